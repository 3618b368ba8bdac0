//! From the lines of one block to what it says.

use super::super::block::Body;
use super::super::cursor::{Cursor, Stop, first_word, shown};
use super::super::cycle_block::CycleBlock;
use super::super::error::ProgramWarningKind;
use super::super::fault::BlockFault;
use super::super::klartext::{defined, heading};
use super::super::lines::Piece;
use super::super::milling::{cycle_head, first_parameter, with_lines};
use super::super::place::TextPlace;
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
    place: impl Fn(usize, usize) -> TextPlace,
) -> Result<Body, Odd> {
    if let Some(odd) = pieces.iter().find_map(Odd::open_quote) {
        return Err(odd);
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
    if let Some((next, word)) = more.iter().find_map(|piece| Some((piece, piece.code.split_whitespace().next()?))) {
        return Err(left_over(next, word));
    }
    if LONGEST < first.code.len() {
        return Err(Odd::of(first, Stop { at: 0, reason: BlockFault::TooLong { most: LONGEST } }));
    }
    body(first.code, modes).map_err(|stop| Odd::of(first, stop))
}

fn left_over(piece: &Piece<'_>, found: &str) -> Odd {
    Odd::of(piece, Stop { at: 0, reason: BlockFault::LeftOver { found: shown(found) } })
}

/// The number of a cycle with Q parameters: G200 to G299 machine, G400 to G499 and G1400 to G1499 probe.
fn cycle_number(code: &str) -> Option<u32> {
    let mut cursor = Cursor::new(code);
    let number = cursor.take_prefix("G").then(|| cursor.whole(1499).ok().flatten())??;
    let is_whole = !cursor.rest().starts_with(['.', ',']);
    (is_whole && matches!(number, 200..300 | 400..500 | 1400..1500)).then_some(number)
}

/// A cycle: all words in one line, or lines as in Klartext.
fn cycle(
    mut cursor: Cursor<'_>,
    first: &Piece<'_>,
    more: &[Piece<'_>],
    place: impl Fn(usize, usize) -> TextPlace,
) -> Result<CycleBlock, Odd> {
    let cycle = cycle_head(&mut cursor).map_err(|stop| Odd::of(first, stop))?;
    // The name ends where the first parameter begins.
    let parameter = first_parameter(&cycle.name, |_| true);
    let name = parameter.map_or(cycle.name.as_str(), |(name, _)| name);
    // A name has no figures and signs: `X+5` is none, nor is a parameter without its `=`.
    let is_odd = |word: &&str| word.contains(|c: char| c.is_ascii_digit() || "+*=~%".contains(c));
    if let Some((at, odd)) = name.split_whitespace().filter(is_odd).find_map(|odd| Some((name.find(odd)?, odd))) {
        let at = first.code.len() - cycle.name.len() + at;
        return Err(Odd::of(first, Stop { at, reason: BlockFault::LeftOver { found: shown(odd) } }));
    }
    let at = parameter.map(|(name, _)| name.len());
    with_lines(cycle, at, first, more, place)
}

/// What a comment has swallowed: a parameter of a cycle that goes on in the same line, or a block behind a `*`.
fn swallowed(piece: &Piece<'_>, is_cycle: bool) -> Option<Odd> {
    let comment = piece.comment?;
    let parameter = first_parameter(comment, |cursor| cursor.take('=')).filter(|_| is_cycle).map(|(_, rest)| rest);
    let mut parts = comment.split('*').skip(1).map(str::trim_start);
    let found = parameter.or_else(|| parts.find(|part| front(part).number.is_some()))?;
    let found = first_word(found);
    let at = piece.start + piece.code.len();
    Some(Odd { line: piece.line, at, what: ProgramWarningKind::CommentHolds { found } })
}
