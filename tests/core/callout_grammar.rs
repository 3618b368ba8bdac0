//! The grammar of callouts and classes, its errors, and the places that they name.

use std::fmt;
use std::str::FromStr;

use fitcheck::tolerance::callout::halves;
use fitcheck::tolerance::{Callout, CalloutError, Feature, ToleranceClass};
use fitcheck::words::{Language, Words};

/// What a text is read as, or `!` and the error.
pub fn said<T: FromStr<Err = CalloutError> + fmt::Display>(text: &str) -> String {
    match T::from_str(text) {
        Ok(read) => read.to_string(),
        Err(error) => format!("! {error}"),
    }
}

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(said::<Callout>(text), expected, "for {text:?}");
}

/// All texts read as the same callout.
#[track_caller]
fn check_all(texts: &[&str], expected: &str) {
    for text in texts {
        check(text, expected);
    }
}

/// The characters in brackets are those that the error names.
#[track_caller]
fn check_span(marked: &str) {
    let text = marked.replace(['[', ']'], "");
    let error = Callout::from_str(&text).unwrap_err();
    let span = error.span().unwrap();
    let mut chars: Vec<char> = text.chars().collect();
    chars.insert(span.end, ']');
    chars.insert(span.start, '[');
    assert_eq!(chars.into_iter().collect::<String>(), marked, "{error}");
}

#[test]
fn reads_classes_as_people_type_them() {
    check_all(
        &["25 H7", "25H7", "  Ø25 H7 ", "⌀ 25H7", "ø25,0 H7", "25 mm H7", "25mm H7", "+25 H7", "25. H7"],
        "25 H7",
    );
    check("25 h7", "25 h7");
    check("25.50JS13", "25.5 JS13");
    check("+3.001 K7", "3.001 K7");
    check_all(&["10m6", "10 m6", "10 mm m6"], "10 m6");
    check("25mm6", "25 mm6");
}

#[test]
fn reads_fits_hole_first() {
    check_all(&["25 H7/g6", "25H7/g6", "25 H7-g6", "Ø25 H7 / g6", "25 H7 \u{2013} g6", "25 mm H7/g6"], "25 H7/g6");
    check("25 g6/H7", "! the shaft comes before the hole: write 25 H7/g6 (character 4)");
    let no_fit = "are not a hole and a shaft: a fit is written with capital letters, then small letters, such as 25 H7/g6 (character 4)";
    check("25 H7/G6", &format!("! H7 and G6 {no_fit}"));
    check("25 h7-g6", &format!("! h7 and g6 {no_fit}"));
    check("25 H7/", "! a tolerance class is missing, such as H7 for a hole or h7 for a shaft (character 7)");
    check("25 H7/g6/f5", "! /f5 is not expected here: the text is complete without it (character 9)");
    check("25 H7-0.1", "! 0.1 is not a tolerance class: write letters and a grade, such as H7 or js13 (character 7)");
}

#[test]
fn reads_general_tolerances_in_small_letters() {
    check_all(&["10m", "10 m", "Ø10,0 m", "10 mm m", " 10m "], "10m");
    check("0.5f", "0.5f");
    check(
        "10M",
        "! M has no grade: write 10m for the general tolerance of ISO 2768-1, or add a grade, such as M7 (character 3)",
    );
    check("10m -0.1", "! -0.1 is not expected here: the text is complete without it (character 5)");
    // Without a grade it can only be an own column: whoever looks its limits up says what there is.
    check("10 h", "10 h");
}

