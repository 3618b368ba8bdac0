//! What 1410 and 1411 share: the second point, and how far the line through both points is turned against the nominal one.
//!
//! Q964 is that angle. With Q1121 = 1 the basic rotation grows by it; a move of rotary axes (Q1126, Q1121 = 2) is refused.

use crate::probing::cycle::{
    Angle, Axis, CycleError, DatumTarget, Inputs, Key, Meaning, NewRotation, Parameter, ResultName, ResultParameter,
    TurnedBy,
};
use crate::words::Dialogue::{De, En, It, Nl};

use super::nominal_cycle::PRESET;

// De, Nl, It: not seen.

/// The second point, first axis.
pub(super) const SECOND_1: Parameter = Parameter::nominal_coordinate(1103, "2ND POINT REF AXIS")
    .named(&[(Nl, "2E PUNT HOOFDAS"), (De, "2.PUNKT HAUPTACHSE"), (It, "2. PUNTO ASSE PRINC.")])
    .asked(&[
        (En, "2nd nominal position of ref. axis?"),
        (Nl, "2e nominale positie hoofdas?"),
        (De, "2. Sollposition Hauptachse?"),
        (It, "2. posizione nom. asse princ.?"),
    ])
    .means(Meaning::NextPoint(Axis::First));
/// Second axis.
pub(super) const SECOND_2: Parameter = Parameter::nominal_coordinate(1104, "2ND POINT MINOR AXIS")
    .named(&[(Nl, "2E PUNT NEVENAS"), (De, "2.PUNKT NEBENACHSE"), (It, "2. PUNTO ASSE SECOND.")])
    .asked(&[
        (En, "2nd nominal position of minor axis?"),
        (Nl, "2e nominale positie nevenas?"),
        (De, "2. Sollposition Nebenachse?"),
        (It, "2. posizione nom. asse second.?"),
    ])
    .means(Meaning::NextPoint(Axis::Second));
/// Third axis.
pub(super) const SECOND_3: Parameter = Parameter::nominal_coordinate(1105, "2ND POINT TOOL AXIS")
    .named(&[(Nl, "2E PUNT GS-AS"), (De, "2.PUNKT WZ-ACHSE"), (It, "2. PUNTO ASSE UTENS.")])
    .asked(&[
        (En, "2nd nominal position of tool axis?"),
        (Nl, "2e nominale positie gereedschapsas?"),
        (De, "2. Sollposition Werkzeugachse?"),
        (It, "2. posizione nom. asse utensile?"),
    ])
    .means(Meaning::NextPoint(Axis::Third));
/// Whether a rotary axis is aligned.
pub(super) const ALIGN: Parameter = Parameter::choice(Key::Q(1126), "ALIGN ROTARY AXIS", &[0, 1, 2])
    .named(&[(Nl, "ROTATIEAS UITLIJNEN"), (De, "DREHACHSEN AUSRICHTEN"), (It, "ALLINEARE ASSE ROT.")])
    .asked(&[
        (En, "Align rotary axis (0/1/2)?"),
        (Nl, "Rotatieas uitlijnen (0/1/2)?"),
        (De, "Drehachse ausrichten (0/1/2)?"),
        (It, "Allineare asse rotativo (0/1/2)?"),
    ])
    .or(0)
    .means(Meaning::RotaryAlignment);
/// By which point the active preset is corrected: the first, the second, the middle of both.
pub(super) const CORRECTION: Parameter = PRESET.of(&[0, 1, 2, 3]);
/// What becomes of the rotation.
pub(super) const ROTATION: Parameter = Parameter::choice(Key::Q(1121), "CONFIRM ROTATION", &[0, 1, 2])
    .named(&[(Nl, "ROTATIE OVERNEMEN"), (De, "DREHUNG UEBERNEHMEN"), (It, "CONFERMA ROTAZIONE")])
    .asked(&[
        (En, "Confirm rotation (0/1/2)?"),
        (Nl, "Rotatie overnemen (0/1/2)?"),
        (De, "Drehung übernehmen (0/1/2)?"),
        (It, "Confermare rotazione (0/1/2)?"),
    ])
    .or(0)
    .means(Meaning::RotationTransfer);

/// From the first point to the second, in the plane.
pub(super) fn line([from_x, from_y, _]: [f64; 3], [to_x, to_y, _]: [f64; 3]) -> [f64; 2] {
    [to_x - from_x, to_y - from_y]
}

/// How far the line through two points is turned against the nominal one, degrees.
pub(super) fn turned([from, to]: [[f64; 3]; 2], [found, found_to]: [[f64; 3]; 2]) -> f64 {
    let [wanted_1, wanted_2] = line(from, to);
    let [found_1, found_2] = line(found, found_to);
    libm::atan2(wanted_1 * found_2 - wanted_2 * found_1, wanted_1 * found_1 + wanted_2 * found_2).to_degrees()
}

/// That angle as a result.
pub(super) fn rotation(turned: f64) -> ResultParameter {
    ResultParameter::angle(964, ResultName::new("found-rotation"), Angle::nearest(turned))
}

/// The basic rotation that grows by it.
pub(super) const fn by(turned: f64) -> NewRotation {
    NewRotation { degrees: turned, by: TurnedBy::Rotation(DatumTarget::Active) }
}

/// Whether the angle becomes a basic rotation.
///
/// # Errors
/// [`CycleError::NoRotation`] for a move of rotary axes, and for a rotation together with a correction: about which point the system turns
/// then is not known.
pub(super) fn confirms(inputs: &Inputs) -> Result<bool, CycleError> {
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
