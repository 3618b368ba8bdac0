//! The control's tables: the shipped ones against ISO 286, the samples, round trips, and everything that is wrong.
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::string_slice,
    clippy::disallowed_methods,
    reason = "a test may stop, and it writes small files that nobody else reads"
)]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use fitcheck::control::deviations::{read_folder, read_table, to_control_table};
use fitcheck::control::shipped_tables;
use fitcheck::control::table::{
    Column, Comment, CommentPlace, ControlTable, Generation, TableFile, TableUnit, WriteError,
};
use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::table::Column as ClassColumn;
use fitcheck::tolerance::{Callout, DeviationTable, Deviations, Feature, ToleranceClass};
use proptest::prelude::*;

const HOLE_CLASSES: &str = "D10 E9 F7 F8 G7 G9 H6 H7 H8 H9 H11 H12 H13 JS7 JS9 K6 K7 M6 M7 N7 N9 P7 P9 R7";
const SHAFT_CLASSES: &str = "d9 e8 f7 g6 h5 h6 h7 h8 h9 h11 js5 js6 js13 js14 k5 k6 m5 m6 n6 p6 r6 s6 s7";
const ENDS: [&str; 21] = [
    "1", "3", "6", "10", "18", "30", "50", "65", "80", "100", "120", "140", "160", "180", "200", "225", "250", "280",
    "315", "355", "400",
];

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn um(text: &str) -> Length {
    Length::parse_in(text, Unit::Micrometre).unwrap()
}

/// A row of `limits_47_classes.csv`.
struct Published {
    class: String,
    over: Length,
    to: Length,
    deviations: Deviations,
}

fn published() -> Vec<Published> {
    let mut reader = csv::Reader::from_path(root("tests/data/iso286/limits_47_classes.csv")).unwrap();
    let rows = reader.records().map(|record| {
        let record = record.unwrap();
        Published {
            class: record[0].to_owned(),
            over: mm(&record[1]),
            to: mm(&record[2]),
            deviations: Deviations::new(um(&record[3]), um(&record[4])).unwrap(),
        }
    });
    rows.collect()
}

/// The published deviations for all sizes over `over` up to `to`: one pair for the whole range, or none.
fn published_for(rows: &[Published], class: &str, over: Length, to: Length) -> Option<Deviations> {
    let within = rows.iter().filter(|row| row.class == class && row.over < to && over < row.to);
    let found: Vec<Deviations> = within.map(|row| row.deviations).collect();
    for pair in &found {
        assert_eq!(*pair, found[0], "{class} over {over} to {to} needs a finer range");
    }
    found.first().copied()
}

/// The table that the standard's figures make.
fn table_of_the_standard(name: &str, classes: &str) -> DeviationTable {
    let rows = published();
    let ends: Vec<Length> = ENDS.iter().map(|end| mm(end)).collect();
    let columns = classes.split(' ').map(|class| {
        let mut over = Length::ZERO;
        let cells = ends.iter().map(|&to| {
            let cell = published_for(&rows, class, over, to);
            over = to;
            cell
        });
        ClassColumn { class: class.parse().unwrap(), cells: cells.collect() }
    });
    DeviationTable::new(name, true, ends.clone(), columns.collect()).unwrap()
}

/// `UPDATE_TABLES=1 cargo test shipped_tables` writes the files anew.
#[test]
fn the_shipped_tables_are_what_the_writer_makes_of_the_standard() {
    for (name, classes) in [("82553_hole.tab", HOLE_CLASSES), ("82553_shaft.tab", SHAFT_CLASSES)] {
        let written = to_control_table(&table_of_the_standard(name, classes), Generation::Structure).write().unwrap();
        let path = root("tables").join(name);
        if std::env::var_os("UPDATE_TABLES").is_some() {
            fitcheck::files::write(&path, &written).unwrap();
        }
        let shipped = std::fs::read(&path).unwrap();
        assert!(shipped == written, "{name} is not what the standard says: run UPDATE_TABLES=1 cargo test");
    }
}

#[test]
fn every_cell_of_the_shipped_tables_is_the_standards_and_nothing_is_more_or_less() {
    let tables = shipped_tables();
    let names: Vec<&str> = tables.iter().map(DeviationTable::name).collect();
    assert_eq!(names, ["82553_hole.tab", "82553_shaft.tab"]);
    let rows = published();
    let published_classes: BTreeSet<&str> = rows.iter().map(|row| row.class.as_str()).collect();
    let mut shipped_classes = BTreeSet::new();
    let (mut cells, mut empty) = (0, Vec::new());
    for (table, classes) in tables.iter().zip([HOLE_CLASSES, SHAFT_CLASSES]) {
        assert!(table.shipped());
        assert_eq!(table.ends(), ENDS.map(mm));
        let order: Vec<&str> = table.columns().iter().map(|column| column.class.as_str()).collect();
        assert_eq!(order.join(" "), classes);
        shipped_classes.extend(classes.split(' '));
        for column in table.columns() {
            let mut over = Length::ZERO;
            for (&to, cell) in table.ends().iter().zip(&column.cells) {
                let class = column.class.as_str();
                assert_eq!(*cell, published_for(&rows, class, over, to), "{class} over {over} up to {to}");
                if cell.is_none() {
                    empty.push(format!("{class} over {over} up to {to}"));
                }
                over = to;
                cells += 1;
            }
        }
    }
    assert_eq!(shipped_classes, published_classes);
    assert_eq!(cells, 47 * 21);
    assert_eq!(empty, ["N9 over 0 up to 1", "js14 over 0 up to 1"]);
}

