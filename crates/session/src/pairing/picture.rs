//! The picture of a pairing: holes and shafts as places on one scale, and what of it is in sight.
//!
//! Plain numbers in micrometres from the smallest hole, for drawing only: nothing is decided by them. Shafts are moved by the
//! middle of the wanted clearances, so a pair at the middle is level.

use std::ops::Range;

use fitcheck_core::length::Length;
use fitcheck_exchange::report::pairing::PairingAnswer;

/// The most pairs and leftovers that are in sight all at once; of more, those around the selected pair are.
const MOST_AT_ONCE: usize = 48;

/// How many pairs to either side of the selected one are in sight then.
const AROUND: usize = 12;

/// The most marks of one kind that are drawn; of more in sight every second is drawn, or every third, and so on.
const MOST_DRAWN: usize = 60;

/// Into how many parts the overview divides the scale.
const BINS: u32 = 120;

/// Places of all parts, in micrometres, in order of size.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PairsPicture {
    /// The hole and the shaft of each pair.
    pairs: Vec<[f64; 2]>,
    /// Leftover holes.
    holes: Vec<f64>,
    /// Leftover shafts.
    shafts: Vec<f64>,
    low: f64,
    high: f64,
    /// The overview, from the lower end of the whole scale.
    pub bins: Vec<Bin>,
}

/// How many parts lie in a part of the scale, as shares of the fullest one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bin {
    /// Paired holes.
    pub holes: f64,
    /// Leftover holes.
    pub left_holes: f64,
    /// Paired shafts.
    pub shafts: f64,
    /// Leftover shafts.
    pub left_shafts: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub struct PairingView {
    /// The lower end of the axis.
    pub low: f64,
    /// The upper end, always above the lower one.
    pub high: f64,
    pub pairs: Marks,
    /// The leftover holes.
    pub holes: Marks,
    /// The leftover shafts.
    pub shafts: Marks,
    /// Whether that is everything.
    pub is_all: bool,
}

/// Places in sight, and how many of them are drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Marks {
    /// Their places among all of their kind.
    pub range: Range<usize>,
    /// Every so manyth is drawn; 1 is all of them.
    pub step: usize,
}

impl Marks {
    fn of(range: Range<usize>) -> Self {
        let step = range.len().div_ceil(MOST_DRAWN).max(1);
        Self { range, step }
    }

    pub fn drawn(&self) -> impl Iterator<Item = usize> + use<> {
        self.range.clone().step_by(self.step)
    }
}

impl PairsPicture {
    pub(super) fn of(answer: &PairingAnswer) -> Self {
        let holes = &answer.asked.holes.measured;
        let shafts = &answer.asked.shafts.measured;
        let wanted = answer.asked.wanted;
        // Any zero will do where there is no part to place.
        let zero = holes.iter().min().or_else(|| shafts.iter().min()).map_or(Length::ZERO, |smallest| *smallest);
        let um = |length: Length| length.to_mm_f64() * 1e3;
        let middle = f64::midpoint(um(wanted.minimum()), um(wanted.maximum()));
        let hole = |at: usize| holes.get(at).map(|size| um(size.saturating_sub(zero)));
        let shaft = |at: usize| shafts.get(at).map(|size| um(size.saturating_sub(zero)) + middle);
        let pairing = &answer.pairing;
        let pairs: Vec<_> =
            pairing.pairs.iter().filter_map(|pair| Some([hole(pair.hole)?, shaft(pair.shaft)?])).collect();
        let holes: Vec<f64> = pairing.holes.iter().filter_map(|&at| hole(at)).collect();
        let shafts: Vec<f64> = pairing.shafts.iter().filter_map(|&at| shaft(at)).collect();
        let ends = pairs.iter().flatten().chain(&holes).chain(&shafts).copied();
        let ends = ends.fold(None, |ends: Option<(f64, f64)>, um| {
            Some(ends.map_or((um, um), |(low, high)| (low.min(um), high.max(um))))
        });
        let (low, high) = ends.map_or((0.0, 1.0), |(low, high)| widened(low, high));
        let mut picture = Self { pairs, holes, shafts, low, high, bins: Vec::new() };
        picture.bins = picture.counted();
        picture
    }

