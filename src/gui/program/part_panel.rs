//! Left: the simulated part of several features, listed by name, kind, size and place.

use eframe::egui::{Label, RichText, ScrollArea, Ui};

use crate::gui::theme::{sizes, space};
use crate::gui::view::{View, quiet};
use crate::message::Message;
use crate::session::{Action, feature_message};

/// How many features are visible without scrolling.
const LINES: f32 = 6.0;

/// The part, and a button that opens another one. Only the features in sight are drawn: there may be a thousand.
pub(super) fn part_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.field_button(ui, Action::OpenPart);
    let Some(open) = view.session.part() else { return };
    let part = &open.part;
    let message = Message::new("part-of-features").text("name", &open.name).count("count", part.features.len());
    quiet(ui, view.words.say(&message.mm("ball", part.probe.ball_radius)));
    let row = sizes().small + space(1.5);
    ui.spacing_mut().item_spacing.y = 0.0;
    let area = ScrollArea::vertical().id_salt("part-features").max_height(row * LINES).auto_shrink([false, true]);
    area.show_rows(ui, row, part.features.len(), |ui, rows| {
        for feature in part.features.get(rows).unwrap_or_default() {
            let said = view.words.say(&feature_message(feature));
            ui.add(Label::new(RichText::new(said).size(sizes().small)).truncate().selectable(false));
        }
    });
}
