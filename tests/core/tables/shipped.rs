//! Compares the built-in tables with the published figures of ISO 286.

use super::*;
use crate::callouts::{Sample, samples};

const HOLE_CLASSES: &str = "D10 E9 F7 F8 G7 G9 H6 H7 H8 H9 H11 H12 H13 JS7 JS9 K6 K7 M6 M7 N7 N9 P7 P9 R7";
const SHAFT_CLASSES: &str = "d9 e8 f7 g6 h5 h6 h7 h8 h9 h11 js5 js6 js13 js14 k5 k6 m5 m6 n6 p6 r6 s6 s7";
const ENDS: [&str; 21] = [
    "1", "3", "6", "10", "18", "30", "50", "65", "80", "100", "120", "140", "160", "180", "200", "225", "250", "280",
    "315", "355", "400",
];

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

/// The table made from the standard's figures.
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

/// `UPDATE_TABLES=1 cargo test shipped_tables` writes the files again.
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
    let names: Vec<&str> = tables.iter().map(|table| table.name()).collect();
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

/// The same without the program's reader: straight from the bytes.
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

/// Only the two built-in tables, as on a control.
fn control() -> fitcheck::tolerance::Sources {
    fitcheck::tolerance::Sources::of_tables(shipped_tables())
}

#[track_caller]
fn check_limits(callout: &str, expected: &str) {
    let said = match callout.parse::<Callout>().map(|callout| control().limits(&callout, None)) {
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

/// NC-Solution 8255 (7/2020).
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
    let tables = control();
    let mut reader = csv::Reader::from_path(root("tests/data/iso286/spot_checks.csv")).unwrap();
    let (mut agreed, mut refused) = (0, 0);
    for record in reader.records() {
        let record = record.unwrap();
        let callout: Callout = record[0].parse().unwrap();
        let class = callout.class().unwrap().to_string();
        let is_ours = HOLE_CLASSES.split(' ').chain(SHAFT_CLASSES.split(' ')).any(|ours| ours == class);
        let is_refused = !is_ours || mm("400") < callout.nominal() || !record[3].is_empty();
        match tables.limits(&callout, None) {
            Err(_) if is_refused => refused += 1,
            Ok(limits) if !is_refused => {
                assert_eq!(limits.deviations.lower(), um(&record[1]), "{callout}");
                assert_eq!(limits.deviations.upper(), um(&record[2]), "{callout}");
                agreed += 1;
            }
            other => panic!("{callout}: {other:?}"),
        }
    }
    // 400.5 H7 and 26 S7 are published, but not in the tables; the standard also refuses eight callouts.
    assert_eq!((agreed, refused), (26, 10));
}

#[test]
fn the_shipped_tables_can_be_read_without_a_warning() {
    let files = ["82553_hole.tab", "82553_shaft.tab"];
    for name in files {
        let (table, warnings) =
            read_table(fitcheck::shipped::file(fitcheck::shipped::TABLES, name).unwrap(), name, name, true).unwrap();
        assert!(table.is_some() && warnings.is_empty(), "{name}: {warnings:?}");
    }
    assert_eq!(shipped_tables().len(), files.len());
}

#[test]
fn every_sample_of_the_shipped_tables_reads_as_it_should() {
    let samples = samples("callout-8255-table");
    assert_eq!(samples.len(), 2);
    for Sample { text, nominal, band, .. } in samples {
        let callout: fitcheck::tolerance::Callout = text.parse().unwrap();
        assert_eq!(Some(callout.nominal()), nominal);
        let limits = fitcheck::tolerance::Sources::of_tables(shipped_tables()).limits(&callout, None).ok();
        assert_eq!(limits.map(|limits| (limits.deviations.upper(), limits.deviations.lower())), band, "{text}");
    }
}
