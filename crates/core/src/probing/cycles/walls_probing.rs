//! The contacts of the cycles that probe opposite walls about a nominal centre, along the axes.

use super::judged::between;
use super::probed::{clearance, met, probing};
use crate::length::Length;
use crate::probing::contact::{Contact, Touch};
use crate::probing::cycle::{Course, CycleError, Inputs};
use crate::probing::simulated::{Surface, Walls};
use crate::probing::vector::along;
use crate::tolerance::Feature;

/// Walls about a centre that stands in parameters of the cycle: those of a slot or pocket face it, those of a ridge or boss do not.
#[derive(Debug, Clone, Copy)]
pub(super) struct About {
    pub(super) feature: Feature,
    /// The Q numbers of the nominal centre, first and second axis.
    pub(super) centre: [u16; 2],
}

impl About {
    /// The nominal centre at measuring height.
    pub(super) fn centre(self, inputs: &Inputs) -> [f64; 3] {
        let [x, y] = self.centre.map(|number| inputs.mm(number));
        [x, y, inputs.mm(261)]
    }

    /// The probing of the wall on one side of the centre; both walls are `size` apart.
    pub(super) fn touch(self, inputs: &Inputs, ball_radius: f64, outwards: [f64; 3], size: f64) -> Touch {
        let clearance = clearance(inputs) + ball_radius;
        let (start, sign) = match self.feature {
            // In a small pocket the probe starts at the centre.
            Feature::Hole => ((size / 2.0 - clearance).max(0.0), 1.0),
            Feature::Shaft => (size / 2.0 + clearance, -1.0),
        };
        probing(inputs, along(self.centre(inputs), outwards, start), outwards.map(|part| sign * part))
    }
}

/// A pocket or a boss.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rectangle {
    pub(super) about: About,
    /// The Q numbers of the nominal sides along the first and the second axis.
    pub(super) sides: [u16; 2],
}

impl Rectangle {
    /// The rectangle at its nominal size.
    pub(super) fn surface(self, inputs: &Inputs) -> Surface {
        let [x, y, _] = self.about.centre(inputs);
        let [first, second] = self.sides.map(|number| inputs.mm(number));
        Surface::Walls(Walls::new(self.about.feature, [x, y], (first, Some(second))))
    }

    /// The nominal sides, as the status window shows them.
    pub(super) fn subject(self, inputs: &Inputs) -> String {
        let [first, second] = self.sides.map(|number| inputs.length(number));
        format!("{first} x {second}")
    }

    /// Makes the contacts and leaves to the clearance height.
    pub(super) fn probe(self, inputs: &Inputs, course: &mut Course<'_>) -> Result<Vec<Contact>, CycleError> {
        let mut contacts = Vec::new();
        let mut before: Option<[f64; 3]> = None;
        for touch in self.touches(inputs, course.ball_radius()) {
            self.pre_position(inputs, before, touch.from, course);
            contacts.push(met(&touch, course)?);
            before = Some(touch.from);
        }
        course.leave(inputs.mm(260));
        Ok(contacts)
    }

    /// The contacts in order, from inside a pocket or from outside a boss.
    fn touches(self, inputs: &Inputs, ball_radius: f64) -> [Touch; 4] {
        let [first, second] = self.sides.map(|number| inputs.mm(number));
        [([1.0, 0.0, 0.0], first), ([0.0, 1.0, 0.0], second), ([-1.0, 0.0, 0.0], first), ([0.0, -1.0, 0.0], second)]
            .map(|(outwards, size)| self.about.touch(inputs, ball_radius, outwards, size))
    }

    /// From above to the first contact; to the others as Q301 says, and at measuring height one axis after the other.
    fn pre_position(self, inputs: &Inputs, before: Option<[f64; 3]>, to: [f64; 3], course: &mut Course<'_>) {
        let Some([before_x, before_y, _]) = before.filter(|_| inputs.whole(301) == 0) else {
            return course.pre_position_from_above(to, inputs.mm(260));
        };
        let [to_x, to_y, height] = to;
        let [centre_x, _, _] = self.about.centre(inputs);
        // The previous contact was off the centre in one axis, this one is in the other.
        let is_from_first = (to_x - centre_x).abs() <= 0.0;
        let corner = if is_from_first { [before_x, to_y, height] } else { [to_x, before_y, height] };
        course.pre_position(corner);
        course.pre_position(to);
    }
}

/// The length and the middle of each side, from the four contacts in their order.
pub(super) fn sides(contacts: &[Contact]) -> Result<[(Length, Length); 2], CycleError> {
    let place = |number: usize, of: fn(&Contact) -> f64| contacts.get(number).map_or(0.0, of);
    Ok([
        between(place(0, |contact| contact.x), place(2, |contact| contact.x))?,
        between(place(1, |contact| contact.y), place(3, |contact| contact.y))?,
    ])
}
