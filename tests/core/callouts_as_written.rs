//! Callouts as drawings and other programs write them: those of the field, and the kinds behind them.

#![cfg(test)]

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::tolerance::callout::Modifier;
use fitcheck::tolerance::{Callout, Feature, Sources};
use proptest::prelude::*;

use super::callout_grammar::said;

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(said::<Callout>(text), expected, "for {text:?}");
}

#[track_caller]
fn check_all(texts: &[&str], expected: &str) {
    for text in texts {
        check(text, expected);
    }
}

/// The text is refused with these words.
#[track_caller]
fn refused(text: &str, words: &[&str]) {
    let error = said::<Callout>(text);
    assert!(error.starts_with("! "), "{text:?} is {error}");
    for word in words {
        assert!(error.contains(word), "{text:?}: {error}");
    }
}

/// Exit code, standard output and standard error.
fn fitcheck(args: &[&str]) -> (Option<i32>, String, String) {
    let answer = cargo_bin_cmd!("fitcheck").args(args).assert();
    let output = answer.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn every_callout_of_the_field_is_answered_as_it_should() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/callouts_as_written.csv");
    let mut reader = csv::ReaderBuilder::new().flexible(true).quoting(false).from_path(path).unwrap();
    let rows: Vec<(String, String)> = reader
        .records()
        .map(|row| {
            let row = row.unwrap();
            (row[0].to_owned(), row.iter().skip(1).collect::<Vec<_>>().join(","))
        })
        .collect();
    assert_eq!(rows.len(), 17);
    for (callout, right) in rows {
        let (code, out, error) = fitcheck(&["limits", &callout]);
        let whole = format!("{out}{error}");
        let expected: &[&str] = match callout.as_str() {
            "25 H7 (+0.021/0)" | "25H7(+0.021 0)" => &["25 H7 (+0.021 0)", "25.000 … 25.021 mm"],
            "Ø20 g6 (-0.007/-0.020)" => &["20 g6 (-0.007 -0.02)", "19.980 … 19.993 mm"],
            "25 H7 (+0.025/0)" => &["25.000 … 25.021 mm", "+25 and 0 µm", "+21 and 0 µm"],
            "φ25H7" | "∅25 H7" | "%%c25H7" | "２５ Ｈ７" => &["25 H7 ", "25.000 … 25.021 mm"],
            "2x Ø8 H7" => &["2x 8 H7", "8.000 … 8.015 mm"],
            "4× 8 H7" => &["4x 8 H7", "8.000 … 8.015 mm"],
            "0.5in H7" => &["0.5 in is 12.7 mm", "write 12.7 H7"],
            "1/2\" H7" => &["1/2\" is 12.7 mm", "write 12.7 H7"],
            "M6x1 6H" => &["is a thread"],
            "10 mK" => &["10mK", "9.800 … 10.200 mm"],
            "25 +21/0" => &["if the deviations are in micrometres, write 25 +0.021 0"],
            "100 +35/0" => &["if the deviations are in micrometres, write 100 +0.035 0"],
            "25 ±24" => &["if the deviations are in micrometres, write 25 ±0.024"],
            other => panic!("{other} is not known"),
        };
        let is_answered = right.starts_with("as ") || callout == "10 mK";
        // A difference asks for a look.
        let expected_code = if callout == "25 H7 (+0.025/0)" { 14 } else { i32::from(!is_answered) };
        assert_eq!(code, Some(expected_code), "{callout}: {whole}");
        for words in expected {
            assert!(whole.contains(words), "{callout}: {whole}");
        }
    }
}

