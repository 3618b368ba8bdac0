//! Verdicts for rows by the million: several workers take blocks of a stream in turns, so that the order stays, nothing is
//! judged twice and memory does not grow with the stream.
//!
//! | file | what |
//! |---|---|
//! | here | the turns |
//! | `stream` | what comes in and goes out: plain, gzip, Zstandard, UTF-16 |
//! | `forms` | what the rows are written as |
//!
//! What a row means is in `exchange::batch`.

mod forms;
mod stream;

use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

pub use forms::{FORMS, Form, Rendering};
pub use stream::{Packing, Stream};

use crate::exchange::ImportErrorKind;
use crate::exchange::batch::{Block, Counts, Court, Cutter, Judge, Judged, Marks, Row, Take, Tally};
use crate::tolerance::ToleranceClass;

/// How far a run has come, for whoever watches it, and its end.
#[derive(Debug, Default)]
pub struct Watch {
    /// Rows that were written.
    pub rows: AtomicU64,
    /// Bytes of them.
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
}

/// Where the rows come from.
pub struct Input<'a> {
    /// The stream, from its first row on.
    pub stream: &'a mut (dyn Read + Send),
    /// What cuts it into blocks.
    pub cutter: Cutter,
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

/// The stream, and which block comes next.
struct Source<'a> {
    input: Input<'a>,
    next: u64,
    failed: Option<io::Error>,
    is_ended: bool,
}

/// What a worker makes of each block.
pub trait Making: Take {
    /// Begins a block.
    fn begin(&mut self);

    /// Ends it, while other workers are at theirs.
    ///
    /// # Errors
    /// What cannot be made.
    fn end(&mut self) -> io::Result<()>;
}

/// Where that goes, block by block in the order of the stream.
pub trait Sink<M: Making>: Send {
    /// Takes what was made of a block.
    ///
    /// # Errors
    /// Why nothing more can be taken.
    fn take(&mut self, made: &mut M, block: &Block, tally: &Tally) -> io::Result<()>;
}

/// The answers of a block as bytes.
struct Written<R> {
    rendering: R,
    packing: Packing,
    packed: Vec<u8>,
}

impl<R: Rendering> Take for Written<R> {
    #[expect(clippy::inline_always, reason = "as the rendering's own, for every row")]
    #[inline(always)]
    fn judged(&mut self, row: &Row<'_>, judged: &Judged) {
        self.rendering.judged(row, judged);
    }

    fn refused(&mut self, row: &Row<'_>, reason: &str) {
        self.rendering.refused(row, reason);
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        self.rendering.broken(line, reason);
    }

    fn line(&mut self, line: &[u8]) {
        self.rendering.line(line);
    }
}

impl<R: Rendering> Making for Written<R> {
    fn begin(&mut self) {
        self.rendering.out().clear();
    }

    fn end(&mut self) -> io::Result<()> {
        self.packing.pack(self.rendering.out().bytes(), &mut self.packed).map(|_| ())
    }
}

impl Making for Marks {
    fn begin(&mut self) {
        self.clear();
    }

    fn end(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A stream of bytes.
struct Out<'a>(&'a mut (dyn Write + Send));

impl<R: Rendering> Sink<Written<R>> for Out<'_> {
    fn take(&mut self, made: &mut Written<R>, _block: &Block, _tally: &Tally) -> io::Result<()> {
        let bytes = if made.packing == Packing::Plain { made.rendering.out().bytes() } else { &made.packed };
        self.0.write_all(bytes)?;
        // Whoever waits at the other end of a pipe gets what is there.
        self.0.flush()
    }
}

/// Whose turn it is.
struct Order<'a, S> {
    sink: &'a mut S,
    turn: u64,
    tally: Tally,
    failed: Option<io::Error>,
}

struct Turns<'a, 'i, S> {
    source: Mutex<Source<'i>>,
    sink: Mutex<Order<'a, S>>,
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

/// More workers only wait for the one stream that they read and write.
const MOST_WORKERS: usize = 8;

/// How many workers this machine has room for.
pub fn workers() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from).min(MOST_WORKERS)
}

/// Judges all rows of a stream and writes them in their order. `tick` is called ten times a second meanwhile.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn run<R: Rendering>(
    input: Input<'_>,
    court: &Court<'_>,
    manner: Manner<'_>,
    out: &mut (dyn Write + Send),
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let rendering =
        || Written { rendering: R::new(court.layout(), manner.prefix), packing: manner.packing, packed: Vec::new() };
    run_into(input, court, (manner.workers, &rendering), &mut Out(out), watch, tick)
}

