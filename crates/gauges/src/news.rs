//! What comes from a port.

use fitcheck_core::message::Say;

/// What comes from a port.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum News {
    /// It is open for the first time.
    Opened,
    /// A line without its end.
    Line(String),
    /// Something that is no line. The same is told once until a line comes.
    Refused(Refusal),
    /// It cannot be opened, or is gone; it is tried again until it is there.
    Lost(Trouble),
    /// It is there again.
    Back,
}

/// Why something is no line.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "gauges-line", error)]
pub enum Refusal {
    TooLong {
        most: usize,
    },
    /// It has bytes that are no text.
    NotText {
        given: String,
    },
    /// Nothing more came, and no end of the line.
    Half {
        given: String,
    },
    /// The port was opened while it came, so its beginning may be missing.
    Joined {
        given: String,
    },
}

/// Why a port is not open.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "gauges-port", error)]
pub enum Trouble {
    /// There is none of this name.
    Missing {
        port: String,
    },
    /// It is not allowed to this user.
    NotAllowed {
        port: String,
    },
    /// Another program has it.
    Busy {
        port: String,
    },
    /// It was open, and is gone.
    Unplugged {
        port: String,
    },
    /// This build opens no ports.
    NotBuilt,
    Other {
        port: String,
        reason: String,
    },
}
