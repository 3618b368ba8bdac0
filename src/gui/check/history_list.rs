//! The rows in sight of the history, and heads that sort. The list takes the focus as a whole.

use crate::session::CheckAction;
use std::ops::Range;
use std::sync::Arc;

use eframe::egui::accesskit::{Role, SortDirection};
use eframe::egui::style::ScrollAnimation;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{
    Align, Button, Color32, FontId, Id, Layout, Painter, Rangef, Rect, RichText, ScrollArea, Sense, Stroke, StrokeKind,
    Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use crate::gui::shapes::{self, focus_ring, times};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::colours;
use crate::gui::view::{Digits, View, focus_soon, quiet, take_focus};
use crate::journal::Record;
use crate::journal::query::{Column, RecordId, TIME, callout};
use crate::message::{Message, Say as _, message};
use crate::session::{CheckCommand, status_text};
use crate::verdict::Status;
use crate::words::Words;

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    Id::unique("history-list")
}

/// From the choice for export to the columns of [`Column::ALL`]; one that has no room is left out.
type Columns = [Option<Rangef>; Column::ALL.len() + 1];

/// The columns within a width. Where there is too little room, where a value comes from gives way first, then the
/// deviation, the time and the part; the row says it all under the pointer. What is left over is the last column's.
fn columns(left: f32, width: f32) -> Columns {
    const FROM: usize = Column::ALL.len();
    const GIVE_WAY: [usize; 4] = [FROM, 5, 1, 2];
    let mut wanted = [10.0, 42.0, 24.0, 25.0, 25.0, 25.0, 62.0, 36.0].map(space);
    for column in GIVE_WAY {
        if wanted.iter().sum::<f32>() <= width {
            break;
        }
        if let Some(wanted) = wanted.get_mut(column) {
            *wanted = 0.0;
        }
    }
    let sum: f32 = wanted.iter().sum();
    if let [.., from] = &mut wanted
        && 0.0 < *from
    {
        *from += (width - sum).max(0.0);
    }
    let factor = (width / wanted.iter().sum::<f32>()).max(0.0);
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
    // The scroll bar floats: it must not cover the last column.
    let columns = columns(room.left(), room.width() - space(3.0));
    let heads = Rect::from_min_size(room.min, vec2(room.width(), control(ui)));
    heads_ui(ui, view, &columns, heads.y_range());
    let rect = Rect::from_min_max(heads.left_bottom(), room.max);
    take_focus(ui, id());
    let list = ui.interact(rect, id(), Sense::focusable_noninteractive());
    list.widget_info(|| WidgetInfo::labeled(Role::Grid, true, view.text("history-list")));
    ui.scope_builder(UiBuilder::new().max_rect(rect).id_salt("history-body"), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.spacing_mut().scroll.fade.strength = 0.0;
        let count = view.session.history().listed().count();
        if count == 0 {
            quiet(ui, view.text("history-none-found"));
        }
        let area = ScrollArea::vertical().id_salt("history-rows").auto_shrink(false).min_scrolled_height(0.0);
        area.show_rows(ui, control(ui), count, |ui, places| rows_ui(ui, view, &columns, places));
    });
    if list.has_focus() {
        focus_ring(ui, rect);
    }
}

/// The heads: each sorts by its column, and says so.
fn heads_ui(ui: &mut Ui, view: &mut View<'_>, columns: &Columns, height: Rangef) {
    let sort = view.session.history().listed().query().sort;
    for (column, across) in Column::ALL.into_iter().zip(columns.iter().skip(1)) {
        let Some(across) = across else { continue };
        let action = CheckAction::SortHistory(column);
        let name = action.text(view.session, view.words);
        let ascending = sort.filter(|sort| sort.column == column).map(|sort| sort.ascending);
        let told = |id| view.words.say(&Message::new(id).text("column", &name));
        let (shown, said, direction) = match ascending {
            None => (name.clone(), name.clone(), None),
            Some(true) => (format!("{name} ↑"), told("history-ascending"), Some(SortDirection::Ascending)),
            Some(false) => (format!("{name} ↓"), told("history-descending"), Some(SortDirection::Descending)),
        };
        let colour = if direction.is_some() { palette(ui.ctx()).text.0 } else { palette(ui.ctx()).quiet.0 };
        let text = RichText::new(shown).font(theme::font(sizes().small)).color(colour);
        let room = UiBuilder::new().max_rect(Rect::from_x_y_ranges(*across, height)).id_salt(("head", column));
        ui.scope_builder(room.layout(Layout::left_to_right(Align::Center)), |ui| {
            ui.spacing_mut().button_padding.x = PAD;
            let button = Button::new(text).frame_when_inactive(false).truncate().min_size(vec2(0.0, height.span()));
            let head = view.button_as(ui, action, button);
            head.widget_info(|| WidgetInfo::labeled(Role::Button, true, &said));
            if let Some(direction) = direction {
                ui.ctx().accesskit_node_builder(head.id, |node| node.set_sort_direction(direction));
            }
        });
    }
}

