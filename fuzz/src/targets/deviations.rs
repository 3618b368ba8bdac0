//! Any bytes as a table of deviations: it answers with its own cells, it reads back from a control's table of every
//! kind, and its CSV has every cell.

use fitcheck::control::deviations::{read_table, to_control_table};
use fitcheck::control::table::Generation;
use fitcheck::exchange::tables::TABLE_FORMATS;
use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::compare::compare;
use fitcheck::tolerance::iso286::Options;
use fitcheck::tolerance::{Callout, DeviationTable, Deviations, Sources};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let table = match read_table(bytes, "a.tab", "a.tab", false) {
        Ok((table, warnings)) => {
            for warning in &warnings {
                told(bytes, warning);
            }
            table
        }
        Err(error) => return told(bytes, &error),
    };
    let Some(table) = table else { return };
    answers(&table);
    comes_back(&table);
    let comparison = compare(&table, Options::default());
    assert!(comparison.cells().len() <= table.columns().len() * table.ends().len());
    for format in TABLE_FORMATS {
        if let Err(error) = (format.write)(&table) {
            told(bytes, &error);
        }
        if let Some(warning) = (format.warning)(&table) {
            told(bytes, &warning);
        }
    }
}

/// At both borders of every range.
fn answers(table: &DeviationTable) {
    let sources = Sources::of_tables([table.clone()]);
    for column in table.columns().iter().take(40) {
        for ((over, to), cell) in table.ranges().zip(&column.cells).take(60) {
            for nominal in [over.nanometres() + 1, to.nanometres()] {
                let nominal = Length::from_nanometres(nominal).expect("a size within the range");
                let callout = Callout::new(nominal, column.class).expect("a size above zero");
                let found = sources.deviations(&callout, None).map(|(deviations, _)| deviations);
                assert_eq!(found.ok(), *cell, "{callout}");
            }
        }
    }
}

fn comes_back(table: &DeviationTable) {
    for generation in [Generation::Plain, Generation::Structure, Generation::Description] {
        if let Ok(written) = to_control_table(table, generation).write() {
            let (again, _) = read_table(&written, "a.tab", "a.tab", false).expect("a table that was written");
            assert_eq!(again.as_ref(), Some(table));
        }
    }
    let csv = TABLE_FORMATS.iter().find(|format| format.name == "csv").expect("the plain CSV");
    let text = String::from_utf8((csv.write)(table).expect("texts and figures")).expect("ASCII");
    let mut lines = text.lines().skip(1);
    for column in table.columns() {
        for ((over, to), cell) in table.ranges().zip(&column.cells) {
            let Some(cell) = cell else { continue };
            let cells: Vec<&str> = lines.next().expect("a line for every cell").split(',').collect();
            let (mm, um) = (|at: usize| cells[at].parse(), |at: usize| Length::parse_in(cells[at], Unit::Micrometre));
            assert_eq!((cells[0].parse(), mm(1), mm(2)), (Ok(column.class), Ok(over), Ok(to)));
            let (upper, lower) = (um(3).expect("a number"), um(4).expect("a number"));
            assert_eq!(Deviations::new(upper, lower).as_ref(), Ok(cell));
        }
    }
    assert_eq!(lines.next(), None);
}
