//! An error or a warning with its place in a file.

use std::fmt;
use std::sync::Arc;

use super::{Message, Say, message};

/// A place in a file, as far as it is known. Lines and columns count from 1; a column counts characters, not bytes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FilePlace {
    /// The file as the user named it.
    pub file: Option<Arc<str>>,
    /// The line.
    pub line: Option<usize>,
    /// The character in the line.
    pub column: Option<usize>,
}

impl FilePlace {
    /// A line of a text that is named elsewhere.
    pub const fn line(line: usize) -> Self {
        Self { file: None, line: Some(line), column: None }
    }

    /// A character in a line of a text that is named elsewhere.
    pub const fn in_line(line: usize, column: usize) -> Self {
        Self { file: None, line: Some(line), column: Some(column) }
    }

    /// The character that begins at a byte of a text that is named elsewhere; its end where the text has no such byte.
    pub fn of_byte(text: &str, byte: usize) -> Self {
        let before = text.get(..byte).unwrap_or(text);
        let last = before.rsplit_once('\n').map_or(before, |(_, last)| last);
        Self::in_line(before.matches('\n').count().saturating_add(1), last.chars().count().saturating_add(1))
    }

    /// A character in a file.
    pub fn in_file(file: &Arc<str>, line: usize, column: usize) -> Self {
        Self { file: Some(Arc::clone(file)), line: Some(line), column: Some(column) }
    }
}

/// An error or a warning with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Located<T> {
    /// What it is.
    pub what: T,
    /// Where it is.
    pub place: FilePlace,
}

impl<T> Located<T> {
    /// Something in a line of a text that is named elsewhere.
    pub const fn in_line(line: usize, what: T) -> Self {
        Self { what, place: FilePlace::line(line) }
    }
}

/// The place comes last where the file is named, first where only the line is known.
impl<T: Say> Say for Located<T> {
    fn message(&self) -> Message {
        let what = self.what.message();
        let FilePlace { file, line, column } = &self.place;
        match (file, line, column) {
            (Some(file), Some(line), Some(column)) => message!("located-in-file")
                .message("what", what)
                .with("file", file)
                .with("line", line)
                .with("column", column),
            (Some(file), Some(line), None) => {
                message!("located-in-line-of-file").message("what", what).with("file", file).with("line", line)
            }
            (Some(file), None, _) => message!("located-at-file").message("what", what).with("file", file),
            (None, Some(line), Some(column)) => {
                message!("located-at-column").message("what", what).with("line", line).with("column", column)
            }
            (None, Some(line), None) => message!("located-at-line").message("what", what).with("line", line),
            (None, None, _) => what,
        }
    }
}

impl<T: Say> fmt::Display for Located<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

impl<T: Say + fmt::Debug> std::error::Error for Located<T> {}
