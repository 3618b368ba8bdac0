//! Which rows are listed, in which order. Those of a fate or a class are counted at once; words and the order ask the
//! worker, which looks at every row again.

use std::sync::Arc;

use fitcheck_core::text::long;
use fitcheck_core::tolerance::Sources;
use fitcheck_exchange::exchange::batch::{ListedRows, MOST_SIFTED, Sifted, Sifting};
use fitcheck_exchange::journal::query::FilterWord;

use super::{End, Listed, Rows};
use crate::effect::Effect;
use fitcheck_core::message::Message;

impl Rows {
    /// How many rows are listed.
    pub fn listed(&self) -> usize {
        let sieved = || self.before.last().map_or(0, |listed| *listed);
        self.sifted.as_ref().map_or_else(sieved, |sifted| sifted.numbers.len())
    }

    /// Whether every row is listed.
    pub fn lists_all(&self) -> bool {
        self.filter.is_all() && self.sifting.words.is_empty() && !self.is_cut()
    }

    /// Whether there are more rows than a list in order holds.
    pub fn is_cut(&self) -> bool {
        self.sifted.as_ref().is_some_and(|sifted| long(sifted.numbers.len()) < sifted.count)
    }

    /// Whether rows are being found or put in order.
    pub const fn is_sifting(&self) -> bool {
        self.is_sifting
    }

    /// Whether words or an order wait for the end of the run.
    pub fn awaits_end(&self) -> bool {
        self.is_running() && self.sifting != Sifting::default()
    }

    /// Whether the worst row is first.
    pub const fn is_worst_first(&self) -> bool {
        self.sifting.is_worst_first
    }

    /// The row at a place of the list.
    pub fn at(&self, place: usize) -> Option<Listed<'_>> {
        let (part, in_part) = if let Some(sifted) = &self.sifted {
            let (_, part, in_part) = self.part_of(*sifted.numbers.get(place)?)?;
            (part, in_part)
        } else {
            let after = self.before.partition_point(|before| *before <= place);
            let at = after.checked_sub(1)?;
            let part = self.parts.get(at)?;
            (part, part.nth(place - self.before.get(at)?, &self.sieve)?)
        };
        let (fate, class) = part.row(in_part)?;
        let number = part.first + long(in_part);
        Some(Listed {
            number,
            fate,
            class: class.checked_sub(1).and_then(|class| self.classes.get(class)).copied(),
            read: self.read.get(&number),
            is_asked: self.asked.contains(&number),
        })
    }

    /// The place of a row in the list, if it is listed.
    fn place_of(&self, number: u64) -> Option<usize> {
        if let Some(sifted) = &self.sifted {
            return sifted.numbers.iter().position(|listed| *listed == number);
        }
        let (at, part, in_part) = self.part_of(number)?;
        let before = self.before.get(at)?;
        if self.filter.is_all() {
            return Some(before + in_part);
        }
        let found = part.listed(&self.sieve).take_while(|row| *row <= in_part);
        let (count, last) = found.fold((0, None), |(count, _), row| (count + 1, Some(row)));
        (last == Some(in_part)).then(|| before + count - 1)
    }

    /// Where to look: a number that goes up whenever a row has to come into sight, and its place.
    pub const fn look(&self) -> (u64, Option<usize>) {
        (self.look, self.place)
    }

    /// The cursor goes to a row, and that comes into sight.
    pub(super) fn put_cursor(&mut self, number: Option<u64>) {
        self.cursor = number;
        self.place = number.and_then(|number| self.place_of(number));
        self.look += 1;
    }

    /// Counts the listed rows before each part, without a look at any row; then asks for words and order.
    pub(super) fn list(&mut self, sources: &Arc<Sources>) -> Vec<Effect> {
        let mut sum = 0;
        self.sieve = self.filter.sieve(self.classes.len());
        let sieve = &self.sieve;
        let sums = self.parts.iter().map(|part| {
            sum += part.count(sieve);
            sum
        });
        self.before = [0].into_iter().chain(sums).collect();
        let effects = self.sift(sources);
        self.put_cursor(self.cursor);
        effects
    }

    /// Asks for words and order, where something is asked and the run has ended.
    pub(super) fn sift(&mut self, sources: &Arc<Sources>) -> Vec<Effect> {
        self.question += 1;
        self.is_sifting = false;
        self.unsifted = None;
        if self.sifting == Sifting::default() || self.is_running() {
            self.sifted = None;
            return Vec::new();
        }
        let Some(rows) = self.sieved(sources) else { return Vec::new() };
        self.is_sifting = true;
        let sifting = self.sifting.clone();
        vec![Effect::SiftRows { run: self.run, number: self.question, rows: Box::new(rows), sifting }]
    }

    /// Lists rows that have these words.
    pub(crate) fn find(&mut self, words: Vec<FilterWord>, sources: &Arc<Sources>) -> Vec<Effect> {
        if words == self.sifting.words {
            return Vec::new();
        }
        self.sifting.words = words;
        self.list(sources)
    }

    /// Puts the worst row first, or leaves the rows in the order of the file.
    pub(crate) fn put_worst_first(&mut self, is_worst_first: bool, sources: &Arc<Sources>) -> Vec<Effect> {
        self.sifting.is_worst_first = is_worst_first;
        if is_worst_first {
            // The worst one is looked for, not the one that was.
            self.cursor = None;
        }
        self.list(sources)
    }

    /// Takes the answer to a question, unless another one was asked since.
    pub(crate) fn take_sifted(&mut self, run: u64, number: u64, result: Result<Sifted, Message>) {
        if run != self.run || number != self.question {
            return;
        }
        self.is_sifting = false;
        match result {
            Ok(sifted) => self.sifted = Some(sifted),
            Err(problem) => self.unsifted = Some(problem),
        }
        let first = self.at(0).map(|row| row.number).filter(|_| self.sifting.is_worst_first);
        self.put_cursor(self.cursor.or(first));
    }

    /// The rows that the filter takes, in the order of the file; `None` before they can be read again.
    fn sieved(&self, sources: &Arc<Sources>) -> Option<ListedRows> {
        Some(ListedRows {
            layout: Arc::clone(self.layout.as_ref()?),
            sources: Arc::clone(sources),
            parts: self.parts.clone(),
            stream: Arc::clone(self.stream.as_ref()?),
            sieve: self.sieve.clone(),
            order: None,
        })
    }

    /// The rows as they are listed; `None` where the list is not ready.
    pub(super) fn listed_rows(&self, sources: &Arc<Sources>) -> Option<ListedRows> {
        if self.is_running() || self.is_sifting {
            return None;
        }
        let order = self.sifted.as_ref().map(|sifted| Arc::clone(&sifted.numbers));
        Some(ListedRows { order, ..self.sieved(sources)? })
    }

    /// Whether the listed rows can be written.
    pub fn can_be_written(&self) -> bool {
        !self.is_running() && !self.is_sifting && self.stream.is_some() && 0 < self.listed()
    }

    /// The worst row so far.
    pub fn worst(&self) -> Option<u64> {
        self.worst.map(|(_, number)| number)
    }

    /// How many rows are listed at most in another order than that of the file.
    pub const MOST: usize = MOST_SIFTED;

    /// Whether all rows were judged.
    pub fn is_whole(&self) -> bool {
        self.end.as_ref().is_some_and(|end| *end == End::Done)
    }
}
