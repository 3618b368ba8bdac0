//! Cycle 400, basic rotation: the angle of an edge becomes the rotation of the system about the active datum.
//!
//! A rotation in force ends before the contacts; that, and that Q150 holds the angle, is remembered (`docs/SOURCES.md`, "Angle and
//! rotation"). An edge along the minor axis is turned against that axis, so that it lies along it afterwards.

use super::datum_cycle::ROW;
use super::line_probing::{probe, result, surface, turned};
use super::width_cycle::AXIS;
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, DIRECTION, MEASURING_HEIGHT, MOVE_TO_CLEARANCE, POINT_1, POINT_2, SECOND_POINT_1, SECOND_POINT_2,
    SET_UP_CLEARANCE,
};
use crate::probing::cycle::{
    Control, Course, Cycle, CycleError, DatumTarget, Inputs, Key, Log, Meaning, Measured, NewRotation, Note, Parameter,
    TurnedBy, Window,
};
use crate::words::Dialogue::{De, En, It, Nl};

// Nl, It: ours.

const PRESET_ANGLE: Key = Key::Q(307);

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 400,
    code: "400",
    control: Control::Milling,
    names: &[(En, "BASIC ROTATION"), (Nl, "BASISROTATIE"), (De, "GRUNDDREHUNG"), (It, "ROTAZIONE BASE")],
    notes: &[Note::EndsRotation, Note::Recommended { cycle: "1410" }],
    parameters: &[
        POINT_1,
        POINT_2,
        SECOND_POINT_1,
        SECOND_POINT_2,
        AXIS,
        DIRECTION,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT.required(),
        MOVE_TO_CLEARANCE,
        Parameter::angle(PRESET_ANGLE, "PRESET ROTATION ANG.", 360, 0)
            .named(&[(Nl, "VOORINST. ROTATIEHOEK"), (De, "VOREINST. DREHW."), (It, "PREIMP. ANGOLO ROTAZ.")])
            .asked(&[
                (En, "Preset value for rotation angle"),
                (Nl, "Voorinstelling rotatiehoek?"),
                (De, "Voreinstellung Drehwinkel?"),
                (It, "Preimpostazione angolo rotaz.?"),
            ])
            .or(0)
            .means(Meaning::AlignedAngle),
        ROW,
    ],
    surface,
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let contacts = probe(inputs, course)?;
    let turned = turned(inputs, contacts);
    let by = TurnedBy::Rotation(match u32::try_from(inputs.whole(ROW.key)).unwrap_or(0) {
        0 => DatumTarget::Display,
        row => DatumTarget::Preset { row },
    });
    let degrees = turned - inputs.degrees(PRESET_ANGLE);
    Ok(Measured {
        contacts: contacts.to_vec(),
        results: vec![result(turned)],
        rotation: Some(NewRotation { degrees, by }),
        ..Measured::default()
    })
}
