//! The journal of the window, never on the frame's thread: one thread writes, one finds and reads, one walks the chain.
//!
//! | file | what |
//! |---|---|
//! | here | what the window needs of a journal, and who does it |
//! | `writer` | entries onto the disk, one batch after the other |
//! | `alarms` | rules that fire at the newest values, and open alarms |
//! | `finder` | which records answer a question, and rows |
//! | `series` | the values of the statistics page |
//! | `local` | the journal of this station |
//! | `shop`, `no_shop` | the server of the shop, or none |

mod alarms;
mod finder;
mod local;
mod series;
#[cfg(not(feature = "shop"))]
#[path = "no_shop.rs"]
mod shop;
#[cfg(feature = "shop")]
mod shop;
mod writer;

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

pub use crate::store::here::{computer, moment};
use eframe::egui::Context;
use finder::{Finder, FinderRequest};
use jiff::civil::DateTime;
use jiff::tz::TimeZone;
pub use local::Local;
use series::SeriesAsked;
use shop::Shop;
use writer::{Job, Writer};

use super::errands::Errands;
use super::watching::KnownOf;
use crate::journal::ask::Question;
use crate::journal::chain::Head;
use crate::journal::entry::{Entry, Moment};
use crate::message::{Message, message};
use crate::session::parts::{AlarmSearch, WalkCommand};
use crate::session::records::Verified;
use crate::session::{Command, Effect, OpenJournal, RecordRow, RecordsCommand, StatisticsCommand};
use crate::watch::TakenFiles;

/// Where records are kept, whatever that is: the file of this station, or one that a test has made up.
pub trait Journals: Debug + Send + Sync {
    /// Opens a journal to write; makes it where there is none.
    ///
    /// # Errors
    /// What the user should know.
    fn open(&self, file: &Path, station: &str, now: &Moment) -> Result<(Box<dyn Keeps>, Box<OpenJournal>), Message>;

    /// Opens a journal to read, beside whoever writes it.
    ///
    /// # Errors
    /// What the user should know.
    fn reader(&self, file: &Path) -> Result<Box<dyn Reads>, Message>;

    /// The bodies of all entries so far, from the first one on.
    ///
    /// # Errors
    /// What the user should know.
    fn bodies(&self, file: &Path, see: &mut dyn FnMut(&[u8])) -> Result<(), Message>;

    /// Walks the chain. `progress` gets how many entries are done, and of how many, and may stop it.
    ///
    /// # Errors
    /// What the user should know.
    fn verify(&self, file: &Path, progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>) -> Result<Verified, Message>;
}

/// A journal that is written.
pub trait Keeps: Send {
    /// Writes entries; when it returns, they are on disk.
    ///
    /// # Errors
    /// What the user should know; then none of them is kept.
    fn append(&mut self, entries: &[Entry]) -> Result<Vec<Head>, Message>;
}

/// A journal that is read.
pub trait Reads: Send {
    /// The newest entry.
    ///
    /// # Errors
    /// [`ReadError`].
    fn newest(&self) -> Result<Head, ReadError>;

    /// The numbers of the checks that answer a question, newest first, from before a number on, and at most so many.
    ///
    /// # Errors
    /// [`ReadError`].
    fn numbers(&self, question: &Question, before: Option<u64>, most: usize) -> Result<Vec<u64>, ReadError>;

    /// These records; one that is not there is left out.
    ///
    /// # Errors
    /// [`ReadError`].
    fn rows(&self, numbers: &[u64]) -> Result<Vec<RecordRow>, ReadError>;

    /// The reports that show the check of a number, the oldest first.
    ///
    /// # Errors
    /// [`ReadError`].
    fn reports_of(&self, number: u64) -> Result<Vec<RecordRow>, ReadError>;

    /// Ends the call that runs now, from another thread.
    fn interrupt(&self) -> Arc<dyn Fn() + Send + Sync>;
}

