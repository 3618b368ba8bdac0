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
    /// A shift that was made in a tilted plane which has ended since.
    TiltedShift,
    /// The part, turned by a rotary axis whose centre only the machine knows: until both axes of the plane have a new datum.
    AxisTurned,
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

/// Cycles of `TCH PROBE` that set no datum and no rotation: one point, angles, calibration, tools, bolt circles, planes, fast probing
/// (datum-cycles, sections 5 and 6).
fn sets_no_datum(number: u32) -> bool {
    matches!(number, 0..=4 | 9 | 30..=33 | 430 | 431 | 441 | 460..=463 | 480..=484 | 580..=589)
}

/// Whether a cycle that is not run may have set a datum: nothing is measured after it.
pub(super) fn may_set_datum(cycle: &str) -> bool {
    !cycle_number(cycle).is_some_and(sets_no_datum)
}

/// The number before the point of a block of several cycles.
pub(super) fn cycle_number(cycle: &str) -> Option<u32> {
    cycle.split('.').next().and_then(|number| number.parse().ok())
}
