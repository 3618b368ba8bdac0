//! From the lines of one block to what it says.

use super::super::block::Body;
use super::super::cursor::{Cursor, Stop};
use super::super::cycle_block::CycleBlock;
use super::super::error::ProgramWarningKind;
use super::super::fault::BlockFault;
use super::super::klartext::{cycle_head, cycle_line, defined, first_parameter, heading};
use super::super::lines::Piece;
use super::super::place::Place;
use super::super::warnings::{LONGEST, Odd};
use super::body::{body, frame};
use super::modes::Modes;
use super::pieces::front;

/// Whether a block is the line of Klartext that gives values to `PREDEF`.
pub(super) fn is_global(code: &str) -> bool {
    Cursor::new(code).take_words(&["GLOBAL", "DEF"])
}

/// The lines of a block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Collected<'p, 'a> {
    pub pieces: &'p [Piece<'a>],
    /// Whether a `*` ends the last of them.
    pub has_star: bool,
    /// Whether the program has not begun.
    pub is_first: bool,
}

/// What the lines of a block say; `place` turns a line and its bytes into a place in characters.
pub(super) fn understand(
    Collected { pieces, has_star, is_first }: Collected<'_, '_>,
    modes: &mut Modes,
    place: impl Fn(usize, usize) -> Place,
) -> Result<Body, Odd> {
    let open = pieces.iter().find_map(|piece| piece.open_quote.map(|at| (piece.line, at)));
    if let Some((line, at)) = open {
        return Err(Odd { line, at, what: ProgramWarningKind::UnclosedQuote });
    }
    let (Some((first, more)), Some(last)) = (pieces.split_first(), pieces.last()) else { return Ok(Body::Nothing) };
    let is_cycle = is_global(first.code) || cycle_number(first.code).is_some();
    if let Some(odd) = pieces.iter().find_map(|piece| swallowed(piece, is_cycle)) {
        return Err(odd);
    }
    if first.code.is_empty() {
        return Ok(Body::Nothing);
    }
    if let Some(text) = first.code.strip_prefix('*') {
        // A second `*` is no structure.
        return if text.trim_start().starts_with('-') { Ok(heading(text)) } else { Err(left_over(first, "*")) };
    }
    if let Some((name, unit)) = frame(first.code) {
        return Ok(if is_first { Body::Begin { name, unit } } else { Body::End { name, unit } });
    }
    let end = |what| Odd { line: last.line, at: last.start + last.code.len(), what };
    if has_star && last.goes_on {
        return Err(left_over(last, "~"));
    }
    if is_global(first.code) {
        let mut cursor = Cursor::new(first.code);
        cursor.take_words(&["GLOBAL", "DEF"]);
        return if last.goes_on {
            Err(end(ProgramWarningKind::OpenEnd))
        } else {
            cycle(cursor, first, more, place).map(Body::GlobalDefinition)
        };
    }
    if !has_star {
        return Err(end(ProgramWarningKind::NoStar));
    }
    if let Some(number) = cycle_number(first.code) {
        let mut cursor = Cursor::new(first.code);
        cursor.take_prefix("G");
        let mut cycle = cycle(cursor, first, more, place)?;
        cycle.number = number.to_string();
        return Ok(if number < 300 { defined(cycle) } else { Body::Probe(cycle) });
    }
    if let Some(next) = more.iter().find(|piece| !piece.code.is_empty()) {
        return Err(left_over(next, next.code.split_whitespace().next().unwrap_or_default()));
    }
    if LONGEST < first.code.len() {
        return Err(not_understood(first, 0, BlockFault::TooLong { most: LONGEST }));
    }
    body(first.code, modes).map_err(|Stop { at, reason }| not_understood(first, at, reason))
}

fn not_understood(piece: &Piece<'_>, at: usize, reason: BlockFault) -> Odd {
    Odd { line: piece.line, at: piece.start + at, what: ProgramWarningKind::NotUnderstood(reason) }
}

fn left_over(piece: &Piece<'_>, found: &str) -> Odd {
    not_understood(piece, 0, BlockFault::LeftOver { found: found.chars().take(24).collect() })
}

/// The number of a cycle with Q parameters: G200 to G299 machine, G400 to G499 probe.
fn cycle_number(code: &str) -> Option<u32> {
    let mut cursor = Cursor::new(code);
    let number = cursor.take_prefix("G").then(|| cursor.whole(999).ok().flatten())??;
    let is_whole = !cursor.rest().starts_with(['.', ',']);
    (is_whole && matches!(number, 200..300 | 400..500)).then_some(number)
}

/// A cycle: all words in one line, or lines as in Klartext.
fn cycle(
    mut cursor: Cursor<'_>,
    first: &Piece<'_>,
    more: &[Piece<'_>],
    place: impl Fn(usize, usize) -> Place,
) -> Result<CycleBlock, Odd> {
    let in_first = |Stop { at, reason }| not_understood(first, at, reason);
    let mut cycle = cycle_head(&mut cursor).map_err(in_first)?;
    // The name ends where the first parameter begins.
    let name_at = first.code.len() - cycle.name.len();
    let words = cycle.name.clone();
    let at = first_parameter(&words, |_| true).unwrap_or(words.len());
    // A name has no figures and signs: `X+5` is none, nor is a parameter without its `=`.
    let name = words.get(..at).unwrap_or_default();
    if let Some(odd) =
        name.split_whitespace().find(|word| word.contains(|c: char| c.is_ascii_digit() || "+*=~%".contains(c)))
    {
        let found = odd.chars().take(24).collect();
        return Err(not_understood(first, name_at + name.find(odd).unwrap_or(0), BlockFault::LeftOver { found }));
    }
    if at < words.len() {
        cycle.name.truncate(at);
        cycle.name.truncate(cycle.name.trim_end().len());
        let start = first.start + name_at + at;
        let rest = Piece { code: words.get(at..).unwrap_or_default(), start, ..*first };
        cycle_line(&mut cycle, &rest, |at| place(first.line, start + at))
            .map_err(|Stop { at, reason }| not_understood(&rest, at, reason))?;
    }
    for piece in more {
        cycle_line(&mut cycle, piece, |at| place(piece.line, piece.start + at))
            .map_err(|Stop { at, reason }| not_understood(piece, at, reason))?;
    }
    Ok(cycle)
}

/// What a comment has swallowed: a parameter of a cycle that goes on in the same line, or a block behind a `*`.
fn swallowed(piece: &Piece<'_>, is_cycle: bool) -> Option<Odd> {
    let comment = piece.comment?;
    let at = if is_cycle { first_parameter(comment, |cursor| cursor.take('=')) } else { None };
    let parameter = at.and_then(|at| comment.get(at..));
    let mut parts = comment.split('*').skip(1).map(str::trim_start);
    let found = parameter.or_else(|| parts.find(|part| front(part).number.is_some()))?;
    let found = found.split_whitespace().next().unwrap_or_default().chars().take(24).collect();
    let at = piece.start + piece.code.len();
    Some(Odd { line: piece.line, at, what: ProgramWarningKind::CommentHolds { found } })
}
