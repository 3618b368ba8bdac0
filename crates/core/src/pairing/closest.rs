//! Of all ways to make the most pairs within bounds, the one with the least sum of squared distances from their middle.
//!
//! Put the holes on a line, and the shafts too, moved up by the middle clearance. How far a pair is from the middle is then how far
//! apart its two parts are on the line. Some best answer has no leftover between the parts of a pair, as that leftover would be at
//! least as near to one of them, and no two pairs that cross, as both in order of size are at least as near. So the line falls
//! apart into leftovers and stretches with as many holes as shafts, whose parts go together in order of size.
//!
//! The level of a gap between two parts is the holes before it less the shafts before it. A stretch goes from a gap to the next
//! of the same level, so each gap ends one stretch at most. From gap to gap, either the part before the gap is left over, or
//! the stretch that ends there is paired: the most pairs up to each gap, and the least sum among those with the most. Sums are made
//! only for stretches that are in some answer with the most pairs. Together these are mostly about as long as the line; at worst,
//! where half of the holes are left over at both sides of a heap of shafts, as long as its square.

use super::wanted::Window;
use crate::length::Length;

/// The pairs as ranks, in order of size; both lists are in ascending order. Of equal sizes the first ones are paired.
pub(super) fn closest(holes: &[Length], shafts: &[Length], window: Window) -> Vec<(usize, usize)> {
    let line = Line::of(holes, shafts, window);
    let stretches = line.stretches();
    let counts = Counts::of(&stretches);
    let pairs = line.pairs(&stretches, &counts);
    let paired_holes = first_of_equal(holes, pairs.iter().map(|pair| pair.0));
    let paired_shafts = first_of_equal(shafts, pairs.iter().map(|pair| pair.1));
    paired_holes.into_iter().zip(paired_shafts).collect()
}

/// Ranks in ascending order, each moved to the first free one of its size.
fn first_of_equal(sizes: &[Length], ranks: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut free = 0;
    let first = |rank| {
        let size = sizes.get(rank)?;
        let rank = sizes.partition_point(|other| other < size).max(free);
        free = rank + 1;
        Some(rank)
    };
    ranks.filter_map(first).collect()
}

/// Holes and moved shafts, in half nanometres: the middle may lie on a half.
struct Line {
    holes: Vec<i64>,
    shafts: Vec<i64>,
    /// How far apart the parts of a pair may be.
    reach: i64,
}

/// Parts between two gaps of the same level.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// How many parts are before it.
    start: usize,
    /// How many holes are before it.
    holes_before: usize,
    /// How many shafts are before it.
    shafts_before: usize,
    pairs: usize,
}

/// What is known about a level, during the walk along the line.
struct Level {
    /// The last gap of this level, as a stretch without parts.
    last_gap: Option<Stretch>,
    /// The largest lag of the holes since the walk last came here from below, down to this level.
    hole_lag: i64,
    /// The largest lag of the shafts since the walk last came here from above, up to this level.
    shaft_lag: i64,
}

impl Level {
    const NEW: Self = Self { last_gap: None, hole_lag: i64::MIN, shaft_lag: i64::MIN };
}

impl Line {
    fn of(holes: &[Length], shafts: &[Length], Window { low, high }: Window) -> Self {
        Self {
            holes: holes.iter().map(|hole| hole.nanometres() * 2).collect(),
            shafts: shafts.iter().map(|shaft| shaft.nanometres() * 2 + low + high).collect(),
            reach: high - low,
        }
    }

    /// The stretch that ends behind each part of the line, where there is one and all its pairs are within reach.
    ///
    /// In a stretch that starts with a hole, at a level, the shaft of a hole has the hole's rank less the level. It is within
    /// reach if that is less than the number of shafts up to there: if the hole's lag is less than the level.
    fn stretches(&self) -> Vec<Option<Stretch>> {
        let mut holes = self.holes.iter().zip(self.lags(&self.holes, &self.shafts)).peekable();
        let mut shafts = self.shafts.iter().zip(self.lags(&self.shafts, &self.holes)).peekable();
        let (mut lower, mut higher) = (Vec::new(), Vec::new());
        let mut here = Gap { level: 0, holes: 0, shafts: 0 };
        let mut from = Level { last_gap: Some(here.empty_stretch()), ..Level::NEW };
        // In one place they take turns, or many measured alike would make stretches within stretches.
        let mut is_turn_of_holes = true;
        let mut all = Vec::with_capacity(self.holes.len() + self.shafts.len());
        loop {
            let next_shaft = shafts.peek().map(|shaft| shaft.0);
            let is_before = |hole: &i64, shaft| hole < shaft || hole == shaft && is_turn_of_holes;
            let (mut to, is_within);
            if let Some((_, lag)) = holes.next_if(|hole| next_shaft.is_none_or(|shaft| is_before(hole.0, shaft))) {
                here = Gap { level: here.level + 1, holes: here.holes + 1, ..here };
                to = higher.pop().unwrap_or(Level::NEW);
                is_within = from.shaft_lag < -here.level;
                to.shaft_lag = to.shaft_lag.max(from.shaft_lag);
                to.hole_lag = lag;
                lower.push(from);
                is_turn_of_holes = false;
            } else if let Some((_, lag)) = shafts.next() {
                here = Gap { level: here.level - 1, shafts: here.shafts + 1, ..here };
                to = lower.pop().unwrap_or(Level::NEW);
                is_within = from.hole_lag < here.level;
                to.hole_lag = to.hole_lag.max(from.hole_lag);
                to.shaft_lag = lag;
                higher.push(from);
                is_turn_of_holes = true;
            } else {
                return all;
            }
            let before = to.last_gap.replace(here.empty_stretch());
            let stretch = before.map(|gap| Stretch { pairs: here.holes - gap.holes_before, ..gap });
            all.push(stretch.filter(|_| is_within));
            from = to;
        }
    }

