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

fitcheck_core::named! {
    /// An axis of the machine.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Axis {
        /// All axes.
        ALL;
        fn letter;
        /// The first.
        X = "X",
        /// The second.
        Y = "Y",
        /// The third.
        Z = "Z",
    }
}
