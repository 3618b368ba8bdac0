//! How commands and the worker's news change the rows of a large file. What belongs to the check page, such as the check
//! that is shown, is in `check::rows`.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _};
use fitcheck_core::text::long;
use fitcheck_core::tolerance::Sources;
use fitcheck_exchange::exchange::batch::{FATES, Part, Picked, RowFate};
use jiff::civil::DateTime;

use super::{End, Large, News, Rows, ShownRow};
use crate::Step;
use crate::effect::Effect;

/// How many rows beyond those in sight are read with them.
const AROUND: usize = 20;

/// How many places are in sight at most.
const MOST_SEEN: usize = 400;

/// How many rows are kept that were read again.
const MOST_READ: usize = 1_000;

impl Rows {
    /// A file that is judged from its beginning, and the effects of that.
    pub(crate) fn begin(run: u64, name: String, path: PathBuf, large: Large) -> (Self, Vec<Effect>) {
        let effects = vec![Effect::StopRows, Effect::JudgeRows { run, path: path.clone() }];
        (Self::new(run, name, path, large), effects)
    }

    /// The same file from its beginning; the filter stays.
    pub(crate) fn again(&self, run: u64) -> (Self, Vec<Effect>) {
        let (mut rows, effects) = Self::begin(run, self.name.clone(), self.path.clone(), self.large);
        rows.filter.fates.clone_from(&self.filter.fates);
        rows.sifting.clone_from(&self.sifting);
        rows.look = self.look + 1;
        (rows, effects)
    }

    /// Takes what the worker says.
    pub(crate) fn judged(&mut self, run: u64, news: News, sources: &Arc<Sources>) -> Vec<Effect> {
        if run != self.run || self.end.is_some() {
            return Vec::new();
        }
        self.layout = news.layout.or_else(|| self.layout.take());
        self.stream = news.stream.or_else(|| self.stream.take());
        self.classes = news.classes;
        self.tally = news.tally;
        self.bytes = news.bytes;
        self.elapsed_ms = news.elapsed_ms;
        self.end = news.end;
        self.sha256 = news.sha256;
        self.counts.resize(self.classes.len() + 1, [0; FATES]);
        self.sieve = self.filter.sieve(self.classes.len());
        for part in news.parts {
            for (class, counts) in part.by_class() {
                let known = self.counts.get_mut(*class).into_iter();
                let pairs = known.flat_map(|known| known.iter_mut().zip(counts));
                pairs.for_each(|(known, count)| *known += u64::from(*count));
            }
            if let Some((rank, row)) = part.worst()
                && self.worst.is_none_or(|(worst, _)| rank < worst)
            {
                self.worst = Some((rank, part.first + long(row)));
            }
            self.before.push(self.listed() + part.count(&self.sieve));
            self.parts.push(part);
        }
        if self.is_running() { Vec::new() } else { self.sift(sources) }
    }

    /// Ends the run at once, also where its worker waits for a disk: what it says later is not heard.
    pub(crate) fn cancel(&mut self, sources: &Arc<Sources>) -> Vec<Effect> {
        if !self.is_running() {
            return Vec::new();
        }
        self.end = Some(End::Cancelled);
        let mut effects = vec![Effect::StopRows];
        effects.extend(self.sift(sources));
        effects
    }

    /// Lists rows of a fate, or no longer.
    pub(crate) fn toggle_fate(&mut self, fate: RowFate, sources: &Arc<Sources>) -> Vec<Effect> {
        if !self.filter.fates.remove(&fate) {
            self.filter.fates.insert(fate);
        }
        self.list(sources)
    }

    /// Lists rows of a class, or no longer; `None` lists those of all.
    pub(crate) fn toggle_class(&mut self, class: Option<usize>, sources: &Arc<Sources>) -> Vec<Effect> {
        match class {
            Some(class) if !self.filter.classes.remove(&class) => {
                self.filter.classes.insert(class);
            }
            Some(_) => {}
            None => self.filter.classes.clear(),
        }
        self.list(sources)
    }

