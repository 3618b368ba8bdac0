//! The rows in sight and their cells. No row is a stop for Tab: the table is one.

use std::fmt::Debug;
use std::hash::Hash;

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{Color32, FontId, Painter, Rangef, Rect, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2};

use super::columns::{Across, Kind};
use super::{Seen, Table, Zoned};
use crate::gui::shapes::{self, Edge, times};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::verdict_card::colours;
use crate::gui::view::View;
use crate::verdict::Status;

/// Between the edge of a column and its text.
pub(in crate::gui) const PAD: f32 = 4.0;

/// What a page says of a row. `K` is what it knows the row by.
#[expect(clippy::struct_excessive_bools, reason = "each may stand with each")]
#[derive(Debug)]
pub(in crate::gui) struct Row<K> {
    pub key: K,
    /// One for each column.
    pub cells: Vec<Cell>,
    /// What a screen reader says of it; shown under the pointer where something of it is cut.
    pub said: String,
    /// The keys are there.
    pub is_cursor: bool,
    /// It is the one that the page shows.
    pub is_open: bool,
    /// Another one stands in its place.
    pub is_struck: bool,
    /// It was not read yet, or is no longer so.
    pub is_quiet: bool,
}

impl<K> Row<K> {
    pub const fn new(key: K, cells: Vec<Cell>, said: String) -> Self {
        Self { key, cells, said, is_cursor: false, is_open: false, is_struck: false, is_quiet: false }
    }
}

/// What is in a cell.
#[derive(Debug)]
pub(in crate::gui) enum Cell {
    Text(String),
    /// A name, and below it one or two lines of text with some of it in bold letters.
    Found {
        name: String,
        line: Vec<(String, bool)>,
    },
    /// Where a value lies in its zone; nothing where there is none.
    Zone(Option<Zoned>),
    /// How long a bar is and where its mark stands, as shares of the column; nothing where there is none.
    Bar(Option<[f32; 2]>),
    /// A verdict.
    Verdict {
        status: Option<Status>,
        edge: Edge,
        word: String,
        /// What is said beside it, where there is room.
        beside: String,
    },
    /// A box with a check mark, and its name.
    Choice {
        is_chosen: bool,
        can_choose: bool,
        name: String,
    },
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

/// What a screen reader says of a row: its parts as far as there is something in them.
pub(in crate::gui) fn joined<'a>(parts: impl IntoIterator<Item = &'a String>) -> String {
    let parts = parts.into_iter().map(String::as_str).filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(", ")
}

/// The rows, the first of them in `first`.
pub(super) fn rows_ui<K: Copy + Debug + Hash>(
    ui: &Ui,
    view: &View<'_>,
    declared: (&Table<'_>, &Across),
    first: Rect,
    rows: Vec<Row<K>>,
    seen: &mut Seen<K>,
) {
    for (at, row) in rows.into_iter().enumerate() {
        let rect = first.translate(vec2(0.0, times(first.height(), at)));
        row_ui(ui, view, declared, rect, row, seen);
    }
}

fn row_ui<K: Copy + Debug + Hash>(
    ui: &Ui,
    view: &View<'_>,
    (table, across): (&Table<'_>, &Across),
    rect: Rect,
    row: Row<K>,
    seen: &mut Seen<K>,
) {
    // Not focusable: the table is one stop for Tab.
    let response = ui.interact(rect, table.id.with(row.key), Sense::CLICK);
    ground(ui, rect, &row, response.hovered());
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, &row.said));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(row.is_cursor));
    if row.is_cursor {
        ui.ctx().accesskit_node_builder(table.id, |node| node.set_active_descendant(response.id.accesskit_id()));
    }
    let palette = palette(ui.ctx());
    let look =
        (&theme::font(sizes().body), if row.is_quiet || row.is_struck { palette.quiet.0 } else { palette.text.0 });
    let sign = view.words.decimal_sign();
    let mut is_cut = false;
    for ((column, across), cell) in table.columns.iter().zip(across).zip(&row.cells) {
        let room = across.map(|across| Rect::from_x_y_ranges(across, rect.y_range()));
        match (room, cell) {
            (None, Cell::Text(text)) => is_cut |= !text.is_empty(),
            (None, _) => {}
            (Some(room), Cell::Text(text)) if column.wraps => {
                is_cut |= two_lines(ui.painter(), room.shrink2(vec2(PAD, 0.0)), text, look);
            }
            (Some(room), Cell::Text(text)) => {
                is_cut |= text_in(ui.painter(), room.shrink2(vec2(PAD, 0.0)), text, look, (column.kind, Some(sign)));
            }
            (Some(room), Cell::Found { name, line }) => {
                found_ui(ui.painter(), room.shrink2(vec2(PAD, 0.0)), name, line);
            }
            (Some(room), Cell::Verdict { status, edge, word, beside }) => {
                let colours = colours(palette, *status, *edge);
                let word = (column.kind == Kind::Verdict).then_some(word.as_str());
                let chip = verdict(ui.painter(), room, (*status, *edge), colours, word);
                is_cut |= !beside.is_empty() && !beside_ui(ui.painter(), room, chip, beside);
            }
            (Some(room), Cell::Zone(zoned)) => {
                let room = room.shrink2(vec2(PAD, 0.0));
                if let Some(zoned) = zoned {
                    zoned.paint(ui.painter(), room, palette);
                }
            }
            (Some(room), Cell::Bar(bar)) => bar_ui(ui.painter(), room.shrink2(vec2(PAD, 0.0)), *bar),
            (Some(room), Cell::Choice { is_chosen, can_choose, name }) => {
                if choice_ui(ui, table, room, &row.key, (*is_chosen, *can_choose, name)) {
                    seen.chosen = Some((row.key, !is_chosen));
                }
            }
        }
    }
    if row.is_struck {
        strike(ui, (table, across), rect);
    }
    if response.clicked() {
        seen.clicked = Some(row.key);
    }
    if is_cut {
        response.on_hover_text(row.said);
    }
}

