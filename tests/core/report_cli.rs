//! `fitcheck report`: formats, files in and out, exit codes, errors.

#![cfg(test)]

use std::path::Path;

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::files;
use fitcheck::probing::{Caveat, Origin};
use fitcheck::words::{Language, Words};

use crate::report::check_well_formed;

const TIME: &str = "2026-11-21T10:42";

fn report(args: &[&str]) -> Command {
    let mut command = cargo_bin_cmd!("fitcheck");
    command.arg("report").args(["--time", TIME]).args(args);
    command
}

/// Exit code, standard output, standard error.
fn run(args: &[&str]) -> (i32, String, String) {
    let output = report(args).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// Writes a report into a folder of its own and returns its text.
#[track_caller]
fn written(name: &str, args: &[&str], code: i32) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let (exit, out, err) = run(&[args, &["-o", path.to_str().unwrap()]].concat());
    assert_eq!((exit, out.as_str()), (code, ""), "{err}");
    assert!(err.ends_with(&format!("wrote {}\n", path.display())), "{err}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    std::fs::read_to_string(path).unwrap()
}

fn sample(path: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples").join(path).display().to_string()
}

const THREE: [&str; 6] =
    ["--check", "Bore A: 25 H7=25.012", "--check", "25 H7=24,998", "--check", "<script>: 25 g6=24.9799"];

#[test]
fn three_checks_make_a_whole_page() {
    let page = written("report.html", &[&THREE[..], &["--part", "4711-A", "--inspector", "J. de Vries"]].concat(), 11);
    check_well_formed(&page);
    let words = Words::new(Language::En);
    for text in [
        &words.told(&Caveat::OnlyADiameter),
        &words.told(&Origin::Typed),
        "<title>GOOD</title>",
        "<title>REWORK</title>",
        "<title>SCRAP</title>",
        "Bore A",
        "4711-A",
        "J. de Vries",
        "2026-11-21 10:42:00",
        "25.021 mm",
        "24.9799 mm",
        "24.9930 mm",
        "0.1 µm too small",
        "ISO 286, over 18 up to 30 mm",
        "ISO 286, over 18 up to 30 mm",
        "no guard band, limits belong to the zone",
        ">Signature</th>",
        "&#60;script&#62;",
    ] {
        assert!(page.contains(text), "{text:?} is missing in\n{page}");
    }
    assert!(!page.contains("<script"));
}

#[test]
fn the_page_is_dutch_when_asked() {
    let page = written("report.HTM", &[&THREE[..], &["--language", "nl", "--title", "Eerste stuk"]].concat(), 11);
    for text in ["<html lang=\"nl\">", "Eerste stuk", "GOED", "NABEWERKING", "AFGEKEURD", "24,9799 mm", "Handtekening"]
    {
        assert!(page.contains(text), "{text:?} is missing in\n{page}");
    }
}

#[test]
fn csv_goes_to_standard_output_when_asked() {
    let args = ["--check", "=1+1: 25 H7=25.0215", "--check", "25 H7=25.021", "-o", "-", "--format", "csv"];
    let expected = "\
time,id,callout,feature,nominal_mm,min_mm,max_mm,measured_mm,deviation_um,status,remove_um,remove_to_middle_um,\
position,centre_x_mm,centre_y_mm,contacts,source,origin,rule,warnings,simulated
2026-11-21T10:42:00,'=1+1,25 H7,hole,25,25.000,25.021,25.0215,21.5,SCRAP,,,,,,,\
\"ISO 286, over 18 up to 30 mm\",typed,\"no guard band, limits belong to the zone\",\
one diameter only: form and position are unknown,false
2026-11-21T10:42:00,,25 H7,hole,25,25.000,25.021,25.021,21,GOOD,,,,,,,\
\"ISO 286, over 18 up to 30 mm\",typed,\"no guard band, limits belong to the zone\",\
one diameter only: form and position are unknown,false
";
    assert_eq!(run(&args), (11, expected.to_owned(), String::new()));
}

#[test]
fn json_is_the_same_in_every_language() {
    let in_language = |language| {
        let text = written("r.json", &["--check", "25 H7=24.998", "--check", "x", "--language", language], 1);
        serde_json::from_str::<serde_json::Value>(&text).unwrap()
    };
    let english = in_language("en");
    assert_eq!(english, in_language("nl"));
    assert_eq!(english["version"], 1);
    assert_eq!(english["created"], "2026-11-21T10:42:00");
    let note = "x: x has no measured value: write a callout, = and millimetres, such as 25 H7=25.012";
    assert_eq!(english["notes"], serde_json::json!([note]));
    let check = &english["checks"][0];
    assert_eq!(check["status"], "REWORK");
    assert_eq!((check["min_mm"].as_f64(), check["remove_um"].as_f64()), (Some(25.0), Some(2.0)));
}

#[test]
fn the_worst_check_gives_the_exit_code() {
    for (measured, code) in [("25.000", 0), ("24.999999", 10), ("25.021", 0), ("25.021001", 11)] {
        let check = format!("25 H7={measured}");
        assert_eq!(run(&["--check", &check, "-o", "-", "--format", "csv"]).0, code, "{measured}");
    }
    let args =
        ["--check", "25 H7=25.5", "--check", "25 H7=24.5", "--check", "25 H7=25.01", "-o", "-", "--format", "csv"];
    assert_eq!(run(&args).0, 11);
}

#[test]
fn a_row_that_cannot_be_used_is_named_and_the_others_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("bores.csv");
    files::write(&csv, b"id;callout;measured\nA;25 H7;25,012\nB;25 H7;25,0l2\n").unwrap();
    let path = folder.path().join("report.html");
    let args = [csv.to_str().unwrap(), "--check", "25 H9999=1", "-o", path.to_str().unwrap()];
    let (code, _, err) = run(&args);
    let page = std::fs::read_to_string(&path).unwrap();
    check_well_formed(&page);
    assert_eq!(code, 1);
    for text in [
        "bores.csv: line 3, column 3: measured: 25,0l2 is not a number",
        "25 H9999=1: H9999 is not an ISO 286 tolerance class: write letters and a grade, such as H7 or js13",
    ] {
        assert!(page.contains(text), "{text:?} is missing in\n{page}");
        assert!(err.contains(text), "{text:?} is missing in\n{err}");
    }
    let origin = Words::new(Language::En).told(&Origin::Imported { file: "bores.csv".into() });
    assert!(page.contains("<title>GOOD</title>") && page.contains(&origin));
}

