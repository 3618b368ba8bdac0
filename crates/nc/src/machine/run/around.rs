//! Blocks that set something up for the measurements behind them.

use super::super::around::machining;
use super::super::fault::FaultKind;
use super::super::files::Files;
use super::super::presets::row_number;
use super::super::remark::Remark;
use super::Run;
use super::skipped::ReadAs;
use crate::program::{Body, CycleBlock, Expression, Frame, Operand};
use fitcheck_core::probing::cycle::{DatumTarget, NewDatum};

impl Run {
    /// Does what such a block says; others do nothing here.
    pub(super) fn set_up(&mut self, at: usize, body: &Body, files: &mut Files) -> Result<(), FaultKind> {
        match body {
            Body::SelectProgram(path) => {
                let path = self.path_of(path)?;
                self.around.select(path);
            }
            Body::CycleDefinition(cycle) => {
                self.around.stated(cycle, false, self.flow.unit(), &mut self.values)?;
                self.machining(at, cycle);
            }
            Body::GlobalDefinition(cycle) => self.around.define(cycle, self.flow.unit(), &self.values)?,
            Body::Mode(mode) => self.around.set_mode(*mode),
            Body::Frame(Frame::Preset(number)) => self.activate(at, *number, files)?,
            Body::Frame(frame) => self.change(at, frame)?,
            Body::SystemRead { to, datum } => {
                if let Some(value) = datum.as_ref().and_then(|datum| self.system_value(datum)) {
                    let given = self.values.assign(*to, &Expression::Value(Operand::Number(value)), self.is_main())?;
                    self.note_given(at, *to, given);
                    return Ok(());
                }
                let given = self.values.lose_system(*to, || self.flow.made(at), self.is_main());
                let remark = given.is_none().then_some(Remark::NoSystemData { parameter: *to });
                self.note_given(at, *to, given);
                self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
            }
            _ => {}
        }
        Ok(())
    }

    /// `CYCL DEF` of a cycle that machines: those of the machine's builder may do anything.
    fn machining(&mut self, at: usize, cycle: &CycleBlock) {
        if let Some(number) = machining(cycle) {
            self.around.pass_over(&format!("CYCL DEF {}", cycle.number));
            self.around.turning(number, self.flow.made(at));
        } else {
            self.lose_all(at);
            self.remark(at, Remark::NotFollowed);
        }
    }

    /// Cycle 247: another preset.
    fn activate(&mut self, at: usize, number: Option<Operand>, files: &mut Files) -> Result<(), FaultKind> {
        let number = number.map(|number| self.values.operand(number)).transpose()?;
        let row = number.and_then(row_number);
        let table = match row {
            Some(row) => self.presets.row(row, files)?,
            None => None,
        };
        self.check_presets()?;
        let remark = self.around.activate(number, table, self.flow.made(at));
        self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
        Ok(())
    }

    /// The datum that a cycle has found: what follows counts from there.
    pub(super) fn set_datum(&mut self, at: usize, new: &NewDatum, files: &mut Files) -> Result<(), FaultKind> {
        let row = match new.target {
            DatumTarget::Preset { row } => Some(row),
            // Where no block has named the active row: as where the display is set.
            DatumTarget::Active => self.around.preset().and_then(row_number),
            DatumTarget::Display => None,
            DatumTarget::Table { row } => return Err(FaultKind::NoDatumTable { row }),
        };
        let table = match row {
            Some(row) => self.presets.unlocked(row, files)?,
            None => None,
        };
        self.check_presets()?;
        let (remarks, written) = self.around.set_datum(new, (row, table), self.flow.made(at))?;
        let place = self.flow.place_of(at);
        self.remarks.add_all(&place, remarks);
        let remark = self.presets.write(row.unwrap_or(0), written, files)?;
        self.remarks.add_all(&place, remark.into_iter().collect());
        Ok(())
    }

    /// An error where a block may have changed the preset table that was not run.
    fn check_presets(&self) -> Result<(), FaultKind> {
        self.presets.path().map_or(Ok(()), |path| self.check_file(path, ReadAs::Table))
    }

    /// A change of the system that coordinates count in.
    fn change(&mut self, at: usize, frame: &Frame) -> Result<(), FaultKind> {
        let remark =
            self.around.change(frame, self.flow.made(at), self.flow.unit(), &|operand| self.values.operand(operand))?;
        self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
        Ok(())
    }
}
