//! All checks of the session: which of them are listed and in which order, which are chosen for a report, and how to undo
//! a change.
//!
//! | file | what |
//! |---|---|
//! | here | the checks, the row of the list at which the keys are, undo |
//! | `command` | what can be done with the list, and doing it |
//! | `filter` | what the words of a filter mean in the user's language |
//! | `copy` | rows as a spreadsheet takes them |

mod command;
mod copy;
mod filter;

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::memory::{Memory, Removed};
use fitcheck_exchange::journal::query::{Query, RecordId, Records};

pub use command::ListCommand;
pub use copy::status_text;
pub(crate) use filter::filter_words;

/// How many steps back undo remembers.
const UNDO_STEPS: usize = 50;

/// The checks.
#[derive(Debug, Default)]
pub struct History {
    records: Memory,
    chosen: BTreeSet<RecordId>,
    /// How many of the chosen ones the list does not show.
    hidden: usize,
    /// The row of the list at which the keys are.
    pub cursor: Option<RecordId>,
    /// Goes up whenever the cursor has to come into sight.
    look: u64,
    undo: VecDeque<(ChangeId, Change)>,
    /// What stands in the place of checks that were corrected here.
    successors: BTreeMap<RecordId, RecordId>,
    /// Why rows of imported files are no checks, by the number that their first check has or would have.
    left_out: BTreeMap<RecordId, Vec<Message>>,
    /// Checks of which hole or shaft was said after they were judged.
    said: BTreeSet<RecordId>,
    /// How many changes there were.
    changes: u64,
}

/// The number of a change of the history: no two changes of a session have the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ChangeId(u64);

/// What undo takes back: only what was added or removed, never a copy of everything.
#[derive(Debug)]
enum Change {
    /// Records were added from this one on.
    Added { first: RecordId, count: usize },
    /// A record was corrected: another one stands in its place.
    Corrected { new: RecordId },
    /// Hole or shaft was said, and records were judged again by that.
    JudgedAgain { before: Vec<(RecordId, Arc<Record>)> },
    /// Records were removed; some of them were chosen.
    Cleared { removed: Removed, chosen: BTreeSet<RecordId>, cursor: Option<RecordId> },
}

impl Change {
    /// What it was, as undo names it.
    fn message(&self) -> Message {
        match self {
            Self::Added { count, .. } => message!("undo-add").count("count", *count),
            Self::Corrected { .. } => message!("undo-correct"),
            Self::JudgedAgain { .. } => message!("undo-feature"),
            Self::Cleared { .. } => message!("undo-clear"),
        }
    }
}

impl History {
    /// How many checks there are, listed or not.
    pub fn len(&self) -> usize {
        self.records.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// Every check that stands, oldest first.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &Arc<Record>> {
        self.records.standing().map(|(_, record)| record)
    }

    /// The record of the journal that stands in the place of a check, or takes it back.
    pub fn replaced_by(&self, id: RecordId) -> Option<u64> {
        self.records.replaced_by(id)
    }

    /// A check.
    pub fn get(&self, id: RecordId) -> Option<Arc<Record>> {
        self.records.get(id)
    }

    /// The checks that were made last, so many of them.
    pub(super) fn newest(&self, count: usize) -> Vec<Arc<Record>> {
        let end = self.next().0;
        let begin = end.saturating_sub(u64::try_from(count).unwrap_or(end));
        (begin..end).filter_map(|id| self.get(RecordId(id))).collect()
    }

    /// What the list shows: the answer to the filter, in the chosen order.
    pub const fn listed(&self) -> &dyn Records {
        &self.records
    }

    /// Whether a check is chosen for a report.
    pub fn is_chosen(&self, id: RecordId) -> bool {
        self.chosen.contains(&id)
    }

    /// How many checks are chosen.
    pub fn chosen_count(&self) -> usize {
        self.chosen.len()
    }

    /// How many of the chosen checks the list does not show.
    pub const fn hidden_count(&self) -> usize {
        self.hidden
    }

    /// Where to look: a number that goes up whenever a row has to come into sight, and its place.
    pub fn look(&self) -> (u64, Option<usize>) {
        (self.look, self.cursor.and_then(|id| self.records.place_of(id)))
    }

