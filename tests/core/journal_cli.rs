//! `--record` and `fitcheck journal` as programs: what is judged is kept, found, shown, exported, corrected and verified.

use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value;
use tempfile::TempDir;

use crate::at_home::AtHome as _;

const HEADER: &str = "station,number,time,who,part,serial,feature,callout,min_mm,max_mm,measured_mm,rule,u_um,status,origin,correction_of,hash,simulated,as_measured_mm,correction_um,temperature_c,expansion_um_per_m_k,scale_temperature_c,scale_expansion_um_per_m_k,position,remeasure_reason";

/// A folder with a home of its own, so that nothing of the user's is touched.
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

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn run_with(&self, args: &[&str], variables: &[(&str, &str)]) -> Said {
        let mut command = cargo_bin_cmd!("fitcheck");
        let home = self.path("home");
        for name in ["FITCHECK_JOURNAL", "HOSTNAME"] {
            command.env_remove(name);
        }
        command.at_home(&home).env("TZ", "UTC").current_dir(self.0.path());
        command.envs(variables.iter().copied());
        let Output { status, stdout, stderr } = command.args(args).output().unwrap();
        Said {
            code: status.code().unwrap(),
            out: String::from_utf8(stdout).unwrap(),
            err: String::from_utf8(stderr).unwrap(),
        }
    }

    fn run(&self, args: &[&str]) -> Said {
        self.run_with(args, &[])
    }

    /// The same for words that are apart by blanks.
    fn say(&self, line: &str) -> Said {
        self.run(&line.split(' ').collect::<Vec<_>>())
    }

    #[track_caller]
    fn done(&self, line: &str) -> String {
        let said = self.say(line);
        assert_eq!(said.code, 0, "{line}: {}{}", said.out, said.err);
        said.out
    }

    fn put(&self, name: &str, text: &str) {
        fitcheck::files::write(&self.path(name), text.as_bytes()).unwrap();
    }

    /// A typed bore of 25 H7, recorded in `j.sqlite`.
    #[track_caller]
    fn record(&self, measured: &str, more: &[&str]) -> Said {
        let args =
            ["check", "25 H7", "--measured", measured, "--record", "--journal", "j.sqlite", "--station", "Mill 3"];
        let said = self.run(&[&args, more].concat());
        assert!(said.err.contains("recorded as entry "), "{}", said.err);
        said
    }

    /// The rows of an export as objects of their columns.
    fn rows(&self, question: &str) -> Vec<Vec<String>> {
        let out = self.done(&format!("journal export --journal j.sqlite{question}"));
        let mut lines = csv::ReaderBuilder::new().from_reader(out.as_bytes());
        assert_eq!(lines.headers().unwrap().iter().collect::<Vec<_>>().join(","), HEADER);
        lines.records().map(|line| line.unwrap().iter().map(str::to_owned).collect()).collect()
    }

    fn entry(&self, number: u64) -> Value {
        let out = self.done(&format!("journal show {number} --format json --journal j.sqlite"));
        serde_json::from_str(&out).unwrap()
    }
}

/// A column of a row.
fn cell<'a>(row: &'a [String], name: &str) -> &'a str {
    &row[HEADER.split(',').position(|column| column == name).unwrap()]
}

/// The columns of rows.
fn column<'a>(rows: &'a [Vec<String>], name: &str) -> Vec<&'a str> {
    rows.iter().map(|row| cell(row, name)).collect()
}

// ---- recording ----

