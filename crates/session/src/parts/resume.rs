//! A part that was interrupted comes back: its plan and its serial number from the state file, its values from the journal.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::part::Plan;
use fitcheck_exchange::journal::ask::{AskedKinds, Question};
use fitcheck_exchange::journal::entry::{Checked, Entry};
use fitcheck_exchange::journal::query::RecordId;

use super::PartsPage;
use super::planned::{Away, Planned, Sizes};
use super::walking::Value;
use crate::effect::Effect;
use crate::notice::Notice;
use crate::parts::WalkField;
use crate::purpose::Purpose;
use crate::recording::{Keeping, Recorded};
use crate::records::RecordRow;
use crate::saved::{SavedWalk, SavedWatch};
use crate::shared::Shared;

/// The most values of a part that come back: every size of the largest plan, some of them several times.
const MOST: usize = 10_000;

/// A part that waits for its plan and the journal.
#[derive(Debug, Default)]
pub(super) struct Resume {
    /// What the state file says.
    saved: Option<SavedWalk>,
    /// The number of the question to the journal.
    run: u64,
    /// The newest record when it was asked: what comes later was measured here.
    until: u64,
    /// Whether it is being answered.
    is_asked: bool,
    /// The folder that is to be watched again.
    pub(super) watched: Option<SavedWatch>,
    /// Whether it was told that both wait for a plan without faults.
    is_told: bool,
}

impl Resume {
    pub(super) fn new(mut saved: SavedWalk) -> Self {
        let watched = saved.watched.take();
        Self { saved: saved.plan.is_some().then_some(saved), watched, ..Self::default() }
    }
}

impl PartsPage {
    /// What is kept of the part that is being measured, or that waits to come back.
    pub(crate) fn saved_walk(&self) -> SavedWalk {
        SavedWalk { watched: self.resume.watched.clone().or_else(|| self.watched.saved()), ..self.saved_part() }
    }

    fn saved_part(&self) -> SavedWalk {
        if let Some(saved) = &self.resume.saved {
            return saved.clone();
        }
        let plan: Option<PathBuf> = self.walking.path.clone().filter(|path| path.to_str().is_some());
        if !self.walking.is_begun() || plan.is_none() {
            return SavedWalk::default();
        }
        let serial = self.walking.serial().to_owned();
        let skipped = self.walking.skipped();
        let Planned { sizes, since: planned } = self.walking.planned.clone();
        SavedWalk { plan, serial, since: self.walking.since, sizes, planned, skipped, watched: None }
    }

    /// Watches the folder of the last time again once its plan is there.
    fn try_watch_again(&mut self) {
        let Some(plan) = self.document.path().filter(|_| self.document.plan().is_some()) else { return };
        if let Some(watched) = self.resume.watched.take_if(|watched| watched.plan == *plan) {
            self.errands.push(Effect::Read(Purpose::WatchFolder, watched.folder));
        }
    }

    /// Tells once what waits because its plan has faults now.
    fn tell_waiting(&mut self, shared: &mut Shared) {
        let Some(path) = self.document.path().filter(|_| self.document.plan().is_none()) else { return };
        let part = self.resume.saved.as_ref().filter(|saved| saved.plan.as_deref() == Some(path));
        let folder = self.resume.watched.as_ref().filter(|watched| watched.plan == *path);
        if std::mem::replace(&mut self.resume.is_told, part.is_some() || folder.is_some()) {
            return;
        }
        if let Some(saved) = part {
            shared.tell(message!("walk-page-part-waits").text("serial", &saved.serial));
        }
        if let Some(watched) = folder {
            shared.tell(message!("walk-page-watch-waits").text("path", watched.folder.display()));
        }
    }

