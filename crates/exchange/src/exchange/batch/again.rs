//! The listed rows of a stream once more: which of them have some words, the worst first, and each with its cells. They
//! are read again from the stream, so that nothing of them has to be kept.

use std::cmp::Reverse;
use std::fmt::Debug;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use fitcheck_core::length::Length;
use fitcheck_core::text::long;
use fitcheck_core::tolerance::Sources;

use super::court::StreamJudging;
use super::cut::Block;
use super::judge::Take;
use super::judged::{Judged, Rank};
use super::layout::Layout;
use super::marks::{Part, RowFate, Sieve};
use super::pick::{Picked, pick};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::row::{TextRow, unquoted};
use crate::journal::query::{FilterWord, folded};

/// The most rows that are put in order: a list of more holds the first or the worst of them.
pub const MOST_SIFTED: usize = 1_000_000;

/// How many rows are read again at a time.
const AT_A_TIME: usize = 1 << 16;

/// Where the bytes of parts are read again.
pub trait StreamBytes: Debug + Send + Sync {
    /// The bytes of a part.
    ///
    /// # Errors
    /// Those of the stream; [`io::ErrorKind::InvalidData`] where they are not those that were judged.
    fn bytes(&self, part: &Part) -> io::Result<Vec<u8>>;
}

/// A part with the numbers of some of its rows, ascending.
pub(crate) type PartRows<'a> = (&'a Arc<Part>, Vec<usize>);

/// Sees the numbers of a portion of rows in their order, and the parts that have them.
type SeePortion<'s, 'a> = dyn FnMut(&[u64], &[PartRows<'a>]) -> io::Result<()> + 's;

/// Rows of a stream that are listed, in their order.
#[derive(Debug, Clone)]
pub struct ListedRows {
    pub layout: Arc<Layout>,
    pub sources: Arc<Sources>,
    pub parts: Vec<Arc<Part>>,
    pub stream: Arc<dyn StreamBytes>,
    /// Which rows are taken.
    pub sieve: Sieve,
    /// The numbers of the rows in another order than that of the stream, or of fewer rows.
    pub order: Option<Arc<[u64]>>,
}

/// The same rows of the same run.
impl PartialEq for ListedRows {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.layout, &other.layout) && self.parts == other.parts && self.order == other.order
    }
}

/// What is asked of rows besides their sieve.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Sifting {
    /// Words that a row has to have, all of them.
    pub words: Vec<FilterWord>,
    /// Whether the worst row is first; otherwise they stay in the order of the stream.
    pub is_worst_first: bool,
}

/// The rows that were found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sifted {
    /// Their numbers among all rows, in order.
    pub numbers: Arc<[u64]>,
    /// How many there are: more than numbers where there are very many.
    pub count: u64,
    /// How many of the numbers have no verdict.
    pub unjudged: usize,
}

const NO_VERDICT: Rank = (Reverse(None), Length::ZERO);

impl ListedRows {
    /// The numbers of the rows among all, in order.
    pub fn numbers(&self) -> Box<dyn Iterator<Item = u64> + '_> {
        match &self.order {
            Some(order) => Box::new(order.iter().copied()),
            None => {
                Box::new(self.parts.iter().flat_map(|part| part.listed(&self.sieve).map(|row| part.first + long(row))))
            }
        }
    }

    /// What the rows are judged by.
    pub fn court(&self) -> StreamJudging<'_> {
        StreamJudging::new(&self.layout, &self.sources)
    }

    /// Finds rows among those that the sieve takes; `None` where it was stopped.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn sift(&self, sifting: &Sifting, stop: &AtomicBool) -> io::Result<Option<Sifted>> {
        let court = self.court();
        let mut judge = court.judge();
        let mut found = Found { sifting, rows: Vec::new(), count: 0 };
        for part in self.parts.iter().filter(|part| 0 < part.count(&self.sieve)) {
            if stop.load(Relaxed) {
                return Ok(None);
            }
            let block = Block::again(self.stream.bytes(part)?, self.layout.separator, part.broken);
            let tolerance = self.layout.columns.tolerance;
            let mut sifter = Sifter {
                part,
                sieve: &self.sieve,
                tolerance,
                at: 0,
                differs: false,
                text: String::new(),
                found: &mut found,
            };
            judge.block(&block, &mut sifter);
            if sifter.differs || sifter.at != part.len() {
                return Err(io::ErrorKind::InvalidData.into());
            }
        }
        Ok(Some(found.sifted()))
    }

    /// Shows some rows at a time: each part that has some of them with their numbers in it, ascending. In the order of
    /// the stream.
    pub(crate) fn each_portion<'a>(&'a self, see: &mut SeePortion<'_, 'a>) -> io::Result<()> {
        let mut numbers = self.numbers();
        loop {
            let portion: Vec<u64> = numbers.by_ref().take(AT_A_TIME).collect();
            if portion.is_empty() {
                return Ok(());
            }
            let mut sorted = portion.clone();
            sorted.sort_unstable();
            let mut parts: Vec<PartRows<'_>> = Vec::new();
            let mut rest = sorted.as_slice();
            for part in &self.parts {
                let (of_part, behind) =
                    rest.split_at(rest.partition_point(|number| *number < part.first + long(part.len())));
                rest = behind;
                let rows: Vec<usize> =
                    of_part.iter().filter_map(|number| usize::try_from(number.checked_sub(part.first)?).ok()).collect();
                if !rows.is_empty() {
                    parts.push((part, rows));
                }
            }
            see(&portion, &parts)?;
        }
    }

    /// Shows every row with its cells, in order.
    ///
    /// # Errors
    /// Those of the stream and of what it was shown to.
    pub fn each(&self, see: &mut dyn FnMut(&Picked) -> io::Result<()>) -> io::Result<()> {
        let court = self.court();
        self.each_portion(&mut |numbers, parts| {
            let mut all = Vec::new();
            for (part, rows) in parts {
                let picked = pick(self.stream.bytes(part)?, part, rows, &court);
                let picked = picked.ok_or(io::ErrorKind::InvalidData)?;
                all.extend(picked.into_iter().map(|row| (part.first + long(row.number), row)));
            }
            for number in numbers {
                let at = all.binary_search_by_key(number, |(number, _)| *number).ok();
                if let Some((_, row)) = at.and_then(|at| all.get(at)) {
                    see(row)?;
                }
            }
            Ok(())
        })
    }
}

