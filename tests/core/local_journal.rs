//! The journal of a station: what was acknowledged is there, what is there was not changed, and what is wrong is named.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use fitcheck::journal::Record;
use fitcheck::journal::ask::{AskedKinds, LocalNow, Question};
use fitcheck::journal::body;
use fitcheck::journal::chain::{Hash, Head};
use fitcheck::journal::entry::{About, Check, Checked, Content, Correction, Entry, Kept, Moment, Reported, Shown};
use fitcheck::journal::found::{FoundEntry, folded};
use fitcheck::journal::inspection::Break;
use fitcheck::journal::ranges::EntryRanges;
use fitcheck::length::Unit;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::store::local::{Anchors, Finding, Journal, Opening, Reader, Verified, backup, verify};
use fitcheck::store::{StoreError, StoreRemark};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use proptest::prelude::*;
use rusqlite::Connection;
use tempfile::TempDir;

use crate::at_home::AtHome as _;

/// 2026-11-23 18:00:00 UTC.
const NOON: i64 = 1_795_456_800_000;

pub(crate) fn moment(utc_ms: i64) -> Moment {
    Moment { utc_ms, offset_min: 60, zone: "Europe/Amsterdam".to_owned() }
}

/// A check of a hole, typed; or simulated where the part's name ends in a tilde.
pub(crate) fn check(callout: &str, measured: &str, [part, serial, who]: [&str; 3]) -> Entry {
    let callout = callout.parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let origin = if part.ends_with('~') { Origin::Simulated { cycle: 421, seed: 7 } } else { Origin::Typed };
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), origin);
    let time = jiff::civil::date(2026, 11, 23).at(19, 0, 0, 0);
    let record = Record::judged(time, part.to_owned(), Some(callout), limits, measurement, None);
    let about = About {
        station: "Mill 3".to_owned(),
        time: moment(NOON),
        who: who.to_owned(),
        part: part.to_owned(),
        serial: serial.to_owned(),
        feature: String::new(),
        remark: String::new(),
    };
    let what = Checked::Size(record.into());
    Entry { about, content: Content::Check(Box::new(Check { what, files: Vec::new(), corrects: None })) }
}

fn good(part: &str) -> Entry {
    check("25 H7", "25.012", [part, "17", "Anna"])
}

/// A report of these checks of a journal, whose last entry is `head`.
pub(crate) fn report(name: &str, checks: &[u64], head: Head) -> Entry {
    let shown = Shown { checks: EntryRanges::of(checks.iter().copied()), unrecorded: 0, head: Some(head) };
    let about = About { part: String::new(), serial: String::new(), ..good("").about };
    let report = Reported {
        name: name.to_owned(),
        format: "html".to_owned(),
        sha256: Hash::of_file(name.as_bytes()),
        bytes: 100,
        title: "Lot 8".to_owned(),
        shown,
    };
    Entry { about, content: Content::Report(report) }
}

/// A folder with the place of a journal and of its last entries.
struct Place {
    folder: TempDir,
}

impl Place {
    fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self) -> PathBuf {
        self.folder.path().join("data/journal.sqlite")
    }

    fn opening(&self) -> Opening {
        Opening {
            anchors: Some(self.folder.path().join("settings/heads.txt")),
            patience: Duration::from_millis(200),
            ..Opening::new("Mill 3", moment(NOON))
        }
    }

    fn open(&self) -> Journal {
        self.try_open().unwrap()
    }

    fn try_open(&self) -> Result<Journal, StoreError> {
        Journal::open(&self.path(), &self.opening())
    }

    /// A journal with so many checks, closed.
    fn with(count: usize) -> Self {
        let place = Self::new();
        let entries: Vec<Entry> = (1..=count).map(|number| good(&format!("Flange {number}"))).collect();
        place.open().append(&entries).unwrap();
        place
    }

    fn verify(&self) -> Verified {
        self.verify_beside(&[])
    }

    fn verify_beside(&self, known: &[Head]) -> Verified {
        verify(&self.path(), known, &mut |_done, _all| ControlFlow::Continue(())).unwrap()
    }

    fn entries(&self) -> Vec<Kept> {
        Reader::open(&self.path()).unwrap().entries(1, usize::MAX).unwrap()
    }

    /// Somebody opens the file with another tool, takes the triggers away, and changes something.
    fn tamper(&self, sql: &str) {
        let connection = Connection::open(self.path()).unwrap();
        let triggers: Vec<(String, String)> = connection
            .prepare("SELECT name, sql FROM sqlite_schema WHERE type = 'trigger'")
            .unwrap()
            .query_map([], |row| Ok((row.get(0)?, row.get(1)?)))
            .unwrap()
            .collect::<Result<_, _>>()
            .unwrap();
        for (name, _) in &triggers {
            connection.execute_batch(&format!("DROP TRIGGER {name}")).unwrap();
        }
        connection.execute_batch(sql).unwrap();
        for (_, sql) in &triggers {
            connection.execute_batch(sql).unwrap();
        }
    }

    fn bytes(&self) -> Vec<u8> {
        std::fs::read(self.path()).unwrap()
    }

    fn overwrite(&self, bytes: &[u8]) {
        fitcheck::files::write(&self.path(), bytes).unwrap();
    }
}

fn remarks(journal: &Journal) -> Vec<String> {
    journal.remarks().iter().map(ToString::to_string).collect()
}

#[test]
fn what_was_acknowledged_is_there_after_a_restart() {
    let place = Place::new();
    let mut journal = place.open();
    assert_eq!(journal.remarks(), [StoreRemark::Begun { path: place.path() }]);
    let kept = journal.append(&[good("A"), good("B")]).unwrap();
    assert_eq!(kept.iter().map(|kept| kept.head.number).collect::<Vec<_>>(), [2, 3]);
    // Whoever reads meanwhile sees them already.
    assert_eq!(place.entries()[1..], kept);
    drop(journal);
    let mut journal = place.open();
    assert_eq!(journal.remarks(), []);
    assert_eq!(journal.head().unwrap(), kept[1].head);
    journal.append(&[good("C")]).unwrap();
    drop(journal);
    let rows = Reader::open(&place.path()).unwrap().rows(&[4, 2, 99]).unwrap();
    let parts: Vec<String> = rows.iter().map(|row| row.entry.as_ref().unwrap().about.part.clone()).collect();
    assert_eq!(parts, ["C", "A"]);
    let found = place.verify();
    assert!(found.is_whole());
    assert_eq!(found.inspected.entries, 4);
}

