//! A keypad for fingers and gloves: it types into the field that had the focus last, and gives the focus back to it. It is there
//! where such a field is on screen, and nowhere else.
//!
//! It stands below what is asked and covers nothing. Keys act when released, are 15 mm or more on a 10 inch panel, and
//! need no gesture.
//!
//! | file | what |
//! |---|---|
//! | here | where it stands, and which field it types into |
//! | `sheets` | what is on the keys |
//! | `typing` | what a key does in the field |

mod sheets;
mod typing;

use eframe::egui::{Button, Color32, Context, Frame, Id, Margin, Panel, Response, RichText, Ui, Vec2, vec2};

pub(super) use self::typing::{has_given_focus, keep_selection, leave};

use self::sheets::{Key, Sheet};
use self::typing::{give_focus, press};
use super::field_id;
use super::shapes::times;
use super::theme::{self, Icon, Weight, sizes, space};
use super::view::{View, remembered};
use crate::session::{CheckField, Field};

/// How the keypad stands.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct State {
    sheet: Sheet,
    /// Whether letters are small.
    is_small: bool,
    /// The field for which the sheet was chosen: another one begins with figures.
    field: Option<Field>,
}

fn state_id() -> Id {
    Id::unique("keypad-state")
}

fn target_id() -> Id {
    Id::unique("keypad-target")
}

/// Remembers the field that the keypad types into.
pub(super) fn aim(ui: &Ui, field: Field) {
    ui.data_mut(|data| data.insert_temp(target_id(), field));
}

/// The field that had the focus last.
pub(super) fn aimed(ui: &Ui) -> Option<Field> {
    ui.data(|data| data.get_temp(target_id()))
}

/// Remembers that a field is on screen in this frame.
pub(super) fn see(ui: &Ui, field: Field) {
    let frame = ui.ctx().cumulative_frame_nr();
    ui.data_mut(|data| data.insert_temp(field_id::id(field).with("seen"), frame));
}

/// Whether a field was drawn in the last frame.
pub(super) fn was_seen(ctx: &Context, field: Field) -> bool {
    let frame = ctx.data(|data| data.get_temp::<u64>(field_id::id(field).with("seen")));
    frame.is_some_and(|frame| ctx.cumulative_frame_nr() <= frame + 1)
}

/// The field that the keypad types into: the one that had the focus last, while it is on screen; else the measured
/// value, while that is.
fn target(ui: &Ui) -> Option<Field> {
    // The keypad is drawn before the fields.
    let is_seen = |field: &Field| was_seen(ui.ctx(), *field);
    aimed(ui).filter(is_seen).or(Some(Field::Check(CheckField::Measured)).filter(is_seen))
}

/// When the keypad was drawn first and last.
#[derive(Debug, Clone, Copy)]
struct Drawn {
    first: u64,
    last: u64,
}

fn drawn_id() -> Id {
    Id::unique("keypad-drawn")
}

/// Remembers that the keypad is drawn in this frame; where it was not in the one before, the column beside it has become lower.
fn draw(ctx: &Context) {
    let frame = ctx.cumulative_frame_nr();
    let before = ctx.data(|data| data.get_temp::<Drawn>(drawn_id())).filter(|drawn| frame <= drawn.last + 1);
    if before.is_none() {
        // A column knows its height in the next frame.
        ctx.request_repaint();
    }
    let first = before.map_or(frame, |drawn| drawn.first);
    ctx.data_mut(|data| data.insert_temp(drawn_id(), Drawn { first, last: frame }));
}

/// The field that a keypad which has just come types into: it must not be out of sight.
pub(super) fn just_came_for(ui: &Ui) -> Option<Id> {
    let frame = ui.ctx().cumulative_frame_nr();
    let drawn = ui.data(|data| data.get_temp::<Drawn>(drawn_id()))?;
    (drawn.last == frame && frame <= drawn.first + 1).then(|| target(ui).map(field_id::id))?
}

/// The height of a key that a glove hits.
const LEAST_KEY: f32 = 56.0;

/// Keys in a row, and rows.
const SIDE: usize = 4;

/// Between two keys.
fn gap() -> f32 {
    space(1.5)
}

/// The width that a column needs for the keypad; nothing where it is switched off.
pub(super) fn width(view: &View<'_>) -> f32 {
    if view.session.has_keypad() { times(sizes().key + gap(), SIDE) + space(5.0) } else { 0.0 }
}

/// The keypad below what is asked, where it is switched on and there is something to type into. Before anything else in the column: it takes
/// its room first.
pub(super) fn keypad_ui(ui: &mut Ui, view: &mut View<'_>) {
    if !view.session.has_keypad() {
        return;
    }
    // Keys for gloves first; then what is asked has room, too.
    let least = LEAST_KEY * 4.0 + space(5.0);
    let room = (ui.available_height() * 0.45).max(least.min(ui.available_height() * 0.6));
    keys_of_height_ui(ui, view, room, true);
}

