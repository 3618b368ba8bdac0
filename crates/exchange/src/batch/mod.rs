//! Verdicts for rows by the million: several workers take blocks of a stream in turns, so that the order stays, nothing is
//! judged twice and memory does not grow with the stream.
//!
//! | file | what |
//! |---|---|
//! | here | the turns |
//! | `stream` | what comes in and goes out: plain, gzip, Zstandard, UTF-16 |
//! | `forms` | what the rows are written as |
//! | `text` | CSV in; CSV, TSV and JSON lines out |
//! | `listed` | the rows of a list as text of any form, in its order |
//! | `worker` | who judges a portion and writes what became of it |
//! | `parquet` | Parquet in and out, with the feature of that name |
//!
//! What a row means is in `exchange::batch`.
//!
//! To use the rows of a stream in another way, give [`run_into`] two things: a [`Making`], which is what a worker makes of a block, and a
//! [`Sink`], which takes it in the order of the stream. Written bytes are one such pair; `Marks` and the list of the window
//! (`gui/rows.rs`) are another.

mod forms;
mod listed;
#[cfg(feature = "parquet")]
pub mod parquet;
mod stream;
mod text;
mod worker;

use std::io;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use fitcheck_core::tolerance::ToleranceClass;

pub use forms::{FORMS, Form, Rendering, WithRendering};
pub use listed::{refusal, write_listed};
pub use stream::{Packing, Stream};
pub use text::{Input, Making, Sink, run, run_into};

use crate::exchange::batch::{Counts, Figures, Judge, JudgedCounts, Tally};

/// How far a run has come, for whoever watches it, and its end.
#[derive(Debug, Default)]
pub struct Watch {
    /// Rows that were written.
    pub rows: AtomicU64,
    pub bytes: AtomicU64,
    /// Whether the run should end; what was written until then is not everything.
    pub stop: AtomicBool,
}

/// What a run had.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Summary {
    /// All rows.
    pub tally: Tally,
    /// The verdicts of each class, by its name.
    pub by_class: Vec<(ToleranceClass, Counts)>,
    /// The verdicts of callouts without a class.
    pub others: Counts,
    /// What to check about the figures behind the limits.
    pub figures: Figures,
}

/// How a run is done.
#[derive(Debug, Clone, Copy)]
pub struct Manner<'a> {
    /// How many workers judge at the same time, at least one.
    pub workers: usize,
    /// What the rows are packed with, block by block.
    pub packing: Packing,
    /// What stands before the names of the added columns.
    pub prefix: &'a str,
}

/// Why a run ended early.
#[derive(Debug)]
pub enum Failed {
    /// The stream could not be read on; what came before was written.
    Reading(io::Error),
    /// The rows could not be written.
    Writing(io::Error),
}

/// More workers only wait for the one stream that they read and write.
const MOST_WORKERS: usize = 8;

/// How many workers this machine has room for.
pub fn workers() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from).min(MOST_WORKERS)
}

/// Gives the rows out, portion by portion.
trait Source: Send {
    type Portion: Default;

    /// Fills a portion with the next rows; `false` at the end.
    fn next(&mut self, portion: &mut Self::Portion) -> io::Result<bool>;

    /// How many bytes of the input were given out.
    fn bytes(&self) -> u64;
}

/// What one worker does with the rows.
trait Work<'c> {
    type Portion;
    type Sink: ?Sized + Send;

    /// Judges a portion and makes ready what is written of it.
    fn judge(&mut self, portion: &mut Self::Portion) -> Tally;

    /// Writes what was made ready of a portion.
    fn write(&mut self, portion: &Self::Portion, tally: &Tally, sink: &mut Self::Sink) -> io::Result<()>;

    fn end(self) -> Judge<'c>;
}

/// Where the rows come from, and which portion comes next.
struct In<S> {
    source: S,
    next: u64,
    failed: Option<io::Error>,
    is_ended: bool,
}

/// Where the rows go, and whose turn it is to write.
struct Out<'a, K: ?Sized> {
    sink: &'a mut K,
    turn: u64,
    tally: Tally,
    failed: Option<io::Error>,
}

struct Turns<'a, S, K: ?Sized> {
    source: Mutex<In<S>>,
    sink: Mutex<Out<'a, K>>,
    /// Somebody has written.
    written: Condvar,
    /// How many workers are at work still.
    working: Mutex<usize>,
    ended: Condvar,
    watch: &'a Watch,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // A worker that failed has said so; what it held is whole between two steps.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// How a run is watched: where it says how far it is, and what is called ten times a second meanwhile.
struct Watched<'a> {
    watch: &'a Watch,
    tick: &'a mut dyn FnMut(&Watch),
}

