//! An alarm of a control chart, and what somebody says of it: entries of their own kind. No verdict depends on either.

use fitcheck_core::message::{Message, Say, message};
use fitcheck_statistics::{Place, Rule};

use super::chain::Head;

/// A rule of a control chart fires at the newest value of a feature, or somebody answers that. The entry names part and feature.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Alarm {
    pub rule: Rule,
    /// On which figure of the chart.
    pub place: Place,
    /// The entry of the first value of the pattern.
    pub first: u64,
    /// The entry of the value at which the rule fired.
    pub last: u64,
    /// The serial number of the part of the first value; empty where nobody said.
    pub since: String,
    /// What somebody says of it; `None` in the entry of the alarm itself.
    pub answer: Option<AlarmAnswer>,
}

/// Why a rule fired, and what was done.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AlarmAnswer {
    /// The entry of the alarm.
    pub target: Head,
    /// Why it fired; never empty.
    pub cause: String,
    /// What was done about it; never empty.
    pub action: String,
}

impl Alarm {
    /// Whether another alarm is of the same pattern: the same rule, and one goes on where the other one was. A point beyond the limits is
    /// a pattern by itself.
    pub fn has_pattern_of(&self, other: &Self) -> bool {
        let is_same = (self.rule, self.place) == (other.rule, other.place);
        is_same && self.first <= other.last && other.first <= self.last
    }
}

/// The rule, and since which part it is so: `nine points on one side of the centre line, since part A-0091`.
impl Say for Alarm {
    fn message(&self) -> Message {
        let said = if self.since.is_empty() {
            message!("journal-alarm-since-entry").text("number", self.first)
        } else {
            message!("journal-alarm-since-part").text("serial", &self.since)
        };
        said.message("rule", self.place.said(self.rule))
    }
}
