//! What was checked, when, with which limits and by which rule.
//!
//! A record holds the whole way from callout to verdict, so that a report made next year says the same as the screen
//! today.
//!
//! | file | what |
//! |---|---|
//! | here | a record |
//! | `entry` | a record with all that is kept beside it |
//! | `ranges` | numbers of entries, as a report names its checks |
//! | `body` | an entry as the bytes that are hashed and kept |
//! | `chain` | each entry hashed over the one before |
//! | `alarm` | a rule of a control chart fires, and what somebody says of it |
//! | `ask` | questions to a journal that lasts |
//! | `found` | what an entry is found by |
//! | `inspection` | whether a chain is whole, and where it breaks |
//! | `cycle` | what a measuring cycle found, as it is kept |
//! | `decision` | what the decision rule of a record says of its value |
//! | `query` | which records are listed, and in which order; where records are kept, as a trait |
//! | `memory` | records in memory |
//! | `natural` | texts in the order in which people count |
//! | `planned` | a value of a plan's size becomes a record: what the plan says, and what is given beside it |
//! | `window` | the status window of a record |
//!
//! To add a field to an entry:
//!
//! 1. Add it to `entry.rs`, or to the record here. The compiler names everybody who makes entries: command line, window, store, tests.
//! 2. Add it to `body/wire.rs` as optional, with `#[serde(default, skip_serializing_if = "Option::is_none")]`. Kept bodies then stay byte
//!    for byte the same; no body is ever written again.
//! 3. Add a line each to `body/write.rs` and `body/read.rs` (`body/size.rs` for a record), and a row to `docs/JOURNAL.md`.
//! 4. Raise `body::VERSION`: older versions of Fitcheck refuse a body with a field that they do not know. Every version up to it is read.
//!    A body gets the smallest version that can hold it (`body::version_of`): entries without the field are written as before.
//! 5. Leave the golden bodies of `tests/core/journal_body.rs` as they are and add new ones.
//! 6. Show it in `cli/journal/text.rs` and `gui/records/reasons.rs`; take it in `cli/record.rs`; correct it in `cli/journal/correct.rs`.
//! 7. Give it to the view of the server by a function of its own and as the last column (`store/shop/view.sql`).

mod alarm;
pub mod ask;
pub mod body;
pub mod chain;
mod cycle;
mod decision;
pub mod entry;
pub mod found;
pub mod inspection;
pub mod memory;
pub mod natural;
pub mod planned;
pub mod query;
pub mod ranges;
mod window;

use std::sync::Arc;

pub use alarm::{Alarm, AlarmAnswer};
pub use decision::Decision;
use fitcheck_core::budget::Provenance;
use fitcheck_core::length::Length;
use fitcheck_core::probing::{Caveat, Measurement, Origin, noted};
use fitcheck_core::tolerance::fit::thermal::Correction;
use fitcheck_core::tolerance::{Callout, Feature, Limits};
use fitcheck_core::verdict::{Doubt, PositionVerdict, Rule, Status, Verdict, doubt, judge, judge_by};
use jiff::civil::DateTime;
pub use window::{status_variables, status_window};

/// One check.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Local date and time of the check, or of the measurement where the file has one.
    pub time: DateTime,
    /// Name of the feature or part, where there is one.
    pub id: String,
    /// What was asked for; `None` where limits came from a log, which holds no class.
    pub callout: Option<Callout>,
    /// The limits that it was judged by.
    pub limits: Limits,
    /// What was measured.
    pub measurement: Measurement,
    /// The answer.
    pub verdict: Verdict,
    /// A measured value that may be another quantity or another part's.
    pub doubt: Option<Doubt>,
    /// How the diameter was brought to 20 °C, where it was: the measurement holds the result.
    pub correction: Option<Correction>,
    /// The budget that gave the uncertainty, where one did.
    pub budget: Option<Arc<Provenance>>,
}

impl Record {
    /// The same by another name.
    #[must_use]
    pub fn called(&self, name: &str) -> Arc<Self> {
        Arc::new(Self { id: name.to_owned(), ..self.clone() })
    }

    /// Checks a measurement, and the centre's position where it was measured, by the control's default rule; a value
    /// that may be another quantity or another part's gets a doubt.
    pub fn judged(
        time: DateTime,
        id: String,
        callout: Option<Callout>,
        limits: Limits,
        measurement: Measurement,
        position: Option<PositionVerdict>,
    ) -> Self {
        let measured = measurement.diameter;
        let verdict = judge(&limits, measured, position);
        let doubt = doubt(&limits, measured);
        Self { time, id, callout, limits, measurement, verdict, doubt, correction: None, budget: None }
    }