/// What is shown, where the keys are, and what is under the pointer stands out.
fn ground<K>(ui: &Ui, rect: Rect, row: &Row<K>, is_hovered: bool) {
    let palette = palette(ui.ctx());
    let ground = match (row.is_open, row.is_cursor, is_hovered) {
        (true, ..) => Some(palette.tint.0),
        (_, true, _) | (_, _, true) => Some(palette.hover.0),
        _ => None,
    };
    if let Some(ground) = ground {
        ui.painter().rect_filled(rect, 0.0, ground);
    }
    if row.is_cursor {
        let bar = Rect::from_min_size(rect.left_top(), vec2(3.0, rect.height()));
        ui.painter().rect_filled(bar, 0.0, palette.accent.0);
    }
}

/// A text in one line; returns whether it was cut.
pub(in crate::gui) fn text_ui(painter: &Painter, rect: Rect, text: &str, font: &FontId, colour: Color32) -> bool {
    text_in(painter, rect, text, (font, colour), (Kind::Text, None))
}

/// A text that goes on in a second line of smaller letters where one is too short; returns whether it was cut.
fn two_lines(painter: &Painter, rect: Rect, text: &str, (font, colour): (&FontId, Color32)) -> bool {
    if painter.layout_no_wrap(text.to_owned(), font.clone(), colour).size().x <= rect.width() {
        return text_in(painter, rect, text, (font, colour), (Kind::Text, None));
    }
    let mut job = LayoutJob::simple(text.to_owned(), theme::font(sizes().small), colour, rect.width().max(0.0));
    job.wrap.max_rows = 2;
    let galley = painter.layout_job(job);
    let is_cut = galley.elided;
    painter.galley(pos2(rect.left(), rect.center().y - galley.size().y / 2.0), galley, colour);
    is_cut
}

/// The height of a row with a name and so many lines.
pub(in crate::gui) fn found_height(ui: &Ui, lines: usize) -> f32 {
    let height = |size: f32| ui.fonts_mut(|fonts| fonts.row_height(&theme::font(size)));
    (height(sizes().body) + times(height(sizes().small), lines) + 2.0 * space(2.0)).ceil()
}

/// A name, and below it two lines with some of their words in bold letters.
fn found_ui(painter: &Painter, rect: Rect, name: &str, line: &[(String, bool)]) {
    let palette = palette(painter.ctx());
    let mut job = LayoutJob::simple_singleline(name.to_owned(), theme::font(sizes().body), palette.text.0);
    job.wrap = TextWrapping::truncate_at_width(rect.width().max(0.0));
    let name = painter.layout_job(job);
    let mut job = LayoutJob::default();
    for (text, is_bold) in line {
        let format = if *is_bold {
            TextFormat::simple(theme::bold(sizes().small), palette.text.0)
        } else {
            TextFormat::simple(theme::font(sizes().small), palette.quiet.0)
        };
        job.append(text, 0.0, format);
    }
    job.wrap = TextWrapping { max_rows: 2, ..TextWrapping::wrap_at_width(rect.width().max(0.0)) };
    let line = painter.layout_job(job);
    let at = rect.left_top() + vec2(0.0, space(2.0));
    let below = at + vec2(0.0, name.size().y);
    painter.galley(at, name, palette.text.0);
    painter.galley(below, line, palette.quiet.0);
}

