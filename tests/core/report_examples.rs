//! The examples of reports in `docs/examples/reports` are what the program writes, to the byte.
//!
//! `EXAMPLES=write cargo test --test core report_examples` writes them anew: look at them then.

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

const FOLDER: &str = "docs/examples/reports";

/// Its name, and what is asked for besides plan, values and time.
const EXAMPLES: [(&str, &[&str]); 18] = [
    ("report.pdf", &[]),
    ("report.html", &[]),
    ("report.md", &[]),
    ("report.xlsx", &[]),
    ("report.csv", &[]),
    ("report.json", &[]),
    ("report.dfq", &[]),
    ("report.qif", &[]),
    ("report_de.pdf", &["--language", "de"]),
    ("report_it.pdf", &["--language", "it"]),
    ("report_nl.pdf", &["--language", "nl"]),
    ("first-article.pdf", &["--template", "first-article", "--head", "instrument=Mill 3, probe 1"]),
    ("certificate.pdf", &["--template", "certificate", "--head", "customer=Northgate Precision"]),
    ("list.pdf", &["--template", "list"]),
    ("sheet.pdf", &["--template", "sheet"]),
    ("label.pdf", &["--template", "label", "--paper", "large-label"]),
    ("label.png", &["--template", "label", "--paper", "large-label"]),
    ("own.pdf", &["--template", "docs/examples/reports/own.toml"]),
];

#[test]
fn the_examples_are_what_the_program_writes() {
    let folder = tempfile::tempdir().unwrap();
    for (name, more) in EXAMPLES {
        let made = folder.path().join(name);
        let mut command = cargo_bin_cmd!("fitcheck");
        command.args(["report", "--plan", "assets/samples/sample_plate.toml", "docs/examples/reports/values.csv"]);
        command.args(["--time", "2026-11-28T10:00", "--inspector", "Anna Visser"]).args(more).arg("-o").arg(&made);
        let output = command.output().unwrap();
        assert!(made.exists(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        let kept = Path::new(FOLDER).join(name);
        if std::env::var_os("EXAMPLES").is_some() {
            std::fs::copy(&made, &kept).unwrap();
        }
        assert!(
            std::fs::read(&made).unwrap() == std::fs::read(&kept).unwrap(),
            "{name} is not what the program writes"
        );
    }
}
