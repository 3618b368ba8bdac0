//! Names, arguments and texts that somebody else has written: they change neither the terminal, nor a spreadsheet, nor
//! the exit code.

use std::path::Path;

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin_cmd;

/// ESC, which writes a terminal's title and hides lines, and a mark that turns the direction of a text.
const WILD: &str = "\u{1b}]0;owned\u{7}\u{202e}";

fn fitcheck(folder: &Path) -> Command {
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder).env_clear();
    command
}

/// Both streams of a call, as one text.
fn said(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    text(&output.stdout) + &text(&output.stderr)
}

fn is_tame(text: &str) -> bool {
    let is_wild = |c: char| c.is_control() && !"\n\t\r".contains(c) || ('\u{202a}'..='\u{202e}').contains(&c);
    !text.contains(is_wild)
}

#[test]
fn no_name_argument_or_text_reaches_the_terminal_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    // Windows has no file of such a name; a name that is only asked for may be any.
    let name = if cfg!(windows) { "\u{202e}" } else { WILD };
    let (csv, bad, mask) = (format!("a{name}.csv"), format!("b{name}.csv"), format!("m{name}.a"));
    put(&csv, &format!("id;callout;measured\n{WILD};25 H7;25.01\n{WILD};25 {WILD};25.01\n"));
    put(&bad, "\u{0}\u{1}");
    put(&mask, &format!("\"{WILD}\";\n\"%S {WILD}\", QS3;\n\"%S\", {WILD};\n"));
    let missing = format!("none{WILD}");
    let calls: [&[&str]; 12] = [
        &["import", &csv],
        &["import", &bad],
        &["import", &missing],
        &["report", &csv, "-o", "report.html"],
        &["report", &csv, "-o", &format!("{WILD}/report.html")],
        &["check", "25 H7", "--measured", "25.01", "--mask", &mask],
        &["check", "25 H7", "--measured", WILD],
        &["check", WILD, "--measured", "25"],
        &["limits", WILD],
        &["fit", WILD],
        &["run", &missing],
        &[&missing, WILD],
    ];
    for call in calls {
        let said = said(fitcheck(folder.path()).args(call));
        assert!(!said.is_empty() && is_tame(&said), "{call:?}: {said:?}");
    }
}

#[test]
fn a_cell_that_a_spreadsheet_would_compute_gets_an_apostrophe_in_every_csv() {
    let folder = tempfile::tempdir().unwrap();
    let formula = "=HYPERLINK(A1)";
    let rows = format!("id;callout;measured\n{formula};25 H7;25.01\n");
    fitcheck::files::write(&folder.path().join("a.csv"), rows.as_bytes()).unwrap();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("tables/82553_hole.tab");
    let table = std::fs::read_to_string(shipped).unwrap().replace("+149", "+150");
    fitcheck::files::write(&folder.path().join(formula), table.as_bytes()).unwrap();
    let calls: [&[&str]; 5] = [
        &["table", "verify", formula, "--format", "csv"],
        &["import", "a.csv", "--format", "csv"],
        &["report", "a.csv", "-o", "-", "--format", "csv"],
        &["limits", formula, "--format", "csv"],
        &["fit", formula, "--format", "csv"],
    ];
    for call in calls {
        let output = fitcheck(folder.path()).args(call).output().unwrap();
        let said = String::from_utf8(output.stdout).unwrap();
        let cells: Vec<&str> = said.split([',', '\n']).map(|cell| cell.trim_start_matches('"')).collect();
        assert!(cells.contains(&format!("'{formula}").as_str()), "{call:?}: {said}");
        assert!(!cells.iter().any(|cell| cell.starts_with(['=', '@'])), "{call:?}: {said}");
    }
    // Numbers stay numbers.
    let said = said(fitcheck(folder.path()).args(["limits", "25 g6", "--format", "csv"]));
    assert!(said.contains(",-7,") && !said.contains('\''), "{said}");
}

#[cfg(target_os = "linux")]
#[test]
fn the_exit_code_stands_when_standard_error_takes_nothing() {
    use std::process::Stdio;
    let folder = tempfile::tempdir().unwrap();
    let rows = b"id;callout;measured;note\n1;25 H7;24.99;x\n";
    fitcheck::files::write(&folder.path().join("a.csv"), rows).unwrap();
    let calls: [(&[&str], i32); 3] = [
        (&["check", "25 H7", "--measured", "24.998"], 10),
        (&["check", "25 H7", "--measured", "25.03"], 11),
        (&["import", "a.csv"], 10),
    ];
    for (call, code) in calls {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let program = assert_cmd::cargo::cargo_bin!("fitcheck");
        let mut command = std::process::Command::new(program);
        command.args(call).current_dir(folder.path()).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(full);
        let output = command.spawn().unwrap().wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{call:?}");
        assert!(!output.stdout.is_empty(), "{call:?}");
    }
}

