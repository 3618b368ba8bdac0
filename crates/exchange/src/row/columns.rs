//! The columns of CSV for programs: each is declared once, with its name and how a row gives its cell.

use fitcheck_core::verdict::Status;

/// A column: its name, and its cell in a row; `None` is an empty cell.
pub type Column<R> = (&'static str, fn(&R) -> Option<String>);

/// Columns whose cells are the fields themselves, under the fields' names: `class`, and `hole.class` as `hole_class`
/// where `hole` is an `Option`.
#[macro_export]
macro_rules! columns {
    ($($first:ident $(. $second:ident $(. $third:ident)?)?),+ $(,)?) => {
        [$((
            concat!(stringify!($first) $(, "_", stringify!($second) $(, "_", stringify!($third))?)?),
            |row| row.$first $(.as_ref()?.$second $(.$third)?)?.cell(),
        )),+]
    };
}
pub use crate::columns;

/// The names, for the first line.
pub fn names<C: Copy, const N: usize>(columns: &[(&'static str, C); N]) -> [&'static str; N] {
    columns.map(|(name, _)| name)
}

/// The cells of a row, in the order of the columns; what the row does not have is an empty one.
pub fn cells<'a, R>(columns: &'a [Column<R>], row: &'a R) -> impl Iterator<Item = String> + 'a {
    columns.iter().map(move |(_, cell)| cell(row).unwrap_or_default())
}

/// What goes into a cell unchanged, the same in every language.
pub trait Cell {
    /// Its text; `None` for an empty cell.
    fn cell(&self) -> Option<String>;
}

impl Cell for String {
    fn cell(&self) -> Option<String> {
        Some(self.clone())
    }
}

impl Cell for &str {
    fn cell(&self) -> Option<String> {
        Some((*self).to_owned())
    }
}

impl Cell for bool {
    fn cell(&self) -> Option<String> {
        Some(self.to_string())
    }
}

impl Cell for Status {
    fn cell(&self) -> Option<String> {
        Some(self.word().to_owned())
    }
}

impl<T: Cell> Cell for Option<T> {
    fn cell(&self) -> Option<String> {
        self.as_ref()?.cell()
    }
}
