//! A list of any length that scrolls by itself: a scroll area counts in pixels, and has too few digits for the millionth row.

use eframe::egui::{CursorIcon, Id, Rect, Sense, Ui, pos2, vec2};

use super::Table;
use crate::gui::shapes::{self, lines_of, part_of, times};
use crate::gui::theme::{palette, space};
use crate::gui::view::remembered;

/// The first place in sight, and how many points of it are above.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Top {
    /// The first place in sight.
    pub place: usize,
    /// How many points of it are above.
    pub hidden: f32,
}

impl Top {
    /// Moves by points, as far as there are rows.
    fn scroll(self, points: f32, height: f32, last: Self) -> Self {
        let moved = self.hidden + points;
        let rows = (moved / height).floor();
        let place = if rows < 0.0 {
            let up = lines_of(-rows);
            if self.place < up {
                return Self::default();
            }
            self.place - up
        } else {
            self.place + lines_of(rows)
        };
        Self { place, hidden: moved - rows * height }.at_most(last)
    }

    fn at_most(self, last: Self) -> Self {
        let is_beyond = last.place < self.place || last.place == self.place && last.hidden < self.hidden;
        if is_beyond { last } else { self }
    }
}

/// Where the list stands after the wheel, a finger, the bar, or a cursor that has to come into sight.
pub(super) fn scrolled(ui: &Ui, table: &Table<'_>, rect: Rect, bar: f32) -> Top {
    let id = table.id;
    let height = table.row(ui);
    let key = id.with("top");
    let (mut top, looked): (Top, u64) = remembered(ui, key);
    let fit = lines_of((rect.height() / height).floor());
    let last = match table.count.checked_sub(fit + 1) {
        Some(place) => Top { place, hidden: height - (rect.height() - times(height, fit)) },
        None => Top::default(),
    };
    // A finger drags the rows; what is pressed stays with the row.
    let drag = ui.interact(rect, id.with("drag"), Sense::DRAG);
    let is_touched = ui.input(eframe::egui::InputState::any_touches);
    if drag.dragged() && is_touched {
        top = top.scroll(-drag.drag_delta().y, height, last);
    }
    if ui.rect_contains_pointer(rect) {
        let before = top;
        top = top.scroll(-ui.input(|input| input.smooth_scroll_delta().y), height, last);
        if top != before {
            // What scrolls here scrolls nothing around it.
            ui.input_mut(|input| input.smooth_scroll_delta.y = 0.0);
        }
    }
    top = bar_ui(ui, id, rect, (top, last), bar);
    let (look, place) = table.look;
    if look != looked
        && let Some(place) = place
    {
        let is_above = place < top.place || place == top.place && 0.0 < top.hidden;
        if is_above {
            top = Top { place, hidden: 0.0 };
        } else if top.place + fit <= place {
            let hidden = height - (rect.height() - times(height, fit));
            top = place.checked_sub(fit).map_or_else(Top::default, |place| Top { place, hidden });
        }
    }
    top = top.at_most(last);
    ui.data_mut(|data| data.insert_temp(key, (top, look)));
    top
}

/// The scroll bar, where there is something to scroll.
fn bar_ui(ui: &Ui, id: Id, rect: Rect, (top, last): (Top, Top), width: f32) -> Top {
    if last.place == 0 && last.hidden <= 0.0 {
        return top;
    }
    let rail = Rect::from_min_max(pos2(rect.right() - width, rect.top()), rect.max);
    let response = ui.interact(rail, id.with("bar"), Sense::DRAG | Sense::CLICK).on_hover_cursor(CursorIcon::Default);
    let size = space(8.0).min(rail.height());
    let way = (rail.height() - size).max(1.0);
    let mut top = top;
    if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.dragged() || response.clicked()) {
        let share = ((pointer.y - rail.top() - size / 2.0) / way).clamp(0.0, 1.0);
        top = if 1.0 <= share { last } else { Top { place: part_of(share, last.place), hidden: 0.0 } };
    }
    let at = shapes::ratio(top.place, last.place.max(1)) * way;
    let handle = Rect::from_min_size(pos2(rail.left(), rail.top() + at), vec2(width, size)).shrink2(vec2(2.0, 0.0));
    let palette = palette(ui.ctx());
    ui.painter().rect_filled(rail, 0.0, palette.sunken.0);
    ui.painter().rect_filled(handle, 2.0, if response.hovered() { palette.text.0 } else { palette.quiet.0 });
    top
}
