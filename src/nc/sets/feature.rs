//! Which features of a plan a control can measure.

use super::Planned;
use super::error::{FeatureError, FeatureFault};
use super::names::Control;
use crate::message::{Located, Place};
use crate::part::{Plan, PlanFeature};
use crate::tolerance::Tolerance;

/// The most characters of a feature's name: with its prefix and suffix, a file name has at most 29.
const LONGEST_NAME: usize = 20;

/// The features with their places, or the first one that the control cannot measure.
pub(super) fn planned(plan: &Plan, control: Control) -> Result<Vec<Planned<'_>>, FeatureError> {
    let of = |feature| {
        one(feature, control).map_err(|what| {
            let line = feature.line;
            Located { what, place: Place { line, ..Place::default() } }
        })
    };
    plan.features().iter().map(of).collect()
}

fn one(feature: &PlanFeature, control: Control) -> Result<Planned<'_>, FeatureFault> {
    for callout in feature.kind.callouts() {
        if !matches!(callout.tolerance(), Tolerance::Class(_)) {
            return Err(FeatureFault::NoClass { callout });
        }
    }
    let name = || feature.name.clone();
    let is_sound = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    if LONGEST_NAME < feature.name.chars().count() || !feature.name.bytes().all(is_sound) {
        let name = feature.name.chars().take(2 * LONGEST_NAME).collect();
        return Err(FeatureFault::Name { name, most: LONGEST_NAME });
    }
    let place = feature.place.ok_or_else(|| FeatureFault::NoPlace { name: name() })?;
    if feature.has_own_cycle {
        return Err(FeatureFault::OwnCycle { name: name() });
    }
    // Both cycles of a kind are on the same controls.
    if let Some(cycle) = feature.cycle.filter(|cycle| !control.has(cycle)) {
        let (kind, cycle, control) = (feature.kind.word(), cycle.code, control.name());
        return Err(FeatureFault::NotOnControl { kind, cycle, control });
    }
    Ok(Planned { feature, place, limits: &feature.limits })
}
