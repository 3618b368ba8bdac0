//! Entries onto the disk, one batch after the other. A journal that has failed is opened anew before the next batch.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::Context;

use super::{Journals, Keeps, ReadError};
use crate::journal::ask::Question;
use crate::journal::chain::Head;
use crate::journal::entry::{Entry, Moment};
use crate::message::{Message, message};
use crate::session::{Command, OpenJournal, RecordRow, RecordsCommand};

/// Something to do for the writer.
pub(super) struct Job {
    pub ctx: Context,
    now: Moment,
    what: WriterTask,
}

enum WriterTask {
    Open { place: (PathBuf, String), newest: u64 },
    Keep { run: u64, entries: Vec<Entry> },
}

impl Job {
    pub fn open(ctx: &Context, place: (PathBuf, String), now: Moment, newest: u64) -> Self {
        Self { ctx: ctx.clone(), now, what: WriterTask::Open { place, newest } }
    }

    pub fn keep(ctx: &Context, now: Moment, run: u64, entries: Vec<Entry>) -> Self {
        Self { ctx: ctx.clone(), now, what: WriterTask::Keep { run, entries } }
    }

    /// The answer where nobody can do it.
    pub fn refused(self, why: Message) -> Command {
        match self.what {
            WriterTask::Open { .. } => RecordsCommand::Opened(Err(why)).into(),
            WriterTask::Keep { run, .. } => RecordsCommand::Kept { run, result: Err(why) }.into(),
        }
    }
}

/// The one who writes.
pub(super) struct Writer {
    journals: Arc<dyn Journals>,
    /// The file, and the name of the station.
    place: Option<(PathBuf, String)>,
    journal: Option<Box<dyn Keeps>>,
}

impl Writer {
    pub fn new(journals: Arc<dyn Journals>) -> Self {
        Self { journals, place: None, journal: None }
    }

    /// Does a job, and answers.
    pub fn work(&mut self, job: Job) -> Vec<Command> {
        let Job { now, what, .. } = job;
        match what {
            WriterTask::Open { place, newest } => {
                self.place = Some(place);
                let result = self.open(&now).and_then(|opened| Ok((opened, self.newest(newest)?)));
                vec![RecordsCommand::Opened(result).into()]
            }
            WriterTask::Keep { run, entries } => {
                // It failed before: what it holds now is looked at anew.
                let mut result = self.append(&now, &entries);
                if result.as_ref().is_err_and(|problem| problem.id == "store-moved") {
                    // Another program has set it aside: the one in its place takes the entries.
                    self.journal = None;
                    result = self.append(&now, &entries);
                }
                if result.is_err() {
                    self.journal = None;
                }
                vec![RecordsCommand::Kept { run, result }.into()]
            }
        }
    }

    fn append(&mut self, now: &Moment, entries: &[Entry]) -> Result<Vec<Head>, Message> {
        if self.journal.is_none() {
            self.open(now)?;
        }
        match &mut self.journal {
            Some(journal) => journal.append(entries),
            None => Err(message!("records-page-no-thread")),
        }
    }

    fn open(&mut self, now: &Moment) -> Result<Box<OpenJournal>, Message> {
        let (file, station) = self.place.as_ref().ok_or_else(|| message!("records-page-no-thread"))?;
        self.journal = None;
        let (journal, opened) = self.journals.open(file, station, now)?;
        self.journal = Some(journal);
        Ok(opened)
    }

    /// The newest checks that stand, the oldest of them first.
    fn newest(&self, most: u64) -> Result<Vec<RecordRow>, Message> {
        let Some((file, _)) = &self.place else { return Ok(Vec::new()) };
        let most = usize::try_from(most).unwrap_or(usize::MAX);
        let failed = |error| match error {
            ReadError::Interrupted => message!("records-page-interrupted"),
            ReadError::Failed(why) => why,
        };
        let reader = self.journals.reader(file)?;
        let question = Question { standing: true, ..Question::default() };
        let mut numbers = reader.numbers(&question, None, most).map_err(failed)?;
        numbers.sort_unstable();
        reader.rows(&numbers).map_err(failed)
    }
}
