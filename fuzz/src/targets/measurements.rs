//! Any bytes as an import of any format: every row is a record, set aside or an error, with a line of its own; the
//! verdicts are those of the limits; what is exported as CSV is imported as the same. Read as sizes alone, every record is
//! one of its side.

use std::collections::BTreeSet;

use fitcheck::exchange::{FORMATS, Imported, import, sizes};
use fitcheck::journal::Record;
use fitcheck::length::Length;
use fitcheck::report::csv;
use fitcheck::tolerance::Feature;
use fitcheck::verdict::judge;

use super::shared::{NOW, OWN_SOURCES, told};

pub fn run(bytes: &[u8]) {
    let imported = import("a.csv", bytes, &OWN_SOURCES, NOW);
    counts(bytes, &imported);
    sizes_alone(bytes, &imported);
    for format in FORMATS {
        let _either = format.recognises(bytes, "a.csv");
    }
    let records: Vec<Record> = imported.records.into_iter().filter(|record| record.callout.is_some()).collect();
    for record in &records {
        assert_eq!(record.verdict, judge(&record.limits, record.measurement.diameter, None));
    }
    if !records.is_empty() {
        comes_back(&records);
    }
}

fn counts(bytes: &[u8], imported: &Imported) {
    let Imported { records, lines, unjudged, errors, warnings, rows, .. } = imported;
    assert_eq!(*rows, records.len() + unjudged.len() + errors.len());
    assert_eq!(records.len(), lines.len());
    assert!(lines.is_sorted());
    // A line ends with LF or CR; in a log also with a zero byte.
    let most = 1 + bytes.iter().filter(|byte| b"\r\n\0".contains(byte)).count();
    let given = unjudged.iter().map(|row| row.line).chain(errors.iter().filter_map(|error| error.place.line));
    for line in lines.iter().copied().chain(given) {
        assert!((1..=most).contains(&line), "line {line} of {most}");
    }
    for error in errors.iter().take(3) {
        told(bytes, error);
    }
    for warning in warnings.iter().take(3) {
        told(bytes, warning);
    }
}

fn sizes_alone(bytes: &[u8], imported: &Imported) {
    for feature in [Feature::Hole, Feature::Shaft] {
        let read = sizes("a.csv", bytes, feature);
        assert!(!read.measured.is_empty() || !read.errors.is_empty(), "nothing was read, and nothing said");
        assert!(read.measured.iter().all(|size| Length::ZERO < size.measured));
        let found: BTreeSet<_> = read.measured.iter().map(|size| (size.line, size.measured)).collect();
        for (line, record) in imported.lines.iter().zip(&imported.records) {
            let measured = record.measurement.diameter;
            let is_size = record.limits.feature == Some(feature) && Length::ZERO < measured;
            assert!(!is_size || found.contains(&(*line, measured)), "line {line}: {measured}");
        }
        for error in read.errors.iter().take(3) {
            told(bytes, error);
        }
    }
}

fn comes_back(records: &[Record]) {
    let written = csv::render(records).expect("records are written");
    let again = import("a.csv", &written, &OWN_SOURCES, NOW);
    assert_eq!((again.errors.len(), again.unjudged.len()), (0, 0), "{:?}", again.errors.first());
    assert_eq!(again.records.len(), records.len());
    for (again, record) in again.records.iter().zip(records) {
        assert_eq!((again.time, again.callout, &again.limits), (record.time, record.callout, &record.limits));
        assert_eq!((again.measurement.diameter, again.verdict), (record.measurement.diameter, record.verdict));
        assert_eq!(again.measurement.origin.is_simulated(), record.measurement.origin.is_simulated());
        assert_eq!(again.id.trim_start_matches('\''), record.id.trim_start_matches('\''));
    }
}
