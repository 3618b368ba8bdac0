//! What can be done with the rows of a large file, and what its worker says.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::ToleranceClass;
use fitcheck_exchange::exchange::batch::{Layout, Part, Picked, RowFate, Sifted, StreamBytes, Tally};
use fitcheck_exchange::journal::chain::Hash;

use crate::Step;

/// What can be done with the rows of a large file.
#[derive(Debug, Clone)]
pub enum RowsCommand {
    /// A file was found to be judged row by row, or cannot be read.
    Opened {
        /// Its name without the folder.
        name: String,
        /// The file, and why it is not imported.
        result: Result<(PathBuf, Large), Message>,
    },
    /// The worker of a run has judged more rows, or has ended.
    Judged {
        run: u64,
        /// What it says.
        news: Box<News>,
    },
    /// Ends the run; what was judged stays.
    Cancel,
    /// Judges the file once more from its beginning.
    Again,
    /// Forgets the file and goes back to the history.
    Close,
    /// Shows the rows, or the history in their place.
    Show(bool),
    /// Lists rows of this fate, or no longer; where none is chosen, all are listed.
    Fate(RowFate),
    /// Lists rows of this class, or no longer; 0 is none.
    Class(usize),
    /// Lists the rows of all classes.
    AllClasses,
    /// Puts the worst row first, or leaves the rows in the order of the file.
    WorstFirst(bool),
    /// Rows were found by words or put in order, or cannot be; the number is that of the question.
    Sifted { run: u64, number: u64, result: Result<Sifted, Message> },
    /// Goes to the worst row and shows its check.
    Worst,
    /// These places of the list are in sight: their cells are read.
    See(Range<usize>),
    /// Rows were read again, by their numbers, or cannot be.
    Read { run: u64, result: Result<Vec<(u64, Arc<Picked>)>, Message> },
    /// Goes to another row.
    Move(Step),
    /// Goes to the row with this number and shows its check.
    Check(u64),
    /// Adds the check of the shown row to the history.
    Keep,
}

/// Why a file is judged row by row and not imported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Large {
    /// It has so many bytes.
    Bytes(u64),
    /// It is packed, so nobody knows how large it is.
    Packed,
}

/// What a worker has found since it last said something.
#[derive(Debug, Clone, Default)]
pub struct News {
    /// What the rows are, once that is known.
    pub layout: Option<Arc<Layout>>,
    /// Where its rows are read again, once that is known.
    pub stream: Option<Arc<dyn StreamBytes>>,
    /// The next blocks.
    pub parts: Vec<Arc<Part>>,
    /// All classes so far.
    pub classes: Vec<ToleranceClass>,
    /// Remarks so far.
    pub tally: Tally,
    /// How many bytes of the file were read, and how many it has where that is known.
    pub bytes: (u64, Option<u64>),
    /// For how long the run has been going on, in milliseconds.
    pub elapsed_ms: u64,
    pub end: Option<End>,
    /// SHA-256 of the file, where it was read to its end.
    pub sha256: Option<Hash>,
}

/// How a run has ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum End {
    /// All rows are judged.
    Done,
    /// It was cancelled before that.
    Cancelled,
    /// The file could not be read to its end.
    Failed(Message),
}
