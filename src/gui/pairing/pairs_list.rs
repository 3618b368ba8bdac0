//! Middle, below: the pairs in sight. The list takes the focus as a whole.

use std::ops::Range;

use eframe::egui::accesskit::Role;
use eframe::egui::style::ScrollAnimation;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{FontId, Id, Painter, Rangef, Rect, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2};

use crate::gui::shapes::{focus_ring, times};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, focus_soon, quiet, take_focus};
use crate::message::message;
use crate::session::{PairRow, Paired, PairingCommand};

/// The id of the list: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    Id::unique("pairs-list")
}

/// Hole, its size, shaft, its size, clearance, from the middle, remark.
const COLUMNS: usize = 7;

/// Whether a column has figures: they stand at the right.
const IS_FIGURE: [bool; COLUMNS] = [false, true, false, true, true, true, false];

/// The columns within a width; one that has no room is left out. The distance from the middle gives way first, then the
/// sizes: the row says it all under the pointer. A remark is only wanted where there is one.
fn columns(left: f32, width: f32, has_remarks: bool) -> [Option<Rangef>; COLUMNS] {
    const GIVE_WAY: [usize; 3] = [5, 3, 1];
    let mut wanted = [20.0, 19.0, 20.0, 19.0, 26.0, 28.0, 34.0].map(space);
    if let [.., remark] = &mut wanted
        && !has_remarks
    {
        *remark = 0.0;
    }
    for column in GIVE_WAY {
        if wanted.iter().sum::<f32>() <= width {
            break;
        }
        if let Some(wanted) = wanted.get_mut(column) {
            *wanted = 0.0;
        }
    }
    // On a wide screen a size stays near its name.
    let factor = (width / wanted.iter().sum::<f32>()).clamp(0.0, 1.6);
    let mut from = left;
    wanted.map(|wanted| {
        let column = Rangef::new(from, from + wanted * factor);
        from = column.max;
        (0.0 < wanted).then_some(column)
    })
}

/// Heads and rows in the room that is left.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>, paired: &Paired) {
    let room = ui.available_rect_before_wrap();
    // The scroll bar floats: it must not cover the last column.
    let columns = columns(room.left(), room.width() - space(3.0), 0 < paired.simulated);
    let heads = Rect::from_min_size(room.min, vec2(room.width(), sizes().small * 2.0));
    heads_ui(ui, view, &columns, heads);
    let rect = Rect::from_min_max(heads.left_bottom(), room.max);
    take_focus(ui, id());
    let list = ui.interact(rect, id(), Sense::focusable_noninteractive());
    list.widget_info(|| WidgetInfo::labeled(Role::Grid, true, view.text("pairing-page-list")));
    ui.scope_builder(UiBuilder::new().max_rect(rect).id_salt("pairs-body"), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.spacing_mut().scroll.fade.strength = 0.0;
        if paired.count() == 0 {
            quiet(ui, view.text("pairing-page-no-pair"));
        }
        let area = ScrollArea::vertical().id_salt("pairs-rows").auto_shrink(false).min_scrolled_height(0.0);
        area.show_rows(ui, control(ui), paired.count(), |ui, places| rows_ui(ui, view, paired, &columns, places));
    });
    if list.has_focus() {
        focus_ring(ui, rect);
    }
}

/// The names of the columns.
fn heads_ui(ui: &Ui, view: &View<'_>, columns: &[Option<Rangef>; COLUMNS], rect: Rect) {
    let (hole, shaft) = (view.text("pairing-page-hole"), view.text("pairing-page-shaft"));
    let with_unit = |id: &str| format!("{}, µm", view.text(id));
    let (clearance, from_middle) = (with_unit("pairing-page-clearance"), with_unit("pairing-page-from-middle-head"));
    let heads = [hole, "mm".to_owned(), shaft, "mm".to_owned(), clearance, from_middle, String::new()];
    let (font, colour) = (theme::font(sizes().small), palette(ui.ctx()).quiet);
    for ((head, column), is_figure) in heads.iter().zip(columns).zip(IS_FIGURE) {
        if let Some(column) = column {
            let cell = Rect::from_x_y_ranges(*column, rect.y_range());
            text_ui(ui.painter(), cell, (head, &font, colour), is_figure);
        }
    }
}

fn rows_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    paired: &Paired,
    columns: &[Option<Rangef>; COLUMNS],
    places: Range<usize>,
) {
    let (left, width) = (ui.max_rect().left(), ui.available_width());
    follow(ui, view, ui.max_rect().top() - times(control(ui), places.start), left);
    for place in places {
        let (rect, _) = ui.allocate_exact_size(vec2(width, control(ui)), Sense::hover());
        if let Some(row) = paired.row(place) {
            row_ui(ui, view, columns, &Drawn { rect, place, cells: cells(view, paired, row) });
        }
    }
}

