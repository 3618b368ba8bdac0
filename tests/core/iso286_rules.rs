//! Rules and texts of ISO 286. `iso286.rs` compares the cells with independent transcriptions.

use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::iso286::{
    Cell, Edition, Grade, JsHalves, Options, Remark, classes, classes_at, deviations, standard_tolerance,
};
use fitcheck::tolerance::{Feature, ToleranceClass};

#[track_caller]
fn check_with(options: Options, class: &str, nominal: &str, expected: &str) {
    let said = match deviations(class.parse().unwrap(), nominal.parse().unwrap(), options) {
        Ok(Cell { deviations, over, to, .. }) => {
            let um = |length: Length| length.exact(Unit::Micrometre, 0);
            format!("{} / {} over {over} to {to}", um(deviations.upper()), um(deviations.lower()))
        }
        Err(error) => format!("! {error}"),
    };
    assert_eq!(said, expected, "for {nominal} {class}");
}

#[track_caller]
fn check(class: &str, nominal: &str, expected: &str) {
    check_with(Options::default(), class, nominal, expected);
}

#[test]
fn a_step_ends_with_its_bound_and_the_next_begins_a_nanometre_above() {
    check("K7", "3", "0 / -10 over 0 to 3");
    check("K7", "3.000001", "3 / -9 over 3 to 6");
    check("M6", "250", "-8 / -37 over 180 to 250");
    check("M6", "250.000001", "-9 / -41 over 250 to 315");
    check("M6", "315", "-9 / -41 over 250 to 315");
    check("M6", "315.000001", "-10 / -46 over 315 to 400");
    check("M5", "280", "-13 / -36 over 250 to 315");
    check("T7", "24.000001", "-33 / -54 over 24 to 30");
    check("r6", "65", "60 / 41 over 50 to 65");
    check("r6", "65.000001", "62 / 43 over 65 to 80");
    check("H7", "3150", "210 / 0 over 2500 to 3150");
    check("H8", "1250", "165 / 0 over 1000 to 1250");
}

#[test]
fn halves_and_fractions_are_exact() {
    check("js01", "3", "0.15 / -0.15 over 0 to 3");
    check("js2", "25", "1.25 / -1.25 over 18 to 30");
    check("JS9", "100", "43.5 / -43.5 over 80 to 120");
    check("K3", "25", "-0.5 / -4.5 over 18 to 30");
    check("P4", "8", "-13.5 / -17.5 over 6 to 10");
}

#[test]
fn the_1988_rounding_and_edition_are_options() {
    let rounded = Options { js: JsHalves::Rounded, ..Options::default() };
    check_with(rounded, "JS9", "100", "43 / -43 over 80 to 120");
    check_with(rounded, "js7", "25", "10 / -10 over 18 to 30");
    check_with(rounded, "js7", "9", "7 / -7 over 6 to 10");
    check_with(rounded, "js6", "9", "4.5 / -4.5 over 6 to 10");
    check_with(rounded, "js12", "2", "50 / -50 over 0 to 3");
    check_with(rounded, "js11", "3000", "675 / -675 over 2500 to 3150");
    check("cd8", "10.000001", "-70 / -97 over 10 to 18");
    check("FG6", "50", "31 / 15 over 30 to 50");
    let old = Options { edition: Edition::Of1988, ..Options::default() };
    check_with(old, "cd8", "10", "-56 / -78 over 6 to 10");
    let refused = "! cd8 is not defined at 10.000001 mm in ISO 286; it is defined over 0 up to 10 mm";
    check_with(old, "cd8", "10.000001", refused);
}

