//! The labelled lines at the head of every page for people: what the report is about, as far as its template shows it.

use std::collections::BTreeSet;

use fitcheck_core::words::Words;

use super::Report;
use super::origins::Entry;
use super::seen::ReportSurvey;
use super::template::{HeadField, Section};

/// How dates are written: the same in every language, so that nobody mistakes the day for the month.
pub(super) const DATE: &str = "%Y-%m-%d %H:%M:%S";

/// Those of HTML, Markdown and workbooks: the template's, date and program in any case, and what all checks have in common, which says the
/// temperature, too.
pub(super) fn whole(report: &Report, seen: &ReportSurvey, words: &Words) -> Vec<Entry> {
    let template = &report.template;
    let chosen = template.head.iter().copied().filter(|field| template.has(Section::Head) && *field != HeadField::Date);
    let fields = chosen.filter(|field| *field != HeadField::Temperature).chain([HeadField::Date]);
    let mut entries: Vec<Entry> = fields.filter_map(|field| entry(report, field, words)).collect();
    entries.push(Entry { label: words.get("report-program"), value: report.program.clone() });
    entries.extend(seen.shared.entries(words));
    entries
}

/// What the template shows and there is something to say of.
pub(super) fn entries(report: &Report, words: &Words) -> Vec<Entry> {
    report.template.head.iter().filter_map(|field| entry(report, *field, words)).collect()
}

fn entry(report: &Report, field: HeadField, words: &Words) -> Option<Entry> {
    let value = value(report, field, words).filter(|value| !value.is_empty())?;
    Some(Entry { label: words.get(field.text()), value })
}

fn value(report: &Report, field: HeadField, words: &Words) -> Option<String> {
    // Of several parts each has its own.
    let only = if let [only] = report.parts.as_slice() { Some(only) } else { None };
    let plan = report.parts.first().map(|part| &part.plan.head);
    if let Some(given) = report.given.get(&field) {
        return Some(given.clone());
    }
    match field {
        HeadField::Part => report.part.clone().or_else(|| plan.map(|head| head.part.clone())),
        HeadField::Drawing => plan.map(|head| head.drawing.clone()),
        HeadField::Serial => only.map(|part| part.serial().to_owned()),
        HeadField::Order => report.order.clone(),
        HeadField::Inspector => report.inspector.clone(),
        HeadField::Date => Some(report.created.strftime(DATE).to_string()),
        HeadField::Records => report.journal.as_ref().map(|journal| journal.numbers.clone()),
        HeadField::Material => {
            let materials = report.parts.first().into_iter().flat_map(|part| part.plan.features());
            let names: BTreeSet<&str> =
                materials.filter_map(|f| f.material.as_ref()).map(|m| m.name.as_str()).collect();
            Some(names.into_iter().collect::<Vec<_>>().join(", "))
        }
        HeadField::Temperature => {
            let warm =
                only?.records().filter_map(|record| record.correction.as_ref()).map(|correction| correction.part);
            let all: BTreeSet<String> = warm.map(|warm| words.number(&warm.temperature.to_string())).collect();
            Some(all.into_iter().map(|one| format!("{one} °C")).collect::<Vec<_>>().join(", "))
        }
        HeadField::Revision
        | HeadField::Batch
        | HeadField::Customer
        | HeadField::Station
        | HeadField::Instrument
        | HeadField::Calibrated
        | HeadField::Plan => None,
    }
}
