//! A measured value of a plan's size becomes a check: brought to 20 °C where a temperature is given, and judged by the plan's rule and
//! uncertainty, or else by those that are given beside it.
//!
//! The command line and the window judge by this alone, so that both say the same of a value. The plan counts wherever it says something;
//! what was given and does not count is told, and never left out in silence.

use std::sync::Arc;

use fitcheck_core::budget::{AssessmentError, Budget};
use fitcheck_core::message::{Message, Say};
use fitcheck_core::part::{FeatureKind, Material, PlanFeature, Size};
use fitcheck_core::tolerance::fit::thermal::{Correction, Warm};
use fitcheck_core::verdict::rules::{RuleError, RuleInputs, RuleName, Uncertainty};
use fitcheck_core::verdict::{Doubt, Rule};

use super::Record;

/// What is given for judging besides the plan: by options, or on the check page.
#[derive(Debug, Clone, Copy, Default)]
pub struct JudgingOptions<'a> {
    /// The rule, where one was chosen.
    pub rule: Option<RuleName>,
    /// What goes with it; the uncertainty is that of every value.
    pub given: RuleInputs,
    /// A budget, which gives each value an uncertainty of its own.
    pub budget: Option<&'a Budget>,
    /// The part and the scales that it was measured with, where a temperature is given.
    pub warm: Option<(Warm, Option<Warm>)>,
}

/// What is to be said of how a value was judged.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "planned")]
pub enum PlannedRemark {
    /// Another rule was given, and the plan's counts.
    Rule {
        /// The rule that counts.
        #[say(with = Say::message)]
        rule: Rule,
        /// The word of the other one.
        given: &'static str,
    },
    /// Another uncertainty was given, or a budget, and the plan's counts.
    Uncertainty {
        /// The uncertainty that counts.
        #[say(with = Say::message)]
        u: Uncertainty,
    },
    /// Another material was given, and the plan's counts.
    Material {
        /// As the plan names it.
        name: String,
    },
    /// The value was brought to 20 °C.
    Corrected {
        /// The temperature at which it was measured.
        temperature: String,
        /// The expansion in millionths per kelvin.
        expansion: String,
    },
    /// A place on the part has no size of its own that could grow.
    NotCorrected,
}

impl PlannedRemark {
    /// Whether it tells of something that was given and does not count for this value.
    pub const fn is_warning(&self) -> bool {
        !matches!(self, Self::Corrected { .. })
    }
}

/// Why a value cannot be judged.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "planned-error", error)]
pub enum PlannedError {
    /// A temperature is given for a value that its file has brought to 20 °C.
    AlreadyCorrected,
    /// Rule and uncertainty do not go together.
    #[say(transparent)]
    Rule(#[from] RuleError),
    /// The budget gives no uncertainty.
    #[say(transparent)]
    Budget(#[from] AssessmentError),
}

/// A check by a plan, and what is to be said of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned {
    /// The check.
    pub record: Record,
    /// How it came about.
    pub said: Vec<PlannedRemark>,
}

/// Judges a record of a plan's size, whatever it was judged by before.
///
/// # Errors
/// [`PlannedError`] where it cannot be judged as the plan and what is given say: it is never judged by less.
pub fn judge(size: &Size<'_>, record: Record, beside: &JudgingOptions<'_>) -> Result<Planned, PlannedError> {
    let mut said = Vec::new();
    let record = match beside.warm {
        Some(warm) => corrected(size.feature, record, warm, &mut said)?,
        None => record,
    };
    let mut record = by_rule(size.feature, record, beside, &mut said)?;
    record.doubt = doubt(size, &record);
    Ok(Planned { record, said })
}

/// What is strange about a value: first of all that the plan says it cannot be. What it may have been is offered where that can.
fn doubt(size: &Size<'_>, record: &Record) -> Option<Doubt> {
    let usual = record.doubt;
    let Some(range) = size.excludes(record.measured()) else { return usual };
    let meant = usual.and_then(Doubt::meant).filter(|meant| range.admits(*meant));
    Some(Doubt::Implausible { lower: range.lower(), upper: range.upper(), meant })
}

fn corrected(
    feature: &PlanFeature,
    record: Record,
    (part, scale): (Warm, Option<Warm>),
    said: &mut Vec<PlannedRemark>,
) -> Result<Record, PlannedError> {
    if matches!(feature.kind, FeatureKind::Face(..) | FeatureKind::Point(..) | FeatureKind::Form(_)) {
        said.push(PlannedRemark::NotCorrected);
        return Ok(record);
    }
    if record.correction.is_some() {
        return Err(PlannedError::AlreadyCorrected);
    }
    let part = match &feature.material {
        Some(Material { name, expansion }) => {
            if *expansion != part.expansion {
                said.push(PlannedRemark::Material { name: name.clone() });
            }
            Warm { expansion: *expansion, ..part }
        }
        None => part,
    };
    let temperature = part.temperature.to_string();
    let expansion = part.expansion.to_string();
    said.push(PlannedRemark::Corrected { temperature, expansion });
    let measured = record.measurement.diameter;
    Ok(record.corrected(Correction::new(measured, part, scale)))
}

fn by_rule(
    feature: &PlanFeature,
    record: Record,
    beside: &JudgingOptions<'_>,
    said: &mut Vec<PlannedRemark>,
) -> Result<Record, PlannedError> {
    let own_uncertainty = feature.rule.and_then(|rule| rule.uncertainty());
    let own_rule = feature.rule.filter(|_rule| feature.has_own_rule);
    let (name, given) = match own_rule {
        Some(rule) => (rule.name(), *rule.given()),
        None => (beside.rule.unwrap_or(RuleName::Simple), beside.given),
    };
    let by = |uncertainty| Rule::new(name, RuleInputs { uncertainty, ..given });
    let record = match (own_uncertainty, beside.budget) {
        (Some(_), _) => record.by(by(own_uncertainty)?),
        (None, None) => record.by(by(beside.given.uncertainty)?),
        (None, Some(budget)) => {
            let (found, uncertainty) = record.assess(budget.clone())?;
            record.by_budget(by(Some(uncertainty))?, Arc::new(found.provenance()))
        }
    };
    let chosen = |given: &RuleInputs| RuleInputs { uncertainty: None, ..*given };
    let is_other = |rule: RuleName| rule != name || chosen(&beside.given) != chosen(&given);
    if let Some(other) = beside.rule.filter(|rule| own_rule.is_some() && is_other(*rule)) {
        said.push(PlannedRemark::Rule { rule: record.verdict.rule, given: other.word() });
    }
    if let Some(u) = own_uncertainty
        && (beside.budget.is_some() || beside.given.uncertainty.is_some_and(|other| other != u))
    {
        said.push(PlannedRemark::Uncertainty { u });
    }
    Ok(record)
}

impl Planned {
    /// What is to be said of it, in the order in which it was done.
    pub fn messages(&self) -> impl Iterator<Item = Message> {
        self.said.iter().map(Say::message)
    }
}
