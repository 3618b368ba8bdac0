//! Verdicts of one value, by hand: every border, what to remove, the position, and values that look like another quantity.

use fitcheck::length::Length;
use fitcheck::tolerance::{Bounds, Deviations, Feature, Limits, Sources};
use fitcheck::verdict::{AxisPosition, Doubt, PositionVerdict, Status, classify, doubt, doubt_of, judge, judge_size};
use proptest::prelude::*;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn limits(callout: &str) -> Limits {
    Sources::default().limits(&callout.parse().unwrap(), None).unwrap()
}

/// Status, distances from both limits, and what to remove to the limit and to the middle.
fn said(callout: &str, measured: &str) -> String {
    let size = judge_size(&limits(callout), mm(measured));
    let removal =
        size.removal.map_or(String::new(), |removal| format!(" -{} -{}", removal.to_limit, removal.to_middle));
    format!("{} {} {} {}{removal}", size.status.word(), size.deviation, size.above_minimum, size.below_maximum)
}

#[test]
fn a_value_on_a_limit_is_good_and_a_nanometre_beyond_it_is_not() {
    // 25 H7 from 25.000 to 25.021, 25 g6 from 24.980 to 24.993: ISO 286-2:2010, tables 6 and 18.
    for (callout, measured, expected) in [
        ("25 H7", "25", "GOOD 0 0 0.021"),
        ("25 H7", "25.021", "GOOD 0.021 0.021 0"),
        ("25 H7", "24.999999", "REWORK -0.000001 -0.000001 0.021001 -0.000001 -0.010501"),
        ("25 H7", "25.021001", "SCRAP 0.021001 0.021001 -0.000001"),
        ("25 g6", "24.98", "GOOD -0.02 0 0.013"),
        ("25 g6", "24.993", "GOOD -0.007 0.013 0"),
        ("25 g6", "24.979999", "SCRAP -0.020001 -0.000001 0.013001"),
        ("25 g6", "25", "REWORK 0 0.02 -0.007 -0.007 -0.0135"),
    ] {
        assert_eq!(said(callout, measured), expected, "{callout} {measured}");
    }
}

#[test]
fn a_status_has_one_word_for_machines_in_every_format() {
    for status in Status::ALL {
        assert_eq!(serde_json::to_value(status).unwrap(), status.word());
    }
    // The worst of several parts is the largest.
    assert!(Status::ALL.is_sorted());
}

/// The centre's position: each axis' deviation and what is permitted, in mm.
fn position(axes: [(&str, Option<&str>); 2]) -> PositionVerdict {
    PositionVerdict {
        axes: axes
            .map(|(deviation, tolerance)| AxisPosition { deviation: mm(deviation), tolerance: tolerance.map(mm) }),
    }
}

#[test]
fn a_centre_is_out_only_beyond_what_its_axis_permits() {
    for (axes, is_monitored, is_out) in [
        ([("9", None), ("-9", None)], false, false),
        ([("0.1", Some("0.1")), ("9", None)], true, false),
        ([("9", None), ("-0.1", Some("0.1"))], true, false),
        ([("-0.100001", Some("0.1")), ("0", None)], true, true),
        ([("0", Some("0.1")), ("0.100001", Some("0.1"))], true, true),
    ] {
        let position = position(axes);
        assert_eq!((position.is_monitored(), position.is_out()), (is_monitored, is_out), "{axes:?}");
        let status = judge(&limits("25 H7"), mm("25.01"), Some(position)).status();
        assert_eq!(status, if is_out { Status::Scrap } else { Status::Good }, "{axes:?}");
    }
}

