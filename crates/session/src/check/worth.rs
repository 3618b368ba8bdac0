//! What a measured value is worth: its temperature, its uncertainty, and the rule that judges it.

use std::sync::Arc;

use fitcheck_core::budget::{Assessment, Budget, Conditions};
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::part::PlanFeature;
use fitcheck_core::tolerance::Limits;
use fitcheck_core::tolerance::fit::thermal::{Correction, Temperature, ThermalError, Warm};
use fitcheck_core::verdict::Rule;
use fitcheck_core::verdict::rules::{
    Acceptance, Prior, Prover, Risks, RuleError, RuleInputs, RuleName, Uncertainty, multiple, thousandths,
};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::planned::JudgingOptions;

use super::{CheckField, RuleChoice, UncertaintyFrom};
use crate::budget::OpenBudget;
use crate::texts::{KeptField as _, Range, Texts};

/// The field that was refused, and why.
pub(crate) type Refusal = (CheckField, Message);

/// The fields of rule and uncertainty.
const OF_RULE: [CheckField; 4] =
    [CheckField::Uncertainty, CheckField::Coverage, CheckField::GuardFactor, CheckField::GuardWidth];

/// The fields of the temperature.
const OF_TEMPERATURE: [CheckField; 4] =
    [CheckField::PartTemperature, CheckField::PartExpansion, CheckField::ScaleTemperature, CheckField::ScaleExpansion];

/// Whether a field is about the rule.
pub(super) fn is_of_rule(field: CheckField) -> bool {
    OF_RULE.contains(&field)
}

/// Whether a field is about the temperature.
pub(super) fn is_of_temperature(field: CheckField) -> bool {
    OF_TEMPERATURE.contains(&field)
}

/// What the fields mean.
#[derive(Debug, Clone, Default)]
pub struct RuleFields {
    /// What is chosen.
    pub judging: RuleChoice,
    given: RuleInputs,
    /// Why there is no rule.
    no_rule: Option<Refusal>,
    /// Why a value cannot be brought to 20 °C.
    no_correction: Option<Refusal>,
    /// Part and scales.
    warm: Option<(Warm, Option<Warm>)>,
    /// What the process makes.
    process: Option<(Option<Length>, f64)>,
    /// What goes wrong by the rule, for these limits and this process.
    pub risks: Option<Risks>,
}

impl RuleFields {
    /// Reads the fields; errors are given to `refuse`.
    pub(super) fn read(
        texts: &Texts<CheckField>,
        judging: RuleChoice,
        refuse: &mut dyn FnMut(CheckField, Message),
    ) -> Self {
        let mut worth = Self { judging, ..Self::default() };
        match worth.read_rule(texts) {
            Ok(given) => worth.given = given,
            Err((field, problem)) => {
                let is_typed = !texts.text(field).trim().is_empty();
                // Nobody has typed it yet: that is no mistake before somebody judges.
                if is_typed || field != CheckField::Uncertainty {
                    refuse(field, problem.clone());
                }
                worth.no_rule = Some((field, problem));
            }
        }
        match warm(texts) {
            Ok(warm) => worth.warm = warm,
            Err((field, problem)) => {
                refuse(field, problem.clone());
                worth.no_correction = Some((field, problem));
            }
        }
        match process(texts) {
            Ok(process) => worth.process = process,
            Err((field, problem)) => refuse(field, problem),
        }
        worth
    }

    fn read_rule(&self, texts: &Texts<CheckField>) -> Result<RuleInputs, Refusal> {
        let RuleChoice { rule, prover, from } = self.judging;
        let text = |field: CheckField| texts.text(field).trim();
        let has_uncertainty = !text(CheckField::Uncertainty).is_empty();
        let uncertainty = match from {
            UncertaintyFrom::Budget => None,
            _ if !has_uncertainty => None,
            UncertaintyFrom::Standard | UncertaintyFrom::Expanded => {
                let k = Uncertainty::factor(text(CheckField::Coverage))
                    .map_err(|error| (CheckField::Coverage, error.message()))?;
                let given = text(CheckField::Uncertainty);
                let read = match from {
                    UncertaintyFrom::Expanded => Uncertainty::expanded(given, k),
                    _ => Uncertainty::standard(given).map(|uncertainty| uncertainty.covered(k)),
                };
                Some(read.map_err(|error| (CheckField::Uncertainty, error.message()))?)
            }
        };
        let factor = if rule.takes_factor() {
            let given = text(CheckField::GuardFactor);
            let refusal = || (CheckField::GuardFactor, message!("guard-factor-wrong").text("given", given));
            Some(multiple(given).filter(|factor| 0 < *factor).ok_or_else(refusal)?)
        } else {
            None
        };
        let width = if rule.takes_width() && !text(CheckField::GuardWidth).is_empty() {
            let read = Length::parse_in(text(CheckField::GuardWidth), Unit::Micrometre);
            Some(read.map_err(|error| (CheckField::GuardWidth, error.message()))?)
        } else {
            None
        };
        let prover = if rule.takes_prover() { prover } else { Prover::Supplier };
        let given = RuleInputs { uncertainty, factor, width, prover };
        if from != UncertaintyFrom::Budget {
            made(rule, given)?;
        }
        Ok(given)
    }

