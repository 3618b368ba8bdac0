//! The rows of a file that is too large for the history: judged by the workers of `batch`, counted, filtered and walked
//! by what is kept of each (its verdict and class), and read again from the file where they are in sight.
//!
//! | file | what |
//! |---|---|
//! | here | the rows, which of them are listed, the row at which the keys are |
//! | `command` | what can be done, and what the worker says |
//! | `apply` | doing it |
//! | `listing` | which rows are listed, in which order |
//! | `reporting` | the listed rows as a report or as the rows of a file |

mod apply;
mod command;
mod listing;
mod reporting;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::ToleranceClass;
use fitcheck_exchange::exchange::Labels;
use fitcheck_exchange::exchange::batch::{
    FATES, Filter, Layout, Part, Picked, Rank, RowFate, Sieve, Sifted, Sifting, StreamBytes, Tally,
};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::Hash;

pub use command::{End, Large, News, RowsCommand};
pub use reporting::{RowsText, row_forms};

/// From how many bytes on a file of measurements is judged row by row: 1 MiB, about 40 000 rows. An import of that many
/// takes 35 MB and holds the frame for a tenth of a second while its records go to the history; one of 4 MiB holds it for
/// four.
pub const LARGE: u64 = 1 << 20;

/// The rows of a large file.
#[derive(Debug)]
pub struct Rows {
    run: u64,
    /// The file's name without its folder.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// Why it is judged row by row.
    pub large: Large,
    /// What its rows are, once that is known.
    pub layout: Option<Arc<Layout>>,
    /// Where they are read again, once that is known.
    stream: Option<Arc<dyn StreamBytes>>,
    parts: Vec<Arc<Part>>,
    /// How many listed rows come before each part, and how many there are.
    before: Vec<usize>,
    classes: Vec<ToleranceClass>,
    /// How many rows of each class have each fate; the first one has no class.
    counts: Vec<[u64; FATES]>,
    /// What is said of the rows so far.
    pub tally: Tally,
    /// How many bytes of the file were read, and how many it has where that is known.
    pub bytes: (u64, Option<u64>),
    /// For how long it was judged, in milliseconds.
    pub elapsed_ms: u64,
    /// How it has ended, if it has.
    pub end: Option<End>,
    /// SHA-256 of the file, once it was read to its end.
    pub sha256: Option<Hash>,
    /// Which rows are listed.
    pub filter: Filter,
    /// The same for the classes so far.
    sieve: Sieve,
    /// What is asked of the listed rows besides.
    sifting: Sifting,
    /// The number of the last question of that kind.
    question: u64,
    /// Whether its answer is awaited.
    is_sifting: bool,
    /// Its answer.
    sifted: Option<Sifted>,
    /// Why there is none.
    pub unsifted: Option<Message>,
    /// The rank and the number of the worst row so far.
    worst: Option<(Rank, u64)>,
    /// The row at which the keys are.
    pub cursor: Option<u64>,
    /// Its place in the list, if it is listed.
    place: Option<usize>,
    /// Goes up whenever the cursor has to come into sight.
    look: u64,
    /// The rows that were read again, by their numbers.
    read: BTreeMap<u64, Arc<Picked>>,
    /// Those that are being read.
    asked: BTreeSet<u64>,
    /// Why rows cannot be read again.
    pub unread: Option<Message>,
    /// The row whose check is to be shown as soon as it is read.
    wanted: Option<u64>,
    /// The row whose check is shown.
    pub shown: Option<ShownRow>,
}

/// The row whose check is shown.
#[derive(Debug, Clone)]
pub struct ShownRow {
    /// Its number among all rows, from 0.
    pub number: u64,
    /// Its line in the file, from 1.
    pub line: usize,
    /// The cells with the names of their columns; one that has no column has its number.
    pub cells: Vec<(String, String)>,
    /// Its check; `None` where it has no verdict.
    pub record: Option<Arc<Record>>,
    /// What the file says of it besides.
    pub labels: Option<Labels>,
    /// Why it has none.
    pub why: Option<Message>,
}

#[derive(Debug, Clone, Copy)]
pub struct Listed<'a> {
    /// Its number among all rows, from 0.
    pub number: u64,
    /// What became of it.
    pub fate: RowFate,
    /// Its class, if its callout has one.
    pub class: Option<ToleranceClass>,
    /// The row itself, once it is read again.
    pub read: Option<&'a Arc<Picked>>,
    /// Whether it is being read.
    pub is_asked: bool,
}

impl Rows {
    fn new(run: u64, name: String, path: PathBuf, large: Large) -> Self {
        Self {
            run,
            name,
            path,
            large,
            layout: None,
            stream: None,
            parts: Vec::new(),
            before: vec![0],
            classes: Vec::new(),
            counts: vec![[0; FATES]],
            tally: Tally::default(),
            bytes: (0, None),
            elapsed_ms: 0,
            end: None,
            sha256: None,
            filter: Filter::default(),
            sieve: Filter::default().sieve(0),
            sifting: Sifting::default(),
            question: 0,
            is_sifting: false,
            sifted: None,
            unsifted: None,
            worst: None,
            cursor: None,
            place: None,
            look: 0,
            read: BTreeMap::new(),
            asked: BTreeSet::new(),
            unread: None,
            wanted: None,
            shown: None,
        }
    }

    /// Whether rows are being judged.
    pub const fn is_running(&self) -> bool {
        self.end.is_none()
    }

    /// How many rows there are so far.
    pub fn count(&self) -> u64 {
        self.fates().iter().map(|(_, count)| count).sum()
    }

    /// How many rows have each fate so far.
    pub fn fates(&self) -> [(RowFate, u64); FATES] {
        let mut all = [0; FATES];
        for counts in &self.counts {
            all.iter_mut().zip(counts).for_each(|(all, count)| *all += count);
        }
        let mut fates = RowFate::ALL.into_iter().zip(all);
        std::array::from_fn(|_| fates.next().unwrap_or((RowFate::NotJudged, 0)))
    }

    /// The classes that occur so far, each with its number for the filter and its counts in the order of [`RowFate::ALL`];
    /// rows without a class come last.
    pub fn classes(&self) -> impl Iterator<Item = (usize, Option<ToleranceClass>, &[u64; FATES])> {
        let named = self.classes.iter().copied().map(Some).zip(1..);
        let all = named.chain([(None, 0)]);
        all.filter_map(|(class, number)| Some((number, class, self.counts.get(number)?)))
            .filter(|(_, _, counts)| counts.iter().any(|count| 0 < *count))
    }

    /// How many rows were judged in a second; `None` before that can be said.
    pub fn rate(&self) -> Option<u64> {
        (self.count() * 1000).checked_div(self.elapsed_ms)
    }

    /// The part of a row, its place among the parts, and the row's number in it.
    fn part_of(&self, number: u64) -> Option<(usize, &Arc<Part>, usize)> {
        // Parts without rows have the number of the next one.
        let at = self.parts.partition_point(|part| part.first <= number).checked_sub(1)?;
        let part = self.parts.get(at)?;
        let in_part = usize::try_from(number - part.first).ok().filter(|row| *row < part.len())?;
        Some((at, part, in_part))
    }

    /// Nothing of it is shown any more.
    pub(super) fn hide(&mut self) {
        self.shown = None;
        self.wanted = None;
    }
}
