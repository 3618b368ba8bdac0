//! What cycles 423 and 424 share: four contacts on the walls of a rectangle, centre and sides.
//!
//! Parameters and ranges as in the cycle manual of the TNC 320, their order and names as in a public post-processor;
//! results and course as in the manual of the TNC7. Our interpretation: contacts 1 to 4 lie in plus direction of the
//! first axis, plus of the second, minus of the first and minus of the second, on the axes through the nominal centre;
//! a side is the distance of its two contacts, the centre their middle, and a rectangle that is turned is not
//! corrected. A pocket side that is too large is scrap, one that is too small is rework; for a boss it is the reverse,
//! as the control's error texts say. A centre out of position counts as scrap.

use super::judged;
use super::walls_probing::{About, Rectangle, sides};
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{
    CENTRE_1, CENTRE_2, CENTRE_TOLERANCE_1, CENTRE_TOLERANCE_2, CLEARANCE_HEIGHT, MEASURING_HEIGHT, MEASURING_LOG,
    MOVE_TO_CLEARANCE, SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Axis, Correction, Course, CycleError, CycleResult, FigureKind, Inputs, Key, LogFigure, Meaning, Measured,
    Parameter, ResultName, ResultParameter, limits,
};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

/// The nominal length of the side along the first axis.
pub(super) const SIDE_1: Parameter = Parameter::size(Key::Q(282), "FIRST SIDE LENGTH")
    .named(&[(Nl, "LENGTE 1E ZIJDE"), (De, "1. SEITEN-LAENGE"), (It, "LUNGHEZZA 1. LATO")])
    .asked(&[
        (En, "1st side length (nominal value)?"),
        (Nl, "Lengte 1e zijde (nom. waarde)?"),
        (De, "1. Seitenlänge (Sollwert)?"),
        (It, "Lunghezza 1. lato (valore nom.)?"),
    ])
    .means(Meaning::Side(Axis::First));
/// Along the second.
pub(super) const SIDE_2: Parameter = Parameter::size(Key::Q(283), "2ND SIDE LENGTH")
    .named(&[(Nl, "LENGTE 2E ZIJDE"), (De, "2. SEITEN-LAENGE"), (It, "LUNGHEZZA 2. LATO")])
    .asked(&[
        (En, "2nd side length (nominal value)?"),
        (Nl, "Lengte 2e zijde (nom. waarde)?"),
        (De, "2. Seitenlänge (Sollwert)?"),
        (It, "Lunghezza 2. lato (valore nom.)?"),
    ])
    .means(Meaning::Side(Axis::Second));

/// The declaration, in the order of NC programs.
pub(super) const PARAMETERS: [Parameter; 17] = [
    CENTRE_1,
    CENTRE_2,
    SIDE_1,
    SIDE_2,
    MEASURING_HEIGHT,
    SET_UP_CLEARANCE,
    CLEARANCE_HEIGHT,
    MOVE_TO_CLEARANCE,
    Parameter::size(Key::Q(284), "MAX. LIMIT 1ST SIDE")
        .named(&[(Nl, "MAX. MAAT 1E ZIJDE"), (De, "GROESSTMASS 1. SEITE"), (It, "LIMITE MAX 1. LATO")])
        .asked(&[
            (En, "Max. size limit 1st side length?"),
            (Nl, "Maximale grensmaat 1e zijde?"),
            (De, "Größtmaß 1. Seitenlänge?"),
            (It, "Limite max lunghezza 1. lato?"),
        ])
        .or(0)
        .means(Meaning::MaximumSide(Axis::First)),
    Parameter::size(Key::Q(285), "MIN. LIMIT 1ST SIDE")
        .named(&[(Nl, "MIN. MAAT 1E ZIJDE"), (De, "KLEINSTMASS 1. SEITE"), (It, "LIMITE MIN. 1. LATO")])
        .asked(&[
            (En, "Min. size limit 1st side length?"),
            (Nl, "Minimale grensmaat 1e zijde?"),
            (De, "Kleinstmaß 1. Seitenlänge?"),
            (It, "Limite minimo lunghezza 1. lato?"),
        ])
        .or(0)
        .means(Meaning::MinimumSide(Axis::First)),
    Parameter::size(Key::Q(286), "MAX. LIMIT 2ND SIDE")
        .named(&[(Nl, "MAX. MAAT 2E ZIJDE"), (De, "GROESSTMASS 2. SEITE"), (It, "LIMITE MAX 2. LATO")])
        .asked(&[
            (En, "Max. size limit 2nd side length?"),
            (Nl, "Maximale grensmaat 2e zijde?"),
            (De, "Größtmaß 2. Seitenlänge?"),
            (It, "Limite max lunghezza 2. lato?"),
        ])
        .or(0)
        .means(Meaning::MaximumSide(Axis::Second)),
    Parameter::size(Key::Q(287), "MIN. LIMIT 2ND SIDE")
        .named(&[(Nl, "MIN. MAAT 2E ZIJDE"), (De, "KLEINSTMASS 2. SEITE"), (It, "LIMITE MIN. 2. LATO")])
        .asked(&[
            (En, "Min. size limit 2nd side length?"),
            (Nl, "Minimale grensmaat 2e zijde?"),
            (De, "Kleinstmaß 2. Seitenlänge?"),
            (It, "Limite minimo lunghezza 2. lato?"),
        ])
        .or(0)
        .means(Meaning::MinimumSide(Axis::Second)),
    CENTRE_TOLERANCE_1,
    CENTRE_TOLERANCE_2,
    MEASURING_LOG,
    STOP_IF_ERROR,
    TOOL,
];

