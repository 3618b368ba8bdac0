//! What a block says: its first words decide which function reads the rest.

use super::super::block::{Body, Unit};
use super::super::cursor::{Cursor, Parsed};
use super::super::fault::{BlockFault, ExpectedWord};
use super::around::around;
use super::functions::{assignment, declaration, function};
use super::label::{call_label, label};
use super::moves::{line, tool_call};
use super::path_words::{is_axis_word, is_machine_function, machine_functions};

/// Reads a block that is neither heading nor cycle. A block with an unknown beginning is [`Body::Other`].
pub(super) fn body(code: &str) -> Parsed<Body> {
    let mut cursor = Cursor::new(code);
    let cursor = &mut cursor;
    let Some(body) = known(cursor)? else { return Ok(Body::Other) };
    cursor.end()?;
    Ok(body)
}

fn known(cursor: &mut Cursor<'_>) -> Parsed<Option<Body>> {
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
fn name_and_unit(cursor: &mut Cursor<'_>) -> Parsed<(String, Unit)> {
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
        None if text.is_empty() => Err(from.fail(BlockFault::Missing(ExpectedWord::Unit))),
        None => Err(cursor.fail(BlockFault::Missing(ExpectedWord::Unit))),
    }
}
