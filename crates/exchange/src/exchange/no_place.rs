//! Why the place of a feature in a file is no position for a measuring cycle: a probe sent there would find no hole.

use fitcheck_core::message::Say;

/// Why.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange-no-place")]
pub enum NoPlace {
    /// It lies along another axis than Z.
    Axis {
        /// The axis as the file has it.
        axis: String,
    },
    /// The file does not say along which axis it lies.
    NoAxis,
    /// It is neither a circle nor a cylinder.
    Kind { kind: String },
    /// It is checked in a coordinate system of its own.
    System { system: String },
}
