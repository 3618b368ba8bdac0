//! FN 16 masks: the samples, the built-in masks byte for byte, and what is refused.

use std::collections::BTreeSet;

use fitcheck::control::mask::{Context, FileUse, Mask};
use fitcheck::control::status::shipped_mask;
use fitcheck::control::variables::{Family, Parameter, Value, Variables};
use fitcheck::journal::{Record, status_variables, status_window};
use fitcheck::length::Length;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::shipped;
use fitcheck::tolerance::{Callout, Deviations, Limits, Source};
use fitcheck::verdict::{Status, doubt, judge};
use fitcheck::words::Dialogue;
use jiff::civil::{DateTime, date};

fn time() -> DateTime {
    date(2026, 3, 7).at(8, 5, 9, 0)
}

fn sample(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/data/samples/masks/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// A record of 25 H7, or of any other size with a zone of this many micrometres above it.
fn record(callout: &str, upper_um: i32, measured: &str) -> Record {
    let callout: Callout = callout.parse().unwrap();
    let measured: Length = measured.parse().unwrap();
    let deviations = Deviations::new(Length::from_micrometres(upper_um), Length::ZERO).unwrap();
    let source = Source::File("test".into());
    let limits = Limits::new(callout.feature().unwrap(), callout.nominal(), deviations, source).unwrap();
    Record {
        time: time(),
        id: String::new(),
        callout: Some(callout),
        verdict: judge(&limits, measured, None),
        doubt: doubt(&limits, measured),
        correction: None,
        budget: None,
        limits,
        measurement: Measurement::of_diameter(measured, Origin::Typed),
    }
}

fn render(mask: &[u8], variables: &Variables, language: Dialogue) -> Result<String, String> {
    let (mask, _) = Mask::read(mask).map_err(|error| error.to_string())?;
    let context = Context { language, time: time(), call_path: r"TNC:\PART.H" };
    mask.render(variables, &context).map(|output| output.text).map_err(|error| error.to_string())
}

/// What printf of C prints.
#[test]
fn whole_numbers_with_a_least_number_of_digits_are_not_filled_with_zeros() {
    let mut variables = Variables::new();
    variables.set(Parameter::q(1), Value::Number(7.0));
    for (format, expected) in [("%05D", "00007"), ("%05.3D", "  007"), ("%+06.2I", "   +07"), ("%-05.3D|", "007  |")] {
        let mask = format!("\"{format}\", Q1;");
        assert_eq!(render(mask.as_bytes(), &variables, Dialogue::En), Ok(format!("{expected}\n")), "{format}");
    }
}

#[test]
fn the_shipped_dutch_mask_is_that_of_nc_solution_8255_byte_for_byte() {
    let shipped = include_str!("../../assets/masks/82552_nl.a");
    assert_eq!(
        shipped,
        "\"STATUS VAN DE PASSING: %S\", QS3\n\"GEPRUEFTE PASSUNG: %S\", QS2;\n\"MINIMALE MAAT:%9.4LF\", Q33;\n\
         \"MAXIMALE MAAT:%9.4LF\", Q23;\n\"GEMETEN DIAMETER:%9.4LF\", Q153;\nM_CLOSE;\n"
    );
    let (_, warnings) = Mask::read(shipped.as_bytes()).unwrap();
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(warnings, ["line 1: the ; at the end is missing"]);
}

#[test]
fn the_status_window_in_all_languages_and_for_all_statuses() {
    let expected = [
        (
            Dialogue::Nl,
            "25.012",
            "STATUS VAN DE PASSING: GOED\nGEPRUEFTE PASSUNG: 25 H7\nMINIMALE MAAT:  25.0000\nMAXIMALE MAAT:  25.0210\nGEMETEN DIAMETER:  25.0120\n",
        ),
        (
            Dialogue::Nl,
            "24.998",
            "STATUS VAN DE PASSING: Nabewerking\nGEPRUEFTE PASSUNG: 25 H7\nMINIMALE MAAT:  25.0000\nMAXIMALE MAAT:  25.0210\nGEMETEN DIAMETER:  24.9980\n",
        ),
        (
            Dialogue::Nl,
            "25.030",
            "STATUS VAN DE PASSING: Afgekeurd\nGEPRUEFTE PASSUNG: 25 H7\nMINIMALE MAAT:  25.0000\nMAXIMALE MAAT:  25.0210\nGEMETEN DIAMETER:  25.0300\n",
        ),
        (
            Dialogue::De,
            "25.012",
            "STATUS DER PASSUNG: GUT\nGEPRUEFTE PASSUNG: 25 H7\nMINDESTMASS:  25.0000\nHOECHSTMASS:  25.0210\nGEMESSENER DURCHMESSER:  25.0120\n",
        ),
        (
            Dialogue::De,
            "24.998",
            "STATUS DER PASSUNG: Nacharbeit\nGEPRUEFTE PASSUNG: 25 H7\nMINDESTMASS:  25.0000\nHOECHSTMASS:  25.0210\nGEMESSENER DURCHMESSER:  24.9980\n",
        ),
        (
            Dialogue::De,
            "25.030",
            "STATUS DER PASSUNG: Ausschuss\nGEPRUEFTE PASSUNG: 25 H7\nMINDESTMASS:  25.0000\nHOECHSTMASS:  25.0210\nGEMESSENER DURCHMESSER:  25.0300\n",
        ),
        (
            Dialogue::En,
            "25.012",
            "FIT STATUS: GOOD\nCHECKED FIT: 25 H7\nMINIMUM SIZE:  25.0000\nMAXIMUM SIZE:  25.0210\nMEASURED DIAMETER:  25.0120\n",
        ),
        (
            Dialogue::En,
            "24.998",
            "FIT STATUS: REWORK\nCHECKED FIT: 25 H7\nMINIMUM SIZE:  25.0000\nMAXIMUM SIZE:  25.0210\nMEASURED DIAMETER:  24.9980\n",
        ),
        (
            Dialogue::En,
            "25.030",
            "FIT STATUS: SCRAP\nCHECKED FIT: 25 H7\nMINIMUM SIZE:  25.0000\nMAXIMUM SIZE:  25.0210\nMEASURED DIAMETER:  25.0300\n",
        ),
        (
            Dialogue::It,
            "25.012",
            "STATO ACCOPPIAMENTO: BUONO\nACCOPPIAMENTO CONTROLLATO: 25 H7\nDIMENSIONE MINIMA:  25.0000\nDIMENSIONE MASSIMA:  25.0210\nDIAMETRO MISURATO:  25.0120\n",
        ),
        (
            Dialogue::It,
            "24.998",
            "STATO ACCOPPIAMENTO: Ripresa\nACCOPPIAMENTO CONTROLLATO: 25 H7\nDIMENSIONE MINIMA:  25.0000\nDIMENSIONE MASSIMA:  25.0210\nDIAMETRO MISURATO:  24.9980\n",
        ),
        (
            Dialogue::It,
            "25.030",
            "STATO ACCOPPIAMENTO: Scarto\nACCOPPIAMENTO CONTROLLATO: 25 H7\nDIMENSIONE MINIMA:  25.0000\nDIMENSIONE MASSIMA:  25.0210\nDIAMETRO MISURATO:  25.0300\n",
        ),
    ];
    for (language, measured, text) in expected {
        assert_eq!(status_window(&record("25 H7", 21, measured), language, None).unwrap(), text);
    }
}

#[test]
fn the_fit_is_written_with_only_the_decimals_it_has() {
    for (typed, printed) in
        [("25 H7", "25 H7"), ("25.50H7", "25.5 H7"), ("25,0 h6", "25 h6"), ("0.125 JS7", "0.125 JS7")]
    {
        let variables = status_variables(&record(typed, 10, "25"), Dialogue::En);
        assert_eq!(variables.get(Parameter::qs(2)), Some(&Value::Text(printed.to_owned())));
    }
}

#[test]
fn exactly_one_status_marker_is_set() {
    for measured in ["25.012", "24.998", "25.030"] {
        let record = record("25 H7", 21, measured);
        let variables = status_variables(&record, Dialogue::En);
        let set: Vec<u16> =
            (180..183).filter(|number| variables.get(Parameter::q(*number)) == Some(&Value::Number(1.0))).collect();
        let expected = match record.verdict.status() {
            Status::Good => 180,
            Status::Rework => 181,
            _ => 182,
        };
        assert_eq!(set, [expected]);
    }
}

#[test]
fn the_sample_masks_print_their_expected_texts() {
    let window = status_window(
        &record("25 H7", 21, "25.0134"),
        Dialogue::En,
        Some(&Mask::read(&sample("status_en.a")).unwrap().0),
    );
    assert_eq!(window.unwrap().as_bytes(), sample("status_en.expected.txt"));
    let (mask, warnings) = Mask::read(&sample("defects.a")).unwrap();
    let lines: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        lines,
        [
            "line 1: the ; at the end is missing",
            "line 3: the ; at the end is missing",
            "line 4: the ; at the end is missing"
        ]
    );
    let window = status_window(&record("10 H7", 15, "9.99"), Dialogue::En, Some(&mask)).unwrap();
    assert_eq!(window.as_bytes(), sample("defects.expected.txt"));
    let german = Mask::read(&sample("status_de_latin1_crlf.a")).unwrap().0;
    let window = status_window(&record("25 H7", 21, "25.012"), Dialogue::De, Some(&german)).unwrap();
    assert_eq!(
        window,
        "STATUS DER PASSUNG: GUT\nGEPRÜFTE PASSUNG: 25 H7\nKLEINSTMAß:  25.0000\nGRÖßTMAß:  25.0210\nGEMESSENER Ø:  25.0120\n"
    );
}