#[test]
fn a_check_is_recorded_after_its_verdict_and_found_again() {
    let place = Place::new();
    let names =
        ["--who", "Anna", "--part", "Flange", "--serial", "17", "--feature-name", "B1", "--remark", "burr left"];
    let said = place.record("25.012", &names);
    assert_eq!(said.code, 0);
    assert!(said.out.starts_with("FIT STATUS: GOOD"), "{}", said.out);
    assert!(said.err.contains("note: a new journal was created: j.sqlite"), "{}", said.err);
    assert!(said.err.contains("recorded as entry 2 of j.sqlite (hash "), "{}", said.err);
    let rework = place.record("24.99", &["--rule", "iso14253-2017", "--u", "1.2"]);
    assert_eq!(rework.code, 10);
    let rows = place.rows("");
    assert_eq!(column(&rows, "number"), ["2", "3"]);
    assert_eq!(rows[0][..2], ["Mill 3", "2"]);
    let values =
        ["Anna", "Flange", "17", "B1", "25 H7", "25.000", "25.021", "25.012", "simple", "", "GOOD", "typed", ""];
    assert_eq!(rows[0][3..16], values);
    assert!(cell(&rows[0], "time").ends_with("+00:00"), "{:?}", rows[0]);
    assert_eq!(
        (cell(&rows[1], "rule"), cell(&rows[1], "u_um"), cell(&rows[1], "status")),
        ("iso14253-2017", "1.2", "REWORK")
    );
    let found = place.done("journal list burr --journal j.sqlite");
    assert!(found.contains("Flange 17") && found.lines().count() == 2, "{found}");
    assert_eq!(place.rows(" verdict:rework").len(), 1);
    assert_eq!(place.rows(" verdict:scrap,re-measure").len(), 0);
}

#[test]
fn nothing_is_recorded_without_being_asked_for() {
    let place = Place::new();
    let said = place.run_with(&["check", "25 H7", "--measured", "25.012"], &[("FITCHECK_JOURNAL", "j.sqlite")]);
    assert_eq!((said.code, said.err.as_str()), (0, ""));
    assert!(!place.path("j.sqlite").exists() && !place.path("home").exists());
    let said = place.run(&["check", "25 H7", "--measured", "25.012", "--who", "Anna"]);
    assert_eq!(said.code, 2, "{}", said.err);
}

#[test]
fn the_journal_is_the_users_own_unless_another_one_is_named() {
    let place = Place::new();
    let check = ["check", "25 H7", "--measured", "25.012", "--record"];
    let said = place.run(&check);
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.err.contains("journal.sqlite"), "{}", said.err);
    let said = place.run_with(&check, &[("FITCHECK_JOURNAL", "shop.sqlite")]);
    assert!(said.err.contains("of shop.sqlite"), "{}", said.err);
    let said =
        place.run_with(&[&check[..], &["--journal", "j.sqlite"]].concat(), &[("FITCHECK_JOURNAL", "shop.sqlite")]);
    assert!(said.err.contains("of j.sqlite"), "{}", said.err);
    assert_eq!(place.done("journal list").lines().count(), 2);
}

/// A program on a stick, with a folder `state` beside it.
#[test]
fn a_program_that_is_carried_about_keeps_its_journal_beside_it() {
    let place = Place::new();
    std::fs::create_dir_all(place.path("stick/state")).unwrap();
    let carried = place.path("stick/fitcheck");
    let built = env!("CARGO_BIN_EXE_fitcheck");
    std::fs::hard_link(built, &carried).or_else(|_| std::fs::copy(built, &carried).map(drop)).unwrap();
    let mut command = std::process::Command::new(&carried);
    command.args(["check", "25 H7", "--measured", "25.012", "--record"]).current_dir(place.0.path());
    let output = command.at_home(place.path("home")).env_remove("FITCHECK_JOURNAL").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let names = ["journal.sqlite", "journal-heads.txt"];
    assert!(names.iter().all(|name| place.path("stick/state").join(name).exists()));
    assert!(!place.path("home").exists());
}

