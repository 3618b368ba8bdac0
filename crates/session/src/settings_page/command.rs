//! What can be done on the settings page. What a setting changes is a command of whatever it belongs to.

use std::path::PathBuf;

use fitcheck_core::message::Message;
use fitcheck_exchange::report::image::Image;

use super::{Section, SettingsField};
use crate::gauges::GaugeCommand;

/// What can be done on the settings page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SettingsCommand {
    /// Replaces the text of a field.
    Type(SettingsField, String),
    /// Locks the operator's window with the PIN in its field.
    SetPin,
    /// A PIN was hashed, or not.
    PinHashed(Result<String, Message>),
    /// Locks the operator's window no more.
    RemovePin,
    /// Leaves the operator's window: at once, or after its PIN.
    LeaveOperator,
    /// Tries the PIN in its field.
    TryPin,
    /// A PIN was tried: whether it is the right one.
    PinTried(bool),
    /// Stays in the operator's window.
    Stay,
    /// Shows a section, and no longer what was looked for.
    Show(Section),
    /// The company's logo was read from this file, or not.
    LogoRead { path: PathBuf, result: Result<Image, Message> },
    /// Does something with the gauges.
    Gauge(GaugeCommand),
}
