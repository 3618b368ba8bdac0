//! The cells in sight: size ranges down, classes across, heads that stay. The grid takes the focus as a whole.

use eframe::egui::{Align2, Id, Rect, Sense, Ui, vec2};

use super::paint;
use crate::gui::key_names::part_id;
use crate::gui::over_page::just_opened;
use crate::gui::shapes::focus_ring;
use crate::gui::table::grid::{Cells, Grid};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::View;
use crate::length::Length;
use crate::message::{Message, message};
use crate::session::focused::CELLS;
use crate::session::tables::Document;
use crate::session::{TablesAction, TablesCommand};
use crate::tolerance::ToleranceClass;

/// The id of the grid: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    part_id(CELLS)
}

/// The grid in the room that is left.
pub(super) fn grid_ui(ui: &mut Ui, view: &mut View<'_>) {
    let tables = view.session.tables();
    let Some(document) = tables.shown() else { return };
    let head = vec2(space(28.0), space(11.0));
    let cell = vec2(space(17.0), space(10.0));
    let widths = tables.filter.columns.iter().map(|_| cell.x);
    let grid = Grid::new(id(), tables.number(), head, widths, (tables.filter.ranges.len(), cell.y));
    let rect = ui.available_rect_before_wrap();
    let name = view.words.say(&message!("tables-grid").text("name", &document.title));
    let place = grid.place_ui(ui, rect, &name);
    if just_opened(ui, id()) {
        place.request_focus();
    }
    let cells = grid.cells_ui(ui, rect, |ui, cells| {
        body_ui(ui, view, document, (&grid, cells), place.has_focus());
        follow(ui, view, document, cells);
    });
    heads_ui(ui, view, document, rect, &cells);
    if place.has_focus() {
        focus_ring(ui, rect);
    }
}

/// A cell: its column among all, its class, its range, and from where to where that goes.
type DrawnCell = (usize, ToleranceClass, usize, (Length, Length));

/// Draws the cells in sight.
fn body_ui(ui: &Ui, view: &mut View<'_>, document: &Document, (grid, cells): (&Grid, &Cells<'_>), focused: bool) {
    let filter = &view.session.tables().filter;
    for place in cells.columns() {
        let Some(&column) = filter.columns.get(place) else { continue };
        let Some(class) = document.table().columns().get(column) else { continue };
        let decimals = paint::decimals(ui.painter(), &class.cells);
        for row in cells.rows() {
            let Some(&range) = filter.ranges.get(row) else { continue };
            let (Some(&cell), Some(ends)) = (class.cells.get(range), document.range(range)) else { continue };
            let rect = cells.rect(row, place);
            let look = paint::TableCellView {
                palette: palette(ui.ctx()),
                words: view.words,
                decimals,
                cell,
                differs: !document.differences(column, range).is_empty(),
                cursor: (document.selected == Some((class.class, range))).then_some(focused),
                marked: filter.rows.contains(&range),
            };
            paint::cell(ui.painter(), rect, &look);
            cell_ui(ui, view, document, grid, ((column, class.class, range, ends), rect));
        }
    }
}

/// A cell can be clicked; for a screen reader it has a name.
fn cell_ui(ui: &Ui, view: &mut View<'_>, document: &Document, grid: &Grid, (place, rect): (DrawnCell, Rect)) {
    let (_, class, range, _) = place;
    let selected = document.selected == Some((class, range));
    let salt = (class.as_str(), range);
    let click = (rect, Sense::CLICK);
    let response = grid.cell_ui(ui, salt, click, selected, || cell_name(view, document, place));
    if response.clicked() {
        view.send(TablesCommand::Select(class, range));
        ui.memory_mut(|memory| memory.request_focus(id()));
    }
    if response.double_clicked() {
        view.act(TablesAction::EditCell);
    }
}

/// `H7, over 18 up to 30 mm, +21 / 0 µm, differs from ISO 286`.
fn cell_name(view: &View<'_>, document: &Document, (column, class, range, (over, to)): DrawnCell) -> String {
    let figures = match document.cell(class, range) {
        Some(cell) => message!("tables-pair")
            .text("upper", view.words.signed_um(cell.upper()))
            .text("lower", view.words.signed_um(cell.lower())),
        None => message!("tables-no-value"),
    };
    let id = if document.differences(column, range).is_empty() { "tables-cell" } else { "tables-cell-differs" };
    let message = Message::new(id).text("class", class).number("over", over).number("to", to);
    view.words.say(&message.message("figures", figures))
}

/// The selected cell, and a row that the filter names, come into sight when they change; afterwards scrolling is free.
fn follow(ui: &Ui, view: &View<'_>, document: &Document, cells: &Cells<'_>) {
    let filter = &view.session.tables().filter;
    let selected = document.selected.and_then(|(class, range)| {
        let column = document.column(class)?;
        Some((filter.columns.binary_search(&column).ok()?, filter.ranges.binary_search(&range).ok()?))
    });
    let changed = |key: &str, value: Option<(usize, usize)>| {
        let key = id().with((key, view.session.tables().number()));
        let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(key), value));
        value.filter(|value| before != Some(*value))
    };
    if let Some((_, row)) =
        changed("row", filter.rows.first().and_then(|range| Some((0, filter.ranges.binary_search(range).ok()?))))
    {
        cells.look_at_row(ui, row);
    }
    if let Some((place, row)) = changed("cell", selected) {
        cells.look_at(ui, row, place);
    }
}

/// The heads above and on the left, moved along with the cells.
fn heads_ui(ui: &Ui, view: &View<'_>, document: &Document, rect: Rect, cells: &Cells<'_>) {
    let palette = palette(ui.ctx());
    let filter = &view.session.tables().filter;
    let selected = document.selected;
    let class_of = |place: usize| {
        let column = *filter.columns.get(place)?;
        Some((column, document.table().columns().get(column)?.class))
    };
    let corner = cells.heads_ui(
        ui,
        rect,
        |painter, head, place| {
            let Some((column, class)) = class_of(place) else { return };
            let differences = document.differing_in(column);
            let remark = match differences {
                0 if document.is_own_class(class) => view.text("tables-own-class"),
                0 => String::new(),
                count => format!("≠ {count}"),
            };
            let marked = selected.is_some_and(|(selected, _)| selected == class);
            let text = class.as_str();
            let differs = 0 < differences;
            paint::head(painter, head, &paint::Head { palette, text, remark: &remark, differs, marked });
        },
        |painter, head, row| {
            let Some(&range) = filter.ranges.get(row) else { return };
            let Some((over, to)) = document.range(range) else { return };
            let text = format!("{} – {}", view.words.mm(over, 0), view.words.mm(to, 0));
            let marked = filter.rows.contains(&range) || selected.is_some_and(|(_, selected)| selected == range);
            paint::head(painter, head, &paint::Head { palette, text: &text, remark: "", differs: false, marked });
        },
    );
    let font = theme::font(sizes().small);
    ui.painter().text(corner.center(), Align2::CENTER_CENTER, view.text("tables-range-head"), font, palette.quiet.0);
}
