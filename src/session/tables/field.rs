//! The text fields of the table page.

use crate::session::field::KeptField;

/// A text field of the table page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TablesField {
    /// Which classes are shown, and which size is marked.
    Filter,
    /// Upper deviation of the selected cell, µm.
    CellUpper,
    /// Lower deviation of the selected cell, µm.
    CellLower,
    /// Classes to add or to make a table of.
    Classes,
    /// Largest size of a new table, mm.
    To,
}

impl KeptField for TablesField {
    const ALL: &'static [Self] = &[Self::Filter, Self::CellUpper, Self::CellLower, Self::Classes, Self::To];

    fn declared(self) -> (&'static str, &'static str) {
        match self {
            Self::Filter => ("table-filter", ""),
            Self::CellUpper => ("cell-upper", ""),
            Self::CellLower => ("cell-lower", ""),
            Self::Classes => ("table-classes", ""),
            Self::To => ("table-to", "500"),
        }
    }
}
