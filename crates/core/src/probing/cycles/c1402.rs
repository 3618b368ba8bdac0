//! Cycle 1402, sphere probing: contacts around the widest place of a sphere and one at its top, centre and diameter against nominal values.
//!
//! Where the control probes is not known: the contacts are ours, and the sphere through them is by geometric least squares, as circles are.
//! A sphere is judged like a stud.

use super::circle_probing::{FIRST_ANGLE, Round, Way};
use super::judged;
use super::nominal_cycle::{
    ARC, CLEARANCE_MODE, COUNT, DIAMETER, Findings, POINT_1, POINT_2, POINT_3, PRESET, REACTION, angles, leave,
    of_feature, ways,
};
use super::probed::{clearance, probing};
use super::sphere::Sphere;
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Key, Log, Meaning, Measured, Parameter, ResultName, Window,
    nearest,
};
use crate::probing::simulated::{FreePoint, Surface};
use crate::probing::vector::along;
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

const CENTRE: [Parameter; 3] =
    [POINT_1.means(Meaning::Centre(Axis::First)), POINT_2.means(Meaning::Centre(Axis::Second)), POINT_3];

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 1402,
    code: "1402",
    control: Control::Milling,
    names: &[(En, "SPHERE PROBING"), (Nl, "TASTEN KOGEL"), (De, "ANTASTEN KUGEL"), (It, "TASTATURA SFERA")],
    notes: &[],
    parameters: &[
        CENTRE[0],
        CENTRE[1],
        CENTRE[2],
        DIAMETER,
        COUNT,
        FIRST_ANGLE,
        ARC,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        CLEARANCE_MODE,
        REACTION,
        PRESET,
    ],
    surface,
    run,
    subject: |inputs| Some(inputs.nominal(DIAMETER.key).value().to_string()),
    corrects: |_result| None,
    window: Window::Diameter,
    log: Log::None,
};

/// The centre in the middle of its tolerances.
fn centre(inputs: &Inputs) -> [f64; 3] {
    CENTRE.map(|of| inputs.nominal(of.key).target().to_mm_f64())
}

fn diameter(inputs: &Inputs) -> f64 {
    inputs.nominal(DIAMETER.key).target().to_mm_f64()
}

/// The neighbourhood of its top is all of the sphere.
fn surface(inputs: &Inputs) -> Surface {
    let radius = diameter(inputs) / 2.0;
    Surface::Point(FreePoint { radius: Some(radius), ..FreePoint::flat(along(centre(inputs), UP, radius), UP) })
}

/// Runs the cycle on checked inputs: Q950 to Q952 the centre, Q966 the diameter, Q980 to Q982 and Q996 the deviations, Q183 the status.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    of_feature(&DIAMETER, Feature::Shaft, Key::Word(CYCLE.code), inputs)?;
    course.needs_heights()?;
    let balls = probe(inputs, course)?;
    leave(inputs, course);
    let ball_radius = course.ball_radius();
    let sphere = Sphere::through(&balls, centre(inputs)).ok_or(CycleError::NoSphere)?;
    let contacts = balls.iter().map(|ball| sphere.inwards(ball, ball_radius)).collect();
    found(&sphere, nearest(2.0 * (sphere.radius - ball_radius))?, contacts, inputs)
}

/// The places of the ball: around the sphere at the height of its centre, then at its top.
fn probe(inputs: &Inputs, course: &mut Course<'_>) -> Result<Vec<Contact>, CycleError> {
    let [x, y, height] = centre(inputs);
    let around = Round { feature: Feature::Shaft, centre: [x, y], diameter: diameter(inputs), height };
    let ways = ways(inputs);
    let mut balls = around.probe(angles(inputs), ways, inputs, course)?;
    let above = diameter(inputs) / 2.0 + clearance(inputs) + course.ball_radius();
    let touch = probing(inputs, [x, y, height + above], [0.0, 0.0, -1.0]);
    let [_, next] = ways;
    let [_, _, from] = touch.from;
    // Up beside the sphere, and over it.
    course.pre_position_from_above(touch.from, if matches!(next, Way::Over) { inputs.mm(260) } else { from });
    balls.push(course.touch(&touch)?);
    course.retract(touch.from);
    Ok(balls)
}

fn found(sphere: &Sphere, diameter: Length, contacts: Vec<Contact>, inputs: &Inputs) -> Result<Measured, CycleError> {
    let mut findings = Findings::default();
    let axes = [Axis::First, Axis::Second, Axis::Third];
    let names = [
        [ResultName::CENTRE_1, ResultName::CENTRE_DEVIATION_1],
        [ResultName::CENTRE_2, ResultName::CENTRE_DEVIATION_2],
        [ResultName::CENTRE_3, ResultName::CENTRE_DEVIATION_3],
    ];
    for ((((of, place), axis), names), number) in CENTRE.iter().zip(sphere.centre).zip(axes).zip(names).zip(0_u16..) {
        let at = [950 + number, 980 + number];
        findings.centre(axis, (inputs.nominal(of.key), nearest(place)?), at, names);
    }
    let nominal = inputs.nominal(DIAMETER.key);
    let check = judged::size(ResultName::DIAMETER, diameter, nominal.limits(), Feature::Shaft);
    let names = [ResultName::DIAMETER, ResultName::DIAMETER_DEVIATION];
    findings.add((nominal, diameter), [966, 996], names, check);
    Ok(findings.measured(inputs, contacts))
}
