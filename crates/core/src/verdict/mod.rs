//! Good, rework, scrap or re-measure, and how much to remove.
//!
//! The comparisons are only `<` and `<=`, in whole nanometres; limits belong to the zone. The centre's position is a
//! separate cause. Formatting is elsewhere.
//!
//! | file | what |
//! |---|---|
//! | here | the status, a diameter's and a centre's verdict, doubts about the measured value |
//! | `rules` | decision rules: which values are accepted when the measurement is uncertain |
//! | `fit` | two measured parts of a fit, or one of them |

pub mod fit;
pub mod rules;

pub use rules::Rule;

use crate::length::Length;
use crate::message::{Arg, Message, Say, message, printed};
use crate::tolerance::{Bounds, Feature, Limits};

crate::named! {
    /// What to do with the part; `Display` is the English word.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize, Say)]
    #[say(prefix = "status")]
    pub enum Status {
        /// Every status, best first.
        ALL;
        /// The word as questions have it: in small letters and without blanks.
        fn key;
        /// Inside the limits or on one of them.
        #[serde(rename = "GOOD")]
        Good = "good",
        /// Outside, but material can still be taken off.
        #[serde(rename = "REWORK")]
        Rework = "rework",
        /// Nothing is decided: the value lies within a guard band of the rule.
        #[serde(rename = "RE-MEASURE")]
        ReMeasure = "re-measure",
        /// Outside, and nobody has said hole or shaft: whether material can still be taken off is open.
        #[serde(rename = "OUT OF LIMITS")]
        OutOfLimits = "out-of-limits",
        /// Outside, and material cannot be put back.
        #[serde(rename = "SCRAP")]
        Scrap = "scrap",
    }
}

impl Status {
    /// Its place in [`Status::ALL`].
    #[inline]
    pub const fn at(self) -> usize {
        match self {
            Self::Good => 0,
            Self::Rework => 1,
            Self::ReMeasure => 2,
            Self::OutOfLimits => 3,
            Self::Scrap => 4,
        }
    }

    /// Whether most sets of values have none: one between guard bands, or one that is neither hole nor shaft.
    pub const fn is_rare(self) -> bool {
        matches!(self, Self::ReMeasure | Self::OutOfLimits)
    }

    /// The word for machines, the same in every language.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Good => "GOOD",
            Self::Rework => "REWORK",
            Self::ReMeasure => "RE-MEASURE",
            Self::OutOfLimits => "OUT OF LIMITS",
            Self::Scrap => "SCRAP",
        }
    }
}

/// How much material to remove, as a diameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Removal {
    /// To the nearest limit of size: the least that makes the part good.
    pub to_limit: Length,
    /// To the middle of the zone, where a tool is aimed. A half nanometre is rounded to the larger size.
    pub to_middle: Length,
}

/// What the size alone says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SizeVerdict {
    /// Good, rework or scrap; out of limits where nobody has said hole or shaft.
    pub status: Status,
    /// Measured minus nominal size.
    pub deviation: Length,
    /// Measured minus minimum: negative when too small.
    pub above_minimum: Length,
    /// Maximum minus measured: negative when too large.
    pub below_maximum: Length,
    /// For rework, how much to remove.
    pub removal: Option<Removal>,
}

/// One axis of the centre: its deviation from the nominal position and what is permitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AxisPosition {
    /// Measured minus nominal coordinate.
    pub deviation: Length,
    /// Permitted either way (Q279 or Q280); `None` where the axis is not monitored (0 on the control).
    pub tolerance: Option<Length>,
}

impl AxisPosition {
    /// Whether the axis is monitored and out.
    pub fn is_out(&self) -> bool {
        self.tolerance.is_some_and(|tolerance| tolerance < self.deviation.abs())
    }
}

/// The centre's position: never merged with the diameter's result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PositionVerdict {
    /// Reference axis, minor axis.
    pub axes: [AxisPosition; 2],
}

impl PositionVerdict {
    /// Whether any axis is monitored.
    pub fn is_monitored(&self) -> bool {
        self.axes.iter().any(|axis| axis.tolerance.is_some())
    }

