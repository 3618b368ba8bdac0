//! The contacts of the cycles that measure a circle in the plane, and the parameters that say where they lie.

use super::probed::{clearance, probing};
use crate::length::Length;
use crate::probing::contact::{Contact, Touch};
use crate::probing::cycle::{
    Angle, Course, CycleError, Inputs, Key, Meaning, Parameter, ParameterName, Plane, QUARTER_TURN, Texts,
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

/// A hole or a shaft that is probed at a height, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Round {
    pub(super) feature: Feature,
    pub(super) centre: [f64; 2],
    pub(super) diameter: f64,
    pub(super) height: f64,
}

/// How the probe comes to the start of a probing.
#[derive(Debug, Clone, Copy)]
pub(super) enum Way {
    /// In a straight line.
    Straight,
    /// On an arc at measuring height.
    Arc,
    /// Over the clearance height.
    Over,
}

impl Circle {
    /// The nominal centre.
    pub(super) fn nominal(self, inputs: &Inputs) -> [Length; 2] {
        self.centre.map(|number| inputs.length(number))
    }

    fn round(self, inputs: &Inputs) -> Round {
        let centre = self.centre.map(|number| inputs.mm(number));
        Round { feature: self.feature, centre, diameter: inputs.mm(262), height: inputs.mm(261) }
    }

    /// The hole or shaft at its nominal size.
    pub(super) fn surface(self, inputs: &Inputs) -> Surface {
        self.round(inputs).surface()
    }

    /// Makes the contacts, at Q325 + k · Q247, and leaves to the clearance height: from above to the first one, to the others as Q301
    /// says, and at measuring height as Q365 says.
    pub(super) fn probe(self, inputs: &Inputs, course: &mut Course<'_>) -> Result<Vec<Contact>, CycleError> {
        if inputs.length(262) == Length::ZERO {
            let name = ParameterName::new(DIAMETER_NAME, DIAMETER_NAMES);
            return Err(CycleError::NoDiameter { key: Key::Q(262), name });
        }
        // Q423 is 3 or 4.
        let count = usize::try_from(inputs.whole(423)).unwrap_or(4);
        let angles = (0..4_u8).take(count).map(|number| inputs.angle(325).stepped(inputs.angle(247), number));
        let next = match (inputs.whole(301), inputs.whole(365)) {
            (1, _) => Way::Over,
            (_, 1) => Way::Arc,
            _ => Way::Straight,
        };
        let contacts = self.round(inputs).probe(angles, [Way::Over, next], inputs, course)?;
        course.leave(inputs.mm(260));
        Ok(contacts)
    }
}

impl Round {
    pub(super) fn surface(self) -> Surface {
        Surface::Round(Workpiece::round(self.feature, self.centre, self.diameter), Plane::Xy)
    }

    /// Makes a contact at each angle; the first way leads to the first one, the second to each of the others.
    pub(super) fn probe(
        self,
        angles: impl Iterator<Item = Angle>,
        [first, next]: [Way; 2],
        inputs: &Inputs,
        course: &mut Course<'_>,
    ) -> Result<Vec<Contact>, CycleError> {
        let mut contacts = Vec::new();
        for angle in angles {
            let touch = self.touch(angle, inputs, course.ball_radius());
            let [x, y] = self.centre;
            match if contacts.is_empty() { first } else { next } {
                Way::Straight => course.pre_position(touch.from),
                Way::Arc => course.pre_position_about(touch.from, [x, y, self.height]),
                Way::Over => course.pre_position_from_above(touch.from, inputs.mm(260)),
            }
            contacts.push(course.touch(&touch)?);
            course.retract(touch.from);
        }
        Ok(contacts)
    }

    /// From inside a hole, or from outside a shaft.
    fn touch(self, angle: Angle, inputs: &Inputs, ball_radius: f64) -> Touch {
        let [x, y] = self.centre;
        let radius = self.diameter / 2.0;
        let clearance = clearance(inputs);
        let (start, outward) = match self.feature {
            // In a small hole the probe starts at the centre.
            Feature::Hole => ((radius - clearance - ball_radius).max(0.0), 1.0),
            Feature::Shaft => (radius + clearance + ball_radius, -1.0),
        };
        let [cos, sin] = angle.direction();
        probing(inputs, [x + start * cos, y + start * sin, self.height], [outward * cos, outward * sin, 0.0])
    }
}
