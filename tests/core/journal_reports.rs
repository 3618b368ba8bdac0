//! Reports in the journal: which file was written and what it shows is found, shown and compared, and nobody takes it back.

use std::path::PathBuf;
use std::process::Output;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::journal::ask::{AskedKinds, Question};
use fitcheck::journal::chain::{Hash, HashPrefix, Head};
use fitcheck::journal::entry::{About, Checked, Content, Correction, Entry, Reported, Shown};
use fitcheck::journal::ranges::EntryRanges;
use fitcheck::report::{Report, json};
use fitcheck::store::StoreError;
use fitcheck::store::local::{Finding, Journal, Opening, Reader, verify};
use fitcheck::words::{Language, Words};
use serde_json::Value;
use tempfile::TempDir;

use crate::at_home::AtHome as _;
use crate::local_journal::{check, moment, report};

struct Place(TempDir);

/// What the program has said.
struct Said {
    code: i32,
    out: String,
    err: String,
}

impl Place {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// With a journal of three checks, numbers 2 to 4.
    fn with_checks() -> Self {
        let place = Self::new();
        let entries = ["25.011", "25.012", "25.013"].map(|measured| check("25 H7", measured, ["Flange", "17", "Anna"]));
        place.open().append(&entries).unwrap();
        place
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn open(&self) -> Journal {
        let opening = Opening { anchors: None, ..Opening::new("Mill 3", moment(1_795_456_800_000)) };
        Journal::open(&self.path("j.sqlite"), &opening).unwrap()
    }

    fn reader(&self) -> Reader {
        Reader::open(&self.path("j.sqlite")).unwrap()
    }

    fn add(&self, entry: Entry) -> Head {
        self.open().append(&[entry]).unwrap()[0].head
    }

    /// Writes a report of these entries as JSON, and records it as the window does.
    fn report(&self, name: &str, numbers: &[u64]) -> Head {
        let rows = self.reader().rows(numbers).unwrap();
        let records = rows.iter().map(|row| match &row.entry.as_ref().unwrap().check().unwrap().what {
            Checked::Size(record) => record.as_ref().clone(),
            Checked::Cycle(_) => panic!("a cycle"),
        });
        let report = Report::new(jiff::civil::date(2026, 11, 28).at(19, 0, 0, 0), records.collect::<Vec<_>>());
        let bytes = json::RENDERING.bytes(&report, &Words::new(Language::En)).unwrap();
        fitcheck::files::write(&self.path(name), &bytes).unwrap();
        let journal = self.open();
        let shown = Shown {
            checks: EntryRanges::of(numbers.iter().copied()),
            unrecorded: 0,
            head: Some(journal.head().unwrap()),
        };
        let content = Content::Report(Reported {
            name: name.to_owned(),
            format: "json".to_owned(),
            sha256: Hash::of_file(&bytes),
            bytes: u64::try_from(bytes.len()).unwrap(),
            title: "Lot 8".to_owned(),
            shown,
        });
        drop(journal);
        let about = check("25 H7", "25.012", ["", "", "Bert"]).about;
        self.add(Entry { about: About { station: "Office".to_owned(), ..about }, content })
    }

    fn change(&self, name: &str, from: &str, to: &str) {
        let text = std::fs::read_to_string(self.path(name)).unwrap();
        assert!(text.contains(from), "{text}");
        fitcheck::files::write(&self.path(name), text.replacen(from, to, 1).as_bytes()).unwrap();
    }

    fn say(&self, line: &str) -> Said {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.env_remove("FITCHECK_JOURNAL");
        let home = self.path("home");
        command.at_home(&home).env("TZ", "UTC").current_dir(self.0.path());
        let Output { status, stdout, stderr } = command.args(line.split(' ')).output().unwrap();
        Said {
            code: status.code().unwrap(),
            out: String::from_utf8(stdout).unwrap(),
            err: String::from_utf8(stderr).unwrap(),
        }
    }

    /// The same of the journal.
    fn journal(&self, line: &str) -> Said {
        self.say(&format!("journal {line} --journal j.sqlite"))
    }

    #[track_caller]
    fn done(&self, line: &str) -> String {
        let said = self.journal(line);
        assert_eq!(said.code, 0, "{line}: {}{}", said.out, said.err);
        said.out
    }

    fn json(&self, line: &str) -> Value {
        serde_json::from_str(&self.journal(line).out).unwrap()
    }
}

fn withdrawal(target: Head) -> Entry {
    let correction = Correction { target, reason: "wrong part".to_owned(), by: "Bert".to_owned() };
    Entry { content: Content::Withdrawal(correction), ..check("25 H7", "25.012", ["Flange", "17", "Anna"]) }
}

// ---- the index ----

#[test]
fn reports_are_found_by_their_bytes_names_and_checks_indexed_or_not() {
    let place = Place::with_checks();
    let journal = place.open();
    let first = place.add(report("Flange.html", &[2, 4], journal.head().unwrap())).number;
    for is_indexed in [false, true] {
        if is_indexed {
            journal.tidy().unwrap();
        }
        let second = place.add(report("lot.html", &[3, 4], journal.head().unwrap())).number;
        let reader = place.reader();
        let of = |number: u64| reader.reports_of(number).unwrap();
        assert_eq!((of(2), of(4).contains(&second)), (vec![first], true));
        assert!(!of(5).contains(&second) && of(first).is_empty() && of(99).is_empty());
        assert_eq!(reader.reports_with(Hash::of_file(b"Flange.html")).unwrap(), [first]);
        assert_eq!(reader.reports_with(Hash::of_file(b"other")).unwrap(), [0_u64; 0]);
        assert_eq!(reader.reports_named("FLANGE.HTML").unwrap(), [first]);
        assert!(reader.reports_named("lot.html").unwrap().contains(&second));
        let whole = verify(&place.path("j.sqlite"), &[], &mut |_, _| std::ops::ControlFlow::Continue(())).unwrap();
        assert!(whole.is_whole(), "{whole:?}");
    }
}

#[test]
fn no_question_for_checks_finds_a_report() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3]);
    let reader = place.reader();
    let numbers = |question: Question| reader.numbers(&question, None, 99).unwrap();
    let none = Question::default;
    assert_eq!(numbers(none()), [5, 4, 3, 2]);
    assert_eq!(numbers(Question { kinds: AskedKinds::Reports, ..none() }), [5]);
    for of_checks in [
        Question { kinds: AskedKinds::Checks, ..none() },
        Question { standing: true, ..none() },
        Question { simulated: Some(false), ..none() },
        Question { verdicts: fitcheck::verdict::Status::ALL.to_vec(), ..none() },
    ] {
        assert_eq!(numbers(of_checks.clone()), [4, 3, 2], "{of_checks:?}");
        assert_eq!(reader.count(&of_checks, 99).unwrap(), 3);
    }
    for of_report in ["flange", "json", "8"] {
        let question = Question { words: vec![of_report.to_owned()], ..none() };
        assert!(numbers(question).contains(&5), "{of_report}");
    }
    assert_eq!(numbers(Question { who: Some("bert".to_owned()), ..none() }), [5]);
    assert_eq!(numbers(Question { station: Some("office".to_owned()), ..none() }), [5]);
}

