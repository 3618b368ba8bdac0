//! Bad input on the command line: files that are empty, huge, folders, in another encoding, or cannot be written.
//!
//! Faults within a table, a mask, a log, a list of measurements or contacts are tested with their readers.

#![cfg(test)]

use std::fs::File;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use assert_cmd::cargo::cargo_bin_cmd;
use tempfile::TempDir;

/// Every way to pass a file to the program; `FILE` stands for it.
const READERS: [&[&str]; 5] = [
    &["import", "FILE"],
    &["circle", "FILE"],
    &["check", "25 H7", "--contacts", "FILE"],
    &["check", "25 H7", "--measured", "25", "--mask", "FILE"],
    &["report", "FILE", "-o", "-", "--format", "csv"],
];

/// Exit code, standard output, standard error. A program that hangs is stopped and then has no exit code.
fn run(args: &[&str], path: &Path) -> (i32, String, String) {
    let path = path.to_str().unwrap();
    let args = args.iter().map(|arg| if *arg == "FILE" { path } else { arg });
    let output = cargo_bin_cmd!("fitcheck").args(args).timeout(Duration::from_mins(1)).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// Exit code 1 and the reason on standard error.
#[track_caller]
fn refused(args: &[&str], path: &Path, reason: &str) {
    let (code, _, err) = run(args, path);
    assert!(code == 1 && err.contains(reason), "{args:?}: exit code {code}, {err}");
}

fn file(name: &str, bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    File::create(&path).unwrap().write_all(bytes).unwrap();
    (folder, path)
}

/// 200 MB that take no space on the disk.
fn huge(name: &str) -> (TempDir, PathBuf) {
    let (folder, path) = file(name, b"");
    File::options().write(true).open(&path).unwrap().set_len(200_000_000).unwrap();
    (folder, path)
}

#[test]
fn a_file_of_200_mb_is_refused_at_once() {
    let (_folder, path) = huge("huge.csv");
    for args in READERS {
        let is_any_size = matches!(args[0], "import" | "report");
        refused(
            args,
            &path,
            if is_any_size { "not a file of a known format" } else { "the file is larger than 64 MiB" },
        );
    }
    let (_folder, path) = huge("contacts.csv");
    File::options().write(true).open(&path).unwrap().write_all(b"x;y\n1;2\n").unwrap();
    refused(&["import", "FILE"], &path, "larger than 64 MiB");
}

#[test]
fn a_table_of_200_mb_is_refused_at_once() {
    let (folder, _path) = huge("huge.tab");
    refused(&["limits", "25 H7", "--tables", "FILE"], folder.path(), "huge.tab");
    refused(&["check", "25 H7", "--measured", "25", "--tables", "FILE"], folder.path(), "larger than");
}

#[test]
fn a_stream_of_more_than_the_bound_is_refused_in_bounded_memory() {
    let input = vec![b'1'; (64 << 20) + 1];
    for args in [&["check", "25 H7", "--contacts", "-"][..], &["circle", "-"]] {
        let output = cargo_bin_cmd!("fitcheck").args(args).write_stdin(input.clone()).output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(1) && err.contains("larger than 64 MiB"), "{args:?}: {err}");
    }
}

#[test]
fn a_row_of_20_000_columns_is_read_at_once() {
    let row = |cell: &dyn Fn(usize) -> String| (0..20_000).map(cell).collect::<Vec<_>>().join(";");
    let numbers = row(&|_| "1.5".to_owned());
    let names = row(&|at| format!("c{at}"));
    for text in [format!("{names}\n{numbers}\n"), format!("{numbers}\n{numbers}\n"), format!("{names}\n{names}\n")] {
        let (_folder, path) = file("wide.csv", text.as_bytes());
        let (code, _, stderr) = run(&["import", "FILE"], &path);
        assert_eq!(code, 1, "{stderr}");
        assert!(stderr.len() < 500, "{stderr}");
    }
    let (_folder, path) = file("wide.csv", format!("callout;measured;{names}\n25 H7;25.01;{numbers}\n").as_bytes());
    let (code, _, stderr) = run(&["import", "FILE"], &path);
    assert_eq!(code, 0, "{stderr}");
    assert!(stderr.contains("c0") && stderr.len() < 500, "{stderr}");
}

#[test]
fn materials_with_thirty_thousand_names_each_are_read_at_once() {
    let names = |first: char| {
        let names: Vec<String> = (0..30_000).map(|at| format!("{first}{at}=\"{first}{at:x}\"")).collect();
        names.join(",")
    };
    let material = |name: char| format!("[[material]]\nname=\"{name}\"\nexpansion=9\nnames={{{}}}\n", names(name));
    let (_folder, path) = file("many.toml", format!("version=1\n{}{}", material('a'), material('b')).as_bytes());
    let call = ["fit", "50 H7/p6", "--materials", "FILE", "--hole-material", "a", "--shaft-material", "b"];
    let (code, out, err) = run(&[&call[..], &["--temperature", "80"]].concat(), &path);
    assert!(code == 0 && out.contains("80"), "{code} {out} {err}");
}

