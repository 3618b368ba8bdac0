//! A text field with a name, a unit and an error beside it.
//!
//! Text is read at every change and committed with Enter; nothing is removed or altered while typing.

pub(super) use super::field_id::{id, select, select_all};

use std::ops::Range;

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{
    Align, Align2, Atom, AtomExt as _, Context, FontId, Grid, Id, Key, Layout, Rect, Response, RichText, Stroke,
    TextBuffer, TextEdit, Ui, UiBuilder, Vec2, vec2,
};

use super::field_help::{self, field_help_ui};
use super::in_turn::hold;
use super::room::is_low;
use super::theme::{self, Icon, control, space};
use super::view::{View, problem, quiet, quiet_text, remembered};
use super::{keypad, section};
use crate::session::{CheckField, Command, Field, FieldPlace, Session, WalkField, WindowAction};

/// How a field looks.
pub(super) struct FieldStyle {
    pub font: FontId,
    /// The width in points.
    pub width: f32,
    pub align: Align,
    /// What counts while nothing is typed, or that something must be.
    pub hint: RichText,
    /// The least height in points, where that is more than what everything has that is pressed.
    pub height: f32,
    /// What stands behind the text, within the field.
    pub unit: String,
    /// The room behind that, for what is drawn over the field.
    pub beside: f32,
    /// Whether what is typed is not shown.
    pub is_hidden: bool,
}

impl FieldStyle {
    /// A small field for a number, right-aligned.
    pub fn number(width: f32) -> Self {
        Self { align: Align::RIGHT, ..Self::text(width) }
    }

    /// A field for words.
    pub fn text(width: f32) -> Self {
        Self {
            font: theme::font(theme::sizes().body),
            width,
            align: Align::LEFT,
            hint: RichText::default(),
            height: 0.0,
            unit: String::new(),
            beside: 0.0,
            is_hidden: false,
        }
    }

    /// The field of the callout, as wide as there is room.
    pub fn callout(ui: &Ui) -> Self {
        let height = if is_low(ui) { 0.0 } else { space(11.5) };
        let font = theme::font(theme::sizes().callout);
        Self { font, height, ..Self::text(ui.available_width()) }
    }

    /// The field of the measured value.
    pub fn value(ui: &Ui, width: f32) -> Self {
        let height = if is_low(ui) { 0.0 } else { space(13.5) };
        let size = if is_low(ui) { theme::sizes().callout } else { theme::sizes().value };
        Self { font: theme::bold(size), height, ..Self::text(width) }
    }

    pub fn unit(self, unit: impl Into<String>) -> Self {
        Self { unit: unit.into(), ..self }
    }

    /// A large field of a given width.
    pub fn large(width: f32) -> Self {
        Self { font: theme::font(theme::sizes().figure), ..Self::text(width) }
    }
}

/// What a screen reader says of a field.
enum Said<'a> {
    /// The text beside it.
    By(Id),
    Name(&'a str),
}

/// Draws a field without a text beside it; `name` is what a screen reader says.
pub(super) fn named_field_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    field: impl Into<Field>,
    name: &str,
    look: FieldStyle,
) -> Response {
    edit_ui(ui, view, field.into(), &Said::Name(name), look)
}

/// Draws the field alone. `name` is the text beside it, which a screen reader says.
///
/// Tab or a click into the field selects its text, so that typing replaces it; Enter measures and keeps the focus, so
/// that the next value can come at once.
pub(super) fn field_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    field: impl Into<Field>,
    name: Id,
    look: FieldStyle,
) -> Response {
    edit_ui(ui, view, field.into(), &Said::By(name), look)
}

