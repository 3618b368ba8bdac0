//! The rows in sight of all records. The list takes the focus as a whole. A row that was not read yet is drawn grey; the frame never
//! waits for it.

use std::ops::Range;

use eframe::egui::accesskit::Role;
use eframe::egui::{Id, Rangef, Rect, Sense, Stroke, StrokeKind, Ui, UiBuilder, WidgetInfo, vec2};

use super::cells::Cells;
use crate::gui::check::{PAD, text_ui};
use crate::gui::long_list::{Long, Top, scrolled};
use crate::gui::shapes::{self, focus_ring, lines_of, times};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::colours;
use crate::gui::view::{View, focus_soon, quiet, take_focus};
use crate::message::message;
use crate::session::RecordsCommand;
use crate::verdict::Status;

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    Id::unique("records-list")
}

const HEADS: [&str; 10] = [
    "records-page-head-number",
    "head-time",
    "head-part",
    "records-page-serial-short",
    "records-page-feature",
    "head-callout",
    "head-measured",
    "head-deviation",
    "head-status",
    "records-page-who",
];

/// The column of the verdict.
const STATUS: usize = 8;

/// From the choice for a report to the columns of [`HEADS`]; one that has no room is left out.
type Columns = [Option<Rangef>; HEADS.len() + 1];

/// The columns within a width. Where there is too little room, feature, serial number, who, deviation, time and part give way, in this
/// order; the row says it all under the pointer. What is left over is the last column's.
fn columns(left: f32, width: f32) -> Columns {
    const GIVE_WAY: [usize; 6] = [5, 4, 10, 8, 2, 3];
    let mut wanted = [10.0, 16.0, 34.0, 26.0, 20.0, 20.0, 19.0, 23.0, 25.0, 46.0, 26.0].map(space);
    for column in GIVE_WAY {
        if wanted.iter().sum::<f32>() <= width {
            break;
        }
        if let Some(wanted) = wanted.get_mut(column) {
            *wanted = 0.0;
        }
    }
    let sum: f32 = wanted.iter().sum();
    let [.., status, who] = &mut wanted;
    *(if 0.0 < *who { who } else { status }) += (width - sum).max(0.0);
    let factor = (width / wanted.iter().sum::<f32>()).clamp(0.0, 1.0);
    let mut from = left;
    wanted.map(|wanted| {
        let column = Rangef::new(from, from + wanted * factor);
        from = column.max;
        (0.0 < wanted).then_some(column)
    })
}

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    let room = ui.available_rect_before_wrap();
    let bar = space(4.0);
    let columns = columns(room.left(), room.width() - bar);
    let heads = Rect::from_min_size(room.min, vec2(room.width(), space(6.0)));
    for (head, across) in HEADS.into_iter().zip(columns.iter().skip(1)) {
        let Some(across) = across else { continue };
        let cell = Rect::from_x_y_ranges(*across, heads.y_range()).shrink2(vec2(PAD, 0.0));
        let font = theme::font(sizes().small);
        text_ui(ui.painter(), cell, &view.text(head), &font, palette(ui.ctx()).quiet.0);
    }
    let rect = Rect::from_min_max(heads.left_bottom(), room.max);
    if rect.height() < 1.0 {
        return;
    }
    take_focus(ui, id());
    let list = ui.interact(rect, id(), Sense::focusable_noninteractive());
    list.widget_info(|| WidgetInfo::labeled(Role::Grid, true, view.text("records-page-list")));
    let (count, look) = (view.session.records().listing().count(), view.session.records().look());
    let top = scrolled(ui, &Long { id: id(), count, look }, rect, bar);
    ui.scope_builder(UiBuilder::new().max_rect(rect).id_salt("records-body"), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        if count == 0 {
            nothing_ui(ui, view);
        }
        let fit = lines_of((rect.height() / control(ui)).ceil()) + 1;
        rows_ui(ui, view, &columns, (top, rect), top.place..(top.place + fit).min(count));
    });
    if list.has_focus() {
        focus_ring(ui, rect);
    }
    ui.advance_cursor_after_rect(room);
}

/// Why there are no rows.
fn nothing_ui(ui: &mut Ui, view: &View<'_>) {
    let listing = view.session.records().listing();
    let id = match (listing.is_whole(), view.session.recording().newest() <= 1) {
        (false, _) => "records-page-looking",
        (true, true) => "records-page-empty",
        (true, false) => "records-page-none-found",
    };
    quiet(ui, view.text(id));
}

fn rows_ui(ui: &Ui, view: &mut View<'_>, columns: &Columns, (top, rect): (Top, Rect), places: Range<usize>) {
    let height = control(ui);
    let session = view.session;
    let listing = session.records().listing();
    let across = columns
        .iter()
        .flatten()
        .fold(Rangef::NOTHING, |all, column| Rangef::new(all.min.min(column.min), all.max.max(column.max)));
    for (at, place) in places.clone().enumerate() {
        let Some(number) = listing.at(place) else { break };
        let from = rect.top() - top.hidden + times(height, at);
        let rect = Rect::from_x_y_ranges(across, Rangef::new(from, from + height));
        let row = listing.row(number);
        let cells = row.map_or_else(|| Cells::missing(number), |row| Cells::of(view.words, row));
        row_ui(ui, view, columns, &Drawn { rect, place, number, is_read: row.is_some(), cells });
    }
    if listing.lacks(&places) {
        view.send(RecordsCommand::See(places));
    }
}

/// A row in sight.
struct Drawn {
    rect: Rect,
    place: usize,
    number: u64,
    is_read: bool,
    cells: Cells,
}

