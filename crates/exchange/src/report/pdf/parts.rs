//! A whole part: its answer, what it lacks, its picture, the table of its sizes, and what they rest on.

use fitcheck_core::message::{Say as _, message};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::card::Card;
use super::columns::Widths;
use super::flow::Flow;
use super::grounds::Grounds;
use super::head;
use super::look::{GAP, STRONG};
use super::pictures::Pictures;
use super::rows::Rows;
use super::table::{Row, Table};
use super::tags::TagId;
use crate::journal::Record;
use crate::report::origins::Entry;
use crate::report::part::PartSheet;
use crate::report::Report;
use crate::report::template::Section;
use crate::report::said::{beyond_limits, decimals_of, lacks};

/// What to remove is said in the card of so many sizes; of all of them in the table.
const MOST_REMOVED: usize = 2;

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
    let removed = part.sizes().filter_map(|(size, _, record)| {
        let removal = record?.verdict.size.removal?;
        Some(words.say(&message!("report-pdf-remove").text("name", size.name()).text("um", words.um(removal.to_limit))))
    });
    Card {
        status,
        word,
        simulated: (0 < standing.simulated).then(|| words.get("simulated")),
        lines: removed.take(MOST_REMOVED).chain([words.say(&standing.message())]).collect(),
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
            Section::Picture => pictures.write(flow, section, part, (number, all.len()), words),
            Section::Features => {
                let table = Table::begin(flow, section, widths.clone().fit(flow.width()), words);
                all.iter().for_each(|(row, _)| table.row(flow, row));
                table.end(flow);
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

/// The height of a table with so many rows, and of what stands below it, as far as it can be known before.
pub(super) fn height_of(rows: usize) -> f32 {
    super::table::count(rows) * 18.0 + 40.0 + 9.0 * STRONG.line() + GAP
}
