//! Tables made from the standard.

use crate::length::Length;
use crate::message::Say;
use crate::tolerance::iso286::{self, Undefined};
use crate::tolerance::table::{Column, DeviationTable, TableShapeError, ranges};
use crate::tolerance::{Deviations, Feature, ToleranceClass};

/// Why a table cannot be made from the standard.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "make", error)]
pub enum MakeError {
    /// There is no class.
    NoClass,
    /// Hole and shaft classes in one table.
    BothFeatures {
        /// The first hole class.
        hole: ToleranceClass,
        /// The first shaft class.
        shaft: ToleranceClass,
    },
    /// A last size of 0 or less, or beyond the standard.
    LastSize {
        /// What was given.
        to: Length,
    },
    /// A class that is defined for none of the sizes.
    #[say(transparent)]
    Undefined(Undefined),
    /// A class is named twice, or sizes do not ascend.
    #[say(transparent)]
    Shape(#[from] TableShapeError),
}

/// A column of the standard for given size ranges: a cell is empty where the standard does not define the class in the
/// whole range, or has more than one value in it.
pub fn standard_column(class: ToleranceClass, ends: &[Length], options: iso286::Options) -> Column {
    let cell = |(over, to)| {
        let mut values = iso286::steps_within(over, to).map(|end| value(class, end, options));
        let first = values.next().flatten();
        first.filter(|_| values.all(|value| value == first))
    };
    Column { class, cells: ranges(ends).map(cell).collect() }
}

/// A table from the standard for classes of holes or of shafts, over 0 up to and including `to`, with as few size
/// ranges as the classes need.
///
/// # Errors
/// [`MakeError`] names the class or the size that is not possible.
pub fn standard_table(
    name: &str,
    classes: &[ToleranceClass],
    to: Length,
    options: iso286::Options,
) -> Result<DeviationTable, MakeError> {
    check_last(to)?;
    let all: Vec<Length> = iso286::steps_within(Length::ZERO, to).collect();
    let columns: Vec<Column> = classes.iter().map(|class| standard_column(*class, &all, options)).collect();
    // A range continues as long as no class changes.
    let changes = |number: usize| columns.iter().any(|column| column.cells.get(number) != column.cells.get(number + 1));
    let ends = all.iter().enumerate().filter(|(number, _)| changes(*number)).map(|(_, end)| *end).collect();
    table_of_standard(name, classes, ends, options)
}

/// The same for given ends of size ranges, ascending; cells are empty as [`standard_column`] says, and [`compare`]
/// names those that hide a difference.
///
/// # Errors
/// [`MakeError`] names the class or the size that is not possible.
///
/// [`compare`]: crate::tolerance::compare::compare
pub fn table_of_standard(
    name: &str,
    classes: &[ToleranceClass],
    ends: Vec<Length>,
    options: iso286::Options,
) -> Result<DeviationTable, MakeError> {
    let first = |feature| classes.iter().copied().find(|class| class.feature() == feature);
    match (first(Feature::Hole), first(Feature::Shaft)) {
        (None, None) => return Err(MakeError::NoClass),
        (Some(hole), Some(shaft)) => return Err(MakeError::BothFeatures { hole, shaft }),
        _ => {}
    }
    let columns: Vec<Column> = classes.iter().map(|class| standard_column(*class, &ends, options)).collect();
    let table = DeviationTable::new(name, false, ends, columns)?;
    check_last(table.last_end())?;
    for empty in table.columns().iter().filter(|column| column.cells.iter().all(Option::is_none)) {
        iso286::deviations(empty.class, table.last_end(), options).map_err(MakeError::Undefined)?;
    }
    Ok(table)
}

fn check_last(to: Length) -> Result<(), MakeError> {
    let is_beyond = iso286::step_ends().last().is_none_or(|largest| largest < to);
    if to <= Length::ZERO || is_beyond { Err(MakeError::LastSize { to }) } else { Ok(()) }
}

fn value(class: ToleranceClass, size: Length, options: iso286::Options) -> Option<Deviations> {
    iso286::deviations(class, size, options).ok().map(|cell| cell.deviations)
}