/// Why nothing was read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReadError {
    /// Somebody stopped it.
    Interrupted,
    /// The reason.
    Failed(Message),
}

/// Which records the window keeps, and what it needs for that.
#[derive(Debug, Clone)]
pub struct Records {
    /// How a journal is opened.
    pub journals: Arc<dyn Journals>,
    /// The usual file; `None` keeps no records unless the state file names one.
    pub usual: Option<PathBuf>,
    /// The name of the station.
    pub station: String,
    /// The time with its zone.
    pub moment: fn() -> Moment,
    /// Where its days begin.
    pub zone: TimeZone,
    /// Whether its threads are used where everything else is done at once: for tests of slow journals.
    pub always_threads: bool,
}

impl Records {
    /// The journal of this station, in the user's data folder.
    pub fn of_user() -> Self {
        let journals = Arc::new(Local::of_user());
        let usual = Local::usual();
        Self {
            journals,
            usual,
            station: computer(),
            moment,
            zone: crate::files::zone_or_unknown(),
            always_threads: false,
        }
    }

    /// No records, unless the state file names a journal.
    pub fn nowhere() -> Self {
        Self { usual: None, ..Self::of_user() }
    }
}

/// How long a window that closes waits for entries that are being written.
const MOST: Duration = Duration::from_secs(30);

/// A way to stop what is read now.
type Interrupt = Arc<Mutex<Option<Arc<dyn Fn() + Send + Sync>>>>;

/// The journal of the window.
pub(super) struct Desk {
    records: Records,
    is_at_once: bool,
    answers: Sender<Command>,
    /// To the thread that writes; `None` once the window closes.
    writer: Mutex<Option<Sender<Job>>>,
    /// Hears when everything is written.
    written: Mutex<Receiver<()>>,
    /// To the thread that reads.
    finder: Sender<FinderRequest>,
    /// The same two for tests, on the frame's thread.
    at_once: Mutex<(Writer, Finder)>,
    interrupt: Interrupt,
    /// The number of the newest question: what belongs to an older one is given up.
    newest: Arc<AtomicU64>,
    /// The same of the palette's questions.
    newest_few: Arc<AtomicU64>,
    /// The same of the statistics page's questions.
    newest_series: Arc<AtomicU64>,
    /// The number of the walk that goes on; 0 for none.
    walk: Arc<AtomicU64>,
    file: Mutex<Option<PathBuf>>,
    shop: Mutex<Shop>,
    /// When each batch of entries was made.
    made: Mutex<BTreeMap<u64, Moment>>,
    clock: fn() -> DateTime,
}

impl Debug for Desk {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Desk").field("records", &self.records).finish_non_exhaustive()
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Says something to the window and asks for a frame.
fn say(answers: &Sender<Command>, ctx: &Context, command: impl Into<Command>) {
    // A closed window hears no answer; that is not an error.
    let _closed = answers.send(command.into());
    ctx.request_repaint();
}

impl Desk {
    pub fn new(errands: Errands, records: Records, clock: fn() -> DateTime, answers: Sender<Command>) -> Self {
        let (writer, jobs) = channel::<Job>();
        let (done, written) = channel();
        let (finder, asked) = channel::<FinderRequest>();
        let interrupt = Interrupt::default();
        let newest = Arc::<AtomicU64>::default();
        let newest_few = Arc::<AtomicU64>::default();
        let new_writer = || Writer::new(Arc::clone(&records.journals));
        let new_finder = || {
            let newest = [&newest, &newest_few].map(Arc::clone);
            Finder::new(Arc::clone(&records.journals), Arc::clone(&interrupt), newest)
        };
        let is_at_once = errands == Errands::AtOnce && !records.always_threads;
        if !is_at_once {
            let mut of_thread = new_writer();
            let to_window = answers.clone();
            on_thread("journal", move || {
                for job in jobs {
                    let ctx = job.ctx.clone();
                    of_thread.work(job).into_iter().for_each(|command| say(&to_window, &ctx, command));
                }
                drop(of_thread);
                let _nobody_waits = done.send(());
            });
            let of_thread = new_finder();
            let to_window = answers.clone();
            on_thread("records", move || of_thread.run(&asked, &to_window));
        }
        Self {
            is_at_once,
            answers,
            writer: Mutex::new(Some(writer)),
            written: Mutex::new(written),
            finder,
            at_once: Mutex::new((new_writer(), new_finder())),
            interrupt,
            newest,
            newest_few,
            newest_series: Arc::default(),
            walk: Arc::default(),
            file: Mutex::default(),
            shop: Mutex::default(),
            made: Mutex::default(),
            clock,
            records,
        }
    }

