//! Why a size is left out: one of the usual reasons, or another one.

use eframe::egui::{Button, Ui, vec2};

use crate::gui::field::{Look, error_ui, field_ui};
use crate::gui::theme::{self, control, sizes};
use crate::gui::view::{View, heading};
use crate::session::Action;
use crate::session::parts::{PartsField, WalkCommand};

/// The usual reasons.
const USUAL: [&str; 4] =
    ["walk-page-skip-access", "walk-page-skip-gauge", "walk-page-skip-machined", "walk-page-skip-elsewhere"];

pub(super) fn skip_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.separator();
    heading(ui, view.text("walk-page-skip-why"));
    ui.horizontal_wrapped(|ui| {
        for reason in USUAL.map(|id| view.text(id)) {
            if ui.add(Button::new(&reason).min_size(vec2(0.0, control(ui)))).clicked() {
                view.send(WalkCommand::Skip(reason));
            }
        }
    });
    let name = ui.label(view.text("walk-page-reason"));
    let width = ui.available_width();
    let look = Look { font: theme::font(sizes().body), ..Look::large(width) };
    field_ui(ui, view, PartsField::Reason, name.id, look);
    error_ui(ui, view, PartsField::Reason);
    ui.horizontal_wrapped(|ui| {
        for action in [Action::SkipFor, Action::LeaveSkip] {
            view.field_button(ui, action);
        }
    });
}
