//! Why there is no figure.

use fitcheck_core::message::{Say, printed};

/// Why there is no figure.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "statistics-reason", error)]
pub enum Reason {
    /// There is no value, or all are left out.
    Empty,
    /// A value is not a finite number; places count from 1.
    NotANumber {
        /// Its place in the series.
        place: usize,
    },
    /// Too few values, groups or points.
    TooFew {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// All values are equal: there is no spread.
    AllEqual,
    /// No subgroup has two values.
    NoSubgroups,
    /// A subgroup is too large for its range to say something.
    LargeSubgroup {
        /// How many values it has.
        found: usize,
        /// How many values it may have.
        most: usize,
    },
    /// Subgroups of several sizes where one size is needed.
    UnequalSubgroups {
        /// The size of the smallest.
        least: usize,
        /// The size of the largest.
        most: usize,
    },
    /// Values that do not say to which subgroup they belong.
    Ungrouped {
        /// How many there are.
        count: usize,
    },
    /// No limit is given.
    NoLimits,
    /// One limit is missing where both are needed.
    OneLimit,
    /// The lower limit is not below the upper one, or a limit is not a number.
    SwappedLimits,
    /// The law has positive values only.
    NotPositive,
    /// The law has no negative values.
    Negative,
    /// The law cannot be fitted to these values.
    NoFit,
    /// A cell of a gauge study has another number of readings than the others; numbers count from 1.
    UnevenCell {
        /// The number of the part.
        part: usize,
        /// The number of the operator.
        operator: usize,
        /// How many readings it has.
        found: usize,
        /// How many readings it needs.
        needed: usize,
    },
    /// The baseline of a chart is not within its stage.
    NoBaseline,
    /// A parameter beyond its range.
    Parameter {
        /// What was given.
        #[say(with = printed)]
        given: String,
        /// Its name.
        name: &'static str,
    },
}