#[test]
fn every_element_of_the_grammar_prints() {
    let mut variables = Variables::new();
    let text = |text: &str| Value::Text(text.to_owned());
    let length = |mm: &str| Value::Length(mm.parse().unwrap());
    for (number, value) in [(2, text("25 H7")), (3, text("GOOD")), (4, text("raw  %S text")), (9, text(""))] {
        variables.set(Parameter::qs(number), value);
    }
    for (number, value) in [
        (1, length("25")),
        (5, Value::Number(3.0)),
        (10, Value::Number(13.4)),
        (22, Value::Number(8.0)),
        (23, length("25.021")),
        (33, length("25")),
        (153, length("25.0134")),
    ] {
        variables.set(Parameter::q(number), value);
    }
    variables.set(Parameter { family: Family::Ql, number: 1 }, Value::Number(63.81));
    variables.set(Parameter { family: Family::Qr, number: 3 }, Value::Number(12.0));
    let printed = render(&sample("all_elements.a"), &variables, Dialogue::En).unwrap();
    let expected = [
        "FIT REPORT 07-03-2026 08:05:09",
        r"PROGRAM: TNC:\PART.H",
        "FIT:     25 H7       |",
        "RAW:     raw  %S text",
        "NOMINAL:   25.0000 mm",
        "MINIMUM:   25.0000 mm",
        "MAXIMUM:   25.0210 mm",
        "ACTUAL:   +25.0134 mm",
        "DEV:        13.400 um =   63.8 %",
        "COUNT:   3 of 12, row 008",
        r#"QUOTE "ok" BACKSLASH \ SECOND LINE"#,
        "BEGINS HERE",
        "",
        "STATUS:  GOOD",
    ];
    assert_eq!(printed, expected.map(|line| format!("{line}\n")).concat());
    for (language, first) in [
        (Dialogue::De, "PASSUNGSBERICHT 07.03.26"),
        (Dialogue::Nl, "PASSINGSRAPPORT"),
        (Dialogue::It, "RAPPORTO ACCOPPIAMENTO"),
    ] {
        let printed = render(&sample("all_elements.a"), &variables, language).unwrap();
        assert_eq!(printed.lines().next(), Some(first));
    }
    variables.set(Parameter::qs(9), text("note"));
    let printed = render(&sample("all_elements.a"), &variables, Dialogue::En).unwrap();
    assert_eq!(printed.lines().count(), 15);
}

