//! The limit band's geometry: zone, rework side, scrap side, guard bands and the measured value on one axis of deviations.
//!
//! Plain values in micrometres from the nominal size, for drawing only: nothing is judged by them. The report's
//! picture and the window's plot are both drawn from a [`Band`], so they show the same.

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{Feature, Limits};
use fitcheck_core::verdict::Rule;
use fitcheck_statistics::round::round_down;

/// What a part is on one side of the zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Material can still be taken off.
    Rework,
    /// Material cannot be put back.
    Scrap,
    /// Nobody has said hole or shaft, so whether material can be taken off is open.
    Out,
}

/// Where the measured value is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Marker {
    /// On the axis, at this deviation in micrometres.
    InSight(f64),
    /// Smaller than the axis shows: an arrow at the left edge, with the deviation in micrometres.
    BeyondLeft(f64),
    /// Larger than the axis shows: an arrow at the right edge, with the deviation in micrometres.
    BeyondRight(f64),
}

/// What happens to a value between a limit and where the rule decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guarded {
    /// It is neither accepted nor rejected: re-measure.
    Undecided,
    /// It is accepted although it lies beyond the limit.
    AcceptedBeyond,
}

/// A guard band as far as the axis shows it, in micrometres from the nominal size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GuardBand {
    /// Its left end.
    pub from_um: f64,
    /// Its right end, always right of the left one.
    pub to_um: f64,
    /// What happens to a value in it.
    pub guarded: Guarded,
}

/// What a decision rule makes of the axis, in micrometres from the nominal size; the ends may lie beyond the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Guard {
    /// The smallest and the largest accepted deviation; `None` where no value is accepted.
    pub accepted: Option<[f64; 2]>,
    /// Smaller than the first or larger than the second is rejected; `None` where no value is.
    pub rejected: Option<[f64; 2]>,
    /// The guard bands from left to right, cut at the ends of the axis.
    pub bands: Vec<GuardBand>,
}

/// The band's values, all in micrometres from the nominal size.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Left end of the axis.
    pub axis_min_um: f64,
    /// Right end of the axis, always right of the left one.
    pub axis_max_um: f64,
    /// Lower limit deviation, always inside the axis.
    pub lower_um: f64,
    /// Upper limit deviation, always inside the axis; equal to the lower one for a zone of no width.
    pub upper_um: f64,
    /// What is to the left of the zone: rework for a hole, scrap for a shaft.
    pub left: Side,
    /// What is to the right of the zone: scrap for a hole, rework for a shaft.
    pub right: Side,
    /// The measured value, where there is one.
    pub marker: Option<Marker>,
    /// Round deviations along the axis, ascending; zero is among them where the axis shows it.
    pub ticks: Vec<f64>,
    /// The guard bands of the rule; `None` where the limits themselves decide.
    pub guard: Option<Guard>,
}

/// The least margin on either side of the zone, in zone widths: room for the side's name.
const MARGIN: f64 = 0.5;
/// How far outside the zone, in zone widths, the axis still stretches to the measured value, the nominal size and the ends of
/// guard bands.
/// Farther out, the zone would become a line.
const REACH: f64 = 1.0;
/// The gap between a value that the axis stretches to and the axis's end, in zone widths.
const AIR: f64 = 0.15;
/// The width in micrometres used for a zone that has none.
const WIDTH_OF_NONE: f64 = 10.0;
/// The fewest steps between ticks; there are at most two to three times as many.
const STEPS: f64 = 4.0;

