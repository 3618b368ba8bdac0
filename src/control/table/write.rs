//! A table to bytes.
//!
//! Cells are written as they are, padded to their columns; lines end in CRLF, the table in `[END]`. What is written reads
//! back as the same table, or it is an error. Rules: `docs/SOURCES.md`.

use crate::control::text::decode;
use crate::message::{Message, Say};

use super::{Column, Comment, CommentPlace, ControlTable, Generation};

/// The most columns of a table on iTNC 530 (`docs/SOURCES.md`).
const MOST_COLUMNS: usize = 30;
/// The most characters of a line on iTNC 530 (`docs/SOURCES.md`).
const LONGEST_LINE: usize = 200;

/// Why a table cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum WriteError {
    /// A text is longer than its column is wide.
    #[error("row {row}, column {column}: {text} does not fit into {width} characters")]
    TooWide {
        /// The row, from 0.
        row: usize,
        /// The column.
        column: String,
        /// The text.
        text: String,
        /// The column's width.
        width: usize,
    },
    /// More columns than the control takes.
    #[error("the table has {columns} columns; an iTNC 530 takes at most {limit}")]
    TooManyColumns {
        /// How many there are.
        columns: usize,
        /// How many there may be.
        limit: usize,
    },
    /// Lines longer than the control takes.
    #[error("the lines of the table have {characters} characters; an iTNC 530 takes at most {limit}")]
    TooLong {
        /// How many there are.
        characters: usize,
        /// How many there may be.
        limit: usize,
    },
    /// Something in the table would be read as something else, such as a name with a blank in it.
    #[error("the table cannot be written so that it reads back the same: check the names of the table and its columns")]
    ReadsOtherwise,
}

impl Say for WriteError {
    fn message(&self) -> Message {
        match self {
            Self::TooWide { row, column, text, width } => Message::new("table-write-too-wide")
                .text("row", row)
                .text("column", column)
                .text("text", text)
                .text("width", width),
            Self::TooManyColumns { columns, limit } => {
                Message::new("table-write-too-many-columns").text("columns", columns).text("limit", limit)
            }
            Self::TooLong { characters, limit } => {
                Message::new("table-write-too-long").text("characters", characters).text("limit", limit)
            }
            Self::ReadsOtherwise => Message::new("table-write-reads-otherwise"),
        }
    }
}

impl ControlTable {
    /// The table as bytes: ASCII, or Windows-1252 where the text needs it, or UTF-8 where that is not enough.
    ///
    /// # Errors
    /// [`WriteError`] where the control could not take the table or would read something else.
    pub fn write(&self) -> Result<Vec<u8>, WriteError> {
        self.check_size()?;
        let bytes = encode(self.text()?);
        match Self::read(&bytes, "") {
            Ok(file) if file.table == *self => Ok(bytes),
            _ => Err(WriteError::ReadsOtherwise),
        }
    }

    fn check_size(&self) -> Result<(), WriteError> {
        if self.generation != Generation::Structure {
            return Ok(());
        }
        if MOST_COLUMNS < self.columns.len() {
            return Err(WriteError::TooManyColumns { columns: self.columns.len(), limit: MOST_COLUMNS });
        }
        let characters = self.columns.iter().map(|column| column.width).sum();
        if LONGEST_LINE < characters {
            return Err(WriteError::TooLong { characters, limit: LONGEST_LINE });
        }
        Ok(())
    }

    fn text(&self) -> Result<String, WriteError> {
        let mut lines = Lines::default();
        lines.line(&self.begin_line());
        self.comments_at(&mut lines, ";", CommentPlace::Header);
        match self.generation {
            Generation::Plain => {}
            Generation::Structure => self.structure(&mut lines),
            Generation::Description => self.description(&mut lines),
        }
        let mut names = String::new();
        for column in &self.columns {
            pad(&mut names, &column.name, column.width);
        }
        lines.line(&names);
        let mut comments = self.comments.iter().peekable();
        for (number, row) in self.rows.iter().enumerate() {
            row_comments(&mut lines, &mut comments, number);
            lines.line(&self.row(number, row)?);
        }
        row_comments(&mut lines, &mut comments, self.rows.len());
        lines.line("[END]");
        Ok(lines.text)
    }

    fn begin_line(&self) -> String {
        let mut line = format!("BEGIN {}", self.file_name());
        if let Some(unit) = self.unit {
            line.push(' ');
            line.push_str(unit.word());
        }
        if let Some(version) = &self.version {
            line.push_str(" Version: '");
            line.push_str(version);
            line.push('\'');
        }
        if let Some(mark) = &self.mark {
            line.push(' ');
            line.push_str(mark);
        }
        line
    }