/// A row in sight.
struct Drawn {
    rect: Rect,
    place: usize,
    cells: [String; COLUMNS],
}

fn cells(view: &View<'_>, paired: &Paired, row: PairRow<'_>) -> [String; COLUMNS] {
    let words = view.words;
    let [hole, shaft, clearance, from_middle] = paired.figures(row).map(|figure| words.number(&figure));
    [
        paired.hole_name(row.hole, words),
        hole,
        paired.shaft_name(row.shaft, words),
        shaft,
        clearance,
        from_middle,
        row.remark().map(|remark| words.say(&remark)).unwrap_or_default(),
    ]
}

fn row_ui(ui: &Ui, view: &mut View<'_>, columns: &[Option<Rangef>; COLUMNS], row: &Drawn) {
    let (palette, painter) = (palette(ui.ctx()), ui.painter());
    let is_selected = view.session.pairing().selected() == Some(row.place);
    if is_selected || row.place % 2 == 1 {
        let ground = if is_selected { palette.selection } else { palette.background };
        painter.rect_filled(row.rect, 0.0, ground.0);
    }
    if is_selected {
        let bar = Rect::from_min_size(row.rect.left_top(), vec2(3.0, row.rect.height()));
        painter.rect_filled(bar, 0.0, palette.accent.0);
    }
    // Not focusable: the list is one stop for Tab.
    let response = ui.interact(row.rect, id().with(row.place), Sense::CLICK);
    let said = said(view, &row.cells);
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, &said));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_selected));
    if is_selected {
        ui.ctx().accesskit_node_builder(id(), |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    let font = theme::font(sizes().body);
    let mut is_cut = false;
    for ((text, column), is_figure) in row.cells.iter().zip(columns).zip(IS_FIGURE) {
        is_cut |= match column {
            Some(column) => {
                let cell = Rect::from_x_y_ranges(*column, row.rect.y_range());
                text_ui(painter, cell, (text, &font, palette.text), is_figure)
            }
            None => !text.is_empty(),
        };
    }
    let clicked = response.clicked();
    if is_cut {
        response.on_hover_text(said);
    }
    if clicked {
        view.send(PairingCommand::Select(row.place));
        focus_soon(ui, id());
    }
}

/// A text in one line of a cell, figures at the right; returns whether it was cut.
fn text_ui(painter: &Painter, cell: Rect, (text, font, colour): (&str, &FontId, theme::Hex), is_figure: bool) -> bool {
    let cell = cell.shrink2(vec2(space(1.5), 0.0));
    let mut job = LayoutJob::simple_singleline(text.to_owned(), font.clone(), colour.0);
    job.wrap = TextWrapping::truncate_at_width(cell.width().max(0.0));
    let galley = painter.layout_job(job);
    let is_cut = galley.elided;
    let left = if is_figure { cell.right() - galley.size().x } else { cell.left() };
    painter.galley(pos2(left, cell.center().y - galley.size().y / 2.0), galley, colour.0);
    is_cut
}

/// What a screen reader says of a row.
fn said(view: &View<'_>, cells: &[String; COLUMNS]) -> String {
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

/// The selected pair comes into sight when it changes; afterwards scrolling is free.
fn follow(ui: &Ui, view: &View<'_>, top: f32, left: f32) {
    let (number, place) = view.session.pairing().look();
    let key = id().with("look");
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(key), number));
    let Some(place) = place.filter(|_| before != number) else { return };
    let row = Rect::from_min_size(pos2(left, top + times(control(ui), place)), vec2(1.0, control(ui)));
    ui.scroll_to_rect_animation(row, None, ScrollAnimation::none());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_fill_the_width_and_give_way_one_after_another() {
        for (width, shown, with_remarks) in [(800.0, 6, 7), (560.0, 6, 6), (500.0, 5, 5), (400.0, 4, 4), (200.0, 3, 4)]
        {
            let columns_of = |has| columns(7.0, width, has).into_iter().flatten().collect::<Vec<Rangef>>();
            for has_remarks in [false, true] {
                let columns = columns_of(has_remarks);
                let joined = columns.windows(2).all(|two| (two[0].max - two[1].min).abs() < 0.01);
                let (first, last) = (columns[0].min, columns[columns.len() - 1].max);
                assert!(joined && (first - 7.0).abs() < 0.01 && (last - 7.0 - width).abs() < 0.01, "{width}");
            }
            assert_eq!((columns_of(false).len(), columns_of(true).len()), (shown, with_remarks), "{width}");
        }
    }
}