/// The same without the program's reader: the bytes by eye, so to speak.
#[test]
fn the_shipped_files_are_laid_out_for_an_itnc_530() {
    for (name, columns) in [("82553_hole.tab", 26), ("82553_shaft.tab", 25)] {
        let text = std::fs::read_to_string(root("tables").join(name)).unwrap();
        assert!(text.is_ascii() && text.starts_with(&format!("BEGIN {name}\r\n#STRUCTBEGIN\r\n")));
        assert!(text.ends_with("\r\n[END]\r\n"));
        assert_eq!(text.matches('\n').count(), text.matches("\r\n").count());
        assert!(text.lines().all(|line| line.len() <= 200));
        let rows: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("NR ")).collect();
        assert_eq!(rows[0].split_whitespace().count(), columns);
        assert_eq!(rows.len(), 1 + 42 + 1);
    }
    let hole = std::fs::read_to_string(root("tables/82553_hole.tab")).unwrap();
    // Up to 10 mm: JS7 is +7.5 and -7.5, and the lower row leaves BEREICH blank.
    let row = |number: &str| hole.lines().find(|line| line.starts_with(&format!("{number} "))).unwrap();
    assert_eq!(row("6").split_whitespace().collect::<Vec<_>>()[..3], ["6", "10", "+98"]);
    assert_eq!(row("7").split_whitespace().collect::<Vec<_>>()[..2], ["7", "+40"]);
    assert!(row("6").contains("+7.5 ") && row("7").contains("-7.5 "));
}

#[track_caller]
fn check_limits(callout: &str, expected: &str) {
    let said = match callout.parse::<Callout>().map(|callout| shipped_tables().limits(&callout)) {
        Ok(Ok(limits)) => format!(
            "{} / {}",
            limits.deviations.upper().exact(Unit::Micrometre, 0),
            limits.deviations.lower().exact(Unit::Micrometre, 0)
        ),
        Ok(Err(error)) => error.to_string(),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected, "for {callout}");
}

/// `facts/heidenhain.md` 1.5.
#[test]
fn the_lookup_answers_its_test_points() {
    check_limits("3 K7", "0 / -10");
    check_limits("3.0001 K7", "3 / -9");
    check_limits("3 k6", "6 / 0");
    check_limits("6.0001 k6", "10 / 1");
    check_limits("10 H7", "15 / 0");
    check_limits("10.0001 H7", "18 / 0");
    check_limits("8 JS7", "7.5 / -7.5");
    check_limits("25 D10", "149 / 65");
    check_limits("50 R7", "-25 / -50");
    check_limits("50.0001 R7", "-30 / -60");
    check_limits("65.0001 R7", "-32 / -62");
    check_limits("120 s7", "114 / 79");
    check_limits("120.0001 s7", "132 / 92");
    check_limits("180.0001 r6", "106 / 77");
    check_limits("400 H13", "890 / 0");
}

#[test]
fn the_lookup_changes_range_within_one_nanometre() {
    check_limits("2.999999 K7", "0 / -10");
    check_limits("3.000000 K7", "0 / -10");
    check_limits("3.000001 K7", "3 / -9");
    check_limits("0.000001 H7", "10 / 0");
    check_limits("1.000001 N9", "-4 / -29");
    check_limits("400.000000 H7", "57 / 0");
    check_limits(
        "400.000001 H7",
        "nominal size 400.000001 mm is beyond table 82553_hole.tab, whose last range is over 355 up to and \
         including 400 mm",
    );
}

#[test]
fn the_lookup_refuses_in_words_that_tell_the_way_out() {
    check_limits("0 H7", "nominal size 0 mm is not above 0");
    check_limits("-5 H7", "nominal size -5 mm is not above 0");
    check_limits("25 H10", &format!("H10 is not in table 82553_hole.tab; it has {HOLE_CLASSES}"));
    check_limits("25 z9", &format!("z9 is not in table 82553_shaft.tab; it has {SHAFT_CLASSES}"));
    check_limits("25 G6", "G6 is a hole class and table 82553_hole.tab does not have it; the shaft class is g6");
    check_limits(
        "1 N9",
        "N9 is not defined over 0 up to 1 mm in table 82553_hole.tab; it is defined over 1 up to 400 mm",
    );
}

/// `spot_checks.csv` asks for all of ISO 286; the tables hold 47 classes up to 400 mm and must refuse the rest.
#[test]
fn the_shipped_tables_agree_with_the_spot_checks_as_far_as_they_go() {
    let tables = shipped_tables();
    let mut reader = csv::Reader::from_path(root("tests/data/iso286/spot_checks.csv")).unwrap();
    let (mut agreed, mut refused) = (0, 0);
    for record in reader.records() {
        let record = record.unwrap();
        let callout: Callout = record[0].parse().unwrap();
        let class = callout.class().to_string();
        let is_ours = HOLE_CLASSES.split(' ').chain(SHAFT_CLASSES.split(' ')).any(|ours| ours == class);
        let is_refused = !is_ours || mm("400") < callout.nominal() || !record[3].is_empty();
        match tables.limits(&callout) {
            Err(_) if is_refused => refused += 1,
            Ok(limits) if !is_refused => {
                assert_eq!(limits.deviations.lower(), um(&record[1]), "{callout}");
                assert_eq!(limits.deviations.upper(), um(&record[2]), "{callout}");
                agreed += 1;
            }
            other => panic!("{callout}: {other:?}"),
        }
    }
    // 400.5 H7 and 26 S7 are published, but not in the tables; eight callouts are refused by the standard, too.
    assert_eq!((agreed, refused), (26, 10));
}