#[test]
fn a_report_is_neither_corrected_nor_withdrawn_and_knows_the_journal() {
    let place = Place::with_checks();
    let head = place.report("flange.json", &[2, 3]);
    let mut journal = place.open();
    assert_eq!(journal.append(&[withdrawal(head)]), Err(StoreError::IsReport { number: 5 }));
    let other = Head { number: 4, hash: head.hash };
    let foreign = report("other.html", &[2], other);
    assert_eq!(journal.append(&[foreign]), Err(StoreError::OtherJournal { number: 4 }));
    assert_eq!(journal.head().unwrap(), head);
    let said = place.journal("correct 5 --reason x --withdraw");
    assert_eq!(said.code, 1);
    assert!(said.err.contains("entry 5 is not a check"), "{}", said.err);
}

#[test]
fn an_index_that_hides_a_report_is_named() {
    for change in [
        "DELETE FROM reported WHERE first = 2",
        "UPDATE reported SET last = 3",
        "DELETE FROM report",
        "UPDATE report SET sha256 = zeroblob(32)",
        "UPDATE report SET name = 'other'",
        "INSERT INTO report VALUES (3, zeroblob(32), 'x')",
        "INSERT INTO reported VALUES (3, 2, 2)",
    ] {
        let place = Place::with_checks();
        place.report("flange.json", &[2, 4]);
        place.open().tidy().unwrap();
        rusqlite::Connection::open(place.path("j.sqlite")).unwrap().execute_batch(change).unwrap();
        let found = verify(&place.path("j.sqlite"), &[], &mut |_, _| std::ops::ControlFlow::Continue(())).unwrap();
        assert_eq!(found.findings, [Finding::NotFound { entries: 1 }], "{change}");
    }
}

