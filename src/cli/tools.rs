//! The tool table as an option: what subcommands that run measuring cycles share.

use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::io::not_dash;
use super::{CliError, CliRemark, IntoCliError as _, Io, read_input, save};
use crate::control::tool_table::{Changed, ToolChange, ToolTable};

/// Where the tool table comes from and goes to.
#[derive(Debug, clap::Args)]
pub(super) struct ToolArgs {
    /// Tool table of a control, in which cycles with Q330 correct the tool
    #[arg(long = "tools", value_name = "FILE.t")]
    from: Option<PathBuf>,
    /// Write the tool table with its changes to this file
    #[arg(long = "tools-out", value_name = "FILE.t", requires = "from")]
    to: Option<PathBuf>,
}

impl ToolArgs {
    /// The table, where one is given.
    pub(super) fn read(&self, io: &mut Io<'_>) -> Result<Option<ToolTable>, CliError> {
        let Some(path) = &self.from else { return Ok(None) };
        let (name, bytes) = read_input(path, io)?;
        let table = ToolTable::read(&bytes, &name).said()?;
        for warning in table.warnings() {
            io.warn(warning);
        }
        Ok(Some(table))
    }

    /// Writes the table where it was asked for, and returns where; a changed one that is not written is told.
    pub(super) fn write(
        &self,
        table: Option<&ToolTable>,
        is_changed: bool,
        io: &mut Io<'_>,
    ) -> Result<Option<String>, CliError> {
        if let (Some(table), Some(path)) = (table, &self.to) {
            not_dash(path)?;
            let name = path.display().to_string();
            save(path, &table.write().about(&name)?, io)?;
            return Ok(Some(name));
        }
        if is_changed {
            io.remark(&CliRemark::ToolsNotWritten);
        }
        Ok(None)
    }
}

/// A change for programs: texts as in the table, in its unit, and millimetres.
pub(super) fn json(change: &ToolChange) -> Json {
    let (from, to) = match change.what {
        Changed::Delta { from, to, .. } => (Some(from.to_mm_f64()), Some(to.to_mm_f64())),
        Changed::Locked(_) => (None, None),
    };
    json!({
        "tool": change.tool.to_string(),
        "name": change.name,
        "column": change.column(),
        "from": change.from,
        "to": change.to,
        "from_mm": from,
        "to_mm": to,
        "by_mm": change.correction.by.to_mm_f64(),
    })
}
