//! What cycles 421 and 422 share: three or four contacts on a circle, centre and diameter by least squares.
//!
//! Parameters, ranges and results as in the control's cycle manuals (TNC 320 and TNC7, cycles 421 and 422).

use super::round;
use crate::length::Length;
use crate::probing::contact::Touch;
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, INCIDENCE_ANGLE, MEASURING_HEIGHT, MEASURING_LOG, REVERSED, SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Angle, Check, CircleFound, Course, CycleError, Found, FoundName, Inputs, Key, LogTarget, Measured, Nominal,
    Parameter, Plane, QUARTER_TURN, Remark, Stop, Texts, limits,
};
use crate::tolerance::Feature;
use crate::verdict::{Status, classify};
use crate::words::Dialogue::En;

/// The name of Q262.
const NOMINAL_DIAMETER: &str = "NOMINAL DIAMETER";

/// The step between three contacts when Q247 is not given: 90 degrees would leave half the circle unseen.
const STEP_OF_THREE: i64 = Angle::from_degrees(120).ten_thousandths();

/// What differs between hole and stud.
pub(super) struct Side {
    pub(super) feature: Feature,
    /// The Q number of the maximum dimension.
    pub(super) maximum: u16,
    /// Its question.
    pub(super) maximum_question: Texts,
    /// The Q number of the minimum dimension.
    pub(super) minimum: u16,
    /// Its question.
    pub(super) minimum_question: Texts,
    /// The file of the measuring log.
    pub(super) log: &'static str,
}

/// The declaration, in the order of NC programs.
pub(super) const fn parameters(side: &Side) -> [Parameter; 20] {
    const fn q(number: u16) -> Key {
        Key::Q(number)
    }
    [
        Parameter::coordinate(q(273), "CENTER IN 1ST AXIS").asked(&[(En, "Center in 1st axis (nom. value)?")]),
        Parameter::coordinate(q(274), "CENTER IN 2ND AXIS").asked(&[(En, "Center in 2nd axis (nom. value)?")]),
        Parameter::size(q(262), NOMINAL_DIAMETER).asked(&[(En, "Nominal diameter?")]),
        Parameter::angle(q(325), "STARTING ANGLE", 360, 0).asked(&[(En, "Starting angle?")]).or(0),
        Parameter::angle(q(247), "STEPPING ANGLE", 120, 5)
            .asked(&[(En, "Intermediate stepping angle?")])
            .or(QUARTER_TURN)
            .or_where(q(423), 3, STEP_OF_THREE),
        MEASURING_HEIGHT.or(0),
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        Parameter::choice(q(301), "MOVE TO CLEARANCE", &[0, 1])
            .asked(&[(En, "Move to clearance height (0/1)?")])
            .or(0)
            .or_predef(),
        Parameter::size(q(side.maximum), "MAXIMUM DIMENSION").asked(side.maximum_question).or(0),
        Parameter::size(q(side.minimum), "MINIMUM DIMENSION").asked(side.minimum_question).or(0),
        Parameter::size(q(279), "TOLERANCE 1ST CENTER").asked(&[(En, "Tolerance for center 1st axis?")]).or(0),
        Parameter::size(q(280), "TOLERANCE 2ND CENTER").asked(&[(En, "Tolerance for center 2nd axis?")]).or(0),
        MEASURING_LOG,
        STOP_IF_ERROR,
        TOOL,
        Parameter::choice(q(423), "NO. OF MEAS. POINTS", &[3, 4])
            .asked(&[(En, "No. probe points in plane (4/3)?")])
            .or(4),
        Parameter::choice(q(365), "TYPE OF TRAVERSE", &[0, 1]).asked(&[(En, "Type of traverse? Line=0/arc=1")]).or(1),
        REVERSED,
        INCIDENCE_ANGLE,
    ]
}

/// Runs either cycle on checked inputs.
pub(super) fn run(side: &Side, inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let limits = limits(inputs, side.minimum, side.maximum)?;
    let nominal = inputs.length(262);
    if nominal == Length::ZERO {
        return Err(CycleError::NoDiameter { key: Key::Q(262), name: NOMINAL_DIAMETER });
    }
    let ball_radius = course.ball_radius();
    let height = inputs.mm(260);
    let mut contacts = Vec::new();
    for touch in touches(side, inputs, ball_radius) {
        pre_position(inputs, &touch, contacts.is_empty(), course);
        contacts.push(course.touch(&touch)?);
        course.retract(touch.from);
    }
    course.leave(height);
    let round = round::fit(contacts, side.feature, Plane::Xy, ball_radius)?;
    let centre = [inputs.length(273), inputs.length(274)];
    let found = round.found(centre, [inputs.length(279), inputs.length(280)])?;
    let checks = checks(side, &found, limits, centre);
    // A centre out of position cannot be machined back: it counts as scrap, and exactly one marker is set.
    let status = checks.iter().map(|check| check.status).max().unwrap_or(Status::Good);
    let outside = limits.is_some_and(|(minimum, maximum)| nominal < minimum || maximum < nominal);
    Ok(Measured {
        contacts: round.contacts,
        results: results(&found, found.diameter.saturating_sub(nominal), status),
        circle: Some(found),
        status: Some(status),
        stop: if inputs.whole(309) == 1 { Stop::of(1, &checks) } else { None },
        checks,
        log: LogTarget::of_q281(inputs.whole(281), side.log),
        remarks: if outside { vec![Remark::NominalOutsideLimits { nominal }] } else { Vec::new() },
    })
}

