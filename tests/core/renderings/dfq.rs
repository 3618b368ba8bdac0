//! AQDEF: what our own reader reads back, and that nothing in it is better than in the report.

use fitcheck::exchange::{ImportInputs, Item, import_from};
use fitcheck::tolerance::Sources;
use std::io::Cursor;

use super::lots::{bytes, corrected, hostile, lot, undecided};
use super::*;

/// What is read from a file of ours.
pub fn read_back(name: &str, bytes: &[u8]) -> Vec<Item> {
    let mut items = Vec::new();
    let sources = Sources::default();
    let given = ImportInputs::new(&sources, created());
    import_from(name, &mut Cursor::new(bytes), given, &mut |item| items.push(item));
    items
}

/// Name, size, limits and verdict of every value.
pub fn values(items: &[Item]) -> Vec<String> {
    let line = |item: &Item| match item {
        Item::Record { record, labels, .. } => {
            let Record { id, measurement, limits, verdict, time, .. } = &**record;
            let serial = &labels.serial;
            let [minimum, maximum] = [limits.minimum(), limits.maximum()];
            let status = verdict.status();
            Some(format!("{id} {} {minimum}..{maximum} {status} {time} [{serial}]", measurement.diameter))
        }
        Item::Unjudged(row) => Some(format!("{} {:?}: {}", row.id, row.measured.map(|size| size.to_string()), row.why)),
        Item::Error(error) => Some(format!("error: {}", error.what.kind)),
        Item::Warning(_) | Item::Contacts(_) => None,
    };
    items.iter().filter_map(line).collect()
}

/// What is said of a file besides its values.
pub fn warnings(items: &[Item]) -> Vec<String> {
    let said = |item: &Item| match item {
        Item::Warning(warning) => Some(warning.what.kind.to_string()),
        _ => None,
    };
    items.iter().filter_map(said).collect()
}

#[test]
fn a_file_has_the_keys_of_the_format() {
    let report = Report {
        part: Some("4711".to_owned()),
        order: Some("O-1".to_owned()),
        inspector: Some("J. de Vries".to_owned()),
        ..report(vec![good(), rework()])
    };
    let text = String::from_utf8(bytes("dfq", &report, Language::Nl)).unwrap();
    let expected = "K0100 2
K1001/1 4711
K1002/1 4711
K1053/1 O-1
K1222/1 J. de Vries
K1900/1 Fitcheck 0.0.0, 2026-11-21 11:00:00
K2001/1 1
K2002/1 Bore A
K2004/1 0
K2009/1 202
K2022/1 3
K2101/1 25.000
K2103/1 H
K2104/1 7
K2110/1 25.000
K2111/1 25.021
K2112/1 0.000
K2113/1 0.021
K2115/1 25.021
K2120/1 1
K2121/1 1
K2142/1 mm
K2900/1 25 H7, ISO 286, over 18 up to 30 mm
";
    assert!(text.replace("\r\n", "\n").starts_with(expected), "{text}");
    let values = "K0001/1 25.012
K0002/1 0
K0004/1 21.11.2026/10:42:07
K0009/1 GOOD; one diameter only: form and position are unknown
K0001/2 24.998
K0002/2 0
K0004/2 21.11.2026/10:43:00
K0009/2 REWORK; one diameter only: form and position are unknown
";
    assert!(text.replace("\r\n", "\n").ends_with(values), "{text}");
    assert!(text.lines().count() == text.matches("\r\n").count() && text.is_ascii());
}

#[test]
fn our_reader_has_the_same_values_limits_and_verdicts() {
    let report = report(vec![good(), rework(), scrap(), typed("25.012346")]);
    let items = read_back("r.dfq", &bytes("dfq", &report, Language::En));
    assert_eq!(
        values(&items),
        [
            "Bore A 25.012 25..25.021 GOOD 2026-11-21T10:42:07 []",
            "25 H7 24.998 25..25.021 REWORK 2026-11-21T10:43:00 []",
            "Bore C 25.03 25..25.021 SCRAP 2026-11-21T10:43:30 []",
            "25 H7 25.012346 25..25.021 GOOD 2026-11-21T10:42:07 []",
        ]
    );
    assert_eq!(warnings(&items), ["entries skipped: K1900, K2900"]);
}

