//! Any bytes as a QIF file: every row is a record, set aside or an error with a place within the file, and the verdicts are those of
//! the limits; the same text in UTF-16 is read as the same.

use fitcheck::exchange::import;
use fitcheck::verdict::judge;

use super::shared::{NOW, OWN_SOURCES, told};

pub fn run(bytes: &[u8]) {
    let imported = import("a.qif", bytes, &OWN_SOURCES, NOW);
    let rows = imported.records.len() + imported.unjudged.len() + imported.errors.len();
    assert_eq!(imported.rows, rows);
    for record in &imported.records {
        assert_eq!(record.verdict, judge(&record.limits, record.measurement.diameter, None));
    }
    for error in &imported.errors {
        told(bytes, error);
        assert!(error.place.line.is_some_and(|line| 1 <= line));
    }
    imported.warnings.iter().for_each(|warning| told(bytes, warning));
    let text = std::str::from_utf8(bytes)
        .ok()
        .filter(|text| text.contains("encoding=\"UTF-8\"") && !text.contains('\u{fffd}'));
    if let Some(text) = text.filter(|text| text.starts_with("<?xml ")) {
        let wide: Vec<u8> = format!("\u{feff}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect();
        let again = import("a.qif", &wide, &OWN_SOURCES, NOW);
        if text.contains("<QIFDocument") {
            assert_eq!((again.records, again.unjudged), (imported.records, imported.unjudged));
        }
    }
}
