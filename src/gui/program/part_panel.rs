//! Left: the simulated part of several features, listed by name, kind, size and place. The list takes the focus as a whole.

use eframe::egui::accesskit::Role;
use eframe::egui::{EventFilter, Id, Key, Label, Rect, RichText, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, vec2};

use crate::gui::shapes::{focus_ring, times};
use crate::gui::theme::{sizes, space};
use crate::gui::view::{View, quiet, remembered};
use crate::message::message;
use crate::session::{ProgramAction, feature_message};
use crate::text::Within as _;

/// How many features are visible without scrolling.
const LINES: usize = 6;

/// The part, and a button that opens another one. Only the features in sight are drawn: there may be a thousand.
pub(super) fn part_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.field_button(ui, ProgramAction::OpenPart);
    let Some(open) = view.session.part() else { return };
    let features = &open.part.features;
    let message = message!("part-of-features").text("name", &open.name).count("count", features.len());
    quiet(ui, view.words.say(&message.number("ball", open.part.probe.ball_radius)));
    let name = view.text("part-features");
    let row = sizes().small + space(1.5);
    let id = Id::unique("part-features");
    let size = vec2(ui.available_width(), times(row, features.len().min(LINES)));
    let rect = Rect::from_min_size(ui.cursor().min, size);
    let list = ui.interact(rect, id, Sense::focusable_noninteractive());
    list.widget_info(|| WidgetInfo::labeled(Role::List, true, &name));
    let mut area = ScrollArea::vertical().id_salt("part-features").max_height(size.y).auto_shrink([false, true]);
    if let Some(offset) = list.has_focus().then(|| asked_offset(ui, id, row, features.len())).flatten() {
        area = area.vertical_scroll_offset(offset);
    }
    let shown = ui.scope_builder(UiBuilder::new().accessibility_parent(id), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        area.show_rows(ui, row, features.len(), |ui, rows| {
            for feature in features.within(rows) {
                let said = view.words.say(&feature_message(feature));
                ui.add(Label::new(RichText::new(said).size(sizes().small)).truncate().selectable(false));
            }
        })
    });
    ui.data_mut(|data| data.insert_temp(id, shown.inner.state.clamped_offset().y));
    if list.has_focus() {
        focus_ring(ui, rect);
    }
}

/// Where the keys scroll the list to, if one of them was pressed.
fn asked_offset(ui: &Ui, id: Id, row: f32, count: usize) -> Option<f32> {
    let arrows = EventFilter { vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
    let last = times(row, count.saturating_sub(LINES));
    let now: f32 = remembered(ui, id);
    let page = times(row, LINES);
    let steps = [
        (Key::ArrowDown, now + row),
        (Key::ArrowUp, now - row),
        (Key::PageDown, now + page),
        (Key::PageUp, now - page),
        (Key::Home, 0.0),
        (Key::End, last),
    ];
    let pressed = |key: Key| ui.input(|input| input.key_pressed(key));
    steps.into_iter().find(|(key, _)| pressed(*key)).map(|(_, offset)| offset.clamp(0.0, last))
}
