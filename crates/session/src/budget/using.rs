//! Which budget checks use, and the file in which it is found again at the next start.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::budget::template::Placeholder;
use fitcheck_core::budget::{Basis, Budget, Validity};
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::journal::chain::Hash;

use super::{BudgetDocument, BudgetPage, OpenBudget, Readings};
use crate::check::{RuleChoice, UncertaintyFrom, rule_name_id};
use crate::document::Document as _;
use crate::field_table::RULE_PART;
use crate::notice::Notice;
use crate::page::Page;
use crate::shared::{News, Shared};

/// Which budget checks use, seen from the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UseOf {
    /// None.
    Nothing,
    /// The one on the page, as it stands.
    This,
    /// Another one, or this one as it was before.
    Another,
}

/// What checks do with the budget in use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BudgetForce {
    /// It gives the uncertainty of each value.
    InForce,
    /// The uncertainty that is typed on the check page counts.
    TypedCounts,
    /// The rule on the check page is made of no uncertainty.
    RuleWithout,
}

impl BudgetForce {
    /// By how the next value is judged.
    pub(crate) fn of(judging: RuleChoice) -> Self {
        match judging.from {
            UncertaintyFrom::Budget if judging.rule.says_uncertainty() => Self::InForce,
            UncertaintyFrom::Budget => Self::RuleWithout,
            UncertaintyFrom::Standard | UncertaintyFrom::Expanded => Self::TypedCounts,
        }
    }
}

impl BudgetPage {
    /// The budget on the page as checks would use it: readings that were taken are part of it.
    fn usable(&self) -> Option<Budget> {
        let mut budget = self.read.as_ref()?.as_ref().ok()?.clone();
        if let (Basis::Calibrated(piece), Some(Readings { measured, .. })) = (&mut budget.basis, &self.readings) {
            piece.readings.clone_from(measured);
        }
        Some(budget)
    }

    /// Whether checks can use the budget on the page: a calibrated piece without readings says nothing.
    pub fn can_be_used(&self) -> bool {
        match &self.read {
            _ if !self.placeholders().is_empty() => false,
            Some(Ok(Budget { basis: Basis::Contributions(_), .. })) => true,
            Some(Ok(Budget { basis: Basis::Calibrated(_), .. })) => self.found().is_some(),
            _ => false,
        }
    }

    /// What of the template still stands in the budget: nobody has said it of this station.
    pub fn placeholders(&self) -> Vec<Message> {
        let Some(Ok(budget)) = &self.read else { return Vec::new() };
        let message = |what| match what {
            Placeholder::Name => message!("budget-page-placeholder-name").text("name", &budget.name),
            Placeholder::By => message!("budget-page-placeholder-by").text("by", &budget.by),
            Placeholder::Figures => message!("budget-page-placeholder-figures"),
        };
        budget.placeholders().into_iter().map(message).collect()
    }

    /// Which budget checks use.
    pub fn use_of(&self, used: Option<&OpenBudget>) -> UseOf {
        match used {
            None => UseOf::Nothing,
            Some(used) if self.usable().is_some_and(|budget| budget == used.budget) => UseOf::This,
            Some(_) => UseOf::Another,
        }
    }

    /// Checks use the budget on the page.
    pub(super) fn use_this(&mut self, shared: &mut Shared) {
        let Some(budget) = self.usable().filter(|_| self.can_be_used()) else { return };
        self.keep_file();
        let is_by_rule = shared.worth.judging.rule.says_uncertainty();
        let mut details = Vec::new();
        if self.used_file.is_none() {
            let has_readings = self.readings.is_some();
            let id = if has_readings { "budget-page-readings-not-kept" } else { "budget-page-not-kept" };
            details.push(Message::new(id));
        }
        details.extend(warnings(&budget, budget.validity(self.today)));
        // A rule without uncertainty did not use the typed one either.
        if let Some(typed) = shared.worth.typed_uncertainty().filter(|_| is_by_rule) {
            details.push(message!("budget-page-used-before").message("uncertainty", typed.rounded_message()));
        }
        // The page says which budget is in use, and that no rule uses it; a notice only tells what is not seen there.
        if !details.is_empty() {
            shared.notices.push(told(&budget, details, shared));
        }
        shared.budget = Some(Arc::new(OpenBudget { file: self.document.name(), budget, sha256: self.sha256() }));
        shared.spread(News::BudgetTaken);
    }

