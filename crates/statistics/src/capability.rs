//! What a process can do, by the normal law: Cp, Cpk, Pp, Ppk and Cpm with intervals, distances to the limits, expected share
//! outside.
//!
//! ISO 22514-2; NIST/SEMATECH e-Handbook 6.1.6; Montgomery. The indices with σ within subgroups are Cp and Cpk, those with the
//! standard deviation of all values Pp and Ppk. With one limit there is no Cp, and Cpk is that of the one side.

use crate::moments::{Estimate, Moments, checked_level, count};
use crate::reason::Reason;
use crate::sigma::{Method, Sigma};
use crate::tolerance::Tolerance;
use fitcheck_core::law::{chi_square_quantile, normal, normal_quantile};

/// Which degrees of freedom the intervals of Cp and Cpk have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Degrees {
    /// Those that the estimate of σ is worth ([`Sigma::degrees`]): the intervals hold their level.
    #[default]
    Effective,
    /// n − 1, as some programs and books have it: intervals of ranges and of standard deviations become too narrow.
    OfValues,
}

/// What is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CapabilityPlan {
    /// The limits.
    pub tolerance: Tolerance,
    /// The value that is aimed at; `None` is the middle between both limits.
    pub target: Option<f64>,
    /// How σ within subgroups is estimated.
    pub method: Method,
    /// Which degrees of freedom its intervals have.
    pub degrees: Degrees,
    /// The level of the intervals, such as 0.95.
    pub level: f64,
}

impl CapabilityPlan {
    /// Intervals of 95 % with effective degrees of freedom, aimed at the middle.
    pub const fn of(tolerance: Tolerance, method: Method) -> Self {
        Self { tolerance, target: None, method, degrees: Degrees::Effective, level: 0.95 }
    }
}

/// One side of the tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// How many σ the limit is away from the mean; negative where the mean is beyond it.
    pub distance: Estimate,
    /// A third of it: Cpl or Cpu.
    pub index: Estimate,
    /// Expected parts beyond this limit in a million.
    pub ppm: Estimate,
}

/// The indices with one estimate of σ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Indices {
    /// The estimate of σ.
    pub sigma: Sigma,
    /// The same with its interval.
    pub deviation: Estimate,
    /// (upper − lower) / 6 σ: Cp or Pp; none with one limit.
    pub potential: Option<Estimate>,
    /// The side of the lower limit.
    pub lower: Option<Side>,
    /// The side of the upper limit.
    pub upper: Option<Side>,
    /// The worse side: Cpk or Ppk.
    pub actual: Estimate,
    /// (upper − lower) / 6 √(σ² + (mean − target)²): Cpm; none with one limit.
    pub about_target: Option<Estimate>,
    /// Expected parts outside the limits in a million.
    pub ppm: Estimate,
}

/// What a process can do.
#[derive(Debug, Clone, PartialEq)]
pub struct Capability {
    /// Count, mean and spread of all values.
    pub moments: Moments,
    /// The mean with its interval.
    pub mean: Estimate,
    /// How many values are below the lower and above the upper limit.
    pub outside: [usize; 2],
    /// With σ within subgroups: Cp, Cpk; or why there is none.
    pub within: Result<Indices, Reason>,
    /// With the standard deviation of all values: Pp, Ppk.
    pub overall: Indices,
}

/// The capability of a series of subgroups; of single values each is a subgroup of one.
///
/// # Errors
/// Fewer than two values, values that are equal or no finite numbers, a level beyond 0 to 1.
pub fn capability<'a, G>(groups: G, plan: &CapabilityPlan) -> Result<Capability, Reason>
where
    G: IntoIterator<Item = &'a [f64]> + Clone,
{
    checked_level(plan.level)?;
    let values: Vec<f64> = groups.clone().into_iter().flatten().copied().collect();
    let moments = Moments::of(&values)?;
    let overall = Sigma::overall(&moments)?;
    let within = Sigma::within(groups, plan.method).map(|sigma| match plan.degrees {
        Degrees::Effective => sigma,
        Degrees::OfValues => Sigma { degrees: moments.degrees(), ..sigma },
    });
    Ok(Capability {
        moments,
        mean: moments.mean_estimate(plan.level)?,
        outside: plan.tolerance.outside(&values),
        within: within.and_then(|sigma| indices(&moments, sigma, plan)),
        overall: indices(&moments, overall, plan)?,
    })
}

