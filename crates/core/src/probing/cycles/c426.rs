//! Cycle 426, measure ridge width: two points on either side, limits in Q288 and Q289.
//!
//! Parameters in the order of a public post-processor, with the names of its similar cycles; ranges, course and results
//! by analogy with 425 and 427, because no public page was found: first in minus direction to the first point, then
//! over the clearance height and in plus direction to the second. Our interpretation: each probing begins `SET_UP`,
//! Q320 and the ball's radius away from its point, so the first point has the larger coordinate.

use super::probed::met_at;
use super::width_cycle::{AXIS, FIGURES, MAXIMUM, MINIMUM, WIDTH, along_axis, corrects, measured, subject, surface};
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, MEASURING_HEIGHT, MEASURING_LOG, POINT_1, POINT_2, SECOND_POINT_1, SECOND_POINT_2,
    SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Log, Meaning, Measured, Note, TextLog, Window, limits,
};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 426,
    code: "426",
    control: Control::Milling,
    names: &[
        (En, "MEASURE RIDGE WIDTH"),
        (Nl, "METEN DAMBREEDTE"),
        (De, "MESSEN STEG AUSSEN"),
        (It, "MIS. ISOLA ESTERNA"),
    ],
    notes: &[Note::EndsRotation],
    parameters: &[
        POINT_1.means(Meaning::FirstPoint(Axis::First)),
        POINT_2.means(Meaning::FirstPoint(Axis::Second)),
        SECOND_POINT_1.means(Meaning::SecondPoint(Axis::First)),
        SECOND_POINT_2.means(Meaning::SecondPoint(Axis::Second)),
        AXIS,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        WIDTH,
        MAXIMUM,
        MINIMUM,
        MEASURING_LOG,
        STOP_IF_ERROR,
        TOOL,
    ],
    surface: |inputs| {
        let [first_x, first_y, _] = point(inputs, 263, 264);
        let [second_x, second_y, _] = point(inputs, 265, 266);
        let middle = [f64::midpoint(first_x, second_x), f64::midpoint(first_y, second_y)];
        surface(Feature::Shaft, middle, inputs)
    },
    run,
    subject: |inputs| Some(subject(inputs)),
    corrects: |result| corrects(Feature::Shaft, result),
    window: Window::Own("width"),
    log: Log::Text(TextLog { file: "TCHPR426.TXT", figures: FIGURES }),
};

/// A programmed point at measuring height.
fn point(inputs: &Inputs, first: u16, second: u16) -> [f64; 3] {
    [inputs.mm(first), inputs.mm(second), inputs.mm(261)]
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let limits = limits(inputs, 289, 288)?;
    let plus = along_axis(inputs);
    let first = met_at(point(inputs, 263, 264), plus.map(|part| -part), inputs, course)?;
    let second = met_at(point(inputs, 265, 266), plus, inputs, course)?;
    course.leave(inputs.mm(260));
    measured(Feature::Shaft, inputs, limits, [first, second])
}