    /// The chosen checks, or those that are listed where none is chosen, oldest first.
    pub(super) fn for_report(&self) -> impl Iterator<Item = &Arc<Record>> {
        self.reported().map(|(_, record)| record)
    }

    /// The numbers of these in the history, in the same order.
    pub(super) fn ids_for_report(&self) -> impl Iterator<Item = RecordId> {
        self.reported().map(|(id, _)| id)
    }

    /// How many of the listed checks a report leaves out, because they were corrected or withdrawn; none of chosen ones is.
    pub(super) fn replaced_for_report(&self) -> usize {
        if !self.chosen.is_empty() {
            return 0;
        }
        self.records.count().saturating_sub(self.reported().count())
    }

    /// How many of these stand in the place of a check that was corrected.
    pub(super) fn corrections(&self, ids: impl Iterator<Item = RecordId>) -> usize {
        let all: BTreeSet<RecordId> = self.successors.values().copied().collect();
        ids.filter(|id| all.contains(id)).count()
    }

    fn reported(&self) -> impl Iterator<Item = (RecordId, &Arc<Record>)> {
        let listed: BTreeSet<RecordId> = if self.chosen.is_empty() {
            self.records.page(0..self.records.count()).into_iter().map(|(id, _)| id).collect()
        } else {
            self.chosen.clone()
        };
        self.records.standing().filter(move |(id, _)| listed.contains(id))
    }

    /// How many checks a report has.
    pub fn exported_count(&self) -> usize {
        if self.chosen.is_empty() { self.records.counts().into_iter().sum() } else { self.chosen.len() }
    }

    /// What undo would take back.
    pub fn undoes(&self) -> Option<Message> {
        self.undo.back().map(|(_, change)| change.message())
    }

    /// The change that undo would take back.
    pub fn last_change(&self) -> Option<ChangeId> {
        self.undo.back().map(|(id, _)| *id)
    }

    /// Puts checks of the journal before all others, the oldest first; undo knows nothing of them. Returns their numbers.
    pub(super) fn restore(&mut self, records: Vec<Arc<Record>>) -> Vec<RecordId> {
        let ids = self.records.put_before(records);
        self.count_hidden();
        ids
    }

    /// An entry of the journal corrects a check, or takes it back: the check stays in the list, struck through. What stands in its place is a
    /// check of its own, whose number comes back.
    pub(super) fn replace(&mut self, old: RecordId, by: u64, record: Option<Arc<Record>>) -> Option<RecordId> {
        self.records.replace(old, by);
        self.chosen.remove(&old);
        let new = record.map(|record| {
            let new = self.records.next();
            self.records.add(vec![record]);
            self.successors.insert(old, new);
            new
        });
        self.count_hidden();
        new
    }

    /// Undo takes a correction back.
    pub(super) fn can_undo_correction(&mut self, new: RecordId) {
        self.remember(Change::Corrected { new });
    }

    /// The correction that undo would take back: what stands in the place of the check before.
    pub(super) fn undoes_correction(&self) -> Option<RecordId> {
        match self.undo.back() {
            Some((_, Change::Corrected { new })) => Some(*new),
            _ => None,
        }
    }

    /// Rows of a file that is added next are no checks, and why.
    pub(super) fn leave_out(&mut self, why: Vec<Message>) {
        if !why.is_empty() {
            self.left_out.entry(self.records.next()).or_default().extend(why);
        }
    }

    /// Why rows of imported files are no checks of the list. Of chosen checks nobody says that they are all.
    pub(super) fn left_out(&self) -> impl Iterator<Item = &Message> {
        self.left_out.values().flatten().filter(|_| self.chosen.is_empty())
    }

    /// Puts records that were judged again in their places.
    pub(super) fn judge_again(&mut self, again: Vec<(RecordId, Arc<Record>)>) {
        let before = self.records.put(again);
        self.said.extend(before.iter().map(|(id, _)| *id));
        self.remember(Change::JudgedAgain { before });
    }

    /// Whether hole or shaft was said of a check after it was judged.
    pub fn is_said(&self, id: RecordId) -> bool {
        self.said.contains(&id)
    }

    /// The records as they were before hole or shaft was said, where undo would take that back.
    pub(super) fn undoes_judging(&self) -> Option<&[(RecordId, Arc<Record>)]> {
        match self.undo.back() {
            Some((_, Change::JudgedAgain { before })) => Some(before),
            _ => None,
        }
    }