    fn row(&self, number: usize, row: &[String]) -> Result<String, WriteError> {
        let mut line = String::new();
        for (column, cell) in self.columns.iter().zip(row) {
            if column.width < cell.chars().count() {
                return Err(WriteError::TooWide {
                    row: number,
                    column: column.name.clone(),
                    text: cell.clone(),
                    width: column.width,
                });
            }
            pad(&mut line, cell, column.width);
        }
        Ok(line)
    }

    fn structure(&self, lines: &mut Lines) {
        lines.line("#STRUCTBEGIN");
        for column in self.columns.iter().filter(|column| column.is_described()) {
            lines.line(&format!("   NAME = {}", column.name));
            if let Some(kind) = &column.kind {
                lines.line(&format!("     TYPE = {kind}"));
            }
            // The span is one blank more than the width.
            lines.line(&format!("     WIDTH = {}", column.width.saturating_sub(1)));
            if let Some(decimals) = column.decimals {
                lines.line(&format!("     DEC = {decimals}"));
            }
            for (key, value) in &column.settings {
                lines.line(&format!("     {key} = {value}"));
            }
        }
        self.comments_at(lines, "*", CommentPlace::Block);
        lines.line("#STRUCTEND");
    }

    fn description(&self, lines: &mut Lines) {
        lines.line("TableDescription (");
        lines.line("  columns:= [");
        let described: Vec<&Column> = self.columns.iter().filter(|column| column.is_described()).collect();
        for (number, column) in described.iter().enumerate() {
            lines.line("    CfgColumnDescription (");
            let mut entries = vec![format!("key:=\"{}\"", column.name), format!("width:={}", column.width)];
            entries.extend(column.kind.iter().map(|kind| format!("unit:={kind}")));
            entries.extend(column.settings.iter().map(|(key, value)| format!("{key}:={value}")));
            lines.line(&format!("      {}", entries.join(",\r\n      ")));
            lines.line(if number + 1 < described.len() { "    )," } else { "    )" });
        }
        let comma = if self.properties.is_empty() { "" } else { "," };
        lines.line(&format!("  ]{comma}"));
        for (number, (key, value)) in self.properties.iter().enumerate() {
            let comma = if number + 1 < self.properties.len() { "," } else { "" };
            lines.line(&format!("  {key}:={value}{comma}"));
        }
        self.comments_at(lines, ";", CommentPlace::Block);
        lines.line(")");
    }

    fn comments_at(&self, lines: &mut Lines, sign: &str, place: CommentPlace) {
        for comment in self.comments.iter().filter(|comment| comment.place == place) {
            lines.line(&format!("{sign}{}", comment.text));
        }
    }
}

/// Writes the comments before the row of this number.
fn row_comments<'a>(
    lines: &mut Lines,
    comments: &mut std::iter::Peekable<impl Iterator<Item = &'a Comment>>,
    number: usize,
) {
    while let Some(comment) = comments.next_if(|comment| match comment.place {
        CommentPlace::Header | CommentPlace::Block => true,
        CommentPlace::Row(row) => row <= number,
    }) {
        if matches!(comment.place, CommentPlace::Row(_)) {
            lines.line(&format!(";{}", comment.text));
        }
    }
}

/// Lines with their ends.
#[derive(Default)]
struct Lines {
    text: String,
}

impl Lines {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str("\r\n");
    }
}

fn pad(line: &mut String, text: &str, width: usize) {
    line.push_str(text);
    line.extend(std::iter::repeat_n(' ', width.saturating_sub(text.chars().count())));
}

/// ASCII as it is; else Windows-1252, unless that would be taken for UTF-8 or cannot hold the text.
fn encode(text: String) -> Vec<u8> {
    if !text.is_ascii() {
        let (bytes, _, unmappable) = encoding_rs::WINDOWS_1252.encode(&text);
        if !unmappable && decode(&bytes) == text {
            return bytes.into_owned();
        }
    }
    text.into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, Words};

    #[test]
    fn every_error_is_said_in_english_and_in_dutch() {
        let (column, text) = ("H7".to_owned(), "+1000.5".to_owned());
        for error in [
            WriteError::TooWide { row: 3, column, text, width: 6 },
            WriteError::TooManyColumns { columns: 31, limit: 30 },
            WriteError::TooLong { characters: 201, limit: 200 },
            WriteError::ReadsOtherwise,
        ] {
            assert_eq!(Words::new(Language::En).told(&error), error.to_string());
            let dutch = Words::new(Language::Nl).told(&error);
            assert!(dutch != error.message().id && dutch != error.to_string(), "{dutch}");
        }
    }

    #[test]
    fn text_beyond_windows_1252_or_taken_for_utf8_is_written_as_utf8() {
        assert_eq!(encode("µ".to_owned()), [0xb5]);
        assert_eq!(encode("Ω".to_owned()), "Ω".as_bytes());
        // C3 BC in Windows-1252 is ü in UTF-8.
        assert_eq!(decode(&encode("Ã¼".to_owned())), "Ã¼");
    }
}