/// A journal of the version before reports has neither their tables nor their index.
#[test]
fn a_journal_of_the_version_before_is_indexed_anew() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3]);
    place.open().tidy().unwrap();
    let before = "DROP TABLE report; DROP TABLE reported; DROP INDEX find_report; PRAGMA user_version = 3";
    rusqlite::Connection::open(place.path("j.sqlite")).unwrap().execute_batch(before).unwrap();
    assert!(matches!(Reader::open(&place.path("j.sqlite")), Err(StoreError::Older { .. })));
    let said = place.say("check 25H7 --measured 25.01 --record --journal j.sqlite");
    assert!(said.err.contains("was upgraded to this version; the file as it was before is"), "{}", said.err);
    assert_eq!(place.reader().reports_of(3).unwrap(), [5]);
    place.done("verify");
}

// ---- the command line ----

#[test]
fn a_report_is_a_line_of_its_own_and_no_check() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3]);
    let list = place.done("list");
    assert!(list.lines().nth(1).unwrap().starts_with("5 "), "{list}");
    assert!(list.lines().nth(1).unwrap().contains("Bert") && list.contains("report flange.json: 2 checks (2 to 3)"));
    assert_eq!(place.done("list reports").lines().count(), 2);
    assert_eq!(place.done("list reports lot").lines().count(), 2);
    assert_eq!(place.done("list checks").lines().count(), 4);
    let found = &place.json("list --format json")[0];
    assert_eq!((&found["number"], &found["status"]), (&Value::from(5), &Value::Null));
    assert_eq!((&found["report"]["name"], &found["report"]["title"]), (&"flange.json".into(), &"Lot 8".into()));
    assert_eq!(found["report"]["checks"].to_string(), "[[2,3]]");
    assert!(place.json("list --format json")[1].get("report").is_none());
    for checks_alone in ["list --format csv", "export", "export --format csv"] {
        assert_eq!(place.done(checks_alone).lines().count(), 4, "{checks_alone}");
    }
    assert_eq!(place.done("export --format json").lines().count(), 3);
    assert!(place.done("export reports --format json").contains("\"kind\":\"report\""));
    let said = place.journal("list reports checks");
    assert!(said.err.contains("reports and checks exclude each other"), "{}", said.err);
}

#[test]
fn an_entry_is_shown_with_all_that_it_says_and_a_check_with_its_reports() {
    let place = Place::with_checks();
    let head = place.report("flange.json", &[2, 3]);
    let shown = place.done("show 5");
    let sha256 = Hash::of_file(&std::fs::read(place.path("flange.json")).unwrap()).to_string();
    for line in [
        "entry        5 of 5",
        "station      Office",
        "who          Bert",
        "report       flange.json",
        "format       json",
        "title        Lot 8",
        &format!("SHA-256      {sha256}"),
        "shows        2 checks (2 to 3)",
        "made after   entry 4 (",
    ] {
        assert!(shown.contains(line), "{line}: {shown}");
    }
    assert!(place.done("show 3").contains("in report    5 flange.json\n"));
    assert!(!place.done("show 4").contains("in report"));
    assert_eq!(place.json("show 3 --format json")["in_reports"].to_string(), "[5]");
    assert!(place.json("show 4 --format json").get("in_reports").is_none());
    // By the digits that a report has.
    let digits = head.hash.to_string();
    // Figures alone are a number, up to sixteen of them.
    let first = |count: usize| digits.chars().take(count).collect::<String>();
    let is_name = |count: &usize| *count == 16 || first(*count).bytes().any(|digit| digit.is_ascii_alphabetic());
    let short = (8..=16).find(is_name).unwrap();
    for name in [first(short), digits.clone(), first(16).to_uppercase()] {
        assert!(place.done(&format!("show {name}")).starts_with("entry        5 of 5"), "{name}");
    }
    let unknown = if digits.starts_with("0000000") { "ffffffffff" } else { "00000000aa" };
    let said = place.journal(&format!("show {unknown}"));
    assert_eq!(said.code, 1);
    assert!(said.err.contains(&format!("no entry of j.sqlite has a hash that begins with {unknown}")), "{}", said.err);
    assert!(place.journal("show 12345678").err.contains("there is no entry 12345678"));
    for wrong in ["abc", "1234567x", "-5"] {
        assert_eq!(place.journal(&format!("show {wrong}")).code, 2, "{wrong}");
    }
}

