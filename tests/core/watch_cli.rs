//! `fitcheck watch` as a program: killed in the middle, started twice.

use std::collections::BTreeMap;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use fitcheck::files;
use fitcheck::journal::entry::Checked;

use crate::at_home::AtHome as _;
use crate::watching::PLAN;

struct Running(Child);

impl Running {
    fn start(folder: &Path) -> Self {
        Self::of(Self::command(folder))
    }

    fn of(mut command: Command) -> Self {
        Self(command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap())
    }

    fn command(folder: &Path) -> Command {
        Self::until_idle(folder, "4")
    }

    fn until_idle(folder: &Path, seconds: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
        let args = ["watch", "in", "--plan", "plan.csv", "--journal", "j.sqlite", "--until-idle", seconds];
        command.current_dir(folder).args(args);
        command.at_home(folder).env_remove("FITCHECK_JOURNAL");
        command
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _gone = self.0.kill();
        let _code = self.0.wait();
    }
}

/// 500 files at once, half of them written in slow pieces, and the program killed in the middle of it, three times.
#[test]
fn five_hundred_files_are_taken_once_each_whoever_is_killed_meanwhile() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("in");
    std::fs::create_dir(&input).unwrap();
    files::write(&folder.path().join("plan.csv"), PLAN.as_bytes()).unwrap();
    // Every value is another one, within the zone from 12.016 to 12.059.
    let value = |file: usize, row: usize| format!("12.{:05}", 1_600 + 2 * (2 * file + row));
    let writer = {
        let input = input.clone();
        let write = move || {
            let rows = |file: usize| format!("BORE_A;{}\nBORE_A;{}\n", value(file, 0), value(file, 1));
            let mut slow = Vec::new();
            for file in 0..500 {
                let text = format!("name;measured\n{}", rows(file));
                let path = input.join(format!("m{file:03}.csv"));
                if file % 2 == 0 {
                    files::write(&path, text.as_bytes()).unwrap();
                } else {
                    slow.push((path, text));
                }
            }
            // Seven bytes at a time: in the middle of names and numbers.
            for piece in 0..12 {
                for (path, text) in &slow {
                    let bytes = text.as_bytes().chunks(7).nth(piece).unwrap_or_default();
                    OpenOptions::new().create(true).append(true).open(path).unwrap().write_all(bytes).unwrap();
                }
                std::thread::sleep(Duration::from_millis(150));
            }
            assert!(slow.iter().all(|(path, text)| std::fs::read_to_string(path).unwrap() == *text));
        };
        std::thread::Builder::new().name("writer".to_owned()).spawn(write).unwrap()
    };
    for pause in [700, 900, 600] {
        let running = Running::start(folder.path());
        std::thread::sleep(Duration::from_millis(pause));
        drop(running);
    }
    writer.join().unwrap();
    let begun = Instant::now();
    let mut last = Running::start(folder.path());
    let code = last.0.wait().unwrap();
    assert_eq!(code.code(), Some(0), "every value is good");
    println!("the rest in {:?}", begun.elapsed());
    let reader = fitcheck::store::local::Reader::open(&folder.path().join("j.sqlite")).unwrap();
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for kept in reader.entries(1, 10_000).unwrap() {
        let entry = fitcheck::journal::body::read(&kept.body).unwrap();
        if let Some(Checked::Size(record)) = entry.check().map(|check| &check.what) {
            *counts.entry(record.measurement.diameter.to_string()).or_default() += 1;
        }
    }
    assert_eq!(counts.len(), 1000, "none is lost");
    assert!(counts.values().all(|count| *count == 1), "none is there twice: {counts:?}");
}

