//! Cycle 1411, probing two circles: two holes or studs, or one of each, and how far the line through their centres is turned against the
//! nominal one.

use super::circle_probing::FIRST_ANGLE;
use super::nominal_cycle::{
    ARC, CLEARANCE_MODE, COUNT, CircleResults, DIAMETER, FIRST_CIRCLE, Findings, NominalCircle, POINT_1, POINT_2,
    POINT_3, REACTION, leave, ways,
};
use super::two_points::{ALIGN, CORRECTION, ROTATION, SECOND_1, SECOND_2, SECOND_3, by, confirms, rotation, turned};
use crate::length::Length;
use crate::probing::cycle::shared::{CLEARANCE_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{
    Axis, CircleFound, Control, Course, Cycle, CycleError, DatumAxis, Inputs, Key, Log, Meaning, Measured, Parameter,
    ResultName, Window,
};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 1411,
    code: "1411",
    control: Control::Milling,
    names: &[
        (En, "PROBING TWO CIRCLES"),
        (Nl, "TASTEN TWEE CIRKELS"),
        (De, "ANTASTEN ZWEI KREISE"),
        (It, "TAST. DUE CERCHI"),
    ],
    notes: &[],
    parameters: &[
        CENTRE[0],
        CENTRE[1],
        HEIGHT,
        DIAMETER,
        SECOND_CENTRE[0],
        SECOND_CENTRE[1],
        SECOND_HEIGHT,
        SECOND_DIAMETER,
        GEOMETRIES,
        COUNT,
        FIRST_ANGLE,
        ARC,
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        CLEARANCE_MODE,
        REACTION,
        ALIGN,
        CORRECTION,
        ROTATION,
    ],
    surface: |inputs| first(inputs).round(inputs).surface(),
    run,
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};

const CENTRE: [Parameter; 2] =
    [POINT_1.means(Meaning::Centre(Axis::First)), POINT_2.means(Meaning::Centre(Axis::Second))];
const HEIGHT: Parameter = POINT_3.means(Meaning::MeasuringHeight);
const SECOND_CENTRE: [Parameter; 2] =
    [SECOND_1.means(Meaning::SecondCentre(Axis::First)), SECOND_2.means(Meaning::SecondCentre(Axis::Second))];
const SECOND_HEIGHT: Parameter = SECOND_3.means(Meaning::SecondHeight);
/// The nominal diameter of the second.
const SECOND_DIAMETER: Parameter = Parameter::nominal_size(1117, "DIAMETER 2")
    .named(&[(Nl, "DIAMETER 2"), (De, "DURCHMESSER 2"), (It, "DIAMETRO 2")])
    .asked(&[(En, "Diameter 2?"), (Nl, "Diameter 2?"), (De, "Durchmesser 2?"), (It, "Diametro 2?")])
    .means(Meaning::SecondDiameter);
/// Holes or studs. That 2 is a hole and a stud, and 3 the other way round, is remembered weakly.
const GEOMETRIES: Parameter = Parameter::choice(Key::Q(1115), "GEOMETRY TYPE", &[0, 1, 2, 3])
    .named(&[(Nl, "GEOMETRIETYPE"), (De, "GEOMETRIETYP"), (It, "TIPO DI GEOMETRIA")])
    .asked(&[
        (En, "Geometry type (0...3)?"),
        (Nl, "Geometrietype (0...3)?"),
        (De, "Geometrietyp (0...3)?"),
        (It, "Tipo di geometria (0...3)?"),
    ])
    .or(0)
    .means(Meaning::Geometries);

/// Q953 and Q954 its centre, Q967 its diameter, Q983, Q984 and Q997 the deviations.
const SECOND_CIRCLE: CircleResults = CircleResults {
    centre: [
        ([953, 983], [ResultName::new("found-second-position-1"), ResultName::new("found-second-deviation-1")]),
        ([954, 984], [ResultName::new("found-second-position-2"), ResultName::new("found-second-deviation-2")]),
    ],
    diameter: (
        [967, 997],
        [ResultName::new("found-second-diameter"), ResultName::new("found-second-diameter-deviation")],
    ),
};

fn first(inputs: &Inputs) -> NominalCircle {
    let feature = if matches!(inputs.whole(GEOMETRIES.key), 1 | 3) { Feature::Shaft } else { Feature::Hole };
    NominalCircle { feature, centre: CENTRE, height: HEIGHT, diameter: DIAMETER }
}

fn second(inputs: &Inputs) -> NominalCircle {
    let feature = if matches!(inputs.whole(GEOMETRIES.key), 1 | 2) { Feature::Shaft } else { Feature::Hole };
    NominalCircle { feature, centre: SECOND_CENTRE, height: SECOND_HEIGHT, diameter: SECOND_DIAMETER }
}

/// Runs the cycle on checked inputs.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let turns = confirms(inputs)?;
    let circles = [first(inputs), second(inputs)];
    for circle in &circles {
        circle.check(inputs)?;
    }
    let targets = [CENTRE, SECOND_CENTRE].map(|centre| centre.map(|of| inputs.nominal(of.key).target()));
    let [from, to] = targets;
    if from == to {
        let [(first, _), (second, _)] = [CENTRE, SECOND_CENTRE].map(|[one, other]| (one.key, other.key));
        return Err(CycleError::NoEdge { first, second });
    }
    let [one, other] = &circles;
    let [way, next] = ways(inputs);
    let (mut contacts, found) = one.probe([way, next], inputs, course)?;
    if inputs.whole(CLEARANCE_MODE.key) != -1 {
        course.leave(inputs.mm(260));
    }
    let (more, second) = other.probe([way, next], inputs, course)?;
    leave(inputs, course);
    contacts.extend(more);
    let mut findings = Findings::default();
    one.add(&found, &FIRST_CIRCLE, inputs, &mut findings);
    other.add(&second, &SECOND_CIRCLE, inputs, &mut findings);
    findings.correct_by(corrections(targets, [&found, &second], inputs));
    let place = |[x, y]: [Length; 2]| [x.to_mm_f64(), y.to_mm_f64(), 0.0];
    let turned = turned(targets.map(place), [place(found.centre), place(second.centre)]);
    findings.also(rotation(turned));
    let rotation = turns.then_some(by(turned));
    Ok(Measured { rotation, ..findings.measured(inputs, contacts) })
}

/// By which centre the active preset is corrected: the first, the second, the middle of both.
fn corrections(targets: [[Length; 2]; 2], found: [&CircleFound; 2], inputs: &Inputs) -> Vec<DatumAxis> {
    let [from, to] = targets;
    let [one, other] = found.map(|found| found.centre);
    let pairs = |wanted: [Length; 2], measured: [Length; 2]| {
        let axes = [Axis::First, Axis::Second].into_iter().zip(measured).zip(wanted);
        axes.map(|((axis, measured), wanted)| DatumAxis { axis, measured, wanted }).collect()
    };
    let middle = |[x, y]: [Length; 2], [to_x, to_y]: [Length; 2]| [x.midpoint(to_x), y.midpoint(to_y)];
    match inputs.whole(CORRECTION.key) {
        2 => pairs(to, other),
        3 => pairs(middle(from, to), middle(one, other)),
        _ => pairs(from, one),
    }
}
