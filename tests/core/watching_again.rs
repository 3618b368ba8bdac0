//! The watched folder, where files are replaced, copied, half written or held: nothing is lost, and nothing is silent.

#[cfg(unix)]
use std::fs::{File, rename};
#[cfg(unix)]
use std::io::Write as _;

use fitcheck::control::mask::Mask;
#[cfg(unix)]
use fitcheck::files;
#[cfg(unix)]
use fitcheck::watch::Waiting;

use crate::watching::{HEAD, Watched};

/// A log of `BORE_A` with this deviation from 12 mm, with its sign and four figures: `0.0300`.
fn log(deviation: &str) -> String {
    let text = include_str!("../data/samples/logs/en/TCHPR421.TXT");
    let places = [("40.0", "50.0"), ("39.9", "49.9"), ("30.0", "65.0"), ("29.9", "64.9")];
    let text = places.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to));
    text.replace("25.0210", "12.0590")
        .replace("25.0134", &deviation.replacen('0', "12", 1))
        .replace("0.0134", deviation)
        .replace("25.0000", "12.0000")
}

const NOTHING: [&str; 0] = [];

#[test]
fn a_log_that_was_seen_in_pieces_takes_nothing_away_from_those_that_overwrite_it() {
    let mut watched = Watched::new();
    let second = log("0.0400");
    let (begun, rest) = second.split_at(second.len() / 2);
    watched.write("TCHPR421.TXT", &format!("{}\r\n{begun}", log("0.0300")));
    assert_eq!(watched.take(150), ["TCHPR421.TXT BORE_A 12.03 GOOD"]);
    watched.append("TCHPR421.TXT", rest);
    assert_eq!(watched.take(150), ["TCHPR421.TXT BORE_A 12.04 GOOD"]);
    for (deviation, value) in [("0.0350", "12.035"), ("0.0360", "12.036")] {
        watched.write("TCHPR421.TXT", &log(deviation));
        assert_eq!(watched.take(150), [format!("TCHPR421.TXT BORE_A {value} GOOD")]);
    }
    assert_eq!(watched.remarks, NOTHING, "a title is no value");
    watched.restarted(0);
    assert_eq!(watched.take(12_000), NOTHING);
    watched.write("TCHPR421.TXT", &log("0.0370"));
    assert_eq!(watched.take(4_000), ["TCHPR421.TXT BORE_A 12.037 GOOD"]);
}

#[test]
fn logs_and_prints_that_grow_together_have_marks_of_their_own() {
    let mut watched = Watched::new();
    let half = log("0.0400");
    let (begun, rest) = half.split_at(half.len() / 2);
    for (name, deviation) in [("a.txt", "0.0300"), ("b.txt", "0.0310")] {
        watched.write(name, &format!("{}\r\n{begun}", log(deviation)));
        assert_eq!(watched.take(150).len(), 1, "{name}");
    }
    assert_eq!(watched.take(500), NOTHING, "neither takes the other's mark away");
    watched.append("a.txt", rest);
    assert_eq!(watched.take(150), ["a.txt BORE_A 12.04 GOOD"]);
    let mask = "\"Bore %-8s\",QS1;\n\"D %8.3f\",Q153;\n";
    watched.masks.push(("m.a".to_owned(), Mask::read(mask.as_bytes()).unwrap().0));
    watched.write("p.txt", "Bore BORE_A  \nD   12.030\nBore BORE_A  \n");
    assert_eq!(watched.take(150), ["p.txt BORE_A 12.03 GOOD"]);
    watched.write("p.txt", "Bore BORE_A  \nD   12.040\n");
    assert_eq!(watched.take(150), ["p.txt BORE_A 12.04 GOOD"], "its title was there before, and its value was not");
}

#[cfg(target_os = "linux")]
#[test]
fn a_last_line_is_never_taken_while_its_writer_has_the_file_open() {
    for (begun, rest, value) in [
        ("name;measured\nBORE_A;12.0", "31\n", "12.031"),
        ("name;measured;serial\nBORE_A;12.03;S1", "234\n", "12.03"),
        ("measured;name\n12.03;BORE", "_A\n", "12.03"),
    ] {
        let mut watched = Watched::new();
        let mut file = watched.open("a.csv", begun);
        // That it has no value yet is told.
        let early = watched.take(60_000).concat();
        assert!(!early.contains("GOOD") && !early.contains("BORE"), "{begun:?}: {early}");
        file.write_all(rest.as_bytes()).unwrap();
        assert_eq!(watched.take(150), [format!("a.csv BORE_A {value} GOOD")]);
        assert_eq!(watched.remarks, NOTHING);
    }
}

