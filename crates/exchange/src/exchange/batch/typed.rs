//! Rows from Parquet as the text that CSV would have, so that one judge reads both.

use std::io;

use super::judge::{Judge, Take};
use super::layout::Layout;
use super::{Block, Tally};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::index::LONGEST_ROW;
use crate::exchange::parquet::{ChunkReader, Field, FieldKind, PortionSize, Reader, Rows, Value, put};
use fitcheck_core::text::Within as _;

/// How many rows decide what the columns are, as with CSV.
const SAMPLE: PortionSize = PortionSize { rows: 200, bytes: 512 << 10 };

/// How much text is judged at a time.
const TEXT: usize = super::BLOCK;

/// What rows are wanted for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// Every cell is written as text.
    Text,
    /// The columns are passed on as they are, and only what is judged is needed as text.
    Columns,
}

impl Purpose {
    /// How many rows are taken at a time: some to be written at once, or a row group.
    pub const fn wanted(self) -> PortionSize {
        match self {
            Self::Text => PortionSize { rows: 8_192, bytes: 1 << 20 },
            Self::Columns => PortionSize { rows: 128 << 10, bytes: 16 << 20 },
        }
    }
}

/// What the columns of a file are: by their names, as in CSV, else by the first rows.
///
/// # Errors
/// Why nothing in it can be judged.
pub fn layout_of<R: ChunkReader + 'static>(mut file: Reader<R>) -> Result<Layout, ImportErrorKind> {
    let fields = file.fields().to_vec();
    let names: Vec<String> = fields.iter().map(|field| field.name().to_owned()).collect();
    let mut above = Vec::new();
    for (at, name) in names.iter().enumerate() {
        if 0 < at {
            above.push(b',');
        }
        let begin = above.len();
        above.extend_from_slice(name.as_bytes());
        quote_from(begin, &mut above);
    }
    above.push(b'\n');
    let mut rows = Rows::default();
    let read = file.next(SAMPLE, &mut rows);
    read.map_err(|error| ImportErrorKind::Parquet { reason: error.to_string() })?;
    let mut sample = above.clone();
    let mut cells = rows.cells();
    for _ in 0..rows.count {
        for (at, (field, cells)) in fields.iter().zip(&mut cells).enumerate() {
            if 0 < at {
                sample.push(b',');
            }
            if let Some(value) = cells.next() {
                put_cell(field.kind, value, &mut sample);
            }
        }
        sample.push(b'\n');
    }
    Layout::of_columns(names, above, &sample)
}

/// Some rows of a file, judged as text.
#[derive(Debug, Default)]
pub struct Typed {
    pub(super) rows: Rows,
    block: Block,
}

impl Typed {
    /// Reads the next rows; `false` at the end.
    ///
    /// # Errors
    /// What is damaged.
    pub fn read<R: ChunkReader + 'static>(&mut self, file: &mut Reader<R>, purpose: Purpose) -> io::Result<bool> {
        Ok(file.next(purpose.wanted(), &mut self.rows)?)
    }

    /// Judges all rows.
    pub fn judge(&mut self, fields: &[Field], purpose: Purpose, judge: &mut Judge<'_>, take: &mut impl Take) -> Tally {
        let mut tally = Tally::default();
        let layout = judge.layout();
        let may_say = |at: usize, field: &Field| field.kind == FieldKind::Text && layout.may_say(at);
        let is_needed = |(at, field)| purpose == Purpose::Text || layout.is_judged(at) || may_say(at, field);
        let needed: Vec<bool> = (0..).zip(fields).map(is_needed).collect();
        let mut cells = self.rows.cells();
        let mut left = self.rows.count;
        while 0 < left {
            let Block { text, index, .. } = &mut self.block;
            text.clear();
            let ends = index.get_or_insert_default();
            ends.clear();
            while 0 < left && text.len() < TEXT {
                for (at, ((field, cells), is_needed)) in fields.iter().zip(&mut cells).zip(&needed).enumerate() {
                    if 0 < at {
                        ends.end_cell(text.len(), false);
                        text.push(b',');
                    }
                    match cells.next() {
                        Some(value) if *is_needed => put_cell(field.kind, value, text),
                        Some(value) => put_mark(field.kind, value, text),
                        None => {}
                    }
                }
                ends.end_cell(text.len(), true);
                text.push(b'\n');
                left -= 1;
            }
            tally.add(judge.block(&self.block, take));
        }
        tally
    }
}

/// A value as a cell of CSV.
#[inline]
fn put_cell(kind: FieldKind, value: Value<'_>, out: &mut Vec<u8>) {
    // More of a text is not needed to see that its row is too long.
    let value = match value {
        Value::Bytes(text) => Value::Bytes(text.get(..=LONGEST_ROW).unwrap_or(text)),
        other => other,
    };
    let begin = out.len();
    put(kind, value, out);
    if kind == FieldKind::Text {
        quote_from(begin, out);
    }
}

/// In place of a cell that nobody reads: something where there is something, as much where it is very long.
#[inline]
fn put_mark(kind: FieldKind, value: Value<'_>, out: &mut Vec<u8>) {
    match value {
        Value::Bytes(text) if LONG < text.len() => put_cell(kind, value, out),
        Value::Bytes(text) if kind == FieldKind::Text && text.trim_ascii().is_empty() => {}
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