    /// Whether a monitored axis is out.
    pub fn is_out(&self) -> bool {
        self.axes.iter().any(AxisPosition::is_out)
    }
}

/// The whole answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Verdict {
    /// What the diameter says.
    pub size: SizeVerdict,
    /// What the centre says, where it was measured.
    pub position: Option<PositionVerdict>,
    /// The rule that was used.
    pub rule: Rule,
    /// Why nothing is decided although the rule would decide; then the size is to be measured again.
    pub undecided: Option<Undecided>,
}

/// Why a measured value decides nothing, whatever the zones of the rule say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "undecided")]
pub enum Undecided {
    /// The uncertainty was given, and the contacts make the diameter much less sure than contacts evenly round the full circle.
    Contacts {
        /// How many contacts there are.
        contacts: usize,
        /// How many times less sure, in thousandths.
        #[say(with = thousandths)]
        times: u32,
    },
}

impl Undecided {
    /// How many times less sure a diameter may be than by contacts evenly round the full circle, in thousandths: a given uncertainty
    /// counts up to and including this.
    pub const MOST_TIMES: u32 = 3_000;
}

impl Verdict {
    /// The status of the part: the diameter's, but scrap when the centre is out of position, because a shifted
    /// feature cannot be machined back and a control sets exactly one marker (Q180, Q181 or Q182).
    pub fn status(&self) -> Status {
        if self.position.is_some_and(|position| position.is_out()) { Status::Scrap } else { self.size.status }
    }
}

impl Verdict {
    /// Whether the part is good although its size lies beyond a limit: the rule accepts what is not proven to be out (ISO 14253-1 where the
    /// customer has to prove, relaxed acceptance of ASME B89.7.3.1).
    pub fn is_beyond_limits(&self) -> bool {
        let is_out = self.size.above_minimum < Length::ZERO || self.size.below_maximum < Length::ZERO;
        is_out && self.status() == Status::Good
    }

    /// Whether somebody has to look at the part: it is not good, or its size lies beyond a limit and the rule accepts that.
    pub fn asks_for_a_look(&self) -> bool {
        self.status() != Status::Good || self.is_beyond_limits()
    }
}

/// The word for people: that of the status, but another one where the size lies beyond a limit and the rule accepts it.
impl Say for Verdict {
    fn message(&self) -> Message {
        if self.is_beyond_limits() { message!("status-accepted") } else { self.status().message() }
    }
}

impl Verdict {
    /// The same with a measured value that decides nothing: nothing is removed by it either.
    #[must_use]
    pub const fn left_undecided(mut self, why: Undecided) -> Self {
        self.size.status = Status::ReMeasure;
        self.size.removal = None;
        self.undecided = Some(why);
        self
    }
}

/// A number of thousandths as a decimal.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as `say(with)` calls it")]
fn thousandths(number: &u32) -> Arg {
    printed(&rules::thousandths(*number))
}

/// Good on or between the limits; a hole too small or a shaft too large is rework, the other side scrap. What is neither hole nor shaft is
/// out of limits on either side.
#[inline]
pub fn classify(feature: Option<Feature>, minimum: Length, maximum: Length, measured: Length) -> Status {
    let too_small = measured < minimum;
    let too_large = maximum < measured;
    match (feature, too_small, too_large) {
        (_, false, false) => Status::Good,
        (Some(Feature::Hole), true, _) | (Some(Feature::Shaft), _, true) => Status::Rework,
        (Some(Feature::Hole), _, true) | (Some(Feature::Shaft), true, _) => Status::Scrap,
        (None, ..) => Status::OutOfLimits,
    }
}

/// Judges a diameter: a hole too small or a shaft too large can be reworked, the other side is scrap.
///
/// ```
/// use fitcheck_core::tolerance::Sources;
/// use fitcheck_core::verdict::{Status, judge_size};
///
/// let limits = Sources::default().limits(&"25 H7".parse()?, None)?;
/// let verdict = judge_size(&limits, "24.998".parse()?);
/// assert_eq!(verdict.status, Status::Rework);
/// assert_eq!(verdict.removal.map(|removal| removal.to_limit.to_string()), Some("0.002".to_owned()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn judge_size(limits: &Limits, measured: Length) -> SizeVerdict {
    judge_bounds(&limits.bounds(), measured)
}

