//! From a fit and a position to a measurement: what the window and the command line ask for.

use super::circle::CircleError;
use super::contact::Prober;
use super::cycle::{Angle, CycleError, Inputs, Value};
use super::cycles::cycle;
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

/// The number of the cycle that program 82551 calls: 421 for a hole (LBL 14), 422 for a shaft (LBL 15).
pub const fn cycle_number(feature: Feature) -> u16 {
    match feature {
        Feature::Hole => 421,
        Feature::Shaft => 422,
    }
}

/// Measures a feature with the cycle for it, as LBL 14 and LBL 15 of program 82551 do: four contacts at 90 degrees.
///
/// # Errors
/// [`CycleError`] for a parameter out of range, a missed contact, or contacts that make no circle.
pub fn measure(
    limits: &Limits,
    position: &ProbePosition,
    prober: &mut dyn Prober,
    origin: Origin,
) -> Result<(Measurement, PositionVerdict), CycleError> {
    let number = cycle_number(limits.feature);
    let (maximum, minimum) = match limits.feature {
        Feature::Hole => (275, 276),
        Feature::Shaft => (277, 278),
    };
    let [x, y] = position.centre;
    // The program sets no longest path: the probe goes on until it meets something.
    let probe = TouchProbe { longest_path: Length::MAX, ..TouchProbe::default() };
    let inputs = Inputs::new()
        .with_probe(probe)
        .with(273, Value::Length(x))
        .with(274, Value::Length(y))
        .with(262, Value::Length(limits.nominal))
        .with(325, Value::Angle(position.first_angle))
        .with(261, Value::Length(position.height))
        .with(320, Value::Length(position.clearance))
        .with(maximum, Value::Length(limits.maximum()))
        .with(minimum, Value::Length(limits.minimum()))
        .with(279, Value::Length(position.centre_tolerance))
        .with(280, Value::Length(position.centre_tolerance));
    let unknown = || CycleError::NoSuchParameter { cycle: "", parameter: number.to_string(), known: String::new() };
    let result = cycle(number).ok_or_else(unknown)?.measure(&inputs, prober)?;
    // Both cycles measure a circle.
    let found = result.circle.ok_or(CircleError::TooFew { contacts: 0 })?;
    let measurement = Measurement::of_circle(found.circle, result.contacts, origin)?;
    Ok((measurement, found.position))
}