#[test]
fn where_nothing_can_be_recorded_the_verdict_is_there_and_the_call_fails() {
    let place = Place::new();
    std::fs::create_dir(place.path("folder")).unwrap();
    let check = ["check", "25 H7", "--measured", "25.012", "--record"];
    for (more, why) in [
        (["--journal", "folder"], "nothing was recorded: folder is not a file"),
        (["--who", "An\nna"], "nothing was recorded: about.who has the control character U+000A"),
    ] {
        let said = place.run(&[&check[..], &more].concat());
        assert_eq!(said.code, 1, "{}", said.err);
        assert!(said.out.starts_with("FIT STATUS: GOOD"), "{}", said.out);
        assert!(said.err.contains(why), "{}", said.err);
    }
    place.put("letter.sqlite", "Dear journal");
    let said = place.run(&[&check[..], &["--journal", "letter.sqlite"]].concat());
    assert_eq!(said.code, 1);
    assert!(said.err.contains("not a journal of Fitcheck"), "{}", said.err);
    assert_eq!(std::fs::read(place.path("letter.sqlite")).unwrap(), b"Dear journal");
}

#[test]
fn a_record_says_hole_shaft_or_neither() {
    let place = Place::new();
    let record = ["--record", "--journal", "j.sqlite"];
    let check = |more: &[&str]| place.run(&[&["check", "10m", "--measured"], more, &record].concat()).code;
    assert_eq!(check(&["10.05"]), 0);
    assert_eq!(check(&["10.25"]), 13);
    assert_eq!(check(&["10.25", "--feature", "hole"]), 11);
    let shown = |number: &str| place.run(&["journal", "show", number, "--journal", "j.sqlite"]).out;
    assert!(shown("2").contains("(neither hole nor shaft, -200 / +200 µm)"), "{}", shown("2"));
    assert!(shown("3").contains("OUT OF LIMITS") && shown("4").contains("(hole, "), "{}", shown("3"));
    let asked = place.run(&["journal", "list", "verdict:out-of-limits", "--journal", "j.sqlite"]);
    assert!(asked.out.contains("10.25") && asked.out.contains("OUT OF LIMITS"), "{}", asked.out);
}