#[test]
fn entries_are_added_all_or_none() {
    let place = Place::with(1);
    let mut journal = place.open();
    let mut wrong = good("B");
    wrong.about.remark = "a\u{0}b".to_owned();
    assert!(matches!(journal.append(&[good("A"), wrong]), Err(StoreError::Body(_))));
    assert_eq!(place.entries().len(), 2);
    journal.append(&[good("A")]).unwrap();
    assert_eq!(place.entries().len(), 3);
}

#[test]
fn the_database_itself_refuses_to_change_entries() {
    let place = Place::with(3);
    let connection = Connection::open(place.path()).unwrap();
    for sql in [
        "UPDATE entry SET body = x'00' WHERE number = 2",
        "UPDATE entry SET number = 9 WHERE number = 4",
        "DELETE FROM entry WHERE number = 4",
        "DELETE FROM entry",
        "INSERT OR REPLACE INTO entry VALUES (2, x'00', zeroblob(32))",
        "INSERT INTO entry VALUES (6, x'00', zeroblob(32))",
        "INSERT INTO entry VALUES (1, x'00', zeroblob(32)) ON CONFLICT DO UPDATE SET body = x'00'",
    ] {
        assert!(connection.execute_batch(sql).is_err(), "{sql}");
    }
    drop(connection);
    assert!(place.verify().is_whole());
}

#[test]
fn one_changed_one_removed_one_inserted_and_one_reordered_entry_are_named() {
    let close = "UPDATE entry SET number = number - 1 WHERE number > 4";
    let open =
        "UPDATE entry SET number = -number WHERE number > 4; UPDATE entry SET number = 1 - number WHERE number < 0";
    let swap = "UPDATE entry SET number = -1 WHERE number = 4; UPDATE entry SET number = 4 WHERE number = 5; \
                UPDATE entry SET number = 5 WHERE number = -1";
    for (sql, expected) in [
        (
            "UPDATE entry SET body = CAST(replace(CAST(body AS TEXT), 'Anna', 'Anne') AS BLOB) WHERE number = 4",
            Break::Changed { number: 4 },
        ),
        ("UPDATE entry SET hash = zeroblob(32) WHERE number = 4", Break::Changed { number: 4 }),
        ("DELETE FROM entry WHERE number = 4", Break::Removed { number: 4, count: 1 }),
        (&format!("DELETE FROM entry WHERE number = 4; {close}"), Break::Removed { number: 4, count: 1 }),
        (
            &format!("{open}; INSERT INTO entry SELECT 5, body, hash FROM entry WHERE number = 2"),
            Break::Inserted { number: 5 },
        ),
        (swap, Break::Reordered { number: 4, other: 5 }),
    ] {
        let place = Place::with(9);
        place.tamper(sql);
        assert_eq!(place.verify().inspected.breaks, [expected], "{sql}");
    }
}

#[test]
fn a_dropped_trigger_and_a_forgotten_row_are_named() {
    let place = Place::with(2);
    Connection::open(place.path()).unwrap().execute_batch("DROP TRIGGER entry_stays").unwrap();
    assert_eq!(place.verify().findings, [Finding::Altered { name: "entry_stays".to_owned() }]);
    let indexed = || {
        let place = Place::with(2);
        place.open().tidy().unwrap();
        place
    };
    let place = indexed();
    place.tamper("DELETE FROM find WHERE number = 2");
    assert_eq!(place.verify().findings, [Finding::NotFound { entries: 1 }]);
    for sql in [
        "UPDATE find SET status = 3 WHERE number = 2",
        "UPDATE find SET who = 'bert' WHERE number = 2",
        "UPDATE find SET at = at + 1 WHERE number = 2",
        "INSERT INTO find SELECT 99, at, kind, status, simulated, part, serial, feature, callout, class, who, station, corrects FROM find WHERE number = 2",
    ] {
        let place = indexed();
        place.tamper(sql);
        assert_eq!(place.verify().findings, [Finding::NotFound { entries: 1 }], "{sql}");
    }
}

#[test]
fn newest_entries_that_were_cut_off_are_told_at_the_next_opening() {
    let place = Place::with(5);
    place.open().tidy().unwrap();
    place.tamper("DELETE FROM entry WHERE number > 3");
    let journal = place.open();
    assert_eq!(journal.remarks(), [StoreRemark::Behind { path: place.path(), last: 3, known: 6 }]);
    let known = Anchors::read(&place.opening().anchors.unwrap()).unwrap().of_chain(journal.chain());
    drop(journal);
    // The alarm stays.
    assert_eq!(place.open().remarks().len(), 1);
    assert_eq!(place.verify_beside(&known).inspected.breaks, [Break::CutOff { last: 3, known: 6 }]);
    assert!(place.verify().is_whole());
    // What is recorded now is found.
    place.open().append(&[good("Bush")]).unwrap();
    let bush = Question { part: Some("bush".to_owned()), ..Question::default() };
    assert_eq!(Reader::open(&place.path()).unwrap().numbers(&bush, None, 9).unwrap(), [4]);
}

#[test]
fn an_older_copy_that_was_put_back_and_written_on_is_told() {
    let place = Place::with(2);
    let older = place.bytes();
    place.open().append(&[good("A"), good("B")]).unwrap();
    place.overwrite(&older);
    let mut journal = place.open();
    assert_eq!(journal.remarks(), [StoreRemark::Behind { path: place.path(), last: 3, known: 5 }]);
    journal.append(&[good("C"), good("D"), good("E")]).unwrap();
    drop(journal);
    assert_eq!(place.open().remarks(), [StoreRemark::Other { path: place.path(), number: 5 }]);
}

#[test]
fn a_journal_that_is_gone_is_told_once_and_named_by_the_new_one() {
    let place = Place::with(2);
    let (chain, head) = (place.open().chain(), place.entries()[2].head);
    std::fs::remove_file(place.path()).unwrap();
    let journal = place.open();
    let begun = StoreRemark::Begun { path: place.path() };
    assert_eq!(journal.remarks(), [begun, StoreRemark::Replaced { path: place.path(), known: 3 }]);
    drop(journal);
    let first = Reader::open(&place.path()).unwrap().rows(&[1]).unwrap().remove(0);
    let Content::Begin(begin) = first.entry.unwrap().content else { panic!() };
    assert_eq!(begin.after, Some((chain, head)));
    assert_eq!(place.open().remarks(), []);
}

#[test]
fn two_writers_at_once_make_one_chain() {
    let place = Place::with(0);
    let opening = Opening { patience: Duration::from_mins(1), ..place.opening() };
    std::thread::scope(|scope| {
        for who in 0..4 {
            let (path, opening) = (place.path(), opening.clone());
            scope.spawn(move || {
                let mut journal = Journal::open(&path, &opening).unwrap();
                for number in 0..25 {
                    journal.append(&[good(&format!("{who}-{number}"))]).unwrap();
                }
            });
        }
    });
    let found = place.verify();
    assert!(found.is_whole(), "{found:?}");
    assert_eq!(found.inspected.entries, 101);
}

