//! What the decision rule of a record says of its value.

use super::Record;
use crate::budget::Geometry;
use crate::probing::Measurement;
use crate::verdict::rules::{Conformity, RuleName, Zones};
use crate::verdict::{Rule, Undecided};

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
        let (bounds, measured) = (self.limits.bounds(), self.measurement.diameter);
        let zones = rule.zones(&bounds);
        let is_decided = self.verdict.undecided.is_none();
        Some(Decision {
            zones,
            proven: zones.is_proven(measured).map(|is_proven| is_proven && is_decided),
            conformity: rule.conformity(&bounds, measured).filter(|_conformity| is_decided),
        })
    }
}

/// Why a given uncertainty decides nothing for these contacts; `None` where it counts. The limits themselves decide by the control's
/// own rule, whatever the uncertainty.
pub(super) fn undecided(rule: Rule, measurement: &Measurement) -> Option<Undecided> {
    rule.uncertainty().filter(|_uncertainty| rule.name() != RuleName::Simple)?;
    measurement.circle?;
    let geometry = Geometry::of_contacts(&measurement.contacts).ok()?;
    let (contacts, times) = (geometry.touches, geometry.times_even());
    (Undecided::MOST_TIMES < times).then_some(Undecided::Contacts { contacts, times })
}
