//! Right, below: the status window, as the control's pop-up prints it.

use eframe::egui::{ComboBox, Frame, Label, Margin, RichText, ScrollArea, Stroke, Ui};

use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, problem, quiet};
use crate::session::{Command, MaskChoice, Purpose};
use crate::words::{Language, Message};

/// The pop-up and what can be done with it.
pub(super) fn status_ui(ui: &mut Ui, view: &mut View<'_>) {
    let shown = view.session.shown().map(|shown| shown.window.clone());
    popup_ui(ui, view, shown.as_ref());
    ui.horizontal(|ui| {
        if ui.add_enabled(shown.is_some(), eframe::egui::Button::new(view.text("copy"))).clicked() {
            view.send(Command::CopyStatus);
        }
        mask_chooser_ui(ui, view);
    });
}

fn popup_ui(ui: &mut Ui, view: &View<'_>, shown: Option<&Result<String, Message>>) {
    let palette = palette(ui.ctx());
    let frame = Frame::new().fill(palette.popup.0).stroke(Stroke::new(2.0, palette.popup_title.0)).corner_radius(2.0);
    frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        Frame::new().fill(palette.popup_title.0).inner_margin(Margin::symmetric(8, 3)).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            let title = RichText::new(view.text("popup-title")).size(sizes().small).color(palette.on_popup_title.0);
            ui.label(title);
        });
        Frame::new().inner_margin(Margin::same(8)).show(ui, |ui| {
            ui.set_min_height(space(24.0));
            match shown {
                Some(Ok(text)) => {
                    ScrollArea::both().max_height(space(60.0)).auto_shrink([false, true]).show(ui, |ui| {
                        let text = RichText::new(text.trim_end()).font(theme::mono(sizes().mono)).color(palette.text.0);
                        ui.add(Label::new(text).extend().selectable(true));
                    });
                }
                Some(Err(error)) => _ = problem(ui, view.words.say(error)),
                None => _ = quiet(ui, view.text("popup-empty")),
            }
        });
    });
}

fn mask_chooser_ui(ui: &mut Ui, view: &mut View<'_>) {
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
            for language in Language::ALL {
                choice(ui, language.name().to_owned(), Command::SetMask(Some(language)));
            }
            let own = words.get("mask-choice-own");
            choice(ui, own, Command::OpenDialog(Purpose::LoadMask));
        })
        .response;
    response.labelled_by(name.id);
}
