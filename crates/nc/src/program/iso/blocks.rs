//! From lines to blocks, as only ISO does it: a block goes on to its `*`, at the latest to the next block number.

use super::super::block::{Body, Unit};
use super::super::error::ProgramWarningKind;
use super::super::lines::{Front, Piece, trimmed};
use super::super::milling::{Before, CutOff, Form, Reader, assigned};
use super::super::place::TextPlace;
use super::super::warnings::Odd;
use super::body::frame;
use super::modes::Modes;
use super::pieces::{front, piece};
use super::understand::{Collected, is_global, understand};

/// The most lines of a block; one without its `*` is not searched for it any further.
const MOST_LINES: usize = 500;

/// ISO, while a program is read.
pub(super) struct Iso {
    modes: Modes,
    /// Whether a `*` ends the present block.
    has_star: bool,
    /// Whether the program has begun.
    has_begun: bool,
}

impl Iso {
    pub(super) fn new(text: &str) -> Self {
        Self { modes: Modes::new(text), has_star: false, has_begun: false }
    }
}

impl Form for Iso {
    const FORMULAS: &'static [&'static str] = &["Q", "D"];
    const NO_END: ProgramWarningKind = ProgramWarningKind::IsoNoEnd;
    const AFTER_END: ProgramWarningKind = ProgramWarningKind::IsoAfterEnd;
    // It begins with its name, or it would not be read here.
    const NO_BEGIN: Option<ProgramWarningKind> = None;

    fn units(begin: Unit, end: Unit) -> ProgramWarningKind {
        ProgramWarningKind::IsoUnits { begin, end }
    }

    fn front(line: &str) -> Front {
        front(line)
    }

    /// Blank lines are skipped.
    fn collect(reader: &mut Reader<'_, Self>, line: usize, from: usize) -> usize {
        reader.pieces.clear();
        let (mut last, mut has_star) = piece(reader.source.line(line), line, from);
        reader.pieces.push(last);
        // Comments, headings and the program's name are whole without a `*`.
        let is_whole = last.code.is_empty() || last.code.starts_with('*') || frame(last.code).is_some();
        let is_global = is_global(last.code);
        while !is_whole && !has_star && (!is_global || last.goes_on) && reader.pieces.len() < MOST_LINES {
            let Some(next) = reader.next_line(last.line + 1) else { break };
            if begins_a_block(reader.source.line(next)) {
                break;
            }
            (last, has_star) = piece(reader.source.line(next), next, 0);
            reader.pieces.push(last);
        }
        reader.form.has_star = has_star;
        last.line + 1
    }

    fn understand(
        &mut self,
        weighed: Result<(), Odd>,
        front: Front,
        pieces: &[Piece<'_>],
        place: impl Fn(usize, usize) -> TextPlace,
    ) -> Result<Body, Odd> {
        let before = self.modes;
        let collected = Collected { pieces, has_star: self.has_star, is_first: !self.has_begun };
        let read = weighed.and_then(|()| understand(collected, &mut self.modes, place));
        match &read {
            Ok(body) => self.has_begun |= matches!(body, Body::Begin { .. }),
            Err(_) => pieces.iter().for_each(|piece| self.modes.not_understood(piece.code)),
        }
        if front.may_be_skipped {
            self.modes.skipped(before);
        }
        read
    }

    fn cut_off(before: Option<&Before>, front: Front, pieces: &[Piece<'_>], read: &Body) -> Option<CutOff> {
        let cut_off = assigned(before, front, pieces.first()?, read)?;
        Some(CutOff { what: in_iso(cut_off.what), ..cut_off })
    }
}

/// Whether a line can only be the first of a block.
fn begins_a_block(line: &str) -> bool {
    let front = front(line);
    let code = line.get(front.end..).map_or("", trimmed);
    front.number.is_some() || front.may_be_skipped || code.starts_with('%') || is_global(code)
}

/// What is wrong with a line of a cycle, without a `~`.
fn in_iso(what: ProgramWarningKind) -> ProgramWarningKind {
    match what {
        ProgramWarningKind::CycleCut { cycle, line, parameter } => {
            ProgramWarningKind::IsoCycleCut { cycle, line, parameter }
        }
        what => what,
    }
}