#[test]
fn a_value_that_looks_like_another_quantity_is_named_with_what_it_may_have_been() {
    let inch = |text: &str| Doubt::TimesInch { meant: (!text.is_empty()).then(|| mm(text)) };
    let inches = |text: &str| Doubt::Inches { meant: (!text.is_empty()).then(|| mm(text)) };
    let double = |text: &str| Doubt::Double { meant: (!text.is_empty()).then(|| mm(text)) };
    let half = |text: &str| Doubt::Half { meant: Some(mm(text)) };
    let sign = |text: &str| Doubt::DecimalSign { meant: mm(text) };
    let far = |text: &str| Doubt::Far { distance: mm(text) };
    for (callout, measured, expected) in [
        ("25 H7", "25.012", None),
        // 25.4 times 25 mm and 1 % of it.
        ("25 H7", "635.3048", Some(inch("25.012"))),
        ("25 H7", "635.3049", Some(inch(""))),
        ("25 H7", "641.35", Some(inch("25.25"))),
        ("25 H7", "628.65", Some(inch("24.75"))),
        ("25 H7", "641.350001", Some(far("616.329001"))),
        ("25 H7", "628.649999", Some(far("603.628999"))),
        ("25 H7", "0.984725", Some(inches("25.012015"))),
        ("25 H7", "0.984724", Some(inches(""))),
        ("25 H7", "50.024", Some(double("25.012"))),
        ("25 H7", "50.024001", Some(double(""))),
        ("25 H7", "49.5", Some(double("24.75"))),
        ("25 H7", "49.499999", Some(far("24.478999"))),
        ("25 H7", "12.506", Some(half("25.012"))),
        ("25 H7", "12.375", Some(half("24.75"))),
        ("25 H7", "12.374999", Some(far("12.625001"))),
        ("25 H7", "250.12", Some(sign("25.012"))),
        ("25 H7", "2.5012", Some(sign("25.012"))),
        ("25 H7", "25012", Some(sign("25.012"))),
        ("25 H7", "25012000", Some(sign("25.012"))),
        ("25 H7", "0.000025", Some(sign("25"))),
        // A tenth of it is no whole nanometre.
        ("25 H7", "250.120001", Some(far("225.099001"))),
        // The seventh place is none that a sign slips to.
        ("30 H7", "0.000003", Some(far("29.999997"))),
        // 2 % of the nominal size, which is more than ten tolerances.
        ("25 H7", "25.521", None),
        ("25 H7", "25.521001", Some(far("0.500001"))),
        ("25 H7", "24.5", None),
        ("25 H7", "24.499999", Some(far("0.500001"))),
        // Ten tolerances of 0.25 mm, which are more than 2 %.
        ("3 H14", "5.75", None),
        ("3 H14", "5.750001", Some(far("2.500001"))),
    ] {
        let found = doubt(&limits(callout), mm(measured));
        assert_eq!(found, expected, "{callout} {measured}");
        let meant = match expected {
            Some(Doubt::DecimalSign { meant }) => Some(meant),
            Some(
                Doubt::TimesInch { meant } | Doubt::Inches { meant } | Doubt::Double { meant } | Doubt::Half { meant },
            ) => meant,
            // Only a plan says what can be.
            Some(Doubt::Far { .. } | Doubt::Implausible { .. }) | None => None,
        };
        assert_eq!(found.and_then(Doubt::meant), meant, "{callout} {measured}");
    }
}

#[test]
fn a_length_between_limits_that_are_far_apart_is_no_other_quantity() {
    let between = |feature: Option<Feature>, low: &str, width: &str| {
        Bounds::new(feature, mm(low), Deviations::new(mm(width), Length::ZERO).unwrap()).unwrap()
    };
    let chamfer = between(None, "0.5", "2");
    for measured in ["0.5", "1", "0.25", "2.5"] {
        let doubt = doubt_of(&chamfer, mm(measured));
        assert_eq!(doubt.is_some(), measured == "0.25", "{measured}: {doubt:?}");
    }
    assert!(doubt_of(&chamfer, mm("5")).is_some(), "outside, ten times the lower limit");
    assert!(doubt_of(&between(Some(Feature::Hole), "0.5", "2"), mm("1")).is_some(), "a hole has a size");
    let coordinate = between(None, "-0.1", "0.2");
    assert!(
        ["-0.05", "-0.2", "-1"]
            .iter()
            .all(|at| !matches!(doubt_of(&coordinate, mm(at)), Some(Doubt::Half { .. } | Doubt::Double { .. })))
    );
}

proptest! {
    #[test]
    fn a_hole_and_a_shaft_mirror_each_other(minimum in -99_i64..99, width in 0_i64..99, measured in -299_i64..299) {
        let nm = |number| Length::from_nanometres(number).unwrap();
        let (low, high) = (nm(minimum), nm(minimum + width));
        let hole = classify(Some(Feature::Hole), low, high, nm(measured));
        let shaft = classify(Some(Feature::Shaft), high.negated(), low.negated(), nm(-measured));
        prop_assert_eq!(hole, shaft);
        let is_within = (minimum..=minimum + width).contains(&measured);
        prop_assert_eq!(hole == Status::Good, is_within);
        // What is neither is good within the same limits, and out of them on either side.
        let neither = classify(None, low, high, nm(measured));
        prop_assert_eq!(neither, if is_within { Status::Good } else { Status::OutOfLimits });
    }
}
