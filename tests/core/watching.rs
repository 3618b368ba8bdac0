//! The watched folder: each file once, whole or not at all, whatever happens meanwhile.

use std::collections::BTreeSet;
use std::fs::{File, OpenOptions};
use std::io::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use fitcheck::control::mask::Mask;
use fitcheck::exchange::Item;
use fitcheck::files;
use fitcheck::journal::chain::Hash;
use fitcheck::tolerance::Sources;
use fitcheck::tolerance::fit::thermal::Temperature;
use fitcheck::watch::{Batch, FileJudging, FolderScan, TakenFiles, Watcher};

pub(crate) const PLAN: &str = "name;callout;x;y;z\nBORE_A;12 F9;50;65;-8\nPIN;20 g6;100;65;-8\n";

fn plan() -> fitcheck::part::Plan {
    crate::plans::plan(PLAN)
}

/// A folder and a clock that only the test moves.
pub(crate) struct Watched {
    folder: tempfile::TempDir,
    pub(crate) watcher: Watcher,
    clock: Duration,
    /// What was told to be the same as another file.
    pub(crate) same: Vec<(String, String)>,
    /// What the journal would know.
    recorded: Vec<(String, Hash)>,
    /// What else was told.
    pub(crate) remarks: Vec<String>,
    pub(crate) temperature: Option<Temperature>,
    pub(crate) masks: Vec<(String, Mask)>,
    /// What the last look has found.
    pub(crate) looked: Option<FolderScan>,
}