#[test]
fn file_words_are_told_apart() {
    let used = |mask: &str| {
        let (mask, _) = Mask::read(mask.as_bytes()).unwrap();
        let context = Context { language: Dialogue::En, time: time(), call_path: "" };
        let output = mask.render(&Variables::new(), &context).unwrap();
        (output.file, output.close)
    };
    assert_eq!(used("\"x\";\nM_CLOSE;\n"), (FileUse::Replace, true));
    assert_eq!(used("\"x\";\nM_APPEND;\n"), (FileUse::Append, false));
    assert_eq!(used("\"x\";\nM_APPEND_MAX20;\n"), (FileUse::AppendMax(20), false));
    assert_eq!(used("\"x\";\nM_TRUNCATE;\nM_CLOSE\n"), (FileUse::Replace, true));
}

#[test]
fn a_mask_that_cannot_be_read_says_where_and_why() {
    let q = |mask: &str| render(mask.as_bytes(), &Variables::new(), Dialogue::En).unwrap_err();
    assert_eq!(q(""), "the mask is empty");
    assert_eq!(q("* only a comment\n"), "the mask is empty");
    assert_eq!(q("\"A %X\", Q1;"), "line 1, column 4: %X is not a format: allowed are %S %RS %F %LF %D %I %%");
    assert_eq!(q("* c\n\"A %S, QS1;"), "line 2, column 1: the quotation mark is not closed");
    assert_eq!(q("\"%S %S\", QS1;"), "line 1: 2 formats and 1 parameters");
    assert_eq!(q("\"text\", QS1;"), "line 1: 0 formats and 1 parameters");
    assert_eq!(
        q("\"100 %\";"),
        "line 1, column 6: % is not a format: allowed are %S %RS %F %LF %D %I %%".replace("% is", "%\" is")
    );
    assert_eq!(q("\"%F\", Z1;").split(": allowed").next(), Some("line 1, column 7: Z1 is not a parameter"));
    assert_eq!(q("\"%F\", Q;").split(": allowed").next(), Some("line 1, column 7: Q is not a parameter"));
    assert_eq!(q("\"%999999999F\", Q1;"), "line 1, column 2: 999999999 is too wide: at most 255");
    assert_eq!(q("hello"), "line 1, column 1: hello is not a record, keyword or comment");
    assert_eq!(q("\"%F\", Q7;"), "line 1, column 2: Q7 is not defined");
}

