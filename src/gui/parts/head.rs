//! Above both views: the switch between them, new, open, save, and the plan's name.

use eframe::egui::{Button, Ui, vec2};

use crate::gui::theme::control;
use crate::gui::view::{View, quiet};
use crate::message::message;
use crate::session::PartsAction;
use crate::session::parts::PartsView;

pub(super) fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        for part in PartsView::ALL {
            let show = PartsAction::ShowParts(part);
            let text = show.text(view.session, view.words);
            let button = Button::selectable(show.is_on(view.session) == Some(true), text);
            view.button_as(ui, show, button.min_size(vec2(0.0, control(ui))));
        }
        ui.separator();
        for action in [PartsAction::NewPlan, PartsAction::OpenPlan, PartsAction::SavePlan(0)] {
            view.field_button(ui, action);
        }
        if view.session.parts().view == PartsView::Plan {
            view.field_button(ui, PartsAction::SavePlan(1));
        }
        let document = &view.session.parts().document;
        if document.is_unsaved() {
            quiet(ui, view.words.say(&message!("parts-page-not-saved").text("name", document.name())));
        } else if !document.is_empty() {
            quiet(ui, document.name());
        }
    });
}