fn edit_ui(ui: &mut Ui, view: &mut View<'_>, field: Field, said: &Said<'_>, look: FieldStyle) -> Response {
    let mut text = view.session.text(field).to_owned();
    let id = id(field);
    let culprit = view.session.culprit(field);
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
        .align(Align2([look.align, Align::Center]))
        .password(look.is_hidden)
        .hint_text(look.hint)
        .min_size(vec2(look.width, control(ui).max(look.height)));
    if !look.unit.is_empty() {
        edit = edit.suffix(quiet_text(ui, &look.unit));
    }
    if 0.0 < look.beside {
        edit = edit.suffix(Atom::default().atom_size(vec2(look.beside, 0.0)));
    }
    if culprit.is_some() {
        edit = edit.layouter(&mut layouter);
    }
    let response = match said {
        Said::By(name) => ui.add(edit).labelled_by(*name),
        Said::Name(name) => ui.add(edit).accessible_name(*name),
    };
    if response.changed() {
        view.send(field.typed(text.clone()));
    }
    keypad::see(ui, field);
    if response.has_focus() {
        keypad::aim(ui, field);
    }
    let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if entered {
        view.send(Command::Enter(field));
        response.request_focus();
    }
    // What stands there was judged or refused: a click replaces it as the first one does, until something is typed.
    let edited = id.with("edited");
    if response.changed() {
        ui.data_mut(|data| data.insert_temp(edited, true));
    } else if entered {
        ui.data_mut(|data| data.insert_temp(edited, false));
    }
    let has_selection = || {
        let range = TextEditState::load(ui.ctx(), id).and_then(|state| state.cursor.char_range());
        range.is_some_and(|range| !range.is_empty())
    };
    let is_measured =
        [CheckField::Callout.into(), CheckField::Measured.into(), WalkField::Value.into()].contains(&field);
    let is_clicked_again = is_measured && response.clicked() && !remembered::<bool>(ui, edited) && !has_selection();
    if entered || is_clicked_again || is_entered(ui, &response) {
        select_all(ui.ctx(), id, &text);
    }
    if let Some(error) = view.session.error(field) {
        let said = view.words.say(error);
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_invalid(eframe::egui::accesskit::Invalid::True);
            node.set_description(said.clone());
        });
    } else if !look.unit.is_empty() {
        ui.ctx().accesskit_node_builder(id, |node| node.set_description(look.unit));
    }
    if !view.session.is_for_operators() {
        field_help_ui(ui, view, field, &response);
    }
    response
}

/// The field of a measured value, with room for the button of the keypad.
pub(super) fn value_field_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    field: impl Into<Field>,
    name: Id,
    look: FieldStyle,
) -> Rect {
    let beside = control(ui) + space(field_help::reach(ui) - 2.0);
    field_ui(ui, view, field, name, FieldStyle { beside, ..look.unit("mm") }).rect
}

/// The button of the keypad in its field, into which the keypad types then.
pub(super) fn keypad_button_ui(ui: &mut Ui, view: &mut View<'_>, field: impl Into<Field>, rect: Rect) {
    let button = control(ui);
    // The sign of the help at the corner stays free.
    let place = rect.with_max_x(rect.right() - space(field_help::reach(ui)));
    let place = Align2::RIGHT_CENTER.align_size_within_rect(Vec2::splat(button), place);
    let mut over = ui.new_child(UiBuilder::new().max_rect(place).layout(Layout::top_down(Align::Center)));
    over.spacing_mut().button_padding = Vec2::ZERO;
    if view.icon_toggle(&mut over, WindowAction::Keypad, Icon::Numpad).clicked() {
        view.send(Command::GoTo(field.into()));
    }
}

/// Whether a field has just been entered: by key, or by a click that gave it the focus, once the button is released, so
/// that neither a short nor a long press leaves a cursor in the middle. A drag selects what it was drawn over.
fn is_entered(ui: &Ui, response: &Response) -> bool {
    let pressed = response.id.with("pressed");
    if response.gained_focus() {
        if keypad::has_given_focus(ui.ctx(), response.id) {
            return false;
        }
        let by_pointer = response.is_pointer_button_down_on() || ui.input(|input| input.pointer.any_pressed());
        ui.data_mut(|data| data.insert_temp(pressed, by_pointer));
        // A press and its release in one frame: a touch, or a loaded machine.
        return !by_pointer || response.clicked();
    }
    if remembered(ui, pressed) && !ui.input(|input| input.pointer.any_down()) {
        ui.data_mut(|data| data.insert_temp(pressed, false));
        let range = TextEditState::load(ui.ctx(), response.id).and_then(|state| state.cursor.char_range());
        return response.has_focus() && range.is_none_or(|range| range.is_empty());
    }
    false
}

