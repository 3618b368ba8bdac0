//! What can be wrong or odd in a table file, and where.
//!
//! Rule 8 of `docs/SOURCES.md`: every message names file, line and column.

use std::fmt;
use std::sync::Arc;

use crate::message::{Message, Say};

/// A place in a file. Line and column count from 1; the column counts characters, not bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file as the user named it.
    pub file: Arc<str>,
    /// The line.
    pub line: usize,
    /// The character in the line.
    pub column: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, line {}, column {}", self.file, self.line, self.column)
    }
}

/// An error or a warning with its place.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{what}: {place}")]
pub struct Located<T> {
    /// What it is.
    pub what: T,
    /// Where it is.
    pub place: Place,
}

impl<T: Say> Say for Located<T> {
    fn message(&self) -> Message {
        Message::new("table-at")
            .message("what", self.what.message())
            .text("file", &self.place.file)
            .text("line", self.place.line)
            .text("column", self.place.column)
    }
}

/// Why a file is no table that can be used.
pub type TableError = Located<TableFault>;

/// What was odd but readable.
pub type TableWarning = Located<TableDoubt>;

/// What is wrong with a table file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TableFault {
    /// Nothing but blanks and line ends.
    #[error("the file is empty")]
    Empty,
    /// A control character: a program, a picture, a damaged file.
    #[error("character U+{code:04X} is no text: this is not a table or it is damaged")]
    NotText {
        /// The character's number.
        code: u32,
    },
    /// A line beyond the bound of the reader.
    #[error("the line is longer than {limit} bytes")]
    LineTooLong {
        /// The bound.
        limit: usize,
    },
    /// More cells than the reader keeps.
    #[error("the table has more than {limit} cells")]
    TooLarge {
        /// The bound.
        limit: usize,
    },
    /// More columns than the reader keeps.
    #[error("the table has more than {limit} columns")]
    TooManyColumns {
        /// The bound.
        limit: usize,
    },
    /// The first line is no BEGIN line.
    #[error("a table begins with BEGIN and its name, not with {found}")]
    NoBegin {
        /// What the file begins with.
        found: String,
    },
    /// BEGIN stands alone.
    #[error("the name of the table is missing behind BEGIN")]
    NoName,
    /// A text in quotation marks does not end in its line.
    #[error("a quotation mark is not closed")]
    UnclosedQuote,
    /// The file ends within a block.
    #[error("the block {block} of line {line} is not closed")]
    UnclosedBlock {
        /// The block's first word.
        block: &'static str,
        /// Where it begins.
        line: usize,
    },
    /// Two blocks that describe the columns.
    #[error("the columns are described a second time")]
    SecondBlock,
    /// Something else is due here.
    #[error("{expected} is due here, not {found}")]
    Unexpected {
        /// What is due: a sign or a word of the format, the same in every language.
        expected: &'static str,
        /// What was found.
        found: String,
    },
    /// A width or a number of decimals that is none.
    #[error("{key} is a whole number up to {limit}, not {text}")]
    NotASize {
        /// The key, WIDTH or DEC.
        key: &'static str,
        /// What was found.
        text: String,
        /// The largest that is accepted.
        limit: usize,
    },
    /// There is no line with the names of the columns.
    #[error("the line with the names of the columns is missing")]
    NoColumns,
    /// Columns are told by their position, and a tab has none.
    #[error("a tab stands here: only blanks keep columns apart")]
    Tab,
    /// Two columns with one name.
    #[error("column {name} occurs twice")]
    ColumnTwice {
        /// The name.
        name: String,
    },
    /// A row does not reach the last column.
    #[error("the row ends before column {name}: fill it up with blanks, or write - for no value")]
    ShortRow {
        /// The first column that it does not reach.
        name: String,
    },
    /// No `[END]` and neither a line end nor a blank behind the last row: its last figure may not be the last.
    #[error("the file ends within this row and without [END]: it may be cut off")]
    Truncated,
    /// Text behind the end.
    #[error("text behind [END]: {found}")]
    TextAfterEnd {
        /// What was found.
        found: String,
    },
}

impl Say for TableFault {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("table-empty"),
            Self::NotText { code } => Message::new("table-not-text").text("code", format_args!("U+{code:04X}")),
            Self::LineTooLong { limit } => Message::new("table-line-too-long").text("limit", limit),
            Self::TooLarge { limit } => Message::new("table-too-large").text("limit", limit),
            Self::TooManyColumns { limit } => Message::new("table-too-many-columns").text("limit", limit),
            Self::NoBegin { found } => Message::new("table-no-begin").text("found", found),
            Self::NoName => Message::new("table-no-name"),
            Self::UnclosedQuote => Message::new("table-unclosed-quote"),
            Self::UnclosedBlock { block, line } => {
                Message::new("table-unclosed-block").text("block", block).text("line", line)
            }
            Self::SecondBlock => Message::new("table-second-block"),
            Self::Unexpected { expected, found } => {
                Message::new("table-unexpected").text("expected", expected).text("found", found)
            }
            Self::NotASize { key, text, limit } => {
                Message::new("table-not-a-size").text("key", key).text("text", text).text("limit", limit)
            }
            Self::NoColumns => Message::new("table-no-columns"),
            Self::Tab => Message::new("table-tab"),
            Self::ColumnTwice { name } => Message::new("table-column-twice").text("name", name),
            Self::ShortRow { name } => Message::new("table-short-row").text("name", name),
            Self::Truncated => Message::new("table-truncated"),
            Self::TextAfterEnd { found } => Message::new("table-text-after-end").text("found", found),
        }
    }
}

