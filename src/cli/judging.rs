//! How a subcommand judges measured values: by which rule, with which uncertainty, brought to 20 °C from which temperature.

use std::path::PathBuf;
use std::sync::Arc;

use super::material::{WarmArgs, Warmth};
use super::rule::RuleArgs;
use super::{CliError, CliRemark, CliWarning, Io, Refused as _};
use crate::budget::{Budget, BudgetWarning};
use crate::journal::Record;
use crate::report::csv::More;
use crate::tolerance::fit::materials::Certainty;
use crate::tolerance::fit::thermal::Correction;
use crate::verdict::Rule;
use crate::verdict::rules::Uncertainty;

/// By which rule a measured value is judged, and what is known of it.
#[derive(Debug, Clone, clap::Args)]
#[group(skip)]
pub(super) struct JudgeArgs {
    #[command(flatten)]
    pub(super) warm: WarmArgs,
    #[command(flatten)]
    pub(super) rule: RuleArgs,
    /// Uncertainty budget (TOML, see fitcheck budget) that gives uncertainty and coverage factor for the measured value
    #[arg(long, value_name = "FILE.toml", conflicts_with_all = ["u", "expanded", "k"], help_heading = "Decision rule")]
    pub(super) budget: Option<PathBuf>,
}

/// Judges record after record.
#[derive(Debug)]
pub(super) struct Judge {
    rule: Rule,
    warmth: Option<Warmth>,
    budget: Option<ByBudget>,
}

/// A rule whose uncertainty is each record's own.
#[derive(Debug)]
struct ByBudget {
    /// Its file.
    name: String,
    budget: Budget,
    rule: RuleArgs,
}

impl JudgeArgs {
    /// Reads what is needed to judge many records. With a budget the rule has an uncertainty of its own for each.
    pub(super) fn judge(&self, io: &mut Io<'_>) -> Result<Judge, CliError> {
        let warmth = self.warm.warmth()?;
        let Some(path) = &self.budget else { return Ok(Judge { rule: self.rule.rule()?, warmth, budget: None }) };
        // Any uncertainty shows whether the rule has what it needs.
        let rule = self.rule.rule_with(Some(Uncertainty::standard("1").said()?))?;
        let (name, budget) = super::budget::read(path, io)?;
        Ok(Judge { rule, warmth, budget: Some(ByBudget { name, budget, rule: self.rule.clone() }) })
    }
}

impl Judge {
    /// Which columns its records have besides those of every file. What contacts leave undecided is not among them: no file of
    /// measurements has the contacts of a check.
    pub(super) fn more(&self) -> More {
        More::default()
            .with(More::CORRECTED, self.warmth.is_some())
            .with(More::GUARDED, !self.rule.is_plain())
            .with(More::BUDGETED, self.budget.is_some())
    }

    /// Whether it judges as a control does.
    pub(super) fn is_plain(&self) -> bool {
        self.rule.is_plain() && self.warmth.is_none()
    }

    /// A record as it judges it.
    ///
    /// # Errors
    /// Where the budget gives no uncertainty for it.
    pub(super) fn judged(&self, record: Record) -> Result<Record, CliError> {
        let record = match &self.warmth {
            // A file of Fitcheck says how its values were corrected.
            Some(_) if record.correction.is_some() => return Err(CliError::AlreadyCorrected),
            Some(Warmth { part, scale }) => {
                let measured = record.measurement.diameter;
                record.corrected(Correction::new(measured, part.warm, *scale))
            }
            None => record,
        };
        let Some(ByBudget { name, budget, rule }) = &self.budget else {
            // The rule of a plan counts where no other one was asked for.
            return Ok(if self.rule.is_plain() { record } else { record.by(self.rule) });
        };
        let (found, uncertainty) = record.assess(budget.clone()).about(name)?;
        let rule = rule.rule_with(Some(uncertainty))?;
        Ok(record.by_budget(rule, Arc::new(found.provenance())))
    }

    /// Says once how all records are brought to 20 °C and by which budget they are judged.
    pub(super) fn tell(&self, io: &mut Io<'_>) {
        if let Some(Warmth { part, scale }) = &self.warmth {
            io.remark(&CliRemark::CorrectedAll {
                temperature: part.warm.temperature,
                material: part.name.clone().unwrap_or_else(|| "none".to_owned()),
                expansion: part.warm.expansion,
            });
            if let Some(scale) = scale {
                io.remark(&CliRemark::Scales { temperature: scale.temperature, expansion: scale.expansion });
            }
            if part.certainty == Certainty::Verify {
                io.warn(&CliWarning::ExpansionUnconfirmed { expansion: part.warm.expansion });
            }
        }
        if let Some(ByBudget { budget, .. }) = &self.budget {
            let Budget { name, date, valid_until, .. } = budget;
            let (name, date, until) = (name.clone(), date.to_string(), valid_until.to_string());
            io.remark(&CliRemark::Budget { name, date, until });
        }
    }

    /// Says the rule once, where no answer says it: nothing where it is the control's own.
    pub(super) fn tell_rule(&self, io: &mut Io<'_>) {
        if self.budget.is_some() {
            io.remark(&CliRemark::RuleByBudget { rule: self.rule });
        } else if !self.rule.is_plain() {
            io.remark(&CliRemark::Rule { rule: self.rule });
        }
    }
}

/// What was told of budgets: each warning once.
#[derive(Debug, Default)]
pub(super) struct Warned(Vec<BudgetWarning>);

impl Warned {
    /// Warns of what is new in a record.
    pub(super) fn see(&mut self, record: &Record, io: &mut Io<'_>) {
        for warning in record.budget.iter().flat_map(|budget| &budget.warnings) {
            if !self.0.contains(warning) {
                io.warn(warning);
                self.0.push(warning.clone());
            }
        }
    }
}
