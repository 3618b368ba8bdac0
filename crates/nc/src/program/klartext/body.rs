//! What a block says: its first words decide which function reads the rest.

use super::super::block::{Body, Target, Unit};
use super::super::cursor::{Cursor, Read};
use super::super::fault::{BlockFault, Wanted};
use super::super::operand::Operand;
use super::around::around;
use super::functions::{assignment, declaration, function};
use super::moves::{line, tool_call};
use super::path_words::{is_axis_word, is_machine_function, machine_functions};
use crate::control::variables::Family;

/// The largest number of a label.
pub(in super::super) const MOST_LABEL: u32 = 65_535;
/// How often a part of a program can be repeated.
pub(in super::super) const MOST_REPEATS: u32 = 65_534;

/// Reads a block that is neither heading nor cycle. A block with an unknown beginning is [`Body::Other`].
pub(super) fn body(code: &str) -> Read<Body> {
    let mut cursor = Cursor::new(code);
    let cursor = &mut cursor;
    let Some(body) = known(cursor)? else { return Ok(Body::Other) };
    cursor.end()?;
    Ok(body)
}

fn known(cursor: &mut Cursor<'_>) -> Read<Option<Body>> {
    let Some(first) = cursor.next() else { return Ok(Some(Body::Nothing)) };
    match first.to_ascii_uppercase() {
        'B' if cursor.take_words(&["BEGIN", "PGM"]) => {
            let (name, unit) = name_and_unit(cursor)?;
            Ok(Some(Body::Begin { name, unit }))
        }
        'C' if cursor.take_words(&["CALL", "LBL"]) => call_label(cursor).map(Some),
        'C' if cursor.take_words(&["CALL", "SELECTED", "PGM"]) => Ok(Some(Body::CallSelectedProgram)),
        'C' if cursor.take_words(&["CALL", "PGM"]) => Ok(Some(Body::CallProgram(cursor.path(None)?))),
        'D' if cursor.take_words(&["DECLARE", "STRING"]) => declaration(cursor).map(Some),
        'E' if cursor.take_words(&["END", "PGM"]) => {
            let (name, unit) = name_and_unit(cursor)?;
            Ok(Some(Body::End { name, unit }))
        }
        'F' if cursor.take_word("FN") => function(cursor).map(Some),
        'L' if cursor.take_word("L") => line(cursor).map(Some),
        'L' if cursor.take_word("LBL") => label(cursor).map(Some),
        'M' if is_machine_function(cursor) => Ok(Some(Body::MachineFunctions(machine_functions(cursor)?))),
        'Q' => match cursor.clone().parameter()? {
            Some(_) => assignment(cursor).map(Some),
            None => Ok(None),
        },
        'S' if cursor.take_words(&["SEL", "PGM"]) => Ok(Some(Body::SelectProgram(cursor.path(None)?))),
        'S' if cursor.take_word("STOP") => Ok(Some(Body::Stop(machine_functions(cursor)?))),
        'T' if cursor.take_words(&["TOOL", "CALL"]) => tool_call(cursor).map(Some),
        // Paraxial positioning begins with its axis.
        _ if is_axis_word(cursor) => line(cursor).map(Some),
        _ => around(cursor),
    }
}

/// `name MM`: the unit is the last word.
fn name_and_unit(cursor: &mut Cursor<'_>) -> Read<(String, Unit)> {
    let from = cursor.clone();
    let text = cursor.take_rest();
    let unit = |word: &str| match word {
        word if word.eq_ignore_ascii_case("MM") => Some(Unit::Mm),
        word if word.eq_ignore_ascii_case("INCH") => Some(Unit::Inch),
        _ => None,
    };
    let (name, last) = text.rsplit_once(char::is_whitespace).unwrap_or(("", text));
    match unit(last) {
        Some(unit) => Ok((name.trim_end().to_owned(), unit)),
        None if text.is_empty() => Err(from.fail(BlockFault::Missing(Wanted::Unit))),
        None => Err(cursor.fail(BlockFault::Missing(Wanted::Unit))),
    }
}

/// `LBL 5`, `LBL "NAME"`, after the word.
fn label(cursor: &mut Cursor<'_>) -> Read<Body> {
    cursor.blanks();
    let at = cursor.clone();
    match target(cursor)? {
        Target::Parameter(parameter) => Err(at.fail(BlockFault::LabelOfParameter { parameter })),
        label => Ok(Body::Label(label)),
    }
}

/// A number, a quoted name, a parameter.
pub(super) fn target(cursor: &mut Cursor<'_>) -> Read<Target> {
    if let Some(name) = cursor.quoted() {
        return Ok(Target::Name(name.to_owned()));
    }
    if let Some(number) = cursor.whole(MOST_LABEL)? {
        return Ok(Target::Number(number));
    }
    match cursor.parameter()? {
        Some(parameter) => Ok(Target::Parameter(parameter)),
        None => Err(cursor.stop(Wanted::Label)),
    }
}

/// `CALL LBL 5 REP 3`, also `REP3`, `REP Q7` and the old `REP 25/25`: its second number counted the repeats left.
fn call_label(cursor: &mut Cursor<'_>) -> Read<Body> {
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
