//! Above both views: the switch between them, new, open, save, and the plan's name.

use eframe::egui::Ui;

use crate::gui::view::{View, quiet};
use crate::message::Message;
use crate::session::Action;
use crate::session::parts::PartsView;

pub(super) fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        for part in PartsView::ALL {
            view.field_button(ui, Action::ShowParts(part));
        }
        ui.separator();
        for action in [Action::NewPlan, Action::OpenPlan, Action::SavePlan(0)] {
            view.field_button(ui, action);
        }
        let document = view.session.parts().document();
        if document.is_unsaved() {
            quiet(ui, view.words.say(&Message::new("parts-page-not-saved").text("name", document.name())));
        } else if !document.is_empty() {
            quiet(ui, document.name());
        }
    });
}