#[test]
fn a_writer_that_waits_too_long_says_that_another_program_holds_the_file() {
    let place = Place::with(1);
    let mut journal = place.open();
    let other = Connection::open(place.path()).unwrap();
    other.execute_batch("BEGIN IMMEDIATE").unwrap();
    assert_eq!(journal.append(&[good("A")]), Err(StoreError::Locked { path: place.path() }));
    assert_eq!(Reader::open(&place.path()).unwrap().head().unwrap().number, 2);
    other.execute_batch("COMMIT").unwrap();
    journal.append(&[good("A")]).unwrap();
}

/// What waiting programs told.
static TOLD: Mutex<Vec<StoreRemark>> = Mutex::new(Vec::new());

/// The place in the queue of those who write.
fn queue(place: &Place) -> std::fs::File {
    let path = place.path().with_file_name("journal.sqlite-lock");
    std::fs::File::options().write(true).open(path).unwrap()
}

#[test]
fn a_program_waits_as_long_as_the_one_before_it_writes_and_tells_so_after_some_seconds() {
    let place = Place::with(1);
    let patience = Duration::from_secs(2);
    let opening = Opening { patience, waits: |remark| TOLD.lock().unwrap().push(remark.clone()), ..place.opening() };
    let mut journal = Journal::open(&place.path(), &opening).unwrap();
    let queue = queue(&place);
    queue.lock().unwrap();
    let (begun, waited) = (Instant::now(), AtomicBool::new(false));
    std::thread::scope(|scope| {
        scope.spawn(|| {
            // An older program, which does not know the queue; it is slow, and adds one entry after the other.
            let other = Connection::open(place.path()).unwrap();
            let mut number = 2;
            while begun.elapsed() < 2 * patience + patience / 2 {
                number += 1;
                other.execute("INSERT INTO entry VALUES (?1, x'00', zeroblob(32))", [number]).unwrap();
                assert!(!waited.load(Ordering::Relaxed), "nobody comes before its turn");
                std::thread::sleep(Duration::from_millis(20));
            }
            drop(queue);
        });
        let kept = journal.append(&[good("A")]);
        waited.store(true, Ordering::Relaxed);
        kept.unwrap();
    });
    assert!(2 * patience < begun.elapsed(), "longer than it is patient where nothing happens");
    assert_eq!(*TOLD.lock().unwrap(), [StoreRemark::Waits { path: place.path() }], "once");
}

#[test]
fn a_program_that_holds_the_queue_and_writes_nothing_is_given_up_and_nothing_is_recorded() {
    let place = Place::with(1);
    let mut journal = place.open();
    let queue = queue(&place);
    queue.lock().unwrap();
    assert_eq!(journal.append(&[good("A")]), Err(StoreError::Locked { path: place.path() }));
    assert_eq!(place.try_open().unwrap_err(), StoreError::Locked { path: place.path() });
    drop(queue);
    journal.append(&[good("A")]).unwrap();
    assert_eq!(place.entries().len(), 3);
}

#[test]
fn a_program_that_records_all_the_time_lets_others_have_their_turn() {
    let place = Place::with(1);
    let opening = Opening { patience: Duration::from_mins(1), ..place.opening() };
    let (busy, is_over) = (AtomicU64::new(0), AtomicBool::new(false));
    std::thread::scope(|scope| {
        for _ in 0..3 {
            scope.spawn(|| {
                let mut journal = Journal::open(&place.path(), &opening).unwrap();
                while !is_over.load(Ordering::Relaxed) {
                    journal.append(&[good("busy")]).unwrap();
                    busy.fetch_add(1, Ordering::Relaxed);
                }
            });
        }
        for _ in 0..20 {
            let mut journal = Journal::open(&place.path(), &opening).unwrap();
            journal.append(&[good("now and then")]).unwrap();
        }
        is_over.store(true, Ordering::Relaxed);
    });
    println!("{} entries of others to twenty of its own", busy.load(Ordering::Relaxed));
    assert!(place.verify().is_whole());
}

#[test]
fn a_file_that_is_no_journal_is_left_as_it_is() {
    let other = {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("other.sqlite");
        Connection::open(&path).unwrap().execute_batch("CREATE TABLE accounts(name TEXT)").unwrap();
        std::fs::read(path).unwrap()
    };
    let newer = {
        let place = Place::with(1);
        Connection::open(place.path()).unwrap().pragma_update(None, "user_version", 99).unwrap();
        place.bytes()
    };
    for (bytes, expected) in [
        (b"Time;Part;Measured\n".as_slice(), "is not a journal of Fitcheck"),
        (b"x".as_slice(), "is not a journal of Fitcheck"),
        (&other, "is not a journal of Fitcheck"),
        (&newer, "was made by a newer Fitcheck (version 99, this one supports 5)"),
    ] {
        let place = Place::new();
        std::fs::create_dir_all(place.path().parent().unwrap()).unwrap();
        place.overwrite(bytes);
        for error in [
            place.try_open().map(drop).unwrap_err(),
            Reader::open(&place.path()).map(drop).unwrap_err(),
            verify(&place.path(), &[], &mut |_, _| ControlFlow::Continue(())).map(drop).unwrap_err(),
            backup(&place.path(), &place.folder.path().join("copy")).map(drop).unwrap_err(),
        ] {
            assert!(error.to_string().contains(expected), "{error}");
        }
        assert_eq!(place.bytes(), bytes);
        let files = std::fs::read_dir(place.path().parent().unwrap()).unwrap().count();
        assert_eq!(files, 1, "{expected}");
    }
}

#[test]
fn a_folder_in_the_place_of_a_journal_is_told() {
    let place = Place::new();
    std::fs::create_dir_all(place.path()).unwrap();
    assert_eq!(place.try_open().map(drop).unwrap_err(), StoreError::NotAFile { path: place.path() });
    assert_eq!(Reader::open(&place.path()).map(drop).unwrap_err(), StoreError::NotAFile { path: place.path() });
}

