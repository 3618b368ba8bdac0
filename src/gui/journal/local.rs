//! The journal of this station, in its file.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Journals, Keeps, ReadError, Reads};
use crate::files;
use crate::journal::ask::Question;
use crate::journal::chain::Head;
use crate::journal::entry::{Entry, Moment};
use crate::message::{Message, Say as _, message};
use crate::session::records::Verified;
use crate::session::{OpenJournal, RecordRow};
use crate::store::local::{self, Anchors, Journal, ListedEntry, Opening, Reader};
use crate::store::{StoreError, StoreRemark, is_server};

/// Journals in files of this computer.
#[derive(Debug, Clone)]
pub struct Local {
    /// Where the last entries of journals are kept besides.
    anchors: Option<PathBuf>,
}

impl Local {
    /// The last entries are kept with the user's settings.
    pub fn of_user() -> Self {
        Self { anchors: Anchors::of_user() }
    }

    /// The last entries are kept in this file, or nowhere.
    pub const fn with_anchors(anchors: Option<PathBuf>) -> Self {
        Self { anchors }
    }

    /// The usual file of a user, or the one that `FITCHECK_JOURNAL` names; `None` where there is no data folder. The window keeps
    /// its records in a file, whatever server gets them afterwards.
    pub fn usual() -> Option<PathBuf> {
        let named = std::env::var("FITCHECK_JOURNAL").ok().filter(|text| !text.is_empty() && !is_server(text));
        named.map(PathBuf::from).or_else(|| files::journal_folder().map(|folder| folder.join(local::FILE)))
    }
}

fn failed(error: StoreError) -> ReadError {
    match error {
        StoreError::Interrupted => ReadError::Interrupted,
        error => ReadError::Failed(error.message()),
    }
}

impl Journals for Local {
    fn open(&self, file: &Path, station: &str, now: &Moment) -> Result<(Box<dyn Keeps>, Box<OpenJournal>), Message> {
        let opening = Opening { anchors: self.anchors.clone(), ..Opening::new(station, now.clone()) };
        let journal = Journal::open(file, &opening).map_err(|error| error.message())?;
        let remarks = journal.remarks().iter().filter(|remark| !matches!(remark, StoreRemark::Begun { .. }));
        let remarks = remarks.map(crate::message::Say::message).collect();
        let opened =
            OpenJournal { chain: journal.chain(), head: journal.head().map_err(|error| error.message())?, remarks };
        Ok((Box::new(journal), Box::new(opened)))
    }

    fn reader(&self, file: &Path) -> Result<Box<dyn Reads>, Message> {
        Ok(Box::new(Reader::open(file).map_err(|error| error.message())?))
    }

    fn bodies(&self, file: &Path, see: &mut dyn FnMut(&[u8])) -> Result<(), Message> {
        let reader = Reader::open(file).map_err(|error| error.message())?;
        let mut from = 1;
        loop {
            let entries = reader.entries(from, 1_000).map_err(|error| error.message())?;
            let Some(last) = entries.last() else { return Ok(()) };
            from = last.head.number + 1;
            for kept in &entries {
                see(&kept.body);
            }
        }
    }

    fn verify(&self, file: &Path, progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>) -> Result<Verified, Message> {
        let chain = Reader::open(file).map_err(|error| error.message())?.chain();
        let anchors = self.anchors.as_deref().map(Anchors::read);
        let mut problems = Vec::new();
        let known = match anchors {
            Some(Ok(anchors)) => anchors.of_chain(chain),
            Some(Err(why)) => {
                problems.push(message!("records-page-no-anchors").text("why", why));
                Vec::new()
            }
            None => Vec::new(),
        };
        let found = local::verify(file, &known, progress).map_err(|error| error.message())?;
        problems.extend(found.inspected.breaks.iter().map(crate::message::Say::message));
        problems.extend(found.findings.iter().map(crate::message::Say::message));
        Ok(Verified { entries: found.inspected.entries, head: found.inspected.head, problems })
    }
}

impl Keeps for Journal {
    fn append(&mut self, entries: &[Entry]) -> Result<Vec<Head>, Message> {
        let kept = Self::append(self, entries).map_err(|error| error.message())?;
        Ok(kept.into_iter().map(|kept| kept.head).collect())
    }
}

impl Reads for Reader {
    fn newest(&self) -> Result<Head, ReadError> {
        self.head().map_err(failed)
    }

    fn numbers(&self, question: &Question, before: Option<u64>, most: usize) -> Result<Vec<u64>, ReadError> {
        Self::numbers(self, question, before, most).map_err(failed)
    }

    fn rows(&self, numbers: &[u64]) -> Result<Vec<RecordRow>, ReadError> {
        Ok(Self::rows(self, numbers).map_err(failed)?.into_iter().map(row).collect())
    }

    fn reports_of(&self, number: u64) -> Result<Vec<RecordRow>, ReadError> {
        let numbers = Self::reports_of(self, number).map_err(failed)?;
        Ok(Self::rows(self, &numbers).map_err(failed)?.into_iter().map(row).collect())
    }

    fn interrupt(&self) -> Arc<dyn Fn() + Send + Sync> {
        let interrupt = Self::interrupt(self);
        Arc::new(move || interrupt.stop())
    }
}

fn row(row: ListedEntry) -> RecordRow {
    let ListedEntry { kept, entry, corrected_by } = row;
    RecordRow { head: kept.head, entry: entry.map_err(|error| error.message()), corrected_by, went_back: false }
}