/// A line feed in a name, and what it would have printed as a line of its own.
#[cfg(unix)]
const FORGED: &str = "a\nGOOD forged\r\nGOOD forged.csv";

#[cfg(unix)]
#[test]
fn no_name_argument_or_cell_begins_a_line_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    put(FORGED, "id;callout;measured;note\n1;25 H7;25.03;x\n2;25 H7;\n");
    put("a.csv", "id;callout;measured\n1;25 H7;25.03\n");
    put("bad.csv", &format!("id;callout;measured\n\"{FORGED}\";25 H7;25,03\n"));
    let journal = ["--journal", "j.sqlite"];
    let names =
        ["--record", "--part", FORGED, "--serial", FORGED, "--who", FORGED, "--remark", FORGED, "--station", FORGED];
    let recording = [&["check", "25 H7", "--measured", "25.01"][..], &names, &journal].concat();
    let long_option = format!("--{FORGED}");
    let calls: Vec<Vec<&str>> = vec![
        recording,
        vec!["journal", "list", "--journal", "j.sqlite"],
        vec!["journal", "show", "2", "--journal", "j.sqlite"],
        vec!["journal", "list", FORGED, "--journal", "j.sqlite"],
        vec!["journal", "list", "--journal", FORGED],
        vec!["import", FORGED],
        vec!["import", FORGED, FORGED],
        vec!["import", "bad.csv"],
        vec!["import", "a.csv", "--plan", FORGED],
        vec!["import", "a.csv", "--columns", FORGED],
        vec!["import", "a.csv", "--mask", FORGED],
        vec!["import", "--show-columns", FORGED],
        vec!["report", FORGED, "-o", "r.html"],
        vec!["report", "a.csv", "--check", FORGED, "-o", "r.html"],
        vec!["batch", FORGED],
        vec!["pair", FORGED, "a.csv", "--clearance", "0.01..0.02"],
        vec!["circle", FORGED],
        vec!["cycle", "421", "--set", FORGED],
        vec!["cycle", FORGED],
        vec!["run", FORGED],
        vec!["run", "a.csv", "--workpiece", FORGED],
        vec!["check", "25 H7", "--measured", FORGED],
        vec!["check", FORGED, "--measured", "25"],
        vec!["check", "25 H7", "--measured", "25", "--table", FORGED],
        vec!["check", "25 H7", "--measured", "25", "--rule", FORGED],
        vec!["check", "25 H7", "--measured", "25", "--material", FORGED, "--temperature", "20"],
        vec!["limits", FORGED],
        vec!["fit", FORGED],
        vec!["table", "verify", FORGED],
        vec!["plan", "check", FORGED],
        vec!["budget", FORGED],
        vec!["nc", FORGED, "--control", "tnc7", "-o", "set"],
        vec!["watch", FORGED],
        vec![FORGED, FORGED],
        vec!["--", "none", FORGED],
        vec!["import", &long_option],
        vec![&long_option],
    ];
    for call in calls {
        let said = said(fitcheck(folder.path()).args(&call));
        assert!(!said.is_empty(), "{call:?}");
        assert!(!said.lines().any(|line| line.starts_with("GOOD forged")), "{call:?}: {said}");
    }
}

#[cfg(unix)]
#[test]
fn a_note_beside_a_file_is_written_line_by_line() {
    let folder = tempfile::tempdir().unwrap();
    let drop = folder.path().join("drop");
    std::fs::create_dir(&drop).unwrap();
    fitcheck::files::write(&drop.join(FORGED), b"id;callout;measured\n1;25 H7;25.03x\n").unwrap();
    let said = said(fitcheck(folder.path()).args(["watch", "drop", "--journal", "j.sqlite", "--until-idle", "1"]));
    assert!(!said.lines().any(|line| line.starts_with("GOOD forged")), "{said}");
    let notes = std::fs::read_dir(&drop).unwrap().filter_map(|entry| {
        let path = entry.unwrap().path();
        path.to_string_lossy().ends_with(".why.txt").then(|| std::fs::read_to_string(&path).unwrap())
    });
    let notes: Vec<String> = notes.collect();
    assert!(notes.len() == 1 && !notes[0].contains("\nGOOD"), "{notes:?}");
}