/// Judges all rows of a stream: each worker makes something of its blocks, and a sink takes it in the order of the
/// stream. `tick` is called ten times a second meanwhile.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn run_into<M: Making, S: Sink<M>>(
    input: Input<'_>,
    court: &Court<'_>,
    (workers, making): (usize, &(dyn Fn() -> M + Sync)),
    sink: &mut S,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let workers = workers.max(1);
    let turns = Turns {
        source: Mutex::new(Source { input, next: 0, failed: None, is_ended: false }),
        sink: Mutex::new(Order { sink, turn: 0, tally: Tally::default(), failed: None }),
        written: Condvar::new(),
        working: Mutex::new(workers),
        ended: Condvar::new(),
        watch,
    };
    let mut summary = Summary::default();
    std::thread::scope(|scope| {
        let work = || turns.work(court, making);
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
                // Its block is missing, so nothing of this run may count as whole.
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    let (source, sink) = (turns.source.into_inner(), turns.sink.into_inner());
    let (source, sink) = (source.unwrap_or_else(PoisonError::into_inner), sink.unwrap_or_else(PoisonError::into_inner));
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
        let Self { tally, by_class, others } = other;
        self.tally.add(tally);
        self.classes(by_class, others);
    }

    fn add(&mut self, judge: Judge<'_>) {
        let (by_class, others) = judge.by_class();
        self.classes(by_class, others);
    }

    fn classes(&mut self, by_class: Vec<(ToleranceClass, Counts)>, others: Counts) {
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
struct Leave<'a, 'b, 'i, S>(&'a Turns<'b, 'i, S>);

impl<S> Drop for Leave<'_, '_, '_, S> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.watch.stop.store(true, Relaxed);
        }
        *lock(&self.0.working) -= 1;
        self.0.ended.notify_all();
        self.0.written.notify_all();
    }
}

impl<S> Turns<'_, '_, S> {
    fn work<'c, M: Making>(&self, court: &'c Court<'_>, making: &(dyn Fn() -> M + Sync)) -> Judge<'c>
    where
        S: Sink<M>,
    {
        let _leave = Leave(self);
        let mut judge = court.judge();
        let (mut made, mut block) = (making(), Block::default());
        while let Some(number) = self.take(&mut block) {
            made.begin();
            let tally = judge.block(&block, &mut made);
            let ended = made.end();
            if !self.give(number, tally, &block, ended.map(|()| &mut made)) {
                break;
            }
        }
        judge
    }

    /// Takes the next block of the stream; `None` where there is none.
    fn take(&self, block: &mut Block) -> Option<u64> {
        let mut source = lock(&self.source);
        if source.is_ended || self.watch.stop.load(Relaxed) {
            return None;
        }
        let Input { stream, cutter } = &mut source.input;
        match cutter.next(*stream, block) {
            Ok(true) => {
                let number = source.next;
                source.next += 1;
                return Some(number);
            }
            Ok(false) => {}
            Err(error) => source.failed = Some(error),
        }
        source.is_ended = true;
        None
    }

    /// Writes a block when its turn comes; `false` where nothing more is written.
    fn give<M: Making>(&self, number: u64, tally: Tally, block: &Block, made: io::Result<&mut M>) -> bool
    where
        S: Sink<M>,
    {
        let mut sink = lock(&self.sink);
        while sink.turn != number {
            if self.watch.stop.load(Relaxed) || sink.failed.is_some() {
                return false;
            }
            let waited = self.written.wait_timeout(sink, Duration::from_millis(100));
            sink = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        if sink.failed.is_some() {
            return false;
        }
        if let Err(error) = made.and_then(|made| sink.sink.take(made, block, &tally)) {
            sink.failed = Some(error);
            lock(&self.source).is_ended = true;
        }
        self.watch.rows.fetch_add(tally.rows, Relaxed);
        self.watch.bytes.fetch_add(u64::try_from(block.len()).unwrap_or_default(), Relaxed);
        sink.tally.add(tally);
        sink.turn += 1;
        let goes_on = sink.failed.is_none();
        drop(sink);
        self.written.notify_all();
        goes_on
    }
}
