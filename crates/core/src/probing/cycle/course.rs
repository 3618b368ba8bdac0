//! The path of the probe through a cycle: moves that can be listed and stepped through, and the contacts on it.
//!
//! All places are those of the ball's centre in workpiece coordinates, millimetres.

use super::astray::{Astray, beyond};
use super::error::CycleError;
use super::remark::Remark;
use crate::length::Length;
use crate::probing::contact::{Contact, NoContact, Prober, Touch};
use crate::probing::vector::along;

/// What a move is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Phase {
    /// To the place where a probing begins, at rapid traverse.
    PrePosition,
    /// Towards the workpiece, at probing feed.
    Approach,
    /// The ball touches: a move of no length.
    Contact,
    /// Back from the workpiece.
    Retract,
    /// Up to the clearance height.
    Leave,
}

impl Phase {
    /// The word for machines to read.
    pub const fn word(self) -> &'static str {
        match self {
            Self::PrePosition => "pre-position",
            Self::Approach => "approach",
            Self::Contact => "contact",
            Self::Retract => "retract",
            Self::Leave => "leave",
        }
    }
}

/// One move of the ball's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// What it is for.
    pub phase: Phase,
    /// The contact that it belongs to, from 1; `None` for leaving.
    pub touch: Option<usize>,
    /// Where it begins, mm.
    pub from: [f64; 3],
    /// Where it ends, mm.
    pub to: [f64; 3],
    /// For an arc, its centre, mm; the arc takes the shorter way round.
    pub about: Option<[f64; 3]>,
}

/// Asks for contacts and records the path between them.
pub struct Course<'a> {
    prober: &'a mut dyn Prober,
    moves: Vec<Move>,
    at: Option<[f64; 3]>,
    touches: usize,
    astray: Astray,
    /// The set-up clearance of the touch-probe table; `None` where it is not known from where the ball comes.
    set_up: Option<Length>,
}

impl<'a> Course<'a> {
    pub(super) fn new(prober: &'a mut dyn Prober, position: Option<[f64; 3]>, set_up: Length) -> Self {
        Self { prober, moves: Vec::new(), at: position, touches: 0, astray: Astray::default(), set_up: Some(set_up) }
    }

    /// The ball's radius, mm; zero where contacts are already points of the surface.
    pub(in crate::probing) fn ball_radius(&self) -> f64 {
        self.prober.ball_radius()
    }

    /// Refuses contacts without heights, for a cycle whose answer depends on them.
    pub(in crate::probing) fn needs_heights(&self) -> Result<(), CycleError> {
        let number = self.touches + 1;
        if self.prober.has_heights() { Ok(()) } else { Err(NoContact::NoHeight { number }.into()) }
    }

    /// The path, and what is worth knowing about where the contacts lie.
    pub(super) fn into_parts(self) -> (Vec<Move>, Option<Remark>) {
        (self.moves, self.astray.remark())
    }

    /// The probings begin where the ball is, and that is not known: the contacts may be anywhere.
    pub(in crate::probing) const fn begin_anywhere(&mut self) {
        self.set_up = None;
    }

    /// Moves in a straight line on the way to the next contact.
    pub(in crate::probing) fn pre_position(&mut self, to: [f64; 3]) {
        self.go(Phase::PrePosition, to, None);
    }

    /// Moves above a place and down to it: over the clearance height if the ball is not yet at that height.
    pub(in crate::probing) fn pre_position_from_above(&mut self, to: [f64; 3], height: f64) {
        let [x, y, z] = to;
        let above = height.max(z);
        if let Some([from_x, from_y, from_z]) = self.at {
            self.pre_position([from_x, from_y, above.max(from_z)]);
        }
        self.pre_position([x, y, above]);
        self.pre_position(to);
    }

    /// Moves on an arc on the way to the next contact.
    pub(in crate::probing) fn pre_position_about(&mut self, to: [f64; 3], centre: [f64; 3]) {
        self.go(Phase::PrePosition, to, Some(centre));
    }

    /// Probes from the start of the probing; the ball stays where it met the workpiece.
    pub(in crate::probing) fn touch(&mut self, touch: &Touch) -> Result<Contact, CycleError> {
        self.touches += 1;
        match self.prober.touch(touch) {
            Ok(contact) => {
                let met = contact.place();
                let has_height = self.prober.has_heights();
                if self.prober.is_recorded()
                    && let Some(set_up) = self.set_up
                    && let Some(error) = beyond(self.touches, touch, &contact, (has_height, set_up))
                {
                    return Err(error.into());
                }
                self.astray.look(self.touches, touch, &contact, has_height);
                self.at = Some(touch.from);
                self.go(Phase::Approach, met, None);
                let number = Some(self.touches);
                self.moves.push(Move { phase: Phase::Contact, touch: number, from: met, to: met, about: None });
                Ok(contact)
            }
            Err(error) => {
                // A path probed without a contact is also shown, where it has an end.
                let is_end_known =
                    matches!(error, NoContact::Missed { .. } | NoContact::OutOfReach { .. } | NoContact::UsedUp { .. });
                if touch.longest.is_finite() && is_end_known {
                    self.at = Some(touch.from);
                    self.go(Phase::Approach, along(touch.from, touch.direction, touch.longest), None);
                }
                Err(error.into())
            }
        }
    }

    /// Moves back from the workpiece.
    pub(in crate::probing) fn retract(&mut self, to: [f64; 3]) {
        self.go(Phase::Retract, to, None);
    }

    /// Ends the cycle at the clearance height, straight above the ball.
    pub(in crate::probing) fn leave(&mut self, height: f64) {
        if let Some(from @ [x, y, _]) = self.at.filter(|[_, _, z]| *z < height) {
            let to = [x, y, height];
            self.moves.push(Move { phase: Phase::Leave, touch: None, from, to, about: None });
            self.at = Some(to);
        }
    }

    fn go(&mut self, phase: Phase, to: [f64; 3], about: Option<[f64; 3]>) {
        let from = self.at.replace(to).unwrap_or(to);
        let touch = if phase == Phase::PrePosition { self.touches + 1 } else { self.touches };
        // The first place is the start of the path, and a move to where the ball already is does not count.
        if from.iter().zip(&to).any(|(from, to)| 0.0 < (to - from).abs()) {
            self.moves.push(Move { phase, touch: Some(touch), from, to, about });
        }
    }
}

/// A measured coordinate, rounded to the nearest nanometre.
pub(in crate::probing) fn nearest(mm: f64) -> Result<Length, CycleError> {
    Length::from_mm_f64(mm).map_err(CycleError::TooFar)
}
