//! Tables made of the standard.

use crate::length::{Length, signed_mm};
use crate::message::{Message, Say};
use crate::tolerance::iso286::{self, Undefined};
use crate::tolerance::table::{Column, DeviationTable, TableShapeError};
use crate::tolerance::{Deviations, Feature, ToleranceClass};

/// Why no table can be made of the standard.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MakeError {
    /// There is no class.
    #[error("no class is named: name some, such as H7 H8 JS9")]
    NoClass,
    /// Hole and shaft classes in one table.
    #[error(
        "{hole} and {shaft} cannot stand in one table: only the case tells them apart, so make one table for holes and one for shafts"
    )]
    BothFeatures {
        /// The first hole class.
        hole: ToleranceClass,
        /// The first shaft class.
        shaft: ToleranceClass,
    },
    /// A last size of 0 or less, or beyond the standard.
    #[error("the last size is {to} mm: it must be above 0 and at most 3150 mm")]
    LastSize {
        /// What was given.
        to: Length,
    },
    /// A class that is defined for none of the sizes.
    #[error("{0}")]
    Undefined(Undefined),
    /// A class is named twice, or sizes do not ascend.
    #[error("{0}")]
    Shape(#[from] TableShapeError),
}

impl Say for MakeError {
    fn message(&self) -> Message {
        match self {
            Self::NoClass => Message::new("make-no-class"),
            Self::BothFeatures { hole, shaft } => {
                Message::new("make-both-features").text("hole", hole).text("shaft", shaft)
            }
            Self::LastSize { to } => signed_mm(Message::new("make-last-size"), "to-sign", "to", *to),
            Self::Undefined(error) => error.message(),
            Self::Shape(error) => error.message(),
        }
    }
}

/// A column of the standard for given size ranges: a cell is empty where the standard does not define the class in the
/// whole range, or has more than one value in it.
pub fn standard_column(class: ToleranceClass, ends: &[Length], options: iso286::Options) -> Column {
    let cell = |(over, to)| {
        let mut values = steps(over, to).map(|end| value(class, end, options));
        let first = values.next().flatten();
        first.filter(|_| values.all(|value| value == first))
    };
    Column { class, cells: ranges(ends).map(cell).collect() }
}

/// A table of the standard for classes of holes or of shafts, over 0 up to and including `to`, with as few size ranges
/// as the classes need.
///
/// # Errors
/// [`MakeError`] names the class or the size that cannot be.
pub fn standard_table(
    name: &str,
    classes: &[ToleranceClass],
    to: Length,
    options: iso286::Options,
) -> Result<DeviationTable, MakeError> {
    check_last(to)?;
    let all: Vec<Length> = steps(Length::ZERO, to).collect();
    let columns: Vec<Column> = classes.iter().map(|class| standard_column(*class, &all, options)).collect();
    // A range goes on as long as no class changes.
    let changes = |number: usize| columns.iter().any(|column| column.cells.get(number) != column.cells.get(number + 1));
    let ends = all.iter().enumerate().filter(|(number, _)| changes(*number)).map(|(_, end)| *end).collect();
    table_of_standard(name, classes, ends, options)
}

/// The same for given ends of size ranges, ascending; cells are empty as [`standard_column`] says, and [`compare`] names
/// those that hide something.
///
/// # Errors
/// [`MakeError`] names the class or the size that cannot be.
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
    let largest = iso286::step_ends().last().unwrap_or_default();
    if to <= Length::ZERO || largest < to { Err(MakeError::LastSize { to }) } else { Ok(()) }
}

/// Above and up to, for ends of size ranges.
fn ranges(ends: &[Length]) -> impl Iterator<Item = (Length, Length)> {
    std::iter::once(Length::ZERO).chain(ends.iter().copied()).zip(ends.iter().copied())
}

/// The ends of the standard's steps within a size range, its own end last: within a step no class changes.
fn steps(over: Length, to: Length) -> impl Iterator<Item = Length> {
    iso286::step_ends().filter(move |end| over < *end && *end < to).chain([to])
}

