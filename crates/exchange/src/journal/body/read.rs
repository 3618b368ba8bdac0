//! An entry from the fields of a body: nothing is taken as it comes.

use std::sync::Arc;

use fitcheck_core::verdict::Status;

use super::texts::{
    bounded, length, long, name, of_contacts, of_fractions, printed, seed, some_length, two_lengths, whole,
};
use super::{BodyError, size, version_of, wire};
use crate::journal::chain::Head;
use crate::journal::entry::{
    About, Begin, BlockKept, Check, Checked, Compared, Content, Correction, CycleCheck, CycleOrigin, DatumKept, Entry,
    FileRole, Moment, Reported, Shown, UsedFile,
};
use crate::journal::ranges::EntryRanges;

/// The first entry of a chain is its beginning: no check has a smaller number.
const FIRST_CHECK: u64 = 2;

/// Local time is nowhere further from UTC, minutes.
const LARGEST_OFFSET: u32 = 25 * 60 + 59;

/// The years that have a time: as far as calendars go here.
const TIMES: std::ops::RangeInclusive<i64> = -377_705_023_201_000..=253_402_207_200_999;

pub(super) fn entry(body: wire::Body) -> Result<Entry, BodyError> {
    let about = about(&body.about)?;
    let content = match (body.kind, body.begin, body.check, body.withdrawal, body.report, body.alarm) {
        (wire::BodyKind::Begin, Some(content), None, None, None, None) => Content::Begin(begin(&content)?),
        (wire::BodyKind::Check, None, Some(content), None, None, None) => Content::Check(Box::new(check(content)?)),
        (wire::BodyKind::Withdrawal, None, None, Some(content), None, None) => {
            Content::Withdrawal(corrects("withdrawal.reason", &content)?)
        }
        (wire::BodyKind::Report, None, None, None, Some(content), None) => Content::Report(report(content)?),
        (wire::BodyKind::Alarm, None, None, None, None, Some(content)) => {
            Content::Alarm(Box::new(super::alarms::read(&content)?))
        }
        _ => return Err(BodyError::Contradiction { field: "kind" }),
    };
    // An entry has one body: the same in another version would have another hash. Entries of version 3 were first written as 1.
    let version = version_of(&content);
    if version != body.v && (version, body.v) != (3, 1) {
        return Err(BodyError::Contradiction { field: "v" });
    }
    Ok(Entry { about, content })
}

fn report(report: wire::Report) -> Result<Reported, BodyError> {
    bounded("report.checks", &report.checks)?;
    let checks = EntryRanges::read(report.checks).ok_or(BodyError::Contradiction { field: "report.checks" })?;
    let head = report.head.as_ref().map(|wire::Last { number, hash }| {
        Ok(Head { number: whole("report.head.number", *number)?, hash: printed("report.head.hash", hash)? })
    });
    let shown = Shown { checks, unrecorded: whole("report.unrecorded", report.unrecorded)?, head: head.transpose()? };
    sound_report(&report.name, &report.format, &shown)?;
    Ok(Reported {
        name: name("report.name", &report.name)?,
        format: name("report.format", &report.format)?,
        sha256: printed("report.sha256", &report.sha256)?,
        bytes: whole("report.bytes", report.bytes)?,
        title: name("report.title", &report.title)?,
        shown,
    })
}

/// What holds of every report: its file has a name without a folder and a format, and its checks were recorded before it was made.
pub(super) fn sound_report(name: &str, format: &str, shown: &Shown) -> Result<(), BodyError> {
    for (field, text) in [("report.name", name), ("report.format", format)] {
        if text.trim().is_empty() {
            return Err(BodyError::Empty { field });
        }
    }
    if name.contains('/') {
        return Err(BodyError::value("report.name", name));
    }
    let Shown { checks, head, .. } = shown;
    bounded("report.checks", checks.ranges())?;
    if head.is_some_and(|head| head.number == 0) {
        return Err(BodyError::value("report.head.number", 0));
    }
    if let Some([first, _]) = checks.ranges().first().filter(|[first, _]| *first < FIRST_CHECK) {
        return Err(BodyError::value("report.checks", first));
    }
    let known = head.map_or(0, |head| head.number);
    if checks.last().is_some_and(|last| known < last) {
        return Err(BodyError::Contradiction { field: "report.checks" });
    }
    Ok(())
}

