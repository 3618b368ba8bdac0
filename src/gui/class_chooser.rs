//! Choosing a tolerance class from the tables: holes and shafts separately, each with its picture.

use eframe::egui::{ComboBox, Id, Sense, Ui, vec2};

use super::shapes;
use super::theme::{control, palette, space};
use super::view::{View, caret_ui, heading, list_height};
use crate::session::CheckCommand;
use crate::tolerance::Feature;

/// The chooser; `name` is what a screen reader says.
pub(super) fn class_chooser_ui(ui: &mut Ui, view: &mut View<'_>, name: Id, width: f32) {
    let chosen = view.session.check().asked.callout.and_then(|callout| callout.class());
    let shown = chosen.map_or_else(|| view.text("class-none"), |class| class.to_string());
    let response = ComboBox::from_id_salt("class-chooser")
        .selected_text(shown)
        .width(width)
        .height(list_height(ui))
        .icon(caret_ui)
        .show_ui(ui, |ui| {
            ui.set_min_width(space(132.0));
            for feature in [Feature::Hole, Feature::Shaft] {
                ui.horizontal(|ui| {
                    feature_picture(ui, feature, space(6.0));
                    heading(ui, view.text(feature_classes_id(feature)));
                });
                ui.horizontal_wrapped(|ui| {
                    for class in view.session.sources().classes(feature) {
                        let size = vec2(space(14.0), control(ui));
                        let button = eframe::egui::Button::selectable(chosen == Some(class), class.as_str());
                        if ui.add_sized(size, button).clicked() {
                            view.send(CheckCommand::ChooseClass(class));
                            ui.close();
                        }
                    }
                });
            }
        })
        .response;
    response.labelled_by(name);
}

pub(super) const fn feature_classes_id(feature: Feature) -> &'static str {
    match feature {
        Feature::Hole => "classes-hole",
        Feature::Shaft => "classes-shaft",
    }
}

/// The small picture of hole or shaft.
pub(super) fn feature_picture(ui: &mut Ui, feature: Feature, size: f32) {
    let (rect, _) = ui.allocate_exact_size(vec2(size, size), Sense::hover());
    let palette = palette(ui.ctx());
    shapes::feature(ui.painter(), rect.shrink(1.0), feature, palette.line.0, palette.surface.0, palette.text.0);
}
