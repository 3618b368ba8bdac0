//! Callouts, cycle texts and general tolerances, against the samples and the published table.

#![cfg(test)]

use std::path::Path;

use fitcheck::length::Length;
use fitcheck::tolerance::callout::{halves, qs400};
use fitcheck::tolerance::iso2768::{self, GeneralClass};
use fitcheck::tolerance::{Callout, CycleText, Deviations, Feature, Sources, ToleranceClass};
use proptest::prelude::*;

/// ISO 2768-1, linear sizes: over, up to, and the deviations of f, m, c and v, in millimetres.
const GENERAL: &str = "\
0.5 3 0.05 0.1 0.2 -
3 6 0.05 0.1 0.3 0.5
6 30 0.1 0.2 0.5 1.0
30 120 0.15 0.3 0.8 1.5
120 400 0.2 0.5 1.2 2.5
400 1000 0.3 0.8 2.0 4.0
1000 2000 0.5 1.2 3.0 6.0
2000 4000 - 2.0 4.0 8.0";

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn nanometres(nm: i64) -> Length {
    Length::from_nanometres(nm).unwrap()
}

/// The half width of a general tolerance and its range, or `None` where it is refused.
fn general(class: GeneralClass, nominal: Length) -> Option<(Length, Length, Length)> {
    let cell = iso2768::deviations(class, nominal).ok()?;
    assert_eq!(cell.deviations.upper(), cell.deviations.lower().negated());
    Some((cell.deviations.upper(), cell.over, cell.to))
}

#[test]
fn every_general_tolerance_is_the_published_one() {
    for row in GENERAL.lines() {
        let cells: Vec<&str> = row.split(' ').collect();
        let (over, to) = (mm(cells[0]), mm(cells[1]));
        let first = if over == mm("0.5") { over } else { nanometres(over.nanometres() + 1) };
        for (class, cell) in GeneralClass::ALL.into_iter().zip(&cells[2..]) {
            let expected = (*cell != "-").then(|| (mm(cell), over, to));
            for nominal in [first, over.midpoint(to), nanometres(to.nanometres() - 1), to] {
                assert_eq!(general(class, nominal), expected, "{nominal}{class}");
            }
        }
    }
}

#[test]
fn general_tolerances_begin_at_half_a_millimetre_and_end_at_four_metres() {
    for class in GeneralClass::ALL {
        for outside in ["-1", "0", "0.4", "0.499999", "4000.000001", "1000000000"] {
            assert_eq!(general(class, mm(outside)), None, "{outside}{class}");
        }
    }
    assert!(general(GeneralClass::Fine, mm("0.5")).is_some() && general(GeneralClass::Coarse, mm("4000")).is_some());
}

/// A row of the samples.
pub struct Sample {
    pub text: String,
    pub nominal: Option<Length>,
    /// Upper and lower; `None` where the text is refused or means no tolerance.
    pub band: Option<(Length, Length)>,
    remark: String,
}

pub fn samples(kind: &str) -> Vec<Sample> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/tolerance_texts.csv");
    let mut reader = csv::Reader::from_path(path).unwrap();
    let rows = reader.records().map(Result::unwrap).filter(|row| &row[1] == kind);
    let length = |cell: &str| (!cell.is_empty()).then(|| mm(cell));
    let sample = |row: csv::StringRecord| Sample {
        text: row[0].to_owned(),
        nominal: length(&row[2]),
        band: length(&row[3]).zip(length(&row[4])),
        remark: row[5].to_owned(),
    };
    rows.map(sample).collect()
}

/// The deviations of a callout: its own, or those of ISO 2768-1 or of ISO 286.
fn deviations(callout: &Callout) -> Result<Option<(Length, Length)>, String> {
    let found = Sources::default().deviations(callout, None).map_err(|error| error.to_string())?;
    Ok(Some((found.0.upper(), found.0.lower())))
}

