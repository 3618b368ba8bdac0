//! The rows of a plan's table: inserted, deleted, moved and sorted; and the balloons of their features.
//!
//! A feature without a name is called by its place, and values are known by the names of their features. So names are written before
//! a row gets another place.

use fitcheck_core::part::{Column, Draft, DraftFeature, MOST_FEATURES};
use fitcheck_core::tolerance::Sources;

use super::document::Typing;
use super::draft_cells::{clamped, place, write};
use super::picture::NUDGE;
use super::{PartsPage, PlanCommand, sorting};
use crate::Step;

impl PartsPage {
    /// Inserts, deletes and moves rows, and places balloons.
    pub(super) fn edit_rows(&mut self, command: &PlanCommand, sources: &Sources) {
        let (row, column) = self.sheet.at();
        match command {
            PlanCommand::Insert => {
                let is_room = self.document.draft().rows.len() < MOST_FEATURES;
                self.document.change(sources, |draft| {
                    if is_room {
                        write_names(draft);
                        let at = row.min(draft.rows.len());
                        draft.rows.insert(at, fresh(draft, at));
                    }
                });
                self.sheet.go(row, column, false, &self.document);
            }
            PlanCommand::Delete => {
                let rows = self.sheet.selected_rows();
                self.document.change(sources, |draft| {
                    let rows = clamped(&rows, draft.rows.len());
                    write_names(draft);
                    draft.rows.drain(rows);
                });
                self.sheet.go(*rows.start(), column, false, &self.document);
            }
            PlanCommand::MoveRows(step) => self.move_rows(*step == Step::Up, sources),
            PlanCommand::PlaceBalloon { row, at, is_done } => {
                self.document.type_into(Typing::Balloon(*row), sources, |draft| place(draft, *row, *at));
                if *is_done {
                    self.document.settle();
                }
            }
            PlanCommand::NudgeBalloon(row, step) => {
                let at = self.balloons().get(*row).and_then(|balloon| balloon.at);
                if let Some([x, y]) = at {
                    let at = match step {
                        Step::Left => [x - NUDGE, y],
                        Step::Right => [x + NUDGE, y],
                        Step::Up => [x, y - NUDGE],
                        Step::Down => [x, y + NUDGE],
                        _ => [x, y],
                    };
                    self.document.change(sources, |draft| place(draft, *row, at));
                }
            }
            PlanCommand::RemoveBalloon(row) => self.document.change(sources, |draft| {
                if let Some(row) = draft.rows.get_mut(*row) {
                    write(row, Column::BalloonX, "");
                    write(row, Column::BalloonY, "");
                }
            }),
            // Every other command is done elsewhere.
            _ => {}
        }
    }

    pub(super) fn sort(&mut self, column: Column, sources: &Sources) {
        let text = |row: &DraftFeature| row.cell(column).text.clone();
        let is_sorted = self
            .document
            .draft()
            .rows
            .is_sorted_by(|one, other| sorting::order(&one.cell(column).text, &other.cell(column).text).is_le());
        self.document.change(sources, |draft| {
            write_names(draft);
            draft.rows.sort_by(|one, other| {
                let order = sorting::order(&text(one), &text(other));
                // Empty cells stay last.
                let is_empty = one.text(column).is_none() || other.text(column).is_none();
                if is_sorted && !is_empty { order.reverse() } else { order }
            });
        });
    }

    fn move_rows(&mut self, up: bool, sources: &Sources) {
        let rows = clamped(&self.sheet.selected_rows(), self.document.draft().rows.len());
        let can = if up { 0 < rows.start } else { rows.end < self.document.draft().rows.len() };
        if !can || rows.is_empty() {
            return;
        }
        self.document.change(sources, |draft| {
            write_names(draft);
            let around = if up { rows.start - 1..rows.end } else { rows.start..rows.end + 1 };
            if let Some(around) = draft.rows.get_mut(around) {
                if up { around.rotate_left(1) } else { around.rotate_right(1) }
            }
        });
        let moved = if up { rows.start - 1..=rows.end - 2 } else { rows.start + 1..=rows.end };
        self.sheet.select_rows(moved);
    }
}

/// What a feature without a name is called.
fn name_of_place(row: usize) -> String {
    format!("F{}", row + 1)
}

/// Writes the names of all features that are called by their places.
fn write_names(draft: &mut Draft) {
    for (at, row) in draft.rows.iter_mut().enumerate() {
        if row.text(Column::Name).is_none() && !row.is_empty() {
            row.set(Column::Name, name_of_place(at));
        }
    }
}

/// A new row: it has a name where another feature is called by its place.
pub(super) fn fresh(draft: &Draft, at: usize) -> DraftFeature {
    let is_taken = |name: &str| {
        let names = draft.rows.iter().filter_map(|row| row.text(Column::Name));
        names.into_iter().any(|taken| taken.eq_ignore_ascii_case(name))
    };
    let mut row = DraftFeature::default();
    if is_taken(&name_of_place(at)) {
        // Of one more names than there are rows, one is free.
        let count = draft.rows.len();
        if let Some(free) = (count..=2 * count).map(name_of_place).find(|name| !is_taken(name)) {
            row.set(Column::Name, free);
        }
    }
    row
}