/// Two of them would record every value twice.
#[test]
fn a_second_program_on_the_same_folder_is_refused_and_the_first_one_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("in");
    std::fs::create_dir(&input).unwrap();
    files::write(&folder.path().join("plan.csv"), PLAN.as_bytes()).unwrap();
    let first = Running::of(Running::until_idle(folder.path(), "600"));
    let begun = Instant::now();
    let is_watched = || {
        let names = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name());
        names.into_iter().any(|name| name.to_string_lossy().contains(".watch-"))
    };
    while !is_watched() {
        assert!(begun.elapsed() < Duration::from_mins(2), "it never begins");
        std::thread::sleep(Duration::from_millis(20));
    }
    let second = Running::command(folder.path()).output().unwrap();
    let said = String::from_utf8_lossy(&second.stderr);
    assert!(!second.status.success() && said.contains("another program watches"), "{second:?}");
    files::write(&input.join("a.csv"), b"name;measured\nBORE_A;12.03\n").unwrap();
    let reader = fitcheck::store::local::Reader::open(&folder.path().join("j.sqlite")).unwrap();
    let recorded = || {
        let entries = reader.entries(1, 10).unwrap();
        let checks = entries.iter().filter(|kept| fitcheck::journal::body::read(&kept.body).unwrap().check().is_some());
        checks.count()
    };
    while recorded() == 0 {
        assert!(begun.elapsed() < Duration::from_mins(4), "it does not go on");
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(recorded(), 1);
    drop(first);
}

/// The feature and the value of every check in the journal, sorted.
fn checks(folder: &Path) -> Vec<String> {
    let reader = fitcheck::store::local::Reader::open(&folder.join("j.sqlite")).unwrap();
    let entries = reader.entries(1, 100).unwrap();
    let check = |body: &[u8]| match &fitcheck::journal::body::read(body).unwrap().check()?.what {
        Checked::Size(record) => Some(format!("{} {}", record.id, record.measurement.diameter)),
        Checked::Cycle(_) => None,
    };
    let mut checks: Vec<String> = entries.iter().filter_map(|kept| check(&kept.body)).collect();
    checks.sort();
    checks
}

/// A journal takes no text of more than a kilobyte: that is told of its row, and keeps nothing else out.
#[test]
fn a_field_that_a_journal_cannot_hold_keeps_nothing_else_out() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("in");
    std::fs::create_dir(&input).unwrap();
    files::write(&folder.path().join("plan.csv"), PLAN.as_bytes()).unwrap();
    let rows = format!("name;measured;serial\nPIN;19.99;S1\nPIN;19.985;{}\nPIN;19.984;S3\n", "x".repeat(1_101));
    for (name, text) in
        [("a.csv", "name;measured\nBORE_A;12.03\n"), ("b.csv", &rows), ("c.csv", "name;measured\nBORE_A;12.04\n")]
    {
        files::write(&input.join(name), text.as_bytes()).unwrap();
    }
    let output = Running::command(folder.path()).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("b.csv:3: nothing was recorded: about.serial has 1101 bytes"), "{said}");
    assert_eq!(checks(folder.path()), ["BORE_A 12.03", "BORE_A 12.04", "PIN 19.984", "PIN 19.99"]);
    let note = std::fs::read_to_string(fitcheck::watch::note_of(&input.join("b.csv"))).unwrap();
    assert!(note.contains("line 3: nothing was recorded: about.serial has 1101 bytes"), "{note}");
}

/// The shell makes the file before the program begins; what is in it would come again and again.
#[cfg(target_os = "linux")]
#[test]
fn what_the_program_prints_into_its_folder_is_not_taken() {
    for format in ["csv", "text", "json"] {
        let folder = tempfile::tempdir().unwrap();
        let input = folder.path().join("in");
        std::fs::create_dir(&input).unwrap();
        files::write(&folder.path().join("plan.csv"), PLAN.as_bytes()).unwrap();
        files::write(&input.join("a.csv"), b"name;measured\nBORE_A;12.03\n").unwrap();
        let [out, err] = ["out.txt", "err.txt"].map(|name| std::fs::File::create(input.join(name)).unwrap());
        let mut command = Running::command(folder.path());
        let mut running = Running(command.args(["--format", format]).stdout(out).stderr(err).spawn().unwrap());
        assert_eq!(running.0.wait().unwrap().code(), Some(0), "{format}");
        assert_eq!(checks(folder.path()), ["BORE_A 12.03"], "{format}");
        let mut names = std::fs::read_dir(&input).unwrap().map(|entry| entry.unwrap().file_name());
        assert!(!names.any(|name| name.to_string_lossy().ends_with(fitcheck::watch::NOTE_ENDING)), "{format}");
    }
}
