//! Tables compared with ISO 286: a table that agrees is clean, and exactly what is changed is found.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck::control::deviations::read_table;
use fitcheck::control::shipped_tables;
use fitcheck::exchange::tables::TABLE_FORMATS;
use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::compare::{Comparison, Difference, compare};
use fitcheck::tolerance::iso286::{self, Edition, JsHalves, Options};
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::table_edit::{TableEdit, standard_table};
use fitcheck::tolerance::{DeviationTable, Deviations, Feature, ToleranceClass};

use crate::table_formats::table_format;

const NANOMETRE: i64 = 1;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn um(text: &str) -> Length {
    Length::parse_in(text, Unit::Micrometre).unwrap()
}

fn moved(length: Length, nanometres: i64) -> Length {
    Length::from_nanometres(length.nanometres() + nanometres).unwrap()
}

fn compared(table: &DeviationTable) -> Comparison {
    compare(table, Options::default())
}

/// The built-in table for this feature.
fn shipped(feature: Feature) -> Arc<DeviationTable> {
    let is_of = |table: &&Arc<DeviationTable>| table.columns()[0].class.feature() == feature;
    Arc::clone(shipped_tables().iter().find(is_of).unwrap())
}

fn with_ends(table: &DeviationTable, ends: Vec<Length>) -> DeviationTable {
    DeviationTable::new("own.tab", false, ends, table.columns().to_vec()).unwrap()
}

/// `r6 over 65 up to 80`
fn place(difference: &Difference) -> String {
    format!("{} over {} up to {}", difference.class, difference.over, difference.to)
}

#[test]
fn both_shipped_tables_agree_in_every_cell() {
    for (feature, cells) in [(Feature::Hole, 24 * 21), (Feature::Shaft, 23 * 21)] {
        let found = compared(&shipped(feature));
        assert_eq!(found, Comparison { compared: cells, ..Comparison::default() });
    }
}

