//! What the cycles of a run say goes to the journal, each once.

use super::{Origin, ProgramPage, WorkpieceFrom};
use crate::journal::entry::{FileRole, UsedFile};
use crate::session::recording::{cycle_check, used};
use crate::session::shared::Shared;

impl ProgramPage {
    /// Sends what the run has judged since the last time.
    pub(super) fn keep_new(&mut self, shared: &mut Shared) {
        let is_simulated = self.is_simulated();
        let files = self.files(shared);
        let Some(run) = &mut self.run else { return };
        let all = run.machine.cycles();
        let new = all.get(run.recorded..).unwrap_or_default().iter();
        let checks: Vec<_> = new.filter_map(|cycle| cycle_check(cycle.cycle, &cycle.result, is_simulated)).collect();
        run.recorded = all.len();
        let last = u64::try_from(checks.len()).unwrap_or_default().checked_sub(1);
        if let (Some(last), Some(sent)) = (last, shared.recording.keep_cycles(checks, &files)) {
            run.record = Some((sent, last));
        }
    }

    /// The files that a run is made with.
    fn files(&self, shared: &Shared) -> Vec<UsedFile> {
        let name = match &self.origin {
            Some(Origin::File(path)) => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            Some(Origin::Shipped(name)) => (*name).to_owned(),
            None => return Vec::new(),
        };
        let measured = match self.workpiece {
            WorkpieceFrom::Part => {
                shared.workpiece.part.as_deref().and_then(|part| used(FileRole::Workpiece, &part.name, part.sha256))
            }
            WorkpieceFrom::Recorded => shared
                .workpiece
                .recorded
                .as_deref()
                .and_then(|contacts| used(FileRole::Measurements, &contacts.name, contacts.sha256)),
            WorkpieceFrom::Perfect | WorkpieceFrom::Given | WorkpieceFrom::Simulated => None,
        };
        used(FileRole::Program, &name, self.sha256).into_iter().chain(measured).collect()
    }
}
