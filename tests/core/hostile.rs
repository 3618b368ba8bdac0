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
    let (csv, bad, mask) = (format!("a{WILD}.csv"), format!("b{WILD}.csv"), format!("m{WILD}.a"));
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
