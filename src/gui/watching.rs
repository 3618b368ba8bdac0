//! A watched folder, on a thread of its own: it looks, tells what is ready, and waits with the next look until that is recorded.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use eframe::egui::Context;
use jiff::civil::DateTime;

use crate::control::mask::Mask;
use crate::exchange::Remembered;
use crate::message::{Message, Say as _, message};
use crate::part::Plan;
use crate::session::Command;
use crate::session::parts::{WalkCommand, WatchNews, WatchedFile};
use crate::tolerance::Sources;
use crate::tolerance::fit::thermal::Temperature;
use crate::watch::{Alone, Batch, EVERY, FileJudging, FolderScan, PATIENCE, TakenFiles, Watcher};
use crate::words::{Language, Words};

/// Reads what the journal knows already.
pub(super) type KnownOf = Box<dyn FnOnce() -> Result<TakenFiles, Message> + Send>;

/// What a watch needs.
pub(super) struct Watch {
    pub run: u64,
    pub folder: PathBuf,
    pub plan: Arc<Plan>,
    pub sources: Arc<Sources>,
    /// The columns of files as they were corrected.
    pub columns: Arc<Remembered>,
    /// The user's own mask.
    pub masks: Arc<Vec<(String, Mask)>>,
    /// Of what is written beside files that cannot be used.
    pub language: Language,
    pub clock: fn() -> DateTime,
    /// From which temperature values are brought to 20 °C.
    pub temperature: Option<Temperature>,
    pub known: KnownOf,
    /// The journal, where there is one: nobody else watches the folder for it.
    pub journal: Option<PathBuf>,
    pub ctx: Context,
    pub answers: Sender<Command>,
}

/// The watch that goes on: its number, and where its thread hears which looks are recorded. Without it the thread ends.
#[derive(Debug, Default)]
pub(super) struct Watching(Mutex<Option<(u64, Sender<u64>)>>);

impl Watching {
    /// Begins a watch in place of any other.
    pub fn begin(&self, watch: Watch) {
        let (sender, taken) = channel();
        *self.current() = Some((watch.run, sender));
        let said = std::thread::Builder::new().name("watch".to_owned()).spawn(move || watch.run(&taken));
        if let Err(error) = said {
            log::error!("no thread for watch: {error}");
        }
    }

    /// What a look has found is recorded.
    pub fn taken(&self, run: u64, look: u64) {
        if let Some((_, sender)) = self.current().as_ref().filter(|(current, _)| *current == run) {
            // A thread that has ended hears nothing more.
            let _ended = sender.send(look);
        }
    }

    /// Ends the watch.
    pub fn stop(&self) {
        *self.current() = None;
    }

