//! The measuring logs that cycles ask for with Q281: into a file beside the program, or on the screen.

use super::budget::{Budget, UsedUp};
use super::fault::FaultKind;
use super::path::NcPath;
use super::prints::{Window, Written};
use super::remark::Remark;
use super::run::Machine;
use super::store::StoreError;
use crate::control::cycle_log::{CycleLog, Heading};
use crate::control::mask::FileUse;
use crate::control::text::decode;
use crate::length::Unit;
use crate::nc::program::TextOperand;
use crate::probing::cycle::{Cycle, CycleResult, LogTarget};

impl Machine {
    /// Writes or shows the log of a cycle. Logs of the same name are added to one another, as
    /// [`CycleLog::append`] says; one that cannot be written is remarked, and the run goes on.
    pub(super) fn log(&mut self, at: usize, cycle: &'static Cycle, result: &CycleResult) -> Result<(), FaultKind> {
        let (LogTarget::File(_) | LogTarget::Screen) = result.log else { return Ok(()) };
        let Some(name) = cycle.log.file().map(str::to_owned) else { return Ok(()) };
        let path = self.path_of(&TextOperand::Text(name))?;
        let program = Some(self.frame.path.to_string());
        let heading = Heading { date_time: Some(self.settings.time), program, unit: Unit::Millimetre };
        let language = self.settings.language;
        let Some(log) = CycleLog::of(cycle, result, &heading, language) else { return Ok(()) };
        let alone = match log.write(language) {
            Ok(bytes) => bytes,
            Err(error) => {
                self.remark(at, Remark::NotSaved { path, reason: error.to_string() });
                return Ok(());
            }
        };
        let text = decode(&alone).replace("\r\n", "\n");
        self.output_bytes += text.len();
        if self.budget().output_bytes < self.output_bytes {
            return Err(UsedUp::Output(self.budget().output_bytes).into());
        }
        if result.log == LogTarget::Screen {
            Budget::one_more(self.windows.len(), self.budget().windows, UsedUp::Windows)?;
            let place = self.place_of(at);
            self.windows.push(Window { place, mask: path, text, is_open: true });
            return Ok(());
        }
        Budget::one_more(self.outputs.len(), self.budget().outputs, UsedUp::Outputs)?;
        let is_saved = self.save_log(at, &path, &log)?;
        let place = self.place_of(at);
        self.outputs.push(Written { place, path, text, how: FileUse::Append, is_saved });
        Ok(())
    }

    /// Whether the log stands in the file now.
    fn save_log(&mut self, at: usize, path: &NcPath, log: &CycleLog) -> Result<bool, FaultKind> {
        let before = match self.read(path) {
            Err(FaultKind::Store(StoreError::Missing { .. })) => Vec::new(),
            read => read?,
        };
        let bytes = match log.append(&before, self.settings.language) {
            Ok(bytes) => bytes,
            Err(error) => {
                self.remark(at, Remark::NotSaved { path: path.clone(), reason: error.to_string() });
                return Ok(false);
            }
        };
        match self.store.write(path, &bytes, FileUse::Replace) {
            Ok(size) => self.moved(size).map(|()| true),
            Err(StoreError::ReadOnly) => {
                self.remark(at, Remark::NotWritten { path: path.clone() });
                Ok(false)
            }
            Err(error) => Err(error.into()),
        }
    }
}
