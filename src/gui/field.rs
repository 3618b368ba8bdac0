//! A text field with a name, a unit and an error beside it.
//!
//! Text is read at every change and committed with Enter; nothing is dropped or altered while typing.

use std::ops::Range;

use eframe::egui::text::{CCursor, CCursorRange, LayoutJob, TextFormat};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{Align, FontId, Id, Key, Response, Stroke, TextBuffer, TextEdit, Ui};

use super::keypad;
use super::theme;
use super::view::{View, problem};
use crate::message::Message;
use crate::session::{Command, CycleField, CyclesCommand, Field, ProgramCommand, ProgramField, Session};

/// How a field looks.
pub(super) struct Look {
    /// The font of the text.
    pub font: FontId,
    /// The width in points.
    pub width: f32,
    /// Where the text stands.
    pub align: Align,
    /// What counts while nothing is typed.
    pub hint: String,
}

impl Look {
    /// A small field for a number, right aligned.
    pub fn number(width: f32) -> Self {
        Self { font: theme::font(theme::sizes().body), width, align: Align::RIGHT, hint: String::new() }
    }

    /// A large field over a width.
    pub fn large(width: f32) -> Self {
        Self { font: theme::font(theme::sizes().value), width, align: Align::LEFT, hint: String::new() }
    }
}

/// A text field of any page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Target {
    /// One that every session has.
    Field(Field),
    /// One that a measuring cycle or its workpiece asks for.
    Cycle(CycleField),
    /// One of the program page.
    Program(ProgramField),
}

impl From<Field> for Target {
    fn from(field: Field) -> Self {
        Self::Field(field)
    }
}

impl From<CycleField> for Target {
    fn from(field: CycleField) -> Self {
        Self::Cycle(field)
    }
}

impl From<ProgramField> for Target {
    fn from(field: ProgramField) -> Self {
        Self::Program(field)
    }
}

impl Target {
    /// Its text.
    pub fn text(self, session: &Session) -> &str {
        match self {
            Self::Field(field) => session.inputs().text(field),
            Self::Cycle(field) => session.cycles().text(field),
            Self::Program(field) => session.program().text(field),
        }
    }

    /// The command that replaces its text.
    pub fn typed(self, text: String) -> Command {
        match self {
            Self::Field(field) => Command::Type(field, text),
            Self::Cycle(field) => Command::Cycles(CyclesCommand::Type(field, text)),
            Self::Program(field) => Command::Program(ProgramCommand::Type(field, text)),
        }
    }

    /// What Enter does.
    pub const fn entered(self) -> Option<Command> {
        match self {
            Self::Program(ProgramField::Filter) => None,
            Self::Program(ProgramField::Name | ProgramField::Value) => Some(Command::Program(ProgramCommand::SetValue)),
            _ => Some(Command::Measure),
        }
    }

    fn error(self, session: &Session) -> Option<&Message> {
        match self {
            Self::Field(field) => session.error(field),
            Self::Cycle(field) => session.cycles().error(field),
            Self::Program(field) => session.program().error(field),
        }
    }

    fn culprit(self, session: &Session) -> Option<&Range<usize>> {
        match self {
            Self::Field(field) => session.culprit(field),
            Self::Cycle(_) | Self::Program(_) => None,
        }
    }
}

/// The id of a field, the same wherever it is drawn.
pub(super) fn id(field: impl Into<Target>) -> Id {
    Id::unique(("field", field.into()))
}

/// Draws the field alone. `name` is what a screen reader says.
///
/// Tab or a click into the field selects its text, so that typing replaces it; Enter measures and keeps the focus, so
/// that the next value can come at once.
pub(super) fn field_ui(ui: &mut Ui, view: &mut View<'_>, field: impl Into<Target>, name: Id, look: Look) -> Response {
    let field = field.into();
    let mut text = field.text(view.session).to_owned();
    let id = id(field);
    let culprit = field.culprit(view.session);
    let font = look.font.clone();
    let marked = |ui: &Ui, buffer: &dyn TextBuffer, _width: f32| {
        let job = underlined(ui, buffer.as_str(), &font, culprit);
        ui.fonts_mut(|fonts| fonts.layout_job(job))
    };
    let mut layouter = marked;
    let mut edit = TextEdit::singleline(&mut text)
        .id(id)
        .font(look.font)
        .desired_width(look.width)
        .align(eframe::egui::Align2([look.align, Align::Center]))
        .hint_text(look.hint)
        .min_size(eframe::egui::vec2(look.width, theme::sizes().field));
    if culprit.is_some() {
        edit = edit.layouter(&mut layouter);
    }
    let response = ui.add(edit).labelled_by(name);
    if response.changed() {
        view.send(field.typed(text.clone()));
    }
    if response.has_focus() {
        keypad::aim(ui, field);
    }
    let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if entered {
        if let Some(command) = field.entered() {
            view.send(command);
        }
        response.request_focus();
    }
    if entered || (response.gained_focus() && !response.is_pointer_button_down_on()) {
        select_all(ui, id, &text);
    }
    if let Some(error) = field.error(view.session) {
        let said = view.words.say(error);
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_invalid(eframe::egui::accesskit::Invalid::True);
            node.set_description(said.clone());
        });
    }
    response
}

/// A text whose wrong characters are underlined; `culprit` counts characters from 0.
fn underlined(ui: &Ui, text: &str, font: &FontId, culprit: Option<&Range<usize>>) -> LayoutJob {
    let palette = theme::palette(ui.ctx());
    let plain = TextFormat::simple(font.clone(), palette.text.0);
    let mut job = LayoutJob { break_on_newline: false, ..LayoutJob::default() };
    let Some(culprit) = culprit else {
        job.append(text, 0.0, plain);
        return job;
    };
    let byte = |character: usize| text.char_indices().nth(character).map_or(text.len(), |(byte, _)| byte);
    let (start, end) = (byte(culprit.start), byte(culprit.end));
    let wrong = TextFormat { underline: Stroke::new(2.0, palette.error.0), ..plain.clone() };
    for (range, format) in [(0..start, plain.clone()), (start..end, wrong), (end..text.len(), plain)] {
        if let Some(part) = text.get(range).filter(|part| !part.is_empty()) {
            job.append(part, 0.0, format);
        }
    }
    job
}

/// Selects the whole text of a field, so that typing replaces it.
pub(super) fn select_all(ui: &Ui, id: Id, text: &str) {
    let mut state = TextEditState::load(ui.ctx(), id).unwrap_or_default();
    let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(ui.ctx(), id);
}

/// What is wrong with a field, below it.
pub(super) fn error_ui(ui: &mut Ui, view: &View<'_>, field: impl Into<Target>) {
    if let Some(error) = field.into().error(view.session) {
        problem(ui, view.words.say(error));
    }
}