/// Judges a diameter as [`judge_size`] does, without where the limits come from.
#[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
#[inline(always)]
pub fn judge_bounds(bounds: &Bounds, measured: Length) -> SizeVerdict {
    verdict_of(bounds, measured, classify(bounds.feature, bounds.minimum(), bounds.maximum(), measured))
}

/// All about a diameter of which [`classify`] has told the status.
#[expect(clippy::inline_always, reason = "as above")]
#[inline(always)]
pub fn verdict_of(bounds: &Bounds, measured: Length, status: Status) -> SizeVerdict {
    let above_minimum = measured.saturating_sub(bounds.minimum());
    let below_maximum = bounds.maximum().saturating_sub(measured);
    let removal = match bounds.feature {
        Some(Feature::Hole) if status == Status::Rework => {
            Some(Removal { to_limit: above_minimum.negated(), to_middle: bounds.middle().saturating_sub(measured) })
        }
        Some(Feature::Shaft) if status == Status::Rework => {
            Some(Removal { to_limit: below_maximum.negated(), to_middle: measured.saturating_sub(bounds.middle()) })
        }
        _ => None,
    };
    let deviation = measured.saturating_sub(bounds.nominal);
    SizeVerdict { status, deviation, above_minimum, below_maximum, removal }
}

/// Judges a diameter and, where there is one, a centre by the control's default rule.
pub fn judge(limits: &Limits, measured: Length, position: Option<PositionVerdict>) -> Verdict {
    judge_by(Rule::SIMPLE, limits, measured, position)
}

/// Judges a diameter and, where there is one, a centre by a rule. The rule is about the diameter; the centre has its own
/// tolerance.
pub fn judge_by(rule: Rule, limits: &Limits, measured: Length, position: Option<PositionVerdict>) -> Verdict {
    let bounds = limits.bounds();
    let zones = rule.zones(&bounds);
    let mut size = verdict_of(&bounds, measured, zones.status(bounds.feature, measured));
    // What is removed must bring the size to where the rule accepts it, and never less far than the limit.
    if let (Some(removal), Some([least, most])) = (&mut size.removal, zones.accepted) {
        removal.to_limit = match bounds.feature {
            Some(Feature::Hole) => least.max(bounds.minimum()).saturating_sub(measured),
            Some(Feature::Shaft) => measured.saturating_sub(most.min(bounds.maximum())),
            None => removal.to_limit,
        };
    }
    Verdict { size, position, rule, undecided: None }
}

/// What may be wrong with a measured value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "doubt")]
pub enum Doubt {
    /// 25.4 times the nominal size: an inch part read in millimetres, converted once too often.
    TimesInch {
        /// The size that it may have been, where 25.4 divides it into whole nanometres.
        #[say(skip)]
        meant: Option<Length>,
    },
    /// The nominal size over 25.4: inches.
    Inches {
        /// The size in millimetres.
        #[say(skip)]
        meant: Option<Length>,
    },
    /// Twice the nominal size.
    Double {
        /// Half of the value.
        #[say(skip)]
        meant: Option<Length>,
    },
    /// Half the nominal size: a radius.
    Half {
        /// Twice the value.
        #[say(skip)]
        meant: Option<Length>,
    },
    /// A power of ten times the nominal size, or a part of it: 250.12 or 2.5012 for 25.012.
    DecimalSign {
        /// The value with its decimal sign elsewhere.
        meant: Length,
    },
    /// So far beyond a limit that it may be another part: by more than ten times the tolerance and 2 % of the nominal
    /// size.
    Far {
        /// How far beyond the nearest limit.
        distance: Length,
    },
    /// Outside what its plan says that a value can be.
    Implausible {
        /// The smallest value that can be.
        lower: Length,
        /// The largest one.
        upper: Length,
        /// What the value may have been, where that can be.
        #[say(skip)]
        meant: Option<Length>,
    },
}

