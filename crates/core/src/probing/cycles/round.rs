//! The circle through contacts, for every cycle that measures one.
//!
//! The circle goes through the ball's centres and is then widened or narrowed by the ball: this takes the ball's radius
//! into account exactly, wherever the circle lies. How the control itself fits a circle to contacts is not published;
//! geometric least squares is our choice.

use super::judged;
use crate::length::Length;
use crate::probing::circle::{Circle, least_squares};
use crate::probing::contact::Contact;
use crate::probing::cycle::{CircleFound, CycleError, Plane};
use crate::tolerance::Feature;

/// The points of the surface and the circle through them, in whole nanometres, against a nominal centre; a tolerance of
/// zero is not monitored. Contacts and points are in X, Y, Z.
pub(super) fn found(
    contacts: Vec<Contact>,
    feature: Feature,
    plane: Plane,
    ball_radius: f64,
    nominal: [Length; 2],
    tolerances: [Length; 2],
) -> Result<(Vec<Contact>, CircleFound), CycleError> {
    let (contacts, circle) = fit(contacts, feature, plane, ball_radius)?;
    let nearest = |mm: f64| Length::from_mm_f64(mm).map_err(CycleError::TooLarge);
    let centre = [nearest(circle.x)?, nearest(circle.y)?];
    let diameter = nearest(circle.diameter)?;
    let position = judged::position(centre, nominal, tolerances);
    Ok((contacts, CircleFound { plane, circle, centre, diameter, position }))
}

/// The points of the surface and the circle through them, unrounded.
fn fit(
    contacts: Vec<Contact>,
    feature: Feature,
    plane: Plane,
    ball_radius: f64,
) -> Result<(Vec<Contact>, Circle), CycleError> {
    let in_plane: Vec<_> = contacts.iter().map(|contact| Contact::at(plane.within(contact.place()))).collect();
    let circle = least_squares(&in_plane)?;
    if ball_radius <= 0.0 {
        return Ok((contacts, circle));
    }
    let outward = match feature {
        Feature::Hole => ball_radius,
        Feature::Shaft => -ball_radius,
    };
    let on_surface = |contact: &Contact| {
        let off_x = contact.x - circle.x;
        let off_y = contact.y - circle.y;
        // Three contacts of one circle are never all at its centre; a contact that is there stays there.
        let distance = libm::hypot(off_x, off_y);
        let share = if distance <= 0.0 { 0.0 } else { outward / distance };
        Contact::at(plane.place([contact.x + off_x * share, contact.y + off_y * share, contact.z]))
    };
    let contacts = in_plane.iter().map(on_surface).collect();
    Ok((contacts, Circle { diameter: circle.diameter + 2.0 * outward, ..circle }))
}
