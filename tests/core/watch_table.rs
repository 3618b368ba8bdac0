//! The table of the manual's page on the watched folder, row by row.

use std::io::Write as _;

use fitcheck::watch::Waiting;

use crate::watching::{HEAD, Watched};

const NOTHING: [&str; 0] = [];

/// The description of a characteristic, as AQDEF has it.
const DFQ: &str = "K0100 1\nK2001/1 1\nK2002/1 BORE_A\nK2101/1 12\nK2110/1 12.016\nK2111/1 12.059\nK2142/1 mm\n";

/// What a row says of a file, and what shows that it is so.
type FileCase = (&'static str, fn(&mut Watched));

const ROWS: [FileCase; 10] = [
    ("is put there as a whole, or has complete lines", whole),
    ("does not mark its end (AQDEF, CALYPSO, contacts)", without_end),
    ("ends within a line, a log or a record", within_line),
    ("is replaced by other content", replaced),
    ("is rewritten with the same content, or copied", same),
    ("is truncated and rewritten with its earlier content", cut),
    ("is renamed after it was imported", renamed),
    ("adds lines to an AQDEF value that was imported already", late),
    ("Fitcheck itself writes there: output, journal, a CSV of verdicts", own),
    ("cannot be opened, or has a field that no journal takes", refused),
];

#[test]
fn the_table_of_the_manual_is_true_row_by_row() {
    let manual = include_str!("../../docs/manual/watch.md");
    let table = manual.lines().skip_while(|line| !line.starts_with("|---")).skip(1);
    let table = table.take_while(|line| line.starts_with('|'));
    let told: Vec<&str> = table.map(|row| row.split('|').nth(1).unwrap().trim()).collect();
    assert_eq!(told, ROWS.map(|(row, _)| row), "each row has its test");
    for (row, is_so) in ROWS {
        println!("{row}");
        is_so(&mut Watched::new());
    }
}

fn whole(watched: &mut Watched) {
    watched.put("a.csv", &format!("{HEAD}BORE_A;12.03"));
    watched.write("b.csv", &format!("{HEAD}BORE_A;12.04\n"));
    assert_eq!(watched.take(99), NOTHING);
    assert_eq!(watched.take(1), ["a.csv BORE_A 12.03 GOOD", "b.csv BORE_A 12.04 GOOD"]);
}

fn without_end(watched: &mut Watched) {
    let mut file = watched.open("a.dfq", &format!("{DFQ}K0001/1 12.03\n"));
    assert_eq!(watched.take(60_000), NOTHING, "its writer has it open");
    file.write_all(b"K0002/1 0\n").unwrap();
    drop(file);
    assert_eq!(watched.take(999), NOTHING);
    assert_eq!(watched.take(1), ["a.dfq BORE_A 12.03 GOOD"]);
    // Nobody says that it is closed.
    watched.write("b.dfq", &format!("{DFQ}K0001/1 12.04\n"));
    watched.restarted(0);
    assert_eq!(watched.take(9_999), NOTHING);
    assert_eq!(watched.take(1), ["b.dfq BORE_A 12.04 GOOD"]);
}

fn within_line(watched: &mut Watched) {
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.9"));
    assert_eq!(watched.take(100), ["a.csv BORE_A 12.03 GOOD"]);
    assert_eq!(watched.take(2_899), NOTHING);
    assert_eq!(watched.take(1).concat(), "a.csv PIN 19.9 SCRAP");
    let _open = watched.open("b.csv", &format!("{HEAD}BORE_A;12.04"));
    assert!(watched.take(60_000).iter().all(|said| !said.contains("12.04")), "its writer has it open");
}

fn replaced(watched: &mut Watched) {
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    watched.take(100);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.985\n"));
    assert_eq!(watched.take(100), ["a.csv BORE_A 12.03 GOOD", "a.csv PIN 19.985 GOOD"]);
    assert_eq!(watched.remarks, ["the file was rewritten and begins as before: one value imported again"]);
}

fn same(watched: &mut Watched) {
    let text = format!("{HEAD}BORE_A;12.03\n");
    watched.write("a.csv", &text);
    watched.take(100);
    for name in ["a.csv", "b.csv"] {
        watched.write(name, &text);
        assert_eq!(watched.take(100), NOTHING);
    }
    let said: Vec<String> = watched.same.iter().map(|(name, known)| format!("{name} is {known}")).collect();
    assert_eq!(said, ["a.csv is a.csv", "b.csv is a.csv"]);
    assert!(watched.note("a.csv").is_none() && watched.note("b.csv").is_some());
}

fn cut(watched: &mut Watched) {
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\nPIN;19.99\n"));
    watched.take(100);
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(100), NOTHING);
    watched.append("a.csv", "PIN;19.99\nPIN;19.985\n");
    assert_eq!(watched.take(100), ["a.csv PIN 19.985 GOOD"]);
}

fn renamed(watched: &mut Watched) {
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    watched.take(100);
    std::fs::rename(watched.path("a.csv"), watched.path("b.csv")).unwrap();
    watched.append("b.csv", "PIN;19.99\n");
    assert_eq!(watched.take(100), ["b.csv PIN 19.99 GOOD"]);
    assert_eq!((watched.same.len(), watched.note("b.csv")), (0, None), "it is no copy");
}

fn late(watched: &mut Watched) {
    watched.write("a.dfq", &format!("{DFQ}K0001/1 12.03\n"));
    assert_eq!(watched.take(1_000), ["a.dfq BORE_A 12.03 GOOD"]);
    watched.append("a.dfq", "K0014/1 S77\n");
    assert_eq!(watched.take(1_000), NOTHING);
    let lines = "lines up to 9 add to values that were already imported, from line 8 on";
    assert!(watched.remarks.concat().starts_with(lines), "{:?}", watched.remarks);
    assert!(watched.note("a.dfq").unwrap().contains(lines));
}

fn own(watched: &mut Watched) {
    let verdicts = "file,line,id,callout,nominal_mm,min_mm,max_mm,measured_mm\na.csv,2,BORE_A,,12,12,12.1,12.03\n";
    watched.write("v.csv", verdicts);
    watched.write("j.csv", &format!("{HEAD}BORE_A;12.03\n"));
    watched.watcher.leave_journal(&watched.path("j.csv"));
    watched.write("out.csv", &format!("{HEAD}BORE_A;12.04\n"));
    watched.watcher.leave(&watched.path("out.csv"));
    assert_eq!(watched.take(12_000), NOTHING);
}

/// The memory of a process is a file that cannot be read from its beginning. Fields that no journal takes are in `watch_cli`.
fn refused(watched: &mut Watched) {
    std::os::unix::fs::symlink("/proc/self/mem", watched.path("m.csv")).unwrap();
    watched.write("a.csv", &format!("{HEAD}BORE_A;12.03\n"));
    assert_eq!(watched.take(100), ["a.csv BORE_A 12.03 GOOD"]);
    watched.take(3_000);
    let look = watched.looked.as_ref().unwrap();
    assert!(matches!(look.waiting.as_slice(), [(_, Waiting::Refused { .. })]), "{look:?}");
    assert!(watched.note("m.csv").unwrap().contains("cannot be read"));
}