/// The hole or stud at nominal.
pub(super) fn nominal(side: &Side, inputs: &Inputs) -> Nominal {
    Nominal::Circle {
        feature: side.feature,
        plane: Plane::Xy,
        centre: [inputs.mm(273), inputs.mm(274)],
        diameter: inputs.mm(262),
    }
}

/// The touches in order: at Q325 + k · Q247, from inside a hole or from outside a stud.
fn touches(side: &Side, inputs: &Inputs, ball_radius: f64) -> Vec<Touch> {
    let (x, y, height) = (inputs.mm(273), inputs.mm(274), inputs.mm(261));
    let radius = inputs.mm(262) / 2.0;
    let clearance = inputs.mm(320) + inputs.probe().set_up.to_mm_f64();
    let (start, outward) = match side.feature {
        // In a small hole the probe starts at the centre.
        Feature::Hole => ((radius - clearance - ball_radius).max(0.0), 1.0),
        Feature::Shaft => (radius + clearance + ball_radius, -1.0),
    };
    let count = inputs.whole(423);
    let step = inputs.angle(247);
    // Q423 is 3 or 4.
    (0..4_u8)
        .take(usize::try_from(count).unwrap_or(4))
        .map(|number| {
            let [cos, sin] = inputs.angle(325).stepped(step, number).direction();
            Touch {
                from: [x + start * cos, y + start * sin, height],
                direction: [outward * cos, outward * sin, 0.0],
                longest: inputs.probe().longest_path.to_mm_f64(),
            }
        })
        .collect()
}

/// From above to the first touch; to the others as Q301 says, and at measuring height as Q365 says.
fn pre_position(inputs: &Inputs, touch: &Touch, is_first: bool, course: &mut Course<'_>) {
    if is_first || inputs.whole(301) == 1 {
        course.pre_position_from_above(touch.from, inputs.mm(260));
    } else if inputs.whole(365) == 1 {
        course.pre_position_about(touch.from, [inputs.mm(273), inputs.mm(274), inputs.mm(261)]);
    } else {
        course.pre_position(touch.from);
    }
}

/// The diameter where limits were given, and each axis of the centre that has a tolerance: each is its own cause.
fn checks(side: &Side, found: &CircleFound, limits: Option<(Length, Length)>, nominal: [Length; 2]) -> Vec<Check> {
    let measured = found.diameter;
    let diameter = limits.map(|(minimum, maximum)| Check {
        what: FoundName::DIAMETER,
        measured,
        minimum,
        maximum,
        status: classify(side.feature, minimum, maximum, measured),
    });
    let names = [FoundName::CENTRE_1, FoundName::CENTRE_2];
    let axes = names.into_iter().zip(found.centre).zip(nominal.into_iter().zip(found.position.axes));
    let centre = axes.filter_map(|((what, measured), (nominal, axis))| {
        let tolerance = axis.tolerance?;
        Some(Check {
            what,
            measured,
            minimum: nominal.saturating_sub(tolerance),
            maximum: nominal.saturating_sub(tolerance.negated()),
            status: if axis.is_out() { Status::Scrap } else { Status::Good },
        })
    });
    diameter.into_iter().chain(centre).collect()
}

/// Q151 to Q153 measured, Q161 to Q163 deviations, Q180 to Q182 markers of which exactly one is 1.
fn results(found: &CircleFound, deviation: Length, status: Status) -> Vec<Found> {
    let [centre_1, centre_2] = found.centre;
    let [axis_1, axis_2] = found.position.axes;
    let mut results = vec![
        Found::length(151, FoundName::CENTRE_1, centre_1),
        Found::length(152, FoundName::CENTRE_2, centre_2),
        Found::length(153, FoundName::DIAMETER, found.diameter),
        Found::length(161, FoundName::CENTRE_DEVIATION_1, axis_1.deviation),
        Found::length(162, FoundName::CENTRE_DEVIATION_2, axis_2.deviation),
        Found::length(163, FoundName::DIAMETER_DEVIATION, deviation),
    ];
    results.extend(Found::markers(status));
    results
}
