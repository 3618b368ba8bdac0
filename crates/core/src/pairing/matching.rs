//! As many pairs as possible, and of all ways to make as many, the one with the least sum of squared distances from the middle.
//!
//! The shafts that fit a hole are those from `hole − maximum` to `hole − minimum`: an interval of sizes, and both ends rise with
//! the hole. So the greedy walk in order of size finds as many pairs as there can be: each hole, from the smallest,
//! takes the smallest shaft that is left and fits. Exchanging partners of any other matching turns it into this one. Which of the
//! parts go together is `closest`.

use super::PairClearances;
use super::closest::closest;
use super::wanted::Window;
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

/// The most pairs of holes and shafts with a wanted clearance, and of all ways to pair as many, the one with the least sum of
/// squared distances from its middle.
///
/// Which of several such ways is taken follows from the sizes alone; of parts of equal size, those that were given first.
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
    let found = closest(holes, shafts, Window::of(wanted));
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

/// The most pairs there can be: a greedy walk over sizes in ascending order.
pub(super) fn count(holes: &[Length], shafts: &[Length], window: Window) -> usize {
    let mut free = shafts.iter().peekable();
    let takes_one = |hole: &&Length| {
        let clearance = |shaft: &Length| hole.nanometres() - shaft.nanometres();
        // A shaft that is too small for this hole is too small for all larger ones.
        while free.next_if(|shaft| window.high < clearance(shaft)).is_some() {}
        free.next_if(|shaft| window.low <= clearance(shaft)).is_some()
    };
    holes.iter().filter(takes_one).count()
}