    /// SHA-256 of the file, where it holds what checks use.
    fn sha256(&self) -> Option<Hash> {
        self.document.sha256.filter(|_| self.used_file.is_some() && !self.document.is_unsaved())
    }

    /// The file is found again at the next start, if it holds what checks use.
    fn keep_file(&mut self) {
        self.used_file = self.document.file().filter(|_| self.readings.is_none()).map(Path::to_owned);
        self.awaits_used = false;
    }

    /// A budget that checks use has got a file.
    pub(super) fn used_is_saved(&mut self, shared: &mut Shared) {
        if self.use_of(shared.budget.as_deref()) == UseOf::This {
            self.keep_file();
            if let Some(used) = &shared.budget {
                let file = self.document.name();
                shared.budget = Some(Arc::new(OpenBudget { file, sha256: self.sha256(), budget: used.budget.clone() }));
            }
        } else if self.used_file.as_deref() == self.document.file() {
            // The file holds another budget now: at the next start it would be taken for the one in use.
            self.used_file = None;
        }
    }

    /// Checks use no budget any more.
    pub(super) fn leave(&mut self, shared: &mut Shared) {
        self.used_file = None;
        self.awaits_used = false;
        shared.budget = None;
        shared.spread(News::BudgetLeft);
    }

    /// The budget of the last time was read; it comes too late where another was chosen, or none.
    pub(super) fn used_read(&mut self, path: PathBuf, result: Result<String, Message>, shared: &mut Shared) {
        if !self.awaits_used || self.used_file.as_ref() != Some(&path) {
            return;
        }
        self.awaits_used = false;
        let shown = path.display().to_string();
        let document = result.map(|text| BudgetDocument::read(path, &text));
        let read = document.and_then(|document| match Budget::read(&document.text) {
            Ok(budget) => Ok((document, budget)),
            Err(error) => Err(error.message()),
        });
        match read {
            Ok((document, budget)) => {
                let warnings = warnings(&budget, budget.validity(self.today));
                if !warnings.is_empty() {
                    shared.notices.push(told(&budget, warnings, shared));
                }
                let sha256 = shared.recording.of_file(&document.name());
                shared.budget = Some(Arc::new(OpenBudget { file: document.name(), budget, sha256 }));
                shared.spread(News::Budget);
                // What was opened meanwhile stays.
                if *self.document == BudgetDocument::default() {
                    self.document.open(document);
                    self.opened();
                }
            }
            // A file that cannot be read now may be there the next time.
            Err(problem) => {
                shared.tell(message!("budget-page-used-unread").text("path", shown).message("problem", problem));
            }
        }
    }
}

/// That checks use a budget; or that they will, once the rule of the check page uses an uncertainty: it offers the rule.
fn told(budget: &Budget, details: Vec<Message>, shared: &Shared) -> Notice {
    let rule = shared.worth.judging.rule;
    if rule.says_uncertainty() {
        return Notice { details, ..Notice::of(message!("budget-page-used").text("name", &budget.name), false) };
    }
    let rule = Message::new(rule_name_id(rule));
    let waits = message!("budget-page-used-no-rule").text("name", &budget.name).message("rule", rule);
    Notice { details, page: Some(Page::Check), part: Some(RULE_PART), ..Notice::of(waits, false) }
}

/// What to check about a budget on a day.
fn warnings(budget: &Budget, validity: Validity) -> Vec<Message> {
    use fitcheck_core::budget::BudgetWarning;
    let day = match validity {
        Validity::Valid => None,
        Validity::Expired => Some(BudgetWarning::Expired { until: budget.valid_until.to_string() }.message()),
        Validity::NotYet => Some(BudgetWarning::NotYet { date: budget.date.to_string() }.message()),
    };
    let study = budget.failed_study.clone().map(|why| BudgetWarning::FailedStudy { why }.message());
    day.into_iter().chain(study).collect()
}