impl Band {
    /// The band of the given limits, with the measured value if there is one.
    ///
    /// The axis shows the whole zone with half its width on either side. It stretches to the measured value and to
    /// the nominal size where they are less than a zone width away; a value farther out becomes an arrow.
    ///
    /// ```
    /// use fitcheck_exchange::report::band::{Band, Marker, Side};
    /// use fitcheck_core::tolerance::{Deviations, Feature, Limits, Source};
    ///
    /// let deviations = Deviations::new("0.021".parse()?, "0".parse()?)?;
    /// let limits = Limits::new(Feature::Hole, "25".parse()?, deviations, Source::File("x".into())).unwrap();
    /// let band = Band::new(&limits, Some("25.012".parse()?));
    /// assert_eq!((band.lower_um, band.upper_um), (0.0, 21.0));
    /// assert_eq!((band.axis_min_um, band.axis_max_um), (-10.5, 31.5));
    /// assert_eq!((band.left, band.right), (Side::Rework, Side::Scrap));
    /// assert_eq!(band.marker, Some(Marker::InSight(12.0)));
    /// assert_eq!(band.ticks, [-10.0, 0.0, 10.0, 20.0, 30.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(limits: &Limits, measured: Option<Length>) -> Self {
        Self::by(&Rule::SIMPLE, limits, measured)
    }

    /// The same with the guard bands of a rule. The axis stretches to their ends as it does to the nominal size; what does not
    /// fit is cut at the axis's end.
    ///
    /// ```
    /// use fitcheck_exchange::report::band::{Band, GuardBand, Guarded};
    /// use fitcheck_core::tolerance::Sources;
    /// use fitcheck_core::verdict::Rule;
    /// use fitcheck_core::verdict::rules::{RuleInputs, RuleName};
    ///
    /// let limits = Sources::default().limits(&"25 H7".parse()?, None)?;
    /// let rule = Rule::new(RuleName::Fixed, RuleInputs { width: Some("0.002".parse()?), ..RuleInputs::default() })?;
    /// let guard = Band::by(&rule, &limits, None).guard.unwrap();
    /// assert_eq!((guard.accepted, guard.rejected), (Some([2.0, 19.0]), Some([-2.0, 23.0])));
    /// let undecided = |from_um, to_um| GuardBand { from_um, to_um, guarded: Guarded::Undecided };
    /// assert_eq!(guard.bands, [undecided(-2.0, 2.0), undecided(19.0, 23.0)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn by(rule: &Rule, limits: &Limits, measured: Option<Length>) -> Self {
        let guard = Ends::of(rule, limits);
        let lower_um = limits.deviations.lower().to_um_f64();
        let upper_um = limits.deviations.upper().to_um_f64();
        let width = if lower_um < upper_um { upper_um - lower_um } else { WIDTH_OF_NONE };
        let mut axis_min_um = lower_um - MARGIN * width;
        let mut axis_max_um = upper_um + MARGIN * width;
        let measured = measured.map(|measured| measured.saturating_sub(limits.nominal).to_um_f64());
        let ends = guard.iter().flat_map(Ends::all);
        for value in [Some(0.0), measured].into_iter().flatten().chain(ends) {
            if lower_um - REACH * width <= value && value <= upper_um + REACH * width {
                axis_min_um = axis_min_um.min(value - AIR * width);
                axis_max_um = axis_max_um.max(value + AIR * width);
            }
        }
        let marker = measured.map(|value| {
            if value < axis_min_um {
                Marker::BeyondLeft(value)
            } else if axis_max_um < value {
                Marker::BeyondRight(value)
            } else {
                Marker::InSight(value)
            }
        });
        let (left, right) = match limits.feature {
            Some(Feature::Hole) => (Side::Rework, Side::Scrap),
            Some(Feature::Shaft) => (Side::Scrap, Side::Rework),
            None => (Side::Out, Side::Out),
        };
        let ticks = ticks(axis_min_um, axis_max_um);
        let guard = guard.map(|ends| ends.cut([axis_min_um, axis_max_um], [lower_um, upper_um]));
        Self { axis_min_um, axis_max_um, lower_um, upper_um, left, right, marker, ticks, guard }
    }

    /// Where a deviation is along the axis: 0 at the left end, 1 at the right end, kept between them.
    pub fn fraction(&self, um: f64) -> f64 {
        ((um - self.axis_min_um) / (self.axis_max_um - self.axis_min_um)).clamp(0.0, 1.0)
    }

    /// Whether the axis shows a deviation.
    pub fn shows(&self, um: f64) -> bool {
        self.axis_min_um <= um && um <= self.axis_max_um
    }
}

/// Where a rule accepts and rejects, in micrometres from the nominal size.
#[derive(Debug, Clone, Copy)]
struct Ends {
    accepted: Option<[f64; 2]>,
    rejected: Option<[f64; 2]>,
}

impl Ends {
    /// `None` where the limits themselves decide.
    fn of(rule: &Rule, limits: &Limits) -> Option<Self> {
        let bounds = limits.bounds();
        let zones = rule.zones(&bounds);
        let plain = [bounds.minimum(), bounds.maximum()];
        let everything = [Length::MAX.negated(), Length::MAX];
        let deviations = |ends: [Length; 2]| ends.map(|size| size.saturating_sub(limits.nominal).to_um_f64());
        (zones.accepted != Some(plain) || zones.rejected != plain).then(|| Self {
            accepted: zones.accepted.map(deviations),
            rejected: (zones.rejected != everything).then(|| deviations(zones.rejected)),
        })
    }

    fn all(&self) -> impl Iterator<Item = f64> {
        self.accepted.into_iter().chain(self.rejected).flatten()
    }

    fn cut(self, [axis_min, axis_max]: [f64; 2], [lower, upper]: [f64; 2]) -> Guard {
        let Self { accepted, rejected } = self;
        let [below, above] = rejected.unwrap_or([axis_min, axis_max]);
        let undecided = |from: f64, to: f64| (from, to, Guarded::Undecided);
        let found = match accepted {
            None => vec![undecided(below, above)],
            Some([least, most]) => vec![
                undecided(below, least),
                (least, lower, Guarded::AcceptedBeyond),
                (upper, most, Guarded::AcceptedBeyond),
                undecided(most, above),
            ],
        };
        let bands = found.into_iter().map(|(from, to, guarded)| GuardBand {
            from_um: from.max(axis_min),
            to_um: to.min(axis_max),
            guarded,
        });
        Guard { accepted, rejected, bands: bands.filter(|band| band.from_um < band.to_um).collect() }
    }
}

