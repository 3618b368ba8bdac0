//! The workers behind the rows of a large file: one run at a time judges them and says ten times a second what it has
//! found; rows in sight are read again from the file.
//!
//! What is packed or is UTF-16 cannot be read from the middle: its text goes to a temporary file, which has no name where
//! the system allows that and is gone with the window in any case.

use std::fs::{File, Metadata};
use std::io::{self, Cursor, Read, Seek as _, SeekFrom, Write as _};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant, SystemTime};

use crate::batch::{self, Failed, Input, Packing, Sink, Stream, Watch};
use crate::exchange::ImportErrorKind;
use crate::exchange::batch::{
    BLOCK, Block, Cutter, Layout, ListedRows, Marks, Part, Picked, Sifted, Sifting, Store, StreamBytes, StreamJudging,
    Tally, pick,
};
use crate::files;
use crate::journal::chain::FileHash;
use crate::message::{Message, Say as _, message};
use crate::session::{End, LARGE, Large, News};
use crate::text::{Within as _, long};
use crate::tolerance::Sources;

/// How often a run says what it has found.
const EVERY: Duration = Duration::from_millis(100);

/// The most text that is unpacked into a temporary file, 16 GiB.
const MOST_UNPACKED: u64 = 16 << 30;

/// The run that goes on or was the last one.
#[derive(Debug, Default)]
pub(super) struct Runs {
    last: Mutex<Option<Run>>,
    /// Stops the question about rows that was asked last.
    sifting: Mutex<Arc<AtomicBool>>,
}

#[derive(Debug)]
struct Run {
    number: u64,
    watch: Arc<Watch>,
    text: Option<Arc<Text>>,
}

/// Where the rows of a run are read again.
#[derive(Debug)]
struct Text {
    file: Mutex<File>,
    /// What the file was when it was judged; `None` for one of our own.
    stamp: Option<Stamp>,
    /// Where its first row begins.
    start: u64,
    layout: Arc<Layout>,
    sources: Arc<Sources>,
    /// Removes a temporary file that still has its name.
    _name: Option<tempfile::TempPath>,
}

/// Length and time of the last change.
type Stamp = (u64, Option<SystemTime>);