/// Between the edge of a column and its text.
pub(in crate::gui) const PAD: f32 = 4.0;

/// A row in sight.
struct Row {
    rect: Rect,
    id: RecordId,
    record: Arc<Record>,
    place: usize,
    is_cursor: bool,
    is_chosen: bool,
    is_shown: bool,
}

fn rows_ui(ui: &mut Ui, view: &mut View<'_>, columns: &Columns, places: Range<usize>) {
    let (left, width) = (ui.max_rect().left(), ui.available_width());
    follow(ui, view, ui.max_rect().top() - times(control(ui), places.start), left);
    let history = view.session.history();
    let shown = view.session.check().shown().map(|shown| Arc::clone(&shown.record));
    for (place, (id, record)) in places.clone().zip(history.listed().page(places)) {
        let (rect, _) = ui.allocate_exact_size(vec2(width, control(ui)), Sense::hover());
        let row = Row {
            rect,
            id,
            place,
            is_cursor: history.cursor() == Some(id),
            is_chosen: history.is_chosen(id),
            is_shown: shown.as_ref().is_some_and(|shown| Arc::ptr_eq(shown, &record)),
            record,
        };
        row_ui(ui, view, columns, &row);
    }
}

fn row_ui(ui: &Ui, view: &mut View<'_>, columns: &Columns, row: &Row) {
    let palette = palette(ui.ctx());
    let painter = ui.painter();
    let ground = match row {
        Row { is_shown: true, .. } => Some(palette.selection.0),
        Row { is_cursor: true, .. } => Some(palette.field.0),
        Row { place, .. } if place % 2 == 1 => Some(palette.background.0),
        _ => None,
    };
    if let Some(ground) = ground {
        painter.rect_filled(row.rect, 0.0, ground);
    }
    if row.is_cursor {
        painter.rect_filled(
            Rect::from_min_size(row.rect.left_top(), vec2(3.0, row.rect.height())),
            0.0,
            palette.accent.0,
        );
    }
    let cells = Cells::of(view.words, &row.record);
    // Not focusable: the list is one stop for Tab.
    let response = ui.interact(row.rect, id().with(row.id.0), Sense::CLICK);
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, said(view, &cells, row)));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(row.is_cursor));
    if row.is_cursor {
        ui.ctx().accesskit_node_builder(id(), |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    let [choose, time, part, callout, measured, deviation, status, from] =
        columns.map(|across| across.map(|across| Rect::from_x_y_ranges(across, row.rect.y_range())));
    if let Some(choose) = choose {
        choose_ui(ui, view, choose, row, &cells);
    }
    let font = theme::font(sizes().body);
    let mut is_cut = false;
    for (cell, text) in [
        (time, &cells.time),
        (part, &cells.part),
        (callout, &cells.callout),
        (measured, &cells.measured),
        (deviation, &cells.deviation),
        (from, &cells.from),
    ] {
        is_cut |= match cell {
            Some(cell) => text_ui(painter, cell.shrink2(vec2(PAD, 0.0)), text, &font, palette.text.0),
            None => true,
        };
    }
    if let Some(status) = status {
        status_ui(painter, status, row, &cells.status);
    }
    let clicked = response.clicked();
    if is_cut {
        response.on_hover_text(said(view, &cells, row));
    }
    if clicked {
        view.send(CheckCommand::Show(row.id));
        focus_soon(ui, id());
    }
}

/// A text in one line; returns whether it was cut.
pub(in crate::gui) fn text_ui(painter: &Painter, rect: Rect, text: &str, font: &FontId, colour: Color32) -> bool {
    let mut job = LayoutJob::simple_singleline(text.to_owned(), font.clone(), colour);
    job.wrap = TextWrapping::truncate_at_width(rect.width().max(0.0));
    let galley = painter.layout_job(job);
    let is_cut = galley.elided;
    painter.galley(pos2(rect.left(), rect.center().y - galley.size().y / 2.0), galley, colour);
    is_cut
}

/// The choice for export: a box with a check mark.
fn choose_ui(ui: &Ui, view: &mut View<'_>, rect: Rect, row: &Row, cells: &Cells) {
    let palette = palette(ui.ctx());
    let mark = Rect::from_center_size(rect.center(), vec2(space(5.0), space(5.0)));
    ui.painter().rect(mark, 2.0, palette.field.0, Stroke::new(1.5, palette.quiet.0), StrokeKind::Inside);
    if row.is_chosen {
        shapes::status(ui.painter(), mark.shrink(3.0), Some(Status::Good), palette.text.0);
    }
    let response = ui.interact(rect, id().with(("choose", row.id.0)), Sense::CLICK);
    let check = format!("{} {} {} mm", cells.part, cells.callout, cells.measured);
    let name = message!("choose-check").text("check", check.trim()).text("time", &cells.time);
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, row.is_chosen, view.words.say(&name)));
    if response.clicked() {
        view.send(CheckCommand::Choose(row.id, !row.is_chosen));
    }
}

