//! What can be done with the list of checks, and doing it.

use fitcheck_core::words::Words;
use fitcheck_exchange::journal::query::{Column, Query, Records as _, Sort};

use super::History;
use crate::Step;

/// What can be done with the list of checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ListCommand {
    /// Goes to another row.
    Move(Step),
    /// Sorts by a column, the other way round the second time; the third time the newest check is first again.
    SortBy(Column),
    /// Leaves the good ones out of the list, or shows them again.
    OnlyBad(bool),
    /// Chooses every check of the list for export.
    ChooseAll,
    /// Chooses every check of the list that is not good, and no other one.
    ChooseBad,
    ChooseNone,
    /// Puts the chosen rows on the clipboard, or the row at which the keys are.
    Copy,
}

impl History {
    /// Does something with the list; returns the text for the clipboard, in these words, where one is asked for.
    pub(crate) fn apply(&mut self, command: ListCommand, words: impl FnOnce() -> Words) -> Option<String> {
        match command {
            ListCommand::Move(step) => self.move_by(step),
            ListCommand::SortBy(column) => {
                let sort = match self.records.query().sort {
                    Some(Sort { column: by, ascending: true }) if by == column => {
                        Some(Sort { column, ascending: false })
                    }
                    Some(Sort { column: by, ascending: false }) if by == column => None,
                    _ => Some(Sort { column, ascending: true }),
                };
                self.ask(Query { sort, ..self.records.query().clone() });
            }
            ListCommand::OnlyBad(only_bad) => self.ask(Query { only_bad, ..self.records.query().clone() }),
            ListCommand::ChooseAll => {
                let listed = self.records.page(0..self.records.count()).into_iter().map(|(id, _)| id);
                self.chosen.extend(listed.filter(|id| self.records.replaced_by(*id).is_none()));
            }
            ListCommand::ChooseBad => {
                let listed = self.records.page(0..self.records.count()).into_iter();
                let bad = listed.filter(|(_, record)| record.verdict.asks_for_a_look()).map(|(id, _)| id);
                self.chosen = bad.filter(|id| self.records.replaced_by(*id).is_none()).collect();
                self.count_hidden();
            }
            ListCommand::ChooseNone => {
                self.chosen.clear();
                self.hidden = 0;
            }
            ListCommand::Copy => return self.copied(&words()),
        }
        None
    }

    /// Moves the cursor. A cursor that is not in the list counts as before its first row.
    fn move_by(&mut self, step: Step) {
        let Some(last) = self.records.count().checked_sub(1) else { return };
        let here = self.cursor.and_then(|id| self.records.place_of(id));
        let place = step.place(here, last);
        if let Some((id, _)) = self.records.page(place..place + 1).first() {
            self.go_to(*id);
        }
    }
}