#[test]
fn a_folder_is_no_file() {
    let folder = tempfile::tempdir().unwrap();
    for args in READERS {
        refused(args, folder.path(), "this is a folder, not a file");
    }
}

#[test]
fn a_file_is_no_folder_of_tables() {
    let (_folder, path) = file("own.tab", b"BEGIN own.tab\n");
    for args in [
        &["limits", "25 H7", "--tables", "FILE"][..],
        &["check", "25 H7", "--measured", "25", "--tables", "FILE"],
        &["report", "--check", "25 H7=25", "-o", "-", "--format", "csv", "--tables", "FILE"],
    ] {
        refused(args, &path, "own.tab");
    }
}

#[test]
fn a_missing_file_is_named() {
    let folder = tempfile::tempdir().unwrap();
    for args in READERS {
        refused(args, &folder.path().join("none.csv"), "no such file or folder");
    }
}

#[test]
fn an_empty_file_is_refused_by_every_reader() {
    for bytes in [&b""[..], b"\xef\xbb\xbf", b"\r\n\r\n", b"   \n"] {
        let (_folder, path) = file("empty.csv", bytes);
        for args in READERS {
            let (code, _, err) = run(args, &path);
            assert!(code == 1 && err.contains("empty.csv"), "{args:?}, {bytes:?}: exit code {code}, {err}");
        }
    }
}

#[test]
fn bytes_of_no_text_are_refused_and_do_not_panic() {
    let bytes: Vec<u8> = (0..=255).cycle().take(4096).collect();
    let (_folder, path) = file("picture.csv", &bytes);
    for args in READERS {
        refused(args, &path, "picture.csv");
    }
}

#[test]
fn a_byte_order_mark_does_not_matter() {
    let contacts = "\u{feff}x,y\r\n12.506,0\r\n0,12.506\r\n-12.506,0\r\n0,-12.506\r\n";
    let (_folder, path) = file("bore.csv", contacts.as_bytes());
    assert_eq!(run(&["check", "25 H7", "--contacts", "FILE"], &path).0, 0);
    let (_folder, path) = file("shop.a", "\u{feff}\"%S\", QS3;\r\n".as_bytes());
    let (code, out, err) = run(&["check", "25 H7", "--measured", "25.012", "--mask", "FILE"], &path);
    assert_eq!((code, out.trim_end(), err.as_str()), (0, "GOOD", ""));
    let table = "\u{feff}BEGIN own.tab MM\r\nNR   BEREICH U1\r\n0    50      +8\r\n1            +3\r\n[END]\r\n";
    let (folder, _path) = file("own.tab", table.as_bytes());
    let (code, out, err) = run(&["limits", "5 U1", "--format", "csv", "--tables", "FILE"], folder.path());
    assert!(code == 0 && out.contains("5.008"), "{code} {out} {err}");
}

#[test]
fn a_place_that_cannot_be_written_is_named_and_nothing_is_left() {
    let (folder, path) = file("notes.txt", b"notes");
    let report = ["report", "--check", "25 H7=25.012", "-o", "FILE"];
    // Below a file, in a folder that does not exist, and over a folder.
    let over = folder.path().join("over.html");
    std::fs::create_dir(&over).unwrap();
    for target in [path.join("report.html"), folder.path().join("none/report.html"), over] {
        let (code, out, err) = run(&report, &target);
        let named = err.trim_end().ends_with(target.to_str().unwrap());
        assert!(code == 1 && out.is_empty() && named, "{code} {err}");
    }
    assert_eq!(std::fs::read(&path).unwrap(), b"notes");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[cfg(unix)]
#[test]
fn the_largest_file_that_the_system_allows_is_told_and_nothing_is_left() {
    let (folder, path) = file("report.html", b"the old one");
    let set = folder.path().join("set");
    let program = assert_cmd::cargo::cargo_bin!("fitcheck");
    let report: &[&str] = &["report", "--check", "25 H7=25.012", "-o"];
    let nc: &[&str] = &["nc", "25 H7", "--x", "0", "--y", "0", "--z", "-5", "--control", "tnc7", "-o"];
    for (arguments, target) in [(report, &path), (nc, &set)] {
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", "ulimit -f 1 && exec \"$0\" \"$@\""]).arg(program).args(arguments).arg(target);
        let output = shell.output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {err}");
        assert!(err.contains("File too large") && err.contains(target.to_str().unwrap()), "{err}");
    }
    assert_eq!(std::fs::read(&path).unwrap(), b"the old one");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn a_folder_without_permission_is_named() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = tempfile::tempdir().unwrap();
    std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(0o555)).unwrap();
    if tempfile::tempfile_in(folder.path()).is_ok() {
        println!("skipped: this user may write everywhere (an administrator), so no folder can refuse");
        return;
    }
    let target = folder.path().join("report.html");
    let (code, _, err) = run(&["report", "--check", "25 H7=25.012", "-o", "FILE"], &target);
    assert!(code == 1 && err.contains("ermission denied") && err.contains("report.html"), "{code} {err}");
}
