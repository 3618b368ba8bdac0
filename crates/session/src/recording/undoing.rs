//! Undo has taken checks back: a record of them that nobody withdraws would count, and come back at the next start. Those of one step are
//! withdrawn as one batch, once all of them are written; what could not be written is not written any more.

use std::collections::BTreeSet;

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::journal::entry::{Content, Correction};
use fitcheck_exchange::journal::query::RecordId;

use super::{Known, Recording, RecordingState};

/// How many ranges of numbers a notice names.
const NAMED: usize = 5;

/// Checks that undo has taken back in one step, until all of their records are written.
#[derive(Debug)]
pub(super) struct Undone {
    /// How many checks.
    checks: usize,
    /// What has to be withdrawn.
    records: Vec<Known>,
    reason: String,
    /// Who took them back: somebody else may measure once they are written.
    by: String,
}

/// Withdrawals that were sent as one batch.
#[derive(Debug)]
pub(super) struct Withdrawing {
    checks: usize,
    numbers: Vec<u64>,
}

impl Recording {
    /// Checks of the history are taken back; `standing` are those of them, and of what stands in their place, whose records count.
    /// Returns whether anything of them is recorded or on its way.
    pub(crate) fn take_back(&mut self, taken: &BTreeSet<RecordId>, standing: &[RecordId], reason: String) -> bool {
        let records: Vec<Known> = standing.iter().filter_map(|id| self.checks.remove(id)).collect();
        // What was taken back is not measured: its serial number is free again.
        self.checks.retain(|id, _| !taken.contains(id));
        let is_recorded = |known: &Known| {
            let batch = self.batches.get(&known.slip.0);
            batch.is_some_and(|batch| !matches!(batch.fate, RecordingState::Refused(_)))
        };
        let records: Vec<Known> = records.into_iter().filter(is_recorded).collect();
        let has_any = !records.is_empty();
        if has_any {
            self.undone.push(Undone { checks: taken.len(), records, reason, by: self.who().to_owned() });
        }
        has_any
    }

    /// Sends the withdrawals of steps whose records are all written, and gives up what could not be. Returns what is to be said of steps of
    /// which nothing was written.
    pub(crate) fn go_on_undoing(&mut self) -> Vec<Message> {
        let mut told = Vec::new();
        for mut undone in std::mem::take(&mut self.undone) {
            self.give_up(&mut undone);
            if undone.records.is_empty() {
                told.push(message!("records-page-taken-back-unwritten").count("checks", undone.checks));
            } else if undone.records.iter().all(|known| self.is_written(known)) {
                self.withdraw(undone);
            } else {
                self.undone.push(undone);
            }
        }
        told
    }

    /// A batch that could not be written and of which all is taken back is not tried again.
    fn give_up(&mut self, undone: &mut Undone) {
        let runs: BTreeSet<u64> = undone.records.iter().map(|known| known.slip.0).collect();
        for run in runs {
            let of_run = undone.records.iter().filter(|known| known.slip.0 == run).count();
            let is_lost = self
                .batches
                .get(&run)
                .is_some_and(|batch| matches!(batch.fate, RecordingState::Failed(_)) && batch.entries.len() == of_run);
            if is_lost {
                self.batches.remove(&run);
                undone.records.retain(|known| known.slip.0 != run);
            }
        }
    }

    fn is_written(&self, known: &Known) -> bool {
        self.head_of_slip(known.slip).is_some()
    }

    fn withdraw(&mut self, undone: Undone) {
        let Undone { checks, records, reason, by } = undone;
        let mut numbers = Vec::new();
        let mut entries = Vec::new();
        for known in records {
            let Some(target) = self.head_of_slip(known.slip) else { continue };
            numbers.push(target.number);
            let correction = Correction { target, reason: reason.clone(), by: by.clone() };
            entries.push(self.entry(&known.named, Content::Withdrawal(correction)));
        }
        if let Some(run) = self.send(entries) {
            self.withdrawing.insert(run, Withdrawing { checks, numbers });
        }
    }

    /// The journal has answered about a batch of withdrawals: what is to be said, and the numbers of the records that no longer count.
    pub(crate) fn withdrawn(&mut self, run: u64) -> Option<(Message, Vec<u64>)> {
        if !matches!(self.batches.get(&run)?.fate, RecordingState::Kept(_)) {
            return None;
        }
        let Withdrawing { checks, numbers } = self.withdrawing.remove(&run)?;
        let said = message!("records-page-taken-back").count("checks", checks).count("records", numbers.len());
        Some((said.text("numbers", ranges(&numbers)), numbers))
    }

    /// The records of a batch of withdrawals that could not be written, as a text.
    pub(crate) fn not_withdrawn(&self, run: u64) -> Option<(usize, String)> {
        let is_failed = matches!(self.batches.get(&run)?.fate, RecordingState::Failed(_));
        let withdrawing = self.withdrawing.get(&run).filter(|_| is_failed)?;
        Some((withdrawing.numbers.len(), ranges(&withdrawing.numbers)))
    }
}

/// Numbers as people read them: `88`, `88 … 92, 95`.
fn ranges(numbers: &[u64]) -> String {
    let mut sorted = numbers.to_vec();
    sorted.sort_unstable();
    let mut ranges: Vec<(u64, u64)> = Vec::new();
    for number in sorted {
        match ranges.last_mut() {
            Some((_, last)) if last.checked_add(1) == Some(number) => *last = number,
            _ => ranges.push((number, number)),
        }
    }
    let more = if NAMED < ranges.len() { ", …" } else { "" };
    let named = ranges.into_iter().take(NAMED);
    let named = named.map(|(first, last)| if first == last { first.to_string() } else { format!("{first} … {last}") });
    named.collect::<Vec<_>>().join(", ") + more
}

#[cfg(test)]
mod tests {
    use super::ranges;

    #[test]
    fn numbers_in_a_row_are_one_range() {
        assert_eq!(ranges(&[88]), "88");
        assert_eq!(ranges(&[90, 88, 89, 95]), "88 … 90, 95");
        assert_eq!(ranges(&[1, 3, 5, 7, 9, 11]), "1, 3, 5, 7, 9, …");
    }
}
