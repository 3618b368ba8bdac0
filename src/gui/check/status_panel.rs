//! Right, below: the status window, as the control's pop-up prints it.

use eframe::egui::{ComboBox, Ui};

use crate::gui::popup::popup_ui;
use crate::gui::view::{View, quiet};
use crate::session::{Command, MaskChoice, Purpose};
use crate::words::Dialogue;

/// The pop-up and what can be done with it.
pub(super) fn status_ui(ui: &mut Ui, view: &mut View<'_>) {
    let shown = view.session.shown().map(|shown| shown.window.clone());
    popup_ui(ui, view, shown.as_ref(), "popup-empty");
    ui.horizontal(|ui| {
        if ui.add_enabled(shown.is_some(), eframe::egui::Button::new(view.text("copy"))).clicked() {
            view.send(Command::CopyStatus);
        }
        mask_chooser_ui(ui, view);
    });
}

pub(in crate::gui) fn mask_chooser_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("mask-choice"));
    let shown = match view.session.mask() {
        MaskChoice::OfLanguage => view.text("mask-choice-of-language"),
        MaskChoice::Shipped(language) => language.name().to_owned(),
        MaskChoice::Own { name, .. } => name.clone(),
    };
    let response = ComboBox::from_id_salt("mask")
        .selected_text(shown)
        .show_ui(ui, |ui| {
            let (words, commands) = (view.words, &mut view.commands);
            let mut choice = |ui: &mut Ui, text: String, command: Command| {
                if ui.selectable_label(false, text).clicked() {
                    commands.push(command);
                }
            };
            let of_language = words.get("mask-choice-of-language");
            choice(ui, of_language, Command::SetMask(None));
            for language in Dialogue::ALL {
                choice(ui, language.name().to_owned(), Command::SetMask(Some(language)));
            }
            let own = words.get("mask-choice-own");
            choice(ui, own, Command::OpenDialog(Purpose::LoadMask));
        })
        .response;
    response.labelled_by(name.id);
}