#[test]
fn reads_deviations_upper_first() {
    let both = "12 +0.01 -0.015";
    check_all(&[both, "12+0.01-0.015", "12 + 0,010 - 0,015", "12 +0.01/-0.015", "12+0.01/\u{2212}0.015"], both);
    check_all(&["12 +10 µm -15 um", "12 mm +10 μm/-15µm", "12 +0.01 mm -0.015"], both);
    check_all(
        &["12 ±0.02", "12±0,02", "12 ± 20 µm", "12 +/-0.02", "12 +-0.02", "12 +/\u{2013}0.02 mm", "12 +0.02 -0.02"],
        "12 ±0.02",
    );
    check_all(&["12 +0.2/0", "12 +0.2 0", "12 +0.2", "12 +0.2-0", "12 +200 µm 0"], "12 +0.2 0");
    check_all(&["12 0/-0.2", "12 0 -0.2", "12 -0.2", "12 +0 -0.2", "12 0-0,2", "12\u{2013}0.2"], "12 0 -0.2");
    check("12 -0.007/-0.020", "12 -0.007 -0.02");
    check("8-1-2", "8 -1 -2");
    check_all(&["12 0 0", "12 ±0"], "12 ±0");
}

#[test]
fn refuses_deviations_that_may_mean_something_else() {
    let swapped = "the lower deviation comes before the upper one: write";
    check("8-2-1", &format!("! {swapped} 8 -1 -2 (character 2)"));
    check("12 -0.1 +0.1", &format!("! {swapped} 12 ±0.1 (character 4)"));
    check("12 0/+0.1", &format!("! {swapped} 12 +0.1 0 (character 4)"));
    let no_sign = "for a deviation, without a space in the number";
    check("12 0.2", &format!("! 0.2 has no sign: write +0.2 or -0.2 {no_sign} (character 4)"));
    check("12 +0.2/0.1", &format!("! 0.1 has no sign: write +0.1 or -0.1 {no_sign} (character 9)"));
    check("1 250 H8", &format!("! 250 has no sign: write +250 or -250 {no_sign} (character 3)"));
    let no_unit = "has no unit and the other deviation is in µm: write the unit after both";
    check("100 +10 -15 µm", &format!("! 10 {no_unit} (character 6)"));
    check("100 +10 µm -15", &format!("! 15 {no_unit} (character 13)"));
    let mixed = "has a different decimal sign than the number before it: use one kind";
    check("1,234 +0.5", &format!("! 0.5 {mixed} (character 8)"));
    check("12.5 +0.1 -0,1", &format!("! 0,1 {mixed} (character 12)"));
}

#[test]
fn refuses_what_is_no_deviation() {
    let how = "write a sign and a number, such as +0.1 or -0.1";
    check("12 +", &format!("! the deviation is missing: {how} (character 4)"));
    check("12 0", &format!("! the deviation is missing: {how} (character 5)"));
    check("12 -0", &format!("! the deviation is missing: {how} (character 6)"));
    check("12 +0.1/", &format!("! the deviation is missing: {how} (character 9)"));
    check("12 +x", &format!("! +x is not a deviation: {how} (character 4)"));
    check("12 ±-0.1", &format!("! ±-0.1 is not a deviation: {how} (character 4)"));
    check("12 +0.1 ±0.1", &format!("! ±0.1 is not a deviation: {how} (character 9)"));
    check("12 +0.1.2", "! deviation: 0.1.2 is not a number (character 5)");
    check("12 +0.0001 µm", "! deviation: 0.0001 µm is finer than a nanometre (character 5)");
    check("12 +0.1 -0.2 -0.3", "! -0.3 is not expected here: the text is complete without it (character 14)");
    check("12 ±0.1 H7", "! H7 is not expected here: the text is complete without it (character 9)");
    let asks = "if the deviations are in micrometres, write";
    check("12 -11 -12", &format!("! minimum limit 0 mm is not above 0: {asks} 12 -0.011 -0.012 (character 4)"));
    check("12 ±13", &format!("! minimum limit -1 mm is not above 0: {asks} 12 ±0.013 (character 4)"));
    check("0.001 ±0.0013", "! minimum limit -0.0003 mm is not above 0 (character 7)");
    check("1000000000 +0.000001", "! the limits of 1000000000 mm are too large (character 12)");
}

