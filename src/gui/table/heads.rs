//! The names above the columns: some sort, and say how; their edges are dragged.

use eframe::egui::accesskit::{Role, SortDirection};
use eframe::egui::{
    Align, Button, CursorIcon, Layout, Rangef, Rect, RichText, Sense, Stroke, Ui, UiBuilder, WidgetInfo, vec2,
};

use super::columns::{self, Across, Column, Head, Kind, Own};
use super::rows::{PAD, text_in};
use super::{BAR, Table};
use crate::gui::theme::{self, palette, row, sizes, space};
use crate::gui::view::View;
use crate::message::Message;
use crate::session::Action;

/// How near an edge the pointer takes it.
const NEAR: f32 = 4.0;

/// The height of the heads; none where no column has one.
pub(super) fn height(ui: &Ui, columns: &[Column]) -> f32 {
    let has = |of: fn(&Head) -> bool| columns.iter().any(|column| of(&column.head));
    if has(|head| matches!(head, Head::Sorts(..))) {
        row(ui)
    } else if has(|head| *head != Head::Text(None, None)) {
        space(6.0)
    } else {
        0.0
    }
}

/// Where the columns stand, with the widths that the user gave them.
pub(super) fn across(ui: &Ui, table: &Table<'_>, room: (f32, f32)) -> Across {
    columns::across(table.columns, table.stretch, &own(ui, table), room)
}

/// The widths that the user gave the columns; they are kept, also over a restart.
fn own(ui: &Ui, table: &Table<'_>) -> Own {
    // Who never moved an edge has given none.
    ui.data_mut(|data| data.get_persisted(table.id.with("widths"))).unwrap_or_default()
}

/// The heads, and the edges between them.
pub(super) fn heads_ui(ui: &mut Ui, view: &mut View<'_>, table: &Table<'_>, across: &Across, rect: Rect) {
    if rect.height() < 1.0 {
        return;
    }
    for (number, (column, across)) in table.columns.iter().zip(across).enumerate() {
        let Some(across) = across else { continue };
        let cell = Rect::from_x_y_ranges(*across, rect.y_range());
        match column.head {
            Head::Sorts(action, unit) => sort_ui(ui, view, (action, unit), table.sorted, cell, number),
            Head::Text(id, unit) => {
                let parts = id.map(|id| view.text(id)).into_iter().chain(unit.map(str::to_owned));
                let text = parts.collect::<Vec<_>>().join(", ");
                let is_left = matches!(column.kind, Kind::Text | Kind::Verdict | Kind::Zone);
                let kind = if is_left { Kind::Text } else { Kind::Figure };
                let font = theme::font(sizes().small);
                let colour = palette(ui.ctx()).quiet.0;
                text_in(ui.painter(), cell.shrink2(vec2(PAD, 0.0)), &text, (&font, colour), (kind, None));
            }
        }
    }
    edges_ui(ui, table, across, rect);
}

/// A head that sorts by its column, and says so.
fn sort_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (action, unit): (Action, Option<&str>),
    sorted: Option<(Action, bool)>,
    cell: Rect,
    number: usize,
) {
    let name = std::iter::once(action.text(view.session, view.words)).chain(unit.map(str::to_owned));
    let name = name.collect::<Vec<_>>().join(", ");
    let told = |id| view.words.say(&Message::new(id).text("column", &name));
    let (shown, said, direction) = match sorted.filter(|(by, _)| *by == action) {
        None => (name.clone(), name.clone(), None),
        Some((_, true)) => (format!("{name} ↑"), told("history-ascending"), Some(SortDirection::Ascending)),
        Some((_, false)) => (format!("{name} ↓"), told("history-descending"), Some(SortDirection::Descending)),
    };
    let colour = if direction.is_some() { palette(ui.ctx()).text.0 } else { palette(ui.ctx()).quiet.0 };
    let text = RichText::new(shown).font(theme::font(sizes().small)).color(colour);
    let room = UiBuilder::new().max_rect(cell).id_salt(("head", number));
    ui.scope_builder(room.layout(Layout::left_to_right(Align::Center)), |ui| {
        ui.spacing_mut().button_padding.x = PAD;
        let button = Button::new(text).frame_when_inactive(false).truncate().min_size(vec2(0.0, cell.height()));
        let head = view.button_as(ui, action, button);
        head.widget_info(|| WidgetInfo::labeled(Role::Button, true, &said));
        if let Some(direction) = direction {
            ui.ctx().accesskit_node_builder(head.id, |node| node.set_sort_direction(direction));
        }
    });
}

/// The edges: dragged, they give a column its width; a double click gives the declared one back. What is last ends with the table.
fn edges_ui(ui: &Ui, table: &Table<'_>, across: &Across, rect: Rect) {
    let last = across.iter().rposition(Option::is_some);
    let shown = across.iter().enumerate().filter_map(|(at, across)| Some((at, (*across)?)));
    for (at, across) in shown.filter(|(at, _)| Some(*at) != last) {
        if table.columns.get(at).is_none_or(Column::is_fixed) {
            continue;
        }
        let near = Rangef::new(across.max - NEAR, across.max + NEAR);
        // Not focusable: the pointer alone drags it.
        let edge = ui.interact(
            Rect::from_x_y_ranges(near, rect.y_range()),
            table.id.with(("edge", at)),
            Sense::CLICK | Sense::DRAG,
        );
        let edge = edge.on_hover_and_drag_cursor(CursorIcon::ResizeColumn);
        if edge.hovered() || edge.dragged() {
            ui.painter().vline(across.max, rect.y_range(), Stroke::new(1.5, palette(ui.ctx()).focus.0));
        }
        let asked = edge.interact_pointer_pos().filter(|_| edge.dragged()).map(|pointer| {
            let most = columns::most(table.columns, at, rect.width() - space(BAR));
            Some((pointer.x - across.min).clamp(columns::least(), most))
        });
        if let Some(width) = if edge.double_clicked() { Some(None) } else { asked } {
            let mut own = own(ui, table);
            own.resize(table.columns.len(), None);
            own.splice(at..=at, [width]);
            ui.data_mut(|data| data.insert_persisted(table.id.with("widths"), own));
        }
    }
}
