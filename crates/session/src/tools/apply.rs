//! How the tool table is opened and closed, and what of it is written.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_nc::control::tool_table::ToolTable;

use super::{OpenTools, ToolsCommand};
use crate::Session;
use crate::page::Page;
use crate::shared::{News, Shared};

impl Shared {
    /// Does a command.
    pub fn apply_tools(&mut self, command: ToolsCommand) {
        match command {
            ToolsCommand::Read { name, result } => {
                let Some(table) = self.file_answered(result) else { return };
                let details = table.warnings().iter().map(fitcheck_core::message::Say::message).collect();
                self.note_details(message!("tools-loaded").text("name", &name), details);
                self.tools = Some(Arc::new(OpenTools { name, table: *table }));
            }
            ToolsCommand::Close => self.tools = None,
        }
        self.spread(News::Tools);
    }

    /// The tool table that a run begins with.
    pub fn tool_table(&self) -> Option<&ToolTable> {
        self.tools.as_ref().map(|tools| &tools.table)
    }
}

impl Session {
    /// The tool table that was opened.
    pub fn tools(&self) -> Option<&OpenTools> {
        self.shared.tools.as_deref()
    }

    /// The tool table as the run of the open page has changed it; `None` where it has changed nothing.
    pub fn changed_tools(&self) -> Option<&ToolTable> {
        match self.shared.page {
            Page::Program => self.program.run.as_ref()?.changed_tools(),
            Page::Cycles => self.cycles.run.as_ref()?.monitoring.as_ref()?.changed(),
            _ => None,
        }
    }

    /// The bytes of that table.
    pub(crate) fn tools_bytes(&self) -> Result<Vec<u8>, Message> {
        let table = self.changed_tools().ok_or_else(|| message!("tools-nothing-changed"))?;
        table.write().map_err(|error| error.message())
    }
}
