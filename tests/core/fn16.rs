//! FN 16 output read back through the mask that printed it.

use std::fmt::Write as _;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use fitcheck::control::mask::{Context, Mask, PrintMatch};
use fitcheck::control::variables::{Family, Parameter, Value, Variables};
use fitcheck::exchange::{ImportInputs, Item, import_from};
use fitcheck::journal::{Record, status_variables};
use fitcheck::length::Length;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::shipped;
use fitcheck::tolerance::{Callout, Sources};
use fitcheck::words::Dialogue;
use jiff::civil::{DateTime, date};
use proptest::prelude::*;

const NOW: DateTime = date(2026, 3, 7).at(8, 5, 9, 0);

fn samples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples")
}

fn mask(text: &str) -> Mask {
    Mask::read(text.as_bytes()).unwrap().0
}

/// What is said of each item: records as line, name, limits, measured value and status.
fn read(masks: &[(&str, &str)], bytes: &[u8]) -> Vec<String> {
    let masks: Vec<(String, Mask)> = masks.iter().map(|(name, text)| ((*name).to_owned(), mask(text))).collect();
    let sources = Sources::default();
    let mut said = Vec::new();
    let given = ImportInputs { masks: &masks, ..ImportInputs::new(&sources, NOW) };
    import_from("list.txt", &mut Cursor::new(bytes), given, &mut |item| {
        said.push(match item {
            Item::Record { line, record, .. } => told(line, &record),
            Item::Unjudged(unjudged) => {
                format!("{}: {} {}: {}", unjudged.line, unjudged.id, unjudged.measured.unwrap(), unjudged.why)
            }
            Item::Error(error) => error.to_string(),
            Item::Warning(warning) => format!("warning: {warning}"),
            Item::Contacts(_) => panic!("no contacts"),
        });
    });
    said
}

fn told(line: usize, record: &Record) -> String {
    let callout = record.callout.map(|callout| callout.to_string()).unwrap_or_default();
    let id = if record.id.is_empty() { String::new() } else { format!("{}: ", record.id) };
    let (limits, measured) = (&record.limits, record.measurement.diameter);
    let status = record.verdict.status();
    format!("{line}: {id}{callout} {}..{} {measured} {status}", limits.minimum(), limits.maximum())
}

#[track_caller]
fn check(mask: &str, text: &str, expected: &[&str]) {
    assert_eq!(read(&[("m.a", mask)], text.as_bytes()), expected, "{mask}\n{text}");
}

#[test]
fn the_sample_is_read_to_four_records() {
    let folder = samples().join("fn16");
    let mask = std::fs::read_to_string(folder.join("fit_list.a")).unwrap();
    let text = std::fs::read_to_string(folder.join("fit_list.txt")).unwrap();
    let expected = [
        "1: 25 H7 25..25.021 25.0134 GOOD",
        "2: 20 g6 19.98..19.993 19.9975 REWORK",
        "3: 18 K7 17.988..18.006 18.0085 SCRAP",
        "4: 10 JS7 9.9925..10.0075 10.0075 GOOD",
    ];
    check(&mask, &text, &expected);
    check(&mask, &text.replace('.', ","), &expected);
    check(&mask, &text.replace("\r\n", "\n"), &expected);
    check(&mask, &format!("\u{feff}{text}"), &expected);
    // Other parameters, so that the callout alone tells which number is which.
    let unknown = mask.replace("Q33", "Q1701").replace("Q23", "Q1702").replace("Q153", "Q1703").replace("QS3", "QS12");
    check(&unknown, &text, &expected);
}

