//! Capability of what is not normal, by percentiles of a fitted law (ISO 22514-2, ISO 22514-4).
//!
//! Pp = (upper − lower) / (X99.865 − X0.135), and Ppk the worse of (upper − X50) / (X99.865 − X50) and (X50 − lower) / (X50 − X0.135).
//! The intervals are those for many values; a simulation of 50 values holds them.

use crate::fitted::{Family, Fitted, Law};
use crate::moments::Estimate;
use crate::reason::Reason;
use crate::shape::{AndersonDarling, anderson_darling};
use crate::tolerance::Tolerance;
use fitcheck_core::law::{normal, normal_quantile};

/// The shares at −3 s, 0 and +3 s of a normal law, to the digits that the standard prints.
const SHARES: [f64; 3] = [0.001_35, 0.5, 0.998_65];

/// Capability by percentiles.
#[derive(Debug, Clone, PartialEq)]
pub struct Percentiles {
    /// The fitted law.
    pub law: Law,
    /// Whether the values come from it.
    pub test: Result<AndersonDarling, Reason>,
    /// X0.135, X50 and X99.865.
    pub points: [f64; 3],
    /// Pp; none with one limit.
    pub potential: Option<Estimate>,
    /// Ppk.
    pub actual: Estimate,
    /// Expected parts in a million below the lower limit.
    pub below: Option<Estimate>,
    /// Expected parts in a million above the upper limit.
    pub above: Option<Estimate>,
}

/// The capability of values by the percentiles of a law.
///
/// # Errors
/// What the fit refuses; a level beyond 0 to 1.
pub fn percentiles(values: &[f64], family: Family, tolerance: &Tolerance, level: f64) -> Result<Percentiles, Reason> {
    let fitted = Fitted::of(values, family)?;
    let lower = |limit: f64| {
        move |law: &Law| {
            let [low, middle, _] = points(law);
            (middle - limit) / (middle - low)
        }
    };
    let upper = |limit: f64| {
        move |law: &Law| {
            let [_, middle, high] = points(law);
            (limit - middle) / (high - middle)
        }
    };
    let potential = tolerance.both().ok().map(|[lower, upper]| {
        fitted.estimate(level, move |law| {
            let [low, _, high] = points(law);
            (upper - lower) / (high - low)
        })
    });
    let lower = tolerance.lower().map(|limit| fitted.estimate(level, lower(limit))).transpose()?;
    let upper = tolerance.upper().map(|limit| fitted.estimate(level, upper(limit))).transpose()?;
    let actual = match (lower, upper) {
        (Some(lower), Some(upper)) if lower.value < upper.value => Some(lower),
        (lower, upper) => upper.or(lower),
    };
    // A share becomes a distance in s, on which the interval is even.
    let share = |limit: f64, is_above: bool| {
        let of = move |law: &Law| {
            let tails = law.tails(limit);
            normal_quantile(if is_above { tails.above } else { tails.below }).clamp(-37.0, 37.0)
        };
        Ok(fitted.estimate(level, of)?.map(|distance| 1e6 * normal(distance).below))
    };
    Ok(Percentiles {
        law: fitted.law,
        test: anderson_darling(values, &fitted),
        points: points(&fitted.law),
        potential: potential.transpose()?,
        actual: actual.ok_or(Reason::NoLimits)?,
        below: tolerance.lower().map(|limit| share(limit, false)).transpose()?,
        above: tolerance.upper().map(|limit| share(limit, true)).transpose()?,
    })
}

fn points(law: &Law) -> [f64; 3] {
    SHARES.map(|share| law.quantile(share))
}
