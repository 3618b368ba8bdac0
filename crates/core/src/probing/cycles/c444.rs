//! Cycle 444, probing in 3-D: one point of a free surface, its deviation along the normal.
//!
//! Course and principle as in the Dutch manual of TNC 640 (01/2021); parameters, QS400 and Q309 as in the cycle manual
//! of the TNC 320. The ranges of the normal's components and the numbers of the results are from memory and may differ
//! on a control.

use super::judged;
use super::probed::probing;
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, ERROR_REACTION, POINT_1, POINT_2, POINT_3, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, Control, Course, Cycle, CycleError, Inputs, Key, Log, Meaning, Measured, Note, Parameter, Range, Remark,
    ResultName, ResultParameter, Stop, Window, nearest,
};
use crate::probing::simulated::{FreePoint, Surface};
use crate::probing::vector::{along, direction, dot};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

/// The permitted deviation along the normal, as a text.
const TOLERANCE: Key = Key::Qs(400);

/// The retraction after the contact; without it the ball returns to where the probing began.
const RETRACT: Key = Key::Word("MB");

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 444,
    code: "444",
    control: Control::Milling,
    names: &[(En, "PROBING IN 3-D"), (Nl, "TASTEN 3D"), (De, "ANTASTEN 3D"), (It, "TASTATURA 3D")],
    notes: &[Note::NotOnItnc530, Note::MachineBuilder, Note::NormalFromCad],
    parameters: &[
        POINT_1,
        POINT_2,
        POINT_3,
        component(581, "SURFACE NORMAL 1ST AXIS", Axis::First)
            .named(&[(Nl, "NORMAAL 1E AS"), (De, "NORMALE HAUPTACHSE"), (It, "NORMALE ASSE PRINC.")])
            .asked(&[
                (En, "Surface-normal in ref. axis?"),
                (Nl, "Oppervlaktenormaal in hoofdas?"),
                (De, "Flächen-Normale Hauptachse?"),
                (It, "Normale superf. asse princ.?"),
            ]),
        component(582, "SURFACE NORMAL 2ND AXIS", Axis::Second)
            .named(&[(Nl, "NORMAAL 2E AS"), (De, "NORMALE NEBENACHSE"), (It, "NORMALE ASSE SECOND.")])
            .asked(&[
                (En, "Surface-normal in minor axis?"),
                (Nl, "Oppervlaktenormaal in nevenas?"),
                (De, "Flächen-Normale Nebenachse?"),
                (It, "Normale superf. asse second.?"),
            ]),
        component(583, "SURFACE NORMAL 3RD AXIS", Axis::Third)
            .named(&[(Nl, "NORMAAL 3E AS"), (De, "NORMALE WZ-ACHSE"), (It, "NORMALE ASSE UTENS.")])
            .asked(&[
                (En, "Surface-normal in tool axis?"),
                (Nl, "Oppervlaktenormaal in gereedschapsas?"),
                (De, "Flächen-Normale Werkzeug-Achse?"),
                (It, "Normale superf. asse utensile?"),
            ]),
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        Parameter::new(TOLERANCE, "TOLERANCE", Range::Band)
            .named(&[(Nl, "TOLERANTIE"), (De, "TOLERANZ"), (It, "TOLLERANZA")])
            .asked(&[
                (En, "Tolerance value?"),
                (Nl, "Tolerantiewaarde?"),
                (De, "Toleranzangabe?"),
                (It, "Valore di tolleranza?"),
            ])
            .or_nothing(),
        ERROR_REACTION.means(Meaning::StopOnUndersize),
        Parameter::size(RETRACT, "RETRACTION")
            .named(&[(Nl, "TERUGTREKAFSTAND"), (De, "RUECKZUG"), (It, "DISTACCO")])
            .asked(&[
                (En, "Retraction distance?"),
                (Nl, "Terugtrekafstand?"),
                (De, "Rückzugsweg?"),
                (It, "Distanza di distacco?"),
            ])
            .or_nothing()
            .means(Meaning::Retract),
    ],
    // A normal without a direction is an error of the cycle itself.
    surface: |inputs| Surface::Point(FreePoint::flat(point(inputs), normal(inputs).unwrap_or([0.0; 3]))),
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::Own("444"),
    log: Log::Points { file: "TCHPR444.html" },
};