#[test]
fn contacts_their_file_and_a_budget_are_in_the_record() {
    let place = Place::new();
    let contacts = "x,y,z\n12.505,0,-5\n0,12.507,-5\n-12.503,0,-5\n0,-12.5,-5\n";
    place.put("bore.csv", contacts);
    let budget = "name = \"S3\"\ndate = 2020-01-15\nby = \"J. Jansen\"\nvalid_until = 2099-01-14\n\n[[contribution]]\n\
        name = \"touch\"\nkind = \"scatter\"\ntype = \"A\"\nlaw = \"normal\"\nstandard_um = 0.5\ntouches = 4\nstep_deg = 90\n";
    place.put("s3.toml", budget);
    let said = place.run(&[
        "check",
        "25 H7",
        "--contacts",
        "bore.csv",
        "--budget",
        "s3.toml",
        "--rule",
        "iso14253-2017",
        "--temperature",
        "22",
        "--material",
        "steel",
        "--record",
        "--journal",
        "j.sqlite",
    ]);
    assert_eq!(said.code, 0, "{}", said.err);
    let entry = place.entry(2);
    let check = &entry["body"]["check"];
    let sha256 = |text: &str| fitcheck::journal::chain::Hash::of_file(text.as_bytes()).to_string();
    let files: Vec<_> = check["files"]
        .as_array()
        .unwrap()
        .iter()
        .map(|file| {
            (
                file["role"].as_str().unwrap(),
                file["name"].as_str().unwrap(),
                file["sha256"].as_str().unwrap().to_owned(),
            )
        })
        .collect();
    assert_eq!(files, [("measurements", "bore.csv", sha256(contacts)), ("budget", "s3.toml", sha256(budget))]);
    assert_eq!(check["size"]["measurement"]["contacts_mm"][0], serde_json::json!(["12.505", "0", "-5"]));
    assert_eq!(check["size"]["budget"]["name"], "S3");
    assert_eq!(check["size"]["correction"]["part"]["temperature_c_thousandths"], 22_000);
    let text = place.done("journal show 2 --journal j.sqlite");
    for line in [
        "at 20 °C",
        "budget       S3, created 2020-01-15 by J. Jansen",
        "contact      X 12.5050",
        "file         measurements bore.csv, SHA-256",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
}

#[test]
fn an_import_is_recorded_at_once_and_says_what_is_not() {
    let place = Place::new();
    let rows = "id,callout,measured\nb1,25 H7,25.012\nb2,25 H7,25.03\nb3,,3\n\"b4\u{7}\",25 H7,25.01\n=1+1,25 H7,25.01\nb6,25 H7,fifty\n";
    place.put("rows.csv", rows);
    let said = place.say("import rows.csv --format csv --record --journal j.sqlite --who Bob");
    assert_eq!(said.code, 1);
    let not = "warning: 3 rows are not recorded: rows.csv:4, rows.csv:5 (about.part has the control character U+0007 as its character 3: \
        texts of a journal are one line without control characters), rows.csv:7";
    assert!(said.err.contains(not), "{}", said.err);
    assert!(said.err.contains("recorded as entries 2 to 4 of j.sqlite (hash of the last one "), "{}", said.err);
    let recorded = place.rows("");
    assert_eq!(column(&recorded, "part"), ["b1", "b2", "'=1+1"]);
    assert_eq!(column(&recorded, "status"), ["GOOD", "SCRAP", "GOOD"]);
    assert_eq!(column(&recorded, "who"), ["Bob"; 3]);
    let hash = fitcheck::journal::chain::Hash::of_file(rows.as_bytes()).to_string();
    assert_eq!(place.entry(3)["body"]["check"]["files"][0]["sha256"], hash.as_str());
    // With a part, the name of a row is the feature.
    place.say("import rows.csv --record --journal j.sqlite --part Flange");
    assert_eq!(column(&place.rows(" part:Flange"), "feature"), ["b1", "b2", "'=1+1"]);
    // Without --record the answer is the same.
    let plain = place.say("import rows.csv --format csv");
    assert_eq!((plain.code, plain.out), (said.code, said.out));
}

#[test]
fn cycles_are_recorded_with_contacts_and_simulated_ones_say_so() {
    let place = Place::new();
    let cycle = "cycle 421 --set Q273=0 Q274=0 Q262=25 Q275=25.021 Q276=25 --record --journal j.sqlite";
    place.done(cycle);
    place.put("c.csv", "x,y,z\n12.52,0,0\n0,12.52,0\n-12.52,0,0\n0,-12.52,0\n");
    let said = place.say(&format!("{cycle} --contacts c.csv --part Flange"));
    assert_eq!(said.code, 11, "{}", said.err);
    let rows = place.rows("");
    assert_eq!(column(&rows, "measured_mm"), ["25.000", "25.040"]);
    assert_eq!(column(&rows, "max_mm"), ["25.021"; 2]);
    assert_eq!(
        column(&rows, "origin"),
        ["cycle 421, simulated, a workpiece without faults", "cycle 421, contacts from c.csv"]
    );
    assert_eq!(place.rows(" measured").len(), 1);
    assert_eq!(place.rows(" simulated").len(), 1);
    let entry = place.entry(3);
    assert_eq!(entry["body"]["check"]["cycle"]["contacts_mm"][0][0], "12.52");
    assert_eq!(entry["body"]["check"]["files"][0]["name"], "c.csv");
    // Without limits nothing is judged, and nothing is recorded.
    let said = place.say("cycle 421 --set Q273=0 Q274=0 Q262=25 --record --journal j.sqlite");
    assert!(said.err.contains("nothing was judged, so nothing was recorded"), "{}", said.err);
    assert_eq!(place.rows("").len(), 2);
}

#[test]
fn a_run_records_each_cycle_with_its_block() {
    let place = Place::new();
    place.done("run 8255_nl.h --set Q1=25 QS1=H7 --record --journal j.sqlite --part Flange");
    let rows = place.rows(" part:Flange simulated");
    assert_eq!(column(&rows, "status"), ["GOOD"]);
    let check = &place.entry(2)["body"]["check"];
    assert!(check["cycle"]["block"]["line"].as_u64().unwrap() > 1, "{check}");
    assert_eq!(check["files"][0]["role"], "program");
    let text = place.done("journal show 2 --journal j.sqlite");
    assert!(text.contains("\nparameter    Q262 = 25\n"), "{text}");
}

#[test]
fn whatever_a_name_holds_is_recorded_as_it_is_and_found() {
    let place = Place::new();
    let names = [
        "'; DROP TABLE entry; --",
        "\" OR 1=1 --",
        "NEAR(a b) AND *",
        "%_\\",
        "=HYPERLINK(\"x\")",
        "Ø \u{202e}desrever",
        "名前 \u{1f529}",
    ];
    for (number, name) in (2_u64..).zip(names) {
        let fields = ["--who", "--part", "--serial", "--feature-name", "--remark"];
        let more: Vec<&str> = fields.iter().flat_map(|field| [*field, name]).collect();
        place.record("25.01", &more);
        let about = &place.entry(number)["body"]["about"];
        for field in ["who", "part", "serial", "feature", "remark"] {
            assert_eq!(about[field], name);
        }
        let quoted = format!("\"{}\"", name.replace('"', "\"\""));
        for key in ["part", "serial", "feature", "who"] {
            let asked = format!("{key}:{quoted}");
            let said = place.run(&["journal", "list", "--journal", "j.sqlite", "--format", "json", &asked]);
            let rows: Value = serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{asked}: {}", said.err));
            assert_eq!(rows.as_array().unwrap().len(), 1, "{asked}");
            assert_eq!(rows[0]["number"], number);
        }
        let said = place.run(&["journal", "list", "--journal", "j.sqlite", &quoted]);
        assert_eq!(said.code, 0, "{quoted}: {}", said.err);
        assert!(!said.out.contains('\u{202e}'), "{}", said.out);
    }
    assert_eq!(place.rows("").len(), names.len());
    place.done("journal verify --journal j.sqlite");
}

#[test]
fn ten_programs_record_into_one_file_at_once() {
    let place = Place::new();
    let rows = "b,25 H7,25.01\n".repeat(50);
    place.put("rows.csv", &format!("id,callout,measured\n{rows}"));
    std::thread::scope(|scope| {
        for number in 0..10 {
            let place = &place;
            let record = move || {
                let part = format!("P{number}");
                place.done(&format!("import rows.csv --record --journal j.sqlite --part {part}"));
            };
            scope.spawn(record);
        }
    });
    let recorded = place.rows("");
    assert_eq!(recorded.len(), 500);
    for part in 0..10 {
        // All rows of a program, or none, and nothing of another one in between.
        let part = format!("P{part}");
        let numbers: Vec<u64> = recorded
            .iter()
            .filter(|row| cell(row, "part") == part)
            .map(|row| cell(row, "number").parse().unwrap())
            .collect();
        assert_eq!(numbers.len(), 50);
        assert_eq!(numbers[49] - numbers[0], 49);
    }
    let out = place.done("journal verify --journal j.sqlite");
    assert!(out.starts_with("501 entries are as they were written"), "{out}");
}

// ---- asking ----

#[test]
fn a_list_is_the_newest_first_and_ends_where_it_is_told_to() {
    let place = Place::new();
    for measured in ["25.001", "25.002", "25.003"] {
        place.record(measured, &["--part", "Flange"]);
    }
    let list = |more: &str| -> Vec<u64> {
        let out = place.done(&format!("journal list --journal j.sqlite --format json{more}"));
        let rows: Vec<Value> = serde_json::from_str(&out).unwrap();
        rows.iter().map(|row| row["number"].as_u64().unwrap()).collect()
    };
    assert_eq!(list(""), [4, 3, 2]);
    assert_eq!(list(" --oldest --limit 2"), [2, 3]);
    let said = place.say("journal list --journal j.sqlite --limit 2");
    assert!(said.err.contains("note: only 2 entries are listed"), "{}", said.err);
    let csv = place.done("journal list --journal j.sqlite --format csv --limit 1");
    assert_eq!(csv.lines().next(), Some(HEADER));
    let row: Value =
        serde_json::from_str(&place.done("journal list --journal j.sqlite --format json --limit 1")).unwrap();
    assert_eq!((&row[0]["measured_mm"], &row[0]["simulated"]), (&serde_json::json!(25.003), &serde_json::json!(false)));
    // An argument with a blank is one value.
    let said = place.run(&[
        "journal",
        "list",
        "--journal",
        "j.sqlite",
        "station:Mill 3",
        "callout:25 H7",
        "today",
        "--format",
        "csv",
    ]);
    assert_eq!(said.out.lines().count(), 4, "{}{}", said.out, said.err);
    let said = place.say("journal list --journal j.sqlite colour:red");
    assert_eq!(said.code, 1);
    assert!(said.err.contains("colour:red: colour: is not a known keyword; expected part:, "), "{}", said.err);
}

#[test]
fn an_export_is_the_bodies_byte_for_byte() {
    let place = Place::new();
    place.record("25.001", &["--remark", "Ø \"fine\" \\ é"]);
    place.record("25.03", &[]);
    let out = place.done("journal export --journal j.sqlite --format json");
    let lines: Vec<&str> = out.lines().collect();
    let first = place.done("journal show 2 --journal j.sqlite --format json");
    let head: Value = serde_json::from_str(&first).unwrap();
    for (line, number) in lines.iter().zip(2_u64..) {
        let value: Value = serde_json::from_str(line).unwrap();
        let (_, body) = line.split_once("\"body\":").unwrap();
        let body = body.strip_suffix('}').unwrap();
        let chain = value["chain"].as_str().unwrap().parse().unwrap();
        let before = place.entry(number)["before"].as_str().unwrap().parse().unwrap();
        let before = fitcheck::journal::chain::Head { number: number - 1, hash: before };
        let hash = fitcheck::journal::chain::entry_hash(chain, before, body.as_bytes()).unwrap().to_string();
        assert_eq!(value["hash"], hash.as_str());
    }
    assert_eq!(head["body"]["about"]["remark"], "Ø \"fine\" \\ é");
    let said = place.say("journal export --journal j.sqlite verdict:scrap --output scrap.csv");
    assert!(said.err.contains("scrap.csv"), "{}", said.err);
    assert_eq!(std::fs::read_to_string(place.path("scrap.csv")).unwrap().lines().count(), 2);
}

#[test]
fn an_entry_that_is_not_there_is_refused() {
    let place = Place::new();
    assert!(place.say("journal list --journal j.sqlite").err.contains("there is no journal at j.sqlite"));
    assert!(!place.path("j.sqlite").exists());
    place.record("25.001", &[]);
    for number in ["0", "3", "999999999999999"] {
        let said = place.say(&format!("journal show {number} --journal j.sqlite"));
        assert_eq!(said.code, 1);
        assert!(
            said.err.contains(&format!("there is no entry {number} in j.sqlite: the last one is 2")),
            "{}",
            said.err
        );
    }
    let begin = place.done("journal show 1 --journal j.sqlite");
    assert!(begin.contains("begins       the chain "), "{begin}");
}

// ---- correcting ----

#[test]
fn a_correction_is_a_new_entry_and_the_old_one_stays() {
    let place = Place::new();
    place.record("25.012", &["--serial", "17", "--who", "Anna"]);
    let said =
        place.run(&["journal", "correct", "2", "--reason", "the next part", "--serial", "18", "--journal", "j.sqlite"]);
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.err.contains("recorded as entry 3"), "{}", said.err);
    let rows = place.rows("");
    assert_eq!(column(&rows, "serial"), ["17", "18"]);
    assert_eq!(column(&rows, "correction_of"), ["", "2"]);
    assert_eq!(column(&rows, "who"), ["Anna"; 2]);
    assert_eq!(column(&place.rows(" standing"), "number"), ["3"]);
    let text = place.done("journal show 2 --journal j.sqlite");
    assert!(text.contains("entry 3, which corrects this one"), "{text}");
    let text = place.done("journal show 3 --journal j.sqlite");
    assert!(text.contains("corrects     entry 2 (") && text.contains("reason       the next part"), "{text}");
    let again = place.run(&["journal", "correct", "2", "--reason", "x", "--serial", "19", "--journal", "j.sqlite"]);
    assert!(
        again.err.contains("entry 2 was already corrected or withdrawn by entry 3: correct that one"),
        "{}",
        again.err
    );
}

