//! Where a feature of a part ends.

use super::super::{FARTHEST, Figure, Shape, Surface, WorkpieceError, in_range};
use crate::probing::cycle::Plane;

/// Where a feature ends, millimetres; infinite where it has no end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// The top of walls, along the axis of their plane: Z for X/Y.
    pub top: f64,
    /// Their bottom: the floor of a hole, slot or pocket; the end of a body.
    pub bottom: f64,
    /// How long the walls of a slot or ridge are, half of it to either side of the centre.
    pub length: f64,
    /// How far a face or point reaches about its point.
    pub reach: f64,
}

impl Extent {
    /// No end anywhere.
    pub const ENDLESS: Self =
        Self { top: f64::INFINITY, bottom: f64::NEG_INFINITY, length: f64::INFINITY, reach: f64::INFINITY };

    /// What is assumed of a surface: walls in X/Y begin at Z0 and go down without end, everything else has no end.
    pub const fn usual(surface: &Surface) -> Self {
        match (surface.shape(), surface.plane()) {
            (Shape::Face | Shape::Point, _) | (_, Plane::Zx | Plane::Yz) => Self::ENDLESS,
            (_, Plane::Xy) => Self { top: 0.0, ..Self::ENDLESS },
        }
    }

    /// Whether it has no end anywhere.
    pub(super) fn is_endless(&self) -> bool {
        *self == Self::ENDLESS
    }

    pub(super) fn check(&self) -> Result<(), WorkpieceError> {
        let finite = |figure, given: f64, least| {
            if given == f64::INFINITY { Ok(()) } else { in_range(figure, given, least, FARTHEST) }
        };
        finite(Figure::Top, self.top, -FARTHEST)?;
        if self.bottom.is_finite() || self.bottom.is_nan() || 0.0 < self.bottom {
            // A bottom lies below its top.
            in_range(Figure::Bottom, self.bottom, -FARTHEST, self.top.min(FARTHEST) - 0.001)?;
        }
        finite(Figure::Length, self.length, 0.001)?;
        finite(Figure::Reach, self.reach, 0.001)
    }

    /// The same, grown by a factor about the workpiece's zero.
    pub(super) fn grown(&self, factor: f64) -> Self {
        let Self { top, bottom, length, reach } = *self;
        Self { top: top * factor, bottom: bottom * factor, length: length * factor, reach: reach * factor }
    }

    /// Whether a height lies between top and bottom, both included.
    pub(super) fn has(&self, height: f64) -> bool {
        self.bottom <= height && height <= self.top
    }

    /// How far a height lies above the top or below the bottom; below zero between them.
    pub(super) fn beyond(&self, height: f64) -> f64 {
        (height - self.top).max(self.bottom - height)
    }
}
