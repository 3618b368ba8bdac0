//! The measuring logs that cycles ask for with Q281: to a file next to the program, or on the screen.

use fitcheck_core::length::Unit;
use fitcheck_core::message::Say as _;
use fitcheck_core::probing::cycle::{Cycle, CycleResult, LogTarget};
use fitcheck_core::text::decode;
use fitcheck_core::words::Dialogue;

use super::budget::Settings;
use super::fault::{BlockPlace, FaultKind};
use super::files::Files;
use super::flow::Flow;
use super::path::NcPath;
use super::prints::{Prints, Written, save};
use super::remark::{Remark, Remarks};
use super::store::StoreError;
use crate::control::cycle_log::{CycleLog, Heading};
use crate::control::mask::FileUse;
use crate::program::Unit as ProgramUnit;

/// The log of a cycle, and where it goes.
#[derive(Debug)]
pub(super) struct Log {
    content: CycleLog,
    path: NcPath,
    is_shown: bool,
    language: Dialogue,
}

impl Log {
    /// The log that a cycle in a program asks for.
    pub(super) fn of(
        cycle: &'static Cycle,
        result: &CycleResult,
        flow: &Flow,
        settings: &Settings,
        is_simulated: bool,
    ) -> Result<Option<Self>, FaultKind> {
        let (LogTarget::File(_) | LogTarget::Screen) = result.log else { return Ok(None) };
        let Some(name) = cycle.log.file() else { return Ok(None) };
        let path = flow.path().resolve(name)?;
        let program = Some(flow.path().to_string());
        let unit = if flow.main_unit() == Some(ProgramUnit::Inch) { Unit::Inch } else { Unit::Millimetre };
        let heading = Heading { date_time: Some(settings.time), program, unit, is_simulated };
        let language = settings.language;
        let is_shown = result.log == LogTarget::Screen;
        let content = CycleLog::of(cycle, result, &heading, language);
        Ok(content.map(|content| Self { content, path, is_shown, language }))
    }

    /// Whether it gives another status than the cycle, because its figures are rounded.
    pub(super) fn other(&self, result: &CycleResult) -> Option<Remark> {
        let other = self.content.other_verdict(result, self.language)?;
        Some(Remark::Measured { what: other.message() })
    }

    /// Writes or shows it. A log is added to an earlier one of the same name, as [`CycleLog::append`] says; a log that
    /// cannot be written gives a remark, and the run goes on.
    pub(super) fn write(
        self,
        place: BlockPlace,
        prints: &mut Prints,
        files: &mut Files,
        remarks: &mut Remarks,
    ) -> Result<(), FaultKind> {
        let text = match self.content.write(self.language) {
            Ok(alone) => decode(&alone).replace("\r\n", "\n"),
            Err(error) => {
                remarks.add(place, Remark::NotSaved { path: self.path, reason: error.message() });
                return Ok(());
            }
        };
        if self.is_shown {
            return Ok(prints.show(place, self.path, text)?);
        }
        prints.count_output(&self.path, &text)?;
        let is_saved = self.save(&place, files, remarks)?;
        prints.keep(Written { place, path: self.path, text, how: FileUse::Append, is_saved });
        Ok(())
    }

    /// Whether the log is now in the file.
    fn save(&self, place: &BlockPlace, files: &mut Files, remarks: &mut Remarks) -> Result<bool, FaultKind> {
        let before = match files.read(&self.path) {
            Err(FaultKind::Store(StoreError::Missing { .. })) => Vec::new(),
            read => read?,
        };
        let path = || self.path.clone();
        let bytes = match self.content.append(&before, self.language) {
            Ok(bytes) => bytes,
            Err(error) => {
                remarks.add(place.clone(), Remark::NotSaved { path: path(), reason: error.message() });
                return Ok(false);
            }
        };
        let is_saved = save(&self.path, &bytes, FileUse::Replace, files)?;
        if !is_saved {
            remarks.add(place.clone(), Remark::NotWritten { path: path() });
        }
        Ok(is_saved)
    }
}
