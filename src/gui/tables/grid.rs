//! The cells in sight: size ranges down, classes across, heads that stay. The grid takes the focus as a whole.

use crate::session::TablesAction;
use eframe::egui::accesskit::Role;
use eframe::egui::scroll_area::ScrollAreaOutput;
use eframe::egui::style::ScrollAnimation;
use eframe::egui::{Align2, Id, Pos2, Rect, ScrollArea, Sense, Ui, UiBuilder, Vec2, WidgetInfo, pos2, vec2};

use super::paint;
use crate::gui::dialogs::just_opened;
use crate::gui::shapes::{focus_ring, times};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::View;
use crate::message::{Message, message};
use crate::session::TablesCommand;
use crate::session::tables::Document;
use crate::tolerance::ToleranceClass;

/// The id of the grid: it takes the focus as a whole.
pub(in crate::gui) fn id() -> Id {
    Id::unique("table-grid")
}

/// Sizes of the grid, points.
struct Measures {
    head: Vec2,
    cell: Vec2,
}

impl Measures {
    fn new() -> Self {
        Self { head: vec2(space(28.0), space(11.0)), cell: vec2(space(17.0), space(10.0)) }
    }
}

/// The grid in the room that is left.
pub(super) fn grid_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(document) = view.session.tables().shown() else { return };
    let measures = Measures::new();
    let rect = ui.available_rect_before_wrap();
    let grid = ui.interact(rect, id(), Sense::focusable_noninteractive());
    let name = view.words.say(&message!("tables-grid").text("name", document.title()));
    grid.widget_info(|| WidgetInfo::labeled(Role::Grid, true, &name));
    if just_opened(ui, id()) {
        grid.request_focus();
    }
    let body = Rect::from_min_max(rect.min + measures.head, rect.max);
    let room = UiBuilder::new().max_rect(body).id_salt("table-body");
    let output = ui.scope_builder(room, |ui| {
        // Cut cells look cut already; a fade would cover the selected one.
        ui.spacing_mut().scroll.fade.strength = 0.0;
        let number = view.session.tables().number();
        let area = ScrollArea::both().id_salt(("table", number)).auto_shrink(false);
        area.show_viewport(ui, |ui, viewport| body_ui(ui, view, &measures, viewport, grid.has_focus()))
    });
    heads_ui(ui, view, document, &measures, rect, &output.inner);
    if grid.has_focus() {
        focus_ring(ui, rect);
    }
}

/// A cell that was drawn.
struct Place {
    column: usize,
    range: usize,
    class: ToleranceClass,
    rect: Rect,
}

/// Draws the cells that the viewport shows; returns where the first one is.
fn body_ui(ui: &mut Ui, view: &mut View<'_>, measures: &Measures, viewport: Rect, focused: bool) -> Pos2 {
    let Some(document) = view.session.tables().shown() else { return viewport.min };
    let filter = view.session.tables().filter();
    let rows = document.table().ends().len();
    let (wide, high) = (times(measures.cell.x, filter.columns().len()), times(measures.cell.y, rows));
    let (content, _) = ui.allocate_exact_size(vec2(wide, high), Sense::hover());
    let origin = content.min;
    let seen = viewport.translate(origin.to_vec2());
    for (place, &column) in filter.columns().iter().enumerate() {
        let x = origin.x + times(measures.cell.x, place);
        if x + measures.cell.x < seen.left() || seen.right() < x {
            continue;
        }
        let Some(class) = document.table().columns().get(column) else { continue };
        let decimals = paint::decimals(ui.painter(), &class.cells);
        for (range, &cell) in class.cells.iter().enumerate() {
            let y = origin.y + times(measures.cell.y, range);
            if y + measures.cell.y < seen.top() || seen.bottom() < y {
                continue;
            }
            let rect = Rect::from_min_size(pos2(x, y), measures.cell);
            let selected = match (document.selected() == Some((class.class, range)), focused) {
                (false, _) => paint::Selection::None,
                (true, false) => paint::Selection::Selected,
                (true, true) => paint::Selection::Focused,
            };
            let look = paint::Look {
                palette: palette(ui.ctx()),
                words: view.words,
                decimals,
                cell,
                differs: !document.differences(column, range).is_empty(),
                selected,
                marked: filter.rows().contains(&range),
            };
            paint::cell(ui.painter(), rect, &look);
            cell_ui(ui, view, document, &Place { column, range, class: class.class, rect });
        }
    }
    follow(ui, view, document, measures, content);
    origin
}

/// A cell can be clicked; for a screen reader it has a name.
fn cell_ui(ui: &Ui, view: &mut View<'_>, document: &Document, place: &Place) {
    let cell_id = id().with((place.class.as_str(), place.range));
    // Not focusable: the grid is one stop for Tab.
    let response = ui.interact(place.rect, cell_id, Sense::CLICK);
    let selected = document.selected() == Some((place.class, place.range));
    response.widget_info(|| WidgetInfo::labeled(Role::GridCell, true, cell_name(view, document, place)));
    ui.ctx().accesskit_node_builder(cell_id, |node| node.set_selected(selected));
    if response.clicked() {
        view.send(TablesCommand::Select(place.class, place.range));
        ui.memory_mut(|memory| memory.request_focus(id()));
    }
    if response.double_clicked() {
        view.act(TablesAction::EditCell);
    }
}

