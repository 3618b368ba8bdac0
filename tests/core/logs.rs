//! Compares measuring logs with `tests/data/samples/logs/expected.csv`, column by column.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use fitcheck::control::log::{self, Figure, Log};
use fitcheck::exchange::{Imported, WhyUnjudged, import};
use fitcheck::journal::Record;
use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::{Feature, Source, Sources};
use fitcheck::verdict::Status;

/// One line of the expected values, by column.
type Expected = HashMap<String, String>;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs")
}

fn expected() -> Vec<Expected> {
    csv::Reader::from_path(folder().join("expected.csv")).unwrap().deserialize().collect::<Result<_, _>>().unwrap()
}

fn imported(bytes: &[u8]) -> Imported {
    import("log.txt", bytes, &Sources::default(), jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0))
}

/// Every expected line with its log: the second line of a file is the file's second log.
fn each(check: impl Fn(&Expected, &Log, &Imported, usize)) {
    let mut seen: HashMap<String, usize> = HashMap::new();
    for expected in expected() {
        let file = &expected["file"];
        let number = seen.entry(file.clone()).or_default();
        let bytes = std::fs::read(folder().join(file)).unwrap();
        let logs: Vec<Log> = log::read(&bytes).into_iter().collect::<Result<_, _>>().unwrap();
        check(&expected, &logs[*number], &imported(&bytes), *number);
        *number += 1;
    }
    assert_eq!(seen.len(), 18, "files");
    assert_eq!(seen.values().sum::<usize>(), 19, "logs");
}

/// A column's value in the log's own unit; `None` where it is empty.
fn value(expected: &Expected, column: &str, unit: Unit) -> Option<Length> {
    Some(&expected[column]).filter(|text| !text.is_empty()).map(|text| Length::parse_in(text, unit).unwrap())
}

fn status(expected: &Expected) -> Status {
    [Status::Good, Status::Rework, Status::Scrap].into_iter().find(|s| s.word() == expected["status"]).unwrap()
}

/// Centre and diameter; `None` for a coordinate.
fn circle(log: &Log) -> Option<[Figure; 3]> {
    log.figures.clone().try_into().ok()
}

#[test]
fn figures_are_those_of_the_log() {
    each(|expected, log, _, _| {
        let file = &expected["file"];
        let of = |column: &str| value(expected, column, log.unit);
        assert_eq!(log.cycle.to_string(), expected["cycle"], "{file}");
        assert_eq!(if log.unit == Unit::Inch { "INCH" } else { "MM" }, expected["unit"], "{file}");
        let Some([centre_1, centre_2, diameter]) = circle(log) else {
            let [coordinate] = log.figures[..] else { panic!("{file}") };
            let limits = coordinate.limits.unwrap();
            assert_eq!(coordinate.nominal, of("nominal"), "{file}");
            assert_eq!(Some(limits.minimum), of("minimum"), "{file}");
            assert_eq!(Some(limits.maximum), of("maximum"), "{file}");
            assert_eq!(Some(coordinate.actual), of("actual"), "{file}");
            return;
        };
        let limits = diameter.limits.unwrap();
        assert_eq!(diameter.nominal, of("nominal"), "{file}");
        assert_eq!(Some(limits.minimum), of("minimum"), "{file}");
        assert_eq!(Some(limits.maximum), of("maximum"), "{file}");
        assert_eq!(Some(diameter.actual), of("actual"), "{file}");
        assert_eq!(diameter.actual.checked_sub(diameter.nominal.unwrap()), of("deviation"), "{file}");
        for (axis, number) in [(centre_1, 1), (centre_2, 2)] {
            let (actual, nominal) = (axis.actual, axis.nominal.unwrap());
            assert_eq!(actual.checked_sub(nominal), of(&format!("centre_{number}_deviation")), "{file}");
            let limits = axis.limits.unwrap();
            let tolerance = of(&format!("centre_{number}_tolerance"));
            assert_eq!(limits.maximum.checked_sub(nominal), tolerance, "{file}");
            assert_eq!(nominal.checked_sub(limits.minimum), tolerance, "{file}");
        }
        if let Some(deviation) = diameter.deviation {
            assert_eq!(Some(deviation), of("deviation"), "{file}");
        }
    });
}

