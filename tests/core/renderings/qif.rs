//! QIF: what our own reader reads back, the structure, and that only a measured good value is a pass. `tests/attack/readers` validates files
//! against the schema of the format, with a validator of others.

use super::dfq::{read_back, values, warnings};
use super::lots::{bytes, corrected, hostile, lot, undecided};
use super::*;

fn file(report: &Report) -> String {
    String::from_utf8(bytes("qif", report, Language::En)).unwrap()
}

/// The texts of all elements of a name.
fn texts<'t>(file: &'t str, name: &str) -> Vec<&'t str> {
    let begin = format!("<{name}>");
    file.split(begin.as_str()).skip(1).filter_map(|rest| rest.split('<').next()).collect()
}

/// Every number of a thing, and every number that refers to one.
fn numbers(file: &str) -> (Vec<usize>, Vec<usize>) {
    let ids = file.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()?.parse().ok()).collect();
    let is_reference = |name: &str| name.ends_with("Id") && !name.starts_with('/') && name != "QPId";
    let elements = file.split('<').filter_map(|part| part.split_once('>'));
    let references = elements.filter(|(name, _)| is_reference(name)).map(|(_, text)| text.trim().parse().unwrap());
    let references = references.collect();
    (ids, references)
}

#[test]
fn numbers_are_unique_and_whatever_refers_to_one_finds_it() {
    for report in [report(vec![good(), rework(), out_of_position(), undecided()]), lot(), hostile(), report(vec![])] {
        let file = file(&report);
        let (mut ids, references) = numbers(&file);
        assert!(references.iter().all(|id| ids.contains(id)), "{file}");
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count, "{file}");
        let most: usize = file.split("idMax=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
        assert!(ids.last().is_some_and(|last| *last <= most), "{file}");
        // Lists say how many they have.
        for list in ["MeasurementResultsSet", "CharacteristicItems", "FeatureItems", "ActualComponentSet"] {
            let Some((_, rest)) = file.split_once(&format!("<{list} n=\"")) else { continue };
            let (said, rest) = rest.split_once('"').unwrap();
            let inside = rest.split(&format!("</{list}>")).next().unwrap();
            assert_eq!(inside.matches(" id=\"").count().min(1), said.parse::<usize>().unwrap().min(1), "{list}");
        }
    }
}

#[test]
fn our_reader_has_the_same_values_limits_and_verdicts() {
    let report = report(vec![good(), rework(), scrap(), typed("25.012346")]);
    let items = read_back("r.qif", file(&report).as_bytes());
    assert_eq!(
        values(&items),
        [
            "Bore A 25.012 25..25.021 GOOD 2026-11-21T10:42:07 []",
            "25 H7 24.998 25..25.021 REWORK 2026-11-21T10:43:00 []",
            "Bore C 25.03 25..25.021 SCRAP 2026-11-21T10:43:30 []",
            "25 H7 25.012346 25..25.021 GOOD 2026-11-21T10:42:07 []",
        ]
    );
    // One of them is scrap, and so is the whole, as far as QIF has one.
    assert_eq!(warnings(&items), ["the file says FAIL about the whole part"; 2]);
}

#[test]
fn parts_have_serial_numbers_and_a_status() {
    let file = file(&lot());
    let items = read_back("r.qif", file.as_bytes());
    let time = "2026-11-21T10:42:07";
    let found = values(&items);
    let good: Vec<&String> = found.iter().filter(|value| value.contains("..")).collect();
    assert_eq!(
        good,
        [
            &format!("BORE_A 25.012 25..25.021 GOOD {time} [17]"),
            &format!("SEAT 19.9901 19.98..19.993 GOOD {time} [17]"),
            &format!("SLOT 12.02 12..12.043 GOOD {time} [17]"),
            &format!("BORE_A 25.012 25..25.021 GOOD {time} [18]"),
            &format!("BORE_A 25.1 25..25.021 SCRAP {time} [19]"),
            &format!("SEAT 19.9901 19.98..19.993 GOOD {time} [19]"),
            &format!("SLOT 12.02 12..12.043 GOOD {time} [19]"),
            &"25 H7 24.998 25..25.021 REWORK 2026-11-21T10:43:00 []".to_owned(),
        ],
        "{found:#?}"
    );
    let expected = ["PASS", "UNKNOWN", "FAIL", "UNKNOWN", "REWORK"];
    // Once with the results, once with the parts.
    assert_eq!(texts(&file, "InspectionStatusEnum"), [expected, expected].concat());
    assert_eq!(texts(&file, "SerialNumber"), ["17", "18", "19", "20"]);
    assert!(file.contains("<OppositeParallelLinesFeatureNominal") && file.contains("<Location>40 30.5 -8</Location>"));
    assert!(file.contains("<AttributeStr name=\"reason\" value=\"left out: no gauge\"/>"), "{file}");
}

#[test]
fn nothing_but_a_measured_good_value_is_a_pass() {
    let file = file(&report(vec![good(), undecided(), out_of_position(), corrected()]));
    let statuses = texts(&file, "CharacteristicStatusEnum");
    assert_eq!(statuses, ["PASS", "INDETERMINATE", "NOT_ANALYZED", "PASS"]);
    assert_eq!(texts(&file, "InspectionStatusEnum"), ["UNKNOWN", "UNKNOWN"]);
    for text in [
        "value=\"SIMULATED SCRAP",
        "<Value combinedUncertainty=\"0.0015\" meanError=\"0\">25.0205</Value>",
        "name=\"simulated\" value=\"true\"",
        "name=\"measured before the correction to 20 °C, mm\" value=\"25.012\"",
        "<Location validity=\"DUMMY\">0 0 0</Location>",
    ] {
        assert!(file.contains(text), "{text} is missing in\n{file}");
    }
    // A place that stands there because one has to is none for our reader.
    for item in read_back("r.qif", file.as_bytes()) {
        if let fitcheck::exchange::Item::Record { labels, .. } = item {
            assert_eq!(labels.place, [None; 3]);
        }
    }
}

#[test]
fn the_name_of_a_file_is_that_of_its_content() {
    let name = |report: &Report| texts(&file(report), "QPId")[0].to_owned();
    let one = name(&report(vec![good()]));
    assert_eq!(one, name(&report(vec![good()])));
    assert_ne!(one, name(&report(vec![rework()])));
    assert_ne!(one, name(&Report { order: Some("2".to_owned()), ..report(vec![good()]) }));
    assert_eq!(one.split('-').map(str::len).collect::<Vec<_>>(), [8, 4, 4, 4, 12]);
}

#[test]
fn no_name_becomes_an_element() {
    let file = file(&hostile());
    assert!(!file.contains("<script") && !file.contains("]]>") && !file.contains(['\0', '\u{1b}', '\u{202e}']));
    let items = read_back("r.qif", file.as_bytes());
    let evil = super::lots::EVIL.len();
    assert_eq!(values(&items).iter().filter(|value| value.contains("..")).count(), 4 * evil, "{:#?}", values(&items));
}

#[test]
fn the_language_changes_nothing() {
    let all = Language::all().map(|language| bytes("qif", &lot(), language));
    assert_eq!(all.collect::<std::collections::BTreeSet<_>>().len(), 1);
}
