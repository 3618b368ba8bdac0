//! A list and what is open of it: beside each other where there is room, else the open one in the place of the list.

use eframe::egui::Ui;

use super::columns::{Draw, Side, panel_ui, rest_ui};
use super::keypad::keypad_ui;
use super::theme::space;
use super::view::View;

pub(super) struct Split {
    /// Its name, for the width that the user gave what is open.
    pub name: &'static str,
    /// From this width on both stand beside each other.
    pub beside: f32,
    pub list: Draw,
    /// What is open.
    pub detail: Draw,
}

pub(super) fn split_ui(ui: &mut Ui, view: &mut View<'_>, split: &Split, is_open: bool) {
    let width = ui.available_width();
    let is_beside = space(split.beside) <= width;
    if is_open && is_beside {
        let sizes = (width * 0.42, space(90.0)..=width * 0.6);
        panel_ui(ui, view, Side::Right, split.name, sizes, |ui, view| {
            keypad_ui(ui, view);
            (split.detail)(ui, view);
        });
    } else {
        keypad_ui(ui, view);
    }
    let shown = if is_open && !is_beside { split.detail } else { split.list };
    rest_ui(ui, view, shown);
}
