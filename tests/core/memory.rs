//! Memory that is there: with little of it, the program still answers. `tests/attack/memory` measures more and larger.

#![cfg(all(test, unix))]

use std::fs::File;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

use fitcheck::report::RENDERINGS;
use tempfile::TempDir;

/// The program, its stacks and its libraries, KiB. Libraries are not optimised for tests, and those of Parquet and of the shop's server
/// are large: a run of `limits` under `ulimit -v` tells how much.
const PROGRAM: usize = (64 << 10) + PARQUET + SHOP;
const PARQUET: usize = if cfg!(feature = "parquet") { 16 << 10 } else { 0 };
const SHOP: usize = if cfg!(feature = "shop") { 24 << 10 } else { 0 };
/// What any work takes, KiB: less than the 64 MB that it may take, so that small files show what large ones would need.
const BASE: usize = 24_000;

/// Runs the program with so much memory for its work, in KiB; exit code and standard error.
fn run(memory: usize, args: &[&str]) -> (Option<i32>, String) {
    let output = Command::new("sh")
        .args(["-c", "ulimit -v \"$0\" && exec \"$@\"", &(PROGRAM + memory).to_string()])
        .arg(env!("CARGO_BIN_EXE_fitcheck"))
        .args(args)
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// 64 MB, KiB: for work that keeps up to its own limit, as a trace does.
const WHOLE: usize = 62_500;

/// Runs it on a file: it gets a little and twice the file, and must end with one of its own exit codes.
#[track_caller]
fn check(path: &Path, args: &[&str], code: i32) {
    check_within(BASE, path, args, code);
}

#[track_caller]
fn check_within(base: usize, path: &Path, args: &[&str], code: i32) {
    let file = path.to_str().unwrap();
    let args: Vec<&str> = args.iter().map(|arg| if *arg == "FILE" { file } else { arg }).collect();
    let kept = usize::try_from(path.metadata().unwrap().len()).unwrap() >> 9;
    let (found, err) = run(base + kept, &args);
    let end: String = err.chars().rev().take(300).collect::<Vec<_>>().into_iter().rev().collect();
    assert_eq!(found, Some(code), "{args:?}: {end}");
}

fn file(folder: &TempDir, name: &str, part: &str, size: usize) -> std::path::PathBuf {
    let path = folder.path().join(name);
    File::create(&path).unwrap().write_all(part.repeat(size / part.len()).as_bytes()).unwrap();
    path
}

#[test]
fn a_file_of_separators_takes_little_more_than_itself() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.html");
    let out = out.to_str().unwrap();
    // Beyond the mebibyte that a row may have.
    for part in [";", "\"\n"] {
        let path = file(&folder, "all.csv", part, 2 << 20);
        check(&path, &["import", "FILE", "--format", "csv"], 1);
        check(&path, &["report", "FILE", "-o", out], 1);
        check(&path, &["cycle", "427", "--inputs", "FILE"], 1);
        check(&path, &["nc", "FILE", "--control", "tnc7", "-o", out], 1);
        check(&path, &["circle", "FILE"], 1);
        check(&path, &["check", "25 H7", "--contacts", "FILE"], 1);
        let log = file(&folder, "TCHPR421.TXT", part, 2 << 20);
        check(&log, &["import", "FILE", "--format", "csv"], 1);
        check(&log, &["cycle", "427", "--block", "FILE"], 1);
    }
}

#[test]
fn rows_are_judged_and_printed_one_by_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rows.csv");
    let mut rows = std::io::BufWriter::new(File::create(&path).unwrap());
    rows.write_all(b"id;callout;measured\n").unwrap();
    (0..20_000).try_for_each(|row| writeln!(rows, "A{row};25 H7;25.1")).unwrap();
    drop(rows);
    for format in ["text", "csv", "json"] {
        let args = ["import", "FILE", "--format", format];
        let kept = usize::try_from(path.metadata().unwrap().len()).unwrap() >> 9;
        let args: Vec<&str> =
            args.iter().map(|arg| if *arg == "FILE" { path.to_str().unwrap() } else { arg }).collect();
        let (code, err) = run(BASE + kept, &args);
        assert_eq!(code, Some(11), "{format}: {err}");
    }
    // A workbook and a PDF are made in memory; a picture is of one label.
    let streamed = RENDERINGS.iter().filter(|rendering| !matches!(rendering.name, "xlsx" | "pdf" | "png"));
    for ending in streamed.filter_map(|rendering| rendering.endings.first()) {
        let out = folder.path().join(format!("report.{ending}"));
        let (code, err) = run(BASE, &["report", path.to_str().unwrap(), "-o", out.to_str().unwrap()]);
        assert_eq!(code, Some(11), "{ending}: {err}");
    }
}

/// A program that repeats its blocks until a budget ends it.
fn forever(folder: &TempDir, blocks: &str) -> std::path::PathBuf {
    let path = folder.path().join("main.h");
    let text = format!("BEGIN PGM main MM\nLBL 1\n{blocks}\nFN 9: IF +0 EQU +0 GOTO LBL 1\nEND PGM main MM\n");
    File::create(&path).unwrap().write_all(text.as_bytes()).unwrap();
    path
}

#[test]
fn the_trace_of_an_endless_program_is_bounded() {
    let folder = tempfile::tempdir().unwrap();
    let long = format!("; {}", "x".repeat(200_000));
    let trace = ["run", "FILE", "--trace", "--format", "json", "--max-blocks", "60000"];
    check_within(WHOLE, &forever(&folder, &format!("Q1 = 1 {long}")), &trace, 1);
    let text = format!("QS1 = \"{}\"", "y".repeat(250));
    let many: Vec<String> = (2..90).map(|number| format!("QS{number} = QS1")).collect();
    check_within(WHOLE, &forever(&folder, &format!("{text}\n{}", many.join("\n"))), &trace, 1);
    File::create(folder.path().join("m.a")).unwrap().write_all(b"\"x\";\n").unwrap();
    let windows = forever(&folder, &format!("FN 16: F-PRINT m.a / SCREEN: {long}"));
    check_within(WHOLE, &windows, &["run", "FILE", "--format", "json"], 1);
}
