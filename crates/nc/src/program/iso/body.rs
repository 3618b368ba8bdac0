//! What a block of one line says: its first sign decides which function reads the rest.

use super::super::block::{Body, Target, Unit};
use super::super::cursor::{Cursor, Parsed};
use super::super::fault::ExpectedWord;
use super::super::klartext::{MOST_REPEATS, assignment, label_number};
use super::super::operand::Operand;
use super::codes;
use super::functions::function;
use super::modes::Modes;
use super::words::Words;

/// `%NAME G71`: the name and the unit of a program, in its first and in its last block.
pub(super) fn frame(code: &str) -> Option<(String, Unit)> {
    let (name, unit) = code.strip_prefix('%')?.trim_end().rsplit_once(char::is_whitespace)?;
    let unit = match unit {
        unit if unit.eq_ignore_ascii_case("G71") => Unit::Mm,
        unit if unit.eq_ignore_ascii_case("G70") => Unit::Inch,
        _ => return None,
    };
    Some((name.trim().to_owned(), unit))
}

/// Reads a block that is neither heading nor cycle nor frame.
pub(super) fn body(code: &str, modes: &mut Modes) -> Parsed<Body> {
    let mut cursor = Cursor::new(code);
    let cursor = &mut cursor;
    let Some(first) = cursor.next() else { return Ok(Body::Nothing) };
    let body = match first.to_ascii_uppercase() {
        '%' => {
            cursor.take('%');
            modes.forget();
            Body::CallProgram(cursor.path(None)?)
        }
        'D' if is_function(cursor) => {
            cursor.take_prefix("D");
            function(cursor)?
        }
        'L' => {
            cursor.take_prefix("L");
            call_label(cursor, modes)?
        }
        'Q' => assignment(cursor)?,
        _ => match label(cursor)? {
            Some(label) => {
                modes.join();
                Body::Label(label)
            }
            None => return codes::body(&Words::read(cursor)?, modes),
        },
    };
    cursor.end()?;
    Ok(body)
}

/// Whether `D` and a digit come next: not `DL+0.2`.
fn is_function(cursor: &Cursor<'_>) -> bool {
    let mut ahead = cursor.clone();
    ahead.take_prefix("D") && ahead.next().is_some_and(|c| c.is_ascii_digit())
}

/// `G98 L1`.
fn label(cursor: &mut Cursor<'_>) -> Parsed<Option<Target>> {
    let mut ahead = cursor.clone();
    if !ahead.take_prefix("G") || ahead.whole(999).ok().flatten() != Some(98) {
        return Ok(None);
    }
    *cursor = ahead;
    if !cursor.take_prefix("L") {
        return Err(cursor.stop(ExpectedWord::Word("L")));
    }
    Ok(Some(Target::Number(label_number(cursor)?)))
}

/// `L1,0` calls a subprogram, `L1,2` repeats a part of the program twice; after the `L`.
fn call_label(cursor: &mut Cursor<'_>, modes: &mut Modes) -> Parsed<Body> {
    let number = label_number(cursor)?;
    cursor.expect(',', ",")?;
    let count = cursor.expect_whole(MOST_REPEATS)?;
    let repeat = (0 < count).then(|| Operand::Number(f64::from(count)));
    if repeat.is_none() {
        modes.join();
    }
    Ok(Body::CallLabel { label: Target::Number(number), repeat })
}