#[test]
fn the_time_is_what_was_printed() {
    let folder = samples().join("fn16");
    let mask = mask(&std::fs::read_to_string(folder.join("fit_list.a")).unwrap());
    let masks = [("fit_list.a".to_owned(), mask)];
    let sources = Sources::default();
    let mut times = Vec::new();
    let text = std::fs::read(folder.join("fit_list.txt")).unwrap();
    import_from(
        "l.txt",
        &mut Cursor::new(text),
        ImportInputs { masks: &masks, ..ImportInputs::new(&sources, NOW) },
        &mut |item| {
            if let Item::Record { record, .. } = item {
                times.push(record.time.to_string());
            }
        },
    );
    assert_eq!(times, ["2024-03-14T08:05:00", "2024-03-14T08:07:00", "2024-03-14T08:09:00", "2024-03-14T08:12:00"]);
}

#[test]
fn the_status_windows_of_all_languages_read_back() {
    for language in Dialogue::ALL {
        let text = shipped::file(shipped::MASKS, &format!("82552_{language}.a")).unwrap();
        let text = String::from_utf8(text.to_vec()).unwrap();
        let mut printed = String::new();
        let mut expected = Vec::new();
        for (at, (callout, measured)) in
            [("25 H7", "25.0134"), ("20 g6", "19.9975"), ("18 K7", "18.0085"), ("10 JS7", "10.0075")]
                .into_iter()
                .enumerate()
        {
            let record = record(callout, measured);
            let context = Context { language, time: NOW, call_path: "" };
            printed += &mask(&text).render(&status_variables(&record, language), &context).unwrap().text;
            expected.push(told(1 + 5 * at, &record));
        }
        assert_eq!(read(&[("82552.a", &text)], printed.as_bytes()), expected, "{language}");
    }
}

fn record(callout: &str, measured: &str) -> Record {
    let callout: Callout = callout.parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), Origin::Typed);
    Record::judged(NOW, String::new(), Some(callout), limits, measurement, None)
}

#[test]
fn the_masks_of_other_cycles_read_back() {
    let text = |name: &str| {
        String::from_utf8(shipped::file(shipped::MASKS, &format!("{name}_en.a")).unwrap().to_vec()).unwrap()
    };
    let width = "WIDTH STATUS: GOOD\nCHECKED: 8 (426)\nMINIMUM WIDTH:   7.9000\nMAXIMUM WIDTH:   8.1000\n\
                 MEASURED WIDTH:   8.0120\nCENTRE LINE:   0.0010\n";
    let skipped = "warning: line 1: columns skipped: Q157";
    check(&text("width"), width, &[skipped, "1: 8 (426):  7.9..8.1 8.012 GOOD"]);
    let inside = width.replace("426", "425").replace("8.0120", "8.2000");
    let differs = "warning: line 1: the file says GOOD, but the limits say SCRAP";
    check(&text("width"), &inside, &[skipped, differs, "1: 8 (425):  7.9..8.1 8.2 SCRAP"]);
    check(
        &text("427"),
        "COORDINATE STATUS: GOOD\nCHECKED: X (427)\nMINIMUM LIMIT:  -1.0000\nMAXIMUM LIMIT:   1.0000\n\
         MEASURED COORDINATE:  -0.5000\n",
        &["1: X (427) -0.5: a coordinate of cycle 427, not a hole or shaft"],
    );
    let sides = read(
        &[("r.a", &text("rectangle"))],
        b"RECTANGLE STATUS: REWORK\nCHECKED: 40 x 20 (423)\nLIMITS 1ST SIDE:  39.9000/  40.1000\n\
          MEASURED 1ST SIDE:  39.8000\nLIMITS 2ND SIDE:  19.9000/  20.1000\nMEASURED 2ND SIDE:  20.0000\n",
    );
    assert!(sides.iter().any(|said| said.contains("Q154:  39.9..40.1 39.8 REWORK")), "{sides:?}");
    assert!(sides.iter().any(|said| said.contains("Q155:  19.9..20.1 20 GOOD")), "{sides:?}");
    let point = read(
        &[("p.a", &text("444"))],
        b"POINT STATUS: GOOD\nTOLERANCE: 0.4-0.1\nMEASURED 1ST AXIS:   1.0000\nMEASURED 2ND AXIS:   2.0000\n\
          MEASURED 3RD AXIS:   3.0000\nDEVIATION:   0.2000\n",
    );
    assert!(point.last().is_some_and(|said| said.starts_with("1:  0.2: ")), "{point:?}");
}

