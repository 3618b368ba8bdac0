//! Blocks that set something up for the measurements behind them.

use super::super::around::machining;
use super::super::fault::FaultKind;
use super::super::files::Files;
use super::super::presets::{PresetRow, row_number};
use super::super::remark::Remark;
use super::Run;
use super::skipped::ReadAs;
use crate::program::{Axis, Body, CycleBlock, Expression, Frame, Operand};
use fitcheck_core::probing::cycle::{DatumTarget, NewDatum, NewRotation, Plane, RotaryAxis, TurnedBy};

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
                let value = datum.as_ref().and_then(|datum| self.system_value(datum));
                if let Some(value) = value.or_else(|| self.file_is_there(datum.as_ref()?, files)) {
                    let given = self.values.assign(*to, &Expression::Value(Operand::Number(value)), self.is_main())?;
                    self.note_given(at, *to, given);
                    let is_assumed = datum.as_ref().is_some_and(|datum| self.assumes_machine_zero(datum));
                    let place = self.flow.place_of(at);
                    self.remarks
                        .add_all(&place, is_assumed.then_some(Remark::MachineZeroAssumed).into_iter().collect());
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
        let (row, table) = self.row_for(new.target, files)?;
        let (remarks, written) = self.around.set_datum(new, (row, table), self.flow.made(at))?;
        let place = self.flow.place_of(at);
        self.remarks.add_all(&place, remarks);
        let remark = self.presets.write(row.unwrap_or(0), written, files)?;
        self.remarks.add_all(&place, remark.into_iter().collect());
        Ok(())
    }

    /// The row that a cycle writes into, and what the preset table has there.
    fn row_for(
        &mut self,
        target: DatumTarget,
        files: &mut Files,
    ) -> Result<(Option<u32>, Option<PresetRow>), FaultKind> {
        let row = match target {
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
        Ok((row, table))
    }

    /// How a cycle has turned the system, or the part in it: what follows counts in that.
    pub(super) fn set_rotation(&mut self, at: usize, new: &NewRotation, files: &mut Files) -> Result<(), FaultKind> {
        let target = match new.by {
            TurnedBy::Rotation(target) => target,
            TurnedBy::Axis { axis, is_zeroed } => {
                self.turn_part(at, axis, is_zeroed, new.degrees);
                return Ok(());
            }
        };
        let (row, _) = self.row_for(target, files)?;
        let written = self.around.set_rotation(new.degrees, row, self.flow.made(at));
        let remark = self.presets.write(row.unwrap_or(0), written, files)?;
        self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
        Ok(())
    }

    /// A rotary axis has turned the part: about the tool axis that is followed, about another nothing is known behind it.
    fn turn_part(&mut self, at: usize, axis: RotaryAxis, is_zeroed: bool, degrees: f64) {
        let about = match axis {
            RotaryAxis::A => Axis::A,
            RotaryAxis::B => Axis::B,
            RotaryAxis::C => Axis::C,
        };
        let is_about_tool = matches!(
            (self.around.plane(), axis),
            (Plane::Xy, RotaryAxis::C) | (Plane::Zx, RotaryAxis::B) | (Plane::Yz, RotaryAxis::A)
        );
        self.way.lose();
        if is_about_tool {
            self.around.turn_part(degrees, self.flow.made(at));
            if !is_zeroed {
                self.around.leave_turned(about);
            }
        } else {
            self.around.lose_system(|| self.flow.made(at));
            self.remark(at, Remark::NotFollowed);
        }
    }

    /// An error where a block may have changed the preset table that was not run.
    fn check_presets(&self) -> Result<(), FaultKind> {
        self.presets.path().map_or(Ok(()), |path| self.check_file(path, ReadAs::Table))
    }

    /// A change of the system that coordinates count in.
    fn change(&mut self, at: usize, frame: &Frame) -> Result<(), FaultKind> {
        let was_turned = self.around.is_turned();
        let remark =
            self.around.change(frame, self.flow.made(at), self.flow.unit(), &|operand| self.values.operand(operand))?;
        // Where rotary axes turn the part, the ball is elsewhere on it.
        let turns = matches!(frame, Frame::Tilt { axes_stay: false, .. } | Frame::TurnedBack | Frame::OtherTilt);
        if turns && (was_turned || self.around.is_turned()) {
            self.way.lose();
        }
        self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
        Ok(())
    }
}
