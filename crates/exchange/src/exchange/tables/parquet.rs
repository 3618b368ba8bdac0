//! Parquet: one row per cell that has a value, for engines that join files.
//!
//! Names are those of the table `fitcheck_limits` in the SQL of `fitcheck sql`. Deviations are in millimetres, so that a nominal
//! size and a deviation add up to a limit, and all figures are exact decimals. A size belongs to the range above `over_mm` up
//! to `to_mm`; the ranges of a class are ascending, as a join by the nearest `to_mm` wants them. There is no number of a step:
//! tables may have ranges of their own.

use std::sync::Arc;

use fitcheck_core::tolerance::DeviationTable;

use super::{TableFormat, TableFormatError};

/// This format; programs without the feature `parquet` refuse to write it.
pub const FORMAT: TableFormat = TableFormat {
    name: "parquet",
    endings: &["parquet"],
    description: "table-format-plain-parquet",
    warning: |_| None,
    write: |table| together(&[Arc::new(table.clone())]),
};

/// One file of several tables.
///
/// # Errors
/// [`TableFormatError::ParquetUnknown`] in a program without the feature `parquet`.
#[cfg(not(feature = "parquet"))]
pub fn together(_tables: &[Arc<DeviationTable>]) -> Result<Vec<u8>, TableFormatError> {
    Err(TableFormatError::ParquetUnknown)
}

/// One file of several tables.
///
/// # Errors
/// What the writer reports.
#[cfg(feature = "parquet")]
pub fn together(tables: &[Arc<DeviationTable>]) -> Result<Vec<u8>, TableFormatError> {
    file(tables).map_err(|error| TableFormatError::Parquet { reason: error.to_string() })
}

/// One row group: there are a few thousand cells.
#[cfg(feature = "parquet")]
fn file(tables: &[Arc<DeviationTable>]) -> std::io::Result<Vec<u8>> {
    use crate::exchange::parquet::{Chunks, Field, Writer, put_text};
    use fitcheck_core::tolerance::Feature;

    let [over, to, lower, upper] =
        ["over_mm", "to_mm", "lower_mm", "upper_mm"].map(|name| Field::decimal(name, 6, false));
    let fields = [Field::required_text("class")?, Field::boolean("hole")?, over?, to?, lower?, upper?];
    let mut classes = Vec::new();
    let mut holes = Vec::new();
    let mut figures = [const { Vec::new() }; 4];
    for table in tables {
        for column in table.columns() {
            for ((over, to), cell) in table.ranges().zip(&column.cells) {
                if let Some(pair) = cell {
                    put_text(column.class.as_str().as_bytes(), &mut classes);
                    holes.push(column.class.feature() == Feature::Hole);
                    for (values, length) in figures.iter_mut().zip([over, to, pair.lower(), pair.upper()]) {
                        values.push(length.nanometres());
                    }
                }
            }
        }
    }
    let rows = holes.len();
    let mut chunks = Chunks::new(&fields)?;
    chunks.texts(rows, &[], &classes)?;
    chunks.booleans(rows, &[], &holes)?;
    for values in &figures {
        chunks.numbers(rows, &[], values)?;
    }
    let mut bytes = Vec::new();
    let mut writer = Writer::new(&mut bytes, &fields)?;
    if 0 < rows {
        writer.write(chunks.group())?;
    }
    writer.finish()?;
    Ok(bytes)
}