fn value(class: ToleranceClass, size: Length, options: iso286::Options) -> Option<Deviations> {
    iso286::deviations(class, size, options).ok().map(|cell| cell.deviations)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::compare::compare;

    fn classes(text: &str) -> Vec<ToleranceClass> {
        text.split_whitespace().map(|class| class.parse().unwrap()).collect()
    }

    fn made(text: &str, to: &str) -> Result<DeviationTable, MakeError> {
        standard_table("own.tab", &classes(text), to.parse().unwrap(), iso286::Options::default())
    }

    #[track_caller]
    fn check(text: &str, to: &str, ends: &str) {
        let table = made(text, to).unwrap();
        let found: Vec<String> = table.ends().iter().map(ToString::to_string).collect();
        assert_eq!(found.join(" "), ends, "for {text} to {to}");
        assert_eq!(compare(&table, iso286::Options::default()).differences, []);
    }

    #[test]
    fn a_table_has_the_ranges_that_its_classes_need() {
        check("H7 H8", "50", "3 6 10 18 30 50");
        check("H7 R7", "80", "3 6 10 18 30 50 65 80");
        check("N9", "10", "1 3 6 10");
        check("h6", "12.5", "3 6 10 12.5");
        check("H7", "3150", "3 6 10 18 30 50 80 120 180 250 315 400 500 630 800 1000 1250 1600 2000 2500 3150");
    }

    #[test]
    fn what_cannot_be_made_is_refused_and_said_in_both_languages() {
        use crate::words::{Language, Words};
        for (text, to, expected) in [
            ("", "50", "no class is named: name some, such as H7 H8 JS9"),
            (
                "H7 g6",
                "50",
                "H7 and g6 cannot stand in one table: only the case tells them apart, so make one table for holes and \
                 one for shafts",
            ),
            ("H7", "0", "the last size is 0 mm: it must be above 0 and at most 3150 mm"),
            ("H7", "3150.000001", "the last size is 3150.000001 mm: it must be above 0 and at most 3150 mm"),
            ("T7", "24", "T7 is not defined at 24 mm in ISO 286; it is defined over 24 up to 3150 mm"),
            ("H7 H7", "24", "column H7 occurs twice"),
        ] {
            let error = made(text, to).unwrap_err();
            assert_eq!(error.to_string(), expected);
            assert_eq!(Words::new(Language::En).told(&error), expected);
            assert_ne!(Words::new(Language::Nl).told(&error), expected);
        }
    }

    #[test]
    fn given_ranges_end_with_the_standard_and_leave_a_cell_empty_that_has_no_one_value() {
        let made = |text: &str, ends: &str| {
            let ends = ends.split(' ').map(|end| end.parse().unwrap()).collect();
            table_of_standard("own.tab", &classes(text), ends, iso286::Options::default())
        };
        let refused = |text: &str, ends: &str| made(text, ends).unwrap_err().to_string();
        let why = "the last size is 3150.000001 mm: it must be above 0 and at most 3150 mm";
        assert_eq!(refused("H7", "3 3150.000001"), why);
        assert_eq!(refused("H7", "0 3"), "size range up to 0 mm does not end above the one before it, 0 mm");
        let why = "T6 is not defined at 20 mm in ISO 286; it is defined over 24 up to 3150 mm";
        assert_eq!(refused("R6 T6", "20"), why, "R6 is defined and merely has no one value");
        let cells = |text: &str, ends: &str| -> Vec<_> {
            made(text, ends).unwrap().columns()[0].cells.iter().map(Option::is_some).collect()
        };
        assert_eq!(cells("H7", "0.5 1 2.5 3"), [true; 4]);
        assert_eq!(cells("A11", "1 3"), [false, true]);
        assert_eq!(cells("A11", "3 6"), [false, true], "not for the whole of the first range");
        assert_eq!(cells("R6", "3 50 80"), [true, false, false], "more than one value");
    }
}
