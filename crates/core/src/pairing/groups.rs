//! Sorting into groups of equal width: any hole of a group goes with any shaft of the group of the same number.
//!
//! A group reaches from its first size up to the first size of the next one, which belongs to the next; the last group has
//! both its ends. Ends that are no whole nanometre are rounded up, which moves no part into another group.

use super::{PairClearances, PairingError};
use crate::length::Length;
use crate::tolerance::Feature;

/// The most groups: more bins than any shop has.
pub const MOST_GROUPS: usize = 1_000;

/// Sizes from one to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range {
    /// The smallest.
    pub from: Length,
    /// The largest, not below the smallest.
    pub to: Length,
}

impl Range {
    /// From the smallest to the largest of some sizes; `None` where there are none.
    pub fn of(sizes: &[Length]) -> Option<Self> {
        Some(Self { from: *sizes.iter().min()?, to: *sizes.iter().max()? })
    }
}

/// What the groups of holes and of shafts are made from: what was measured, or zones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ranges {
    /// Of the holes.
    pub holes: Range,
    /// Of the shafts.
    pub shafts: Range,
}

impl Ranges {
    /// What was measured.
    ///
    /// # Errors
    /// [`PairingError::NoSizes`] without holes or without shafts.
    pub fn measured(holes: &[Length], shafts: &[Length]) -> Result<Self, PairingError> {
        let range = |sizes, feature| Range::of(sizes).ok_or(PairingError::NoSizes { feature });
        Ok(Self { holes: range(holes, Feature::Hole)?, shafts: range(shafts, Feature::Shaft)? })
    }
}

/// A group of holes and the group of shafts that goes with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// From its first size to the first size of the next group, or to the last size of all.
    pub hole_range: Range,
    /// The same for the shafts.
    pub shaft_range: Range,
    /// How many holes it has.
    pub holes: usize,
    /// How many shafts it has.
    pub shafts: usize,
    /// The smallest and the largest clearance that two of its parts can have; `None` without holes or without shafts.
    pub clearances: Option<(Length, Length)>,
}

impl Group {
    /// How many pairs can be taken from it.
    pub fn pairs(&self) -> usize {
        self.holes.min(self.shafts)
    }

    /// Whether every hole of the group goes with every shaft of it; `None` without holes or without shafts.
    pub fn all_within(&self, wanted: PairClearances) -> Option<bool> {
        self.clearances.map(|(smallest, largest)| wanted.allows(smallest) && wanted.allows(largest))
    }
}

/// All groups, and where each part belongs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Groups {
    /// The groups, the smallest sizes first.
    pub all: Vec<Group>,
    /// The group of each hole, counted from 0; `None` outside the range.
    pub holes: Vec<Option<usize>>,
    /// The group of each shaft.
    pub shafts: Vec<Option<usize>>,
}

impl Groups {
    /// How many holes and shafts are outside the ranges, and so in no group.
    pub fn outside(&self) -> (usize, usize) {
        let outside = |groups: &[Option<usize>]| groups.iter().filter(|group| group.is_none()).count();
        (outside(&self.holes), outside(&self.shafts))
    }
}

/// Sorts holes and shafts into so many groups.
///
/// # Errors
/// [`PairingError`] where a range has fewer nanometres than groups are asked for, or the number of groups is 0 or beyond
/// [`MOST_GROUPS`].
pub fn groups(holes: &[Length], shafts: &[Length], count: usize, ranges: Ranges) -> Result<Groups, PairingError> {
    let hole_split = Split::new(Feature::Hole, ranges.holes, count)?;
    let shaft_split = Split::new(Feature::Shaft, ranges.shafts, count)?;
    let hole_bins = hole_split.sort(holes);
    let shaft_bins = shaft_split.sort(shafts);
    let groups = (0..).zip(hole_bins.iter().zip(&shaft_bins)).map(|(number, (hole, shaft))| {
        let clearances = hole
            .range
            .zip(shaft.range)
            .map(|(hole, shaft)| (hole.from.saturating_sub(shaft.to), hole.to.saturating_sub(shaft.from)));
        Group {
            hole_range: hole_split.range_of(number),
            shaft_range: shaft_split.range_of(number),
            holes: hole.count,
            shafts: shaft.count,
            clearances,
        }
    });
    Ok(Groups {
        all: groups.collect(),
        holes: holes.iter().map(|hole| hole_split.group(*hole)).collect(),
        shafts: shafts.iter().map(|shaft| shaft_split.group(*shaft)).collect(),
    })
}

/// A range in parts of equal width.
struct Split {
    range: Range,
    count: usize,
}

/// What of the measured sizes lies in a part.
#[derive(Clone, Default)]
struct Bin {
    count: usize,
    range: Option<Range>,
}

impl Split {
    fn new(feature: Feature, range: Range, count: usize) -> Result<Self, PairingError> {
        if !(1..=MOST_GROUPS).contains(&count) {
            return Err(PairingError::GroupCount { count });
        }
        let split = Self { range, count };
        if 1 < count && split.width() < split.parts() {
            return Err(PairingError::TooNarrow { feature, from: range.from, to: range.to, count });
        }
        Ok(split)
    }

    /// Nanometres from end to end: at most 1e15, and a thousand times as many are still exact.
    fn width(&self) -> i64 {
        self.range.to.saturating_sub(self.range.from).nanometres()
    }

    fn parts(&self) -> i64 {
        i64::try_from(self.count).unwrap_or(i64::MAX)
    }

    /// The part that a size lies in, counted from 0.
    fn group(&self, size: Length) -> Option<usize> {
        if size < self.range.from || self.range.to < size {
            return None;
        }
        let behind = size.saturating_sub(self.range.from).nanometres();
        // A range of one size is a single part.
        let Some(group) = (behind * self.parts()).checked_div(self.width()) else { return Some(0) };
        Some(usize::try_from(group).ok()?.min(self.count - 1))
    }

    fn range_of(&self, number: usize) -> Range {
        Range { from: self.end(number), to: self.end(number + 1) }
    }

    /// Where a part begins: the first whole nanometre in it. Beyond the last part it is the end of all.
    fn end(&self, number: usize) -> Length {
        let behind = |number: i64| {
            let width = number * self.width();
            let parts = self.parts();
            Length::from_nanometres(width / parts + i64::from(width % parts != 0)).ok()
        };
        let behind = i64::try_from(number).ok().and_then(behind);
        behind.and_then(|behind| self.range.from.checked_add(behind)).unwrap_or(self.range.to)
    }

    fn sort(&self, sizes: &[Length]) -> Vec<Bin> {
        let mut bins = vec![Bin::default(); self.count];
        for size in sizes.iter().copied() {
            if let Some(bin) = self.group(size).and_then(|group| bins.get_mut(group)) {
                let range = bin.range.unwrap_or(Range { from: size, to: size });
                bin.range = Some(Range { from: range.from.min(size), to: range.to.max(size) });
                bin.count += 1;
            }
        }
        bins
    }
}
