//! Other texts in some cells of a table's file: every other byte stays as it is.
//!
//! For tables that belong to the control, such as `tool.t`: what a reader does not keep (line ends, blanks, the order of
//! a description) must not change with a cell.

use std::collections::BTreeMap;

use fitcheck_core::text::{behind, decode};

use super::read::split_at_characters;
use super::{ControlTable, TableFile, WriteError};

/// The mark at the beginning of some files in UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

impl TableFile {
    /// The bytes that this table was read from, with these texts in these cells (row, column, both from 0).
    ///
    /// A text begins where the old one began, or at the start of its column if it is too long for that; a blank stays
    /// before the next column.
    ///
    /// # Errors
    /// [`WriteError::TooWide`], or [`WriteError::ReadsOtherwise`] if the result would not read back with these texts.
    pub(crate) fn patched(
        &self,
        bytes: &[u8],
        cells: &BTreeMap<(usize, usize), String>,
    ) -> Result<Vec<u8>, WriteError> {
        if cells.is_empty() {
            return Ok(bytes.to_vec());
        }
        let text = decode(bytes);
        let mut patched = String::with_capacity(text.len());
        let mut number = 0;
        let mut before = "";
        for piece in text.split_inclusive(['\n', '\r', '\0']) {
            // The second half of CRLF begins no line.
            let is_end_only = piece == "\n" && before.ends_with('\r');
            before = piece;
            if is_end_only {
                patched.push_str(piece);
                continue;
            }
            number += 1;
            match self.row_lines.binary_search(&number) {
                Ok(row) if cells.range((row, 0)..(row + 1, 0)).next().is_some() => {
                    let line = piece.strip_suffix(['\n', '\r', '\0']).unwrap_or(piece);
                    patched.push_str(&self.patched_line(line, row, cells)?);
                    patched.push_str(behind(piece, line.len()));
                }
                _ => patched.push_str(piece),
            }
        }
        let patched = encoded(bytes, &patched);
        if self.reads_back(&patched, cells) { Ok(patched) } else { Err(WriteError::ReadsOtherwise) }
    }

    /// The line of a row with its new cells.
    fn patched_line(
        &self,
        line: &str,
        row: usize,
        cells: &BTreeMap<(usize, usize), String>,
    ) -> Result<String, WriteError> {
        let mut patched = String::with_capacity(line.len());
        let mut rest = line;
        let last = self.table.columns.len().saturating_sub(1);
        for (number, column) in self.table.columns.iter().enumerate() {
            let (span, after) = if number == last { (rest, "") } else { split_at_characters(rest, column.width) };
            rest = after;
            let Some(text) = cells.get(&(row, number)) else {
                patched.push_str(span);
                continue;
            };
            // A row may end before this column.
            let start = self.start_of(number);
            let missing = start.saturating_sub(patched.chars().count());
            blanks(&mut patched, missing);
            // The last column ends with its line.
            let room = if number == last { usize::MAX } else { column.width };
            let length = text.chars().count();
            // A cell that begins directly after its neighbour would be uncertain when it is read.
            let least = usize::from(patched.ends_with(|c: char| !c.is_whitespace()));
            if room <= least + length {
                let width = column.width;
                let column = column.name.clone();
                return Err(WriteError::TooWide { row, column, text: text.clone(), width });
            }
            let lead = span.chars().take_while(|c| c.is_whitespace()).count();
            let lead = if span.trim().is_empty() || room <= lead + length { least } else { lead };
            blanks(&mut patched, lead);
            patched.push_str(text);
            blanks(&mut patched, span.chars().count().saturating_sub(lead + length));
        }
        Ok(patched)
    }

    /// Whether bytes hold this table with these texts.
    fn reads_back(&self, bytes: &[u8], cells: &BTreeMap<(usize, usize), String>) -> bool {
        let Ok(file) = ControlTable::read_with_short_rows(bytes, "") else { return false };
        let mut expected = self.table.rows.clone();
        for ((row, column), text) in cells {
            let Some(cell) = expected.get_mut(*row).and_then(|row| row.get_mut(*column)) else { return false };
            text.clone_into(cell);
        }
        file.table.rows == expected && !cells.keys().any(|(row, column)| file.touches(*row, *column))
    }
}

fn blanks(line: &mut String, count: usize) {
    line.extend(std::iter::repeat_n(' ', count));
}

/// A text in the encoding of these bytes, with their mark.
fn encoded(bytes: &[u8], text: &str) -> Vec<u8> {
    let (mark, bare) = bytes.strip_prefix(MARK).map_or((&[][..], bytes), |bare| (MARK, bare));
    let body = match std::str::from_utf8(bare) {
        Ok(_utf8) => text.as_bytes().into(),
        Err(_windows_1252) => encoding_rs::WINDOWS_1252.encode(text).0,
    };
    [mark, &body].concat()
}
