//! Where the contacts of a cycle come from, and what is to be said of them.

use std::path::PathBuf;

use crate::cli::{CliError, CliWarning, ErrorSubject, IntoCliError as _, Io, read_contacts, read_input};
use crate::exchange::contacts::Contacts;
use crate::journal::entry::{CycleOrigin, FileRole};
use crate::nc::machine::Remark;
use crate::probing::cycle::{Cycle, Inputs, Move, Phase};
use crate::probing::simulated::Part;
use crate::probing::{self, Contact, Prober, Recorded, SourceError};
use crate::text::decode;
use crate::tolerance::fit::thermal::Temperature;

/// Where the contacts come from.
#[derive(Debug)]
pub(in crate::cli) enum Source {
    /// A workpiece without faults and a point as the probe.
    Perfect,
    /// A file of a simulated workpiece.
    Workpiece { file: String, part: Part },
    /// A file of contacts.
    Contacts { file: String, contacts: Vec<Contact>, has_heights: bool },
}

/// The options of it.
#[derive(Debug, clap::Args)]
#[group(skip)]
pub(in crate::cli) struct SourceArgs {
    /// The simulated workpiece and probe
    #[arg(long, value_name = "FILE.toml", conflicts_with = "contacts")]
    workpiece: Option<PathBuf>,
    /// Recorded contacts in probing order: x, y, z in mm, points of the surface; - reads standard input
    #[arg(long, value_name = "FILE.csv")]
    contacts: Option<PathBuf>,
    /// Seed of the scatter, instead of that in the workpiece file
    #[arg(long, value_name = "N", requires = "workpiece", conflicts_with = "contacts")]
    seed: Option<u64>,
}

impl SourceArgs {
    pub(in crate::cli) fn read(&self, io: &mut Io<'_>) -> Result<Source, CliError> {
        if let Some(path) = &self.contacts {
            let (file, Contacts { contacts, has_heights, .. }) = read_contacts(path, Temperature::REFERENCE, io)?;
            return Ok(Source::Contacts { file, contacts, has_heights });
        }
        let Some(path) = &self.workpiece else { return Ok(Source::Perfect) };
        let (file, bytes) = read_input(path, io)?;
        io.used(FileRole::Workpiece, &file, &bytes);
        let mut part = Part::read(&decode(&bytes)).about(&file)?;
        part.seed = self.seed.unwrap_or(part.seed);
        Ok(Source::Workpiece { file, part })
    }
}

impl Source {
    /// What a cycle probes.
    pub(super) fn prober(&self, cycle: &'static Cycle, inputs: &Inputs) -> Result<Box<dyn Prober>, CliError> {
        match self {
            Self::Contacts { contacts, has_heights, .. } => {
                Ok(Box::new(Recorded::new(contacts.clone()).with_heights(*has_heights)))
            }
            Self::Workpiece { file, part } => probing::Source::Part(part).prober(cycle, inputs).about(file),
            Self::Perfect => match probing::Source::Perfect.prober(cycle, inputs) {
                Err(SourceError::Cycle(error)) => Err(error).about(&ErrorSubject::Cycle { code: cycle.code }),
                prober => prober.about(&ErrorSubject::PerfectWorkpiece),
            },
        }
    }

    /// The same as a journal keeps it.
    pub(in crate::cli) fn origin(&self) -> CycleOrigin {
        match self {
            Self::Perfect => CycleOrigin::Perfect,
            Self::Workpiece { file, part } => CycleOrigin::Workpiece { file: file.as_str().into(), seed: part.seed },
            Self::Contacts { file, .. } => CycleOrigin::Contacts { file: file.as_str().into() },
        }
    }
}

/// Remarks on the first move between contacts that would touch a feature of a simulated part.
pub(super) fn remark_on_moves(source: &Source, inputs: &Inputs, path: &[Move], io: &mut Io<'_>) {
    let Source::Workpiece { part, .. } = source else { return };
    let Ok(machine) = part.machine().map(|machine| machine.calibrated(inputs.probe())) else { return };
    let features = machine.unchecked().join(", ");
    if !features.is_empty() {
        io.remark(&Remark::Unchecked { features });
    }
    let mut between = path.iter().filter(|step| matches!(step.phase, Phase::PrePosition | Phase::Leave));
    if let Some(found) = between.find_map(|step| machine.collision(step.from, step.to, step.about)) {
        io.remark(&Remark::from(found));
    }
}

/// Warns of contacts that the cycle did not ask for.
pub(super) fn warn_of_unused(source: &Source, path: &[Move], io: &mut Io<'_>) {
    let Source::Contacts { file, contacts, has_heights } = source else { return };
    let count = contacts.len();
    let unused = probing::Source::Recorded { contacts, has_heights: *has_heights }.unused(path);
    if 0 < unused {
        io.warn_about(file, &CliWarning::ContactsLeft { used: count - unused, count });
    }
}