#[test]
fn verdicts_are_the_expected_ones() {
    each(|expected, log, imported, number| {
        let file = &expected["file"];
        assert_eq!(imported.errors, [], "{file}");
        // The column is in micrometres; no inch log has one.
        let remove = value(expected, "remove_um_or_inch", Unit::Micrometre);
        let Some([centre_1, centre_2, _]) = circle(log) else {
            let WhyUnjudged::Coordinate(coordinate) = &imported.unjudged[number].why else { panic!("{file}") };
            assert_eq!(coordinate.status, status(expected), "{file}");
            assert_eq!(coordinate.removal.map(|removal| removal.to_limit), remove, "{file}");
            return;
        };
        let record: &Record = &imported.records[number];
        assert_eq!(imported.lines[number], log.line, "{file}");
        assert_eq!(record.verdict.size.status, status(expected), "{file}");
        assert_eq!(record.verdict.size.removal.map(|removal| removal.to_limit), remove, "{file}");
        let of = |column: &str| value(expected, column, log.unit);
        assert_eq!(Some(record.limits.nominal), of("nominal"), "{file}");
        assert_eq!(Some(record.limits.minimum()), of("minimum"), "{file}");
        assert_eq!(Some(record.limits.maximum()), of("maximum"), "{file}");
        assert_eq!(Some(record.measurement.diameter), of("actual"), "{file}");
        assert_eq!(Some(record.verdict.size.deviation), of("deviation"), "{file}");
        assert_eq!(record.measurement.centre, Some([centre_1.actual, centre_2.actual]), "{file}");
        let position = record.verdict.position.unwrap();
        for (axis, number) in [(0, 1), (1, 2)] {
            assert_eq!(Some(position.axes[axis].deviation), of(&format!("centre_{number}_deviation")), "{file}");
            assert_eq!(position.axes[axis].tolerance, of(&format!("centre_{number}_tolerance")), "{file}");
        }
        assert_eq!(if position.is_out() { "OUT" } else { "IN" }, expected["position"], "{file}");
        let feature = if expected["cycle"] == "421" { Feature::Hole } else { Feature::Shaft };
        assert_eq!(record.limits.feature, Some(feature), "{file}");
        assert_eq!((record.callout, &record.limits.source), (None, &Source::File("log.txt".into())), "{file}");
        assert_eq!(Some(record.time), log.date_time(), "{file}");
    });
}

#[test]
fn only_what_is_odd_is_warned_of() {
    each(|expected, log, _, _| {
        let warnings: Vec<String> = log.warnings.iter().map(|warning| warning.what.to_string()).collect();
        let expected: &[&str] = match expected["file"].as_str() {
            "variants/TCHPR421_without_unit_line.TXT" => &["no line gives the unit: millimetres assumed"],
            "variants/TCHPR421_cut_off.TXT" => &["the deviations are missing: the log may be cut off"],
            _ => &[],
        };
        assert_eq!(warnings, expected, "{}", log.title);
    });
}

/// The sample log with some of its figures replaced.
fn sample(changes: &[(&str, &str)]) -> Vec<u8> {
    let text = std::fs::read_to_string(folder().join("en/TCHPR421.TXT")).unwrap();
    let changed = changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    changed.into_bytes()
}

#[track_caller]
fn check(changes: &[(&str, &str)], expected: (Status, Option<bool>)) {
    let imported = imported(&sample(changes));
    assert_eq!(imported.errors, []);
    let verdict = imported.records[0].verdict;
    let position = verdict.position.filter(fitcheck::verdict::PositionVerdict::is_monitored);
    assert_eq!((verdict.size.status, position.map(|position| position.is_out())), expected);
}

#[test]
fn borders_of_a_log_are_exact() {
    let measured = |figure: &str, deviation: &str, status| {
        check(&[("25.0134", figure), ("0.0134", deviation)], (status, Some(false)));
    };
    measured("25.0000", "0.0000", Status::Good);
    measured("24.999999", "-0.000001", Status::Rework);
    measured("25.0210", "0.0210", Status::Good);
    measured("25.021001", "0.021001", Status::Scrap);
}

#[test]
fn the_centre_is_a_cause_of_its_own() {
    check(&[("40.0120", "40.0500"), (" 0.0120", " 0.0500")], (Status::Good, Some(false)));
    check(&[("40.0120", "40.050001"), (" 0.0120", " 0.0500")], (Status::Good, Some(true)));
    check(&[("29.9910", "29.9499"), ("-0.0090", "-0.0501")], (Status::Good, Some(true)));
    // A centre out of position does not hide what can be removed.
    let both = [("40.0120", "41.0000"), (" 0.0120", " 1.0000"), ("25.0134", "24.9980"), (" 0.0134", "-0.0020")];
    check(&both, (Status::Rework, Some(true)));
}

#[test]
fn a_tolerance_of_zero_is_not_monitored() {
    let zero = [("40.0500", "40.0000"), ("39.9500", "40.0000"), ("30.0500", "30.0000"), ("29.9500", "30.0000")];
    check(&zero, (Status::Good, None));
    check(&zero[..2], (Status::Good, Some(false)));
}

#[test]
fn limits_of_zero_give_no_verdict() {
    let imported = imported(&sample(&[
        ("hole:                        25.0210", "hole: 0"),
        ("hole:                        25.0000", "hole: 0"),
    ]));
    assert_eq!((imported.records.len(), imported.unjudged.len(), imported.errors.len()), (0, 1, 0));
    assert_eq!(imported.unjudged[0].why, WhyUnjudged::NoLimits { nominal: "25".parse().unwrap() });
}
