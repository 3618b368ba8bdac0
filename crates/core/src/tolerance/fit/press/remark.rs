//! Why there is no press fit, and what to know before the answer is used.

use super::super::thermal::Temperature;
use crate::length::Length;
use crate::message::Say;
use crate::tolerance::Feature;

/// Why there is no press fit.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "press", error)]
pub enum PressError {
    /// The fit never has an interference.
    NoInterference {
        /// The smallest clearance.
        clearance: Length,
    },
    /// A length of zero or less.
    Length {
        /// What was given.
        length: Length,
    },
    /// A hub that is not larger than the joint.
    HubOuter {
        /// What was given.
        given: Length,
        /// The diameter of the joint.
        nominal: Length,
    },
    /// A bore of the shaft that leaves no shaft, or is negative.
    ShaftBore {
        /// What was given.
        given: Length,
        /// The diameter of the joint.
        nominal: Length,
    },
    /// A negative roughness.
    Roughness {
        /// What was given.
        given: Length,
    },
    /// No friction.
    Friction,
    /// A material without modulus and Poisson's ratio.
    Material {
        /// Its name.
        name: String,
    },
}

/// What to know before the answer is used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "press")]
pub enum PressRemark {
    /// A part yields at the largest interference.
    Yields {
        /// Hole for the hub, or shaft.
        part: Feature,
        /// The equivalent stress that an elastic part would have, MPa.
        stress: String,
        /// The yield strength, MPa.
        limit: String,
    },
    /// Nobody said at which stress a part yields.
    YieldUnknown {
        /// Hole for the hub, or shaft.
        part: Feature,
    },
    /// The parts may have a clearance.
    MayBeLoose {
        /// The largest clearance.
        clearance: Length,
    },
    /// The roughness loses the smallest interference.
    AllSmoothed {
        /// What it loses.
        loss: Length,
    },
    /// No roughness was given.
    NoRoughness,
    /// The hub would have to be too hot.
    TooHot {
        /// The highest temperature of its coefficient.
        most: Temperature,
    },
    /// The shaft would have to be colder than liquid nitrogen.
    TooCold,
    /// The shaft is taken to shrink as it expands.
    ContractionUnknown,
}

impl PressRemark {
    /// Whether somebody has to look before the answer counts: nothing is safe then.
    pub const fn stands_against(&self) -> bool {
        matches!(self, Self::Yields { .. } | Self::MayBeLoose { .. } | Self::AllSmoothed { .. })
    }
}
