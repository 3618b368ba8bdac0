//! `fitcheck doctor` and `--quiet`, through the built program.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::path::Path;

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::journal::entry::Moment;
use fitcheck::store::local::{Journal, Opening};
use serde_json::Value as Json;

/// The program for somebody whose folders are all below this one, without a display.
fn fitcheck(home: &Path) -> Command {
    let mut program = cargo_bin_cmd!("fitcheck");
    for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "FITCHECK_JOURNAL", "PGPASSWORD"] {
        program.env_remove(name);
    }
    for (name, folder) in [("HOME", ""), ("XDG_CONFIG_HOME", "config"), ("XDG_DATA_HOME", "data")] {
        program.env(name, home.join(folder));
    }
    for name in ["APPDATA", "LOCALAPPDATA", "USERPROFILE"] {
        program.env(name, home);
    }
    program.env("TZ", "Europe/Amsterdam").current_dir(home);
    program
}

/// What is said of one thing: how it is, and what was found.
fn said(home: &Path, change: impl FnOnce(&mut Command), what: &str) -> (String, String) {
    let mut program = fitcheck(home);
    change(program.args(["doctor", "--format", "json"]));
    let output = program.assert().get_output().stdout.clone();
    let all: Json = serde_json::from_slice(&output).unwrap();
    let one = all.as_array().unwrap().iter().find(|one| one["what"] == what).unwrap_or_else(|| panic!("{all}"));
    (one["condition"].as_str().unwrap().to_owned(), one["found"].as_str().unwrap().to_owned())
}

#[test]
fn what_is_not_needed_yet_is_not_wrong() {
    let home = tempfile::tempdir().unwrap();
    for what in ["journal", "server", "tables"] {
        assert_eq!(said(home.path(), |_| (), what).0, "none", "{what}");
    }
    assert_eq!(said(home.path(), |_| (), "records").0, "well");
    assert!(std::fs::read_dir(home.path()).unwrap().next().is_none(), "the doctor leaves nothing behind");
}

#[test]
fn a_time_zone_that_is_none_is_told_with_what_to_do() {
    let home = tempfile::tempdir().unwrap();
    let (zone, found) = said(home.path(), |_| (), "time zone");
    assert!(zone == "well" && found.starts_with("Europe/Amsterdam, it is 2"), "{found}");
    let (zone, found) = said(home.path(), |program| _ = program.env("TZ", "Europa/Amsterdam"), "time zone");
    assert!(zone == "wrong" && found.contains("set it to a name such as Europe/Amsterdam"), "{found}");
}

#[test]
fn a_clock_before_the_newest_entry_is_wrong() {
    let home = tempfile::tempdir().unwrap();
    fitcheck(home.path())
        .args(["check", "25 H7", "--measured", "25.012", "--record", "--journal", "a.sqlite"])
        .assert()
        .success();
    let now = |program: &mut Command| _ = program.args(["--journal", "a.sqlite"]);
    assert_eq!(said(home.path(), now, "clock").0, "well");
    let (journal, found) = said(home.path(), now, "journal");
    assert_eq!((journal.as_str(), found.as_str()), ("well", "a.sqlite: entries 2"));
    let in_2100 = Moment { utc_ms: 4_102_444_800_000, offset_min: 60, zone: "Europe/Amsterdam".to_owned() };
    let path = home.path().join("b.sqlite");
    drop(Journal::open(&path, &Opening { anchors: None, ..Opening::new("Mill 3", in_2100) }).unwrap());
    let (clock, found) = said(home.path(), |program| _ = program.args(["--journal", "b.sqlite"]), "clock");
    assert!(clock == "wrong" && found.contains("2100-01-01T01:00:00.000+01:00: set the clock"), "{found}");
}

#[test]
fn a_file_that_is_no_journal_and_a_folder_that_is_a_file_are_wrong() {
    let home = tempfile::tempdir().unwrap();
    std::fs::write(home.path().join("none.sqlite"), "not a journal").unwrap();
    let (journal, found) = said(home.path(), |program| _ = program.args(["--journal", "none.sqlite"]), "journal");
    assert!(journal == "wrong" && found.contains("none.sqlite is not a journal"), "{found}");
    std::fs::write(home.path().join("config"), "a file").unwrap();
    #[cfg(unix)]
    assert_eq!(said(home.path(), |_| (), "settings").0, "wrong");
    fitcheck(home.path()).args(["doctor", "--journal", "none.sqlite"]).assert().code(1);
}

#[test]
fn own_tables_are_read() {
    let home = tempfile::tempdir().unwrap();
    let plain = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/tables/generation1_plain.tab");
    std::fs::create_dir(home.path().join("tables")).unwrap();
    std::fs::copy(plain, home.path().join("tables/fit.tab")).unwrap();
    let (tables, found) = said(home.path(), |program| _ = program.args(["--tables", "tables"]), "tables");
    assert_eq!((tables.as_str(), found.as_str()), ("well", "tables: tables 1"));
    let (tables, _) = said(home.path(), |program| _ = program.args(["--tables", "nowhere"]), "tables");
    assert_eq!(tables, "wrong");
}

#[cfg(feature = "shop")]
#[test]
fn a_server_that_does_not_answer_is_wrong_and_its_password_is_not_shown() {
    let home = tempfile::tempdir().unwrap();
    let address = "postgres://mill3:secret@127.0.0.1:9/checks";
    let (server, found) = said(home.path(), |program| _ = program.args(["--journal", address]), "server");
    assert_eq!(server, "wrong", "{found}");
    assert!(!found.contains("secret"), "{found}");
}

#[test]
fn quiet_leaves_the_answer_the_warnings_and_the_exit_code() {
    let home = tempfile::tempdir().unwrap();
    let loud = fitcheck(home.path()).args(["report", "--check", "25 H7=25.012", "-o", "a.csv"]).assert().success();
    assert!(!loud.get_output().stderr.is_empty());
    let quiet = ["report", "--check", "25 H7=25.012", "-o", "a.csv", "--quiet"];
    fitcheck(home.path()).args(quiet).assert().success().stderr("");
    std::fs::write(home.path().join("rows.csv"), "id;callout;measured\nA1;25 H7;25.03\nA2;25 H7;x\n").unwrap();
    let batch = fitcheck(home.path()).args(["-q", "batch", "rows.csv", "-o", "out.csv"]).assert().code(1);
    assert_eq!(String::from_utf8_lossy(&batch.get_output().stderr), "rows.csv:3:3: measured: x is not a number\n");
    let simulated = fitcheck(home.path()).args(["check", "25 H7", "--simulate", "-q"]).assert();
    let said = String::from_utf8_lossy(&simulated.get_output().stderr).into_owned();
    assert!(said.contains("simulated"), "{said}");
}
