//! What single cells of a plan say: texts, materials, rules, travels.

use super::cells::CellFault;
use super::column::Column;
use super::fault::PlanFault;
use super::plan::Material;
use super::plausible::Plausible;
use crate::length::Length;
use crate::probing::cycle::Meaning;
use crate::probing::cycles::measuring;
use crate::tolerance::Feature;
use crate::tolerance::fit::materials::Materials;
use crate::tolerance::fit::thermal::{Expansion, ThermalError};
use crate::verdict::Rule;
use crate::verdict::rules::{RuleInputs, RuleName, Uncertainty};

/// Whether a column of the plan, or its callout, decides a parameter of a cycle.
pub(super) const fn is_decided(meaning: Meaning) -> bool {
    !matches!(
        meaning,
        Meaning::MoveToClearance
            | Meaning::Shift
            | Meaning::Log
            | Meaning::Stop
            | Meaning::StopOnUndersize
            | Meaning::Tool
            | Meaning::CentreTolerance(_)
            | Meaning::ContactCount
            | Meaning::Step
            | Meaning::Path
            | Meaning::Traverse
            | Meaning::Retract
            | Meaning::Difference
    )
}

/// Checks a value against the range of a parameter; both cycles have these parameters, with the same ranges.
pub(super) fn in_range(meaning: Meaning, value: &impl ToString) -> Result<(), PlanFault> {
    let Some(parameter) = measuring(Feature::Hole).meant(meaning) else { return Ok(()) };
    let value = value.to_string();
    match parameter.accept(value.trim_end_matches('°')) {
        Ok(_value) => Ok(()),
        Err(error) => Err(PlanFault::Range(Box::new(error))),
    }
}

/// A text of one line.
pub(super) fn plain_text(text: &str, column: &'static str, most: usize) -> Result<String, PlanFault> {
    let is_sound = text.chars().count() <= most && !text.chars().any(char::is_control);
    if is_sound { Ok(text.to_owned()) } else { Err(PlanFault::Text { column, most }) }
}

/// What an error repeats of a text.
pub(super) fn beginning(text: &str) -> String {
    text.chars().take(40).collect()
}

pub(super) fn material(text: &str) -> Result<Material, PlanFault> {
    let name = text.to_owned();
    match Materials::shipped().find(text) {
        Ok(material) => Ok(Material { name, expansion: material.expansion }),
        Err(unknown) => match text.parse::<Expansion>() {
            Ok(expansion) => Ok(Material { name, expansion }),
            Err(ThermalError::NotANumber { .. }) => Err(PlanFault::Material(unknown)),
            Err(error) => Err(PlanFault::Thermal(error)),
        },
    }
}

/// A rule by its name and the standard uncertainty in micrometres; `fixed=2` has its guard band behind the name. Each of the two cells has
/// its own fault; whether they go together is told where both can be read.
pub(super) fn rule(name: Option<&str>, uncertainty: Option<&str>) -> Result<Option<Rule>, Vec<CellFault>> {
    let mut faults = Vec::new();
    let read = uncertainty.map(Uncertainty::standard).transpose();
    let uncertainty = read.unwrap_or_else(|error| {
        faults.push((Column::Uncertainty, PlanFault::Uncertainty { column: "u_um", error }));
        None
    });
    let named = name.map(named).transpose().unwrap_or_else(|fault| {
        faults.push((Column::Rule, fault));
        None
    });
    if !faults.is_empty() {
        return Err(faults);
    }
    match (named, name) {
        (Some((rule, width)), Some(text)) => {
            let rule = Rule::new(rule, RuleInputs { uncertainty, width, ..RuleInputs::default() });
            rule.map(Some).map_err(|error| vec![(Column::Rule, PlanFault::Rule { rule: beginning(text), error })])
        }
        // An uncertainty alone is shown with the control's rule.
        _ => Ok(uncertainty
            .and_then(|_u| Rule::new(RuleName::Simple, RuleInputs { uncertainty, ..RuleInputs::default() }).ok())),
    }
}

/// The name of a rule, and its guard band where it has one.
fn named(text: &str) -> Result<(RuleName, Option<Length>), PlanFault> {
    let (word, width) = text.split_once('=').map_or((text, None), |(word, width)| (word.trim(), Some(width)));
    let unknown = || {
        let known = RuleName::ALL.map(RuleName::word).join(", ");
        PlanFault::Unknown { column: "rule", given: beginning(text), known }
    };
    let name = RuleName::of_word(&word.to_lowercase()).ok_or_else(unknown)?;
    let width = width.map(|width| Length::parse_in(width, crate::length::Unit::Micrometre)).transpose();
    Ok((name, width.map_err(|error| PlanFault::Number { column: "rule", error })?))
}

/// Two numbers, the smaller one first.
pub(super) fn travel(text: &str) -> Result<[Length; 2], PlanFault> {
    two_lengths(text).ok_or_else(|| PlanFault::NoTravel { given: beginning(text) })
}

/// What a value can be: two lengths in millimetres, the smaller one first.
pub(super) fn plausible(text: &str, column: &'static str) -> Result<Plausible, PlanFault> {
    let range = two_lengths(text).and_then(Plausible::new);
    range.ok_or_else(|| PlanFault::NoPlausible { column, given: beginning(text) })
}

/// Two lengths with a blank between them, the smaller one first.
fn two_lengths(text: &str) -> Option<[Length; 2]> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let read: Option<Vec<Length>> = words.iter().map(|word| word.parse().ok()).collect();
    match read.as_deref() {
        Some([minimum, maximum]) if minimum < maximum => Some([*minimum, *maximum]),
        _ => None,
    }
}
