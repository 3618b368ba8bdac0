//! Circle evaluation by every criterion, from contacts in the plane.
//!
//! | file | what |
//! |---|---|
//! | `frame` | contacts translated to their centre; too few, coinciding, collinear, not finite |
//! | `least_squares` | the circle with the least sum of squared radial deviations: diameter and centre of the cycles |
//! | `circumscribed` | the smallest circle around all contacts |
//! | `hull`, `cell` | convex hull; a cell of a Voronoi diagram, by clipping |
//! | `inscribed` | the largest empty circle that the contacts surround |
//! | `zone` | the narrowest ring: roundness |
//! | `two_point` | diameters between opposed contacts |
//! | `uncertainty` | how much of a touch's scatter goes into diameter and centre |
//! | `warning` | what the contacts cannot tell |
//!
//! Everything here is `f64` millimetres and nothing is rounded; a result becomes a [`crate::length::Length`] once, in
//! [`super::measurement`]. Heights (`z`) are not looked at. Limits and verdicts are elsewhere.

mod frame;
mod least_squares;

use super::contact::Contact;
pub use frame::CircleError;
use frame::Frame;

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

/// The geometric least-squares circle through contacts.
///
/// ```
/// use fitcheck::probing::Contact;
/// use fitcheck::probing::circle::least_squares;
///
/// let contacts = [(62.5, 50.0), (50.0, 62.5), (37.5, 50.0), (50.0, 37.5)].map(|(x, y)| Contact { x, y, z: -5.0 });
/// let circle = least_squares(&contacts)?;
/// assert!((circle.diameter - 25.0).abs() < 1e-12);
/// # Ok::<(), fitcheck::probing::circle::CircleError>(())
/// ```
pub fn least_squares(contacts: &[Contact]) -> Result<Circle, CircleError> {
    let frame = Frame::new(contacts)?;
    let fit = least_squares::fit(frame.points()).ok_or(CircleError::Straight { contacts: contacts.len() })?;
    Ok(frame.circle(fit.centre, fit.radius))
}

/// The arc in degrees that contacts cover, seen from a circle's centre: 360 less the largest gap.
///
/// No contact, or one only, covers no arc.
pub fn arc_deg(contacts: &[Contact], circle: &Circle) -> f64 {
    let points: Vec<_> = contacts.iter().map(|contact| [contact.x - circle.x, contact.y - circle.y]).collect();
    360.0 - Angles::new(&points, [0.0, 0.0]).largest_gap_deg
}

/// Directions of points about a centre.
struct Angles {
    largest_gap_deg: f64,
}

impl Angles {
    fn new(points: &[[f64; 2]], centre: [f64; 2]) -> Self {
        let [centre_x, centre_y] = centre;
        let mut angles: Vec<f64> =
            points.iter().map(|&[x, y]| (y - centre_y).atan2(x - centre_x).to_degrees()).collect();
        angles.sort_by(f64::total_cmp);
        let within = angles.windows(2).fold(0.0, |gap: f64, pair| match pair {
            &[before, after] => gap.max(after - before),
            _ => gap,
        });
        let across = match (angles.first(), angles.last()) {
            (Some(first), Some(last)) => 360.0 - (last - first),
            _ => 360.0,
        };
        Self { largest_gap_deg: within.max(across) }
    }
}
