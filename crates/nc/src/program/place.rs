//! A place in the text of a program.

use fitcheck_core::message;

/// A place in the text: line and column, both from 1; columns count characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextPlace {
    pub line: usize,
    pub column: usize,
}

impl From<TextPlace> for message::FilePlace {
    fn from(TextPlace { line, column }: TextPlace) -> Self {
        Self { file: None, line: Some(line), column: Some(column) }
    }
}
