//! A keypad for fingers and gloves: it types into the field that had the focus last.
//!
//! Keys act when released, are 15 mm or more on a 10 inch panel, and need no gesture.

use eframe::egui::{Align2, Button, Grid, Id, RichText, Ui, vec2};

use super::dialogs::fixed_window;
use super::theme::{self, sizes, space};
use super::view::View;
use crate::session::{Action, CheckField, Field, Page};

/// What a key does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Key {
    Type(char),
    Back,
    Clear,
    Measure,
}

/// The keys, row by row.
const KEYS: [[Key; 4]; 4] = [
    [Key::Type('7'), Key::Type('8'), Key::Type('9'), Key::Back],
    [Key::Type('4'), Key::Type('5'), Key::Type('6'), Key::Clear],
    [Key::Type('1'), Key::Type('2'), Key::Type('3'), Key::Type('-')],
    [Key::Type('0'), Key::Type('.'), Key::Type(' '), Key::Measure],
];

fn target_id() -> Id {
    Id::unique("keypad-target")
}

/// Remembers the field that the keypad types into.
pub(super) fn aim(ui: &Ui, field: Field) {
    ui.data_mut(|data| data.insert_temp(target_id(), field));
}

/// The keypad, where it is switched on.
pub(super) fn keypad_ui(ui: &Ui, view: &mut View<'_>) {
    if !view.session.has_keypad() {
        return;
    }
    let field = ui.data(|data| data.get_temp(target_id())).unwrap_or(Field::Check(CheckField::Measured));
    fixed_window("keypad", view.text("keypad"), Align2::CENTER_BOTTOM, -space(4.0)).show(ui, |ui| {
        Grid::new("keys").spacing(vec2(space(1.0), space(1.0))).show(ui, |ui| {
            for row in KEYS {
                for key in row {
                    key_ui(ui, view, field, key);
                }
                ui.end_row();
            }
        });
    });
}

fn key_ui(ui: &mut Ui, view: &mut View<'_>, field: Field, key: Key) {
    let decimal = view.words.language().decimal_sign();
    let (shown, name) = match key {
        Key::Type(' ') => (view.text("key-blank"), view.text("key-blank")),
        Key::Type('.') => (decimal.to_string(), view.text("key-decimal")),
        Key::Type('-') => ("\u{2212}".to_owned(), view.text("key-minus")),
        Key::Type(figure) => (figure.to_string(), format!("{} {figure}", view.text("key"))),
        Key::Back => ("←".to_owned(), view.text("key-back")),
        Key::Clear => (view.text("key-clear"), view.text("key-clear")),
        Key::Measure => ("⏎".to_owned(), view.text("key-measure")),
    };
    let size = vec2(sizes().key, sizes().key);
    let button = Button::new(RichText::new(shown).font(theme::bold(sizes().value))).min_size(size);
    if !ui.add_sized(size, button).accessible_name(name).clicked() {
        return;
    }
    let mut text = view.session.text(field).to_owned();
    match key {
        Key::Type('.') => text.push(decimal),
        Key::Type(figure) => text.push(figure),
        Key::Back => _ = text.pop(),
        Key::Clear => text.clear(),
        Key::Measure => {
            let page = view.session.page();
            let set = (page == Page::Tables).then_some(Action::SetCell);
            if let Some(action) = set.or_else(|| Action::on_enter(field, page)) {
                view.act(action);
            }
            return;
        }
    }
    view.send(field.typed(text));
}
