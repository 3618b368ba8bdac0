//! What 400, 403 and 420 share: two contacts on a straight edge or on a face, and the angle of the line through them.
//!
//! Order and names of the parameters as in public post-processors; Q150 is remembered, and so are the signs (`docs/SOURCES.md`, "Angle
//! and rotation"). The ball's radius is the same at both contacts: the angle does not depend on it.

use super::probed::{approach, clearance, met, met_at, probing};
use crate::probing::contact::Contact;
use crate::probing::cycle::{Angle, Course, CycleError, Inputs, Key, ResultName, ResultParameter};
use crate::probing::simulated::{Face, Surface};
use crate::probing::vector::along;

/// The two points, at measuring height.
fn points(inputs: &Inputs) -> [[f64; 3]; 2] {
    [[263, 264], [265, 266]].map(|[first, second]: [u16; 2]| [inputs.mm(first), inputs.mm(second), inputs.mm(261)])
}

/// How far the second contact lies from the first: along the line in the plane, and along the measured axis.
fn across(inputs: &Inputs, [[x1, y1, z1], [x2, y2, z2]]: [[f64; 3]; 2]) -> (f64, f64) {
    match inputs.whole(272) {
        1 => (y2 - y1, x2 - x1),
        2 => (x2 - x1, y2 - y1),
        _ if is_about_first(inputs) => (y2 - y1, z2 - z1),
        _ => (x2 - x1, z2 - z1),
    }
}

/// Whether the line on a face runs along the second axis: its angle is then one about the first.
fn is_about_first(inputs: &Inputs) -> bool {
    inputs.length(263) == inputs.length(265)
}

/// The edge or face in which nothing is turned: through both points.
pub(super) fn surface(inputs: &Inputs) -> Surface {
    let places = points(inputs);
    let [from, [x2, y2, _]] = places;
    let [x1, y1, _] = from;
    let [to_x, to_y, to_z] = approach(inputs);
    let normal = if inputs.whole(272) == 3 {
        [0.0, 0.0, -to_z]
    } else {
        // At a right angle to the line, against the approach.
        let [line_x, line_y] = [x2 - x1, y2 - y1];
        let sign = if 0.0 < to_x * line_y - to_y * line_x { -1.0 } else { 1.0 };
        [sign * line_y, -sign * line_x, 0.0]
    };
    let is_line = normal.iter().any(|part| 0.0 < part.abs());
    Surface::Face(Face::plane(from, if is_line { normal } else { [-to_x, -to_y, -to_z] }))
}

/// Both contacts: the way between them is at measuring height, or over the clearance height (Q301).
///
/// # Errors
/// [`CycleError::NoEdge`] where the points have one place on the line.
pub(super) fn probe(inputs: &Inputs, course: &mut Course<'_>) -> Result<[Contact; 2], CycleError> {
    let [first, second] = points(inputs);
    if across(inputs, [first, second]).0.abs() <= 0.0 {
        let [first, second] = if inputs.whole(272) == 1 { [264, 266] } else { [263, 265] };
        return Err(CycleError::NoEdge { first: Key::Q(first), second: Key::Q(second) });
    }
    if inputs.whole(272) == 3 {
        course.needs_heights()?;
    }
    let one = met_at(first, approach(inputs), inputs, course)?;
    let other = if inputs.whole(301) == 1 {
        met_at(second, approach(inputs), inputs, course)?
    } else {
        let before = clearance(inputs) + course.ball_radius();
        let touch = probing(inputs, along(second, approach(inputs), -before), approach(inputs));
        course.pre_position(touch.from);
        met(&touch, course)?
    };
    course.leave(inputs.mm(260));
    Ok([one, other])
}

/// The angle of the line against its axis, degrees: the second axis of the plane where the first is measured, else the first; on a face
/// the angle about the first axis or about the second.
pub(super) fn turned(inputs: &Inputs, contacts: [Contact; 2]) -> f64 {
    let (along, off) = across(inputs, contacts.map(|contact| contact.place()));
    let rise = libm::atan(off / along).to_degrees();
    // A line along the second axis that leans to plus has turned clockwise; one that rises along the first has turned backwards about
    // the second.
    let is_backwards = inputs.whole(272) == 1 || inputs.whole(272) == 3 && !is_about_first(inputs);
    if is_backwards { -rise } else { rise }
}

/// The angle as Q150 has it, degrees.
pub(super) fn result(degrees: f64) -> ResultParameter {
    ResultParameter::angle(150, ResultName::ANGLE, Angle::nearest(degrees))
}
