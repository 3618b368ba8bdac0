//! A list of rows with heads, as its page declares it: any number of rows, of which those in sight are asked for. It takes the focus as
//! a whole, and says what was pressed; what that does is the page's.
//!
//! | file | what |
//! |---|---|
//! | `columns` | what a column is, and where the columns stand within a width |
//! | `heads` | the names above, what sorts, and edges that are dragged |
//! | `grid` | cells under heads that stay, of a page of its own |
//! | `rows` | the rows in sight and their cells |
//! | `zone` | where a value lies in its zone |
//! | `long_list` | scrolling, for more rows than a scroll area can count |

mod columns;
pub(super) mod grid;
mod heads;
mod long_list;
mod rows;
mod zone;

use std::fmt::Debug;
use std::hash::Hash;
use std::ops::Range;

pub(super) use columns::Column;
use eframe::egui::accesskit::Role;
use eframe::egui::{Id, Rect, Sense, Ui, UiBuilder, WidgetInfo, vec2};
use long_list::scrolled;
pub(super) use rows::{Cell, PAD, Row, found_height, joined, text_ui};
pub(super) use zone::Zoned;

use super::shapes::{focus_ring, lines_of, times};
use super::theme::{row, space};
use super::view::{View, focus_soon, quiet, take_focus};
use crate::session::Action;

/// The width of the scroll bar, steps of space.
const BAR: f32 = 3.0;

/// A table as a page declares it.
pub(super) struct Table<'a> {
    /// It takes the focus as a whole.
    pub id: Id,
    /// The name of the text that names it.
    pub name: &'a str,
    pub columns: &'a [Column],
    /// The height of its rows where it is not the usual one.
    pub height: Option<f32>,
    /// How many times its declared width a column becomes where nothing else takes what is left over.
    pub stretch: f32,
    /// The head that sorts now, and whether the smallest is first.
    pub sorted: Option<(Action, bool)>,
    /// How many rows it has.
    pub count: usize,
    /// A number that changes when a row has to come into sight, and its place.
    pub look: (u64, Option<usize>),
    /// Why there is no row.
    pub empty: String,
    /// Whether a click on a row gives it the focus.
    pub keeps_focus: bool,
}

/// What was seen of a table, and pressed in it. `K` is what the page knows a row by.
pub(super) struct Seen<K> {
    /// The places in sight.
    pub places: Range<usize>,
    /// The row that was clicked.
    pub clicked: Option<K>,
    /// The row whose choice was clicked, and whether it is chosen from now on.
    pub chosen: Option<(K, bool)>,
}

impl<'a> Table<'a> {
    /// A table without rows.
    pub fn new(id: Id, name: &'a str, columns: &'a [Column]) -> Self {
        let sorted = None;
        let count = 0;
        let look = (0, None);
        let stretch = f32::INFINITY;
        let empty = String::new();
        Self { id, name, columns, height: None, stretch, sorted, count, look, empty, keeps_focus: true }
    }

    /// The height of a row.
    fn row(&self, ui: &Ui) -> f32 {
        self.height.unwrap_or_else(|| row(ui))
    }

    /// Draws it in the room that is left, with the rows of the places in sight.
    pub fn show<K: Copy + Debug + Hash>(
        &self,
        ui: &mut Ui,
        view: &mut View<'_>,
        rows: impl FnOnce(&View<'_>, Range<usize>) -> Vec<Row<K>>,
    ) -> Seen<K> {
        let mut seen = Seen { places: 0..0, clicked: None, chosen: None };
        let room = ui.available_rect_before_wrap();
        let bar = space(BAR);
        let rect = Rect::from_min_max(room.min + vec2(0.0, heads::height(ui, self.columns)), room.max);
        let across = heads::across(ui, self, (room.left(), room.width() - bar));
        heads::heads_ui(ui, view, self, &across, Rect::from_min_max(room.min, rect.right_top()));
        if rect.height() < 1.0 {
            return seen;
        }
        if self.keeps_focus {
            take_focus(ui, self.id);
        }
        let list = ui.interact(rect, self.id, Sense::focusable_noninteractive());
        list.widget_info(|| WidgetInfo::labeled(Role::Grid, true, view.text(self.name)));
        let top = scrolled(ui, self, rect, bar);
        let fit = lines_of((rect.height() / self.row(ui)).ceil()) + 1;
        seen.places = top.place..(top.place + fit).min(self.count);
        let body = UiBuilder::new().max_rect(rect).id_salt((self.id, "body")).accessibility_parent(self.id);
        ui.scope_builder(body, |ui| {
            ui.set_clip_rect(rect.intersect(ui.clip_rect()));
            if self.count == 0 {
                quiet(ui, &self.empty);
            }
            let from = rect.min - vec2(0.0, top.hidden);
            // Where all rows are in sight there is no bar.
            let is_long = rect.height() < times(self.row(ui), self.count);
            let width = if is_long { rect.width() - bar } else { rect.width() };
            let first = Rect::from_min_size(from, vec2(width, self.row(ui)));
            let rows = rows(view, seen.places.clone());
            rows::rows_ui(ui, view, (self, &across), first, rows, &mut seen);
        });
        if seen.clicked.is_some() && self.keeps_focus {
            focus_soon(ui, self.id);
        }
        if list.has_focus() {
            focus_ring(ui, rect);
        }
        ui.advance_cursor_after_rect(room);
        seen
    }
}
