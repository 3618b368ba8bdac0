//! The way out of the operator's window where a PIN locks it.

use eframe::egui::{Button, RichText, Ui, vec2};

use super::asked::{Main, asked_ui};
use super::sides_ui;
use crate::gui::theme::{self, Icon, control, sizes};
use crate::gui::view::{View, heading};
use crate::session::{Field, SettingsAction, SettingsField};

pub(super) fn lock_ui(ui: &mut Ui, view: &mut View<'_>) {
    sides_ui(ui, view, left_ui, |ui, view| {
        crate::gui::card::page_card_ui(ui, |ui| {
            heading(ui, view.text("operator-leave"));
            ui.label(RichText::new(view.text("operator-pin-asked")).font(theme::font(sizes().limits)));
            ui.label(view.text("operator-pin-forgotten"));
            let stay = SettingsAction::Stay;
            let text = RichText::new(stay.text(view.session, view.words)).font(theme::bold(sizes().limits));
            view.button_as(ui, stay, Button::new(text).min_size(vec2(ui.available_width() * 0.5, control(ui))));
        });
    });
}

fn left_ui(ui: &mut Ui, view: &mut View<'_>) {
    let main = Main { text: view.text("operator-pin-try"), icon: Icon::LockSimple, is_possible: true };
    let field = Field::Settings(SettingsField::Pin);
    if asked_ui(ui, view, (Some(field), "operator-pin"), &main, |ui, view| _ = heading(ui, view.text("operator-pin"))) {
        view.act(SettingsAction::TryPin);
    }
}