#[test]
fn a_typed_value_is_judged_again_by_the_same_limits_and_rule() {
    let place = Place::new();
    place.record("25.0195", &["--rule", "iso14253-2017", "--u", "1.2"]);
    let said = place.say("journal correct 2 --reason typing --measured 25,012 --journal j.sqlite");
    assert_eq!(said.code, 0, "{}", said.err);
    let rows = place.rows("");
    assert_eq!(column(&rows, "status"), ["RE-MEASURE", "GOOD"]);
    assert_eq!(column(&rows, "rule"), ["iso14253-2017"; 2]);
    assert_eq!(column(&rows, "measured_mm"), ["25.0195", "25.012"]);
    let said = place.run(&["check", "25 H7", "--simulate", "--record", "--journal", "j.sqlite"]);
    assert_eq!(said.code, 0);
    let said = place.say("journal correct 4 --reason typing --measured 25 --journal j.sqlite");
    assert_eq!(said.code, 1);
    assert!(said.err.contains("the value of entry 4 was not typed"), "{}", said.err);
    // Brought to 20 °C as the first one was.
    place.record("24.99", &["--temperature", "22.5", "--material", "steel"]);
    assert_eq!(place.say("journal correct 5 --reason typing --measured 25.01 --journal j.sqlite").code, 0);
    assert_eq!(column(&place.rows(""), "measured_mm")[4], "25.009281");
    assert_eq!(place.entry(6)["body"]["check"]["size"]["correction"]["measured_nm"], 25_010_000);
}

