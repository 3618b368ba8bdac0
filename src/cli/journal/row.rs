//! The columns of a list. They must not change.

use serde_json::{Map, Value as Json, json};

use crate::journal::Record;
use crate::journal::entry::{Check, Checked, CycleCheck, Entry};
use crate::length::{Length, Unit};
use crate::report::columns::{Cell as _, Column, cells, names};
use crate::report::csv::harmless;
use crate::report::row::position;
use crate::store::local::Row;
use crate::tolerance::fit::thermal::Correction;
use crate::verdict::rules::Uncertainty;

/// The columns of the CSV, in order.
pub(super) const COLUMNS: [Column<Row>; 26] = [
    ("station", |row| name(&about(row)?.station)),
    ("number", |row| Some(row.kept.head.number.to_string())),
    ("time", |row| Some(about(row)?.time.text())),
    ("who", |row| name(&about(row)?.who)),
    ("part", |row| name(&about(row)?.part)),
    ("serial", |row| name(&about(row)?.serial)),
    ("feature", |row| name(&about(row)?.feature)),
    ("callout", |row| record(row)?.callout.map(|callout| callout.to_string())),
    ("min_mm", |row| Some(mm(limits(row)?[0]))),
    ("max_mm", |row| Some(mm(limits(row)?[1]))),
    ("measured_mm", |row| Some(mm(measured(row)?))),
    ("rule", |row| record(row)?.verdict.rule.name().word().cell()),
    ("u_um", |row| record(row)?.verdict.rule.uncertainty().map(Uncertainty::um)),
    ("status", |row| check(row)?.status()?.cell()),
    ("origin", |row| name(&origin(check(row)?))),
    ("correction_of", |row| Some(entry(row)?.corrects()?.target.number.to_string())),
    ("hash", |row| Some(row.kept.head.hash.to_string())),
    ("simulated", |row| check(row)?.is_simulated().cell()),
    ("as_measured_mm", |row| Some(mm(correction(row)?.measured))),
    ("correction_um", |row| Some(correction(row)?.change().exact(Unit::Micrometre, 0))),
    ("temperature_c", |row| Some(correction(row)?.part.temperature.to_string())),
    ("expansion_um_per_m_k", |row| Some(correction(row)?.part.expansion.to_string())),
    ("scale_temperature_c", |row| Some(correction(row)?.scale?.temperature.to_string())),
    ("scale_expansion_um_per_m_k", |row| Some(correction(row)?.scale?.expansion.to_string())),
    ("position", |row| position(record(row)?.verdict.position?).cell()),
    ("remeasure_reason", |row| Some(record(row)?.verdict.undecided?.to_string())),
];

/// Columns whose cells are numbers in JSON.
const NUMBERS: [&str; 12] = [
    "number",
    "min_mm",
    "max_mm",
    "measured_mm",
    "u_um",
    "correction_of",
    "as_measured_mm",
    "correction_um",
    "temperature_c",
    "expansion_um_per_m_k",
    "scale_temperature_c",
    "scale_expansion_um_per_m_k",
];

/// The names of the columns, as the first line of a CSV.
pub(super) fn header() -> Vec<String> {
    names(&COLUMNS).into_iter().map(str::to_owned).collect()
}

/// The cells of a row.
pub(super) fn line(row: &Row) -> Vec<String> {
    cells(&COLUMNS, row).collect()
}

/// The same as an object, with what a list has no column for.
pub(super) fn object(row: &Row) -> Map<String, Json> {
    let mut object = Map::new();
    for (name, cell) in COLUMNS {
        let cell = cell(row);
        let value = match cell {
            // Decimals are exact in their text, and the nearest float prints the same.
            Some(text) if NUMBERS.contains(&name) => serde_json::from_str(&text).unwrap_or(Json::String(text)),
            Some(text) => Json::String(text),
            None => Json::Null,
        };
        object.insert(name.to_owned(), value);
    }
    let remark = about(row).map(|about| about.remark.clone()).filter(|remark| !remark.is_empty());
    object.insert("simulated".to_owned(), json!(check(row).map(Check::is_simulated)));
    object.insert("corrected_by".to_owned(), json!(row.corrected_by));
    object.insert("remark".to_owned(), json!(remark));
    object.insert("error".to_owned(), json!(row.entry.as_ref().err().map(ToString::to_string)));
    object
}

pub(super) fn entry(row: &Row) -> Option<&Entry> {
    row.entry.as_ref().ok()
}

fn about(row: &Row) -> Option<&crate::journal::entry::About> {
    entry(row).map(|entry| &entry.about)
}

pub(super) fn check(row: &Row) -> Option<&Check> {
    entry(row)?.check()
}

pub(super) fn record(row: &Row) -> Option<&Record> {
    match &check(row)?.what {
        Checked::Size(record) => Some(record),
        Checked::Cycle(_) => None,
    }
}

/// How a value was brought to 20 °C.
fn correction(row: &Row) -> Option<&Correction> {
    record(row)?.correction.as_ref()
}

fn cycle(row: &Row) -> Option<&CycleCheck> {
    match &check(row)?.what {
        Checked::Size(_) => None,
        Checked::Cycle(cycle) => Some(cycle),
    }
}

fn limits(row: &Row) -> Option<[Length; 2]> {
    let of_record = record(row).map(|record| [record.limits.minimum(), record.limits.maximum()]);
    of_record.or_else(|| cycle(row)?.limits)
}

pub(super) fn measured(row: &Row) -> Option<Length> {
    record(row).map(|record| record.measurement.diameter).or_else(|| cycle(row)?.measured)
}

/// Where a value comes from, in English.
pub(super) fn origin(check: &Check) -> String {
    match &check.what {
        Checked::Size(record) => record.measurement.origin.to_string(),
        Checked::Cycle(cycle) => format!("cycle {}, {}", cycle.cycle, cycle.origin),
    }
}

fn mm(length: Length) -> String {
    length.exact(Unit::Millimetre, 3)
}

/// A text that somebody typed: no spreadsheet computes it.
fn name(text: &str) -> Option<String> {
    (!text.is_empty()).then(|| harmless(text))
}