/// What is damaged is moved away as it is, and the new journal names it.
#[test]
fn a_damaged_journal_is_set_aside_and_never_overwritten() {
    type Damage = fn(&mut Vec<u8>);
    let damages: [(&str, Damage); 3] = [
        ("cut to half", |bytes| bytes.truncate(bytes.len() / 2 / 4096 * 4096 + 100)),
        ("header zeroed", |bytes| bytes[..100].fill(0)),
        ("first page random", |bytes| bytes[100..4096].fill(0xA7)),
    ];
    for (name, damage) in damages {
        let place = Place::with(300);
        let chain = place.open().chain();
        let mut bytes = place.bytes();
        damage(&mut bytes);
        place.overwrite(&bytes);
        let mut journal = place.open();
        let [StoreRemark::SetAside { folder, .. }, rest @ ..] = journal.remarks() else {
            panic!("{name}: {:?}", remarks(&journal))
        };
        assert!(matches!(rest[0], StoreRemark::Begun { .. }), "{name}: {rest:?}");
        assert_eq!(std::fs::read(folder.join("journal.sqlite")).unwrap(), bytes, "{name}");
        assert_ne!(journal.chain(), chain);
        journal.append(&[good("A")]).unwrap();
        drop(journal);
        assert!(place.verify().is_whole());
        let first = Reader::open(&place.path()).unwrap().rows(&[1]).unwrap().remove(0).entry.unwrap();
        let Content::Begin(begin) = first.content else { panic!() };
        assert_eq!(begin.after.map(|(chain, head)| (chain, head.number)), Some((chain, 301)), "{name}");
    }
}

/// Whatever bytes are changed, a journal is read, refused or set aside; no entry is invented and nothing ends the program.
#[test]
fn random_bytes_in_a_journal_are_found() {
    let place = Place::with(120);
    let whole = place.bytes();
    let written = place.entries();
    let mut found = 0;
    for seed in 0..60_usize {
        let mut bytes = whole.clone();
        let at = seed * 7919 * 13 % (bytes.len() - 16);
        for (place, byte) in bytes[at..at + 16].iter_mut().enumerate() {
            *byte ^= u8::try_from((seed * 31 + place * 17) % 255).unwrap() + 1;
        }
        place.overwrite(&bytes);
        let answer = verify(&place.path(), &[], &mut |_, _| ControlFlow::Continue(()));
        let told = match &answer {
            Ok(verified) => !verified.is_whole(),
            Err(_) => true,
        };
        let is_the_same = Reader::open(&place.path())
            .and_then(|reader| reader.entries(1, usize::MAX))
            .is_ok_and(|entries| entries == written);
        // Bytes that no entry is in may be anything.
        assert!(told || is_the_same, "byte {at}: {answer:?}");
        found += usize::from(told);
        assert_eq!(place.bytes(), bytes, "byte {at}: looking changes nothing");
    }
    assert!(20 < found, "{found} of 60");
}

#[test]
fn an_older_journal_is_brought_to_this_version_after_a_copy() {
    let place = Place::with(3);
    let connection = Connection::open(place.path()).unwrap();
    connection
        .execute_batch("PRAGMA user_version = 0; DROP INDEX find_who; DELETE FROM find; UPDATE indexed SET number = 9")
        .unwrap();
    drop(connection);
    assert_eq!(Reader::open(&place.path()).map(drop).unwrap_err(), StoreError::Older { path: place.path() });
    let journal = place.open();
    let [StoreRemark::Migrated { copy, .. }] = journal.remarks() else { panic!("{:?}", remarks(&journal)) };
    let copied = Connection::open(copy).unwrap();
    let count: i64 = copied.query_row("SELECT count(*) FROM entry", [], |row| row.get(0)).unwrap();
    assert_eq!(count, 4);
    drop(journal);
    assert!(place.verify().is_whole());
    let anna = Question { who: Some("anna".to_owned()), ..Question::default() };
    assert_eq!(Reader::open(&place.path()).unwrap().numbers(&anna, None, 9).unwrap(), [4, 3, 2]);
}

