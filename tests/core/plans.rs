//! Plans of tests, from the text of a file.

use fitcheck::part::{Document, Draft, DraftFeature, Plan};
use fitcheck::tolerance::Sources;

/// The plan of a file without a fault.
#[track_caller]
pub fn plan(text: &str) -> Plan {
    read(text, &Sources::default()).unwrap_or_else(|errors| panic!("{errors:?}"))
}

/// The plan of a file, or everything that is wrong with it.
pub fn read(text: &str, sources: &Sources) -> Result<Plan, Vec<String>> {
    let document = Document::read(text.as_bytes()).map_err(|error| vec![error.to_string()])?;
    document.plan(sources).map_err(|errors| errors.iter().map(ToString::to_string).collect())
}

/// The plan of rows without a file.
#[track_caller]
pub fn of_rows(rows: &[DraftFeature], sources: &Sources) -> Plan {
    Plan::of(&Draft::of(rows.to_vec()), sources).unwrap_or_else(|faults| panic!("{faults:?}"))
}