fn row_ui(ui: &Ui, view: &mut View<'_>, columns: &Columns, row: &Drawn) {
    let (palette, painter, page) = (palette(ui.ctx()), ui.painter(), view.session.records());
    let is_cursor = page.cursor() == Some(row.number);
    let is_open = page.opened().is_some_and(|open| open.number == row.number);
    let ground = match (is_open, is_cursor, row.place % 2) {
        (true, ..) => Some(palette.selection.0),
        (_, true, _) => Some(palette.field.0),
        (_, _, 1) => Some(palette.background.0),
        _ => None,
    };
    if let Some(ground) = ground {
        painter.rect_filled(row.rect, 0.0, ground);
    }
    if is_cursor {
        let bar = Rect::from_min_size(row.rect.left_top(), vec2(3.0, row.rect.height()));
        painter.rect_filled(bar, 0.0, palette.accent.0);
    }
    let is_chosen = page.is_chosen(row.number);
    // Not focusable: the list is one stop for Tab.
    let response = ui.interact(row.rect, id().with(row.number), Sense::CLICK);
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, row.cells.said(view.words, is_chosen)));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_cursor));
    if is_cursor {
        ui.ctx().accesskit_node_builder(id(), |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    let is_stale = page.listing().is_stale();
    if let [Some(choose), ..] = columns {
        let cell = Rect::from_x_y_ranges(*choose, row.rect.y_range());
        choose_ui(ui, view, cell, row, is_chosen);
    }
    let colour = if row.is_read && !is_stale && !row.cells.is_struck { palette.text.0 } else { palette.quiet.0 };
    let font = theme::font(sizes().body);
    let mut is_cut = false;
    for (number, (across, text)) in columns.iter().skip(1).zip(row.cells.all()).enumerate() {
        let Some(across) = across else {
            is_cut |= !text.is_empty();
            continue;
        };
        let cell = Rect::from_x_y_ranges(*across, row.rect.y_range());
        if number == STATUS && row.cells.is_check && !row.cells.is_struck {
            status_ui(ui, cell, row);
            continue;
        }
        is_cut |= text_ui(painter, cell.shrink2(vec2(PAD, 0.0)), text, &font, colour);
    }
    if row.cells.is_struck {
        strike(ui, columns, row);
    }
    let clicked = response.clicked();
    if is_cut {
        response.on_hover_text(row.cells.said(view.words, is_chosen));
    }
    if clicked {
        view.send(RecordsCommand::Open(row.number));
        focus_soon(ui, id());
    }
}

/// A line through what another entry stands in place of, up to where that is named.
fn strike(ui: &Ui, columns: &Columns, row: &Drawn) {
    let end = columns.get(STATUS + 1).copied().flatten().map_or(row.rect.right(), |status| status.min);
    let start = columns.get(1).copied().flatten().map_or(row.rect.left(), |first| first.min);
    let across = Rangef::new(start + PAD, end - PAD);
    ui.painter().hline(across, row.rect.center().y, Stroke::new(1.0, palette(ui.ctx()).quiet.0));
}

/// The choice for a report: a box with a check mark.
fn choose_ui(ui: &Ui, view: &mut View<'_>, rect: Rect, row: &Drawn, is_chosen: bool) {
    let palette = palette(ui.ctx());
    let mark = Rect::from_center_size(rect.center(), vec2(space(5.0), space(5.0)));
    ui.painter().rect(mark, 2.0, palette.field.0, Stroke::new(1.5, palette.quiet.0), StrokeKind::Inside);
    if is_chosen {
        shapes::status(ui.painter(), mark.shrink(3.0), Some(Status::Good), palette.text.0);
    }
    let response = ui.interact(rect, id().with(("choose", row.number)), Sense::CLICK);
    let name = message!("records-page-choose-record").text("number", row.number);
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, row.is_read, is_chosen, view.words.say(&name)));
    if response.clicked() && row.is_read {
        view.send(RecordsCommand::Choose(row.number, !is_chosen));
    }
}

/// The verdict: a simulated one is pale, framed by dashes, and says so.
fn status_ui(ui: &Ui, cell: Rect, row: &Drawn) {
    let (painter, cells) = (ui.painter(), &row.cells);
    let (fill, colour) = colours(palette(ui.ctx()), cells.verdict, cells.is_simulated);
    let width = (cell.width() - 2.0 * PAD).min(space(54.0));
    let rect = Rect::from_min_size(
        cell.left_center() + vec2(PAD, -cell.height().min(space(7.0)) / 2.0),
        vec2(width, cell.height().min(space(7.0))),
    );
    painter.rect_filled(rect, 3.0, fill);
    if cells.is_simulated {
        shapes::dashed_frame(painter, rect, colour);
    }
    let (shape, text) = rect.split_left_right_at_x(rect.left() + rect.height());
    shapes::status(painter, shape.shrink(space(1.75)), cells.verdict, colour);
    text_ui(painter, text.shrink2(vec2(2.0, 0.0)), &cells.status, &theme::bold(sizes().small), colour);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_fill_the_width_and_give_way_one_after_another() {
        let mut before = HEADS.len() + 1;
        for width in [1600.0, 1200.0, 1100.0, 1000.0, 900.0, 700.0, 560.0, 400.0, 200.0] {
            let columns: Vec<Rangef> = columns(7.0, width).into_iter().flatten().collect();
            let is_in_order = |pair: &[Rangef]| pair[0].min < pair[1].min && pair[0].max <= pair[1].min + 0.01;
            assert!(columns.windows(2).all(is_in_order), "{width}");
            let (first, last) = (columns[0].min, columns[columns.len() - 1].max);
            assert!((first - 7.0).abs() < 0.01 && (last - 7.0 - width).abs() < 0.01, "{width}: {first} to {last}");
            assert!(columns.len() <= before, "{width}");
            before = columns.len();
        }
        assert_eq!(before, 5, "choice, number, callout, value and verdict never give way");
    }
}
