//! Rows as the columns of a Parquet file: those of the input, and six with the answers.

use std::io;

use fitcheck_core::verdict::Status;

use super::judge::Take;
use super::judged::Judged;
use super::layout::Layout;
use super::row_groups::Typed;
use crate::exchange::ImportErrorKind;
use crate::exchange::parquet::{Chunks, Field, Group, added, put_text};
use crate::exchange::row::{TextRow, unquoted};

/// The columns of the output: those of the input, as texts where they have no types, and those that are added.
///
/// # Errors
/// A name that the format does not take.
pub fn output_fields(layout: &Layout, typed: Option<&[Field]>, prefix: &str) -> io::Result<Vec<Field>> {
    let mut fields = match typed {
        Some(fields) => fields.to_vec(),
        None => layout.names.iter().map(|name| Field::text(name)).collect::<Result<_, _>>()?,
    };
    fields.extend(added(prefix)?);
    Ok(fields)
}

/// Takes rows with their answers until they are a row group.
pub struct Answers {
    chunks: Chunks,
    rows: usize,
    /// The cells of the input, where it has no types.
    cells: Vec<Texts>,
    minimum: Vec<i64>,
    maximum: Vec<i64>,
    deviation: Vec<i64>,
    remove: Vec<i64>,
    /// The numbers of the words of verdicts, in the order of [`Status::ALL`].
    status: Vec<u8>,
    error: Texts,
    /// For each row whether it has a verdict, 1 or 0.
    is_judged: Vec<i16>,
    /// For each row whether something can be removed.
    is_rework: Vec<i16>,
}

/// A column of texts, some of them missing.
#[derive(Debug, Default)]
struct Texts {
    /// Each behind its length.
    plain: Vec<u8>,
    /// For each row 1 or 0.
    levels: Vec<i16>,
}

impl Texts {
    #[inline]
    fn push(&mut self, text: &[u8]) {
        self.levels.push((!text.is_empty()).into());
        if !text.is_empty() {
            put_text(text, &mut self.plain);
        }
    }

    fn clear(&mut self) {
        self.plain.clear();
        self.levels.clear();
    }
}

impl Answers {
    /// For a file with these columns; `texts` of them are cells of the input that come as text.
    ///
    /// # Errors
    /// What the packer reports.
    pub fn new(fields: &[Field], texts: usize) -> io::Result<Self> {
        Ok(Self {
            chunks: Chunks::new(fields)?,
            rows: 0,
            cells: (0..texts).map(|_| Texts::default()).collect(),
            minimum: Vec::new(),
            maximum: Vec::new(),
            deviation: Vec::new(),
            remove: Vec::new(),
            status: Vec::new(),
            error: Texts::default(),
            is_judged: Vec::new(),
            is_rework: Vec::new(),
        })
    }

    /// The rows so far as a row group, behind the columns of the input where these have types; `None` without any row.
    ///
    /// # Errors
    /// What the packer reports.
    pub fn group(&mut self, typed: Option<&Typed>) -> io::Result<Option<Group>> {
        if self.rows == 0 {
            return Ok(None);
        }
        let rows = self.rows;
        let chunks = &mut self.chunks;
        if let Some(typed) = typed {
            if typed.rows.count != rows {
                return Err(io::Error::other("a row without an answer"));
            }
            chunks.rows(&typed.rows)?;
        }
        for texts in &mut self.cells {
            chunks.texts(rows, &texts.levels, &texts.plain)?;
            texts.clear();
        }
        for values in [&mut self.minimum, &mut self.maximum, &mut self.deviation] {
            chunks.numbers(rows, &self.is_judged, values)?;
            values.clear();
        }
        chunks.words(rows, &self.is_judged, &Status::ALL.map(Status::word), &self.status)?;
        chunks.numbers(rows, &self.is_rework, &self.remove)?;
        chunks.texts(rows, &self.error.levels, &self.error.plain)?;
        self.status.clear();
        self.remove.clear();
        self.error.clear();
        self.is_judged.clear();
        self.is_rework.clear();
        self.rows = 0;
        Ok(Some(chunks.group()))
    }

    #[inline]
    fn row(&mut self, row: &TextRow<'_>) {
        self.rows += 1;
        for (at, texts) in self.cells.iter_mut().enumerate() {
            match row.cell(at).unwrap_or(b"") {
                quoted @ [b'"', ..] => texts.push(unquoted(quoted).as_bytes()),
                plain => texts.push(plain),
            }
        }
    }

    fn reason(&mut self, reason: &str) {
        self.is_judged.push(0);
        self.is_rework.push(0);
        self.error.push(reason.as_bytes());
    }
}

impl Take for Answers {
    #[inline]
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        self.row(row);
        self.minimum.push(judged.bounds.minimum().nanometres());
        self.maximum.push(judged.bounds.maximum().nanometres());
        self.deviation.push(judged.verdict().deviation.nanometres());
        let [status, ..] = judged.status.at().to_le_bytes();
        self.status.push(status);
        self.is_judged.push(1);
        self.is_rework.push(judged.verdict().removal.is_some().into());
        self.remove.extend(judged.verdict().removal.map(|removal| removal.to_limit.nanometres()));
        self.error.push(b"");
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        self.row(row);
        if self.cells.is_empty() {
            self.reason(reason);
        } else {
            self.reason(&super::with_cells_beyond(row, self.cells.len(), reason));
        }
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        self.rows += 1;
        for (at, texts) in self.cells.iter_mut().enumerate() {
            texts.push(if at == 0 { line.as_bytes() } else { b"" });
        }
        self.reason(&reason.to_string());
    }

    /// A comment or an empty line is no row; the tally counts it.
    fn line(&mut self, _line: &[u8]) {}
}
