//! Cycle 1410, probing on edge: two contacts along one axis of the plane, and how far the edge through them is turned against the nominal one.
//!
//! Q964 is that angle. With Q1121 = 1 the basic rotation grows by it; a move of rotary axes (Q1126, Q1121 = 2) is refused.

use super::edge_probing::{DIRECTION, Point, approach, axis};
use super::nominal_cycle::{CLEARANCE_MODE, Findings, POINT_1, POINT_2, POINT_3, PRESET, REACTION, leave, ways};
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Angle, Axis, Control, Course, Cycle, CycleError, DatumTarget, Inputs, Key, Log, Meaning, Measured, NewRotation,
    Parameter, ResultName, ResultParameter, TurnedBy, Window,
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

/// The second point, first axis.
const SECOND_1: Parameter = Parameter::nominal_coordinate(1103, "2ND POINT REF AXIS")
    .named(&[(Nl, "2E PUNT HOOFDAS"), (De, "2.PUNKT HAUPTACHSE"), (It, "2. PUNTO ASSE PRINC.")])
    .asked(&[
        (En, "2nd nominal position of ref. axis?"),
        (Nl, "2e nominale positie hoofdas?"),
        (De, "2. Sollposition Hauptachse?"),
        (It, "2. posizione nom. asse princ.?"),
    ])
    .means(Meaning::Point(Axis::First));
/// Second axis.
const SECOND_2: Parameter = Parameter::nominal_coordinate(1104, "2ND POINT MINOR AXIS")
    .named(&[(Nl, "2E PUNT NEVENAS"), (De, "2.PUNKT NEBENACHSE"), (It, "2. PUNTO ASSE SECOND.")])
    .asked(&[
        (En, "2nd nominal position of minor axis?"),
        (Nl, "2e nominale positie nevenas?"),
        (De, "2. Sollposition Nebenachse?"),
        (It, "2. posizione nom. asse second.?"),
    ])
    .means(Meaning::Point(Axis::Second));
/// Third axis.
const SECOND_3: Parameter = Parameter::nominal_coordinate(1105, "2ND POINT TOOL AXIS")
    .named(&[(Nl, "2E PUNT GS-AS"), (De, "2.PUNKT WZ-ACHSE"), (It, "2. PUNTO ASSE UTENS.")])
    .asked(&[
        (En, "2nd nominal position of tool axis?"),
        (Nl, "2e nominale positie gereedschapsas?"),
        (De, "2. Sollposition Werkzeugachse?"),
        (It, "2. posizione nom. asse utensile?"),
    ])
    .means(Meaning::Point(Axis::Third));
/// The edge turns about the tool axis.
const IN_PLANE: Parameter = DIRECTION.of(&[-2, -1, 1, 2]).asked(&[
    (En, "Probing direction (-2...+2)?"),
    (Nl, "Tastrichting (-2...+2)?"),
    (De, "Antastrichtung (-2...+2)?"),
    (It, "Direzione di tastatura (-2...+2)?"),
]);
/// Whether a rotary axis is aligned.
const ALIGN: Parameter = Parameter::choice(Key::Q(1126), "ALIGN ROTARY AXIS", &[0, 1, 2])
    .named(&[(Nl, "ROTATIEAS UITLIJNEN"), (De, "DREHACHSEN AUSRICHTEN"), (It, "ALLINEARE ASSE ROT.")])
    .asked(&[
        (En, "Align rotary axis (0/1/2)?"),
        (Nl, "Rotatieas uitlijnen (0/1/2)?"),
        (De, "Drehachse ausrichten (0/1/2)?"),
        (It, "Allineare asse rotativo (0/1/2)?"),
    ])
    .or(0);
/// By which point the active preset is corrected: the first, the second, the middle of both.
const CORRECTION: Parameter = PRESET.of(&[0, 1, 2, 3]);
/// What becomes of the rotation.
const ROTATION: Parameter = Parameter::choice(Key::Q(1121), "CONFIRM ROTATION", &[0, 1, 2])
    .named(&[(Nl, "ROTATIE OVERNEMEN"), (De, "DREHUNG UEBERNEHMEN"), (It, "CONFERMA ROTAZIONE")])
    .asked(&[
        (En, "Confirm rotation (0/1/2)?"),
        (Nl, "Rotatie overnemen (0/1/2)?"),
        (De, "Drehung übernehmen (0/1/2)?"),
        (It, "Confermare rotazione (0/1/2)?"),
    ])
    .or(0);

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

/// From the first point to the second, in the plane.
fn line([from_x, from_y, _]: [f64; 3], [to_x, to_y, _]: [f64; 3]) -> [f64; 2] {
    [to_x - from_x, to_y - from_y]
}

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
    let by = TurnedBy::Rotation(DatumTarget::Active);
    let rotation = turns.then_some(NewRotation { degrees: turned, by });
    Ok(Measured { rotation, ..measured })
}

/// Whether the angle becomes a basic rotation.
///
/// # Errors
/// [`CycleError::NoRotation`] for a move of rotary axes, and for a rotation together with a correction: about which point the system turns
/// then is not known.
fn confirms(inputs: &Inputs) -> Result<bool, CycleError> {
    let refused = |parameter: Parameter| Err(CycleError::NoRotation { key: parameter.key, name: parameter.called() });
    if inputs.whole(ALIGN.key) != 0 {
        return refused(ALIGN);
    }
    match inputs.whole(ROTATION.key) {
        0 => Ok(false),
        1 if inputs.whole(CORRECTION.key) == 0 => Ok(true),
        _ => refused(ROTATION),
    }
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
    let [wanted_1, wanted_2] = line(FIRST.target(inputs), SECOND.target(inputs));
    let [found_1, found_2] = line(one.place(), other.place());
    let turned = (wanted_1 * found_2 - wanted_2 * found_1).atan2(wanted_1 * found_1 + wanted_2 * found_2);
    let turned = turned.to_degrees();
    findings.also(ResultParameter::angle(964, ResultName::new("found-rotation"), Angle::nearest(turned)));
    Ok((findings.measured(inputs, contacts.to_vec()), turned))
}
