//! Which verdict and class each row has, in two bytes a row, and how many there are of each in every block: enough to
//! count, filter and walk millions of rows. What is in their cells is read again from the stream ([`super::pick`]).

use std::cmp::Reverse;
use std::collections::BTreeSet;

use fitcheck_core::tolerance::ToleranceClass;
use fitcheck_core::verdict::Status;

use super::cut::Block;
use super::judge::Take;
use super::judged::{Judged, Rank};
use super::tally::Tally;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::index::{Broken, wide};
use crate::exchange::row::TextRow;
use fitcheck_core::text::long;

/// How many fates there are.
pub const FATES: usize = Status::ALL.len() + 1;

/// What became of a row: a verdict, or none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RowFate {
    Judged(Status),
    /// It has no verdict: it was refused, or nothing says what it should be.
    NotJudged,
}

impl RowFate {
    /// Every fate: the verdicts, best first, then none.
    pub const ALL: [Self; FATES] = [
        Self::Judged(Status::Good),
        Self::Judged(Status::Rework),
        Self::Judged(Status::ReMeasure),
        Self::Judged(Status::OutOfLimits),
        Self::Judged(Status::Scrap),
        Self::NotJudged,
    ];

    /// The verdict, if there is one.
    pub const fn status(self) -> Option<Status> {
        match self {
            Self::Judged(status) => Some(status),
            Self::NotJudged => None,
        }
    }

    /// Its place in [`Self::ALL`].
    const fn number(self) -> u16 {
        match self {
            Self::Judged(Status::Good) => 0,
            Self::Judged(Status::Rework) => 1,
            Self::Judged(Status::ReMeasure) => 2,
            Self::Judged(Status::OutOfLimits) => 3,
            Self::Judged(Status::Scrap) => 4,
            Self::NotJudged => 5,
        }
    }
}

/// The fate in the lower three bits; above them 0, or the number of the class from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Mark(u16);

/// The most classes that are told apart; rows of others count as those without a class.
const MOST_CLASSES: usize = (1 << 13) - 2;

impl Mark {
    fn new(class: Option<usize>, fate: RowFate) -> Self {
        const NO_CLASS: u16 = 0;
        let class = class.filter(|number| *number < MOST_CLASSES).map_or(0, |number| number + 1);
        Self(u16::try_from(class << 3).unwrap_or(NO_CLASS) | fate.number())
    }

    const fn fate(self) -> RowFate {
        match self.0 & 7 {
            0 => RowFate::Judged(Status::Good),
            1 => RowFate::Judged(Status::Rework),
            2 => RowFate::Judged(Status::ReMeasure),
            3 => RowFate::Judged(Status::OutOfLimits),
            4 => RowFate::Judged(Status::Scrap),
            _ => RowFate::NotJudged,
        }
    }

    /// The class: 0 for none, else its number from 1.
    fn class(self) -> usize {
        usize::from(self.0 >> 3)
    }
}

/// The marks of a block while it is judged. One of these goes with one judge.
#[derive(Debug, Default)]
pub struct Marks {
    rows: Vec<Mark>,
    /// The worst row with a verdict.
    worst: Option<(Rank, usize)>,
    /// The number of the next row's class, as the judge has it.
    next: Option<usize>,
    /// The classes by the numbers of the judge.
    classes: Vec<Option<ToleranceClass>>,
}

impl Marks {
    /// Forgets the rows, for the next block.
    pub fn clear(&mut self) {
        self.rows.clear();
        self.worst = None;
    }

    #[cold]
    fn learn(&mut self, number: usize, class: ToleranceClass) {
        if self.classes.len() <= number {
            self.classes.resize(number + 1, None);
        }
        if let Some(known) = self.classes.get_mut(number) {
            *known = Some(class);
        }
    }
}

impl Take for Marks {
    #[inline]
    fn class(&mut self, class: Option<(usize, ToleranceClass)>) {
        self.next = class.map(|(number, _)| number);
        if let Some((number, class)) = class
            && self.classes.get(number).is_none_or(Option::is_none)
        {
            self.learn(number, class);
        }
    }

    #[inline]
    fn judged(&mut self, _row: &TextRow<'_>, judged: &Judged) {
        // Of most rows the word says enough.
        if self.worst.is_none_or(|((Reverse(status), _), _)| status <= Some(judged.status)) {
            let rank = judged.rank();
            if self.worst.is_none_or(|(worst, _)| rank < worst) {
                self.worst = Some((rank, self.rows.len()));
            }
        }
        self.rows.push(Mark::new(self.next, RowFate::Judged(judged.status)));
    }

    fn refused(&mut self, _row: &TextRow<'_>, reason: &str) {
        // A row of empty cells is none.
        if !reason.is_empty() {
            self.rows.push(Mark::new(None, RowFate::NotJudged));
        }
    }

    fn broken(&mut self, _line: &str, _reason: &ImportErrorKind) {
        self.rows.push(Mark::new(None, RowFate::NotJudged));
    }

    fn line(&mut self, _line: &[u8]) {}
}

/// The rows of a block: where it lies in the stream, and what became of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// Where it begins, in bytes from the stream's first row on.
    pub start: u64,
    /// How many bytes it has.
    pub bytes: usize,
    /// The number of its first row among all, from 0.
    pub first: u64,
    /// Its first line, from 0 at the stream's first row.
    pub line: usize,
    pub(super) broken: Option<Broken>,
    rows: Box<[Mark]>,
    /// How many rows of each class that occurs have each fate; class 0 is none.
    counts: Vec<(usize, [u32; FATES])>,
    /// The worst row with a verdict, from 0.
    worst: Option<(Rank, usize)>,
}

