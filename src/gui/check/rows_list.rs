//! The rows of a large file as a table.

use std::ops::Range;

use eframe::egui::{Id, Ui};

use super::grouped;
use super::row_texts::fate_text;
use crate::exchange::batch::Picked;
use crate::gui::key_names::part_id;
use crate::gui::shapes::Edge;
use crate::gui::table::{Cell, Column, Row, Table, joined};
use crate::gui::view::View;
use crate::length::Length;
use crate::message::message;
use crate::session::focused::ROWS;
use crate::session::{Listed, Rows, RowsCommand};
use crate::text::long;
use crate::words::Words;

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    part_id(ROWS)
}

/// The columns of the list; last what is to be done, or why there is no verdict. Where there is too little room, the part gives way first.
pub(in crate::gui) const COLUMNS: [Column; 7] = [
    Column::text(27.0).head("rows-head-line").gives_way(3),
    Column::text(34.0).head("head-part").gives_way(1),
    Column::text(25.0).head("head-callout"),
    Column::text(26.0).head("head-measured"),
    Column::text(25.0).head("head-deviation").gives_way(2),
    Column::verdict(44.0).head("head-status"),
    Column::text(50.0).head("rows-head-what").takes_rest(),
];

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>, rows: &Rows) {
    let table = Table {
        count: rows.listed(),
        look: rows.look(),
        empty: view.text(if rows.is_running() { "rows-none-yet" } else { "rows-none" }),
        ..Table::new(id(), "rows-list", &COLUMNS)
    };
    let seen = table.show(ui, view, |view, places| rows_of(view.words, rows, places));
    let is_missing = |row: Listed<'_>| row.read.is_none() && !row.is_asked;
    if rows.unread.is_none() && seen.places.clone().filter_map(|place| rows.at(place)).any(is_missing) {
        view.send(RowsCommand::See(seen.places));
    }
    if let Some(number) = seen.clicked {
        view.send(RowsCommand::Check(number));
    }
}

fn rows_of(words: &Words, rows: &Rows, places: Range<usize>) -> Vec<Row<u64>> {
    let row = |row: Listed<'_>| {
        let cells = LargeFileCells::of(words, rows, &row);
        Row {
            is_cursor: rows.cursor == Some(row.number),
            is_open: rows.shown.as_ref().is_some_and(|shown| shown.number == row.number),
            ..cells.into_row(words, &row)
        }
    };
    places.map_while(|place| rows.at(place)).map(row).collect()
}

/// The texts of a row.
struct LargeFileCells {
    line: String,
    part: String,
    callout: String,
    measured: String,
    deviation: String,
    status: String,
    what: String,
}

impl LargeFileCells {
    fn of(words: &Words, rows: &Rows, row: &Listed<'_>) -> Self {
        let status = fate_text(words, row.fate);
        let Some(picked) = row.read else {
            // A row that is not read yet shows the class that it was judged by, if any.
            let class = row.class.map_or_else(String::new, |class| class.to_string());
            let wait = || "…".to_owned();
            return Self {
                line: wait(),
                part: wait(),
                callout: class,
                measured: wait(),
                deviation: wait(),
                status,
                what: String::new(),
            };
        };
        let line = rows.layout.as_deref().map_or(0, |layout| layout.line) + picked.line;
        let [part, callout] = picked.named.clone();
        let mut cells = Self {
            line: grouped(long(line)),
            part,
            callout: Self::callout(row, picked).unwrap_or(callout),
            measured: String::new(),
            deviation: String::new(),
            status,
            what: picked.why.as_ref().map_or_else(String::new, |why| words.say(why)),
        };
        if let Some(judged) = picked.judged {
            cells.measured = words.mm(judged.measured, 4);
            cells.deviation = format!("{} µm", words.signed_um(judged.verdict().deviation));
            if let Some(removal) = judged.verdict().removal {
                let amount = |length: Length| message!("remove-amount").text("um", words.um(length));
                cells.what = words.say(&amount(removal.to_limit));
            }
        }
        cells
    }

    /// The callout as it is printed, where it has a class.
    fn callout(row: &Listed<'_>, picked: &Picked) -> Option<String> {
        let nominal = picked.judged?.bounds.nominal;
        Some(format!("{nominal} {}", row.class?))
    }

    fn into_row(self, words: &Words, row: &Listed<'_>) -> Row<u64> {
        let said = self.said(words);
        let Self { line, part, callout, measured, deviation, status, what } = self;
        let [line, part, callout, measured, deviation, what] =
            [line, part, callout, measured, deviation, what].map(Cell::Text);
        let verdict =
            Cell::Verdict { status: row.fate.status(), edge: Edge::None, word: status, beside: String::new() };
        Row::new(row.number, vec![line, part, callout, measured, deviation, verdict, what], said)
    }

    /// What a screen reader says of a row.
    fn said(&self, words: &Words) -> String {
        let line = words.say(&message!("rows-row-line").text("line", &self.line));
        let measured = if self.measured.is_empty() { String::new() } else { format!("{} mm", self.measured) };
        joined([&line, &self.part, &self.callout, &measured, &self.deviation, &self.status, &self.what])
    }
}
