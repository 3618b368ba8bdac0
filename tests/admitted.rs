//! What a run admits by its exit code: 14 where everything has an answer, and a colleague would stop all the same.

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

/// Exit code, standard output and standard error of a call in a folder with these files.
fn of(files: &[(&str, &str)], args: &[&str]) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::create_dir_all(folder.path().join(name).parent().unwrap()).unwrap();
        fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    }
    within(folder.path(), args)
}

fn within(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let home = folder.join("home");
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder).args(args).env("FITCHECK_JOURNAL", folder.join("j.sqlite"));
    let output = command.env("HOME", &home).env("XDG_STATE_HOME", &home).env("XDG_DATA_HOME", &home).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// The exit code of an import of one file.
#[track_caller]
fn import(text: &str, code: i32) {
    let (found, out, err) = of(&[("a.csv", text)], &["import", "a.csv"]);
    assert_eq!(found, code, "{text}\n{out}\n{err}");
}

#[test]
fn a_good_value_that_its_file_calls_nok_is_looked_at_first() {
    // 25 H7 is 25.000 … 25.021.
    import("id;callout;measured;status\nA;25 H7;25.012;OK\n", 0);
    import("id;callout;measured;status\nA;25 H7;25.012;NOK\n", 14);
    // 24.998 of a hole is rework, 25.030 is scrap whatever the file says.
    import("id;callout;measured;status\nA;25 H7;24.998;OK\n", 14);
    import("id;callout;measured;status\nA;25 H7;24.998;NOK\n", 10);
    import("id;callout;measured;status\nA;25 H7;25.030;OK\n", 11);
    // A row without a verdict is bad data, whatever else there is.
    import("id;callout;measured;status\nA;25 H7;25.012;NOK\nB;25 H7;x;OK\n", 1);
}

#[test]
fn what_nobody_measured_is_looked_at_first() {
    import("id;callout;measured;simulated\nA;25 H7;25.012;true\n", 14);
    import("id;callout;measured;simulated\nA;25 H7;25.012;false\n", 0);
    import("id;callout;measured;simulated\nA;25 H7;25.030;true\n", 11);
    let rows = "id;callout;measured;simulated\nA;25 H7;25.012;true\n";
    assert_eq!(of(&[("a.csv", rows)], &["batch", "a.csv"]).0, 14);
    assert_eq!(of(&[("a.csv", rows)], &["report", "a.csv", "-o", "r.html"]).0, 14);
    let plan = "fitcheck_plan = 1\npart = \"One\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
    let files = [("a.csv", rows), ("p.toml", plan), ("in/a.csv", rows)];
    assert_eq!(of(&files, &["import", "--plan", "p.toml", "a.csv"]).0, 14);
    assert_eq!(of(&files, &["report", "--plan", "p.toml", "a.csv", "-o", "r.html"]).0, 14);
    assert_eq!(of(&files, &["watch", "in", "--plan", "p.toml", "--until-idle", "0.5"]).0, 14);
}

#[test]
fn a_value_that_may_be_another_quantity_is_looked_at_first() {
    // Half of 25: a radius. As a hole it could be machined to size.
    import("id;callout;measured\nA;25 H7;12.506\n", 14);
    assert_eq!(of(&[], &["check", "25 H7", "--measured", "12.506"]).0, 14);
    assert_eq!(of(&[], &["check", "25 h7", "--measured", "12.506"]).0, 11);
    let rows = [("a.csv", "id;callout;measured\nA;25 H7;12.506\n")];
    assert_eq!(of(&rows, &["batch", "a.csv"]).0, 14);
    assert_eq!(of(&rows, &["report", "a.csv", "-o", "r.html"]).0, 14);
}

#[test]
fn a_file_that_is_named_twice_is_looked_at_first() {
    let rows = [("a.csv", "id;callout;measured\nA;25 H7;25.012\n")];
    assert_eq!(of(&rows, &["import", "a.csv", "a.csv"]).0, 14);
    assert_eq!(of(&rows, &["batch", "a.csv", "a.csv"]).0, 14);
    assert_eq!(of(&rows, &["report", "a.csv", "a.csv", "-o", "r.html"]).0, 14);
}

#[test]
fn the_help_says_the_rule() {
    let (code, out, _) = of(&[], &["--help"]);
    assert_eq!(code, 0);
    assert!(out.contains("14 judged, but look first"), "{out}");
}
