//! All checks of the session, which of them are chosen for a report, and how to undo a change.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::journal::Record;

/// How many steps back undo remembers.
const UNDO_STEPS: usize = 50;

/// The checks.
#[derive(Debug, Default)]
pub(super) struct History {
    now: Snapshot,
    undo: Vec<Snapshot>,
}

/// The state that undo returns to.
#[derive(Debug, Clone, Default)]
struct Snapshot {
    records: Vec<Arc<Record>>,
    chosen: BTreeSet<usize>,
}

impl History {
    /// All checks, oldest first.
    pub fn records(&self) -> &[Arc<Record>] {
        &self.now.records
    }

    pub fn is_chosen(&self, number: usize) -> bool {
        self.now.chosen.contains(&number)
    }

    pub fn chosen_count(&self) -> usize {
        self.now.chosen.len()
    }

    /// The chosen checks, or all of them where none is chosen.
    pub fn for_report(&self) -> impl Iterator<Item = &Arc<Record>> {
        let chosen = &self.now.chosen;
        let all = self.now.records.iter().enumerate();
        all.filter(|(number, _)| chosen.is_empty() || chosen.contains(number)).map(|(_, record)| record)
    }

    pub const fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    pub fn add(&mut self, records: Vec<Arc<Record>>) {
        self.remember();
        self.now.records.extend(records);
    }

    pub fn choose(&mut self, number: usize, is_chosen: bool) {
        if is_chosen && number < self.now.records.len() {
            self.now.chosen.insert(number);
        } else {
            self.now.chosen.remove(&number);
        }
    }

    /// Empties it. `false` where it is empty already.
    pub fn clear(&mut self) -> bool {
        if self.now.records.is_empty() {
            return false;
        }
        self.remember();
        self.now = Snapshot::default();
        true
    }

    /// Undoes the last change. `false` where there is none.
    pub fn take_back(&mut self) -> bool {
        let Some(before) = self.undo.pop() else { return false };
        self.now = before;
        true
    }

    fn remember(&mut self) {
        if UNDO_STEPS <= self.undo.len() {
            self.undo.remove(0);
        }
        self.undo.push(self.now.clone());
    }
}