fn stamp(metadata: &Metadata) -> Stamp {
    (metadata.len(), metadata.modified().ok())
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn system(path: &Path, error: &io::Error) -> Message {
    files::system(path, error).message()
}

/// Whether a file of measurements is judged row by row, and why; `None` where it is imported. What is not understood is
/// imported too, as far as that goes, because the import says most about it.
pub(super) fn large(path: &Path) -> Result<Option<Large>, Message> {
    let (file, size) = files::open(path).map_err(|error| error.message())?;
    // A pipe is refused by the import.
    let Some(size) = size else { return Ok(None) };
    let mut stream = Stream::of(Box::new(file)).map_err(|error| system(path, &error))?;
    let is_packed = stream.packing != Packing::Plain;
    if !is_packed && size <= LARGE {
        return Ok(None);
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    match stream.layout(true, &name).map_err(|error| system(path, &error))? {
        Ok(_) if is_packed => Ok(Some(Large::Packed)),
        Ok(_) => Ok(Some(Large::Bytes(size))),
        Err(ImportErrorKind::OtherFormat { .. }) if !is_packed => Ok(None),
        Err(_) if !is_packed && size <= files::LARGEST => Ok(None),
        Err(error) => Err(error.message()),
    }
}

impl Runs {
    /// A new run; the one before ends.
    pub fn begin(&self, number: u64) -> Arc<Watch> {
        self.stop();
        let watch = Arc::<Watch>::default();
        *lock(&self.last) = Some(Run { number, watch: Arc::clone(&watch), text: None });
        watch
    }

    /// Ends the run that goes on, if one does.
    pub fn stop(&self) {
        if let Some(run) = lock(&self.last).as_ref() {
            run.watch.stop.store(true, Relaxed);
        }
        lock(&self.sifting).store(true, Relaxed);
    }

    /// Another question about rows; the one before is given up.
    pub fn asks(&self) -> Arc<AtomicBool> {
        let stop = Arc::<AtomicBool>::default();
        std::mem::replace(&mut *lock(&self.sifting), Arc::clone(&stop)).store(true, Relaxed);
        stop
    }

    fn set_text(&self, number: u64, text: &Arc<Text>) {
        if let Some(run) = lock(&self.last).as_mut().filter(|run| run.number == number) {
            run.text = Some(Arc::clone(text));
        }
    }

    /// Judges the rows of a file; what is found goes to `say`, at the end with how it ended.
    pub fn judge(
        &self,
        (number, path): (u64, &Path),
        watch: &Watch,
        sources: &Arc<Sources>,
        say: &mut (dyn FnMut(News) + Send),
    ) {
        let read = AtomicU64::new(0);
        let begun = Instant::now();
        let mut found =
            RunProgress { store: Store::default(), news: News::default(), read: &read, begun, said: None, say };
        // A run that fails inside says so like any other.
        let run = || self.judge_into((number, path), watch, sources, &mut found);
        let end = match std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)) {
            Ok(Ok(())) if watch.stop.load(Relaxed) => End::Cancelled,
            Ok(Ok(())) => End::Done,
            Ok(Err(problem)) => End::Failed(problem),
            Err(_) => End::Failed(message!("rows-panicked")),
        };
        found.news.end = Some(end);
        found.say();
    }

    fn judge_into(
        &self,
        (number, path): (u64, &Path),
        watch: &Watch,
        sources: &Arc<Sources>,
        found: &mut RunProgress<'_>,
    ) -> Result<(), Message> {
        let failed = |error: &io::Error| system(path, error);
        let (file, size) = files::open(path).map_err(|error| error.message())?;
        let before = file.metadata().map(|metadata| stamp(&metadata)).map_err(|error| failed(&error))?;
        found.news.bytes.1 = size;
        let seen = Arc::<Mutex<FileHash>>::default();
        let counted = Counted { file, read: found.read, seen: Arc::clone(&seen) };
        let mut stream = Stream::of(Box::new(counted)).map_err(|error| failed(&error))?;
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        let layout = stream.layout(true, &name).map_err(|error| failed(&error))?.map_err(|error| error.message())?;
        let layout = Arc::new(layout);
        let mut text = Text {
            file: Mutex::new(File::open(path).map_err(|error| failed(&error))?),
            stamp: Some(before),
            start: long(layout.skip),
            layout: Arc::clone(&layout),
            sources: Arc::clone(sources),
            _name: None,
        };
        let mut copy = None;
        if stream.packing != Packing::Plain || stream.is_utf16 {
            let (file, written, name) = unpacked().map_err(|error| message!("rows-no-copy").text("reason", error))?;
            text = Text { file: Mutex::new(file), stamp: None, start: 0, _name: name, ..text };
            copy = Some(written);
        }
        let text = Arc::new(text);
        self.set_text(number, &text);
        found.news.stream = Some(text);
        found.news.layout = Some(Arc::clone(&layout));
        let court = StreamJudging::new(&layout, sources);
        let cutter = Cutter::new(layout.separator(), BLOCK, true);
        let rows = Cursor::new(stream.head.within(layout.skip..)).chain(stream.input);
        let mut rows = Copied { rows, copy, length: 0 };
        let input = Input { stream: &mut rows, cutter };
        let making: (usize, &(dyn Fn() -> Marks + Sync)) = (batch::workers(), &Marks::default);
        let ended = batch::run_into(input, &court, making, found, watch, &mut |_| {});
        if !layout.is_utf8 {
            found.news.tally.not_utf8 += 1;
        }
        match ended {
            Ok(_) => {}
            Err(Failed::Reading(error) | Failed::Writing(error)) => return Err(failed(&error)),
        }
        let after = std::fs::metadata(path).map(|metadata| stamp(&metadata)).ok();
        if after != Some(before) && !watch.stop.load(Relaxed) {
            return Err(message!("rows-changed"));
        }
        // What was not read to its end has no hash.
        let is_whole = size.is_some_and(|size| size == found.read.load(Relaxed));
        found.news.sha256 = is_whole.then(|| lock(&seen).clone().hash());
        Ok(())
    }

    /// Reads rows again, each with its number among all.
    pub fn read(&self, number: u64, wanted: &[(Arc<Part>, Vec<usize>)]) -> Result<Vec<(u64, Arc<Picked>)>, Message> {
        let text = lock(&self.last).as_ref().filter(|run| run.number == number).and_then(|run| run.text.clone());
        // Another run has begun, and its rows are asked for anew.
        let Some(text) = text else { return Ok(Vec::new()) };
        let changed = || message!("rows-changed");
        let court = StreamJudging::new(&text.layout, &text.sources);
        let mut all = Vec::new();
        for (part, rows) in wanted {
            let bytes = text.bytes(part).map_err(|error| unread(&error))?;
            let picked = pick(bytes, part, rows, &court).ok_or_else(changed)?;
            let number = |row: &Picked| part.first + long(row.number);
            all.extend(picked.into_iter().map(|row| (number(&row), Arc::new(row))));
        }
        Ok(all)
    }
}

