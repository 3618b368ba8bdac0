//! The texts of cycles 14xx and of QS400: what they may and may not contain.

use fitcheck::tolerance::CycleText;
use fitcheck::tolerance::callout::qs400;

use crate::callout_grammar::said;

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(said::<CycleText>(text), expected, "for {text:?}");
}

#[test]
fn cycle_texts_may_say_less_and_more() {
    for text in ["?", "?50", "-20", "10H7", "?10H7", "10H7@10.004", "?10m@-3", "10+0.01-0.015", "8-1-2", "10+0.2-0"] {
        check(text, text);
    }
    check(" ? Ø10 ± 0,02 @ 9,99 ", "?10+0.02-0.02@9.99");
    check("8-2-1", "8-1-2");
    check("12-0.1+0.1", "12+0.1-0.1");
    check("12-8", "12+0-8");
    check("", "! a callout is missing: write a nominal size and a tolerance class, such as 25 H7");
    check("??", "! ?? does not begin with a nominal size: write one, such as 25 H7");
    check("-5H7", "! nominal size -5 mm is not above 0");
    let no_fit = "cannot stand in a text of cycles 14xx: write a class, a general class or deviations";
    check("10H7/g6", &format!("! / {no_fit} (character 5)"));
    check("10H7-g6", &format!("! - {no_fit} (character 5)"));
    check("12/11", &format!("! / {no_fit} (character 3)"));
    let how = "write a number, such as 10H7@10.004";
    check("10H7@", &format!("! the value after @ is missing: {how} (character 6)"));
    check("10H7@x", &format!("! x is not a value after @: {how} (character 6)"));
    check("10H7@1.2.3", "! value after @: 1.2.3 is not a number (character 6)");
    check("10H7@1?", "! ? is not expected here: the text is complete without it (character 7)");
}

#[track_caller]
fn check_qs400(text: &str, expected: &str) {
    let said = match qs400(text) {
        Ok(Some(band)) => format!("{} {}", band.upper(), band.lower()),
        Ok(None) => String::new(),
        Err(error) => format!("! {error}"),
    };
    assert_eq!(said, expected, "for {text:?}");
}

#[test]
fn texts_of_qs400_are_bands_without_a_size() {
    for text in ["0.4-0.1", "0,4\u{2013}0,1", "+0.4\u{2212}0.1", " 0.4 -0.1 "] {
        check_qs400(text, "0.4 -0.1");
    }
    check_qs400("0.4", "0.4 0");
    check_qs400("0.4-0", "0.4 0");
    check_qs400("-0.1", "0 -0.1");
    check_qs400("0-0.1", "0 -0.1");
    for text in ["", "  ", "0", "-0", "0-0", "0.1+0.1", "0.1+0.2", "-0.1-0.2"] {
        check_qs400(text, "");
    }
    check_qs400("-0.1+0.4", "! the lower deviation comes before the upper one: write QS400 as 0.4-0.1 (character 5)");
    check_qs400("0.4-0.1-0.2", "! -0.2 is not expected here: the text is complete without it (character 8)");
    check_qs400("H7", "! H7 is not a deviation: write a sign and a number, such as +0.1 or -0.1 (character 1)");
    check_qs400("±0.1", "! ±0.1 is not a deviation: write a sign and a number, such as +0.1 or -0.1 (character 1)");
    check_qs400("0.1 mm", "! 0.1 mm is not a deviation: write a sign and a number, such as +0.1 or -0.1 (character 1)");
    check_qs400("0.4-0,1", "! 0,1 has a different decimal sign than the number before it: use one kind (character 5)");
    check_qs400(
        "1.234,5",
        "! deviation: 1.234,5 is ambiguous: write one decimal sign and no thousands separator (character 1)",
    );
    check_qs400(&format!("0.4{}", " ".repeat(252)), "0.4 0");
    check_qs400(&format!("0.4{}", " ".repeat(253)), "! the text is too long: at most 255 characters");
    check_qs400(
        "0.4 0.1",
        "! 0.1 has no sign: write +0.1 or -0.1 for a deviation, without a space in the number (character 5)",
    );
}
