//! What the picture of a parameter shows: the shape that the cycle measures, and the names of its axes.

use crate::probing::cycle::{Cycle, Meaning};
use crate::probing::simulated::Shape;

/// What is drawn: the shape that the cycle measures, and what its axes are called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Scene {
    pub(super) shape: Shape,
    pub(super) axes: [&'static str; 3],
}

impl Scene {
    pub(super) fn of(cycle: &Cycle) -> Self {
        // Where a parameter chooses the plane, its axes have no letters.
        let axes = if cycle.meant(Meaning::Plane).is_some() { ["1", "2", "3"] } else { ["X", "Y", "Z"] };
        Self { shape: cycle.shape(), axes }
    }
}