/// The figures of the log; their order is our choice.
pub(super) const FIGURES: &[LogFigure] = &[
    LogFigure { what: ResultName::CENTRE_1, word: "centre-1", kind: FigureKind::Centre(Axis::First) },
    LogFigure { what: ResultName::CENTRE_2, word: "centre-2", kind: FigureKind::Centre(Axis::Second) },
    LogFigure { what: ResultName::SIDE_1, word: "side-1", kind: FigureKind::Size(Meaning::Side(Axis::First)) },
    LogFigure { what: ResultName::SIDE_2, word: "side-2", kind: FigureKind::Size(Meaning::Side(Axis::Second)) },
];

/// What is probed.
pub(super) const fn rectangle(feature: Feature) -> Rectangle {
    Rectangle { about: About { feature, centre: [273, 274] }, sides: [282, 283] }
}

/// Runs either cycle on checked inputs.
pub(super) fn run(feature: Feature, inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let limits = [limits(inputs, 285, 284)?, limits(inputs, 287, 286)?];
    let contacts = rectangle(feature).probe(inputs, course)?;
    measured(feature, inputs, limits, contacts)
}

/// Q164 corrects the tool's radius: only the first side counts.
pub(super) fn corrects(feature: Feature, result: &CycleResult) -> Option<Correction> {
    Some(Correction::of_size(feature, result.length(ResultName::SIDE_DEVIATION_1)?))
}

/// The results of four contacts on the walls: Q151, Q152 centre, Q154, Q155 sides, Q161 to Q165 their deviations.
fn measured(
    feature: Feature,
    inputs: &Inputs,
    [limits_1, limits_2]: [Option<(Length, Length)>; 2],
    contacts: Vec<Contact>,
) -> Result<Measured, CycleError> {
    let [(side_1, centre_1), (side_2, centre_2)] = sides(&contacts)?;
    let found = [centre_1, centre_2];
    let nominal = [inputs.length(273), inputs.length(274)];
    let position = judged::position(found, nominal, [inputs.length(279), inputs.length(280)]);
    let sides = [
        judged::size(ResultName::SIDE_1, side_1, limits_1, feature),
        judged::size(ResultName::SIDE_2, side_2, limits_2, feature),
    ];
    let centre = judged::centre(found, nominal, &position);
    let checks = sides.into_iter().flatten().chain(centre).collect();
    let [axis_1, axis_2] = position.axes;
    let results = vec![
        ResultParameter::length(151, ResultName::CENTRE_1, centre_1),
        ResultParameter::length(152, ResultName::CENTRE_2, centre_2),
        ResultParameter::length(154, ResultName::SIDE_1, side_1),
        ResultParameter::length(155, ResultName::SIDE_2, side_2),
        ResultParameter::length(161, ResultName::CENTRE_DEVIATION_1, axis_1.deviation),
        ResultParameter::length(162, ResultName::CENTRE_DEVIATION_2, axis_2.deviation),
        ResultParameter::length(164, ResultName::SIDE_DEVIATION_1, side_1.saturating_sub(inputs.length(282))),
        ResultParameter::length(165, ResultName::SIDE_DEVIATION_2, side_2.saturating_sub(inputs.length(283))),
    ];
    Ok(judged::measured(inputs, contacts, checks, results))
}
