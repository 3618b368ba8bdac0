//! A control's table for a chosen generation of controls: `docs/SOURCES.md`, tables, says what each accepts.

use fitcheck_core::tolerance::DeviationTable;
use fitcheck_nc::control::deviations::to_control_table;
use fitcheck_nc::control::table::Generation;

use super::{TableFormat, TableFormatError};

/// The manual does not name the operators; these are those of the control's formulas.
const OPERATORS: [char; 6] = ['+', '-', '*', '/', '^', '%'];

/// iTNC 530: structure block, at most 30 columns and 200 characters a line.
pub const ITNC530: TableFormat = TableFormat {
    name: "itnc530",
    endings: &["tab"],
    description: "table-format-itnc530",
    warning: |_| None,
    write: |table| Ok(to_control_table(table, Generation::Structure).write()?),
};

/// TNC 620, TNC 640: description block.
pub const TNC640: TableFormat = TableFormat {
    name: "tnc640",
    endings: &["tab"],
    description: "table-format-tnc640",
    warning: |_| None,
    write: described,
};

/// TNC7: description block, and a name that begins with a letter and has no arithmetic operator (TNC7 manual 81762x-19).
pub const TNC7: TableFormat = TableFormat {
    name: "tnc7",
    endings: &["tab"],
    description: "table-format-tnc7",
    warning: |_| None,
    write: for_tnc7,
};

fn described(table: &DeviationTable) -> Result<Vec<u8>, TableFormatError> {
    Ok(to_control_table(table, Generation::Description).write()?)
}

fn for_tnc7(table: &DeviationTable) -> Result<Vec<u8>, TableFormatError> {
    let name = || table.name().to_owned();
    if !table.name().starts_with(|first: char| first.is_ascii_alphabetic()) {
        return Err(TableFormatError::Name { name: name() });
    }
    match table.name().chars().find(|sign| OPERATORS.contains(sign)) {
        Some(sign) => Err(TableFormatError::Operator { name: name(), sign }),
        None => described(table),
    }
}
