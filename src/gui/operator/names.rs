//! Who is measuring: the last names to be touched, and a field for another one with the keypad beside it.

use eframe::egui::{Button, Id, RichText, ScrollArea, Ui, vec2};

use super::asked::{Main, asked_ui};
use super::sides_ui;
use crate::gui::card::page_card_ui;
use crate::gui::theme::{self, Icon, control, sizes};
use crate::gui::view::{View, heading, quiet, remembered};
use crate::session::{Field, RecordsCommand, RecordsField, WindowAction};

fn id() -> Id {
    Id::unique("operator-names")
}

/// Whether the names are shown.
pub(super) fn is_open(ui: &Ui) -> bool {
    remembered(ui, id())
}

pub(super) fn open(ui: &Ui, is_open: bool) {
    ui.data_mut(|data| data.insert_temp(id(), is_open));
}

/// Back to what is measured: its field has the focus.
fn close(ui: &Ui, view: &mut View<'_>) {
    open(ui, false);
    super::go_to_value(view, view.session.page());
}

pub(super) fn names_ui(ui: &mut Ui, view: &mut View<'_>) {
    sides_ui(ui, view, left_ui, right_ui);
}

fn left_ui(ui: &mut Ui, view: &mut View<'_>) {
    let main = Main {
        text: WindowAction::TakeName.text(view.session, view.words),
        icon: Icon::Check,
        is_possible: view.session.can(WindowAction::TakeName),
    };
    let field = Field::Records(RecordsField::Who);
    let is_pressed = asked_ui(ui, view, (Some(field), "records-page-new-name"), &main, |ui, view| {
        heading(ui, view.text("records-page-who"));
        quiet(ui, view.text("records-page-new-name"));
    });
    if is_pressed {
        view.act(WindowAction::TakeName);
        close(ui, view);
    }
}

fn right_ui(ui: &mut Ui, view: &mut View<'_>) {
    page_card_ui(ui, |ui| {
        let recording = view.session.recording();
        let who = recording.who().to_owned();
        let names = recording.names().to_vec();
        let nobody = view.text("records-page-nobody-named");
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            let entries = names.into_iter().map(|name| (name.clone(), name)).chain([(String::new(), nobody)]);
            for (name, shown) in entries {
                let text = RichText::new(&shown).font(theme::bold(sizes().limits));
                let size = vec2(ui.available_width(), control(ui));
                if ui.add(Button::new(text).selected(name == who).min_size(size)).clicked() {
                    view.send(RecordsCommand::UseName(name));
                    close(ui, view);
                }
            }
        });
    });
}
