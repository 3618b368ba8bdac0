//! The table page: tables of deviations against ISO 286.
//!
//! | file | what |
//! |---|---|
//! | `tool_bar` | above: which table, what is shown of it, tools; below: whether it agrees with ISO 286 |
//! | `grid` | middle: the cells in sight, and the keys that walk through them |
//! | `paint` | how a cell and a head look |
//! | `cell_panel` | right: the selected cell against ISO 286, and its fields |
//! | `classes_panel` | right, below: classes from ISO 286 as columns or as a new table |

mod cell_panel;
mod classes_panel;
mod grid;
mod paint;
mod tool_bar;

use eframe::egui::{Frame, Panel, ScrollArea, Ui};

use super::columns::{Side, bar_ui, panel_ui, rest_ui};
use super::keypad::{self, keypad_ui};
use super::theme::{Icon, space};
use super::view::View;
use crate::gui::page::{Group, PageView, open};
use crate::session::{Purpose, TablesAction};

pub(super) const PAGE: PageView = PageView {
    action: |_| TablesAction::OpenTable.into(),
    opened: |view| view.session.tables().shown().iter().map(|document| document.title.clone()).collect(),
    dropped: |_view, path, _number| open(Purpose::OpenTable, path),
    ..PageView::of(Group::Design, Icon::Table, tables_ui)
};

/// The page: above which table, middle its cells, right the selected cell.
fn tables_ui(ui: &mut Ui, view: &mut View<'_>) {
    let size = ui.available_size();
    bar_ui(ui, view, Side::Top, "table-tools", tool_bar::tool_bar_ui);
    let strip = Panel::bottom("table-strip").resizable(false).show_separator_line(false).frame(Frame::NONE);
    strip.show(ui, |ui| tool_bar::strip_ui(ui, view));
    let side = if size.x < 1200.0 { space(75.0) } else { space(84.0) };
    let most = (size.x * 0.6).max(space(50.0));
    let sizes = (side.min(most).max(keypad::width(view)), space(50.0)..=most);
    panel_ui(ui, view, Side::Right, "table-cell", sizes, |ui, view| {
        keypad_ui(ui, view);
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            // The scroll bar floats: it must not cover the fields.
            ui.set_max_width(ui.available_width() - space(2.5));
            cell_panel::cell_panel_ui(ui, view);
            ui.separator();
            classes_panel::classes_panel_ui(ui, view);
        });
    });
    rest_ui(ui, view, grid::grid_ui);
}