fn sample(name: &str) -> Vec<u8> {
    std::fs::read(root("tests/data/samples/tables").join(name)).unwrap()
}

fn read_sample(name: &str) -> (DeviationTable, Vec<String>) {
    let (table, warnings) = read_table(&sample(name), name, name, false).unwrap();
    (table.unwrap(), warnings.iter().map(ToString::to_string).collect())
}

#[track_caller]
fn check_cell(table: &DeviationTable, callout: &str, upper: &str, lower: &str) {
    let tables = fitcheck::tolerance::Tables::shipped(vec![table.clone()]);
    let limits = tables.limits(&callout.parse().unwrap()).unwrap();
    assert_eq!((limits.deviations.upper(), limits.deviations.lower()), (um(upper), um(lower)), "{callout}");
}

/// Values of `tests/data/samples/README.md`.
#[test]
fn the_sample_tables_are_read_to_the_values_of_their_list() {
    let (plain, warnings) = read_sample("generation1_plain.tab");
    assert_eq!(warnings, [""; 0]);
    assert_eq!(plain.to_string(), "generation1_plain.tab (4 classes, 5 size ranges)");
    check_cell(&plain, "10 JS7", "7.5", "-7.5");
    check_cell(&plain, "6 N7", "-4", "-16");
    check_cell(&plain, "30 U1", "12", "5");
    let own = plain.columns().iter().find(|column| column.class.as_str() == "U1").unwrap();
    let defined: Vec<bool> = own.cells.iter().map(Option::is_some).collect();
    assert_eq!(defined, [false, true, true, false, true]);

    let (structure, warnings) = read_sample("generation2_struct.tab");
    assert_eq!(warnings, [""; 0]);
    check_cell(&structure, "18 p6", "29", "18");

    let (description, warnings) = read_sample("generation3_description.tab");
    assert_eq!(warnings, [""; 0]);
    check_cell(&description, "30 K7", "6", "-15");

    let (comma, warnings) = read_sample("decimal_comma_latin1_crlf.tab");
    assert_eq!(warnings, [""; 0]);
    assert_eq!(comma.columns().len(), 2, "REMARK is no class");
    check_cell(&comma, "10 JS7", "7.5", "-7.5");
    check_cell(&comma, "30 JS7", "10.5", "-10.5");

    let (alias, warnings) = read_sample("alias_bereik_no_end.tab");
    assert_eq!(
        warnings,
        [
            "[END] is missing: alias_bereik_no_end.tab, line 12, column 1",
            "BEREIK was read as BEREICH: alias_bereik_no_end.tab, line 2, column 9",
        ]
    );
    check_cell(&alias, "18 H7", "18", "0");
}

#[test]
fn the_parts_of_a_table_are_kept() {
    let read = |name: &str| ControlTable::read(&sample(name), name).unwrap().table;
    let plain = read("generation1_plain.tab");
    assert_eq!((plain.name.as_str(), plain.suffix.as_deref(), plain.unit), ("fit_hole_g1", Some("tab"), None));
    assert_eq!(plain.comments[0].text, " small hole table for parser tests, deviations in micrometres");
    assert_eq!(plain.columns.iter().map(|column| column.width).collect::<Vec<_>>(), [8, 8, 7, 7, 7, 7]);
    let description = read("generation3_description.tab");
    assert_eq!(description.unit, Some(TableUnit::Millimetre));
    assert_eq!(description.version.as_deref(), Some("Update:110.24"));
    assert_eq!(description.properties, [("primaryKey".to_owned(), "\"NR\"".to_owned())]);
    assert_eq!(description.columns[0].kind.as_deref(), Some("INT"));
    assert_eq!(description.columns[0].settings[0], ("initial".to_owned(), "\"+0\"".to_owned()));
    let comma = read("decimal_comma_latin1_crlf.tab");
    assert_eq!(comma.columns[1].settings[1].1, "Maßbereich bis einschließlich?");
    assert_eq!(comma.rows[1][4], "untere Größe");
    let probes = read("tchprobe.tp");
    assert_eq!((probes.suffix.as_deref(), probes.rows.len()), (Some("TP"), 2));
    assert_eq!(probes.rows[1][probes.column("F_PREPOS").unwrap()], "FMAX_MACHINE");
}

#[track_caller]
fn check_begin(line: &str, expected: &str) {
    let text = format!("{line}\nA B\n1 2\n[END]\n");
    let said = match ControlTable::read(text.as_bytes(), "x.tab") {
        Ok(TableFile { table, .. }) => format!(
            "{} {} {} {} {}",
            table.name,
            table.suffix.as_deref().unwrap_or("-"),
            table.unit.map_or("-".to_owned(), |unit| format!("{unit:?}")),
            table.version.as_deref().unwrap_or("-"),
            table.mark.as_deref().unwrap_or("-"),
        ),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected, "for {line:?}");
}

