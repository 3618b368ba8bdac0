//! Lines that a surplus `~` has put into the wrong block: one that a comment has swallowed is refused.

use fitcheck_core::text::{behind, until};

use super::super::around::Frame;
use super::super::block::{Block, Body};
use super::super::cursor::{Cursor, first_word};
use super::super::error::ProgramWarningKind;
use super::super::lines::{Front, Piece, front};
use super::super::milling::{Before, CutOff, assigned, first_parameter};
use super::body::body;

/// Looks at a block that was read, behind the last cycle if there is nothing between.
pub(super) fn cut_off(before: Option<&Before>, front: Front, pieces: &[Piece<'_>], read: &Body) -> Option<CutOff> {
    let (first, more) = pieces.split_first()?;
    if let Some(cut_off) = assigned(before, front, first, read) {
        return Some(cut_off);
    }
    let what = ProgramWarningKind::CommentGoesOn;
    match read {
        // The lines of a cycle are its own; what a comment has swallowed of a measuring cycle is looked for in them.
        Body::Probe(_) => {
            let of = |piece: &Piece<'_>| piece.comment.and_then(parameter_in);
            let (piece, found) = pieces.iter().enumerate().find_map(|(number, piece)| Some((number, of(piece)?)))?;
            Some(CutOff { piece, what: ProgramWarningKind::CommentHolds { found }, is_refused: true })
        }
        Body::CycleDefinition(_) | Body::GlobalDefinition(_) | Body::Frame(Frame::Preset(_)) | Body::Other => None,
        Body::Nothing | Body::Heading { .. } | Body::PassedOver(_) => swallowed(more),
        _ if first.goes_on && first.comment.is_some() => Some(CutOff { piece: 0, what, is_refused: true }),
        _ => swallowed(more),
    }
}

/// A block that a `~` before it has made part of another.
fn swallowed(more: &[Piece<'_>]) -> Option<CutOff> {
    let number = more.iter().position(|piece| {
        let line = if piece.code.is_empty() { piece.comment } else { Some(piece.code) };
        line.is_some_and(is_block)
    })?;
    let is_comment = more.get(number).is_some_and(|piece| piece.code.is_empty());
    let what = if is_comment { ProgramWarningKind::CommentGoesOn } else { ProgramWarningKind::BlockGoesOn };
    Some(CutOff { piece: 1 + number, what, is_refused: true })
}

/// A parameter with its value within a comment, as an error repeats it.
fn parameter_in(comment: &str) -> Option<String> {
    first_parameter(comment, |cursor| cursor.take('=')).map(|(_, rest)| first_word(rest))
}

/// Whether a line behind a machining cycle or a definition of global values belongs to it, although the `~` before it is
/// missing: CAM programs have such cycles, and nothing that is measured depends on them. Numbered lines are blocks.
pub(super) fn belongs(last: Option<&Block>, front: Front, first: &Piece<'_>) -> bool {
    let Some(last) = last else { return false };
    let is_definition = match &last.body {
        // In a program without numbers a line cannot be told from an assignment, which has the same effect.
        Body::CycleDefinition(_) => last.number.is_some(),
        Body::GlobalDefinition(_) => true,
        _ => false,
    };
    let mut cursor = Cursor::new(first.code);
    let is_line = cursor.take_prefix("Q") && matches!(cursor.next(), Some('0'..='9' | 'S' | 's'));
    is_definition && is_line && front.number.is_none()
}

/// Whether a line is a block by itself.
pub(super) fn is_block(line: &str) -> bool {
    let front = front(line);
    let code = until(behind(line, front.end), ';').trim_end_matches([' ', '~']);
    let is_cycle = |words: [&str; 2]| Cursor::new(code).take_words(&words);
    [["TCH", "PROBE"], ["CYCL", "DEF"], ["GLOBAL", "DEF"]].into_iter().any(is_cycle)
        || matches!(body(code), Ok(read) if !matches!(read, Body::Nothing | Body::PassedOver(_) | Body::Other))
}
