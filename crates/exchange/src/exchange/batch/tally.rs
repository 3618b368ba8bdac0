//! What a stream had: how many rows with which verdict, and the first remarks with their lines.

use fitcheck_core::message::Message;

/// How many remarks of a kind are kept.
pub const FIRST: usize = 10;

/// What is said of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowNoteKind {
    /// Why it has no verdict.
    Refused,
    /// Its measured value may be another quantity or another part's.
    Doubt,
    /// Its file says another status.
    StatusDiffers,
    /// Its file says a status that is not known.
    StatusUnknown,
    /// Its file says another limit, another deviation or another side.
    ClaimDiffers,
    /// It runs over several lines.
    SeveralLines,
    /// It is the last one and may be cut off.
    CutOff,
}

impl RowNoteKind {
    /// Every kind, the most important first.
    pub const ALL: [Self; 7] = [
        Self::Refused,
        Self::Doubt,
        Self::StatusDiffers,
        Self::StatusUnknown,
        Self::ClaimDiffers,
        Self::SeveralLines,
        Self::CutOff,
    ];
}

/// Something to be said of a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// The line where the row begins, from 0 in its block and from 1 in a stream.
    pub line: usize,
    /// The number of the cell from 1, where it is about one.
    pub column: Option<usize>,
    /// What is said; its `Display` is English.
    pub what: Message,
}

/// How many notes of one kind there were, and the first of them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Notes {
    /// How many.
    pub count: u64,
    /// At most [`FIRST`].
    pub first: Vec<Note>,
}

/// What some rows had.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Tally {
    pub lines: usize,
    /// Rows: those judged and those refused.
    pub rows: u64,
    /// Rows that say that nobody measured; they are among the judged ones.
    pub simulated: u64,
    /// Judged rows whose value is exactly the nominal size.
    pub nominal: u64,
    /// Judged rows that something else stands against.
    pub against: u64,
    /// Lines that were not UTF-8.
    pub not_utf8: u64,
    pub comments: u64,
    /// In the order of [`RowNoteKind::ALL`].
    notes: [Notes; RowNoteKind::ALL.len()],
}

impl Tally {
    /// What is said of rows, by its kind.
    pub fn notes(&self, kind: RowNoteKind) -> &Notes {
        static NONE: Notes = Notes { count: 0, first: Vec::new() };
        self.notes.iter().zip(RowNoteKind::ALL).find(|(_, one)| *one == kind).map_or(&NONE, |(notes, _)| notes)
    }

    /// Counts a note about the row at the current line, and keeps it if it is one of the first.
    pub(super) fn note(&mut self, kind: RowNoteKind, at: Option<usize>, what: impl FnOnce() -> Message) {
        let line = self.lines;
        let notes = self.notes.iter_mut().zip(RowNoteKind::ALL).find(|(_, one)| *one == kind);
        if let Some((notes, _)) = notes {
            notes.count += 1;
            if notes.first.len() < FIRST {
                notes.first.push(Note { line, column: at.map(|at| at + 1), what: what() });
            }
        }
    }

    /// Adds what the next block had; its lines are counted on.
    pub fn add(&mut self, next: Self) {
        let line = self.lines;
        self.lines += next.lines;
        self.rows += next.rows;
        self.simulated += next.simulated;
        self.against += next.against;
        self.nominal += next.nominal;
        self.not_utf8 += next.not_utf8;
        self.comments += next.comments;
        for (notes, more) in self.notes.iter_mut().zip(next.notes) {
            notes.count += more.count;
            let free = FIRST.saturating_sub(notes.first.len());
            notes.first.extend(more.first.into_iter().take(free).map(|note| Note { line: line + note.line, ..note }));
        }
    }
}
