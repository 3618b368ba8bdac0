//! What is worth knowing about a run that went on.

use std::fmt;

use super::path::NcPath;
use crate::control::variables::Parameter;
use crate::message::{Message, Say};

/// Something worth knowing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Remark {
    /// A block that is not known was passed over.
    Skipped,
    /// M2 or M30 in a called program ended the whole run.
    EndedWithin {
        /// The M function.
        function: u32,
    },
    /// A value that was given before the run stands in place of the block's.
    GivenWins {
        /// The parameter.
        parameter: Parameter,
        /// Its value.
        value: String,
    },
    /// FN 16, FN 27 or a measuring log wrote no file: no folder was chosen.
    NotWritten {
        /// The file.
        path: NcPath,
    },
    /// A table that FN 27 has changed could not be written after the run had already failed, or a measuring log.
    NotSaved {
        /// The file.
        path: NcPath,
        /// Why.
        reason: String,
    },
    /// `M_APPEND_MAX`: the file has reached its size, nothing was added.
    Full {
        /// The file.
        path: NcPath,
        /// Its size, kilobytes.
        kilobytes: u32,
    },
    /// FN 27 has changed a table, and the file was written.
    TableWritten {
        /// The file.
        path: NcPath,
    },
    /// The run is over and recorded contacts are left: perhaps they belong to other features than those they were given to.
    ContactsLeft {
        /// How many there were.
        count: usize,
        /// How many the cycles took.
        used: usize,
    },
    /// The tool is not in the touch-probe table, the first probe was used.
    OtherProbe {
        /// The tool.
        tool: String,
        /// The probe.
        probe: u32,
    },
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Skipped => f.write_str("the block is not known here and was passed over"),
            Self::EndedWithin { function } => {
                write!(f, "M{function} in a called program ended the run: a control does not allow it there")
            }
            Self::GivenWins { parameter, value } => {
                write!(f, "{parameter} = {value} was given before the run and stands in place of this block's value")
            }
            Self::NotWritten { path } => write!(f, "{path} was not written: no folder was chosen for outputs"),
            Self::NotSaved { path, reason } => write!(f, "{path} was not written: {reason}"),
            Self::Full { path, kilobytes } => {
                write!(f, "{path} has reached its {kilobytes} kilobytes, nothing was added")
            }
            Self::TableWritten { path } => write!(f, "{path} was written"),
            Self::ContactsLeft { count, used } => write!(f, "the cycles took {used} of {count} recorded contacts"),
            Self::OtherProbe { tool, probe } => {
                write!(f, "tool {tool} is not in the touch-probe table: probe {probe} was used")
            }
        }
    }
}

impl Say for Remark {
    fn message(&self) -> Message {
        match self {
            Self::Skipped => Message::new("machine-remark-skipped"),
            Self::EndedWithin { function } => Message::new("machine-remark-ended-within").text("function", function),
            Self::GivenWins { parameter, value } => {
                Message::new("machine-remark-given-wins").text("parameter", parameter).text("value", value)
            }
            Self::NotWritten { path } => Message::new("machine-remark-not-written").text("path", path),
            Self::NotSaved { path, reason } => {
                Message::new("machine-remark-not-saved").text("path", path).text("reason", reason)
            }
            Self::Full { path, kilobytes } => {
                Message::new("machine-remark-full").text("path", path).text("kilobytes", kilobytes)
            }
            Self::TableWritten { path } => Message::new("machine-remark-table-written").text("path", path),
            Self::ContactsLeft { count, used } => {
                Message::new("machine-remark-contacts-left").text("count", count).text("used", used)
            }
            Self::OtherProbe { tool, probe } => {
                Message::new("machine-remark-other-probe").text("tool", tool).text("probe", probe)
            }
        }
    }
}
