//! Cycle 417, datum in the probe axis: one contact downwards, at the programmed point.
//!
//! The probe's length is compensated, so the surface itself gets the coordinate. Q160 is remembered.

use super::datum_cycle::{CLEARANCE, NEW_COORDINATE, ROW, TRANSFER, axis, set, target};
use super::probed::met_at;
use crate::probing::cycle::shared::{POINT_1, POINT_2, POINT_3, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Log, Measured, Note, ResultName, ResultParameter, Window, nearest,
};
use crate::probing::simulated::{Face, Surface};
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 417,
    code: "417",
    control: Control::Milling,
    names: &[(En, "DATUM IN TS AXIS"), (Nl, "REF.PT TS-AS"), (De, "BZPKT TS-ACHSE"), (It, "ORIGINE ASSE TS")],
    notes: &[Note::Recommended { cycle: "1400" }],
    parameters: &[POINT_1, POINT_2, POINT_3, SET_UP_CLEARANCE, CLEARANCE, ROW, NEW_COORDINATE, TRANSFER],
    surface: |inputs| Surface::Face(Face::plane(point(inputs), [0.0, 0.0, 1.0])),
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// The programmed point.
fn point(inputs: &Inputs) -> [f64; 3] {
    [inputs.mm(263), inputs.mm(264), inputs.mm(294)]
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let target = target(inputs)?;
    course.needs_heights()?;
    let contact = met_at(point(inputs), [0.0, 0.0, -1.0], inputs, course)?;
    course.leave(inputs.mm(260));
    let height = nearest(contact.z)?;
    let results = vec![ResultParameter::length(160, ResultName::COORDINATE, height)];
    let axes = vec![axis(Axis::Third, height, inputs, NEW_COORDINATE.key)];
    set(target, (vec![contact], results, axes), inputs, course)
}