    /// Begins the interrupted part once its plan is there, and asks the journal for its values once that is open.
    pub(super) fn try_resume(&mut self, shared: &mut Shared) {
        self.tell_waiting(shared);
        self.try_watch_again();
        let Some(saved) = &self.resume.saved else { return };
        let is_its = self.document.path() == saved.plan.as_deref();
        let Some(plan) = self.document.plan().filter(|_| is_its).map(Arc::clone) else { return };
        match shared.recording.keeping {
            // Nobody has said yet where records are kept.
            Keeping::Nowhere if !shared.recording.has_begun() => return,
            Keeping::Opening => return,
            Keeping::Open | Keeping::Nowhere | Keeping::Off | Keeping::Failed(_) => {}
        }
        let Some(saved) = self.resume.saved.take() else { return };
        self.walking.begin(&plan, saved.plan.clone(), saved.serial.clone(), saved.since);
        self.walking.opened = self.document.opened;
        let is_other_plan = self.walking.planned.sizes != saved.sizes;
        let is_open = shared.recording.keeping == Keeping::Open;
        if is_other_plan && is_open {
            self.walking.planned.since = shared.recording.newest;
        } else {
            // Without a journal it cannot be said from which record on the plan is another one: the next time finds that out.
            self.walking.planned = Planned { sizes: saved.sizes.clone(), since: saved.planned };
        }
        let mut gone = BTreeSet::new();
        let sizes = Sizes::of(&plan);
        for (name, reason) in &saved.skipped {
            match sizes.named(name, is_other_plan) {
                Some(at) => _ = self.walking.skip(at, reason),
                None => _ = gone.insert(name.clone()),
            }
        }
        tell_gone(gone, shared);
        self.stay_open();
        if !is_open {
            return shared.tell(message!("walk-page-no-journal").text("serial", &saved.serial));
        }
        self.resume.run += 1;
        self.resume.until = shared.recording.newest;
        self.resume.is_asked = true;
        let part = Some(plan.head.part.clone()).filter(|part| !part.is_empty());
        let serial = Some(saved.serial).filter(|serial| !serial.is_empty());
        // What is corrected says in which order the values came.
        let question = Box::new(Question { part, serial, kinds: AskedKinds::Checks, ..Question::default() });
        self.errands.push(Effect::ReadPart { run: self.resume.run, question, most: MOST });
    }

    /// It does not come back: its plan cannot be read, or another part was begun. Returns the one that waited.
    pub(super) fn give_up_resuming(&mut self) -> Option<SavedWalk> {
        self.resume.is_asked = false;
        self.resume.saved.take()
    }

    /// The journal has answered. Values that were measured meanwhile stay the last ones.
    pub(super) fn came(&mut self, run: u64, result: Result<Vec<RecordRow>, Message>, shared: &mut Shared) {
        if run != self.resume.run || !std::mem::take(&mut self.resume.is_asked) {
            return;
        }
        let rows = match result {
            Ok(rows) => rows,
            Err(why) => return shared.tell(message!("walk-page-not-read").message("why", why)),
        };
        let Some(plan) = self.walking.plan.as_ref().map(Arc::clone) else { return };
        let mut count = 0;
        let mut gone = BTreeSet::new();
        let mut changed = Vec::new();
        let sizes = Sizes::of(&plan);
        let corrected: BTreeMap<u64, u64> = rows.iter().filter_map(corrects).collect();
        let mut came: Vec<(u64, (usize, Value))> = Vec::new();
        for row in &rows {
            let number = row.head.number;
            let Ok(entry) = &row.entry else { continue };
            // A correction stands where the value stood: what was measured after that counts.
            let place = first(&corrected, number);
            let is_known = self.resume.until < number;
            if !self.is_of_part(entry) || place <= self.walking.since || row.corrected_by.is_some() || is_known {
                continue;
            }
            match value(&sizes, number, entry, place <= self.walking.planned.since) {
                Some(Ok(value)) => {
                    count += 1;
                    came.push((place, value));
                }
                Some(Err(Away::Changed(value))) => changed.push(value),
                Some(Err(Away::Gone)) => _ = gone.insert(entry.about.feature.clone()),
                None => {}
            }
            self.see_label(&plan, entry);
        }
        tell_gone(gone, shared);
        if !changed.is_empty() {
            let said = message!("walk-page-changed");
            shared.notices.push(Notice { details: changed, ..Notice::of(said, true) });
        }
        came.sort_by_key(|(place, _)| *place);
        self.walking.put_before(came.into_iter().map(|(_, value)| value).collect());
        self.stay_open();
        let said = message!("walk-page-came-back").text("serial", self.walking.serial()).count("count", count);
        shared.note(said, Vec::new());
    }
}