#[test]
fn parts_have_serial_numbers_and_what_they_lack_is_no_value() {
    let report = lot();
    let file = bytes("dfq", &report, Language::En);
    let items = read_back("r.dfq", &file);
    let time = "2026-11-21T10:42:07";
    assert_eq!(
        values(&items),
        [
            format!("BORE_A 25.012 25..25.021 GOOD {time} [17]"),
            format!("SEAT 19.9901 19.98..19.993 GOOD {time} [17]"),
            format!("SLOT 12.02 12..12.043 GOOD {time} [17]"),
            format!("BORE_A 25.012 25..25.021 GOOD {time} [18]"),
            format!("BORE_A 25.1 25..25.021 SCRAP {time} [19]"),
            format!("SEAT 19.9901 19.98..19.993 GOOD {time} [19]"),
            format!("SLOT 12.02 12..12.043 GOOD {time} [19]"),
            "25 H7 24.998 25..25.021 REWORK 2026-11-21T10:43:00 []".to_owned(),
        ]
    );
    // Two sizes of the second part, and three values that nobody measured.
    assert!(warnings(&items).iter().any(|said| said.contains('5') && said.contains("missing")), "{items:?}");
    let text = String::from_utf8(file).unwrap();
    for line in ["K0009/2 missing", "K0009/3 left out: no gauge", "K0009/1 SIMULATED GOOD", "K2001/3 3a"] {
        assert!(text.contains(line), "{line} is missing in\n{text}");
    }
}

#[test]
fn what_the_limits_alone_would_call_good_is_not_valid() {
    let report = report(vec![undecided(), out_of_position(), corrected()]);
    let file = bytes("dfq", &report, Language::En);
    let items = read_back("r.dfq", &file);
    let values = values(&items);
    assert_eq!(values.len(), 1, "{values:?}");
    assert!(values[0].starts_with("Warm 25.010274 "), "{values:?}");
    let text = String::from_utf8(file).unwrap();
    for part in [
        "K0002/1 255",
        "K0009/1 RE-MEASURE; in a guard band of the rule",
        "K2106/1 0.0030",
        "K0002/2 255",
        "K0009/2 SIMULATED SCRAP",
        "K0002/3 0",
        "corrected to 20 °C, measured 25.012 mm",
    ] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    assert!(text.starts_with('\u{feff}'), "a degree sign is no ASCII");
}

#[test]
fn no_name_becomes_a_line_or_a_field() {
    let file = bytes("dfq", &hostile(), Language::En);
    let text = String::from_utf8(file.clone()).unwrap();
    let text = text.strip_prefix('\u{feff}').unwrap();
    assert!(text.lines().all(|line| line.starts_with('K') && line.get(5..6).is_some_and(|c| c == "/" || c == " ")));
    assert!(!text.contains(['\u{f}', '\u{14}', '\0', '\u{1b}', '\u{202e}']));
    let longest = |key: &str, most: usize| {
        let texts = text.lines().filter(|line| line.starts_with(key)).filter_map(|line| line.split_once(' '));
        assert!(texts.clone().count() > 0 && texts.clone().all(|(_, text)| text.chars().count() <= most), "{key}");
    };
    longest("K1001", 30);
    longest("K1900", 255);
    longest("K2002", 80);
    longest("K0009", 255);
    let items = read_back("r.dfq", &file);
    let evil = super::lots::EVIL.len();
    assert_eq!(values(&items).len(), 3 * evil + evil, "{:#?}", values(&items));
    assert!(values(&items).iter().all(|value| !value.starts_with("error")));
}

#[test]
fn the_language_changes_nothing() {
    let all = Language::all().map(|language| bytes("dfq", &lot(), language));
    assert_eq!(all.collect::<std::collections::BTreeSet<_>>().len(), 1);
}