#[test]
fn every_sample_of_a_callout_reads_as_it_should() {
    let samples = samples("callout");
    assert_eq!(samples.len(), 19);
    for Sample { text, nominal, band, remark } in samples {
        let read = text.parse::<Callout>().map_err(|error| error.to_string());
        let found = read.as_ref().map_err(Clone::clone).and_then(deviations);
        if remark.starts_with("refuse") || remark.contains("ambiguous") {
            let error = found.unwrap_err();
            let hint = match text.as_str() {
                "8-2-1" => "write 8 -1 -2",
                "0.4m" => "is below 0.5 mm, where ISO 2768-1 begins",
                "3v" => "ISO 2768-1 does not define class v from 0.5 up to 3 mm",
                "2500f" => "ISO 2768-1 does not define class f over 2000 up to 4000 mm",
                _ => "1.234,5 is ambiguous",
            };
            assert!(error.contains(hint), "{text}: {error}");
            continue;
        }
        let callout = read.unwrap();
        assert_eq!(Some(callout.nominal()), nominal, "{text}");
        assert_eq!(found.unwrap(), band, "{text}");
    }
}

#[test]
fn every_sample_of_qs400_reads_as_it_should() {
    let samples = samples("QS400");
    assert_eq!(samples.len(), 7);
    for Sample { text, band, .. } in samples {
        let found = qs400(&text).unwrap();
        assert_eq!(found.map(|found| (found.upper(), found.lower())), band, "{text}");
    }
}

#[test]
fn every_sample_of_a_cycle_text_reads_as_it_should() {
    let samples = samples("14xx");
    assert_eq!(samples.len(), 3);
    for Sample { text, nominal, band, .. } in samples {
        let read: CycleText = text.parse().unwrap();
        let callout = read.callout().unwrap();
        assert_eq!((read.nominal(), Some(callout.nominal())), (nominal, nominal), "{text}");
        assert_eq!(read.position_unknown, text.starts_with('?'));
        assert_eq!(read.actual, text.contains('@').then(|| mm("10.004")));
        assert_eq!(deviations(&callout).unwrap(), band, "{text}");
    }
}

fn any_size() -> impl Strategy<Value = Length> {
    prop_oneof![1_i64..5_000_000_000, 1_i64..1_000_000, Just(1_000_000_000_000_000)].prop_map(nanometres)
}

fn any_class(letters: &'static str) -> impl Strategy<Value = ToleranceClass> {
    letters.prop_map(|class| class.parse().unwrap())
}

/// Callouts of every kind.
fn any_callout() -> impl Strategy<Value = Callout> {
    let bound = -3_000_000_i64..3_000_000;
    let (hole, shaft) = ("[A-Z]{1,2}[0-9]{1,2}", "[a-z]{1,2}[0-9]{1,2}");
    let class = (any_size(), prop_oneof![any_class(hole), any_class(shaft)])
        .prop_map(|(size, class)| Callout::new(size, class));
    let fit =
        (any_size(), any_class(hole), any_class(shaft)).prop_map(|(size, hole, shaft)| Callout::fit(size, hole, shaft));
    let general = (any_size(), prop::sample::select(&GeneralClass::ALL[..]))
        .prop_map(|(size, class)| Callout::general(size, class));
    let band = (any_size(), bound.clone(), prop_oneof![bound, Just(0)]).prop_map(|(size, one, other)| {
        let band = Deviations::new(nanometres(one.max(other)), nanometres(one.min(other))).unwrap();
        Callout::with_deviations(size, band)
    });
    let symmetric = (any_size(), 0_i64..3_000_000).prop_map(|(size, half)| {
        Callout::with_deviations(size, Deviations::new(nanometres(half), nanometres(-half)).unwrap())
    });
    let limits = (any_size(), any_size()).prop_map(|(one, other)| Callout::with_limits(one.max(other), one.min(other)));
    let any = prop_oneof![class.boxed(), fit.boxed(), general.boxed(), band.boxed(), symmetric.boxed(), limits.boxed()];
    any.prop_filter_map("refused", Result::ok)
}

