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
//! | `uncertainty` | how much a contact's scatter affects diameter and centre |
//! | `warning` | what the contacts cannot tell |
//!
//! Everything here is in `f64` millimetres and nothing is rounded; a result becomes a [`crate::length::Length`] once,
//! in [`super::measurement`]. Heights (`z`) are not used. Limits and verdicts are elsewhere.

mod cell;
mod circumscribed;
mod frame;
mod hull;
mod inscribed;
mod least_squares;
mod two_point;
mod uncertainty;
mod warning;
mod zone;

use super::contact::Contact;
pub use frame::{CircleError, TooLarge};
use frame::{Frame, count_f64};
pub use two_point::TwoPoint;
pub use uncertainty::Uncertainty;
pub use warning::CircleWarning;
pub(in crate::probing) use warning::heights;
pub use zone::Zone;

/// A circle in millimetres.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Circle {
    /// Centre, reference axis.
    pub x: f64,
    /// Centre, minor axis.
    pub y: f64,
    /// Diameter.
    pub diameter: f64,
}

/// The most contacts for which the maximum inscribed circle and the minimum zone are searched for: the search visits
/// every pair of contacts. For more contacts both are left out, with [`CircleWarning::TooManyContacts`].
pub const MOST_FOR_ZONE: usize = 3_000;

/// Everything that contacts say about a circle. Lengths in millimetres.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation {
    /// Gaussian circle, ISO 14405-1 (GG): what the cycles report.
    pub least_squares: Circle,
    /// Radial deviation of each contact from [`Self::least_squares`], outwards positive, in the order of the contacts.
    pub residuals: Vec<f64>,
    /// Minimum circumscribed circle, ISO 14405-1 (GN).
    pub minimum_circumscribed: Circle,
    /// Maximum inscribed circle, ISO 14405-1 (GX); `None` where the contacts do not surround one.
    pub maximum_inscribed: Option<Circle>,
    /// Minimum zone (GC): the ring of least width that holds all contacts.
    pub minimum_zone: Option<Zone>,
    /// Two-point sizes (LP) where contacts are opposite each other.
    pub two_point: Vec<TwoPoint>,
    /// The arc in degrees that the contacts cover: 360 minus [`Self::largest_gap_deg`].
    pub arc_deg: f64,
    /// The largest angle in degrees without a contact, seen from the least-squares centre.
    pub largest_gap_deg: f64,
    /// How the scatter of the contacts affects diameter and centre.
    pub uncertainty: Uncertainty,
    /// What the contacts cannot tell, and what is suspicious.
    pub warnings: Vec<CircleWarning>,
}

impl Evaluation {
    /// Spread of the residuals of the least-squares circle: largest minus smallest. Zero for three contacts, whatever
    /// the form of the workpiece.
    pub fn form(&self) -> f64 {
        let (least, most) = spread(self.residuals.iter().copied());
        most - least
    }

    /// Root mean square of the residuals.
    pub fn residual_rms(&self) -> f64 {
        let squares: f64 = self.residuals.iter().map(|residual| residual * residual).sum();
        (squares / count_f64(self.residuals.len())).sqrt()
    }
}

/// Smallest and largest of some numbers.
fn spread(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), number| (least.min(number), most.max(number)))
}

/// The geometric least-squares circle through contacts.
///
/// ```
/// use fitcheck_core::probing::Contact;
/// use fitcheck_core::probing::circle::least_squares;
///
/// let contacts = [(62.5, 50.0), (50.0, 62.5), (37.5, 50.0), (50.0, 37.5)].map(|(x, y)| Contact { x, y, z: -5.0 });
/// let circle = least_squares(&contacts)?;
/// assert!((circle.diameter - 25.0).abs() < 1e-12);
/// # Ok::<(), fitcheck_core::probing::circle::CircleError>(())
/// ```
pub fn least_squares(contacts: &[Contact]) -> Result<Circle, CircleError> {
    let frame = Frame::new(contacts)?;
    let fit = least_squares::fit(frame.points()).ok_or(CircleError::Straight { contacts: contacts.len() })?;
    Ok(frame.circle(fit.centre, fit.radius))
}

/// Evaluates contacts by every criterion.
///
/// The answer does not depend on the order of the contacts: they are sorted before anything is summed.
pub fn evaluate(contacts: &[Contact]) -> Result<Evaluation, CircleError> {
    let frame = Frame::new(contacts)?;
    let points = frame.points();
    let fit = least_squares::fit(points).ok_or(CircleError::Straight { contacts: contacts.len() })?;
    let largest_gap_deg = largest_gap_deg(points, fit.centre);
    let few = points.len() <= MOST_FOR_ZONE;
    let (circumscribed_centre, circumscribed_radius) = circumscribed::smallest(points);
    let hull = hull::convex(points);
    let inscribed = if few { inscribed::largest(points, &hull) } else { None };
    let zone = if few { zone::narrowest(points, &hull, fit.centre) } else { None };
    let mut evaluation = Evaluation {
        least_squares: frame.circle(fit.centre, fit.radius),
        residuals: contacts.iter().map(|contact| frame.length(fit.residual(frame.place(contact)))).collect(),
        minimum_circumscribed: frame.circle(circumscribed_centre, circumscribed_radius),
        maximum_inscribed: inscribed.map(|(centre, radius)| frame.circle(centre, radius)),
        minimum_zone: zone.map(|ring| Zone::new(&frame, ring)),
        two_point: two_point::opposed(contacts, &frame, fit.centre),
        arc_deg: 360.0 - largest_gap_deg,
        largest_gap_deg,
        uncertainty: Uncertainty::of(points, fit.centre),
        warnings: Vec::new(),
    };
    evaluation.warnings = warning::all(&evaluation, contacts, frame.repeated());
    Ok(evaluation)
}

/// Two-point sizes (LP) where contacts are opposite each other, seen from a circle's centre; none where they make no circle.
pub fn two_point(contacts: &[Contact], circle: &Circle) -> Vec<TwoPoint> {
    let Ok(frame) = Frame::new(contacts) else { return Vec::new() };
    let centre = frame.place(&Contact { x: circle.x, y: circle.y, z: 0.0 });
    two_point::opposed(contacts, &frame, centre)
}

/// The arc in degrees that contacts cover, seen from a circle's centre: 360 minus the largest gap.
///
/// A single contact covers no arc, nor does an empty list.
pub fn arc_deg(contacts: &[Contact], circle: &Circle) -> f64 {
    let points: Vec<_> = contacts.iter().map(|contact| [contact.x - circle.x, contact.y - circle.y]).collect();
    360.0 - largest_gap_deg(&points, [0.0, 0.0])
}

/// The largest angle in degrees between the directions of neighbouring points, seen from a centre.
fn largest_gap_deg(points: &[[f64; 2]], [centre_x, centre_y]: [f64; 2]) -> f64 {
    let mut angles: Vec<f64> =
        points.iter().map(|&[x, y]| libm::atan2(y - centre_y, x - centre_x).to_degrees()).collect();
    angles.sort_by(f64::total_cmp);
    let within =
        angles.iter().zip(angles.iter().skip(1)).fold(0.0, |gap: f64, (before, after)| gap.max(after - before));
    let across = angles.first().zip(angles.last()).map_or(360.0, |(first, last)| 360.0 - (last - first));
    within.max(across)
}
