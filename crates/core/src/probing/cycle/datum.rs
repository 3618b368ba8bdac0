//! The datum that a cycle sets: which coordinates the measured place gets, and where that is written; and how it turns the system.

use super::meaning::Axis;
use crate::length::Length;
use crate::message::{Arg, Say, as_text};

/// What a cycle makes of the place that it has measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewDatum {
    /// Where it goes.
    pub target: DatumTarget,
    /// The axes that change; the others stay.
    pub axes: Vec<DatumAxis>,
}

/// One axis of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DatumAxis {
    /// The axis of the cycle: reference, minor or probe axis.
    pub axis: Axis,
    /// Where the place is.
    pub measured: Length,
    /// The coordinate that it gets.
    pub wanted: Length,
}

/// How a cycle turns the system, or the part in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewRotation {
    /// Degrees about the probe axis, plus from the first axis to the second.
    pub degrees: f64,
    /// What turns.
    pub by: TurnedBy,
}

/// What a cycle turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TurnedBy {
    /// The system, about the active datum: a basic rotation, which goes to the display or into a row.
    Rotation(DatumTarget),
    /// The part, with a rotary axis.
    Axis {
        /// The axis.
        axis: RotaryAxis,
        /// Whether the place that it comes to is its new zero.
        is_zeroed: bool,
    },
}

/// A rotary axis of a machine: about X, Y and Z.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotaryAxis {
    /// About X.
    A,
    /// About Y.
    B,
    /// About Z.
    C,
}

impl std::fmt::Display for RotaryAxis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
        })
    }
}

as_text!(RotaryAxis);

/// Where a datum goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "datum-target")]
pub enum DatumTarget {
    /// It is active at once.
    Display,
    /// The active preset is corrected at once.
    Active,
    /// A row of the preset table.
    Preset {
        /// The row.
        row: u32,
    },
    /// A row of the active datum table.
    Table {
        /// The row.
        row: u32,
    },
}

impl NewDatum {
    /// The measured and the wanted coordinate of each axis; the names are those with the tool axis Z.
    pub(super) fn listed(&self) -> Arg {
        let axis = |DatumAxis { axis, measured, wanted }: &DatumAxis| {
            let name = match axis {
                Axis::First => "X",
                Axis::Second => "Y",
                Axis::Third => "Z",
            };
            format!("{name} {measured} → {wanted}")
        };
        Arg::Number(self.axes.iter().map(axis).collect::<Vec<_>>().join(", "))
    }
}
