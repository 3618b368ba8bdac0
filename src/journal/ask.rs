//! Questions to a journal: one language for window and command line.

use crate::verdict::Status;

/// Which checks are asked for. What is not given asks for nothing: an empty question finds every check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Question {
    /// The part, whole.
    pub part: Option<String>,
    /// The serial number, or with `*` at its end its beginning.
    pub serial: Option<String>,
    /// The feature, whole.
    pub feature: Option<String>,
    /// The callout, whole, such as `25 H7`.
    pub callout: Option<String>,
    /// The tolerance class, such as `H7`.
    pub class: Option<String>,
    /// Any of these verdicts; empty for every one.
    pub verdicts: Vec<Status>,
    /// Who measured, whole.
    pub who: Option<String>,
    /// The station, whole.
    pub station: Option<String>,
    /// From this instant on: milliseconds since 1970 in UTC.
    pub from_ms: Option<i64>,
    /// Before this instant.
    pub before_ms: Option<i64>,
    /// Simulated checks alone, or measured checks alone; `None` for both.
    pub simulated: Option<bool>,
    /// Only checks that stand: none that another one corrects or that was taken back.
    pub standing: bool,
    /// Words that the part, serial number, feature, name or remark has, or begins a word with: all of them.
    pub words: Vec<String>,
}
