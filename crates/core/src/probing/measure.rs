//! From limits and a position to a measurement, as the window and the command line need it.

use super::circle::CircleError;
use super::contact::Prober;
use super::cycle::{Angle, Axis, CycleError, Inputs, Meaning, Value};
use super::cycles::measuring;
use super::measurement::{Measurement, Origin};
use super::touch_probe::TouchProbe;
use crate::length::Length;
use crate::tolerance::{Feature, Limits};
use crate::verdict::PositionVerdict;

/// The probe position of NC-Solution 8255 (7/2020).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ProbePosition {
    /// Nominal centre in reference and minor axis (Q11, Q21).
    pub centre: [Length; 2],
    /// Measuring height (Q31).
    pub height: Length,
    /// Angle of the first contact (Q41).
    pub first_angle: Angle,
    /// Set-up clearance (Q51), added to the probe's own.
    pub clearance: Length,
    /// Permitted deviation of the centre either way, the same in both axes; zero is not monitored.
    pub centre_tolerance: Length,
}

/// The number of the cycle that program 82551 calls: that for a hole (LBL 14), or that for a shaft (LBL 15).
pub const fn cycle_number(feature: Feature) -> u16 {
    measuring(feature).number
}

/// Measures a feature with the cycle for it, as LBL 14 and LBL 15 of program 82551 do: four contacts at 90 degrees.
///
/// # Errors
/// [`CycleError`] for a parameter out of range, a missed contact, or contacts that do not make a circle.
pub fn measure(
    feature: Feature,
    limits: &Limits,
    position: &ProbePosition,
    prober: &mut dyn Prober,
    origin: Origin,
) -> Result<(Measurement, PositionVerdict), CycleError> {
    let cycle = measuring(feature);
    let [x, y] = position.centre;
    // The program sets no longest path: the probe moves until it meets something.
    let probe = TouchProbe { longest_path: Length::MAX, ..TouchProbe::default() };
    let given = [
        (Meaning::Centre(Axis::First), Value::Length(x)),
        (Meaning::Centre(Axis::Second), Value::Length(y)),
        (Meaning::Diameter, Value::Length(limits.nominal)),
        (Meaning::FirstAngle, Value::Angle(position.first_angle)),
        (Meaning::MeasuringHeight, Value::Length(position.height)),
        (Meaning::SetUpClearance, Value::Length(position.clearance)),
        (Meaning::MaximumDiameter, Value::Length(limits.maximum())),
        (Meaning::MinimumDiameter, Value::Length(limits.minimum())),
        (Meaning::CentreTolerance(Axis::First), Value::Length(position.centre_tolerance)),
        (Meaning::CentreTolerance(Axis::Second), Value::Length(position.centre_tolerance)),
    ];
    let given = given.into_iter().filter_map(|(meaning, value)| Some((cycle.meant(meaning)?.key, value)));
    let inputs = given.fold(Inputs::new().with_probe(probe), |inputs, (key, value)| inputs.with(key, value));
    let result = cycle.measure(&inputs, prober)?;
    // Both cycles measure a circle.
    let found = result.circle.ok_or(CircleError::TooFew { contacts: 0 })?;
    let measurement = Measurement::of_circle(found.circle, result.contacts, origin)?;
    Ok((measurement, found.position))
}