#[test]
fn reads_limits_larger_first() {
    check_all(&["12.01/11.985", "Ø12,01 / 11,985 mm", "12.01 mm/11.985", " 12.010/11.9850 "], "12.01/11.985");
    check("12/12", "12/12");
    check("2/1", "2/1");
    let callout = Callout::from_str("12.01/11.985").unwrap();
    assert_eq!((callout.nominal().to_string().as_str(), callout.feature()), ("11.9975", None));
    check("11.985/12.01", "! the smaller limit comes before the larger one: write 12.01/11.985 (character 1)");
    check(
        "2.000001/1",
        "! 2.000001 mm is more than twice 1 mm, so these are probably not limits: write deviations, such as 12 +0.2 0 \
         (character 1)",
    );
    let how = "write two sizes, the larger first, such as 12.01/11.985";
    check("12.01/", &format!("! the limit of size is missing: {how} (character 7)"));
    check("12.01/-0.1", &format!("! -0.1 is not a limit of size: {how} (character 7)"));
    check("12/1.1.1", "! limit of size: 1.1.1 is not a number (character 4)");
    check("12/0", "! minimum limit 0 mm is not above 0 (character 1)");
}

#[test]
fn a_minus_between_two_sizes_is_no_deviation() {
    let write = "this is ambiguous: write";
    check(
        "12.01-11.985",
        &format!("! {write} 12.01/11.985 for limits of size or 12.01 0 -11.985 for a lower deviation (character 1)"),
    );
    check("12 -6", &format!("! {write} 12/6 for limits of size or 12 0 -6 for a lower deviation (character 1)"));
    check("12 -5.999999", "12 0 -5.999999");
    check("12 0 -6", "12 0 -6");
    check(
        "11.985-12.01",
        "! such a deviation would leave no size: write 12.01/11.985 for limits of size (character 1)",
    );
    let asks = "if the deviations are in micrometres, write";
    check("12-30", &format!("! minimum limit -18 mm is not above 0: {asks} 12 0 -0.03 (character 3)"));
}

#[test]
fn refuses_what_is_no_callout() {
    check("", "! a callout is missing: write a nominal size and a tolerance class, such as 25 H7");
    check("H7", "! H7 does not begin with a nominal size: write one, such as 25 H7");
    check_all(&["25", "10 mm"], "! a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1");
    check("0 H7", "! nominal size 0 mm is not above 0");
    check_all(&["-5 H7", "\u{2212}5 H7", "\u{2013}5 H7"], "! nominal size -5 mm is not above 0");
    check("+-5 H7", "! nominal size: +-5 is not a number");
    check("7.5.2 H7", "! nominal size: 7.5.2 is not a number");
    check("1.234,5 H7", "! nominal size: 1.234,5 is ambiguous: write one decimal sign and no thousands separator");
    check("25 Hh7", "! Hh7 mixes upper and lower case: write HH7 for a hole or hh7 for a shaft (character 4)");
    check("NaN H7", "! NaN H7 does not begin with a nominal size: write one, such as 25 H7");
    for text in ["+0.2 -0.05", "+0.2/0.15", "+0.2 0", "+12 ±0.1"] {
        check(text, &format!("! {text} does not begin with a nominal size: write one, such as 25 H7"));
    }
    check("25 H7 x", "! x is not expected here: the text is complete without it (character 7)");
    for (text, sign, at) in [("?25 H7", '?', 1), ("25?", '?', 3), ("25 H7@25.01", '@', 6), ("10@1", '@', 3)] {
        let expected = format!("! {sign} is for the texts of cycles 14xx, not for a callout (character {at})");
        check(text, &expected);
    }
}

#[test]
fn a_sign_belongs_to_the_size_while_it_is_typed() {
    for (text, expected) in [
        ("+25 H7", ("+25", "H7")),
        ("-25", ("-25", "")),
        ("\u{2212}25 g6", ("\u{2212}25", "g6")),
        ("Ø 25H7", ("25", "H7")),
        ("", ("", "")),
    ] {
        assert_eq!(halves(text), expected, "{text:?}");
    }
    check("+ H7", "! nominal size: + is not a number");
}