/// `H7, over 18 up to 30 mm, +21 / 0 µm, differs from ISO 286`.
fn cell_name(view: &View<'_>, document: &Document, place: &Place) -> String {
    let (over, to) = document.range(place.range).unwrap_or_default();
    let figures = match document.cell(place.class, place.range) {
        Some(cell) => message!("tables-pair")
            .text("upper", view.words.signed_um(cell.upper()))
            .text("lower", view.words.signed_um(cell.lower())),
        None => message!("tables-no-value"),
    };
    let id =
        if document.differences(place.column, place.range).is_empty() { "tables-cell" } else { "tables-cell-differs" };
    let message = Message::new(id).text("class", place.class).number("over", over).number("to", to);
    view.words.say(&message.message("figures", figures))
}

/// The selected cell, and a row that the filter names, come into sight when they change; afterwards scrolling is free.
fn follow(ui: &Ui, view: &View<'_>, document: &Document, measures: &Measures, content: Rect) {
    let filter = view.session.tables().filter();
    let selected = document.selected().and_then(|(class, range)| {
        let column = document.column(class)?;
        Some((filter.columns().binary_search(&column).ok()?, range))
    });
    let changed = |key: &str, value: Option<(usize, usize)>| {
        let key = id().with((key, view.session.tables().number()));
        let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(key), value));
        value.filter(|value| before != Some(*value))
    };
    let row = changed("row", filter.rows().first().map(|row| (0, *row))).map(|(_, row)| (None, row));
    let cell = changed("cell", selected).map(|(place, row)| (Some(place), row));
    for (place, row) in row.into_iter().chain(cell) {
        let y = content.top() + times(measures.cell.y, row);
        let (left, width) = match place {
            Some(place) => (content.left() + times(measures.cell.x, place), measures.cell.x),
            None => (ui.clip_rect().left(), 1.0),
        };
        let rect = Rect::from_min_size(pos2(left, y), vec2(width, measures.cell.y));
        ui.scroll_to_rect_animation(rect, None, ScrollAnimation::none());
    }
}

/// The heads above and on the left, moved along with the cells.
fn heads_ui(
    ui: &Ui,
    view: &View<'_>,
    document: &Document,
    measures: &Measures,
    rect: Rect,
    cells: &ScrollAreaOutput<Pos2>,
) {
    let palette = palette(ui.ctx());
    let (filter, seen) = (view.session.tables().filter(), cells.inner_rect);
    let origin = cells.inner;
    let selected = document.selected();
    let above = ui.painter().with_clip_rect(Rect::from_min_max(pos2(seen.left(), rect.top()), seen.right_top()));
    for (place, &column) in filter.columns().iter().enumerate() {
        let corner = pos2(origin.x + times(measures.cell.x, place), rect.top());
        let head = Rect::from_min_size(corner, vec2(measures.cell.x, measures.head.y));
        let Some(class) = document.table().columns().get(column).map(|column| column.class) else { continue };
        if !head.intersects(above.clip_rect()) {
            continue;
        }
        let differences = document.differing_in(column);
        let remark = match differences {
            0 if document.is_own_class(class) => view.text("tables-own-class"),
            0 => String::new(),
            count => format!("≠ {count}"),
        };
        let marked = selected.is_some_and(|(selected, _)| selected == class);
        let (text, differs) = (class.as_str(), 0 < differences);
        paint::head(&above, head, &paint::Head { palette, text, remark: &remark, differs, marked });
    }
    let left = ui.painter().with_clip_rect(Rect::from_min_max(pos2(rect.left(), seen.top()), seen.left_bottom()));
    for range in 0..document.table().ends().len() {
        let corner = pos2(rect.left(), origin.y + times(measures.cell.y, range));
        let head = Rect::from_min_size(corner, vec2(measures.head.x, measures.cell.y));
        if !head.intersects(left.clip_rect()) {
            continue;
        }
        let (over, to) = document.range(range).unwrap_or_default();
        let text = format!("{} – {}", view.words.mm(over, 0), view.words.mm(to, 0));
        let marked = filter.rows().contains(&range) || selected.is_some_and(|(_, selected)| selected == range);
        paint::head(&left, head, &paint::Head { palette, text: &text, remark: "", differs: false, marked });
    }
    let corner = Rect::from_min_size(rect.min, measures.head);
    ui.painter().rect_filled(corner, 0.0, palette.background.0);
    let font = theme::font(sizes().small);
    ui.painter().text(corner.center(), Align2::CENTER_CENTER, view.text("tables-range-head"), font, palette.quiet.0);
}
