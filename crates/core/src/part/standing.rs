//! What the values of a part make of each of its features: the balloon of a feature with two sides is good when both are.

use super::plan::{Plan, Size};
use super::walk::Step;
use crate::verdict::Status;

/// What the walk knows of a feature.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct FeatureStanding {
    /// The place of its first size in the plan.
    pub first: usize,
    /// What its values make of it, where all of them are there or one is bad.
    pub status: Option<Status>,
    /// Whether a value that counts was simulated.
    pub is_simulated: bool,
    /// Whether a size of it was left out.
    pub is_skipped: bool,
}

/// Each feature of a plan, by the steps of a walk.
pub fn standings(plan: &Plan, steps: &[Step]) -> Vec<FeatureStanding> {
    let sizes: Vec<Size<'_>> = plan.sizes().collect();
    let mut all: Vec<FeatureStanding> = Vec::new();
    let mut is_whole = true;
    for (place, (size, step)) in sizes.iter().zip(steps).enumerate() {
        if size.side == 0 {
            is_whole = true;
            all.push(FeatureStanding { first: place, ..FeatureStanding::default() });
        }
        let Some(last) = all.last_mut() else { continue };
        let counts = step.counts();
        is_whole &= counts.is_some();
        last.status = last.status.max(counts.map(|taken| taken.status));
        last.is_simulated |= counts.is_some_and(|taken| taken.is_simulated);
        last.is_skipped |= counts.is_none() && step.skipped.is_some();
        let is_last = sizes.get(place + 1).is_none_or(|size| size.side == 0);
        // Good is said of a feature of which every side was measured.
        if is_last && !is_whole {
            last.status = last.status.filter(|status| *status != Status::Good);
        }
    }
    all
}
