//! The contacts of the cycles that measure a circle in the plane, and the parameters that say where they lie.

use super::probed::{clearance, probing};
use crate::length::Length;
use crate::probing::contact::{Contact, Touch};
use crate::probing::cycle::Plane;
use crate::probing::cycle::{
    Angle, Course, CycleError, Inputs, Key, Meaning, Parameter, ParameterName, QUARTER_TURN, Texts,
};
use crate::probing::simulated::{Surface, Workpiece};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: not seen but the names of Q247, Q325 and Q365, which are those of other cycles. It: not seen.

/// The name of Q262.
const DIAMETER_NAME: &str = "NOMINAL DIAMETER";
const DIAMETER_NAMES: Texts = &[(Nl, "NOMINALE DIAMETER"), (De, "SOLL-DURCHMESSER"), (It, "DIAMETRO NOMINALE")];

/// The step between three contacts when Q247 is not given: with 90 degrees half the circle would be unmeasured.
const STEP_OF_THREE: i64 = Angle::from_degrees(120).ten_thousandths();

/// The nominal diameter.
pub(super) const DIAMETER: Parameter = Parameter::size(Key::Q(262), DIAMETER_NAME)
    .named(DIAMETER_NAMES)
    .asked(&[
        (En, "Nominal diameter?"),
        (Nl, "Nominale diameter?"),
        (De, "Soll-Durchmesser?"),
        (It, "Diametro nominale?"),
    ])
    .means(Meaning::Diameter);
/// The angle of the first contact.
pub(super) const FIRST_ANGLE: Parameter = Parameter::angle(Key::Q(325), "STARTING ANGLE", 360, 0)
    .named(&[(Nl, "STARTHOEK"), (De, "STARTWINKEL"), (It, "ANGOLO DI PARTENZA")])
    .asked(&[(En, "Starting angle?"), (Nl, "Starthoek?"), (De, "Startwinkel?"), (It, "Angolo di partenza?")])
    .or(0)
    .means(Meaning::FirstAngle);
/// The angle from contact to contact.
pub(super) const STEP: Parameter = Parameter::angle(Key::Q(247), "STEPPING ANGLE", 120, 5)
    .named(&[(Nl, "HOEKSTAP"), (De, "WINKELSCHRITT"), (It, "INCREMENTO ANGOLARE")])
    .asked(&[
        (En, "Intermediate stepping angle?"),
        (Nl, "Hoekstap?"),
        (De, "Winkelschritt?"),
        (It, "Incremento angolare?"),
    ])
    .or(QUARTER_TURN)
    .or_where(Key::Q(423), 3, STEP_OF_THREE)
    .means(Meaning::Step);
/// The number of contacts.
pub(super) const COUNT: Parameter = Parameter::choice(Key::Q(423), "NO. OF MEAS. POINTS", &[3, 4])
    .named(&[(Nl, "AANTAL MEETPUNTEN"), (De, "ANZAHL MESSPUNKTE"), (It, "N. PUNTI DI MISURA")])
    .asked(&[
        (En, "No. probe points in plane (4/3)?"),
        (Nl, "Aantal meetpunten in vlak (4/3)?"),
        (De, "Anzahl Antastungen Ebene (4/3)?"),
        (It, "N. tastature nel piano (4/3)?"),
    ])
    .or(4)
    .means(Meaning::ContactCount);
/// The way between them.
pub(super) const TRAVERSE: Parameter = Parameter::choice(Key::Q(365), "TYPE OF TRAVERSE", &[0, 1])
    .named(&[(Nl, "SOORT VERPLAATSING"), (De, "VERFAHRART"), (It, "TIPO DI TRAIETTORIA")])
    .asked(&[
        (En, "Type of traverse? Line=0/arc=1"),
        (Nl, "Soort verplaatsing? Recht=0/boog=1"),
        (De, "Verfahrart? Gerade=0/Kreis=1"),
        (It, "Tipo traiettoria? Retta=0/arco=1"),
    ])
    .or(1)
    .means(Meaning::Traverse);

/// A hole or a shaft with its centre in parameters of the cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circle {
    pub(super) feature: Feature,
    /// The Q numbers of the nominal centre, first and second axis.
    pub(super) centre: [u16; 2],
}

impl Circle {
    fn centre(self, inputs: &Inputs) -> [f64; 2] {
        self.centre.map(|number| inputs.mm(number))
    }

    /// The nominal centre.
    pub(super) fn nominal(self, inputs: &Inputs) -> [Length; 2] {
        self.centre.map(|number| inputs.length(number))
    }

    /// The hole or shaft at its nominal size.
    pub(super) fn surface(self, inputs: &Inputs) -> Surface {
        Surface::Round(Workpiece::round(self.feature, self.centre(inputs), inputs.mm(262)), Plane::Xy)
    }

    /// Makes the contacts and leaves to the clearance height.
    pub(super) fn probe(self, inputs: &Inputs, course: &mut Course<'_>) -> Result<Vec<Contact>, CycleError> {
        if inputs.length(262) == Length::ZERO {
            let name = ParameterName::new(DIAMETER_NAME, DIAMETER_NAMES);
            return Err(CycleError::NoDiameter { key: Key::Q(262), name });
        }
        let mut contacts = Vec::new();
        for touch in self.touches(inputs, course.ball_radius()) {
            self.pre_position(inputs, &touch, contacts.is_empty(), course);
            contacts.push(course.touch(&touch)?);
            course.retract(touch.from);
        }
        course.leave(inputs.mm(260));
        Ok(contacts)
    }

    /// The contacts in order: at Q325 + k · Q247, from inside a hole or from outside a shaft.
    fn touches(self, inputs: &Inputs, ball_radius: f64) -> Vec<Touch> {
        let [x, y] = self.centre(inputs);
        let height = inputs.mm(261);
        let radius = inputs.mm(262) / 2.0;
        let clearance = clearance(inputs);
        let (start, outward) = match self.feature {
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
    fn pre_position(self, inputs: &Inputs, touch: &Touch, is_first: bool, course: &mut Course<'_>) {
        if is_first || inputs.whole(301) == 1 {
            course.pre_position_from_above(touch.from, inputs.mm(260));
        } else if inputs.whole(365) == 1 {
            let [x, y] = self.centre(inputs);
            course.pre_position_about(touch.from, [x, y, inputs.mm(261)]);
        } else {
            course.pre_position(touch.from);
        }
    }
}