/// The rows that were found so far.
struct Found<'a> {
    sifting: &'a Sifting,
    rows: Vec<(Rank, u64)>,
    count: u64,
}

impl Found<'_> {
    fn keep(&mut self, rank: Rank, number: u64) {
        self.count += 1;
        if self.sifting.is_worst_first {
            self.rows.push((rank, number));
            if 2 * MOST_SIFTED <= self.rows.len() {
                self.worst();
            }
        } else if self.rows.len() < MOST_SIFTED {
            self.rows.push((rank, number));
        }
    }

    /// Forgets the best rows, where there are too many.
    fn worst(&mut self) {
        if MOST_SIFTED < self.rows.len() {
            self.rows.select_nth_unstable(MOST_SIFTED);
            self.rows.truncate(MOST_SIFTED);
        }
    }

    fn sifted(mut self) -> Sifted {
        if self.sifting.is_worst_first {
            self.worst();
            self.rows.sort_unstable();
        }
        let unjudged = self.rows.iter().filter(|(rank, _)| *rank == NO_VERDICT).count();
        Sifted { numbers: self.rows.iter().map(|(_, number)| *number).collect(), count: self.count, unjudged }
    }
}

/// Looks at every row of a part.
struct Sifter<'a, 'f> {
    part: &'a Part,
    sieve: &'a Sieve,
    /// The column of callouts: in it a capital letter means a hole.
    tolerance: Option<usize>,
    /// The number of the next row.
    at: usize,
    /// Whether a row has another verdict than before.
    differs: bool,
    /// The cells of a row.
    text: String,
    found: &'f mut Found<'a>,
}

impl Sifter<'_, '_> {
    fn row(&mut self, fate: RowFate, rank: impl FnOnce() -> Rank, row: Option<&TextRow<'_>>, line: &str) {
        let number = self.at;
        self.at += 1;
        self.differs |= self.part.row(number).is_none_or(|(before, _)| before != fate);
        if !self.part.is_listed(number, self.sieve) {
            return;
        }
        if self.found.sifting.words.is_empty() || self.has_words(fate, row, line) {
            self.found.keep(rank(), self.part.first + long(number));
        }
    }

    fn has_words(&mut self, fate: RowFate, row: Option<&TextRow<'_>>, line: &str) -> bool {
        self.text.clear();
        let mut callout = String::new();
        match row {
            Some(row) => {
                for (at, cell) in row.cells().enumerate() {
                    let cell = unquoted(cell);
                    if self.tolerance == Some(at) {
                        callout.push_str(&cell);
                    } else {
                        self.text.push('\n');
                        self.text.push_str(&cell);
                    }
                }
            }
            None => self.text.push_str(line),
        }
        let text = folded(&self.text);
        let has = |word: &FilterWord| {
            let is_status = fate.status().is_some_and(|status| word.statuses.contains(&status));
            is_status || word.is_in_folded(&text) || word.is_in_callout(&callout)
        };
        self.found.sifting.words.iter().all(has)
    }
}

impl Take for Sifter<'_, '_> {
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        self.row(RowFate::Judged(judged.status), || judged.rank(), Some(row), "");
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        // A row of empty cells is none.
        if !reason.is_empty() {
            self.row(RowFate::NotJudged, || NO_VERDICT, Some(row), "");
        }
    }

    fn broken(&mut self, line: &str, _reason: &ImportErrorKind) {
        self.row(RowFate::NotJudged, || NO_VERDICT, None, line);
    }

    fn line(&mut self, _line: &[u8]) {}
}