#[test]
fn an_error_in_values_names_no_character() {
    let error = CalloutError::from("7".parse::<ToleranceClass>().unwrap_err());
    assert_eq!(error.span(), None);
    assert!(!error.to_string().contains("character"), "{error}");
}

#[test]
fn errors_point_at_their_characters() {
    check_span("[]");
    check_span("  [x] 25");
    check_span("25[]");
    check_span(" Ø[0] H7");
    check_span("Ø [1.234,5] H7");
    check_span("Ø25 [Hh7]");
    check_span("  25 H7/[]");
    check_span("25 [g6/H7]");
    check_span("[12-12.5]");
    check_span("12 \u{2212}0,1 [x y]  ");
    check_span("12 +0,1 \u{2013}[0.2]");
    check_span("[12.01-11.985]");
    check_span("12 H7[@]3");
}

#[test]
fn a_long_text_is_not_repeated_whole() {
    for text in ["9".repeat(1000), format!("25 {}", "Hh".repeat(1000)), "x\u{7}".repeat(1000), "1.".repeat(1000)] {
        let error = Callout::from_str(&text).unwrap_err();
        assert!(error.text.chars().count() <= 81 && error.to_string().chars().count() < 300, "{error}");
        assert!(!error.to_string().contains(char::is_control));
    }
    // Zeros after the figures are not finer.
    check(&format!("25.{} H7", "0".repeat(200)), "25 H7");
}

#[test]
fn classes_are_told_by_feature() {
    let of = |text: &str| {
        let callout = Callout::from_str(text).unwrap();
        [callout.class(), callout.class_for(Feature::Hole), callout.class_for(Feature::Shaft)]
            .map(|class| class.map_or_else(String::new, |class| class.to_string()))
    };
    assert_eq!(of("25 H7"), ["H7", "H7", ""]);
    assert_eq!(of("25 g6"), ["g6", "", "g6"]);
    assert_eq!(of("25 H7/g6"), ["", "H7", "g6"]);
    assert_eq!(of("25m"), ["", "", ""]);
}

#[test]
fn lengths_in_an_error_have_the_sign_of_its_language() {
    let negative = Callout::from_str("-5.5 H7").unwrap_err();
    assert_eq!(Words::new(Language::Nl).told(&negative), "nominale maat \u{2212}5,5 mm is niet groter dan 0");
}

#[test]
fn the_case_of_the_letters_decides_hole_or_shaft() {
    for (text, feature) in
        [("H7", Feature::Hole), ("h7", Feature::Shaft), ("JS13", Feature::Hole), ("js5", Feature::Shaft)]
    {
        let class: ToleranceClass = text.parse().unwrap();
        assert_eq!((class.as_str(), class.feature()), (text, feature));
        assert_eq!(class.other_case().feature(), feature.other());
    }
    assert_eq!("JS7".parse::<ToleranceClass>().unwrap().letters(), "JS");
}

#[test]
fn refuses_what_is_no_class_and_says_why() {
    for (text, message) in [
        ("", "a tolerance class is missing, such as H7 for a hole or h7 for a shaft"),
        ("Js7", "Js7 mixes upper and lower case: write JS7 for a hole or js7 for a shaft"),
        ("7", "7 is not a tolerance class: write letters and a grade, such as H7 or js13"),
        ("mm", "mm is not a tolerance class: write letters and a grade, such as H7 or js13"),
        ("M", "M is not a tolerance class: write letters and a grade, such as H7 or js13"),
        ("H7x", "H7x is not a tolerance class: write letters and a grade, such as H7 or js13"),
        ("Ω7", "Ω7 is not a tolerance class: write letters and a grade, such as H7 or js13"),
        ("ABCDEFGH7", "ABCDEFGH7 is not a tolerance class: write letters and a grade, such as H7 or js13"),
    ] {
        assert_eq!(text.parse::<ToleranceClass>().unwrap_err().to_string(), message);
    }
}
