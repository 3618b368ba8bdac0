//! G785 of lathe controls, circle measurement: three contacts, centre and diameter, no limits.
//!
//! As in the manual of `MANUALplus` 620 and CNC PILOT 640 (54843x-03). Our interpretation where the manual says
//! nothing: angles count from the first axis of the plane to the second; a positive K leads away from the centre, a
//! negative one towards it; without D every probing begins at the present position, which is the nominal centre unless
//! set otherwise; I and J are 0 without input; `#i99` holds the diameter. Q, P and H are only in the example block:
//! they are accepted without effect.

use super::round;
use crate::length::Length;
use crate::probing::contact::{Contact, Touch};
use crate::probing::cycle::{
    Angle, Axis, Control, Course, Cycle, CycleError, Inputs, Key, Log, Meaning, Measured, Parameter, ParameterName,
    Plane, Remark, ResultName, ResultParameter, Texts, Window, nearest,
};
use crate::probing::simulated::{Surface, Workpiece};
use crate::probing::vector::{along, norm};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: names of parameters not seen. It: not seen.

const PLANE: Key = Key::Word("R");
const SIDE: Key = Key::Word("BR");
const PATH: Key = Key::Word("K");
const PATH_NAME: &str = "MEASURING PATH";
const PATH_NAMES: Texts = &[(Nl, "TASTWEG"), (De, "MESSWEG"), (It, "CORSA DI MISURA")];
const FIRST_ANGLE: Key = Key::Word("C");
const STEP: Key = Key::Word("RC");
const START_DIAMETER: Key = Key::Word("D");
const HEIGHT: Key = Key::Word("WB");
const CENTRE_1: Key = Key::Word("I");
const CENTRE_2: Key = Key::Word("J");
const PERMITTED: Key = Key::Word("WE");

/// The number of contacts round the circle.
const TOUCHES: u8 = 3;