/// A component of the normal: only the direction of all three together counts, so any length will do.
const fn component(number: u16, name: &'static str, axis: Axis) -> Parameter {
    Parameter::new(Key::Q(number), name, Range::Number { most: 10 }).means(Meaning::Normal(axis))
}

/// The nominal point.
fn point(inputs: &Inputs) -> [f64; 3] {
    [inputs.mm(263), inputs.mm(264), inputs.mm(294)]
}

/// The unit vector that points out of the material.
fn normal(inputs: &Inputs) -> Result<[f64; 3], CycleError> {
    let keys @ [first, second, third] = [581, 582, 583].map(Key::Q);
    direction(keys.map(|key| inputs.number(key))).ok_or(CycleError::NoNormal { first, second, third })
}

/// Runs the cycle on checked inputs.
///
/// The probing goes from a point on the normal to the nominal point; the ball's radius is taken into account along the
/// normal that was given, so a wrong normal gives a wrong deviation, as on the control.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let normal = normal(inputs)?;
    let inwards = normal.map(|part| -part);
    let ball_radius = course.ball_radius();
    let distance = ball_radius + inputs.probe().set_up.to_mm_f64() + inputs.mm(320);
    let touch = probing(inputs, along(point(inputs), normal, distance), inwards);
    course.needs_heights()?;
    course.pre_position_from_above(touch.from, inputs.mm(260));
    let ball = course.touch(&touch)?;
    let back =
        if inputs.value(RETRACT).is_some() { along(ball.place(), normal, inputs.mm(RETRACT)) } else { touch.from };
    course.retract(back);
    let contact = Contact::at(along(ball.place(), normal, -ball_radius));
    let (results, deviation) = measured(&contact, point(inputs), normal)?;
    let limits = inputs.band(TOLERANCE).map(|band| (band.lower(), band.upper()));
    // Above the band there is material to remove, below it too much is gone.
    let check = judged::size(ResultName::DEVIATION_ALONG, deviation, limits, Feature::Shaft);
    let checks: Vec<_> = check.into_iter().collect();
    // A typing mistake such as 0.1+0.2 for 0.1-0.2 must not switch off the monitoring unnoticed.
    let is_none = checks.is_empty() && inputs.is_given(TOLERANCE);
    let remarks = if is_none { vec![Remark::NoTolerance { key: TOLERANCE }] } else { Vec::new() };
    let status = check.map(|check| check.status);
    let stops = match inputs.whole(309) {
        1 => true,
        // Only undersize stops.
        2 => deviation < Length::ZERO,
        _ => false,
    };
    Ok(Measured {
        contacts: vec![contact],
        results: results.into_iter().chain([judged::status(status)]).collect(),
        status,
        stop: if stops { Stop::of(inputs.whole(309), &checks) } else { None },
        checks,
        remarks,
        ..Measured::default()
    })
}

/// Q151 to Q153 measured, Q161 to Q163 deviations, Q164 the deviation along the normal.
fn measured(
    contact: &Contact,
    point: [f64; 3],
    normal: [f64; 3],
) -> Result<([ResultParameter; 7], Length), CycleError> {
    let deviation @ [off_x, off_y, off_z] = along(contact.place(), point, -1.0);
    let off = nearest(dot(deviation, normal))?;
    let found = [
        ResultParameter::length(151, ResultName::POSITION_1, nearest(contact.x)?),
        ResultParameter::length(152, ResultName::POSITION_2, nearest(contact.y)?),
        ResultParameter::length(153, ResultName::POSITION_3, nearest(contact.z)?),
        ResultParameter::length(161, ResultName::DEVIATION_1, nearest(off_x)?),
        ResultParameter::length(162, ResultName::DEVIATION_2, nearest(off_y)?),
        ResultParameter::length(163, ResultName::DEVIATION_3, nearest(off_z)?),
        ResultParameter::length(164, ResultName::DEVIATION_ALONG, off),
    ];
    Ok((found, off))
}
