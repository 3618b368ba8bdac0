//! Limits that come without a callout: what a value is judged by, or why it is not.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{Deviations, Feature, Limits, LimitsError, Source, Sources};

use crate::exchange::imported::{StatedLimits, WhyUnjudged};

/// What is known of a value besides its limits.
#[derive(Debug, Clone, Copy)]
pub(in crate::exchange) struct Given<'a> {
    /// Hole or shaft, where the row says so.
    pub(in crate::exchange) feature: Option<Feature>,
    /// Whether a size was measured, and not a coordinate or a form.
    pub(in crate::exchange) is_size: bool,
    /// The file that has the limits.
    pub(in crate::exchange) file: &'a Arc<str>,
    pub(in crate::exchange) sources: &'a Sources,
}

/// Why there are no limits to judge by.
#[derive(Debug)]
pub(in crate::exchange) enum NoLimits {
    Unjudged(WhyUnjudged),
    Refused(Box<LimitsError>),
}

impl StatedLimits {
    /// The limits of a row that has no callout.
    pub(in crate::exchange) fn limits(&self, given: Given<'_>) -> Result<Limits, NoLimits> {
        let is_form = !given.is_size && self.nominal.is_none_or(|nominal| nominal == Length::ZERO);
        let (minimum, maximum) = match (self.minimum, self.maximum) {
            (Some(minimum), Some(maximum)) => (minimum, maximum),
            // A roundness has one limit, and nothing is rounder than round.
            (None, Some(maximum)) if is_form => (Length::ZERO, maximum),
            (None, None) => return Err(NoLimits::Unjudged(WhyUnjudged::NoCallout)),
            _ => return Err(NoLimits::Unjudged(WhyUnjudged::OneLimit)),
        };
        let swapped = || NoLimits::Unjudged(WhyUnjudged::SwappedLimits { minimum, maximum });
        if maximum < minimum {
            return Err(swapped());
        }
        let nominal = self.nominal.unwrap_or(minimum);
        let too_large = || NoLimits::Refused(Box::new(LimitsError::TooLarge { nominal }));
        let (upper, lower) = maximum.checked_sub(nominal).zip(minimum.checked_sub(nominal)).ok_or_else(too_large)?;
        let deviations = Deviations::new(upper, lower).map_err(|_swapped| swapped())?;
        judged(given, (nominal, self.nominal.is_some()), deviations)
    }
}

/// Limits by which a value is judged. Where neither hole nor shaft is said, it stays open what a value beyond them is.
fn judged(given: Given<'_>, (nominal, is_stated): (Length, bool), deviations: Deviations) -> Result<Limits, NoLimits> {
    let Given { feature, is_size, file, sources } = given;
    let refused = |error: LimitsError| NoLimits::Refused(Box::new(error));
    let feature = feature.filter(|_| is_size);
    let limits = Limits::new(feature, nominal, deviations, Source::File(Arc::clone(file)));
    let limits = limits.ok_or_else(|| refused(LimitsError::TooLarge { nominal }))?;
    // What lies at zero or below is a coordinate or a deviation, where nobody says otherwise. Two limits alone, as of a chamfer, were never
    // deviations in micrometres.
    if is_size && (feature.is_some() || is_stated && Length::ZERO < nominal) {
        sources.proportionate(&limits.bounds()).map_err(refused)?;
    } else {
        sources.proportionate_coordinate(nominal, deviations).map_err(refused)?;
    }
    Ok(limits)
}
