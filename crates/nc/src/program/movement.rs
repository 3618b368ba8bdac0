//! A straight line: its axes, its feed and its M functions.

use super::operand::Operand;

/// A linear or rotary axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Axis {
    X,
    Y,
    Z,
    A,
    B,
    C,
    U,
    V,
    W,
}

/// A straight line.
#[derive(Debug, Clone, PartialEq)]
pub struct Movement {
    /// The axes that move.
    pub axes: Vec<AxisWord>,
    /// `R0`, `RL`, `RR`, as written.
    pub compensation: Option<String>,
    pub feed: Option<Feed>,
    /// M functions.
    pub machine: Vec<MachineFunction>,
}

/// `IX+2,5`
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisWord {
    pub axis: Axis,
    /// Whether an `I` precedes it: the value counts from where the axis is.
    pub is_incremental: bool,
    /// The destination.
    pub value: Operand,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// `FMAX`
    Rapid,
    /// `FAUTO`
    Auto,
    /// `F200`, `FQ1822`: mm per minute, or a tenth of an inch per minute.
    Value(Operand),
}

/// An M function: `M30`, `M140 MB MAX`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MachineFunction {
    pub number: u32,
    /// The text after it, as written.
    pub rest: String,
}
