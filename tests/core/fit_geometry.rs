//! Hole and shaft as geometry: the kind at its limits, what is not a fit, and what measured parts do in it.

use fitcheck::length::Length;
use fitcheck::tolerance::fit::{Fit, FitKind};
use fitcheck::tolerance::{Deviations, Feature, Limits, Source};
use fitcheck::verdict::Status;
use fitcheck::verdict::fit::{Actual, Possible};

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn limits(feature: Feature, nominal: &str, upper: &str, lower: &str) -> Limits {
    let deviations = Deviations::new(mm(upper), mm(lower)).unwrap();
    Limits::new(feature, mm(nominal), deviations, Source::File("drawing".into())).unwrap()
}

fn fit(hole: (&str, &str), shaft: (&str, &str)) -> Fit {
    let hole = limits(Feature::Hole, "25", hole.0, hole.1);
    Fit::new(hole, limits(Feature::Shaft, "25", shaft.0, shaft.1)).unwrap()
}

#[test]
fn zero_counts_as_clearance_at_the_least_and_as_interference_at_the_most() {
    #[track_caller]
    fn check(hole: (&str, &str), shaft: (&str, &str), kind: FitKind) {
        assert_eq!(fit(hole, shaft).kind(), kind);
    }
    check(("0.021", "0"), ("0", "-0.013"), FitKind::Clearance);
    check(("0.021", "0"), ("0.000001", "-0.013"), FitKind::Transition);
    check(("0.021", "0"), ("0.034", "0.021"), FitKind::Interference);
    check(("0.021", "0"), ("0.034", "0.020999"), FitKind::Transition);
    check(("0", "0"), ("0", "0"), FitKind::Clearance);
    check(("0", "-0.000001"), ("0", "0"), FitKind::Interference);
}

#[test]
fn what_is_no_fit_is_refused() {
    let hole = |nominal| limits(Feature::Hole, nominal, "0.021", "0");
    let shaft = |nominal| limits(Feature::Shaft, nominal, "0", "-0.013");
    let error = |hole, shaft| Fit::new(hole, shaft).unwrap_err().to_string();
    assert_eq!(error(shaft("25"), shaft("25")), "24.987 to 25 mm are the limits of a shaft: expected those of a hole");
    assert_eq!(error(hole("25"), hole("25")), "25 to 25.021 mm are the limits of a hole: expected those of a shaft");
    let nominal = error(hole("25"), shaft("25.000001"));
    assert_eq!(nominal, "a fit has one nominal size: the hole has 25 mm, the shaft 25.000001 mm");
    let far = limits(Feature::Hole, "25", "999999000", "0");
    let low = limits(Feature::Shaft, "25", "0", "-999999000");
    assert_eq!(error(far, low), "the clearance is too large");
}

#[test]
fn two_measured_parts_have_a_clearance_and_a_verdict_each() {
    let fit = fit(("0.021", "0"), ("-0.007", "-0.020"));
    let actual = Actual::of(&fit, mm("25.0210"), mm("24.98"));
    assert_eq!((actual.clearance, actual.conforms, actual.status()), (mm("0.041"), true, Status::Good));
    // Both parts are out to the same side: the clearance conforms and the parts do not.
    let actual = Actual::of(&fit, mm("25.031"), mm("25.003"));
    assert_eq!((actual.clearance, actual.conforms), (mm("0.028"), true));
    assert_eq!((actual.hole_verdict.status(), actual.shaft_verdict.status()), (Status::Scrap, Status::Rework));
    assert_eq!(actual.status(), Status::Scrap);
    assert!(!Actual::of(&fit, mm("25.021001"), mm("24.98")).conforms);
    assert!(fit.allows(mm("0.007")) && !fit.allows(mm("0.006999")));
}

#[test]
fn one_measured_part_leaves_a_range() {
    let fit = fit(("0.021", "0"), ("-0.007", "-0.020"));
    let hole = Possible::of(&fit, Feature::Hole, mm("25.010"));
    assert_eq!((hole.minimum, hole.maximum, hole.verdict.status()), (mm("0.017"), mm("0.030"), Status::Good));
    let shaft = Possible::of(&fit, Feature::Shaft, mm("24.979"));
    assert_eq!((shaft.minimum, shaft.maximum, shaft.verdict.status()), (mm("0.021"), mm("0.042"), Status::Scrap));
}