    /// The command that tells the session where records are kept.
    pub fn begin(&self) -> Command {
        let Records { usual, station, zone, .. } = self.records.clone();
        RecordsCommand::Begin { usual, station, zone }.into()
    }

    /// Runs an effect; others are given back.
    pub fn run(&self, ctx: &Context, effect: Effect) -> Option<Effect> {
        match effect {
            Effect::OpenJournal { file, station, newest } => {
                *lock(&self.file) = Some(file.clone());
                let now = (self.records.moment)();
                self.find(ctx, FinderRequest::File(file.clone()));
                self.write(Job::open(ctx, (file, station), now, newest));
            }
            Effect::Keep { run, mut entries } => {
                let now = (self.records.moment)();
                // What is tried again was made when it was sent first.
                let made = lock(&self.made).entry(run).or_insert_with(|| now.clone()).clone();
                for entry in &mut entries {
                    entry.about.time.clone_from(&made);
                }
                self.write(Job::keep(ctx, now, run, entries));
            }
            Effect::AskRecords { run, question, rests } => {
                self.newest.store(run, Relaxed);
                if let Some(interrupt) = lock(&self.interrupt).as_ref() {
                    interrupt();
                }
                self.find(ctx, FinderRequest::Question { run, question, rests, ctx: ctx.clone() });
            }
            Effect::ReadPart { run, question, most } => {
                self.find(ctx, FinderRequest::Part { run, question, most, ctx: ctx.clone() });
            }
            Effect::ReadSeries { run, question, most, rests } => {
                self.newest_series.store(run, Relaxed);
                let newest = Arc::clone(&self.newest_series);
                self.read_series(ctx, SeriesAsked { run, newest, question, most, rests: rests && !self.is_at_once });
            }
            Effect::FindAlarms(search) => self.find_alarms(ctx, search),
            Effect::FindRecords { run, question, most } => {
                self.newest_few.store(run, Relaxed);
                if let Some(interrupt) = lock(&self.interrupt).as_ref() {
                    interrupt();
                }
                self.find(ctx, FinderRequest::Few { run, question, most, ctx: ctx.clone() });
            }
            Effect::ReadRecords(numbers) => self.find(ctx, FinderRequest::Rows { numbers, ctx: ctx.clone() }),
            Effect::ReadReports(number) => self.find(ctx, FinderRequest::Reports { number, ctx: ctx.clone() }),
            Effect::VerifyRecords { run } => self.verify(ctx, run),
            Effect::SendTo(address) => self.send_to(ctx, address.as_deref()),
            Effect::WakeSender => lock(&self.shop).wake(),
            Effect::SendAgain => lock(&self.shop).again(),
            Effect::StopVerify => self.walk.store(0, Relaxed),
            other => return Some(other),
        }
        None
    }

    /// The journal's file; none where no records are kept.
    pub fn file(&self) -> Option<PathBuf> {
        lock(&self.file).clone()
    }

    /// Reads which files the journal knows; nothing where no records are kept.
    pub fn known(&self) -> KnownOf {
        let journals = Arc::clone(&self.records.journals);
        let file = lock(&self.file).clone();
        Box::new(move || {
            let mut known = TakenFiles::default();
            if let Some(file) = file {
                journals.bodies(&file, &mut |body| known.see(body))?;
            }
            Ok(known)
        })
    }

