//! The sheet of all keys: what they do is the name of their action.

use eframe::egui::accesskit::Role;
use eframe::egui::{Label, RichText, Sense, Ui, UiBuilder, WidgetInfo, vec2};

use crate::gui::key_names::told;
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::message;
use crate::session::help::{KeyRow, key_groups};

/// How wide the keys are at most, of the width of the sheet.
const KEYS: f32 = 0.4;

pub(super) fn sheet_ui(ui: &mut Ui, view: &View<'_>) {
    ui.label(RichText::new(view.text("help-page-keys")).font(theme::bold(sizes().value)));
    quiet(ui, view.text("help-page-keys-about"));
    for group in key_groups(view.session, view.words) {
        ui.add_space(space(2.0));
        heading(ui, view.text(group.name));
        for row in &group.rows {
            row_ui(ui, view, row);
        }
    }
}

/// The keys, and what they do beside them; a screen reader says both at once.
fn row_ui(ui: &mut Ui, view: &View<'_>, row: &KeyRow) {
    let keys: Vec<String> = row.keys.iter().map(|keys| told(ui, *keys)).collect();
    let keys = keys.join(", ");
    let said = view.words.say(&message!("help-page-key-row").text("keys", &keys).text("text", &row.text));
    let width = (ui.available_width() * KEYS).min(space(60.0));
    let line = ui.horizontal_top(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        let column = ui.allocate_ui(vec2(width, 0.0), |ui| {
            ui.set_width(width);
            ui.add(Label::new(RichText::new(&keys).font(theme::bold(sizes().body))).wrap());
        });
        ui.scope_builder(UiBuilder::new().id_salt(column.response.id), |ui| {
            ui.add(Label::new(&row.text).wrap());
        });
    });
    let response = ui.interact(line.response.rect, ui.scope_id().with(&said), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::ListItem, true, &said));
}
