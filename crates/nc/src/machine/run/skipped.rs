//! Blocks that are not run: what they may have changed is unknown behind them, and nothing reads or measures it.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::super::around::ChangingBlock;
use super::super::change::{cycle_number, may_set_datum};
use super::super::fault::FaultKind;
use super::super::files::Files;
use super::super::path::NcPath;
use super::super::remark::Remark;
use super::Run;
use crate::program::{Body, CycleBlock, Unread};

/// Cycles of `TCH PROBE` that measure tools.
fn measures_tools(number: u32) -> bool {
    matches!(number, 30..=33 | 480..=484 | 580..=589)
}

/// Those that calibrate the probe.
fn calibrates(number: u32) -> bool {
    matches!(number, 2 | 9 | 460..=463)
}

/// Fast probing: it measures nothing, and sets nothing but how the others move.
const FAST_PROBING: u32 = 441;

/// Files that a block may have written, moved or removed which was not run.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Touched {
    /// Those that this text names, in small letters.
    Named(String),
    /// The one with this path, in small letters.
    Path(String),
    AnyTable,
}

/// Such files, and the first block that may have touched them.
#[derive(Debug, Default)]
pub(super) struct UnknownFiles(BTreeMap<Touched, ChangingBlock>);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ReadAs {
    Table,
    /// A program or a mask.
    Other,
}

impl Touched {
    fn may_be(&self, path: &NcPath, read_as: ReadAs) -> bool {
        match self {
            // A name in a parameter, or with a wildcard, may be any.
            Self::Named(text) => {
                text.contains(&path.file_name().to_lowercase()) || text.contains("qs") || text.contains(['*', '?'])
            }
            Self::Path(touched) => *touched == path.to_string().to_lowercase(),
            Self::AnyTable => read_as == ReadAs::Table,
        }
    }
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
            Unread::TableOpen => self.close_table(files)?,
            Unread::TableWrite => {
                // Where none is open, a block that opens one may have been skipped.
                let open = self.tables.path().map(|path| path.to_string().to_lowercase());
                self.touch(at, open.map_or(Touched::AnyTable, Touched::Path));
            }
            Unread::Sql(parameters) => {
                self.lose_all(at);
                self.touch(at, Touched::AnyTable);
                // Any later block of SQL may fill what one of them has bound.
                self.bound.extend(parameters);
                let by = Arc::new(self.flow.made(at));
                for parameter in &self.bound {
                    self.values.lose(*parameter, &by);
                }
            }
            Unread::Files => {
                // Each line of the block may have a name.
                let text = self.flow.program().text_of(at).collect::<Vec<_>>().join("\n").to_lowercase();
                self.touch(at, Touched::Named(text));
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

    /// Says that measuring cycles stand behind the end of a program: no control reads on.
    pub(super) fn look_behind_end(&mut self, at: usize) {
        let behind = self.flow.program().blocks().iter().skip(at + 1);
        let count = behind.filter(|block| matches!(block.body, Body::Probe(_))).count();
        if 0 < count {
            self.remark(at, Remark::MeasurementBehindEnd { count });
        }
    }

    /// Passes over a cycle on which no fit depends here, whatever the user has chosen; `None` for another one. What it would return is that
    /// which was given before the run, or undefined.
    pub(super) fn pass_cycle(&mut self, at: usize, block: &CycleBlock) -> Option<Result<(), FaultKind>> {
        let number = cycle_number(&block.number)?;
        if number == FAST_PROBING {
            self.around.pass_over("TCH PROBE 441");
            return Some(self.around.stated(block, true, self.flow.unit(), &mut self.values));
        }
        if !measures_tools(number) && !calibrates(number) {
            return None;
        }
        self.lose_measured(at, block);
        self.values.give_results();
        self.way.lose();
        if measures_tools(number) {
            self.lose_tools(at);
        }
        self.remark(at, Remark::CyclePassedOver);
        Some(self.around.stated(block, true, self.flow.unit(), &mut self.values))
    }

    /// Skips a measuring cycle that nothing here runs. What its block states can be read afterwards.
    pub(super) fn skip_cycle(&mut self, at: usize, block: &CycleBlock) -> Result<(), FaultKind> {
        self.lose_measured(at, block);
        self.around.stated(block, true, self.flow.unit(), &mut self.values)?;
        self.way.lose();
        self.cycles.lose(|| self.flow.made(at));
        if cycle_number(&block.number).is_none() {
            self.lose_tools(at);
        }
        if may_set_datum(&block.number) {
            self.around.lose_system(|| self.flow.made(at));
            self.remark(at, Remark::DatumSkipped);
        } else {
            self.remark(at, Remark::MeasurementSkipped);
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
        self.way.lose();
        self.lose_tools(at);
    }

    /// A block that is not run may have touched files.
    fn touch(&mut self, at: usize, touched: Touched) {
        self.unknown_files.0.entry(touched).or_insert_with(|| self.flow.made(at));
    }

    /// An error for a file that a block may have written which was not run.
    pub(super) fn check_file(&self, path: &NcPath, read_as: ReadAs) -> Result<(), FaultKind> {
        let found = self.unknown_files.0.iter().find(|(touched, _)| touched.may_be(path, read_as));
        let Some((_, ChangingBlock { line, text })) = found else { return Ok(()) };
        Err(FaultKind::FileUnknown { path: path.clone(), line: *line, text: text.clone() })
    }
}