    /// What its measurement cannot tell, what it says against its limits, and what it leaves open of the notes of its callout.
    pub fn caveats(&self) -> Vec<Caveat> {
        let mut caveats = self.measurement.caveats_of(&self.limits.bounds());
        let noted = self.callout.map(|callout| noted::caveats(callout.notes(), &self.limits, &self.measurement));
        caveats.extend(noted.into_iter().flatten());
        caveats
    }

    /// The same, judged by a rule. An uncertainty that was given with it counts for contacts round the circle; where those that were
    /// taken are much worse, nothing is decided.
    #[must_use]
    pub fn by(mut self, rule: Rule) -> Self {
        self.verdict = self.judged_by(rule);
        self
    }

    /// What its own rule says of it today. A record that was kept may have been judged by another version.
    pub fn judged_again(&self) -> Verdict {
        self.judged_by(self.verdict.rule)
    }

    fn judged_by(&self, rule: Rule) -> Verdict {
        let verdict = judge_by(rule, &self.limits, self.measurement.diameter, self.verdict.position);
        match decision::undecided(rule, &self.measurement).filter(|_why| !self.budget_counts_contacts()) {
            Some(why) => verdict.left_undecided(why),
            None => verdict,
        }
    }

    /// The same with the budget that the rule's uncertainty is from: it counts for the contacts that were taken.
    #[must_use]
    pub fn by_budget(self, rule: Rule, budget: Arc<Provenance>) -> Self {
        Self { budget: Some(budget), ..self }.by(rule)
    }

    /// The same with another typed diameter, judged by its limits, its rule and its temperature; `None` where it was not typed. A budget
    /// counts as it did for the value before.
    pub fn typed_again(&self, diameter: Length) -> Option<Self> {
        let is_typed = self.measurement.origin == Origin::Typed;
        let measurement = Measurement::of_diameter(diameter, Origin::Typed);
        is_typed.then(|| self.again((self.callout, self.limits.clone()), measurement, diameter))
    }

    /// The same measurement against other limits, judged by its rule and its temperature.
    #[must_use]
    pub fn asked_again(&self, callout: Option<Callout>, limits: Limits) -> Self {
        self.again((callout, limits), self.measurement.clone(), self.measured())
    }

    /// Whether it is a size of which nobody has said hole or shaft. What reaches down to zero is a form or a coordinate.
    pub fn lacks_feature(&self) -> bool {
        self.limits.feature.is_none() && Length::ZERO < self.limits.minimum()
    }

    /// Whether hole or shaft decides between rework and scrap.
    pub fn is_open(&self) -> bool {
        self.lacks_feature() && self.verdict.status() == Status::OutOfLimits
    }

    /// The same as that of a hole, of a shaft or of neither.
    #[must_use]
    pub fn of_feature(&self, feature: Option<Feature>) -> Self {
        let mut limits = self.limits.clone();
        limits.feature = feature;
        self.asked_again(self.callout.map(|callout| callout.of_part(feature)), limits)
    }

    /// The diameter as it was measured: at the temperature of the part.
    pub fn measured(&self) -> Length {
        self.correction.map_or(self.measurement.diameter, |correction| correction.measured)
    }

    fn again(&self, (callout, limits): (Option<Callout>, Limits), measurement: Measurement, measured: Length) -> Self {
        let Self { time, id, verdict, correction, budget, .. } = self.clone();
        let record = Self::judged(time, id, callout, limits, measurement, verdict.position);
        let record = match correction {
            Some(old) => record.corrected(Correction::new(measured, old.part, old.scale)),
            None => record,
        };
        match budget {
            Some(budget) => record.by_budget(verdict.rule, budget),
            None => record.by(verdict.rule),
        }
    }

    /// The same with the diameter at 20 °C, judged again by its rule.
    #[must_use]
    pub fn corrected(mut self, correction: Correction) -> Self {
        self.measurement.diameter = correction.at_reference;
        // What a value may have been is said of the value as it was measured: it would be corrected once more.
        self.doubt = doubt(&self.limits, correction.measured)
            .filter(|doubt| doubt.meant().is_some())
            .or_else(|| doubt(&self.limits, correction.at_reference).filter(|doubt| doubt.meant().is_none()));
        self.correction = Some(correction);
        let rule = self.verdict.rule;
        self.by(rule)
    }
}
