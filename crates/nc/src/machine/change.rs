//! Changes of the system of coordinates under which nothing is measured here.

use fitcheck_core::message::Say;

/// A change of the system under which nothing is measured here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Say)]
#[say(prefix = "machine-change")]
pub enum Change {
    /// Whatever a block has made of it that was not run.
    NotKnown,
    /// A row of a datum table, which only the control has.
    DatumTable,
    /// Cycle 10.
    Rotation,
    /// Cycle 8.
    Mirror,
    /// Cycle 11.
    Scaling,
    /// Cycle 26.
    AxisScaling,
    /// PLANE, cycle 19.
    Tilt,
    /// Cycle 800, until cycle 801.
    Turning,
}
