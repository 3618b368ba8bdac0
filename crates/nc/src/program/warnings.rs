//! The warnings of a program while it is read: only the first are kept, the others counted.

use super::cursor::Stop;
use super::error::{ProgramWarning, ProgramWarningKind};
use super::lines::Piece;
use super::place::TextPlace;

/// How many warnings are listed one by one.
const MOST_WARNINGS: usize = 500;

/// The longest block that is parsed, in bytes; a control accepts a few hundred characters per line.
pub(super) const LONGEST: usize = 1 << 16;

/// A warning and its place: line from 0, bytes from the line's beginning.
#[derive(Debug)]
pub(super) struct Odd {
    pub line: usize,
    pub at: usize,
    pub what: ProgramWarningKind,
}

impl Odd {
    /// A quotation mark of a line that is not closed.
    pub(super) fn open_quote(piece: &Piece<'_>) -> Option<Self> {
        let at = piece.open_quote?;
        Some(Self { line: piece.line, at, what: ProgramWarningKind::UnclosedQuote })
    }

    /// Where the code of a line cannot be understood, and why.
    pub(super) fn of(piece: &Piece<'_>, Stop { at, reason }: Stop) -> Self {
        Self { line: piece.line, at: piece.start + at, what: ProgramWarningKind::NotUnderstood(reason) }
    }
}

/// Warnings, of which only the first are kept.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    kept: Vec<(TextPlace, ProgramWarningKind)>,
    dropped: usize,
}

impl Warnings {
    pub(super) fn add(&mut self, place: TextPlace, what: impl FnOnce() -> ProgramWarningKind) {
        let what = what();
        if let Some((_, kept)) = self.kept.last_mut()
            && go_on(kept, &what, place.line)
        {
            return;
        }
        if self.kept.len() < MOST_WARNINGS {
            self.kept.push((place, what));
        } else {
            self.dropped += 1;
        }
    }

    pub(super) fn sorted(mut self) -> Vec<ProgramWarning> {
        self.kept.sort_by_key(|(place, _)| *place);
        if let (Some(&(place, _)), true) = (self.kept.last(), 0 < self.dropped) {
            self.kept.push((place, ProgramWarningKind::More { count: self.dropped }));
        }
        self.kept.into_iter().map(|(place, what)| ProgramWarning { what, place: place.into() }).collect()
    }
}

/// Whether a warning is another one of the same cycle that ended too early, in this line: one of them names the lines up to it.
fn go_on(kept: &mut ProgramWarningKind, more: &ProgramWarningKind, last: usize) -> bool {
    use ProgramWarningKind::{CycleCut, CycleCutMany};
    let CycleCut { line: ended, .. } = more else { return false };
    let (CycleCut { cycle, line, parameter } | CycleCutMany { cycle, line, parameter, .. }) = &*kept else {
        return false;
    };
    if line != ended {
        return false;
    }
    *kept = CycleCutMany { cycle: cycle.clone(), line: *line, parameter: *parameter, last };
    true
}