#[test]
fn deviations_in_brackets_are_kept_and_compared() {
    check_all(
        &[
            "25 H7 (+0.021/0)",
            "25H7(+0.021 0)",
            "Ø25 H7 ( +0,021 / 0 )",
            "25 H7 (+21 µm 0)",
            "25 H7 (25.021/25)",
            "25 H7 +0.021 0",
            "25 H7 +0.021/-0.000",
            "25 +0.021/0 (H7)",
            "25 (+0.021/0) H7",
        ],
        "25 H7 (+0.021 0)",
    );
    check("10m (±0.2)", "10m (+0.2 -0.2)");
    check("12 ±0.1 (12.1/11.9)", "12 ±0.1 (+0.1 -0.1)");
    refused("25 H7 (+21/0)", &["if they are in micrometres, write (+0.021 0)"]);
    refused("25 H7 (0/+0.021)", &["the lower deviation comes before the upper one"]);
    refused("25 H7/g6 (+0.021/0)", &["write them behind each class on its own"]);
    refused("25 H7 (+0.021/0) (+0.021/0)", &["(+0.021/0) is not expected here"]);
}

#[test]
fn what_contradicts_the_class_is_a_warning_and_asks_for_a_look() {
    let (code, out, error) = fitcheck(&["check", "25 H7 (+0.025/0)", "--measured", "25.012", "--format", "json"]);
    assert_eq!(code, Some(14), "{out}{error}");
    let told = "the callout states +25 and 0 µm behind the tolerance, which has +21 and 0 µm";
    assert!(error.contains(told) && out.contains(told), "{out}{error}");
    let (code, _, error) = fitcheck(&["check", "25 H7 (+0.021/0)", "--measured", "25.012"]);
    assert_eq!((code, error.contains("states")), (Some(0), false), "{error}");
}

#[test]
fn signs_of_drawings_keyboards_and_programs_are_read() {
    check_all(
        &["φ25H7", "Φ25 H7", "∅ 25 H7", "⌀25H7", "%%c25H7", "%%C 25 H7", "<MOD-DIAM>25 H7", "２５　Ｈ７"],
        "25 H7",
    );
    check_all(&["12%%p0.02", "12 ＋０．０２　－０．０２"], "12 ±0.02");
    check("25 H7∕g6", "25 H7/g6");
}

#[test]
fn a_count_is_kept() {
    check_all(
        &["2x Ø8 H7", "2 x Ø8 H7", "2X 8 H7", "(2x) 8 H7", "8 H7 (2x)", "8 H7 2x", "2×8 H7", "2-Ø8 H7"],
        "2x 8 H7",
    );
    check("4 × 10 ±0.1", "4x 10 ±0.1");
    check("0x 8 H7", "! nominal size 0 mm is not above 0");
    let callout: Callout = "4x 8 H7".parse().unwrap();
    assert_eq!((callout.notes().count, callout.feature()), (Some(4), Some(Feature::Hole)));
    let (code, _, error) = fitcheck(&["check", "4x 8 H7", "--measured", "8.01"]);
    assert_eq!(code, Some(0));
    assert!(error.contains("the callout applies to 4 features"), "{error}");
}

#[test]
fn modifiers_are_kept_and_the_answer_says_what_is_proved() {
    check_all(&["25 H7 Ⓔ", "25 H7 (E)", "25 H7(E)", "25 H7 E", "25H7Ⓔ"], "25 H7 (E)");
    check("25 h7 GN", "25 h7 (GN)");
    check("25 ±0.1 ⒼⒼ (E) (CT)", "25 ±0.1 (GG) (E) (CT)");
    check("2x 25 H7 (+0.021/0) (E)", "2x 25 H7 (+0.021 0) (E)");
    refused("25 H7 (GE)", &["GE is not a modifier of ISO 14405-1", "LP LS GG GX GN"]);
    for modifier in Modifier::ALL {
        let text = format!("25 H7 {modifier}");
        check(&text, &text);
        check(&format!("25 H7 {}", modifier.letters()), &text);
    }
    for (text, words) in [
        ("25 H7 (E)", "(E) requires the envelope of perfect form"),
        ("25 H7 (LP)", "(LP) requires every two-point size to lie within the limits: this is one diameter only"),
        ("25 H7 (GG)", "(GG) refers to the least-squares size: one diameter does not show it"),
        ("25 H7 (GX)", "(GX) refers to another size than the measured one"),
        ("25 H7 (CT)", "(CT) states where or how the size applies"),
    ] {
        let (code, out, error) = fitcheck(&["check", text, "--measured", "25.012", "--format", "json"]);
        assert_eq!(code, Some(0), "{error}");
        assert!(error.contains(words) && out.contains(words), "{text}: {out}{error}");
    }
    let circle = ["check", "25 H7 (LP)", "--simulate", "--format", "json"];
    assert!(fitcheck(&circle).1.contains("the least-squares diameter is only their mean"));
}