    /// The rule, where it is the same for every value; `None` where the fields give none, or a budget has to be asked.
    pub fn rule(&self) -> Option<Rule> {
        let is_one = self.no_rule.is_none() && self.judging.from != UncertaintyFrom::Budget;
        is_one.then(|| made(self.judging.rule, self.given).ok()).flatten()
    }

    /// The rule before anything is measured: a budget is asked for the middle of the zone and its own contacts. `None` where nothing
    /// can be said yet.
    pub(crate) fn rule_ahead(&self, limits: &Limits, budget: Option<&OpenBudget>) -> Option<Rule> {
        if self.no_rule.is_some() || self.judging.from != UncertaintyFrom::Budget {
            return self.rule();
        }
        let Budget { date, .. } = budget?.budget;
        let size = Some(limits.middle());
        let feature = limits.feature;
        let conditions = Conditions { size, feature, ..Conditions::default() };
        let assessment = Assessment::of(budget?.budget.clone(), &conditions, None, date).ok()?;
        made(self.judging.rule, RuleInputs { uncertainty: Some(assessment.uncertainty().ok()?), ..self.given }).ok()
    }

    /// Whether the process is given, and the risks cannot be told for want of one uncertainty of all values.
    pub const fn wants_uncertainty_for_risks(&self) -> bool {
        self.process.is_some() && self.risks.is_none()
    }

    /// What is still to be typed before the rule can judge.
    pub fn awaits(&self) -> Option<&Message> {
        self.no_rule.as_ref().filter(|(field, _)| *field == CheckField::Uncertainty).map(|(_, problem)| problem)
    }

    /// The uncertainty that was typed.
    pub(crate) const fn typed_uncertainty(&self) -> Option<Uncertainty> {
        self.given.uncertainty
    }

    /// How a length is brought to 20 °C; `None` where no temperature is given.
    pub fn correction(&self, measured: Length) -> Option<Correction> {
        let (part, scale) = self.warm?;
        Some(Correction::new(measured, part, scale))
    }