impl Watched {
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let watcher = Watcher::new(folder.path(), TakenFiles::default());
        let (clock, same, recorded) = (Duration::ZERO, Vec::new(), Vec::new());
        Self {
            folder,
            watcher,
            clock,
            same,
            recorded,
            remarks: Vec::new(),
            masks: Vec::new(),
            temperature: None,
            looked: None,
        }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, text: &str) {
        // As a control does it, in place: a file that gets its name as a whole is complete at once.
        File::create(self.path(name)).unwrap().write_all(text.as_bytes()).unwrap();
    }

    /// Gives a file its name when it is complete.
    pub(crate) fn put(&self, name: &str, text: &str) {
        files::write(&self.path(name), text.as_bytes()).unwrap();
    }

    /// Begins a file that its writer keeps open.
    #[cfg(target_os = "linux")]
    pub(crate) fn open(&self, name: &str, text: &str) -> File {
        let mut file = OpenOptions::new().create(true).append(true).open(self.path(name)).unwrap();
        file.write_all(text.as_bytes()).unwrap();
        file
    }

    pub(crate) fn append(&self, name: &str, text: &str) {
        OpenOptions::new().append(true).open(self.path(name)).unwrap().write_all(text.as_bytes()).unwrap();
    }

    /// Looks after some milliseconds.
    pub(crate) fn look(&mut self, after: u64) -> Vec<Batch> {
        self.clock += Duration::from_millis(after);
        let (plan, sources) = (plan(), Sources::default());
        let now = jiff::civil::date(2026, 11, 23).at(8, 0, 0, 0);
        let look = self
            .watcher
            .look(
                FileJudging {
                    plan: Some(&plan),
                    sources: &sources,
                    masks: &self.masks,
                    columns: None,
                    now,
                    temperature: self.temperature,
                },
                self.clock,
            )
            .unwrap();
        self.same.extend(look.same.clone());
        let ready = look.ready.clone();
        self.looked = Some(look);
        ready
    }

    /// The same folder watched by a program that knows what this one has recorded.
    pub(crate) fn restarted(&mut self, after: u64) {
        let mut known = TakenFiles::default();
        for (name, sha256) in &self.recorded {
            known.add(*sha256, name);
        }
        self.watcher = Watcher::new(self.folder.path(), known);
        self.clock += Duration::from_millis(after);
    }

    /// Looks until a file is unchanged for a moment, and takes what is there.
    pub(crate) fn take(&mut self, after: u64) -> Vec<String> {
        [0, after].into_iter().flat_map(|after| self.take_once(after)).collect()
    }

    /// Looks once, and takes what is there.
    fn take_once(&mut self, after: u64) -> Vec<String> {
        let ready = self.look(after);
        let is_check = |item: &Item| matches!(item, Item::Record { .. });
        let recorded = ready.iter().filter(|batch| batch.items.iter().any(is_check));
        self.recorded.extend(recorded.map(|batch| (batch.name.clone(), batch.sha256)));
        self.remarks.extend(ready.iter().flat_map(|batch| &batch.remarks).map(ToString::to_string));
        for batch in &ready {
            self.watcher.taken(batch, &|message| message.to_string()).unwrap();
        }
        self.watcher.tell(&|message| message.to_string()).unwrap();
        let said = |batch: &Batch| -> Vec<String> {
            batch.items.iter().filter_map(said).map(|said| format!("{} {said}", batch.name)).collect()
        };
        ready.iter().flat_map(said).collect()
    }

    pub(crate) fn note(&self, name: &str) -> Option<String> {
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

/// What is told of a copy, and of a file that is written again.
const SAME: [&str; 2] = ["a.csv is a.csv", "b.csv is a.csv"];

pub(crate) const HEAD: &str = "name;measured\n";

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
    let said: BTreeSet<String> = watched.same.iter().map(|(name, known)| format!("{name} is {known}")).collect();
    assert_eq!(
        (said.into_iter().collect::<Vec<_>>(), watched.same.len()),
        (SAME.map(str::to_owned).to_vec(), 2),
        "once"
    );
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
fn a_last_line_that_was_taken_without_its_end_is_not_taken_again_with_it() {
    for end in ["\n", "\r\n", "\r"] {
        let mut watched = Watched::new();
        watched.write("a.csv", &format!("name;measured{end}BORE_A;12.03{end}PIN;19.99"));
        let mut taken = watched.take(150);
        taken.extend(watched.take(3_500));
        assert_eq!(taken, ["a.csv BORE_A 12.03 GOOD", "a.csv PIN 19.99 GOOD"], "{end:?}");
        watched.append("a.csv", &format!("{end}PIN;19.985{end}"));
        assert_eq!(watched.take(150), ["a.csv PIN 19.985 GOOD"], "{end:?}");
        watched.restarted(0);
        assert_eq!(watched.take(4_000), [""; 0], "{end:?}");
    }
}

#[test]
fn utf_16_grows_by_its_lines() {
    let text = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let mut watched = Watched::new();
    files::write(&watched.path("a.csv"), &text("\u{feff}name;measured\nBORE_A;12.03\nPIN;19.9")).unwrap();
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD"]);
    let mut file = OpenOptions::new().append(true).open(watched.path("a.csv")).unwrap();
    file.write_all(&text("85\n")).unwrap();
    assert_eq!(watched.take(150), ["a.csv PIN 19.985 GOOD"]);
}

#[test]
fn a_file_that_is_written_anew_and_seen_in_between_is_not_taken_twice() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    assert_eq!(watched.take(150).len(), 2);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(1_000), [""; 0], "its first line again");
    watched.append("a.csv", "PIN;19.99\nPIN;19.985\n");
    assert_eq!(watched.take(150), ["a.csv PIN 19.985 GOOD"]);
    // The same after a restart, when only the hash of the whole is known.
    watched.restarted(0);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(1_000), [""; 0]);
    watched.append("a.csv", "PIN;19.99\nPIN;19.985\nPIN;19.984\n");
    assert_eq!(watched.take(150), ["a.csv PIN 19.984 GOOD"]);
}

#[test]
fn a_file_that_is_replaced_by_another_one_says_what_of_it_was_there_before() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    watched.take(150);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.985\n"));
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD", "a.csv PIN 19.985 GOOD"]);
    assert_eq!(watched.remarks, ["the file was rewritten and begins as before: one value imported again"]);
}