impl StreamBytes for Text {
    fn bytes(&self, part: &Part) -> io::Result<Vec<u8>> {
        let mut file = lock(&self.file);
        let mut bytes = vec![0; part.bytes];
        file.seek(SeekFrom::Start(self.start + part.start))?;
        file.read_exact(&mut bytes)?;
        let now = file.metadata().map(|metadata| stamp(&metadata))?;
        if self.stamp.is_none_or(|stamp| stamp == now) { Ok(bytes) } else { Err(io::ErrorKind::InvalidData.into()) }
    }
}

/// Finds rows or puts them in order; `None` where the question was given up.
pub(super) fn sift(rows: &ListedRows, sifting: &Sifting, stop: &AtomicBool) -> Option<Result<Sifted, Message>> {
    rows.sift(sifting, stop).map_err(|error| unread(&error)).transpose()
}

/// Why rows cannot be read again.
fn unread(error: &io::Error) -> Message {
    match error.kind() {
        io::ErrorKind::InvalidData | io::ErrorKind::UnexpectedEof => message!("rows-changed"),
        _ => message!("rows-unread").text("reason", error),
    }
}

/// A temporary file without a name, for writing at its end and for reading anywhere; its name where it still has one.
fn unpacked() -> io::Result<(File, File, Option<tempfile::TempPath>)> {
    let (written, name) = tempfile::Builder::new().prefix("fitcheck-").append(true).tempfile()?.into_parts();
    let file = File::open(&name)?;
    let is_nameless = std::fs::remove_file(&name).is_ok();
    Ok((file, written, (!is_nameless).then_some(name)))
}

/// Counts what is read of a file.
struct Counted<'a> {
    file: File,
    read: &'a AtomicU64,
    /// What its bytes are hashed to.
    seen: Arc<Mutex<FileHash>>,
}

impl Read for Counted<'_> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let read = self.file.read(to)?;
        lock(&self.seen).see(to.within(..read));
        self.read.fetch_add(long(read), Relaxed);
        Ok(read)
    }
}

/// Text that is written to a copy as it is read.
struct Copied<R> {
    rows: R,
    copy: Option<File>,
    length: u64,
}

impl<R: Read> Read for Copied<R> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let read = self.rows.read(to)?;
        if let Some(copy) = &mut self.copy {
            self.length += long(read);
            if MOST_UNPACKED < self.length {
                return Err(io::Error::other(
                    message!("rows-too-much").with("most", &(MOST_UNPACKED >> 30)).to_string(),
                ));
            }
            copy.write_all(to.within(..read))?;
        }
        Ok(read)
    }
}

/// What a run has found.
struct RunProgress<'a> {
    store: Store,
    news: News,
    read: &'a AtomicU64,
    begun: Instant,
    /// When it was last said.
    said: Option<Instant>,
    say: &'a mut (dyn FnMut(News) + Send),
}

impl RunProgress<'_> {
    fn say(&mut self) {
        let news = &mut self.news;
        news.classes.clone_from(&self.store.classes);
        news.bytes.0 = self.read.load(Relaxed);
        news.elapsed_ms = u64::try_from(self.begun.elapsed().as_millis()).unwrap_or(u64::MAX);
        let next = News { tally: news.tally.clone(), bytes: news.bytes, ..News::default() };
        (self.say)(std::mem::replace(news, next));
        self.said = Some(Instant::now());
    }
}