    /// What the fields give for judging a value of a plan.
    ///
    /// # Errors
    /// Why it cannot be judged: a field that cannot be read, or no budget, where the plan itself does not say it.
    pub(crate) fn beside<'a>(
        &self,
        feature: &PlanFeature,
        budget: Option<&'a OpenBudget>,
    ) -> Result<JudgingOptions<'a>, Message> {
        // A value that cannot be brought to 20 °C is not judged.
        if let Some((_, problem)) = &self.no_correction {
            return Err(problem.clone());
        }
        let warm = self.warm;
        match &self.no_rule {
            None => {}
            Some(_) if feature.has_own_rule => return Ok(JudgingOptions { warm, ..JudgingOptions::default() }),
            Some((_, problem)) => return Err(problem.clone()),
        }
        let RuleChoice { rule, from, .. } = self.judging;
        let is_sure = feature.has_own_rule || feature.rule.is_some_and(|rule| rule.uncertainty().is_some());
        let budget = match (from, budget) {
            (UncertaintyFrom::Budget, Some(open)) => Some(&open.budget),
            (UncertaintyFrom::Budget, None) if !is_sure => return Err(message!("budget-not-in-use")),
            _ => None,
        };
        let rule = Some(rule).filter(|rule| *rule != RuleName::default());
        Ok(JudgingOptions { rule, given: self.given, budget, warm })
    }

    /// Judges a record by the rule; a budget gives the uncertainty of its value and its contacts.
    pub(crate) fn judge(&self, record: Record, budget: Option<&OpenBudget>) -> Result<Record, Refusal> {
        // A value that cannot be brought to 20 °C is not judged.
        if let Some(refusal) = self.no_rule.as_ref().or(self.no_correction.as_ref()) {
            return Err(refusal.clone());
        }
        let RuleChoice { rule, from, .. } = self.judging;
        if from != UncertaintyFrom::Budget {
            return Ok(record.by(made(rule, self.given)?));
        }
        let refused = |problem: Message| (CheckField::Uncertainty, problem);
        let open = budget.ok_or_else(|| refused(message!("budget-not-in-use")))?;
        let assessed = record.assess(open.budget.clone());
        let (assessment, uncertainty) = assessed.map_err(|error| refused(error.message()))?;
        let given = RuleInputs { uncertainty: Some(uncertainty), ..self.given };
        let budget = Arc::new(assessment.provenance());
        Ok(record.by_budget(made(rule, given)?, budget))
    }

    /// Whether a record was judged as the fields say.
    pub(super) fn agrees(&self, record: &Record, budget: Option<&OpenBudget>) -> bool {
        let rule = record.verdict.rule;
        match self.judging.from {
            // A budget of the same name may have other figures by now.
            UncertaintyFrom::Budget => self
                .judge(record.clone(), budget)
                .is_ok_and(|again| again.verdict.rule == rule && again.budget == record.budget),
            _ => record.budget.is_none() && self.rule() == Some(rule),
        }
    }

    /// Whether its value was brought to 20 °C, or not, as the fields say.
    pub(super) fn agrees_on_temperature(&self, record: &Record) -> bool {
        self.no_correction.is_none()
            && self.warm == record.correction.map(|correction| (correction.part, correction.scale))
    }

    /// Brings nothing to 20 °C from a temperature that is doubted.
    pub(super) fn doubt_temperature(&mut self, field: CheckField, why: Message) {
        self.warm = None;
        self.no_correction.get_or_insert((field, why));
    }

    /// Whether the part's temperature is given.
    pub(super) const fn is_warm(&self) -> bool {
        self.warm.is_some()
    }

    /// From which temperature values are brought to 20 °C.
    pub(crate) fn temperature(&self) -> Option<Temperature> {
        self.warm.map(|(part, _scale)| part.temperature)
    }

    /// Computes the risks for limits.
    pub(super) fn look_at(&mut self, limits: Option<&Limits>) {
        self.risks = limits.and_then(|limits| self.risks_for(limits));
    }

    fn risks_for(&self, limits: &Limits) -> Option<Risks> {
        let (rule, (mean, deviation)) = (self.rule()?, self.process?);
        let bounds = limits.bounds();
        let mm = |[least, most]: [Length; 2]| [least.to_mm_f64(), most.to_mm_f64()];
        let u = rule.uncertainty()?.um().parse::<f64>().ok()? / 1_000.0;
        let accepted = mm(rule.zones(&bounds).accepted?);
        let prior = Prior::Normal { mean: mean.unwrap_or_else(|| limits.middle()).to_mm_f64(), deviation };
        Some(Risks::of(prior, &Acceptance { limits: mm([bounds.minimum(), bounds.maximum()]), accepted, u }))
    }
}

fn made(rule: RuleName, given: RuleInputs) -> Result<Rule, Refusal> {
    Rule::new(rule, given).map_err(|error| {
        let field = match error {
            RuleError::NoWidth { .. } | RuleError::WidthMissing { .. } => CheckField::GuardWidth,
            RuleError::NoFactor { .. } => CheckField::GuardFactor,
            RuleError::NoUncertainty { .. } | RuleError::NoProver { .. } => CheckField::Uncertainty,
        };
        let problem = match error {
            RuleError::NoUncertainty { .. } => {
                message!("check-rule-no-uncertainty").message("rule", Message::new(rule_name_id(rule)))
            }
            other => other.message(),
        };
        (field, problem)
    })
}

