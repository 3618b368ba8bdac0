//! How a workpiece grows with its temperature.

/// Steel, millionths per kelvin.
pub(super) const STEEL: f64 = 11.5;

/// The temperature that sizes refer to (ISO 1), °C.
pub(super) const REFERENCE: f64 = 20.0;

/// By which factor a workpiece of this temperature and expansion is larger than at 20 °C.
pub(super) fn growth(temperature: f64, expansion: f64) -> f64 {
    1.0 + expansion * 1e-6 * (temperature - REFERENCE)
}
