//! What cycles 421 and 422 share: three or four contacts on a circle, centre and diameter by least squares.
//!
//! Parameters, ranges and results as in the control's cycle manuals (TNC 320 and TNC7, cycles 421 and 422).

use super::probed::{clearance, probing};
use super::{judged, round};
use crate::length::Length;
use crate::probing::contact::Touch;
use crate::probing::cycle::shared::{
    CENTRE_1, CENTRE_2, CENTRE_TOLERANCE_1, CENTRE_TOLERANCE_2, CLEARANCE_HEIGHT, INCIDENCE_ANGLE, MEASURING_HEIGHT,
    MEASURING_LOG, MOVE_TO_CLEARANCE, REVERSED, SET_UP_CLEARANCE, STOP_IF_ERROR, TOOL,
};
use crate::probing::cycle::{
    Angle, Axis, CircleFound, Correction, Course, CycleError, CycleResult, FigureKind, Inputs, Key, LogFigure, Meaning,
    Measured, Parameter, ParameterName, Plane, QUARTER_TURN, Remark, ResultName, ResultParameter, Texts, limits,
};
use crate::probing::simulated::{Surface, Workpiece};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: not seen but the names of Q247, Q325 and Q365, which are those of other cycles. It: not seen.

/// The name of Q262.
const NOMINAL_DIAMETER: &str = "NOMINAL DIAMETER";
const NOMINAL_DIAMETERS: Texts = &[(Nl, "NOMINALE DIAMETER"), (De, "SOLL-DURCHMESSER"), (It, "DIAMETRO NOMINALE")];

/// The step between three contacts when Q247 is not given: with 90 degrees half the circle would be unmeasured.
const STEP_OF_THREE: i64 = Angle::from_degrees(120).ten_thousandths();

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

/// The declaration, in the order of NC programs.
pub(super) const fn parameters(side: &Side) -> [Parameter; 20] {
    const fn q(number: u16) -> Key {
        Key::Q(number)
    }
    [
        CENTRE_1,
        CENTRE_2,
        Parameter::size(q(262), NOMINAL_DIAMETER)
            .named(NOMINAL_DIAMETERS)
            .asked(&[
                (En, "Nominal diameter?"),
                (Nl, "Nominale diameter?"),
                (De, "Soll-Durchmesser?"),
                (It, "Diametro nominale?"),
            ])
            .means(Meaning::Diameter),
        Parameter::angle(q(325), "STARTING ANGLE", 360, 0)
            .named(&[(Nl, "STARTHOEK"), (De, "STARTWINKEL"), (It, "ANGOLO DI PARTENZA")])
            .asked(&[(En, "Starting angle?"), (Nl, "Starthoek?"), (De, "Startwinkel?"), (It, "Angolo di partenza?")])
            .or(0)
            .means(Meaning::FirstAngle),
        Parameter::angle(q(247), "STEPPING ANGLE", 120, 5)
            .named(&[(Nl, "HOEKSTAP"), (De, "WINKELSCHRITT"), (It, "INCREMENTO ANGOLARE")])
            .asked(&[
                (En, "Intermediate stepping angle?"),
                (Nl, "Hoekstap?"),
                (De, "Winkelschritt?"),
                (It, "Incremento angolare?"),
            ])
            .or(QUARTER_TURN)
            .or_where(q(423), 3, STEP_OF_THREE)
            .means(Meaning::Step),
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
        Parameter::choice(q(423), "NO. OF MEAS. POINTS", &[3, 4])
            .named(&[(Nl, "AANTAL MEETPUNTEN"), (De, "ANZAHL MESSPUNKTE"), (It, "N. PUNTI DI MISURA")])
            .asked(&[
                (En, "No. probe points in plane (4/3)?"),
                (Nl, "Aantal meetpunten in vlak (4/3)?"),
                (De, "Anzahl Antastungen Ebene (4/3)?"),
                (It, "N. tastature nel piano (4/3)?"),
            ])
            .or(4)
            .means(Meaning::ContactCount),
        Parameter::choice(q(365), "TYPE OF TRAVERSE", &[0, 1])
            .named(&[(Nl, "SOORT VERPLAATSING"), (De, "VERFAHRART"), (It, "TIPO DI TRAIETTORIA")])
            .asked(&[
                (En, "Type of traverse? Line=0/arc=1"),
                (Nl, "Soort verplaatsing? Recht=0/boog=1"),
                (De, "Verfahrart? Gerade=0/Kreis=1"),
                (It, "Tipo traiettoria? Retta=0/arco=1"),
            ])
            .or(1)
            .means(Meaning::Traverse),
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
    if nominal == Length::ZERO {
        return Err(CycleError::NoDiameter {
            key: Key::Q(262),
            name: ParameterName::new(NOMINAL_DIAMETER, NOMINAL_DIAMETERS),
        });
    }
    let ball_radius = course.ball_radius();
    let height = inputs.mm(260);
    let mut contacts = Vec::new();
    for touch in touches(side, inputs, ball_radius) {
        pre_position(inputs, &touch, contacts.is_empty(), course);
        contacts.push(course.touch(&touch)?);
        course.retract(touch.from);
    }
    course.leave(height);
    let centre = [inputs.length(273), inputs.length(274)];
    let tolerances = [inputs.length(279), inputs.length(280)];
    let (contacts, found) = round::found(contacts, side.feature, Plane::Xy, ball_radius, centre, tolerances)?;
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

/// The hole or shaft at its nominal size.
pub(super) fn surface(feature: Feature, inputs: &Inputs) -> Surface {
    Surface::Round(Workpiece::round(feature, [inputs.mm(273), inputs.mm(274)], inputs.mm(262)), Plane::Xy)
}

/// The nominal diameter, as the status window shows it.
pub(super) fn subject(inputs: &Inputs) -> String {
    inputs.length(262).to_string()
}

/// The contacts in order: at Q325 + k · Q247, from inside a hole or from outside a shaft.
fn touches(side: &Side, inputs: &Inputs, ball_radius: f64) -> Vec<Touch> {
    let x = inputs.mm(273);
    let y = inputs.mm(274);
    let height = inputs.mm(261);
    let radius = inputs.mm(262) / 2.0;
    let clearance = clearance(inputs);
    let (start, outward) = match side.feature {
        // In a small hole the probe starts at the centre.
        Feature::Hole => ((radius - clearance - ball_radius).max(0.0), 1.0),
        Feature::Shaft => (radius + clearance + ball_radius, -1.0),
    };
    let count = inputs.whole(423);
    let step = inputs.angle(247);
    // Q423 is 3 or 4.
    (0..4_u8)
        .take(usize::try_from(count).unwrap_or(4))
        .map(|number| {
            let [cos, sin] = inputs.angle(325).stepped(step, number).direction();
            probing(inputs, [x + start * cos, y + start * sin, height], [outward * cos, outward * sin, 0.0])
        })
        .collect()
}

/// From above to the first contact; to the others as Q301 says, and at measuring height as Q365 says.
fn pre_position(inputs: &Inputs, touch: &Touch, is_first: bool, course: &mut Course<'_>) {
    if is_first || inputs.whole(301) == 1 {
        course.pre_position_from_above(touch.from, inputs.mm(260));
    } else if inputs.whole(365) == 1 {
        course.pre_position_about(touch.from, [inputs.mm(273), inputs.mm(274), inputs.mm(261)]);
    } else {
        course.pre_position(touch.from);
    }
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
