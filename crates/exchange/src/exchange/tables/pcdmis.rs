//! The CSV that PC-DMIS reads for ISO tolerances (PC-DMIS Core, page "ISO Dimension Tolerances").
//!
//! Each class has two lines: the class and the bounds of its size ranges, then a pair of deviations for each range, in
//! millimetres. That page (2020.2, 2023.1) confirms the two lines, bounds above and up to, that the lines apply to this
//! class alone, and that case tells hole from shaft. It shows H7 as a part of a file, so several classes one after the
//! other are very likely. Not confirmed: the sign of a lower deviation, because the page shows only 0 and calls the
//! pair plus and minus tolerance, and elsewhere in PC-DMIS a minus tolerance is typed without its sign. It is written
//! with its sign here, and [`FormatWarning::LowerSign`] says so. Also not confirmed: that a class may occur twice. One
//! that is not defined in the middle of its sizes gets two lines for each part. The page says nothing of names without a grade,
//! such as an own column PF: they are written like any class.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::table::Column;
use fitcheck_core::tolerance::{DeviationTable, Deviations};

use super::{FormatWarning, TableFormat};

pub const FORMAT: TableFormat = TableFormat {
    name: "pcdmis",
    endings: &["csv"],
    description: "table-format-pcdmis",
    warning,
    write: |table| Ok(write(table)),
};

fn warning(table: &DeviationTable) -> Option<FormatWarning> {
    let class = |column: &Column| {
        let is_signed = column.cells.iter().flatten().any(|pair| pair.lower() != Length::ZERO);
        is_signed.then_some(column.class)
    };
    table.columns().iter().find_map(class).map(|class| FormatWarning::LowerSign { class })
}

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
    for ((over, to), cell) in table.ranges().zip(&column.cells) {
        if let Some(pair) = cell {
            match parts.last_mut() {
                Some(part) if part.bounds.last() == Some(&over) => {
                    part.bounds.push(to);
                    part.pairs.push(*pair);
                }
                _ => parts.push(Part { bounds: vec![over, to], pairs: vec![*pair] }),
            }
        }
    }
    parts
}

/// Three decimals or more where needed; zero is a bare 0.
fn mm(length: Length) -> String {
    if length == Length::ZERO { "0".to_owned() } else { length.exact(Unit::Millimetre, 3) }
}
