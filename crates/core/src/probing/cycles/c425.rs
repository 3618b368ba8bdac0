//! Cycle 425, measure inside width: a slot along one axis, limits in Q288 and Q289.
//!
//! Parameters and ranges as in the cycle manual of the TNC 320, their order and names as in a public post-processor,
//! course and results as in the manual of the TNC7: first in plus direction, then, shifted by Q310, in minus direction.
//! Our interpretation: Q310 shifts across the measured axis; Q320 and Q301 come last, if a program has them at all; the
//! second probing begins, at rapid traverse, as far from the wall as the nominal width suggests.

use super::probed::{axis, clearance, met, probing};
use super::width_cycle::{AXIS, FIGURES, MAXIMUM, MINIMUM, WIDTH, along_axis, corrects, measured, subject, surface};
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, MEASURING_HEIGHT, MEASURING_LOG, MOVE_TO_CLEARANCE, SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Key, Log, Meaning, Measured, Note, Parameter, TextLog, Window,
    limits,
};
use crate::probing::vector::{along, dot};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 425,
    code: "425",
    control: Control::Milling,
    names: &[
        (En, "MEASURE INSIDE WIDTH"),
        (Nl, "METEN BREEDTE BINNEN"),
        (De, "MESSEN BREITE INNEN"),
        (It, "MIS. LARGHEZZA INT."),
    ],
    notes: &[Note::EndsRotation, Note::Recommended { cycle: "1404" }],
    parameters: &[
        Parameter::coordinate(Key::Q(328), "STARTNG PNT 1ST AXIS")
            .named(&[(Nl, "STARTPUNT 1E AS"), (De, "STARTPUNKT 1. ACHSE"), (It, "PUNTO INIZ. 1. ASSE")])
            .asked(&[
                (En, "Starting point in 1st axis?"),
                (Nl, "Startpunt 1e as?"),
                (De, "Startpunkt 1. Achse?"),
                (It, "Punto iniziale 1. asse?"),
            ])
            .means(Meaning::Start(Axis::First)),
        Parameter::coordinate(Key::Q(329), "STARTNG PNT 2ND AXIS")
            .named(&[(Nl, "STARTPUNT 2E AS"), (De, "STARTPUNKT 2. ACHSE"), (It, "PUNTO INIZ. 2. ASSE")])
            .asked(&[
                (En, "Starting point in 2nd axis?"),
                (Nl, "Startpunt 2e as?"),
                (De, "Startpunkt 2. Achse?"),
                (It, "Punto iniziale 2. asse?"),
            ])
            .means(Meaning::Start(Axis::Second)),
        Parameter::coordinate(Key::Q(310), "OFFS. 2ND MEASUREMNT")
            .named(&[(Nl, "VERSCHUIVING 2E MET."), (De, "VERSATZ 2. MESSUNG"), (It, "OFFSET 2. MISURAZ.")])
            .asked(&[
                (En, "Offset for 2nd measurement?"),
                (Nl, "Verschuiving 2e meting?"),
                (De, "Versatz für 2. Messung?"),
                (It, "Offset per 2. misurazione?"),
            ])
            .or(0)
            .means(Meaning::Shift),
        AXIS,
        MEASURING_HEIGHT,
        CLEARANCE_HEIGHT,
        WIDTH,
        MAXIMUM,
        MINIMUM,
        MEASURING_LOG,
        STOP_IF_ERROR,
        TOOL,
        SET_UP_CLEARANCE,
        MOVE_TO_CLEARANCE,
    ],
    surface: |inputs| {
        let [x, y, _] = start(inputs);
        surface(Feature::Hole, [x, y], inputs)
    },
    run,
    subject: |inputs| Some(subject(inputs)),
    corrects: |result| corrects(Feature::Hole, result),
    window: Window::Own("width"),
    log: Log::Text(TextLog { file: "TCHPR425.TXT", figures: FIGURES }),
};

/// The starting point at measuring height.
fn start(inputs: &Inputs) -> [f64; 3] {
    [inputs.mm(328), inputs.mm(329), inputs.mm(261)]
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let limits = limits(inputs, 289, 288)?;
    let ball_radius = course.ball_radius();
    let height = inputs.mm(260);
    let plus = along_axis(inputs);
    let start = start(inputs);
    let minus = plus.map(|part| -part);

    course.pre_position_from_above(start, height);
    let ball = course.touch(&probing(inputs, start, plus))?.place();
    course.retract(start);

    let shift = if axis(inputs) == Axis::Second { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let shifted = along(start, shift, inputs.mm(310));
    // Where the ball would touch the other wall, seen from the start, minus the clearance.
    let gone = dot(along(ball, start, -1.0), plus);
    let expected = inputs.mm(311) - 2.0 * ball_radius - gone;
    let from = along(shifted, minus, (expected - clearance(inputs)).max(0.0));
    if inputs.whole(301) == 1 && 0.0 < inputs.mm(310).abs() {
        course.pre_position_from_above(from, height);
    } else {
        course.pre_position(shifted);
        course.pre_position(from);
    }
    let other = met(&probing(inputs, from, minus), course)?;
    course.leave(height);
    measured(Feature::Hole, inputs, limits, [Contact::at(along(ball, plus, ball_radius)), other])
}
