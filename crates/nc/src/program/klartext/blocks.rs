//! From lines to blocks, as only Klartext does it.

use super::super::block::{Block, Body, Unit};
use super::super::cycle_block::CycleBlock;
use super::super::error::ProgramWarningKind;
use super::super::lines::{Front, Piece, first, front, next, trimmed};
use super::super::milling::{Before, CutOff, Form, Reader, cycle_line};
use super::super::place::TextPlace;
use super::super::warnings::Odd;
use super::cut_off::{belongs, cut_off};
use super::understand::understand;

/// Klartext, while a program is read.
#[derive(Default)]
pub(super) struct Klartext {
    /// How many blocks there were when lines were added to the last one.
    joined: Option<usize>,
}

impl Form for Klartext {
    const FORMULAS: &'static [&'static str] = &["Q", "FN", "DECLARE"];
    const NO_END: ProgramWarningKind = ProgramWarningKind::NoEnd;
    const AFTER_END: ProgramWarningKind = ProgramWarningKind::AfterEnd;
    const NO_BEGIN: Option<ProgramWarningKind> = Some(ProgramWarningKind::NoBegin);

    fn units(begin: Unit, end: Unit) -> ProgramWarningKind {
        ProgramWarningKind::Units { begin, end }
    }

    fn front(line: &str) -> Front {
        front(line)
    }

    /// A comment that is a block of its own continues as a comment; otherwise every line is parsed. Blank lines are skipped.
    fn collect(reader: &mut Reader<'_, Self>, line: usize, from: usize) -> usize {
        reader.pieces.clear();
        let mut last = first(reader.source.line(line), line, from);
        reader.pieces.push(last);
        let is_comment = last.code.is_empty() && last.comment.is_some();
        let is_heading = last.code.starts_with('*');
        while last.goes_on {
            let Some(line) = reader.next_line(last.line + 1) else {
                reader.source.warn(last.line, 0, ProgramWarningKind::OpenEnd);
                break;
            };
            let text = reader.source.line(line);
            last = next(text, line, 0);
            if is_comment || is_heading {
                last = Piece { code: "", comment: Some(trimmed(text)), open_quote: None, ..last };
            }
            reader.pieces.push(last);
        }
        last.line + 1
    }

    /// Adds the lines to the cycle before, if they belong to it although a `~` is missing.
    fn join(reader: &mut Reader<'_, Self>, line: usize, front: Front, end: usize) -> bool {
        let Some(&first) = reader.pieces.first().filter(|first| belongs(reader.blocks.last(), front, first)) else {
            return false;
        };
        let mut added = CycleBlock { number: String::new(), name: String::new(), lines: Vec::new() };
        for piece in &reader.pieces {
            if cycle_line(&mut added, piece, |at| reader.source.place(piece.line, piece.start + at)).is_err() {
                return false;
            }
        }
        let count = reader.blocks.len();
        let Some(Block { body: Body::CycleDefinition(cycle) | Body::GlobalDefinition(cycle), lines, .. }) =
            reader.blocks.last_mut()
        else {
            return false;
        };
        cycle.lines.append(&mut added.lines);
        let what = ProgramWarningKind::CycleWithoutTilde { cycle: cycle.number.clone(), line: lines.end };
        lines.end = end;
        // Said once for each cycle.
        if reader.form.joined.replace(count) != Some(count) {
            reader.source.warn(line, first.start, what);
        }
        true
    }

    fn understand(
        &mut self,
        weighed: Result<(), Odd>,
        _front: Front,
        pieces: &[Piece<'_>],
        place: impl Fn(usize, usize) -> TextPlace,
    ) -> Result<Body, Odd> {
        weighed.and_then(|()| understand(pieces, place))
    }

    fn cut_off(before: Option<&Before>, front: Front, pieces: &[Piece<'_>], read: &Body) -> Option<CutOff> {
        cut_off(before, front, pieces, read)
    }
}
