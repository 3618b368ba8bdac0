//! The tool table with which the cycles page and the program page monitor tools (Q330).
//!
//! Every run begins with the table as it was opened: what a run changes belongs to the run, until it is saved as a file.

mod apply;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::cycle::{Cycle, CycleResult, Inputs, Meaning, Value};
use fitcheck_nc::control::tool_table::{Changed, Monitored, Tool, ToolChange, ToolNumber, ToolTable};
use fitcheck_nc::control::variables::Parameter;
use fitcheck_nc::machine::Remark;

/// What can be done with the tool table.
#[derive(Debug, Clone)]
pub enum ToolsCommand {
    /// A tool table was read, or not.
    Read {
        /// Its name without the folder.
        name: String,
        result: Result<Box<ToolTable>, Message>,
    },
    /// Monitors no tools any more.
    Close,
}

/// A tool table that was opened.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenTools {
    /// The file's name.
    pub name: String,
    /// The table as it was read.
    pub table: ToolTable,
}

/// What the monitoring of a tool gave on the cycles page.
#[derive(Debug, Clone)]
pub struct Monitoring {
    table: ToolTable,
    /// What was found, or why nothing could be; `Ok(None)` where the cycle names no tool.
    found: Result<Option<Monitored>, Message>,
}

impl Monitoring {
    /// Monitors the tool of a result with a table; the opened one stays as it is.
    pub(super) fn of(table: &ToolTable, cycle: &'static Cycle, result: &CycleResult) -> Self {
        let mut table = table.clone();
        let found = table.monitor(cycle, result).map_err(|fault| fault.message());
        Self { table, found }
    }

    fn monitored(&self) -> Option<&Monitored> {
        self.found.as_ref().ok()?.as_ref()
    }

    /// The changed cell.
    pub fn change(&self) -> Option<&ToolChange> {
        self.monitored()?.change.as_ref()
    }

    fn changed(&self) -> Option<&ToolTable> {
        self.change().map(|_| &self.table)
    }

    /// Why the control would stop: a broken tool, or one that cannot be monitored.
    pub fn problem(&self) -> Option<Message> {
        match (&self.found, self.change().map(|change| change.what)) {
            (Err(problem), _) => Some(problem.clone()),
            (Ok(_), Some(Changed::Locked(broken))) => Some(broken.message()),
            (Ok(_), _) => None,
        }
    }

    /// What is worth knowing besides the change.
    pub fn remark(&self) -> Option<Message> {
        match &self.found {
            Ok(None) => Some(message!("tools-none-named")),
            Ok(Some(Monitored { same_name: Some((tool, more)), .. })) => {
                Some(Remark::SameName { tool: tool.clone(), more: *more }.message())
            }
            Ok(Some(Monitored { change: None, .. })) => Some(message!("tools-no-deviation")),
            _ => None,
        }
    }
}

/// A tool as Q330 names it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NamedTool {
    /// By its number, as errors write it.
    Number(String),
    Name(String),
}

impl NamedTool {
    /// The tool of a number; 0 is none.
    pub fn of_number(number: f64) -> Option<Self> {
        (number != 0.0).then(|| Self::Number(number.to_string()))
    }

    /// The tool that the inputs of a cycle name.
    pub fn of_inputs(cycle: &Cycle, inputs: &Inputs) -> Option<Self> {
        match cycle.value_of(inputs, Meaning::Tool)? {
            Value::Number(number) => Self::of_number(*number),
            Value::Text(name) => Some(Self::Name(name.clone())),
            _ => None,
        }
    }

    /// As it is written.
    pub fn text(&self) -> &str {
        let (Self::Number(text) | Self::Name(text)) = self;
        text
    }

    /// Its row in a table; of several with one name the first, as a control takes it.
    pub fn row(&self, table: &ToolTable) -> Option<usize> {
        match self {
            Self::Number(number) => table.row_of(number.parse::<ToolNumber>().ok()?),
            Self::Name(name) => table.rows_named(name).first().copied(),
        }
    }
}

/// What is typed to name a tool of a table: its number, or its name where a parameter holds texts. `None` where the name
/// finds another tool, or the tool has none.
pub fn text_of_tool(parameter: Option<Parameter>, tool: &Tool, row: usize, table: &ToolTable) -> Option<String> {
    if !parameter.is_some_and(|parameter| parameter.family.is_text()) {
        return Some(tool.number.to_string());
    }
    (table.rows_named(&tool.name).first() == Some(&row)).then(|| tool.name.clone())
}

/// A tool in one line, for people: number, name, lengths and tolerances.
pub fn tool_message(tool: &Tool) -> Message {
    let name = if tool.name.is_empty() { tool.number.to_string() } else { format!("{} {}", tool.number, tool.name) };
    // Like the table, which says so where breakage is not monitored.
    let or_zero = |breakage: Option<Length>| breakage.unwrap_or(Length::ZERO);
    Message::new(if tool.is_locked { "tools-row-locked" } else { "tools-row" })
        .text("tool", name)
        .number("length", tool.length)
        .number("radius", tool.radius)
        .number("delta-length", tool.delta_length)
        .number("delta-radius", tool.delta_radius)
        .number("length-breakage", or_zero(tool.length_breakage))
        .number("radius-breakage", or_zero(tool.radius_breakage))
}
