//! What cycles 410 and 411 share: the centre of a pocket or boss becomes the datum.
//!
//! Course and evaluation as in 423 and 424. Which wall comes first is on no page; it does not change the result.

use super::datum_cycle::{
    CLEARANCE, FIRST, NEW_1, NEW_2, NEW_3, ROW, SECOND, TOP, TOP_1, TOP_2, TOP_3, TRANSFER, axis, set, target,
};
use super::rectangle_cycle::{SIDE_1, SIDE_2};
use super::walls_probing::{About, Rectangle, sides};
use crate::probing::cycle::shared::{MEASURING_HEIGHT, MOVE_TO_CLEARANCE, SET_UP_CLEARANCE};
use crate::probing::cycle::{Axis, Course, CycleError, Inputs, Measured, Parameter, ResultName, ResultParameter};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

/// The declaration, in the order of NC programs.
pub(super) const PARAMETERS: [Parameter; 17] = [
    FIRST,
    SECOND,
    SIDE_1.at(323).asked(&[
        (En, "1st side length?"),
        (Nl, "Lengte 1e zijde?"),
        (De, "1. Seiten-Länge?"),
        (It, "Lunghezza 1. lato?"),
    ]),
    SIDE_2.at(324).asked(&[
        (En, "2nd side length?"),
        (Nl, "Lengte 2e zijde?"),
        (De, "2. Seiten-Länge?"),
        (It, "Lunghezza 2. lato?"),
    ]),
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
];

/// What is probed.
pub(super) const fn rectangle(feature: Feature) -> Rectangle {
    Rectangle { about: About { feature, centre: [321, 322] }, sides: [323, 324] }
}

/// Runs either cycle on checked inputs.
pub(super) fn run(feature: Feature, inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let target = target(inputs)?;
    let contacts = rectangle(feature).probe(inputs, course)?;
    let [(side_1, centre_1), (side_2, centre_2)] = sides(&contacts)?;
    let results = vec![
        ResultParameter::length(151, ResultName::CENTRE_1, centre_1),
        ResultParameter::length(152, ResultName::CENTRE_2, centre_2),
        ResultParameter::length(154, ResultName::SIDE_1, side_1),
        ResultParameter::length(155, ResultName::SIDE_2, side_2),
    ];
    let axes = vec![axis(Axis::First, centre_1, inputs, NEW_1.key), axis(Axis::Second, centre_2, inputs, NEW_2.key)];
    set(target, (contacts, results, axes), inputs, course)
}