#[test]
fn a_backup_of_a_running_journal_is_whole_and_replaces_nothing() {
    let place = Place::with(50);
    let mut journal = place.open();
    journal.append(&[good("A")]).unwrap();
    let to = place.folder.path().join("copy.sqlite");
    let head = backup(&place.path(), &to).unwrap();
    assert_eq!(head, journal.head().unwrap());
    journal.append(&[good("B")]).unwrap();
    assert_eq!(Reader::open(&to).unwrap().entries(1, usize::MAX).unwrap(), place.entries()[..52]);
    let before = std::fs::read(&to).unwrap();
    assert!(matches!(backup(&place.path(), &to), Err(StoreError::File(_))));
    assert_eq!(std::fs::read(&to).unwrap(), before);
    let beside: Vec<_> =
        std::fs::read_dir(place.folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(beside.len(), 3, "{beside:?}");
}

#[test]
fn a_backup_of_a_changed_journal_is_refused() {
    let place = Place::with(3);
    place.tamper("UPDATE entry SET body = x'7b7d' WHERE number = 2");
    let to = place.folder.path().join("copy.sqlite");
    assert_eq!(backup(&place.path(), &to), Err(StoreError::Backup { path: place.path() }));
    assert!(!to.exists());
}

#[test]
fn verifying_tells_its_progress_and_can_be_stopped() {
    let place = Place::with(10_001);
    let mut told = Vec::new();
    let stopped = verify(&place.path(), &[], &mut |done, all| {
        told.push((done, all));
        ControlFlow::Break(())
    });
    assert_eq!(stopped, Err(StoreError::Interrupted));
    assert_eq!(told, [(10_000, 10_002)]);
}

/// Entries of every kind for questions.
fn mixed() -> (Place, Vec<Entry>) {
    let place = Place::new();
    let mut entries = Vec::new();
    for number in 0..60_i64 {
        let part = ["Flange", "Bush Ø", "Käfig~", ""][usize::try_from(number % 4).unwrap()];
        let serial = format!("S-{}", number % 7);
        let (callout, measured) = [("25 H7", "25.012"), ("25 h7", "24.9"), ("8 H11", "7.9"), ("8 H11", "8.3")]
            [usize::try_from(number % 3 + number / 31).unwrap()];
        let mut entry =
            check(callout, measured, [part, &serial, ["Anna", "Bert"][usize::try_from(number % 2).unwrap()]]);
        entry.about.time.utc_ms += number * 3_600_000;
        entry.about.remark = if number % 5 == 0 { "burr at the edge, deburred".to_owned() } else { String::new() };
        entry.about.feature = if number % 6 == 0 { "B1".to_owned() } else { String::new() };
        entries.push(entry);
    }
    // Some of them are indexed, and others wait.
    let mut journal = place.open();
    journal.append(&entries[..39]).unwrap();
    let reported = |journal: &Journal, name: &str| report(name, &[2, 3, 7], journal.head().unwrap());
    let first = reported(&journal, "burr flange.html");
    entries.insert(39, first);
    journal.append(&entries[39..40]).unwrap();
    journal.tidy().unwrap();
    let second = reported(&journal, "Käfig 25.01.json");
    entries.insert(45, second);
    journal.append(&entries[40..]).unwrap();
    drop(journal);
    let kept = place.entries();
    let correction = |number: usize| Correction {
        target: kept[number - 1].head,
        reason: "wrong part".to_owned(),
        by: "Bert".to_owned(),
    };
    let mut corrected = check("25 H7", "25.013", ["Bush Ø", "S-1", "Anna"]);
    if let Content::Check(check) = &mut corrected.content {
        check.corrects = Some(correction(3));
    }
    let withdrawn = Entry { content: Content::Withdrawal(correction(5)), ..good("Flange") };
    place.open().append(&[corrected.clone(), withdrawn.clone()]).unwrap();
    entries.extend([corrected, withdrawn]);
    (place, entries)
}

/// A question answered by looking at every entry: numbers from the newest.
fn by_hand(question: &Question, entries: &[Entry]) -> Vec<u64> {
    let corrected: Vec<u64> =
        entries.iter().filter_map(|entry| entry.corrects().map(|correction| correction.target.number)).collect();
    let is = |asked: &Option<String>, text: &str| {
        asked.as_ref().is_none_or(|asked| match asked.strip_suffix('*') {
            // `*` alone asks for what has a serial number, whichever: a report has none.
            Some(start) => !text.is_empty() && folded(text).starts_with(&*folded(start)),
            None => folded(text) == folded(asked),
        })
    };
    let finds = |number: u64, entry: &Entry| {
        let (about, check) = (&entry.about, entry.check());
        let callout = match check.map(|check| &check.what) {
            Some(Checked::Size(record)) => record.callout.unwrap().to_string(),
            _ => String::new(),
        };
        let reason = entry.corrects().map_or("", |correction| correction.reason.as_str());
        let file = entry.report().map_or_else(String::new, |report| format!("{} {}", report.name, report.title));
        let names =
            format!("{} {} {} {} {} {reason} {file}", about.part, about.serial, about.feature, about.who, about.remark);
        let words = format!("{names} {callout} {}", callout.replace(' ', "")).to_lowercase();
        let measured = match check.map(|check| &check.what) {
            Some(Checked::Size(record)) => record.measurement.diameter.exact(Unit::Millimetre, 6),
            _ => String::new(),
        };
        let has = |word: &String| {
            *word == number.to_string()
                || word.contains('.') && measured.starts_with(word.as_str())
                || word.contains('.') && file.contains(&format!(" {word}"))
                || words
                    .split(|c: char| !c.is_alphanumeric())
                    .any(|one| !one.is_empty() && one.starts_with(&word.to_lowercase()))
        };
        is(&question.part, &about.part)
            && is(&question.serial, &about.serial)
            && is(&question.feature, &about.feature)
            && is(&question.who, &about.who)
            && is(&question.station, &about.station)
            && question.callout.as_ref().is_none_or(|asked| *asked == callout)
            && question.class.as_ref().is_none_or(|asked| callout.ends_with(&format!(" {asked}")))
            && (question.verdicts.is_empty()
                || check.is_some_and(|check| question.verdicts.contains(&check.status().unwrap())))
            && question.from_ms.is_none_or(|from| from <= about.time.utc_ms)
            && question.before_ms.is_none_or(|before| about.time.utc_ms < before)
            && question
                .simulated
                .is_none_or(|asked| asked == check.is_some_and(Check::is_simulated) && entry.report().is_none())
            && match question.kinds {
                AskedKinds::All => true,
                AskedKinds::Checks => entry.report().is_none(),
                AskedKinds::Reports => entry.report().is_some(),
                AskedKinds::Alarms => entry.alarm().is_some(),
            }
            && (!question.standing || (check.is_some() && !corrected.contains(&number)))
            && question.words.iter().all(has)
    };
    let numbered = (2_u64..).zip(entries).filter(|(number, entry)| finds(*number, entry));
    let mut numbers: Vec<u64> = numbered.map(|(number, _)| number).collect();
    numbers.reverse();
    numbers
}

/// The same by the question itself, from the bytes that are kept.
fn by_question(question: &Question, place: &Place) -> Vec<u64> {
    let kept = place.entries();
    let found: Vec<_> =
        kept.iter().filter_map(|kept| Some((kept.head.number, body::found(&kept.body).unwrap()?))).collect();
    let is_corrected = |number| found.iter().any(|(_, found)| found.corrects == Some(number));
    let finds = |(number, found): &&(u64, FoundEntry<'_>)| question.finds(*number, found, is_corrected(*number));
    found.iter().rev().filter(finds).map(|(number, _)| *number).collect()
}

#[test]
fn words_find_the_callout_with_and_without_its_blank_and_a_number_its_record() {
    let mut bore = good("A");
    bore.about.part = "Lever 4".to_owned();
    let place = Place::new();
    let mut journal = place.open();
    let target = journal.append(&[bore.clone()]).unwrap()[0].head;
    let mut odd = check("25 H7", "25.0034", ["Lever 4", "17", "Anna"]);
    if let Content::Check(check) = &mut odd.content {
        check.corrects = Some(Correction { target, reason: "Chip on the seat".to_owned(), by: String::new() });
    }
    let rest: Vec<Entry> = std::iter::once(odd).chain((0..2_598).map(|_| bore.clone())).collect();
    journal.append(&rest).unwrap();
    let all = place.entries().split_off(1);
    let reader = Reader::open(&place.path()).unwrap();
    let asked = |text: &str| {
        let here = LocalNow { now: jiff::Timestamp::UNIX_EPOCH, zone: jiff::tz::TimeZone::UTC };
        reader.numbers(&Question::read(text, &here).unwrap(), None, 5_000).unwrap()
    };
    for text in ["25 H7", "25H7", "25h7", "h7"] {
        assert_eq!(asked(text).len(), all.len(), "{text}");
    }
    // Near the end, and far behind the entries that are looked at first.
    assert_eq!(asked("2600"), [2_600]);
    assert_eq!(asked("88 lever"), [88]);
    assert_eq!(asked("88 bush"), [0_u64; 0]);
    assert_eq!(asked("4").len(), all.len(), "the part is called so");
    // By the index, too.
    for text in ["25.0034", "25,0034", "25.00340", "seat", "chip 25.00"] {
        assert_eq!(asked(text), [3], "{text}");
    }
    assert_eq!((asked("25.012").len(), asked("25.0120").len(), asked("25.0121").len()), (2_599, 2_599, 0));
    assert_eq!(asked("good").len(), all.len() - 1, "one is void");
}

#[test]
fn words_find_reasons_and_measured_values() {
    let place = corrected_journal();
    let reader = Reader::open(&place.path()).unwrap();
    let asked = |text: &str| {
        let here = LocalNow { now: jiff::Timestamp::UNIX_EPOCH, zone: jiff::tz::TimeZone::UTC };
        reader.numbers(&Question::read(text, &here).unwrap(), None, 5_000).unwrap()
    };
    assert_eq!(asked("\"burr on the seat\""), [4, 3], "the correction and the withdrawal");
    for text in ["25.013", "25,013", "25.0130", "+25.013 seat"] {
        assert_eq!(asked(text), [3], "{text}");
    }
    assert_eq!(asked("25.0"), [3, 2], "what begins so");
    assert_eq!(asked("2.13"), [2], "in a remark");
    assert_eq!(asked("24.012"), [0_u64; 0], "24 and 012 stand in different words");
    // A verdict's word alone leaves out what is void, as the filter does.
    assert_eq!((asked("good"), asked("verdict:good")), (vec![0_u64; 0], vec![3, 2]));
}

/// A check, one in its place, and a withdrawal of that.
fn corrected_journal() -> Place {
    let place = Place::new();
    let mut first = check("25 H7", "25.012", ["Lever 24-012", "S-1", "Anna"]);
    first.about.remark = "drawing 2.13".to_owned();
    let mut journal = place.open();
    let heads = journal.append(&[first]).unwrap();
    let correction = |target| Correction { target, reason: "Burr on the seat".to_owned(), by: "Bert".to_owned() };
    let mut second = check("25 H7", "25.013", ["Bush", "S-2", "Anna"]);
    if let Content::Check(check) = &mut second.content {
        check.corrects = Some(correction(heads[0].head));
    }
    let more = journal.append(&[second]).unwrap();
    let third = Entry { content: Content::Withdrawal(correction(more[0].head)), ..good("Bush") };
    journal.append(&[third]).unwrap();
    place
}

fn maybe(texts: &'static [&'static str]) -> impl Strategy<Value = Option<String>> {
    prop_oneof![4 => Just(None), 1 => prop::sample::select(texts).prop_map(|text| Some(text.to_owned()))]
}

fn question() -> impl Strategy<Value = Question> {
    let names = (
        maybe(&["flange", "Bush Ø", "käfig~", "", "none"]),
        maybe(&["S-1", "s-*", "S-9", "", "*"]),
        maybe(&["B1", "b1", ""]),
        maybe(&["25 H7", "25 h7", "8 H11"]),
        maybe(&["H7", "h7", "H11"]),
        maybe(&["anna", "Bert"]),
    );
    let verdicts = prop::collection::vec(prop::sample::select(&Status::ALL[..]), 0..3);
    let hours = prop::option::of(0..61_i64);
    let kinds =
        prop::sample::select(&[AskedKinds::All, AskedKinds::Checks, AskedKinds::Reports, AskedKinds::Alarms][..]);
    let flags = (prop::option::weighted(0.3, any::<bool>()), any::<bool>(), kinds);
    let words = prop::collection::vec(
        prop::sample::select(
            &[
                "burr", "Deburr", "fla", "ø", "kafig", "S", "none", "ann", "25", "h7", "25H", "8h11", "7", "wrong",
                "25.01", "24.9980", "8.0", "html", "lot",
            ][..],
        ),
        0..3,
    );
    (names, verdicts, hours.clone(), hours, flags, words).prop_map(
        |(
            (part, serial, feature, callout, class, who),
            verdicts,
            from,
            before,
            (simulated, standing, kinds),
            words,
        )| Question {
            part,
            serial,
            feature,
            callout,
            class,
            verdicts,
            who,
            station: None,
            from_ms: from.map(|hours| NOON + hours * 3_600_000),
            before_ms: before.map(|hours| NOON + hours * 3_600_000),
            simulated,
            standing,
            kinds,
            // An umlaut is found without its dots, which the look at every entry does not know.
            words: words.into_iter().filter(|word| *word != "kafig").map(str::to_owned).collect(),
        },
    )
}

#[test]
fn questions_find_what_a_look_at_every_entry_finds() {
    let (place, entries) = mixed();
    let reader = Reader::open(&place.path()).unwrap();
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases: 250,
        failure_persistence: None,
        ..ProptestConfig::default()
    });

    runner
        .run(&question(), |question| {
            let expected = by_hand(&question, &entries);
            let count = u64::try_from(expected.len()).unwrap();

            prop_assert_eq!(reader.numbers(&question, None, usize::MAX).unwrap(), expected.clone(), "{:?}", question);
            prop_assert_eq!(by_question(&question, &place), expected.clone(), "{:?}", question);
            prop_assert_eq!(reader.count(&question, u64::MAX).unwrap(), count);
            prop_assert_eq!(reader.count(&question, 2).unwrap(), count.min(2));
            // Page by page it is the same.
            let (mut paged, mut before) = (Vec::<u64>::new(), None);
            loop {
                let page = reader.numbers(&question, before, 7).unwrap();
                before = page.last().copied();
                paged.extend(&page);
                if page.len() < 7 {
                    break;
                }
            }
            prop_assert_eq!(paged, expected);
            Ok(())
        })
        .unwrap();
}

