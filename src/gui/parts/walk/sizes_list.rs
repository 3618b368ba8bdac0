//! Middle: every size of the part with its verdict. The list takes the focus as a whole.

use eframe::egui::accesskit::Role;
use eframe::egui::style::ScrollAnimation;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{Id, Rangef, Rect, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2};

use super::asked_text;
use crate::gui::shapes::{self, focus_ring, times};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::colours;
use crate::gui::view::{Digits, View, quiet};
use crate::message::message;
use crate::session::parts::{WalkCommand, WalkRow, Walking};
use crate::verdict::Status;

/// The id of the list.
pub(in crate::gui) fn id() -> Id {
    Id::unique("walk-sizes")
}

/// What a row says.
struct Cells {
    status: Option<Status>,
    is_simulated: bool,
    name: String,
    asked: String,
    value: String,
    deviation: String,
    remark: String,
}

/// Name, what is asked, value, deviation, remark.
const COLUMNS: usize = 5;

/// Whether a column has figures: they stand at the right.
const IS_FIGURE: [bool; COLUMNS] = [false, false, true, true, false];

/// The columns within a width, behind the mark of the verdict, whatever is in them; one that has no room is left out: the remark, which is
/// narrower first, then the deviation, then what is asked. The row says it all under the pointer.
fn columns(left: f32, width: f32) -> [Option<Rangef>; COLUMNS] {
    const GIVE_WAY: [usize; 3] = [4, 3, 1];
    const REMARK: [f32; 2] = [14.0, 36.0];
    let mut wanted = [23.0, 18.0, 20.0, 18.0, 0.0].map(space);
    let (mark, bar) = (space(10.0), space(3.0));
    let room = (width - mark - bar).max(0.0);
    let left_over = room - wanted.iter().sum::<f32>();
    if let Some(remark) = wanted.last_mut() {
        *remark = left_over.clamp(space(REMARK[0]), space(REMARK[1]));
    }
    for column in GIVE_WAY {
        if wanted.iter().sum::<f32>() <= room {
            break;
        }
        if let Some(wanted) = wanted.get_mut(column) {
            *wanted = 0.0;
        }
    }
    // On a wide screen a value stays near its name.
    let factor = (room / wanted.iter().sum::<f32>().max(1.0)).clamp(0.0, 1.6);
    let mut from = left + mark;
    wanted.map(|wanted| {
        let column = Rangef::new(from, from + wanted * factor);
        from = column.max;
        (0.0 < wanted).then_some(column)
    })
}

/// The list in the room that is left.
pub(super) fn sizes_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = session.parts().walking();
    if !walking.is_begun() {
        quiet(ui, view.text("walk-page-no-part"));
        return;
    }
    let rect = ui.available_rect_before_wrap();
    let list = ui.interact(rect, id(), Sense::focusable_noninteractive());
    list.widget_info(|| WidgetInfo::labeled(Role::Grid, true, view.text("walk-page-sizes")));
    ui.scope_builder(UiBuilder::new().max_rect(rect).id_salt("walk-body"), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.spacing_mut().scroll.fade.strength = 0.0;
        let area = ScrollArea::vertical().id_salt("walk-rows").auto_shrink(false).min_scrolled_height(0.0);
        area.show_rows(ui, control(ui), walking.count(), |ui, places| {
            follow(ui, walking, ui.max_rect().top() - times(control(ui), places.start));
            let columns = columns(ui.max_rect().left(), ui.available_width());
            for place in places {
                row_ui(ui, view, walking, &columns, place);
            }
        });
    });
    if list.has_focus() {
        focus_ring(ui, rect);
    }
}

fn cells(view: &View<'_>, walking: &Walking, place: usize) -> Option<Cells> {
    let words = view.words;
    walking.with_row(place, |WalkRow { size, step, value }| {
        let number = &size.feature.number;
        let name = if number.is_empty() { size.name() } else { format!("{number}  {}", size.name()) };
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
        Cells {
            status: record.map(|record| record.verdict.status()),
            is_simulated,
            name,
            asked,
            value: record.map(|record| digits.mm(words, record.measurement.diameter, 3)).unwrap_or_default(),
            deviation: value
                .map(|value| format!("{} µm", digits.signed_um(words, Walking::deviation(value))))
                .unwrap_or_default(),
            remark: remarks.join(", "),
        }
    })
}