#[test]
fn half_a_line_behind_lines_without_a_value_is_not_waited_for_in_vain() {
    for (before, behind) in [("\r", "\nPIN;19.985"), ("\n", "\n\nPIN;19.985"), ("\n", "# comment\nPIN;19.985")] {
        let mut watched = Watched::new();
        watched.write("a.csv", &format!("{HEAD}BORE_A;12.03{before}"));
        assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD"]);
        watched.append("a.csv", behind);
        assert_eq!(watched.take(500), NOTHING, "{behind:?}");
        assert_eq!(watched.take(12_000), ["a.csv PIN 19.985 GOOD"], "{behind:?}");
        assert!(watched.take(500).is_empty() && watched.looked.as_ref().unwrap().is_idle(), "{behind:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn how_long_a_last_line_without_an_end_waits_is_by_what_is_known_of_its_writer() {
    let no_end = "the last line has no line end; it was imported as it is";
    let mut watched = Watched::new();
    watched.put("a.csv", &format!("{HEAD}BORE_A;12.03"));
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD"], "it got its name when it was complete");
    assert_eq!(watched.remarks, NOTHING);
    watched.write("b.csv", &format!("{HEAD}BORE_A;12.04"));
    assert_eq!(watched.take(2_000), NOTHING, "some close a file in the middle of a line");
    assert_eq!(watched.take(1_500), ["b.csv BORE_A 12.04 GOOD"]);
    assert_eq!(watched.remarks, [no_end]);
    watched.write("c.csv", &format!("{HEAD}BORE_A;12.05"));
    watched.restarted(0);
    assert_eq!(watched.take(9_000), NOTHING, "nobody knows who writes it");
    assert_eq!(watched.take(2_000), ["c.csv BORE_A 12.05 GOOD"]);
}

#[cfg(target_os = "linux")]
const DFQ: &str = "K0100 1\nK2001/1 1\nK2002/1 BORE_A\nK2101/1 12\nK2110/1 12.016\nK2111/1 12.059\nK2142/1 mm\n";

#[cfg(target_os = "linux")]
#[test]
fn a_value_of_aqdef_waits_for_what_is_said_of_it_and_what_comes_too_late_is_told() {
    let mut watched = Watched::new();
    let mut file = watched.open("a.dfq", &format!("{DFQ}K0001/1 12.03\n"));
    assert_eq!(watched.take(60_000), NOTHING, "its writer has it open");
    file.write_all(b"K0002/1 0\nK0001/1 12.04\n").unwrap();
    assert_eq!(watched.take(150), ["a.dfq BORE_A 12.03 GOOD"], "another value begins");
    file.write_all(b"K0002/1 0\n").unwrap();
    drop(file);
    assert_eq!(watched.take(1_100), ["a.dfq BORE_A 12.04 GOOD"]);
    watched.append("a.dfq", "K0014/1 S77\n");
    assert_eq!(watched.take(1_100), NOTHING);
    let late =
        "lines up to 12 add to values that were already imported, from line 10 on: check these values in the journal";
    assert_eq!(watched.remarks, [late]);
    assert!(watched.note("a.dfq").unwrap().contains(late));
    watched.append("a.dfq", "K0001/1 12.05\nK0002/1 0\n");
    assert_eq!(watched.take(1_100), ["a.dfq BORE_A 12.05 GOOD"]);
    assert!(watched.note("a.dfq").unwrap().contains(late), "it stays true");
    // One that is closed after each line.
    watched.write("b.dfq", &format!("{DFQ}K0001/1 12.03\n"));
    assert_eq!(watched.take(500), NOTHING);
    watched.append("b.dfq", "K0002/1 255\n");
    let said = watched.take(12_000).concat();
    assert!(said.contains("no value") && !said.contains("GOOD"), "{said}");
}

#[test]
fn a_file_that_was_seen_in_pieces_and_is_replaced_loses_no_leading_value() {
    for is_restarted in [false, true] {
        let mut watched = Watched::new();
        watched.write("r.csv", &format!("{HEAD}BORE_A;12.03\n"));
        watched.take(150);
        watched.append("r.csv", "PIN;19.99\n");
        assert_eq!(watched.take(150), ["r.csv PIN 19.99 GOOD"]);
        if is_restarted {
            watched.restarted(0);
            assert_eq!(watched.take(12_000), NOTHING);
        }
        watched.put("r.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.985\n"));
        assert_eq!(watched.take(150), ["r.csv BORE_A 12.03 GOOD", "r.csv PIN 19.985 GOOD"]);
        assert_eq!(watched.remarks, ["the file was rewritten and begins as before: one value imported again"]);
        // One without a line end that has fewer lines.
        watched.put("r.csv", &format!("{HEAD}BORE_A;12.04"));
        assert_eq!(watched.take(12_000), ["r.csv BORE_A 12.04 GOOD"]);
    }
}

#[test]
fn a_file_that_was_replaced_while_nobody_watched_says_what_of_it_is_taken() {
    let mut watched = Watched::new();
    watched.write("r.csv", &format!("{HEAD}BORE_A;12.03\n"));
    watched.take(150);
    watched.append("r.csv", "PIN;19.99\n");
    watched.take(150);
    watched.write("r.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.985\n"));
    watched.restarted(0);
    assert_eq!(watched.take(12_000), ["r.csv PIN 19.985 GOOD"]);
    let older = "a file of this name was imported later with other content; not imported again from the beginning of \
                 this one: one value";
    assert_eq!(std::mem::take(&mut watched.remarks), [older]);
    // Cut to its first lines: what it had as a whole is all that is known.
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.035\nPIN;19.99\n"));
    watched.take(150);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.035\n"));
    watched.restarted(0);
    assert_eq!(watched.take(4_000), ["a.csv BORE_A 12.035 GOOD"]);
    let other = "a file of this name was imported before and began differently; all of this one is imported";
    assert_eq!(watched.remarks, [other]);
}