impl Doubt {
    /// What the value may have been, where that is one whole number of nanometres.
    pub const fn meant(self) -> Option<Length> {
        match self {
            Self::TimesInch { meant }
            | Self::Inches { meant }
            | Self::Double { meant }
            | Self::Half { meant }
            | Self::Implausible { meant, .. } => meant,
            Self::DecimalSign { meant } => Some(meant),
            Self::Far { .. } => None,
        }
    }
}

/// A length times a fraction, where that is a whole number of nanometres.
fn scaled(length: Length, factor: i128, divisor: i128) -> Option<Length> {
    let scaled = i128::from(length.nanometres()) * factor;
    let nm = (scaled % divisor == 0).then(|| i64::try_from(scaled / divisor).ok())??;
    Length::from_nanometres(nm).ok()
}

/// Whether a measured value looks like another quantity or another part: within 1 % of 25.4 times, 1/25.4, twice or half
/// the nominal size, or of it with the decimal sign elsewhere; or else far outside the limits.
///
/// The 1 %, and the ten tolerances and 2 % of [`Doubt::Far`], are our choice, far from every honest measured value. Zones of
/// coarse grades are wider than 1 % on small sizes; a doubt only warns and never changes the verdict.
pub fn doubt(limits: &Limits, measured: Length) -> Option<Doubt> {
    doubt_of(&limits.bounds(), measured)
}

/// Looks as [`doubt`] does, without where the limits come from.
#[inline]
pub fn doubt_of(bounds: &Bounds, measured: Length) -> Option<Doubt> {
    let nominal = bounds.nominal.nanometres();
    let value = measured.nanometres();
    // The nearest other quantity is 98 % away. Lengths are at most 1e15 nm, so nothing here reaches 1e18.
    let is_near = (value - nominal).abs() * 64 < nominal;
    let is_good = classify(bounds.feature, bounds.minimum(), bounds.maximum(), measured) == Status::Good;
    // A length between two limits alone, as of a chamfer, has the lower one for its nominal size, and a coordinate may be anything.
    let has_no_nominal = bounds.feature.is_none() && bounds.nominal == bounds.minimum();
    let is_plain = nominal <= 0 || is_good && has_no_nominal;
    if !is_near
        && !is_plain
        && let Some(doubt) = other_quantity(bounds.nominal, measured)
    {
        return Some(doubt);
    }
    if is_good {
        return None;
    }
    // Beyond the nearest limit.
    let below = bounds.minimum().saturating_sub(measured);
    let above = measured.saturating_sub(bounds.maximum());
    let distance = below.max(above);
    let width = bounds.maximum().saturating_sub(bounds.minimum());
    let is_far = width.nanometres() * 10 < distance.nanometres() && nominal.abs() < distance.nanometres() * 50;
    is_far.then_some(Doubt::Far { distance })
}

/// Whether a value is 25.4 times, 1/25.4, twice or half the nominal size, or a power of ten of it.
fn other_quantity(nominal: Length, measured: Length) -> Option<Doubt> {
    let nominal = i128::from(nominal.nanometres());
    let value = i128::from(measured.nanometres());
    // value * divisor within 1 % of nominal * factor
    let near = |factor: i128, divisor: i128| {
        let is = value * divisor;
        let should = nominal * factor;
        (is - should).abs() * 100 <= should.abs() && should != 0
    };
    let meant = |factor, divisor| scaled(measured, factor, divisor);
    if near(254, 10) {
        return Some(Doubt::TimesInch { meant: meant(10, 254) });
    } else if near(10, 254) {
        return Some(Doubt::Inches { meant: meant(254, 10) });
    } else if near(2, 1) {
        return Some(Doubt::Double { meant: meant(1, 2) });
    } else if near(1, 2) {
        return Some(Doubt::Half { meant: meant(2, 1) });
    }
    (1..=6).find_map(|power| {
        let ten = 10_i128.pow(power);
        let moved = if near(ten, 1) {
            meant(1, ten)
        } else if near(1, ten) {
            meant(ten, 1)
        } else {
            None
        };
        moved.map(|meant| Doubt::DecimalSign { meant })
    })
}