/// The verdict: a simulated one is pale, framed by dashes, and says so.
fn status_ui(painter: &Painter, cell: Rect, row: &Row, word: &str) {
    let status = row.record.verdict.status();
    let is_simulated = row.record.measurement.origin.is_simulated();
    let (fill, colour) = colours(palette(painter.ctx()), Some(status), is_simulated);
    let height = cell.height().min(space(7.0));
    let rect = Rect::from_center_size(cell.center(), vec2(cell.width() - 2.0 * PAD, height));
    painter.rect_filled(rect, 3.0, fill);
    if is_simulated {
        shapes::dashed_frame(painter, rect, colour);
    }
    let (shape, text) = rect.split_left_right_at_x(rect.left() + rect.height());
    shapes::status(painter, shape.shrink(space(1.75)), Some(status), colour);
    text_ui(painter, text.shrink2(vec2(2.0, 0.0)), word, &theme::bold(sizes().small), colour);
}

/// What a screen reader says of a row.
fn said(view: &View<'_>, cells: &Cells, row: &Row) -> String {
    let id = if cells.part.is_empty() { "history-row" } else { "history-row-part" };
    let message = Message::new(id)
        .text("time", &cells.time)
        .text("part", &cells.part)
        .text("callout", &cells.callout)
        .text("measured", &cells.measured)
        .text("deviation", &cells.deviation)
        .text("status", &cells.status)
        .text("from", &cells.from);
    let said = view.words.say(&message);
    if row.is_chosen { view.words.say(&message!("history-row-chosen").text("row", said)) } else { said }
}

/// The row of the cursor comes into sight when it moves or the list changes; afterwards scrolling is free.
fn follow(ui: &Ui, view: &View<'_>, top: f32, left: f32) {
    let (number, place) = view.session.history().look();
    let key = id().with("look");
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(key), number));
    let Some(place) = place.filter(|_| before != number) else { return };
    let row = Rect::from_min_size(pos2(left, top + times(control(ui), place)), vec2(1.0, control(ui)));
    ui.scroll_to_rect_animation(row, None, ScrollAnimation::none());
}

struct Cells {
    time: String,
    part: String,
    callout: String,
    measured: String,
    deviation: String,
    status: String,
    from: String,
}

impl Cells {
    fn of(words: &Words, record: &Record) -> Self {
        let digits = Digits::of(record);
        Self {
            time: record.time.strftime(TIME).to_string(),
            part: record.id.clone(),
            callout: callout(record),
            measured: digits.mm(words, record.measurement.diameter, 4),
            deviation: format!("{} µm", digits.signed_um(words, record.verdict.size.deviation)),
            status: status_text(record, words),
            from: words.say(&record.measurement.origin.message()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_fill_the_width_and_give_way_one_after_another() {
        let mut before = Column::ALL.len() + 1;
        for (width, shown) in [(1600.0, 8), (1000.0, 8), (900.0, 7), (760.0, 6), (600.0, 5), (500.0, 4), (200.0, 4)] {
            let columns: Vec<Rangef> = columns(7.0, width).into_iter().flatten().collect();
            assert_eq!(columns.len(), shown, "{width}");
            assert!(
                columns.windows(2).all(|pair| pair[0].min < pair[1].min && pair[0].max <= pair[1].min + 0.01),
                "{width}"
            );
            let (first, last) = (columns[0].min, columns[shown - 1].max);
            assert!((first - 7.0).abs() < 0.01 && (last - 7.0 - width).abs() < 0.01, "{width}: {first} to {last}");
            assert!(shown <= before);
            before = shown;
        }
        // The choice for export, the callout, the value and the verdict never give way.
        let least = columns(0.0, 100.0).map(|column| column.is_some());
        assert_eq!(least, [true, false, false, true, true, false, true, false]);
    }
}
