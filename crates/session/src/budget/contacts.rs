//! Contacts that were really taken, for which a budget is evaluated.

use fitcheck_core::budget::{Geometry, GeometryError};
use fitcheck_core::message::{Message, message};
use fitcheck_exchange::journal::Record;

use crate::workpiece::RecordedContacts;

/// Contacts that were taken over, as they were then.
#[derive(Debug, Clone, PartialEq)]
pub struct TakenContacts {
    /// Whose they are.
    pub of: Message,
    /// What they do to the scatter of a touch.
    pub geometry: Geometry,
}

impl TakenContacts {
    /// Those of a check.
    pub(super) fn of_check(record: &Record) -> Result<Self, GeometryError> {
        let geometry = Geometry::of_contacts(&record.measurement.contacts)?;
        let callout = record.callout.map(|callout| callout.to_string());
        let what = std::iter::once(record.id.clone()).chain(callout).filter(|part| !part.is_empty());
        let is_simulated = record.measurement.origin.is_simulated();
        let id = if is_simulated { "budget-page-of-simulated-check" } else { "budget-page-of-check" };
        let of = Message::new(id)
            .count("count", geometry.touches)
            .text("what", what.collect::<Vec<_>>().join(", "))
            .text("time", record.time.time());
        Ok(Self { of, geometry })
    }

    /// Recorded ones.
    pub(super) fn recorded(recorded: &RecordedContacts) -> Result<Self, GeometryError> {
        let geometry = Geometry::of_contacts(&recorded.contacts)?;
        let of = message!("budget-page-of-recorded").count("count", geometry.touches).text("name", &recorded.name);
        Ok(Self { of, geometry })
    }
}
