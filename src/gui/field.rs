//! A text field with a name, a unit and an error beside it.
//!
//! Text is read at every change and committed with Enter; nothing is dropped or altered while typing.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{Align, FontId, Id, Key, Response, TextEdit, Ui};

use super::keypad;
use super::theme;
use super::view::{View, problem};
use crate::session::{Command, Field};

/// How a field looks.
pub(super) struct Look {
    /// The font of the text.
    pub font: FontId,
    /// The width in points.
    pub width: f32,
    /// Where the text stands.
    pub align: Align,
}

impl Look {
    /// A small field for a number, right aligned.
    pub fn number(width: f32) -> Self {
        Self { font: theme::font(theme::sizes().body), width, align: Align::RIGHT }
    }

    /// A large field over a width.
    pub fn large(width: f32) -> Self {
        Self { font: theme::font(theme::sizes().value), width, align: Align::LEFT }
    }
}

/// The id of a field, the same wherever it is drawn.
pub(super) fn id(field: Field) -> Id {
    Id::unique(("field", field))
}

/// Draws the field alone. `name` is what a screen reader says.
///
/// Tab or a click into the field selects its text, so that typing replaces it; Enter measures and keeps the focus, so
/// that the next value can come at once.
pub(super) fn field_ui(ui: &mut Ui, view: &mut View<'_>, field: Field, name: Id, look: Look) -> Response {
    let mut text = view.session.inputs().text(field).to_owned();
    let id = id(field);
    let response = ui
        .add(
            TextEdit::singleline(&mut text)
                .id(id)
                .font(look.font)
                .desired_width(look.width)
                .align(eframe::egui::Align2([look.align, Align::Center]))
                .min_size(eframe::egui::vec2(look.width, theme::sizes().field)),
        )
        .labelled_by(name);
    if response.changed() {
        view.send(Command::Type(field, text.clone()));
    }
    if response.has_focus() {
        keypad::aim(ui, field);
    }
    let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if entered {
        view.send(Command::Measure);
        response.request_focus();
    }
    if entered || (response.gained_focus() && !response.is_pointer_button_down_on()) {
        select_all(ui, id, &text);
    }
    if let Some(error) = view.session.asked().error(field) {
        let said = view.words.say(error);
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_invalid(eframe::egui::accesskit::Invalid::True);
            node.set_description(said.clone());
        });
    }
    response
}

/// Selects the whole text of a field, so that typing replaces it.
pub(super) fn select_all(ui: &Ui, id: Id, text: &str) {
    let mut state = TextEditState::load(ui.ctx(), id).unwrap_or_default();
    let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(ui.ctx(), id);
}

/// What is wrong with a field, below it.
pub(super) fn error_ui(ui: &mut Ui, view: &View<'_>, field: Field) {
    if let Some(error) = view.session.asked().error(field) {
        problem(ui, view.words.say(error));
    }
}
