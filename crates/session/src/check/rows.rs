//! The rows of a large file on the check page: they stand in the place of the history, and the check of one of them is
//! shown where checks are shown.

use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_exchange::journal::entry::FileRole;
use jiff::civil::DateTime;

use super::{CheckField, CheckPage};
use crate::effect::Effect;
use crate::history::filter_words;
use crate::recording::used;
use crate::rows::{Rows, RowsCommand};
use crate::shared::Shared;
use crate::state::PageState as _;

impl CheckPage {
    /// Does something with the rows of a large file.
    pub(super) fn apply_rows(&mut self, command: RowsCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        if let RowsCommand::Opened { name, result } = command {
            let Some((path, large)) = shared.file_answered(result) else { return Vec::new() };
            self.runs += 1;
            let (rows, effects) = Rows::begin(self.runs, name, path, large);
            self.clear(&shared.sources);
            self.texts.set(CheckField::RowsFilter, "");
            self.rows = Some(rows);
            self.shows_rows = true;
            return effects;
        }
        let Some(rows) = &mut self.rows else { return Vec::new() };
        match command {
            RowsCommand::Opened { .. } => {}
            RowsCommand::Judged { run, news } => {
                let was_running = rows.is_running();
                let mut effects = rows.judged(run, *news, &shared.sources);
                if was_running && rows.is_whole() && self.is_untouched() {
                    effects.extend(self.show_worst(shared, now));
                }
                return effects;
            }
            RowsCommand::Cancel => return rows.cancel(&shared.sources),
            RowsCommand::Again => return self.judge_again(),
            RowsCommand::Close => {
                self.shows_rows = false;
                self.rows = None;
                return vec![Effect::StopRows];
            }
            RowsCommand::Show(shows_rows) => self.shows_rows = shows_rows,
            RowsCommand::Fate(fate) => return rows.toggle_fate(fate, &shared.sources),
            RowsCommand::Class(class) => return rows.toggle_class(Some(class), &shared.sources),
            RowsCommand::AllClasses => return rows.toggle_class(None, &shared.sources),
            RowsCommand::WorstFirst(is_worst_first) => return rows.put_worst_first(is_worst_first, &shared.sources),
            RowsCommand::Sifted { run, number, result } => rows.take_sifted(run, number, result),
            RowsCommand::Worst => return self.show_worst(shared, now),
            RowsCommand::See(places) => return rows.see(&places),
            RowsCommand::Read { run, result } => {
                if let Some(number) = rows.take_read(run, result) {
                    self.show_row(number, shared, now);
                }
            }
            RowsCommand::Move(step) => rows.step(step),
            RowsCommand::Check(number) => {
                let effects = rows.go_to(number);
                self.show_row(number, shared, now);
                return effects;
            }
            RowsCommand::Keep => {
                if let Some((record, labels)) =
                    rows.shown.as_ref().and_then(|row| row.record.clone().zip(row.labels.clone()))
                {
                    let file = rows.sha256.and_then(|sha256| used(FileRole::Measurements, &rows.name, Some(sha256)));
                    let id = shared.history.add(vec![Arc::clone(&record)]);
                    self.keep(id, (&[record], &[labels]), file.as_ref(), shared);
                    shared.note(message!("rows-kept"), Vec::new());
                    shared.note_change();
                }
            }
        }
        Vec::new()
    }

    /// Whether nobody has shown a check or typed a value since the file was opened.
    fn is_untouched(&self) -> bool {
        self.shows_rows && self.shown.is_none() && self.text(CheckField::Measured).trim().is_empty()
    }

    /// Shows the worst row so far.
    fn show_worst(&mut self, shared: &Shared, now: DateTime) -> Vec<Effect> {
        let Some((rows, number)) = self.rows.as_mut().and_then(|rows| rows.worst().map(|number| (rows, number))) else {
            return Vec::new();
        };
        let effects = rows.go_to(number);
        self.show_row(number, shared, now);
        effects
    }

    /// Lists the rows that have the words of the filter.
    pub(super) fn filter_rows(&mut self, shared: &Shared) -> Vec<Effect> {
        let words = filter_words(self.text(CheckField::RowsFilter), &shared.words());
        self.rows.as_mut().map_or_else(Vec::new, |rows| rows.find(words, &shared.sources))
    }

    /// Judges the file once more, as its limits come from elsewhere now, or because the user asks for it.
    pub(super) fn judge_again(&mut self) -> Vec<Effect> {
        let Some(rows) = &self.rows else { return Vec::new() };
        self.runs += 1;
        let (rows, effects) = rows.again(self.runs);
        self.rows = Some(rows);
        effects
    }

    /// Shows the check of a row that was read, or why it has none. It does not go to the history.
    fn show_row(&mut self, number: u64, shared: &Shared, now: DateTime) {
        let Some(row) = self.rows.as_ref().and_then(|rows| rows.row(number, &shared.sources, now)) else { return };
        match &row.record {
            Some(record) => self.show_record(Arc::clone(record), None, shared),
            None => self.clear(&shared.sources),
        }
        if let Some(rows) = &mut self.rows {
            rows.show(row);
        }
    }

    /// Whether they are in sight, in the place of the history.
    pub const fn shows_rows(&self) -> bool {
        self.shows_rows && self.rows.is_some()
    }

    /// What has to be done outside because of what happened elsewhere.
    pub(crate) fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }
}
