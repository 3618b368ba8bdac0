//! The table of a plan: which columns are shown, where the keys are, and what is selected.

use std::ops::RangeInclusive;

use fitcheck_core::part::{Column, Draft, MOST_FEATURES, PlanFault, Spot};
use fitcheck_core::tolerance::LimitsError;

use super::document::PlanDocument;
use crate::Step;

/// The columns that are always shown.
const USUAL: [Column; 7] =
    [Column::Number, Column::Name, Column::Kind, Column::Callout, Column::X, Column::Y, Column::Z];

/// How many rows a page has.
const PAGE: usize = 10;

/// Where the keys are in the table of a plan. Below the last feature is a row in which the next one is begun.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// The shown columns, the usual ones first.
    pub columns: Vec<Column>,
    /// Whether every column is shown, also those that nothing is written in.
    pub shows_all: bool,
    row: usize,
    column: usize,
    /// The other corner of what is selected.
    from: (usize, usize),
    /// Whether something is typed into the cell.
    pub is_editing: bool,
    /// Counts how often the keys moved.
    pub moves: u64,
}

impl Default for Sheet {
    fn default() -> Self {
        let columns = USUAL.to_vec();
        Self { columns, shows_all: false, row: 0, column: 0, from: (0, 0), is_editing: false, moves: 0 }
    }
}

impl Sheet {
    /// The table of a plan that was opened.
    pub(super) fn of(document: &PlanDocument) -> Self {
        let mut sheet = Self::default();
        sheet.follow(document);
        sheet
    }

    /// How many rows the table has: one more than there are features, while there may be more.
    pub fn rows(draft: &Draft) -> usize {
        (draft.rows.len() + 1).min(MOST_FEATURES.max(draft.rows.len()))
    }

    /// The cell at which the keys are.
    pub fn at(&self) -> (usize, Column) {
        (self.row, self.columns.get(self.column).copied().unwrap_or(Column::Name))
    }

    pub fn selected_rows(&self) -> RangeInclusive<usize> {
        self.row.min(self.from.0)..=self.row.max(self.from.0)
    }

    /// The selected columns, by their places among those that are shown.
    pub fn selected_places(&self) -> RangeInclusive<usize> {
        self.column.min(self.from.1)..=self.column.max(self.from.1)
    }

    pub(super) fn selected_columns(&self) -> Vec<Column> {
        let places = self.selected_places();
        self.columns.iter().skip(*places.start()).take(places.count()).copied().collect()
    }

    /// Whether more than one cell is selected.
    pub fn is_block(&self) -> bool {
        self.from != (self.row, self.column)
    }

    pub(super) fn edit(&mut self, is_editing: bool) {
        self.is_editing = is_editing;
        self.moves += u64::from(is_editing);
    }

    /// Something is typed into the cell.
    pub(super) const fn edit_on(&mut self) {
        self.is_editing = true;
    }

    /// Columns that something is written in, or wrong with, are shown from then on.
    pub(super) fn follow(&mut self, document: &PlanDocument) {
        // Where a callout does not say hole or shaft, there is a column that does.
        let is_other = |error: &LimitsError| matches!(error, LimitsError::OtherFeature { .. });
        let asks_for_side = |what: &PlanFault| match what {
            PlanFault::NoFeature { .. } => true,
            PlanFault::Limits { error, .. } => is_other(error),
            _ => false,
        };
        let is_wrong = |column: Column| {
            document.findings().iter().any(|finding| {
                matches!(finding.spot, Spot::Feature(_, Some(of)) if of == column)
                    || column == Column::Feature && asks_for_side(&finding.what)
            })
        };
        let used: Vec<Column> = document.draft().used().collect();
        let at = self.at();
        let from = self.columns.get(self.from.1).copied();
        let has = |column: &Column| {
            // Where balloons are is seen on the picture.
            let is_used = used.contains(column) && !matches!(column, Column::BalloonX | Column::BalloonY);
            self.shows_all || is_used || self.columns.contains(column) || is_wrong(*column)
        };
        let others = Column::ALL.into_iter().filter(|column| !USUAL.contains(column)).filter(has);
        self.columns = USUAL.into_iter().chain(others).collect();
        // The keys go to the first column where theirs is not shown any more.
        let place = |column| self.columns.iter().position(|of| Some(*of) == column).unwrap_or(0);
        self.column = place(Some(at.1));
        self.from.1 = place(from);
        let last = Self::rows(document.draft()).saturating_sub(1);
        self.row = self.row.min(last);
        self.from.0 = self.from.0.min(last);
    }