    /// Asks for the rows in sight and around them that were not read yet.
    pub(crate) fn see(&mut self, places: &Range<usize>) -> Vec<Effect> {
        let end = places.end.min(places.start + MOST_SEEN);
        let near = places.start.saturating_sub(AROUND)..(end + AROUND).min(self.listed());
        let numbers: Vec<u64> = near.filter_map(|place| self.at(place)).map(|row| row.number).collect();
        if MOST_READ < self.read.len() {
            self.read.retain(|number, _| numbers.contains(number));
        }
        self.ask_for(&numbers)
    }

    fn ask_for(&mut self, numbers: &[u64]) -> Vec<Effect> {
        if self.unread.is_some() {
            return Vec::new();
        }
        let mut wanted: Vec<(Arc<Part>, Vec<usize>)> = Vec::new();
        for number in numbers {
            if self.read.contains_key(number) || self.asked.contains(number) {
                continue;
            }
            let Some((_, part, in_part)) = self.part_of(*number) else { continue };
            match wanted.last_mut() {
                Some((last, rows)) if Arc::ptr_eq(last, part) => rows.push(in_part),
                _ => wanted.push((Arc::clone(part), vec![in_part])),
            }
            self.asked.insert(*number);
        }
        let run = self.run;
        (!wanted.is_empty()).then_some(Effect::ReadRows { run, wanted }).into_iter().collect()
    }

    /// Takes rows that were read again; returns the one whose check is to be shown.
    pub(crate) fn take_read(&mut self, run: u64, result: Result<Vec<(u64, Arc<Picked>)>, Message>) -> Option<u64> {
        if run != self.run {
            return None;
        }
        match result {
            Ok(rows) => {
                for (number, _) in &rows {
                    self.asked.remove(number);
                }
                self.read.extend(rows);
            }
            Err(problem) => {
                self.asked.clear();
                self.unread = Some(problem);
            }
        }
        self.wanted.take_if(|number| self.read.contains_key(number))
    }

    /// Moves the cursor. One that is not in the list counts as before its first row.
    pub(crate) fn step(&mut self, step: Step) {
        let Some(last) = self.listed().checked_sub(1) else { return };
        let place = step.place(self.place, last);
        self.cursor = self.at(place).map(|row| row.number);
        self.place = self.cursor.map(|_| place);
        self.look += 1;
    }

    /// Goes to a row. Where it was not read yet, it is shown once it is.
    pub(crate) fn go_to(&mut self, number: u64) -> Vec<Effect> {
        self.put_cursor(Some(number));
        if self.read.contains_key(&number) {
            return Vec::new();
        }
        self.wanted = Some(number);
        self.ask_for(&[number])
    }

    /// What a row says, and its check as an import makes it; `None` where it was not read yet.
    pub(crate) fn row(&self, number: u64, sources: &Sources, now: DateTime) -> Option<ShownRow> {
        let picked = self.read.get(&number)?;
        let layout = self.layout.as_deref()?;
        let line = layout.line + picked.line;
        let is_split = picked.judged.is_some() || picked.cells.len() != 1 || layout.names.len() == 1;
        let cells = picked.cells.iter().enumerate().map(|(at, cell)| {
            let name = layout.names.get(at).filter(|_| is_split).cloned();
            (name.unwrap_or_else(|| (at + 1).to_string()), cell.clone())
        });
        let cells = cells.collect();
        let mut imported = picked.imported(layout, &self.name, sources, now);
        let record = imported.records.pop().filter(|_| picked.judged.is_some()).map(Arc::new);
        let mut warnings = imported.warnings.iter().map(|warning| warning.what.kind.message());
        let why = picked.why.clone().or_else(|| warnings.next_back());
        let labels = imported.labels.pop();
        Some(ShownRow { number, line, cells, record, labels, why })
    }

    pub(crate) fn show(&mut self, row: ShownRow) {
        self.shown = Some(row);
    }
}
