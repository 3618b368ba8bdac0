//! What cycles 425 and 426 share: two contacts on opposite walls along one axis, width and centre line.
//!
//! Parameters in the order of a public post-processor; results Q156, Q157 and Q166 as in the TNC7 manual for 425, those
//! of 426 by analogy. That too large a slot is scrap and too large a ridge is rework is our interpretation of the
//! control's error texts, as for 421 and 422. Walls at an angle to the measured axis are not corrected.

use super::judged;
use super::probed::{axis, coordinate};
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::{
    Axis, Correction, CycleError, CycleResult, FigureKind, Inputs, Key, LogFigure, Meaning, Measured, Parameter,
    Remark, ResultName, ResultParameter,
};
use crate::probing::simulated::{Surface, Walls};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: not seen. It: not seen for Q311, nor the question of Q272.

/// The measured axis, one of the two of the plane.
pub(super) const AXIS: Parameter = Parameter::choice(Key::Q(272), "MEASURING AXIS", &[1, 2])
    .named(&[(Nl, "MEETAS"), (De, "MESSACHSE"), (It, "ASSE MISURATO")])
    .asked(&[
        (En, "Meas. axis (1...2: 1=ref. axis)?"),
        (Nl, "Meetas (1..2: 1=hoofdas)?"),
        (De, "Messachse (1..2: 1=Hauptachse)?"),
        (It, "Asse mis. (1..2: 1=asse princ.)?"),
    ])
    .means(Meaning::AxisOfPlane);
/// The nominal width.
pub(super) const WIDTH: Parameter = Parameter::size(Key::Q(311), "NOMINAL LENGTH")
    .named(&[(Nl, "NOMINALE BREEDTE"), (De, "SOLL-LAENGE"), (It, "LUNGHEZZA NOMINALE")])
    .asked(&[(En, "Nominal length?"), (Nl, "Nominale breedte?"), (De, "Soll-Länge?"), (It, "Lunghezza nominale?")])
    .means(Meaning::Width);
/// The largest permitted width.
pub(super) const MAXIMUM: Parameter = Parameter::size(Key::Q(288), "MAXIMUM LIMIT")
    .named(&[(Nl, "MAXIMALE MAAT"), (De, "GROESSTMASS"), (It, "LIMITE MASSIMO")])
    .asked(&[
        (En, "Maximum limit of size?"),
        (Nl, "Maximale grensmaat?"),
        (De, "Größtmaß?"),
        (It, "Limite max dimensione?"),
    ])
    .or(0)
    .means(Meaning::MaximumWidth);
/// The smallest permitted width.
pub(super) const MINIMUM: Parameter = Parameter::size(Key::Q(289), "MINIMUM LIMIT")
    .named(&[(Nl, "MINIMALE MAAT"), (De, "KLEINSTMASS"), (It, "LIMITE MINIMO")])
    .asked(&[
        (En, "Minimum limit of size?"),
        (Nl, "Minimale grensmaat?"),
        (De, "Kleinstmaß?"),
        (It, "Limite minimo dimensione?"),
    ])
    .or(0)
    .means(Meaning::MinimumWidth);

/// The figures of the log; their order is our choice.
pub(super) const FIGURES: &[LogFigure] = &[
    LogFigure { what: ResultName::WIDTH, word: "width", kind: FigureKind::Size(Meaning::Width) },
    LogFigure { what: ResultName::CENTRE_LINE, word: "centre-line", kind: FigureKind::Information },
];

/// The unit vector of the measured axis.
pub(super) fn along_axis(inputs: &Inputs) -> [f64; 3] {
    if axis(inputs) == Axis::Second { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] }
}

/// The walls at nominal size about a place.
pub(super) fn surface(feature: Feature, [x, y]: [f64; 2], inputs: &Inputs) -> Surface {
    let angle = if axis(inputs) == Axis::Second { 90.0 } else { 0.0 };
    Surface::Walls(Walls { angle, ..Walls::new(feature, [x, y], (inputs.mm(311), None)) })
}

/// The nominal width, as the status window shows it.
pub(super) fn subject(inputs: &Inputs) -> String {
    inputs.length(311).to_string()
}

/// Q166 corrects the tool's radius.
pub(super) fn corrects(feature: Feature, result: &CycleResult) -> Option<Correction> {
    Some(Correction::of_size(feature, result.length(ResultName::WIDTH_DEVIATION)?))
}

/// The results of two contacts on the walls.
pub(super) fn measured(
    feature: Feature,
    inputs: &Inputs,
    limits: Option<(Length, Length)>,
    contacts: [Contact; 2],
) -> Result<Measured, CycleError> {
    let [one, other] = contacts.each_ref().map(|contact| coordinate(contact, inputs));
    let (width, centre_line) = judged::between(one, other)?;
    let nominal = inputs.length(311);
    let checks = judged::size(ResultName::WIDTH, width, limits, feature).into_iter().collect();
    let results = vec![
        ResultParameter::length(156, ResultName::WIDTH, width),
        ResultParameter::length(157, ResultName::CENTRE_LINE, centre_line),
        ResultParameter::length(166, ResultName::WIDTH_DEVIATION, width.saturating_sub(nominal)),
    ];
    let is_outside = judged::is_outside(nominal, limits);
    let remarks = is_outside.then_some(Remark::NominalWidthOutsideLimits { nominal }).into_iter().collect();
    Ok(Measured { remarks, ..judged::measured(inputs, contacts.to_vec(), checks, results) })
}
