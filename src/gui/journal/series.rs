//! The values of the statistics page, read on a thread of their own: a long series keeps no list waiting.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;

use super::{Journals, ReadError, Reads};
use crate::journal::ask::Question;
use crate::message::{Message, message};
use crate::series::{Gathering, MOST_READ};
use crate::session::statistics::SeriesFound;

/// How long nobody may type before a question is asked.
const REST: Duration = Duration::from_millis(200);

/// How many records are read together.
const BATCH: usize = 2_000;

/// A question, and the number of the newest one: an older one is given up.
pub(super) struct SeriesAsked {
    pub run: u64,
    pub newest: Arc<AtomicU64>,
    pub question: Box<Question>,
    /// So many values of a feature.
    pub most: usize,
    pub rests: bool,
}

impl SeriesAsked {
    fn is_given_up(&self) -> bool {
        self.newest.load(Relaxed) != self.run
    }

    /// Reads the values; `None` where the question was given up.
    pub fn read(&self, journals: &dyn Journals, file: Option<&Path>) -> Option<Result<Arc<SeriesFound>, Message>> {
        if self.rests {
            std::thread::sleep(REST);
        }
        if self.is_given_up() {
            return None;
        }
        let Some(file) = file else { return Some(Err(message!("records-page-none"))) };
        let reader = match journals.reader(file) {
            Ok(reader) => reader,
            Err(why) => return Some(Err(why)),
        };
        self.gather(reader.as_ref()).transpose()
    }

    fn gather(&self, reader: &dyn Reads) -> Result<Option<Arc<SeriesFound>>, Message> {
        let failed = |error: ReadError| match error {
            ReadError::Failed(why) => why,
            ReadError::Interrupted => message!("records-page-interrupted"),
        };
        // One more than is read shows whether there are older ones.
        let mut numbers = reader.numbers(&self.question, None, MOST_READ + 1).map_err(failed)?;
        let has_more = MOST_READ < numbers.len();
        numbers.truncate(MOST_READ);
        let mut found = SeriesFound { has_more, ..SeriesFound::default() };
        let mut gathering = Gathering::default();
        for batch in numbers.chunks(BATCH) {
            if self.is_given_up() {
                return Ok(None);
            }
            for row in reader.rows(batch).map_err(failed)? {
                found.read += 1;
                match &row.entry {
                    Ok(entry) => gathering.take(row.head.number, entry, row.corrected_by.is_some()),
                    Err(_told_on_its_page) => found.unread += 1,
                }
            }
        }
        found.features = gathering.finish(self.most).into_iter().map(Arc::new).collect();
        Ok(Some(Arc::new(found)))
    }
}
