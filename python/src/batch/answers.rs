//! The answers of rows as columns, in the order of the rows.

use std::sync::Arc;

use arrow_array::ArrayRef;
use arrow_array::builder::{Decimal128Builder, StringBuilder};
use arrow_schema::{ArrowError, DataType, Field};
use fitcheck_core::verdict::doubt_of;
use fitcheck_exchange::exchange::ImportErrorKind;
use fitcheck_exchange::exchange::batch::{ADDED, Judged, Take, TextRow};

/// The figures of a decimal of the answers.
const FIGURES: u8 = 18;

/// The column that says what is doubtful about a verdict, behind those of `fitcheck batch`.
const DOUBT: &str = "doubt";

/// The added columns, each behind a prefix.
pub(super) fn fields(prefix: &str) -> Vec<Field> {
    let field = |name: &str| {
        let kind = match name {
            "min_mm" | "max_mm" => DataType::Decimal128(FIGURES, 6),
            "deviation_um" | "remove_um" => DataType::Decimal128(FIGURES, 3),
            _ => DataType::Utf8,
        };
        Field::new(format!("{prefix}{name}"), kind, true)
    };
    ADDED.into_iter().chain([DOUBT]).map(field).collect()
}

/// Takes rows with their answers.
#[derive(Debug)]
pub(super) struct Answers {
    minimum: Decimal128Builder,
    maximum: Decimal128Builder,
    deviation: Decimal128Builder,
    status: StringBuilder,
    remove: Decimal128Builder,
    error: StringBuilder,
    doubt: StringBuilder,
    rows: usize,
}

impl Answers {
    /// Room for this many rows.
    pub(super) fn new(rows: usize) -> Self {
        let number = || Decimal128Builder::with_capacity(rows);
        Self {
            minimum: number(),
            maximum: number(),
            deviation: number(),
            status: StringBuilder::with_capacity(rows, rows * "REWORK".len()),
            remove: number(),
            error: StringBuilder::with_capacity(rows, 0),
            doubt: StringBuilder::with_capacity(rows, 0),
            rows: 0,
        }
    }

    /// How many rows were answered.
    pub(super) const fn rows(&self) -> usize {
        self.rows
    }

    /// The columns, in the order of [`fields`].
    pub(super) fn columns(mut self) -> Result<Vec<ArrayRef>, ArrowError> {
        let number = |mut of: Decimal128Builder, scale| -> Result<ArrayRef, ArrowError> {
            Ok(Arc::new(of.finish().with_precision_and_scale(FIGURES, scale)?))
        };
        Ok(vec![
            number(self.minimum, 6)?,
            number(self.maximum, 6)?,
            number(self.deviation, 3)?,
            Arc::new(self.status.finish()),
            number(self.remove, 3)?,
            Arc::new(self.error.finish()),
            Arc::new(self.doubt.finish()),
        ])
    }

    fn without_verdict(&mut self, reason: &str) {
        self.rows += 1;
        for number in [&mut self.minimum, &mut self.maximum, &mut self.deviation, &mut self.remove] {
            number.append_null();
        }
        self.status.append_null();
        self.error.append_option(Some(reason).filter(|reason| !reason.is_empty()));
        self.doubt.append_null();
    }
}

impl Take for Answers {
    #[inline]
    fn judged(&mut self, _row: &TextRow<'_>, judged: &Judged) {
        self.rows += 1;
        let verdict = judged.verdict();
        self.minimum.append_value(judged.bounds.minimum().nanometres().into());
        self.maximum.append_value(judged.bounds.maximum().nanometres().into());
        self.deviation.append_value(verdict.deviation.nanometres().into());
        self.status.append_value(judged.status.word());
        self.remove.append_option(verdict.removal.map(|removal| removal.to_limit.nanometres().into()));
        self.error.append_null();
        self.doubt.append_option(doubt_of(&judged.bounds, judged.measured).map(|doubt| doubt.to_string()));
    }

    fn refused(&mut self, _row: &TextRow<'_>, reason: &str) {
        self.without_verdict(reason);
    }

    fn broken(&mut self, _line: &str, reason: &ImportErrorKind) {
        self.without_verdict(&reason.to_string());
    }

    /// Columns with types have no lines.
    fn line(&mut self, _line: &[u8]) {}
}