/// The indices with an estimate of σ.
fn indices(of: &Moments, sigma: Sigma, plan: &CapabilityPlan) -> Result<Indices, Reason> {
    let CapabilityPlan { tolerance, level, .. } = plan;
    let side = |limit: Option<f64>, sign: f64, level: f64| {
        limit.map(|limit| one_side(of, sigma, sign * (limit - of.mean) / sigma.value, level))
    };
    let sides = |level: f64| [side(tolerance.lower(), -1.0, level), side(tolerance.upper(), 1.0, level)];
    let [lower, upper] = sides(*level);
    let worse = match (lower, upper) {
        (Some(lower), Some(upper)) if lower.index.value < upper.index.value => Some(lower),
        (lower, upper) => upper.or(lower),
    };
    let width = tolerance.both().ok().map(|[lower, upper]| upper - lower);
    let deviation = Estimate::of_deviation(sigma.value, sigma.degrees, *level);
    // Both ends of two sides hold together where each holds at half the risk (Bonferroni).
    let together = if width.is_some() { f64::midpoint(1.0, *level) } else { *level };
    let ppm = sides(together).into_iter().flatten().map(|side| side.ppm).reduce(|one, other| Estimate {
        value: one.value + other.value,
        lower: one.lower + other.lower,
        upper: (one.upper + other.upper).min(MILLION),
    });
    Ok(Indices {
        sigma,
        deviation,
        potential: width.map(|width| deviation.map(|deviation| width / (6.0 * deviation))),
        lower,
        upper,
        actual: worse.ok_or(Reason::NoLimits)?.index,
        about_target: about_target(of, sigma, plan),
        ppm: ppm.ok_or(Reason::NoLimits)?,
    })
}

/// Parts in a million.
const MILLION: f64 = 1e6;

/// A side whose limit is so many σ away. The interval is that of Bissell (1990): z √(1/(9 n) + Cpk²/(2 f)).
fn one_side(of: &Moments, sigma: Sigma, distance: f64, level: f64) -> Side {
    let error = (1.0 / count(of.count) + distance * distance / (2.0 * sigma.degrees)).sqrt();
    let distance = Estimate::about(distance, normal_quantile(f64::midpoint(1.0, level)) * error);
    Side {
        distance,
        index: distance.map(|distance| distance / 3.0),
        ppm: distance.map(|distance| MILLION * normal(distance).above),
    }
}

/// Cpm with the interval of Boyles (1991). Overall, the square about the target is that of all values over n − 1.
fn about_target(of: &Moments, sigma: Sigma, plan: &CapabilityPlan) -> Option<Estimate> {
    let [lower, upper] = plan.tolerance.both().ok()?;
    let offset = of.mean - plan.target.unwrap_or_else(|| f64::midpoint(lower, upper));
    let number = count(of.count);
    let (weight, worth) = match sigma.method {
        Method::Overall => (number / of.degrees(), number),
        _ => (1.0, sigma.degrees),
    };
    let value = (upper - lower) / (6.0 * (sigma.value.powi(2) + weight * offset * offset).sqrt());
    let ratio = (offset / sigma.value).powi(2);
    let degrees = (1.0 + ratio).powi(2) / (1.0 / worth + 2.0 * ratio / number);
    let rest = (1.0 - plan.level) / 2.0;
    let end = |share: f64| value * (chi_square_quantile(degrees, share) / degrees).sqrt();
    Some(Estimate { value, lower: end(rest), upper: end(1.0 - rest) })
}
