//! Errors and warnings for a table file, and their places.
//!
//! Rule 8 of `docs/SOURCES.md`: every message names file, line and column.

use fitcheck_core::message::{Located, Say};

/// Why a file is not a usable table.
pub type TableError = Located<TableFault>;

/// A warning about a table file that could still be read.
pub type TableWarning = Located<TableWarningKind>;

/// What is wrong with a table file.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "table", error)]
pub enum TableFault {
    /// Nothing but blanks and line ends.
    Empty,
    /// A control character: a program, a picture, a damaged file.
    #[say(args(code = format!("U+{code:04X}")))]
    NotText {
        /// The character's number.
        #[say(skip)]
        code: u32,
    },
    /// A line longer than the reader accepts.
    LineTooLong {
        limit: usize,
    },
    /// More cells than the reader keeps.
    TooLarge {
        limit: usize,
    },
    /// More columns than the reader keeps.
    TooManyColumns {
        limit: usize,
    },
    /// The first line is not a BEGIN line.
    NoBegin {
        /// What the file begins with.
        found: String,
    },
    /// BEGIN without a name.
    NoName,
    /// A text in quotation marks does not end on its line.
    UnclosedQuote,
    /// The file ends within a block.
    UnclosedBlock {
        /// The block's first word.
        block: &'static str,
        /// Where it begins.
        line: usize,
    },
    /// Two blocks that describe the columns.
    SecondBlock,
    /// Something else is expected here.
    Unexpected {
        /// What is expected: a sign or a word of the format, the same in every language.
        expected: &'static str,
        found: String,
    },
    /// A width or a number of decimals that is not usable.
    NotASize {
        /// The key, WIDTH or DEC.
        key: &'static str,
        /// What was found.
        text: String,
        /// The largest that is accepted.
        limit: usize,
    },
    /// There is no line with the names of the columns.
    NoColumns,
    /// Columns are found by their position, and a tab does not have one.
    Tab,
    /// Two columns with the same name.
    ColumnTwice {
        name: String,
    },
    /// A row does not reach the last column.
    ShortRow {
        /// The first column that it does not reach.
        name: String,
    },
    /// No `[END]`, and neither a line end nor a blank after the last row: its last number may be cut off.
    Truncated,
    TextAfterEnd {
        found: String,
    },
}

/// A warning about a table file that could still be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "table")]
pub enum TableWarningKind {
    /// The file has no end line.
    NoEnd,
    /// The BEGIN line has no unit, and the table has lengths.
    NoUnit,
    /// A tool table has no column TL.
    NoLock,
    /// A word in the BEGIN line that is neither unit, version nor mark; it is kept as the mark.
    BeginWord {
        /// The word or words.
        word: String,
    },
    /// The block and the line of names give different widths.
    Width {
        /// The column.
        name: String,
        /// The width in the line of names.
        found: usize,
        /// The width that follows from the block.
        described: usize,
    },
    /// The block describes a column that is not in the line of names.
    NotInTable {
        /// The column.
        name: String,
    },
    /// The line of names has a column that the block does not describe.
    NotDescribed {
        /// The column.
        name: String,
    },
    /// A part of a description block that this reader does not keep.
    Skipped {
        /// The object's or key's name.
        name: String,
    },
}
