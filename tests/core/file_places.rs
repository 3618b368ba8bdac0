//! Where files are written: modes, links, pipes and devices stay what they are, and nothing is left beside them.

#![cfg(all(test, unix))]

use std::fs::{read, read_dir, read_to_string};
use std::io::ErrorKind;
use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, PermissionsExt as _, symlink};
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use fitcheck::files::{FileError, no_half_set, read_file, save, write, write_folder, write_new};
use fitcheck::store::tables::read_tables;

const PROGRAM: &str = env!("CARGO_BIN_EXE_fitcheck");

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn mode(path: &Path) -> u32 {
    path.metadata().unwrap().mode() & 0o7777
}

#[test]
fn a_file_that_is_replaced_keeps_its_mode_and_group() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.html");
    for wanted in [0o600, 0o640, 0o664, 0o666, 0o755] {
        write(&path, b"old").unwrap();
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(wanted)).unwrap();
        let before = path.metadata().unwrap();
        write(&path, b"new").unwrap();
        let after = path.metadata().unwrap();
        assert_eq!(read(&path).unwrap(), b"new");
        assert_eq!((mode(&path), after.uid(), after.gid()), (wanted, before.uid(), before.gid()));
    }
    // Somebody else's, where this can be tried: only the administrator gives files away.
    if std::os::unix::fs::chown(&path, Some(4711), Some(4712)).is_ok() {
        write(&path, b"newer").unwrap();
        let after = path.metadata().unwrap();
        assert_eq!((after.uid(), after.gid()), (4711, 4712));
    }
}

#[test]
fn a_new_file_has_the_mode_that_the_user_wants_for_new_files() {
    let folder = tempfile::tempdir().unwrap();
    for (umask, wanted, of_folder) in [("022", 0o644, 0o755), ("027", 0o640, 0o750), ("077", 0o600, 0o700)] {
        let run = |arguments: &str| {
            let line = format!("umask {umask}; exec {PROGRAM} {arguments}");
            assert!(Command::new("sh").args(["-c", &line]).current_dir(&folder).output().unwrap().status.success());
        };
        let (file, set) = (folder.path().join(format!("{umask}.html")), folder.path().join(umask));
        run(&format!("report --check '25 H7=25.01' -o {}", file.display()));
        run(&format!("nc '25 H7' --control tnc640 --x 0 --y 0 --z -5 -o {}", set.display()));
        assert_eq!((mode(&file), mode(&set)), (wanted, of_folder));
        for name in names(&set) {
            assert_eq!(mode(&set.join(&name)), wanted, "{name}");
        }
    }
}

#[test]
fn a_link_stays_and_what_it_leads_to_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let (real, link, far) = ("real.csv", "link.csv", "far.csv").into_paths(folder.path());
    symlink("real.csv", &link).unwrap();
    symlink("link.csv", &far).unwrap();
    // A link that leads nowhere yet, a link to a file, and a link to a link.
    for (path, text) in [(&link, "one"), (&link, "two"), (&far, "three")] {
        write(path, text.as_bytes()).unwrap();
        assert_eq!(read_to_string(&real).unwrap(), text);
        assert!(link.is_symlink() && far.is_symlink());
    }
    save(&far, b"four", true).unwrap();
    assert_eq!(read_to_string(&real).unwrap(), "four");
    assert_eq!(write_new(&far, b"five"), Err(FileError::Exists { path: far.clone() }));
    let circle = folder.path().join("circle.csv");
    symlink("circle.csv", &circle).unwrap();
    assert!(matches!(write(&circle, b"six"), Err(FileError::System { .. })));
    assert_eq!(names(folder.path()), ["circle.csv", "far.csv", "link.csv", "real.csv"]);
}

trait IntoPaths {
    fn into_paths(self, folder: &Path) -> (std::path::PathBuf, std::path::PathBuf, std::path::PathBuf);
}

impl IntoPaths for (&str, &str, &str) {
    fn into_paths(self, folder: &Path) -> (std::path::PathBuf, std::path::PathBuf, std::path::PathBuf) {
        (folder.join(self.0), folder.join(self.1), folder.join(self.2))
    }
}

fn pipe(folder: &Path) -> std::path::PathBuf {
    let pipe = folder.join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    pipe
}

