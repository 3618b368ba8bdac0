//! A whole part: its answer, what it lacks, its picture, the table of its sizes, and what they rest on.

use fitcheck_core::message::{Say as _, message};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::card::Card;
use super::cells::Row;
use super::columns::Widths;
use super::flow::Flow;
use super::grounds::Grounds;
use super::head;
use super::look::GAP;
use super::pictures::Pictures;
use super::rows::Rows;
use super::table::Table;
use super::tags::TagId;
use crate::journal::Record;
use crate::report::origins::Entry;
use crate::report::part::PartSheet;
use crate::report::said::{beyond_limits, cause, decimals_of, lacks};
use crate::report::template::Section;
use crate::report::{Report, text};

/// What stands below a table usually, and is to be on the same page: what the verdicts rest on, and the signature.
const BELOW: f32 = 196.0;

/// So many sizes are named in the card; all of them are in the table.
const MOST_CAUSES: usize = 2;

/// The answer of a part.
pub(super) fn card(part: &PartSheet, words: &Words) -> Card {
    let standing = part.standing();
    let status = part.status();
    let is_accepted = status == Some(Status::Good) && beyond_limits(part).next().is_some();
    let word = match status {
        None => words.get("walk-page-not-complete"),
        Some(_) if is_accepted => words.get("status-accepted"),
        Some(status) => words.told(&status),
    };
    // What makes the part what it is, and what to do.
    let causes = part.sizes().filter_map(|(size, _, record)| {
        let verdict = &record?.verdict;
        let is_cause = Some(verdict.status()) == status && status != Some(Status::Good);
        is_cause.then(|| {
            if let Some(removal) = verdict.size.removal {
                let remove = message!("report-pdf-remove").text("name", size.name());
                return words.say(&remove.text("um", words.um(removal.to_limit)));
            }
            let why = cause(verdict, words).unwrap_or_else(|| words.say(&text::size(&verdict.size, words)));
            format!("{}: {why}", size.name())
        })
    });
    let causes: Vec<String> = causes.take(MOST_CAUSES).collect();
    Card {
        status,
        word,
        simulated: (0 < standing.simulated).then(|| words.get("simulated")),
        lines: causes.into_iter().chain([words.say(&standing.message())]).collect(),
        counts: Vec::new(),
    }
}

/// What stands on the first page before the values of a part.
pub(super) fn write_lacks(flow: &mut Flow<'_>, section: TagId, part: &PartSheet, words: &Words) {
    head::write_signals(flow, section, &lacks(part, words));
}

/// Writes the picture, the table and what it rests on.
pub(super) fn write(
    flow: &mut Flow<'_>,
    (section, report): (TagId, &Report),
    part: &PartSheet,
    (number, pictures): (usize, &Pictures),
    words: &Words,
) {
    let labels = labels(part);
    let decimals = part.sizes().flat_map(|(size, _, record)| {
        let measured = record.map(|record| record.measurement.diameter);
        [size.limits.minimum(), size.limits.maximum()].into_iter().chain(measured)
    });
    let rows = Rows { words, decimals: decimals.map(decimals_of).fold(3, usize::max), report };
    let all: Vec<(Row, Option<&Record>)> = part
        .sizes()
        .zip(&labels)
        .map(|((size, step, record), label)| {
            let record = record.map(AsRef::as_ref);
            (rows.size(label, &size, step, record), record)
        })
        .collect();
    let template = &report.template;
    let mut widths = Widths::new(flow.fonts, words, &template.columns);
    for (row, _) in &all {
        widths.see(flow.fonts, row);
    }
    let mut grounds = Grounds::new(words);
    for (row, record) in &all {
        if let Some(record) = record {
            grounds.see(&row.label, record);
        }
    }
    for shown in &template.sections {
        match shown {
            Section::Picture if template.has(Section::Features) => {
                let table = Table::new(flow, section, widths.clone().fit(flow.width()), words);
                let laid = all.iter().map(|(row, _)| table.lay(flow, row).height());
                let height = table.head_height() + laid.sum::<f32>();
                pictures.write(flow, section, part, (number, height + BELOW), words);
            }
            Section::Picture => pictures.write(flow, section, part, (number, BELOW), words),
            Section::Features => {
                let mut table = Table::new(flow, section, widths.clone().fit(flow.width()), words);
                table.begin(flow);
                for (row, _) in &all {
                    let laid = table.lay(flow, row);
                    table.row(flow, laid);
                }
                flow.y += GAP;
            }
            Section::Remarks if !part.plan.head.remark.is_empty() => {
                let remark = part.plan.head.remark.clone();
                let entry = Entry { label: words.get("parts-page-head-remark"), value: remark };
                head::write_sentences(flow, section, &[entry]);
            }
            Section::Rule | Section::Caveats => grounds.write(flow, section, *shown),
            _ => {}
        }
    }
}

/// The numbers of the sizes: those of their balloons, or the places of their features in the plan.
fn labels(part: &PartSheet) -> Vec<String> {
    let features = (1_usize..).zip(part.plan.features());
    let label = |(place, feature): (usize, &fitcheck_core::part::PlanFeature)| {
        let label = if feature.number.is_empty() { place.to_string() } else { feature.number.clone() };
        vec![label; feature.sizes().count()]
    };
    features.flat_map(label).collect()
}
