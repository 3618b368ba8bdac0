//! Blocks that are not run: what they may have changed is unknown behind them, and nothing reads or measures it.

use std::sync::Arc;

use super::super::around::Made;
use super::super::fault::FaultKind;
use super::super::files::Files;
use super::super::path::NcPath;
use super::super::remark::Remark;
use super::Run;
use crate::nc::program::{CycleBlock, Unread};

/// Cycles of `TCH PROBE` that set no datum and no rotation: one point, angles, calibration, tools, bolt circles, planes, fast probing
/// (datum-cycles, sections 4 to 6).
fn sets_no_datum(number: u32) -> bool {
    matches!(number, 0..=4 | 9 | 30..=33 | 420 | 430 | 431 | 441 | 460..=463 | 480..=484)
}

/// Those that measure tools.
fn measures_tools(number: u32) -> bool {
    matches!(number, 30..=33 | 480..=484)
}

impl Run {
    /// Skips an unknown block.
    ///
    /// # Errors
    /// [`FaultKind::NotSkipped`] where it decides what runs next.
    pub(super) fn skip(&mut self, at: usize, files: &mut Files) -> Result<(), FaultKind> {
        let place = self.flow.place_of(at);
        let known = self.unread.get(&place).cloned();
        let unread = known.unwrap_or_else(|| Arc::new(self.flow.program().unread(at)));
        self.unread.entry(place).or_insert_with(|| Arc::clone(&unread));
        match unread.as_ref() {
            Unread::Flow => return Err(FaultKind::NotSkipped),
            Unread::Nothing => {}
            Unread::Sets(parameters) => {
                let by = Arc::new(self.flow.made(at));
                for parameter in parameters {
                    let given = self.values.lose_assigned(*parameter, &by, self.is_main());
                    self.note_given(at, *parameter, given);
                }
            }
            // The table that is open is not the one that the program means.
            Unread::Table => self.close_table(files)?,
            Unread::Files => {
                let by = self.flow.made(at);
                if !self.unknown_files.contains(&by) {
                    self.unknown_files.push(by);
                }
            }
            Unread::Anything(parameters) => {
                self.lose_all(at);
                if !parameters.is_empty() {
                    let by = Arc::new(self.flow.made(at));
                    for parameter in parameters {
                        self.values.lose(*parameter, &by);
                    }
                }
            }
        }
        self.remark(at, Remark::Skipped);
        Ok(())
    }

    /// Skips a measuring cycle that nothing here runs. What its block states can be read afterwards.
    pub(super) fn skip_cycle(&mut self, at: usize, block: &CycleBlock) -> Result<(), FaultKind> {
        let number = block.number.split('.').next().and_then(|number| number.parse().ok());
        // Fast probing measures nothing, and sets nothing but how the others move.
        if number == Some(441) {
            self.remark(at, Remark::Skipped);
            return self.around.stated(block, true, self.flow.unit(), &mut self.values);
        }
        self.lose_measured(at, block);
        self.around.stated(block, true, self.flow.unit(), &mut self.values)?;
        self.way.lose();
        // Tools and calibrations have no contacts of the workpiece.
        if !number.is_some_and(|number| measures_tools(number) || matches!(number, 2 | 9 | 460..=463)) {
            self.cycles.lose(|| self.flow.made(at));
        }
        if number.is_none_or(measures_tools) {
            self.tools.lose(|| Arc::new(self.flow.made(at)));
        }
        if number.is_some_and(sets_no_datum) {
            self.remark(at, Remark::MeasurementSkipped);
        } else {
            self.around.lose_system(|| self.flow.made(at));
            self.remark(at, Remark::DatumSkipped);
        }
        Ok(())
    }

    /// The results of a measuring cycle that is not run are undefined behind it, also where an earlier one had set them.
    pub(super) fn lose_measured(&mut self, at: usize, block: &CycleBlock) {
        let by = Arc::new(self.flow.made(at));
        self.values.lose_results(&by);
        block.named().into_iter().for_each(|parameter| self.values.lose(parameter, &by));
    }

    /// A block may have measured, set a datum, changed the tool and moved it.
    pub(super) fn lose_all(&mut self, at: usize) {
        let flow = &self.flow;
        self.values.lose_results(&Arc::new(flow.made(at)));
        self.around.lose_system(|| flow.made(at));
        self.around.lose_globals();
        self.tools.lose(|| Arc::new(flow.made(at)));
        self.way.lose();
    }

    /// An error for a file that a block may have written which was not run.
    pub(super) fn check_file(&self, path: &NcPath) -> Result<(), FaultKind> {
        let name = path.file_name().to_lowercase();
        // A name in a parameter may be any.
        let may_name = |made: &&Made| {
            let text = made.text.to_lowercase();
            text.contains(&name) || text.contains("qs")
        };
        let Some(Made { line, text }) = self.unknown_files.iter().find(may_name).cloned() else { return Ok(()) };
        Err(FaultKind::FileUnknown { path: path.clone(), line, text })
    }
}