#[test]
fn nothing_behind_a_semicolon_a_tab_or_a_line_end_is_computed() {
    let folder = tempfile::tempdir().unwrap();
    let id = "x;=1+1\t@SUM(1)";
    fitcheck::files::write(
        &folder.path().join("a.csv"),
        format!("id,callout,measured\n{id},25 H7,24.993\n").as_bytes(),
    )
    .unwrap();
    let recorded = ["check", "25 H7", "--measured", "24.993", "--record", "--journal", "j.sqlite", "--part", "p;=1;+2"];
    assert!(said(fitcheck(folder.path()).args(recorded)).contains("recorded"));
    let calls: [&[&str]; 6] = [
        &["import", "a.csv", "--format", "csv"],
        &["report", "a.csv", "-o", "-", "--format", "csv"],
        &["journal", "list", "--journal", "j.sqlite", "--format", "csv"],
        &["journal", "export", "--journal", "j.sqlite"],
        &["limits", "x;=1+1", "--format", "csv"],
        &["fit", "x;=1+1", "--format", "csv"],
    ];
    for call in calls {
        let output = fitcheck(folder.path()).args(call).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        let cells: Vec<&str> = text.split([';', '\t', '\n']).skip(1).map(str::trim).collect();
        assert!(!cells.iter().any(|cell| cell.starts_with(['=', '+', '@'])), "{call:?}: {text}");
        assert!(text.contains(";'") || text.contains("\n'="), "{call:?}: {text}");
    }
    // A number stays one.
    let (text, file) = (said(fitcheck(folder.path()).args(["import", "a.csv", "--format", "csv"])), ",-7,");
    assert!(text.contains(file), "{text}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_told_never_good_and_leaves_scrap_scrap() {
    use std::process::Stdio;
    let folder = tempfile::tempdir().unwrap();
    let rows = |measured: &str| format!("id;callout;measured\n{}", format!("1;25 H7;{measured}\n").repeat(2_000));
    for (name, measured) in [("good.csv", "25.01"), ("scrap.csv", "25.03"), ("rework.csv", "24.99")] {
        fitcheck::files::write(&folder.path().join(name), rows(measured).as_bytes()).unwrap();
    }
    let calls: [(&[&str], i32); 9] = [
        (&["check", "25 H7", "--measured", "25.03"], 11),
        (&["check", "25 H7", "--measured", "24.998"], 1),
        (&["check", "25 H7", "--measured", "25.01"], 1),
        (&["check", "25 H7", "--measured", "25.03", "--format", "json"], 11),
        (&["import", "scrap.csv"], 11),
        (&["import", "scrap.csv", "--format", "csv"], 11),
        (&["import", "rework.csv", "--format", "json"], 1),
        (&["import", "good.csv"], 1),
        (&["limits", "25 H7"], 1),
    ];
    let program = assert_cmd::cargo::cargo_bin!("fitcheck");
    for (call, code) in calls {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut command = std::process::Command::new(program);
        command.args(call).current_dir(folder.path()).stdin(Stdio::null()).stdout(full).stderr(Stdio::piped());
        let output = command.spawn().unwrap().wait_with_output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{call:?}: {said}");
        assert!(said.contains("No space left"), "{call:?}: {said}");
    }
    // Whoever closes the pipe early gets the same exit code.
    for (file, code) in [("scrap.csv", 11), ("good.csv", 0)] {
        let mut command = std::process::Command::new(program);
        command.args(["import", file, "--format", "csv"]).current_dir(folder.path());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        assert_eq!(child.wait_with_output().unwrap().status.code(), Some(code), "{file}");
    }
}

#[test]
fn a_dash_is_standard_output_wherever_a_file_is_written() {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("a.csv"), b"id;callout;measured\n1;25 H7;25.01\n").unwrap();
    fitcheck::files::write(&folder.path().join("b.csv"), b"id;callout;measured\n1;25 g6;24.99\n").unwrap();
    fitcheck::files::write(&folder.path().join("p.csv"), b"name;callout\nA;25 H7\n").unwrap();
    let recorded = ["check", "25 H7", "--measured", "25.01", "--record", "--journal", "j.sqlite"];
    assert!(said(fitcheck(folder.path()).args(recorded)).contains("recorded"));
    let printed: [&[&str]; 9] = [
        &["journal", "export", "--journal", "j.sqlite", "-o", "-"],
        &["batch", "a.csv", "-o", "-"],
        &["report", "a.csv", "-o", "-", "--format", "csv"],
        &["pair", "a.csv", "b.csv", "--clearance", "0.01..0.03", "-o", "-"],
        &["sql", "--dialect", "sqlite", "-o", "-"],
        &["table", "export", "--format", "csv", "-o", "-"],
        &["table", "new", "--classes", "H7", "-o", "-"],
        &["plan", "convert", "p.csv", "-o", "-"],
        &["plan", "new", "-", "25 H7"],
    ];
    for call in printed {
        let output = fitcheck(folder.path()).args(call).output().unwrap();
        assert!(!output.stdout.is_empty(), "{call:?}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(!folder.path().join("-").exists(), "{call:?}");
    }
    let refused: [&[&str]; 5] = [
        &["journal", "backup", "-", "--journal", "j.sqlite"],
        &["nc", "25 H7", "--x", "40", "--y", "30", "--z", "-8", "--control", "tnc7", "-o", "-"],
        &["run", "8255_nl.h", "--output-folder", "-"],
        &["cycle", "421", "--log-folder", "-"],
        &["table", "new", "--classes", "H7 h7", "-o", "-"],
    ];
    for call in refused {
        let said = said(fitcheck(folder.path()).args(call));
        assert!(!folder.path().join("-").exists(), "{call:?}: {said}");
    }
}
