//! What a study says in sentences: is the gauge good enough, and for which tolerance? Lengths are in millimetres.

use fitcheck_core::message::{Say, printed};

/// Up to this share of the tolerance a gauge is good (AIAG MSA).
pub const GOOD_SHARE: f64 = 0.1;

/// Up to this share it is accepted where it must be (AIAG MSA).
pub const ACCEPTED_SHARE: f64 = 0.3;

/// A sentence about a study.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "statistics-gauge")]
pub enum Finding {
    /// Every value has an operator of its own.
    OperatorPerValue,
    /// More operators than parts.
    MoreOperators {
        /// The parts.
        parts: usize,
        /// The operators.
        operators: usize,
    },
    /// Operators differ more than parts do.
    OperatorsDifferMore,
    /// A nested study in which every operator read the same parts.
    SameParts,
    /// A study of one master with several parts.
    SeveralMasters {
        /// How many.
        parts: usize,
    },
    /// A type 1 study that is passed.
    MasterGood {
        /// What Cg and Cgk must reach.
        #[say(with = printed)]
        required: String,
    },
    /// One that is not.
    MasterBad {
        /// What Cg and Cgk must reach.
        #[say(with = printed)]
        required: String,
    },
    /// The smallest tolerance of a type 1 study.
    Smallest {
        /// The tolerance.
        #[say(with = printed)]
        mm: String,
        /// The upper end of its interval.
        #[say(with = printed)]
        most: String,
        /// The level in per cent.
        #[say(with = printed)]
        level: String,
    },
    /// A bias that is more than chance.
    Biased {
        /// The bias in micrometres, with its sign.
        #[say(with = printed)]
        um: String,
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// A bias that may be chance.
    NotBiased {
        /// The bias in micrometres, with its sign.
        #[say(with = printed)]
        um: String,
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// A gauge that takes little of the `tolerance`, or of the `variation` of all readings.
    Good {
        /// Of what.
        of: &'static str,
        /// Its share in per cent.
        #[say(with = printed)]
        percent: String,
    },
    /// One that takes more.
    Accepted {
        /// Of what.
        of: &'static str,
        /// Its share in per cent.
        #[say(with = printed)]
        percent: String,
    },
    /// One that takes too much.
    Bad {
        /// Of what.
        of: &'static str,
        /// Its share in per cent.
        #[say(with = printed)]
        percent: String,
    },
    /// The smallest tolerances for both shares.
    SmallestShares {
        /// That for 10 %.
        #[say(with = printed)]
        good: String,
        /// That for 30 %.
        #[say(with = printed)]
        accepted: String,
    },
    /// An interaction that is kept.
    InteractionKept {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// An interaction that is pooled with the repeatability.
    InteractionPooled {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// A component of variance that came out negative: `operator`, `interaction` or `part`.
    Negative {
        /// Which one.
        what: &'static str,
    },
    /// A bias that changes with the size.
    NotLinear {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// A bias that does not.
    Linear {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// A master that reads the same over time.
    Stable,
    /// A master at whose points rules fire or whose readings drift.
    NotStable,
}

impl Finding {
    /// Whether it says that the gauge is not good enough.
    pub const fn fails(&self) -> bool {
        matches!(self, Self::MasterBad { .. } | Self::Bad { .. } | Self::NotStable)
    }

    /// What the share of a gauge says, of the `tolerance` or of the `variation`, in per cent.
    pub fn of_share(of: &'static str, share: f64) -> Self {
        let percent = format!("{share:.1}");
        if share <= 100.0 * GOOD_SHARE {
            Self::Good { of, percent }
        } else if share <= 100.0 * ACCEPTED_SHARE {
            Self::Accepted { of, percent }
        } else {
            Self::Bad { of, percent }
        }
    }
}
