//! Q330: what the result of a measuring cycle changes in the tool table.
//!
//! First breakage: a change above LBREAK or RBREAK locks the tool and corrects nothing. Then the correction, inside the
//! tolerance too. Sources, and what is ours: `docs/SOURCES.md`.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say, display, message};
use fitcheck_core::probing::cycle::{Corrected, Correction, Cycle, CycleResult, Meaning, Value};

use super::{DeltaColumn, LOCKED, Tool, ToolNumber, ToolTable};

/// The most tools that an error lists.
const MOST_LISTED: usize = 20;

/// A changed cell of the tool table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToolChange {
    pub tool: ToolNumber,
    /// Its name; empty if it has none.
    pub name: String,
    /// What the cycle found: how much the value of [`Self::column`], or the one of a broken tool, would change.
    pub correction: Correction,
    /// The cell's text before.
    pub from: String,
    /// Its text now.
    pub to: String,
    pub what: Changed,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Changed {
    /// DL or DR.
    Delta {
        column: DeltaColumn,
        /// The value before.
        from: Length,
        /// The value now.
        to: Length,
    },
    /// TL: the tool is locked, because it is broken.
    Locked(Breakage),
}

/// A tool whose value would change by more than its breakage tolerance: error 1065 of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Breakage {
    pub tool: ToolNumber,
    /// The value that would change.
    pub column: DeltaColumn,
    /// By how much.
    pub by: Length,
    /// The largest change, from LBREAK or RBREAK.
    pub most: Length,
    /// The tool that takes its place.
    pub replacement: Option<ToolNumber>,
}

/// What the monitoring of a tool gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Monitored {
    /// The changed cell; `None` where the deviation is 0.
    pub change: Option<ToolChange>,
    /// The name of Q330, and how many further tools have it: the first one of the table was taken.
    pub same_name: Option<(String, usize)>,
}

/// Why a tool cannot be monitored.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "tool", error)]
pub enum ToolFault {
    /// The table does not have the tool.
    Unknown {
        /// The number or name in Q330.
        tool: String,
        /// The tools that it has, the first ones of many.
        known: String,
    },
    /// The cycle found no deviation: it has no limits.
    NoDeviation {
        /// The number or name in Q330.
        tool: String,
        cycle: &'static str,
    },
    /// The new value is beyond its range.
    OutOfRange {
        tool: ToolNumber,
        column: &'static str,
        /// The value now.
        from: Length,
        /// The value that it would have.
        to: Length,
        /// The largest value, either way.
        most: Length,
    },
    #[say(transparent)]
    Broken(Breakage),
}

impl ToolChange {
    /// The name of the changed column.
    pub const fn column(&self) -> &'static str {
        match self.what {
            Changed::Delta { column, .. } => column.name(),
            Changed::Locked(_) => "TL",
        }
    }

    /// The name of the sentence: one of its own where a table in inches has rounded the value.
    fn corrected(&self, from: Length, to: Length) -> &'static str {
        let is_rounded = to.saturating_sub(from) != self.correction.by;
        if is_rounded { "tool-corrected-rounded" } else { "tool-corrected" }
    }

    /// Number and name, `3 (MILL_D10)`.
    fn label(&self) -> String {
        if self.name.is_empty() { self.tool.to_string() } else { format!("{} ({})", self.tool, self.name) }
    }
}

impl Say for ToolChange {
    fn message(&self) -> Message {
        match self.what {
            Changed::Delta { column, from, to } => Message::new(self.corrected(from, to))
                .text("tool", self.label())
                .text("column", column.name())
                .number("from", from)
                .number("to", to)
                .number("by", self.correction.by),
            Changed::Locked(_) => message!("tool-locked").text("tool", self.label()).text("to", &self.to),
        }
    }
}

impl Say for Breakage {
    fn message(&self) -> Message {
        let id = if self.replacement.is_some() { "tool-broken-replacement" } else { "tool-broken" };
        let message = Message::new(id)
            .with("tool", &self.tool)
            .text("column", self.column.name())
            .number("by", self.by)
            .text("limit", self.column.breakage())
            .number("most", self.most);
        self.replacement.iter().fold(message, |message, tool| message.with("replacement", tool))
    }
}

display!(ToolChange, Breakage);