#[test]
fn quotation_marks_within_a_record_are_printed() {
    let printed = |mask: &str| render(mask.as_bytes(), &Variables::new(), Dialogue::En);
    for mask in ["\"A %\"b; c%\" d\";", "\"A %\\\"b; c%\\\" d\";", "\"A \\\"b; c\\\" d\";"] {
        assert_eq!(printed(mask).unwrap(), "A \"b; c\" d\n", "{mask}");
    }
}

#[test]
fn text_that_would_be_lost_is_refused() {
    let refused = |mask: &str| Mask::read(mask.as_bytes()).unwrap_err().to_string();
    assert_eq!(refused("\"A\" \"%F\", Q1;"), "line 1, column 5: \"%F\", Q1; is not a record, keyword or comment");
    assert_eq!(refused("\"%S\", QS3 QS2;"), "line 1, column 11: QS2; is not a record, keyword or comment");
}

#[test]
fn hiding_empty_texts_does_not_hide_an_undefined_one() {
    let mask = b"M_EMPTY_HIDE;\n\"STATUS: %S %S\", QS3, QS9;\n";
    let mut variables = Variables::new();
    variables.set(Parameter::qs(3), Value::Text("SCRAP".to_owned()));
    assert_eq!(render(mask, &variables, Dialogue::En).unwrap_err(), "line 2, column 13: QS9 is not defined");
    variables.set(Parameter::qs(9), Value::Text(String::new()));
    assert_eq!(render(mask, &variables, Dialogue::En).unwrap(), "");
}