#[test]
fn general_tolerances_of_a_drawing_name_form_too() {
    check_all(&["10 mK", "10mK", "10 ISO 2768-mK", "10 ISO2768-mK", "10 DIN ISO 2768 - mK", "10 m-K"], "10mK");
    check_all(&["10 ISO 2768-m", "10 ISO 2768-1 m", "10 DIN ISO 2768-1-m", "Ø10 EN ISO 2768 m"], "10m");
    check("10 fH", "10fH");
    let (code, _, error) = fitcheck(&["check", "10 mK", "--measured", "10.1"]);
    assert_eq!(code, Some(0));
    assert!(error.contains("class K of ISO 2768-2 is for form and position"), "{error}");
    refused("ISO 2768-mK", &["does not begin with a nominal size"]);
}

#[test]
fn grades_are_read_around_a_size_and_refused_alone() {
    check_all(&["25 ±IT7/2", "25±IT7/2", "25 %%pIT7/2"], "25 ±0.0105");
    check("25 ±IT7", "25 ±0.021");
    refused("25 ±IT19/2", &["IT19 is not defined at 25 mm"]);
    let (code, _, error) = fitcheck(&["limits", "25 IT7"]);
    assert_eq!(code, Some(1));
    assert!(error.contains("IT7 is a grade") && error.contains("write ±IT7/2"), "{error}");
}

#[test]
fn what_is_no_callout_is_refused_with_its_own_reason() {
    for text in ["0.5in H7", "1/2\" H7", "1/2 in H7", "0,5 inch H7", "Ø .5\" H7", ".5'' H7", "½ in H7"] {
        let found = said::<Callout>(text);
        let is_half = !text.starts_with('½');
        assert_eq!(found.contains("is 12.7 mm: callouts are in millimetres, write 12.7 H7"), is_half, "{found}");
        assert!(found.starts_with("! "), "{found}");
    }
    refused("1-1/2\" H7/g6", &["is 38.1 mm", "write 38.1 H7/g6"]);
    refused("1 in +0.001/0", &["1 in is 25.4 mm: write size and tolerance in millimetres"]);
    refused("1/3\" H7", &["is in inches"]);
    refused("0\" H7", &["is in inches"]);
    refused("1/0\" H7", &["is in inches"]);
    for text in ["M6x1 6H", "M6", "2x M6", "Tr20x4 7e", "G1/2", "1/4-20 UNC-2B", "G 1/2"] {
        refused(text, &["is a thread", "minor or pitch diameter"]);
    }
    for text in ["[25]", "[Ø25 H7]", "25 TED", "25 BASIC"] {
        refused(text, &["theoretically exact"]);
    }
    for text in ["(25)", "(25 H7)", "(Ø25)", "25 REF"] {
        refused(text, &["for reference only"]);
    }
    for text in ["min 8", "8 min.", "max 8.2", "8 MAX", "≥ 8", "<8"] {
        refused(text, &["has one limit only", "8.2/8"]);
    }
    for text in ["Ra 0.8", "max Ra 0.8", "Rz6.3"] {
        refused(text, &["surface roughness"]);
    }
    refused("1 RC 4", &["RC4 is a class of ANSI B4.1"]);
    let (_, _, error) = fitcheck(&["limits", "25 RC4", "25 FN2", "25 LT3"]);
    assert_eq!(error.matches("is a class of ANSI B4.1, whose tables Fitcheck does not have").count(), 3, "{error}");
}

