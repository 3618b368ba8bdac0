//! The answer on a label, for a printer beside the machine: verdict, part, serial number, date, and the code of the record.

use fitcheck_core::words::Words;

use super::card::Card;
use super::code::Code;
use super::flow::{Flow, base};
use super::fonts::ELLIPSIS;
use super::look::{Style, TEXT, VALUE, WORD};
use super::sheet::{Area, Edge, Shape};
use super::signs::Sign;
use super::tags::{Kind, Tags};
use crate::report::template::Section;
use crate::report::{Report, head};

/// From the edge of the label.
const SIDE: f32 = 6.0;

/// Writes the label. Printers of labels have one colour: the verdict is its word and its sign, and what is simulated has a dashed frame.
pub(super) fn write(
    flow: &mut Flow<'_>,
    report: &Report,
    (card, is_simulated, first): (&Card, bool, Vec<String>),
    words: &Words,
) {
    let [width, height] = flow.size();
    let newest = report.journal.as_ref().and_then(|journal| journal.newest);
    let newest = newest.filter(|_| report.template.has(Section::Code));
    let mut right = width - SIDE;
    if let Some((head, code)) = newest.and_then(|head| Some((head, Code::of(&head.hash.to_string())?))) {
        let side = height - 2.0 * SIDE;
        code.write(flow, Area::new(right - side, SIDE, side, side), head.hash.to_string());
        right -= side + SIDE;
    }
    let room = right - SIDE;
    let section = flow.tags.add(Tags::ROOT, Kind::Section);
    let tall = height * 0.36;
    let word = if card.word.is_empty() { words.get("report-total") } else { card.word.clone() };
    let sign = tall * 0.8;
    let asked = flow.fonts.width(&word, WORD.weight, 1.0);
    let size = (tall * 0.86).min((room - sign - 4.0) / asked.max(0.1));
    let style = Style { size, ink: TEXT, ..WORD };
    let heading = flow.tags.add(section, Kind::Heading(1, word.clone()));
    let middle = [SIDE + sign / 2.0, SIDE + tall / 2.0];
    flow.put(None, Shape::Sign { sign: Sign::of(card.status), middle, size: sign, ink: TEXT });
    flow.say(Some(heading), [SIDE + sign + 4.0, base(SIDE, tall, style)], style, format!("{word} "));
    let mut lines = Vec::new();
    if is_simulated {
        lines.push(words.get("simulated"));
        let edge = Edge { ink: TEXT, width: 1.2, is_dashed: true };
        let area = Area::new(2.0, 2.0, width - 4.0, height - 4.0);
        flow.put(None, Shape::Block { area, radius: 2.0, fill: None, edge: Some(edge) });
    }
    // What must be known comes before what the label is of.
    lines.extend(first);
    let known = lines.len();
    let entries = head::entries(report, words);
    lines.extend(entries.into_iter().map(|entry| entry.value).filter(|value| !value.is_empty()));
    if entries_lack_date(report) {
        lines.push(report.created.strftime(head::DATE).to_string());
    }
    let size =
        ((height - 2.0 * SIDE - tall) / 1.3 / super::cells::count(lines.len().max(1))).clamp(4.5, VALUE.size + 1.0);
    let style = Style { size, ink: TEXT, ..VALUE };
    let mut y = SIDE + tall;
    for (number, line) in (1..).zip(lines) {
        let fits = |y: f32| y + style.line() <= height - SIDE + 1.0;
        if !fits(y) {
            break;
        }
        // Where not all of it has room, that is seen.
        let line = if number < known && !fits(y + style.line()) { ELLIPSIS.to_string() } else { line };
        let element = flow.tags.add(section, Kind::Paragraph);
        let line = flow.wrap(&line, style, room, 1).concat();
        flow.say(Some(element), [SIDE, base(y, style.line(), style)], style, format!("{line} "));
        y += style.line();
    }
}

/// Whether the head of the template has no date: a label without one is worth nothing.
fn entries_lack_date(report: &Report) -> bool {
    !report.template.head.contains(&crate::report::template::HeadField::Date)
}
