//! Cycle 419, datum in one axis: one contact along it, in either direction.
//!
//! CAM systems write in Q263 or Q264 where the probe stands before the approach, as they do for 427 (`docs/SOURCES.md`, "Datum cycles");
//! the face is then Q320 and the ball's radius ahead, and stands in Q333. That Q160 holds the result is by analogy with 427: no manual
//! that we found names a parameter.

use super::datum_cycle::{CLEARANCE, NEW_COORDINATE, ROW, TRANSFER, axis, set, target};
use super::probed::{self, approach, coordinate, met_at};
use crate::probing::cycle::shared::{DIRECTION, MEASURED_AXIS, MEASURING_HEIGHT, POINT_1, POINT_2, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Log, Measured, Note, ResultName, ResultParameter, Window, nearest,
};
use crate::probing::simulated::{Face, Surface};
use crate::probing::vector::along;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The radius of a ball is no larger than this, mm: it tells whether Q333 stands where a CAM system writes the face. The radius itself is
/// not known where a perfect workpiece is made.
const LARGEST_BALL: f64 = 5.0;

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 419,
    code: "419",
    control: Control::Milling,
    names: &[
        (En, "DATUM IN ONE AXIS"),
        (Nl, "REF.PT IN EEN AS"),
        (De, "BZPKT EINZELNE ACHSE"),
        (It, "ORIGINE ASSE SINGOLO"),
    ],
    notes: &[Note::Recommended { cycle: "1400" }],
    parameters: &[
        POINT_1,
        POINT_2,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE,
        MEASURED_AXIS,
        DIRECTION,
        ROW,
        NEW_COORDINATE,
        TRANSFER,
    ],
    surface: |inputs| Surface::Face(Face::plane(face(inputs), approach(inputs).map(|part| -part))),
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// Where the face of a perfect workpiece is.
fn face(inputs: &Inputs) -> [f64; 3] {
    let point = probed::point(inputs);
    let sign = if inputs.whole(267) < 0 { -1.0 } else { 1.0 };
    let [x, y, z] = point;
    let programmed = match probed::axis(inputs) {
        Axis::First => x,
        Axis::Second => y,
        Axis::Third => z,
    };
    let ahead = sign * (inputs.mm(NEW_COORDINATE.key) - programmed);
    let ball = ahead - inputs.mm(320);
    if 0.0 < ball && ball <= LARGEST_BALL { along(point, approach(inputs), ahead) } else { point }
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let target = target(inputs)?;
    if probed::axis(inputs) == Axis::Third {
        course.needs_heights()?;
    }
    let contact = met_at(probed::point(inputs), approach(inputs), inputs, course)?;
    course.leave(inputs.mm(260));
    let measured = nearest(coordinate(&contact, inputs))?;
    let results = vec![ResultParameter::length(160, ResultName::COORDINATE, measured)];
    let axes = vec![axis(probed::axis(inputs), measured, inputs, NEW_COORDINATE.key)];
    set(target, (vec![contact], results, axes), inputs, course)
}
