//! A folder that is watched: what came, what waits, what was refused. The folder itself is looked at outside.
//!
//! Outside waits with the next look until this one is recorded: what is not on disk is not taken, so that nothing is lost and nothing is
//! there twice, whoever ends the program meanwhile.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::part::Plan;
use fitcheck_core::verdict::Status;
use fitcheck_exchange::journal::entry::{FileRole, UsedFile};
use jiff::civil::DateTime;

use super::PartsPage;
use super::arriving::said_of_others;
use super::measuring::Arriving;
use super::watch_news::{WatchNews, WatchedFile};
use crate::effect::Effect;
use crate::recording::Keeping;
use crate::saved::SavedWatch;
use crate::shared::{OwnMask, Shared};

/// How many files are listed, the latest first.
const MOST: usize = 200;

#[derive(Debug, Clone)]
pub struct TakenFile {
    /// Its name without the folder.
    pub name: String,
    /// When it was taken.
    pub time: DateTime,
    /// How many values there are of each status, in the order of [`Status::ALL`].
    pub counts: Vec<(Status, usize)>,
    /// What was refused of it, and what else is to be said.
    pub said: Vec<Message>,
}

/// A watched folder.
#[derive(Debug, Default)]
pub struct Watched {
    /// The folder, while it is watched.
    pub folder: Option<PathBuf>,
    plan: Option<Arc<Plan>>,
    /// The file of the plan, where it has one.
    plan_path: Option<PathBuf>,
    run: u64,
    /// Whether it has to wait before it can begin.
    is_late: bool,
    /// Whether it waits for checks that are not on disk yet.
    is_unwritten: bool,
    /// How many files and parts of files were known when it began; `None` before that.
    pub known: Option<usize>,
    files: VecDeque<TakenFile>,
    /// How many files were taken.
    pub count: usize,
    /// The files that are not ready, with the reasons.
    pub waiting: Vec<(String, Message)>,
    /// Why nothing is watched at the moment.
    pub trouble: Option<Message>,
    /// The look that is being recorded, and the batch of the journal.
    pending: Option<(u64, u64)>,
}

impl Watched {
    /// The file of the plan that it is judged by, while it is watched.
    pub(super) fn plan_path(&self) -> Option<&Path> {
        self.plan_path.as_deref().filter(|_| self.folder.is_some())
    }

    /// The files that were taken, the latest first.
    pub fn files(&self) -> impl Iterator<Item = &TakenFile> {
        self.files.iter()
    }

    /// Whether something that came is not on disk yet.
    pub const fn is_recording(&self) -> bool {
        self.pending.is_some() || self.is_unwritten
    }

    /// What is kept of it until the next time; a plan without a file cannot be.
    pub(super) fn saved(&self) -> Option<SavedWatch> {
        let folder = self.folder.clone()?;
        let plan = self.plan_path.clone()?;
        Some(SavedWatch { folder, plan }).filter(|saved| saved.folder.to_str().and(saved.plan.to_str()).is_some())
    }

    /// The plan that values are judged by.
    pub(super) const fn plan(&self) -> Option<&Arc<Plan>> {
        self.plan.as_ref()
    }

    /// Whether it is there again after a restart: its plan is in a file.
    pub const fn comes_back(&self) -> bool {
        self.plan_path.is_some()
    }

    /// A plan was saved: where it is the one that values are judged by, it can be read again.
    pub(super) fn saved_as(&mut self, plan: Option<&Arc<Plan>>, path: &Path) {
        if plan.is_some() && self.plan.as_ref() == plan {
            self.plan_path = Some(path.to_owned());
        }
    }

    /// Ends the watch; what was taken stays listed.
    pub(super) fn stop(&mut self) -> Option<Effect> {
        self.run += 1;
        self.waiting = Vec::new();
        self.trouble = None;
        self.pending = None;
        self.is_late = false;
        self.is_unwritten = false;
        self.folder.take().map(|_| Effect::StopWatch)
    }
}

impl PartsPage {
    /// Whether the folder is judged by another plan than the one that is open: by the one with which the watch began.
    pub fn watches_other_plan(&self) -> bool {
        let own = self.watched.plan.as_ref().filter(|_| self.watched.folder.is_some() && !self.walking.is_begun());
        own.is_some_and(|own| !self.document.plan().is_some_and(|now| Arc::ptr_eq(own, now) || own == now))
    }

    /// Watches a folder from now on.
    pub(super) fn watch(&mut self, folder: PathBuf, is_folder: bool, shared: &mut Shared) {
        let result =
            if is_folder { Ok(folder) } else { Err(message!("walk-page-no-folder").text("path", folder.display())) };
        let Some(folder) = shared.file_answered(result) else { return };
        let plan = self.walking.plan.as_ref().or(self.document.plan()).map(Arc::clone);
        let plan_path = if self.walking.plan.is_some() {
            self.walking.path.clone()
        } else {
            // A plan that was changed and not saved cannot be read again.
            self.document.path().filter(|_| !self.document.is_unsaved()).map(Path::to_owned)
        };
        let Some(plan) = plan else { return shared.tell(message!("walk-page-watch-no-plan")) };
        if shared.recording.has_failed_to_open() {
            return shared.tell(message!("walk-page-watch-no-journal"));
        }
        self.watched.run += 1;
        let run = self.watched.run;
        self.resume.watched = None;
        let folder = Some(folder);
        let plan = Some(plan);
        self.watched = Watched { folder, plan, plan_path, run, is_late: true, ..Watched::default() };
        self.begin_watch(shared);
    }

