//! The probability that a true value lies within limits, by a normal law about the measured value (JCGM 106).

use super::Uncertainty;
use crate::law;
use crate::length::Length;
use crate::tolerance::Bounds;

/// Where the true value probably lies; the three sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conformity {
    /// Within the limits.
    pub within: f64,
    /// Below the lower limit.
    pub below: f64,
    /// Above the upper limit.
    pub above: f64,
}

impl Conformity {
    /// The probabilities for a measured value.
    pub fn of(bounds: &Bounds, measured: Length, uncertainty: Uncertainty) -> Self {
        let u = uncertainty.nm();
        let away = |limit: Length| distance(limit, measured) / u;
        let normal = |z: f64| law::normal(z).below;
        let below = normal(away(bounds.minimum()));
        let above = normal(-away(bounds.maximum()));
        // The smaller part of a whole keeps its digits.
        let within = if below + above < 0.5 {
            1.0 - (below + above)
        } else {
            let to_minimum = away(bounds.minimum());
            let to_maximum = away(bounds.maximum());
            // On the side where both are small.
            if 0.0 < to_minimum {
                normal(-to_minimum) - normal(-to_maximum)
            } else {
                normal(to_maximum) - normal(to_minimum)
            }
        };
        Self { within: within.max(0.0), below, above }
    }
}

/// A probability in percent: two decimals, more near 0 and 1, where two would say certain.
pub fn percent(probability: f64) -> String {
    let rest = probability.min(1.0 - probability);
    let least = [(1e-4, 2), (1e-6, 4), (1e-8, 6)].into_iter().find(|(least, _)| *least <= rest);
    let written = |decimals: usize| format!("{:.*}", decimals, probability * 100.0);
    // 5 and 95 per cent decide in ISO 14253-1: on which side of them it lies must be seen.
    let is_told = |text: &str| {
        let is_beside = |read: f64, border: f64| {
            (read < border) == (probability * 100.0 < border) && read.total_cmp(&border).is_ne()
        };
        text.parse().is_ok_and(|read| [5.0, 95.0].into_iter().all(|border| is_beside(read, border)))
    };
    let decimals = least.map_or(2, |(_, decimals)| decimals);
    let texts = (decimals..=8).map(written);
    let mut told = texts.filter(|text| is_told(text));
    told.next().unwrap_or_else(|| written(decimals))
}

/// A limit minus a value, nanometres; both are whole numbers of at most 1e15.
#[expect(clippy::as_conversions, clippy::cast_precision_loss, reason = "far from a limit its last digits do not count")]
fn distance(limit: Length, value: Length) -> f64 {
    limit.saturating_sub(value).nanometres() as f64
}
