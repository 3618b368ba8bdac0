//! The cells in sight: a row a feature, heads that stay. The table takes the focus as a whole.

use eframe::egui::accesskit::Invalid;
use eframe::egui::{Context, Event, FocusDirection, Id, Key, Rect, Sense, Ui, vec2};

use super::{column_id, editor, grid_id, paint};
use crate::gui::shapes::{focus_ring, lines_of};
use crate::gui::table::grid::{Cells, Grid};
use crate::gui::theme::{control, palette, space};
use crate::gui::view::View;
use crate::message::{Message, Say as _, message};
use crate::part::{Column, PlanFeature};
use crate::session::PartsCommand;
use crate::session::parts::{PlanCommand, Sheet};
use crate::words::Words;

/// Gives the table the focus when it is drawn next.
pub(in crate::gui) fn focus(ctx: &Context) {
    let frame = ctx.cumulative_frame_nr();
    ctx.data_mut(|data| data.insert_temp(soon(), frame));
    ctx.request_repaint();
}

fn soon() -> Id {
    grid_id().with("soon")
}

/// Gives the table the focus in the next frame: it may be drawn after what was clicked, which would lose it again.
pub(super) fn focus_next(ui: &Ui) {
    focus(ui.ctx());
}

/// A column of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum PlanColumn {
    Of(Column),
    /// What the callout gives; it cannot be edited.
    Limits,
}

impl PlanColumn {
    /// Its width, steps of space.
    const fn width(self) -> f32 {
        match self {
            Self::Of(Column::Number | Column::Axis) => 14.0,
            Self::Of(Column::Name | Column::Parameters) => 30.0,
            Self::Of(Column::X | Column::Y | Column::Z) => 18.0,
            Self::Of(Column::Feature) => 28.0,
            Self::Of(Column::Remark) | Self::Limits => 44.0,
            Self::Of(_) => 24.0,
        }
    }

    fn name(self, view: &View<'_>) -> String {
        match self {
            Self::Of(column) => view.text(&column_id(column)),
            Self::Limits => view.text("parts-page-limits"),
        }
    }
}

/// The columns of the plan, each with what it gives behind it.
fn columns(view: &View<'_>) -> Vec<PlanColumn> {
    let of = |column: &Column| {
        let limits = (*column == Column::Callout).then_some(PlanColumn::Limits);
        std::iter::once(PlanColumn::Of(*column)).chain(limits)
    };
    view.session.parts().sheet.columns.iter().flat_map(of).collect()
}

/// The table in the room that is left.
pub(in crate::gui::parts) fn grid_ui(ui: &mut Ui, view: &mut View<'_>) {
    let columns = columns(view);
    let widths = columns.iter().map(|shown| space(shown.width()));
    let rows = (Sheet::rows(view.session.parts().document.draft()), control(ui));
    let grid = Grid::new(grid_id(), 0, vec2(space(14.0), space(8.0)), widths, rows);
    let rect = ui.available_rect_before_wrap();
    if ui.data(|data| data.get_temp::<u64>(soon()).is_some_and(|frame| frame < ui.ctx().cumulative_frame_nr())) {
        ui.data_mut(|data| data.remove::<u64>(soon()));
        ui.memory_mut(|memory| memory.request_focus(grid_id()));
    }
    leave(ui, view);
    let is_focused = grid.place_ui(ui, rect, &view.text("parts-page-table")).has_focus();
    // The field of the cell takes the focus where it is drawn, which is after this.
    if is_focused && !view.session.parts().sheet.is_editing {
        typed(ui, view);
    }
    let cells = grid.cells_ui(ui, rect, |ui, cells| body_ui(ui, view, &columns, (&grid, cells), is_focused));
    heads_ui(ui, view, &columns, rect, &cells);
    if is_focused {
        focus_ring(ui, rect);
    }
    ui.advance_cursor_after_rect(rect);
}

