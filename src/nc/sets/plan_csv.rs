//! Plans as CSV: one feature per line.
//!
//! The header names the columns, in any order: `callout`, `x`, `y`, `z`, and if wanted `name`, `kind`, `axis`,
//! `callout2`, `angle`, `clearance`, `clearance_height`. Comma, semicolon or tab separates cells; numbers have a point or a comma.

use std::str::FromStr;

use super::cells::KindCells;
use super::error::{PlanError, PlanFault};
use super::plan::{MOST_FEATURES, NcFeature, NcPlan};
use crate::control::text::{decode, lines};
use crate::length::LengthError;
use crate::message::Place;

/// The known columns.
const COLUMNS: [&str; 11] =
    ["name", "kind", "axis", "callout", "callout2", "x", "y", "z", "angle", "clearance", "clearance_height"];

/// The largest plan, 1 MiB: a kilobyte for every feature. Every cell takes memory and time, also an empty one.
const LARGEST: usize = 1 << 20;

/// The required columns.
const NEEDED: [&str; 4] = ["callout", "x", "y", "z"];

impl NcPlan {
    /// Reads a plan.
    ///
    /// ```
    /// use fitcheck::nc::sets::NcPlan;
    ///
    /// let plan = NcPlan::read(b"name;callout;x;y;z\nA1;25 H7;40;30,5;-8\n")?;
    /// assert_eq!(plan.features()[0].y.to_string(), "30.5");
    /// # Ok::<(), fitcheck::nc::sets::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlanError`] with the line, also if a row has more cells than the header, or if a column is unknown.
    pub fn read(bytes: &[u8]) -> Result<Self, PlanError> {
        if LARGEST < bytes.len() {
            return Err(PlanError { what: PlanFault::TooLarge { most: LARGEST >> 10 }, place: Place::default() });
        }
        let text = decode(bytes);
        let header = lines(&text).map(|(_, line)| line).find(|line| !line.trim().is_empty()).unwrap_or_default();
        let separator = [b';', b'\t'].into_iter().find(|&sign| header.as_bytes().contains(&sign)).unwrap_or(b',');
        let mut columns: Option<Vec<&'static str>> = None;
        let (mut features, mut features_lines) = (Vec::new(), Vec::new());
        for (line, row) in lines(&text) {
            let at = |what| PlanError::in_line(line, what);
            let row = cells(row, separator);
            if row.iter().all(str::is_empty) {
                continue;
            }
            let Some(columns) = &columns else {
                columns = Some(header_of(&row).map_err(at)?);
                continue;
            };
            if features.len() == MOST_FEATURES {
                return Err(at(PlanFault::TooMany { most: MOST_FEATURES }));
            }
            features.push(feature(columns, &row).map_err(at)?);
            features_lines.push(line);
        }
        Self::of_lines(features, features_lines)
    }
}

/// The cells of a line; none contains a line end.
fn cells(line: &str, separator: u8) -> csv::StringRecord {
    let reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .delimiter(separator)
        .buffer_capacity(line.len().clamp(1, 1 << 16))
        .from_reader(line.as_bytes());
    // A row of a text in memory can always be read.
    reader.into_records().find_map(Result::ok).unwrap_or_default()
}

fn header_of(row: &csv::StringRecord) -> Result<Vec<&'static str>, PlanFault> {
    let mut columns = Vec::new();
    for cell in row {
        let known = COLUMNS.into_iter().find(|known| known.eq_ignore_ascii_case(cell));
        let known = known.ok_or_else(|| PlanFault::UnknownColumn {
            column: cell.chars().take(40).collect(),
            known: COLUMNS.join(", "),
        })?;
        if columns.contains(&known) {
            return Err(PlanFault::ColumnTwice { column: known });
        }
        columns.push(known);
    }
    match NEEDED.into_iter().find(|needed| !columns.contains(needed)) {
        Some(column) => Err(PlanFault::NoColumn { column }),
        None => Ok(columns),
    }
}

fn feature(columns: &[&'static str], row: &csv::StringRecord) -> Result<NcFeature, PlanFault> {
    if columns.len() < row.len() {
        return Err(PlanFault::Cells { found: row.len(), expected: columns.len() });
    }
    let cell = |column: &'static str| {
        let at = columns.iter().position(|known| *known == column);
        at.and_then(|at| row.get(at)).filter(|cell| !cell.is_empty())
    };
    let callout = cell("callout").ok_or(PlanFault::NoCell { column: "callout" })?;
    let kind = KindCells { kind: cell("kind"), axis: cell("axis"), callout, second: cell("callout2") }.read()?;
    let needed = |column| match cell(column) {
        Some(text) => number(column, text),
        None => Err(PlanFault::NoCell { column }),
    };
    let usual = NcFeature::of_kind(kind, [needed("x")?, needed("y")?, needed("z")?]);
    Ok(NcFeature {
        name: cell("name").unwrap_or_default().to_owned(),
        angle: cell("angle").map_or(Ok(usual.angle), |text| number("angle", text))?,
        clearance: cell("clearance").map_or(Ok(usual.clearance), |text| number("clearance", text))?,
        clearance_height: cell("clearance_height")
            .map_or(Ok(usual.clearance_height), |text| number("clearance_height", text))?,
        ..usual
    })
}

fn number<T: FromStr<Err = LengthError>>(column: &'static str, text: &str) -> Result<T, PlanFault> {
    text.parse().map_err(|error| PlanFault::Number { column, error })
}