/// The forms of `facts/heidenhain.md` 2.2.
#[test]
fn every_seen_form_of_the_begin_line_is_read() {
    check_begin("BEGIN 8150-1-en.tab", "8150-1-en tab - - -");
    check_begin("BEGIN CCMT.CUT MM", "CCMT CUT Millimetre - -");
    check_begin("BEGIN TOOL.T INCH", "TOOL T Inch - -");
    check_begin(
        "BEGIN TOOL.T MM Version: 'Update:120.17 Date:2004-08-01'",
        "TOOL T Millimetre Update:120.17 Date:2004-08-01 -",
    );
    check_begin("BEGIN TOOL.T MM VERSION: 'Update:1.2' U", "TOOL T Millimetre Update:1.2 U");
    check_begin("BEGIN TOOL.T MM U", "TOOL T Millimetre - U");
    check_begin("BEGIN Test.AFC.TAB MM", "Test.AFC TAB Millimetre - -");
    check_begin("BEGIN SIMTOOLT_M MM", "SIMTOOLT_M - Millimetre - -");
    check_begin("BEGIN FRAES_GB.CDT ", "FRAES_GB CDT - - -");
    check_begin("BEGIN pal2sp .p ", "pal2sp p - - -");
    check_begin("BEGIN", "the name of the table is missing behind BEGIN: x.tab, line 1, column 6");
    check_begin("BEGIN x.tab Version: 'a", "a quotation mark is not closed: x.tab, line 1, column 24");
    check_begin("BEGIN x.tab Version: a", "' is due here, not a: x.tab, line 1, column 1");
    check_begin(
        "BEGINNING x.tab",
        "a table begins with BEGIN and its name, not with BEGINNING x.tab: x.tab, line 1, column 1",
    );
}

/// A small table as text, to be broken.
const SOUND: &str = "\
BEGIN own.tab
NR  BEREICH H7     U1
0   3       +10    +8
1           +0     +3
2   6       +12    -
3           +0     -
[END]
";

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    check_bytes(text.as_bytes(), expected);
}

/// What is said about a table: its warnings, or its error behind a `!`.
#[track_caller]
fn check_bytes(bytes: &[u8], expected: &[&str]) {
    let said: Vec<String> = match read_table(bytes, "own.tab", "own.tab", false) {
        Ok((table, warnings)) => {
            assert!(table.is_some() || !warnings.is_empty());
            warnings.iter().map(ToString::to_string).collect()
        }
        Err(error) => vec![format!("! {error}")],
    };
    assert_eq!(said, expected, "for {:?}", String::from_utf8_lossy(&bytes[..bytes.len().min(400)]));
}

#[test]
fn a_table_is_the_same_whatever_its_encoding_and_line_ends() {
    let read = |bytes: &[u8]| ControlTable::read(bytes, "own.tab").unwrap();
    let german = SOUND.replace("BEGIN own.tab\n", "BEGIN own.tab\n; Größe\n");
    let sound = read(german.as_bytes());
    for end in ["\r\n", "\r", "\0"] {
        assert_eq!(read(german.replace('\n', end).as_bytes()), sound, "{end:?}");
    }
    let mut marked = b"\xef\xbb\xbf".to_vec();
    marked.extend(german.as_bytes());
    assert_eq!(read(&marked), sound);
    let latin: Vec<u8> = german.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    assert_eq!(read(&latin), sound);
    let (comma, _) = read_table(SOUND.replace("+12 ", "+12,50").as_bytes(), "own.tab", "own.tab", false).unwrap();
    check_cell(&comma.unwrap(), "6 H7", "12.5", "0");
}

#[test]
fn comments_blank_lines_and_a_bare_end_are_no_rows() {
    check(&SOUND.replace("2   6", ";2   5       +99    x\n\n   \n2   6"), &[]);
    check(&SOUND.replace("[END]", "END"), &[]);
    check(&SOUND.replace("[END]\n", "[END]\n\n  \n"), &[]);
}

#[test]
fn a_missing_end_is_a_warning() {
    check(&SOUND.replace("[END]\n", ""), &["[END] is missing: own.tab, line 6, column 1"]);
    // A blank behind the last cell: it is whole, too.
    let padded = SOUND.replace("+8\n", "+8     \n").replace("+3\n", "+3     \n").replace("-\n", "-      \n");
    check(padded.trim_end_matches("\n[END]\n"), &["[END] is missing: own.tab, line 6, column 1"]);
    let unpadded = SOUND.trim_end_matches("\n[END]\n");
    check(
        unpadded,
        &["! the file ends within this row and without [END]: it may be cut off: own.tab, line 6, column 1"],
    );
}