/// Which rows are listed. An empty set leaves nothing out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Filter {
    /// Rows of these fates.
    pub fates: BTreeSet<RowFate>,
    /// Rows of these classes; 0 is none, the others are numbers of a [`Store`] from 1.
    pub classes: BTreeSet<usize>,
}

impl Filter {
    /// Whether it leaves nothing out.
    pub fn is_all(&self) -> bool {
        self.fates.is_empty() && self.classes.is_empty()
    }

    /// The filter as a table, for this many classes: one look-up a row.
    pub fn sieve(&self, classes: usize) -> Sieve {
        let takes_fate = |fate: &RowFate| self.fates.is_empty() || self.fates.contains(fate);
        let fates = RowFate::ALL.map(|fate| takes_fate(&fate));
        let of_class = |class: usize| {
            let takes_class = self.classes.is_empty() || self.classes.contains(&class);
            std::array::from_fn(|fate| takes_class && fates.get(fate).is_some_and(|takes| *takes))
        };
        Sieve { takes: (0..=classes).map(of_class).collect(), is_all: self.is_all() }
    }
}

/// A filter as a table.
#[derive(Debug, Clone, Default)]
pub struct Sieve {
    /// Whether a row of each class, 0 for none, and of each fate is taken; a mark has room for eight fates.
    takes: Vec<[bool; 8]>,
    is_all: bool,
}

impl Sieve {
    fn takes(&self, mark: Mark) -> bool {
        self.takes.get(mark.class()).and_then(|fates| fates.get(usize::from(mark.0 & 7))).is_some_and(|takes| *takes)
    }
}

impl Part {
    /// How many rows it has.
    pub const fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether it has none.
    pub const fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Where it cannot be split into cells, and why.
    pub(crate) const fn broken(&self) -> Option<Broken> {
        self.broken
    }

    /// How many bytes of memory it takes.
    pub fn bytes_kept(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.rows) + size_of_val(self.counts.as_slice())
    }

    /// What became of a row, and its class; the rows count from 0.
    pub fn row(&self, number: usize) -> Option<(RowFate, usize)> {
        self.rows.get(number).map(|mark| (mark.fate(), mark.class()))
    }

    /// How many rows a filter takes; no row is looked at.
    pub fn count(&self, sieve: &Sieve) -> usize {
        if sieve.is_all {
            return self.len();
        }
        let classes = self.counts.iter().filter_map(|(class, counts)| Some((sieve.takes.get(*class)?, counts)));
        let fates = classes.flat_map(|(takes, counts)| takes.iter().zip(counts));
        fates.filter(|(takes, _)| **takes).map(|(_, count)| wide(*count)).sum()
    }

    /// One of the rows that a filter takes, from 0.
    pub fn nth(&self, place: usize, sieve: &Sieve) -> Option<usize> {
        if sieve.is_all { Some(place).filter(|place| *place < self.len()) } else { self.listed(sieve).nth(place) }
    }

    /// The rows that a filter takes, from 0.
    pub fn listed<'a>(&'a self, sieve: &'a Sieve) -> impl Iterator<Item = usize> + 'a {
        let rows = self.rows.iter().enumerate();
        rows.filter(|(_, mark)| sieve.takes(**mark)).map(|(number, _)| number)
    }

    /// Whether a filter takes a row.
    pub(super) fn is_listed(&self, number: usize, sieve: &Sieve) -> bool {
        self.rows.get(number).is_some_and(|mark| sieve.takes(*mark))
    }

    /// The worst row with a verdict, from 0, by what the worst rows of parts are compared: the least is the worst.
    pub const fn worst(&self) -> Option<(Rank, usize)> {
        self.worst
    }

    /// How many rows of each class have each fate; class 0 is none.
    pub fn by_class(&self) -> &[(usize, [u32; FATES])] {
        &self.counts
    }
}

/// Numbers the classes of all workers alike and knows where the next part begins.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Store {
    /// The classes, in the order in which they were met: the first one has the number 1.
    pub classes: Vec<ToleranceClass>,
    rows: u64,
    lines: usize,
}

impl Store {
    /// The part of the next block of the stream. The marks are taken.
    pub fn part(&mut self, marks: &mut Marks, block: &Block, tally: &Tally) -> Part {
        let numbers: Vec<usize> =
            marks.classes.iter().map(|class| class.map_or(0, |class| self.number(class))).collect();
        let mut rows: Box<[Mark]> = marks.rows.as_slice().into();
        marks.rows.clear();
        let worst = marks.worst.take();
        let mut counts = vec![[0_u32; FATES]; self.classes.len() + 1];
        for mark in &mut rows {
            let own = mark.class().checked_sub(1).and_then(|number| numbers.get(number)).map_or(0, |own| *own);
            *mark = Mark::new(own.checked_sub(1), mark.fate());
            let fates = counts.get_mut(own);
            if let Some(count) = fates.and_then(|fates| fates.get_mut(usize::from(mark.0 & 7))) {
                *count += 1;
            }
        }
        let occurs = |(_, fates): &(usize, [u32; FATES])| fates.iter().any(|count| 0 < *count);
        let part = Part {
            start: block.start(),
            bytes: block.len(),
            first: self.rows,
            line: self.lines,
            broken: block.broken,
            rows,
            counts: counts.into_iter().enumerate().filter(occurs).collect(),
            worst,
        };
        self.rows += long(part.len());
        self.lines += tally.lines;
        part
    }

    /// The number of a class from 1, new if it was not met before; 0 where there are too many.
    fn number(&mut self, class: ToleranceClass) -> usize {
        if let Some(at) = self.classes.iter().position(|known| *known == class) {
            return at + 1;
        }
        if MOST_CLASSES <= self.classes.len() {
            return 0;
        }
        self.classes.push(class);
        self.classes.len()
    }
}
