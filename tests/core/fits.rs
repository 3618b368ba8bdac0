//! Hole and shaft: kinds, preferred and named fits, the other basis.
//!
//! The worked examples and the tables of pairs are those of `docs/SOURCES.md`; the limits come from `iso286`, which
//! other tests compare with transcriptions of the standard.

use fitcheck::length::Length;
use fitcheck::tolerance::fit::equivalent::{Difference, equivalent};
use fitcheck::tolerance::fit::preferred::{Function, Preference, function, preference};
use fitcheck::tolerance::fit::{Basis, Fit, FitError, FitKind, basis};
use fitcheck::tolerance::iso286::{self, Grade, Letter, Options};
use fitcheck::tolerance::{Feature, Limits, Source, Sources, ToleranceClass};
use fitcheck::verdict::Status;
use fitcheck::verdict::fit::Actual;
use proptest::prelude::*;

pub fn class(text: &str) -> ToleranceClass {
    text.parse().unwrap()
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn limits(nominal: Length, class: ToleranceClass) -> Option<Limits> {
    let cell = iso286::deviations(class, nominal, Options::default()).ok()?;
    Limits::new(class.feature(), nominal, cell.deviations, Source::File("ISO 286".into()))
}

/// The fit of two classes, where both are defined.
fn fit_of(nominal: Length, hole: ToleranceClass, shaft: ToleranceClass) -> Option<Fit> {
    Some(Fit::new(limits(nominal, hole)?, limits(nominal, shaft)?).unwrap())
}

fn fit(nominal: &str, pair: &str) -> Fit {
    let (hole, shaft) = pair.split_once('/').unwrap();
    fit_of(mm(nominal), class(hole), class(shaft)).unwrap()
}

fn pair(text: &str) -> (ToleranceClass, ToleranceClass) {
    let (hole, shaft) = text.split_once('/').unwrap();
    (class(hole), class(shaft))
}

/// A size inside each step from 3 to 500 mm and its upper end.
fn sizes() -> Vec<Length> {
    let ends: Vec<Length> = iso286::step_ends().filter(|end| mm("3") <= *end && *end <= mm("500")).collect();
    let mut sizes = Vec::new();
    for step in ends.windows(2) {
        sizes.push(Length::from_nanometres(step[0].nanometres() + 1).unwrap());
        sizes.push(step[1]);
    }
    sizes
}

#[test]
fn worked_examples() {
    #[track_caller]
    fn check(nominal: &str, pair: &str, minimum: &str, maximum: &str, kind: FitKind) {
        let fit = fit(nominal, pair);
        let said = (fit.minimum_clearance().to_string(), fit.maximum_clearance().to_string(), fit.kind());
        assert_eq!(said, (minimum.to_owned(), maximum.to_owned(), kind), "{nominal} {pair}");
    }
    check("25", "H7/g6", "0.007", "0.041", FitKind::Clearance);
    check("25", "H7/k6", "-0.015", "0.019", FitKind::Transition);
    check("50", "H7/p6", "-0.042", "-0.001", FitKind::Interference);
    check("2", "H7/p6", "-0.012", "0.004", FitKind::Transition);
    check("25", "H7/h6", "0", "0.034", FitKind::Clearance);
    check("2", "P7/h6", "-0.016", "0", FitKind::Interference);
    check("3150", "H8/h7", "0", "0.54", FitKind::Clearance);
    check("4", "H01/js01", "-0.0002", "0.0006", FitKind::Transition);
}

#[test]
fn two_measured_parts_are_judged_each_and_together() {
    let actual = Actual::of(&fit("50", "H7/p6"), mm("50.010"), mm("50.030"));
    assert_eq!((actual.clearance, actual.conforms, actual.status()), (mm("-0.020"), true, Status::Good));
    let mean = fit("50", "H7/p6").mean_clearance();
    assert_eq!(mean, mm("-0.0215"));
}

#[test]
fn a_fit_of_a_callout_takes_both_parts_from_the_same_sources() {
    let sources = Sources::default();
    let of = |callout: &str| Fit::of_callout(&callout.parse().unwrap(), &sources);
    // 50 H7 is 50.000 to 50.025, p6 50.026 to 50.042, g6 49.975 to 49.991, k6 50.002 to 50.018.
    for (callout, kind) in [("50 H7/p6", "interference"), ("50 H7/g6", "clearance"), ("50 H7/k6", "transition")] {
        let fit = of(callout).unwrap();
        assert_eq!(fit.kind().word(), kind);
        let parts = fit.parts().map(|(feature, limits)| (feature, limits.feature));
        let [hole, shaft] = [Feature::Hole, Feature::Shaft].map(|feature| (feature, Some(feature)));
        assert_eq!(parts, [hole, shaft], "{callout}");
    }
    for callout in ["50 H7", "50 g6", "50 ±0.1", "50m"] {
        let asked = callout.parse().unwrap();
        assert_eq!(of(callout).unwrap_err(), FitError::OneSided { callout: asked }, "{callout}");
    }
}

#[test]
fn the_basis_is_the_h() {
    for (text, expected) in [
        ("H7/g6", Some(Basis::Hole)),
        ("G7/h6", Some(Basis::Shaft)),
        ("H7/h6", Some(Basis::Both)),
        ("F8/m6", None),
        ("JS7/h6", Some(Basis::Shaft)),
        ("Q7/h6", None),
    ] {
        let (hole, shaft) = pair(text);
        assert_eq!(basis(hole, shaft), expected, "{text}");
        let word = expected.map(Basis::word);
        assert_eq!(word, expected.map(|basis| format!("{basis:?}").to_lowercase()).as_deref(), "{text}");
    }
}

#[test]
fn preferred_fits_are_the_tables_of_iso_286_1() {
    let list = |preference: Preference| -> String {
        let mut lines: Vec<String> = Vec::new();
        let mut before = String::new();
        for (hole, shaft) in preference.fits() {
            let (base, other) = match preference {
                Preference::HoleBasis => (hole, shaft),
                Preference::ShaftBasis => (shaft, hole),
            };
            if before != base.to_string() {
                before = base.to_string();
                lines.push(format!("{base}:"));
            }
            let line = lines.last_mut().unwrap();
            *line = format!("{line} {other}");
        }
        lines.join("\n")
    };
    assert_eq!(
        list(Preference::HoleBasis),
        "H6: g5 h5 js5 k5 m5 n5 p5\n\
         H7: f6 g6 h6 js6 k6 m6 n6 p6 r6 s6 t6 u6 x6\n\
         H8: e7 f7 h7 js7 k7 m7 s7 u7 d8 e8 f8 h8\n\
         H9: d8 e8 f8 h8\n\
         H10: b9 c9 d9 e9 h9\n\
         H11: b11 c11 d10 h10"
    );
    assert_eq!(
        list(Preference::ShaftBasis),
        "h5: G6 H6 JS6 K6 M6 N6 P6\n\
         h6: F7 G7 H7 JS7 K7 M7 N7 P7 R7 S7 T7 U7 X7\n\
         h7: E8 F8 H8\n\
         h8: D9 E9 F9 H9\n\
         h9: E8 F8 H8 D9 E9 F9 H9 B11 C10 D10 H10"
    );
    for (text, expected) in [
        ("H7/h6", Some(Preference::HoleBasis)),
        ("H9/h9", Some(Preference::ShaftBasis)),
        ("P7/h6", Some(Preference::ShaftBasis)),
        ("H9/d9", None),
        ("H7/g7", None),
        ("F8/m6", None),
    ] {
        let (hole, shaft) = pair(text);
        assert_eq!(preference(hole, shaft), expected, "{text}");
        assert_eq!(preference(shaft, hole), None, "hole and shaft are not exchanged");
    }
    for preference in [Preference::HoleBasis, Preference::ShaftBasis] {
        assert!(preference.fits().all(|(hole, shaft)| self::preference(hole, shaft).is_some()));
    }
}

#[test]
fn named_fits_are_the_table_of_ansi_b4_2() {
    let table = [
        ("H11/c11", "C11/h11", "loose running"),
        ("H9/d9", "D9/h9", "free running"),
        ("H8/f7", "F8/h7", "close running"),
        ("H7/g6", "G7/h6", "sliding"),
        ("H7/h6", "H7/h6", "locational clearance"),
        ("H7/k6", "K7/h6", "locational transition"),
        ("H7/n6", "N7/h6", "locational transition, tighter"),
        ("H7/p6", "P7/h6", "locational interference"),
        ("H7/s6", "S7/h6", "medium drive"),
        ("H7/u6", "U7/h6", "force"),
    ];
    for ((hole_basis, shaft_basis, name), of) in table.into_iter().zip(Function::ALL) {
        let mut expected = vec![pair(hole_basis), pair(shaft_basis)];
        expected.dedup();
        let fits: Vec<_> = of.fits().map(|fit| (fit.hole, fit.shaft)).collect();
        assert_eq!((fits, of.to_string().as_str()), (expected, name));
        assert_eq!(function(pair(hole_basis).0, pair(hole_basis).1), Some(of));
        assert_eq!(function(pair(shaft_basis).0, pair(shaft_basis).1), Some(of));
    }
    assert_eq!(Function::ALL.into_iter().flat_map(Function::fits).count(), 19);
    assert_eq!(function(class("H7"), class("m6")), None);
    assert_eq!(function(class("C11"), class("c11")), None);
}

#[test]
fn both_columns_of_a_named_fit_are_the_same_except_the_last_five_up_to_3_mm() {
    let ends: Vec<Length> = iso286::step_ends().filter(|end| *end <= mm("500")).collect();
    let mut differing = Vec::new();
    for nominal in ends {
        for function in Function::ALL {
            let fits: Vec<Fit> = function.fits().filter_map(|f| fit_of(nominal, f.hole, f.shaft)).collect();
            let [one, other] = fits.as_slice() else { continue };
            if !Difference::between(one, other).is_none() {
                differing.push((nominal.to_string(), function));
            }
        }
    }
    let last_five = &Function::ALL[5..];
    let expected = ["1", "3"].iter().flat_map(|nominal| last_five.iter().map(|f| ((*nominal).to_owned(), *f)));
    assert_eq!(differing, expected.collect::<Vec<_>>());
}

#[test]
fn the_equivalent_fit_changes_letters_and_keeps_grades() {
    for (text, expected) in [
        ("H7/p6", Some("P7/h6")),
        ("P7/h6", Some("H7/p6")),
        ("G7/h6", Some("H7/g6")),
        ("H8/js7", Some("JS8/h7")),
        ("H11/zc01", Some("ZC11/h01")),
        ("H7/h6", None),
        ("F8/m6", None),
        ("H7/q6", None),
    ] {
        let (hole, shaft) = pair(text);
        assert_eq!(equivalent(hole, shaft), expected.map(pair), "{text}");
        if let Some((hole, shaft)) = equivalent(hole, shaft) {
            assert_eq!(equivalent(hole, shaft), Some(pair(text)));
        }
    }
    assert_eq!(equivalent(class("h6"), class("H7")), None);
    let difference = Difference::between(&fit("2", "H7/p6"), &fit("2", "P7/h6"));
    assert_eq!((difference.minimum, difference.maximum), (mm("-0.004"), mm("-0.004")));
    // H8 is wider than H7 at one end only.
    let difference = Difference::between(&fit("25", "H7/h6"), &fit("25", "H8/h6"));
    assert_eq!((difference.minimum, difference.maximum), (Length::ZERO, mm("0.012")));
    assert!(!difference.is_none());
    assert!(Difference::between(&fit("25", "H7/h6"), &fit("25", "H7/h6")).is_none());
}

#[test]
fn words_for_machines_are_each_for_one_thing() {
    assert_eq!(Preference::HoleBasis.word(), "hole basis");
    assert_eq!(Preference::ShaftBasis.word(), "shaft basis");
    let words: std::collections::BTreeSet<&str> = Function::ALL.iter().map(|function| function.word()).collect();
    assert_eq!(words.len(), Function::ALL.len());
    assert!(words.contains("loose-running") && words.contains("locational-interference"));
}

/// Hn with x(n − 1) and Xn with h(n − 1): 1 812 combinations by the facts, K, M, N to n = 8 and P to ZC to n = 7.
#[test]
fn equivalent_fits_are_exactly_the_same_from_3_to_500_mm_except_the_stated_ones() {
    let mut differing: Vec<String> = Vec::new();
    let mut compared = 0;
    for nominal in sizes() {
        for letter in Letter::ALL.into_iter().filter(|letter| !matches!(letter, Letter::H | Letter::J | Letter::Js)) {
            let coarsest = match letter {
                Letter::K | Letter::M | Letter::N => 8,
                letter if letter < Letter::H => 18,
                _ => 7,
            };
            for number in 3..=coarsest {
                let grade = |number| Grade::numbered(number).unwrap();
                let hole = iso286::class(Feature::Hole, Letter::H, grade(number));
                let shaft = iso286::class(Feature::Shaft, letter, grade(number - 1));
                let (other_hole, other_shaft) = equivalent(hole, shaft).unwrap();
                let fits = (fit_of(nominal, hole, shaft), fit_of(nominal, other_hole, other_shaft));
                let (Some(one), Some(other)) = fits else { continue };
                compared += 1;
                if !Difference::between(&one, &other).is_none() {
                    let step = if mm("250") < nominal && nominal <= mm("315") { "250 to 315" } else { "" };
                    differing.push(format!("{other_hole}{}{step}", if step.is_empty() { "" } else { " at " }));
                }
            }
        }
    }
    differing.sort();
    differing.dedup();
    assert!(5_000 < compared, "{compared}");
    assert_eq!(differing, ["K3", "K3 at 250 to 315", "K4", "K4 at 250 to 315", "M6 at 250 to 315"]);
}

proptest! {
    #[test]
    fn the_kind_is_that_of_the_signs(nm in 1_i64..3_150_000_000, hole in 0_usize..560, shaft in 0_usize..560) {
        let nominal = Length::from_nanometres(nm).unwrap();
        let pick = |feature, number: usize| {
            let classes: Vec<(ToleranceClass, _)> = iso286::classes_at(feature, nominal, Options::default()).collect();
            classes[number % classes.len()].0
        };
        let fit = fit_of(nominal, pick(Feature::Hole, hole), pick(Feature::Shaft, shaft)).unwrap();
        let (minimum, maximum) = (fit.minimum_clearance().nanometres(), fit.maximum_clearance().nanometres());
        prop_assert!(minimum < maximum);
        let kind = match (0 <= minimum, maximum <= 0) {
            (true, _) => FitKind::Clearance,
            (_, true) => FitKind::Interference,
            _ => FitKind::Transition,
        };
        prop_assert_eq!(fit.kind(), kind);
        let hole = fit.hole();
        let shaft = fit.shaft();
        // Extreme parts give the extreme clearances, and one nanometre more does not conform.
        let widest = Actual::of(&fit, hole.maximum(), shaft.minimum());
        prop_assert!(widest.conforms && widest.clearance == fit.maximum_clearance() && widest.status() == Status::Good);
        let step = Length::from_nanometres(1).unwrap();
        let beyond = Actual::of(&fit, hole.maximum().checked_add(step).unwrap(), shaft.minimum());
        prop_assert!(!beyond.conforms && beyond.status() == Status::Scrap);
        let tightest = Actual::of(&fit, hole.minimum(), shaft.maximum());
        prop_assert!(tightest.conforms && tightest.clearance == fit.minimum_clearance());
        let beyond = Actual::of(&fit, hole.minimum(), shaft.maximum().checked_add(step).unwrap());
        prop_assert!(!beyond.conforms && beyond.status() == Status::Rework);
    }
}