/// Judges all rows of a source and writes them in their order, each worker as `hire` makes it.
fn take_turns<'c, S: Source, W: Work<'c, Portion = S::Portion>>(
    source: S,
    sink: &mut W::Sink,
    workers: usize,
    watched: Watched<'_>,
    hire: impl Fn() -> W + Sync,
) -> Result<Summary, Failed> {
    let workers = workers.max(1);
    let Watched { watch, tick } = watched;
    let turns = Turns {
        source: Mutex::new(In { source, next: 0, failed: None, is_ended: false }),
        sink: Mutex::new(Out { sink, turn: 0, tally: Tally::default(), failed: None }),
        written: Condvar::new(),
        working: Mutex::new(workers),
        ended: Condvar::new(),
        watch,
    };
    let mut summary = Summary::default();
    std::thread::scope(|scope| {
        let work = || turns.work(&hire);
        let start = |number| std::thread::Builder::new().name(format!("batch {number}")).spawn_scoped(scope, work);
        // Where the system gives fewer threads, fewer workers do it; without any, this thread does.
        let judges: Vec<_> = (1..=workers).filter_map(|number| start(number).ok()).collect();
        *lock(&turns.working) -= workers - judges.len();
        if judges.is_empty() {
            *lock(&turns.working) += 1;
            summary.add(work());
        }
        let mut working = lock(&turns.working);
        while 0 < *working {
            let waited = turns.ended.wait_timeout(working, Duration::from_millis(100));
            working = waited.unwrap_or_else(PoisonError::into_inner).0;
            tick(watch);
        }
        drop(working);
        for judge in judges {
            match judge.join() {
                Ok(judge) => summary.add(judge),
                // Its portion is missing, so nothing of this run may count as whole.
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    let source = turns.source.into_inner();
    let sink = turns.sink.into_inner();
    let source = source.unwrap_or_else(PoisonError::into_inner);
    let sink = sink.unwrap_or_else(PoisonError::into_inner);
    summary.tally = sink.tally;
    match (sink.failed, source.failed) {
        (Some(error), _) => Err(Failed::Writing(error)),
        (None, Some(error)) => Err(Failed::Reading(error)),
        (None, None) => Ok(summary),
    }
}

impl Summary {
    /// The verdicts of all rows.
    pub fn counts(&self) -> Counts {
        let mut all = self.others;
        self.by_class.iter().for_each(|(_, counts)| sum(&mut all, *counts));
        all
    }

    /// Adds what another stream had.
    pub fn append(&mut self, other: Self) {
        let Self { tally, by_class, others, figures } = other;
        self.tally.add(tally);
        self.met(JudgedCounts { by_class, others, figures });
    }

    fn add(&mut self, judge: Judge<'_>) {
        self.met(judge.met());
    }

    fn met(&mut self, JudgedCounts { by_class, others, mut figures }: JudgedCounts) {
        self.figures.append(&mut figures);
        for (class, counts) in by_class {
            match self.by_class.binary_search_by_key(&class, |(known, _)| *known) {
                Ok(at) => self.by_class.iter_mut().skip(at).take(1).for_each(|(_, known)| sum(known, counts)),
                Err(at) => self.by_class.insert(at, (class, counts)),
            }
        }
        sum(&mut self.others, others);
    }
}

fn sum(counts: &mut Counts, more: Counts) {
    for (count, more) in counts.iter_mut().zip(more) {
        *count += more;
    }
}

/// Ends the run of all workers where one of them ends, however it does.
struct Leave<'a, 'b, S, K: ?Sized>(&'a Turns<'b, S, K>);

impl<S, K: ?Sized> Drop for Leave<'_, '_, S, K> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.watch.stop.store(true, Relaxed);
        }
        *lock(&self.0.working) -= 1;
        self.0.ended.notify_all();
        self.0.written.notify_all();
    }
}

impl<S: Source, K: ?Sized + Send> Turns<'_, S, K> {
    fn work<'c, W: Work<'c, Portion = S::Portion, Sink = K>>(&self, hire: &impl Fn() -> W) -> Judge<'c> {
        let _leave = Leave(self);
        let mut worker = hire();
        let mut portion = S::Portion::default();
        while let Some((number, bytes)) = self.take(&mut portion) {
            let tally = worker.judge(&mut portion);
            if !self.give((number, bytes), tally, &portion, &mut worker) {
                break;
            }
        }
        worker.end()
    }

    /// Takes the next portion of the source, with its number and how many bytes came so far; `None` where there is none.
    fn take(&self, portion: &mut S::Portion) -> Option<(u64, u64)> {
        let mut input = lock(&self.source);
        if input.is_ended || self.watch.stop.load(Relaxed) {
            return None;
        }
        match input.source.next(portion) {
            Ok(true) => {
                let number = input.next;
                input.next += 1;
                return Some((number, input.source.bytes()));
            }
            Ok(false) => {}
            Err(error) => input.failed = Some(error),
        }
        input.is_ended = true;
        None
    }

    /// Writes a portion when its turn comes; `false` where nothing more is written.
    fn give<'c, W: Work<'c, Portion = S::Portion, Sink = K>>(
        &self,
        (number, bytes): (u64, u64),
        tally: Tally,
        portion: &S::Portion,
        worker: &mut W,
    ) -> bool {
        let mut out = lock(&self.sink);
        while out.turn != number {
            if self.watch.stop.load(Relaxed) || out.failed.is_some() {
                return false;
            }
            let waited = self.written.wait_timeout(out, Duration::from_millis(100));
            out = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        if out.failed.is_some() {
            return false;
        }
        if let Err(error) = worker.write(portion, &tally, &mut *out.sink) {
            out.failed = Some(error);
            lock(&self.source).is_ended = true;
        }
        self.watch.rows.fetch_add(tally.rows, Relaxed);
        self.watch.bytes.store(bytes, Relaxed);
        out.tally.add(tally);
        out.turn += 1;
        let goes_on = out.failed.is_none();
        drop(out);
        self.written.notify_all();
        goes_on
    }
}