/// Whether a time is one: the same when it is written.
pub(super) fn sound_time(time: &Moment) -> Result<(), BodyError> {
    if !TIMES.contains(&time.utc_ms) {
        return Err(BodyError::value("about.time.utc_ms", time.utc_ms));
    }
    if LARGEST_OFFSET < time.offset_min.unsigned_abs() {
        return Err(BodyError::value("about.time.offset_min", time.offset_min));
    }
    Ok(())
}

fn about(about: &wire::About) -> Result<About, BodyError> {
    let wire::Time { utc_ms, offset_min, zone } = &about.time;
    let time = Moment { utc_ms: *utc_ms, offset_min: *offset_min, zone: name("about.time.zone", zone)? };
    sound_time(&time)?;
    Ok(About {
        station: name("about.station", &about.station)?,
        time,
        who: name("about.who", &about.who)?,
        part: name("about.part", &about.part)?,
        serial: name("about.serial", &about.serial)?,
        feature: name("about.feature", &about.feature)?,
        remark: long("about.remark", &about.remark)?,
    })
}

fn begin(begin: &wire::Begin) -> Result<Begin, BodyError> {
    let after = begin.after.as_ref().map(|wire::After { chain, number, hash }| {
        let number = whole("begin.after.number", *number)?;
        Ok((printed("begin.after.chain", chain)?, Head { number, hash: printed("begin.after.hash", hash)? }))
    });
    Ok(Begin {
        chain: printed("begin.chain", &begin.chain)?,
        program: name("begin.program", &begin.program)?,
        after: after.transpose()?,
    })
}

fn corrects(field: &'static str, corrects: &wire::Corrects) -> Result<Correction, BodyError> {
    if corrects.reason.trim().is_empty() {
        return Err(BodyError::Empty { field });
    }
    if corrects.number == 0 {
        return Err(BodyError::value("corrects.number", corrects.number));
    }
    let number = whole("corrects.number", corrects.number)?;
    let target = Head { number, hash: printed("corrects.hash", &corrects.hash)? };
    Ok(Correction { target, reason: long(field, &corrects.reason)?, by: name("corrects.by", &corrects.by)? })
}

fn check(check: wire::Check) -> Result<Check, BodyError> {
    bounded("check.files", &check.files)?;
    let what = match (check.size, check.cycle) {
        (Some(of_size), None) => Checked::Size(Arc::new(size::record(&of_size)?)),
        (None, Some(of_cycle)) => Checked::Cycle(Box::new(cycle(&of_cycle, check.status)?)),
        _ => return Err(BodyError::Contradiction { field: "check.size" }),
    };
    let file = |file: &wire::File| {
        let role = FileRole::ALL.into_iter().find(|role| role.word() == file.role);
        Ok(UsedFile {
            role: role.ok_or_else(|| BodyError::value("check.files.role", &file.role))?,
            name: name("check.files.name", &file.name)?.into(),
            sha256: printed("check.files.sha256", &file.sha256)?,
        })
    };
    let files = check.files.iter().map(file).collect::<Result<_, BodyError>>()?;
    let corrects = check.corrects.as_ref().map(|one| corrects("check.corrects.reason", one)).transpose()?;
    let found = Check { what, files, corrects };
    // Both are there for whoever reads a body without Fitcheck.
    if found.status() != check.status {
        return Err(BodyError::Contradiction { field: "check.status" });
    }
    if found.is_simulated() != check.simulated {
        return Err(BodyError::Contradiction { field: "check.simulated" });
    }
    Ok(found)
}

