//! The rows in sight of a large file. The list takes the focus as a whole.

use std::ops::Range;

use eframe::egui::accesskit::Role;
use eframe::egui::{Id, Rangef, Rect, Sense, Ui, UiBuilder, WidgetInfo, vec2};

use super::history_list::{PAD, text_ui};
use super::rows_panel::{fate_text, grouped};
use crate::exchange::batch::Picked;
use crate::gui::long_list::{Long, Top, scrolled};
use crate::gui::shapes::{self, focus_ring, lines_of, times};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, focus_soon, quiet, take_focus};
use crate::length::Length;
use crate::message::message;
use crate::session::{Listed, Rows, RowsCommand};
use crate::words::Words;

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    Id::unique("rows-list")
}

/// Line, part, callout, measured, deviation, verdict, and what is to be done or why there is no verdict.
const HEADS: [&str; 7] =
    ["rows-head-line", "head-part", "head-callout", "head-measured", "head-deviation", "head-status", "rows-head-what"];

type Columns = [Option<Rangef>; HEADS.len()];

/// The columns within a width. Where there is too little room, the part gives way first, then the deviation and the line;
/// what is left over is the last column's.
fn columns(left: f32, width: f32) -> Columns {
    const GIVE_WAY: [usize; 3] = [1, 4, 0];
    let mut wanted = [27.0, 34.0, 25.0, 26.0, 25.0, 44.0, 50.0].map(space);
    for column in GIVE_WAY {
        if wanted.iter().sum::<f32>() <= width {
            break;
        }
        if let Some(wanted) = wanted.get_mut(column) {
            *wanted = 0.0;
        }
    }
    let sum: f32 = wanted.iter().sum();
    let [.., last] = &mut wanted;
    *last += (width - sum).max(0.0);
    let factor = (width / wanted.iter().sum::<f32>()).clamp(0.0, 1.0);
    let mut from = left;
    wanted.map(|wanted| {
        let column = Rangef::new(from, from + wanted * factor);
        from = column.max;
        (0.0 < wanted).then_some(column)
    })
}

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>, rows: &Rows) {
    let room = ui.available_rect_before_wrap();
    let bar = space(4.0);
    let columns = columns(room.left(), room.width() - bar);
    let heads = Rect::from_min_size(room.min, vec2(room.width(), space(6.0)));
    for (head, across) in HEADS.into_iter().zip(columns) {
        let Some(across) = across else { continue };
        let cell = Rect::from_x_y_ranges(across, heads.y_range()).shrink2(vec2(PAD, 0.0));
        let font = theme::font(sizes().small);
        text_ui(ui.painter(), cell, &view.text(head), &font, palette(ui.ctx()).quiet.0);
    }
    let rect = Rect::from_min_max(heads.left_bottom(), room.max);
    if rect.height() < 1.0 {
        return;
    }
    take_focus(ui, id());
    let list = ui.interact(rect, id(), Sense::focusable_noninteractive());
    list.widget_info(|| WidgetInfo::labeled(Role::Grid, true, view.text("rows-list")));
    let height = control(ui);
    let top = scrolled(ui, &Long { id: id(), count: rows.listed(), look: rows.look() }, rect, bar);
    ui.scope_builder(UiBuilder::new().max_rect(rect).id_salt("rows-body"), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        if rows.listed() == 0 {
            quiet(ui, view.text(if rows.is_running() { "rows-none-yet" } else { "rows-none" }));
        }
        let end = (top.place + lines_of((rect.height() / height).ceil()) + 1).min(rows.listed());
        rows_ui(ui, view, rows, &columns, (top, rect), top.place..end);
    });
    if list.has_focus() {
        focus_ring(ui, rect);
    }
    ui.advance_cursor_after_rect(room);
}

fn rows_ui(
    ui: &Ui,
    view: &mut View<'_>,
    rows: &Rows,
    columns: &Columns,
    (top, rect): (Top, Rect),
    places: Range<usize>,
) {
    let height = control(ui);
    let mut is_missing = false;
    for (number, place) in places.clone().enumerate() {
        let Some(row) = rows.at(place) else { break };
        is_missing |= row.read.is_none() && !row.is_asked;
        let from = rect.top() - top.hidden + times(height, number);
        let across = columns
            .iter()
            .flatten()
            .fold(Rangef::NOTHING, |all, column| Rangef::new(all.min.min(column.min), all.max.max(column.max)));
        let row_rect = Rect::from_x_y_ranges(across, Rangef::new(from, from + height));
        row_ui(ui, view, rows, columns, (row_rect, place), &row);
    }
    if is_missing && rows.unread().is_none() {
        view.send(RowsCommand::See(places));
    }
}