#[test]
fn a_status_that_contradicts_the_limits_is_a_warning() {
    check(
        "\"%S %S %9.4F\", QS3, QS2, Q153;",
        "GOOD 25 H7   25.0100\n",
        &[
            "line 1: m.a: line 1, column 5: QS3 and QS2 are texts with only blanks between them, so the output cannot be read back: a text may contain blanks",
        ],
    );
    check(
        "\"%S: %S %9.4F\", QS3, QS2, Q153;",
        "GOOD: 25 H7  25.0300\nSCRAP: 25 H7  25.0300\nAusschuss: 25 H7  25.0300\n",
        &[
            "warning: line 1: the file says GOOD, but the limits say SCRAP",
            "1: 25 H7 25..25.021 25.03 SCRAP",
            "2: 25 H7 25..25.021 25.03 SCRAP",
            "3: 25 H7 25..25.021 25.03 SCRAP",
        ],
    );
}

#[test]
fn a_mask_whose_print_has_two_readings_is_refused() {
    let refused = |text: &str| mask(text).inverse().map(|_| ()).unwrap_err().to_string();
    for (text, reason) in [
        ("\"%S%9.4F\", QS2, Q153;", "line 1, column 4: QS2 and Q153 are printed with nothing between them"),
        ("\"%D%D\", Q1, Q2;", "line 1, column 4: Q1 and Q2 are printed with nothing between them"),
        ("\"%S   %RS\", QS2, QS3;", "line 1, column 7: QS2 and QS3 are texts with only blanks between them"),
        ("\"%9.4F\", Q1;\n\"%9.4F\", Q2;", "no literal text marks where a record begins"),
        ("\"FIT %S\", QS2;", "the mask prints no number"),
        ("\"%D.%D.%D\", DAY, MONTH, YEAR4;", "the mask prints no number"),
    ] {
        assert!(refused(text).starts_with(reason), "{text}: {}", refused(text));
    }
    for text in ["\"%9.4F%9.4F\", Q1, Q2;", "\"%8.8S%9.4F\", QS2, Q153;", "\"%9.4F%S\", Q153, QS3;"] {
        assert!(mask(text).inverse().is_ok(), "{text}");
    }
    let measured = read(&[("m.a", "\"A %9.4F B %9.4F\", Q5, Q6;")], b"A 25.0000 B 25.0100\n");
    assert!(measured[0].contains("any of these could be the measured value: Q5, Q6"), "{measured:?}");
    let none = read(&[("m.a", "\"A %D %S\", Q5, QS2;")], b"A 25 25 H7\n");
    assert!(none[0].contains("m.a prints no measured value"), "{none:?}");
}

#[test]
fn a_mask_with_nearly_every_element_reads_back() {
    let text = std::fs::read_to_string(samples().join("masks/all_elements.a")).unwrap();
    for (remark, language) in [("", Dialogue::En), ("as is", Dialogue::De), ("", Dialogue::It), ("x", Dialogue::Nl)] {
        let mut variables = Variables::new();
        for (number, value) in
            [(1, "25"), (5, "3"), (10, "-0.0079"), (22, "8"), (23, "25.021"), (33, "25"), (153, "25.0134")]
        {
            variables.set(Parameter::q(number), Value::Length(value.parse().unwrap()));
        }
        variables.set("QL1".parse().unwrap(), Value::Number(-7.9));
        variables.set("QR3".parse().unwrap(), Value::Number(12.0));
        for (number, value) in [(2, "25 H7"), (3, "GOOD"), (4, "raw"), (9, remark)] {
            variables.set(Parameter::qs(number), Value::Text(value.to_owned()));
        }
        let context = Context { language, time: NOW, call_path: r"TNC:\PART.H" };
        let printed = mask(&text).render(&variables, &context).unwrap().text;
        let said = read(&[("all.a", &text)], printed.repeat(2).as_bytes());
        let records: Vec<&String> =
            said.iter().filter(|said| said.ends_with("25 H7 25..25.021 25.0134 GOOD")).collect();
        assert_eq!((records.len(), said.len()), (2, 3), "{said:?}\n{printed}");
    }
}

