//! The CSV that PC-DMIS reads for ISO tolerances (PC-DMIS Core, page "ISO Dimension Tolerances").
//!
//! Two lines a class: the class and the bounds of its size ranges, then a pair of deviations for each range, in
//! millimetres. Sure are the two lines and that case tells hole from shaft. The manual shows one class, and the lower
//! deviation 0 only: several classes one after the other, and a lower deviation with its sign, are our reading. Where
//! a class is not defined in the middle of its sizes, it gets two lines for each part.

use super::TableFormat;
use crate::length::{Length, Unit};
use crate::tolerance::table::Column;
use crate::tolerance::{DeviationTable, Deviations};

/// This format.
pub const FORMAT: TableFormat = TableFormat {
    name: "pcdmis",
    endings: &["csv"],
    description: "CSV of ISO tolerances for PC-DMIS",
    description_id: "table-format-pcdmis",
    write: |table| Ok(write(table)),
};

fn write(table: &DeviationTable) -> Vec<u8> {
    let mut lines = Vec::new();
    for column in table.columns() {
        for part in parts(table, column) {
            let bounds: Vec<String> = part.bounds.iter().map(ToString::to_string).collect();
            let pairs: Vec<String> = part.pairs.iter().flat_map(|pair| [mm(pair.upper()), mm(pair.lower())]).collect();
            lines.push(format!("{}, {}\n{}\n", column.class, bounds.join(", "), pairs.join(", ")));
        }
    }
    lines.concat().into_bytes()
}

/// Neighbouring ranges with values: one more bound than pairs.
#[derive(Default)]
struct Part {
    bounds: Vec<Length>,
    pairs: Vec<Deviations>,
}

fn parts(table: &DeviationTable, column: &Column) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut over = Length::ZERO;
    for (&to, cell) in table.ends().iter().zip(&column.cells) {
        if let Some(pair) = cell {
            match parts.last_mut() {
                Some(part) if part.bounds.last() == Some(&over) => {
                    part.bounds.push(to);
                    part.pairs.push(*pair);
                }
                _ => parts.push(Part { bounds: vec![over, to], pairs: vec![*pair] }),
            }
        }
        over = to;
    }
    parts
}

/// Three decimals or more where needed; zero is a bare 0.
fn mm(length: Length) -> String {
    if length == Length::ZERO { "0".to_owned() } else { length.exact(Unit::Millimetre, 3) }
}
