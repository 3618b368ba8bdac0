//! Every key of the window, by the place where it is heard.

use eframe::egui::{Grid, Label, RichText, Ui, vec2};

use crate::gui::key_names::told;
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, quiet};

/// The share of the width that the keys have.
const SHARE: f32 = 0.4;

pub(super) fn keys_ui(ui: &mut Ui, view: &View<'_>) {
    for place in &view.session.settings_page().keys {
        ui.separator();
        quiet(ui, view.text(place.place));
        let width = ui.available_width();
        let of_keys = (width * SHARE).floor();
        let of_name = width - of_keys - space(4.0);
        let grid = Grid::new(("settings-keys", place.place)).num_columns(2).min_row_height(0.0);
        grid.spacing(vec2(space(4.0), space(1.0))).show(ui, |ui| {
            for row in &place.rows {
                let keys: Vec<String> = row.shortcuts.iter().map(|shortcut| told(ui, *shortcut)).collect();
                let keys = RichText::new(keys.join(", ")).font(theme::bold(sizes().body));
                for (text, width) in [(keys, of_keys), (RichText::new(&row.name), of_name)] {
                    ui.vertical(|ui| {
                        ui.set_width(width);
                        ui.add(Label::new(text).wrap());
                    });
                }
                ui.end_row();
            }
        });
    }
}
