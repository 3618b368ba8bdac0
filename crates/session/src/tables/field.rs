//! The text fields of the table page.

use crate::texts::kept_fields;

kept_fields! {
    /// A text field of the table page.
    TablesField

    /// Which classes are shown, and which size is marked.
    Filter: "table-filter", "";
    /// Upper deviation of the selected cell, µm.
    CellUpper: "cell-upper", "";
    /// Lower deviation of the selected cell, µm.
    CellLower: "cell-lower", "";
    /// Classes to add or to make a table of.
    Classes: "table-classes", "";
    /// Largest size of a new table, mm.
    To: "table-to", "500";
}
