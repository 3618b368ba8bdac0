//! A report was written: the journal is told which file it was, and which of its checks it has.
//!
//! What cannot be recorded is told, and the file stays: it is whole, and whoever wants the journal to know it writes it again.

use fitcheck_core::message::{Message, Say as _};
use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::{Content, Reported, Shown};
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_exchange::journal::ranges::EntryRanges;

use super::{Keeping, Named, Recorded, Recording, RecordingState};

impl Recording {
    /// The number of a check of the history in the journal; `None` as long as it is not on disk.
    pub(crate) fn number_of(&self, id: RecordId) -> Option<u64> {
        match self.of_check(id)? {
            Recorded::Kept(number) => Some(number),
            Recorded::Waiting | Recorded::Failed(_) => None,
        }
    }

    /// What a report shows of the journal, by the numbers of its checks; `None` of a check that the journal does not have. `newest` is an
    /// entry of the journal that was read and may be behind what this window knows. Nothing where no journal is open, or where it has none
    /// of the checks.
    pub(crate) fn shown(&self, checks: impl IntoIterator<Item = Option<u64>>, newest: Option<Head>) -> Option<Shown> {
        let own = self.journal.as_ref().filter(|_| self.keeping == Keeping::Open)?.head;
        let head = newest.into_iter().chain([own]).max_by_key(|head| head.number);
        let mut unrecorded = 0_u64;
        let mut numbers = Vec::new();
        for number in checks {
            match number {
                Some(number) => numbers.push(number),
                None => unrecorded = unrecorded.saturating_add(1),
            }
        }
        let checks = EntryRanges::of(numbers);
        (!checks.is_empty()).then_some(Shown { checks, unrecorded, head })
    }

    /// Sends that a report was written. Returns why it can be no entry of the journal, such as checks in more ranges than an entry has.
    pub(crate) fn keep_report(&mut self, report: Reported) -> Option<Message> {
        let name = report.name.clone();
        let entry = self.entry(&Named::default(), Content::Report(report));
        if let Err(error) = body::write(&entry) {
            return Some(error.message());
        }
        let run = self.send(vec![entry])?;
        self.reports.insert(run, name);
        None
    }

    /// The file of a batch that tells of a report and could not be written: it is not tried again.
    pub(crate) fn unknown_report(&mut self, run: u64) -> Option<String> {
        let name = self.reports.remove(&run)?;
        let is_failed = self.batches.get(&run).is_some_and(|batch| matches!(batch.fate, RecordingState::Failed(_)));
        is_failed.then(|| {
            self.batches.remove(&run);
            name
        })
    }
}
