//! A keypad for fingers and gloves: it types into the field that had the focus last, and gives the focus back to it.
//! Where that field is not on screen, it types nothing.
//!
//! It stands below what is asked and covers nothing. Keys act when released, are 15 mm or more on a 10 inch panel, and
//! need no gesture; figures and signs on one page, letters for classes and names on another.

use std::ops::Range;

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{Button, Context, Frame, Id, Margin, Panel, RichText, Ui, Vec2, vec2};

use super::field_id;
use super::theme::{self, sizes, space};
use super::view::{View, remembered};
use crate::session::TablesAction;
use crate::session::{CheckField, Command, Field, Page};

/// What a key does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Key {
    Type(char),
    Back,
    Clear,
    /// Shows the other page.
    Letters,
    /// Capital letters, or small ones.
    Shift,
    Enter,
}

/// The page of figures, row by row.
const FIGURES: [[Key; 4]; 4] = [
    [Key::Type('7'), Key::Type('8'), Key::Type('9'), Key::Back],
    [Key::Type('4'), Key::Type('5'), Key::Type('6'), Key::Clear],
    [Key::Type('1'), Key::Type('2'), Key::Type('3'), Key::Type('-')],
    [Key::Type('0'), Key::Type('.'), Key::Letters, Key::Enter],
];

/// The signs of the page of letters that are no letters.
const SIGNS: [Key; 10] = [
    Key::Shift,
    Key::Type('/'),
    Key::Type('+'),
    Key::Type(' '),
    Key::Letters,
    Key::Type('-'),
    Key::Type('.'),
    Key::Back,
    Key::Clear,
    Key::Enter,
];

/// How many keys a row of letters has.
const LETTERS_A_ROW: usize = 6;

/// How the keypad stands.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct State {
    has_letters: bool,
    is_small: bool,
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

/// The width that a column needs for the keypad; nothing where it is switched off.
pub(super) fn width(view: &View<'_>) -> f32 {
    if view.session.has_keypad() { shapes_width(4) } else { 0.0 }
}

fn shapes_width(keys: u8) -> f32 {
    sizes().key * f32::from(keys) + space(1.0) * f32::from(keys) + space(5.0)
}

/// The keypad below what is asked, where it is switched on. Before anything else in the column: it takes its room first.
pub(super) fn keypad_ui(ui: &mut Ui, view: &mut View<'_>) {
    if !view.session.has_keypad() {
        return;
    }
    give_focus(ui.ctx());
    draw(ui.ctx());
    // Keys for gloves first; then what is asked has room, too.
    let room = (ui.available_height() * 0.45).max((LEAST_KEY * 4.0 + space(5.0)).min(ui.available_height() * 0.6));
    let panel = Panel::bottom("keypad").resizable(false).show_separator_line(false);
    panel.frame(Frame::new().inner_margin(Margin { top: 8, ..Margin::ZERO })).show(ui, |ui| {
        let field = target(ui);
        let mut state: State = remembered(ui, state_id());
        ui.spacing_mut().item_spacing = vec2(space(1.0), space(1.0));
        let rows = rows(state, ui.available_width());
        let longest = rows.iter().map(Vec::len).max().unwrap_or(1);
        let share = |all: f32, count: usize| {
            let count = f32::from(u8::try_from(count.max(1)).unwrap_or(u8::MAX));
            (all - space(1.0) * (count - 1.0)) / count
        };
        let size = vec2(share(ui.available_width(), longest), share(room, rows.len()).clamp(space(8.0), sizes().key));
        for row in rows {
            ui.horizontal(|ui| {
                for key in row {
                    key_ui(ui, view, field, key, &mut state, size.min(vec2(sizes().key * 1.6, size.y)));
                }
            });
        }
        ui.data_mut(|data| data.insert_temp(state_id(), state));
    });
}

