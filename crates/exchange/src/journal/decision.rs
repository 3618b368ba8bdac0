//! What the decision rule of a record says of its value.

use fitcheck_core::budget::{Assessment, AssessmentError, Budget, Conditions, Geometry, GeometryError};
use fitcheck_core::probing::Measurement;
use fitcheck_core::verdict::rules::{Conformity, RuleName, Uncertainty, Zones};
use fitcheck_core::verdict::{Rule, Undecided};

use super::Record;

/// What a rule says of a measured value besides its status.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decision {
    /// What the rule accepts and rejects.
    pub zones: Zones,
    /// Whether the status is proven; `None` where the rule proves nothing.
    pub proven: Option<bool>,
    /// The probability that the part conforms; `None` where the uncertainty is not known, or does not count for this value.
    pub conformity: Option<Conformity>,
}

impl Record {
    /// What its rule says of its value; `None` by the control's own rule without an uncertainty.
    pub fn decision(&self) -> Option<Decision> {
        let rule = self.verdict.rule;
        if rule.is_plain() {
            return None;
        }
        let bounds = self.limits.bounds();
        let measured = self.measurement.diameter;
        let zones = rule.zones(&bounds);
        // Where the centre decides, nothing is proven by the size.
        let is_by_size = self.verdict.status() == self.verdict.size.status;
        let is_decided = self.verdict.undecided.is_none();
        let counts = undecided_by_contacts(&self.measurement).is_none() || self.budget_counts_contacts();
        Some(Decision {
            zones,
            proven: zones.is_proven(measured).filter(|_proven| is_by_size).map(|is_proven| is_proven && is_decided),
            conformity: rule.conformity(&bounds, measured).filter(|_conformity| is_decided && counts && is_by_size),
        })
    }

    /// A budget for its value, its contacts and its day, and the uncertainty that a rule gets.
    ///
    /// # Errors
    /// [`AssessmentError`] where the budget gives none.
    pub fn assess(&self, budget: Budget) -> Result<(Assessment, Uncertainty), AssessmentError> {
        let found = Assessment::of(budget, &self.conditions()?, None, self.time.date())?;
        let uncertainty = found.uncertainty()?;
        Ok((found, uncertainty))
    }

    /// What a budget is evaluated for.
    ///
    /// # Errors
    /// [`GeometryError`] where its contacts make no circle.
    pub fn conditions(&self) -> Result<Conditions, GeometryError> {
        let geometry = match self.measurement.contacts.as_slice() {
            [] => None,
            contacts => Some(Geometry::of_contacts(contacts)?),
        };
        let size = Some(self.measurement.diameter);
        let feature = self.limits.feature;
        Ok(Conditions { size, geometry, feature, correction: self.correction })
    }

    /// Whether its uncertainty is that of the contacts that were taken.
    pub(super) fn budget_counts_contacts(&self) -> bool {
        self.budget.as_ref().is_some_and(|budget| budget.counts_contacts)
    }
}

/// Why a rule decides nothing for these contacts; `None` where it does. The limits themselves decide by the control's own rule.
pub(super) fn undecided(rule: Rule, measurement: &Measurement) -> Option<Undecided> {
    undecided_by_contacts(measurement).filter(|_why| rule.name() != RuleName::Simple)
}

/// The same whatever the rule.
fn undecided_by_contacts(measurement: &Measurement) -> Option<Undecided> {
    measurement.circle?;
    let geometry = Geometry::of_contacts(&measurement.contacts).ok()?;
    let contacts = geometry.touches;
    let times = geometry.times_even();
    (Undecided::MOST_TIMES < times).then_some(Undecided::Contacts { contacts, times })
}
