//! What cycles that monitor limits share: the check of sizes and centres, the stop, the markers.

use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::{
    Check, CycleError, Inputs, Key, Measured, ResultName, ResultParameter, Stop, Value, nearest,
};
use crate::tolerance::Feature;
use crate::verdict::{AxisPosition, PositionVerdict, Status, classify};

/// A measured size or coordinate against its limits; nothing where it is not monitored.
pub(super) fn size(
    what: ResultName,
    measured: Length,
    limits: Option<(Length, Length)>,
    feature: Feature,
) -> Option<Check> {
    let (minimum, maximum) = limits?;
    Some(Check { what, measured, minimum, maximum, status: classify(Some(feature), minimum, maximum, measured) })
}

/// A centre against its nominal place; a tolerance of zero is not monitored.
pub(super) fn position(centre: [Length; 2], nominal: [Length; 2], tolerances: [Length; 2]) -> PositionVerdict {
    let [centre_1, centre_2] = centre;
    let [nominal_1, nominal_2] = nominal;
    let [tolerance_1, tolerance_2] = tolerances;
    let axis = |measured: Length, nominal, tolerance: Length| AxisPosition {
        deviation: measured.saturating_sub(nominal),
        tolerance: (Length::ZERO < tolerance).then_some(tolerance),
    };
    PositionVerdict { axes: [axis(centre_1, nominal_1, tolerance_1), axis(centre_2, nominal_2, tolerance_2)] }
}

/// A coordinate of a centre against its limits; nothing where it is not monitored. A wrong position cannot be machined away, so it is scrap.
pub(super) fn place(what: ResultName, measured: Length, limits: Option<(Length, Length)>) -> Option<Check> {
    let (minimum, maximum) = limits?;
    let status = if measured < minimum || maximum < measured { Status::Scrap } else { Status::Good };
    Some(Check { what, measured, minimum, maximum, status })
}

/// Each axis of a centre that has a tolerance, as a check of its own.
pub(super) fn centre(centre: [Length; 2], nominal: [Length; 2], position: &PositionVerdict) -> Vec<Check> {
    let names = [ResultName::CENTRE_1, ResultName::CENTRE_2];
    let axes = names.into_iter().zip(centre).zip(nominal.into_iter().zip(position.axes));
    let checks = axes.filter_map(|((what, measured), (nominal, axis))| {
        let tolerance = axis.tolerance?;
        place(what, measured, Some((nominal.saturating_sub(tolerance), nominal.saturating_sub(tolerance.negated()))))
    });
    checks.collect()
}

/// The worst of several values, because exactly one marker is set; `Good` also where nothing was monitored.
fn worst(checks: &[Check]) -> Status {
    checks.iter().map(|check| check.status).max().unwrap_or(Status::Good)
}

/// The result of a cycle that monitors limits: with its markers, and with the stop where Q309 asks for one and a value
/// is out of tolerance.
pub(super) fn measured(
    inputs: &Inputs,
    contacts: Vec<Contact>,
    checks: Vec<Check>,
    mut results: Vec<ResultParameter>,
) -> Measured {
    let status = worst(&checks);
    results.extend(ResultParameter::markers(status));
    let stop = if inputs.whole(309) == 1 { Stop::of(1, &checks) } else { None };
    Measured { contacts, checks, status: Some(status), results, stop, ..Measured::default() }
}

/// Q183: −1 without a tolerance, 0 good, 1 rework, 2 scrap.
pub(super) fn status(status: Option<Status>) -> ResultParameter {
    let number = match status {
        Some(Status::Good) => 0,
        Some(Status::Rework) => 1,
        Some(Status::Scrap) => 2,
        None | Some(Status::ReMeasure | Status::OutOfLimits) => -1,
    };
    ResultParameter { key: Some(Key::Q(183)), name: ResultName::STATUS, value: Value::Whole(number) }
}

/// Whether a nominal size is not between its limits.
pub(super) fn is_outside(nominal: Length, limits: Option<(Length, Length)>) -> bool {
    limits.is_some_and(|(minimum, maximum)| nominal < minimum || maximum < nominal)
}

/// The distance between two opposite walls and the middle between them, rounded to the nearest nanometre.
pub(super) fn between(one: f64, other: f64) -> Result<(Length, Length), CycleError> {
    Ok((nearest((one - other).abs())?, nearest(f64::midpoint(one, other))?))
}