    /// Shows every column, or those that are used.
    pub(super) fn show_all(&mut self, shows_all: bool, document: &PlanDocument) {
        let (row, column) = self.at();
        self.shows_all = shows_all;
        if !shows_all {
            self.columns = USUAL.to_vec();
        }
        self.follow(document);
        self.go(row, column, false, document);
    }

    /// Goes to a cell; what is selected reaches to it, or is the cell alone.
    pub(super) fn go(&mut self, row: usize, column: Column, extends: bool, document: &PlanDocument) {
        let last = Self::rows(document.draft()).saturating_sub(1);
        self.row = row.min(last);
        self.column = self.columns.iter().position(|of| *of == column).unwrap_or(0);
        if !extends {
            self.from = (self.row, self.column);
        }
        self.moves += 1;
    }

    /// Goes to a cell of a column that may not be shown yet.
    pub(super) fn show(&mut self, row: usize, column: Column, document: &PlanDocument) {
        if !self.columns.contains(&column) {
            self.columns.push(column);
            self.follow(document);
        }
        self.go(row, column, false, document);
    }

    /// Moves by a step.
    pub(super) fn step(&mut self, step: Step, extends: bool, document: &PlanDocument) {
        let last_row = Self::rows(document.draft()).saturating_sub(1);
        let last = self.columns.len().saturating_sub(1);
        let (row, place) = match step {
            Step::Left => (self.row, self.column.saturating_sub(1)),
            Step::Right => (self.row, (self.column + 1).min(last)),
            Step::Up => (self.row.saturating_sub(1), self.column),
            Step::Down => (self.row + 1, self.column),
            Step::PageUp => (self.row.saturating_sub(PAGE), self.column),
            Step::PageDown => (self.row + PAGE, self.column),
            Step::First => (self.row, 0),
            Step::Last => (self.row, last),
            Step::Top => (0, 0),
            Step::Bottom => (last_row, last),
        };
        let column = self.columns.get(place).copied().unwrap_or(Column::Name);
        self.go(row, column, extends, document);
    }

    /// To the next cell, row by row, or to the one before.
    pub(super) fn tab(&mut self, forwards: bool, document: &PlanDocument) {
        let last = self.columns.len().saturating_sub(1);
        let (row, place) = match (forwards, self.column) {
            (true, place) if place < last => (self.row, place + 1),
            (true, _) => (self.row + 1, 0),
            (false, 0) => (self.row.saturating_sub(1), last),
            (false, place) => (self.row, place - 1),
        };
        let column = self.columns.get(place).copied().unwrap_or(Column::Name);
        self.go(row, column, false, document);
    }

    /// Whether there is a cell after this one, or before it.
    pub fn can_tab(&self, forwards: bool, draft: &Draft) -> bool {
        let last_row = Self::rows(draft).saturating_sub(1);
        let last = self.columns.len().saturating_sub(1);
        let end = if forwards { (last_row, last) } else { (0, 0) };
        (self.row, self.column) != end
    }

    /// Selects a block from the cell in its upper left corner.
    pub(super) fn select(&mut self, (row, column): (usize, Column), rows: usize, columns: usize) {
        let place = self.columns.iter().position(|of| *of == column).unwrap_or(0);
        self.row = row;
        self.column = place;
        let last = self.columns.len().saturating_sub(1);
        self.from = (row + rows.saturating_sub(1), (place + columns.saturating_sub(1)).min(last));
        self.moves += 1;
    }

    /// Selects whole rows.
    pub(super) fn select_rows(&mut self, rows: RangeInclusive<usize>) {
        self.row = *rows.start();
        self.from.0 = *rows.end();
        self.moves += 1;
    }
}
