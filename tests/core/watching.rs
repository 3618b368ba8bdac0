//! The watched folder: each file once, whole or not at all, whatever happens meanwhile.

use std::collections::BTreeMap;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use fitcheck::exchange::Item;
use fitcheck::files;
use fitcheck::tolerance::Sources;
use fitcheck::watch::{Batch, Judging, Known, Watcher};

const PLAN: &str = "name;callout;x;y;z\nBORE_A;12 F9;50;65;-8\nPIN;20 g6;100;65;-8\n";

fn plan() -> fitcheck::part::Plan {
    crate::plans::plan(PLAN)
}

/// A folder and a clock that only the test moves.
struct Watched {
    folder: tempfile::TempDir,
    watcher: Watcher,
    clock: Duration,
    /// What was told to be the same as another file.
    same: Vec<(String, String)>,
}

impl Watched {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let watcher = Watcher::new(folder.path(), Known::default());
        Self { folder, watcher, clock: Duration::ZERO, same: Vec::new() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        files::write(&self.path(name), text.as_bytes()).unwrap();
    }

    fn append(&self, name: &str, text: &str) {
        OpenOptions::new().append(true).open(self.path(name)).unwrap().write_all(text.as_bytes()).unwrap();
    }

    /// Looks after some milliseconds.
    fn look(&mut self, after: u64) -> Vec<Batch> {
        self.clock += Duration::from_millis(after);
        let (plan, sources) = (plan(), Sources::default());
        let now = jiff::civil::date(2026, 11, 23).at(8, 0, 0, 0);
        let look = self
            .watcher
            .look(Judging { plan: Some(&plan), sources: &sources, masks: &[], columns: None, now }, self.clock)
            .unwrap();
        self.same.extend(look.same);
        look.ready
    }

    /// Looks until a file is unchanged for a moment, and takes what is there.
    fn take(&mut self, after: u64) -> Vec<String> {
        let mut ready = self.look(0);
        ready.extend(self.look(after));
        for batch in &ready {
            self.watcher.taken(batch, &|message| message.to_string()).unwrap();
        }
        ready
            .iter()
            .flat_map(|batch| batch.items.iter().filter_map(said).map(|said| format!("{} {said}", batch.name)))
            .collect()
    }

    fn note(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(fitcheck::watch::note_of(&self.path(name))).ok()
    }
}

fn said(item: &Item) -> Option<String> {
    match item {
        Item::Record { record, .. } => {
            Some(format!("{} {} {}", record.id, record.measurement.diameter, record.verdict.status()))
        }
        Item::Unjudged(unjudged) => Some(format!("{} {}", unjudged.id, unjudged.why)),
        Item::Error(error) => Some(error.to_string()),
        Item::Warning(_) | Item::Contacts(_) => None,
    }
}

const HEAD: &str = "name;measured\n";

#[test]
fn a_file_is_taken_once_it_is_unchanged_for_a_moment_and_only_once() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.look(0), [], "it may still be written");
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD"]);
    assert_eq!(watched.take(10_000), [""; 0]);
    // The same content by another name, or written once more, is nothing new.
    watched.write("b.csv", &format!("{HEAD}BORE_A;12.03\n"));
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.look(0).len() + watched.look(10_000).len(), 0);
    assert_eq!(watched.same, [("b.csv".to_owned(), "a.csv".to_owned())], "and it is said, once");
    // Other content of the same name is.
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.05\n"));
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.05 GOOD"]);
}

#[test]
fn of_a_file_that_grows_the_new_lines_are_taken_and_never_half_a_number() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.9"));
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD"]);
    assert_eq!(watched.take(500), [""; 0], "19.9 may become 19.99");
    watched.append("a.csv", "9\n");
    assert_eq!(watched.take(150), ["a.csv PIN 19.99 GOOD"]);
    // A last line without an end counts when nothing was written for a while.
    watched.append("a.csv", "PIN;19.985");
    assert_eq!(watched.take(2_000), [""; 0]);
    assert_eq!(watched.take(3_500), ["a.csv PIN 19.985 GOOD"]);
    // What is written behind it makes another line of it, and only of it.
    watched.append("a.csv", "1\nPIN;19.984\n");
    assert_eq!(watched.take(150), ["a.csv PIN 19.9851 GOOD", "a.csv PIN 19.984 GOOD"]);
}

