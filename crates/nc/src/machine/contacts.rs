//! Where the cycles of a run get their contacts from.

use fitcheck_core::probing::cycle::{Cycle, CycleError, CycleResult, Inputs, Move, Phase};
use fitcheck_core::probing::simulated::{self, Mover, Part};
use fitcheck_core::probing::{Contact, NoContact, Prober, Recorded, Source, SourceError, Touch, TouchProbe};

use super::fault::FaultKind;
use super::moves::{Travel, TravelKind};
use super::placement::{Placed, Placement, System};
use super::remark::Remark;

/// What the probe touches.
#[derive(Debug, Clone, PartialEq)]
pub enum Contacts {
    /// Whatever a cycle expects, at nominal size and without faults.
    Perfect,
    /// A simulated workpiece, with one feature or several; the scatter continues from cycle to cycle.
    Workpiece(Part),
    /// Contacts in probing order, points of the surface, for all cycles of the run one after the other.
    Recorded(Vec<Contact>),
    /// The same from a file without heights.
    WithoutHeights(Vec<Contact>),
}

/// The contacts during the run.
#[derive(Debug)]
pub(super) enum Probed {
    Perfect,
    Workpiece(Box<Part>),
    Machine(Box<simulated::Machine>),
    Recorded(Recorded),
}

/// One contact, and the radius of the ball that made it.
pub(super) type Touched = Result<(Contact, f64), NoContact>;

/// The path of the probe, and the outcome.
type Measured = (Vec<Move>, Result<CycleResult, CycleError>);

impl Contacts {
    /// Contacts of a file, with or without heights.
    pub fn of_file(contacts: Vec<Contact>, has_heights: bool) -> Self {
        if has_heights { Self::Recorded(contacts) } else { Self::WithoutHeights(contacts) }
    }
}

impl Probed {
    pub(super) fn new(contacts: Contacts) -> Self {
        match contacts {
            Contacts::Perfect => Self::Perfect,
            Contacts::Workpiece(part) => Self::Workpiece(Box::new(part)),
            Contacts::Recorded(contacts) => Self::Recorded(Recorded::new(contacts)),
            Contacts::WithoutHeights(contacts) => Self::Recorded(Recorded::new(contacts).with_heights(false)),
        }
    }

    /// Whether nobody measured.
    pub(super) const fn is_simulated(&self) -> bool {
        !matches!(self, Self::Recorded(_))
    }

    /// Whether every cycle meets what it expects.
    pub(super) const fn is_perfect(&self) -> bool {
        matches!(self, Self::Perfect)
    }

    /// Whether contacts were recorded.
    pub(super) const fn is_recorded(&self) -> bool {
        matches!(self, Self::Recorded(_))
    }

    /// How many recorded contacts there are and how many the cycles took, unless they took all.
    pub(super) fn left(&self) -> Option<(usize, usize)> {
        let Self::Recorded(recorded) = self else { return None };
        Some(recorded.handed_out()).filter(|(count, used)| used < count)
    }

    /// Switches the simulated machine on, if it is not yet.
    fn switch_on(&mut self) -> Result<(), FaultKind> {
        if let Self::Workpiece(part) = self {
            let machine = part.machine().map_err(|error| FaultKind::Workpiece(Box::new(error)))?;
            *self = Self::Machine(Box::new(machine));
        }
        Ok(())
    }

    /// What a move of the ball would touch on a simulated part. The moves that end or begin at a contact are no such
    /// moves: they are answered by the contact. Only an upright probe has its stylus along Z.
    pub(super) fn collision(&mut self, travel: &Travel, is_upright: bool) -> Option<Remark> {
        if let TravelKind::Cycle(Phase::Approach | Phase::Contact | Phase::Retract) = travel.kind {
            return None;
        }
        // A workpiece that cannot be is told by the cycle that measures it.
        self.switch_on().ok()?;
        let Self::Machine(machine) = self else { return None };
        let movers: &[Mover] = if is_upright { &[Mover::Ball, Mover::Stylus] } else { &[Mover::Ball] };
        machine.collision_of(movers, travel.from, travel.to, travel.about).map(Remark::from)
    }

    /// Whether moves are looked at with a stylus: on a part of several features.
    pub(super) fn has_stylus(&self) -> bool {
        matches!(self, Self::Machine(machine) if machine.has_stylus())
    }

    /// A remark about features that moves are not looked at with.
    pub(super) fn unchecked(&mut self) -> Option<Remark> {
        self.switch_on().ok()?;
        let Self::Machine(machine) = self else { return None };
        let features = machine.unchecked().join(", ");
        (!features.is_empty()).then_some(Remark::Unchecked { features })
    }

    /// One contact, in the coordinates of the system, and the radius of the ball that made it; `None` where every cycle meets what it
    /// expects: a single point expects nothing.
    pub(super) fn touch(
        &mut self,
        touch: &Touch,
        probe: TouchProbe,
        placement: Placement,
    ) -> Result<Option<Touched>, FaultKind> {
        self.switch_on()?;
        Ok(match self {
            Self::Machine(machine) => {
                **machine = machine.as_ref().clone().calibrated(&probe);
                let mut prober = Placed { prober: machine.as_mut(), placement };
                Some(prober.touch(touch).map(|contact| (contact, prober.ball_radius())))
            }
            Self::Recorded(recorded) => {
                let placement = Placement { system: System::default(), ..placement };
                let mut prober = Placed { prober: recorded, placement };
                Some(prober.touch(touch).map(|contact| (contact, prober.ball_radius())))
            }
            Self::Perfect | Self::Workpiece(_) => None,
        })
    }

    /// Whether its contacts have heights.
    pub(super) fn has_heights(&self) -> bool {
        !matches!(self, Self::Recorded(recorded) if !recorded.has_heights())
    }

    /// Runs a cycle.
    pub(super) fn measure(
        &mut self,
        cycle: &Cycle,
        inputs: &Inputs,
        placement: Placement,
    ) -> Result<Measured, FaultKind> {
        self.switch_on()?;
        match self {
            Self::Machine(machine) => {
                // Each probe of the table has a calibration of its own.
                **machine = machine.as_ref().clone().calibrated(inputs.probe());
                Ok(cycle.measure_along(inputs, &mut Placed { prober: machine.as_mut(), placement }))
            }
            // Contacts were recorded from the zero in force, as a control shows them.
            Self::Recorded(recorded) => {
                let placement = Placement { system: System::default(), ..placement };
                Ok(cycle.measure_along(inputs, &mut Placed { prober: recorded, placement }))
            }
            Self::Perfect | Self::Workpiece(_) => match Source::Perfect.prober(cycle, inputs) {
                Ok(mut prober) => Ok(cycle.measure_along(inputs, &mut *prober)),
                Err(SourceError::Cycle(error)) => Ok((Vec::new(), Err(error))),
                Err(SourceError::Workpiece(error)) => Err(FaultKind::Workpiece(Box::new(error))),
            },
        }
    }
}
