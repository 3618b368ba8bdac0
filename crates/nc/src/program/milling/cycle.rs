//! Cycles: a number, a name and lines with a value for each parameter.

use super::super::cursor::{Cursor, Parsed, Stop};
use super::super::cycle_block::{CycleBlock, CycleLine, CycleName, CycleValue};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::lines::Piece;
use super::super::operand::TextOperand;
use super::super::place::TextPlace;
use super::super::warnings::Odd;
use crate::control::variables::Family;

/// The number and the name, after `TCH PROBE` or `CYCL DEF`.
pub(in super::super) fn head(cursor: &mut Cursor<'_>) -> Parsed<CycleBlock> {
    let Some(number) = cursor.number_text() else { return Err(cursor.stop(ExpectedWord::Number)) };
    Ok(CycleBlock { number: number.to_owned(), name: cursor.take_rest().to_owned(), lines: Vec::new() })
}

/// Adds the content of a line; `column` turns a byte position in the line's code into a place.
pub(in super::super) fn line(
    cycle: &mut CycleBlock,
    piece: &Piece<'_>,
    column: impl Fn(usize) -> TextPlace,
) -> Parsed<()> {
    let mut cursor = Cursor::new(piece.code);
    while !cursor.is_at_end() {
        let place = column(cursor.at());
        let parameter = name(&mut cursor)?;
        cursor.expect('=', "=")?;
        let value = value(&mut cursor)?;
        // Without one, a line of a cycle has an empty comment.
        let comment = piece.comment.map_or_else(String::new, str::to_owned);
        cycle.lines.push(CycleLine { parameter, value, place, comment });
    }
    Ok(())
}

/// A parameter, or a word before `=`: a cycle may have an input without a number (`MB`).
fn name(cursor: &mut Cursor<'_>) -> Parsed<CycleName> {
    let mut ahead = cursor.clone();
    let word = ahead.letters();
    ahead.take_prefix(word);
    // A Q without its number is no word.
    if word.is_empty() || word.starts_with(['Q', 'q']) || ahead.next() != Some('=') {
        return Ok(cursor.any_parameter()?.into());
    }
    *cursor = ahead;
    Ok(CycleName::Word(word.to_owned()))
}

fn value(cursor: &mut Cursor<'_>) -> Result<CycleValue, Stop> {
    if let Some(text) = cursor.quoted() {
        return Ok(CycleValue::Text(TextOperand::Text(text.to_owned())));
    }
    cursor.blanks();
    let from = cursor.clone();
    if let Some(parameter) = cursor.parameter()?.filter(|parameter| parameter.family == Family::Qs) {
        return Ok(CycleValue::Text(TextOperand::Parameter(parameter)));
    }
    *cursor = from.clone();
    let word = cursor.take_while(|c| c.is_ascii_alphabetic());
    let is_parameter = cursor.rest().starts_with(|c: char| c.is_ascii_digit());
    if !word.is_empty() && !is_parameter {
        return Ok(CycleValue::Word(word.to_owned()));
    }
    *cursor = from.clone();
    match cursor.operand() {
        Ok(value) => {
            let text = cursor.since(from.at()).chars().filter(|c| !c.is_whitespace()).collect();
            Ok(CycleValue::Number { value, text })
        }
        // A number beyond its range has an error of its own; anything else is not a value.
        Err(stop) if matches!(stop.reason, BlockFault::Missing(_) | BlockFault::Unexpected { .. }) => {
            Err(from.clone().stop(ExpectedWord::CycleValue))
        }
        Err(stop) => Err(stop),
    }
}

/// A text before the first parameter behind which this stands, and from there on.
pub(in super::super) fn first_parameter(
    text: &str,
    is_followed: impl Fn(&mut Cursor<'_>) -> bool,
) -> Option<(&str, &str)> {
    let is_parameter = |rest: &str| {
        let mut cursor = Cursor::new(rest);
        // One whose number is too large is refused where it is read.
        !matches!(cursor.parameter(), Ok(None)) && is_followed(&mut cursor)
    };
    text.match_indices(['Q', 'q'])
        .filter_map(|(at, _)| text.split_at_checked(at))
        .find(|(before, rest)| !before.ends_with(|c: char| c.is_alphanumeric()) && is_parameter(rest))
}

/// A cycle with all its lines. Its first line holds its name, and perhaps its first parameters behind `at` bytes of the name.
pub(in super::super) fn with_lines(
    mut cycle: CycleBlock,
    at: Option<usize>,
    first: &Piece<'_>,
    more: &[Piece<'_>],
    place: impl Fn(usize, usize) -> TextPlace,
) -> Result<CycleBlock, Odd> {
    let words = cycle.name.clone();
    let of_first = at.and_then(|at| words.split_at_checked(at)).map(|(name, code)| {
        // A `~` between them comes from a line end that was lost.
        name.trim_end_matches(|c: char| c == '~' || c.is_whitespace()).clone_into(&mut cycle.name);
        Piece { code, start: first.start + first.code.len() - code.len(), ..*first }
    });
    for piece in of_first.iter().chain(more) {
        line(&mut cycle, piece, |at| place(piece.line, piece.start + at)).map_err(|stop| Odd::of(piece, stop))?;
    }
    Ok(cycle)
}
