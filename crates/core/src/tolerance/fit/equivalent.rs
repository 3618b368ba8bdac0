//! The same fit in the other basis: `H7/p6` and `P7/h6`.
//!
//! The letters change places, the grades stay with hole and shaft. Often, but not always, that gives exactly the same
//! clearances: the Δ of ISO 286-1 is made for fits with a hole one grade coarser than the shaft, above 3 up to 500 mm.

use super::Fit;
use crate::length::Length;
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::iso286::{self, Letter};

/// The pair of classes in the other basis; `None` where there is none: neither class is an H, or both are.
pub fn equivalent(hole: ToleranceClass, shaft: ToleranceClass) -> Option<(ToleranceClass, ToleranceClass)> {
    if (hole.feature(), shaft.feature()) != (Feature::Hole, Feature::Shaft) {
        return None;
    }
    let (of_hole, hole_grade) = iso286::parts(hole)?;
    let (of_shaft, shaft_grade) = iso286::parts(shaft)?;
    let is_one_basis = (of_hole == Letter::H) != (of_shaft == Letter::H);
    is_one_basis.then(|| {
        let hole = iso286::class(Feature::Hole, of_shaft, hole_grade);
        (hole, iso286::class(Feature::Shaft, of_hole, shaft_grade))
    })
}

/// How far one fit's clearances differ from another's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Difference {
    /// The other fit's smallest clearance minus this one's.
    pub minimum: Length,
    /// The other fit's largest clearance minus this one's.
    pub maximum: Length,
}

impl Difference {
    /// From one fit to the other.
    pub fn between(one: &Fit, other: &Fit) -> Self {
        Self {
            minimum: other.minimum_clearance().saturating_sub(one.minimum_clearance()),
            maximum: other.maximum_clearance().saturating_sub(one.maximum_clearance()),
        }
    }

    /// Whether both clearances are the same to the nanometre.
    pub fn is_none(self) -> bool {
        self.minimum == Length::ZERO && self.maximum == Length::ZERO
    }
}
