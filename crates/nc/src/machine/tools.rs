//! The tool table of a run: the tool of Q330 after a cycle, and the called tool before one.
//!
//! The rules of Q330 are in `control::tool_table::monitor`.

use std::sync::Arc;

use fitcheck_core::message::Arg;
use fitcheck_core::probing::cycle::{Cycle, CycleResult};

use super::around::ChangingBlock;
use super::fault::{BlockPlace, FaultKind};
use super::remark::{Remark, Remarks};
use super::values::Values;
use crate::control::tool_table::{
    Changed, Monitored, PROBE, Tool as TableTool, ToolChange, ToolFault, ToolNumber, ToolTable,
};
use crate::program::Tool;

/// A change of the tool table, and the block of the cycle that made it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToolChanged {
    pub place: BlockPlace,
    pub change: ToolChange,
}

/// The tool table of a run, if it has one.
#[derive(Debug)]
pub(super) struct Tools {
    table: Option<ToolTable>,
    changes: Vec<ToolChanged>,
    /// The row of the tool that was called last, until a cycle has asked for it.
    called: Option<usize>,
    /// The same, until another one is called.
    in_spindle: Option<usize>,
    /// A block that was not run may have changed the table.
    lost: Option<Arc<ChangingBlock>>,
}

impl Tools {
    pub(super) const fn new(table: Option<ToolTable>) -> Self {
        Self { table, changes: Vec::new(), called: None, in_spindle: None, lost: None }
    }

    pub(super) const fn table(&self) -> Option<&ToolTable> {
        self.table.as_ref()
    }

    pub(super) fn changes(&self) -> &[ToolChanged] {
        &self.changes
    }

    /// A block that was not run may have changed the table.
    pub(super) fn lose(&mut self, by: impl FnOnce() -> Arc<ChangingBlock>) {
        if self.table.is_some() {
            self.lost.get_or_insert_with(by);
        }
    }

    /// TOOL CALL: remarks about a tool that the table lacks, or has several times.
    pub(super) fn call(&mut self, tool: Option<&Tool>, values: &Values) -> Result<Vec<Remark>, FaultKind> {
        let (Some(table), Some(tool)) = (&self.table, tool) else { return Ok(Vec::new()) };
        let (row, more, shown) = match tool {
            Tool::Number(number) => {
                let value = values.operand(*number)?;
                let row = ToolNumber::of(value).ok().and_then(|number| table.row_of(number));
                (row, 0, value.to_string())
            }
            Tool::Name(name) => {
                let name = values.text_operand(name)?;
                let rows = table.rows_named(name);
                (rows.first().copied(), rows.len().saturating_sub(1), name.to_owned())
            }
        };
        self.called = row;
        self.in_spindle = row;
        Ok(match self.called {
            // The number of a tool is a name: it keeps its point in every language.
            None => vec![Remark::NoSuchTool { tool: Arg::Text(shown) }],
            Some(_) if 0 < more => vec![Remark::SameName { tool: shown, more }],
            Some(_) => Vec::new(),
        })
    }

    /// The table, unless a block that was not run may have changed it.
    pub(super) fn known(&self) -> Option<&ToolTable> {
        self.table.as_ref().filter(|_| self.lost.is_none())
    }

    /// What the table says of the tool that was called last.
    pub(super) fn in_spindle(&self) -> Option<&TableTool> {
        self.known()?.tools().get(self.in_spindle?)
    }

    /// Remarks about the called tool before a cycle, made once per call.
    pub(super) fn called(&mut self) -> Vec<Remark> {
        let row = self.called.take();
        let Some(tool) = self.table.as_ref().zip(row).and_then(|(table, row)| table.tools().get(row)) else {
            return Vec::new();
        };
        let locked = tool.is_locked.then_some(Remark::ToolLocked { tool: tool.number });
        let other = tool.kind.filter(|_| tool.is_no_probe());
        let other = other.map(|kind| Remark::NoProbeTool { tool: tool.number, kind, probe: PROBE });
        locked.into_iter().chain(other).collect()
    }

    /// A result as a control with this table sees it.
    pub(super) fn seen(&self, result: CycleResult) -> CycleResult {
        if self.table.is_some() { result.with_tool_table() } else { result }
    }

    /// Monitors the tool of Q330 and keeps the change. A broken tool is locked, and the run stops.
    pub(super) fn monitor(
        &mut self,
        place: &BlockPlace,
        cycle: &'static Cycle,
        result: &CycleResult,
        remarks: &mut Remarks,
    ) -> Result<(), FaultKind> {
        let Some(table) = &mut self.table else { return Ok(()) };
        if let Some(lost) = &self.lost
            && table.clone().monitor(cycle, result)?.is_some()
        {
            let ChangingBlock { line, text } = lost.as_ref().clone();
            return Err(FaultKind::ToolsUnknown { line, text });
        }
        let Some(Monitored { change, same_name }) = table.monitor(cycle, result)? else { return Ok(()) };
        if let Some((tool, more)) = same_name {
            remarks.add(place.clone(), Remark::SameName { tool, more });
        }
        let Some(change) = change else { return Ok(()) };
        let broken = if let Changed::Locked(broken) = change.what { Some(broken) } else { None };
        self.changes.push(ToolChanged { place: place.clone(), change });
        broken.map_or(Ok(()), |broken| Err(ToolFault::Broken(broken).into()))
    }
}
