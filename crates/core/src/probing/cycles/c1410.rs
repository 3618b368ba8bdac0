//! Cycle 1410, probing on edge: two contacts along one axis of the plane, and how far the edge through them is turned against the nominal one.

use super::edge_probing::{DIRECTION, Point, approach, axis};
use super::nominal_cycle::{CLEARANCE_MODE, Findings, POINT_1, POINT_2, POINT_3, REACTION, leave, ways};
use super::two_points::{
    ALIGN, CORRECTION, ROTATION, SECOND_1, SECOND_2, SECOND_3, by, confirms, line, rotation, turned,
};
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Log, Measured, Parameter, ResultName, Window,
};
use crate::probing::simulated::{Face, Surface};
use crate::tolerance::Nominal;
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 1410,
    code: "1410",
    control: Control::Milling,
    names: &[(En, "PROBING ON EDGE"), (Nl, "TASTEN KANT"), (De, "ANTASTEN KANTE"), (It, "TASTATURA SPIGOLO")],
    notes: &[],
    parameters: &[
        POINT_1,
        POINT_2,
        POINT_3,
        SECOND_1,
        SECOND_2,
        SECOND_3,
        IN_PLANE,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        CLEARANCE_MODE,
        REACTION,
        ALIGN,
        CORRECTION,
        ROTATION,
    ],
    surface: |inputs| Surface::Face(Face::plane(FIRST.target(inputs), normal(inputs))),
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// The edge turns about the tool axis.
const IN_PLANE: Parameter = DIRECTION.of(&[-2, -1, 1, 2]).asked(&[
    (En, "Probing direction (-2...+2)?"),
    (Nl, "Tastrichting (-2...+2)?"),
    (De, "Antastrichtung (-2...+2)?"),
    (It, "Direzione di tastatura (-2...+2)?"),
]);
/// Q950 to Q952, with its deviations from Q980 on.
const FIRST: Point = Point {
    of: [POINT_1, POINT_2, POINT_3],
    results: [950, 980],
    names: [ResultName::POSITION_1, ResultName::POSITION_2, ResultName::POSITION_3],
    deviations: [ResultName::DEVIATION_1, ResultName::DEVIATION_2, ResultName::DEVIATION_3],
};
/// Q953 to Q955, with its deviations from Q983 on.
const SECOND: Point = Point {
    of: [SECOND_1, SECOND_2, SECOND_3],
    results: [953, 983],
    names: [
        ResultName::new("found-second-position-1"),
        ResultName::new("found-second-position-2"),
        ResultName::new("found-second-position-3"),
    ],
    deviations: [
        ResultName::new("found-second-deviation-1"),
        ResultName::new("found-second-deviation-2"),
        ResultName::new("found-second-deviation-3"),
    ],
};

/// Out of the material, square to the nominal edge; against the approach where both points are one.
fn normal(inputs: &Inputs) -> [f64; 3] {
    let [along_1, along_2] = line(FIRST.target(inputs), SECOND.target(inputs));
    let [towards_1, towards_2, _] = approach(inputs);
    let facing = along_2 * towards_1 - along_1 * towards_2;
    if facing.abs() <= 0.0 {
        return approach(inputs).map(|part| -part);
    }
    let sign = -facing.signum();
    [along_2 * sign, -along_1 * sign, 0.0]
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let turns = confirms(inputs)?;
    FIRST.check(inputs)?;
    SECOND.check(inputs)?;
    let along = if axis(inputs) == Axis::First { Axis::Second } else { Axis::First };
    let (first, second) = (FIRST.of(along).key, SECOND.of(along).key);
    if inputs.nominal(first).target() == inputs.nominal(second).target() {
        return Err(CycleError::NoEdge { first, second });
    }
    let [way, next] = ways(inputs);
    let contacts = [FIRST.probe(way, inputs, course)?, SECOND.probe(next, inputs, course)?];
    leave(inputs, course);
    let (measured, turned) = found(contacts, inputs)?;
    let rotation = turns.then_some(by(turned));
    Ok(Measured { rotation, ..measured })
}

/// The two points, and how far the line through them is turned, degrees.
fn found(contacts: [Contact; 2], inputs: &Inputs) -> Result<(Measured, f64), CycleError> {
    let [one, other] = &contacts;
    let mut findings = Findings::default();
    let measured = FIRST.add(one, inputs, &mut findings)?;
    let measured_2 = SECOND.add(other, inputs, &mut findings)?;
    let (nominal, nominal_2) = (FIRST.nominal(inputs), SECOND.nominal(inputs));
    let middle = |one: Length, other: Length| one.midpoint(other);
    match inputs.whole(CORRECTION.key) {
        2 => findings.correct(axis(inputs), nominal_2, measured_2),
        3 => {
            let wanted = Nominal::of(middle(nominal.target(), nominal_2.target()));
            findings.correct(axis(inputs), wanted, middle(measured, measured_2));
        }
        _ => findings.correct(axis(inputs), nominal, measured),
    }
    let turned = turned([FIRST.target(inputs), SECOND.target(inputs)], [one.place(), other.place()]);
    findings.also(rotation(turned));
    Ok((findings.measured(inputs, contacts.to_vec()), turned))
}
