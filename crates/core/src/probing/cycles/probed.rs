//! How milling cycles probe: the clearance before a surface, the point where the ball met the surface, and along which axis.

use crate::probing::contact::{Contact, Touch};
use crate::probing::cycle::{Axis, Course, CycleError, Inputs};
use crate::probing::vector::along;

/// The set-up clearance, mm: Q320 plus that of the probe.
pub(super) fn clearance(inputs: &Inputs) -> f64 {
    inputs.mm(320) + inputs.probe().set_up.to_mm_f64()
}

/// A probing from a place, as far as the probe's longest path.
pub(super) fn probing(inputs: &Inputs, from: [f64; 3], direction: [f64; 3]) -> Touch {
    Touch { from, direction, longest: inputs.probe().longest_path.to_mm_f64() }
}

/// Probes and moves back: the point where the ball met the surface.
pub(super) fn met(touch: &Touch, course: &mut Course<'_>) -> Result<Contact, CycleError> {
    let ball = course.touch(touch)?;
    course.retract(touch.from);
    Ok(Contact::at(along(ball.place(), touch.direction, course.ball_radius())))
}

/// Probes towards a point from the clearance before it, coming from above: the point where the ball met the surface.
pub(super) fn met_at(
    point: [f64; 3],
    direction: [f64; 3],
    inputs: &Inputs,
    course: &mut Course<'_>,
) -> Result<Contact, CycleError> {
    let before = clearance(inputs) + course.ball_radius();
    let touch = probing(inputs, along(point, direction, -before), direction);
    course.pre_position_from_above(touch.from, inputs.mm(260));
    met(&touch, course)
}

/// The measured axis (Q272).
pub(super) fn axis(inputs: &Inputs) -> Axis {
    match inputs.whole(272) {
        1 => Axis::First,
        2 => Axis::Second,
        _ => Axis::Third,
    }
}

/// The coordinate of a contact in that axis.
pub(super) fn coordinate(contact: &Contact, inputs: &Inputs) -> f64 {
    match axis(inputs) {
        Axis::First => contact.x,
        Axis::Second => contact.y,
        Axis::Third => contact.z,
    }
}

/// The programmed point of a cycle that probes along one axis.
pub(super) fn point(inputs: &Inputs) -> [f64; 3] {
    [inputs.mm(263), inputs.mm(264), inputs.mm(261)]
}

/// The unit vector of its approach, along the measured axis as Q267 says.
pub(super) fn approach(inputs: &Inputs) -> [f64; 3] {
    let sign = if inputs.whole(267) < 0 { -1.0 } else { 1.0 };
    [1, 2, 3].map(|axis| if inputs.whole(272) == axis { sign } else { 0.0 })
}