#[test]
fn a_unit_that_pauses_in_its_middle_is_taken_when_it_is_complete_and_its_note_goes() {
    let log = include_str!("../data/samples/logs/en/TCHPR421.TXT");
    let places = [("40.0", "50.0"), ("39.9", "49.9"), ("30.0", "65.0"), ("29.9", "64.9")];
    let log = places.iter().fold(log.to_owned(), |text, (from, to)| text.replace(from, to));
    let log = log.replace("25.0210", "12.0590").replace("25.0134", "12.0300").replace("0.0134", "0.0300");
    let log = log.replace("25.0000", "12.0000");
    // However a log is cut: it is never lost, never there twice, and never another one.
    for cut in (0..=log.len()).step_by(7) {
        let mut watched = Watched::new();
        let (begun, rest) = log.split_at(cut);
        watched.write("TCHPR421.TXT", &format!("{log}\r\n{begun}"));
        let mut taken = watched.take(150);
        taken.extend(watched.take(4_000));
        assert!(!taken.is_empty(), "the first one, cut at {cut}");
        watched.append("TCHPR421.TXT", rest);
        taken.extend(watched.take(4_000));
        let good: Vec<&String> = taken.iter().filter(|taken| taken.ends_with("GOOD")).collect();
        assert_eq!(
            good,
            ["TCHPR421.TXT BORE_A 12.03 GOOD", "TCHPR421.TXT BORE_A 12.03 GOOD"],
            "cut at {cut}: {taken:?}"
        );
        assert_eq!(watched.note("TCHPR421.TXT"), None, "cut at {cut}");
    }
}

#[test]
fn values_of_aqdef_that_are_added_are_taken_and_none_twice() {
    let head = "K0100 1\nK2001/1 1\nK2002/1 BORE_A\nK2101/1 12\nK2110/1 12.016\nK2111/1 12.059\nK2142/1 mm\n";
    let mut watched = Watched::new();
    watched.write("a.dfq", &format!("{head}K0001/1 12.03\nK0002/1 0\n"));
    // Nothing shows its end: it is closed, and unchanged for a second.
    assert_eq!(watched.take(150), [""; 0]);
    assert_eq!(watched.take(1_000), ["a.dfq BORE_A 12.03 GOOD"]);
    watched.append("a.dfq", "K0001/1 12.05\nK0002/1 0\n");
    assert_eq!(watched.take(1_200), ["a.dfq BORE_A 12.05 GOOD"]);
    watched.restarted(0);
    assert_eq!(watched.take(4_000), [""; 0]);
    // A writer that keeps it open may have more to say of the value.
    let mut file = OpenOptions::new().append(true).open(watched.path("a.dfq")).unwrap();
    file.write_all(b"K0001/1 12.04\n").unwrap();
    let early = watched.take(1_000);
    file.write_all(b"K0002/1 255\n").unwrap();
    drop(file);
    let late = watched.take(1_000);
    assert_eq!((early.len(), late.len()), (0, 0), "{early:?} {late:?}: it is no value");
}

#[test]
fn a_description_that_comes_later_than_its_values_is_used() {
    let mut watched = Watched::new();
    watched.write("a.dfx", "K0001/1 12.03\nK0002/1 0\n");
    assert_eq!(watched.take(4_000).len(), 1, "an error");
    assert!(watched.note("a.dfx").is_some());
    watched.write("a.DFD", "K0100 1\nK2001/1 1\nK2002/1 BORE_A\nK2101/1 12\nK2110/1 12.016\nK2111/1 12.059\n");
    assert_eq!(watched.take(4_000), ["a.dfx BORE_A 12.03 GOOD"]);
    assert_eq!(watched.note("a.dfx"), None);
}

