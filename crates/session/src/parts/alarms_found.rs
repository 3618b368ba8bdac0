//! What was found of alarms of control charts.

use fitcheck_core::message::Message;
use fitcheck_exchange::journal::Alarm;

use super::alarm_search::NewestValue;
use crate::records::RecordRow;

/// What was found.
#[derive(Debug, Clone, Default)]
pub struct AlarmsFound {
    /// What fired, each at its value.
    pub fired: Vec<(NewestValue, Alarm)>,
    /// Features whose rules cannot be looked at, each with its newest value and the reason.
    pub unchecked: Vec<(NewestValue, Message)>,
    /// The alarms of the journal that nobody has answered, the oldest first.
    pub open: Vec<RecordRow>,
}
