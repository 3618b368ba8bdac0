//! What cycles 412 and 413 share: the centre of a hole or stud becomes the datum.
//!
//! Course and evaluation as in 421 and 422, which have the same parameters. The nominal diameter is rather too small for a hole and rather
//! too large for a stud, so that the ball meets the wall within its path.

use super::circle_probing::{COUNT, Circle, DIAMETER, FIRST_ANGLE, STEP, TRAVERSE};
use super::datum_cycle::{
    CLEARANCE, FIRST, NEW_1, NEW_2, NEW_3, ROW, SECOND, TOP, TOP_1, TOP_2, TOP_3, TRANSFER, axis, set, target,
};
use super::round;
use crate::length::Length;
use crate::probing::cycle::shared::{MEASURING_HEIGHT, MOVE_TO_CLEARANCE, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Course, CycleError, Inputs, Measured, Parameter, Plane, ResultName, ResultParameter,
};
use crate::tolerance::Feature;

/// The declaration, in the order of NC programs.
pub(super) const PARAMETERS: [Parameter; 20] = [
    FIRST,
    SECOND,
    DIAMETER,
    FIRST_ANGLE.required(),
    STEP.required(),
    MEASURING_HEIGHT,
    SET_UP_CLEARANCE,
    CLEARANCE,
    MOVE_TO_CLEARANCE,
    ROW,
    NEW_1,
    NEW_2,
    TRANSFER,
    TOP,
    TOP_1,
    TOP_2,
    TOP_3,
    NEW_3,
    COUNT,
    TRAVERSE,
];

/// What is probed.
pub(super) const fn circle(feature: Feature) -> Circle {
    Circle { feature, centre: [321, 322] }
}

/// Runs either cycle on checked inputs.
pub(super) fn run(feature: Feature, inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let target = target(inputs)?;
    let circle = circle(feature);
    let contacts = circle.probe(inputs, course)?;
    let ball_radius = course.ball_radius();
    let (contacts, found) =
        round::found(contacts, feature, Plane::Xy, ball_radius, circle.nominal(inputs), [Length::ZERO; 2])?;
    let [centre_1, centre_2] = found.centre;
    let results = vec![
        ResultParameter::length(151, ResultName::CENTRE_1, centre_1),
        ResultParameter::length(152, ResultName::CENTRE_2, centre_2),
        ResultParameter::length(153, ResultName::DIAMETER, found.diameter),
    ];
    let axes = vec![axis(Axis::First, centre_1, inputs, NEW_1.key), axis(Axis::Second, centre_2, inputs, NEW_2.key)];
    let measured = set(target, (contacts, results, axes), inputs, course)?;
    Ok(Measured { circle: Some(found), ..measured })
}