#[test]
fn empty_files_and_other_files_are_refused() {
    check("", &["! the file is empty: own.tab, line 1, column 1"]);
    check(" \r\n\0\n", &["! the file is empty: own.tab, line 1, column 1"]);
    check_bytes(b"\xef\xbb\xbf", &["! the file is empty: own.tab, line 1, column 1"]);
    check_bytes(
        b"\x7fELF\x02\x01\x01",
        &["! character U+007F is no text: this is not a table or it is damaged: own.tab, line 1, column 1"],
    );
    check_bytes(
        b"\x89PNG\r\n\x1a\n",
        &["! a table begins with BEGIN and its name, not with \u{2030}PNG: own.tab, line 1, column 1"],
    );
    check(
        "id;callout;measured\n",
        &["! a table begins with BEGIN and its name, not with id;callout;measured: own.tab, line 1, column 1"],
    );
    check(
        &SOUND.replace("+12", "+\u{1}2"),
        &["! character U+0001 is no text: this is not a table or it is damaged: own.tab, line 5, column 14"],
    );
    check("BEGIN x.tab\n", &["! the line with the names of the columns is missing: own.tab, line 2, column 1"]);
    check("BEGIN x.tab\n[END]\n", &["! the line with the names of the columns is missing: own.tab, line 2, column 1"]);
}

#[test]
fn a_truncated_table_is_refused() {
    // Cut within +12, which would read as +1.
    check(
        &SOUND[..SOUND.find("+12").unwrap() + 2],
        &[
            "! the row ends before column U1: fill it up with blanks, or write - for no value: own.tab, line 5, column 15",
        ],
    );
    // Cut within the last column: +25 would read as +2.
    let long = SOUND.replace("-\n3  ", "+25\n3  ");
    check(
        &long[..long.find("+25").unwrap() + 2],
        &["! the file ends within this row and without [END]: it may be cut off: own.tab, line 5, column 1"],
    );
    // Cut between two rows of a pair.
    check(
        &SOUND[..SOUND.find("3           +0     -").unwrap()],
        &[
            "! the number of rows is odd, 3: each size range takes two: upper deviation, lower deviation: own.tab, line 5, column 1",
        ],
    );
    check(
        "BEGIN x.tab\n#STRUCTBEGIN\n  NAME = H7\n",
        &["! the block #STRUCTBEGIN of line 2 is not closed: own.tab, line 3, column 1"],
    );
    check(
        "BEGIN x.tab\nTableDescription (\n columns:= [\n",
        &["! the block TableDescription of line 2 is not closed: own.tab, line 3, column 1"],
    );
}

#[test]
fn broken_rows_and_columns_are_refused() {
    check(&SOUND.replace("U1", "H7"), &["! column H7 occurs twice: own.tab, line 2, column 20"]);
    check(
        &SOUND.replace("2   6       +12    -", "2   6       +12"),
        &[
            "! the row ends before column U1: fill it up with blanks, or write - for no value: own.tab, line 5, column 16",
        ],
    );
    check(&SOUND.replace("+12", "+1x"), &["! column H7: +1x is not a number: own.tab, line 5, column 13"]);
    check(&SOUND.replace("+12 ", "12mm"), &["! column H7: 12mm is not a number: own.tab, line 5, column 13"]);
    check(
        &SOUND.replace("+12    ", "1.234,5"),
        &["! column H7 and its neighbour run into each other: keep them apart by a blank: own.tab, line 5, column 13"],
    );
    check(
        &SOUND.replace("+12    ", "1.23,5 "),
        &[
            "! column H7: 1.23,5 is ambiguous: write one decimal sign and no thousands separator: own.tab, line 5, column 13",
        ],
    );
    check(
        &SOUND.replace("+12    ", "0.0005 "),
        &["! column H7: 0.0005 is finer than a nanometre: own.tab, line 5, column 13"],
    );
    check(&SOUND.replace("   6   ", "   six "), &["! column BEREICH: six is not a number: own.tab, line 5, column 5"]);
    check(
        &SOUND.replace("2   6", "2\t6"),
        &["! a tab stands here: only blanks keep columns apart: own.tab, line 5, column 2"],
    );
    check(&SOUND.replace("[END]", "[END]\n4   10"), &["! text behind [END]: 4   10: own.tab, line 8, column 1"]);
    // One place too far to the left: the sign would be lost and -5 read as 5.
    check(
        &SOUND.replace("+0     +3", "+0    -5 "),
        &["! column H7 and its neighbour run into each other: keep them apart by a blank: own.tab, line 4, column 13"],
    );
}

#[test]
fn broken_ranges_and_pairs_are_refused() {
    check(
        &SOUND.replace("2   6", "2   3"),
        &["! size range up to 3 mm does not end above the one before it, 3 mm: own.tab, line 5, column 5"],
    );
    check(
        &SOUND.replace("0   3", "0   0"),
        &["! size range up to 0 mm does not end above the one before it, 0 mm: own.tab, line 3, column 5"],
    );
    check(&SOUND.replace("2   6", "2    "), &["! the end of the size range is missing: own.tab, line 5, column 5"]);
    check(
        &SOUND.replace("3           +0     -", "3   5       +0     -"),
        &[
            "! the size range up to 6 mm has 5 in its second row: repeat it or leave it blank: own.tab, line 6, column 5",
        ],
    );
    check(&SOUND.replace("3           +0     -", "3   6       +0     -"), &[]);
    check(
        &SOUND.replace("+3\n", "  \n"),
        &["! column U1 has only one of the two deviations for the size range up to 3 mm: own.tab, line 4, column 20"],
    );
    check(
        &SOUND.replace("+12    -", "+12    -1"),
        &["! column U1 has only one of the two deviations for the size range up to 6 mm: own.tab, line 6, column 20"],
    );
    check(
        &SOUND.replace("+3\n", "+9\n"),
        &["! column U1: upper deviation 0.008 mm is below lower deviation 0.009 mm: own.tab, line 4, column 20"],
    );
    check("BEGIN x.tab\nNR BEREICH H7\n[END]\n", &["! the table has no size range: own.tab, line 2, column 4"]);
    check(
        &SOUND.replace("own.tab", "own.tab INCH"),
        &[
            "! the table is in inch: write size ranges in millimetres and deviations in micrometres: own.tab, line 2, column 5",
        ],
    );
    check(
        &SOUND.replace("U1", "BEREIK"),
        &["! BEREICH and BEREIK are both there: only one can hold the size ranges: own.tab, line 2, column 20"],
    );
    check(
        &SOUND.replace("H7", "HX").replace("U1", "UX"),
        &["! no column is a tolerance class such as H7: own.tab, line 2, column 5"],
    );
}

