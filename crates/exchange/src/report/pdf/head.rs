//! The head of the first page: what the report is about, the answer, and what a reader must know before anything else.

use fitcheck_core::message::message;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::card::{Card, Count};
use super::flow::{Flow, base};
use super::look::{GAP, LABEL, NOTE, SIDE, STRONG, SUBTITLE, TEXT, TITLE};
use super::pictures::Pictures;
use super::sheet::{Area, Shape};
use super::tags::{Kind, TagId, Tags};
use crate::report::Report;
use crate::report::origins::Entry;
use crate::report::part::PartSheet;
use crate::report::seen::ReportSurvey;

/// The share of the width that the card has.
const CARD: f32 = 0.43;
/// The columns of labels and values beside the card.
const COLUMNS: u8 = 3;

/// Writes title, and what the report is about; on the right the company.
pub(super) fn write_title(
    flow: &mut Flow<'_>,
    (report, pictures): (&Report, &Pictures),
    [title, about]: [&str; 2],
    words: &Words,
) {
    let plain: String = title.chars().take(MOST_NAME).collect();
    let heading = flow.tags.add(Tags::ROOT, Kind::Heading(1, plain));
    let top = flow.y;
    let has_company = !report.template.company.name.is_empty() || pictures.logo.is_some();
    // The sign of what is simulated has its place on the right.
    let aside = if has_company { COMPANY } else { 120.0 };
    let lines = flow.wrap(title, TITLE, flow.width() - aside, 3);
    flow.lines(heading, SIDE, TITLE, lines);
    if !about.is_empty() {
        let element = flow.tags.add(Tags::ROOT, Kind::Paragraph);
        let lines = flow.wrap(about, SUBTITLE, flow.width() - aside, 3);
        flow.lines(element, SIDE, SUBTITLE, lines);
    }
    let left = flow.y;
    if has_company {
        flow.y = top + SIMULATED;
        write_company(flow, report, pictures);
    }
    flow.y = flow.y.max(left);
    if let Some(why) = &pictures.no_logo {
        flow.paragraph(Tags::ROOT, NOTE.in_ink(TEXT), &words.say(why));
    }
    flow.y += GAP - 2.0;
}

/// What the sign of what is simulated needs at the top.
const SIMULATED: f32 = 22.0;

/// The height of a logo, and its most width.
const LOGO: [f32; 2] = [34.0, 76.0];

/// Name and address up to the right edge, and the logo before them.
fn write_company(flow: &mut Flow<'_>, report: &Report, pictures: &Pictures) {
    let company = &report.template.company;
    let top = flow.y;
    let mut widest: f32 = 0.0;
    let address = company.address.iter().map(|line| (LABEL, line));
    let name = std::iter::once((STRONG, &company.name)).filter(|(_, name)| !name.is_empty());
    for (style, text) in name.chain(address) {
        let element = flow.tags.add(Tags::ROOT, Kind::Paragraph);
        for line in flow.wrap(text, style, COMPANY - LOGO[1] - 20.0, 2) {
            widest = widest.max(flow.fonts.width(&line, style.weight, style.size));
            let place = [flow.right(), base(flow.y, style.line(), style)];
            flow.say_to(Some(element), place, style, line);
            flow.y += style.line();
        }
    }
    let Some((number, drawable)) = pictures.logo.and_then(|number| Some((number, pictures.all.get(number)?))) else {
        return;
    };
    let width = (LOGO[0] / drawable.proportion().max(1e-4)).min(LOGO[1]);
    let gap = if 0.0 < widest { 10.0 } else { 0.0 };
    let area = Area::new(flow.right() - widest - gap - width, top, width, width * drawable.proportion());
    let place = Some((flow.page(), [area.x, area.y, area.width, area.height]));
    let said = if company.name.is_empty() { company.logo.clone() } else { company.name.clone() };
    let figure = flow.tags.add(Tags::ROOT, Kind::Figure(said, place));
    flow.put(Some(figure), Shape::Picture(area, number));
    flow.y = flow.y.max(area.bottom());
}

/// The width that the company has.
const COMPANY: f32 = 240.0;

/// The most signs of a name where it is only said, such as in the outline.
pub(super) const MOST_NAME: usize = 300;

/// Writes the card, and labels with their values beside it.
pub(super) fn write_card(flow: &mut Flow<'_>, section: TagId, card: Option<&Card>, entries: &[Entry]) {
    let top = flow.y;
    let width = if entries.is_empty() { flow.width() } else { flow.width() * CARD };
    let height = card.map_or(0.0, |card| card.draw(flow, section, width));
    let left = if card.is_some() { SIDE + width + 16.0 } else { SIDE };
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

/// So many notes stand on the first page; more stand at the end, and the first page says so.
pub(super) const MOST_NOTES: usize = 8;

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
    // A zero of what seldom comes would only raise questions.
    let told = Status::ALL.into_iter().zip(counts).filter(|(status, count)| !status.is_rare() || 0 < *count);
    told.map(|(status, count)| Count { status: Some(status), word: words.told(&status), number: count })
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
