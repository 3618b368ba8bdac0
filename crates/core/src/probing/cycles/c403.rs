//! Cycle 403, rotation in a rotary axis: the table turns an edge, or a face, into line.
//!
//! The axis moves by the measured angle less Q380; where its centre is only the machine knows. With Q312 = 0 the axis is the one about
//! which the angle was measured. Ranges differ from control to control; all of it but order and names is remembered (`docs/SOURCES.md`,
//! "Angle and rotation").

use super::datum_cycle::{ROW, TRANSFER, target};
use super::line_probing::{probe, result, surface, turned};
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, DIRECTION, MEASURED_AXIS, MEASURING_HEIGHT, MOVE_TO_CLEARANCE, POINT_1, POINT_2, SECOND_POINT_1,
    SECOND_POINT_2, SET_UP_CLEARANCE,
};
use crate::probing::cycle::{
    Control, Course, Cycle, CycleError, Inputs, Key, Log, Meaning, Measured, NewRotation, Note, Parameter, RotaryAxis,
    TurnedBy, Window,
};
use crate::words::Dialogue::{De, En, It, Nl};

// Nl, It: ours. De: remembered.

const COMPENSATION_AXIS: Key = Key::Q(312);
const SET_TO_ZERO: Key = Key::Q(337);
const REFERENCE_ANGLE: Key = Key::Q(380);

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 403,
    code: "403",
    control: Control::Milling,
    names: &[
        (En, "ROT IN ROTARY AXIS"),
        (Nl, "ROT. VIA ROTATIEAS"),
        (De, "ROT UEBER DREHACHSE"),
        (It, "ROT. SU ASSE ROTATIVO"),
    ],
    notes: &[Note::EndsRotation],
    parameters: &[
        POINT_1,
        POINT_2,
        SECOND_POINT_1,
        SECOND_POINT_2,
        MEASURED_AXIS,
        DIRECTION,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT.required(),
        MOVE_TO_CLEARANCE,
        Parameter::choice(COMPENSATION_AXIS, "COMPENSATION AXIS", &[0, 4, 5, 6])
            .named(&[(Nl, "COMPENSATIEAS"), (De, "AUSGLEICHSACHSE"), (It, "ASSE DI COMPENS.")])
            .asked(&[
                (En, "Axis for compensation motion?"),
                (Nl, "As voor compensatiebeweging?"),
                (De, "Achse für Ausgleichsbewegung?"),
                (It, "Asse per movimento compensaz.?"),
            ])
            .means(Meaning::CompensationAxis),
        Parameter::choice(SET_TO_ZERO, "SET TO ZERO", &[0, 1])
            .named(&[(Nl, "OP NUL ZETTEN"), (De, "NULL SETZEN"), (It, "AZZERARE")])
            .asked(&[
                (En, "Set to zero after alignment?"),
                (Nl, "Op nul zetten na uitlijnen?"),
                (De, "Nullsetzen nach Ausrichtung?"),
                (It, "Azzerare dopo allineamento?"),
            ])
            .or(0)
            .means(Meaning::ZeroAfterAlignment),
        ROW,
        TRANSFER,
        Parameter::angle(REFERENCE_ANGLE, "REFERENCE ANGLE", 360, 0)
            .named(&[(Nl, "REFERENTIEHOEK"), (De, "BEZUGSWINKEL"), (It, "ANGOLO DI RIFERIM.")])
            .asked(&[
                (En, "Ref. angle? (0=ref. axis)"),
                (Nl, "Referentiehoek? (0=hoofdas)"),
                (De, "Bezugswinkel? (0=Hauptachse)"),
                (It, "Angolo riferim.? (0=asse princ.)"),
            ])
            .or(0)
            .means(Meaning::AlignedAngle),
    ],
    surface,
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// The axis that turns: the one that is named, or the one about which the angle is.
fn axis(inputs: &Inputs) -> RotaryAxis {
    match inputs.whole(COMPENSATION_AXIS) {
        4 => RotaryAxis::A,
        5 => RotaryAxis::B,
        6 => RotaryAxis::C,
        _ => match inputs.whole(272) {
            1 | 2 => RotaryAxis::C,
            _ if inputs.length(263) == inputs.length(265) => RotaryAxis::A,
            _ => RotaryAxis::B,
        },
    }
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let is_zeroed = inputs.whole(SET_TO_ZERO) == 1;
    if is_zeroed {
        // A row without a table is found before anything turns.
        target(inputs)?;
    }
    let contacts = probe(inputs, course)?;
    let turned = turned(inputs, contacts);
    let degrees = turned - inputs.degrees(REFERENCE_ANGLE);
    let by = TurnedBy::Axis { axis: axis(inputs), is_zeroed };
    Ok(Measured {
        contacts: contacts.to_vec(),
        results: vec![result(turned)],
        rotation: Some(NewRotation { degrees, by }),
        ..Measured::default()
    })
}