/// Found by the fuzz target `fn16`: such a character was taken for a blank.
#[test]
fn a_no_break_space_of_a_mask_is_a_character_of_it() {
    let mask = "\"%02d:%02d\u{a0}%10S\u{a0}mm %9.4F\", HOUR, MIN, QS2, Q153;";
    check(mask, "08:05\u{a0}     25 H7\u{a0}mm   25.0100\n", &["1: 25 H7 25..25.021 25.01 GOOD"]);
}

/// Found by the fuzz target `fn16`: a tab between two fields matched nothing, since the blanks before it took it along.
#[test]
fn tabs_of_a_mask_separate_its_fields() {
    let mask = "\"%S\t%9.4F\t%S\tmm\t%S\", QS2, Q153, QS3, QS12;";
    let printed = "25 H7\t  25.0100\tGOOD\tmm\tas is\n20 g6\t  19.9900\t\tmm\t\n";
    let expected = ["1: as is: 25 H7 25..25.021 25.01 GOOD", "2: 20 g6 19.98..19.993 19.99 GOOD"];
    check(mask, printed, &expected);
    check(mask, &printed.replace("mm\t\n", "mm\n"), &expected);
    // With two texts side by side, too: as many tabs as the mask has, and no fewer.
    let two = "\"%9.4F\t%S\t%S\", Q153, QS2, QS3;";
    check(two, "  25.0100\t25 H7\tGOOD\n", &["1: 25 H7 25..25.021 25.01 GOOD"]);
    check(two, "  25.0100\t\tGOOD\n", &["1:  25.01: not judged: no limits given"]);
}

/// Found by the fuzz target `fn16`: a text of which nothing is printed was taken for a hidden one.
#[test]
fn a_text_without_columns_is_not_a_hidden_one() {
    let mask = "M_EMPTY_HIDE;\n\"REMARK %.S\", QS9;\nM_EMPTY_SHOW;\n\"IS %9.4F %S\", Q153, QS2;";
    let printed = "REMARK \nIS   25.0100 25 H7\n";
    check(mask, printed, &["1: 25 H7 25..25.021 25.01 GOOD"]);
}

/// Found by the fuzz target `fn16`: the blank behind a number on the left of its width was taken for that of the mask, and the other
/// one for the text.
#[test]
fn blanks_that_fill_up_a_number_belong_to_it() {
    let mask = "\"%-3D %6.6S IS %-9.4F %5.5S\", Q1, QS2, Q153, QS3;";
    let expected = ["1: 25 H7 25..25.021 25.01 GOOD"];
    check(mask, "7   25 H7  IS 25.0100   GOOD \n", &expected);
    check(mask, "7 25 H7  IS 25.0100 GOOD\n", &expected);
}

#[test]
fn one_of_several_masks_is_found() {
    let (a, b) = ("\"A %S: %9.4F\", QS2, Q153;", "\"B %S: %9.4F\", QS2, Q153;");
    let text = b"B 25 H7:  25.0100\n";
    let expected = ["1: 25 H7 25..25.021 25.01 GOOD"];
    assert_eq!(read(&[("a.a", a), ("b.a", b)], text), expected);
    assert_eq!(read(&[("a.a", a)], text), ["line 1: none of the given masks prints such a file: a.a"]);
    let both = "line 1: several masks print such a file; give only the one that wrote it: a.a, b.a";
    assert_eq!(read(&[("a.a", "\"%S: %9.4F\", QS2, Q153;"), ("b.a", b)], text), [both]);
}