#[test]
fn other_columns_are_left_alone() {
    check(&SOUND.replace("U1", "NOTE"), &[]);
    check(
        &SOUND.replace("+8\n", "ab\n").replace("+3\n", "cd\n"),
        &["column U1 holds no numbers and was skipped: own.tab, line 2, column 20"],
    );
    check(
        &SOUND.replace("U1", "Js7"),
        &[
            "column Js7 mixes upper and lower case, so it is no tolerance class and was skipped: own.tab, line 2, column 20",
        ],
    );
    check(
        &SOUND.replace("BEREICH", "RANGE  "),
        &["no table of deviations, for it has no column BEREICH; skipped: own.tab"],
    );
    let both = SOUND.replace("U1", "h7");
    let (table, _) = read_table(both.as_bytes(), "own.tab", "own.tab", false).unwrap();
    let tables = fitcheck::tolerance::Tables::shipped(vec![table.unwrap()]);
    assert_eq!((tables.classes(Feature::Hole).len(), tables.classes(Feature::Shaft).len()), (1, 1));
}

#[test]
fn blocks_are_checked_against_the_line_of_names() {
    let structure = |block: &str| SOUND.replace("NR  BER", &format!("#STRUCTBEGIN\n{block}#STRUCTEND\nNR  BER"));
    let names = "NAME = BEREICH\nWIDTH = 3\nNAME = H7\nWIDTH = 6\nNAME = U1\nWIDTH = 6\n";
    check(&structure(names), &[]);
    check(
        &structure(&names.replace("H7\nWIDTH = 6", "H7\nWIDTH = 5")),
        &[
            "column H7 is 7 characters wide here but 6 in the description; the names decide: own.tab, line 10, column 13",
        ],
    );
    check(
        &structure("NAME = BEREICH\nNAME = H7\nNAME = H8\n"),
        &[
            "column U1 is not described: own.tab, line 7, column 20",
            "column H8 is described but not in the table: own.tab, line 7, column 1",
        ],
    );
    check(
        &structure("NAME = H7\n  WIDTH = six\n"),
        &["! WIDTH is a whole number up to 10000, not six: own.tab, line 4, column 3"],
    );
    check(&structure("NAME = H7\nNAME = H7\n"), &["! column H7 occurs twice: own.tab, line 4, column 1"]);
    check(&structure("NAME\n"), &["! = is due here, not NAME: own.tab, line 3, column 1"]);
    check(&structure("TYPE = N\n"), &["! NAME = is due here, not TYPE = N: own.tab, line 3, column 1"]);
    check(
        &SOUND.replace("NR  BER", "#STRUCTBEGIN\n#STRUCTEND\nTableDescription (\n)\nNR  BER"),
        &["! the columns are described a second time: own.tab, line 4, column 1"],
    );
    let description = |block: &str| SOUND.replace("NR  BER", &format!("TableDescription ({block}\n)\nNR  BER"));
    let h7 = "CfgColumnDescription (key:=\"H7\", width:=7, unit:=FLOAT)";
    check(
        &description(&format!(" columns:=[ {h7}, CfgTableProperties ( a:=[ 1 ] ) ]")),
        &[
            "CfgTableProperties is unknown and was skipped: own.tab, line 2, column 108",
            "column BEREICH is not described: own.tab, line 4, column 5",
            "column U1 is not described: own.tab, line 4, column 20",
        ],
    );
    check(&description(" columns:= 7"), &["! [ is due here, not 7: own.tab, line 2, column 30"]);
    check(&description(" a:=\"7"), &["! a quotation mark is not closed: own.tab, line 2, column 23"]);
    check(&description(" a=7"), &["! := is due here, not =7: own.tab, line 2, column 21"]);
    check(&description(&" [".repeat(1000)), &["! ) is due here, not [: own.tab, line 2, column 20"]);
}

#[test]
fn large_files_are_refused_before_they_fill_the_memory() {
    let rows = "BEGIN x.tab\nA B\n".to_owned() + &"1 2\n".repeat(600_000);
    check(&rows, &["! the table has more than 1000000 cells: own.tab, line 500002, column 1"]);
    let comments = "BEGIN x.tab\nA B\n".to_owned() + &";\n".repeat(1_100_000);
    check(&comments, &["! the table has more than 1000000 cells: own.tab, line 1000001, column 1"]);
    let columns: String = (0..1001).map(|number| format!(" C{number}")).collect();
    check(&format!("BEGIN x.tab\n{columns}\n"), &["! the table has more than 1000 columns: own.tab, line 2, column 1"]);
    check(
        &format!("BEGIN x.tab\n{}\n", "A".repeat(65_537)),
        &["! the line is longer than 65536 bytes: own.tab, line 2, column 1"],
    );
}

