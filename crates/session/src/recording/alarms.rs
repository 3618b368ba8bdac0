//! Alarms of control charts and their answers on their way to the journal.

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::journal::entry::Content;
use fitcheck_exchange::journal::{Alarm, body};

use super::{Named, Recording};

impl Recording {
    /// Sends alarms, or the answer to one, each of what it names. Returns the number of the batch.
    ///
    /// # Errors
    /// Why one can be no entry of a journal, or that nothing is recorded; then none is sent.
    pub(crate) fn keep_alarms(&mut self, alarms: Vec<(Named, Alarm)>) -> Result<u64, Message> {
        let entry = |(named, alarm): (Named, Alarm)| self.entry(&named, Content::Alarm(Box::new(alarm)));
        let entries: Vec<_> = alarms.into_iter().map(entry).collect();
        if let Some(error) = entries.iter().find_map(|entry| body::write(entry).err()) {
            return Err(error.message());
        }
        self.send(entries).ok_or_else(|| message!("records-page-not-recording"))
    }
}
