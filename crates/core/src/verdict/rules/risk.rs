//! Global risks: how often a process and a rule together accept what does not conform, or reject what does (JCGM 106, section 9).

use crate::law::{gamma, gamma_density, normal};

/// What is known of the true values before one is measured, in the unit of the limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Prior {
    /// A process with a mean and a standard deviation above 0.
    Normal {
        /// Its mean.
        mean: f64,
        /// Its standard deviation.
        deviation: f64,
    },
    /// A gamma law, from 0 up, for deviations of form; shape and scale are above 0.
    Gamma {
        /// Its shape.
        shape: f64,
        /// Its scale.
        scale: f64,
    },
}

/// Limits, accepted values and the standard uncertainty, all in one unit. A side without a limit is infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Acceptance {
    /// Smallest and largest conforming value.
    pub limits: [f64; 2],
    /// Smallest and largest accepted value.
    pub accepted: [f64; 2],
    /// The standard uncertainty.
    pub u: f64,
}

/// What goes wrong, as probabilities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Risks {
    /// That a value does not conform.
    pub nonconforming: f64,
    /// The consumer's risk: that a value is accepted and does not conform.
    pub consumer: f64,
    /// The producer's risk: that a value conforms and is not accepted.
    pub producer: f64,
}

/// So many parts of a range are integrated each by itself: the functions change over a tenth of a standard uncertainty at most
/// as fast as a polynomial of the ninth degree does.
const PARTS: u32 = 1_500;

/// Points and weights of Gauss and Legendre for five points in a range from -1 to 1.
const POINTS: [(f64, f64); 5] = [
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

impl Prior {
    fn density(self, x: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation } => {
                let off = (x - mean) / deviation;
                libm::exp(-off * off / 2.0) / (deviation * std::f64::consts::TAU.sqrt())
            }
            Self::Gamma { shape, scale } => gamma_density(shape, x / scale) / scale,
        }
    }

    /// How many values are not above this one.
    fn up_to(self, x: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation } => normal((x - mean) / deviation).below,
            Self::Gamma { shape, scale } => gamma(shape, x / scale).below,
        }
    }

    /// Where nearly every value lies.
    fn range(self) -> [f64; 2] {
        match self {
            Self::Normal { mean, deviation } => [mean - 12.0 * deviation, mean + 12.0 * deviation],
            Self::Gamma { shape, scale } => [0.0, scale * (shape + 12.0 * shape.sqrt() + 40.0)],
        }
    }
}

impl Risks {
    /// The risks of accepting by a zone.
    pub fn of(prior: Prior, acceptance: &Acceptance) -> Self {
        let Acceptance { limits: [minimum, maximum], accepted: [least, most], u } = *acceptance;
        let is_accepted = |x: f64| normal((most - x) / u).below - normal((least - x) / u).below;
        let [first, last] = prior.range();
        let minimum = minimum.clamp(first, last);
        let maximum = maximum.clamp(first, last);
        // Ten standard uncertainties about its ends the zone's edge is all there is: each stretch is integrated by itself, however wide
        // the process is.
        let edges = [least - 10.0 * u, least + 10.0 * u, most - 10.0 * u, most + 10.0 * u];
        let accepted = |from, to| in_stretches(from, to, &edges, |x| prior.density(x) * is_accepted(x));
        let conforming = prior.up_to(maximum) - prior.up_to(minimum);
        let consumer = accepted(first, minimum) + accepted(maximum, last);
        let producer = in_stretches(minimum, maximum, &edges, |x| prior.density(x) * (1.0 - is_accepted(x)));
        Self { nonconforming: 1.0 - conforming, consumer, producer }
    }
}

/// The zone of accepted values, moved inwards from the limits by the same amount at either one, whose consumer's risk is this; `None`
/// where even the smallest zone has a larger one.
pub fn acceptance_for(prior: Prior, limits: [f64; 2], u: f64, consumer: f64) -> Option<Acceptance> {
    let [minimum, maximum] = limits;
    let [first, last] = prior.range();
    let moved = |by: f64| Acceptance { limits, accepted: [minimum + by, maximum - by], u };
    let risk = |by: f64| Risks::of(prior, &moved(by)).consumer;
    // Outwards a zone may become larger than the limits.
    let mut least = -20.0 * u;
    let mut most = (maximum.min(last) - minimum.max(first)) / 2.0;
    if maximum.is_infinite() || minimum.is_infinite() {
        most *= 2.0;
    }
    if consumer < risk(most) || risk(least) < consumer {
        return None;
    }
    for _ in 0..80 {
        let middle = f64::midpoint(least, most);
        if risk(middle) < consumer { most = middle } else { least = middle }
    }
    Some(moved(most))
}

/// The integral in stretches that end at these places.
fn in_stretches(from: f64, to: f64, edges: &[f64], of: impl Fn(f64) -> f64) -> f64 {
    let mut places: Vec<f64> = edges.iter().copied().filter(|edge| from < *edge && *edge < to).collect();
    places.sort_by(f64::total_cmp);
    places.push(to);
    let mut start = from;
    places.into_iter().map(|end| integral(std::mem::replace(&mut start, end), end, &of)).sum()
}

fn integral(from: f64, to: f64, of: impl Fn(f64) -> f64) -> f64 {
    let half = (to - from) / f64::from(PARTS) / 2.0;
    let part = |number: u32| {
        let middle = from + half * f64::from(2 * number + 1);
        POINTS.iter().map(|(point, weight)| weight * of(middle + half * point)).sum::<f64>()
    };
    (0..PARTS).map(part).sum::<f64>() * half
}
