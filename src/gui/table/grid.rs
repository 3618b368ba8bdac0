//! A grid of cells: heads above and on the left that stay, the cells in sight, and a cell at which the keys are. It takes the focus as a
//! whole; what its cells are, and what a click does, is the page's.

use std::fmt::Debug;
use std::hash::Hash;
use std::ops::Range;

use eframe::egui::accesskit::Role;
use eframe::egui::style::ScrollAnimation;
use eframe::egui::{
    Id, Painter, Rangef, Rect, Response, ScrollArea, Sense, Stroke, StrokeKind, Ui, UiBuilder, Vec2, WidgetInfo, pos2,
    vec2,
};

use crate::gui::shapes::{lines_of, times};
use crate::gui::theme::{Hex, palette};
use crate::text::Within as _;

/// A grid as its page declares it.
pub(in crate::gui) struct Grid {
    id: Id,
    /// What its rows and columns are of: another one is scrolled on its own.
    number: usize,
    /// How wide the heads on the left are, and how high those above.
    head: Vec2,
    /// Where each column ends, from the first one on.
    ends: Vec<f32>,
    rows: usize,
    height: f32,
}

/// The cells of a grid where they are drawn.
pub(in crate::gui) struct Cells<'a> {
    grid: &'a Grid,
    /// All of them.
    all: Rect,
    /// What of them is in sight.
    pub seen: Rect,
}

impl Grid {
    /// A grid of so many rows, all as high, below heads of a size.
    pub fn new(
        id: Id,
        number: usize,
        head: Vec2,
        widths: impl Iterator<Item = f32>,
        (rows, height): (usize, f32),
    ) -> Self {
        let ends = widths.scan(0.0, |end, width| {
            *end += width;
            Some(*end)
        });
        Self { id, number, head, ends: ends.collect(), rows, height }
    }

    /// Its place among what takes the focus, and what a screen reader says of it.
    pub fn place_ui(&self, ui: &Ui, rect: Rect, name: &str) -> Response {
        let grid = ui.interact(rect, self.id, Sense::focusable_noninteractive());
        grid.widget_info(|| WidgetInfo::labeled(Role::Grid, true, name));
        grid
    }

