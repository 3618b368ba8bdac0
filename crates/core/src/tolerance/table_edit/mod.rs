//! A table that is being edited, with undo; `making` makes tables from the standard.

mod making;

pub use making::{MakeError, standard_column, standard_table, table_of_standard};

use super::class::ToleranceClass;
use super::deviations::Deviations;
use super::table::{Column, DeviationTable, TableShapeError};

/// How many steps can be undone.
const UNDO_STEPS: usize = 200;

/// A table that is being edited. Every change is one undo step.
///
/// A step holds only what it changes, so that undo of a large table stays small.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableEdit {
    table: DeviationTable,
    /// The table as it was opened.
    kept: DeviationTable,
    past: Vec<Step>,
    future: Vec<Step>,
}

/// A step from one state of a table to the next, or back.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Step {
    /// A cell gets this value.
    Cell { column: usize, range: usize, cell: Option<Deviations> },
    /// A column is added.
    Insert { at: usize, column: Column },
    /// A column is removed.
    Remove { at: usize },
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
        let Some(column) = self.number(class) else { return false };
        let there = self.table.columns.get(column).and_then(|column| column.cells.get(range));
        if there.is_none_or(|there| *there == cell) {
            return false;
        }
        self.change(Step::Cell { column, range, cell })
    }

    /// Adds a column at the end.
    ///
    /// # Errors
    /// [`TableShapeError`] for a class that the table already has, or where there are more or fewer cells than ranges.
    pub fn add_column(&mut self, column: Column) -> Result<(), TableShapeError> {
        let class = column.class;
        let cells = column.cells.len();
        let ranges = self.table.ends.len();
        if cells != ranges {
            return Err(TableShapeError::Cells { class, cells, ranges });
        }
        if self.number(class).is_some() {
            return Err(TableShapeError::Twice { class });
        }
        self.change(Step::Insert { at: self.table.columns.len(), column });
        Ok(())
    }

    /// Removes a column. `false` where there is none of that class.
    pub fn remove_column(&mut self, class: ToleranceClass) -> bool {
        self.number(class).is_some_and(|at| self.change(Step::Remove { at }))
    }

    fn number(&self, class: ToleranceClass) -> Option<usize> {
        self.table.columns.iter().position(|column| column.class == class)
    }

    /// Makes a change that can be undone.
    fn change(&mut self, step: Step) -> bool {
        let Some(back) = self.apply(step) else { return false };
        if UNDO_STEPS <= self.past.len() {
            self.past.remove(0);
        }
        self.past.push(back);
        self.future.clear();
        true
    }

    /// Applies a step and returns the step back. `None` where the step does not fit the table, which stays as it is.
    fn apply(&mut self, step: Step) -> Option<Step> {
        let columns = &mut self.table.columns;
        let back = match step {
            Step::Cell { column, range, cell } => {
                let place = columns.get_mut(column)?.cells.get_mut(range)?;
                Step::Cell { column, range, cell: std::mem::replace(place, cell) }
            }
            Step::Insert { at, column } if at <= columns.len() => {
                columns.insert(at, column);
                Step::Remove { at }
            }
            Step::Remove { at } if at < columns.len() => Step::Insert { at, column: columns.remove(at) },
            Step::Insert { .. } | Step::Remove { .. } => return None,
        };
        // A built-in table counts as one only while it has its original values.
        self.table.shipped = self.kept.shipped && !self.is_changed();
        Some(back)
    }

    /// Undoes the last change. `false` when there is none.
    pub fn undo(&mut self) -> bool {
        let again = self.past.pop().and_then(|step| self.apply(step));
        let done = again.is_some();
        self.future.extend(again);
        done
    }

    /// Redoes the last undone change. `false` when there is none.
    pub fn redo(&mut self) -> bool {
        let back = self.future.pop().and_then(|step| self.apply(step));
        let done = back.is_some();
        self.past.extend(back);
        done
    }

    /// Whether there is a change to undo.
    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is a change to redo.
    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Whether the table differs from when it was opened.
    pub fn is_changed(&self) -> bool {
        self.table.columns != self.kept.columns
    }
}
