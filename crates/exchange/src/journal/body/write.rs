//! An entry as the fields of a body.

use fitcheck_core::budget::Provenance;
use fitcheck_core::length::Length;
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::tolerance::Limits;
use fitcheck_core::tolerance::fit::thermal::{self, Warm};
use fitcheck_core::verdict::rules::Uncertainty;
use fitcheck_core::verdict::{AxisPosition, Doubt, Rule, Undecided, Verdict};

use super::texts::{bounded, contacts, fractions, long, name, whole};
use super::{BodyError, version_of, wire};
use crate::journal::Record;
use crate::journal::chain::Head;
use crate::journal::entry::{
    About, Begin, BlockKept, Check, Checked, Content, Correction, CycleCheck, CycleOrigin, DatumKept, Entry, Reported,
    Shown, UsedFile,
};

pub(super) fn body(entry: &Entry) -> Result<wire::Body, BodyError> {
    let about = about(&entry.about)?;
    let v = version_of(&entry.content);
    let body =
        |kind| wire::Body { v, kind, about, begin: None, check: None, withdrawal: None, report: None, alarm: None };
    Ok(match &entry.content {
        Content::Begin(content) => wire::Body { begin: Some(begin(content)?), ..body(wire::BodyKind::Begin) },
        Content::Check(content) => wire::Body { check: Some(check(content)?), ..body(wire::BodyKind::Check) },
        Content::Withdrawal(content) => {
            let withdrawal = Some(corrects("withdrawal.reason", content)?);
            wire::Body { withdrawal, ..body(wire::BodyKind::Withdrawal) }
        }
        Content::Alarm(content) => {
            wire::Body { alarm: Some(super::alarms::written(content)?), ..body(wire::BodyKind::Alarm) }
        }
        Content::Report(content) => wire::Body { report: Some(report(content)?), ..body(wire::BodyKind::Report) },
    })
}

fn report(report: &Reported) -> Result<wire::Report, BodyError> {
    let Reported { name: file, format, sha256, bytes, title, shown } = report;
    super::read::sound_report(file, format, shown)?;
    let Shown { checks, unrecorded, head } = shown;
    let head = head.map(|Head { number, hash }| {
        Ok(wire::Last { number: whole("report.head.number", number)?, hash: hash.to_string() })
    });
    Ok(wire::Report {
        name: name("report.name", file)?,
        format: name("report.format", format)?,
        title: name("report.title", title)?,
        bytes: whole("report.bytes", *bytes)?,
        sha256: sha256.to_string(),
        checks: checks.ranges().to_vec(),
        unrecorded: whole("report.unrecorded", *unrecorded)?,
        head: head.transpose()?,
    })
}

fn about(about: &About) -> Result<wire::About, BodyError> {
    let time = &about.time;
    super::read::sound_time(time)?;
    Ok(wire::About {
        station: name("about.station", &about.station)?,
        time: wire::Time {
            utc_ms: time.utc_ms,
            offset_min: time.offset_min,
            zone: name("about.time.zone", &time.zone)?,
        },
        who: name("about.who", &about.who)?,
        part: name("about.part", &about.part)?,
        serial: name("about.serial", &about.serial)?,
        feature: name("about.feature", &about.feature)?,
        remark: long("about.remark", &about.remark)?,
    })
}

fn begin(begin: &Begin) -> Result<wire::Begin, BodyError> {
    let after = begin.after.map(|(chain, Head { number, hash })| {
        let number = whole("begin.after.number", number)?;
        Ok(wire::After { chain: chain.to_string(), number, hash: hash.to_string() })
    });
    Ok(wire::Begin {
        chain: begin.chain.to_string(),
        program: name("begin.program", &begin.program)?,
        after: after.transpose()?,
    })
}

fn corrects(field: &'static str, correction: &Correction) -> Result<wire::Corrects, BodyError> {
    let Correction { target: Head { number, hash }, reason, by } = correction;
    if reason.trim().is_empty() {
        return Err(BodyError::Empty { field });
    }
    if *number == 0 {
        return Err(BodyError::value("corrects.number", number));
    }
    let number = whole("corrects.number", *number)?;
    let hash = hash.to_string();
    let reason = long(field, reason)?;
    let by = name("corrects.by", by)?;
    Ok(wire::Corrects { number, hash, reason, by })
}

fn check(check: &Check) -> Result<wire::Check, BodyError> {
    bounded("check.files", &check.files)?;
    let (size, cycle) = match &check.what {
        Checked::Size(record) => (Some(size(record)?), None),
        Checked::Cycle(of_cycle) => (None, Some(cycle(of_cycle)?)),
    };
    let file = |file: &UsedFile| {
        let role = file.role.word().to_owned();
        let sha256 = file.sha256.to_string();
        Ok(wire::File { role, name: name("check.files.name", &file.name)?, sha256 })
    };
    Ok(wire::Check {
        status: check.status(),
        simulated: check.is_simulated(),
        size,
        cycle,
        files: check.files.iter().map(file).collect::<Result<_, BodyError>>()?,
        corrects: check.corrects.as_ref().map(|one| corrects("check.corrects.reason", one)).transpose()?,
    })
}