    /// The cells below and beside the heads.
    pub fn cells_ui(&self, ui: &mut Ui, rect: Rect, content: impl FnOnce(&mut Ui, &Cells<'_>)) -> Cells<'_> {
        let body = Rect::from_min_max(rect.min + self.head, rect.max);
        let builder = UiBuilder::new().max_rect(body).id_salt((self.id, "body")).accessibility_parent(self.id);
        let output = ui.scope_builder(builder, |ui| {
            // Cut cells look cut already; a fade would cover the selected one.
            ui.spacing_mut().scroll.fade.strength = 0.0;
            let area = ScrollArea::both().id_salt((self.id, self.number)).auto_shrink(false);
            area.show_viewport(ui, |ui, viewport| {
                let size = vec2(self.width_of(self.ends.len()), times(self.height, self.rows));
                let (all, _) = ui.allocate_exact_size(size, Sense::hover());
                content(ui, &Cells { grid: self, all, seen: viewport.translate(all.min.to_vec2()) });
                all
            })
        });
        let output = output.inner;
        Cells { grid: self, all: output.inner, seen: output.inner_rect }
    }

    /// How wide the first so many columns are together.
    fn width_of(&self, columns: usize) -> f32 {
        self.ends.within(..columns).last().map_or(0.0, |end| *end)
    }

    /// A cell has a name for a screen reader, and may be selected. It is no stop for Tab: the grid is one.
    pub fn cell_ui(
        &self,
        ui: &Ui,
        salt: impl Debug + Hash,
        (rect, sense): (Rect, Sense),
        is_selected: bool,
        name: impl Fn() -> String,
    ) -> Response {
        let cell = ui.interact(rect, self.id.with(salt), sense);
        cell.widget_info(|| WidgetInfo::labeled(Role::GridCell, true, name()));
        ui.ctx().accesskit_node_builder(cell.id, |node| node.set_selected(is_selected));
        cell
    }
}

impl Cells<'_> {
    /// The columns in sight.
    pub fn columns(&self) -> Range<usize> {
        let place = |x: f32| self.grid.ends.partition_point(|end| self.all.left() + end < x);
        place(self.seen.left())..(place(self.seen.right()) + 1).min(self.grid.ends.len())
    }

    /// The rows in sight.
    pub fn rows(&self) -> Range<usize> {
        let rows = |y: f32| (y - self.all.top()) / self.grid.height;
        lines_of(rows(self.seen.top()).floor())..lines_of(rows(self.seen.bottom()).ceil()).min(self.grid.rows)
    }

    fn across(&self, column: usize) -> Rangef {
        let edge = |columns: usize| self.all.left() + self.grid.width_of(columns);
        Rangef::new(edge(column), edge(column + 1))
    }

    fn down(&self, row: usize) -> Rangef {
        let top = self.all.top() + times(self.grid.height, row);
        Rangef::new(top, top + self.grid.height)
    }

    /// Where a cell is.
    pub fn rect(&self, row: usize, column: usize) -> Rect {
        Rect::from_x_y_ranges(self.across(column), self.down(row))
    }

    /// A cell comes into sight.
    pub fn look_at(&self, ui: &Ui, row: usize, column: usize) {
        ui.scroll_to_rect_animation(self.rect(row, column), None, ScrollAnimation::none());
    }

    /// A row comes into sight; the columns stay.
    pub fn look_at_row(&self, ui: &Ui, row: usize) {
        let left = ui.clip_rect().left();
        let rect = Rect::from_x_y_ranges(Rangef::new(left, left + 1.0), self.down(row));
        ui.scroll_to_rect_animation(rect, None, ScrollAnimation::none());
    }

    /// The heads above and on the left, moved along with the cells; and the corner between them.
    pub fn heads_ui(
        &self,
        ui: &Ui,
        rect: Rect,
        mut above: impl FnMut(&Painter, Rect, usize),
        mut left: impl FnMut(&Painter, Rect, usize),
    ) -> Rect {
        let seen = self.seen;
        let corner = Rect::from_min_size(rect.min, self.grid.head);
        let painter = ui.painter().with_clip_rect(Rect::from_min_max(pos2(seen.left(), rect.top()), seen.right_top()));
        for column in self.columns() {
            above(&painter, Rect::from_x_y_ranges(self.across(column), corner.y_range()), column);
        }
        let painter =
            ui.painter().with_clip_rect(Rect::from_min_max(pos2(rect.left(), seen.top()), seen.left_bottom()));
        for row in self.rows() {
            left(&painter, Rect::from_x_y_ranges(corner.x_range(), self.down(row)), row);
        }
        ui.painter().rect_filled(corner, 0.0, palette(ui.ctx()).sunken.0);
        corner
    }
}

/// The ground of a cell or a head, within thin lines.
pub(in crate::gui) fn ground(painter: &Painter, rect: Rect, fill: Hex) {
    painter.rect_filled(rect, 0.0, fill.0);
    painter.rect_stroke(rect, 0.0, Stroke::new(0.5, palette(painter.ctx()).line.0), StrokeKind::Middle);
}

/// The ground of a head: marked where the keys are in its row or column.
pub(in crate::gui) fn head_ground(painter: &Painter, rect: Rect, is_marked: bool) {
    let palette = palette(painter.ctx());
    ground(painter, rect, if is_marked { palette.tint } else { palette.sunken });
}

/// The frame of a cell that is not as it should be; a sign goes with it.
pub(in crate::gui) fn wrong_frame(painter: &Painter, rect: Rect) {
    let stroke = Stroke::new(1.5, palette(painter.ctx()).error.0);
    painter.rect_stroke(rect.shrink(1.5), 2.0, stroke, StrokeKind::Inside);
}

/// The frame of the cell at which the keys are: a heavier one while the grid has the focus.
pub(in crate::gui) fn cursor_frame(painter: &Painter, rect: Rect, is_focused: bool) {
    let stroke = Stroke::new(if is_focused { 3.0 } else { 1.5 }, palette(painter.ctx()).focus.0);
    painter.rect_stroke(rect, 2.0, stroke, StrokeKind::Inside);
}
