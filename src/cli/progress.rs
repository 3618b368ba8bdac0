//! How far something long has come: a line on standard error while somebody watches; and its end by Ctrl+C.

use std::io::{self, Read, Seek, SeekFrom};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use fitcheck_core::text::long;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::batch::Watch;
use crate::exchange::Body;
use crate::files::Stop;

/// Before this nothing is shown: most calls are done by then.
const PATIENCE: Duration = Duration::from_millis(500);

/// How much time lies between two changes of the line, at least: ten a second.
const BETWEEN: Duration = Duration::from_millis(100);

/// Something long that is done with one input: how far it is, and whether it is to end.
///
/// Nothing is shown where standard error is no terminal.
#[derive(Debug)]
pub(super) struct Work {
    done: Arc<Done>,
    size: Size,
    line: Line,
    stop: Stop,
}

/// How much there is to do, as far as that is known.
#[derive(Debug, Clone, Copy)]
pub(super) enum Size {
    /// Nobody knows.
    Open,
    /// So many bytes.
    Bytes(u64),
    /// So many rows.
    Rows(u64),
}

/// What is done so far.
#[derive(Debug, Default)]
struct Done {
    rows: AtomicU64,
    bytes: AtomicU64,
}

/// The line on standard error; its clones are the same line.
#[derive(Debug, Clone)]
pub(super) struct Line {
    shown: Arc<Mutex<ProgressLine>>,
    /// Whether anybody sees it.
    is_watched: bool,
}

#[derive(Debug)]
struct ProgressLine {
    name: String,
    begun: Instant,
    /// When it was last changed.
    last: Option<Instant>,
    /// What stands there now.
    bar: Option<ProgressBar>,
    /// Whether something else stands there for good.
    is_over: bool,
}

impl Work {
    /// On an input with a name, of so many bytes if that is known.
    pub(super) fn on(name: &str, bytes: Option<u64>) -> Self {
        Self::of(name, bytes.map_or(Size::Open, Size::Bytes))
    }

    /// On something with a name.
    pub(super) fn of(name: &str, size: Size) -> Self {
        Self { done: Arc::default(), size, line: Line::new(name), stop: Stop::heard() }
    }

    /// The same input once more, for something else.
    pub(super) fn again(&self, name: &str) {
        self.done.rows.store(0, Relaxed);
        self.done.bytes.store(0, Relaxed);
        self.line.begin(name);
    }

    /// Another row is done.
    pub(super) fn row(&self) {
        self.done.rows.fetch_add(1, Relaxed);
        self.show();
    }

    /// Shows how far workers are, and asks them to end where Ctrl+C did.
    pub(super) fn follow(&self, watch: &Watch) {
        self.done.rows.store(watch.rows.load(Relaxed), Relaxed);
        self.done.bytes.store(watch.bytes.load(Relaxed), Relaxed);
        watch.stop.fetch_or(self.is_stopped(), Relaxed);
        self.show();
    }

    /// How many rows are done.
    pub(super) fn rows(&self) -> u64 {
        self.done.rows.load(Relaxed)
    }

    /// Whether Ctrl+C asked for its end.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop.is_asked()
    }

    /// The line, for whoever writes where it stands.
    pub(super) fn line(&self) -> Line {
        self.line.clone()
    }

    fn show(&self) {
        if self.line.is_watched {
            self.line.show(&self.done, self.size);
        }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.line.end();
    }
}

impl Line {
    fn new(name: &str) -> Self {
        let is_watched = !ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).is_hidden();
        let name = name.to_owned();
        let shown = ProgressLine { name, begun: Instant::now(), last: None, bar: None, is_over: false };
        Self { shown: Arc::new(Mutex::new(shown)), is_watched }
    }

    fn lock(&self) -> MutexGuard<'_, ProgressLine> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The line of something else begins.
    fn begin(&self, name: &str) {
        let mut shown = self.lock();
        shown.clear();
        name.clone_into(&mut shown.name);
        shown.begun = Instant::now();
        shown.last = None;
    }

    /// Shows what is done, if it is time for that.
    fn show(&self, done: &Arc<Done>, size: Size) {
        let mut shown = self.lock();
        let is_soon = shown.last.is_some_and(|last| last.elapsed() < BETWEEN);
        if shown.is_over || is_soon || shown.begun.elapsed() < PATIENCE {
            return;
        }
        shown.last = Some(Instant::now());
        let bar = shown.bar.take().unwrap_or_else(|| bar(&shown.name, shown.begun, (done, size)));
        bar.update(|state| state.set_pos(done.position(size)));
        shown.bar = Some(bar);
    }

    /// Writes something on lines of their own where this one stands.
    pub(super) fn beside(&self, write: impl FnOnce()) {
        match &self.lock().bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        }
    }

    /// Takes the line away.
    pub(super) fn end(&self) {
        self.lock().clear();
    }

    /// Takes the line away for good: an answer comes to the same terminal.
    pub(super) fn give_way(&self) {
        let mut shown = self.lock();
        shown.clear();
        shown.is_over = true;
    }
}

