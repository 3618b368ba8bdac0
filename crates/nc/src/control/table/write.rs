//! A table to bytes.
//!
//! Cells are written as they are, padded to their columns; lines end in CRLF, the table in `[END]`. The result reads
//! back as the same table, or it is an error. Rules: `docs/SOURCES.md`.

use fitcheck_core::message::Say;
use fitcheck_core::text::decode;

use super::{Column, Comment, CommentPlace, ControlTable, Generation};

/// The most columns of a table on iTNC 530 (`docs/SOURCES.md`).
const MOST_COLUMNS: usize = 30;
/// The most characters of a line on iTNC 530 (`docs/SOURCES.md`).
const LONGEST_LINE: usize = 200;

/// Why a table cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "table-write", error)]
pub enum WriteError {
    /// A text is longer than its column is wide.
    TooWide {
        /// The row, from 0.
        row: usize,
        column: String,
        text: String,
        /// The column's width.
        width: usize,
    },
    /// More columns than the control accepts.
    TooManyColumns {
        /// How many there are.
        columns: usize,
        /// How many there may be.
        limit: usize,
    },
    /// Lines longer than the control accepts.
    TooLong {
        /// How many characters a line has.
        characters: usize,
        /// How many it may have.
        limit: usize,
    },
    /// Something in the table would be read back differently, such as a name with a blank in it.
    ReadsOtherwise,
}

impl ControlTable {
    /// The table as bytes: ASCII, or Windows-1252 where the text needs it, or UTF-8 where that is not enough.
    ///
    /// # Errors
    /// [`WriteError`] if the control could not read the table or would read something else.
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
        let mut lines = Vec::new();
        lines.push(self.begin_line());
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
        lines.push(names);
        let mut comments = self.comments.iter().peekable();
        for (number, row) in self.rows.iter().enumerate() {
            row_comments(&mut lines, &mut comments, number);
            lines.push(self.row(number, row)?);
        }
        row_comments(&mut lines, &mut comments, self.rows.len());
        lines.push("[END]".to_owned());
        // Every line gets its end.
        lines.push(String::new());
        Ok(lines.join("\r\n"))
    }

    fn begin_line(&self) -> String {
        let mut words = vec![format!("BEGIN {}", self.file_name())];
        words.extend(self.unit.map(|unit| unit.word().to_owned()));
        words.extend(self.version.as_ref().map(|version| format!("Version: '{version}'")));
        words.extend(self.mark.clone());
        words.join(" ")
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

    fn structure(&self, lines: &mut Vec<String>) {
        lines.push("#STRUCTBEGIN".to_owned());
        for column in self.columns.iter().filter(|column| column.is_described()) {
            lines.push(format!("   NAME = {}", column.name));
            if let Some(kind) = &column.kind {
                lines.push(format!("     TYPE = {kind}"));
            }
            // The span is one blank more than the width.
            lines.push(format!("     WIDTH = {}", column.width.saturating_sub(1)));
            if let Some(decimals) = column.decimals {
                lines.push(format!("     DEC = {decimals}"));
            }
            for (key, value) in &column.settings {
                lines.push(format!("     {key} = {value}"));
            }
        }
        self.comments_at(lines, "*", CommentPlace::Block);
        lines.push("#STRUCTEND".to_owned());
    }

    fn description(&self, lines: &mut Vec<String>) {
        lines.push("TableDescription (".to_owned());
        lines.push("  columns:= [".to_owned());
        let described: Vec<&Column> = self.columns.iter().filter(|column| column.is_described()).collect();
        for (number, column) in described.iter().enumerate() {
            lines.push("    CfgColumnDescription (".to_owned());
            let mut entries = vec![format!("key:=\"{}\"", column.name), format!("width:={}", column.width)];
            entries.extend(column.kind.iter().map(|kind| format!("unit:={kind}")));
            entries.extend(column.settings.iter().map(|(key, value)| format!("{key}:={value}")));
            lines.push(format!("      {}", entries.join(",\r\n      ")));
            lines.push(if number + 1 < described.len() { "    )," } else { "    )" }.to_owned());
        }
        let comma = if self.properties.is_empty() { "" } else { "," };
        lines.push(format!("  ]{comma}"));
        for (number, (key, value)) in self.properties.iter().enumerate() {
            let comma = if number + 1 < self.properties.len() { "," } else { "" };
            lines.push(format!("  {key}:={value}{comma}"));
        }
        self.comments_at(lines, ";", CommentPlace::Block);
        lines.push(")".to_owned());
    }

    fn comments_at(&self, lines: &mut Vec<String>, sign: &str, place: CommentPlace) {
        for comment in self.comments.iter().filter(|comment| comment.place == place) {
            lines.push(format!("{sign}{}", comment.text));
        }
    }
}

/// Writes the comments before the row of this number.
fn row_comments<'a>(
    lines: &mut Vec<String>,
    comments: &mut std::iter::Peekable<impl Iterator<Item = &'a Comment>>,
    number: usize,
) {
    while let Some(comment) = comments.next_if(|comment| match comment.place {
        CommentPlace::Header | CommentPlace::Block => true,
        CommentPlace::Row(row) => row <= number,
    }) {
        if matches!(comment.place, CommentPlace::Row(_)) {
            lines.push(format!(";{}", comment.text));
        }
    }
}

fn pad(line: &mut String, text: &str, width: usize) {
    line.push_str(text);
    line.extend(std::iter::repeat_n(' ', width.saturating_sub(text.chars().count())));
}

/// ASCII as it is; else Windows-1252, unless that would be read as UTF-8 or cannot hold the text.
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

    #[test]
    fn text_beyond_windows_1252_or_taken_for_utf8_is_written_as_utf8() {
        assert_eq!(encode("µ".to_owned()), [0xb5]);
        assert_eq!(encode("Ω".to_owned()), "Ω".as_bytes());
        // C3 BC in Windows-1252 is ü in UTF-8.
        assert_eq!(decode(&encode("Ã¼".to_owned())), "Ã¼");
    }
}