#[test]
fn what_was_read_and_not_recorded_is_not_taken_for_known() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\nPIN;19.985\n"));
    assert_eq!([watched.look(0), watched.look(150)].concat().len(), 1, "and the journal is locked");
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    assert_eq!(watched.take(150), ["a.csv BORE_A 12.03 GOOD", "a.csv PIN 19.99 GOOD"]);
}

#[test]
fn of_the_same_content_under_two_names_one_is_taken_and_the_other_one_is_told() {
    let mut watched = Watched::new();
    let text = format!("{HEAD}BORE_A;12.03\n");
    for name in ["a.csv", "b.csv"] {
        watched.write(name, &text);
    }
    let mut taken = watched.take(150);
    taken.extend(watched.take(150));
    assert_eq!(taken.len(), 1, "{taken:?}");
    let (copy, known) = watched.same.first().cloned().unwrap();
    let said = format!("the same content was imported before as {known}; if a part was really measured again");
    assert!(watched.note(&copy).unwrap().contains(&said), "{:?}", watched.note(&copy));
    assert_eq!(watched.note(&known), None);
    // Its writer has written it again: that is told, and is no other part.
    watched.write(&known, &text);
    assert_eq!(watched.take(150), NOTHING);
    assert_eq!((watched.same.len(), watched.note(&known)), (2, None));
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_is_renamed_goes_on_under_its_new_name() {
    let mut watched = Watched::new();
    watched.write("log.csv", &format!("{HEAD}BORE_A;12.03\n"));
    watched.take(150);
    watched.append("log.csv", "PIN;19.99\n");
    rename(watched.path("log.csv"), watched.path("log_1.csv")).unwrap();
    watched.write("log.csv", HEAD);
    assert_eq!(watched.take(150), ["log_1.csv PIN 19.99 GOOD"]);
    watched.append("log.csv", "BORE_A;12.04\n");
    assert_eq!(watched.take(3_500), ["log.csv BORE_A 12.04 GOOD"]);
    // It is no copy, either.
    rename(watched.path("log_1.csv"), watched.path("done.csv")).unwrap();
    assert_eq!((watched.take(150).len(), watched.note("done.csv")), (0, None));
}

#[cfg(unix)]
#[test]
fn a_file_that_is_replaced_by_one_of_its_length_and_time_is_seen() {
    let mut watched = Watched::new();
    let time = std::time::SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(1_000_000_000);
    for value in ["12.03", "12.04"] {
        watched.write("new.tmp", &format!("{HEAD}BORE_A;{value}\n"));
        File::options().write(true).open(watched.path("new.tmp")).unwrap().set_modified(time).unwrap();
        rename(watched.path("new.tmp"), watched.path("a.csv")).unwrap();
        assert_eq!(watched.take(150), [format!("a.csv BORE_A {value} GOOD")]);
    }
}

#[test]
fn a_note_goes_when_it_is_no_longer_true() {
    let mut watched = Watched::new();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    watched.take(150);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.O3\n"));
    watched.take(12_000);
    assert!(watched.note("a.csv").is_some());
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(12_000), NOTHING, "it was taken before");
    assert_eq!(watched.note("a.csv"), None);
}

