//! The lines in sight; a click before a block sets a breakpoint. The listing takes the focus as a whole.

use std::ops::Range;

use eframe::egui::accesskit::Role;
use eframe::egui::style::ScrollAnimation;
use eframe::egui::{Id, Rect, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2};

use super::paint;
use crate::gui::key_names::part_id;
use crate::gui::shapes::{focus_ring, times};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, quiet};
use crate::message::message;
use crate::nc::program::Body;
use crate::session::ProgramCommand;
use crate::session::focused::LISTING;
use crate::session::program::{Document, Run, State};
use crate::text::Within as _;

/// How many lines around a block come into sight with it.
const AROUND: f32 = 3.0;

/// The most characters of a line that get room.
const WIDEST: usize = 2_000;

/// The id of the listing: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    part_id(LISTING)
}

fn row_height() -> f32 {
    space(5.5)
}

fn gutter() -> f32 {
    space(10.0)
}

/// The listing in the room that is left.
pub(super) fn listing_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(document) = view.session.program().shown() else {
        quiet(ui, view.text("program-page-nothing"));
        return;
    };
    let rect = ui.available_rect_before_wrap();
    let listing = ui.interact(rect, id(), Sense::focusable_noninteractive());
    let name = message!("program-page-listing").text("name", document.title());
    let name = view.words.say(&name.count("count", document.program.blocks().len()));
    listing.widget_info(|| WidgetInfo::labeled(Role::List, true, &name));
    let area = ScrollArea::both().id_salt(("listing", &document.path)).auto_shrink(false);
    ui.scope_builder(UiBuilder::new().accessibility_parent(id()), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.spacing_mut().scroll.fade.strength = 0.0;
        area.show_rows(ui, row_height(), document.program.line_count(), |ui, rows| {
            rows_ui(ui, view, document, rows, rect);
        });
    });
    if listing.has_focus() {
        focus_ring(ui, rect);
    }
}

fn rows_ui(ui: &mut Ui, view: &mut View<'_>, document: &Document, rows: Range<usize>, seen: Rect) {
    let top = ui.max_rect().top();
    let left = ui.max_rect().left();
    follow(ui, view, top - times(row_height(), rows.start), left);
    let glyph = ui.fonts_mut(|fonts| fonts.glyph_width(&theme::mono(sizes().mono), '0'));
    let width = gutter() + glyph * times(1.0, document.longest_line().min(WIDEST) + 2);
    let width = width.max(ui.available_width());
    let program = view.session.program();
    let run = program.run.as_ref();
    let current = run.and_then(Run::place).filter(|place| place.program == document.path).map(|place| place.block);
    let failed = run.is_some_and(|run| run.state == State::Faulted);
    for line in rows {
        let (rect, _) = ui.allocate_exact_size(vec2(width, row_height()), Sense::hover());
        let block = document.program.block_at(line);
        let begins = block.is_some_and(|block| document.first_line(block) == line);
        let row = VisibleLine { rect, line, block, begins, is_current: block.is_some() && block == current, failed };
        row_ui(ui, view, document, &row, seen);
    }
}

/// A line in sight.
struct VisibleLine {
    rect: Rect,
    line: usize,
    block: Option<usize>,
    begins: bool,
    is_current: bool,
    failed: bool,
}

fn row_ui(ui: &Ui, view: &mut View<'_>, document: &Document, row: &VisibleLine, seen: Rect) {
    let palette = palette(ui.ctx());
    let painter = ui.painter();
    let whole = Rect::from_x_y_ranges(seen.x_range(), row.rect.y_range());
    let is_selected = row.block == Some(document.selected);
    let body = row.block.and_then(|block| document.program.blocks().get(block)).map(|block| &block.body);
    if row.is_current {
        painter.rect_filled(whole, 0.0, palette.tint.0);
    } else if is_selected {
        painter.rect_filled(whole, 0.0, palette.surface.0);
    } else if matches!(body, Some(Body::Heading { .. })) {
        painter.rect_filled(whole, 0.0, palette.sunken.0);
    }
    if is_selected {
        let bar = Rect::from_min_size(whole.left_top(), vec2(3.0, whole.height()));
        painter.rect_filled(bar, 0.0, palette.data.0);
    }
    let text = document.program.line(row.line);
    let line = paint::line(document.program.notation(), text, row.begins, palette);
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(line));
    let y = row.rect.center().y - galley.size().y / 2.0;
    painter.galley(pos2(row.rect.left() + gutter(), y), galley, palette.text.0);
    let Some(block) = row.block.filter(|_| row.begins) else { return };
    marks_ui(ui, view, document, row, block);
}

/// The marks before a block, and what a click does: before it a breakpoint, on it the selection.
fn marks_ui(ui: &Ui, view: &mut View<'_>, document: &Document, row: &VisibleLine, block: usize) {
    let palette = palette(ui.ctx());
    let program = view.session.program();
    let has_breakpoint = program.has_breakpoint(block);
    let half = (gutter() - space(2.0)) / 2.0;
    let dot = Rect::from_min_size(row.rect.left_top() + vec2(space(1.0), 0.0), vec2(half, row.rect.height()));
    if has_breakpoint {
        paint::breakpoint(ui.painter(), dot, palette.error.0);
    }
    if row.is_current {
        paint::current(ui.painter(), dot.translate(vec2(half, 0.0)), row.failed, palette);
    }
    // Not focusable: the listing is one stop for Tab.
    let response = ui.interact(row.rect, id().with(("block", block)), Sense::CLICK);
    let is_selected = block == document.selected;
    response.widget_info(|| WidgetInfo::labeled(Role::ListItem, true, said(view, document, row, has_breakpoint)));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_selected));
    if response.clicked() {
        let in_gutter = response.interact_pointer_pos().is_some_and(|at| at.x < row.rect.left() + gutter());
        view.send(ProgramCommand::Select(block));
        if in_gutter {
            view.send(ProgramCommand::ToggleBreakpoint(Some(block)));
        }
        ui.memory_mut(|memory| memory.request_focus(id()));
    }
}

/// What a screen reader says: the line, and its marks in words.
fn said(view: &View<'_>, document: &Document, row: &VisibleLine, has_breakpoint: bool) -> String {
    let text = document.program.line(row.line).trim();
    let text = text.within(..text.floor_char_boundary(WIDEST));
    let mut said = text.to_owned();
    let marks = [
        (has_breakpoint, "program-page-has-breakpoint"),
        (row.is_current && !row.failed, "program-page-is-current"),
        (row.is_current && row.failed, "program-page-is-failed"),
    ];
    for (_, id) in marks.into_iter().filter(|(is_so, _)| *is_so) {
        said = format!("{said}, {}", view.text(id));
    }
    said
}

/// A block comes into sight when the run or a jump goes there; afterwards scrolling is free.
fn follow(ui: &Ui, view: &View<'_>, top: f32, left: f32) {
    let (number, line) = view.session.program().look();
    let key = id().with("look");
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(key), number));
    if before == number {
        return;
    }
    let y = top + times(row_height(), line);
    let around = vec2(0.0, row_height() * AROUND);
    let rect = Rect::from_min_size(pos2(left, y), vec2(1.0, row_height())).expand2(around);
    ui.scroll_to_rect_animation(rect, None, ScrollAnimation::none());
}
