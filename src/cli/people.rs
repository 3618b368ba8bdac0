//! What people read: lengths, and tables whose columns are as wide as their widest cells.

use crate::length::{Length, Unit};

/// Millimetres exactly, with at least three decimals.
pub(super) fn mm(length: Length) -> String {
    length.exact(Unit::Millimetre, 3)
}

/// Micrometres exactly.
pub(super) fn um(length: Length) -> String {
    length.exact(Unit::Micrometre, 0)
}

/// `+7 … +41 µm`
pub(super) fn range(minimum: Length, maximum: Length) -> String {
    format!("{} … {} µm", minimum.signed_um(), maximum.signed_um())
}

/// What is said of clearances that begin so.
pub(super) const fn negative(minimum: Length) -> &'static str {
    if minimum.nanometres() < 0 { " (negative is interference)" } else { "" }
}

/// The columns of a table: each heading, and where its cells are aligned.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aligned<const N: usize> {
    pub(super) columns: [(&'static str, Side); N],
    /// How wide a column becomes at most: a wider cell moves those after it.
    pub(super) widest: usize,
}

/// Where the cells of a column are aligned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

impl<const N: usize> Aligned<N> {
    pub(super) fn headings(&self) -> [String; N] {
        self.columns.map(|(heading, _)| heading.to_owned())
    }

    /// How wide the columns are for these rows.
    pub(super) fn widths(&self, rows: &[[String; N]]) -> [usize; N] {
        let mut widths = self.columns.map(|(heading, _)| heading.chars().count());
        for row in rows {
            for (width, cell) in widths.iter_mut().zip(row) {
                *width = (*width).max(cell.chars().count().min(self.widest));
            }
        }
        widths
    }

    /// A row in columns of these widths.
    pub(super) fn line(&self, cells: &[String; N], widths: &[usize; N]) -> String {
        let padded = cells.iter().zip(widths).zip(self.columns).map(|((cell, &width), (_, side))| match side {
            Side::Left => format!("{cell:<width$}  "),
            Side::Right => format!("{cell:>width$}  "),
        });
        padded.collect::<String>().trim_end().to_owned()
    }

    /// The headings and all rows.
    pub(super) fn lines(&self, rows: &[[String; N]]) -> impl Iterator<Item = String> {
        let widths = self.widths(rows);
        std::iter::once(&self.headings()).chain(rows).map(|row| self.line(row, &widths)).collect::<Vec<_>>().into_iter()
    }
}