#[test]
fn prints_of_a_mask_are_taken_once_and_lines_that_it_has_not_printed_are_told() {
    let mask = "\"Bore %-8s\",QS1;\n\"D %8.3f\",Q153;\n";
    let mut watched = Watched::new();
    watched.masks.push(("m.a".to_owned(), Mask::read(mask.as_bytes()).unwrap().0));
    watched.write("p.txt", "Bore BORE_A  \nD   12.030\nCoolant is low\nBore PIN     \n");
    assert_eq!(watched.take(150), ["p.txt BORE_A 12.03 GOOD"]);
    let late = watched.take(4_000).concat();
    assert!(late.contains("line 5: the record ends too early"), "{late}");
    let note = watched.note("p.txt").unwrap();
    assert!(note.contains("Coolant is low") && note.contains("line 5"), "{note}");
    watched.append("p.txt", "D   19.985\n");
    assert_eq!(watched.take(150), ["p.txt PIN 19.985 GOOD"]);
    let note = watched.note("p.txt").unwrap();
    assert!(note.contains("Coolant is low") && !note.contains("line 5"), "{note}");
    watched.restarted(0);
    assert_eq!(watched.take(4_000), [""; 0]);
}

#[test]
fn a_long_file_is_taken_part_by_part() {
    let mut watched = Watched::new();
    let row = |at: usize| format!("BORE_A;12.{:05}\n", 1_600 + at % 4_300);
    let rows: String = (0..60_000).map(row).collect();
    watched.write("a.csv", &format!("{HEAD}{rows}"));
    assert_eq!(watched.take(150).len(), 50_000 - 1, "with the header");
    assert_eq!(watched.take(150).len(), 10_001);
    assert_eq!(watched.take(4_000).len(), 0);
}

#[test]
fn a_note_of_somebody_else_is_left_alone() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.O3\nPIN;19.99\n"));
    watched.write("a.csv.why.txt", "mine");
    let ready = [watched.look(0), watched.look(150)].concat();
    let [batch] = ready.as_slice() else { panic!("{ready:?}") };
    let error = watched.watcher.taken(batch, &|message| message.to_string()).unwrap_err();
    assert!(error.to_string().contains("a.csv.why.txt"), "{error}");
    assert_eq!(watched.note("a.csv").as_deref(), Some("mine"));
}

#[test]
fn a_folder_is_watched_for_a_journal_by_one_program_alone() {
    let folder = tempfile::tempdir().unwrap();
    let journal = folder.path().join("j.sqlite");
    let first = fitcheck::watch::Alone::take(folder.path(), &journal).unwrap();
    assert!(first.is_some());
    assert!(fitcheck::watch::Alone::take(folder.path(), &journal).unwrap().is_none());
    let other = folder.path().join("k.sqlite");
    assert!(fitcheck::watch::Alone::take(folder.path(), &other).unwrap().is_some(), "another journal");
    drop(first);
    assert!(fitcheck::watch::Alone::take(folder.path(), &journal).unwrap().is_some());
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

/// At 60 °C a bore of 12 mm may be 11 µm larger than at 20 °C, of a zone of 43.
#[test]
fn a_temperature_in_a_file_is_compared_with_the_one_that_counts() {
    let mut watched = Watched::new();
    for (measured, temperature, said, is_told) in [
        ("12.03", None, "60", true),
        ("12.03", None, "20", false),
        ("12.04", Some("60"), "60", false),
        ("12.04", Some("60"), "20", true),
    ] {
        watched.temperature = temperature.map(|text| text.parse().unwrap());
        watched
            .put(&format!("{measured}_{said}.csv"), &format!("name;measured;temperature\nBORE_A;{measured};{said}\n"));
        let [batch] = [watched.look(0), watched.look(150)].concat().try_into().unwrap();
        let is_told_of = |item: &Item| matches!(item, Item::Warning(told) if told.to_string().contains("temperature"));
        assert_eq!(batch.items.iter().any(is_told_of), is_told, "{temperature:?} {said}");
        watched.watcher.taken(&batch, &|message| message.to_string()).unwrap();
    }
}