#[test]
fn records_of_several_lines_languages_and_hidden_texts() {
    let all = "L_ENGLISH;\n\"FIT %S\", QS2;\nL_GERMAN;\n\"PASSUNG %S\", QS2;\nL_ALL;\nM_EMPTY_HIDE;\n\"REMARK %S\", QS9;\n\
               M_EMPTY_SHOW;\n\"IS\\n%-12.4LF|%S\", Q153, QS3;\nM_APPEND;\nM_CLOSE;\n";
    let text = "FIT 25 H7\nREMARK ok\nIS\n25.0100     |GOOD\n\nPASSUNG 20 g6\nIS\n19.9900     |GUT\n\
                somebody's own line\nFIT 25 H7\nIS\n25.0500     |SCRAP\nFIT 18 K7\nIS\nFIT 18 K7\nIS\n18.0000|\n";
    check(
        all,
        text,
        &[
            "1: ok: 25 H7 25..25.021 25.01 GOOD",
            "6: 20 g6 19.98..19.993 19.99 GOOD",
            "warning: line 9: skipped, not a measurement: somebody's own line",
            "10: 25 H7 25..25.021 25.05 SCRAP",
            "line 15: the record ends too early: expected the output of line 9 of the mask",
            "15: 18 K7 17.988..18.006 18 GOOD",
        ],
    );
}

#[test]
fn printed_limits_with_fewer_digits_are_those_of_the_callout() {
    check(
        "\"%S: %8.3F %8.3F %8.4F\", QS2, Q33, Q23, Q153;",
        "10 JS7:    9.993   10.008  10.0076\n",
        &["1: 10 JS7 9.9925..10.0075 10.0076 SCRAP"],
    );
    let other =
        read(&[("m.a", "\"%S: %8.3F %8.3F %8.4F\", QS2, Q33, Q23, Q153;")], b"10 JS7:    9.990   10.010  10.0076\n");
    assert!(
        other[0].contains("10 JS7") && other[0].starts_with("warning") && other[1].contains("9.99..10.01"),
        "{other:?}"
    );
}

#[test]
fn a_measured_value_that_lies_on_a_limit_is_not_taken_for_the_limit() {
    let mask = "\"%8S MIN %9.4LF MAX %9.4LF IST %9.4LF LAST %9.4LF\", QS2, Q101, Q102, Q103, Q104;";
    let print = |callout, minimum, maximum, actual, last| {
        format!("{callout:>8} MIN {minimum:9.4} MAX {maximum:9.4} IST {actual:9.4} LAST {last:9.4}\n")
    };
    let on_limit = print("25 H7", 25.0, 25.021, 25.0, 25.015);
    let said = read(&[("own.a", mask)], on_limit.as_bytes());
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(said[0].contains("any of these could be the measured value: Q101, Q102, Q103, Q104"), "{said:?}");
    // Two callouts tell the limits, and what is left is still more than one.
    let both = on_limit + &print("10 g6", 9.986, 9.995, 9.991, 25.015);
    let said = read(&[("own.a", mask)], both.as_bytes());
    assert!(said[0].contains("any of these could be the measured value: Q103, Q104"), "{said:?}");
    let three = mask.replace(" LAST %9.4LF", "").replace(", Q104", "");
    let text: Vec<&str> = both.lines().map(|line| line.split(" LAST").next().unwrap()).collect();
    let text = text.join("\n") + "\n";
    let expected = ["1: 25 H7 25..25.021 25 GOOD", "2: 10 g6 9.986..9.995 9.991 GOOD"];
    check(&three, &text, &expected);
}