#[test]
fn a_log_keeps_its_position() {
    let text = written("r.csv", &[&sample("logs/en/TCHPR421.TXT")], 0);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let row = reader.records().next().unwrap().unwrap();
    let cell = |number: usize| row.get(number).unwrap();
    assert_eq!([4, 5, 6, 7, 9, 12].map(cell), ["25", "25.000", "25.021", "25.0134", "GOOD", "IN"]);
    assert!(cell(16).contains("TCHPR421.TXT"));
}

#[test]
fn nothing_is_written_without_a_check() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.html");
    let (code, out, err) = run(&["--check", "0 H7=1", "-o", path.to_str().unwrap()]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert_eq!(
        err,
        "fitcheck: 0 H7=1: nominal size 0 mm is not above 0\n\
         fitcheck: no check was usable, so no report was written\n"
    );
    assert!(!path.exists());
}

#[test]
fn values_that_are_no_diameter_are_refused() {
    for (value, reason) in [
        ("", "measured value: a length is missing"),
        ("NaN", "measured value: NaN is not a number"),
        ("1.234,5", "measured value: 1.234,5 is ambiguous: write one decimal sign and no thousands separator"),
        ("0", "measured value 0 mm is not above 0"),
        ("-25.012", "measured value -25.012 mm is not above 0"),
    ] {
        let check = format!("25 H7={value}");
        let (code, _, err) = run(&["--check", &check, "-o", "-", "--format", "csv"]);
        assert_eq!(code, 1);
        assert!(err.starts_with(&format!("fitcheck: {check}: {reason}\n")), "{err}");
    }
}