#[test]
fn a_folder_is_read_by_name_and_every_message_names_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let said = || match read_folder(folder.path()) {
        Ok(own) => {
            let tables = own.tables.iter().map(ToString::to_string);
            tables.chain(own.warnings.iter().map(ToString::to_string)).collect::<Vec<_>>()
        }
        Err(error) => vec![error.to_string()],
    };
    let shown = |name: &str| at(name).display().to_string();
    let none =
        format!("no table of deviations (*.tab with a column BEREICH) in this folder: {}", folder.path().display());
    assert_eq!(said(), [none.as_str()]);
    std::fs::write(at("tool.tab"), "BEGIN TOOL.TAB MM\nT NAME\n1 DRILL\n[END]\n").unwrap();
    assert_eq!(said(), [none.as_str()]);
    std::fs::write(at("b.TAB"), SOUND).unwrap();
    std::fs::write(at("a.tab"), SOUND.replace("[END]\n", "")).unwrap();
    std::fs::write(at("notes.txt"), "not a table").unwrap();
    std::fs::create_dir(at("folder.tab")).unwrap();
    assert_eq!(
        said(),
        [
            "a.tab (2 classes, 2 size ranges)".to_owned(),
            "b.TAB (2 classes, 2 size ranges)".to_owned(),
            format!("[END] is missing: {}, line 6, column 1", shown("a.tab")),
            format!("no table of deviations, for it has no column BEREICH; skipped: {}", shown("tool.tab")),
        ]
    );
    std::fs::write(at("c.tab"), SOUND.replace("+12", "x12")).unwrap();
    assert_eq!(said(), [format!("column H7: x12 is not a number: {}, line 5, column 13", shown("c.tab"))]);
    let missing = read_folder(&at("none")).unwrap_err().to_string();
    assert_eq!(missing, format!("no such file or folder: {}", shown("none")));
}

const GENERATIONS: [Generation; 3] = [Generation::Plain, Generation::Structure, Generation::Description];

#[test]
fn reading_writing_and_reading_again_gives_the_same_table() {
    let folder = root("tests/data/samples/tables");
    let shipped = root("tables");
    for name in ["82553_hole.tab", "82553_shaft.tab"] {
        let bytes = std::fs::read(shipped.join(name)).unwrap();
        let table = ControlTable::read(&bytes, name).unwrap().table;
        assert!(table.write().unwrap() == bytes, "{name} changes its bytes");
    }
    let files = std::fs::read_dir(folder).unwrap().chain(std::fs::read_dir(shipped).unwrap());
    let mut count = 0;
    for path in files.map(|entry| entry.unwrap().path()).filter(|path| !path.ends_with(".gitattributes")) {
        let name = path.display().to_string();
        let table = ControlTable::read(&std::fs::read(&path).unwrap(), &name).unwrap().table;
        let again = ControlTable::read(&table.write().unwrap(), &name).unwrap();
        assert_eq!(again.table, table, "{name}");
        for generation in GENERATIONS {
            let converted = table.to_generation(generation);
            let again = ControlTable::read(&converted.write().unwrap(), &name).unwrap();
            assert_eq!(again.warnings, [], "{name}");
            assert_eq!(again.table, converted, "{name}");
            assert_eq!(again.table.rows, table.rows, "{name}");
        }
        count += 1;
    }
    assert_eq!(count, 8);
}

#[test]
fn deviations_survive_all_three_generations() {
    for table in shipped_tables().iter() {
        for generation in GENERATIONS {
            let bytes = to_control_table(table, generation).write().unwrap();
            let (again, warnings) = read_table(&bytes, table.name(), "x", true).unwrap();
            assert_eq!(warnings, []);
            assert_eq!(&again.unwrap(), table);
        }
    }
}

fn table_of(names: &[&str], rows: &[&[&str]]) -> ControlTable {
    ControlTable {
        name: "own".to_owned(),
        suffix: Some("tab".to_owned()),
        unit: None,
        version: None,
        mark: None,
        generation: Generation::Plain,
        columns: names.iter().map(|name| Column::plain(name, 7.max(name.chars().count() + 1))).collect(),
        properties: Vec::new(),
        rows: rows.iter().map(|row| row.iter().map(|cell| (*cell).to_owned()).collect()).collect(),
        comments: Vec::new(),
    }
}

