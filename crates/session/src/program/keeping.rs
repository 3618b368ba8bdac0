//! What the cycles of a run say goes to the journal, each once.

use fitcheck_core::text::{Within as _, long};
use fitcheck_exchange::journal::entry::{CycleCheck, CycleOrigin, FileRole, UsedFile};
use fitcheck_nc::machine::CycleRun;

use super::{Origin, ProgramPage, WorkpieceFrom};
use crate::recording::used;
use crate::shared::Shared;

impl ProgramPage {
    /// Sends what the run has judged since the last time.
    pub(super) fn keep_new(&mut self, shared: &mut Shared) {
        let origin = self.contacts_from(shared);
        let files = self.files(shared);
        let Some(run) = &mut self.run else { return };
        let all = run.machine.cycles();
        let new = all.within(run.recorded..).iter();
        let check = |cycle: &CycleRun| {
            let program = run.machine.program(&cycle.place.program);
            let line = program
                .and_then(|program| program.blocks().get(cycle.place.block))
                .map_or(0, |block| block.lines.start);
            let line = long(line).saturating_add(1);
            let block = Some((cycle.place.program.to_string(), line));
            let is_judged = cycle.result.verdict().is_some();
            is_judged.then(|| CycleCheck { block, ..CycleCheck::of_run(cycle, origin.clone()) })
        };
        let checks: Vec<_> = new.filter_map(check).collect();
        run.recorded = all.len();
        let last = long(checks.len()).checked_sub(1);
        if let (Some(last), Some(sent)) = (last, shared.recording.keep_cycles(checks, &files)) {
            run.record = Some((sent, last));
        }
    }

    /// Where the contacts of a run come from.
    fn contacts_from(&self, shared: &Shared) -> CycleOrigin {
        let workpiece = &shared.workpiece;
        match self.workpiece {
            WorkpieceFrom::Recorded => {
                let file = self.recorded.as_deref().map_or("", |recorded| recorded.name.as_str());
                CycleOrigin::Contacts { file: file.into() }
            }
            WorkpieceFrom::Part => {
                let file = workpiece.part.as_deref().map_or("", |open| open.name.as_str());
                let seed = workpiece.part.as_deref().map_or(0, |open| open.part.seed);
                CycleOrigin::Workpiece { file: file.into(), seed }
            }
            WorkpieceFrom::Simulated => {
                let seed = workpiece.form.simulation.as_ref().map_or(0, |simulation| simulation.seed);
                CycleOrigin::Workpiece { file: "".into(), seed }
            }
            WorkpieceFrom::Perfect | WorkpieceFrom::Given => CycleOrigin::Perfect,
        }
    }

    /// The files that a run is made with.
    fn files(&self, shared: &Shared) -> Vec<UsedFile> {
        let name = match &self.origin {
            Some(Origin::File(path)) => path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned(),
            Some(Origin::Shipped(name)) => (*name).to_owned(),
            None => return Vec::new(),
        };
        let measured = match self.workpiece {
            WorkpieceFrom::Part => {
                shared.workpiece.part.as_deref().and_then(|part| used(FileRole::Workpiece, &part.name, part.sha256))
            }
            WorkpieceFrom::Recorded => self
                .recorded
                .as_deref()
                .and_then(|contacts| used(FileRole::Measurements, &contacts.name, contacts.sha256)),
            WorkpieceFrom::Perfect | WorkpieceFrom::Given | WorkpieceFrom::Simulated => None,
        };
        used(FileRole::Program, &name, self.sha256).into_iter().chain(measured).collect()
    }
}
