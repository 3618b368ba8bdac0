//! Cycle 420, measure angle: of an edge against the reference axis, or of a face.
//!
//! It judges nothing. For an edge along the minor axis (Q272 = 1) the angle is read literally, near 90 degrees: whether a control gives
//! that or the angle against the minor axis is on no page. The layout of its log TCHPR420.TXT is not known: none is written.

use super::line_probing::{probe, result, surface, turned};
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, DIRECTION, MEASURED_AXIS, MEASURING_HEIGHT, MEASURING_LOG, MOVE_TO_CLEARANCE, POINT_1, POINT_2,
    SECOND_POINT_1, SECOND_POINT_2, SET_UP_CLEARANCE,
};
use crate::probing::cycle::{Control, Course, Cycle, CycleError, Inputs, Log, Meaning, Measured, Note, Window};
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 420,
    code: "420",
    control: Control::Milling,
    names: &[(En, "MEASURE ANGLE"), (Nl, "METEN HOEK"), (De, "MESSEN WINKEL"), (It, "MISURARE ANGOLO")],
    notes: &[Note::EndsRotation],
    parameters: &[
        POINT_1,
        POINT_2,
        SECOND_POINT_1,
        SECOND_POINT_2,
        MEASURED_AXIS,
        DIRECTION,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT.required(),
        MOVE_TO_CLEARANCE,
        MEASURING_LOG.without_effect().means(Meaning::Choice),
    ],
    surface,
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let contacts = probe(inputs, course)?;
    let turned = turned(inputs, contacts);
    let angle = match inputs.whole(272) {
        1 if turned <= 0.0 => turned + 90.0,
        1 => turned - 90.0,
        _ => turned,
    };
    Ok(Measured { contacts: contacts.to_vec(), results: vec![result(angle)], ..Measured::default() })
}
