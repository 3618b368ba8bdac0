//! The columns of a list. They must not change.

use super::inspected::HeadAnswer;
use crate::cli::Figure;
use crate::journal::entry::{Check, Checked, CycleCheck, Entry, Reported};
use crate::journal::{Alarm, Record};
use crate::length::Length;
use crate::report::csv::harmless;
use crate::row::position;
use crate::store::local::ListedEntry;
use crate::tolerance::fit::thermal::Correction;
use crate::verdict::Status;

row! {
    /// An entry of a list.
    pub(super) struct Line of(row: &ListedEntry) {
        station: Option<String> = name(&about(row)?.station),
        number: u64 = row.kept.head.number,
        time: Option<String> = Some(about(row)?.time.text()),
        who: Option<String> = name(&about(row)?.who),
        part: Option<String> = name(&about(row)?.part),
        serial: Option<String> = name(&about(row)?.serial),
        feature: Option<String> = name(&about(row)?.feature),
        callout: Option<String> = Some(record(row)?.callout?.to_string()),
        min_mm: Option<Figure> = Some(Figure::mm(limits(row)?[0], 3)),
        max_mm: Option<Figure> = Some(Figure::mm(limits(row)?[1], 3)),
        measured_mm: Option<Figure> = Some(Figure::mm(measured(row)?, 3)),
        rule: Option<&'static str> = Some(record(row)?.verdict.rule.name().word()),
        u_um: Option<Figure> = Some(Figure(record(row)?.verdict.rule.uncertainty()?.um())),
        status: Option<Status> = check(row)?.status(),
        origin: Option<String> = name(&origin(check(row)?)),
        correction_of: Option<u64> = Some(entry(row)?.corrects()?.target.number),
        hash: String = row.kept.head.hash.to_string(),
        simulated: Option<bool> = Some(check(row)?.is_simulated()),
        as_measured_mm: Option<Figure> = Some(Figure::mm(correction(row)?.measured, 3)),
        correction_um: Option<Figure> = Some(Figure::um(correction(row)?.change())),
        temperature_c: Option<Figure> = Some(Figure(correction(row)?.part.temperature.to_string())),
        expansion_um_per_m_k: Option<Figure> = Some(Figure(correction(row)?.part.expansion.to_string())),
        scale_temperature_c: Option<Figure> = Some(Figure(correction(row)?.scale?.temperature.to_string())),
        scale_expansion_um_per_m_k: Option<Figure> = Some(Figure(correction(row)?.scale?.expansion.to_string())),
        position: Option<&'static str> = Some(position(record(row)?.verdict.position?)),
        remeasure_reason: Option<String> = Some(record(row)?.verdict.undecided?.to_string());
        json:
        corrected_by: Option<u64> = row.corrected_by,
        remark: Option<String> = Some(about(row)?.remark.clone()).filter(|remark| !remark.is_empty()),
        error: Option<String> = Some(row.entry.as_ref().err()?.to_string()),
        #[serde(skip_serializing_if = "Option::is_none")]
        report: Option<ReportAnswer> = Some(ReportAnswer::of(entry(row)?.report()?)),
        #[serde(skip_serializing_if = "Option::is_none")]
        alarm: Option<AlarmEntry> = Some(AlarmEntry::of(entry(row)?.alarm()?)),
    }
}

object! {
    /// An alarm of a control chart, or the answer to one.
    pub(super) struct AlarmEntry of(alarm: &Alarm) {
        rule: &'static str = alarm.rule.word(),
        place: &'static str = alarm.place.word(),
        first: u64 = alarm.first,
        last: u64 = alarm.last,
        since: String = alarm.since.clone(),
        answers: Option<u64> = Some(alarm.answer.as_ref()?.target.number),
        cause: Option<String> = Some(alarm.answer.as_ref()?.cause.clone()),
        action: Option<String> = Some(alarm.answer.as_ref()?.action.clone()),
    }
}

object! {
    /// A file that was written.
    pub(super) struct ReportAnswer of(report: &Reported) {
        name: String = report.name.clone(),
        format: String = report.format.clone(),
        sha256: String = report.sha256.to_string(),
        bytes: u64 = report.bytes,
        title: String = report.title.clone(),
        check_count: u64 = report.shown.checks.count(),
        checks: Vec<[u64; 2]> = report.shown.checks.ranges().to_vec(),
        unrecorded: u64 = report.shown.unrecorded,
        head: Option<HeadAnswer> = report.shown.head.map(HeadAnswer::of),
    }
}

pub(super) fn entry(row: &ListedEntry) -> Option<&Entry> {
    row.entry.as_ref().ok()
}

fn about(row: &ListedEntry) -> Option<&crate::journal::entry::About> {
    entry(row).map(|entry| &entry.about)
}

pub(super) fn check(row: &ListedEntry) -> Option<&Check> {
    entry(row)?.check()
}

pub(super) fn record(row: &ListedEntry) -> Option<&Record> {
    match &check(row)?.what {
        Checked::Size(record) => Some(record),
        Checked::Cycle(_) => None,
    }
}

/// How a value was brought to 20 °C.
fn correction(row: &ListedEntry) -> Option<&Correction> {
    record(row)?.correction.as_ref()
}

fn cycle(row: &ListedEntry) -> Option<&CycleCheck> {
    match &check(row)?.what {
        Checked::Size(_) => None,
        Checked::Cycle(cycle) => Some(cycle),
    }
}

fn limits(row: &ListedEntry) -> Option<[Length; 2]> {
    let of_record = record(row).map(|record| [record.limits.minimum(), record.limits.maximum()]);
    of_record.or_else(|| cycle(row)?.limits)
}

pub(super) fn measured(row: &ListedEntry) -> Option<Length> {
    record(row).map(|record| record.measurement.diameter).or_else(|| cycle(row)?.measured)
}

/// Where a value comes from, in English.
pub(super) fn origin(check: &Check) -> String {
    match &check.what {
        Checked::Size(record) => record.measurement.origin.to_string(),
        Checked::Cycle(cycle) => format!("cycle {}, {}", cycle.cycle, cycle.origin),
    }
}

/// A text that somebody typed: no spreadsheet computes it.
fn name(text: &str) -> Option<String> {
    (!text.is_empty()).then(|| harmless(text))
}
