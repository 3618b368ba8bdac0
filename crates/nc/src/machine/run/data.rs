//! Blocks that set parameters, and blocks that read and write tables.

use super::super::fault::FaultKind;
use super::super::files::Files;
use super::super::presets::is_preset_table;
use super::super::remark::Remark;
use super::Run;
use super::skipped::ReadAs;
use crate::program::{Body, TextOperand};

impl Run {
    /// Sets a parameter or takes its value away; others have no effect here.
    pub(super) fn assign(&mut self, at: usize, body: &Body) -> Result<(), FaultKind> {
        let (to, given) = match body {
            Body::Assign { to, value } => (*to, self.values.assign(*to, value, self.is_main())?),
            Body::AssignText { to, value } => (*to, self.values.assign_text(*to, value, self.is_main())?),
            Body::Undefine(to) => (*to, self.values.undefine(*to, self.is_main())),
            _ => return Ok(()),
        };
        self.note_given(at, to, given);
        Ok(())
    }

    /// FN 26, FN 27, FN 28; others have no effect here.
    pub(super) fn table(&mut self, at: usize, body: &Body, files: &mut Files) -> Result<(), FaultKind> {
        match body {
            Body::TableOpen(path) => self.open_table(at, path, files),
            Body::TableRead { to, row, columns } => {
                if let Some(path) = self.tables.path() {
                    self.check_file(path, ReadAs::Table)?;
                }
                let found = self.tables.read(*to, *row, columns, self.flow.unit(), &self.values)?;
                self.remarks.add_all(&self.flow.place_of(at), found.remarks);
                found.values.into_iter().try_for_each(|(to, value)| self.values.put(to, value))
            }
            Body::TableWrite { row, columns, from } => {
                let mut cells = self.tables.cells(*row, columns, *from, self.flow.unit(), &self.values)?;
                self.remarks.add_all(&self.flow.place_of(at), std::mem::take(&mut cells.remarks));
                // Which presets it changes, and whether one of them is active, is not followed.
                if self.tables.path().is_some_and(is_preset_table) {
                    self.around.lose_system(|| self.flow.made(at));
                    self.remark(at, Remark::NotFollowed);
                }
                // What was not measured stays known as such.
                let is_simulated = self.cycles.is_simulated() && !self.cycles.runs().is_empty();
                self.tables.write(at, cells, is_simulated, files)
            }
            _ => Ok(()),
        }
    }

    /// FN 26: closes the table that is still open.
    fn open_table(&mut self, at: usize, path: &TextOperand, files: &mut Files) -> Result<(), FaultKind> {
        let path = self.path_of(path)?;
        self.check_file(&path, ReadAs::Table)?;
        if self.tables.path() == Some(&path) {
            return Ok(());
        }
        self.close_table(files)?;
        let remarks = self.tables.open(path, files)?;
        self.remarks.add_all(&self.flow.place_of(at), remarks);
        Ok(())
    }
}