    /// The numbers of the checks that undo would take away.
    pub(super) fn taken_by_undo(&self) -> BTreeSet<RecordId> {
        match self.undo.back() {
            Some((_, Change::Added { first, count })) => (first.0..).take(*count).map(RecordId).collect(),
            _ => BTreeSet::new(),
        }
    }

    /// What stands in the place of a check, or the check itself; `None` where it was taken back.
    pub(super) fn standing(&self, id: RecordId) -> Option<RecordId> {
        let mut standing = id;
        while let Some(new) = self.successors.get(&standing) {
            standing = *new;
        }
        self.replaced_by(standing).is_none().then_some(standing)
    }

    /// The numbers of all checks.
    pub(super) fn ids(&self) -> BTreeSet<RecordId> {
        self.records.ids().collect()
    }

    /// Leaves room before the first check for those of the journal.
    pub(super) fn leave_room(&mut self, count: u64) {
        self.records.leave_room(count);
    }

    /// The number that the next check will get.
    pub(super) const fn next(&self) -> RecordId {
        self.records.next()
    }

    /// Adds checks as one step; returns the number of the last one.
    pub(super) fn add(&mut self, records: Vec<Arc<Record>>) -> RecordId {
        let first = self.records.next();
        let count = records.len();
        self.remember(Change::Added { first, count });
        self.records.add(records);
        RecordId(self.records.next().0.saturating_sub(1))
    }

    pub(super) fn choose(&mut self, id: RecordId, is_chosen: bool) {
        if is_chosen && self.records.get(id).is_some() && self.replaced_by(id).is_none() {
            self.chosen.insert(id);
        } else {
            self.chosen.remove(&id);
        }
        self.count_hidden();
    }

    /// Asks for another list.
    fn ask(&mut self, query: Query) {
        self.records.ask(query);
        self.count_hidden();
        self.look += 1;
    }

    fn count_hidden(&mut self) {
        self.hidden = self.chosen.iter().filter(|id| self.records.place_of(**id).is_none()).count();
    }

    /// Puts the cursor on a check, which comes into sight.
    pub(super) const fn go_to(&mut self, id: RecordId) {
        self.cursor = Some(id);
        self.look += 1;
    }

    /// Empties it; returns how many checks it had.
    pub(super) fn clear(&mut self) -> usize {
        let removed = self.records.remove(RecordId::default()..self.records.next());
        let count = removed.len();
        self.left_out.clear();
        if 0 < count {
            let chosen = std::mem::take(&mut self.chosen);
            let cursor = self.cursor.take();
            self.hidden = 0;
            self.remember(Change::Cleared { removed, chosen, cursor });
        }
        count
    }

    /// Undoes the last change; returns what it was. `None` where there is none.
    pub(super) fn take_back(&mut self) -> Option<Message> {
        let (_, change) = self.undo.pop_back()?;
        let message = change.message();
        match change {
            Change::Added { first, count } => {
                let added = first..RecordId(first.0.saturating_add(fitcheck_core::text::long(count)));
                // With what corrected them, which comes later.
                let mut later = BTreeSet::new();
                for (old, new) in &self.successors {
                    if added.contains(old) || later.contains(old) {
                        later.insert(*new);
                    }
                }
                self.left_out.remove(&first);
                self.records.remove(added.clone());
                for id in &later {
                    self.records.remove(*id..RecordId(id.0.saturating_add(1)));
                }
                let is_left = |id: &RecordId| !added.contains(id) && !later.contains(id);
                self.chosen.retain(is_left);
                self.cursor = self.cursor.filter(is_left);
            }
            // The journal answers first.
            Change::Corrected { .. } => {}
            Change::JudgedAgain { before } => _ = self.records.put(before),
            Change::Cleared { removed, chosen, cursor } => {
                self.records.put_back(removed);
                self.chosen = chosen;
                self.cursor = cursor;
            }
        }
        self.count_hidden();
        self.look += 1;
        Some(message)
    }

    fn remember(&mut self, change: Change) {
        if UNDO_STEPS <= self.undo.len() {
            self.undo.pop_front();
        }
        self.changes += 1;
        self.undo.push_back((ChangeId(self.changes), change));
    }
}
