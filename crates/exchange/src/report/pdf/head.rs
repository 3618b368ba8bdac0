//! The head of the first page: what the report is about, the answer, and what a reader must know before anything else.

use fitcheck_core::message::message;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::card::{Card, Count};
use super::flow::{Flow, base};
use super::look::{GAP, LABEL, SIDE, STRONG, SUBTITLE, TEXT, TITLE};
use super::sheet::Shape;
use super::tags::{Kind, TagId, Tags};
use crate::report::Report;
use crate::report::origins::Entry;
use crate::report::part::PartSheet;
use crate::report::seen::ReportSurvey;

/// How dates are written: the same in every language, so that nobody mistakes the day for the month.
pub(super) const DATE: &str = "%Y-%m-%d %H:%M:%S";

/// The share of the width that the card has.
const CARD: f32 = 0.43;
/// The columns of labels and values beside the card.
const COLUMNS: u8 = 3;

/// The title of the report.
pub(super) fn title(report: &Report, words: &Words) -> String {
    if report.title.is_empty() { words.get("report-title") } else { report.title.clone() }
}

/// Writes title, and what the report is about.
pub(super) fn write_title(flow: &mut Flow<'_>, title: &str, about: &str) {
    let plain: String = title.chars().take(MOST_NAME).collect();
    let heading = flow.tags.add(Tags::ROOT, Kind::Heading(1, plain));
    // The sign of what is simulated has its place on the right.
    let lines = flow.wrap(title, TITLE, flow.width() - 120.0, 3);
    flow.lines(heading, SIDE, TITLE, lines);
    if !about.is_empty() {
        let element = flow.tags.add(Tags::ROOT, Kind::Paragraph);
        let lines = flow.wrap(about, SUBTITLE, flow.width(), 3);
        flow.lines(element, SIDE, SUBTITLE, lines);
    }
    flow.y += GAP - 2.0;
}

/// The most signs of a name where it is only said, such as in the outline.
pub(super) const MOST_NAME: usize = 300;

/// Writes the card, and labels with their values beside it.
pub(super) fn write_card(flow: &mut Flow<'_>, section: TagId, card: &Card, entries: &[Entry]) {
    let top = flow.y;
    let width = if entries.is_empty() { flow.width() } else { flow.width() * CARD };
    let height = card.draw(flow, section, width);
    let left = SIDE + width + 16.0;
    let column = (flow.right() - left) / f32::from(COLUMNS);
    let mut y = top + 1.0;
    for row in entries.chunks(COLUMNS.into()) {
        let mut lowest = y;
        let mut x = left;
        for entry in row {
            let element = flow.tags.add(section, Kind::Paragraph);
            flow.say(Some(element), [x, base(y, LABEL.line(), LABEL)], LABEL, format!("{} ", entry.label));
            let mut down = y + LABEL.line();
            for line in flow.wrap(&entry.value, STRONG, column - 8.0, 3) {
                flow.say(Some(element), [x, base(down, STRONG.line(), STRONG)], STRONG, line);
                down += STRONG.line();
            }
            lowest = lowest.max(down);
            x += column;
        }
        y = lowest + 5.0;
    }
    flow.y = (top + height).max(y - 5.0) + GAP - 2.0;
}

/// Writes what a reader must know before the values, with a bar on the left that is seen first.
pub(super) fn write_signals(flow: &mut Flow<'_>, section: TagId, signals: &[String]) {
    if signals.is_empty() {
        return;
    }
    let mut top = flow.y;
    let mut page = flow.page();
    for signal in signals {
        let element = flow.tags.add(section, Kind::Paragraph);
        for line in flow.wrap(signal, STRONG, flow.width() - 10.0, 6) {
            flow.room(STRONG.line());
            if page < flow.page() {
                (page, top) = (flow.page(), flow.y);
            }
            flow.say(Some(element), [SIDE + 10.0, base(flow.y, STRONG.line(), STRONG)], STRONG, line);
            flow.y += STRONG.line();
        }
    }
    let bar = SIDE + 2.0;
    flow.put(None, Shape::Line { from: [bar, top], to: [bar, flow.y], width: 3.0, ink: TEXT });
    flow.y += GAP - 2.0;
}

