//! The text fields of the cycles page.

use fitcheck_core::probing::cycle::Key;

/// A text field of the cycles page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CycleField {
    /// A parameter of the chosen cycle.
    Parameter(Key),
    /// What PREDEF stands for in a parameter of the chosen cycle.
    Global(Key),
    /// Where the ball stands before the cycle, by axis.
    Position(Axis),
}

/// An axis of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// All axes.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    pub const fn letter(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Y => "Y",
            Self::Z => "Z",
        }
    }
}