#[test]
fn a_check_is_withdrawn_with_a_reason() {
    let place = Place::new();
    place.record("25.012", &[]);
    let withdraw = |reason: &str| {
        place.run(&["journal", "correct", "2", "--withdraw", "--reason", reason, "--journal", "j.sqlite"])
    };
    assert!(withdraw(" ").err.contains("withdrawal.reason is empty"));
    assert_eq!(withdraw("dirty").code, 0);
    assert_eq!(column(&place.rows(" standing"), "number"), Vec::<&str>::new());
    assert_eq!(column(&place.rows(""), "correction_of"), ["", "2"]);
    let said = place.say("journal correct 3 --reason x --serial 1 --journal j.sqlite");
    assert!(said.err.contains("entry 3 is not a check"), "{}", said.err);
    let said = place.say("journal correct 2 --reason x --journal j.sqlite");
    assert!(said.err.contains("a correction must change something"), "{}", said.err);
    let said = place.say("journal correct 2 --reason x --withdraw --serial 1 --journal j.sqlite");
    assert_eq!(said.code, 2, "{}", said.err);
}

/// The value of the correction and the one before it are both gone: that is said.
#[test]
fn a_correction_that_is_withdrawn_leaves_neither_and_says_so() {
    let place = Place::new();
    place.record("25.05", &[]);
    assert_eq!(place.say("journal correct 2 --reason typing --measured 25.01 --journal j.sqlite").code, 0);
    let said = place.say("journal correct 3 --reason x --withdraw --journal j.sqlite");
    assert_eq!(said.code, 14, "{}", said.err);
    assert!(said.err.contains("entry 3 corrected entry 2: now neither of them counts"), "{}", said.err);
}