    /// The rank of each part less the number of the others that are not beyond its reach.
    fn lags(&self, parts: &[i64], others: &[i64]) -> Vec<i64> {
        let mut others = others.iter().peekable();
        let mut lag = 0;
        let lag_of = |part: &i64| {
            while others.next_if(|other| **other - part <= self.reach).is_some() {
                lag -= 1;
            }
            lag += 1;
            lag - 1
        };
        parts.iter().map(lag_of).collect()
    }

    /// The pairs of the best answer, as ranks in ascending order.
    fn pairs(&self, stretches: &[Option<Stretch>], counts: &Counts) -> Vec<(usize, usize)> {
        let taken = self.taken(stretches, counts);
        let mut pairs = Vec::with_capacity(counts.most);
        let mut end = taken.len();
        while let Some(before) = end.checked_sub(1) {
            end = before;
            if let Some(stretch) = taken.get(before).copied().flatten() {
                let ranks = |pair| (stretch.holes_before + pair, stretch.shafts_before + pair);
                pairs.extend((0..stretch.pairs).rev().map(ranks));
                end = stretch.start;
            }
        }
        pairs.reverse();
        pairs
    }

    /// The stretch to pair where the line is cut behind each part; `None` where that part is left over.
    fn taken(&self, stretches: &[Option<Stretch>], counts: &Counts) -> Vec<Option<Stretch>> {
        // The least sum up to each gap; of no meaning where no answer with the most pairs has that gap between its stretches.
        let mut sums = vec![0];
        let mut taken = Vec::with_capacity(stretches.len());
        let mut sum = 0;
        for (part, stretch) in stretches.iter().enumerate() {
            let left_over = counts.can_leave(part).then_some(sum);
            let paired = stretch.filter(|stretch| counts.can_take(*stretch, part + 1)).and_then(|stretch| {
                let sum: u128 = sums.get(stretch.start)? + self.squares(stretch)?;
                left_over.is_none_or(|left_over| sum < left_over).then_some((sum, stretch))
            });
            sum = paired.map(|paired| paired.0).or(left_over).unwrap_or(0);
            sums.push(sum);
            taken.push(paired.map(|paired| paired.1));
        }
        taken
    }

    /// The sum of the squared distances, of its pairs in order of size.
    fn squares(&self, Stretch { holes_before, shafts_before, pairs, .. }: Stretch) -> Option<u128> {
        let holes = self.holes.get(holes_before..holes_before + pairs)?;
        let shafts = self.shafts.get(shafts_before..shafts_before + pairs)?;
        let square = |(hole, shaft): (&i64, &i64)| {
            let distance = u128::from(hole.abs_diff(*shaft));
            distance * distance
        };
        Some(holes.iter().zip(shafts).map(square).sum())
    }
}

/// A place between two parts, or at an end of the line.
#[derive(Clone, Copy)]
struct Gap {
    level: i64,
    holes: usize,
    shafts: usize,
}

impl Gap {
    const fn empty_stretch(self) -> Stretch {
        Stretch { start: self.holes + self.shafts, holes_before: self.holes, shafts_before: self.shafts, pairs: 0 }
    }
}

/// The most pairs before and behind each gap.
struct Counts {
    before: Vec<usize>,
    behind: Vec<usize>,
    most: usize,
}

impl Counts {
    fn of(stretches: &[Option<Stretch>]) -> Self {
        let mut before = vec![0];
        let mut most = 0;
        for stretch in stretches {
            let paired = stretch.and_then(|stretch| Some(before.get(stretch.start)? + stretch.pairs));
            most = paired.map_or(most, |paired| paired.max(most));
            before.push(most);
        }
        let mut behind = vec![0; before.len()];
        let mut most_behind = 0;
        for (part, stretch) in stretches.iter().enumerate().rev() {
            // All stretches that start behind this part have been seen.
            if let Some(count) = behind.get_mut(part + 1) {
                most_behind = most_behind.max(*count);
                *count = most_behind;
            }
            if let Some(stretch) = stretch
                && let Some(count) = behind.get_mut(stretch.start)
            {
                *count = (*count).max(most_behind + stretch.pairs);
            }
        }
        Self { before, behind, most }
    }

    /// Whether some answer with the most pairs leaves this part over, with no stretch across it.
    fn can_leave(&self, part: usize) -> bool {
        self.before.get(part) == self.before.get(part + 1) && self.can_cut(part + 1)
    }

    /// Whether some answer with the most pairs has all pairs of this stretch.
    fn can_take(&self, stretch: Stretch, end: usize) -> bool {
        let with_it = self.before.get(stretch.start).map(|count| count + stretch.pairs);
        with_it.as_ref() == self.before.get(end) && self.can_cut(end)
    }

    /// Whether some answer with the most pairs has no pair across this gap.
    fn can_cut(&self, gap: usize) -> bool {
        self.before.get(gap).zip(self.behind.get(gap)).is_some_and(|(before, behind)| before + behind == self.most)
    }
}
