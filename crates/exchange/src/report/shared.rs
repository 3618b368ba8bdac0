//! What all checks of a report have in common, for its head: the rule, the temperature and the budget are said there once.

use std::sync::Arc;

use fitcheck_core::budget::Provenance;
use fitcheck_core::message::message;
use fitcheck_core::tolerance::fit::thermal::Correction;
use fitcheck_core::verdict::Rule;
use fitcheck_core::verdict::rules::RuleInputs;
use fitcheck_core::words::Words;

use super::origins::{self, Entry};
use crate::journal::Record;

/// What every check so far has.
#[derive(Default)]
pub(super) struct Shared {
    /// Their rule; apart from the uncertainty where that is each one's own.
    rule: Option<Rule>,
    has_own_uncertainties: bool,
    /// A correction with their temperatures; the value is that of the first.
    correction: Option<Correction>,
    budget: Option<Arc<Provenance>>,
}

impl Shared {
    /// Looks at a check.
    pub fn see(&mut self, record: &Record, is_first: bool) {
        if is_first {
            let is_plain = record.verdict.rule.is_plain();
            self.rule = (!is_plain).then_some(record.verdict.rule);
            self.correction = record.correction;
            self.budget.clone_from(&record.budget);
            return;
        }
        let rule = record.verdict.rule;
        let is_alike =
            |one: &Rule| one.name() == rule.name() && apart_from_uncertainty(one) == apart_from_uncertainty(&rule);
        self.has_own_uncertainties |= self.rule.is_some_and(|one| one.uncertainty() != rule.uncertainty());
        self.rule = self.rule.filter(is_alike);
        let temperatures = |correction: Correction| (correction.part, correction.scale);
        let given = record.correction.map(temperatures);
        self.correction = self.correction.filter(|one| Some(temperatures(*one)) == given);
        if self.budget != record.budget {
            self.budget = None;
        }
    }

    /// The lines of the head.
    pub fn entries(&self, words: &Words) -> Vec<Entry> {
        let entry = |id: &str, value: String| Entry { label: words.get(id), value };
        let rule = self.rule.map(|rule| {
            if self.has_own_uncertainties {
                words.say(&rule.message_with(message!("report-own-uncertainty")))
            } else {
                origins::rule(rule, words)
            }
        });
        let correction = self.correction.map(|correction| {
            let part = correction.part;
            let said = message!("report-all-corrected").number("temperature", part.temperature);
            format!("{}; {}", words.say(&said.number("expansion", part.expansion)), origins::scales(&correction, words))
        });
        let budget = self.budget.as_ref().map(|budget| origins::budget(budget, words));
        let all = [("report-verdict-from", rule), ("report-temperature", correction), ("report-budget", budget)];
        all.into_iter().filter_map(|(id, value)| Some(entry(id, value?))).collect()
    }
}

fn apart_from_uncertainty(rule: &Rule) -> RuleInputs {
    RuleInputs { uncertainty: None, ..*rule.given() }
}
