//! Compares a table of deviations with ISO 286, cell by cell, and own tables with each other.
//!
//! A table's range may cover several steps of the standard; it is compared with each of them, so that a range over 50
//! up to 80 mm is reported for r6, whose deviations change at 65 mm.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::class::ToleranceClass;
use super::deviations::Deviations;
use super::iso286::{self, Undefined};
use super::table::{Column, DeviationTable};
use crate::length::Length;
use crate::message::Say;

/// What a comparison found.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Comparison {
    /// Where the table differs, column by column, in each by ascending size.
    pub differences: Vec<Difference>,
    /// How many cells were compared.
    pub compared: usize,
    /// Columns that are not classes of ISO 286: the user's own.
    pub unknown: Vec<ToleranceClass>,
}

/// Sizes for which a cell differs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The class.
    pub class: ToleranceClass,
    /// The number of the table's size range, from 0.
    pub range: usize,
    /// The sizes for which the cell differs, which may be a part of its range: above this,
    pub over: Length,
    /// up to and including this.
    pub to: Length,
    /// What the table says; `None` for an empty cell.
    pub table: Option<Deviations>,
    /// What ISO 286 says, or why it does not define the class here.
    pub standard: Result<Deviations, Undefined>,
}

impl Comparison {
    /// The cells that differ, each by its class and the number of its range: a range that covers several steps of the
    /// standard may have several differences.
    pub fn cells(&self) -> Vec<(ToleranceClass, usize)> {
        let mut cells: Vec<_> = self.differences.iter().map(|found| (found.class, found.range)).collect();
        cells.dedup();
        cells
    }
}

impl Difference {
    /// How far the table's upper deviation is above the standard's, where both have one.
    pub fn upper_by(&self) -> Option<Length> {
        Some(self.table?.minus(self.standard.as_ref().ok()?).0)
    }

    /// How far the table's lower deviation is above the standard's, where both have one.
    pub fn lower_by(&self) -> Option<Length> {
        Some(self.table?.minus(self.standard.as_ref().ok()?).1)
    }
}

/// Compares every cell of a table with the standard.
pub fn compare(table: &DeviationTable, options: iso286::Options) -> Comparison {
    let mut found = Comparison::default();
    for column in table.columns() {
        if iso286::parts(column.class).is_none() {
            found.unknown.push(column.class);
            continue;
        }
        for (range, (sizes, &cell)) in table.ranges().zip(&column.cells).enumerate() {
            found.compared += 1;
            found.differences.extend(differences(column.class, range, sizes, cell, options));
        }
    }
    found
}

/// The differences in one cell; neighbouring steps with the same difference are joined.
fn differences(
    class: ToleranceClass,
    range: usize,
    (over, to): (Length, Length),
    table: Option<Deviations>,
    options: iso286::Options,
) -> Vec<Difference> {
    let mut found: Vec<Difference> = Vec::new();
    let mut over = over;
    for end in iso286::steps_within(over, to) {
        // No class changes within a step, so its end represents all of it.
        let standard = iso286::deviations(class, end, options).map(|cell| cell.deviations);
        if standard.as_ref().ok() != table.as_ref() {
            match found.last_mut() {
                Some(last) if last.to == over && last.standard.as_ref().ok() == standard.as_ref().ok() => last.to = end,
                _ => found.push(Difference { class, range, over, to: end, table, standard }),
            }
        }
        over = end;
    }
    found
}

/// Two tables that have different values of a class for the same sizes: which one applies would depend on their names.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(id = "tables-contradict", error, args(one = cell_text(*one), other = cell_text(*other)))]
pub struct Contradiction {
    /// The first table.
    pub first: Arc<str>,
    /// The second one.
    pub second: Arc<str>,
    /// The class.
    pub class: ToleranceClass,
    /// The first sizes for which they differ: above this,
    pub over: Length,
    /// up to and including this.
    pub to: Length,
    /// What the first one says; `None` for an empty cell.
    #[say(skip)]
    pub one: Option<Deviations>,
    /// What the second one says.
    #[say(skip)]
    pub other: Option<Deviations>,
}

/// `0 / +21`, or the word for an empty cell.
fn cell_text(cell: Option<Deviations>) -> String {
    let figures = |cell: Deviations| format!("{} / {}", cell.lower().signed_um(), cell.upper().signed_um());
    cell.map_or_else(|| "none".to_owned(), figures)
}

/// The first class and sizes for which two of the tables have different values. Sizes that only one of them reaches
/// are no contradiction, nor are equal values.
pub fn contradiction<'a>(tables: impl IntoIterator<Item = &'a DeviationTable>) -> Option<Contradiction> {
    let mut known: BTreeMap<ToleranceClass, Vec<(&DeviationTable, &Column)>> = BTreeMap::new();
    for table in tables {
        for column in table.columns() {
            let before = known.entry(column.class).or_default();
            if let Some(found) = before.iter().find_map(|first| contradicts(*first, (table, column))) {
                return Some(found);
            }
            before.push((table, column));
        }
    }
    None
}

fn contradicts(
    (first, one): (&DeviationTable, &Column),
    (second, other): (&DeviationTable, &Column),
) -> Option<Contradiction> {
    let mut ends: Vec<Length> = first.ends().iter().chain(second.ends()).copied().collect();
    ends.sort_unstable();
    ends.dedup();
    let cell = |table: &DeviationTable, column: &Column, end| {
        let (number, ..) = table.range(end)?;
        column.cells.get(number).copied()
    };
    let mut over = Length::ZERO;
    for to in ends {
        // Beyond the last range of either there is nothing to compare.
        let here = cell(first, one, to)?;
        let there = cell(second, other, to)?;
        if here != there {
            let first = Arc::clone(&first.name);
            let second = Arc::clone(&second.name);
            return Some(Contradiction { first, second, class: one.class, over, to, one: here, other: there });
        }
        over = to;
    }
    None
}