impl ProgressLine {
    fn clear(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

/// A bar on standard error.
fn bar(name: &str, begun: Instant, (done, size): (&Arc<Done>, Size)) -> ProgressBar {
    let (length, template) = match size {
        Size::Bytes(all) | Size::Rows(all) => (Some(all), "{prefix}: {done} {bar:20} {percent} %, {eta} left"),
        Size::Open => (None, "{prefix}: {done}"),
    };
    let done = Arc::clone(done);
    let say = move |_: &ProgressState, line: &mut dyn std::fmt::Write| {
        // A line that cannot be shown is not shown.
        let _unseen = line.write_str(&done.text(size, begun.elapsed()));
    };
    let bar = ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr());
    let bar = bar.with_prefix(name.replace(char::is_control, " ")).with_elapsed(begun.elapsed());
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style.with_key("done", say)),
        Err(_) => bar,
    }
}

impl Done {
    /// How far it is, in what its size is given in.
    fn position(&self, size: Size) -> u64 {
        let counted = if matches!(size, Size::Rows(_)) { &self.rows } else { &self.bytes };
        counted.load(Relaxed)
    }

    /// `1200000 rows, 30.5 of 127.2 MB, 310000 rows a second`.
    fn text(&self, size: Size, elapsed: Duration) -> String {
        let rows = self.rows.load(Relaxed);
        let bytes = self.bytes.load(Relaxed);
        let done = match size {
            Size::Rows(all) => format!("{rows} of {all} rows"),
            Size::Bytes(all) => format!("{rows} rows, {} of {} MB", megabytes(bytes), megabytes(all)),
            Size::Open => format!("{rows} rows, {} MB", megabytes(bytes)),
        };
        // It is shown after half a second, so that is not nothing.
        let ms = elapsed.as_millis().max(1);
        format!("{done}, {} rows a second", u128::from(rows) * 1_000 / ms)
    }
}

/// Millions of bytes with one decimal.
fn megabytes(bytes: u64) -> String {
    let tenths = bytes / 100_000;
    format!("{}.{}", tenths / 10, tenths % 10)
}

/// A file that is read for a work: it counts how far, and ends in an error once the work is to end, so that nothing is taken for whole.
pub(super) struct Watched<'a> {
    body: &'a mut dyn Body,
    work: &'a Work,
    /// Where it is read next.
    at: u64,
}

impl<'a> Watched<'a> {
    pub(super) fn new(body: &'a mut dyn Body, work: &'a Work) -> Self {
        Self { body, work, at: 0 }
    }
}

impl Read for Watched<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.work.is_stopped() {
            return Err(stopped());
        }
        let count = self.body.read(buffer)?;
        self.at += long(count);
        // What is looked at twice is done once.
        self.work.done.bytes.fetch_max(self.at, Relaxed);
        self.work.show();
        Ok(count)
    }
}

impl Seek for Watched<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = self.body.seek(to)?;
        Ok(self.at)
    }
}

/// What a stream says that is to end; nobody reads it, since the end has a sentence of its own.
pub(super) fn stopped() -> io::Error {
    io::Error::other("stopped")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_rows_megabytes_and_rows_a_second() {
        let done = Done { rows: AtomicU64::new(1_200_000), bytes: AtomicU64::new(30_549_999) };
        let after = Duration::from_secs(4);
        let text = done.text(Size::Bytes(127_200_000), after);
        assert_eq!(text, "1200000 rows, 30.5 of 127.2 MB, 300000 rows a second");
        assert_eq!(done.text(Size::Open, after), "1200000 rows, 30.5 MB, 300000 rows a second");
        assert_eq!(done.text(Size::Rows(2_000_000), after), "1200000 of 2000000 rows, 300000 rows a second");
        assert_eq!(done.text(Size::Open, Duration::ZERO), "1200000 rows, 30.5 MB, 1200000000 rows a second");
    }
}
