//! Where the cycles of a run get their contacts from.

use super::fault::FaultKind;
use crate::probing::cycle::{Cycle, CycleError, CycleResult, Inputs, Move};
use crate::probing::simulated::{self, Bench};
use crate::probing::{Contact, Recorded};

/// What the probe touches.
#[derive(Debug, Clone, PartialEq)]
pub enum Contacts {
    /// Whatever a cycle expects, at nominal and without faults.
    Perfect,
    /// A simulated workpiece; scatter goes on from cycle to cycle.
    Workpiece(Bench),
    /// Contacts in probing order, points of the surface, for all cycles of the run one after the other.
    Recorded(Vec<Contact>),
}

/// The contacts while the run goes on.
#[derive(Debug)]
pub(super) enum Workbench {
    Perfect,
    Workpiece(Bench),
    Machine(Box<simulated::Machine>),
    Recorded(Recorded),
}

/// The way of the probe, and what came of it.
type Measured = (Vec<Move>, Result<CycleResult, CycleError>);

impl Workbench {
    pub(super) fn new(contacts: Contacts) -> Self {
        match contacts {
            Contacts::Perfect => Self::Perfect,
            Contacts::Workpiece(bench) => Self::Workpiece(bench),
            Contacts::Recorded(contacts) => Self::Recorded(Recorded::new(contacts)),
        }
    }

    /// How many recorded contacts there are and how many the cycles took, where they did not take all.
    pub(super) fn left(&self) -> Option<(usize, usize)> {
        let Self::Recorded(recorded) = self else { return None };
        Some(recorded.handed_out()).filter(|(count, used)| used < count)
    }

    /// Runs a cycle.
    pub(super) fn measure(&mut self, cycle: &Cycle, inputs: &Inputs) -> Result<Measured, FaultKind> {
        if let Self::Workpiece(bench) = self {
            let machine = bench.machine().map_err(|error| FaultKind::Workpiece(Box::new(error)))?;
            *self = Self::Machine(Box::new(machine));
        }
        match self {
            Self::Machine(machine) => {
                // Each probe of the table has a calibration of its own.
                **machine = machine.as_ref().clone().calibrated(inputs.probe());
                Ok(cycle.measure_along(inputs, machine.as_mut()))
            }
            Self::Recorded(recorded) => Ok(cycle.measure_along(inputs, recorded)),
            Self::Perfect | Self::Workpiece(_) => perfect(cycle, inputs),
        }
    }
}

/// Runs a cycle on the surface that it expects.
fn perfect(cycle: &Cycle, inputs: &Inputs) -> Result<Measured, FaultKind> {
    let nominal = match cycle.nominal(inputs) {
        Ok(nominal) => nominal,
        Err(error) => return Ok((Vec::new(), Err(error))),
    };
    match Bench::perfect(nominal.into()).machine() {
        Ok(machine) => Ok(cycle.measure_along(inputs, &mut machine.calibrated(inputs.probe()))),
        // The cycle itself says better what is wrong with its inputs.
        Err(error) => match cycle.measure(inputs, &mut Recorded::new(Vec::new())) {
            Err(refused) if !matches!(refused, CycleError::NoContact(_)) => Ok((Vec::new(), Err(refused))),
            _ => Err(FaultKind::Workpiece(Box::new(error))),
        },
    }
}
