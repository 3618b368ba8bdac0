//! A value of a size becomes a check, as `journal::planned` judges it: by the plan, and by the check page where the plan says nothing.

use fitcheck_core::message::{Message, Say as _};
use fitcheck_core::part::Size;
use fitcheck_core::probing::Measurement;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::planned::{Planned, PlannedError, PlannedRemark, judge};
use jiff::civil::DateTime;

use crate::shared::Shared;

/// The check of a value that was measured here, and what is to be said of it.
pub(super) fn judged(
    size: &Size<'_>,
    measurement: Measurement,
    shared: &Shared,
    now: DateTime,
) -> Result<(Record, Vec<Message>), Message> {
    let record = Record::judged(now, size.name(), size.callout, size.limits.clone(), measurement, None);
    judged_by(size, record, false, shared)
}

/// The same of a value from a file, which has its own time and position; the file may say that it was brought to 20 °C.
pub(super) fn judged_by(
    size: &Size<'_>,
    record: Record,
    is_corrected: bool,
    shared: &Shared,
) -> Result<(Record, Vec<Message>), Message> {
    let beside = shared.worth.beside(size.feature, shared.budget.as_deref())?;
    if is_corrected && beside.warm.is_some() {
        return Err(PlannedError::AlreadyCorrected.message());
    }
    let planned = judge(size, record, &beside).map_err(|error| error.message())?;
    let mut said: Vec<Message> = planned.messages().collect();
    let Planned { record, said: remarks } = planned;
    // That another rule does not count tells the plan's, too.
    if !remarks.iter().any(|remark| matches!(remark, PlannedRemark::Rule { .. })) {
        said.push(rule_said(size, &record));
    }
    Ok((record, said))
}

/// By which rule a check was judged, and whose it is.
fn rule_said(size: &Size<'_>, record: &Record) -> Message {
    let id = if size.feature.has_own_rule { "walk-page-rule-plan" } else { "walk-page-rule-own" };
    Message::new(id).message("rule", record.verdict.rule.rounded_message())
}
