//! Words of a path: axes with their values, and M functions.

use super::super::cursor::{Cursor, Parsed};
use super::super::movement::{Axis, AxisWord, MachineFunction};
use super::super::words::{AXES, meaning};

/// The largest number of an M function.
pub(in super::super) const MOST_M: u32 = 9999;

/// `IX+2,5`; blanks may occur anywhere in it.
pub(super) fn axis_word(cursor: &mut Cursor<'_>) -> Parsed<Option<AxisWord>> {
    let mut ahead = cursor.clone();
    let is_incremental = ahead.take_prefix("I");
    let Some(axis) = axis_letter(&mut ahead) else { return Ok(None) };
    let value = ahead.operand()?;
    *cursor = ahead;
    Ok(Some(AxisWord { axis, is_incremental, value }))
}

pub(super) fn axis_letter(cursor: &mut Cursor<'_>) -> Option<Axis> {
    let letter = cursor.next().filter(char::is_ascii_alphabetic)?;
    let axis = meaning(&AXES, letter.encode_utf8(&mut [0; 4]))?;
    cursor.take(letter);
    Some(axis)
}

/// Whether an axis with its value comes next: paraxial positioning begins with it (`X+37.8 R0 FMAX`).
pub(super) fn is_axis_word(cursor: &Cursor<'_>) -> bool {
    let mut ahead = cursor.clone();
    ahead.take_prefix("I");
    axis_letter(&mut ahead).is_some()
        && ahead.rest().starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | 'Q' | 'q'))
}

/// M functions up to the end, or to an axis with its value; other text after a number belongs to it.
pub(super) fn machine_functions(cursor: &mut Cursor<'_>) -> Parsed<Vec<MachineFunction>> {
    let mut found = Vec::new();
    while !cursor.is_at_end() {
        if found.is_empty() && !is_machine_function(cursor) {
            cursor.end()?;
        }
        cursor.take_prefix("M");
        let number = cursor.expect_whole(MOST_M)?;
        let at = cursor.at();
        cursor.blanks();
        while !cursor.is_at_end() && !is_machine_function(cursor) && !is_axis_word(cursor) {
            cursor.take_while(|c| !c.is_whitespace());
        }
        found.push(MachineFunction { number, rest: cursor.since(at).to_owned() });
        // `L X+0 M8 C+90`: the axis moves.
        if is_axis_word(cursor) {
            break;
        }
    }
    Ok(found)
}

/// Whether `M` and a digit come next.
pub(super) fn is_machine_function(cursor: &Cursor<'_>) -> bool {
    let mut ahead = cursor.clone();
    ahead.take_prefix("M") && ahead.rest().trim_start().starts_with(|c: char| c.is_ascii_digit())
}

/// `X+10`, `IY - 5`, if it comes next.
pub(in super::super) fn axis(cursor: &mut Cursor<'_>) -> Parsed<Option<AxisWord>> {
    let mut ahead = cursor.clone();
    ahead.take_prefix("I");
    let is_value =
        axis_letter(&mut ahead).is_some() && matches!(ahead.next(), Some('0'..='9' | '+' | '-' | '.' | 'Q' | 'q'));
    if is_value { axis_word(cursor) } else { Ok(None) }
}
