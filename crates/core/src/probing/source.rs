//! Where a cycle's contacts come from: a perfect workpiece at nominal size, a simulated one, or recorded contacts.

use super::contact::{Contact, NoContact, Prober, Recorded, Touch};
use super::cycle::{Cycle, CycleError, Inputs, Meaning, Move, Phase, Value};
use super::simulated::{Machine, Part, Simulation, Surface, WorkpieceError};
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
        let machine = machine.calibrated(inputs.probe());
        let other = cycle.nominal_beside(inputs).filter(|_other| matches!(self, Self::Perfect));
        Ok(match other {
            None => Box::new(machine),
            Some(other) => {
                let beside = Simulation::perfect(other).machine()?.calibrated(inputs.probe());
                let is_circle = matches!(other, Surface::Round(..));
                let count = match cycle.value_of(inputs, Meaning::ContactCount) {
                    Some(Value::Whole(count)) => *count,
                    _ => USUAL_COUNT,
                };
                let of_first = is_circle.then_some(count);
                Box::new(Two { machine, beside, of_first })
            }
        })
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

/// The contacts of a circle where the cycle is not told how many.
const USUAL_COUNT: i64 = 4;

/// A perfect workpiece and another surface beside it: neither is in the way of the other, whatever the figures of a cycle say.
struct Two {
    machine: Machine,
    beside: Machine,
    /// How many probings are still of the first, where both are circles; a top has those straight along the probe axis.
    of_first: Option<i64>,
}

impl Two {
    fn is_of_other(&mut self, touch: &Touch) -> bool {
        if let Some(left) = &mut self.of_first {
            *left -= 1;
            return *left < 0;
        }
        let [x, y, _] = touch.direction;
        x.abs() + y.abs() <= 0.0
    }
}

impl Prober for Two {
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact> {
        if self.is_of_other(touch) { self.beside.touch(touch) } else { self.machine.touch(touch) }
    }
}
