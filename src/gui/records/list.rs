//! All records as a table. A row that was not read yet is drawn grey; the frame never waits for it.

use std::ops::Range;

use eframe::egui::{Id, Ui};

use super::cells::RecordCells;
use crate::gui::key_names::part_id;
use crate::gui::table::{Column, Row, Table};
use crate::gui::view::View;
use crate::session::RecordsCommand;
use crate::session::focused::RECORDS;

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    part_id(RECORDS)
}

/// The columns of the list, behind the choice for a report.
pub(in crate::gui) const COLUMNS: [Column; 12] = [
    Column::choice(),
    Column::text(16.0).head("records-page-head-number"),
    Column::text(34.0).head("head-time").gives_way(6),
    Column::text(26.0).head("head-part").gives_way(7),
    Column::text(20.0).head("records-page-serial-short").gives_way(4),
    Column::text(20.0).head("records-page-feature").gives_way(3),
    Column::text(19.0).head("head-callout"),
    Column::text(23.0).head("head-measured"),
    Column::text(25.0).head("head-deviation").gives_way(5),
    Column::zone().head("records-page-zone").gives_way(2),
    Column::verdict(46.0).head("head-status").takes_rest(),
    Column::text(26.0).head("records-page-who").gives_way(1).takes_rest(),
];

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.records();
    let table = Table {
        count: page.listing.count(),
        look: page.look(),
        empty: nothing(view),
        ..Table::new(id(), "records-page-list", &COLUMNS)
    };
    let seen = table.show(ui, view, rows);
    if view.session.records().listing.lacks(&seen.places) {
        view.send(RecordsCommand::See(seen.places));
    }
    if let Some((number, is_chosen)) = seen.chosen {
        view.send(RecordsCommand::Choose(number, is_chosen));
    }
    if let Some(number) = seen.clicked {
        view.send(RecordsCommand::Open(number));
    }
}

/// Why there are no rows.
fn nothing(view: &View<'_>) -> String {
    let listing = &view.session.records().listing;
    view.text(match (listing.is_whole, view.session.recording().newest <= 1) {
        (false, _) => "records-page-looking",
        (true, true) => "records-page-empty",
        (true, false) => "records-page-none-found",
    })
}

fn rows(view: &View<'_>, places: Range<usize>) -> Vec<Row<u64>> {
    let page = view.session.records();
    let listing = &page.listing;
    let row = |number: u64| {
        let read = listing.row(number);
        let cells = read.map_or_else(|| RecordCells::missing(number), |row| RecordCells::of(view.words, row));
        let is_struck = cells.is_struck;
        Row {
            is_cursor: page.cursor == Some(number),
            is_open: page.open.as_ref().is_some_and(|open| open.number == number),
            is_struck,
            is_quiet: read.is_none() || listing.is_stale,
            ..cells.into_row(view.words, number, (page.is_chosen(number), read.is_some()))
        }
    };
    places.map_while(|place| listing.at(place)).map(row).collect()
}
