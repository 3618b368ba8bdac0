//! A value of a size becomes a check: brought to 20 °C where a temperature is given, judged by the plan's rule, or else by the rule of the
//! check page.

use jiff::civil::DateTime;

use crate::journal::Record;
use crate::message::{Message, Say as _};
use crate::part::{Kind, Size};
use crate::probing::Measurement;
use crate::session::shared::Shared;

/// The check of a value that was measured here.
pub(super) fn judged(
    size: &Size<'_>,
    measurement: Measurement,
    shared: &Shared,
    now: DateTime,
) -> Result<(Record, Vec<Message>), Message> {
    let (measured, feature) = (measurement.diameter, size.feature);
    let material = feature.material.as_ref().map(|material| material.expansion);
    let correction = shared.worth.correction_of(measured, material);
    let record = Record::judged(now, size.name(), size.callout, size.limits.clone(), measurement, None);
    let mut remarks = Vec::new();
    let record = match (correction, &feature.kind) {
        (None, _) => record,
        // A place on the part has no size of its own that could grow.
        (Some(_), Kind::Face(..) | Kind::Point(..)) => {
            remarks.push(Message::new("walk-page-not-corrected"));
            record
        }
        (Some(correction), _) => {
            if let Some(material) = &feature.material {
                remarks.push(Message::new("walk-page-material").text("name", &material.name));
            }
            record.corrected(correction)
        }
    };
    let record = by_rule(size, record, shared)?;
    remarks.push(rule_said(size, &record));
    Ok((record, remarks))
}

/// The check of a value from a file: judged already by the plan's limits, and by the plan's rule where it has one. At which temperature it
/// was measured is not known.
pub(super) fn by_rule(size: &Size<'_>, record: Record, shared: &Shared) -> Result<Record, Message> {
    shared.worth.judge_by_plan(record, size.feature.rule, shared.budget.as_deref())
}

/// By which rule a check was judged, and whose it is.
pub(super) fn rule_said(size: &Size<'_>, record: &Record) -> Message {
    let id = if size.feature.rule.is_some() { "walk-page-rule-plan" } else { "walk-page-rule-own" };
    Message::new(id).message("rule", record.verdict.rule.message())
}