#[test]
fn digits_that_several_hashes_begin_with_are_refused_with_their_entries() {
    let place = Place::with_checks();
    place.open().tidy().unwrap();
    let same = "DROP TRIGGER entry_keeps; UPDATE entry SET hash = unhex(substr(hex(hash), 1, 0) || '9F86D081' || substr(hex(hash), 9)) \
                WHERE number IN (2, 4)";
    rusqlite::Connection::open(place.path("j.sqlite")).unwrap().execute_batch(same).unwrap();
    let reader = place.reader();
    let prefix = HashPrefix::read("9f86d081").unwrap();
    let found: Vec<u64> = reader.with_hash(&prefix, 9).unwrap().iter().map(|head| head.number).collect();
    assert_eq!(found, [2, 4]);
    let said = place.journal("show 9f86d081");
    assert_eq!(said.code, 1);
    assert!(said.err.contains("several entries begin with 9f86d081: 2, 4. Give more digits"), "{}", said.err);
}

#[test]
fn a_file_as_it_was_written_is_known_whatever_it_is_called() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3, 4]);
    let out = place.done("verify flange.json");
    assert!(
        out.contains(
            "flange.json was written on 2026-11-23T19:00:00.000+01:00 by Bert at Office, as entry 5 of chain "
        )
    );
    assert!(out.contains(": 3 checks (2 to 4)\n  every one of them stands as it was written\n"), "{out}");
    assert!(out.contains("  the data of the file says what the journal says\n"), "{out}");
    std::fs::rename(place.path("flange.json"), place.path("mail.txt")).unwrap();
    let target = place.reader().entry(3).unwrap().unwrap().head;
    place.add(withdrawal(target));
    assert_eq!(place.journal("correct 4 --reason x --measured 25.014").code, 0);
    let out = place.done("verify mail.txt");
    assert!(
        out.contains("  entry 4 was corrected by entry 7 since\n  entry 3 was withdrawn by entry 6 since\n"),
        "{out}"
    );
    let found = &place.json("verify mail.txt --format json")["files"][0];
    assert_eq!(
        (&found["known"], &found["whole"], &found["reports"][0]["data_agrees"]),
        (&true.into(), &true.into(), &true.into())
    );
    assert_eq!(found["reports"][0]["withdrawn"].to_string(), "[{\"number\":3,\"by\":6}]");
    assert_eq!(found["reports"][0]["corrected"].to_string(), "[{\"number\":4,\"by\":7}]");
    assert!(place.json("verify --format json").get("files").is_none());
}

#[test]
fn a_changed_file_is_not_known_and_says_which_check_is_another_one() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3, 4]);
    place.change("flange.json", "25.012", "25.002");
    place.change("flange.json", "\"id\": \"Flange\"", "\"id\": \"Bush\"");
    let said = place.journal("verify flange.json");
    assert_eq!(said.code, 1);
    for line in [
        "5 entries are as they were written",
        "flange.json is not a file that this journal knows: it was changed, or written elsewhere",
        "  entry 5 is a report of this name, with the SHA-256 ",
        "  entry 2: id is Bush in the file, Flange 17 in the journal",
        "  entry 3: measured_mm is 25.002 in the file, 25.012 in the journal",
    ] {
        assert!(said.out.contains(line), "{line}: {}", said.out);
    }
    assert!(!said.out.contains("entry 4:"), "{}", said.out);
    let found = place.json("verify flange.json --format json");
    assert_eq!((&found["whole"], &found["files"][0]["known"]), (&true.into(), &false.into()));
    assert_eq!(found["files"][0]["same_name"]["data_agrees"], Value::from(false));
    // What is no data is no difference of data.
    place.report("title.json", &[2]);
    place.change("title.json", "\"title\": \"\"", "\"title\": \"x\"");
    assert!(place.journal("verify title.json").out.contains("agrees with entry 6: what is other is elsewhere"));
    fitcheck::files::write(&place.path("other.html"), b"<html>").unwrap();
    let said = place.journal("verify other.html none.html");
    assert_eq!(said.code, 1);
    assert!(said.out.contains("other.html is not a file that this journal knows"), "{}", said.out);
    assert!(!said.out.contains("is a report of this name") && said.err.contains("none.html"), "{}", said.err);
}

#[test]
fn a_journal_that_was_changed_proves_nothing_of_a_file() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3]);
    let change = "DROP TRIGGER entry_keeps; UPDATE entry SET hash = zeroblob(32) WHERE number = 3";
    rusqlite::Connection::open(place.path("j.sqlite")).unwrap().execute_batch(change).unwrap();
    let said = place.journal("verify flange.json");
    assert_eq!(said.code, 1);
    assert!(said.out.contains("the journal itself is not as it was written: what it says of the file proves nothing"));
    assert!(!said.out.contains("stands as it was written"), "{}", said.out);
}