/// The figures to compare with are the published ones, not the engine's: 47 classes in their printed sub-steps.
#[test]
fn tables_of_the_published_figures_agree_and_with_a_nanometre_more_nothing_does() {
    let path = format!("{}/tests/data/iso286/limits_47_classes.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::Reader::from_path(path).unwrap();
    let mut by_class: BTreeMap<String, Vec<(Length, Length, Deviations)>> = BTreeMap::new();
    for row in reader.records().map(Result::unwrap) {
        let deviations = Deviations::new(um(&row[3]), um(&row[4])).unwrap();
        by_class.entry(row[0].to_owned()).or_default().push((mm(&row[1]), mm(&row[2]), deviations));
    }
    assert_eq!(by_class.len(), 47);
    for (class, rows) in by_class {
        let class: ToleranceClass = class.parse().unwrap();
        let (mut ends, mut cells) = (Vec::new(), Vec::new());
        let mut before = Length::ZERO;
        for (over, to, deviations) in rows {
            // What is not printed is not defined.
            if before < over {
                ends.push(over);
                cells.push(None);
            }
            ends.push(to);
            cells.push(Some(deviations));
            before = to;
        }
        let printed = cells.iter().flatten().count();
        let table = |cells: Vec<_>| DeviationTable::new("own.tab", false, ends.clone(), vec![Column { class, cells }]);
        assert_eq!(compared(&table(cells.clone()).unwrap()).differences, [], "{class}");
        let wider = |cell: &Deviations| Deviations::new(moved(cell.upper(), NANOMETRE), cell.lower()).unwrap();
        let wrong = cells.iter().map(|cell| cell.as_ref().map(wider)).collect();
        let differences = compared(&table(wrong).unwrap()).differences;
        let by = Length::from_nanometres(NANOMETRE).ok();
        assert!(differences.iter().all(|one| (one.upper_by(), one.lower_by()) == (by, Some(Length::ZERO))));
        let ranges: std::collections::BTreeSet<usize> = differences.iter().map(|one| one.range).collect();
        assert_eq!(ranges.len(), printed, "{class}");
    }
}

/// Every cell of both tables, in every way in which it can be wrong.
#[test]
fn one_changed_cell_is_the_one_difference() {
    for feature in [Feature::Hole, Feature::Shaft] {
        let mut edit = TableEdit::new((*shipped(feature)).clone());
        let columns = shipped(feature).columns().to_vec();
        for column in &columns {
            for (range, &cell) in column.cells.iter().enumerate() {
                let changes: Vec<Option<Deviations>> = match cell {
                    Some(pair) => vec![
                        Deviations::new(moved(pair.upper(), NANOMETRE), pair.lower()).ok(),
                        Deviations::new(pair.upper(), moved(pair.lower(), -NANOMETRE)).ok(),
                        None,
                    ],
                    // N9 up to 1 mm, which the standard refuses.
                    None => vec![Deviations::new(um("-4"), um("-29")).ok()],
                };
                for changed in changes {
                    assert!(edit.set(column.class, range, changed));
                    // Only this column: the others are as before.
                    let only = edit.table().columns().iter().find(|one| one.class == column.class).unwrap().clone();
                    let ends = edit.table().ends().to_vec();
                    let table = DeviationTable::new("own.tab", false, ends, vec![only]).unwrap();
                    let found = compared(&table).differences;
                    let [difference] = &found[..] else { panic!("{}: {found:?}", column.class) };
                    assert_eq!((difference.class, difference.range), (column.class, range));
                    assert_eq!((difference.table, difference.standard.as_ref().ok()), (changed, cell.as_ref()));
                    assert!(edit.undo());
                }
            }
        }
        assert_eq!(compared(edit.table()).differences, []);
    }
}

#[test]
fn a_size_range_that_ends_a_nanometre_off_is_found_there_and_nowhere_else() {
    let table = shipped(Feature::Hole);
    let thirty = table.ends().iter().position(|end| *end == mm("30")).unwrap();
    for (nanometres, over, to) in [(NANOMETRE, "30", "30.000001"), (-NANOMETRE, "29.999999", "30")] {
        let mut ends = table.ends().to_vec();
        ends[thirty] = moved(ends[thirty], nanometres);
        let found = compared(&with_ends(&table, ends)).differences;
        let here: Vec<_> = found.iter().map(|one| (one.over, one.to)).collect();
        assert!(here.iter().all(|sizes| *sizes == (mm(over), mm(to))), "{here:?}");
        // Every class with a different cell in the next range: the table itself says which these are.
        let differs = |column: &&Column| column.cells[thirty] != column.cells[thirty + 1];
        let expected: Vec<_> = table.columns().iter().filter(differs).map(|column| column.class).collect();
        assert_eq!(found.iter().map(|one| one.class).collect::<Vec<_>>(), expected);
        assert!(20 < expected.len());
    }
}

#[test]
fn a_range_over_two_sub_steps_is_wrong_for_the_classes_that_need_them() {
    let table = shipped(Feature::Shaft);
    let at = table.ends().iter().position(|end| *end == mm("65")).unwrap();
    let ends: Vec<Length> = table.ends().iter().copied().filter(|end| *end != mm("65")).collect();
    let columns = table.columns().iter().map(|column| {
        let mut cells = column.cells.clone();
        cells.remove(at);
        Column { class: column.class, cells }
    });
    // The cells of 65 to 80 mm now also apply to 50 to 65 mm.
    let merged = DeviationTable::new("own.tab", false, ends, columns.collect()).unwrap();
    let found: Vec<String> = compared(&merged).differences.iter().map(place).collect();
    assert_eq!(found, ["r6 over 50 up to 65", "s6 over 50 up to 65", "s7 over 50 up to 65"]);
}

#[test]
fn the_options_of_the_standard_count() {
    let rounded = Options { js: JsHalves::Rounded, ..Options::default() };
    let found = compare(&shipped(Feature::Hole), rounded).differences;
    let classes: Vec<&str> = found.iter().map(|one| one.class.as_str()).collect();
    assert!(!found.is_empty() && classes.iter().all(|class| ["JS7", "JS9"].contains(class)), "{classes:?}");
    let half = Length::parse_in("0.5", Unit::Micrometre).unwrap();
    assert!(found.iter().all(|one| (one.upper_by(), one.lower_by()) == (Some(half), Some(half.negated()))));
    // 10.5 µm, an odd 21 halved.
    assert!(found.iter().any(|one| place(one) == "JS7 over 18 up to 30"));

    let edition = Options { edition: Edition::Of1988, ..Options::default() };
    let table = standard_table("own.tab", &["EF7".parse().unwrap()], mm("50"), Options::default()).unwrap();
    let found = compare(&table, edition).differences;
    assert_eq!(place(&found[0]), "EF7 over 10 up to 18");
    assert!(found.iter().all(|one| one.table.is_some() && one.standard.is_err()));
}

/// All classes at once where a control takes them, in parts where it takes no more than 30.
#[test]
fn every_class_of_the_standard_survives_every_generation() {
    let options = Options::default();
    for feature in [Feature::Hole, Feature::Shaft] {
        let classes: Vec<ToleranceClass> = iso286::classes(feature, options).collect();
        assert!(250 < classes.len(), "{}", classes.len());
        for format in TABLE_FORMATS.iter().filter(|format| format.endings.contains(&"tab")) {
            let together = if format.name == "itnc530" { 16 } else { classes.len() };
            for part in classes.chunks(together) {
                let table = standard_table("own.tab", part, mm("3150"), options).unwrap();
                let bytes = (format.write)(&table).unwrap();
                let (read, warnings) = read_table(&bytes, "own.tab", "own.tab", false).unwrap();
                assert_eq!((read.as_ref(), warnings), (Some(&table), vec![]), "{}", format.name);
            }
        }
        let table = standard_table("own.tab", &classes, mm("3150"), options).unwrap();
        assert_eq!(compared(&table).differences, []);
    }
}

/// On every end of a range, a nanometre below and a nanometre above it.
#[test]
fn a_made_table_answers_as_the_standard_does_on_its_borders() {
    let options = Options::default();
    let classes: Vec<ToleranceClass> =
        "A9 CD8 EF7 H7 J7 JS9 K6 M6 N9 R7 T7 Y8 ZC10".split(' ').map(|class| class.parse().unwrap()).collect();
    let table = standard_table("own.tab", &classes, mm("3150"), options).unwrap();
    let answer = |class: ToleranceClass, size: Length| -> Option<Deviations> {
        let range = table.ends().iter().position(|end| size <= *end)?;
        table.columns().iter().find(|column| column.class == class)?.cells[range]
    };
    for step in iso286::step_ends() {
        for size in [moved(step, -NANOMETRE), step, moved(step, NANOMETRE)] {
            for &class in &classes {
                let standard = iso286::deviations(class, size, options).ok().map(|cell| cell.deviations);
                assert_eq!(answer(class, size), standard, "{size} {class}");
            }
        }
    }
}

/// `NR` and `BEREICH` take 16 characters, a class 7.
#[test]
fn an_itnc_530_takes_26_classes_and_other_controls_more() {
    let grades = (1..=18).flat_map(|grade| ["H", "JS"].map(|letter| format!("{letter}{grade}")));
    let classes: Vec<ToleranceClass> = grades.map(|class| class.parse().unwrap()).collect();
    let written = |format: &str, count: usize| {
        let table = standard_table("own.tab", &classes[..count], mm("3"), Options::default()).unwrap();
        (table_format(format).unwrap().write)(&table).map(drop).map_err(|error| error.to_string())
    };
    let too_long = "the lines of the table have 205 characters; an iTNC 530 takes at most 200";
    let too_many = "the table has 31 columns; an iTNC 530 takes at most 30";
    assert_eq!(written("itnc530", 26), Ok(()));
    assert_eq!(written("itnc530", 27), Err(too_long.to_owned()));
    assert_eq!(written("itnc530", 29), Err(too_many.to_owned()));
    assert_eq!((written("tnc640", 36), written("tnc7", 36)), (Ok(()), Ok(())));
}

fn pair(upper: i32, lower: i32) -> Option<Deviations> {
    Deviations::new(Length::from_micrometres(upper), Length::from_micrometres(lower)).ok()
}

fn table(ends: &[&str], columns: &[(&str, &[Option<Deviations>])]) -> DeviationTable {
    let columns = columns.iter().map(|(class, cells)| Column { class: class.parse().unwrap(), cells: cells.to_vec() });
    let ends = ends.iter().map(|end| end.parse().unwrap()).collect();
    DeviationTable::new("own.tab", false, ends, columns.collect()).unwrap()
}

#[track_caller]
fn check(table: &DeviationTable, expected: &[&str]) {
    let said = |pair: Option<&Deviations>| pair.map_or("-".into(), |p| format!("{}/{}", p.upper(), p.lower()));
    let found: Vec<String> = compare(table, iso286::Options::default())
        .differences
        .iter()
        .map(|d| {
            let (is, should) = (said(d.table.as_ref()), said(d.standard.as_ref().ok()));
            format!("{} range {} over {} to {}: {is} not {should}", d.class, d.range, d.over, d.to)
        })
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn cells_that_agree_are_counted_and_own_columns_are_named() {
    let table = table(&["3", "6"], &[("H7", &[pair(10, 0), pair(12, 0)]), ("OWN1", &[pair(1, 0), None])]);
    let found = compare(&table, iso286::Options::default());
    assert_eq!((found.compared, found.differences.len()), (2, 0));
    assert_eq!(found.unknown, ["OWN1".parse().unwrap()]);
}

#[test]
fn every_kind_of_difference_is_found() {
    check(
        &table(&["3", "6"], &[("H7", &[pair(11, 0), pair(12, -1)]), ("N9", &[pair(-4, -29), None])]),
        &[
            "H7 range 0 over 0 to 3: 0.011/0 not 0.01/0",
            "H7 range 1 over 3 to 6: 0.012/-0.001 not 0.012/0",
            // Up to 1 mm the standard refuses N9; above it the cell is right.
            "N9 range 0 over 0 to 1: -0.004/-0.029 not -",
            "N9 range 1 over 3 to 6: - not 0/-0.03",
        ],
    );
}

#[test]
fn a_range_over_several_steps_is_wrong_in_some_of_them() {
    check(
        &table(&["50", "80"], &[("r6", &[None, pair(60, 41)])]),
        &[
            "r6 range 0 over 0 to 3: - not 0.016/0.01",
            "r6 range 0 over 3 to 6: - not 0.023/0.015",
            "r6 range 0 over 6 to 10: - not 0.028/0.019",
            "r6 range 0 over 10 to 18: - not 0.034/0.023",
            "r6 range 0 over 18 to 30: - not 0.041/0.028",
            "r6 range 0 over 30 to 50: - not 0.05/0.034",
            "r6 range 1 over 65 to 80: 0.06/0.041 not 0.062/0.043",
        ],
    );
}

#[test]
fn a_table_that_goes_on_beyond_the_standard_differs_there() {
    let own = table(&["3150", "4000"], &[("H7", &[None, pair(210, 0)])]);
    let found = compare(&own, iso286::Options::default()).differences;
    let last = found.last().unwrap();
    assert_eq!((last.over.to_string(), last.to.to_string()), ("3150".into(), "4000".into()));
    let why = "nominal size 4000 mm is beyond ISO 286, which ends at 3150 mm";
    assert_eq!(last.standard.as_ref().unwrap_err().to_string(), why);
    assert_eq!((last.upper_by(), last.lower_by()), (None, None));
}

#[test]
fn by_how_much_is_told_with_its_sign() {
    let own = table(&["3"], &[("h7", &[pair(1, -12)])]);
    let found = compare(&own, iso286::Options::default()).differences;
    let by = (found[0].upper_by(), found[0].lower_by());
    assert_eq!(by, (Some(Length::from_micrometres(1)), Some(Length::from_micrometres(-2))));
}
