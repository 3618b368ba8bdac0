//! Long work on the command line: how far it is, on a terminal alone; Ctrl+C keeps what is done whole, and says how much that is.

#![cfg(unix)]

use std::fmt::Write as _;
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::at_home::AtHome as _;

/// Rows that take a while in a build for tests, on any machine.
const ROWS: usize = 400_000;

struct Place(TempDir);

impl Place {
    /// A folder with a file of so many rows.
    fn new(rows: usize) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let mut text = "id;callout;measured\n".to_owned();
        for row in 0..rows {
            writeln!(text, "P{row};25 H7;25.0{:02}", row % 20).unwrap();
        }
        fitcheck::files::write(&folder.path().join("rows.csv"), text.as_bytes()).unwrap();
        Self(folder)
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, program: impl AsRef<std::ffi::OsStr>) -> Command {
        let mut command = Command::new(program);
        command.current_dir(self.0.path()).at_home(self.0.path()).env_remove("FITCHECK_JOURNAL");
        command
    }

    /// Begins a call, and stops it by Ctrl+C once it has written something.
    fn stopped(&self, args: &[&str]) -> (i32, String, String) {
        let mut child = self.command("env");
        let mut child = child.args(heard()).args(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        let mut first = String::new();
        out.read_line(&mut first).unwrap();
        interrupt(&child);
        out.read_to_string(&mut first).unwrap();
        let (code, err) = ended(child);
        (code, first, err)
    }
}

fn program() -> &'static Path {
    Path::new(env!("CARGO_BIN_EXE_fitcheck"))
}

/// The program as `env` starts it: whoever runs the tests in the background of a script has Ctrl+C ignored, and the program keeps to that.
fn heard() -> Vec<String> {
    const SIGINT: u32 = 2;
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap_or_default();
    let is_ignored = u64::from_str_radix(ignored.trim(), 16).is_ok_and(|mask| mask >> (SIGINT - 1) & 1 == 1);
    let default = is_ignored.then(|| "--default-signal=INT".to_owned());
    default.into_iter().chain([program().display().to_string()]).collect()
}

/// What Ctrl+C does.
fn interrupt(child: &Child) {
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
}