/// The keys of a page; in a column that is wide and low, twice as many a row.
fn rows(state: State, width: f32) -> Vec<Vec<Key>> {
    let is_wide = shapes_width(7) < width;
    if state.has_letters {
        let case = |letter: char| if state.is_small { letter.to_ascii_lowercase() } else { letter };
        let letters = ('A'..='Z').map(|letter| Key::Type(case(letter)));
        let keys: Vec<Key> = letters.chain(SIGNS).collect();
        keys.chunks(if is_wide { LETTERS_A_ROW * 2 } else { LETTERS_A_ROW }).map(<[Key]>::to_vec).collect()
    } else if is_wide {
        FIGURES.chunks(2).map(<[[Key; 4]]>::concat).collect()
    } else {
        FIGURES.iter().map(|row| row.to_vec()).collect()
    }
}

fn key_ui(ui: &mut Ui, view: &mut View<'_>, field: Option<Field>, key: Key, state: &mut State, size: Vec2) {
    let decimal = view.words.decimal_sign();
    let (shown, name) = match key {
        Key::Type(' ') => (view.text("key-blank"), view.text("key-blank")),
        Key::Type('.') => (decimal.to_string(), view.text("key-decimal")),
        Key::Type('-') => ("\u{2212}".to_owned(), view.text("key-minus")),
        Key::Type(sign) => (sign.to_string(), format!("{} {sign}", view.text("key"))),
        Key::Back => ("←".to_owned(), view.text("key-back")),
        Key::Clear => (view.text("key-clear"), view.text("key-clear")),
        Key::Letters if state.has_letters => ("123".to_owned(), view.text("key-figures")),
        Key::Letters => ("ABC".to_owned(), view.text("key-letters")),
        Key::Shift => ((if state.is_small { "ABC" } else { "abc" }).to_owned(), view.text("key-shift")),
        Key::Enter => ("⏎".to_owned(), view.text("key-enter")),
    };
    let button = Button::new(RichText::new(shown).font(theme::bold(sizes().figure))).min_size(size);
    // Without a field only the keys that change the keypad itself do something.
    let changes_keypad = matches!(key, Key::Letters | Key::Shift);
    let response = ui.add_enabled_ui(changes_keypad || field.is_some(), |ui| ui.add_sized(size, button)).inner;
    if !response.accessible_name(name).clicked() {
        return;
    }
    match key {
        Key::Letters => state.has_letters = !state.has_letters,
        Key::Shift => state.is_small = !state.is_small,
        key => {
            if let Some(field) = field {
                press(ui, view, field, key);
            }
        }
    }
}

/// Does in a field what a key is for.
fn press(ui: &Ui, view: &mut View<'_>, field: Field, key: Key) {
    let typed = match key {
        Key::Type('.') => Some(view.words.decimal_sign()),
        Key::Type(sign) => Some(sign),
        Key::Back | Key::Letters | Key::Shift => None,
        Key::Clear => {
            view.send(field.typed(String::new()));
            return focus(ui.ctx(), field, 0..0);
        }
        Key::Enter => {
            if view.session.page() == Page::Tables {
                view.act(TablesAction::SetCell);
            } else {
                view.send(Command::Enter(field));
            }
            // As after Enter: the next value replaces this one.
            let all = 0..view.session.text(field).chars().count();
            return focus(ui.ctx(), field, all);
        }
    };
    let is_free = view.session.is_free_text(field);
    let (text, cursor) = edited(view.session.text(field), selected(ui.ctx(), view, field), typed, is_free);
    view.send(field.typed(text));
    focus(ui.ctx(), field, cursor..cursor);
}

/// What is selected in a field, in characters; its end where nothing is known.
fn selected(ctx: &Context, view: &View<'_>, field: Field) -> Range<usize> {
    let end = view.session.text(field).chars().count();
    let range = TextEditState::load(ctx, field_id::id(field)).and_then(|state| state.cursor.char_range());
    range.map_or(end..end, |range| {
        let [from, to] = range.sorted_cursors().map(|cursor| usize::from(cursor.index).min(end));
        from..to
    })
}

/// Gives the focus back to the field, with this part of its text selected: in the next frame, when it has its new text.
fn focus(ctx: &Context, field: Field, selected: Range<usize>) {
    ctx.data_mut(|data| data.insert_temp(focus_id(), Some((field, selected))));
}