fn row_ui(
    ui: &Ui,
    view: &mut View<'_>,
    rows: &Rows,
    columns: &Columns,
    (rect, place): (Rect, usize),
    row: &Listed<'_>,
) {
    let palette = palette(ui.ctx());
    let is_cursor = rows.cursor() == Some(row.number);
    let is_shown = rows.shown().is_some_and(|shown| shown.number == row.number);
    let ground = match (is_shown, is_cursor, place % 2) {
        (true, ..) => Some(palette.selection.0),
        (_, true, _) => Some(palette.field.0),
        (_, _, 1) => Some(palette.background.0),
        _ => None,
    };
    let painter = ui.painter();
    if let Some(ground) = ground {
        painter.rect_filled(rect, 0.0, ground);
    }
    if is_cursor {
        painter.rect_filled(Rect::from_min_size(rect.left_top(), vec2(3.0, rect.height())), 0.0, palette.accent.0);
    }
    let cells = Cells::of(view.words, rows, row);
    // Not focusable: the list is one stop for Tab.
    let response = ui.interact(rect, id().with(row.number), Sense::CLICK);
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, cells.said(view.words)));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_cursor));
    if is_cursor {
        ui.ctx().accesskit_node_builder(id(), |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    let font = theme::font(sizes().body);
    let mut is_cut = false;
    for (number, (across, text)) in columns.iter().zip(cells.all()).enumerate() {
        let Some(across) = across else {
            is_cut = true;
            continue;
        };
        let cell = Rect::from_x_y_ranges(*across, rect.y_range());
        if number == STATUS {
            fate_ui(ui, cell, row, text);
        } else {
            is_cut |= text_ui(painter, cell.shrink2(vec2(PAD, 0.0)), text, &font, palette.text.0);
        }
    }
    let clicked = response.clicked();
    if is_cut {
        response.on_hover_text(cells.said(view.words));
    }
    if clicked {
        view.send(RowsCommand::Check(row.number));
        focus_soon(ui, id());
    }
}

/// The column of the verdict.
const STATUS: usize = 5;

/// The verdict: colour, shape and word.
fn fate_ui(ui: &Ui, cell: Rect, row: &Listed<'_>, word: &str) {
    let (fill, colour) = palette(ui.ctx()).of_status(row.fate.status());
    let rect = Rect::from_center_size(cell.center(), vec2(cell.width() - 2.0 * PAD, cell.height().min(space(7.0))));
    ui.painter().rect_filled(rect, 3.0, fill);
    let (shape, text) = rect.split_left_right_at_x(rect.left() + rect.height());
    shapes::status(ui.painter(), shape.shrink(space(1.75)), row.fate.status(), colour);
    text_ui(ui.painter(), text.shrink2(vec2(2.0, 0.0)), word, &theme::bold(sizes().small), colour);
}

/// The texts of a row.
struct Cells {
    line: String,
    part: String,
    callout: String,
    measured: String,
    deviation: String,
    status: String,
    what: String,
}

impl Cells {
    fn of(words: &Words, rows: &Rows, row: &Listed<'_>) -> Self {
        let status = fate_text(words, row.fate);
        let Some(picked) = row.read else {
            let class = row.class.map(|class| class.to_string()).unwrap_or_default();
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
        let line = rows.layout().map_or(0, |layout| layout.line) + picked.line;
        let [part, callout] = picked.named.clone();
        let mut cells = Self {
            line: grouped(u64::try_from(line).unwrap_or_default()),
            part,
            callout: Self::callout(row, picked).unwrap_or(callout),
            measured: String::new(),
            deviation: String::new(),
            status,
            what: picked.why.as_ref().map(|why| words.say(why)).unwrap_or_default(),
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

    const fn all(&self) -> [&String; HEADS.len()] {
        [&self.line, &self.part, &self.callout, &self.measured, &self.deviation, &self.status, &self.what]
    }

    /// What a screen reader says of a row.
    fn said(&self, words: &Words) -> String {
        let line = words.say(&message!("rows-row-line").text("line", &self.line));
        let measured = if self.measured.is_empty() { String::new() } else { format!("{} mm", self.measured) };
        let parts = [&line, &self.part, &self.callout, &measured, &self.deviation, &self.status, &self.what];
        parts.into_iter().filter(|part| !part.is_empty()).map(String::as_str).collect::<Vec<_>>().join(", ")
    }
}