/// Waits until a program has read so many bytes, where the system tells that: then it is at work.
fn has_read(child: &Child, bytes: u64) {
    let path = format!("/proc/{}/io", child.id());
    let begun = Instant::now();
    loop {
        let Ok(told) = std::fs::read_to_string(&path) else { return std::thread::sleep(Duration::from_millis(400)) };
        let read = told.lines().find_map(|line| line.strip_prefix("rchar: ")).and_then(|text| text.parse().ok());
        if read.is_none_or(|read: u64| bytes < read) {
            return;
        }
        assert!(begun.elapsed() < Duration::from_mins(2), "it never begins to read");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// The exit code as a shell says it, and standard error.
fn ended(mut child: Child) -> (i32, String) {
    use std::os::unix::process::ExitStatusExt as _;
    let mut err = String::new();
    child.stderr.take().unwrap().read_to_string(&mut err).unwrap();
    let status = child.wait().unwrap();
    (status.code().unwrap_or_else(|| 128 + status.signal().unwrap()), err)
}

/// How many rows standard error says were done.
#[track_caller]
fn rows_said(err: &str) -> usize {
    let line = err.lines().find_map(|line| line.strip_prefix("fitcheck: stopped by Ctrl+C after "));
    line.unwrap_or_else(|| panic!("{err}")).strip_suffix(" rows").unwrap().parse().unwrap()
}

#[test]
fn an_import_that_is_stopped_ends_with_a_whole_line_and_says_how_many_rows_were_done() {
    let place = Place::new(ROWS);
    let (code, out, err) = place.stopped(&["import", "rows.csv", "--format", "csv"]);
    assert_eq!(code, 130, "{err}");
    let rows = rows_said(&err);
    assert!(0 < rows && rows < ROWS, "{rows}");
    // The header, and a line for each row that is counted.
    assert_eq!(out.lines().count(), rows + 1);
    assert!(out.ends_with('\n'));
    let last = out.lines().next_back().unwrap();
    assert!(last.starts_with(&format!("rows.csv,{},P{},25 H7,", rows + 1, rows - 1)), "{last}");
    assert_eq!(last.split(',').count(), out.lines().nth(1).unwrap().split(',').count());
}

#[test]
fn the_json_of_an_import_that_is_stopped_is_whole() {
    let place = Place::new(ROWS);
    let (code, out, err) = place.stopped(&["import", "rows.csv", "--format", "json"]);
    assert_eq!(code, 130, "{err}");
    let read: Vec<serde_json::Value> = serde_json::from_str(&out).unwrap();
    assert_eq!(read.len(), rows_said(&err));
}

#[test]
fn a_batch_that_is_stopped_ends_with_a_whole_line_and_writes_no_half_file() {
    // It is fast, so it reads a pipe that never ends.
    let place = Place::new(10);
    let source = "yes '1;25 H7;25.01'";
    let mut child = place.command("sh");
    let script = format!("exec env {} batch - < pipe", heard().join(" "));
    assert!(place.command("mkfifo").arg("pipe").status().unwrap().success());
    let feed = format!("( echo 'id;callout;measured'; {source} ) > pipe");
    let mut feeding = place.command("sh").args(["-c", &feed]).stderr(Stdio::null()).spawn().unwrap();
    let mut child = child.args(["-c", &script]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    let mut text = String::new();
    for _ in 0..100 {
        out.read_line(&mut text).unwrap();
    }
    interrupt(&child);
    out.read_to_string(&mut text).unwrap();
    let (code, err) = ended(child);
    feeding.wait().unwrap();
    assert_eq!(code, 130, "{err}");
    assert!(text.ends_with(";25.000;25.021;10;GOOD;;\n"), "{:?}", text.lines().next_back());
    assert_eq!(text.lines().count(), rows_said(&err) + 1);
}

#[test]
fn what_is_stopped_writes_no_half_file_over_an_old_one() {
    let place = Place::new(ROWS);
    fitcheck::files::write(&place.at("report.html"), b"the old one").unwrap();
    let mut command = place.command("env");
    let command = command.args(heard()).args(["report", "rows.csv", "-o", "report.html"]);
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    has_read(&child, 1_000_000);
    interrupt(&child);
    let (code, err) = ended(child);
    assert_eq!(code, 130, "{err}");
    rows_said(&err);
    assert_eq!(std::fs::read_to_string(place.at("report.html")).unwrap(), "the old one");
    let mut names: Vec<_> =
        std::fs::read_dir(place.0.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["report.html", "rows.csv"]);
}

#[test]
fn an_import_that_is_stopped_before_it_records_says_that_nothing_is_recorded() {
    let place = Place::new(ROWS);
    // What was recorded before stays.
    fitcheck::files::write(&place.at("one.csv"), b"id;callout;measured\nA;25 H7;25.01\n").unwrap();
    let record = ["--record", "--journal", "j.sqlite"];
    let first = place.command(program()).args(["import", "one.csv"]).args(record).output().unwrap();
    assert!(first.status.success());
    let args = [&["import", "rows.csv", "--format", "csv"][..], &record].concat();
    let (code, _, err) = place.stopped(&args);
    assert_eq!(code, 130, "{err}");
    rows_said(&err);
    assert!(err.contains("nothing was recorded"), "{err}");
    let list = place.command(program()).args(["journal", "export", "--journal", "j.sqlite"]).output().unwrap();
    assert_eq!(String::from_utf8(list.stdout).unwrap().lines().count(), 2);
}

#[test]
fn a_second_ctrl_c_or_a_while_ends_what_does_not_hear_the_first() {
    let place = Place::new(10);
    assert!(place.command("mkfifo").arg("pipe").status().unwrap().success());
    let mut child = place.command("sh");
    let script = format!("exec env {} batch - < pipe", heard().join(" "));
    let mut feeding = place.command("sh");
    let feed = "( echo 'id;callout;measured'; echo '1;25 H7;25.01'; exec sleep 30 ) > pipe";
    let mut feeding = feeding.args(["-c", feed]).stderr(Stdio::null()).spawn().unwrap();
    let mut child = child.args(["-c", &script]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    out.read_line(&mut String::new()).unwrap();
    let begun = Instant::now();
    interrupt(&child);
    let (code, _) = ended(child);
    feeding.kill().unwrap();
    feeding.wait().unwrap();
    assert_eq!(code, 130);
    assert!(begun.elapsed() < Duration::from_secs(28), "{:?}: before the pipe ends", begun.elapsed());
}

/// What a terminal gets of a call whose answer goes to a file; `None` where there is no program that makes one.
fn on_terminal(place: &Place, args: &str) -> Option<String> {
    let call = format!("{} {args}", program().display());
    let mut script = place.command("script");
    let script = script.args(["-qec", &call, "/dev/null"]).env("TERM", "xterm").stdin(Stdio::null());
    let output = script.output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}

#[test]
fn long_work_shows_its_figures_on_a_terminal_and_takes_the_line_away() {
    let place = Place::new(ROWS);
    let begun = Instant::now();
    let Some(shown) = on_terminal(&place, "import rows.csv --format csv > out.csv") else { return };
    let tenths = begun.elapsed().as_millis() / 100;
    let size = std::fs::metadata(place.at("rows.csv")).unwrap().len();
    let all = format!(" of {}.{} MB, ", size / 1_000_000, size / 100_000 % 10);
    assert!(shown.contains("rows.csv: ") && shown.contains(" rows, "), "{shown:?}");
    assert!(shown.contains(&all) && shown.contains(" rows a second"), "{all}: {shown:?}");
    // At most ten times a second.
    let times = shown.matches(" rows a second").count();
    assert!(u128::try_from(times).unwrap() <= tenths, "{times} times in {tenths} tenths of a second");
    // The last thing that is done to the line is that it is cleared.
    let rest = shown.rsplit(" rows a second").next().unwrap();
    assert!(rest.contains("\u{1b}[2K") || rest.contains("\u{1b}[K") || rest.contains("\u{1b}[J"), "{rest:?}");
    assert_eq!(std::fs::read_to_string(place.at("out.csv")).unwrap().lines().count(), ROWS + 1);
}

#[test]
fn short_work_and_work_in_pipes_show_nothing() {
    let place = Place::new(100);
    if let Some(shown) = on_terminal(&place, "import rows.csv --format csv > out.csv") {
        assert_eq!(shown, "");
    }
    let place = Place::new(ROWS / 2);
    let output = place.command(program()).args(["import", "rows.csv", "--format", "csv"]).output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    // An answer that comes to the terminal itself is not disturbed.
    if let Some(shown) = on_terminal(&place, "import rows.csv --format csv") {
        assert_eq!(shown.matches("\r\n").count(), ROWS / 2 + 1);
        let (_, rows) = shown.split_once("rows.csv,2,").unwrap();
        assert!(!rows.contains(" rows a second"));
    }
}
