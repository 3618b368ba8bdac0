//! How a subcommand judges measured values: by which rule, with which uncertainty, brought to 20 °C from which temperature.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use super::material::{WarmArgs, Warmth};
use super::rule::RuleArgs;
use super::{CliError, CliRemark, CliWarning, IntoCliError as _, Io};
use crate::budget::{Budget, BudgetWarning};
use crate::exchange::Labels;
use crate::journal::Record;
use crate::journal::planned::{self, JudgingOptions, Planned, PlannedError, PlannedRemark};
use crate::message::{IntoArg as _, Say as _};
use crate::part::{Plan, Size};
use crate::report::csv::More;
use crate::tolerance::Feature;
use crate::tolerance::fit::materials::Certainty;
use crate::tolerance::fit::thermal::{Correction, Temperature};
use crate::verdict::Rule;
use crate::verdict::rules::{RuleInputs, RuleName, Uncertainty};

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

/// Hole or shaft.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
pub(super) enum FeatureArg {
    /// An inner size.
    Hole,
    /// An outer size.
    Shaft,
}

impl FeatureArg {
    pub(super) const fn feature(self) -> Feature {
        match self {
            Self::Hole => Feature::Hole,
            Self::Shaft => Feature::Shaft,
        }
    }
}

/// Hole or shaft, where files do not say it.
#[derive(Debug, Clone, clap::Args)]
#[group(skip)]
pub(super) struct SaidArgs {
    /// Hole or shaft, for sizes that do not say it; what reaches down to zero, such as a flatness, stays neither
    #[arg(long, value_enum, conflicts_with = "plan")]
    feature: Option<FeatureArg>,
}

/// The sizes of a plan by the names of records; none without a plan.
#[derive(Debug, Default)]
pub(super) struct Sizes<'a>(BTreeMap<String, Size<'a>>);

impl<'a> Sizes<'a> {
    /// Of a plan, where there is one.
    pub(super) fn of(plan: Option<&'a Plan>) -> Self {
        Self(plan.into_iter().flat_map(Plan::sizes).map(|size| (size.name(), size)).collect())
    }

    /// Whether there is no plan.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Judges record after record.
#[derive(Debug)]
pub(super) struct Judge {
    rule: Rule,
    /// What the options say of the rule: a budget gives each record an uncertainty.
    options: RuleArgs,
    /// The rule where they name it, and what they give it; a plan may have another one.
    named: Option<RuleName>,
    given: RuleInputs,
    /// What sizes are that do not say it.
    feature: Option<Feature>,
    warmth: Option<Warmth>,
    /// A budget, which gives each record an uncertainty of its own, and its file.
    budget: Option<(String, Budget)>,
}

impl JudgeArgs {
    /// Reads what is needed to judge many records. With a budget the rule has an uncertainty of its own for each.
    pub(super) fn judge(&self, io: &mut Io<'_>) -> Result<Judge, CliError> {
        let warmth = self.warm.warmth()?;
        let options = self.rule.clone();
        let named = options.named();
        let given = options.given(None)?;
        let (rule, budget) = match &self.budget {
            None => (options.rule()?, None),
            // Any uncertainty shows whether the rule has what it needs.
            Some(path) => {
                (options.rule_with(Some(Uncertainty::standard("1").said()?))?, Some(super::budget::read(path, io)?))
            }
        };
        Ok(Judge { rule, options, named, given, feature: None, warmth, budget })
    }
}

impl Judge {
    /// The same with hole or shaft for sizes that do not say it.
    pub(super) fn with(self, said: &SaidArgs) -> Self {
        Self { feature: said.feature.map(FeatureArg::feature), ..self }
    }

    /// Which columns its records have besides those of every file. What contacts leave undecided is not among them: no file of
    /// measurements has the contacts of a check.
    pub(super) fn more(&self) -> More {
        More::default()
            .with(More::CORRECTED, self.warmth.is_some())
            .with(More::GUARDED, !self.rule.is_plain())
            .with(More::BUDGETED, self.budget.is_some())
    }

    /// The same of values that a plan has judged: it may have rules, too.
    pub(super) fn more_of(&self, plan: Option<&Plan>) -> More {
        let has_rule = |plan: &Plan| plan.features().iter().any(|feature| feature.rule.is_some());
        self.more().with(More::GUARDED, plan.is_some_and(has_rule))
    }

