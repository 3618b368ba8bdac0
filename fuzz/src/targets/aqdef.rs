//! Any bytes as a file of AQDEF, or as its two halves (byte 0x1C between them): every value is a record, set aside or an error, in the
//! order of the lines; a diameter is above zero; limits are those that the verdict is by; and both halves give the same from either side.

use std::io::Cursor;

use fitcheck::exchange::{ImportInputs, Imported, import_given};
use fitcheck::length::Length;
use fitcheck::verdict::judge;

use super::shared::{NOW, OWN_SOURCES, told};

pub fn run(bytes: &[u8]) {
    if let Some(at) = bytes.iter().position(|&byte| byte == 0x1c) {
        let (characteristics, values) = (&bytes[..at], &bytes[at + 1..]);
        check(bytes, &read("a.dfd", characteristics, values));
        check(bytes, &read("a.dfx", values, characteristics));
    } else {
        let imported = read("a.dfq", bytes, b"");
        assert!(imported.lines.is_sorted());
        check(bytes, &imported);
    }
}

fn read(name: &str, bytes: &[u8], beside: &[u8]) -> Imported {
    let beside = |_ending: &str| Some(beside.to_vec()).filter(|beside| !beside.is_empty());
    let given = ImportInputs { beside: &beside, ..ImportInputs::new(&OWN_SOURCES, NOW) };
    import_given(name, &mut Cursor::new(bytes), given)
}

fn check(bytes: &[u8], imported: &Imported) {
    let Imported { records, lines, unjudged, errors, warnings, rows, .. } = imported;
    assert_eq!(*rows, records.len() + unjudged.len() + errors.len());
    assert_eq!(records.len(), lines.len());
    assert!(0 < *rows, "nothing was read, and nothing said");
    for record in records {
        assert!(Length::ZERO < record.measurement.diameter);
        assert_eq!(record.verdict, judge(&record.limits, record.measurement.diameter, None));
    }
    for error in errors.iter().take(3) {
        told(bytes, error);
    }
    for warning in warnings.iter().take(3) {
        told(bytes, warning);
    }
}
