//! Rows from Parquet, judged as text.

use std::io;

use super::judge::{Judge, Take};
use super::layout::Layout;
use super::{Tally, TypedBlock};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::parquet::{ChunkReader, Field, PortionSize, Reader, Rows, typed};

/// How many rows decide what the columns are, as with CSV.
const SAMPLE: PortionSize = PortionSize { rows: 200, bytes: 512 << 10 };

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
    let mut rows = Rows::default();
    let read = file.next(SAMPLE, &mut rows);
    read.map_err(|error| ImportErrorKind::Parquet { reason: error.to_string() })?;
    let mut block = TypedBlock::default();
    let mut cells = rows.cells();
    for _ in 0..rows.count {
        for (field, cells) in fields.iter().zip(&mut cells) {
            block.cell(cells.next().map(|value| typed(field.kind, value)), true);
        }
        block.end_row();
    }
    block.layout(fields.iter().map(|field| field.name().to_owned()).collect())
}

/// Some rows of a file, judged as text.
#[derive(Debug, Default)]
pub struct Typed {
    pub(super) rows: Rows,
    block: TypedBlock,
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
        let is_needed = |(at, field): (usize, &Field)| purpose == Purpose::Text || layout.needs(at, field.is_text());
        let needed: Vec<bool> = (0..).zip(fields).map(is_needed).collect();
        let mut cells = self.rows.cells();
        let mut left = self.rows.count;
        while 0 < left {
            self.block.clear();
            while 0 < left && !self.block.is_full() {
                for ((field, cells), is_needed) in fields.iter().zip(&mut cells).zip(&needed) {
                    self.block.cell(cells.next().map(|value| typed(field.kind, value)), *is_needed);
                }
                self.block.end_row();
                left -= 1;
            }
            tally.add(self.block.judge(judge, take));
        }
        tally
    }
}