/// What a PDF says is read again in `crates/exchange/tests/pdf`.
#[test]
fn a_pdf_is_the_same_every_time_and_has_its_data_attached() {
    let made = |paper: &str| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("report.pdf");
        let args = [&THREE[..], &["--language", "nl", "--paper", paper, "-o", path.to_str().unwrap()]].concat();
        let (code, _, err) = run(&args);
        assert_eq!(code, 11, "{err}");
        std::fs::read(path).unwrap()
    };
    let a4 = made("a4");
    assert_eq!(a4, made("a4"));
    assert_ne!(a4, made("letter"));
    let has = |text: &[u8]| a4.windows(text.len()).any(|piece| piece == text);
    assert!(a4.starts_with(b"%PDF-1.7\n"));
    for text in ["/AFRelationship/Data", "(report.json)", "(checks.csv)", "/Lang(nl)"] {
        assert!(has(text.as_bytes()), "{text}");
    }
    assert!(!has(b"<script>"));
}

#[test]
fn an_unknown_ending_lists_the_known_ones() {
    for (file, reason) in [
        ("report.xps", ".xps is not a format of the report: use one of "),
        ("report", "report has no ending that gives the report's format: use one of "),
    ] {
        let (code, _, err) = run(&["--check", "25 H7=25.01", "-o", file]);
        assert_eq!(code, 2);
        assert!(err.contains(&format!("{reason}{}", fitcheck::report::endings())), "{err}");
    }
    assert!(fitcheck::report::endings().starts_with(".html .htm .csv .json .md .markdown .xlsx .dfq .qif"));
}

#[test]
fn standard_output_needs_a_format_and_a_file_takes_no_other() {
    let (code, _, err) = run(&["--check", "25 H7=25.01", "-o", "-"]);
    assert_eq!(code, 2);
    assert!(err.contains("--format"), "{err}");
    let (code, _, err) = run(&["--check", "25 H7=25.01", "-o", "a.html", "--format", "csv"]);
    assert_eq!(code, 1);
    assert_eq!(err, "fitcheck: --format csv does not fit the ending of a.html: leave one of them out\n");
}

#[test]
fn a_folder_that_is_not_there_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("none").join("report.html");
    let (code, _, err) = run(&["--check", "25 H7=25.01", "-o", missing.to_str().unwrap()]);
    assert_eq!(code, 1);
    assert_eq!(err, format!("fitcheck: no such file or folder: {}\n", missing.display()));

    let a_folder = folder.path().join("a.html");
    std::fs::create_dir(&a_folder).unwrap();
    let (code, _, err) = run(&["--check", "25 H7=25.01", "-o", a_folder.to_str().unwrap()]);
    assert_eq!(code, 1);
    assert_eq!(err, format!("fitcheck: this is a folder, not a file: {}\n", a_folder.display()));
}

#[test]
fn a_missing_measurement_file_is_named_on_the_report() {
    let page = written("r.html", &["--check", "25 H7=25.01", "nowhere.csv"], 1);
    assert!(page.contains("nowhere.csv: no such file or folder: nowhere.csv"), "{page}");
}

#[test]
fn a_report_without_anything_to_report_is_wrong_usage() {
    assert_eq!(run(&["-o", "a.html"]).0, 2);
    assert_eq!(run(&["--check", "25 H7=25.01"]).0, 2);
}

#[test]
fn the_help_has_examples() {
    let (code, out, _) = run(&["--help"]);
    assert_eq!(code, 0);
    assert!(out.contains("fitcheck report bores.csv TCHPR421.TXT -o report.html"), "{out}");
}

#[test]
fn the_same_report_has_the_same_bytes() {
    let once = || written("report.html", &THREE, 11);
    assert_eq!(once(), once());
}

#[test]
#[cfg(unix)]
fn nobody_listening_leaves_the_verdict() {
    let folder = tempfile::tempdir().unwrap();
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let status = std::process::Command::new(assert_cmd::cargo::cargo_bin!("fitcheck"))
        .args(["report", "--time", TIME, "--check", "25 H7=25.5", "-o"])
        .arg(folder.path().join("bore.html"))
        .stderr(std::process::Stdio::from(writer))
        .status()
        .unwrap();
    assert_eq!(status.code(), Some(11));
}
