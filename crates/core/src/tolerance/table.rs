//! Tables of deviations: size ranges and classes, as a control's table holds them.

use std::sync::Arc;

use super::class::ToleranceClass;
use super::deviations::Deviations;
use crate::length::Length;
use crate::message::Say;

/// One class of a [`DeviationTable`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// The class, `H7`.
    pub class: ToleranceClass,
    /// One cell per size range, `None` where the class is not defined.
    pub cells: Vec<Option<Deviations>>,
}

/// Deviations by size range and class.
///
/// Ranges are ascending and given by their upper, inclusive end; the first begins above 0. There are as many cells
/// in each column as ranges, and no class occurs twice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeviationTable {
    pub(super) name: Arc<str>,
    pub(super) shipped: bool,
    pub(super) ends: Vec<Length>,
    pub(super) columns: Vec<Column>,
}

/// What is wrong with the parts of a [`DeviationTable`]; readers of files also name the line.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shape", error)]
pub enum TableShapeError {
    /// No ranges.
    NoRanges,
    /// A range does not end above the one before it.
    NotAscending {
        /// The range's end.
        end: Length,
        /// The end of the range before it.
        before: Length,
    },
    /// A column has more or fewer cells than there are ranges.
    Cells {
        /// The column.
        class: ToleranceClass,
        /// Its number of cells.
        cells: usize,
        /// The number of ranges.
        ranges: usize,
    },
    /// A class has two columns.
    Twice {
        /// The class.
        class: ToleranceClass,
    },
}

impl DeviationTable {
    /// Makes a table from its parts. `shipped` marks the two built-in tables, which agree with ISO 286-2.
    ///
    /// # Errors
    /// [`TableShapeError`] where the parts do not fit together.
    pub fn new(name: &str, shipped: bool, ends: Vec<Length>, columns: Vec<Column>) -> Result<Self, TableShapeError> {
        if ends.is_empty() {
            return Err(TableShapeError::NoRanges);
        }
        let mut before = Length::ZERO;
        for &end in &ends {
            if end <= before {
                return Err(TableShapeError::NotAscending { end, before });
            }
            before = end;
        }
        for (number, column) in columns.iter().enumerate() {
            if column.cells.len() != ends.len() {
                let cells = column.cells.len();
                let ranges = ends.len();
                return Err(TableShapeError::Cells { class: column.class, cells, ranges });
            }
            if columns.iter().take(number).any(|other| other.class == column.class) {
                return Err(TableShapeError::Twice { class: column.class });
            }
        }
        Ok(Self { name: name.into(), shipped, ends, columns })
    }

    /// The table's name, `82553_hole.tab`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// A copy under another name, which is no longer a built-in table.
    #[must_use]
    pub fn named(&self, name: &str) -> Self {
        Self { name: name.into(), shipped: false, ..self.clone() }
    }

    /// Whether it is one of the two built-in tables.
    pub const fn shipped(&self) -> bool {
        self.shipped
    }

    /// The upper, inclusive ends of the size ranges, ascending.
    pub fn ends(&self) -> &[Length] {
        &self.ends
    }

    /// The size ranges, ascending: above, and up to and including.
    pub fn ranges(&self) -> impl Iterator<Item = (Length, Length)> {
        ranges(&self.ends)
    }

    /// The columns in the table's order.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The largest nominal size that the table answers.
    pub fn last_end(&self) -> Length {
        let (_, to) = self.last_range();
        to
    }

    /// The last of its ranges; a table has at least one.
    pub(super) fn last_range(&self) -> (Length, Length) {
        self.ranges().last().unwrap_or((Length::ZERO, Length::ZERO))
    }

    pub(super) fn column(&self, class: ToleranceClass) -> Option<&Column> {
        self.columns.iter().find(|column| column.class == class)
    }

    /// The first range that ends at or above the size: its number, above, up to and including.
    pub(super) fn range(&self, nominal: Length) -> Option<(usize, Length, Length)> {
        let number = self.ends.partition_point(|&end| end < nominal);
        let (over, to) = self.ranges().nth(number)?;
        Some((number, over, to))
    }
}

/// The size ranges with these ends: above, and up to and including.
pub(super) fn ranges(ends: &[Length]) -> impl Iterator<Item = (Length, Length)> {
    std::iter::once(Length::ZERO).chain(ends.iter().copied()).zip(ends.iter().copied())
}
