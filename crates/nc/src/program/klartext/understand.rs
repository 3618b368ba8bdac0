//! From the lines of one block to what it says.

use super::super::block::Body;
use super::super::cursor::{Cursor, Stop};
use super::super::cycle_block::CycleBlock;
use super::super::error::ProgramWarningKind;
use super::super::fault::BlockFault;
use super::super::lines::Piece;
use super::super::milling::{cycle_head, first_parameter, with_lines};
use super::super::place::TextPlace;
use super::super::warnings::{LONGEST, Odd};
use super::super::words::DEEPEST;
use super::around::defined;
use super::body::body;
use super::cut_off::is_block;
use super::frames::dotted;

/// What the lines of a block say; `place` turns a line and its bytes into a place in characters.
pub(super) fn understand(pieces: &[Piece<'_>], place: impl Fn(usize, usize) -> TextPlace) -> Result<Body, Odd> {
    if let Some(odd) = pieces.iter().find_map(Odd::open_quote) {
        return Err(odd);
    }
    let Some((first, more)) = pieces.split_first() else { return Ok(Body::Nothing) };
    if let Some(text) = first.code.strip_prefix('*') {
        return Ok(heading(text));
    }
    let mut cursor = Cursor::new(first.code);
    if cursor.take_words(&["TCH", "PROBE"]) {
        return cycle(cursor, first, more, place).map(Body::Probe);
    }
    if cursor.take_words(&["GLOBAL", "DEF"]) {
        return cycle(cursor, first, more, place).map(Body::GlobalDefinition);
    }
    if cursor.take_words(&["CYCL", "DEF"]) {
        let whole = dotted(&mut cursor).map_err(|stop| Odd::of(first, stop))?;
        return match whole {
            Some(body) => Ok(body),
            None => cycle(cursor, first, more, place).map(defined),
        };
    }
    // A comment that ends in ~ continues on the next line; only without a comment does the block itself continue.
    let pieces = if first.comment.is_some() { std::slice::from_ref(first) } else { pieces };
    plain(pieces)
}

/// A block that is not a cycle: its lines are read as one.
fn plain(pieces: &[Piece<'_>]) -> Result<Body, Odd> {
    let Some(first) = pieces.first() else { return Ok(Body::Nothing) };
    let length: usize = pieces.iter().map(|piece| piece.code.len() + 1).sum();
    if LONGEST < length {
        return Err(Odd::of(first, Stop { at: 0, reason: BlockFault::TooLong { most: LONGEST } }));
    }
    if pieces.len() == 1 {
        return body(first.code).map_err(|stop| Odd::of(first, stop));
    }
    let codes: Vec<&str> = pieces.iter().map(|piece| piece.code).collect();
    body(&codes.join(" ")).map_err(|Stop { mut at, reason }| {
        let mut of = first;
        for piece in pieces {
            of = piece;
            if at <= piece.code.len() {
                break;
            }
            at -= piece.code.len() + 1;
        }
        Odd::of(of, Stop { at, reason })
    })
}

fn cycle(
    mut cursor: Cursor<'_>,
    first: &Piece<'_>,
    more: &[Piece<'_>],
    place: impl Fn(usize, usize) -> TextPlace,
) -> Result<CycleBlock, Odd> {
    let cycle = cycle_head(&mut cursor).map_err(|stop| Odd::of(first, stop))?;
    // The name ends where the first parameter begins.
    let at = first_parameter(&cycle.name, |cursor| cursor.take('=')).map(|(name, _)| name.len());
    with_lines(cycle, at, first, more, place).map_err(|odd| {
        // The `~` above it is one too many.
        let is_swallowed = more.iter().any(|piece| piece.line == odd.line && is_block(piece.code));
        if is_swallowed { Odd { what: ProgramWarningKind::BlockGoesOn, ..odd } } else { odd }
    })
}

/// `* - text`: each two more blanks before or after the dash are one level more.
pub(in super::super) fn heading(text: &str) -> Body {
    let blanks = |text: &str| text.len() - text.trim_start_matches(' ').len();
    let before = blanks(text);
    let text = text.trim();
    let (behind, text) = text.strip_prefix('-').map_or((0, text), |text| (blanks(text), text));
    let depth = 1 + before.saturating_sub(1) / 2 + behind.saturating_sub(1) / 2;
    Body::Heading { depth: depth.min(DEEPEST), text: text.trim().to_owned() }
}