#[test]
fn what_a_control_cannot_take_is_not_written() {
    let sound = table_of(&["NR", "H7"], &[&["0", "+1"]]);
    assert!(sound.write().is_ok());
    let wide = table_of(&["NR", "H7"], &[&["0", "+1000.25"]]);
    assert_eq!(wide.write().unwrap_err().to_string(), "row 0, column H7: +1000.25 does not fit into 7 characters");
    for (names, row) in [
        (["NR", "H 7"], ["0", "1"]),
        (["NR", "NR"], ["0", "1"]),
        ([";NR", "H7"], ["0", "1"]),
        (["NR", "H7"], [";0", "1"]),
        (["NR", "H7"], ["", ""]),
        (["NR", "H7"], ["END", ""]),
        (["NR", "H7"], ["0", " 1"]),
        (["NR", "H7"], ["0", "1\n2"]),
    ] {
        assert_eq!(table_of(&names, &[&row]).write(), Err(WriteError::ReadsOtherwise), "{names:?} {row:?}");
    }
    let names: Vec<String> = (0..31).map(|number| format!("C{number}")).collect();
    let many = table_of(&names.iter().map(String::as_str).collect::<Vec<_>>(), &[]);
    assert!(many.write().is_ok());
    let many = many.to_generation(Generation::Structure);
    assert_eq!(many.write(), Err(WriteError::TooManyColumns { columns: 31, limit: 30 }));
    let mut long = table_of(&["NR", "H7"], &[]).to_generation(Generation::Structure);
    long.columns[1].width = 193;
    assert!(long.write().is_ok(), "200 characters");
    long.columns[1].width = 194;
    assert_eq!(long.write(), Err(WriteError::TooLong { characters: 201, limit: 200 }));
}

fn any_table() -> impl Strategy<Value = ControlTable> {
    let names = prop::collection::btree_set("[A-Za-zØ][A-Za-z0-9_/ß]{0,7}", 1..6);
    let cells = prop::collection::vec(prop::collection::vec("[+-]?[0-9A-Zµ€Ω.,]{0,5}", 6), 0..6);
    let texts = prop::collection::vec("[a-z;*= ß]{0,10}", 0..4);
    (names, cells, texts, 0..3_usize, 0..3_usize).prop_filter_map(
        "reads otherwise",
        |(names, cells, texts, generation, unit)| {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let mut table = table_of(&names, &[]);
            table.rows = cells.into_iter().map(|row| row.into_iter().take(names.len()).collect()).collect();
            table.unit = [None, Some(TableUnit::Millimetre), Some(TableUnit::Inch)][unit];
            let rows = table.rows.len();
            table.comments = texts
                .into_iter()
                .enumerate()
                .map(|(number, text)| Comment {
                    place: if number == 0 { CommentPlace::Header } else { CommentPlace::Row(number.min(rows)) },
                    text,
                })
                .collect();
            table = table.to_generation(GENERATIONS[generation]);
            // Rows of blanks and a name END cannot be told from what they look like.
            let is_sound = table.rows.iter().all(|row| {
                let text = row.concat();
                !text.is_empty() && text != "END"
            });
            (is_sound && names != ["END"]).then_some(table)
        },
    )
}

proptest! {
    #[test]
    fn any_written_table_reads_back_the_same(table in any_table()) {
        let bytes = table.write().unwrap();
        let again = ControlTable::read(&bytes, "x").unwrap();
        prop_assert_eq!(&again.table, &table);
        prop_assert!(again.warnings.is_empty());
        prop_assert_eq!(again.table.write().unwrap(), bytes);
    }

    #[test]
    fn any_deviations_read_back_the_same(
        steps in prop::collection::vec(1..500_000_000_i64, 1..8),
        cells in prop::collection::vec(prop::option::of((-400_000..400_000_i64, 0..400_000_i64)), 8),
        generation in 0..3_usize,
    ) {
        let nm = |nm: i64| Length::from_nanometres(nm).unwrap();
        let mut end = 0;
        let ends: Vec<Length> = steps.iter().map(|step| { end += step; nm(end) }).collect();
        let cells = cells.iter().take(ends.len()).map(|cell| {
            cell.map(|(lower, width)| Deviations::new(nm(lower + width), nm(lower)).unwrap())
        });
        let class: ToleranceClass = "U1".parse().unwrap();
        let mut columns = vec![ClassColumn { class, cells: cells.collect() }];
        columns.push(ClassColumn { class: "h7".parse().unwrap(), cells: columns[0].cells.iter().copied().rev().collect() });
        let table = DeviationTable::new("own.tab", false, ends, columns).unwrap();
        let bytes = to_control_table(&table, GENERATIONS[generation]).write().unwrap();
        let again = read_table(&bytes, "own.tab", "own.tab", false).unwrap().0.unwrap();
        prop_assert_eq!(again, table);
    }

    #[test]
    fn no_bytes_bring_the_reader_down(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _either = read_table(&bytes, "x", "x", false);
        let mut table = b"BEGIN x.tab\n".to_vec();
        table.extend(bytes);
        let _either = read_table(&table, "x", "x", false);
    }

    #[test]
    fn no_damaged_table_brings_the_reader_down(at in 0..4000_usize, length in 0..20_usize, new in "[ \\[\\]();:=\"*#0-9A-Z\n]{0,6}") {
        for name in ["generation2_struct.tab", "generation3_description.tab", "decimal_comma_latin1_crlf.tab"] {
            let mut bytes = sample(name);
            let at = at % bytes.len();
            let end = (at + length).min(bytes.len());
            bytes.splice(at..end, new.bytes());
            if let Ok(file) = ControlTable::read(&bytes, name)
                && let Ok(written) = file.table.write()
            {
                prop_assert_eq!(ControlTable::read(&written, name).unwrap().table, file.table);
            }
        }
    }
}
