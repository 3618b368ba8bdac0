//! Cycle 1401, circle probing: centre and diameter of a hole or stud against nominal values with their tolerances.
//!
//! A stud that is too large and a hole that is too small are rework, as in 421 and 422; a wrong centre is scrap. The height is where the ball
//! touches and is not measured. The control writes TCHPRAUTO.html, whose layout is not known: there is no log here.

use super::circle_probing::FIRST_ANGLE;
use super::nominal_cycle::{
    ARC, CLEARANCE_MODE, COUNT, DIAMETER, FIRST_CIRCLE, Findings, GEOMETRY, NominalCircle, POINT_1, POINT_2, POINT_3,
    PRESET, REACTION, leave, ways,
};
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Log, Meaning, Measured, Parameter, Window,
};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

const CENTRE: [Parameter; 2] =
    [POINT_1.means(Meaning::Centre(Axis::First)), POINT_2.means(Meaning::Centre(Axis::Second))];
const HEIGHT: Parameter = POINT_3.means(Meaning::MeasuringHeight);

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 1401,
    code: "1401",
    control: Control::Milling,
    names: &[(En, "CIRCLE PROBING"), (Nl, "TASTEN CIRKEL"), (De, "ANTASTEN KREIS"), (It, "TASTATURA CERCHIO")],
    notes: &[],
    parameters: &[
        CENTRE[0],
        CENTRE[1],
        HEIGHT,
        DIAMETER,
        GEOMETRY,
        COUNT,
        FIRST_ANGLE,
        ARC,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        CLEARANCE_MODE,
        REACTION,
        PRESET,
    ],
    surface: |inputs| circle(inputs).round(inputs).surface(),
    run,
    subject: |inputs| Some(inputs.nominal(DIAMETER.key).value().to_string()),
    corrects: |_result| None,
    window: Window::Diameter,
    log: Log::None,
};

fn circle(inputs: &Inputs) -> NominalCircle {
    let feature = if inputs.whole(GEOMETRY.key) == 1 { Feature::Shaft } else { Feature::Hole };
    NominalCircle { feature, centre: CENTRE, height: HEIGHT, diameter: DIAMETER }
}

/// Runs the cycle on checked inputs: Q950 and Q951 the centre, Q966 the diameter, Q980, Q981 and Q996 the deviations, Q183 the status.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let circle = circle(inputs);
    circle.check(inputs)?;
    let (contacts, found) = circle.probe(ways(inputs), inputs, course)?;
    leave(inputs, course);
    let mut findings = Findings::default();
    circle.add(&found, &FIRST_CIRCLE, inputs, &mut findings);
    Ok(Measured { circle: Some(found), ..findings.measured(inputs, contacts) })
}
