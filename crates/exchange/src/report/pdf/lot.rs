//! Several parts on one page, the worst first: each with its verdict, and how many of its sizes were measured, are missing, left out or simulated.

use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::flow::{Flow, base};
use super::look::{CELL, CHIP, GAP, LABEL, LINE, NOTE, SIDE, TEXT, VALUE, tone};
use super::sheet::{Area, Edge, Shape};
use super::signs::Sign;
use super::tags::{Kind, TagId};
use crate::report::part::PartSheet;
use crate::report::said::heading;

/// The height of a row.
const ROW: f32 = 18.0;
/// The columns of numbers, from the right.
const NUMBERS: [&str; 4] = ["report-measured", "report-missing", "report-skipped", "simulated"];
/// The width of a number, and of a verdict.
const NUMBER: f32 = 58.0;
const VERDICT: f32 = 120.0;

/// Writes the table.
pub(super) fn write(flow: &mut Flow<'_>, section: TagId, parts: &[PartSheet], words: &Words) {
    let table = flow.tags.add(section, Kind::Table);
    let head = flow.tags.add(table, Kind::TableHead);
    let row = flow.tags.add(head, Kind::Row);
    let body = flow.tags.add(table, Kind::TableBody);
    head_row(flow, Some(row), words);
    let mut all: Vec<&PartSheet> = parts.iter().collect();
    // Parts that are alike keep their order.
    all.sort_by_key(|part| badness(part));
    for part in all {
        if flow.room(ROW) {
            head_row(flow, None, words);
        }
        let row = flow.tags.add(body, Kind::Row);
        part_row(flow, row, part, words);
    }
    flow.y += GAP / 2.0;
    if 1 < parts.len() {
        flow.paragraph(section, NOTE, &words.get("report-lot-order"));
    }
    flow.y += GAP / 2.0;
}

/// How bad a part is: one without a verdict comes after the bad ones and before the good ones.
fn badness(part: &PartSheet) -> u8 {
    match part.status() {
        Some(Status::Scrap) => 0,
        Some(Status::OutOfLimits) => 1,
        Some(Status::ReMeasure) => 2,
        Some(Status::Rework) => 3,
        None => 4,
        Some(Status::Good) => 5,
    }
}

/// Where the verdicts begin.
fn verdicts(flow: &Flow<'_>) -> f32 {
    numbers(flow) - VERDICT
}

/// Where the numbers begin.
fn numbers(flow: &Flow<'_>) -> f32 {
    flow.right() - NUMBER * 4.0
}

fn head_row(flow: &mut Flow<'_>, row: Option<TagId>, words: &Words) {
    let y = base(flow.y, ROW, LABEL);
    for (id, x) in [("report-part", SIDE), ("report-verdict", verdicts(flow))] {
        let cell = row.map(|row| flow.tags.add(row, Kind::ColumnHead));
        flow.say(cell, [x, y], LABEL, words.get(id));
    }
    let mut x = numbers(flow);
    for id in NUMBERS {
        x += NUMBER;
        let cell = row.map(|row| flow.tags.add(row, Kind::ColumnHead));
        for line in flow.wrap(&words.get(id), LABEL, NUMBER - 2.0, 1) {
            flow.say_to(cell, [x, y], LABEL, line);
        }
    }
    flow.y += ROW;
    flow.rule(flow.y, 1.0, TEXT);
}

fn part_row(flow: &mut Flow<'_>, row: TagId, part: &PartSheet, words: &Words) {
    let y = base(flow.y, ROW, CELL);
    let name = flow.tags.add(row, Kind::RowHead);
    for line in flow.wrap(&heading(part, words), VALUE, verdicts(flow) - SIDE - 8.0, 1) {
        flow.say(Some(name), [SIDE, y], VALUE, line);
    }
    let status = part.status();
    let word = status.map_or_else(|| words.get("walk-page-not-complete"), |status| words.told(&status));
    let standing = part.standing();
    let is_simulated = 0 < standing.simulated;
    let style = CHIP.in_ink(if is_simulated { TEXT } else { tone(status).on });
    let width = flow.fonts.width(&word, style.weight, style.size);
    let chip = Area::new(verdicts(flow), flow.y + 2.3, width + 22.0, ROW - 4.6);
    if status.is_some() {
        let tone = tone(status);
        let edge = is_simulated.then_some(Edge { ink: TEXT, width: 0.8, is_dashed: true });
        let fill = if is_simulated { tone.pale } else { tone.ground };
        flow.put(None, Shape::Block { area: chip, radius: 3.0, fill: Some(fill), edge });
    }
    let middle = [chip.x + 9.0, chip.middle()[1]];
    flow.put(None, Shape::Sign { sign: Sign::of(status), middle, size: 9.5, ink: style.ink });
    let cell = flow.tags.add(row, Kind::Cell);
    flow.say(Some(cell), [chip.x + 17.0, base(flow.y, ROW, style)], style, word);
    let mut x = numbers(flow);
    for number in [standing.measured, standing.missing, standing.skipped, standing.simulated] {
        x += NUMBER;
        let cell = flow.tags.add(row, Kind::Cell);
        flow.say_to(Some(cell), [x, y], CELL, number.to_string());
    }
    flow.y += ROW;
    flow.rule(flow.y, 0.5, LINE);
}
