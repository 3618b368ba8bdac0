//! What a row says that was measured of its feature: its diameter, or a coordinate, a radius, a roundness of the same name.
//!
//! Measuring machines write several rows of one feature, and a column tells them apart: `AXIS` with `D`, `X`, `TP`, or `Type` with
//! `Diameter`, `Flatness`. A row that says another quantity than a size is never judged as that size. The words are English, Dutch,
//! German and Italian.
//!
//! | a column | is read |
//! |---|---|
//! | whose name says a quantity: `AXIS`, `Merkmalsart` | always |
//! | whose name may say one: `Type`, `as` | where its words do; otherwise they say nothing of what was measured, which is told |
//! | of any other name, or none | where its words can hardly be anything else |
//!
//! A word that is not known is another quantity in a column that knows others. Where a column has that one word alone, or says nothing
//! known, its values are taken as sizes, and the file is told of it: with a plan, name and nominal size still have to be right.

mod column;
mod said;

pub(super) use column::{Free, QuantityColumn, of_row};
use fitcheck_core::part::FeatureKind;
use fitcheck_core::probing::cycle::Axis;
pub(super) use said::{is_angle, is_form, is_shape, may_be_named};

/// What a file says that was measured of a feature.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Quantity {
    /// A size, of whatever kind.
    Size,
    Diameter,
    /// A distance of two walls or from a datum.
    Width,
    Coordinate(Axis),
    /// A length that is the size of nothing, such as a radius, a flatness, a position.
    Length,
    /// Anything else.
    Other,
}

impl Quantity {
    /// Whether it is the size of something: a row of it may be judged by a callout.
    pub const fn is_size(&self) -> bool {
        matches!(self, Self::Size | Self::Diameter | Self::Width)
    }

    /// Whether it is what a plan asks of a feature of a kind.
    pub fn fits(&self, kind: &FeatureKind) -> bool {
        match self {
            Self::Size => true,
            Self::Diameter => matches!(kind, FeatureKind::Diameter(_) | FeatureKind::Length(_)),
            Self::Width => matches!(
                kind,
                FeatureKind::Width(..)
                    | FeatureKind::Pocket(_)
                    | FeatureKind::Boss(_)
                    | FeatureKind::Face(..)
                    | FeatureKind::Length(_)
            ),
            Self::Coordinate(axis) => match kind {
                FeatureKind::Face(_, towards) => towards.axis == *axis,
                kind => matches!(kind, FeatureKind::Length(_)),
            },
            Self::Length => kind.is_by_hand(),
            Self::Other => false,
        }
    }
}