    /// Begins a watch that was asked for. What the journal knows already is not taken again, so that has to be open, and nothing may be
    /// on its way there: it would be taken a second time.
    pub(super) fn begin_watch(&mut self, shared: &mut Shared) {
        let watched = &mut self.watched;
        let (Some(folder), Some(plan)) = (watched.folder.clone(), watched.plan.clone()) else { return };
        if !watched.is_late || shared.recording.keeping == Keeping::Opening {
            return;
        }
        if shared.recording.has_failed_to_open() {
            watched.folder = None;
            watched.is_late = false;
            watched.is_unwritten = false;
            return shared.tell(message!("walk-page-watch-no-journal"));
        }
        watched.is_unwritten = shared.recording.is_on() && 0 < shared.recording.unwritten();
        if watched.is_unwritten {
            return;
        }
        match &shared.own_mask {
            OwnMask::Awaited(_) => return,
            // What it has printed would be refused, and that for good.
            OwnMask::Unread(path) => {
                watched.trouble = Some(message!("walk-page-watch-no-mask").text("path", path.display()));
                return;
            }
            OwnMask::Settled => watched.trouble = None,
        }
        watched.is_late = false;
        self.errands.push(Effect::Watch { run: watched.run, folder, plan });
    }

    /// A part is begun by another plan: the folder is judged by it from now on.
    pub(super) fn watch_plan(&mut self, plan: &Arc<Plan>, shared: &mut Shared) {
        if !self.watched.plan.as_ref().is_some_and(|old| **old == **plan) && self.watched.folder.is_some() {
            self.watched.plan = Some(Arc::clone(plan));
            self.watched.plan_path.clone_from(&self.walking.path);
            self.watch_anew(shared);
        }
    }

    /// The folder is judged by another plan or with other columns from now on.
    pub(super) fn watch_anew(&mut self, shared: &mut Shared) {
        let watched = &mut self.watched;
        if watched.folder.is_some() {
            watched.run += 1;
            watched.is_late = true;
            watched.pending = None;
            watched.waiting = Vec::new();
            self.begin_watch(shared);
        }
    }

    /// Something came from the folder. What belongs to a watch that was ended changes nothing.
    pub(super) fn watch_news(&mut self, run: u64, news: WatchNews, shared: &mut Shared, now: DateTime) {
        if run != self.watched.run || self.watched.folder.is_none() {
            return;
        }
        match news {
            WatchNews::Begun(known) => {
                self.watched.known = Some(known);
                self.watched.trouble = None;
            }
            WatchNews::Waiting(waiting) => self.watched.waiting = waiting,
            WatchNews::Trouble(trouble) => self.watched.trouble = trouble,
            WatchNews::Look { number, files } => self.look(number, files, shared, now),
        }
    }

    /// Takes all files of a look: they are recorded together.
    fn look(&mut self, number: u64, files: Vec<WatchedFile>, shared: &mut Shared, now: DateTime) {
        let Some(plan) = self.watched.plan.clone() else { return };
        let mut values = Vec::new();
        for WatchedFile { name, sha256, items, remarks } in files {
            let file = UsedFile { role: FileRole::Measurements, name: name.as_str().into(), sha256 };
            let arrived = self.arrive(&plan, items, Some(&file), shared);
            let count = |status: Status| {
                let is_it = |value: &&Arriving| value.record.verdict.status() == status;
                arrived.values.iter().filter(is_it).count()
            };
            let counts = Status::ALL.into_iter().map(|status| (status, count(status))).collect();
            let others = said_of_others(&arrived);
            let nobodys = said_of_nobody(&arrived.values);
            let said = arrived.problems.into_iter().chain(remarks).chain(others).chain(nobodys);
            let said = said.chain(arrived.warnings).collect();
            self.watched.files.push_front(TakenFile { name, time: now, counts, said });
            self.watched.files.truncate(MOST);
            self.watched.count += 1;
            values.extend(arrived.values);
        }
        let sent = self.keep(values, shared);
        self.stay_open();
        match sent.run {
            Some(batch) => self.watched.pending = Some((number, batch)),
            // Nothing of it is recorded: it counts as taken until the window is closed.
            None => self.errands.push(Effect::WatchTaken { run: self.watched.run, look: number }),
        }
    }

    /// The journal has answered: what is on disk is taken, and a watch that waited for it begins. What is not stays waiting until it is
    /// tried again.
    pub(super) fn batch_kept(&mut self, batch: u64, is_kept: bool, shared: &mut Shared) {
        if let Some((look, _)) = self.watched.pending.take_if(|(_, pending)| is_kept && *pending == batch) {
            self.errands.push(Effect::WatchTaken { run: self.watched.run, look });
        }
        self.begin_watch(shared);
    }
}

/// That some values are of no part: neither their file nor a part that is being measured says whose they are.
fn said_of_nobody(values: &[Arriving]) -> Option<Message> {
    let is_nobodys = |value: &&Arriving| {
        let has_serial = value.labels.as_deref().is_some_and(|labels| !labels.serial.is_empty());
        value.at.is_none() && !has_serial
    };
    let count = values.iter().filter(is_nobodys).count();
    (0 < count).then(|| message!("walk-page-watch-nobody").count("count", count))
}
