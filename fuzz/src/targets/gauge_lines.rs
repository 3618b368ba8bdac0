//! Any bytes as lines of gauges in a file: no line is lost, with a unit or without; a line that names its unit has the same value whatever
//! unit is given.

use std::io::Cursor;

use fitcheck::exchange::{FORMATS, ImportInputs, Imported, Mapping, import_given};

use super::shared::{NOW, OWN_SOURCES};

pub fn run(bytes: &[u8]) {
    let format = FORMATS.iter().find(|format| format.recognises(bytes, "a.txt"));
    if format.is_none_or(|format| format.name != "gauge") {
        return;
    }
    let read = |mapping: Option<&Mapping>| {
        let given = ImportInputs { mapping, ..ImportInputs::new(&OWN_SOURCES, NOW) };
        import_given("a.txt", &mut Cursor::new(bytes), given)
    };
    let of = |word: &str| read(Some(&word.parse::<Mapping>().expect("a mapping")));
    let plain = read(None);
    let [mm, inch] = ["unit=mm", "unit=inch"].map(of);
    for Imported { records, unjudged, errors, rows, .. } in [&plain, &mm, &inch] {
        assert_eq!(*rows, unjudged.len() + errors.len());
        assert!(records.is_empty() && 0 < *rows, "nothing was read, and nothing said");
    }
    if !plain.unjudged.is_empty() {
        assert_eq!(plain.unjudged, mm.unjudged);
        assert_eq!(plain.unjudged, inch.unjudged);
    }
    // An inch may be too long to be a length.
    assert!(inch.unjudged.len() <= mm.unjudged.len());
}
