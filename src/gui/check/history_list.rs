//! Earlier checks as a table whose heads sort.

use std::ops::Range;
use std::sync::Arc;

use eframe::egui::{Id, Ui};

use crate::gui::key_names::part_id;
use crate::gui::shapes::Edge;
use crate::gui::table::{Cell, Column, Row, Table, Zoned};
use crate::gui::view::{Digits, View};
use crate::journal::Record;
use crate::journal::query::{Column as By, RecordId, TIME, callout};
use crate::message::{Message, Say as _, message};
use crate::session::focused::HISTORY;
use crate::session::{Action, CheckAction, CheckCommand, status_text};

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    part_id(HISTORY)
}

/// The columns of the history, behind the choice for export. What is left over goes to where a value comes from, which gives way first.
pub(in crate::gui) const COLUMNS: [Column; 9] = [
    Column::choice(),
    Column::text(26.0).sorts(Action::Check(CheckAction::SortHistory(By::Time))).gives_way(4),
    Column::text(20.0).sorts(Action::Check(CheckAction::SortHistory(By::Part))).gives_way(5),
    Column::text(20.0).sorts(Action::Check(CheckAction::SortHistory(By::Callout))),
    Column::text(23.0).sorts(Action::Check(CheckAction::SortHistory(By::Measured))),
    Column::text(20.0).sorts(Action::Check(CheckAction::SortHistory(By::Deviation))).gives_way(3),
    Column::zone().head("records-page-zone").gives_way(1),
    Column::verdict(52.0).sorts(Action::Check(CheckAction::SortHistory(By::Status))).takes_rest(),
    Column::text(58.0).sorts(Action::Check(CheckAction::SortHistory(By::From))).gives_way(2).takes_rest(),
];

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    let history = view.session.history();
    let sort = history.listed().query().sort;
    let table = Table {
        sorted: sort.map(|sort| (CheckAction::SortHistory(sort.column).into(), sort.ascending)),
        count: history.listed().count(),
        look: history.look(),
        empty: view.text("history-none-found"),
        ..Table::new(id(), "history-list", &COLUMNS)
    };
    let seen = table.show(ui, view, rows);
    if let Some((id, is_chosen)) = seen.chosen {
        view.send(CheckCommand::Choose(id, is_chosen));
    }
    if let Some(id) = seen.clicked {
        view.send(CheckCommand::Show(id));
    }
}

fn rows(view: &View<'_>, places: Range<usize>) -> Vec<Row<RecordId>> {
    let history = view.session.history();
    let shown = view.session.check().shown.as_ref().map(|shown| Arc::clone(&shown.record));
    let row = |(id, record): (RecordId, Arc<Record>)| Row {
        is_cursor: history.cursor == Some(id),
        is_struck: history.replaced_by(id).is_some(),
        is_open: shown.as_ref().is_some_and(|shown| Arc::ptr_eq(shown, &record)),
        ..row(view, id, &record)
    };
    history.listed().page(places).into_iter().map(row).collect()
}

/// The time of day for what was made on the day of the newest check, else the day with it.
fn short_time(view: &View<'_>, record: &Record) -> String {
    let newest = view.session.history().iter().next_back().map(|newest| newest.time.date());
    let format = if newest == Some(record.time.date()) { "%H:%M:%S" } else { "%m-%d %H:%M" };
    record.time.strftime(format).to_string()
}

fn row(view: &View<'_>, id: RecordId, record: &Record) -> Row<RecordId> {
    let words = view.words;
    let digits = Digits::of(record);
    let is_chosen = view.session.history().is_chosen(id);
    let time = record.time.strftime(TIME).to_string();
    let short = short_time(view, record);
    let part = record.id.clone();
    let callout = callout(record);
    let measured = digits.mm(words, record.measurement.diameter, 4);
    let deviation = format!("{} µm", digits.signed_um(words, record.verdict.size.deviation));
    let replaced = view.session.history().replaced_by(id);
    let status = match replaced {
        Some(by) => words.say(&message!("records-page-see").text("number", by)),
        None => status_text(record, words),
    };
    let from = words.say(&record.measurement.origin.message());
    let check = format!("{part} {callout} {measured} mm");
    let name = words.say(&message!("choose-check").text("check", check.trim()).text("time", &time));
    let said = Message::new(if part.is_empty() { "history-row" } else { "history-row-part" })
        .text("time", &time)
        .text("part", &part)
        .text("callout", &callout)
        .text("measured", &measured)
        .text("deviation", &deviation)
        .text("status", &status)
        .text("from", &from);
    let said = words.say(&said);
    let said = if is_chosen { words.say(&message!("history-row-chosen").text("row", said)) } else { said };
    let verdict = match replaced {
        Some(_) => Cell::Text(status),
        None => Cell::Verdict {
            status: Some(record.verdict.status()),
            edge: Edge::of(record),
            word: status,
            beside: String::new(),
        },
    };
    let [time, part, callout, measured, deviation, from] =
        [short, part, callout, measured, deviation, from].map(Cell::Text);
    let choice = Cell::Choice { is_chosen, can_choose: replaced.is_none(), name };
    let zone = Cell::Zone(Some(Zoned::of(record)));
    Row::new(id, vec![choice, time, part, callout, measured, deviation, zone, verdict, from], said)
}
