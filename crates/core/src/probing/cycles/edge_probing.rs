//! The contacts of cycles 14xx that probe points along an axis whose sign is the direction (Q372).

use super::circle_probing::Way;
use super::judged;
use super::nominal_cycle::{Findings, not_measured};
use super::probed::{clearance, met, probing};
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::{Axis, Course, CycleError, Inputs, Key, Meaning, Parameter, ResultName, nearest};
use crate::probing::vector::along;
use crate::tolerance::{Feature, Nominal};
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

const AXES: [Axis; 3] = [Axis::First, Axis::Second, Axis::Third];

/// The measured axis, with the direction as its sign.
pub(super) const DIRECTION: Parameter = Parameter::choice(Key::Q(372), "PROBING DIRECTION", &[-3, -2, -1, 1, 2, 3])
    .named(&[(Nl, "TASTRICHTING"), (De, "ANTASTRICHTUNG"), (It, "DIREZIONE TASTATURA")])
    .asked(&[
        (En, "Probing direction (-3...+3)?"),
        (Nl, "Tastrichting (-3...+3)?"),
        (De, "Antastrichtung (-3...+3)?"),
        (It, "Direzione di tastatura (-3...+3)?"),
    ])
    .means(Meaning::DirectedAxis);

/// A nominal point.
pub(super) struct Point {
    /// The parameters of its coordinates.
    pub(super) of: [Parameter; 3],
    /// The numbers of the first results: of its place, of its deviation.
    pub(super) results: [u16; 2],
    pub(super) names: [ResultName; 3],
    pub(super) deviations: [ResultName; 3],
}

/// The measured axis.
pub(super) fn axis(inputs: &Inputs) -> Axis {
    match inputs.whole(DIRECTION.key).abs() {
        1 => Axis::First,
        2 => Axis::Second,
        _ => Axis::Third,
    }
}

/// The unit vector of the approach.
pub(super) fn approach(inputs: &Inputs) -> [f64; 3] {
    let sign = if inputs.whole(DIRECTION.key) < 0 { -1.0 } else { 1.0 };
    AXES.map(|of| if of == axis(inputs) { sign } else { 0.0 })
}

impl Point {
    /// Where it should be.
    pub(super) fn target(&self, inputs: &Inputs) -> [f64; 3] {
        self.of.map(|of| inputs.nominal(of.key).target().to_mm_f64())
    }

    /// The parameter of one axis.
    pub(super) const fn of(&self, axis: Axis) -> Parameter {
        let [first, second, third] = self.of;
        match axis {
            Axis::First => first,
            Axis::Second => second,
            Axis::Third => third,
        }
    }

    /// The nominal value in the measured axis.
    pub(super) fn nominal(&self, inputs: &Inputs) -> Nominal {
        inputs.nominal(self.of(axis(inputs)).key)
    }

    /// Refuses tolerances for the axes that are not measured.
    pub(super) fn check(&self, inputs: &Inputs) -> Result<(), CycleError> {
        let others = self.of.iter().zip(AXES).filter(|(_, of)| *of != axis(inputs));
        others.map(|(of, _)| of).try_for_each(|of| not_measured(of, inputs))
    }

    /// Probes it: the point where the ball met the surface.
    pub(super) fn probe(&self, way: Way, inputs: &Inputs, course: &mut Course<'_>) -> Result<Contact, CycleError> {
        let direction = approach(inputs);
        let before = clearance(inputs) + course.ball_radius();
        let touch = probing(inputs, along(self.target(inputs), direction, -before), direction);
        match way {
            Way::Over => course.pre_position_from_above(touch.from, inputs.mm(260)),
            Way::Straight | Way::Arc => course.pre_position(touch.from),
        }
        met(&touch, course)
    }

    /// What was found of it: the place, and in the measured axis its deviation. Material that is left is rework: the ball met it too
    /// early. Returns the coordinate in the measured axis.
    pub(super) fn add(
        &self,
        contact: &Contact,
        inputs: &Inputs,
        findings: &mut Findings,
    ) -> Result<Length, CycleError> {
        let nominal = self.nominal(inputs);
        let feature = if inputs.whole(DIRECTION.key) < 0 { Feature::Shaft } else { Feature::Hole };
        let [at, off_at] = self.results;
        let mut found = Length::ZERO;
        let names = self.names.into_iter().zip(self.deviations).zip(0_u16..);
        for ((of, place), ((name, deviation), number)) in AXES.into_iter().zip(contact.place()).zip(names) {
            let measured = nearest(place)?;
            if of == axis(inputs) {
                found = measured;
                let check = judged::size(name, measured, nominal.limits(), feature);
                findings.add((nominal, measured), [at + number, off_at + number], [name, deviation], check);
            } else {
                findings.only(at + number, name, measured);
            }
        }
        Ok(found)
    }
}