/// Texts of the characters that callouts are made of.
const ALMOST: &str = "[0-9.,+\\-/ ±?@ØHhgmfM\u{2212}\u{2013}µx]{0,16}";

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn what_is_printed_reads_as_the_same_callout(callout in any_callout()) {
        let text = callout.to_string();
        prop_assert_eq!(text.parse::<Callout>(), Ok(callout), "{}", text);
        prop_assert_eq!(text.replace('.', ",").parse::<Callout>(), Ok(callout), "{}", text);
    }

    #[test]
    fn a_callout_written_for_a_cycle_reads_as_the_same_callout(callout in any_callout()) {
        if let Ok(text) = callout.to_string().parse::<CycleText>() {
            prop_assert_eq!(text.callout(), Some(callout));
            prop_assert_eq!(text.to_string().parse::<CycleText>(), Ok(text), "{}", text);
        }
    }

    #[test]
    fn whatever_is_typed_reads_stably_or_is_refused_at_its_characters(text in ALMOST) {
        match text.parse::<Callout>() {
            Ok(callout) => prop_assert_eq!(callout.to_string().parse::<Callout>(), Ok(callout), "{:?}", text),
            Err(error) => {
                let span = error.span().unwrap();
                prop_assert!(span.start <= span.end && span.end <= text.chars().count(), "{:?}: {:?}", text, error);
            }
        }
        if let Ok(read) = text.parse::<CycleText>() {
            prop_assert_eq!(read.to_string().parse::<CycleText>(), Ok(read), "{:?}", text);
        }
        drop(qs400(&text));
    }

    #[test]
    fn no_text_makes_reading_fail_otherwise(text in ".{0,60}") {
        drop((text.parse::<Callout>(), text.parse::<CycleText>(), qs400(&text)));
    }
}

#[track_caller]
fn check_general(size: &str, letter: &str, expected: &str) {
    let said = match iso2768::deviations(GeneralClass::from_letter(letter).unwrap(), size.parse().unwrap()) {
        Ok(cell) => format!("±{} over {} up to {}", cell.deviations.upper(), cell.over, cell.to),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected, "for {size}{letter}");
}

#[test]
fn a_size_has_the_tolerance_of_its_range() {
    check_general("10", "f", "±0.1 over 6 up to 30");
    check_general("0.5", "m", "±0.1 over 0.5 up to 3");
    check_general("4000", "v", "±8 over 2000 up to 4000");
}

#[test]
fn one_side_of_a_fit_is_a_callout_of_one_part() {
    for (callout, hole, shaft) in [
        ("25 H7/g6", "25 H7", "25 g6"),
        ("25 H7", "25 H7", "25 H7"),
        ("12 +0.2 0", "12 +0.2 0", "12 +0.2 0"),
        ("10m", "10m", "10m"),
    ] {
        let callout: Callout = callout.parse().unwrap();
        let part = |feature| callout.of_part(feature).to_string();
        assert_eq!([part(Feature::Hole), part(Feature::Shaft)], [hole, shaft], "{callout}");
    }
}

#[test]
fn refusals_say_where_the_class_is_defined() {
    check_general(
        "0.499999",
        "m",
        "nominal size 0.499999 mm is below 0.5 mm, where ISO 2768-1 begins: write the deviations next to the size",
    );
    check_general(
        "3",
        "v",
        "ISO 2768-1 does not define class v from 0.5 up to 3 mm; it is defined over 3 up to 4000 mm",
    );
    check_general(
        "2500",
        "f",
        "ISO 2768-1 does not define class f over 2000 up to 4000 mm; it is defined from 0.5 up to 2000 mm",
    );
    check_general("4000.000001", "m", "nominal size 4000.000001 mm is beyond ISO 2768-1, which ends at 4000 mm");
}

#[test]
fn a_callout_is_taken_apart_while_it_is_typed() {
    for (text, nominal, class) in [
        ("25 H7", "25", "H7"),
        ("Ø25,5js6", "25,5", "js6"),
        ("25", "25", ""),
        ("H7", "", "H7"),
        ("12 +0.1 -0.2", "12", "+0.1 -0.2"),
        ("", "", ""),
    ] {
        assert_eq!(halves(text), (nominal, class), "for {text:?}");
    }
}