/// The keypad over a height, with an Enter of its own, or for a page that has a large button for it.
pub(super) fn keys_of_height_ui(ui: &mut Ui, view: &mut View<'_>, room: f32, has_enter: bool) {
    give_focus(ui.ctx());
    let Some(field) = target(ui) else { return };
    draw(ui.ctx());
    let panel = Panel::bottom("keypad").resizable(false).show_separator_line(false);
    panel.frame(Frame::new().inner_margin(Margin { top: 8, ..Margin::ZERO })).show(ui, |ui| {
        let mut state: State = remembered(ui, state_id());
        if state.field != Some(field) {
            state = State { field: Some(field), ..State::default() };
        }
        ui.spacing_mut().item_spacing = vec2(gap(), gap());
        let keys = state.sheet.keys(field, has_enter);
        // In a column that is wide and low, twice as many a row.
        let in_row = if times(sizes().key + gap(), 7) < ui.available_width() { SIDE * 2 } else { SIDE };
        let share = |all: f32, count: usize| (all - times(gap(), count - 1)) / times(1.0, count);
        let most = if has_enter { sizes().key } else { f32::INFINITY };
        let height = share(room, keys.len() / in_row).clamp(space(8.0), most);
        let size = vec2(share(ui.available_width(), in_row).min(height.max(sizes().key) * 1.6), height);
        for row in keys.chunks(in_row) {
            ui.horizontal(|ui| {
                for key in row {
                    key_ui(ui, view, (field, *key), &mut state, size);
                }
            });
        }
        ui.data_mut(|data| data.insert_temp(state_id(), state));
    });
}

/// Enter was pressed elsewhere for the field: what is typed next replaces what stands there.
pub(super) fn entered(ui: &Ui, view: &View<'_>, field: Field) {
    let all = 0..view.session.text(field).chars().count();
    typing::focus(ui.ctx(), field, all);
}

/// What stands on a key, and what a screen reader says.
fn told(view: &View<'_>, key: Key, is_small: bool) -> (String, String) {
    match key {
        Key::Type(' ') => (view.text("key-blank"), view.text("key-blank")),
        Key::Type('.') => (view.words.decimal_sign().to_string(), view.text("key-decimal")),
        Key::Type('-') => ("\u{2212}".to_owned(), view.text("key-minus")),
        Key::Type(sign) => (sign.to_string(), format!("{} {sign}", view.text("key"))),
        Key::Class(class) => (class.to_owned(), format!("{} {class}", view.text("key"))),
        Key::Back => (String::new(), view.text("key-back")),
        Key::Clear => ("C".to_owned(), view.text("key-clear")),
        Key::Show(sheet) => (sheet.label().to_owned(), view.text(sheet.name())),
        Key::Shift => ((if is_small { "ABC" } else { "abc" }).to_owned(), view.text("key-shift")),
        Key::Enter => ("⏎".to_owned(), view.text("key-enter")),
    }
}

fn key_ui(ui: &mut Ui, view: &mut View<'_>, (field, key): (Field, Key), state: &mut State, size: Vec2) {
    let key = match key {
        Key::Type(letter) if state.is_small => Key::Type(letter.to_ascii_lowercase()),
        key => key,
    };
    let (shown, name) = told(view, key, state.is_small);
    let response = cap_ui(ui, key, &shown, size);
    if !response.accessible_name(name).clicked() {
        return;
    }
    match key {
        Key::Show(sheet) => state.sheet = sheet,
        Key::Class(_) => {
            // Figures come next.
            state.sheet = Sheet::Figures;
            press(ui, view, field, key);
        }
        Key::Shift => state.is_small = !state.is_small,
        key => press(ui, view, field, key),
    }
}

fn cap_ui(ui: &mut Ui, key: Key, shown: &str, size: Vec2) -> Response {
    let figure = (size.y * 0.38).clamp(sizes().figure, sizes().value);
    let button = if key == Key::Back {
        Button::new(Icon::Backspace.text(Weight::Regular, figure))
    } else {
        // Words are set smaller, and never cut.
        let wanted = if shown.chars().count() < 3 { figure } else { figure * 0.75 };
        let wide = ui.painter().layout_no_wrap(shown.to_owned(), theme::bold(wanted), Color32::PLACEHOLDER).size().x;
        let fit = wanted * ((size.x - space(2.0)) / wide.max(1.0)).min(1.0);
        Button::new(RichText::new(shown).font(theme::bold(fit)))
    };
    let types = matches!(key, Key::Type(_) | Key::Class(_));
    let look = if types { theme::edged } else { theme::tonal };
    theme::looking(ui, look, |ui| ui.add_sized(size, button.min_size(size)))
}
