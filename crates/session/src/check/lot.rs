//! The rows of an imported file: how many are good, rework, scrap or not judged, and which one is worst.

use std::sync::Arc;

use fitcheck_core::verdict::Status;
use fitcheck_exchange::exchange::Imported;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::query::RecordId;

use crate::Step;
use crate::history::History;

/// A file of measurements that was imported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lot {
    /// The file's name without its folder.
    pub name: String,
    /// How many rows or logs were read.
    pub rows: usize,
    counts: [usize; Status::ALL.len()],
    /// How many measurements were not judged, because nothing says what they should be.
    pub unjudged: usize,
    /// How many rows could not be used.
    pub refused: usize,
    /// How many judged values may be another quantity.
    pub doubted: usize,
    /// Record in the history and line in the file of every row that was judged, worst first.
    order: Vec<(RecordId, usize)>,
    /// Which of them is shown.
    at: usize,
}

impl Lot {
    /// The lot of a file whose records are in the history from `first` on.
    pub(super) fn new(name: &str, imported: &Imported, records: &[Arc<Record>], first: RecordId) -> Self {
        let status = |record: &Record| record.verdict.status();
        let count = |wanted: Status| records.iter().filter(|record| status(record) == wanted).count();
        let mut order: Vec<_> = records.iter().zip(&imported.lines).zip((first.0..).map(RecordId)).collect();
        // Worst first: by the word, then by how far the value is beyond a limit or from the nearer one; as in the file
        // where both are the same.
        order.sort_by_key(|((record, _), _)| {
            let size = &record.verdict.size;
            (std::cmp::Reverse(status(record)), size.above_minimum.min(size.below_maximum))
        });
        Self {
            name: name.to_owned(),
            rows: imported.rows,
            counts: Status::ALL.map(count),
            unjudged: imported.unjudged.len(),
            refused: imported.errors.len(),
            doubted: records.iter().filter(|record| record.doubt.is_some()).count(),
            order: order.into_iter().map(|((_, line), id)| (id, *line)).collect(),
            at: 0,
        }
    }

    /// The same after some of its records were judged again: the order stays, for somebody is looking at it.
    pub(super) fn counted_again(self, history: &History) -> Self {
        let statuses: Vec<Status> =
            self.records().filter_map(|id| history.get(id)).map(|record| record.verdict.status()).collect();
        let count = |wanted: Status| statuses.iter().filter(|status| **status == wanted).count();
        Self { counts: Status::ALL.map(count), ..self }
    }

    /// Its records in the history, the worst at first.
    pub(super) fn records(&self) -> impl Iterator<Item = RecordId> {
        self.order.iter().map(|(id, _)| *id)
    }

    /// How many rows have each status, best first.
    pub fn counts(&self) -> impl Iterator<Item = (Status, usize)> {
        Status::ALL.into_iter().zip(self.counts)
    }

    /// How many rows were judged.
    pub const fn judged(&self) -> usize {
        self.order.len()
    }

    /// Which row is shown, worst first, from 1, and its line in the file; `None` where none was judged.
    pub fn shown(&self) -> Option<(usize, usize)> {
        self.order.get(self.at).map(|(_, line)| (self.at + 1, *line))
    }

    /// The record in the history of the row that is shown.
    pub(super) fn record(&self) -> Option<RecordId> {
        self.order.get(self.at).map(|(id, _)| *id)
    }

    /// Goes to another row.
    pub(super) fn step(&mut self, step: Step) {
        let last = self.order.len().saturating_sub(1);
        self.at = match step {
            Step::First | Step::Top => 0,
            Step::Left | Step::Up | Step::PageUp => self.at.saturating_sub(1),
            Step::Right | Step::Down | Step::PageDown => (self.at + 1).min(last),
            Step::Last | Step::Bottom => last,
        };
    }

    /// Goes to a record of the history; `false` where it is not of this lot.
    pub(super) fn go_to(&mut self, id: RecordId) -> bool {
        let found = self.order.iter().position(|(of_row, _)| *of_row == id);
        self.at = found.unwrap_or(self.at);
        found.is_some()
    }
}
