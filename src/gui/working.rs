//! A file that is read or written on a thread says how far it is, and can be stopped: what was not read whole is not taken, and what was
//! not written whole is not there.

use std::cell::RefCell;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use eframe::egui::accesskit::Role;
use eframe::egui::{ProgressBar, Ui, WidgetInfo};

use super::check::grouped;
use super::shapes::share;
use super::theme::space;
use super::view::{View, quiet};
use crate::exchange::Body;
use crate::message::{Message, message};
use crate::session::{WindowAction, Working};
use crate::text::long;

/// Before this nothing is said: most files are done by then.
const PATIENCE: Duration = Duration::from_millis(300);

/// How often it is said how far a file is.
const EVERY: Duration = Duration::from_millis(100);

/// The file that is being read or written, for whoever wants to stop it.
#[derive(Debug, Default)]
pub(super) struct Works(Mutex<Option<Arc<AtomicBool>>>);

impl Works {
    /// Another file; `say` hears how far it is, and nothing once it is done.
    pub fn begin(&self, path: &Path, is_writing: bool, say: Box<dyn Fn(Option<Working>)>) -> Job {
        let stop = Arc::<AtomicBool>::default();
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(&stop));
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let far = Working { name, is_writing, rows: 0, bytes: 0, all: None, elapsed_ms: 0 };
        Job { stop, say, begun: Instant::now(), far: RefCell::new((far, None)) }
    }

    /// Stops it, if there is one.
    pub fn stop(&self) {
        if let Some(stop) = self.0.lock().unwrap_or_else(PoisonError::into_inner).as_ref() {
            stop.store(true, Relaxed);
        }
    }
}

/// A file on its way.
pub(super) struct Job {
    stop: Arc<AtomicBool>,
    say: Box<dyn Fn(Option<Working>)>,
    begun: Instant,
    /// How far it is, and when that was last said.
    far: RefCell<(Working, Option<Instant>)>,
}

impl Job {
    /// Whether it is to stop.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Relaxed)
    }

    /// How many bytes there are to read.
    pub fn has(&self, bytes: usize) {
        self.far.borrow_mut().0.all = u64::try_from(bytes).ok();
    }

    pub fn row(&self) {
        self.far.borrow_mut().0.rows += 1;
        self.tell();
    }

    /// What to say of a file that was stopped while it was read.
    pub fn stopped(&self) -> Message {
        let (far, _) = &*self.far.borrow();
        message!("working-stopped").text("rows", far.rows).text("name", &far.name)
    }

    fn at(&self, bytes: u64) {
        {
            let (far, _) = &mut *self.far.borrow_mut();
            far.bytes = far.bytes.max(bytes);
        }
        self.tell();
    }

    fn tell(&self) {
        let (far, said) = &mut *self.far.borrow_mut();
        let elapsed = self.begun.elapsed();
        if elapsed < PATIENCE || said.is_some_and(|said| said.elapsed() < EVERY) {
            return;
        }
        *said = Some(Instant::now());
        far.elapsed_ms = u64::try_from(elapsed.as_millis()).unwrap_or(u64::MAX);
        (self.say)(Some(far.clone()));
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        if self.far.get_mut().1.is_some() {
            (self.say)(None);
        }
    }
}

/// What a stream says that is to stop; what is told of it is [`Job::stopped`].
fn stopped() -> io::Error {
    io::Error::other("stopped")
}

/// A file that is read for a job.
pub(super) struct Watched<'a, B: ?Sized> {
    pub body: &'a mut B,
    pub job: &'a Job,
    at: u64,
}

impl<'a, B: ?Sized> Watched<'a, B> {
    pub const fn new(body: &'a mut B, job: &'a Job) -> Self {
        Self { body, job, at: 0 }
    }
}

impl<B: Body + ?Sized> Read for Watched<'_, B> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.job.is_stopped() {
            return Err(stopped());
        }
        let count = self.body.read(buffer)?;
        self.at += long(count);
        self.job.at(self.at);
        Ok(count)
    }
}

