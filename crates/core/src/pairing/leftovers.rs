//! What is left over, and the one amount of grinding that saves most of it.
//!
//! Shafts made smaller by an amount and holes made larger by it have the same clearances, so one answer holds for both. The pairs
//! that are made stay as they are: only leftovers go with leftovers, in the same way as the pairs before them.

use super::closest::closest;
use super::matching::count;
use super::wanted::Window;
use super::{Pair, PairClearances, Pairing};
use crate::length::Length;

/// A micrometre, in nanometres: amounts are looked at in steps of it.
const STEP: i64 = 1_000;

/// The most amounts that are looked at: up to a millimetre, more than anybody grinds off a part to save it.
pub const MOST_AMOUNTS: i64 = 1_000;

/// What grinding the leftovers would do.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Grinding {
    /// The smallest amount that saves most; `None` where no amount that was looked at saves any.
    pub best: Option<Saving>,
    /// The largest amount that was looked at; zero where all leftovers have too much clearance already.
    pub tried: Length,
    /// The amount at which the smallest hole takes the largest shaft: more only loses pairs again.
    pub reach: Length,
}

/// An amount, and the leftovers that it brings together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saving {
    /// How much smaller the leftover shafts become, or how much larger the leftover holes.
    pub amount: Length,
    /// The further pairs, in order of size, with their clearances after grinding.
    pub pairs: Vec<Pair>,
}

impl Grinding {
    /// Whether larger amounts, up to [`Self::reach`], were not looked at.
    pub fn is_bounded(&self) -> bool {
        self.tried < self.reach
    }
}

/// The one amount, a whole number of micrometres, by which grinding all leftover shafts, or all leftover holes, makes most
/// further pairs; of several the smallest. `None` where holes or shafts are not left over.
///
/// A shaft that would be ground away is in no pair.
pub fn grinding(holes: &[Length], shafts: &[Length], pairing: &Pairing, wanted: PairClearances) -> Option<Grinding> {
    let left = |sizes: &[Length], positions: &[usize]| -> Vec<Length> {
        positions.iter().filter_map(|&at| sizes.get(at).copied()).collect()
    };
    let holes = left(holes, &pairing.holes);
    let shafts = left(shafts, &pairing.shafts);
    let clearance = holes.first()?.nanometres() - shafts.last()?.nanometres();
    let reach = (wanted.minimum().nanometres() - clearance).max(0);
    let steps = (reach / STEP + i64::from(reach % STEP != 0)).min(MOST_AMOUNTS);
    let mut best = None;
    let mut most = 0;
    for amount in (1..=steps).map(|step| step * STEP) {
        let count = Ground::of(&shafts, amount, wanted).count(&holes);
        if most < count {
            best = Some(amount);
            most = count;
        }
        if most == holes.len().min(shafts.len()) {
            break;
        }
    }
    let best = best.and_then(|amount| {
        let pairs = Ground::of(&shafts, amount, wanted).pairs(&holes, pairing);
        Some(Saving { amount: Length::from_nanometres(amount).ok()?, pairs })
    });
    Some(Grinding {
        best,
        // Within a millimetre and the difference of two lengths, but not of each other.
        tried: Length::from_nanometres(steps * STEP).unwrap_or(Length::MAX),
        reach: Length::from_nanometres(reach).unwrap_or(Length::MAX),
    })
}

/// Leftover shafts after grinding.
struct Ground<'a> {
    /// Those of which something is left, at their size before.
    shafts: &'a [Length],
    /// How many smaller ones are gone.
    gone: usize,
    /// The clearances before grinding that are the wanted ones after it.
    window: Window,
    amount: i64,
}

impl<'a> Ground<'a> {
    fn of(shafts: &'a [Length], amount: i64, wanted: PairClearances) -> Self {
        let gone = shafts.partition_point(|shaft| shaft.nanometres() <= amount);
        let Window { low, high } = Window::of(wanted);
        let window = Window { low: low - amount, high: high - amount };
        let (_, shafts) = shafts.split_at(gone);
        Self { shafts, gone, window, amount }
    }

    fn count(&self, holes: &[Length]) -> usize {
        count(holes, self.shafts, self.window)
    }

    /// The pairs with the positions that the parts have in the lists.
    fn pairs(&self, holes: &[Length], pairing: &Pairing) -> Vec<Pair> {
        let pair = |&(hole, shaft): &(usize, usize)| {
            let apart = holes.get(hole)?.nanometres() - self.shafts.get(shaft)?.nanometres();
            Some(Pair {
                hole: *pairing.holes.get(hole)?,
                shaft: *pairing.shafts.get(shaft + self.gone)?,
                clearance: Length::from_nanometres(apart + self.amount).ok()?,
            })
        };
        closest(holes, self.shafts, self.window).iter().filter_map(pair).collect()
    }
}
