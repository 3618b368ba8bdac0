//! As many pairs as possible, and among these the ones whose clearances are closest to the middle of what is wanted.
//!
//! The shafts that fit a hole are those from `hole − maximum` to `hole − minimum`: an interval of sizes, and both ends rise with
//! the hole. So the greedy walk in order of size finds as many pairs as there can be: each hole, from the smallest,
//! takes the smallest shaft that is left and fits. Exchanging partners of any other matching turns it into this one.
//!
//! The same walk with narrower clearances tells the narrowest band around the middle that still has as many pairs; the band
//! is found by halving. The walk pairs in order of size. Parts of equal size come in the order in which they were given.

use super::PairClearances;
use crate::length::Length;

/// A hole and a shaft that go together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pair {
    /// The hole's position in the list of holes.
    pub hole: usize,
    /// The shaft's position in the list of shafts.
    pub shaft: usize,
    /// Hole minus shaft.
    pub clearance: Length,
}

/// Which parts go together, and which are left over.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Pairing {
    /// The pairs, in order of size.
    pub pairs: Vec<Pair>,
    /// The width of the narrowest band around the middle of the wanted clearances that all pairs lie in.
    pub band: Length,
    /// Positions of the holes without a shaft, in order of size.
    pub holes: Vec<usize>,
    /// Positions of the shafts without a hole, in order of size.
    pub shafts: Vec<usize>,
}

/// The most pairs of holes and shafts with a wanted clearance, in the narrowest band around its middle.
///
/// ```
/// use fitcheck_core::length::Length;
/// use fitcheck_core::pairing::pair;
///
/// let sizes = |all: [&str; 2]| all.map(|size| size.parse::<Length>().unwrap());
/// let pairing = pair(&sizes(["25.030", "25.010"]), &sizes(["24.990", "25.008"]), "0.010..0.030".parse()?);
/// let clearances: Vec<String> = pairing.pairs.iter().map(|pair| pair.clearance.to_string()).collect();
/// assert_eq!(clearances, ["0.02", "0.022"]);
/// # Ok::<(), fitcheck_core::pairing::PairingError>(())
/// ```
pub fn pair(holes: &[Length], shafts: &[Length], wanted: PairClearances) -> Pairing {
    let sorted_holes = Sorted::of(holes);
    let sorted_shafts = Sorted::of(shafts);
    let holes = &sorted_holes.sizes;
    let shafts = &sorted_shafts.sizes;
    let most = count(holes, shafts, Window::of(wanted));
    let found = matched(holes, shafts, narrowest(holes, shafts, wanted, most));
    let pairs: Vec<Pair> = found
        .iter()
        .filter_map(|&(hole, shaft)| {
            let clearance = holes.get(hole)?.saturating_sub(*shafts.get(shaft)?);
            Some(Pair { hole: sorted_holes.position(hole)?, shaft: sorted_shafts.position(shaft)?, clearance })
        })
        .collect();
    Pairing {
        band: pairs.iter().map(|pair| wanted.band(pair.clearance)).max().unwrap_or(Length::ZERO),
        pairs,
        holes: sorted_holes.without(found.iter().map(|pair| pair.0)),
        shafts: sorted_shafts.without(found.iter().map(|pair| pair.1)),
    }
}

/// Sizes in ascending order, each with its position in the given list; equal ones in the order of that list.
struct Sorted {
    sizes: Vec<Length>,
    positions: Vec<usize>,
}

impl Sorted {
    fn of(sizes: &[Length]) -> Self {
        let mut all: Vec<(Length, usize)> = sizes.iter().copied().zip(0..).collect();
        all.sort_unstable();
        let (sizes, positions) = all.into_iter().unzip();
        Self { sizes, positions }
    }

    fn position(&self, rank: usize) -> Option<usize> {
        self.positions.get(rank).copied()
    }

    /// The positions of the sizes that are not taken; `taken` are ranks in ascending order.
    fn without(&self, taken: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut taken = taken.peekable();
        let ranked = (0..).zip(&self.positions);
        ranked.filter(|(rank, _)| taken.next_if_eq(rank).is_none()).map(|(_, position)| *position).collect()
    }
}

/// Clearances in nanometres, both ends included; for the walk only, so they may lie anywhere.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    pub(super) low: i64,
    pub(super) high: i64,
}

impl Window {
    pub(super) const fn of(wanted: PairClearances) -> Self {
        Self { low: wanted.minimum().nanometres(), high: wanted.maximum().nanometres() }
    }

    /// What of the wanted clearances lies in a band of this width around their middle.
    const fn around_middle(wanted: PairClearances, band: i64) -> Self {
        let Self { low, high } = Self::of(wanted);
        // Ends of the band on a half nanometre: inwards, where the last whole one is.
        let inwards = (high - low - band).div_euclid(2) + (high - low - band).rem_euclid(2);
        Self { low: low + inwards, high: high - inwards }
    }
}

/// The narrowest band of clearances around the middle with this many pairs.
fn narrowest(holes: &[Length], shafts: &[Length], wanted: PairClearances, most: usize) -> Window {
    let all = Window::of(wanted);
    let mut too_narrow = -1;
    let mut enough = all.high - all.low;
    while too_narrow + 1 < enough {
        let band = too_narrow.midpoint(enough);
        if count(holes, shafts, Window::around_middle(wanted, band)) == most {
            enough = band;
        } else {
            too_narrow = band;
        }
    }
    Window::around_middle(wanted, enough)
}

fn count(holes: &[Length], shafts: &[Length], window: Window) -> usize {
    let mut pairs = 0;
    walk(holes, shafts, window, |_, _| pairs += 1);
    pairs
}

/// The pairs as ranks, in order of size.
pub(super) fn matched(holes: &[Length], shafts: &[Length], window: Window) -> Vec<(usize, usize)> {
    let mut pairs = Vec::new();
    walk(holes, shafts, window, |hole, shaft| pairs.push((hole, shaft)));
    pairs
}

/// The greedy walk over sizes in ascending order.
pub(super) fn walk(holes: &[Length], shafts: &[Length], window: Window, mut take: impl FnMut(usize, usize)) {
    let mut free = shafts.iter().enumerate().peekable();
    for (hole_rank, hole) in holes.iter().enumerate() {
        let clearance = |shaft: &Length| hole.nanometres() - shaft.nanometres();
        // A shaft that is too small for this hole is too small for all larger ones.
        while free.next_if(|(_, shaft)| window.high < clearance(shaft)).is_some() {}
        if let Some((shaft_rank, _)) = free.next_if(|(_, shaft)| window.low <= clearance(shaft)) {
            take(hole_rank, shaft_rank);
        }
    }
}