#[test]
fn a_file_that_begins_as_another_one_has_values_of_its_own() {
    let mut watched = Watched::new();
    watched.write("p1.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(150), ["p1.csv BORE_A 12.03 GOOD"]);
    watched.write("p2.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    assert_eq!(watched.take(150), ["p2.csv BORE_A 12.03 GOOD", "p2.csv PIN 19.99 GOOD"]);
}

#[test]
fn what_cannot_be_used_is_told_beside_the_file_until_it_can() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.O3\nPIN;19.99\n"));
    assert_eq!(watched.take(150).len(), 2);
    let note = watched.note("a.csv").unwrap();
    assert!(note.contains("line 2, column 2: measured: 12.O3 is not a number"), "{note}");
    // What comes later does not take the note away.
    watched.append("a.csv", "PIN;19.985\n");
    assert_eq!(watched.take(150).len(), 1);
    assert_eq!(watched.note("a.csv").as_deref(), Some(note.as_str()));
    // A file that is put right has none any more.
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    watched.take(150);
    assert_eq!(watched.note("a.csv"), None);
    // A file that is none is told after a while, and stays.
    watched.write("x.qif", "<QIFDocument xmlns=\"http://qifstandards.org/xsd/qif3\"><Results>");
    assert_eq!(watched.take(500), [""; 0], "it may still be written");
    watched.take(3_500);
    assert!(watched.note("x.qif").unwrap().contains("unit of length"), "{:?}", watched.note("x.qif"));
    assert!(watched.path("x.qif").exists());
}

#[test]
fn a_log_is_taken_when_it_is_complete_and_the_next_one_behind_it_too() {
    let log = |diameter: &str, deviation: &str| {
        let text = include_str!("../data/samples/logs/en/TCHPR421.TXT");
        let places = [("40.0", "50.0"), ("39.9", "49.9"), ("30.0", "65.0"), ("29.9", "64.9")];
        let text = places.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to));
        text.replace("25.0210", "12.0590")
            .replace("25.0134", diameter)
            .replace("0.0134", deviation)
            .replace("25.0000", "12.0000")
    };
    let mut watched = Watched::new();
    let first = log("12.0300", "0.0300");
    let (begun, rest) = first.split_at(first.len() / 2);
    watched.write("TCHPR421.TXT", begun);
    assert_eq!(watched.take(500), [""; 0], "half a log is none");
    watched.append("TCHPR421.TXT", rest);
    assert_eq!(watched.take(150), ["TCHPR421.TXT BORE_A 12.03 GOOD"]);
    watched.append("TCHPR421.TXT", &format!("\r\n{}", log("12.0700", "0.0700")));
    assert_eq!(watched.take(150), ["TCHPR421.TXT BORE_A 12.07 SCRAP"]);
}

#[test]
fn files_come_in_the_order_in_which_they_were_written_and_unfinished_names_are_left_alone() {
    let mut watched = Watched::new();
    for (name, value) in [("z.csv", "12.03"), ("a.csv", "12.04"), ("b.csv.part", "12.05"), (".c.csv", "12.05")] {
        watched.write(name, &format!("{HEAD}BORE_A;{value}\n"));
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(watched.take(150), ["z.csv BORE_A 12.03 GOOD", "a.csv BORE_A 12.04 GOOD"]);
    std::fs::rename(watched.path("b.csv.part"), watched.path("b.csv")).unwrap();
    assert_eq!(watched.take(150), ["b.csv BORE_A 12.05 GOOD"]);
}

struct Running(Child);

impl Running {
    fn start(folder: &Path) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
        command.current_dir(folder).args([
            "watch",
            "in",
            "--plan",
            "plan.csv",
            "--journal",
            "j.sqlite",
            "--until-idle",
            "4",
        ]);
        command.env("XDG_DATA_HOME", folder).env("XDG_CONFIG_HOME", folder).env_remove("FITCHECK_JOURNAL");
        Self(command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap())
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
        if let Some(fitcheck::journal::entry::Checked::Size(record)) = entry.check().map(|check| &check.what) {
            *counts.entry(record.measurement.diameter.to_string()).or_default() += 1;
        }
    }
    assert_eq!(counts.len(), 1000, "none is lost");
    assert!(counts.values().all(|count| *count == 1), "none is there twice: {counts:?}");
}
