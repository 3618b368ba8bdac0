//! Gauges on serial and USB ports, at the edge: a port is opened, read on a thread and cut into lines.
//!
//! What a line means is in `exchange::gauge`. What is done with a value is in the session.
//!
//! | file | what |
//! |---|---|
//! | `settings` | how a port is set |
//! | `news` | what comes from a port, as plain values |
//! | `lines` | bytes to lines |
//! | `port` | the ports of this computer, and the thread that reads one; with the feature `ports` |

pub mod lines;
mod news;
#[cfg(feature = "ports")]
pub mod port;
mod settings;

pub use news::{News, Refusal, Trouble};
pub use settings::{DataBits, Parity, PortSettings, StopBits};
