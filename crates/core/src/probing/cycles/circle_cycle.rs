//! What cycles 421 and 422 share: three or four contacts on a circle, centre and diameter by least squares.
//!
//! Parameters, ranges and results as in the control's cycle manuals (TNC 320 and TNC7, cycles 421 and 422).

use super::circle_probing::{COUNT, Circle, DIAMETER, FIRST_ANGLE, STEP, TRAVERSE};
use super::{judged, round};
use crate::length::Length;
use crate::probing::cycle::shared::{
    CENTRE_1, CENTRE_2, CENTRE_TOLERANCE_1, CENTRE_TOLERANCE_2, CLEARANCE_HEIGHT, INCIDENCE_ANGLE, MEASURING_HEIGHT,
    MEASURING_LOG, MOVE_TO_CLEARANCE, REVERSED, SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Axis, CircleFound, Correction, Course, CycleError, CycleResult, FigureKind, Inputs, Key, LogFigure, Meaning,
    Measured, Parameter, Plane, Remark, ResultName, ResultParameter, Texts, limits,
};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, It, Nl};

// De, It: not seen.

/// What differs between hole and shaft.
pub(super) struct Side {
    pub(super) feature: Feature,
    /// The Q number of the maximum dimension.
    pub(super) maximum: u16,
    /// Its question.
    pub(super) maximum_question: Texts,
    /// The Q number of the minimum dimension.
    pub(super) minimum: u16,
    /// Its question.
    pub(super) minimum_question: Texts,
}

impl Side {
    /// What is probed.
    pub(super) const fn circle(&self) -> Circle {
        Circle { feature: self.feature, centre: [273, 274] }
    }
}

/// The declaration, in the order of NC programs.
pub(super) const fn parameters(side: &Side) -> [Parameter; 20] {
    const fn q(number: u16) -> Key {
        Key::Q(number)
    }
    [
        CENTRE_1,
        CENTRE_2,
        DIAMETER,
        FIRST_ANGLE,
        STEP,
        MEASURING_HEIGHT.or(0),
        SET_UP_CLEARANCE,
        CLEARANCE_HEIGHT,
        MOVE_TO_CLEARANCE,
        Parameter::size(q(side.maximum), "MAXIMUM DIMENSION")
            .named(&[(Nl, "MAXIMALE MAAT"), (De, "GROESSTMASS"), (It, "DIMENSIONE MASSIMA")])
            .asked(side.maximum_question)
            .or(0)
            .means(Meaning::MaximumDiameter),
        Parameter::size(q(side.minimum), "MINIMUM DIMENSION")
            .named(&[(Nl, "MINIMALE MAAT"), (De, "KLEINSTMASS"), (It, "DIMENSIONE MINIMA")])
            .asked(side.minimum_question)
            .or(0)
            .means(Meaning::MinimumDiameter),
        CENTRE_TOLERANCE_1,
        CENTRE_TOLERANCE_2,
        MEASURING_LOG,
        STOP_IF_ERROR,
        TOOL,
        COUNT,
        TRAVERSE,
        REVERSED,
        INCIDENCE_ANGLE,
    ]
}

/// The figures of the log.
pub(super) const fn figures(diameter: &'static str) -> [LogFigure; 3] {
    [
        LogFigure { what: ResultName::CENTRE_1, word: "centre-1", kind: FigureKind::Centre(Axis::First) },
        LogFigure { what: ResultName::CENTRE_2, word: "centre-2", kind: FigureKind::Centre(Axis::Second) },
        LogFigure { what: ResultName::DIAMETER, word: diameter, kind: FigureKind::Size(Meaning::Diameter) },
    ]
}

/// Runs either cycle on checked inputs.
pub(super) fn run(side: &Side, inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let limits = limits(inputs, side.minimum, side.maximum)?;
    let nominal = inputs.length(262);
    let circle = side.circle();
    let contacts = circle.probe(inputs, course)?;
    let centre = circle.nominal(inputs);
    let tolerances = [inputs.length(279), inputs.length(280)];
    let (contacts, found) = round::found(contacts, side.feature, Plane::Xy, course.ball_radius(), centre, tolerances)?;
    let checks = judged::size(ResultName::DIAMETER, found.diameter, limits, side.feature)
        .into_iter()
        .chain(judged::centre(found.centre, centre, &found.position))
        .collect();
    let results = results(&found, found.diameter.saturating_sub(nominal));
    let is_outside = judged::is_outside(nominal, limits);
    let remarks = is_outside.then_some(Remark::NominalOutsideLimits { nominal }).into_iter().collect();
    let measured = judged::measured(inputs, contacts, checks, results);
    Ok(Measured { circle: Some(found), remarks, ..measured })
}

/// Q163 corrects the tool's radius.
pub(super) fn corrects(side: &Side, result: &CycleResult) -> Option<Correction> {
    Some(Correction::of_size(side.feature, result.length(ResultName::DIAMETER_DEVIATION)?))
}

/// The nominal diameter, as the status window shows it.
pub(super) fn subject(inputs: &Inputs) -> String {
    inputs.length(262).to_string()
}

/// Q151 to Q153 measured, Q161 to Q163 deviations.
fn results(found: &CircleFound, deviation: Length) -> Vec<ResultParameter> {
    let [centre_1, centre_2] = found.centre;
    let [axis_1, axis_2] = found.position.axes;
    vec![
        ResultParameter::length(151, ResultName::CENTRE_1, centre_1),
        ResultParameter::length(152, ResultName::CENTRE_2, centre_2),
        ResultParameter::length(153, ResultName::DIAMETER, found.diameter),
        ResultParameter::length(161, ResultName::CENTRE_DEVIATION_1, axis_1.deviation),
        ResultParameter::length(162, ResultName::CENTRE_DEVIATION_2, axis_2.deviation),
        ResultParameter::length(163, ResultName::DIAMETER_DEVIATION, deviation),
    ]
}