/// The declaration, in the order of the manual's list.
pub(super) const CYCLE: Cycle = Cycle {
    number: 785,
    code: "G785",
    control: Control::Lathe,
    names: &[(En, "CIRCLE MEASUREMENT"), (Nl, "METEN CIRKEL"), (De, "KREISMESSUNG"), (It, "MISURAZIONE CERCHIO")],
    notes: &[],
    parameters: &[
        Parameter::choice(PLANE, "PLANE", &[0, 1, 2])
            .named(&[(Nl, "VLAK"), (De, "EBENE"), (It, "PIANO")])
            .asked(&[
                (En, "Plane (0=X/Y, 1=Z/X, 2=Y/Z)"),
                (Nl, "Vlak (0=X/Y, 1=Z/X, 2=Y/Z)"),
                (De, "Nullpunkt-Verschiebung Art"),
                (It, "Piano (0=X/Y, 1=Z/X, 2=Y/Z)"),
            ])
            .or(0)
            .means(Meaning::Plane),
        Parameter::choice(SIDE, "INSIDE / OUTSIDE", &[0, 1])
            .named(&[(Nl, "BINNEN / BUITEN"), (De, "INNEN / AUSSEN"), (It, "INTERNO / ESTERNO")])
            .asked(&[
                (En, "Inside / outside (0/1)"),
                (Nl, "Binnen / buiten"),
                (De, "Innen / Aussen"),
                (It, "Interno / esterno"),
            ])
            .or(0)
            .means(Meaning::InsideOutside),
        Parameter::coordinate(PATH, PATH_NAME)
            .named(PATH_NAMES)
            .asked(&[
                (En, "Measuring path (with sign)"),
                (Nl, "Tastweg incrementeel (met teken)"),
                (De, "Messweg inkremental (Vorzeichen)"),
                (It, "Corsa di misura increm. (segno)"),
            ])
            .means(Meaning::Path),
        Parameter::angle(FIRST_ANGLE, "ANGLE OF 1ST TOUCH", 360, 0)
            .named(&[(Nl, "HOEK 1E METING"), (De, "WINKEL 1. MESSUNG"), (It, "ANGOLO 1. MISURAZ.")])
            .asked(&[
                (En, "Angle of 1st measurement"),
                (Nl, "Hoek 1e meting"),
                (De, "Winkel 1. Messung"),
                (It, "Angolo 1. misurazione"),
            ])
            .or(0)
            .means(Meaning::FirstAngle),
        Parameter::angle(STEP, "ANGLE STEP", 360, 0)
            .named(&[(Nl, "HOEKSTAP"), (De, "WINKELSCHRITT"), (It, "INCREMENTO ANGOLARE")])
            .asked(&[
                (En, "Incremental angle"),
                (Nl, "Hoekstap incrementeel"),
                (De, "Winkel inkremental"),
                (It, "Angolo incrementale"),
            ])
            .means(Meaning::Step),
        Parameter::size(START_DIAMETER, "START DIAMETER")
            .named(&[(Nl, "STARTDIAMETER"), (De, "STARTDURCHMESSER"), (It, "DIAMETRO INIZIALE")])
            .asked(&[
                (En, "Start diameter"),
                (Nl, "Startdiameter"),
                (De, "Startdurchmesser"),
                (It, "Diametro iniziale"),
            ])
            .or_nothing()
            .means(Meaning::StartDiameter),
        Parameter::coordinate(HEIGHT, "MEASURING HEIGHT")
            .named(&[(Nl, "MEETHOOGTE"), (De, "MESSHOEHE"), (It, "ALTEZZA MISURATA")])
            .asked(&[
                (En, "Measuring height"),
                (Nl, "Meethoogte"),
                (De, "Position Zustellrichtung"),
                (It, "Altezza di misura"),
            ])
            .or_nothing()
            .means(Meaning::MeasuringHeight),
        Parameter::coordinate(CENTRE_1, "CENTER IN 1ST AXIS")
            .named(&[(Nl, "MIDDEN 1E AS"), (De, "MITTE 1. ACHSE"), (It, "CENTRO 1. ASSE")])
            .asked(&[
                (En, "Circle center 1st axis"),
                (Nl, "Midden 1e as"),
                (De, "Kreismittelpunkt Achse 1"),
                (It, "Centro cerchio asse 1"),
            ])
            .or(0)
            .means(Meaning::Centre(Axis::First)),
        Parameter::coordinate(CENTRE_2, "CENTER IN 2ND AXIS")
            .named(&[(Nl, "MIDDEN 2E AS"), (De, "MITTE 2. ACHSE"), (It, "CENTRO 2. ASSE")])
            .asked(&[
                (En, "Circle center 2nd axis"),
                (Nl, "Midden 2e as"),
                (De, "Kreismittelpunkt Achse 2"),
                (It, "Centro cerchio asse 2"),
            ])
            .or(0)
            .means(Meaning::Centre(Axis::Second)),
        Parameter::size(PERMITTED, "MAXIMUM DIFFERENCE")
            .named(&[(Nl, "MAXIMAAL VERSCHIL"), (De, "MAXIMALE ABWEICHUNG"), (It, "SCOSTAMENTO MASSIMO")])
            .asked(&[
                (En, "Maximum difference"),
                (Nl, "Maximaal verschil"),
                (De, "Maximale Abweichung"),
                (It, "Scostamento massimo"),
            ])
            .or_nothing()
            .means(Meaning::Difference),
        Parameter::coordinate(Key::Word("Q"), "Q").or(0).without_effect(),
        Parameter::coordinate(Key::Word("P"), "P").or(0).without_effect(),
        Parameter::coordinate(Key::Word("H"), "H").or(0).without_effect(),
    ],
    surface,
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::Screen,
};

fn plane(inputs: &Inputs) -> Plane {
    match inputs.whole(PLANE) {
        1 => Plane::Zx,
        2 => Plane::Yz,
        _ => Plane::Xy,
    }
}

fn feature(inputs: &Inputs) -> Feature {
    if inputs.whole(SIDE) == 1 { Feature::Shaft } else { Feature::Hole }
}

fn centre(inputs: &Inputs) -> [f64; 2] {
    [inputs.mm(CENTRE_1), inputs.mm(CENTRE_2)]
}

