//! Reports by the template `statistics`: the figures of published series, in every rendering for people.

use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

/// A report of a table, as text.
fn report(table: &str, name: &str, arguments: &[&str]) -> (Option<i32>, Vec<u8>) {
    let folder = TempDir::new().unwrap();
    fitcheck::files::write(&folder.path().join("values.csv"), table.as_bytes()).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    command.current_dir(folder.path()).args(["report", "values.csv", "-o", name]);
    if !arguments.contains(&"--template") {
        command.args(["--template", "statistics"]);
    }
    let output = command.args(arguments).output().unwrap();
    let bytes = std::fs::read(folder.path().join(name)).unwrap_or_default();
    assert!(!bytes.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    (output.status.code(), bytes)
}

fn text(table: &str, name: &str, arguments: &[&str]) -> String {
    String::from_utf8(report(table, name, arguments).1).unwrap()
}

fn rings() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/statistics/rings.csv");
    std::fs::read_to_string(path).unwrap()
}

/// Montgomery's piston rings: mean 74.001176, s 0.010070, Pp 1.6551, Ppk 1.6162 (`crates/statistics/tests/data/pistonrings.json`).
#[test]
fn a_report_of_statistics_has_the_published_figures() {
    let said = text(&rings(), "rings.md", &[]);
    for figure in ["125 values", "74.0012 mm", "10.07 µm", "1.66 (95 %: 1.45", "1.62 (95 %: 1.41", "0 of 125"] {
        assert!(said.contains(figure), "{figure}: {said}");
    }
    // The lower bound of Ppk is 1.407.
    assert!(said.contains("Ppk of 1.33 is proven: its lower bound is 1.41."), "{said}");
    let page = text(&rings(), "rings.html", &[]);
    assert!(page.contains("<svg xmlns") && page.contains("Single values in µm from"), "no charts");
    assert!(page.contains("<title>ring; 125 values; Mean: 74.0012 mm"), "a screen reader hears the figures");
    let (code, pdf) = report(&rings(), "rings.pdf", &[]);
    assert_eq!((code, pdf.get(..5)), (Some(0), Some(b"%PDF-".as_slice())));
}

#[test]
fn each_feature_has_figures_of_its_own_and_other_templates_have_none() {
    let table =
        "feature,callout,measured\nA,25 H7,25.010\nB,12 H7,12.005\nA,25 H7,25.012\nB,12 H7,12.009\nA,25 H7,25.011\n";
    let said = text(table, "two.md", &[]);
    assert!(said.contains("## A, 25 H7\n\n3 values") && said.contains("## B, 12 H7\n\n2 values"), "{said}");
    assert!(said.contains("intervals are wide"), "{said}");
    let usual = text(table, "two.md", &["--template", "inspection"]);
    assert!(!usual.contains("Ppk"), "{usual}");
}

#[test]
fn names_of_parts_are_one_series_where_all_limits_are_the_same() {
    let table = "part,callout,measured\nP1,25 H7,25.010\nP2,25 H7,25.012\nP3,25 H7,25.011\n";
    assert!(text(table, "one.md", &[]).contains("## 25 H7\n\n3 values"));
}

#[test]
fn one_value_equal_values_and_limits_that_differ_say_why_there_is_no_figure() {
    let one = text("feature,callout,measured\nA,25 H7,25.010\n", "one.md", &[]);
    assert!(one.contains("too few values"), "{one}");
    let equal = text("feature,callout,measured\nA,25 H7,25.010\nA,25 H7,25.010\nA,25 H7,25.010\n", "equal.md", &[]);
    assert!(equal.contains("all values are equal"), "{equal}");
    let mixed = text("feature,callout,measured\nA,25 H7,25.010\nA,25 H8,25.012\nA,25 H7,25.011\n", "mixed.md", &[]);
    assert!(mixed.contains("The limits differ from value to value: no capability is stated."), "{mixed}");
    assert!(!mixed.contains("proven"), "{mixed}");
}

#[test]
fn the_report_is_in_the_language_of_its_reader() {
    let said = text(&rings(), "rings.md", &["--language", "de"]);
    assert!(said.contains("74,0012 mm") && !said.contains("74.0012"), "{said}");
}

#[test]
fn the_charts_of_a_feature_are_a_picture_too() {
    let folder = TempDir::new().unwrap();
    fitcheck::files::write(&folder.path().join("rings.csv"), rings().as_bytes()).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    command.current_dir(folder.path()).args(["stats", "rings.csv", "--group", "5", "--picture", "rings.PNG"]);
    command.assert().success();
    let picture = std::fs::read(folder.path().join("rings.PNG")).unwrap();
    assert!(picture.starts_with(b"\x89PNG\r\n\x1a\n"));
    let side = |at: usize| u32::from_be_bytes(picture[at..at + 4].try_into().unwrap());
    assert_eq!([side(16), side(20)], [3 * 880, 3 * 660]);
    // White alone takes a few kilobytes.
    assert!(50_000 < picture.len(), "{} bytes", picture.len());
}
