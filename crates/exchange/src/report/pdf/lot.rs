//! Many parts with their verdicts, the worst first: what is to be looked at stands on the first page.

use fitcheck_core::message::{Say as _, message};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::flow::{Flow, base};
use super::look::{CELL, CHIP, GAP, LABEL, LINE, SIDE, TEXT, VALUE, tone};
use super::sheet::Shape;
use super::signs::Sign;
use super::table::outline;
use super::tags::{Kind, TagId};
use crate::report::part::PartSheet;
use crate::report::said::heading;

/// The height of a row.
const ROW: f32 = 15.0;

/// How bad a part is: parts without a verdict come after the bad ones and before the good ones.
fn badness(part: &PartSheet) -> u8 {
    match part.status() {
        Some(Status::Scrap) => 0,
        Some(Status::ReMeasure) => 1,
        Some(Status::Rework) => 2,
        None => 3,
        Some(Status::Good) => 4,
    }
}

/// Writes the list of the parts.
pub(super) fn write(flow: &mut Flow<'_>, section: TagId, parts: &[PartSheet], words: &Words) {
    let mut all: Vec<(usize, &PartSheet)> = parts.iter().enumerate().collect();
    all.sort_by_key(|(place, part)| (badness(part), *place));
    let columns = [SIDE, SIDE + 26.0, SIDE + flow.width() * 0.42, SIDE + flow.width() * 0.62];
    let table = flow.tags.add(section, Kind::Table);
    let head = flow.tags.add(table, Kind::TableHead);
    let row = flow.tags.add(head, Kind::Row);
    flow.room(4.0 * ROW);
    for (x, id) in columns.into_iter().zip(["report-contact", "report-part", "report-verdict", "report-lot-values"]) {
        let cell = flow.tags.add(row, Kind::ColumnHead);
        flow.say(Some(cell), [x, base(flow.y, ROW, LABEL)], LABEL, format!("{} ", words.get(id)));
    }
    flow.y += ROW;
    flow.rule(flow.y, 1.0, TEXT);
    let body = flow.tags.add(table, Kind::TableBody);
    for (place, part) in all {
        flow.room(ROW);
        let row = flow.tags.add(body, Kind::Row);
        let standing = part.standing();
        let status = part.status();
        let word = status.map_or_else(|| words.get("walk-page-not-complete"), |status| words.told(&status));
        let word = if 0 < standing.simulated { format!("{word}, {}", words.get("simulated")) } else { word };
        let number = flow.tags.add(row, Kind::Cell);
        flow.say(Some(number), [columns[0], base(flow.y, ROW, CELL)], CELL, format!("{} ", place + 1));
        let name = flow.tags.add(row, Kind::RowHead);
        let width = columns[2] - columns[1] - 8.0;
        let said = flow.wrap(&heading(part, words), VALUE, width, 1).concat();
        flow.say(Some(name), [columns[1], base(flow.y, ROW, VALUE)], VALUE, format!("{said} "));
        let verdict = flow.tags.add(row, Kind::Cell);
        let middle = [columns[2] + 7.0, flow.y + ROW / 2.0];
        flow.put(None, outline(status, 0 < standing.simulated, middle, 6.2));
        let ink = if 0 < standing.simulated { TEXT } else { tone(status).on };
        flow.put(None, Shape::Sign { sign: Sign::of(status), middle, size: 8.0, ink });
        let width = columns[3] - columns[2] - 24.0;
        let word = flow.wrap(&word, CHIP, width, 1).concat();
        flow.say(Some(verdict), [columns[2] + 18.0, base(flow.y, ROW, CHIP)], CHIP, format!("{word} "));
        let counts = flow.tags.add(row, Kind::Cell);
        let said = words.say(&standing.message());
        let said = flow.wrap(&said, CELL, flow.right() - columns[3], 1).concat();
        flow.say(Some(counts), [columns[3], base(flow.y, ROW, CELL)], CELL, said);
        flow.y += ROW;
        flow.rule(flow.y, 0.5, LINE);
    }
    flow.y += GAP;
    let note = message!("report-lot-order");
    flow.paragraph(section, super::look::NOTE, &words.say(&note));
}
