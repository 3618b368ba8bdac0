//! Where the cycles of a run get their contacts from.

use super::fault::FaultKind;
use super::placement::{Placed, Placement};
use crate::probing::cycle::{Cycle, CycleError, CycleResult, Inputs, Move};
use crate::probing::simulated::{self, Simulation};
use crate::probing::{Contact, Recorded, Source, SourceError};

/// What the probe touches.
#[derive(Debug, Clone, PartialEq)]
pub enum Contacts {
    /// Whatever a cycle expects, at nominal size and without faults.
    Perfect,
    /// A simulated workpiece; the scatter continues from cycle to cycle.
    Workpiece(Simulation),
    /// Contacts in probing order, points of the surface, for all cycles of the run one after the other.
    Recorded(Vec<Contact>),
}

/// The contacts during the run.
#[derive(Debug)]
pub(super) enum Probed {
    Perfect,
    Workpiece(Simulation),
    Machine(Box<simulated::Machine>),
    Recorded(Recorded),
}

/// The path of the probe, and the outcome.
type Measured = (Vec<Move>, Result<CycleResult, CycleError>);

impl Probed {
    pub(super) fn new(contacts: Contacts) -> Self {
        match contacts {
            Contacts::Perfect => Self::Perfect,
            Contacts::Workpiece(simulation) => Self::Workpiece(simulation),
            Contacts::Recorded(contacts) => Self::Recorded(Recorded::new(contacts)),
        }
    }

    /// How many recorded contacts there are and how many the cycles took, unless they took all.
    pub(super) fn left(&self) -> Option<(usize, usize)> {
        let Self::Recorded(recorded) = self else { return None };
        Some(recorded.handed_out()).filter(|(count, used)| used < count)
    }

    /// Runs a cycle.
    pub(super) fn measure(
        &mut self,
        cycle: &Cycle,
        inputs: &Inputs,
        placement: Placement,
    ) -> Result<Measured, FaultKind> {
        if let Self::Workpiece(simulation) = self {
            let machine = simulation.machine().map_err(|error| FaultKind::Workpiece(Box::new(error)))?;
            *self = Self::Machine(Box::new(machine));
        }
        match self {
            Self::Machine(machine) => {
                // Each probe of the table has a calibration of its own.
                **machine = machine.as_ref().clone().calibrated(inputs.probe());
                Ok(cycle.measure_along(inputs, &mut Placed { prober: machine.as_mut(), placement }))
            }
            // Contacts were recorded from the zero in force, as a control shows them.
            Self::Recorded(recorded) => {
                let placement = Placement { zero: [0.0; 3], ..placement };
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