#[test]
fn an_umlaut_is_found_without_its_dots_and_signs_alone_find_nothing() {
    let (place, _) = mixed();
    let reader = Reader::open(&place.path()).unwrap();
    let count = |word: &str| {
        let words = vec![word.to_owned()];
        reader.count(&Question { words, ..Question::default() }, u64::MAX).unwrap()
    };
    assert_eq!(count("kafig"), count("KÄFIG"));
    assert!(0 < count("kafig"));
    for hostile in [
        "\"",
        "a\" OR \"b",
        "NEAR(a b)",
        "burr OR flange",
        "*",
        "-",
        "part:x",
        "';DROP TABLE entry;--",
        "{a b}:c",
        "\u{939}\u{93f}",
    ] {
        let _finds_or_not = count(hostile);
    }
    assert_eq!(count("burr OR flange"), 0, "OR is a word");
    assert_eq!(count("*"), 0);
    assert_eq!(count(" "), 64);
    assert!(place.verify().is_whole());
}

/// Words are indexed some hundreds of entries later; what is asked meanwhile is found all the same.
#[test]
fn words_are_found_in_the_newest_and_in_the_oldest_entries() {
    let place = Place::new();
    let entry = |number: u64| {
        let mut entry = good(["Flange", "Bush"][usize::try_from(number % 2).unwrap()]);
        entry.about.remark = if number % 500 == 3 { format!("Grat entfernt, Nr. {number}") } else { String::new() };
        entry
    };
    let mut journal = place.open();
    for lot in 0..13 {
        let entries: Vec<Entry> = (lot * 400..(lot + 1) * 400).map(entry).collect();
        journal.append(&entries).unwrap();
    }
    let reader = Reader::open(&place.path()).unwrap();
    let numbers = |words: &[&str], part: Option<&str>| {
        let words = words.iter().map(|word| (*word).to_owned()).collect();
        reader
            .numbers(&Question { words, part: part.map(str::to_owned), ..Question::default() }, None, usize::MAX)
            .unwrap()
    };
    let expected: Vec<u64> = (0..5200).rev().filter(|number| number % 500 == 3).map(|number| number + 2).collect();
    assert_eq!(numbers(&["grat"], None), expected);
    assert_eq!(numbers(&["entf", "GRAT"], None), expected);
    assert_eq!(numbers(&["grat"], Some("bush")), expected);
    assert!(numbers(&["grat"], Some("flange")).is_empty());
    assert_eq!(numbers(&["grat", "3503"], None), [3505]);
    assert_eq!(numbers(&["3"], None), [3505, 3005, 5, 3], "a word that begins so, and the record of this number");
    assert_eq!(numbers(&["bush"], None).len(), 2600);
    assert!(place.verify().is_whole());
}

