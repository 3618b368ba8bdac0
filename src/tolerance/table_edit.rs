//! A table that is being edited, with undo; and tables made of the standard, in `making`.

mod making;

pub use making::{MakeError, standard_column, standard_table, table_of_standard};

use super::class::ToleranceClass;
use super::limits::Deviations;
use super::table::{Column, DeviationTable, TableShapeError};

/// How many steps back undo remembers.
const UNDO_STEPS: usize = 200;

/// A table that is being edited. Every change is one step of undo.
///
/// A step holds only what it changes, so that undo of a large table stays small.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableEdit {
    table: DeviationTable,
    /// As it was opened.
    kept: DeviationTable,
    past: Vec<Step>,
    future: Vec<Step>,
}

/// What leads from one state of a table to the next, or back.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Step {
    /// A cell gets this.
    Cell { column: usize, range: usize, cell: Option<Deviations> },
    /// A column comes in.
    Insert { at: usize, column: Column },
    /// A column goes out.
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
    /// [`TableShapeError`] for a class that stands there already, or where the cells are more or fewer than the ranges.
    pub fn add_column(&mut self, column: Column) -> Result<(), TableShapeError> {
        let (class, cells, ranges) = (column.class, column.cells.len(), self.table.ends.len());
        if cells != ranges {
            return Err(TableShapeError::Cells { class, cells, ranges });
        }
        if self.number(class).is_some() {
            return Err(TableShapeError::Twice { class });
        }
        self.change(Step::Insert { at: self.table.columns.len(), column });
        Ok(())
    }

    /// Takes a column out. `false` where there is none of that class.
    pub fn remove_column(&mut self, class: ToleranceClass) -> bool {
        self.number(class).is_some_and(|at| self.change(Step::Remove { at }))
    }

    fn number(&self, class: ToleranceClass) -> Option<usize> {
        self.table.columns.iter().position(|column| column.class == class)
    }

    /// Takes a step that undo can take back.
    fn change(&mut self, step: Step) -> bool {
        let Some(back) = self.apply(step) else { return false };
        if UNDO_STEPS <= self.past.len() {
            self.past.remove(0);
        }
        self.past.push(back);
        self.future.clear();
        true
    }

    /// Takes a step; the answer leads back. `None` where the step does not fit the table, which then stays as it is.
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
        // A shipped table is one only as long as it holds what was shipped.
        self.table.shipped = self.kept.shipped && !self.is_changed();
        Some(back)
    }

    /// Takes the last change back. `false` when there is none.
    pub fn undo(&mut self) -> bool {
        let again = self.past.pop().and_then(|step| self.apply(step));
        let done = again.is_some();
        self.future.extend(again);
        done
    }

    /// Does the last change that was taken back again. `false` when there is none.
    pub fn redo(&mut self) -> bool {
        let back = self.future.pop().and_then(|step| self.apply(step));
        let done = back.is_some();
        self.past.extend(back);
        done
    }

    /// Whether there is a change to take back.
    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is a change to do again.
    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Whether the table holds something else than when it was opened.
    pub fn is_changed(&self) -> bool {
        self.table.columns != self.kept.columns
    }
}