/// The number of an entry that corrects another one, and that of the other one.
fn corrects(row: &RecordRow) -> Option<(u64, u64)> {
    Some((row.head.number, row.entry.as_ref().ok()?.corrects()?.target.number))
}

/// The number of the entry that all corrections up to this one go back to.
fn first(corrected: &BTreeMap<u64, u64>, number: u64) -> u64 {
    let mut number = number;
    // An entry corrects an earlier one.
    while let Some(target) = corrected.get(&number).filter(|target| **target < number) {
        number = *target;
    }
    number
}

impl PartsPage {
    /// Whether an entry is of the part that is being measured.
    fn is_of_part(&self, entry: &Entry) -> bool {
        let part = self.walking.plan.as_ref().map_or("", |plan| plan.head.part.as_str());
        entry.about.serial == self.walking.serial() && (part.is_empty() || entry.about.part == part)
    }

    /// A plan without a name of its part was measured by what a file called it: a value of another one is of another part.
    fn see_label(&mut self, plan: &Plan, entry: &Entry) {
        if plan.head.part.is_empty() && !entry.about.part.is_empty() {
            self.walking.label.get_or_insert_with(|| entry.about.part.clone());
        }
    }
}

/// The value of an entry with the place of its size, or why it is none of a size of today; `None` where it is of no size at all.
fn value(sizes: &Sizes<'_>, number: u64, entry: &Entry, is_before: bool) -> Option<Result<(usize, Value), Away>> {
    let Checked::Size(record) = &entry.check()?.what else { return None };
    let name = &entry.about.feature;
    let place = sizes.place(name, record, is_before);
    let record = if record.id.is_empty() { record.called(name) } else { Arc::clone(record) };
    let value = Value {
        when: Some(record.time),
        record,
        id: None,
        number: Some(number),
        remarks: Vec::new(),
        is_settled: false,
    };
    Some(place.map(|at| (at, value)))
}

/// Sizes that the plan has no more are named once, all together.
fn tell_gone(gone: BTreeSet<String>, shared: &mut Shared) {
    if !gone.is_empty() {
        let details = gone.into_iter().map(|name| message!("walk-page-gone-name").text("name", name));
        shared.note(message!("walk-page-gone"), details.collect());
    }
}

impl PartsPage {
    /// Undo took checks back: they are no values of this part any more.
    pub(super) fn undone(&mut self, ids: &BTreeSet<RecordId>, numbers: &BTreeSet<u64>) {
        let is_undone = |value: &Value| {
            value.id.is_some_and(|id| ids.contains(&id)) || value.number.is_some_and(|number| numbers.contains(&number))
        };
        let at = self.walking.place_where(is_undone);
        if let Some(at) = at {
            self.walking.remove(is_undone);
            self.stay_open();
            if self.texts.text(WalkField::Value).trim().is_empty() {
                // What was undone is measured anew.
                self.walking.go(at);
            }
        }
    }

    /// A value of this part was corrected or withdrawn in the journal: it counts no more, and what stands in its place does.
    pub(super) fn taken_back(&mut self, number: u64, by: Option<&(u64, Entry)>, shared: &mut Shared) {
        let is_it = |value: &Value| {
            let of_check = value.id.and_then(|id| shared.recording.of_check(id));
            value.number == Some(number) || of_check == Some(Recorded::Kept(number))
        };
        // A value of a part before this one stays one, whatever is corrected of it.
        let is_here = self.walking.since < number || self.walking.has(is_it);
        let by = by.filter(|(_, entry)| is_here && self.is_of_part(entry));
        let plan = self.walking.plan.as_ref().map(Arc::clone);
        let new =
            by.zip(plan).and_then(|((number, entry), plan)| value(&Sizes::of(&plan), *number, entry, false)?.ok());
        let id = if new.is_some() { "walk-page-put-right" } else { "walk-page-taken-back" };
        if let Some(name) = self.walking.replace(is_it, new) {
            shared.note(Message::new(id).text("name", name), Vec::new());
            self.stay_open();
        }
    }
}