/// Tab goes from cell to cell, and leaves the table behind its last one.
fn leave(ui: &Ui, view: &View<'_>) {
    let parts = view.session.parts();
    let has_focus = ui.memory(|memory| memory.has_focus(grid_id()));
    let forwards = ui.input(|input| input.key_pressed(Key::Tab).then_some(!input.modifiers.shift));
    if let Some(forwards) = forwards.filter(|_| has_focus)
        && !parts.sheet.can_tab(forwards, parts.document.draft())
    {
        let direction = if forwards { FocusDirection::Next } else { FocusDirection::Previous };
        ui.memory_mut(|memory| memory.move_focus(direction));
    }
}

/// What is typed or pasted while the table has the focus.
fn typed(ui: &Ui, view: &mut View<'_>) {
    let mut text = String::new();
    let mut commands = Vec::new();
    let mut tabs = Vec::new();
    ui.input(|input| {
        for event in &input.events {
            match event {
                Event::Text(typed) => text.push_str(typed),
                Event::Paste(pasted) => commands.push(PlanCommand::Paste(pasted.clone())),
                Event::Cut => commands.extend([PlanCommand::Copy, PlanCommand::Empty]),
                Event::Key { key: Key::Tab, pressed: true, modifiers, .. } => tabs.push(!modifiers.shift),
                _ => {}
            }
        }
    });
    if !text.is_empty() {
        commands.push(PlanCommand::Edit(Some(text)));
    }
    let can = |forwards: &bool| view.session.parts().sheet.can_tab(*forwards, view.session.parts().document.draft());
    commands.extend(tabs.into_iter().filter(can).map(PlanCommand::Tab));
    for command in commands {
        view.send(PartsCommand::Plan(command));
    }
}

/// Draws the cells in sight.
fn body_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    columns: &[PlanColumn],
    (grid, cells): (&Grid, &Cells<'_>),
    is_focused: bool,
) {
    for row in cells.rows() {
        for place in cells.columns() {
            match columns.get(place) {
                Some(PlanColumn::Of(column)) => {
                    cell_ui(ui, view, grid, cells.rect(row, place), (row, *column), is_focused);
                }
                Some(PlanColumn::Limits) => limits_ui(ui, view, grid, cells.rect(row, place), row),
                None => {}
            }
        }
    }
    let (row, column) = view.session.parts().sheet.at();
    let Some(place) = columns.iter().position(|shown| *shown == PlanColumn::Of(column)) else { return };
    follow(ui, view, cells, (row, place));
    if view.session.parts().sheet.is_editing {
        editor::editor_ui(ui, view, cells.rect(row, place));
    }
}

/// The cell comes into sight when the keys have moved, or the table has become lower; afterwards scrolling is free.
fn follow(ui: &Ui, view: &View<'_>, cells: &Cells<'_>, (row, place): (usize, usize)) {
    let moves = (view.session.parts().sheet.moves, lines_of(cells.seen.height()));
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(grid_id().with("moves")), moves));
    if before != moves {
        cells.look_at(ui, row, place);
    }
}