    fn write(&self, job: Job) {
        let ctx = job.ctx.clone();
        if self.is_at_once {
            let commands = lock(&self.at_once).0.work(job);
            return commands.into_iter().for_each(|command| say(&self.answers, &ctx, command));
        }
        // Without its thread nothing is written, and that is said.
        let sent = lock(&self.writer).as_ref().map(|writer| writer.send(job));
        if let Some(Err(lost)) = sent {
            let why = message!("records-page-no-thread");
            say(&self.answers, &ctx, lost.0.refused(why));
        }
    }

    fn find(&self, ctx: &Context, asked: FinderRequest) {
        if self.is_at_once {
            let commands = lock(&self.at_once).1.at_once(asked);
            return commands.into_iter().for_each(|command| say(&self.answers, ctx, command));
        }
        let _no_thread = self.finder.send(asked);
    }

    fn read_series(&self, ctx: &Context, asked: SeriesAsked) {
        let file = lock(&self.file).clone();
        let answers = self.answers.clone();
        let ctx = ctx.clone();
        let journals = Arc::clone(&self.records.journals);
        let errand = move || {
            if let Some(result) = asked.read(journals.as_ref(), file.as_deref()) {
                say(&answers, &ctx, StatisticsCommand::Found { run: asked.run, result });
            }
        };
        if self.is_at_once { errand() } else { on_thread("series", errand) }
    }

    fn find_alarms(&self, ctx: &Context, search: Box<AlarmSearch>) {
        let file = lock(&self.file).clone();
        let answers = self.answers.clone();
        let ctx = ctx.clone();
        let journals = Arc::clone(&self.records.journals);
        let errand = move || {
            let found = alarms::find(&search, journals.as_ref(), file.as_deref()).map(Box::new);
            say(&answers, &ctx, WalkCommand::AlarmsFound(found));
        };
        if self.is_at_once { errand() } else { on_thread("alarms", errand) }
    }

    /// Sends the journal to a server from now on, or to none.
    fn send_to(&self, ctx: &Context, address: Option<&str>) {
        let mut shop = lock(&self.shop);
        shop.leave();
        let (Some(address), Some(file)) = (address, lock(&self.file).clone()) else { return };
        let answers = self.answers.clone();
        let ctx = ctx.clone();
        let tell = move |command: Command| say(&answers, &ctx, command);
        shop.send_to(address, (&file, &self.records.station), tell);
    }

    fn verify(&self, ctx: &Context, run: u64) {
        let clock = self.clock;
        self.walk.store(run, Relaxed);
        let Some(file) = lock(&self.file).clone() else { return };
        let answers = self.answers.clone();
        let ctx = ctx.clone();
        let journals = Arc::clone(&self.records.journals);
        let walk = Arc::clone(&self.walk);
        let errand = move || {
            let result = journals.verify(&file, &mut |done, of| {
                say(&answers, &ctx, RecordsCommand::Verifying { run, done, of });
                if walk.load(Relaxed) == run { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
            say(&answers, &ctx, RecordsCommand::Verified { run, result, at: clock() });
        };
        if self.is_at_once { errand() } else { on_thread("verify", errand) }
    }

    /// Waits until everything is on disk that was sent. A drive that does not answer is not waited for forever.
    pub fn finish(&self) {
        self.walk.store(0, Relaxed);
        // What the server lacks is sent the next time.
        lock(&self.shop).leave();
        if lock(&self.writer).take().is_some() && !self.is_at_once && lock(&self.written).recv_timeout(MOST).is_err() {
            log::error!("the journal has not answered: checks may not be recorded");
        }
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        self.finish();
    }
}

fn on_thread(name: &str, errand: impl FnOnce() + Send + 'static) {
    if let Err(error) = std::thread::Builder::new().name(name.to_owned()).spawn(errand) {
        log::error!("no thread for {name}: {error}");
    }
}
