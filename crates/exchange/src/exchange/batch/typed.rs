//! Rows of columns with types, as the text that CSV would have, so that one judge reads both.

use super::judge::{Judge, Take};
use super::layout::Layout;
use super::{BLOCK, Block, Tally};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::index::LONGEST_ROW;
use crate::exchange::typed_value::TypedValue;
use fitcheck_core::text::Within as _;

/// Rows of columns with types, some at a time: cell by cell, row by row.
#[derive(Debug, Default)]
pub struct TypedBlock {
    block: Block,
    /// Whether a cell of the row stands already.
    has_cells: bool,
}

impl TypedBlock {
    /// Takes all rows out.
    pub fn clear(&mut self) {
        self.block.text.clear();
        self.block.index.get_or_insert_default().clear();
        self.has_cells = false;
    }

    /// Whether it has so much that it should be judged.
    pub const fn is_full(&self) -> bool {
        BLOCK <= self.block.text.len()
    }

    /// Adds the next cell of a row; nothing where it is empty. Of one that is not needed only is kept that it is there.
    #[inline]
    pub fn cell(&mut self, value: Option<TypedValue<'_>>, is_needed: bool) {
        let Block { text, index, .. } = &mut self.block;
        if self.has_cells {
            index.get_or_insert_default().end_cell(text.len(), false);
            text.push(b',');
        }
        self.has_cells = true;
        match value {
            Some(value) if is_needed => put_cell(value, text),
            Some(value) => put_mark(value, text),
            None => {}
        }
    }

    /// Ends a row.
    #[inline]
    pub fn end_row(&mut self) {
        let Block { text, index, .. } = &mut self.block;
        index.get_or_insert_default().end_cell(text.len(), true);
        text.push(b'\n');
        self.has_cells = false;
    }

    /// Judges its rows. Each goes to `take` once, in its order.
    pub fn judge(&self, judge: &mut Judge<'_>, take: &mut impl Take) -> Tally {
        judge.block(&self.block, take)
    }

    /// What columns with these names are, by the names, as in CSV, else by these rows, the first of all.
    ///
    /// # Errors
    /// Why nothing in them can be judged.
    pub fn layout(&self, names: Vec<String>) -> Result<Layout, ImportErrorKind> {
        let mut above = Vec::new();
        for (at, name) in names.iter().enumerate() {
            if 0 < at {
                above.push(b',');
            }
            put_cell(TypedValue::Text(name.as_bytes()), &mut above);
        }
        above.push(b'\n');
        let sample = [above.as_slice(), &self.block.text].concat();
        Layout::of_columns(names, above, &sample)
    }
}

/// A value as a cell of CSV.
#[inline]
fn put_cell(value: TypedValue<'_>, out: &mut Vec<u8>) {
    let begin = out.len();
    match value {
        // More of a text is not needed to see that its row is too long.
        TypedValue::Text(text) => {
            out.extend_from_slice(text.get(..=LONGEST_ROW).unwrap_or(text));
            quote_from(begin, out);
        }
        TypedValue::Bytes(bytes) => TypedValue::Bytes(bytes.get(..=LONGEST_ROW).unwrap_or(bytes)).put(out),
        other => other.put(out),
    }
}

/// In place of a cell that nobody reads: something where there is something, as much where it is very long.
#[inline]
fn put_mark(value: TypedValue<'_>, out: &mut Vec<u8>) {
    match value.bytes() {
        Some(bytes) if LONG < bytes.len() => put_cell(value, out),
        Some(text) if matches!(value, TypedValue::Text(_)) && text.trim_ascii().is_empty() => {}
        _ => out.push(b'-'),
    }
}

/// From here on, the length of a text counts.
const LONG: usize = 1 << 10;

/// Puts the last cell between quotation marks if it needs them.
#[inline]
fn quote_from(begin: usize, out: &mut Vec<u8>) {
    let cell = out.within(begin..);
    if !cell.iter().any(|byte| matches!(byte, b',' | b'"' | b'\n' | b'\r')) {
        return;
    }
    let mut quoted = Vec::with_capacity(cell.len() + 2);
    quoted.push(b'"');
    for byte in cell {
        if *byte == b'"' {
            quoted.push(b'"');
        }
        quoted.push(*byte);
    }
    quoted.push(b'"');
    out.truncate(begin);
    out.append(&mut quoted);
}
