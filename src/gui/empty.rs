//! What stands where there is nothing yet: what is missing, and what can be done about it.

use eframe::egui::{Ui, vec2};

use super::theme::control;
use super::view::{View, quiet};
use crate::session::Action;

/// In the middle of a page, with its actions below each other.
pub(super) fn empty_ui(ui: &mut Ui, view: &mut View<'_>, text: &str, actions: &[Action]) {
    ui.add_space(ui.available_height() * 0.3);
    ui.vertical_centered(|ui| {
        quiet(ui, view.text(text));
        let size = vec2(view.width_of(ui, actions), control(ui));
        for action in actions {
            view.sized_button(ui, *action, size);
        }
    });
}
