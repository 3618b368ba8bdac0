//! Which records answer a question, batch by batch, and rows by their numbers. A newer question ends the one before; rows that are in
//! sight do not wait for the end of a long list.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::time::Duration;

use eframe::egui::Context;

use super::{Interrupt, Journals, ReadError, Reads, lock, say};
use crate::journal::ask::Question;
use crate::journal::chain::Head;
use crate::message::message;
use crate::session::parts::WalkCommand;
use crate::session::records::{FoundNumbers, Numbers, PAGE};
use crate::session::{Command, PaletteCommand, RecordRow, RecordsCommand};

/// How long nobody may type before a question is asked.
const REST: Duration = Duration::from_millis(120);

/// How often a part is asked for again that somebody has interrupted.
const TRIES: usize = 10;

/// How many numbers are found together after the first page.
const BATCH: usize = 50_000;

/// The first entry of a journal is its beginning, and no check.
const OLDEST: u64 = 2;

/// Something to find or to read.
pub(super) enum FinderRequest {
    /// The journal is in this file.
    File(PathBuf),
    Question {
        run: u64,
        question: Box<Question>,
        rests: bool,
        ctx: Context,
    },
    Rows {
        numbers: Vec<u64>,
        ctx: Context,
    },
    /// The reports that show a record.
    Reports {
        number: u64,
        ctx: Context,
    },
    /// A few of the newest records, for the palette.
    Few {
        run: u64,
        question: Box<Question>,
        most: usize,
        ctx: Context,
    },
    /// Everything that answers a question, the oldest first.
    Part {
        run: u64,
        question: Box<Question>,
        most: usize,
        ctx: Context,
    },
}

/// A question that is being answered.
struct Open {
    run: u64,
    question: Box<Question>,
    before: Option<u64>,
    ctx: Context,
}

/// The one who finds and reads.
pub(super) struct Finder {
    journals: Arc<dyn Journals>,
    interrupt: Interrupt,
    newest: Arc<AtomicU64>,
    newest_few: Arc<AtomicU64>,
    file: Option<PathBuf>,
    reader: Option<Box<dyn Reads>>,
}

impl Finder {
    /// `newest` are the numbers of the newest questions: of the records page, and of the palette.
    pub fn new(journals: Arc<dyn Journals>, interrupt: Interrupt, newest: [Arc<AtomicU64>; 2]) -> Self {
        let [newest, newest_few] = newest;
        Self { journals, interrupt, newest, newest_few, file: None, reader: None }
    }

    /// Answers until the window is gone.
    pub fn run(mut self, asked: &Receiver<FinderRequest>, answers: &Sender<Command>) {
        let mut open: Option<Open> = None;
        loop {
            let next = match (&open, asked.try_recv()) {
                (_, Ok(next)) => Some(next),
                (_, Err(TryRecvError::Disconnected)) => return,
                (Some(_), Err(TryRecvError::Empty)) => None,
                (None, Err(TryRecvError::Empty)) => match asked.recv() {
                    Ok(next) => Some(next),
                    Err(_closed) => return,
                },
            };
            match next {
                Some(FinderRequest::Question { run, question, rests, ctx }) => {
                    let asking = Open { run, question, before: None, ctx };
                    let rested = if rests { self.rest(asking, asked, answers) } else { Some(asking) };
                    let Some(rested) = rested else { return };
                    open = Some(rested);
                }
                Some(other) => self.serve(other, answers),
                None => open = open.take().and_then(|open| self.go_on(open, answers)),
            }
        }
    }

    /// Waits until nobody types; the newest question is asked. `None` where the window is gone.
    fn rest(&mut self, first: Open, asked: &Receiver<FinderRequest>, answers: &Sender<Command>) -> Option<Open> {
        let mut open = first;
        loop {
            match asked.recv_timeout(REST) {
                Ok(FinderRequest::Question { run, question, rests, ctx }) => {
                    open = Open { run, question, before: None, ctx };
                    if !rests {
                        return Some(open);
                    }
                }
                Ok(other) => self.serve(other, answers),
                Err(RecvTimeoutError::Timeout) => return Some(open),
                Err(RecvTimeoutError::Disconnected) => return None,
            }
        }
    }

    /// Everything at once, for tests.
    pub fn at_once(&mut self, asked: FinderRequest) -> Vec<Command> {
        let (answers, commands) = std::sync::mpsc::channel();
        match asked {
            FinderRequest::Question { run, question, ctx, .. } => {
                let mut open = Some(Open { run, question, before: None, ctx });
                while let Some(next) = open.take() {
                    open = self.go_on(next, &answers);
                }
            }
            other => self.serve(other, &answers),
        }
        commands.try_iter().collect()
    }

    /// Finds the next batch; returns the question where there is more.
    fn go_on(&mut self, mut open: Open, answers: &Sender<Command>) -> Option<Open> {
        if self.newest.load(Relaxed) != open.run {
            return None;
        }
        let most = if open.before.is_none() { PAGE } else { BATCH };
        let result = self.with_reader(|reader| {
            if *open.question == Question::default() {
                // Every number is listed: a chain has no gaps.
                let newest = reader.newest()?.number;
                return Ok(FoundNumbers { numbers: Numbers::All { newest, oldest: OLDEST }, is_end: true });
            }
            let numbers = reader.numbers(&open.question, open.before, most)?;
            Ok(FoundNumbers { is_end: numbers.len() < most, numbers: Numbers::These(numbers) })
        });
        if self.newest.load(Relaxed) != open.run {
            return None;
        }
        let (result, goes_on) = match result {
            // Somebody else's interruption: once more.
            Err(ReadError::Interrupted) => return Some(open),
            Err(ReadError::Failed(why)) => (Err(why), false),
            Ok(found) => {
                if let Numbers::These(numbers) = &found.numbers {
                    open.before = numbers.last().copied().or(open.before);
                }
                let goes_on = !found.is_end;
                (Ok(found), goes_on)
            }
        };
        say(answers, &open.ctx, RecordsCommand::Found { run: open.run, result });
        goes_on.then_some(open)
    }