/// Writes labels with sentences, over the whole width.
pub(super) fn write_sentences(flow: &mut Flow<'_>, section: TagId, entries: &[Entry]) {
    for entry in entries {
        super::grounds::labelled(flow, section, &entry.label, std::slice::from_ref(&entry.value));
    }
    if !entries.is_empty() {
        flow.y += GAP / 2.0;
    }
}

/// What the report itself says in short: part, order, dates; the drawing where it is about one part.
pub(super) fn entries(report: &Report, words: &Words) -> Vec<Entry> {
    let created = report.created.strftime(DATE).to_string();
    let drawing = report.parts.first().map(|part| part.plan.head.drawing.clone()).filter(|name| !name.is_empty());
    [
        ("report-part", report.part.as_ref()),
        ("parts-page-head-drawing", drawing.as_ref()),
        ("report-order", report.order.as_ref()),
        ("report-inspector", report.inspector.as_ref()),
        ("report-created", Some(&created)),
        ("report-program", Some(&report.program)),
    ]
    .into_iter()
    .filter_map(|(id, value)| Some(Entry { label: words.get(id), value: value?.clone() }))
    .collect()
}

/// So many notes stand on the first page; more stand at the end, and the first page says so.
pub(super) const MOST_NOTES: usize = 6;

/// What is special about the checks, in numbers, and what the report notes.
pub(super) fn signals(report: &Report, seen: &ReportSurvey, words: &Words) -> Vec<String> {
    let mut counts = vec![
        ("report-pdf-corrected", seen.corrected),
        ("report-pdf-guarded", seen.guarded),
        ("report-pdf-doubted", seen.doubted),
    ];
    // Of parts both are told by name.
    if report.parts.is_empty() {
        counts.insert(0, ("report-pdf-simulated", seen.simulated));
        counts.insert(1, ("report-pdf-beyond", seen.beyond));
    }
    let said = |(id, count): (&'static str, usize)| {
        let message = fitcheck_core::message::Message::new(id).count("count", count).count("total", seen.total);
        words.say(&message)
    };
    let counted = counts.into_iter().filter(|(_, count)| 0 < *count).map(said);
    let notes = report.notes.len();
    let noted = (MOST_NOTES < notes).then(|| words.say(&message!("report-pdf-notes").count("count", notes)));
    let few = report.notes.iter().filter(|_| noted.is_none()).map(|note| words.say(note));
    seen.note(words).into_iter().chain(counted).chain(few).chain(noted.clone()).collect()
}

/// How many checks there are of each status.
pub(super) fn counts(seen: &ReportSurvey, words: &Words) -> Card {
    let counts = shown(seen.counts, words);
    let all = Count { status: None, word: words.get("report-total"), number: seen.total };
    Card { counts: counts.chain([all]).collect(), ..Card::default() }
}

/// The same of parts.
pub(super) fn counts_of_parts(parts: &[PartSheet], words: &Words) -> Card {
    let mut counts = [0; Status::ALL.len()];
    let mut none = 0;
    for part in parts {
        match part.status().and_then(|status| counts.get_mut(status.at())) {
            Some(count) => *count += 1,
            None => none += 1,
        }
    }
    let counts = shown(counts, words);
    let without = (0 < none).then(|| Count { status: None, word: words.get("walk-page-not-complete"), number: none });
    let all = Count { status: None, word: words.get("report-total"), number: parts.len() };
    Card { counts: counts.chain(without).chain([all]).collect(), ..Card::default() }
}

fn shown(counts: [usize; Status::ALL.len()], words: &Words) -> impl Iterator<Item = Count> {
    Status::ALL.into_iter().zip(counts).filter_map(|(status, count)| {
        // Nothing is re-measured without a guard band, so a zero would only raise questions.
        let is_shown = status != Status::ReMeasure || 0 < count;
        is_shown.then(|| Count { status: Some(status), word: words.told(&status), number: count })
    })
}

/// A heading within the report.
pub(super) fn write_heading(flow: &mut Flow<'_>, section: TagId, text: &str) {
    let plain: String = text.chars().take(MOST_NAME).collect();
    let heading = flow.tags.add(section, Kind::Heading(2, plain));
    flow.room(super::look::HEADING.line() * 4.0);
    let lines = flow.wrap(text, super::look::HEADING, flow.width(), 3);
    flow.lines(heading, SIDE, super::look::HEADING, lines);
    flow.y += 4.0;
}