/// Something else gets the focus than what the last key asked for.
pub(super) fn leave(ctx: &Context) {
    ctx.data_mut(|data| data.remove::<Option<(Field, Range<usize>)>>(focus_id()));
}

fn focus_id() -> Id {
    Id::unique("keypad-focus")
}

/// Gives the focus to the field for which a key of the last frame asked for it.
fn give_focus(ctx: &Context) {
    let asked = ctx.data_mut(|data| data.get_temp_mut_or_default::<Option<(Field, Range<usize>)>>(focus_id()).take());
    let Some((field, selected)) = asked else { return };
    let id = field_id::id(field);
    field_id::select(ctx, id, CCursorRange::two(CCursor::new(selected.start), CCursor::new(selected.end)));
    ctx.memory_mut(|memory| memory.request_focus(id));
    ctx.data_mut(|data| data.insert_temp(given_id(), Some(id)));
}

fn given_id() -> Id {
    Id::unique("keypad-given")
}

/// A field gets the focus for what is being typed: its selection stays as it is.
pub(super) fn keep_selection(ctx: &Context, field: Id) {
    ctx.data_mut(|data| data.insert_temp(given_id(), Some(field)));
}

/// Whether a field has the focus again because of a key of the keypad, or of one that was typed: then its selection stays as it is.
pub(super) fn has_given_focus(ctx: &Context, field: Id) -> bool {
    ctx.data_mut(|data| data.remove_temp::<Option<Id>>(given_id())) == Some(Some(field))
}

/// The text after a key, and where the cursor is then: a sign replaces what is selected; without one, what is selected
/// is deleted, or the character before the cursor. A number has one decimal sign, so a second one is not typed; free
/// text may have any.
fn edited(text: &str, selected: Range<usize>, typed: Option<char>, is_free: bool) -> (String, usize) {
    let characters: Vec<char> = text.chars().collect();
    let (before, _) = characters.split_at(selected.start.min(characters.len()));
    let (_, after) = characters.split_at(selected.end.min(characters.len()));
    let joined = |before: &[char], typed: Option<char>| {
        before.iter().copied().chain(typed).chain(after.iter().copied()).collect()
    };
    let is_decimal = |c: &char| matches!(c, '.' | ',');
    let is_of_number = |c: &&char| c.is_ascii_digit() || is_decimal(c);
    match typed {
        Some(sign) if is_decimal(&sign) && !is_free => {
            let around = before.iter().rev().take_while(is_of_number).chain(after.iter().take_while(is_of_number));
            let has_one = around.copied().any(|c| is_decimal(&c));
            let sign = (!has_one).then_some(sign);
            (joined(before, sign), before.len() + usize::from(sign.is_some()))
        }
        Some(sign) => (joined(before, Some(sign)), before.len() + 1),
        None if selected.is_empty() => {
            let before = before.split_last().map_or(before, |(_, before)| before);
            (joined(before, None), before.len())
        }
        None => (joined(before, None), before.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_replace_what_is_selected_and_a_number_has_one_decimal_sign() {
        for (text, selected, typed, after, cursor) in [
            ("25.012", 0..6, Some('3'), "3", 1),
            ("25.012", 6..6, Some('3'), "25.0123", 7),
            ("25.012", 2..6, None, "25", 2),
            ("25.012", 6..6, None, "25.01", 5),
            ("", 0..0, None, "", 0),
            ("25.012", 6..6, Some('.'), "25.012", 6),
            ("25.012", 0..6, Some(','), ",", 1),
            ("12 +0.01 -0", 11..11, Some('.'), "12 +0.01 -0.", 12),
            ("25", 1..1, Some('.'), "2.5", 2),
        ] {
            assert_eq!(
                edited(text, selected.clone(), typed, false),
                (after.to_owned(), cursor),
                "{text} {selected:?} {typed:?}"
            );
        }
        assert_eq!(edited("A1.2", 4..4, Some('.'), true), ("A1.2.".to_owned(), 5), "a part's number is no number");
    }
}
