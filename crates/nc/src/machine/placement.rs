//! Where a cycle measures: the tool axis makes its plane, datum, rotation and tilt the system that it counts in.
//!
//! A cycle counts in its first and second axis and the probe axis, from the zero in force. The workpiece and the path count in X, Y and Z
//! of the workpiece, which are those of the preset that is active first.

use fitcheck_core::probing::cycle::{Move, Plane};
use fitcheck_core::probing::vector::along;
use fitcheck_core::probing::{Contact, NoContact, Orientation, Prober, Touch};

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

/// The system that coordinates count in: where its zero is, mm in the coordinates of the workpiece, and how its axes lie.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct System {
    pub zero: [f64; 3],
    pub axes: Orientation,
}

impl System {
    /// A place of the system in the coordinates of the workpiece.
    pub(super) fn out(self, place: [f64; 3]) -> [f64; 3] {
        along(self.axes.out(place), self.zero, 1.0)
    }

    /// A place of the workpiece in the coordinates of the system.
    pub(super) fn within(self, place: [f64; 3]) -> [f64; 3] {
        self.axes.within(along(place, self.zero, -1.0))
    }

    /// A place of the system, as far as it is known, in the coordinates of the workpiece.
    pub(super) fn out_of_known(self, place: [Option<f64>; 3]) -> [Option<f64>; 3] {
        moved(self.axes.out_of_known(place), self.zero, 1.0)
    }

    /// The same place of one system in another; what is known stays known between systems whose axes lie alike.
    pub(super) fn into(self, other: Self, place: [Option<f64>; 3]) -> [Option<f64>; 3] {
        if self.axes == other.axes {
            let by = self.axes.within(along(self.zero, other.zero, -1.0));
            return moved(place, by, 1.0);
        }
        other.axes.within_known(moved(self.out_of_known(place), other.zero, -1.0))
    }
}

fn moved([x, y, z]: [Option<f64>; 3], [by_x, by_y, by_z]: [f64; 3], times: f64) -> [Option<f64>; 3] {
    [(x, by_x), (y, by_y), (z, by_z)].map(|(part, by)| Some(part? + times * by))
}

/// The plane, and the system in force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Placement {
    pub plane: Plane,
    pub system: System,
}

impl Placement {
    /// A place of the workpiece as the cycle counts it.
    pub(super) fn into_cycle(self, place: [f64; 3]) -> [f64; 3] {
        self.plane.within(self.system.within(place))
    }

    /// A place of the cycle in the coordinates of the workpiece.
    pub(super) fn out_of_cycle(self, place: [f64; 3]) -> [f64; 3] {
        self.system.out(self.plane.place(place))
    }

    /// Whether the stylus stands along Z of the workpiece.
    pub(super) fn is_upright(self) -> bool {
        self.plane == Plane::Xy && self.system.axes.is_upright()
    }

    /// The moves of a cycle in the coordinates of the workpiece.
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
        let direction = placement.system.axes.out(placement.plane.place(touch.direction));
        let from = placement.out_of_cycle(touch.from);
        let contact = prober.touch(&Touch { from, direction, longest: touch.longest })?;
        // Z is an axis of every plane but X/Y.
        if !placement.is_upright() && !prober.has_heights() {
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
