//! Which features of a plan a control can measure.

use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::part::{FeatureKind, Plan, PlanFeature};
use fitcheck_core::verdict::rules::RuleName;

use super::error::{FeatureError, FeatureFault, SetError, SetRemark};
use super::names::Control;
use super::{Planned, Target};

/// The most characters of a feature's name: with its prefix and suffix, a file name has at most 29.
const LONGEST_NAME: usize = 20;

/// The features with their places, or everything that the control cannot measure.
pub(super) fn planned<'a>(plan: &'a Plan, target: &Target) -> Result<Vec<Planned<'a>>, SetError> {
    let mut all = Vec::new();
    let mut errors = Vec::<FeatureError>::new();
    for feature in plan.features().iter().filter(|feature| !feature.kind.is_by_hand()) {
        let before = errors.len();
        errors.extend(faults(feature, target.control).into_iter().map(|what| {
            let line = feature.line;
            Located { what, place: FilePlace { line, ..FilePlace::default() } }
        }));
        if let Some(place) = feature.place.filter(|_place| errors.len() == before) {
            let by_text = target.by_text && matches!(feature.kind, FeatureKind::Diameter(_));
            all.push(Planned { feature, place, limits: &feature.limits, by_text });
        }
    }
    let mut errors = errors.into_iter();
    match errors.next() {
        Some(first) => Err(SetError::of_features(first, errors.collect())),
        None => Ok(all),
    }
}

/// A feature that no cycle measures: it is not in the set.
pub(super) fn by_hand(feature: &PlanFeature) -> Option<SetRemark> {
    let kind = feature.kind.word();
    feature.kind.is_by_hand().then(|| SetRemark::ByHand { name: feature.name.clone(), kind })
}

/// What a set does not know of a feature that its plan says: the cycles judge by the limits alone.
pub(super) fn unknown(feature: &PlanFeature) -> Option<SetRemark> {
    let rule = feature.rule.filter(|rule| feature.has_own_rule && rule.name() != RuleName::Simple);
    let u = feature.rule.and_then(|rule| rule.uncertainty());
    let said = [
        rule.map(|rule| format!("rule {}", rule.name().word())),
        u.map(|u| format!("u_um {}", u.um())),
        feature.material.as_ref().map(|material| format!("material {}", material.name)),
    ];
    let ranges = feature.sizes().filter_map(|size| {
        let key = if size.side == 0 { "plausible" } else { "plausible2" };
        size.plausible.map(|range| format!("{key} {} {}", range.lower(), range.upper()))
    });
    let said: Vec<String> = said.into_iter().flatten().chain(ranges).collect();
    (!said.is_empty()).then(|| SetRemark::NotInSet { name: feature.name.clone(), said: said.join(", ") })
}

fn faults(feature: &PlanFeature, control: Control) -> Vec<FeatureFault> {
    let mut faults = Vec::new();
    let name = || feature.name.clone();
    let is_sound = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    if LONGEST_NAME < feature.name.chars().count() || !feature.name.bytes().all(is_sound) {
        let name = feature.name.chars().take(2 * LONGEST_NAME).collect();
        faults.push(FeatureFault::Name { name, most: LONGEST_NAME });
    }
    if feature.place.is_none() {
        faults.push(FeatureFault::NoPlace { name: name() });
    }
    if feature.has_own_cycle {
        faults.push(FeatureFault::OwnCycle { name: name() });
        return faults;
    }
    // Both cycles of a kind are on the same controls.
    if let Some(cycle) = feature.cycle.filter(|cycle| !control.has(cycle)) {
        let kind = feature.kind.word();
        let cycle = cycle.code;
        let control = control.name();
        faults.push(FeatureFault::NotOnControl { kind, cycle, control });
    }
    faults
}