fn size(record: &Record) -> Result<wire::Size, BodyError> {
    Ok(wire::Size {
        id: name("check.size.id", &record.id)?,
        local_time: record.time.to_string(),
        callout: record.callout.map(|callout| callout.to_string()),
        limits: limits(&record.limits)?,
        measurement: measurement(&record.measurement)?,
        correction: record.correction.as_ref().map(correction),
        rule: rule(record.verdict.rule),
        budget: record.budget.as_deref().map(budget).transpose()?,
        verdict: verdict(&record.verdict)?,
        doubt: record.doubt.map(doubt),
    })
}

fn limits(limits: &Limits) -> Result<wire::Limits, BodyError> {
    Ok(wire::Limits {
        feature: limits.feature,
        nominal_nm: limits.nominal.nanometres(),
        upper_nm: limits.deviations.upper().nanometres(),
        lower_nm: limits.deviations.lower().nanometres(),
        min_nm: limits.minimum().nanometres(),
        max_nm: limits.maximum().nanometres(),
        source: wire::Source {
            text: long("check.size.limits.source.text", &limits.source.with_difference())?,
            range_nm: limits.source.range().map(|(over, to)| [over.nanometres(), to.nanometres()]),
        },
    })
}

fn measurement(measurement: &Measurement) -> Result<wire::Measurement, BodyError> {
    let file = |file: &str| name("check.size.measurement.origin.file", file);
    let circle = measurement.circle.map(|circle| {
        let numbers = [circle.x, circle.y, circle.diameter];
        fractions("check.size.measurement.circle_mm", numbers)
    });
    Ok(wire::Measurement {
        diameter_nm: measurement.diameter.nanometres(),
        centre_nm: measurement.centre.map(|centre| centre.map(Length::nanometres)),
        origin: match &measurement.origin {
            Origin::Simulated { cycle, seed } => wire::Origin::Simulated { cycle: *cycle, seed: seed.to_string() },
            Origin::Contacts { file: of } => wire::Origin::Contacts { file: file(of)? },
            Origin::Imported { file: of } => wire::Origin::Imported { file: file(of)? },
            Origin::ImportedSimulation { file: of } => wire::Origin::ImportedSimulation { file: file(of)? },
            Origin::Typed => wire::Origin::Typed {},
        },
        circle_mm: circle.transpose()?,
        contacts_mm: contacts("check.size.measurement.contacts_mm", &measurement.contacts)?,
    })
}

fn correction(correction: &thermal::Correction) -> wire::Correction {
    let warm = |warm: Warm| wire::Warm {
        temperature_c_thousandths: warm.temperature.thousandths(),
        expansion_um_per_m_k_thousandths: warm.expansion.thousandths(),
    };
    wire::Correction {
        measured_nm: correction.measured.nanometres(),
        at_20c_nm: correction.at_reference.nanometres(),
        part: warm(correction.part),
        scale: correction.scale.map(warm),
    }
}

fn rule(rule: Rule) -> wire::Rule {
    let given = rule.given();
    let (u_pm, k_thousandths) = given.uncertainty.map(Uncertainty::picometres).unzip();
    wire::Rule {
        name: rule.name().word().to_owned(),
        u_pm,
        k_thousandths,
        factor_thousandths: given.factor,
        width_nm: given.width.map(Length::nanometres),
        prover: given.prover,
    }
}

fn budget(budget: &Provenance) -> Result<wire::Budget, BodyError> {
    bounded("check.size.budget.warnings", &budget.warnings)?;
    let warnings = budget.warnings.iter().map(|warning| long("check.size.budget.warnings", &warning.to_string()));
    Ok(wire::Budget {
        name: name("check.size.budget.name", &budget.name)?,
        date: budget.date.to_string(),
        by: name("check.size.budget.by", &budget.by)?,
        valid_until: budget.valid_until.to_string(),
        counts_contacts: budget.counts_contacts,
        validity: budget.validity.word().to_owned(),
        warnings: warnings.collect::<Result<_, _>>()?,
    })
}

fn verdict(verdict: &Verdict) -> Result<wire::Verdict, BodyError> {
    let axis = |axis: AxisPosition| wire::Axis {
        deviation_nm: axis.deviation.nanometres(),
        tolerance_nm: axis.tolerance.map(Length::nanometres),
    };
    let undecided = verdict.undecided.map(|Undecided::Contacts { contacts, times }| {
        let field = "check.size.verdict.undecided.contacts";
        let contacts = u64::try_from(contacts).map_err(|_range| BodyError::value(field, contacts))?;
        Ok(wire::Undecided { contacts: whole(field, contacts)?, times_thousandths: times })
    });
    let removal = verdict.size.removal;
    Ok(wire::Verdict {
        size: verdict.size.status,
        to_limit_nm: removal.map(|removal| removal.to_limit.nanometres()),
        to_middle_nm: removal.map(|removal| removal.to_middle.nanometres()),
        position: verdict.position.map(|position| position.axes.map(axis)),
        undecided: undecided.transpose()?,
    })
}

