//! Labels: where they stand, and what calls them.

use super::super::block::{Body, Target};
use super::super::cursor::{Cursor, Parsed};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::operand::Operand;
use crate::control::variables::Family;

/// The largest number of a label.
const MOST_LABEL: u32 = 65_535;
/// How often a part of a program can be repeated.
pub(in super::super) const MOST_REPEATS: u32 = 65_534;

/// `LBL 5`, `LBL "NAME"`, after the word.
pub(super) fn label(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.blanks();
    let at = cursor.clone();
    match target(cursor)? {
        Target::Parameter(parameter) => Err(at.fail(BlockFault::LabelOfParameter { parameter })),
        label => Ok(Body::Label(label)),
    }
}

/// The number of a label, in ISO its only name.
pub(in super::super) fn number(cursor: &mut Cursor<'_>) -> Parsed<u32> {
    match cursor.whole(MOST_LABEL)? {
        Some(number) => Ok(number),
        None => Err(cursor.stop(ExpectedWord::Label)),
    }
}

/// A number, a quoted name, a parameter.
pub(super) fn target(cursor: &mut Cursor<'_>) -> Parsed<Target> {
    if let Some(name) = cursor.quoted() {
        return Ok(Target::Name(name.to_owned()));
    }
    if let Some(number) = cursor.whole(MOST_LABEL)? {
        return Ok(Target::Number(number));
    }
    match cursor.parameter()? {
        Some(parameter) => Ok(Target::Parameter(parameter)),
        None => Err(cursor.stop(ExpectedWord::Label)),
    }
}

/// `CALL LBL 5 REP 3`, also `REP3`, `REP Q7` and the old `REP 25/25`: its second number counted the repeats left.
pub(super) fn call_label(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let label = target(cursor)?;
    let mut repeat = None;
    if cursor.take_prefix("REP") {
        repeat = Some(match cursor.parameter()?.filter(|parameter| parameter.family != Family::Qs) {
            Some(parameter) => Operand::Parameter { parameter, is_negative: false },
            None => Operand::Number(f64::from(cursor.expect_whole(MOST_REPEATS)?)),
        });
        if cursor.take('/') {
            cursor.expect_whole(MOST_REPEATS)?;
        }
    }
    Ok(Body::CallLabel { label, repeat })
}