    /// Holes and shafts in each part of the scale.
    fn counted(&self) -> Vec<Bin> {
        let end = |bin| self.low + (self.high - self.low) * f64::from(bin) / f64::from(BINS);
        let ends: Vec<f64> = (0..=BINS).map(end).collect();
        let [holes, shafts]: [Vec<f64>; 2] =
            [|pair: &[f64; 2]| pair[0], |pair: &[f64; 2]| pair[1]].map(|of| self.pairs.iter().map(of).collect());
        let counts = [&holes, &self.holes, &shafts, &self.shafts].map(|places| in_each(places, &ends));
        let most = counts.iter().flatten().copied().fold(1.0, f64::max);
        let [holes, left_holes, shafts, left_shafts] = counts;
        let bins = holes.into_iter().zip(left_holes).zip(shafts.into_iter().zip(left_shafts));
        let bin = |((hole, left_hole), (shaft, left_shaft))| Bin {
            holes: hole / most,
            left_holes: left_hole / most,
            shafts: shaft / most,
            left_shafts: left_shaft / most,
        };
        bins.map(bin).collect()
    }

    /// The hole and the shaft of a pair.
    pub fn pair(&self, at: usize) -> Option<[f64; 2]> {
        self.pairs.get(at).copied()
    }

    /// A leftover hole.
    pub fn hole(&self, at: usize) -> Option<f64> {
        self.holes.get(at).copied()
    }

    /// A leftover shaft.
    pub fn shaft(&self, at: usize) -> Option<f64> {
        self.shafts.get(at).copied()
    }

    /// Where a place is on the whole scale, from 0 to 1.
    pub fn share(&self, um: f64) -> f64 {
        ((um - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    /// What is in sight while a pair is selected, or none: all, or what lies around it; around the first one where none is.
    pub fn sight(&self, selected: Option<usize>) -> PairingView {
        let count = self.pairs.len() + self.holes.len() + self.shafts.len();
        let here = selected.unwrap_or(0);
        let around = self.pairs.get(here.saturating_sub(AROUND)..(here + AROUND + 1).min(self.pairs.len()));
        let Some(around) = around.filter(|around| MOST_AT_ONCE < count && !around.is_empty()) else {
            let all = |places: &[f64]| Marks::of(0..places.len());
            let holes = all(&self.holes);
            let shafts = all(&self.shafts);
            let pairs = Marks::of(0..self.pairs.len());
            return PairingView { low: self.low, high: self.high, pairs, holes, shafts, is_all: true };
        };
        let places = || around.iter().flatten().copied();
        let low = places().fold(f64::INFINITY, f64::min);
        let high = places().fold(f64::NEG_INFINITY, f64::max);
        let within = |places: &[f64]| {
            Marks::of(places.partition_point(|um| *um < low)..places.partition_point(|um| *um <= high))
        };
        // Pairs are in order of size on both sides.
        let first = self.pairs.partition_point(|[hole, shaft]| hole.max(*shaft) < low);
        let end = self.pairs.partition_point(|[hole, shaft]| hole.min(*shaft) <= high);
        let holes = within(&self.holes);
        let shafts = within(&self.shafts);
        let (low, high) = widened(low, high);
        PairingView { low, high, pairs: Marks::of(first..end), holes, shafts, is_all: false }
    }
}

/// How many places lie between each end and the next; ends and places ascend, and the last part has both its ends.
fn in_each(places: &[f64], ends: &[f64]) -> Vec<f64> {
    let below = |end: f64| places.partition_point(|um| *um < end);
    let mut before = 0;
    let counts = ends.iter().enumerate().skip(1).map(|(number, end)| {
        let until = if number + 1 == ends.len() { places.len() } else { below(*end) };
        let count = until.saturating_sub(before);
        before = until;
        f64::from(u32::try_from(count).unwrap_or(u32::MAX))
    });
    counts.collect()
}

/// A little room at both ends, also where they are the same.
fn widened(low: f64, high: f64) -> (f64, f64) {
    let room = ((high - low) * 0.04).max(0.5);
    (low - room, high + room)
}

impl PairingView {
    /// Where a place is in sight, from 0 at the lower end to 1 at the upper one; outside it is beyond these.
    pub fn fraction(&self, um: f64) -> f64 {
        (um - self.low) / (self.high - self.low)
    }

    /// The largest step of what is drawn: 1 where all of it is.
    pub fn step(&self) -> usize {
        [&self.pairs, &self.holes, &self.shafts].into_iter().map(|marks| marks.step).max().unwrap_or(1)
    }
}