#[test]
fn a_value_with_fewer_decimals_than_a_limit_beside_it_is_not_judged() {
    let mask = "\"%8S IST %9.2LF %S\", QS2, Q153, QS3;";
    let said = |text: &str| read(&[("m.a", mask)], text.as_bytes());
    // 25.02 is printed of 25.015 to 25.025, and the limit is 25.021.
    let near = said("   25 H7 IST     25.02 GOOD\n");
    assert!(near[0].contains("any value from 25.015 to 25.025"), "{near:?}");
    assert_eq!(said("   25 H7 IST     25.01 GOOD\n"), ["1: 25 H7 25..25.021 25.01 GOOD"]);
    // On a limit with as many decimals the figures decide, unless the control says otherwise.
    assert_eq!(said("   25 H7 IST     25.00 GOOD\n"), ["1: 25 H7 25..25.021 25 GOOD"]);
    let denied = said("   25 H7 IST     25.00 REWORK\n");
    assert!(denied[0].contains("any value from 24.995 to 25.005"), "{denied:?}");
}

#[test]
fn a_file_that_was_cut_off_anywhere_keeps_its_whole_records() {
    let text = "STATUS: GOOD\nFIT: 25 H7\nMEASURED:  25.0134\n".repeat(2);
    let mask = "\"STATUS: %S\", QS3;\n\"FIT: %S\", QS2;\n\"MEASURED:%9.4LF\", Q153;";
    for end in 1..=text.len() {
        let said = read(&[("m.a", mask)], &text.as_bytes()[..end]);
        let whole = (end + 1) / (text.len() / 2);
        let records = said.iter().filter(|said| said.ends_with("25.0134 GOOD")).count();
        assert_eq!(records, whole, "{end}: {said:?}");
        assert!(whole == said.len() || said.len() <= whole + 2, "{end}: {said:?}");
    }
}

#[test]
fn any_bytes_are_refused_or_told() {
    let mask = "\"%S %9.4F\", QS2, Q153;";
    for bytes in [&b"\x00\x01\x02"[..], b"\xff\xfe2\x005\x00", &vec![b'a'; 100_000], &vec![0; 100_000], b"25 H7 25.0"] {
        let said = read(&[("m.a", mask)], bytes);
        assert_eq!(said, ["line 1: none of the given masks prints such a file: m.a"]);
    }
    let utf16: Vec<u8> = "\u{feff}25 H7 25.0100\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(read(&[("m.a", mask)], &utf16), ["1: 25 H7 25..25.021 25.01 GOOD"]);
    let latin = encoding_rs::WINDOWS_1252.encode("GRÖSSE 25 H7 25,0100\r\n").0.into_owned();
    assert_eq!(read(&[("m.a", "\"GRÖSSE %S %9.4F\", QS2, Q153;")], &latin), ["1: 25 H7 25..25.021 25.01 GOOD"]);
}

#[test]
fn a_mask_made_to_take_for_ever_ends_soon() {
    let fields: Vec<String> = (1..30).map(|number| format!("QS{number}")).collect();
    let slow = format!("\"{}x %9.4F\", {}, Q153;", "%S,".repeat(29), fields.join(", "));
    let hidden = format!("M_EMPTY_HIDE;\n{}\"A %9.4F\", Q153;", "\"%S\", QS1;\n".repeat(190));
    for mask in [slow, hidden] {
        // A search without a bound takes years; what is bounded takes a second.
        let begin = std::time::Instant::now();
        let said = read(&[("m.a", &mask)], format!("{}\n", ",".repeat(1000)).repeat(60).as_bytes());
        assert!(!said.is_empty() && begin.elapsed() < std::time::Duration::from_mins(1), "{:?}", begin.elapsed());
    }
}

#[test]
fn the_command_line_reads_through_masks() {
    let folder = samples().join("fn16");
    let run = |arguments: &[&str]| {
        let output = Command::cargo_bin("fitcheck")
            .unwrap()
            .current_dir(&folder)
            .arg("import")
            .args(arguments)
            .output()
            .unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
    };
    let (code, out, err) = run(&["--mask", "fit_list.a", "fit_list.txt", "--format", "csv"]);
    assert_eq!((code, err.as_str(), out.lines().count()), (11, "", 5), "{out}");
    let (code, _, err) = run(&["--mask", "missing.a", "fit_list.txt"]);
    assert!(code == 1 && err.contains("no such file"), "{err}");
}

