//! What a key does in the field that the keypad types into, and how that field has the focus again.

use std::ops::Range;

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{Context, Id, Ui};

use super::sheets::{Key, with_class};
use crate::gui::field_id;
use crate::gui::view::View;
use crate::session::{Command, Field, FitField, Page, TablesAction};

/// Does in a field what a key is for.
pub(super) fn press(ui: &Ui, view: &mut View<'_>, field: Field, key: Key) {
    let typed = match key {
        Key::Type('.') => Some(view.words.decimal_sign()),
        Key::Type(sign) => Some(sign),
        Key::Back | Key::Show(_) | Key::Shift => None,
        Key::Class(class) => {
            let is_fit = field == FitField::Callout.into();
            let text = with_class(view.session.text(field), class, is_fit);
            let end = text.chars().count();
            view.send(field.typed(text));
            return focus(ui.ctx(), field, end..end);
        }
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
    // After a verdict a key begins the next value of an operator, and never goes on with the one before.
    let begins = view.session.is_for_operators() && view.session.rests();
    let all = 0..view.session.text(field).chars().count();
    let selected = if begins { all } else { selected(ui.ctx(), view, field) };
    let (text, cursor) = edited(view.session.text(field), selected, typed, is_free);
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
pub(super) fn focus(ctx: &Context, field: Field, selected: Range<usize>) {
    ctx.data_mut(|data| data.insert_temp(focus_id(), Some((field, selected))));
}

/// Something else gets the focus than what the last key asked for.
pub(in crate::gui) fn leave(ctx: &Context) {
    ctx.data_mut(|data| data.remove::<Option<(Field, Range<usize>)>>(focus_id()));
}

fn focus_id() -> Id {
    Id::unique("keypad-focus")
}

/// Gives the focus to the field for which a key of the last frame asked for it.
pub(super) fn give_focus(ctx: &Context) {
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
pub(in crate::gui) fn keep_selection(ctx: &Context, field: Id) {
    ctx.data_mut(|data| data.insert_temp(given_id(), Some(field)));
}

/// Whether a field has the focus again because of a key of the keypad, or of one that was typed: then its selection stays as it is.
pub(in crate::gui) fn has_given_focus(ctx: &Context, field: Id) -> bool {
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