// ---- verifying and copying ----

fn open(path: &Path) -> rusqlite::Connection {
    rusqlite::Connection::open(path).unwrap()
}

#[test]
fn verify_names_the_first_entry_that_is_not_as_it_was_written() {
    let place = Place::new();
    for measured in ["25.001", "25.002", "25.003", "25.004"] {
        place.record(measured, &[]);
    }
    let out = place.done("journal verify --journal j.sqlite");
    assert!(out.starts_with("5 entries are as they were written; the last one is 5:"), "{out}");
    let head = out.trim().rsplit(' ').next().unwrap().to_owned();
    place.done(&format!("journal verify --journal j.sqlite --head {head}"));
    let connection = open(&place.path("j.sqlite"));
    connection
        .execute_batch(
            "DROP TRIGGER entry_keeps; UPDATE entry SET body = CAST(replace(CAST(body AS TEXT), '25003000', '25013000') AS BLOB) \
             WHERE number = 4",
        )
        .unwrap();
    drop(connection);
    let said = place.say("journal verify --journal j.sqlite");
    assert_eq!(said.code, 1);
    assert!(said.out.contains("the first that is not as it was written is 4"), "{}", said.out);
    let said = place.say("journal verify --journal j.sqlite --format json");
    let found: Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!((said.code, &found["whole"], &found["first_bad"]), (1, &Value::Bool(false), &Value::from(4)));
}

