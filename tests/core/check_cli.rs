//! `fitcheck check`: verdict, mask, sources of the diameter, machine formats, refusals and exit codes.

#![cfg(test)]

use std::path::{Path, PathBuf};

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::{Value, json};
use tempfile::TempDir;

/// The answer of the program: exit code, standard output, standard error.
#[derive(Debug, PartialEq, Eq)]
struct Answer {
    code: i32,
    out: String,
    err: String,
}

fn run_with_input(args: &[&str], input: &str) -> Answer {
    let output = cargo_bin_cmd!("fitcheck").arg("check").args(args).write_stdin(input).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Answer { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
}

fn run(args: &[&str]) -> Answer {
    run_with_input(args, "")
}

/// Exit code and standard error of a typed diameter.
#[track_caller]
fn check(callout: &str, measured: &str, code: i32, err: &str) {
    let answer = run(&[callout, "--measured", measured]);
    assert_eq!((answer.code, answer.err.as_str()), (code, err), "{callout} = {measured}");
}

/// Bad data: exit code 1, nothing on standard output, one sentence on standard error.
#[track_caller]
fn refused(args: &[&str], reason: &str) {
    let expected = Answer { code: 1, out: String::new(), err: format!("fitcheck: {reason}\n") };
    assert_eq!(run(args), expected, "{args:?}");
}

fn json_of(args: &[&str]) -> Value {
    let answer = run(&[args, &["--format", "json"]].concat());
    serde_json::from_str(&answer.out).unwrap_or_else(|error| panic!("{error}: {answer:?}"))
}

fn file(text: &str, name: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fitcheck::files::write(&path, text.as_bytes()).unwrap();
    (folder, path)
}

fn sample(path: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples").join(path).display().to_string()
}

/// Four contacts on a circle of 25.012 mm around 10, −5.
const FOUR: &str = "x,y\n22.506,-5\n10,7.506\n-2.506,-5\n10,-17.506\n";

#[test]
fn the_dutch_status_window_is_that_of_nc_solution_8255_byte_for_byte() {
    let expected = "STATUS VAN DE PASSING: GOED\nGEPRUEFTE PASSUNG: 25 H7\nMINIMALE MAAT:  25.0000\n\
                    MAXIMALE MAAT:  25.0210\nGEMETEN DIAMETER:  25.0120\n";
    let answer = run(&["25 H7", "--measured", "25.012", "--mask", "nl"]);
    assert_eq!(answer, Answer { code: 0, out: expected.to_owned(), err: String::new() });
}

#[test]
fn the_status_word_is_the_masks() {
    for (measured, nl, en) in
        [("25.012", "GOED", "GOOD"), ("24.998", "Nabewerking", "REWORK"), ("25.030", "Afgekeurd", "SCRAP")]
    {
        let first =
            |mask| run(&["25 H7", "--measured", measured, "--mask", mask]).out.lines().next().map(str::to_owned);
        assert_eq!(first("nl"), Some(format!("STATUS VAN DE PASSING: {nl}")));
        assert_eq!(first("en"), Some(format!("FIT STATUS: {en}")));
    }
}

#[test]
fn the_exit_code_is_the_verdict_and_rework_says_how_much_to_remove() {
    check("25 H7", "25.012", 0, "");
    check("25 H7", "24.998", 10, "remove 0.002 mm to the nearest limit, 0.0125 mm to the middle of the zone\n");
    check("25 H7", "25.030", 11, "");
    // A shaft is the other way round: too large can be taken off, too small cannot be put back.
    check("25 h6", "25.004", 10, "remove 0.004 mm to the nearest limit, 0.0105 mm to the middle of the zone\n");
    check("25 h6", "24.980", 11, "");
}

#[test]
fn the_limits_are_good_and_one_nanometre_beyond_is_not() {
    for (callout, measured, code) in [
        ("25 H7", "25.000", 0),
        ("25 H7", "25.021", 0),
        ("25 H7", "24.999999", 10),
        ("25 H7", "25.021001", 11),
        ("25 h6", "25", 0),
        ("25 h6", "24.987", 0),
        ("25 h6", "25.000001", 10),
        ("25 h6", "24.986999", 11),
    ] {
        assert_eq!(run(&[callout, "--measured", measured]).code, code, "{callout} = {measured}");
    }
}

#[test]
fn numbers_are_read_as_people_write_them() {
    let plain = run(&["25 H7", "--measured", "25.012"]);
    for measured in ["25,012", "+25.012", " 25.012 mm", "25012 µm", "25012um"] {
        assert_eq!(run(&["25 H7", "--measured", measured]), plain, "{measured}");
    }
    for callout in ["25H7", "Ø25 H7", "25,0 H7"] {
        assert_eq!(run(&[callout, "--measured", "25.012"]), plain, "{callout}");
    }
}

#[test]
fn json_has_the_fields_of_the_contract() {
    let good = json_of(&["25 H7", "--measured", "25.012"]);
    for (name, value) in [
        ("callout", json!("25 H7")),
        ("feature", json!("hole")),
        ("nominal_mm", json!(25.0)),
        ("min_mm", json!(25.0)),
        ("max_mm", json!(25.021)),
        ("measured_mm", json!(25.012)),
        ("deviation_um", json!(12.0)),
        ("status", json!("GOOD")),
        ("source", json!("ISO 286, over 18 up to 30 mm")),
        ("rule", json!("no guard band, limits belong to the zone")),
        ("warnings", json!(["one diameter only: form and position are unknown"])),
    ] {
        assert_eq!(good[name], value, "{name}");
    }
    assert_eq!(good.get("remove_um"), None);
    let rework = json_of(&["25 H7", "--measured", "24.998"]);
    assert_eq!((&rework["status"], &rework["remove_um"]), (&json!("REWORK"), &json!(2.0)));
    let scrap = json_of(&["25 g6", "--measured", "24.9799"]);
    assert_eq!((&scrap["status"], &scrap["feature"], scrap.get("remove_um")), (&json!("SCRAP"), &json!("shaft"), None));
}

#[test]
fn csv_is_a_header_and_one_line_with_exact_figures() {
    let answer = run(&["25 H7", "--measured", "24,998", "--format", "csv", "--mask", "nl"]);
    assert_eq!(answer.code, 10);
    let mut reader = csv::Reader::from_reader(answer.out.as_bytes());
    let header = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let [row] = rows.as_slice() else { panic!("{rows:?}") };
    let cell = |name: &str| row.get(header.iter().position(|column| column == name).unwrap()).unwrap();
    for (name, text) in [
        ("callout", "25 H7"),
        ("feature", "hole"),
        ("nominal_mm", "25"),
        ("min_mm", "25.000"),
        ("max_mm", "25.021"),
        ("measured_mm", "24.998"),
        ("deviation_um", "-2"),
        ("status", "REWORK"),
        ("remove_um", "2"),
    ] {
        assert_eq!(cell(name), text, "{name}");
    }
}

#[test]
fn the_time_has_whole_seconds() {
    let answer = json_of(&["25 H7", "--measured", "25.012"]);
    let time = answer["time"].as_str().unwrap();
    assert_eq!(time.len(), "2026-11-21T10:42:07".len(), "{time}");
}

#[test]
fn a_value_that_looks_like_another_quantity_is_warned_of() {
    for (measured, code, doubt) in [
        ("635", 11, "25.4 times the nominal size: was it converted from inch twice?"),
        ("0.984252", 14, "the nominal size divided by 25.4: is it in inch?"),
        ("50", 11, "twice the nominal size: was a diameter taken for a radius?"),
        ("12.5", 14, "half the nominal size: is it a radius?"),
    ] {
        let answer = run(&["25 H7", "--measured", measured]);
        let first = answer.err.lines().next().map(str::to_owned);
        assert_eq!((answer.code, first), (code, Some(format!("warning: measured value is {doubt}"))));
        let warnings = json_of(&["25 H7", "--measured", measured])["warnings"].to_string();
        assert!(warnings.contains(doubt), "{warnings}");
    }
    assert_eq!(run(&["25 H7", "--measured", "25.5"]).err, "");
}

#[test]
fn an_own_mask_prints_as_it_says() {
    let (_folder, path) = file("\"%S IS %S, %+.3LF MM\", QS2, QS3, Q153;\n\"100%%\";\nM_CLOSE\n", "shop.a");
    let answer = run(&["25 H7", "--measured", "25.012", "--mask", path.to_str().unwrap()]);
    assert_eq!((answer.code, answer.out.as_str()), (0, "25 H7 IS GOOD, +25.012 MM\n100%\n"));
    assert!(answer.err.starts_with("warning: ") && answer.err.contains("shop.a: line 3"), "{}", answer.err);
}

#[test]
fn an_own_mask_speaks_the_language_that_is_asked_for() {
    let (_folder, path) = file("L_DUTCH;\n\"%S\", QS3;\nL_ENGLISH;\n\"FIT %S\", QS3;\n", "shop.a");
    let mask = path.to_str().unwrap();
    let said = |language| run(&["25 H7", "--measured", "24.998", "--mask", mask, "--language", language]).out;
    assert_eq!(said("nl"), "Nabewerking\n");
    assert_eq!(said("en"), "FIT REWORK\n");
    let shipped = run(&["25 H7", "--measured", "25.012", "--language", "nl"]);
    assert!(shipped.out.starts_with("STATUS VAN DE PASSING: GOED\n"), "{}", shipped.out);
    assert_eq!(run(&["25 H7", "--measured", "25.012", "--language", "xx"]).code, 2);
}

#[test]
fn a_mask_that_cannot_be_used_is_named() {
    let mask = |path: &Path| ["25 H7", "--measured", "25", "--mask", path.to_str().unwrap()].map(str::to_owned);
    let refused_mask = |path: &Path, reason: &str| {
        let args = mask(path);
        refused(&args.each_ref().map(String::as_str), reason);
    };
    let (folder, path) = file("\"%S\", QS3;\n\"A %F\", Q99;\n", "shop.a");
    refused_mask(&path, &format!("{}: line 2, column 4: Q99 is not defined", path.display()));
    refused_mask(folder.path(), &format!("this is a folder, not a file: {}", folder.path().display()));
    let missing = folder.path().join("none.a");
    refused_mask(&missing, &format!("no such file or folder: {}", missing.display()));
}

#[test]
fn contacts_from_a_file_and_from_standard_input_are_the_same() {
    let (_folder, path) = file(FOUR, "bore.csv");
    let args = ["25 H7", "--contacts", path.to_str().unwrap()];
    let read = json_of(&args);
    for (name, value) in [
        ("measured_mm", json!(25.012)),
        ("status", json!("GOOD")),
        ("centre_x_mm", json!(10.0)),
        ("centre_y_mm", json!(-5.0)),
        ("origin", json!("contacts from bore.csv")),
    ] {
        assert_eq!(read[name], value, "{name}");
    }
    assert_eq!(read["contacts"].as_array().map(Vec::len), Some(4));
    let piped = run_with_input(&["25 H7", "--contacts", "-"], FOUR);
    assert_eq!(piped, run(&args));
    assert_eq!((piped.code, piped.err.as_str()), (0, ""));
}

#[test]
fn contacts_that_make_no_circle_are_refused() {
    for (contacts, reason) in [
        ("x,y\n0,0\n1,1\n2,2\n", "all 3 contacts lie on one straight line: no circle goes through them"),
        ("x,y\n0,0\n1,1\n2,2\n3,3\n", "all 4 contacts lie on one straight line: no circle goes through them"),
        ("x,y\n1,1\n1,1\n1,1\n", "contacts 1 and 2 coincide at x = 1, y = 1: a circle needs 3 different points"),
        ("x,y\n0,0\n1,1\n", "a circle needs at least 3 contacts, found 2"),
    ] {
        let (_folder, path) = file(contacts, "bore.csv");
        refused(&["25 H7", "--contacts", path.to_str().unwrap()], &format!("bore.csv: {reason}"));
        let piped = run_with_input(&["25 H7", "--contacts", "-"], contacts);
        assert_eq!((piped.code, piped.err), (1, format!("fitcheck: standard input: {reason}\n")));
    }
}

#[test]
fn a_contact_file_without_contacts_is_refused() {
    for contacts in ["", "x,y\n", "x,y\n1,a\n2,3\n4,5\n", "\u{feff}", "{\"x\": 1}\n"] {
        let (_folder, path) = file(contacts, "bore.csv");
        let answer = run(&["25 H7", "--contacts", path.to_str().unwrap()]);
        assert_eq!((answer.code, answer.out.as_str()), (1, ""), "{contacts:?}");
        assert!(answer.err.starts_with("fitcheck: bore.csv: "), "{contacts:?}: {}", answer.err);
    }
}

#[test]
fn the_same_seed_gives_the_same_contacts() {
    let simulated = |callout, seed| {
        let mut object = json_of(&[callout, "--simulate", "--seed", seed]);
        object.as_object_mut().unwrap().remove("time");
        object
    };
    assert_eq!(simulated("25 H7", "7"), simulated("25 H7", "7"));
    assert_ne!(simulated("25 H7", "7")["contacts"], simulated("25 H7", "8")["contacts"]);
    assert_eq!(simulated("25 H7", "7")["contacts"].as_array().map(Vec::len), Some(4));
    assert_eq!(simulated("25 H7", "7")["origin"], json!("simulated, cycle 421, seed 7"));
    assert_eq!(simulated("25 g6", "7")["origin"], json!("simulated, cycle 422, seed 7"));
    let text = ["25 H7", "--simulate", "--seed", "7"];
    assert_eq!(run(&text), run(&text));
}

#[test]
fn a_simulated_workpiece_has_the_diameter_that_was_asked_for() {
    for (diameter, code) in [("25.010", 0), ("24.950", 10), ("25.080", 11)] {
        assert_eq!(run(&["25 H7", "--simulate", "--true-diameter", diameter]).code, code, "{diameter}");
    }
    for diameter in ["0", "-25", "abc", ""] {
        let answer = run(&["25 H7", "--simulate", &format!("--true-diameter={diameter}")]);
        assert_eq!((answer.code, answer.out.as_str()), (1, ""), "{diameter:?}: {}", answer.err);
    }
}

#[test]
fn exactly_one_source_is_asked_for() {
    for args in [
        &["25 H7"][..],
        &["25 H7", "--measured", "25", "--simulate"],
        &["25 H7", "--measured", "25", "--contacts", "bore.csv"],
        &["25 H7", "--contacts", "bore.csv", "--simulate"],
        &["25 H7", "--measured", "25", "--seed", "7"],
        &["25 H7", "--measured", "25", "--true-diameter", "25"],
        &["25 H7", "--measured", "25", "--format", "xml"],
        &["--measured", "25"],
    ] {
        let answer = run(args);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{args:?}");
        assert!(answer.err.starts_with("error: "), "{args:?}: {}", answer.err);
    }
}

#[test]
fn a_callout_without_limits_is_refused_in_words() {
    for (callout, needle) in [
        ("25 Q7", "25 Q7: Q7 is not an ISO 286 tolerance class: letter Q does not exist"),
        ("25 j8", "25 j8: j8 is not defined at 25 mm in ISO 286; it is defined over 0 up to 3 mm"),
        ("24 T7", "24 T7: T7 is not defined at 24 mm in ISO 286; it is defined over 24 up to 3150 mm"),
        ("0 H7", "0 H7: nominal size 0 mm is not above 0"),
        ("-3 H7", "-3 H7: nominal size -3 mm is not above 0"),
        ("\u{2212}3 H7", "nominal size -3 mm is not above 0"),
        ("3200 H7", "3200 H7: nominal size 3200 mm is beyond ISO 286"),
        ("3150.000001 H7", "beyond ISO 286, which ends at 3150 mm"),
        ("1 N9", "1 N9: N9 is not defined"),
        ("25", "25: a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1"),
        ("", "callout: a callout is missing: write a nominal size and a tolerance class, such as 25 H7"),
        ("1.234,5 H7", "1.234,5"),
    ] {
        let answer = run(&["--measured", "25", "--", callout]);
        assert_eq!((answer.code, answer.out.as_str()), (1, ""), "{callout}");
        assert!(answer.err.starts_with("fitcheck: ") && answer.err.contains(needle), "{callout}: {}", answer.err);
    }
}

#[test]
fn a_measured_value_that_is_no_diameter_is_refused() {
    for (measured, reason) in [
        ("abc", "measured value: abc is not a number"),
        ("-25", "measured value: -25 mm is not above 0"),
        ("0", "measured value: 0 mm is not above 0"),
    ] {
        refused(&["25 H7", "--measured", measured], reason);
    }
    for measured in ["", "NaN", "1.234,5", "25.0000001", "1e400", "99999999999999999999"] {
        let answer = run(&["25 H7", "--measured", measured]);
        assert_eq!((answer.code, answer.out.as_str()), (1, ""), "{measured:?}");
        assert!(answer.err.starts_with("fitcheck: measured value: "), "{measured:?}: {}", answer.err);
    }
}

#[test]
fn own_tables_come_first_and_add_their_classes() {
    let tables = sample("tables");
    let js7 = json_of(&["10 JS7", "--measured", "10.007", "--tables", &tables]);
    assert_eq!((&js7["min_mm"], &js7["max_mm"]), (&json!(9.9925), &json!(10.0075)));
    assert!(js7["source"].as_str().unwrap().starts_with("table "), "{js7}");
    // Only the user's table has U1: +8 and +3 µm over 3 up to 6 mm.
    let u1 = json_of(&["5 U1", "--measured", "5.003", "--tables", &tables]);
    assert_eq!((&u1["min_mm"], &u1["max_mm"], &u1["status"]), (&json!(5.003), &json!(5.008), &json!("GOOD")));
    assert_eq!(run(&["5 U1", "--measured", "5.003"]).code, 1);
    // An empty cell is not a limit.
    let empty = run(&["3 U1", "--measured", "3", "--tables", &tables]);
    assert_eq!(empty.code, 1);
    assert!(empty.err.contains("U1 is not defined over 0 up to 3 mm in table generation1_plain.tab"), "{}", empty.err);
    // ISO 286 still answers what the user's tables do not cover.
    let beyond = json_of(&["100 H7", "--measured", "100", "--tables", &tables]);
    assert_eq!(beyond["max_mm"], json!(100.035));
}

#[test]
fn a_folder_of_tables_that_cannot_be_read_is_refused() {
    let missing = tempfile::tempdir().unwrap().path().join("none");
    let answer = run(&["25 H7", "--measured", "25", "--tables", missing.to_str().unwrap()]);
    assert_eq!((answer.code, answer.out.as_str()), (1, ""));
    assert!(answer.err.contains("no such file or folder"), "{}", answer.err);
}

#[test]
fn the_help_has_examples_and_exit_codes() {
    let answer = run(&["--help"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    for text in ["fitcheck check \"25 H7\" --measured 25.012", "10 rework, 11 scrap"] {
        assert!(answer.out.contains(text), "{}", answer.out);
    }
}

/// A reader that has gone away must not turn scrap into good.
#[cfg(unix)]
#[test]
fn a_closed_pipe_keeps_the_verdict() {
    use std::process::{Command, Stdio};
    let closed = || {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        Stdio::from(writer)
    };
    for (measured, code) in [("25.012", 0), ("24.998", 10), ("25.030", 11)] {
        let command = || {
            let mut command = Command::new(assert_cmd::cargo::cargo_bin!("fitcheck"));
            command.args(["check", "25 H7", "--measured", measured]);
            command
        };
        let status = command().stdout(closed()).stderr(Stdio::null()).status().unwrap();
        assert_eq!(status.code(), Some(code), "{measured}, standard output closed");
        let output = command().stdout(Stdio::piped()).stderr(closed()).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{measured}, standard error closed");
        assert_eq!(String::from_utf8(output.stdout).unwrap().lines().count(), 5, "{measured}");
    }
}

#[test]
fn a_callout_without_letters_is_judged_and_hole_or_shaft_says_rework_or_scrap() {
    let good = run(&["12 +0.01 -0.015", "--measured", "12.01", "--format", "json"]);
    assert_eq!(good.code, 0, "{}", good.err);
    let object: Value = serde_json::from_str(&good.out).unwrap();
    assert_eq!((&object["feature"], &object["status"]), (&Value::Null, &json!("GOOD")));
    let good = run(&["12 +0.01 -0.015", "--measured", "12.01", "--format", "csv"]);
    assert!(good.out.contains(",12 +0.01 -0.015,,12,11.985,12.010,12.010,10,GOOD,"), "{}", good.out);
    let unsaid = run(&["12 +0.01 -0.015", "--measured", "12.010001"]);
    assert_eq!(unsaid.code, 13);
    assert!(unsaid.out.starts_with("FIT STATUS: OUT OF LIMITS\n"), "{}", unsaid.out);
    assert!(unsaid.err.contains("0.001 µm above maximum"), "{}", unsaid.err);
    let below = run(&["12 +0.01 -0.015", "--measured", "11.968"]);
    assert!(below.err.contains("17 µm below minimum"), "{}", below.err);
    assert!(unsaid.err.contains("add --feature hole or --feature shaft"), "{}", unsaid.err);
    for (feature, measured, code) in
        [("hole", "12.010001", 11), ("shaft", "12.010001", 10), ("hole", "11.98", 10), ("shaft", "11.98", 11)]
    {
        let answer = run(&["12 +0.01 -0.015", "--feature", feature, "--measured", measured]);
        assert_eq!(answer.code, code, "{feature} {measured}: {}", answer.err);
    }
}

#[test]
fn one_part_of_a_fit_is_checked_when_it_is_named() {
    let answer = run(&["25 H7/g6", "--measured", "24.99"]);
    assert_eq!((answer.code, answer.out.as_str()), (1, ""));
    let why = "25 H7/g6 does not say whether the hole or the shaft is meant: add --feature hole or --feature shaft";
    assert!(answer.err.contains(why), "{}", answer.err);
    let shaft = run(&["25 H7/g6", "--feature", "shaft", "--measured", "24.99"]);
    assert_eq!(shaft.code, 0);
    assert!(shaft.out.contains("CHECKED FIT: 25 g6\n"), "{}", shaft.out);
    assert_eq!(run(&["25 H7/g6", "--feature", "hole", "--measured", "24.99"]).code, 10);
    let wrong = run(&["25 H7", "--feature", "shaft", "--measured", "25"]);
    assert!(wrong.code == 1 && wrong.err.contains("H7 is a hole class and not a shaft class"), "{}", wrong.err);
}
