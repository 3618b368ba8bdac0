//! Middle, below: the pairs as a table.

use std::ops::Range;

use eframe::egui::{Id, Ui};

use crate::gui::key_names::part_id;
use crate::gui::table::{Cell, Column, Row, Table};
use crate::gui::view::View;
use crate::message::message;
use crate::session::focused::PAIRS;
use crate::session::{PairRow, Paired, PairingCommand};

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    part_id(PAIRS)
}

/// The columns of the list. The distance from the middle gives way first, then the sizes; a remark is only wanted where there is one.
pub(in crate::gui) const fn columns(has_remarks: bool) -> [Column; 7] {
    [
        Column::text(20.0).head("pairing-page-hole"),
        Column::figure(19.0).unit("mm").gives_way(3),
        Column::text(20.0).head("pairing-page-shaft"),
        Column::figure(19.0).unit("mm").gives_way(2),
        Column::figure(26.0).head("pairing-page-clearance").unit("µm"),
        Column::figure(28.0).head("pairing-page-from-middle-head").unit("µm").gives_way(1),
        Column::text(34.0).wanted(has_remarks),
    ]
}

/// On a wide screen a size stays near its name: the columns become no wider than so many times their width.
const STRETCH: f32 = 1.6;

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>, paired: &Paired) {
    let columns = columns(0 < paired.simulated);
    let table = Table {
        stretch: STRETCH,
        count: paired.count(),
        look: view.session.pairing().look(),
        empty: view.text("pairing-page-no-pair"),
        ..Table::new(id(), "pairing-page-list", &columns)
    };
    let seen = table.show(ui, view, |view, places| rows(view, paired, places));
    if let Some(place) = seen.clicked {
        view.send(PairingCommand::Select(place));
    }
}

fn rows(view: &View<'_>, paired: &Paired, places: Range<usize>) -> Vec<Row<usize>> {
    let selected = view.session.pairing().selected;
    let row = |place: usize| {
        let cells = cells(view, paired, paired.row(place)?);
        let said = said(view, &cells);
        let is_selected = selected == Some(place);
        let row = Row::new(place, cells.map(Cell::Text).into(), said);
        Some(Row { is_cursor: is_selected, is_open: is_selected, ..row })
    };
    places.map_while(row).collect()
}

fn cells(view: &View<'_>, paired: &Paired, row: PairRow<'_>) -> [String; 7] {
    let words = view.words;
    let [hole, shaft, clearance, from_middle] = paired.figures(row).map(|figure| words.number(&figure));
    [
        paired.hole_name(row.hole, words),
        hole,
        paired.shaft_name(row.shaft, words),
        shaft,
        clearance,
        from_middle,
        row.remark().map_or_else(String::new, |remark| words.say(&remark)),
    ]
}

/// What a screen reader says of a row.
fn said(view: &View<'_>, cells: &[String; 7]) -> String {
    let [hole, hole_mm, shaft, shaft_mm, clearance, from_middle, remark] = cells;
    let message = message!("pairing-page-row")
        .text("hole", hole)
        .text("hole-mm", hole_mm)
        .text("shaft", shaft)
        .text("shaft-mm", shaft_mm)
        .text("clearance", clearance)
        .text("middle", from_middle);
    let said = view.words.say(&message);
    if remark.is_empty() { said } else { format!("{said}, {remark}") }
}
