//! Which records are listed, and those of them that were read. A row that is not there yet is asked for and never waited for.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::message::Message;

use super::RecordRow;

/// How many rows are read together.
pub const PAGE: usize = 200;

/// How many pages of rows are kept.
const MOST_PAGES: usize = 20;

/// The numbers of records, newest first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Numbers {
    /// Every number from the newest to the oldest: a chain has no gaps.
    All {
        /// The first one of the list.
        newest: u64,
        /// The last one.
        oldest: u64,
    },
    /// These, descending.
    These(Vec<u64>),
}

impl Default for Numbers {
    fn default() -> Self {
        Self::These(Vec::new())
    }
}

/// What a reader has found since it last said something.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FoundNumbers {
    /// The next numbers.
    pub numbers: Numbers,
    /// Whether these are the last.
    pub is_end: bool,
}

#[derive(Debug, Default)]
pub struct Listing {
    numbers: Numbers,
    /// Whether every number is known.
    pub is_whole: bool,
    /// Whether the answer to the newest question is still out: these rows belong to the one before.
    pub is_stale: bool,
    rows: BTreeMap<u64, Arc<RecordRow>>,
    /// What was read together, the latest used last.
    pages: VecDeque<Vec<u64>>,
    asked: BTreeSet<u64>,
    /// The first place that was in sight the last time.
    seen: usize,
    /// Why records cannot be read.
    pub unread: Option<Message>,
}

impl Listing {
    /// Another question was asked. The rows stay, greyed, until its answer comes.
    pub(super) fn ask(&mut self) {
        self.is_stale = true;
        self.is_whole = false;
        self.unread = None;
        self.asked.clear();
    }

    /// Takes an answer.
    pub(super) fn take(&mut self, found: FoundNumbers) {
        if std::mem::take(&mut self.is_stale) {
            self.numbers = Numbers::default();
            self.seen = 0;
            // Another program may have corrected what was read.
            self.rows.clear();
            self.pages.clear();
            self.asked.clear();
        }
        self.is_whole = found.is_end;
        match (&mut self.numbers, found.numbers) {
            (Numbers::These(known), Numbers::These(more)) => known.extend(more),
            (numbers, all) => *numbers = all,
        }
    }

    /// The question cannot be answered.
    pub(super) fn refuse(&mut self, problem: Message) {
        *self = Self { unread: Some(problem), is_whole: true, ..Self::default() };
    }

    /// Records were corrected or added: what was read of them may be old.
    pub(super) fn forget(&mut self, number: u64) {
        self.rows.remove(&number);
        self.asked.remove(&number);
    }

    /// How many records are listed, as far as that is known.
    pub fn count(&self) -> usize {
        match &self.numbers {
            Numbers::All { newest, oldest } => {
                usize::try_from((newest.saturating_add(1)).saturating_sub(*oldest)).unwrap_or(usize::MAX)
            }
            Numbers::These(numbers) => numbers.len(),
        }
    }

    /// The number of the record at a place.
    pub fn at(&self, place: usize) -> Option<u64> {
        match &self.numbers {
            Numbers::All { newest, oldest } => {
                let number = newest.checked_sub(u64::try_from(place).ok()?)?;
                (*oldest <= number).then_some(number)
            }
            Numbers::These(numbers) => numbers.get(place).copied(),
        }
    }

    /// The place of a record; `None` where it is not listed.
    pub fn place_of(&self, number: u64) -> Option<usize> {
        match &self.numbers {
            Numbers::All { newest, oldest } => {
                let place = newest.checked_sub(number).filter(|_| *oldest <= number)?;
                usize::try_from(place).ok()
            }
            Numbers::These(numbers) => numbers.binary_search_by(|known| number.cmp(known)).ok(),
        }
    }

    /// A record that was read.
    pub fn row(&self, number: u64) -> Option<&Arc<RecordRow>> {
        self.rows.get(&number)
    }

    /// Whether rows at these places have to be asked for.
    pub fn lacks(&self, places: &Range<usize>) -> bool {
        let is_missing = |number: u64| !self.rows.contains_key(&number) && !self.asked.contains(&number);
        self.unread.is_none() && places.clone().filter_map(|place| self.at(place)).any(is_missing)
    }

    /// The pages to read because these places are in sight, and the next one in the direction of scrolling.
    pub(super) fn see(&mut self, places: &Range<usize>) -> Vec<Vec<u64>> {
        let first = places.start / PAGE;
        let last = places.end.saturating_sub(1) / PAGE;
        let ahead = if places.start < self.seen { first.checked_sub(1) } else { last.checked_add(1) };
        self.seen = places.start;
        let pages = (first..=last).take(MOST_PAGES / 2).chain(ahead);
        pages.filter_map(|page| self.want(page)).collect()
    }

    /// The numbers of a page that were not read yet; `None` where all of them were.
    fn want(&mut self, page: usize) -> Option<Vec<u64>> {
        let start = page.saturating_mul(PAGE);
        let numbers: Vec<u64> = (start..start.saturating_add(PAGE)).map_while(|place| self.at(place)).collect();
        if let Some(used) = self.pages.iter().position(|page| page.first() == numbers.first())
            && let Some(page) = self.pages.remove(used)
        {
            self.pages.push_back(page);
        }
        let is_missing = |number: &u64| !self.rows.contains_key(number) && !self.asked.contains(number);
        let missing: Vec<u64> = numbers.into_iter().filter(is_missing).collect();
        self.asked.extend(&missing);
        (!missing.is_empty() && self.unread.is_none()).then_some(missing)
    }

    /// Takes rows that were read; those that were not used for the longest time go.
    pub(super) fn take_rows(&mut self, numbers: Vec<u64>, result: Result<Vec<Arc<RecordRow>>, Message>) {
        for number in &numbers {
            self.asked.remove(number);
        }
        match result {
            Ok(rows) => {
                self.rows.extend(rows.into_iter().map(|row| (row.head.number, row)));
                self.pages.push_back(numbers);
            }
            Err(problem) => self.unread = Some(problem),
        }
        while MOST_PAGES < self.pages.len()
            && let Some(oldest) = self.pages.pop_front()
        {
            for number in oldest {
                self.rows.remove(&number);
            }
        }
    }

    /// How many rows are in memory.
    pub fn read(&self) -> usize {
        self.rows.len()
    }
}
