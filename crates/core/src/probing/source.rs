//! Where a cycle's contacts come from: a perfect workpiece at nominal size, a simulated one, or recorded contacts.

use super::contact::{Contact, Prober, Recorded};
use super::cycle::{Cycle, CycleError, Inputs, Move, Phase};
use super::simulated::{Part, Simulation, WorkpieceError};
use crate::message::Say;

/// Where contacts come from.
#[derive(Debug, Clone, Copy)]
pub enum Source<'a> {
    /// A workpiece without faults where the cycle expects it, and a point as the probe.
    Perfect,
    /// A simulated workpiece.
    Simulated(&'a Simulation),
    /// A simulated part with any number of features.
    Part(&'a Part),
    /// Contacts in probing order, points of the surface.
    Recorded {
        /// The contacts.
        contacts: &'a [Contact],
        /// Whether their heights were recorded, too.
        has_heights: bool,
    },
}

/// Why there is nothing to probe.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "source", error)]
pub enum SourceError {
    /// The cycle's inputs describe no workpiece.
    #[say(transparent)]
    Cycle(#[from] CycleError),
    /// The workpiece is impossible.
    #[say(transparent)]
    Workpiece(#[from] WorkpieceError),
}

impl Source<'_> {
    /// The source of a cycle's contacts.
    ///
    /// # Errors
    /// [`SourceError`] where the inputs or the figures do not describe a possible workpiece.
    pub fn prober(self, cycle: &Cycle, inputs: &Inputs) -> Result<Box<dyn Prober>, SourceError> {
        let machine = match self {
            Self::Recorded { contacts, has_heights } => {
                return Ok(Box::new(Recorded::new(contacts.to_vec()).with_heights(has_heights)));
            }
            Self::Simulated(simulation) => simulation.machine(),
            Self::Part(part) => part.machine(),
            Self::Perfect => Simulation::perfect(cycle.nominal(inputs)?).machine(),
        };
        let machine = machine.map_err(|error| self.refused(error, cycle, inputs))?;
        Ok(Box::new(machine.calibrated(inputs.probe())))
    }

    /// Where the perfect workpiece is impossible, the cycle itself explains better what is wrong with its inputs.
    fn refused(self, error: WorkpieceError, cycle: &Cycle, inputs: &Inputs) -> SourceError {
        match (self, cycle.measure(inputs, &mut Recorded::new(Vec::new()))) {
            (Self::Perfect, Err(refused)) if !matches!(refused, CycleError::NoContact(_)) => refused.into(),
            _ => error.into(),
        }
    }

    /// How many recorded contacts a path did not use.
    pub fn unused(self, path: &[Move]) -> usize {
        let Self::Recorded { contacts, .. } = self else { return 0 };
        contacts.len().saturating_sub(path.iter().filter(|step| step.phase == Phase::Contact).count())
    }
}