/// The circle that a ball without a radius meets half-way along K: the cycle has no nominal diameter.
fn surface(inputs: &Inputs) -> Surface {
    let reached = inputs.mm(START_DIAMETER) / 2.0 + inputs.mm(PATH) / 2.0;
    Surface::Round(Workpiece::round(feature(inputs), centre(inputs), 2.0 * reached.abs()), plane(inputs))
}

/// Where the probings begin and in which direction they go, in plane coordinates.
fn touches(inputs: &Inputs) -> Vec<Touch> {
    let plane = plane(inputs);
    let [first, second] = centre(inputs);
    // The present position; nominal centre and height 0 where none was set.
    let present = inputs.position().map_or([first, second, 0.0], |place| plane.within(place));
    let [present_1, present_2, present_height] = present;
    let height = if inputs.value(HEIGHT).is_some() { inputs.mm(HEIGHT) } else { present_height };
    let path = inputs.mm(PATH);
    let sign = path.signum();
    let radius = inputs.value(START_DIAMETER).map(|_diameter| inputs.mm(START_DIAMETER) / 2.0);
    (0..TOUCHES)
        .map(|number| {
            let angle: Angle = inputs.angle(FIRST_ANGLE).stepped(inputs.angle(STEP), number);
            let [cos, sin] = angle.direction();
            let from = match radius {
                Some(radius) => [first + radius * cos, second + radius * sin, height],
                None => [present_1, present_2, height],
            };
            Touch {
                from: plane.place(from),
                direction: plane.place([sign * cos, sign * sin, 0.0]),
                longest: path.abs(),
            }
        })
        .collect()
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    if inputs.length(PATH) == Length::ZERO {
        return Err(CycleError::NoPath { key: PATH, name: ParameterName::new(PATH_NAME, PATH_NAMES) });
    }
    let plane = plane(inputs);
    if plane != Plane::Xy {
        course.needs_heights()?;
    }
    let [first, second] = centre(inputs);
    if inputs.position().is_none() && inputs.value(START_DIAMETER).is_none() {
        course.begin_anywhere();
    }
    let mut contacts = Vec::new();
    for touch in touches(inputs) {
        let [_, _, height] = plane.within(touch.from);
        if contacts.is_empty() || inputs.value(START_DIAMETER).is_none() {
            course.pre_position(touch.from);
        } else {
            course.pre_position_about(touch.from, plane.place([first, second, height]));
        }
        contacts.push(contact(&touch, contacts.len() + 1, inputs, course)?);
    }
    let nominal = [inputs.length(CENTRE_1), inputs.length(CENTRE_2)];
    let (contacts, found) =
        round::found(contacts, feature(inputs), plane, course.ball_radius(), nominal, [Length::ZERO; 2])?;
    let [centre_1, centre_2] = found.centre;
    // The screen shows the centre; its name there is not documented.
    let [axis_1, axis_2] = plane.axes().map(Key::Word);
    Ok(Measured {
        contacts,
        results: vec![
            ResultParameter::length(Key::Word("#i99"), ResultName::DIAMETER, found.diameter),
            ResultParameter::length(axis_1, ResultName::CENTRE_1, centre_1),
            ResultParameter::length(axis_2, ResultName::CENTRE_2, centre_2),
        ],
        circle: Some(found),
        remarks: vec![Remark::VariableHoldsDiameter],
        ..Measured::default()
    })
}

/// One contact; with WE the mean of two probings, which must agree.
fn contact(touch: &Touch, number: usize, inputs: &Inputs, course: &mut Course<'_>) -> Result<Contact, CycleError> {
    let one = course.touch(touch)?;
    course.retract(touch.from);
    if inputs.value(PERMITTED).is_none() {
        return Ok(one);
    }
    let other = course.touch(touch)?;
    course.retract(touch.from);
    let one = one.place();
    let other = other.place();
    // Both lie on the line of the probing.
    let difference = nearest(norm(along(one, other, -1.0)))?;
    let most = inputs.length(PERMITTED);
    if most < difference {
        return Err(CycleError::Apart { contact: number, difference, key: PERMITTED, most });
    }
    // The mean, without any rounding where both are the same.
    Ok(Contact::at(along(one, along(other, one, -1.0), 0.5)))
}