#[test]
fn verdicts_of_fitcheck_and_files_that_it_writes_are_left_alone() {
    let mut watched = Watched::new();
    let verdicts = "file,line,id,callout,nominal_mm,min_mm,max_mm,measured_mm\na.csv,2,BORE_A,,12,12,12.1,12.03\n";
    watched.write("v.csv", verdicts);
    for name in ["j.csv", "j.csv-wal"] {
        watched.write(name, &format!("{HEAD}BORE_A;12.03\n"));
    }
    watched.watcher.leave_journal(&watched.path("j.csv"));
    assert_eq!(watched.take(12_000), NOTHING);
    assert!(watched.note("v.csv").unwrap().contains("verdicts that Fitcheck wrote"));
    assert_eq!((watched.note("j.csv"), watched.note("j.csv-wal")), (None, None));
}

#[cfg(unix)]
#[test]
fn a_note_is_no_link_and_no_pipe() {
    let mut watched = Watched::new();
    let outside = tempfile::tempdir().unwrap();
    let [target, nothing] = ["diary.txt", "nothing.txt"].map(|name| outside.path().join(name));
    files::write(&target, b"Fitcheck is fine\n").unwrap();
    std::os::unix::fs::symlink(&target, watched.path("a.csv.why.txt")).unwrap();
    std::os::unix::fs::symlink(&nothing, watched.path("b.csv.why.txt")).unwrap();
    let pipe = std::process::Command::new("mkfifo").arg(watched.path("c.csv.why.txt")).status().unwrap();
    assert!(pipe.success());
    for (name, value) in [("a.csv", "12.O3"), ("b.csv", "12.O4"), ("c.csv", "12.03")] {
        watched.write(name, &format!("{HEAD}BORE_A;{value}\n"));
    }
    let ready = [watched.look(0), watched.look(12_000)].concat();
    assert_eq!(ready.len(), 3);
    for batch in &ready {
        let noted = watched.watcher.taken(batch, &|message| message.to_string());
        assert_eq!(noted.is_ok(), batch.name == "c.csv", "{noted:?}");
    }
    assert_eq!(std::fs::read_to_string(&target).unwrap(), "Fitcheck is fine\n");
    assert!(!nothing.exists());
}

/// The memory of a process is a file that cannot be read from its beginning.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_cannot_be_read_is_told_and_nobody_waits_for_it() {
    let mut watched = Watched::new();
    std::os::unix::fs::symlink("/proc/self/mem", watched.path("m.csv")).unwrap();
    watched.take(150);
    assert!(!watched.looked.as_ref().unwrap().is_idle(), "it may be held for a moment");
    watched.take(4_000);
    let look = watched.looked.as_ref().unwrap();
    assert!(look.is_idle() && matches!(look.waiting.as_slice(), [(_, Waiting::Refused { .. })]), "{look:?}");
    assert!(watched.note("m.csv").unwrap().contains("cannot be read"));
    std::fs::remove_file(watched.path("m.csv")).unwrap();
    watched.write("m.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(150), ["m.csv BORE_A 12.03 GOOD"]);
    assert_eq!(watched.note("m.csv"), None);
}

#[cfg(unix)]
#[test]
fn a_link_to_a_journal_leads_to_its_lock() {
    use fitcheck::watch::Alone;
    let folder = tempfile::tempdir().unwrap();
    let [journal, link] = ["j.sqlite", "k.sqlite"].map(|name| folder.path().join(name));
    files::write(&journal, b"").unwrap();
    std::os::unix::fs::symlink(&journal, &link).unwrap();
    let first = Alone::take(folder.path(), &journal).unwrap().unwrap();
    assert!(Alone::take(folder.path(), &link).unwrap().is_none());
    assert!(first.file().exists());
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text_are_not_one_name() {
    use std::os::unix::ffi::OsStrExt as _;
    let mut watched = Watched::new();
    for (name, rows) in [(b"\xff.csv", "BORE_A;12.03\n"), (b"\xfe.csv", "BORE_A;12.03\nPIN;19.99\n")] {
        let path = watched.path("x").with_file_name(std::ffi::OsStr::from_bytes(name));
        files::write(&path, format!("{HEAD}{rows}").as_bytes()).unwrap();
        assert_eq!(watched.take(150).len(), rows.lines().count(), "{rows:?}");
    }
}
