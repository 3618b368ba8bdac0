//! Cycle 427, measure coordinate: one contact along one axis, limits in Q288 and Q289.
//!
//! Parameters, ranges, result and notes as in the Italian manual of TNC7. Rework and scrap are those of an outside
//! dimension, as the cycle manual of the TNC 320 says: too large is rework, too small is scrap. That limits of 0 and 0 monitor
//! nothing is our interpretation: 0 may be a real coordinate.
//!
//! The manual asks for Q261 between Q276 and Q275, which this cycle does not have. What it can mean is the nominal value
//! of the measured axis between Q289 and Q288: a remark says where it is not. CAM systems write there where the probe stands before the
//! approach (`docs/SOURCES.md`): the face of a perfect workpiece then lies in the middle of the limits. The manual also says that deviations are
//! stored in Q parameters and names none for them: the deviation is a result without a parameter.

use super::judged;
use super::probed::{approach, coordinate, met_at, point};
use crate::length::Length;
use crate::probing::cycle::shared::{
    CLEARANCE_HEIGHT, DIRECTION, INCIDENCE_ANGLE, MEASURED_AXIS, MEASURING_HEIGHT, MEASURING_LOG, POINT_1, POINT_2,
    REVERSED, SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Control, Corrected, Correction, Course, Cycle, CycleError, CycleResult, FigureKind, Inputs, Key, Log, LogFigure,
    Meaning, Measured, Note, Parameter, Remark, ResultName, ResultParameter, TextLog, Window, limits, nearest,
};
use crate::probing::simulated::{Face, Surface};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: not seen.

/// The declaration, in the order of the manual's example.
pub(super) const CYCLE: Cycle = Cycle {
    number: 427,
    code: "427",
    control: Control::Milling,
    names: &[
        (En, "MEASURE COORDINATE"),
        (Nl, "METEN COORDINAAT"),
        (De, "MESSEN KOORDINATE"),
        (It, "MISURAZ. COORDINATA"),
    ],
    notes: &[Note::EndsRotation, Note::SoftwareOption { option: "#17 / #1-05-1" }, Note::Recommended { cycle: "1400" }],
    parameters: &[
        POINT_1,
        POINT_2,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        MEASURED_AXIS,
        DIRECTION,
        CLEARANCE_HEIGHT,
        MEASURING_LOG,
        Parameter::coordinate(Key::Q(288), "MAXIMUM LIMIT")
            .named(&[(Nl, "MAXIMALE MAAT"), (De, "GROESSTMASS"), (It, "LIMITE MASSIMO")])
            .asked(&[
                (En, "Maximum limit of size?"),
                (Nl, "Maximale grensmaat?"),
                (De, "Größtmaß?"),
                (It, "Limite max dimensione?"),
            ])
            .or(0)
            .means(Meaning::MaximumCoordinate),
        Parameter::coordinate(Key::Q(289), "MINIMUM LIMIT")
            .named(&[(Nl, "MINIMALE MAAT"), (De, "KLEINSTMASS"), (It, "LIMITE MINIMO")])
            .asked(&[
                (En, "Minimum limit of size?"),
                (Nl, "Minimale grensmaat?"),
                (De, "Kleinstmaß?"),
                (It, "Limite minimo dimensione?"),
            ])
            .or(0)
            .means(Meaning::MinimumCoordinate),
        STOP_IF_ERROR,
        TOOL,
        REVERSED,
        INCIDENCE_ANGLE,
    ],
    surface: |inputs| Surface::Face(Face::plane(face(inputs), approach(inputs).map(|part| -part))),
    run,
    subject: |inputs| {
        ["X", "Y", "Z"]
            .into_iter()
            .zip(1..)
            .find(|(_, axis)| *axis == inputs.whole(272))
            .map(|(name, _)| name.to_owned())
    },
    corrects,
    window: Window::Own("427"),
    log: Log::Text(TextLog {
        file: "TCHPR427.TXT",
        figures: &[LogFigure { what: ResultName::COORDINATE, word: "coordinate", kind: FigureKind::Coordinate }],
    }),
};

/// Where the face should be.
fn face(inputs: &Inputs) -> [f64; 3] {
    let [x, y, z] = point(inputs);
    let nominal = nominal(inputs).to_mm_f64();
    match inputs.whole(272) {
        1 => [nominal, y, z],
        2 => [x, nominal, z],
        _ => [x, y, nominal],
    }
}

/// The nominal value of the measured axis: the programmed one; the middle of the limits where that one is not between them, and they
/// lie ahead of it.
fn nominal(inputs: &Inputs) -> Length {
    let programmed = programmed(inputs);
    let limits = limits(inputs, 289, 288).ok().flatten();
    let middle = limits.map(|(minimum, maximum)| minimum.midpoint(maximum));
    let is_ahead = |middle: &Length| if inputs.whole(267) < 0 { *middle < programmed } else { programmed < *middle };
    middle.filter(is_ahead).filter(|_| judged::is_outside(programmed, limits)).unwrap_or(programmed)
}

/// The programmed value of the measured axis.
fn programmed(inputs: &Inputs) -> Length {
    inputs.length(Key::Q(match inputs.whole(272) {
        1 => 263,
        2 => 264,
        _ => 261,
    }))
}

/// The deviation from the middle of the limits corrects the radius in axis 1 and 2, the length in axis 3. In plus
/// direction the ball meets the lower wall: a smaller coordinate than wanted is material that a small tool has left. In
/// axis 3 a surface that is too high was cut by a tool that is shorter than its table says.
fn corrects(result: &CycleResult) -> Option<Correction> {
    let check = result.checks.first()?;
    let off = check.measured.saturating_sub(check.minimum.midpoint(check.maximum));
    Some(match (result.inputs.whole(272), result.inputs.whole(267)) {
        (3, _) => Correction { of: Corrected::Length, by: off.negated() },
        (_, 1) => Correction { of: Corrected::Radius, by: off },
        _ => Correction { of: Corrected::Radius, by: off.negated() },
    })
}

/// Runs the cycle on checked inputs.
///
/// Axis 1 and 2 take the ball's radius into account, axis 3 the probe's length. For a ball whose lowest point is at the
/// probe's length that is the same: the surface lies a radius ahead of the ball's centre.
fn run(inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let limits = limits(inputs, 289, 288)?;
    if inputs.whole(272) == 3 {
        course.needs_heights()?;
    }
    let contact = met_at(point(inputs), approach(inputs), inputs, course)?;
    course.leave(inputs.mm(260));
    let measured = nearest(coordinate(&contact, inputs))?;
    let checks: Vec<_> = judged::size(ResultName::COORDINATE, measured, limits, Feature::Shaft).into_iter().collect();
    let programmed = programmed(inputs);
    let nominal = nominal(inputs);
    let mut remarks = Vec::new();
    if judged::is_outside(programmed, limits) {
        remarks.push(Remark::NominalCoordinateOutsideLimits { nominal: programmed });
    }
    if !checks.is_empty() {
        remarks.extend([Remark::OutsideDimension, Remark::DeviationWithoutParameter]);
    }
    let results = vec![
        ResultParameter::length(160, ResultName::COORDINATE, measured),
        ResultParameter::without_key(ResultName::COORDINATE_DEVIATION, measured.saturating_sub(nominal)),
    ];
    // The markers are set even without limits.
    Ok(Measured { remarks, ..judged::measured(inputs, vec![contact], checks, results) })
}