fn datum(datum: &wire::Datum) -> Result<DatumKept, BodyError> {
    let [x, y, z] = datum.zero_nm.map(|nm| length("check.cycle.datum.zero_nm", nm));
    let set_by = match (datum.line, &datum.text) {
        (None, None) => None,
        (Some(line), Some(text)) => Some(block_of_datum(line, text)?),
        _ => return Err(BodyError::Contradiction { field: "check.cycle.datum.line" }),
    };
    let rotation = datum.rotation.as_ref().map(turn).transpose()?;
    let tilt = datum.tilt.as_ref().map(turn).transpose()?;
    Ok(DatumKept { zero: [x?, y?, z?], set_by, rotation: rotation.map(|([angle], by)| (angle, by)), tilt })
}

fn block_of_datum(line: u64, text: &str) -> Result<BlockKept, BodyError> {
    Ok(BlockKept { line: whole("check.cycle.datum.line", line)?, text: name("check.cycle.datum.text", text)? })
}

fn turn<const N: usize>(turn: &wire::Turn) -> Result<([f64; N], BlockKept), BodyError> {
    let field = "check.cycle.datum.degrees";
    let degrees = turn.degrees.clone().try_into().map_err(|_count| BodyError::Contradiction { field })?;
    Ok((of_fractions(field, &degrees)?, block_of_datum(turn.line, &turn.text)?))
}

fn cycle(cycle: &wire::Cycle, status: Option<Status>) -> Result<CycleCheck, BodyError> {
    bounded("check.cycle.parameters", &cycle.parameters)?;
    bounded("check.cycle.compared", &cycle.compared)?;
    let figures: Vec<_> = cycle.figures_nm.iter().collect();
    bounded("check.cycle.figures_nm", &figures)?;
    let figures = figures.into_iter().map(|(what, nm)| {
        let field = "check.cycle.figures_nm";
        Ok((name(field, what)?, length(field, *nm)?))
    });
    let parameters = cycle.parameters.iter().map(|[key, value]| {
        let field = "check.cycle.parameters";
        Ok((name(field, key)?, name(field, value)?))
    });
    let compared = cycle.compared.iter().map(|one| {
        Ok(Compared {
            what: name("check.cycle.compared.what", &one.what)?,
            measured: length("check.cycle.compared.measured_nm", one.measured_nm)?,
            minimum: length("check.cycle.compared.min_nm", one.min_nm)?,
            maximum: length("check.cycle.compared.max_nm", one.max_nm)?,
            status: one.status,
        })
    });
    let block = cycle.block.as_ref().map(|wire::Block { file, line }| {
        Ok((name("check.cycle.block.file", file)?, whole("check.cycle.block.line", *line)?))
    });
    let file = |file: &str| Ok::<_, BodyError>(name("check.cycle.origin.file", file)?.into());
    let limits = two_lengths("check.cycle.limits_nm", cycle.limits_nm)?;
    if limits.is_some_and(|[minimum, maximum]| maximum < minimum) {
        return Err(BodyError::Contradiction { field: "check.cycle.limits_nm" });
    }
    Ok(CycleCheck {
        cycle: cycle.number,
        parameters: parameters.collect::<Result<_, BodyError>>()?,
        origin: match &cycle.origin {
            wire::CycleOrigin::Perfect {} => CycleOrigin::Perfect,
            wire::CycleOrigin::Workpiece { file: of, seed: text } => {
                CycleOrigin::Workpiece { file: file(of)?, seed: seed("check.cycle.origin.seed", text)? }
            }
            wire::CycleOrigin::Contacts { file: of } => CycleOrigin::Contacts { file: file(of)? },
        },
        contacts: of_contacts("check.cycle.contacts_mm", &cycle.contacts_mm)?,
        figures: figures.collect::<Result<_, BodyError>>()?,
        compared: compared.collect::<Result<_, BodyError>>()?,
        limits,
        measured: some_length("check.cycle.measured_nm", cycle.measured_nm)?,
        status,
        block: block.transpose()?,
        datum: cycle.datum.as_ref().map(datum).transpose()?,
    })
}
