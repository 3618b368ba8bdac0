//! `FUNCTION FILECOPY`, `FILEMOVE`, `FILEDELETE`: done in the folder that outputs go to, and nowhere else.
//!
//! A target that is there is replaced, and a source that is missing is an error (datum-cycles, section 10; not verified).

use fitcheck_core::text::decode;

use super::super::fault::FaultKind;
use super::super::files::Files;
use super::super::path::NcPath;
use super::super::presets::is_preset_table;
use super::super::prints::{Written, save};
use super::super::remark::Remark;
use super::super::store::StoreError;
use super::super::values::whole;
use super::Run;
use super::skipped::ReadAs;
use crate::control::mask::FileUse;
use crate::control::variables::Parameter;
use crate::program::{FileFunction, SystemDatum, TextOperand};

impl Run {
    /// Copies, moves or deletes a file.
    pub(super) fn file(&mut self, at: usize, function: &FileFunction, files: &mut Files) -> Result<(), FaultKind> {
        match function {
            FileFunction::Copy { from, to } => {
                let (from, to) = (self.file_path(from)?, self.file_path(to)?);
                self.copy(at, &from, to, files).map(|_is_done| ())
            }
            FileFunction::Move { from, to } => {
                let (from, to) = (self.file_path(from)?, self.file_path(to)?);
                if from == to || !self.copy(at, &from, to, files)? {
                    return Ok(());
                }
                self.look_at_presets(at, &from);
                self.prints.removed(&from);
                files.remove(&from)
            }
            FileFunction::Delete(path) => {
                let path = self.file_path(path)?;
                if files.writes() {
                    files.remove(&path)?;
                    self.look_at_presets(at, &path);
                    self.prints.removed(&path);
                    self.remark(at, Remark::Deleted { path });
                } else {
                    self.remark(at, Remark::NotDeleted { path });
                }
                Ok(())
            }
        }
    }

    /// What FN 18 answers about a file whose path is in a QS parameter: 1 where it is there, else 0 (TNC7 basic, system data ID10 NR110);
    /// `None` for another question, and where a block that was not run may have made it or removed it.
    pub(super) fn file_is_there(&self, datum: &SystemDatum, files: &mut Files) -> Option<f64> {
        let number = |operand| self.values.operand(operand).ok().and_then(whole);
        if datum.group != 10 || datum.number.and_then(number) != Some(110) {
            return None;
        }
        let path = Parameter::qs(u16::try_from(number(datum.index?)?).ok()?);
        let path = self.path_of(&TextOperand::Parameter(path)).ok()?;
        self.check_file(&path, ReadAs::Table).ok()?;
        match files.read(&path) {
            Ok(_) => Some(1.0),
            Err(FaultKind::Store(StoreError::Missing { .. })) => Some(0.0),
            Err(_) => None,
        }
    }

    /// A path of a file whose content is known.
    fn file_path(&self, operand: &TextOperand) -> Result<NcPath, FaultKind> {
        let path = self.path_of(operand)?;
        self.check_file(&path, ReadAs::Table)?;
        if self.tables.path() == Some(&path) { Err(FaultKind::FileOpen { path }) } else { Ok(path) }
    }

    /// Which presets another file of the preset table has, and whether one of them is active, is not followed.
    fn look_at_presets(&mut self, at: usize, path: &NcPath) {
        if is_preset_table(path) {
            self.around.lose_system(|| self.flow.made(at));
            self.remark(at, Remark::NotFollowed);
        }
    }

    /// Whether the file was copied.
    fn copy(&mut self, at: usize, from: &NcPath, to: NcPath, files: &mut Files) -> Result<bool, FaultKind> {
        // What the run itself would have written is not there.
        if !files.writes() {
            self.remark(at, Remark::NotWritten { path: to });
            return Ok(false);
        }
        let bytes = files.read(from)?;
        let text = decode(&bytes).replace("\r\n", "\n");
        self.look_at_presets(at, &to);
        self.prints.count_output(&to, &text)?;
        self.prints.removed(&to);
        let is_saved = save(&to, &bytes, FileUse::Replace, files)?;
        let place = self.flow.place_of(at);
        self.prints.keep(Written { place, path: to, text, how: FileUse::Replace, is_saved });
        Ok(is_saved)
    }
}