/// A field of a random mask, what it is given, and what reads back.
#[derive(Debug, Clone)]
struct Field {
    literal: String,
    format: String,
    parameter: Parameter,
    value: Value,
    expected: String,
}

fn field(number: u16) -> impl Strategy<Value = Field> {
    let literal = prop::sample::select(vec!["A", "B: ", " C=", " / ", "Ø ", " |", "9 x ", " ", "\t", "\tD", "E \t"]);
    let number_value =
        (-40_000_000_i64..40_000_000, 1_usize..7, 0_usize..14, prop::sample::select(vec!["", "-", "+", "0"]));
    let text = ("[A-Z0-9][A-Z0-9 .]{0,6}[A-Z0-9]|", 0_usize..12, prop::sample::select(vec!["", "-"]), any::<bool>());
    (literal, number_value, text, any::<bool>()).prop_map(move |(literal, number_of, text_of, is_text)| {
        let literal = literal.to_owned();
        if is_text {
            let (text, width, flag, is_raw) = text_of;
            let format = if is_raw {
                "%RS".to_owned()
            } else {
                format!("%{flag}{}S", if width == 0 { String::new() } else { width.to_string() })
            };
            let value = Value::Text(text.clone());
            return Field { literal, format, parameter: Parameter::qs(number), value, expected: text };
        }
        let (nm, digits, width, flag) = number_of;
        let unit = 10_i64.pow(u32::try_from(6 - digits).unwrap());
        let length = Length::from_nanometres(nm / unit * unit).unwrap();
        let format = format!("%{flag}{}.{digits}F", if width == 0 { String::new() } else { width.to_string() });
        Field {
            literal,
            format,
            parameter: Parameter::q(number),
            value: Value::Length(length),
            expected: length.to_string(),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// What is printed reads back as the same values, or is told to have two readings; a mask that is refused prints nothing that could.
    #[test]
    fn what_a_mask_prints_reads_back(
        records in prop::collection::vec((0_u16..9).prop_flat_map(|first| prop::collection::vec(field(first), 1..4)), 1..4),
        comma in any::<bool>(),
    ) {
        let mut number = 0;
        let (mut text, mut variables, mut expected) = (String::new(), Variables::new(), Vec::new());
        for fields in &records {
            let mut formats = String::new();
            let mut names = String::new();
            for field in fields {
                number += 1;
                let parameter = Parameter { number, ..field.parameter };
                write!(formats, "{}{}", field.literal, field.format).unwrap();
                write!(names, ", {parameter}").unwrap();
                variables.set(parameter, field.value.clone());
                expected.push((parameter.family == Family::Q, field.expected.clone()));
            }
            writeln!(text, "\"{formats}\"{names};").unwrap();
        }
        let mask = mask(&text);
        if let Ok(inverse) = mask.inverse() {
            let context = Context { language: Dialogue::En, time: NOW, call_path: "" };
            let printed = mask.render(&variables, &context).unwrap().text;
            let printed = if comma { printed.replace('.', ",") } else { printed };
            let lines: Vec<&str> = printed.lines().collect();
            match inverse.at(&lines) {
                PrintMatch::Printed(found) => {
                    prop_assert_eq!(found.lines, records.len());
                    for ((is_number, expected), (_, value)) in expected.iter().zip(&found.values) {
                        if *is_number {
                            prop_assert_eq!(&value.parse::<Length>().unwrap().to_string(), expected, "{}\n{}", text, printed);
                        } else {
                            let expected = if comma { expected.replace('.', ",") } else { expected.clone() };
                            prop_assert_eq!(value, &expected, "{}\n{}", text, printed);
                        }
                    }
                }
                PrintMatch::Ambiguous(_) => {}
                other => prop_assert!(false, "{other:?}\n{text}\n{printed}"),
            }
        }
    }
}
