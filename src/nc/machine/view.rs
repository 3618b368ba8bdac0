//! What the machine shows of itself: parameters, place, windows, path, and all it remembers of the run.

use std::sync::Arc;

use super::budget::Settings;
use super::cycles::CycleRun;
use super::fault::BlockPlace;
use super::flow::Call;
use super::moves::Travel;
use super::path::NcPath;
use super::prints::{Window, Written};
use super::remark::Remark;
use super::run::{Machine, State};
use super::tables::OpenTable;
use crate::control::variables::{Parameter, Variables};
use crate::nc::program::Program;
use crate::verdict::Status;

impl Machine {
    /// Sets or clears a breakpoint; `program` is a path as programs write it.
    pub fn toggle_breakpoint(&mut self, program: &str, block: usize) {
        let Ok(path) = NcPath::new(program) else { return };
        let breakpoint = (path, block);
        if !self.breakpoints.remove(&breakpoint) {
            self.breakpoints.insert(breakpoint);
        }
    }

    /// The breakpoints by program and block.
    pub fn breakpoints(&self) -> impl Iterator<Item = (&NcPath, usize)> {
        self.breakpoints.iter().map(|(path, block)| (path, *block))
    }

    /// All parameters that have a value now.
    pub const fn variables(&self) -> &Variables {
        &self.variables
    }

    /// The parameters that the last block has set.
    pub fn changed(&self) -> &[Parameter] {
        &self.changed
    }

    /// The block that is run next.
    pub fn place(&self) -> BlockPlace {
        self.place_of(self.frame.next)
    }

    /// The program that is running.
    pub const fn current(&self) -> &Arc<Program> {
        &self.frame.program
    }

    /// A program that has been loaded, by its path as programs write it.
    pub fn program(&self, path: &str) -> Option<&Arc<Program>> {
        self.programs.get(&NcPath::new(path).ok()?)
    }

    /// The calls that lead here, the outermost first.
    pub fn calls(&self) -> &[Call] {
        &self.calls
    }

    /// What FN 16 has shown, in order; `SCLR:` closes windows.
    pub fn windows(&self) -> &[Window] {
        &self.windows
    }

    /// What FN 16 has printed to files, in order.
    pub fn outputs(&self) -> &[Written] {
        &self.outputs
    }

    /// What the cycles have found, in order.
    pub fn cycles(&self) -> &[CycleRun] {
        &self.cycles
    }

    /// The way of the ball's centre so far.
    pub fn path(&self) -> &[Travel] {
        &self.path
    }

    /// Where the ball's centre stands, mm, in X, Y and Z as far as it is known.
    pub const fn position(&self) -> [Option<f64>; 3] {
        self.position.axes()
    }

    /// What is worth knowing, in order.
    pub fn remarks(&self) -> &[(BlockPlace, Remark)] {
        &self.remarks
    }

    /// How many remarks are not listed.
    pub const fn unlisted_remarks(&self) -> usize {
        self.unlisted
    }

    /// How many blocks were run.
    pub const fn blocks_run(&self) -> u64 {
        self.blocks_run
    }

    /// The table that is open.
    pub fn table(&self) -> Option<&NcPath> {
        self.table.as_ref().map(OpenTable::path)
    }

    /// Whether the run is over, by its end or by a fault.
    pub const fn is_over(&self) -> bool {
        !matches!(self.state, State::Ready)
    }

    /// The worst status of the cycles that judged.
    pub fn status(&self) -> Option<Status> {
        self.cycles.iter().filter_map(|run| run.result.status).max()
    }

    /// The settings of the run.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }
}