#[test]
fn a_pipe_is_written_to_and_stays_a_pipe() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = pipe(folder.path());
    let reader = Command::new("cat").arg(&pipe).stdout(std::process::Stdio::piped()).spawn().unwrap();
    write(&pipe, b"through").unwrap();
    assert_eq!(reader.wait_with_output().unwrap().stdout, b"through");
    assert!(pipe.symlink_metadata().unwrap().file_type().is_fifo());
    assert_eq!(names(folder.path()), ["pipe"]);
    // The window waits for nobody at the other end.
    assert_eq!(save(&pipe, b"", true), Err(FileError::NotAFile { path: pipe.clone() }));
    assert_eq!(read_file(&pipe), Err(FileError::NotAFile { path: pipe.clone() }));
}

#[test]
fn devices_and_open_files_are_written_to() {
    let folder = tempfile::tempdir().unwrap();
    let report = |output: &str| format!("report --check '25 H7=25.01' -o {output}");
    let run = |line: &str| {
        let line = line.replace("fitcheck", PROGRAM);
        Command::new("sh").args(["-c", &line]).current_dir(&folder).output().unwrap()
    };
    let link = folder.path().join("out.json");
    symlink("/dev/stdout", &link).unwrap();
    let piped = run(&format!("fitcheck {} | cat", report("out.json")));
    assert!(piped.stdout.starts_with(b"{"), "{piped:?}");
    // What is in the open file already stays before it.
    let appended = run(&format!("echo first >all; fitcheck {} >>all", report("out.json")));
    assert!(appended.status.success(), "{appended:?}");
    let all = read_to_string(folder.path().join("all")).unwrap();
    assert!(all.starts_with("first\n{") && all.ends_with("}\n"), "{all}");
    assert!(link.is_symlink());
    if Path::new("/dev/full").exists() {
        symlink("/dev/full", folder.path().join("full.html")).unwrap();
        let full = run(&format!("fitcheck {}", report("full.html")));
        assert_eq!(full.status.code(), Some(1), "{full:?}");
        assert!(String::from_utf8_lossy(&full.stderr).contains("full.html"), "{full:?}");
    }
}

#[test]
fn many_writers_of_one_file_leave_one_whole_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.csv");
    let texts: Vec<String> = (0..8).map(|writer| writer.to_string().repeat(100_000)).collect();
    std::thread::scope(|scope| {
        for text in &texts {
            scope.spawn(|| (0..20).for_each(|_| write(&path, text.as_bytes()).unwrap()));
        }
    });
    assert!(texts.contains(&read_to_string(&path).unwrap()));
    assert_eq!(names(folder.path()), ["report.csv"]);
}

/// A running program's file may not be written to, not even by the administrator.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_may_not_be_written_to_is_not_replaced_either() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("busy.csv");
    std::fs::copy("/bin/sleep", &path).unwrap();
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    let before = read(&path).unwrap();
    // A process that another test begins at the same time can hold the copy open for a moment.
    let start = || match Command::new(&path).arg("60").spawn() {
        Err(busy) if busy.kind() == ErrorKind::ExecutableFileBusy => {
            std::thread::sleep(Duration::from_millis(10));
            None
        }
        started => Some(started.unwrap()),
    };
    let mut running = (0..1000).find_map(|_| start()).unwrap();
    let refused = write(&path, b"new");
    running.kill().unwrap();
    running.wait().unwrap();
    assert!(matches!(refused, Err(FileError::System { .. })), "{refused:?}");
    assert!(read(&path).unwrap() == before);
    assert_eq!(names(folder.path()), ["busy.csv"]);
}

const OLD: [(&str, &[u8]); 2] = [("a.h", b"old"), ("b.h", b"old")];

/// A folder in which moving the new set stopped after its first file.
fn half_written() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    write_folder(folder.path(), &OLD, false).unwrap();
    write(&folder.path().join("a.h"), b"new").unwrap();
    let moving = folder.path().join(".fitcheck-set");
    std::fs::create_dir(&moving).unwrap();
    write(&moving.join("b.h"), b"new").unwrap();
    folder
}

#[test]
fn the_next_set_first_finishes_the_one_that_stopped_halfway() {
    let folder = half_written();
    let half = FileError::HalfSet { path: folder.path().join(".fitcheck-set") };
    assert_eq!(no_half_set(folder.path()), Err(half.clone()));
    assert!(read_tables(folder.path()).unwrap_err().to_string() == half.to_string());
    let paths = write_folder(folder.path(), &[("c.h", b"newer")], false).unwrap();
    assert_eq!(paths, [folder.path().join("c.h"), folder.path().join("b.h")]);
    for (name, text) in [("a.h", "new"), ("b.h", "new"), ("c.h", "newer")] {
        assert_eq!(read_to_string(folder.path().join(name)).unwrap(), text);
    }
    assert_eq!(names(folder.path()), ["a.h", "b.h", "c.h"]);
    assert_eq!(no_half_set(folder.path()), Ok(()));
}