fn doubt(doubt: Doubt) -> wire::Doubt {
    let nm = |length: Option<Length>| length.map(Length::nanometres);
    match doubt {
        Doubt::TimesInch { meant } => wire::Doubt::TimesInch { meant_nm: nm(meant) },
        Doubt::Inches { meant } => wire::Doubt::Inches { meant_nm: nm(meant) },
        Doubt::Double { meant } => wire::Doubt::Double { meant_nm: nm(meant) },
        Doubt::Half { meant } => wire::Doubt::Half { meant_nm: nm(meant) },
        Doubt::DecimalSign { meant } => wire::Doubt::DecimalSign { meant_nm: meant.nanometres() },
        Doubt::Far { distance } => wire::Doubt::Far { distance_nm: distance.nanometres() },
        Doubt::Implausible { lower, upper, meant } => {
            let (lower_nm, upper_nm) = (lower.nanometres(), upper.nanometres());
            wire::Doubt::Implausible { lower_nm, upper_nm, meant_nm: nm(meant) }
        }
    }
}

fn datum(datum: &DatumKept) -> Result<wire::Datum, BodyError> {
    let block = datum.set_by.as_ref().map(block_of_datum).transpose()?;
    let (line, text) = block.unzip();
    let rotation = datum.rotation.as_ref().map(|(angle, by)| turn([*angle], by)).transpose()?;
    let tilt = datum.tilt.as_ref().map(|(angles, by)| turn(*angles, by)).transpose()?;
    Ok(wire::Datum { zero_nm: datum.zero.map(Length::nanometres), line, text, rotation, tilt })
}

fn block_of_datum(block: &BlockKept) -> Result<(u64, String), BodyError> {
    Ok((whole("check.cycle.datum.line", block.line)?, name("check.cycle.datum.text", &block.text)?))
}

fn turn<const N: usize>(angles: [f64; N], by: &BlockKept) -> Result<wire::Turn, BodyError> {
    let (line, text) = block_of_datum(by)?;
    let degrees = fractions("check.cycle.datum.degrees", angles)?.to_vec();
    Ok(wire::Turn { degrees, line, text })
}

fn cycle(cycle: &CycleCheck) -> Result<wire::Cycle, BodyError> {
    bounded("check.cycle.parameters", &cycle.parameters)?;
    bounded("check.cycle.compared", &cycle.compared)?;
    let figures = cycle.figures.iter().map(|(what, length)| {
        let field = "check.cycle.figures_nm";
        Ok((name(field, what)?, length.nanometres()))
    });
    let figures: Vec<_> = figures.collect::<Result<_, BodyError>>()?;
    bounded("check.cycle.figures_nm", &figures)?;
    let parameters = cycle.parameters.iter().map(|(key, value)| {
        let field = "check.cycle.parameters";
        Ok([name(field, key)?, name(field, value)?])
    });
    let compared = cycle.compared.iter().map(|one| {
        Ok(wire::Compared {
            what: name("check.cycle.compared.what", &one.what)?,
            measured_nm: one.measured.nanometres(),
            min_nm: one.minimum.nanometres(),
            max_nm: one.maximum.nanometres(),
            status: one.status,
        })
    });
    let block = cycle.block.as_ref().map(|(file, line)| {
        let file = name("check.cycle.block.file", file)?;
        let line = whole("check.cycle.block.line", *line)?;
        Ok(wire::Block { file, line })
    });
    let file = |file: &str| name("check.cycle.origin.file", file);
    Ok(wire::Cycle {
        number: cycle.cycle,
        block: block.transpose()?,
        parameters: parameters.collect::<Result<_, BodyError>>()?,
        origin: match &cycle.origin {
            CycleOrigin::Perfect => wire::CycleOrigin::Perfect {},
            CycleOrigin::Workpiece { file: of, seed } => {
                wire::CycleOrigin::Workpiece { file: file(of)?, seed: seed.to_string() }
            }
            CycleOrigin::Contacts { file: of } => wire::CycleOrigin::Contacts { file: file(of)? },
        },
        contacts_mm: contacts("check.cycle.contacts_mm", &cycle.contacts)?,
        figures_nm: figures.into_iter().collect(),
        compared: compared.collect::<Result<_, BodyError>>()?,
        limits_nm: cycle.limits.map(|limits| limits.map(Length::nanometres)),
        measured_nm: cycle.measured.map(Length::nanometres),
        datum: cycle.datum.as_ref().map(datum).transpose()?,
    })
}
