//! The outcome of a step of the machine.

use fitcheck_core::message::Say;
use fitcheck_core::probing::cycle::Stop;

/// The outcome of a step.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A block was run, or as many as requested.
    Went,
    /// The run waits; the next step goes on.
    Paused(Pause),
    /// The run is over.
    Ended,
}

/// Why the run waits.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "machine-pause")]
pub enum Pause {
    /// STOP or M0.
    Stop,
    /// M1.
    OptionalStop,
    /// The next block has a breakpoint.
    Breakpoint,
    /// Q309: something is out of tolerance.
    #[say(transparent)]
    Tolerance(Box<Stop>),
    /// Q281 = 2: the log is on the screen.
    Log,
}
