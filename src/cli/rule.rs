//! The decision rule of a subcommand: its options, and what they make.

use super::args::one_of;
use super::{CliError, ErrorSubject, IntoCliError as _};
use crate::length::{Length, Unit};
use crate::verdict::Rule;
use crate::verdict::rules::{Prover, RuleInputs, RuleName, Uncertainty, UncertaintyError, multiple};

/// Which values are accepted when the measurement is uncertain.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Decision rule")]
pub(super) struct RuleArgs {
    /// Decision rule: the limits alone (simple, as on a control), or with a guard band; default: simple
    #[arg(long, value_name = "RULE", value_parser = one_of(RuleName::ALL, |rule| rule.word()))]
    rule: Option<RuleName>,
    /// Standard uncertainty of the measured value in µm
    #[arg(long, value_name = "UM", group = "uncertainty")]
    u: Option<String>,
    /// Expanded uncertainty in µm, instead of --u; it is divided by --k
    #[arg(long, value_name = "UM", group = "uncertainty")]
    expanded: Option<String>,
    /// Coverage factor of the expanded uncertainty; default: 2
    #[arg(long, value_name = "K", requires = "uncertainty")]
    k: Option<String>,
    /// Guard band as a multiple of the expanded uncertainty, for ilac-g8, asme-stringent and asme-relaxed; default: 1
    #[arg(long, value_name = "H")]
    factor: Option<String>,
    /// Guard band in µm, for the rule fixed
    #[arg(long, value_name = "UM")]
    guard: Option<String>,
    /// Burden of proof: the supplier proves conformity, or the customer proves nonconformity
    #[arg(long, value_name = "WHO", default_value = "supplier", value_parser = one_of(PROVERS, |prover| prover.0))]
    prover: (&'static str, Prover),
}

const PROVERS: [(&str, Prover); 2] = [("supplier", Prover::Supplier), ("customer", Prover::Customer)];

impl RuleArgs {
    /// The rule, and with it the uncertainty.
    pub(super) fn rule(&self) -> Result<Rule, CliError> {
        self.rule_with(None)
    }

    /// The same with the uncertainty of a budget instead of the options.
    pub(super) fn rule_with(&self, budget: Option<Uncertainty>) -> Result<Rule, CliError> {
        Rule::new(self.rule.unwrap_or(RuleName::Simple), self.given(budget)?)
            .about(&ErrorSubject::Option { name: "rule" })
    }

    /// Which rule they name.
    pub(super) const fn named(&self) -> Option<RuleName> {
        self.rule
    }

    /// What the options give a rule; the uncertainty of a budget instead of theirs.
    pub(super) fn given(&self, budget: Option<Uncertainty>) -> Result<RuleInputs, CliError> {
        let k = Uncertainty::factor(self.k.as_deref().unwrap_or("2")).about(&ErrorSubject::Option { name: "k" })?;
        let about = |name, read: Result<Uncertainty, UncertaintyError>| read.about(&ErrorSubject::Option { name });
        let uncertainty = match (&self.u, &self.expanded) {
            _ if budget.is_some() => budget,
            (Some(u), _) => Some(about("u", Uncertainty::standard(u))?.covered(k)),
            (None, Some(expanded)) => Some(about("expanded", Uncertainty::expanded(expanded, k))?),
            (None, None) => None,
        };
        let factor = self.factor.as_ref().map(|text| {
            let factor = multiple(text).filter(|factor| 0 < *factor);
            factor.ok_or(CliError::NotAMultiple { given: text.clone() }).about(&ErrorSubject::Option { name: "factor" })
        });
        let width = self
            .guard
            .as_ref()
            .map(|text| Length::parse_in(text, Unit::Micrometre).about(&ErrorSubject::Option { name: "guard" }));
        Ok(RuleInputs { uncertainty, factor: factor.transpose()?, width: width.transpose()?, prover: self.prover.1 })
    }
}