impl Sink<Marks> for RunProgress<'_> {
    fn take(&mut self, marks: &mut Marks, block: &Block, tally: &Tally) -> io::Result<()> {
        self.news.parts.push(Arc::new(self.store.part(marks, block, tally)));
        self.news.tally.add(tally.clone());
        // The first rows come at once.
        if self.said.is_none_or(|said| EVERY <= said.elapsed()) {
            self.say();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exchange::batch::Filter;

    /// A file of so many rows in a folder of its own.
    fn file(rows: usize) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.csv");
        files::write(&path, format!("callout,measured\n{}", "25 H7,25.01\n".repeat(rows)).as_bytes()).unwrap();
        (folder, path)
    }

    #[test]
    fn a_run_says_its_first_rows_at_once_and_ends_where_it_is_stopped() {
        let (_folder, path) = file(1_000_000);
        let runs = Runs::default();
        let watch = runs.begin(1);
        let mut rows = 0;
        let mut said = 0;
        let mut end = None;
        runs.judge((1, &path), &watch, &Arc::default(), &mut |news: News| {
            // The first answer has one block, and is cancelled.
            assert!(0 < said || news.layout.is_some() && news.parts.len() == 1);
            runs.stop();
            said += 1;
            rows += news.parts.iter().map(|part| part.len()).sum::<usize>();
            end = news.end;
        });
        assert_eq!(end, Some(End::Cancelled));
        assert!(0 < rows && rows < 1_000_000, "{rows}");
        assert_eq!(said, 2, "the first rows, and the end");
    }

    #[test]
    fn another_run_ends_the_one_before_and_its_rows_are_read_no_more() {
        let (_folder, path) = file(10);
        let runs = Runs::default();
        let first = runs.begin(1);
        let mut parts = Vec::new();
        runs.judge((1, &path), &first, &Arc::default(), &mut |news: News| parts.extend(news.parts));
        let wanted = vec![(Arc::clone(&parts[0]), vec![3, 9])];
        let read = runs.read(1, &wanted).unwrap();
        assert_eq!(read.iter().map(|(number, row)| (*number, row.line)).collect::<Vec<_>>(), [(3, 3), (9, 9)]);
        let second = runs.begin(2);
        assert!(first.stop.load(Relaxed) && !second.stop.load(Relaxed));
        assert_eq!(runs.read(1, &wanted), Ok(Vec::new()));
        // What replaced the file under its name is not read in its place.
        files::write(&path, b"callout,measured\n25 H7,25.01\n").unwrap();
        runs.judge((2, &path), &second, &Arc::default(), &mut |news: News| {
            if let Some(end) = news.end {
                assert_eq!(end, End::Done);
            }
        });
        assert_eq!(runs.read(2, &wanted), Err(Message::new("rows-changed")));
    }

    #[test]
    fn a_million_rows_are_put_in_order_and_a_question_is_given_up_for_the_next_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.csv");
        // The middle of the zone is 25.0105: the last rows are the worst.
        let rows: Vec<String> = (0..1_000_000).map(|row| format!("25 H7,25.{:06}", row / 10)).collect();
        files::write(&path, format!("callout,measured\n{}\n", rows.join("\n")).as_bytes()).unwrap();
        let runs = Runs::default();
        let watch = runs.begin(1);
        let mut all = News::default();
        runs.judge((1, &path), &watch, &Arc::default(), &mut |news: News| {
            all.layout = news.layout.or_else(|| all.layout.take());
            all.stream = news.stream.or_else(|| all.stream.take());
            all.classes = news.classes;
            all.parts.extend(news.parts);
        });
        let sieve = Filter::default().sieve(all.classes.len());
        let rows = ListedRows {
            layout: all.layout.unwrap(),
            sources: Arc::default(),
            parts: all.parts,
            stream: all.stream.unwrap(),
            sieve,
            order: None,
        };
        let sifting = Sifting { is_worst_first: true, ..Sifting::default() };
        let stop = runs.asks();
        let sifted = sift(&rows, &sifting, &stop).unwrap().unwrap();
        assert_eq!((sifted.count, sifted.numbers.len(), sifted.unjudged), (1_000_000, 1_000_000, 0));
        // 25.099999 mm is the largest, and of equals the first of the file is first.
        assert_eq!(
            sifted.numbers[..11],
            [999_990, 999_991, 999_992, 999_993, 999_994, 999_995, 999_996, 999_997, 999_998, 999_999, 999_980]
        );
        let _next = runs.asks();
        assert_eq!(sift(&rows, &sifting, &stop), None);
    }

    #[test]
    fn small_files_logs_and_what_is_not_understood_are_imported() {
        let (_folder, path) = file(10);
        assert_eq!(large(&path), Ok(None));
        let (_folder, path) = file(400_000);
        assert!(matches!(large(&path), Ok(Some(Large::Bytes(bytes))) if LARGE < bytes));
        files::write(&path, &vec![0; 5 << 20]).unwrap();
        assert_eq!(large(&path), Ok(None));
    }
}