/// The text that names a rule in the window.
pub const fn rule_name_id(rule: RuleName) -> &'static str {
    match rule {
        RuleName::Simple => "rule-name-simple",
        RuleName::Iso14253Of2017 => "rule-name-iso14253-2017",
        RuleName::Iso14253Of1998 => "rule-name-iso14253-1998",
        RuleName::IlacG8 => "rule-name-ilac-g8",
        RuleName::AsmeSimple => "rule-name-asme-simple",
        RuleName::AsmeStringent => "rule-name-asme-stringent",
        RuleName::AsmeRelaxed => "rule-name-asme-relaxed",
        RuleName::Fixed => "rule-name-fixed",
    }
}

/// Part and scales, where the part's temperature is given.
fn warm(texts: &Texts<CheckField>) -> Result<Option<(Warm, Option<Warm>)>, Refusal> {
    let read = |temperature: CheckField, expansion: CheckField| -> Result<Option<Warm>, Refusal> {
        let text = |field: CheckField| texts.text(field).trim();
        if text(temperature).is_empty() {
            return Ok(None);
        }
        let refused = |field| move |error: ThermalError| (field, error.message());
        let warmth: Temperature = text(temperature).parse().map_err(refused(temperature))?;
        Ok(Some(Warm { temperature: warmth, expansion: text(expansion).parse().map_err(refused(expansion))? }))
    };
    let part = read(CheckField::PartTemperature, CheckField::PartExpansion)?;
    let scale = read(CheckField::ScaleTemperature, CheckField::ScaleExpansion)?;
    match (part, scale) {
        (None, Some(_)) => Err((CheckField::PartTemperature, message!("part-temperature-missing"))),
        (part, scale) => Ok(part.map(|part| (part, scale))),
    }
}

/// Mean, where it is given, and standard deviation in millimetres of what the process makes.
fn process(texts: &Texts<CheckField>) -> Result<Option<(Option<Length>, f64)>, Refusal> {
    let text = |field: CheckField| texts.text(field).trim();
    let mean = match text(CheckField::ProcessMean) {
        "" => None,
        mean => Some(Range::AboveZero.read(mean).map_err(|problem| (CheckField::ProcessMean, problem))?),
    };
    let spread = text(CheckField::ProcessSpread);
    if spread.is_empty() {
        return Ok(None);
    }
    let refused = |problem| (CheckField::ProcessSpread, problem);
    let read = Length::parse_in(spread, Unit::Micrometre).map_err(|error| refused(error.message()))?;
    if read <= Length::ZERO {
        return Err(refused(message!("process-spread-wrong").text("given", spread)));
    }
    Ok(Some((mean, read.to_mm_f64())))
}

/// What a record was judged by, as it stands in the fields: the choices and the texts.
pub(super) fn of_record(record: &Record) -> (RuleChoice, Vec<(CheckField, String)>) {
    let rule = record.verdict.rule;
    let RuleInputs { uncertainty, factor, width, prover } = *rule.given();
    let from = if record.budget.is_some() { UncertaintyFrom::Budget } else { UncertaintyFrom::Standard };
    let first = |field: CheckField| field.declared().1.to_owned();
    let texts = vec![
        // What the rule does not use leaves its field empty, or as it is at first.
        (CheckField::Uncertainty, uncertainty.map_or_else(String::new, Uncertainty::um)),
        (CheckField::Coverage, uncertainty.map_or_else(|| first(CheckField::Coverage), Uncertainty::k)),
        (CheckField::GuardFactor, factor.map_or_else(|| first(CheckField::GuardFactor), thousandths)),
        (CheckField::GuardWidth, width.map_or_else(String::new, |width| width.exact(Unit::Micrometre, 0))),
    ];
    (RuleChoice { rule: rule.name(), prover, from }, texts)
}

/// The temperatures of a record, as they stand in the fields.
pub(super) fn temperatures_of(record: &Record) -> Vec<(CheckField, String)> {
    let scale = record.correction.and_then(|correction| correction.scale);
    let [part_temperature, part_expansion, scale_temperature, scale_expansion] = OF_TEMPERATURE;
    let mut texts = Vec::new();
    for (temperature, expansion, warm) in [
        (part_temperature, part_expansion, record.correction.map(|correction| correction.part)),
        (scale_temperature, scale_expansion, scale),
    ] {
        // Where no temperature is known its field is empty, and the expansion stays as it is.
        texts.push((temperature, warm.map_or_else(String::new, |warm| warm.temperature.to_string())));
        texts.extend(warm.map(|warm| (expansion, warm.expansion.to_string())));
    }
    texts
}
