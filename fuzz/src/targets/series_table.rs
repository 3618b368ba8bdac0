//! Any bytes as the table of a series: every value is a record, set aside or an error, and the verdicts are those of the limits.

use fitcheck::exchange::{FORMATS, Imported, import};
use fitcheck::verdict::judge;

use super::shared::{NOW, OWN_SOURCES, told};

pub fn run(bytes: &[u8]) {
    let file = "a.tab";
    let format = FORMATS.iter().find(|format| format.recognises(bytes, file));
    if format.is_none_or(|format| format.name != "series-table") {
        return;
    }
    let Imported { records, unjudged, errors, warnings, rows, .. } = import(file, bytes, &OWN_SOURCES, NOW);
    assert_eq!(rows, records.len() + unjudged.len() + errors.len());
    assert!(0 < rows, "nothing was read, and nothing said");
    for record in &records {
        let status = judge(&record.limits, record.measurement.diameter, None).status();
        assert_eq!(record.verdict.status(), status);
    }
    for error in errors.iter().take(3) {
        told(bytes, error);
    }
    for warning in warnings.iter().take(3) {
        told(bytes, warning);
    }
}