    /// Whether it judges as a control does.
    pub(super) fn is_plain(&self) -> bool {
        self.rule.is_plain() && self.warmth.is_none()
    }

    /// Whether it leaves the records of a file as they are.
    pub(super) fn keeps(&self) -> bool {
        self.is_plain() && self.feature.is_none()
    }

    /// A record by the plan where there is one and it is of a size of it, and what is to be warned of.
    ///
    /// # Errors
    /// Where it cannot be judged as the plan and the options say.
    pub(super) fn judged_of(
        &self,
        sizes: &Sizes<'_>,
        record: Record,
        labels: &Labels,
    ) -> Result<(Record, Vec<PlannedRemark>), CliError> {
        // Corrected from what the file does not say: it is not corrected again.
        if labels.is_corrected && self.warmth.is_some() {
            return Err(CliError::AlreadyCorrected);
        }
        let Some(size) = sizes.0.get(&record.id) else { return Ok((self.judged(record)?, Vec::new())) };
        let Planned { record, mut said } = self.judged_by_plan(size, record)?;
        said.retain(PlannedRemark::is_warning);
        Ok((record, said))
    }

    /// A record of a plan's size: the plan counts, and the options where it says nothing.
    fn judged_by_plan(&self, size: &Size<'_>, record: Record) -> Result<Planned, CliError> {
        let warm = self.warmth.as_ref().map(|warmth| (warmth.part.warm, warmth.scale));
        let budget = self.budget.as_ref().map(|(_file, budget)| budget);
        let beside = JudgingOptions { rule: self.named, given: self.given, budget, warm };
        planned::judge(size, record, &beside).map_err(|error| match (&error, &self.budget) {
            (PlannedError::Budget(_), Some((file, _))) => {
                CliError::About { what: file.as_str().arg(), error: error.message() }
            }
            (PlannedError::AlreadyCorrected, _) => CliError::AlreadyCorrected,
            _ => CliError::Said(error.message()),
        })
    }

    /// A record as it judges it.
    ///
    /// # Errors
    /// Where the budget gives no uncertainty for it.
    pub(super) fn judged(&self, record: Record) -> Result<Record, CliError> {
        let record = match self.feature {
            Some(feature) if record.lacks_feature() => record.of_feature(Some(feature)),
            _ => record,
        };
        let record = match &self.warmth {
            // A file of Fitcheck says how its values were corrected.
            Some(_) if record.correction.is_some() => return Err(CliError::AlreadyCorrected),
            Some(Warmth { part, scale, .. }) => {
                let measured = record.measurement.diameter;
                record.corrected(Correction::new(measured, part.warm, *scale))
            }
            None => record,
        };
        let Some((name, budget)) = &self.budget else {
            return Ok(if self.rule == record.verdict.rule { record } else { record.by(self.rule) });
        };
        let (found, uncertainty) = record.assess(budget.clone()).about(name)?;
        Ok(record.by_budget(self.options.rule_with(Some(uncertainty))?, Arc::new(found.provenance())))
    }

    /// From which temperature values are brought to 20 °C.
    pub(super) fn temperature(&self) -> Option<Temperature> {
        self.warmth.as_ref().map(|warmth| warmth.part.warm.temperature)
    }

    /// Says once how all records are brought to 20 °C and by which budget they are judged.
    pub(super) fn tell(&self, io: &mut Io<'_>) {
        if let Some(Warmth { part, scale, doubts }) = &self.warmth {
            io.remark(&CliRemark::CorrectedAll {
                temperature: part.warm.temperature,
                material: part.name.clone().unwrap_or_else(|| "none".to_owned()),
                expansion: part.warm.expansion,
            });
            if let Some(scale) = scale {
                io.remark(&CliRemark::Scales { temperature: scale.temperature, expansion: scale.expansion });
            }
            for doubt in doubts {
                io.warn(doubt);
            }
            if part.certainty == Certainty::Verify {
                io.warn(&CliWarning::ExpansionUnconfirmed { expansion: part.warm.expansion });
            }
        }
        if let Some((_file, budget)) = &self.budget {
            let Budget { name, date, valid_until, .. } = budget;
            let name = name.clone();
            let date = date.to_string();
            let until = valid_until.to_string();
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