/// Multiples of 1, 2 or 5 times a power of ten: at least [`STEPS`] steps fit.
fn ticks(min: f64, max: f64) -> Vec<f64> {
    let step = round_down((max - min) / STEPS);
    let first = (min / step).ceil();
    // `+ 0.0` turns a negative zero into zero.
    (0_u8..u8::MAX).map(|n| (first + f64::from(n)) * step + 0.0).take_while(|tick| *tick <= max).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use fitcheck_core::tolerance::Sources;
    use fitcheck_core::verdict::rules::{Prover, RuleInputs, RuleName, Uncertainty};

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(-10.5, 31.5), [-10.0, 0.0, 10.0, 20.0, 30.0]);
        assert_eq!(ticks(-23.0, 33.0), [-20.0, -10.0, 0.0, 10.0, 20.0, 30.0]);
        assert_eq!(ticks(-0.001, 0.003), [-0.001, 0.0, 0.001, 0.002, 0.003]);
    }
    fn guard(name: RuleName, given: RuleInputs) -> Option<Guard> {
        let limits = Sources::default().limits(&"25 H7".parse().unwrap(), None).unwrap();
        Band::by(&Rule::new(name, given).unwrap(), &limits, Some("25.012".parse().unwrap())).guard
    }

    fn u(um: &str) -> RuleInputs {
        RuleInputs { uncertainty: Some(Uncertainty::standard(um).unwrap()), ..RuleInputs::default() }
    }

    const fn band(from_um: f64, to_um: f64, guarded: Guarded) -> GuardBand {
        GuardBand { from_um, to_um, guarded }
    }

    #[test]
    fn where_the_limits_decide_there_is_no_guard_band() {
        assert_eq!(guard(RuleName::Simple, RuleInputs::default()), None);
        assert_eq!(guard(RuleName::Simple, u("1")), None);
        assert_eq!(guard(RuleName::AsmeSimple, u("1")), None);
    }

    #[test]
    fn a_guard_band_lies_where_the_rule_decides_nothing() {
        let both = guard(RuleName::IlacG8, u("1.5")).unwrap();
        assert_eq!((both.accepted, both.rejected), (Some([3.0, 18.0]), Some([-3.0, 24.0])));
        assert_eq!(both.bands, [band(-3.0, 3.0, Guarded::Undecided), band(18.0, 24.0, Guarded::Undecided)]);
        let within = guard(RuleName::AsmeStringent, u("1.5")).unwrap();
        assert_eq!(within.bands, [band(0.0, 3.0, Guarded::Undecided), band(18.0, 21.0, Guarded::Undecided)]);
    }

    #[test]
    fn values_beyond_a_limit_that_are_accepted_have_a_band_of_their_own() {
        let relaxed = guard(RuleName::AsmeRelaxed, u("1.5")).unwrap();
        assert_eq!((relaxed.accepted, relaxed.rejected), (Some([-3.0, 24.0]), Some([-3.0, 24.0])));
        let beyond = [band(-3.0, 0.0, Guarded::AcceptedBeyond), band(21.0, 24.0, Guarded::AcceptedBeyond)];
        assert_eq!(relaxed.bands, beyond);
        let customer = guard(RuleName::IlacG8, RuleInputs { prover: Prover::Customer, ..u("1.5") }).unwrap();
        assert_eq!(customer.bands, beyond);
    }

    #[test]
    fn where_nothing_is_accepted_one_band_covers_all_that_is_not_rejected() {
        let wide = guard(RuleName::IlacG8, u("6")).unwrap();
        assert_eq!((wide.accepted, wide.rejected), (None, Some([-12.0, 33.0])));
        assert_eq!(wide.bands, [band(-12.0, 33.0, Guarded::Undecided)]);
        // Nothing is decided, and a band wider than the axis is cut at its ends.
        let ratio = guard(RuleName::AsmeSimple, u("6")).unwrap();
        assert_eq!((ratio.accepted, ratio.rejected), (None, None));
        assert_eq!(ratio.bands, [band(-10.5, 31.5, Guarded::Undecided)]);
        let far = guard(RuleName::IlacG8, u("600")).unwrap();
        assert_eq!(far.bands, [band(-10.5, 31.5, Guarded::Undecided)]);
    }

    #[test]
    fn the_axis_stretches_to_the_ends_of_guard_bands() {
        let limits = Sources::default().limits(&"25 H7".parse().unwrap(), None).unwrap();
        let band = Band::by(&Rule::new(RuleName::IlacG8, u("6")).unwrap(), &limits, None);
        assert!(band.axis_min_um < -12.0 && 33.0 < band.axis_max_um, "{band:?}");
        assert_eq!(Band::by(&Rule::SIMPLE, &limits, None), Band::new(&limits, None));
    }
}