    fn current(&self) -> std::sync::MutexGuard<'_, Option<(u64, Sender<u64>)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What the window knows already: it is told only what changes.
#[derive(Default)]
struct ReportedWatch {
    same: Vec<(String, Message)>,
    waiting: Vec<(String, Message)>,
    trouble: Option<Message>,
}

impl Watch {
    fn run(mut self, taken: &Receiver<u64>) {
        let Ok(alone) = self.alone(taken) else { return };
        let nothing: KnownOf = Box::new(|| Ok(TakenFiles::default()));
        let known = match std::mem::replace(&mut self.known, nothing)() {
            Ok(known) => known,
            Err(why) => return self.say(WatchNews::Trouble(Some(why))),
        };
        self.say(WatchNews::Begun(known.count()));
        let words = Words::new(self.language);
        let mut watcher = Watcher::new(&self.folder, known);
        let begun = Instant::now();
        // What this program itself writes is no measurement.
        if let Some(journal) = &self.journal {
            watcher.leave_journal(journal);
        }
        if let Some(alone) = &alone {
            watcher.leave(alone.file());
        }
        let mut told = ReportedWatch::default();
        let mut number = 0;
        loop {
            let plan = Some(&*self.plan);
            let sources = &*self.sources;
            let columns = Some(&*self.columns);
            let judging = FileJudging {
                plan,
                sources,
                masks: &self.masks,
                columns,
                now: (self.clock)(),
                temperature: self.temperature,
            };
            let look = watcher.look(judging, begun.elapsed()).map_err(|error| error.message());
            let ready = self.tell(look, &mut told);
            if let Err(error) = watcher.tell(&|message| words.say(message)) {
                told.trouble = Some(error.message());
                self.say(WatchNews::Trouble(told.trouble.clone()));
            }
            if !ready.is_empty() {
                number += 1;
                self.say(WatchNews::Look { number, files: ready.iter().map(file).collect() });
                if !is_recorded(taken, number) {
                    return;
                }
                for batch in &ready {
                    if let Err(error) = watcher.taken(batch, &|message| words.say(message)) {
                        told.trouble = Some(error.message());
                        self.say(WatchNews::Trouble(told.trouble.clone()));
                    }
                }
            }
            match taken.recv_timeout(EVERY) {
                Err(RecvTimeoutError::Disconnected) => return,
                Ok(_) | Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// Waits until nobody else watches the folder for the journal; an error where this one is ended meanwhile.
    fn alone(&self, taken: &Receiver<u64>) -> Result<Option<Alone>, RecvTimeoutError> {
        let Some(journal) = &self.journal else { return Ok(None) };
        let begun = Instant::now();
        let mut is_told = false;
        loop {
            match Alone::take(&self.folder, journal) {
                Ok(Some(alone)) => {
                    if is_told {
                        self.say(WatchNews::Trouble(None));
                    }
                    return Ok(Some(alone));
                }
                Ok(None) => {}
                // Some shares have no locks.
                Err(error) => {
                    log::warn!("it is not known whether another program watches the folder: {error}");
                    return Ok(None);
                }
            }
            // A watch of this window that is replaced needs a moment to end.
            if !is_told && PATIENCE <= begun.elapsed() {
                is_told = true;
                self.say(WatchNews::Trouble(Some(message!("watch-by-another"))));
            }
            if let Err(ended @ RecvTimeoutError::Disconnected) = taken.recv_timeout(EVERY) {
                return Err(ended);
            }
        }
    }

    /// Tells what has changed: what is waited for, and whether the folder can be read. Returns what is ready.
    fn tell(&self, look: Result<FolderScan, Message>, told: &mut ReportedWatch) -> Vec<Batch> {
        let (FolderScan { ready, waiting, same }, trouble) = match look {
            Ok(look) => (look, None),
            Err(why) => (FolderScan::default(), Some(why)),
        };
        if trouble != told.trouble {
            told.trouble.clone_from(&trouble);
            self.say(WatchNews::Trouble(trouble));
        }
        // A copy of what was taken stays in the list: nothing of it will come.
        for (name, known) in same {
            let why =
                if name == known { message!("watch-same-again") } else { message!("watch-same").text("known", known) };
            // It is told again when it was written again.
            told.same.retain(|(other, _)| *other != name);
            told.same.push((name, why));
        }
        let waiting = waiting.into_iter().map(|(name, why)| (name, why.message()));
        let waiting: Vec<_> = waiting.chain(told.same.iter().cloned()).collect();
        if waiting != told.waiting {
            told.waiting.clone_from(&waiting);
            self.say(WatchNews::Waiting(waiting));
        }
        ready
    }

    fn say(&self, news: WatchNews) {
        // A closed window hears nothing; that is not an error.
        let _closed = self.answers.send(WalkCommand::Watched { run: self.run, news: Box::new(news) }.into());
        self.ctx.request_repaint();
    }
}

/// Waits until a look is recorded; whether the watch goes on.
fn is_recorded(taken: &Receiver<u64>, number: u64) -> bool {
    loop {
        match taken.recv() {
            Ok(look) if look == number => return true,
            Ok(_) => {}
            Err(_ended) => return false,
        }
    }
}

fn file(batch: &Batch) -> WatchedFile {
    let Batch { name, sha256, items, remarks, .. } = batch;
    WatchedFile { name: name.clone(), sha256: *sha256, items: items.clone(), remarks: remarks.clone() }
}