#[test]
fn the_partner_of_a_fit_may_have_deviations() {
    check_all(&["52 H7/0 -0.013", "52 H7 / 0/-0.013", "52H7/-0.013"], "52 H7/0 -0.013");
    check_all(&["2.5 ±0.1 / +0.008 +0.002", "2.5±0.1/+0.008+0.002"], "2.5 ±0.1/+0.008 +0.002");
    check("25 +0.021 0 / g6", "25 +0.021 0/g6");
    check("25 +0.021/0 / -0.007/-0.020", "25 +0.021 0/-0.007 -0.02");
    refused("52 0 -0.013 / H7", &["the shaft comes before the hole: write 52 H7/0 -0.013"]);
    refused("52 g6 / +0.03 0", &["the shaft comes before the hole: write 52 +0.03 0/g6"]);
    refused("5 H7/0 -6", &["minimum limit -1 mm is not above 0"]);
    let (code, out, _) = fitcheck(&["fit", "52 H7/0 -0.013", "--format", "json"]);
    assert_eq!(code, Some(0));
    for words in ["\"minimum_clearance_um\": 0", "\"maximum_clearance_um\": 43", "\"class\": null", "clearance"] {
        assert!(out.contains(words), "{words}: {out}");
    }
    let (code, out, _) = fitcheck(&["limits", "52 H7/0 -0.013"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("52.000 … 52.030 mm") && out.contains("51.987 … 52.000 mm"), "{out}");
}

#[test]
fn places_in_errors_are_those_of_the_text_as_given() {
    let error = "%%c25 H7 (E) x".parse::<Callout>().unwrap_err();
    assert_eq!((error.span(), error.text.as_str()), (Some(13..14), "%%c25 H7 (E) x"));
    let error = "2x ２５ Hh7".parse::<Callout>().unwrap_err();
    assert_eq!(error.span(), Some(6..9), "{error}");
}

/// Pieces of callouts, put together at random.
fn texts() -> impl Strategy<Value = String> {
    let pieces = [
        "25",
        "8.5",
        "0",
        ",",
        "H7",
        "g6",
        "m",
        "mK",
        "K",
        "/",
        " ",
        "  ",
        "(",
        ")",
        "[",
        "]",
        "+0.021",
        "-0.1",
        "±",
        "IT7",
        "/2",
        "2x",
        "4×",
        "(E)",
        "Ⓔ",
        "GG",
        "Ø",
        "φ",
        "%%c",
        "%%",
        "in",
        "\"",
        "'",
        "ISO 2768-",
        "2768",
        "min",
        "Ra",
        "M6",
        "RC",
        "-",
        "x",
        "½",
        "Ｈ",
        "\u{3000}",
    ];
    proptest::collection::vec(proptest::sample::select(pieces.to_vec()), 0..12).prop_map(|pieces| pieces.concat())
}

#[test]
fn a_size_of_class_x_is_no_count() {
    for (text, printed) in [("(E)2x", "2 x (E)"), ("2 x (+0.1 0)", "2 x (+0.1 0)")] {
        let callout: Callout = text.parse().unwrap();
        assert_eq!(callout.to_string().parse::<Callout>(), Ok(callout), "{text}");
        assert_eq!(printed.parse::<Callout>().map(|callout| callout.to_string()).as_deref(), Ok(printed), "{text}");
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused_and_what_is_read_reads_back(text in prop_oneof![texts(), ".{0,60}"]) {
        match text.parse::<Callout>() {
            Ok(callout) => {
                let printed = callout.to_string();
                prop_assert_eq!(printed.parse::<Callout>(), Ok(callout), "{} of {}", printed, text);
                for part in [Feature::Hole, Feature::Shaft] {
                    let part = callout.of_part(part);
                    prop_assert_eq!(part.to_string().parse::<Callout>(), Ok(part), "{} of {}", part, text);
                    let _limits = Sources::default().limits(&part, None);
                }
            }
            Err(error) => {
                let span = error.span();
                let length = text.chars().count();
                prop_assert!(span.is_none_or(|span| span.start <= length && span.end <= length), "{} of {}", error, text);
                prop_assert!(error.to_string().chars().count() < 500);
            }
        }
    }
}