#[test]
fn a_set_that_was_never_whole_goes_without_a_trace() {
    let folder = tempfile::tempdir().unwrap();
    write_folder(folder.path(), &OLD, false).unwrap();
    let growing = folder.path().join(".fitcheck-new");
    std::fs::create_dir(&growing).unwrap();
    write(&growing.join("a.h"), b"ha").unwrap();
    assert_eq!(no_half_set(folder.path()), Ok(()), "the old files are still all there");
    write_folder(folder.path(), &[("a.h", b"new")], true).unwrap();
    assert_eq!(names(folder.path()), ["a.h", "b.h"]);
    assert_eq!(read_to_string(folder.path().join("a.h")).unwrap(), "new");
    // Beside a folder that does not exist yet, too.
    let left = folder.path().join(".set.fitcheck");
    std::fs::create_dir(&left).unwrap();
    write_folder(&folder.path().join("set"), &OLD, false).unwrap();
    assert!(!left.exists());
}

#[test]
fn a_set_keeps_modes_and_links() {
    let folder = tempfile::tempdir().unwrap();
    write_folder(folder.path(), &OLD, false).unwrap();
    let (a, b, real) = ("a.h", "b.h", "real.h").into_paths(folder.path());
    std::fs::set_permissions(&a, std::fs::Permissions::from_mode(0o600)).unwrap();
    std::fs::rename(&b, &real).unwrap();
    symlink("real.h", &b).unwrap();
    write_folder(folder.path(), &[("a.h", b"new"), ("b.h", b"new")], true).unwrap();
    assert_eq!((mode(&a), b.is_symlink()), (0o600, true));
    assert_eq!((read(&a).unwrap(), read(&real).unwrap()), (b"new".to_vec(), b"new".to_vec()));
}

#[test]
fn what_stands_where_a_set_waits_is_never_followed() {
    let folder = tempfile::tempdir().unwrap();
    let moving = folder.path().join(".fitcheck-set");
    std::fs::create_dir(&moving).unwrap();
    symlink("/dev/zero", moving.join("a.h")).unwrap();
    let refused = write_folder(folder.path(), &OLD, true);
    assert!(matches!(refused, Err(FileError::System { .. })), "{refused:?}");
    assert_eq!(names(folder.path()), [".fitcheck-set"]);
}

#[test]
fn no_program_is_run_from_a_half_written_folder() {
    let folder = half_written();
    write(&folder.path().join("a.h"), b"0 BEGIN PGM A MM\r\n1 END PGM A MM\r\n").unwrap();
    let program = folder.path().join("a.h").display().to_string();
    let outcome = Command::new(PROGRAM).args(["run", &program]).output().unwrap();
    let told = String::from_utf8_lossy(&outcome.stderr).into_owned();
    assert_eq!(outcome.status.code(), Some(1));
    assert!(told.contains("stopped in the middle") && told.contains(".fitcheck-set"), "{told}");
}

#[test]
fn a_set_that_came_with_a_folder_writes_nothing_outside_it() {
    let home = tempfile::tempdir().unwrap();
    let (own, given) = (home.path().join("own.txt"), home.path().join("given"));
    std::fs::create_dir_all(given.join(".fitcheck-set")).unwrap();
    write(&own, b"mine").unwrap();
    write(&given.join(".fitcheck-set/notes.txt"), b"theirs").unwrap();
    symlink(&own, given.join("notes.txt")).unwrap();
    write_folder(&given, &[("a.txt", b"new")], false).unwrap();
    assert_eq!(read_to_string(&own).unwrap(), "mine");
    assert_eq!(read_to_string(given.join("notes.txt")).unwrap(), "theirs");
    assert!(!given.join("notes.txt").is_symlink());
}

#[test]
fn a_set_that_is_a_link_to_another_folder_takes_nothing_from_there() {
    let home = tempfile::tempdir().unwrap();
    let (own, given) = (home.path().join("own"), home.path().join("given"));
    std::fs::create_dir_all(&own).unwrap();
    std::fs::create_dir_all(&given).unwrap();
    write(&own.join("letter.txt"), b"mine").unwrap();
    symlink(&own, given.join(".fitcheck-set")).unwrap();
    let error = write_folder(&given, &[("a.txt", b"new")], false).unwrap_err();
    assert!(error.to_string().contains(".fitcheck-set is not a folder"), "{error}");
    assert_eq!(names(&own), ["letter.txt"]);
    assert_eq!(names(&given), [".fitcheck-set"]);
}