impl<B: Body + ?Sized> Seek for Watched<'_, B> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = self.body.seek(to)?;
        Ok(self.at)
    }
}

impl<B: Write + ?Sized> Write for Watched<'_, B> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.job.is_stopped() {
            return Err(stopped());
        }
        let count = self.body.write(bytes)?;
        self.at += long(count);
        self.job.at(self.at);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.body.flush()
    }
}

/// How far the file is, and the button that stops it.
pub(super) fn working_ui(ui: &mut Ui, view: &mut View<'_>, working: &Working) {
    let text = view.words.say(&message(view, working));
    ui.horizontal_wrapped(|ui| {
        if let Some(all) = working.all {
            let bar = ProgressBar::new(share(working.bytes, all)).desired_width(space(25.0)).desired_height(space(3.0));
            let shown = ui.add(bar);
            shown.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, view.text("working-progress")));
        }
        quiet(ui, text);
        view.field_button(ui, WindowAction::StopWorking);
    });
}

/// `Reading bores.csv: 120 000 rows, 3.1 of 8.2 MB, 240 000 rows a second`.
fn message(view: &View<'_>, working: &Working) -> Message {
    let tenths = |bytes: u64| view.words.number(&format!("{}.{}", bytes / 1_000_000, bytes / 100_000 % 10));
    let seconds = Duration::from_millis(working.elapsed_ms).as_secs_f64();
    let message = match (working.is_writing, working.rate()) {
        (true, _) => message!("working-writing"),
        (false, Some(rate)) => message!("working-reading").text("rate", grouped(rate)),
        (false, None) => message!("working-reading-bytes"),
    };
    message
        .text("name", &working.name)
        .text("rows", grouped(working.rows))
        .text("done", tenths(working.bytes))
        // What is read has told its size before anything is said of it; what is written has none.
        .text("all", tenths(working.all.unwrap_or(0)))
        .text("seconds", view.words.number(&format!("{seconds:.1}")))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;
    use std::rc::Rc;

    use super::*;

    #[test]
    fn a_file_that_is_stopped_ends_in_an_error_and_says_how_far_it_was() {
        let works = Works::default();
        let job = works.begin(Path::new("folder/bores.csv"), false, Box::new(|_| {}));
        let mut body = Cursor::new(vec![b'x'; 100]);
        let mut watched = Watched::new(&mut body, &job);
        let mut some = [0; 40];
        assert_eq!(watched.read(&mut some).unwrap(), 40);
        job.row();
        works.stop();
        assert!(job.is_stopped());
        assert!(watched.read(&mut some).is_err());
        assert_eq!(job.stopped().to_string(), "Stopped after 1 rows: nothing from bores.csv was imported");
        // The next one is not stopped.
        assert!(!works.begin(Path::new("b.csv"), true, Box::new(|_| {})).is_stopped());
    }

    #[test]
    fn short_work_says_nothing_and_long_work_says_its_figures_and_its_end() {
        let said = Rc::new(RefCell::new(Vec::new()));
        let hear = || {
            let said = Rc::clone(&said);
            Box::new(move |far: Option<Working>| said.borrow_mut().push(far))
        };
        let works = Works::default();
        let job = works.begin(Path::new("a.csv"), false, hear());
        job.row();
        drop(job);
        assert!(said.borrow().is_empty());
        let mut job = works.begin(Path::new("a.csv"), false, hear());
        job.begun = Instant::now().checked_sub(Duration::from_secs(2)).unwrap();
        job.has(1_000);
        job.at(250);
        // Within a tenth of a second nothing more is said.
        job.row();
        drop(job);
        let said = said.borrow();
        let [Some(far), None] = said.as_slice() else { panic!("{said:?}") };
        assert_eq!((far.rows, far.bytes, far.all), (0, 250, Some(1_000)));
        assert!((2_000..3_000).contains(&far.elapsed_ms), "{}", far.elapsed_ms);
    }
}
