//! Cycle 1400, position probing: one contact along one axis, at a nominal point with its tolerance.
//!
//! Where material is left in front of the wanted face it is rework, where too much is gone it is scrap: the direction of the probing says
//! which is which. That is ours; nothing is known of the control.

use super::edge_probing::{DIRECTION, Point, approach, axis};
use super::nominal_cycle::{CLEARANCE_MODE, Findings, POINT_1, POINT_2, POINT_3, PRESET, REACTION, leave, ways};
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{Axis, Control, Course, Cycle, CycleError, Inputs, Log, Measured, ResultName, Window};
use crate::probing::simulated::{Face, Surface};
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 1400,
    code: "1400",
    control: Control::Milling,
    names: &[(En, "POSITION PROBING"), (Nl, "TASTEN POSITIE"), (De, "ANTASTEN POSITION"), (It, "TASTATURA POSIZIONE")],
    notes: &[],
    parameters: &[
        POINT_1,
        POINT_2,
        POINT_3,
        DIRECTION,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        CLEARANCE_MODE,
        REACTION,
        PRESET,
    ],
    surface: |inputs| Surface::Face(Face::plane(POINT.target(inputs), approach(inputs).map(|part| -part))),
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// The point, Q950 to Q952, and its deviations from Q980 on.
const POINT: Point = Point {
    of: [POINT_1, POINT_2, POINT_3],
    results: [950, 980],
    names: [ResultName::POSITION_1, ResultName::POSITION_2, ResultName::POSITION_3],
    deviations: [ResultName::DEVIATION_1, ResultName::DEVIATION_2, ResultName::DEVIATION_3],
};

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    POINT.check(inputs)?;
    if axis(inputs) == Axis::Third {
        course.needs_heights()?;
    }
    let [way, _] = ways(inputs);
    let contact = POINT.probe(way, inputs, course)?;
    leave(inputs, course);
    let mut findings = Findings::default();
    let measured = POINT.add(&contact, inputs, &mut findings)?;
    findings.correct(axis(inputs), POINT.nominal(inputs), measured);
    Ok(findings.measured(inputs, vec![contact]))
}
