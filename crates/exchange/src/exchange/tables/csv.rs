//! Plain CSV: one line per cell that has a value, in millimetres and micrometres as the names say, with a point.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::DeviationTable;

use super::{TableFormat, TableFormatError};

pub const FORMAT: TableFormat =
    TableFormat { name: "csv", endings: &["csv"], description: "table-format-plain-csv", warning: |_| None, write };

fn write(table: &DeviationTable) -> Result<Vec<u8>, TableFormatError> {
    let failed = |error: &dyn std::fmt::Display| TableFormatError::Csv { reason: error.to_string() };
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = ["class", "over_mm", "to_mm", "upper_um", "lower_um"];
    writer.write_record(names).map_err(|error| failed(&error))?;
    let um = |length: Length| length.exact(Unit::Micrometre, 0);
    for column in table.columns() {
        for ((over, to), cell) in table.ranges().zip(&column.cells) {
            if let Some(pair) = cell {
                let class = column.class.to_string();
                let row = [class, over.to_string(), to.to_string(), um(pair.upper()), um(pair.lower())];
                writer.write_record(row).map_err(|error| failed(&error))?;
            }
        }
    }
    writer.into_inner().map_err(|error| failed(&error))
}
