//! Where the contacts of a cycle come from, and what is to be said of them.

use std::path::Path;

use crate::cli::{CliError, CliWarning, Io, Refused as _, read_input};
use crate::journal::entry::{CycleOrigin, FileRole};
use crate::nc::machine::Remark;
use crate::probing::cycle::{Inputs, Move, Phase};
use crate::probing::simulated::Part;
use crate::probing::{self, Contact};
use crate::text::decode;

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

impl Source {
    /// The same as a journal keeps it.
    pub(in crate::cli) fn origin(&self) -> CycleOrigin {
        match self {
            Self::Perfect => CycleOrigin::Perfect,
            Self::Workpiece { file, part } => CycleOrigin::Workpiece { file: file.as_str().into(), seed: part.seed },
            Self::Contacts { file, .. } => CycleOrigin::Contacts { file: file.as_str().into() },
        }
    }
}

/// A file of a simulated workpiece, and its name.
pub(in crate::cli) fn read_workpiece(path: &Path, io: &mut Io<'_>) -> Result<(String, Part), CliError> {
    let (file, bytes) = read_input(path, io)?;
    io.used(FileRole::Workpiece, &file, &bytes);
    let part = Part::read(&decode(&bytes)).about(&file)?;
    Ok((file, part))
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
    let (count, unused) =
        (contacts.len(), probing::Source::Recorded { contacts, has_heights: *has_heights }.unused(path));
    if 0 < unused {
        io.warn_about(file, &CliWarning::ContactsLeft { used: count - unused, count });
    }
}
