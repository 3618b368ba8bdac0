//! What an entry is found by, read from its body without judging it again: a million of them in seconds.

use std::borrow::Cow;

use fitcheck_core::verdict::Status;
use serde::Deserialize;

use super::{BodyError, wire};
use crate::journal::found::{EntryCallout, FoundEntry, FoundEntryKind, FoundReport};
use crate::journal::ranges::EntryRanges;

#[derive(Deserialize)]
struct Brief<'a> {
    kind: wire::BodyKind,
    #[serde(borrow)]
    about: About<'a>,
    #[serde(borrow)]
    check: Option<Check<'a>>,
    #[serde(borrow)]
    withdrawal: Option<Corrects<'a>>,
    #[serde(borrow)]
    report: Option<Report<'a>>,
    #[serde(borrow)]
    alarm: Option<Alarm<'a>>,
}

#[derive(Deserialize)]
struct Alarm<'a> {
    answers: Option<Answers>,
    #[serde(borrow)]
    cause: Cow<'a, str>,
    #[serde(borrow)]
    action: Cow<'a, str>,
}

#[derive(Deserialize)]
struct Answers {
    number: u64,
}

#[derive(Deserialize)]
struct Report<'a> {
    #[serde(borrow)]
    name: Cow<'a, str>,
    #[serde(borrow)]
    sha256: Cow<'a, str>,
    #[serde(borrow)]
    title: Cow<'a, str>,
    checks: Vec<[u64; 2]>,
}

impl<'a> Report<'a> {
    fn found(self) -> Result<FoundReport<'a>, BodyError> {
        let Self { name, sha256, title, checks } = self;
        super::texts::bounded("report.checks", &checks)?;
        let checks = EntryRanges::read(checks).ok_or(BodyError::Contradiction { field: "report.checks" })?;
        Ok(FoundReport { name, title, sha256: super::texts::printed("report.sha256", &sha256)?, checks })
    }
}

#[derive(Deserialize)]
struct About<'a> {
    #[serde(borrow)]
    station: Cow<'a, str>,
    time: Time,
    #[serde(borrow)]
    who: Cow<'a, str>,
    #[serde(borrow)]
    part: Cow<'a, str>,
    #[serde(borrow)]
    serial: Cow<'a, str>,
    #[serde(borrow)]
    feature: Cow<'a, str>,
    #[serde(borrow)]
    remark: Cow<'a, str>,
}

#[derive(Deserialize)]
struct Time {
    utc_ms: i64,
}

#[derive(Deserialize)]
struct Check<'a> {
    status: Option<Status>,
    simulated: bool,
    #[serde(borrow)]
    size: Option<Size<'a>>,
    cycle: Option<Cycle>,
    #[serde(borrow)]
    corrects: Option<Corrects<'a>>,
}

#[derive(Deserialize)]
struct Size<'a> {
    #[serde(borrow)]
    callout: Option<Cow<'a, str>>,
    limits: Limits,
    measurement: Measurement,
}

#[derive(Deserialize)]
struct Measurement {
    diameter_nm: i64,
}

#[derive(Deserialize)]
struct Cycle {
    measured_nm: Option<i64>,
}

#[derive(Deserialize)]
struct Limits {
    nominal_nm: i64,
}

#[derive(Deserialize)]
struct Corrects<'a> {
    number: u64,
    #[serde(borrow)]
    reason: Cow<'a, str>,
}

/// What an entry is found by; `None` for the first entry of a chain, which is no check.
///
/// # Errors
/// [`BodyError::Json`] where the bytes are no entry. What is found may still be one that [`read`](super::read) refuses.
pub fn found(bytes: &[u8]) -> Result<Option<FoundEntry<'_>>, BodyError> {
    let brief: Brief<'_> =
        serde_json::from_slice(bytes).map_err(|error| BodyError::Json { reason: error.to_string() })?;
    let kind = match brief.kind {
        wire::BodyKind::Begin => return Ok(None),
        wire::BodyKind::Check => FoundEntryKind::Check,
        wire::BodyKind::Withdrawal => FoundEntryKind::Withdrawal,
        wire::BodyKind::Report => FoundEntryKind::Report,
        wire::BodyKind::Alarm => FoundEntryKind::Alarm,
    };
    let report = brief.report.map(Report::found).transpose()?;
    if report.is_some() != (kind == FoundEntryKind::Report) {
        return Err(BodyError::Contradiction { field: "kind" });
    }
    if brief.alarm.is_some() != (kind == FoundEntryKind::Alarm) {
        return Err(BodyError::Contradiction { field: "kind" });
    }
    let About { station, time, who, part, serial, feature, remark } = brief.about;
    let (status, is_simulated, size, cycle, corrects) = match brief.check {
        Some(check) => (check.status, check.simulated, check.size, check.cycle, check.corrects),
        None => (None, false, None, None, None),
    };
    let of_size = size.as_ref().map(|size| size.measurement.diameter_nm);
    let measured_nm = of_size.or_else(|| cycle.and_then(|cycle| cycle.measured_nm));
    let asked = size.map(|size| EntryCallout { callout: size.callout, nominal_nm: size.limits.nominal_nm });
    let (corrects, reason) = match (corrects.or(brief.withdrawal), brief.alarm) {
        (Some(Corrects { number, reason }), _) => (Some(number), reason),
        (None, Some(Alarm { answers: Some(Answers { number }), cause, action })) => {
            (Some(number), Cow::Owned(format!("{cause}; {action}")))
        }
        (None, _) => (None, Cow::Borrowed("")),
    };
    let at_ms = time.utc_ms;
    Ok(Some(FoundEntry {
        kind,
        at_ms,
        status,
        is_simulated,
        part,
        serial,
        feature,
        who,
        station,
        remark,
        asked,
        measured_nm,
        corrects,
        reason,
        report,
    }))
}
