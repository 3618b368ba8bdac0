//! Where a cycle measures: the tool axis makes its plane, the datum its zero.
//!
//! A cycle counts in its first and second axis and the probe axis, from the zero in force. The workpiece and the path count in
//! X, Y and Z from the preset.

use fitcheck_core::probing::cycle::{Move, Plane};
use fitcheck_core::probing::{Contact, NoContact, Prober, Touch};

use crate::program::Axis;

/// The plane that a tool axis makes: Z has X and Y, Y has Z and X, X has Y and Z (`TOOL CALL`, TNC manuals).
pub(super) const fn plane(tool_axis: Axis) -> Option<Plane> {
    match tool_axis {
        Axis::X => Some(Plane::Yz),
        Axis::Y => Some(Plane::Zx),
        Axis::Z => Some(Plane::Xy),
        _ => None,
    }
}

/// The plane, and where the zero in force is, mm from the preset.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Placement {
    pub plane: Plane,
    pub zero: [f64; 3],
}

impl Placement {
    /// A place from the preset as the cycle counts it.
    pub(super) fn into_cycle(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [to_x, to_y, to_z] = self.zero;
        self.plane.within([x - to_x, y - to_y, z - to_z])
    }

    /// A place of the cycle from the preset.
    pub(super) fn out_of_cycle(self, place: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = self.plane.place(place);
        let [from_x, from_y, from_z] = self.zero;
        [x + from_x, y + from_y, z + from_z]
    }

    /// The moves of a cycle from the preset.
    pub(super) fn moves(self, moves: &[Move]) -> Vec<Move> {
        let placed = |step: &Move| Move {
            from: self.out_of_cycle(step.from),
            to: self.out_of_cycle(step.to),
            about: step.about.map(|about| self.out_of_cycle(about)),
            ..*step
        };
        moves.iter().map(placed).collect()
    }
}

/// A workpiece as the cycle sees it.
pub(super) struct Placed<'a, P> {
    pub prober: &'a mut P,
    pub placement: Placement,
}

impl<P: Prober> Prober for Placed<'_, P> {
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact> {
        let Self { prober, placement } = self;
        let direction = placement.plane.place(touch.direction);
        let from = placement.out_of_cycle(touch.from);
        let contact = prober.touch(&Touch { from, direction, longest: touch.longest })?;
        // Z is an axis of every plane but X/Y.
        if placement.plane != Plane::Xy && !prober.has_heights() {
            return Err(NoContact::NoHeight { number: 1 });
        }
        Ok(Contact::at(placement.into_cycle(contact.place())))
    }

    fn ball_radius(&self) -> f64 {
        self.prober.ball_radius()
    }

    fn is_recorded(&self) -> bool {
        self.prober.is_recorded()
    }

    fn has_heights(&self) -> bool {
        self.prober.has_heights()
    }
}