fn row_ui(ui: &mut Ui, view: &mut View<'_>, walking: &Walking, columns: &[Option<Rangef>; COLUMNS], place: usize) {
    let width = ui.available_width();
    let (rect, _) = ui.allocate_exact_size(vec2(width, control(ui)), Sense::hover());
    let Some(cells) = cells(view, walking, place) else { return };
    let (palette, painter) = (palette(ui.ctx()), ui.painter().clone());
    let is_selected = walking.at() == Some(place);
    if is_selected || place % 2 == 1 {
        let ground = if is_selected { palette.selection } else { palette.background };
        painter.rect_filled(rect, 0.0, ground.0);
    }
    if is_selected {
        painter.rect_filled(Rect::from_min_size(rect.left_top(), vec2(3.0, rect.height())), 0.0, palette.accent.0);
    }
    // Not focusable: the list is one stop for Tab.
    let response = ui.interact(rect, id().with(place), Sense::CLICK);
    let said = said(view, &cells);
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, &said));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_selected));
    if is_selected {
        ui.ctx().accesskit_node_builder(id(), |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    let mark = Rect::from_center_size(pos2(rect.left() + space(5.0), rect.center().y), vec2(space(5.0), space(5.0)));
    if cells.status.is_some() {
        let (fill, colour) = colours(palette, cells.status, cells.is_simulated);
        painter.rect_filled(mark, 2.0, fill);
        shapes::status(&painter, mark.shrink(1.0), cells.status, colour);
        if cells.is_simulated {
            shapes::dashed_frame(&painter, mark, colour);
        }
    }
    let mut is_cut = false;
    let sign = view.words.language().decimal_sign();
    let texts = [&cells.name, &cells.asked, &cells.value, &cells.deviation, &cells.remark];
    for ((text, column), is_figure) in texts.into_iter().zip(columns).zip(IS_FIGURE) {
        is_cut |= match column {
            Some(column) => {
                let cell = Rect::from_x_y_ranges(*column, rect.y_range());
                text_ui(&painter, cell, text, is_figure.then_some(sign), palette.text)
            }
            None => !text.is_empty(),
        };
    }
    let is_clicked = response.clicked();
    if is_cut {
        response.on_hover_text(said);
    }
    if is_clicked {
        // The field of the value gets the focus: what a gauge types next is of this size.
        view.send(WalkCommand::Go(place));
    }
}

/// A text in one line of a cell, figures at the right with their decimal signs below each other; returns whether it was cut.
fn text_ui(painter: &eframe::egui::Painter, cell: Rect, text: &str, figure: Option<char>, colour: theme::Hex) -> bool {
    /// What most figures have behind the decimal sign.
    const DECIMALS: &str = "0000";
    let cell = cell.shrink2(vec2(space(1.0), 0.0));
    let mut job = LayoutJob::simple_singleline(text.to_owned(), theme::font(sizes().body), colour.0);
    job.wrap = TextWrapping::truncate_at_width(cell.width().max(0.0));
    let galley = painter.layout_job(job);
    let is_cut = galley.elided;
    let width = |text: String| painter.layout_no_wrap(text, theme::font(sizes().body), colour.0).size().x;
    let left = match figure {
        // A micrometre has its unit behind it, and no decimals as a rule.
        Some(sign) if !text.contains(' ') && text.contains(sign) => {
            let behind = text.rsplit(sign).next().unwrap_or_default().to_owned();
            let short = (width(DECIMALS.to_owned()) - width(behind)).max(0.0);
            (cell.right() - galley.size().x - short).max(cell.left())
        }
        Some(_) => cell.right() - galley.size().x,
        None => cell.left(),
    };
    painter.galley(pos2(left, cell.center().y - galley.size().y / 2.0), galley, colour.0);
    is_cut
}

/// What a screen reader says of a row.
fn said(view: &View<'_>, cells: &Cells) -> String {
    let status = cells.status.map_or_else(|| view.text("walk-page-open"), |status| view.words.told(&status));
    let value = if cells.value.is_empty() { String::new() } else { format!("{} mm", cells.value) };
    let parts = [&cells.name, &cells.asked, &status, &value, &cells.deviation, &cells.remark];
    parts.into_iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join(", ")
}

/// The size that is asked for comes into sight when it changes; afterwards scrolling is free.
fn follow(ui: &Ui, walking: &Walking, top: f32) {
    let (number, place) = walking.look();
    let key = id().with("look");
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(key), number));
    let Some(place) = place.filter(|_| before != number) else { return };
    let row = Rect::from_min_size(pos2(ui.max_rect().left(), top + times(control(ui), place)), vec2(1.0, control(ui)));
    ui.scroll_to_rect_animation(row, None, ScrollAnimation::none());
}