/// What is odd in a table file that was read all the same.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TableDoubt {
    /// The file has no end line.
    #[error("[END] is missing")]
    NoEnd,
    /// A word in the BEGIN line that is neither unit, version nor mark; it is kept as the mark.
    #[error("{word} has no known meaning in the BEGIN line")]
    BeginWord {
        /// The word or words.
        word: String,
    },
    /// The block and the line of names give different widths.
    #[error("column {name} is {found} characters wide here but {described} in the description; the names decide")]
    Width {
        /// The column.
        name: String,
        /// The width in the line of names.
        found: usize,
        /// The width that follows from the block.
        described: usize,
    },
    /// The block describes a column that the line of names does not have.
    #[error("column {name} is described but not in the table")]
    NotInTable {
        /// The column.
        name: String,
    },
    /// The line of names has a column that the block does not describe.
    #[error("column {name} is not described")]
    NotDescribed {
        /// The column.
        name: String,
    },
    /// A part of a description block that this reader does not keep.
    #[error("{name} is unknown and was skipped")]
    Skipped {
        /// The object's or key's name.
        name: String,
    },
}

impl Say for TableDoubt {
    fn message(&self) -> Message {
        match self {
            Self::NoEnd => Message::new("table-no-end"),
            Self::BeginWord { word } => Message::new("table-begin-word").text("word", word),
            Self::Width { name, found, described } => {
                Message::new("table-width").text("name", name).text("found", found).text("described", described)
            }
            Self::NotInTable { name } => Message::new("table-not-in-table").text("name", name),
            Self::NotDescribed { name } => Message::new("table-not-described").text("name", name),
            Self::Skipped { name } => Message::new("table-skipped").text("name", name),
        }
    }
}

/// The beginning of a text, short enough for a message.
pub(crate) fn beginning(text: &str) -> String {
    const SHOWN: usize = 40;
    let text = text.trim();
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, Words};

    fn said_in_both_languages<T: Say + fmt::Display>(what: T) {
        let place = Place { file: "own.tab".into(), line: 12, column: 9 };
        let located = Located { what, place };
        let english = located.to_string();
        assert!(english.ends_with(": own.tab, line 12, column 9"), "{english}");
        assert_eq!(Words::new(Language::En).told(&located), english);
        let dutch = Words::new(Language::Nl).told(&located);
        assert!(dutch.ends_with(": own.tab, regel 12, kolom 9"), "{dutch}");
        assert_ne!(Words::new(Language::Nl).told(&located.what), located.what.message().id);
        assert_ne!(dutch, english);
    }

    #[test]
    fn every_fault_is_said_in_english_and_in_dutch() {
        let name = || "H7".to_owned();
        for fault in [
            TableFault::Empty,
            TableFault::NotText { code: 1 },
            TableFault::LineTooLong { limit: 65536 },
            TableFault::TooLarge { limit: 1_000_000 },
            TableFault::TooManyColumns { limit: 1000 },
            TableFault::NoBegin { found: "PK".to_owned() },
            TableFault::NoName,
            TableFault::UnclosedQuote,
            TableFault::UnclosedBlock { block: "#STRUCTBEGIN", line: 2 },
            TableFault::SecondBlock,
            TableFault::Unexpected { expected: ":=", found: ")".to_owned() },
            TableFault::NotASize { key: "WIDTH", text: "x".to_owned(), limit: 1000 },
            TableFault::NoColumns,
            TableFault::Tab,
            TableFault::ColumnTwice { name: name() },
            TableFault::ShortRow { name: name() },
            TableFault::Truncated,
            TableFault::TextAfterEnd { found: "0 3".to_owned() },
        ] {
            said_in_both_languages(fault);
        }
    }

    #[test]
    fn every_doubt_is_said_in_english_and_in_dutch() {
        let name = || "H7".to_owned();
        for doubt in [
            TableDoubt::NoEnd,
            TableDoubt::BeginWord { word: "X".to_owned() },
            TableDoubt::Width { name: name(), found: 7, described: 8 },
            TableDoubt::NotInTable { name: name() },
            TableDoubt::NotDescribed { name: name() },
            TableDoubt::Skipped { name: name() },
        ] {
            said_in_both_languages(doubt);
        }
    }

    #[test]
    fn long_texts_are_cut_in_messages() {
        assert_eq!(beginning("  short "), "short");
        assert_eq!(beginning(&"ß".repeat(41)), format!("{}…", "ß".repeat(40)));
    }
}
