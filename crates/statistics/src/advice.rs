//! What a person does with the figures, in sentences. Lengths are in millimetres, and are said in micrometres.

use fitcheck_core::message::{Say, printed};

use crate::anova::Groups;
use crate::gauge::Finding;
use crate::moments::Estimate;
use crate::trend::{Offset, Trend};

/// From so many values on an interval is narrow enough to plan with (Montgomery; AIAG SPC).
pub const ENOUGH_VALUES: usize = 25;

/// From so many points on control limits are (Montgomery: 20 to 25 subgroups).
pub const ENOUGH_POINTS: usize = 20;

/// A sentence about a series.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "statistics-advice")]
pub enum Advice {
    /// Few values.
    FewValues {
        /// How many.
        count: usize,
        /// How many are enough.
        enough: usize,
    },
    /// Control limits of few points.
    FewPoints {
        /// How many.
        count: usize,
        /// How many are enough.
        enough: usize,
    },
    /// Rules fire.
    Unstable {
        /// At how many points.
        count: usize,
    },
    /// The values are hardly those of the law.
    NotOfLaw {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// A size that may as well be in the middle.
    Centred {
        /// What is off: `mean`, or the end of the `line` of a trend.
        what: &'static str,
        /// How far it is off.
        #[say(with = printed)]
        um: String,
        /// Of how many values.
        count: usize,
    },
    /// A size that is off by less than a step of the correction.
    Near {
        /// What is off: `mean`, or the end of the `line` of a trend.
        what: &'static str,
        /// How far it is off.
        #[say(with = printed)]
        um: String,
        /// Of how many values.
        count: usize,
    },
    /// A correction.
    Correct {
        /// By how much sizes must change, with its sign.
        #[say(with = printed)]
        correction: String,
        /// What is off: `mean`, or the end of the `line` of a trend.
        what: &'static str,
        /// How far it is off.
        #[say(with = printed)]
        um: String,
        /// Of how many values.
        count: usize,
    },
    /// No trend.
    NoTrend,
    /// A trend that goes to no limit.
    Trend {
        /// The change from part to part, with its sign.
        #[say(with = printed)]
        um: String,
    },
    /// A trend that has come to a limit.
    TrendAtLimit {
        /// The change from part to part, with its sign.
        #[say(with = printed)]
        um: String,
    },
    /// A trend to a limit.
    TrendTo {
        /// The change from part to part, with its sign.
        #[say(with = printed)]
        um: String,
        /// The parts that are left.
        #[say(with = printed)]
        parts: String,
        /// The least of its interval.
        #[say(with = printed)]
        least: String,
        /// The most of its interval.
        #[say(with = printed)]
        most: String,
        /// The level of the interval in per cent.
        #[say(with = printed)]
        level: String,
    },
    /// An average that is beyond its limits.
    AverageOut {
        /// The first such point.
        at: usize,
    },
    /// A sum that is beyond the decision interval.
    SumOut {
        /// The first such point.
        at: usize,
        /// The point at which the shift began.
        since: usize,
    },
    /// What a study of a gauge says.
    #[say(transparent)]
    Gauge(Finding),
    /// Groups that do not differ.
    GroupsAlike {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
    /// Groups that differ.
    GroupsDiffer {
        /// The probability.
        #[say(with = printed)]
        p: String,
    },
}

impl Advice {
    /// What an offset says.
    pub fn of_offset(offset: &Offset) -> Self {
        let what = if offset.is_of_trend { "line" } else { "mean" };
        let (um, count) = (um(offset.distance.value), offset.count);
        let Estimate { lower, upper, .. } = offset.distance;
        match offset.correction {
            Some(correction) => Self::Correct { correction: signed_um(correction, 0), what, um, count },
            None if lower <= 0.0 && 0.0 <= upper => Self::Centred { what, um, count },
            None => Self::Near { what, um, count },
        }
    }

    /// What a trend says whose interval has this level, such as 0.95.
    pub fn of_trend(trend: &Trend, level: f64) -> Self {
        let um = signed_um(trend.slope.value, 3);
        match trend.reach {
            _ if !trend.is_real() => Self::NoTrend,
            None => Self::Trend { um },
            Some(reach) if reach.parts.value < 1.0 => Self::TrendAtLimit { um },
            Some(reach) => {
                let whole = |parts: f64| format!("{:.0}", parts.floor());
                let Estimate { value, lower, upper } = reach.parts;
                Self::TrendTo {
                    um,
                    parts: whole(value),
                    least: whole(lower),
                    most: whole(upper),
                    level: whole(100.0 * level),
                }
            }
        }
    }

    /// What a comparison of groups says at a level such as 0.95.
    pub fn of_groups(groups: &Groups, level: f64) -> Self {
        let p = probability(groups.ratio.p);
        if groups.ratio.p < 1.0 - level { Self::GroupsDiffer { p } } else { Self::GroupsAlike { p } }
    }
}

/// A probability to four decimals.
pub fn probability(p: f64) -> String {
    format!("{p:.4}")
}

/// Millimetres as micrometres with a tenth, without their sign.
fn um(mm: f64) -> String {
    format!("{:.1}", (mm * 1_000.0).abs())
}

/// Millimetres as micrometres with so many decimals and their sign.
fn signed_um(mm: f64, decimals: usize) -> String {
    format!("{:+.decimals$}", mm * 1_000.0)
}
