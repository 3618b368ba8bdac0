//! A table that is being edited, with undo; and tables made of the standard.

use super::class::{Feature, ToleranceClass};
use super::iso286::{self, Undefined};
use super::limits::Deviations;
use super::table::{Column, DeviationTable, TableShapeError};
use crate::length::Length;
use crate::words::{Message, Say};

/// How many steps back undo remembers.
const UNDO_STEPS: usize = 200;

/// A table that is being edited. Every change is one step of undo.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableEdit {
    table: DeviationTable,
    /// As it was opened or last saved.
    kept: DeviationTable,
    past: Vec<DeviationTable>,
    future: Vec<DeviationTable>,
}

impl TableEdit {
    /// Begins with a table.
    pub fn new(table: DeviationTable) -> Self {
        Self { kept: table.clone(), table, past: Vec::new(), future: Vec::new() }
    }

    /// The table as it is now.
    pub const fn table(&self) -> &DeviationTable {
        &self.table
    }

    /// Puts deviations into a cell, or empties it; `range` is the number of the size range. `false` where there is no
    /// such cell or nothing changes.
    pub fn set(&mut self, class: ToleranceClass, range: usize, cell: Option<Deviations>) -> bool {
        let mut columns = self.table.columns().to_vec();
        let found = columns.iter_mut().find(|column| column.class == class);
        match found.and_then(|column| column.cells.get_mut(range)) {
            Some(place) if *place != cell => *place = cell,
            _ => return false,
        }
        self.replace(columns).is_ok()
    }

    /// Adds a column at the end.
    ///
    /// # Errors
    /// [`TableShapeError`] for a class that stands there already, or where the cells are more or fewer than the ranges.
    pub fn add_column(&mut self, column: Column) -> Result<(), TableShapeError> {
        let mut columns = self.table.columns().to_vec();
        columns.push(column);
        self.replace(columns)
    }

    /// Takes a column out. `false` where there is none of that class.
    pub fn remove_column(&mut self, class: ToleranceClass) -> bool {
        let columns: Vec<_> = self.table.columns().iter().filter(|column| column.class != class).cloned().collect();
        columns.len() < self.table.columns().len() && self.replace(columns).is_ok()
    }

    fn replace(&mut self, columns: Vec<Column>) -> Result<(), TableShapeError> {
        let table = DeviationTable::new(self.table.name(), false, self.table.ends().to_vec(), columns)?;
        if UNDO_STEPS <= self.past.len() {
            self.past.remove(0);
        }
        self.past.push(std::mem::replace(&mut self.table, table));
        self.future.clear();
        Ok(())
    }

    /// Takes the last change back. `false` when there is none.
    pub fn undo(&mut self) -> bool {
        let Some(before) = self.past.pop() else { return false };
        self.future.push(std::mem::replace(&mut self.table, before));
        true
    }

    /// Does the last change that was taken back again. `false` when there is none.
    pub fn redo(&mut self) -> bool {
        let Some(after) = self.future.pop() else { return false };
        self.past.push(std::mem::replace(&mut self.table, after));
        true
    }

    /// Whether there is a change to take back.
    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is a change to do again.
    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Whether the table is another than the one that was opened or last saved.
    pub fn is_changed(&self) -> bool {
        self.table.ends() != self.kept.ends() || self.table.columns() != self.kept.columns()
    }
}

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
            Self::LastSize { to } => crate::length::signed_mm(Message::new("make-last-size"), "to-sign", "to", *to),
            Self::Undefined(error) => error.message(),
            Self::Shape(error) => error.message(),
        }
    }
}

/// A column of the standard for given size ranges: a cell is empty where the standard does not define the class in the
/// whole range, or has more than one value in it.
pub fn standard_column(class: ToleranceClass, ends: &[Length], options: iso286::Options) -> Column {
    let mut over = Length::ZERO;
    let cell = |&to: &Length| {
        let value = |end| iso286::deviations(class, end, options).ok().map(|cell| cell.deviations);
        let mut steps = iso286::step_ends().filter(|end| over < *end && *end < to);
        let whole = value(to).filter(|last| steps.all(|end| value(end) == Some(*last)));
        over = to;
        whole
    };
    Column { class, cells: ends.iter().map(cell).collect() }
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
    let largest = iso286::step_ends().last().unwrap_or_default();
    if to <= Length::ZERO || largest < to {
        return Err(MakeError::LastSize { to });
    }
    let all: Vec<Length> = iso286::step_ends().filter(|end| *end < to).chain([to]).collect();
    let columns: Vec<Column> = classes.iter().map(|class| standard_column(*class, &all, options)).collect();
    // A range goes on as long as no class changes.
    let changes = |number: usize| columns.iter().any(|column| column.cells.get(number) != column.cells.get(number + 1));
    let ends = all.iter().enumerate().filter(|(number, _)| changes(*number)).map(|(_, end)| *end).collect();
    table_of_standard(name, classes, ends, options)
}

/// The same for given ends of size ranges, ascending.
///
/// # Errors
/// [`MakeError`] names the class or the size that cannot be.
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
    if let Some(empty) = columns.iter().find(|column| column.cells.iter().all(Option::is_none)) {
        let last = ends.last().copied().unwrap_or_default();
        if let Err(undefined) = iso286::deviations(empty.class, last, options) {
            return Err(MakeError::Undefined(undefined));
        }
    }
    Ok(DeviationTable::new(name, false, ends, columns)?)
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
    fn every_change_can_be_taken_back_and_done_again() {
        let mut edit = TableEdit::new(made("H7", "6").unwrap());
        let h7 = classes("H7")[0];
        assert!(!edit.undo() && !edit.redo() && !edit.is_changed());
        let pair = Deviations::new(Length::from_micrometres(11), Length::ZERO).unwrap();
        assert!(edit.set(h7, 0, Some(pair)));
        assert!(!edit.set(h7, 0, Some(pair)), "nothing changes");
        assert!(!edit.set(h7, 9, Some(pair)) && !edit.set(classes("H8")[0], 0, Some(pair)));
        let h8 = standard_column(classes("H8")[0], edit.table().ends(), iso286::Options::default());
        edit.add_column(h8.clone()).unwrap();
        assert_eq!(edit.add_column(h8.clone()), Err(TableShapeError::Twice { class: h8.class }));
        assert!(edit.remove_column(h7) && !edit.remove_column(h7));
        let last = edit.table().clone();
        assert!(edit.undo() && edit.undo() && edit.undo() && !edit.undo());
        assert!(!edit.is_changed() && edit.can_redo());
        assert!(edit.redo() && edit.redo() && edit.redo() && !edit.redo());
        assert_eq!(*edit.table(), last);
        edit.undo();
        edit.set(h7, 1, None);
        assert!(!edit.can_redo(), "a change ends what could be done again");
    }

    #[test]
    fn undo_forgets_the_oldest_steps() {
        let mut edit = TableEdit::new(made("H7", "6").unwrap());
        for um in 0..i32::try_from(UNDO_STEPS).unwrap() + 50 {
            let pair = Deviations::new(Length::from_micrometres(um + 20), Length::ZERO).unwrap();
            assert!(edit.set(classes("H7")[0], 0, Some(pair)));
        }
        let steps = std::iter::from_fn(|| edit.undo().then_some(())).count();
        assert_eq!(steps, UNDO_STEPS);
    }
}