/// The files that checks were made with are looked for in all bodies: a report is none of them.
#[test]
fn a_report_is_no_file_that_a_watch_has_taken() {
    let head = Head { number: 2, hash: Hash([7; 32]) };
    let body = fitcheck::journal::body::write(&report("lot.csv", &[2], head)).unwrap();
    let mut known = fitcheck::watch::TakenFiles::default();
    known.see(&body);
    assert_eq!(known.count(), 0);
}

/// A report whose entry says something else than its checks: whoever wrote that entry wrote no report of them.
#[test]
fn a_report_of_what_is_no_check_is_told() {
    let place = Place::with_checks();
    place.report("a.json", &[2]);
    let head = place.open().head().unwrap();
    fitcheck::files::write(&place.path("lot.html"), b"lot.html").unwrap();
    place.add(report("lot.html", &[3, 5], head));
    let said = place.journal("verify lot.html");
    assert_eq!(said.code, 1);
    assert!(said.out.contains("  entry 5 is not a check of a size\n"), "{}", said.out);
    // Words of a file that claims to be a report are data, and not believed.
    fitcheck::files::write(&place.path("a.json"), br#"{"checks":[{"time":[1]}]}"#).unwrap();
    let said = place.journal("verify a.json");
    assert!(said.out.contains("the data of the file is not a report of Fitcheck"), "{}", said.out);
}

#[test]
fn the_command_line_records_which_report_it_has_written() {
    let place = Place::new();
    let written = "report --check 25H7=25.012 --check 10g6=9,991 -o bores.html --record --journal j.sqlite --who Anna";
    let said = place.say(written);
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.err.contains("wrote bores.html") && said.err.contains("recorded as entry 2 of j.sqlite (hash "));
    let out = place.done("verify bores.html");
    assert!(
        out.contains("as entry 2 of chain ") && out.contains("0 checks, and 2 checks that the journal does not have"),
        "{out}"
    );
    let entry = place.json("show 2 --format json");
    let report = &entry["body"]["report"];
    let bytes = std::fs::read(place.path("bores.html")).unwrap();
    assert_eq!(report["sha256"], Value::from(Hash::of_file(&bytes).to_string()));
    assert_eq!((&report["bytes"], &report["head"]["number"]), (&bytes.len().into(), &1.into()));
    assert_eq!(place.done("list standing").lines().count(), 1, "its checks are not recorded");
    // The file stays where it cannot be recorded.
    std::fs::create_dir(place.path("folder")).unwrap();
    let said = place.say("report --check 25H7=25.012 -o late.html --record --journal folder");
    assert_eq!(said.code, 1);
    assert!(
        said.err.contains("late.html is written, but the journal does not know it: folder is not a file"),
        "{}",
        said.err
    );
    assert!(place.path("late.html").exists());
    let said = place.say("report --check 25H7=25.012 -o - --format json --record --journal j.sqlite");
    assert_eq!((said.code, said.out.as_str()), (1, ""));
    assert!(said.err.contains("give -o FILE"), "{}", said.err);
}

#[test]
fn a_pdf_is_compared_by_what_it_has_attached() {
    let place = Place::with_checks();
    place.report("flange.json", &[2, 3]);
    let data = std::fs::read(place.path("flange.json")).unwrap();
    let pdf = |data: &[u8]| {
        let mut file = b"%PDF-1.7\n7 0 obj\n<< /Type /EmbeddedFile >>\nstream\n".to_vec();
        file.extend_from_slice(data);
        file.extend_from_slice(b"\nendstream\nendobj\n%%EOF\n");
        file
    };
    let known = |name: &str, bytes: &[u8]| {
        fitcheck::files::write(&place.path(name), bytes).unwrap();
        let head = place.open().head().unwrap();
        let Content::Report(of_checks) = report(name, &[2, 3], head).content else { panic!("a report") };
        let content = Content::Report(Reported { sha256: Hash::of_file(bytes), ..of_checks });
        place.add(Entry { content, ..report(name, &[2, 3], head) });
        place.journal(&format!("verify {name}"))
    };
    let said = known("flange.pdf", &pdf(&data));
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    assert!(said.out.contains("the data of the file says what the journal says"), "{}", said.out);
    // What was written and recorded, and never was what the journal says.
    let lie = String::from_utf8(data).unwrap().replace("\"GOOD\"", "\"SCRAP\"");
    let said = known("lie.pdf", &pdf(lie.as_bytes()));
    assert_eq!(said.code, 1);
    assert!(said.out.contains("entry 2: status is SCRAP in the file, GOOD in the journal"), "{}", said.out);
    let said = known("few.pdf", &pdf(br#"{"checks":[]}"#));
    assert!(said.out.contains("entry 2: no check of the file says what the journal says"), "{}", said.out);
}