    fn serve(&mut self, asked: FinderRequest, answers: &Sender<Command>) {
        match asked {
            FinderRequest::File(file) => {
                self.file = Some(file);
                self.reader = None;
            }
            FinderRequest::Rows { numbers, ctx } => {
                let wanted = with_those_before(&numbers);
                let mut result = self.with_reader(|reader| reader.rows(&wanted));
                if result == Err(ReadError::Interrupted) {
                    result = self.with_reader(|reader| reader.rows(&wanted));
                }
                let result = match result {
                    Ok(rows) => Ok(whole(&numbers, rows)),
                    Err(ReadError::Failed(why)) => Err(why),
                    // It is asked for again where it is still in sight.
                    Err(ReadError::Interrupted) => Ok(Vec::new()),
                };
                say(answers, &ctx, RecordsCommand::Read { numbers, result });
            }
            FinderRequest::Reports { number, ctx } => {
                // Somebody else's interruption: once more.
                let mut result = self.with_reader(|reader| reader.reports_of(number));
                for _ in 0..TRIES {
                    if result == Err(ReadError::Interrupted) {
                        result = self.with_reader(|reader| reader.reports_of(number));
                    }
                }
                let result = match result {
                    Ok(rows) => Ok(rows.into_iter().map(Arc::new).collect()),
                    Err(ReadError::Failed(why)) => Err(why),
                    Err(ReadError::Interrupted) => Err(message!("records-page-interrupted")),
                };
                say(answers, &ctx, RecordsCommand::ReportsRead { number, result });
            }
            FinderRequest::Few { run, question, most, ctx } => {
                let read = |reader: &dyn Reads| {
                    let numbers = reader.numbers(&question, None, most)?;
                    Ok(whole(&numbers, reader.rows(&numbers)?))
                };
                for _ in 0..TRIES {
                    if self.newest_few.load(Relaxed) != run {
                        return;
                    }
                    // Somebody else's interruption: once more.
                    let result = match self.with_reader(read) {
                        Err(ReadError::Interrupted) => continue,
                        Err(ReadError::Failed(why)) => Err(why),
                        Ok(rows) => Ok(rows),
                    };
                    return say(answers, &ctx, PaletteCommand::Found { run, result });
                }
                let result = Err(message!("records-page-interrupted"));
                say(answers, &ctx, PaletteCommand::Found { run, result });
            }
            FinderRequest::Part { run, question, most, ctx } => {
                let read = |reader: &dyn Reads| {
                    let mut numbers = reader.numbers(&question, None, most)?;
                    numbers.sort_unstable();
                    reader.rows(&numbers)
                };
                // Somebody else's interruption: once more.
                let mut result = self.with_reader(read);
                for _ in 0..TRIES {
                    if result == Err(ReadError::Interrupted) {
                        result = self.with_reader(read);
                    }
                }
                let result = result.map_err(|error| match error {
                    ReadError::Failed(why) => why,
                    ReadError::Interrupted => message!("records-page-interrupted"),
                });
                say(answers, &ctx, WalkCommand::Came { run, result });
            }
            FinderRequest::Question { .. } => {}
        }
    }

    /// Asks the reader, which is opened where it is not.
    fn with_reader<T>(&mut self, ask: impl FnOnce(&dyn Reads) -> Result<T, ReadError>) -> Result<T, ReadError> {
        let reader = if let Some(reader) = self.reader.take() {
            reader
        } else {
            let file = self.file.as_ref().ok_or_else(|| ReadError::Failed(message!("records-page-none")))?;
            let reader = self.journals.reader(file).map_err(ReadError::Failed)?;
            *lock(&self.interrupt) = Some(reader.interrupt());
            reader
        };
        let result = ask(reader.as_ref());
        // One that has failed is opened anew.
        self.reader = (!matches!(result, Err(ReadError::Failed(_)))).then_some(reader);
        result
    }
}

/// These numbers and those before them: an entry that was written with an earlier clock than the one before it is marked.
fn with_those_before(numbers: &[u64]) -> Vec<u64> {
    let before = numbers.iter().filter_map(|number| number.checked_sub(1)).filter(|number| 0 < *number);
    let mut all: Vec<u64> = numbers.iter().copied().chain(before).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// The rows in the order in which they were asked for; one that is not there says so.
fn whole(numbers: &[u64], rows: Vec<RecordRow>) -> Vec<Arc<RecordRow>> {
    let rows: BTreeMap<u64, RecordRow> = rows.into_iter().map(|row| (row.head.number, row)).collect();
    let time = |number: u64| Some(rows.get(&number)?.entry.as_ref().ok()?.about.time.utc_ms);
    let row = |number: &u64| {
        let went_back =
            number.checked_sub(1).and_then(time).zip(time(*number)).is_some_and(|(before, now)| now < before);
        Arc::new(rows.get(number).map_or_else(
            || RecordRow {
                head: Head { number: *number, ..Head::default() },
                entry: Err(message!("records-page-missing").text("number", number)),
                corrected_by: None,
                went_back: false,
            },
            |row| RecordRow { went_back, ..row.clone() },
        ))
    };
    numbers.iter().map(row).collect()
}
