//! The tables of surfaces as a file has them.

use serde::{Deserialize, Serialize};

use super::expansion::{REFERENCE, STEEL};
use super::reading::exactly;
use super::{Lobes, Surface, Walls, Workpiece};
use crate::probing::cycle::Plane;
use crate::tolerance::Feature;

/// The seed of a file without one.
pub(super) const fn first_seed() -> u64 {
    1
}

/// The temperature of a file without one.
pub(super) const fn reference() -> f64 {
    REFERENCE
}

/// The expansion of a file without one.
pub(super) const fn steel() -> f64 {
    STEEL
}

/// A hole or a shaft.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Round {
    #[serde(deserialize_with = "exactly")]
    pub(super) centre: [f64; 2],
    pub(super) diameter: f64,
    #[serde(default)]
    pub(super) plane: Plane,
    #[serde(default)]
    pub(super) ovality: Lobes,
    #[serde(default)]
    pub(super) lobes: Lobes,
    #[serde(default)]
    pub(super) surface_scatter: f64,
}

impl Round {
    pub(super) const fn of(workpiece: &Workpiece, plane: Plane) -> Self {
        let Workpiece { centre, diameter, ovality, lobes, surface_scatter, .. } = *workpiece;
        Self { centre, diameter, plane, ovality, lobes, surface_scatter }
    }

    pub(super) const fn surface(&self, feature: Feature) -> Surface {
        let Self { centre, diameter, plane, ovality, lobes, surface_scatter } = *self;
        Surface::Round(Workpiece { feature, centre, diameter, ovality, lobes, surface_scatter }, plane)
    }
}

/// Two walls.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Pair {
    #[serde(deserialize_with = "exactly")]
    pub(super) centre: [f64; 2],
    pub(super) width: f64,
    #[serde(default)]
    pub(super) angle: f64,
    #[serde(default)]
    pub(super) surface_scatter: f64,
}

/// Four walls.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Rectangle {
    #[serde(deserialize_with = "exactly")]
    pub(super) centre: [f64; 2],
    #[serde(deserialize_with = "exactly")]
    pub(super) lengths: [f64; 2],
    #[serde(default)]
    pub(super) angle: f64,
    #[serde(default)]
    pub(super) surface_scatter: f64,
}

impl Pair {
    pub(super) const fn surface(&self, feature: Feature) -> Surface {
        let Self { centre, width, angle, surface_scatter } = *self;
        Surface::Walls(Walls { feature, centre, lengths: (width, None), angle, surface_scatter })
    }
}

impl Rectangle {
    pub(super) const fn surface(&self, feature: Feature) -> Surface {
        let Self { centre, lengths: [first, second], angle, surface_scatter } = *self;
        Surface::Walls(Walls { feature, centre, lengths: (first, Some(second)), angle, surface_scatter })
    }
}
