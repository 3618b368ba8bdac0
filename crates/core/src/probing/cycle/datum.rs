//! The datum that a cycle sets: which coordinates the measured place gets, and where that is written.

use super::meaning::Axis;
use crate::length::Length;
use crate::message::{Arg, Say};

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