/// Between two fields of a row.
const GAP: f32 = 2.0;

/// The width of each of two fields beside each other.
pub(super) fn half_width(ui: &Ui) -> f32 {
    (ui.available_width() - space(GAP)) / 2.0
}

/// Two fields per row, each with its name above it; errors below the row.
pub(super) fn pairs_ui(ui: &mut Ui, view: &mut View<'_>, fields: &[(Field, String, &str)]) {
    let width = half_width(ui);
    for row in fields.chunks(2) {
        let grid = Grid::new(("fields", row.first().map(|(field, ..)| *field))).num_columns(2).min_row_height(0.0);
        // A long name has two lines: the fields stay beside each other.
        let grid = grid.min_col_width(width).max_col_width(width).spacing(vec2(space(GAP), space(0.5)));
        grid.show(ui, |ui| {
            let names: Vec<_> = row.iter().map(|(_, name, _)| quiet(ui, name).id).collect();
            ui.end_row();
            for ((field, _, unit), name) in row.iter().zip(names) {
                field_ui(ui, view, *field, name, FieldStyle::number(width).unit(*unit));
            }
            ui.end_row();
        });
        for (field, ..) in row {
            error_ui(ui, view, *field);
        }
    }
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
    let start = byte(culprit.start);
    let end = byte(culprit.end);
    let wrong = TextFormat { underline: Stroke::new(2.0, palette.error.0), ..plain.clone() };
    for (range, format) in [(0..start, plain.clone()), (start..end, wrong), (end..text.len(), plain)] {
        if let Some(part) = text.get(range).filter(|part| !part.is_empty()) {
            job.append(part, 0.0, format);
        }
    }
    job
}

/// Gives the focus to a field and selects its text, so that typing replaces it. As long as something lies over the page, egui takes the
/// focus from it again: then it is given once that is gone.
pub(super) fn go_to(ctx: &Context, session: &Session, field: Field) {
    keypad::leave(ctx);
    if ctx.memory(|memory| memory.top_modal_layer().is_some()) {
        ctx.data_mut(|data| data.insert_temp(soon(), Some(field)));
        hold(ctx);
        return ctx.request_repaint();
    }
    if let FieldPlace::Fold(name) = session.place_of(field)
        && section::unfold(ctx, name)
    {
        // What is unfolded is drawn some frames later: a field that is not drawn loses the focus again.
        ctx.data_mut(|data| data.insert_temp(unfolding(), Some((field, UNFOLDING))));
        hold(ctx);
        return ctx.request_repaint();
    }
    ctx.memory_mut(|memory| memory.request_focus(id(field)));
    select_all(ctx, id(field), session.text(field));
}

/// How many frames a fold has to open at most.
const UNFOLDING: u8 = 30;

fn unfolding() -> Id {
    Id::unique("field-unfolding")
}

/// Gives the focus to a field in a fold once it is drawn.
fn arrive_in_fold(ctx: &Context, view: &View<'_>) {
    let id = unfolding();
    let Some((field, left)) =
        ctx.data_mut(|data| std::mem::take(data.get_temp_mut_or_default::<Option<(Field, u8)>>(id)))
    else {
        return;
    };
    if keypad::was_seen(ctx, field) {
        go_to(ctx, view.session, field);
    } else if let Some(left) = left.checked_sub(1) {
        ctx.data_mut(|data| data.insert_temp(id, Some((field, left))));
        hold(ctx);
        ctx.request_repaint();
    }
}

fn soon() -> Id {
    Id::unique("field-soon")
}

/// Gives the focus to the field that it was promised to.
pub(super) fn arrive(ctx: &Context, view: &View<'_>) {
    arrive_in_fold(ctx, view);
    let promised = ctx.data_mut(|data| std::mem::take(data.get_temp_mut_or_default::<Option<Field>>(soon())));
    if let Some(field) = promised {
        go_to(ctx, view.session, field);
    }
}

/// What is wrong with a field, below it.
pub(super) fn error_ui(ui: &mut Ui, view: &View<'_>, field: impl Into<Field>) {
    if let Some(error) = view.session.error(field) {
        problem(ui, view.words.say(error));
    }
}