#[test]
fn what_is_undefined_is_refused_with_where_it_is_defined() {
    check("T7", "24", "! T7 is not defined at 24 mm in ISO 286; it is defined over 24 up to 3150 mm");
    check("N9", "1", "! N9 is not defined at 1 mm in ISO 286; it is defined over 1 up to 3150 mm");
    check("N9", "1.000001", "-4 / -29 over 1 to 3");
    check("N9", "8", "0 / -36 over 6 to 10");
    check("b11", "1", "! b11 is not defined at 1 mm in ISO 286; it is defined over 1 up to 500 mm");
    check("H14", "1", "! H14 is not defined at 1 mm in ISO 286; it is defined over 1 up to 3150 mm");
    check("K10", "12", "! K10 is not defined at 12 mm in ISO 286; it is defined over 0 up to 3 mm");
    check("v6", "14", "! v6 is not defined at 14 mm in ISO 286; it is defined over 14 up to 500 mm");
    check("c11", "600", "! c11 is not defined at 600 mm in ISO 286; it is defined over 0 up to 500 mm");
    check(
        "P2",
        "12",
        "! P2 is not defined at 12 mm in ISO 286; it is defined over 0 up to 3 mm, over 500 up to 3150 mm",
    );
    check("j9", "2", "! j9 is not defined at 2 mm in ISO 286; it is not defined at any size");
    check("J5", "2", "! J5 is not defined at 2 mm in ISO 286; it is not defined at any size");
    check("H01", "500.000001", "! H01 is not defined at 500.000001 mm in ISO 286; it is defined over 0 up to 500 mm");
    check("H7", "3150.000001", "! nominal size 3150.000001 mm is beyond ISO 286, which ends at 3150 mm");
    check("H7", "0", "! nominal size 0 mm is not above 0");
    check("H7", "-5", "! nominal size -5 mm is not above 0");
    let letters = "A B C CD D E EF F FG G H J JS K M N P R S T U V X Y Z ZA ZB ZC";
    check("Q7", "25", &format!("! Q7 is not an ISO 286 tolerance class: letter Q does not exist, only {letters}"));
    let grades = "01 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18";
    check("H19", "25", &format!("! H19 is not an ISO 286 tolerance class: the grades are {grades}"));
    check("h07", "25", &format!("! h07 is not an ISO 286 tolerance class: the grades are {grades}"));
}

#[test]
fn the_classes_at_a_size_are_those_that_are_answered() {
    for feature in [Feature::Hole, Feature::Shaft] {
        for nominal in ["1", "2", "8", "20", "25", "300", "501", "3150", "3151", "0"] {
            let (nominal, options): (Length, _) = (nominal.parse().unwrap(), Options::default());
            let at: Vec<_> = classes_at(feature, nominal, options).collect();
            for (class, found) in &at {
                assert_eq!(deviations(*class, nominal, options).unwrap().deviations, *found, "{nominal} {class}");
                assert_eq!(class.as_str().parse::<ToleranceClass>().unwrap(), *class);
            }
            let all = classes(feature, options).filter(|class| deviations(*class, nominal, options).is_ok());
            assert_eq!(all.count(), at.len(), "{feature} {nominal}");
        }
    }
}

#[test]
fn a_standard_tolerance_is_that_of_its_step_and_needs_a_size() {
    let it = |grade: &str, nominal: &str| {
        let grade = Grade::all().find(|known| known.to_string() == grade).unwrap();
        standard_tolerance(grade, nominal.parse().unwrap()).map(|width| width.to_string())
    };
    let numbered = |number| Grade::numbered(number).map(|grade| grade.to_string());
    assert_eq!([0, 1, 18, 19].map(numbered), [None, Some("1".to_owned()), Some("18".to_owned()), None]);
    // ISO 286-1:2010, table 1.
    assert_eq!(it("7", "25").as_deref(), Some("0.021"));
    assert_eq!(it("01", "0.000001").as_deref(), Some("0.0003"));
    assert_eq!(it("18", "3150").as_deref(), Some("33"));
    for (grade, nominal) in [("7", "0"), ("7", "-25"), ("7", "3150.000001"), ("01", "500.000001"), ("14", "1")] {
        assert_eq!(it(grade, nominal), None, "IT{grade} at {nominal}");
    }
}

#[test]
fn contested_and_provisional_figures_are_told() {
    let remark = |class: &str, nominal: &str| {
        deviations(class.parse().unwrap(), nominal.parse().unwrap(), Options::default()).unwrap().remark
    };
    assert_eq!(remark("ef8", "18"), None);
    assert_eq!(remark("ef8", "18.000001"), Some(Remark::ContestedEf));
    assert_eq!(remark("EF8", "30"), Some(Remark::ContestedEf));
    assert_eq!(remark("EF8", "30.000001"), None);
    assert_eq!(remark("h5", "500"), None);
    assert_eq!(remark("h5", "501"), Some(Remark::TrialUse));
    assert_eq!(remark("h5", "800"), Some(Remark::TrialUse));
    assert_eq!(remark("h5", "801"), Some(Remark::OlderIt5));
    assert_eq!(remark("h6", "801"), None);
}
