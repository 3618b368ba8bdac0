//! Blocks that set something up for the measurements behind them.

use super::super::around::Made;
use super::super::fault::FaultKind;
use super::super::remark::Remark;
use super::Run;
use crate::nc::program::{Body, Frame};

impl Run {
    /// Does what such a block says; others do nothing here.
    pub(super) fn set_up(&mut self, at: usize, body: &Body) -> Result<(), FaultKind> {
        match body {
            Body::SelectProgram(path) => {
                let path = self.path_of(path)?;
                self.around.select(path);
            }
            Body::CycleDefinition(cycle) => {
                self.around.pass_over(&format!("CYCL DEF {}", cycle.number));
                self.around.stated(cycle, self.flow.unit(), &mut self.values)?;
            }
            Body::GlobalDefinition(cycle) => self.around.define(cycle, self.flow.unit(), &self.values)?,
            Body::Mode(mode) => self.around.set_mode(*mode),
            Body::Frame(frame) => self.change(at, frame)?,
            Body::SystemRead { to } => {
                let given = self.values.undefine(*to, self.is_main());
                let remark = given.is_none().then_some(Remark::NoSystemData { parameter: *to });
                self.note_given(at, *to, given);
                self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
            }
            _ => {}
        }
        Ok(())
    }

    /// A change of the system that coordinates count in.
    fn change(&mut self, at: usize, frame: &Frame) -> Result<(), FaultKind> {
        let program = self.flow.program();
        let line = program.blocks().get(at).map_or(0, |block| block.lines.start + 1);
        let text = program.text_of(at).next().unwrap_or_default().trim().to_owned();
        let remark = self.around.change(frame, Made { line, text }, self.flow.unit(), &self.values)?;
        self.remarks.add_all(&self.flow.place_of(at), remark.into_iter().collect());
        Ok(())
    }
}
