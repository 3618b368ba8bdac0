//! Decision rules by their names, with what they need.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::verdict::Rule;
use fitcheck_core::verdict::rules::{Prover, RuleInputs, RuleName, Uncertainty, multiple};
use pyo3::prelude::*;

use crate::error::{refused, with_code};
use crate::given::text;

/// What a check is told of its rule, as Python gives it.
#[derive(Debug, Default)]
pub(crate) struct Told<'a, 'py> {
    pub(crate) rule: Option<&'a str>,
    pub(crate) u_um: Option<&'a Bound<'py, PyAny>>,
    pub(crate) expanded_um: Option<&'a Bound<'py, PyAny>>,
    pub(crate) k: Option<&'a Bound<'py, PyAny>>,
    pub(crate) factor: Option<&'a Bound<'py, PyAny>>,
    pub(crate) guard_um: Option<&'a Bound<'py, PyAny>>,
    pub(crate) prover: Option<&'a str>,
}

impl Told<'_, '_> {
    /// The rule; without a name the limits alone decide.
    pub(crate) fn rule(&self) -> PyResult<Rule> {
        let name = match self.rule {
            // By the limits alone the answer would look as if the uncertainty had counted.
            None if self.u_um.is_some() || self.expanded_um.is_some() => {
                let text = "rule: give the rule that uses the uncertainty, such as \"iso14253-2017\"; with \"simple\" the limits alone decide";
                return Err(with_code(text.to_owned(), "python-no-rule"));
            }
            None => RuleName::Simple,
            Some(word) => RuleName::ALL.into_iter().find(|rule| rule.word() == word).ok_or_else(|| {
                let known = RuleName::ALL.map(RuleName::word).join(", ");
                with_code(format!("rule: {word:?} is no rule; the rules are {known}"), "python-no-rule")
            })?,
        };
        let uncertainty = self.uncertainty()?;
        let factor = self.factor.map(|given| factor(given)).transpose()?;
        let width = self.guard_um.map(|given| {
            Length::parse_in(&text(given, "guard_um")?, Unit::Micrometre).map_err(|error| refused("guard_um", &error))
        });
        let prover = match self.prover {
            None | Some("supplier") => Prover::Supplier,
            Some("customer") => Prover::Customer,
            Some(word) => {
                let text = format!("prover: {word:?} is neither \"supplier\" nor \"customer\"");
                return Err(with_code(text, "python-no-prover"));
            }
        };
        let given = RuleInputs { uncertainty, factor, width: width.transpose()?, prover };
        Rule::new(name, given).map_err(|error| refused("rule", &error))
    }

    fn uncertainty(&self) -> PyResult<Option<Uncertainty>> {
        let k = match self.k {
            Some(_) if self.u_um.is_none() && self.expanded_um.is_none() => {
                return Err(with_code("k: give u_um or expanded_um with it".to_owned(), "python-k-alone"));
            }
            Some(k) => Uncertainty::factor(&text(k, "k")?).map_err(|error| refused("k", &error))?,
            None => 2_000,
        };
        match (self.u_um, self.expanded_um) {
            (Some(_), Some(_)) => {
                let text = "u_um and expanded_um both state the uncertainty; give one of them".to_owned();
                Err(with_code(text, "python-two-uncertainties"))
            }
            (Some(u), None) => {
                let u = Uncertainty::standard(&text(u, "u_um")?).map_err(|error| refused("u_um", &error))?;
                Ok(Some(u.covered(k)))
            }
            (None, Some(expanded)) => {
                let text = text(expanded, "expanded_um")?;
                Uncertainty::expanded(&text, k).map(Some).map_err(|error| refused("expanded_um", &error))
            }
            (None, None) => Ok(None),
        }
    }
}

/// By what the expanded uncertainty is multiplied, in thousandths.
fn factor(given: &Bound<'_, PyAny>) -> PyResult<u32> {
    let text = text(given, "factor")?;
    multiple(&text).filter(|factor| 0 < *factor).ok_or_else(|| {
        with_code(format!("factor: {text} is no multiple above 0 with at most three decimals"), "python-no-multiple")
    })
}
