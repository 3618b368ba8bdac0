//! Where a control stands, and what several kinds of controls have: a line, a field, buttons.

use eframe::egui::{Color32, Id, Ui};

use crate::gui::field::{FieldStyle, field_ui};
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, remembered};
use crate::session::{Action, Field, SettingsField};

/// Where a control stands.
pub(super) struct Slot {
    /// What labels it.
    pub name: Id,
    /// Whether it ends at the right edge.
    pub is_right: bool,
}

/// A line that ends at the right edge and yet is in reading order: as wide as it was the last time.
pub(super) fn line_ui(ui: &mut Ui, slot: &Slot, what: &str, content: impl FnOnce(&mut Ui)) {
    if !slot.is_right {
        ui.horizontal(content);
        return;
    }
    let id = slot.name.with(what);
    let last: f32 = remembered(ui, id);
    ui.horizontal(|ui| {
        if 0.0 < last {
            ui.add_space((ui.available_width() - last).max(0.0));
        }
        let width = ui.horizontal(content).response.rect.width();
        if 0.5 < (width - last).abs() {
            ui.data_mut(|data| data.insert_temp(id, width));
            ui.ctx().request_discard("the width of a line is known");
        }
    });
}

/// The width of buttons with these texts beside each other.
pub(super) fn width_of(ui: &Ui, texts: &[String]) -> f32 {
    let font = theme::font(sizes().body);
    let text = |text: &String| ui.painter().layout_no_wrap(text.clone(), font.clone(), Color32::PLACEHOLDER).size().x;
    let padding = 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x + 2.0;
    texts.iter().map(|of| text(of) + padding).sum()
}

/// What can be done: beside each other where there is room.
pub(super) fn buttons_ui(ui: &mut Ui, view: &mut View<'_>, actions: &[Action], slot: &Slot) {
    if actions.is_empty() {
        return;
    }
    let names: Vec<String> = actions.iter().map(|action| action.text(view.session, view.words)).collect();
    if width_of(ui, &names) <= ui.available_width() {
        line_ui(ui, slot, "buttons", |ui| {
            for action in actions {
                view.field_button(ui, *action);
            }
        });
    } else {
        for action in actions {
            view.field_button(ui, *action);
        }
    }
}

/// A field with its unit; one without a unit and with buttons holds a longer text.
pub(super) fn value_ui(ui: &mut Ui, view: &mut View<'_>, (field, unit): (Field, &str), slot: &Slot) {
    if view.session.is_free_text(field) {
        let width = ui.available_width();
        let is_hidden = field == SettingsField::NewPin.into();
        field_ui(ui, view, field, slot.name, FieldStyle { is_hidden, ..FieldStyle::text(width) });
        return;
    }
    line_ui(ui, slot, "field", |ui| {
        field_ui(ui, view, field, slot.name, FieldStyle::number(space(30.0)).unit(unit));
    });
}