#[test]
fn every_filter_has_its_index() {
    let (place, _) = mixed();
    let reader = Reader::open(&place.path()).unwrap();
    let text = |text: &str| Some(text.to_owned());
    let none = Question::default;
    for (index, question) in [
        ("find_part", Question { part: text("a"), ..none() }),
        ("find_serial", Question { serial: text("a"), ..none() }),
        ("find_serial", Question { serial: text("a*"), ..none() }),
        ("find_feature", Question { feature: text("a"), ..none() }),
        ("find_callout", Question { callout: text("a"), ..none() }),
        ("find_class", Question { class: text("a"), ..none() }),
        ("find_who", Question { who: text("a"), ..none() }),
        ("find_status", Question { verdicts: vec![Status::Scrap], ..none() }),
        ("find_report", Question { kinds: AskedKinds::Reports, ..none() }),
        ("find_alarm", Question { kinds: AskedKinds::Alarms, ..none() }),
    ] {
        let plan = reader.plan(&question).unwrap();
        assert!(plan.contains(index), "{question:?}: {plan}");
    }
}

#[test]
fn a_running_question_is_stopped_from_another_thread() {
    let place = Place::with(3_000);
    let reader = Reader::open(&place.path()).unwrap();
    let interrupt = reader.interrupt();
    let stopper = std::thread::Builder::new()
        .spawn(move || {
            for _ in 0..2_000 {
                interrupt.stop();
                std::thread::sleep(Duration::from_micros(50));
            }
        })
        .unwrap();
    let nothing = Question {
        who: Some("anna".to_owned()),
        part: Some("none".to_owned()),
        words: vec!["fl".to_owned()],
        ..Question::default()
    };
    let stopped = (0..2_000).any(|_| reader.numbers(&nothing, None, 9) == Err(StoreError::Interrupted));
    stopper.join().unwrap();
    assert!(stopped);
    assert_eq!(reader.numbers(&nothing, None, 9), Ok(Vec::new()));
}

#[test]
fn the_last_entries_of_all_journals_are_kept_side_by_side() {
    let (one, other) = (Place::with(1), Place::with(2));
    let anchors = one.opening().anchors.unwrap();
    let opening = Opening { anchors: Some(anchors.clone()), ..other.opening() };
    drop(Journal::open(&other.path(), &opening).unwrap());
    let read = Anchors::read(&anchors).unwrap();
    assert_eq!(read.at(&one.path()).unwrap().head.number, 2);
    assert_eq!(read.at(&other.path()).unwrap().head.number, 3);
    assert_eq!(read.at(Path::new("/none")), None);
    fitcheck::files::write(&anchors, b"nonsense\n").unwrap();
    let journal = Journal::open(&one.path(), &one.opening()).unwrap();
    assert!(matches!(journal.remarks(), [StoreRemark::NoAnchor { .. }, ..]), "{:?}", remarks(&journal));
    drop(journal);
    assert_eq!(std::fs::read(&anchors).unwrap(), b"nonsense\n");
}

/// Whoever looks at a journal opens and closes files: that must not take away the locks of a journal that is open in the same program.
#[test]
fn a_journal_that_is_open_keeps_its_log_while_it_is_looked_at_and_others_come_and_go() {
    let place = Place::with(1);
    let mut journal = place.open();
    for number in 0..5 {
        journal.append(&[good(&format!("A{number}"))]).unwrap();
        drop(Reader::open(&place.path()).unwrap());
        assert!(place.verify().is_whole());
        // Another program closes the file as its last user would: it takes the log away only if nobody else has the file.
        let status = std::process::Command::new(env!("CARGO_BIN_EXE_fitcheck"))
            .args(["check", "25 H7", "--measured", "25.012", "--record", "--journal"])
            .arg(place.path())
            .at_home(place.folder.path())
            .output()
            .unwrap();
        assert!(status.status.success(), "{status:?}");
        assert!(place.path().with_file_name("journal.sqlite-wal").exists(), "the log of an open journal is gone");
    }
    assert_eq!(place.entries().len(), 12);
}

#[test]
fn nothing_is_recorded_in_a_journal_that_was_moved_meanwhile() {
    let place = Place::with(1);
    let mut journal = place.open();
    journal.append(&[good("A")]).unwrap();
    let aside = place.folder.path().join("aside");
    std::fs::create_dir(&aside).unwrap();
    if cfg!(windows) {
        // The system itself keeps an open journal where it is.
        assert!(std::fs::rename(place.path(), aside.join("journal.sqlite")).is_err());
        journal.append(&[good("B")]).unwrap();
        return;
    }
    for ending in ["", "-wal", "-shm"] {
        let name = format!("journal.sqlite{ending}");
        std::fs::rename(place.path().with_file_name(&name), aside.join(&name)).unwrap();
    }
    let moved = Err(StoreError::Moved { path: place.path() });
    assert_eq!(journal.append(&[good("B")]), moved);
    // Another one has taken its place.
    let mut other = place.open();
    assert_eq!(journal.append(&[good("B")]), moved);
    other.append(&[good("B")]).unwrap();
    // The log of the other one stays, although it lies where this one's was.
    drop(journal);
    assert_eq!(place.entries().len(), 2);
    drop(other);
    assert_eq!(Reader::open(&aside.join("journal.sqlite")).unwrap().head().unwrap().number, 3);
    assert_eq!(place.entries().len(), 2);
}