impl ToolTable {
    /// Monitors the tool that a cycle names in Q330, and changes the table; `None` if it names none.
    ///
    /// # Errors
    /// [`ToolFault`]: an unknown tool, a result without a deviation, a value beyond ±999.9999 mm. The table is as it was
    /// then. A broken tool is no error here: the change says so.
    pub fn monitor(&mut self, cycle: &'static Cycle, result: &CycleResult) -> Result<Option<Monitored>, ToolFault> {
        let Some((row, named)) = self.monitored(cycle, result)? else { return Ok(None) };
        let correction =
            (cycle.corrects)(result).ok_or(ToolFault::NoDeviation { tool: named.tool, cycle: cycle.code })?;
        let change = match self.tools.get(row).cloned() {
            Some(tool) if correction.by != Length::ZERO => Some(self.correct(row, &tool, correction)?),
            _ => None,
        };
        Ok(Some(Monitored { change, same_name: named.same_name }))
    }

    /// The row of the tool in Q330.
    fn monitored(&self, cycle: &Cycle, result: &CycleResult) -> Result<Option<(usize, Named)>, ToolFault> {
        let (tool, row, more, is_name) = match cycle.value_of(&result.inputs, Meaning::Tool) {
            Some(Value::Number(number)) if 0.0 < *number => {
                let row = ToolNumber::of(*number).ok().and_then(|number| self.row_of(number));
                (number.to_string(), row, 0, false)
            }
            Some(Value::Text(name)) => {
                let rows = self.rows_named(name);
                (name.clone(), rows.first().copied(), rows.len().saturating_sub(1), true)
            }
            _ => return Ok(None),
        };
        let Some(row) = row else { return Err(ToolFault::Unknown { tool, known: self.known(is_name) }) };
        let same_name = (0 < more).then(|| (tool.clone(), more));
        Ok(Some((row, Named { tool, same_name })))
    }

    /// The numbers or names of the tools, the first ones of many.
    fn known(&self, is_name: bool) -> String {
        let text = |tool: &Tool| if is_name { tool.name.clone() } else { tool.number.to_string() };
        let mut known = self.tools.iter().map(text).filter(|text| !text.is_empty());
        let mut listed = known.by_ref().take(MOST_LISTED).collect::<Vec<_>>();
        if known.next().is_some() {
            listed.push("…".to_owned());
        }
        listed.join(", ")
    }

    /// Corrects a tool, or locks it where it is broken.
    fn correct(&mut self, row: usize, tool: &Tool, correction: Correction) -> Result<ToolChange, ToolFault> {
        let (column, from, breakage) = match correction.of {
            Corrected::Length => (DeltaColumn::Length, tool.delta_length, tool.length_breakage),
            Corrected::Radius => (DeltaColumn::Radius, tool.delta_radius, tool.radius_breakage),
        };
        let by = correction.by;
        let change = |from: String, to: String, what| ToolChange {
            tool: tool.number,
            name: tool.name.clone(),
            correction,
            from,
            to,
            what,
        };
        if let Some(most) = breakage.filter(|most| *most < by.abs()) {
            let before = self.columns.lock.map_or_else(String::new, |column| self.text(row, column).to_owned());
            self.lock(row);
            let broken = Breakage { tool: tool.number, column, by, most, replacement: tool.replacement };
            let now = if tool.is_locked { before.clone() } else { LOCKED.to_owned() };
            return Ok(change(before, now, Changed::Locked(broken)));
        }
        let number = match column {
            DeltaColumn::Length => self.columns.delta_length,
            DeltaColumn::Radius => self.columns.delta_radius,
        };
        let before = self.text(row, number).to_owned();
        let to = from.saturating_sub(by.negated());
        let beyond =
            || ToolFault::OutOfRange { tool: tool.number, column: column.name(), from, to, most: DeltaColumn::MOST };
        if DeltaColumn::MOST < to.abs() {
            return Err(beyond());
        }
        let to = self.set_delta(row, column, to).ok_or_else(beyond)?;
        let now = self.text(row, number).to_owned();
        Ok(change(before, now, Changed::Delta { column, from, to }))
    }
}

/// What Q330 says.
struct Named {
    tool: String,
    same_name: Option<(String, usize)>,
}