/// A cell can be clicked; for a screen reader it has a name.
fn cell_ui(ui: &Ui, view: &mut View<'_>, grid: &Grid, rect: Rect, (row, column): (usize, Column), is_focused: bool) {
    let parts = view.session.parts();
    let document = &parts.document;
    let sheet = &parts.sheet;
    let text = document.draft().rows.get(row).map_or("", |cells| &cells.cell(column).text);
    let finding = document.finding(row, Some(column));
    let place = sheet.columns.iter().position(|of| *of == column);
    let is_in =
        sheet.selected_rows().contains(&row) && place.is_some_and(|place| sheet.selected_places().contains(&place));
    let is_at = sheet.at() == (row, column);
    let look = paint::PlanCellView {
        palette: palette(ui.ctx()),
        text,
        is_wrong: finding.is_some(),
        is_fixed: false,
        is_figure: column.is_number(),
        is_selected: is_in,
        cursor: is_at.then_some(is_focused),
    };
    paint::cell(ui.painter(), rect, &look);
    let response = grid.cell_ui(ui, (row, column), (rect, Sense::CLICK), is_in, || {
        let cell = if text.trim().is_empty() { "parts-page-cell-empty" } else { "parts-page-cell" };
        let cell = Message::new(cell).count("row", row + 1).text("column", view.text(&column_id(column)));
        let cell = cell.text("text", text);
        let named = match finding {
            Some(finding) => {
                let wrong = message!("parts-page-cell-wrong").message("cell", cell);
                wrong.message("what", finding.what.message())
            }
            None => cell,
        };
        view.words.say(&named)
    });
    // A screen reader says the cell to which the keys go.
    if is_at {
        ui.ctx().accesskit_node_builder(grid_id(), |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    if finding.is_some() {
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_invalid(Invalid::True));
    }
    let extends = ui.input(|input| input.modifiers.shift);
    if response.double_clicked() {
        view.send(PartsCommand::Plan(PlanCommand::Edit(None)));
    } else if response.clicked() {
        view.send(PartsCommand::Plan(PlanCommand::Go(row, column, extends)));
        ui.memory_mut(|memory| memory.request_focus(grid_id()));
    }
}

fn limits_ui(ui: &Ui, view: &View<'_>, grid: &Grid, rect: Rect, row: usize) {
    let feature = view.session.parts().document.feature(row);
    // A row with a fault is no feature, and has no limits to show.
    let text = feature.map_or_else(String::new, |feature| limits(view.words, feature));
    let palette = palette(ui.ctx());
    let look = paint::PlanCellView {
        palette,
        text: &text,
        is_wrong: false,
        is_fixed: true,
        is_figure: false,
        is_selected: false,
        cursor: None,
    };
    paint::cell(ui.painter(), rect, &look);
    grid.cell_ui(ui, (row, "limits"), (rect, Sense::HOVER), false, || {
        let id = if text.is_empty() { "parts-page-cell-empty" } else { "parts-page-cell" };
        let name = Message::new(id).count("row", row + 1).text("column", view.text("parts-page-limits"));
        view.words.say(&name.text("text", &text))
    });
}

/// Minimum and maximum of every size.
fn limits(words: &Words, feature: &PlanFeature) -> String {
    let of =
        |size: &crate::tolerance::Limits| format!("{} … {}", words.mm(size.minimum(), 3), words.mm(size.maximum(), 3));
    feature.limits.iter().map(of).collect::<Vec<_>>().join("; ")
}

/// The heads above and on the left, moved along with the cells.
fn heads_ui(ui: &Ui, view: &mut View<'_>, shown: &[PlanColumn], rect: Rect, cells: &Cells<'_>) {
    let palette = palette(ui.ctx());
    let mut rows = Vec::new();
    let parts = view.session.parts();
    let (row, column) = parts.sheet.at();
    cells.heads_ui(
        ui,
        rect,
        |painter, head, place| {
            if let Some(shown) = shown.get(place) {
                paint::head(painter, head, palette, &shown.name(view), (*shown == PlanColumn::Of(column), false));
            }
        },
        |painter, head, at| {
            let is_new = at == parts.document.draft().rows.len();
            let text = if is_new { view.text("parts-page-new-row") } else { (at + 1).to_string() };
            paint::head(painter, head, palette, &text, (at == row, parts.document.is_wrong(at)));
            if ui.interact(head.intersect(painter.clip_rect()), grid_id().with((at, "head")), Sense::CLICK).clicked() {
                rows.push(at);
            }
        },
    );
    // The head of a row selects all of it; with Shift, all rows between.
    let columns = &parts.sheet.columns;
    if let (Some(at), Some(first), Some(last)) = (rows.pop(), columns.first(), columns.last()) {
        let extends = ui.input(|input| input.modifiers.shift);
        let from = if extends { parts.sheet.at().0 } else { at };
        for (at, column, extends) in [(from, *last, false), (at, *first, true)] {
            view.send(PartsCommand::Plan(PlanCommand::Go(at, column, extends)));
        }
        focus_next(ui);
    }
}