#[test]
fn an_entry_is_corrected_once_and_only_the_one_that_was_meant() {
    let place = Place::with(2);
    let target = place.entries()[1].head;
    let correcting = |target: Head| {
        let correction = Correction { target, reason: "wrong part".to_owned(), by: "Bert".to_owned() };
        Entry { content: Content::Withdrawal(correction), ..good("A") }
    };
    let mut journal = place.open();
    let other = Head { hash: place.entries()[2].head.hash, ..target };
    assert_eq!(journal.append(&[correcting(other)]), Err(StoreError::OtherTarget { number: 2 }));
    assert_eq!(
        journal.append(&[correcting(Head { number: 99, ..target })]),
        Err(StoreError::OtherTarget { number: 99 })
    );
    journal.append(&[correcting(target)]).unwrap();
    for is_indexed in [false, true] {
        if is_indexed {
            journal.tidy().unwrap();
        }
        assert_eq!(journal.append(&[correcting(target)]), Err(StoreError::Corrected { number: 2, by: 4 }));
    }
    assert_eq!(place.entries().len(), 4);
}

#[test]
fn a_trigger_that_swallows_entries_is_named_and_nothing_is_acknowledged() {
    let place = Place::with(1);
    let mut journal = place.open();
    let swallow = "CREATE TRIGGER zz BEFORE INSERT ON entry BEGIN SELECT RAISE(IGNORE); END";
    Connection::open(place.path()).unwrap().execute_batch(swallow).unwrap();
    let altered = StoreError::Altered { path: place.path(), name: "entry".to_owned() };
    assert_eq!(journal.append(&[good("A")]), Err(altered));
    assert_eq!(place.verify().findings, [Finding::Altered { name: "zz".to_owned() }]);
}

#[test]
fn an_emptied_journal_is_not_whole_and_is_set_aside() {
    let place = Place::with(2);
    place.tamper("DELETE FROM entry; DELETE FROM find; UPDATE indexed SET number = 0");
    assert_eq!(place.verify().findings, [Finding::NoBeginning]);
    let journal = place.open();
    assert!(matches!(journal.remarks(), [StoreRemark::SetAside { .. }, ..]), "{:?}", remarks(&journal));
}

/// The smallest number in the top page of a table, made one less: the entry that has it is looked for in the next page then.
fn hide_by_an_interior_key(path: &Path, table: &str) -> u64 {
    let connection = Connection::open(path).unwrap();
    connection.execute_batch("PRAGMA wal_checkpoint(TRUNCATE)").unwrap();
    let root: usize = connection
        .query_row("SELECT rootpage FROM sqlite_schema WHERE name = ?1", [table], |row| row.get::<_, i64>(0))
        .unwrap()
        .try_into()
        .unwrap();
    let size: usize =
        connection.pragma_query_value(None, "page_size", |row| row.get::<_, i64>(0)).unwrap().try_into().unwrap();
    drop(connection);
    let mut bytes = std::fs::read(path).unwrap();
    let page = (root - 1) * size;
    assert_eq!(bytes[page], 5, "an interior page of a table");
    // The first cell: the number of a page, and a number of seven bits a byte.
    let cell = page + usize::from(u16::from_be_bytes([bytes[page + 12], bytes[page + 13]]));
    let mut at = cell + 4;
    let mut number = u64::from(bytes[at] & 0x7f);
    while bytes[at] & 0x80 != 0 {
        at += 1;
        number = number << 7 | u64::from(bytes[at] & 0x7f);
    }
    assert_ne!(bytes[at] & 0x7f, 0);
    bytes[at] -= 1;
    fitcheck::files::write(path, &bytes).unwrap();
    number
}

#[test]
fn one_changed_key_in_an_interior_page_that_hides_an_entry_is_named() {
    let place = Place::with(700);
    place.open().tidy().unwrap();
    let hidden = hide_by_an_interior_key(&place.path(), "entry");
    let reader = Reader::open(&place.path()).unwrap();
    assert_eq!(reader.entries(1, usize::MAX).unwrap().len(), 701, "a look at all of them shows it");
    let error = StoreError::Hidden { path: place.path(), number: hidden };
    assert_eq!(reader.rows(&[hidden]), Err(error), "a look at it by its number does not");
    let found = place.verify();
    assert!(matches!(found.findings[..], [Finding::Pages { .. }]), "{found:?}");
    assert!(!found.is_whole());
    let copy = place.folder.path().join("copy.sqlite");
    // A copy is made by a look at all of them: it has them in order again.
    backup(&place.path(), &copy).unwrap();
    assert_eq!(
        Reader::open(&copy).unwrap().rows(&[hidden, 702]).unwrap().len(),
        1,
        "what is behind the last is not there"
    );
}

#[test]
fn one_changed_key_in_what_questions_look_at_is_named() {
    for table in ["find", "words_data"] {
        let place = Place::with(3_000);
        place.open().tidy().unwrap();
        hide_by_an_interior_key(&place.path(), table);
        let found = place.verify();
        assert!(
            matches!(found.findings[..], [Finding::Pages { .. } | Finding::Index { .. }, ..]),
            "{table}: {found:?}"
        );
    }
}

#[test]
fn what_questions_are_answered_by_is_compared_with_how_it_is_made() {
    for (change, name) in [
        ("DROP INDEX find_at", "find_at"),
        ("DROP INDEX find_status; CREATE INDEX find_status ON find(status, number) WHERE status <> 3", "find_status"),
        ("CREATE INDEX mine ON find(status)", "mine"),
        ("CREATE TABLE mine(number INTEGER)", "mine"),
        ("DROP INDEX reported_last", "reported_last"),
        ("INSERT INTO indexed VALUES (0)", "indexed"),
        ("INSERT INTO chain VALUES (randomblob(16))", "chain"),
    ] {
        let place = Place::with(20);
        place.open().tidy().unwrap();
        assert!(place.verify().is_whole(), "{change}");
        rusqlite::Connection::open(place.path()).unwrap().execute_batch(change).unwrap();
        let found = place.verify().findings;
        assert!(found.contains(&Finding::Altered { name: name.to_owned() }), "{change}: {found:?}");
    }
}

#[test]
fn an_index_that_hides_an_entry_is_named() {
    let place = Place::with(700);
    place.open().tidy().unwrap();
    let copy = place.folder.path().join("copy.sqlite");
    backup(&place.path(), &copy).unwrap();
    let mut bytes = std::fs::read(&copy).unwrap();
    // In the index of parts a name is followed by the number of its entry; in the table other columns are.
    let name = b"flange 333";
    let places: Vec<usize> = (0..bytes.len() - name.len()).filter(|at| bytes[*at..].starts_with(name)).collect();
    let found = places.into_iter().any(|at| {
        bytes[at + 9] = b'4';
        fitcheck::files::write(&copy, &bytes).unwrap();
        let verified = verify(&copy, &[], &mut |_, _| ControlFlow::Continue(()));
        bytes[at + 9] = b'3';
        let named = |found: &Verified| matches!(found.findings[..], [Finding::Index { .. }]);
        verified.is_ok_and(|verified| named(&verified))
    });
    assert!(found);
}