#[test]
fn a_huge_mask_is_refused_before_it_fills_the_memory() {
    let refused = |mask: &[u8]| Mask::read(mask).unwrap_err().to_string();
    assert_eq!(refused(&b"M_\n".repeat(1 << 20)), "the mask is larger than 1024 KiB");
    // One line of a million quotation marks takes no longer than any other mask.
    let quotes = ["\"", &"%\"".repeat((1 << 19) - 4), "\";"].concat();
    assert!(Mask::read(quotes.as_bytes()).is_ok());
}

#[test]
fn deviations_in_micrometres_are_exact() {
    // 0.5015 mm times 1000 is 501.49999999999994 in binary arithmetic.
    let variables = status_variables(&record("25 H7", 0, "25"), Dialogue::En);
    assert_eq!(variables.get(Parameter::q(4)), Some(&Value::Number(0.0)));
    let mut record = record("25 H7", 0, "25");
    let deviations = Deviations::new("0.5015".parse().unwrap(), "-1.0235".parse().unwrap()).unwrap();
    record.limits.deviations = deviations;
    let printed = |record: &Record| {
        render(b"\"%.0F %.1F\", Q4, Q5;", &status_variables(record, Dialogue::En), Dialogue::En).unwrap()
    };
    assert_eq!(printed(&record), "502 -1023.5\n");
}

#[test]
fn a_parameter_of_the_other_kind_is_refused() {
    let mut variables = Variables::new();
    variables.set(Parameter::qs(1), Value::Text("H7".to_owned()));
    variables.set(Parameter::q(1), Value::Number(1.0));
    let q = |mask: &str| render(mask.as_bytes(), &variables, Dialogue::En).unwrap_err();
    assert_eq!(q("\"%F\", QS1;"), "line 1, column 2: QS1 is a text, the format needs a number");
    assert_eq!(q("\"x%S\", Q1;"), "line 1, column 3: Q1 is a number, the format needs a text");
}

#[test]
fn no_bytes_make_the_reader_panic() {
    proptest::proptest!(|(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..200))| {
        if let Ok((mask, _)) = Mask::read(&bytes) {
            let context = Context { language: Dialogue::En, time: time(), call_path: "" };
            let _rendered = mask.render(&Variables::new(), &context);
        }
    });
    proptest::proptest!(|(text in "[\"%\\\\SFDLR0-9., ;QMn*\n-]{0,60}")| {
        let _read = Mask::read(text.as_bytes());
    });
}

#[test]
fn every_language_has_its_shipped_mask() {
    for language in Dialogue::ALL {
        assert!(
            shipped_mask(language)
                .render(
                    &status_variables(&record("25 H7", 21, "25"), language),
                    &Context { language, time: time(), call_path: "" }
                )
                .is_ok()
        );
    }
}

/// A file for one dialogue language, such as `82552_nl.a` and `nl.toml`, exists for all; a missing one is named.
#[test]
fn every_dialogue_has_every_mask_program_page_and_its_words() {
    let lists = [
        ("assets/masks", shipped::MASKS),
        ("assets/nc", shipped::NC),
        ("assets/dialogues", shipped::DIALOGUES),
        ("assets/logs", shipped::LOGS),
    ];
    let (mut found, mut missing) = (0, BTreeSet::new());
    for (folder, list) in lists {
        for (name, _) in list {
            let (stem, ending) = name.rsplit_once('.').unwrap();
            let mut befores = Dialogue::ALL.into_iter().filter_map(|dialogue| stem.strip_suffix(dialogue.code()));
            let Some(before) = befores.find(|before| before.is_empty() || before.ends_with('_')) else { continue };
            found += 1;
            let names = Dialogue::ALL.map(|dialogue| format!("{before}{dialogue}.{ending}"));
            missing.extend(
                names.into_iter().filter(|name| shipped::file(list, name).is_none()).map(|name| (folder, name)),
            );
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(32 <= found, "{found}");
    assert_eq!(Dialogue::ALL.map(Dialogue::name), ["English", "Nederlands", "Deutsch", "Italiano"]);
}
