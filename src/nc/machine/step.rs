//! What a step of the machine comes to.

use crate::message::{Message, Say};
use crate::probing::cycle::Stop;

/// What a step came to.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A block was run, or as many as were asked for.
    Went,
    /// The run waits; the next step goes on.
    Paused(Pause),
    /// The run is over.
    Ended,
}

/// Why the run waits.
#[derive(Debug, Clone, PartialEq)]
pub enum Pause {
    /// STOP or M0.
    Stop,
    /// M1.
    OptionalStop,
    /// The next block has a breakpoint.
    Breakpoint,
    /// Q309: something is out of tolerance.
    Tolerance(Box<Stop>),
    /// Q281 = 2: the log is on the screen.
    Log,
}

impl std::fmt::Display for Pause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Stop => f.write_str("the program has stopped: STOP or M0"),
            Self::OptionalStop => f.write_str("the program has stopped: M1"),
            Self::Breakpoint => f.write_str("the next block has a breakpoint"),
            Self::Tolerance(stop) => stop.fmt(f),
            Self::Log => f.write_str("the measuring log is on the screen (Q281 = 2)"),
        }
    }
}

impl Say for Pause {
    fn message(&self) -> Message {
        match self {
            Self::Stop => Message::new("machine-pause-stop"),
            Self::OptionalStop => Message::new("machine-pause-optional"),
            Self::Breakpoint => Message::new("machine-pause-breakpoint"),
            Self::Tolerance(stop) => stop.message(),
            Self::Log => Message::new("machine-pause-log"),
        }
    }
}