/// A text in one line, at its place in a column of a kind; returns whether it was cut.
pub(super) fn text_in(
    painter: &Painter,
    rect: Rect,
    text: &str,
    (font, colour): (&FontId, Color32),
    (kind, sign): (Kind, Option<char>),
) -> bool {
    /// What most numbers have behind the decimal sign.
    const DECIMALS: &str = "0000";
    let mut job = LayoutJob::simple_singleline(text.to_owned(), font.clone(), colour);
    job.wrap = TextWrapping::truncate_at_width(rect.width().max(0.0));
    let galley = painter.layout_job(job);
    let is_cut = galley.elided;
    let width = |text: &str| painter.layout_no_wrap(text.to_owned(), font.clone(), colour).size().x;
    let left = match (kind, sign.and_then(|sign| text.rsplit_once(sign))) {
        // A micrometre has its unit behind it, and no decimals as a rule.
        (Kind::Number, Some((_, behind))) if !text.contains(' ') => {
            let short = (width(DECIMALS) - width(behind)).max(0.0);
            (rect.right() - galley.size().x - short).max(rect.left())
        }
        (Kind::Number | Kind::Figure, _) => rect.right() - galley.size().x,
        _ => rect.left(),
    };
    painter.galley(pos2(left, rect.center().y - galley.size().y / 2.0), galley, colour);
    is_cut
}

/// A verdict, with its word where the column has room for one: a simulated one is framed by dashes.
fn verdict(
    painter: &Painter,
    cell: Rect,
    (status, edge): (Option<Status>, Edge),
    (fill, colour): (Color32, Color32),
    word: Option<&str>,
) -> Rect {
    let (rect, corner) = match word {
        Some(word) => {
            let height = cell.height().min(space(6.0));
            let font = theme::bold(sizes().small);
            let text = painter.layout_no_wrap(word.to_owned(), font, colour).size().x;
            let size = vec2((height + text + space(2.5)).min(cell.width() - 2.0 * PAD), height);
            (Rect::from_min_size(cell.left_center() + vec2(PAD, -size.y / 2.0), size), 6.0)
        }
        None => (Rect::from_center_size(cell.center(), vec2(space(5.0), space(5.0))), 2.0),
    };
    painter.rect_filled(rect, corner, fill);
    if let Some(word) = word {
        let (shape, text) = rect.split_left_right_at_x(rect.left() + rect.height());
        shapes::status(painter, shape.shrink(space(1.25)), status, colour);
        text_ui(painter, text.shrink2(vec2(2.0, 0.0)), word, &theme::bold(sizes().small), colour);
    } else {
        shapes::status(painter, rect.shrink(1.0), status, colour);
    }
    shapes::edge(painter, (rect, corner), edge, colour);
    rect
}

/// A bar with a mark on its track.
fn bar_ui(painter: &Painter, cell: Rect, bar: Option<[f32; 2]>) {
    let palette = palette(painter.ctx());
    let Some(shares) = bar else { return };
    let [end, mark] = shares.map(|share| cell.left() + cell.width() * share.clamp(0.0, 1.0));
    let track = Rect::from_center_size(cell.center(), vec2(cell.width(), 4.0));
    painter.rect_filled(track, 2.0, palette.hover.0);
    painter.rect_filled(track.with_max_x(end), 2.0, palette.data.0);
    let height = Rangef::new(cell.center().y - space(1.75), cell.center().y + space(1.75));
    painter.vline(mark, height, Stroke::new(1.5, palette.text.0));
}

/// A few words beside a verdict; returns whether there was room for them.
fn beside_ui(painter: &Painter, cell: Rect, chip: Rect, text: &str) -> bool {
    let colour = palette(painter.ctx()).quiet.0;
    let galley = painter.layout_no_wrap(text.to_owned(), theme::font(sizes().small), colour);
    let at = pos2(chip.right() + 2.0 * PAD, cell.center().y - galley.size().y / 2.0);
    let has_room = at.x + galley.size().x <= cell.right();
    if has_room {
        painter.galley(at, galley, colour);
    }
    has_room
}

/// A box with a check mark; returns whether it was clicked.
fn choice_ui(
    ui: &Ui,
    table: &Table<'_>,
    rect: Rect,
    key: &(impl Debug + Hash),
    (is_chosen, can_choose, name): (bool, bool, &str),
) -> bool {
    let palette = palette(ui.ctx());
    let mark = Rect::from_center_size(rect.center(), vec2(space(5.0), space(5.0)));
    ui.painter().rect(mark, 2.0, palette.surface.0, Stroke::new(1.5, palette.quiet.0), StrokeKind::Inside);
    if is_chosen {
        shapes::status(ui.painter(), mark.shrink(3.0), Some(Status::Good), palette.text.0);
    }
    let response = ui.interact(rect, table.id.with(("choose", key)), Sense::CLICK);
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, can_choose, is_chosen, name));
    response.clicked() && can_choose
}

/// A line through a row, from its first text up to its verdict, where it is said what stands in its place.
fn strike(ui: &Ui, (table, across): (&Table<'_>, &Across), rect: Rect) {
    let mut all = table.columns.iter().zip(across).filter_map(|(column, across)| Some((column, (*across)?)));
    let start = all.clone().find(|(column, _)| !column.is_fixed()).map_or(rect.left(), |(_, across)| across.min);
    let end = all.find(|(column, _)| column.kind == Kind::Verdict).map_or(rect.right(), |(_, across)| across.min);
    let across = Rangef::new(start + PAD, end - PAD);
    ui.painter().hline(across, rect.center().y, Stroke::new(1.0, palette(ui.ctx()).quiet.0));
}
