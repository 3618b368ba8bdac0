//! Why a size is left out: one of the usual reasons, or another one.

use eframe::egui::{Button, Ui, vec2};

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::over_page::just_opened;
use crate::gui::theme::control;
use crate::gui::view::{View, heading, steady};
use crate::session::parts::WalkCommand;
use crate::session::{PartsAction, WalkField};

/// The usual reasons.
const USUAL: [&str; 4] =
    ["walk-page-skip-access", "walk-page-skip-gauge", "walk-page-skip-machined", "walk-page-skip-elsewhere"];

pub(in crate::gui) fn skip_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("walk-page-skip-why"));
    steady(ui, "walk-skip", |ui| {
        for (place, reason) in USUAL.map(|id| view.text(id)).into_iter().enumerate() {
            let button = ui.add(Button::new(&reason).min_size(vec2(ui.available_width(), control(ui))));
            // The key that asks leads to the answers.
            if place == 0 && just_opened(ui, button.id.with("shown")) {
                button.request_focus();
            }
            if button.clicked() {
                view.send(WalkCommand::Skip(reason));
            }
        }
    });
    let name = ui.label(view.text("walk-page-reason"));
    let width = ui.available_width();
    let look = FieldStyle::text(width);
    field_ui(ui, view, WalkField::Reason, name.id, look);
    error_ui(ui, view, WalkField::Reason);
    ui.horizontal_wrapped(|ui| {
        for action in [PartsAction::SkipFor, PartsAction::LeaveSkip] {
            view.field_button(ui, action);
        }
    });
}
