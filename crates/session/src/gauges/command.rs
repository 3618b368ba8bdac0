//! What can be done with gauges.

use fitcheck_core::message::Message;
use fitcheck_exchange::exchange::gauge::LineUnit;
use fitcheck_gauges::{DataBits, Parity, StopBits};

/// What can be done with gauges; all but the list is about the one that is shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GaugeCommand {
    /// Adds one, and shows it.
    Add,
    Remove,
    /// Shows another one.
    Show(usize),
    /// Opens its port, or closes it.
    Connect(bool),
    /// Chooses one of the ports that were found.
    UsePort(String),
    UseBits(DataBits),
    UseParity(Parity),
    UseStop(StopBits),
    /// What its numbers without a unit are in.
    UseUnit(LineUnit),
    /// Learns the form of its lines from the newest one and what is typed for it.
    Teach,
    /// Reads the known forms again.
    Forget,
    /// Looks for the ports of this computer.
    FindPorts,
    /// They were found, or not.
    Ports(Result<Vec<String>, Message>),
}
