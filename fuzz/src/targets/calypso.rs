//! Any bytes as a table of CALYPSO: every row is a record, set aside or an error, with a line of its own; none is rework or scrap, because
//! such a table says neither hole nor shaft.

use std::collections::BTreeSet;

use fitcheck::exchange::{FORMATS, Imported, import};
use fitcheck::verdict::Status;

use super::shared::{NOW, OWN_SOURCES, told};

pub fn run(bytes: &[u8]) {
    let name = "a_chr.txt";
    let format = FORMATS.iter().find(|format| format.recognises(bytes, name));
    if format.is_none_or(|format| format.name != "calypso") {
        return;
    }
    let Imported { records, lines, unjudged, errors, warnings, rows, .. } = import(name, bytes, &OWN_SOURCES, NOW);
    assert_eq!(rows, records.len() + unjudged.len() + errors.len());
    let is_open = |status| matches!(status, Status::Good | Status::OutOfLimits);
    assert!(records.iter().all(|record| is_open(record.verdict.status())));
    assert!(0 < rows, "nothing was read, and nothing said");
    let lines: Vec<usize> = lines.into_iter().chain(unjudged.iter().map(|row| row.line)).collect();
    assert_eq!(lines.iter().collect::<BTreeSet<_>>().len(), lines.len(), "a line with two values");
    for error in errors.iter().take(3) {
        told(bytes, error);
    }
    for warning in warnings.iter().take(3) {
        told(bytes, warning);
    }
}
