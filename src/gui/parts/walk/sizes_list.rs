//! Every size of the part with its verdict: below what is asked where the middle has the picture, else in the middle.

use std::ops::Range;

use eframe::egui::{Color32, Id, Ui};

use super::asked_text;
use crate::gui::key_names::part_id;
use crate::gui::shapes::Edge;
use crate::gui::table::{Cell, Column, PAD, Row, Table, joined};
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{Digits, View, quiet};
use crate::message::message;
use crate::part::Size;
use crate::session::focused::SIZES;
use crate::session::parts::{WalkCommand, WalkRow, Walking};

/// The id of the list.
pub(in crate::gui) fn id() -> Id {
    part_id(SIZES)
}

/// The narrowest column of names, steps of space.
const NAME: f32 = 23.0;

/// What the mark, a value and the bar take beside it.
const BESIDE: f32 = 33.0;

/// Verdict, name, what is asked, value, deviation, remark. The remark, which is narrower first, gives way before the others.
pub(in crate::gui) const COLUMNS: [Column; 6] = [
    Column::mark(),
    Column::text(NAME).wraps(),
    Column::text(18.0).gives_way(3),
    Column::number(20.0),
    Column::number(18.0).gives_way(2),
    Column::text(22.0).gives_way(1).grows(36.0),
];

/// On a wide screen a value stays near its name: the columns become no wider than so many times their width.
const STRETCH: f32 = 1.6;

/// The list in the room that is left.
pub(in crate::gui) fn sizes_ui(ui: &mut Ui, view: &mut View<'_>) {
    let walking = &view.session.parts().walking;
    if !walking.is_begun() {
        quiet(ui, view.text("walk-page-no-part"));
        return;
    }
    let [mark, _, rest @ ..] = COLUMNS;
    let columns: Vec<Column> = [mark, name_column(ui, walking)].into_iter().chain(rest).collect();
    let table = Table {
        stretch: STRETCH,
        count: walking.count(),
        look: walking.look(),
        // The field of the value gets the focus: what a gauge types next is of this size.
        keeps_focus: false,
        ..Table::new(id(), "walk-page-sizes", &columns)
    };
    let seen = table.show(ui, view, |view, places| rows(view, walking, places));
    if let Some(place) = seen.clicked {
        view.send(WalkCommand::Go(place));
    }
}

/// The column of names, as wide as the longest of them where values keep their room; what is longer goes on in a second line.
fn name_column(ui: &Ui, walking: &Walking) -> Column {
    let name = longest(walking);
    let width = |name| ui.painter().layout_no_wrap(name, theme::font(sizes().body), Color32::PLACEHOLDER).size().x;
    let wanted = name.map_or(0.0, |name| (width(name) + 2.0 * PAD) / space(1.0));
    let room = ui.available_width() / space(1.0) - BESIDE;
    Column::text(wanted.ceil().min(room).max(NAME)).wraps()
}

fn longest(walking: &Walking) -> Option<String> {
    let longest = (0..walking.count()).max_by_key(|at| walking.name(*at).chars().count())?;
    walking.with_row(longest, |row| numbered(row.size))
}

/// Whether a list of this width has every name whole, in two lines at most.
pub(super) fn has_room(ui: &Ui, walking: &Walking, width: f32) -> bool {
    let width = width - space(BESIDE) - 2.0 * PAD;
    let rows = |name| ui.painter().layout(name, theme::font(sizes().small), Color32::PLACEHOLDER, width).rows.len();
    longest(walking).is_none_or(|name| rows(name) < 3)
}

/// Number and name of a size.
pub(super) fn numbered(size: &Size<'_>) -> String {
    let number = &size.feature.number;
    if number.is_empty() { size.name() } else { format!("{number}  {}", size.name()) }
}

fn rows(view: &View<'_>, walking: &Walking, places: Range<usize>) -> Vec<Row<usize>> {
    let row = |place: usize| {
        let is_selected = walking.at == Some(place);
        let row = walking.with_row(place, |row| row_of(view, place, &row))?;
        Some(Row { is_cursor: is_selected, is_open: is_selected, ..row })
    };
    places.map_while(row).collect()
}

fn row_of(view: &View<'_>, place: usize, WalkRow { size, step, value }: &WalkRow<'_>) -> Row<usize> {
    let words = view.words;
    let name = numbered(size);
    let asked = asked_text(words, size);
    let record = value.map(|value| value.record.as_ref());
    let digits = record.map_or(Digits::Exact, Digits::of);
    let is_simulated = record.is_some_and(|record| record.measurement.origin.is_simulated());
    let mut remarks = Vec::new();
    if is_simulated {
        remarks.push(words.get("walk-page-row-simulated"));
    }
    if 1 < step.taken.len() {
        remarks.push(words.say(&message!("walk-page-times").count("count", step.taken.len())));
    }
    if let Some(reason) = step.skipped.as_ref().filter(|_| value.is_none()) {
        remarks.push(words.say(&message!("walk-page-skipped").text("reason", reason)));
    }
    let status = record.map(|record| record.verdict.status());
    let word = record.map_or_else(|| view.text("walk-page-open"), |record| words.told(&record.verdict));
    // The cells of a size that was not measured are empty.
    let shown = record.map_or_else(String::new, |record| digits.mm(words, record.measurement.diameter, 3));
    let measured = if shown.is_empty() { String::new() } else { format!("{shown} mm") };
    let deviation = |value| format!("{} µm", digits.signed_um(words, Walking::deviation(value)));
    let deviation = value.map_or_else(String::new, deviation);
    let remark = remarks.join(", ");
    let said = joined([&name, &asked, &word, &measured, &deviation, &remark]);
    let is_left_out = record.is_none() && step.skipped.is_some();
    let mark = if status.is_some() || is_left_out {
        Cell::Verdict { status, edge: record.map_or(Edge::None, Edge::of), word, beside: String::new() }
    } else {
        Cell::Text(String::new())
    };
    let texts = [name, asked, shown, deviation, remark].map(Cell::Text);
    Row::new(place, std::iter::once(mark).chain(texts).collect(), said)
}