/// Every file below a folder.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

#[test]
fn a_head_from_elsewhere_shows_an_older_copy() {
    let place = Place::new();
    place.record("25.001", &[]);
    let said = place.say("journal backup old.sqlite --journal j.sqlite");
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.err.contains("copied up to entry 2 to old.sqlite (hash "), "{}", said.err);
    let again = place.say("journal backup old.sqlite --journal j.sqlite");
    assert_eq!(again.code, 1, "{}", again.err);
    place.record("25.002", &[]);
    let head = place.done("journal verify --journal j.sqlite").trim().rsplit(' ').next().unwrap().to_owned();
    // This computer has seen entry 3, wherever the file lies.
    let said = place.say("journal verify --journal old.sqlite");
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(said.out.contains("entry 3 is known elsewhere"), "{}", said.out);
    // Another one has not, unless somebody tells.
    let elsewhere = place.path("elsewhere");
    let other =
        |args: &[&str]| place.run_with(args, &["HOME", "APPDATA"].map(|name| (name, elsewhere.to_str().unwrap())));
    let verify = ["journal", "verify", "--journal", "old.sqlite"];
    let said = other(&verify);
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    assert!(said.err.contains("no entry of this journal is known elsewhere"), "{}", said.err);
    assert_eq!(other(&[&verify[..], &["--head", &head]].concat()).code, 1);
    // Where nobody can read what this computer has seen, somebody looks first.
    let heads = files_below(place.0.path())
        .into_iter()
        .find(|path| path.ends_with("journal-heads.txt") && !path.starts_with(&elsewhere))
        .unwrap();
    fitcheck::files::write(&heads, b"nothing of the kind\n").unwrap();
    let said = place.say("journal verify --journal old.sqlite");
    assert_eq!(said.code, 14, "{}{}", said.out, said.err);
    for wrong in ["3", "0:00", "x:00", "3:00"] {
        assert_eq!(place.say(&format!("journal verify --journal j.sqlite --head {wrong}")).code, 2, "{wrong}");
    }
}

#[test]
fn a_body_of_a_newer_version_is_listed_and_told() {
    let place = Place::new();
    place.record("25.001", &[]);
    let connection = open(&place.path("j.sqlite"));
    let newer = "DROP TRIGGER entry_keeps; UPDATE entry SET body = CAST(replace(CAST(body AS TEXT), '\"v\":1', '\"v\":7') AS BLOB) WHERE number = 2";
    connection.execute_batch(newer).unwrap();
    drop(connection);
    for command in ["list", "export"] {
        let said = place.say(&format!("journal {command} --journal j.sqlite"));
        assert_eq!(said.code, 1);
        assert!(said.err.contains("entry 2: made by a newer Fitcheck"), "{}", said.err);
    }
}
