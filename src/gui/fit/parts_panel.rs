//! Left: the measured parts; the temperature, and what the parts are made of.

use eframe::egui::{Grid, Id, Ui, vec2};

use crate::gui::field::{Look, Pairs, error_ui, field_ui, pairs_ui};
use crate::gui::theme::space;
use crate::gui::view::{View, heading, list_ui, quiet};
use crate::session::{FitCommand, FitField};
use crate::tolerance::Feature;

/// The measured diameters.
pub(super) fn parts_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("fit-parts"));
    pair_ui(
        ui,
        view,
        [(FitField::HoleMeasured, "fit-hole-measured", "mm"), (FitField::ShaftMeasured, "fit-shaft-measured", "mm")],
    );
}

/// Two fields beside each other, each with its name above it and its error below.
pub(super) fn pair_ui(ui: &mut Ui, view: &mut View<'_>, fields: [(FitField, &str, &str); 2]) {
    let column = (ui.available_width() - space(2.0)) / 2.0;
    let pairs = Pairs { column, field: |_: &str| column - space(8.0), gap: space(1.0) };
    pairs_ui(ui, view, &pairs, &fields.map(|(field, name, unit)| (field.into(), view.text(name), unit)));
}

/// The temperature of both parts and their materials.
pub(super) fn temperature_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let name = heading(ui, view.text("fit-temperature"));
        ui.spacing_mut().item_spacing.x = space(1.0);
        field_ui(ui, view, FitField::Temperature, name.id, Look::number(space(16.0)));
        quiet(ui, "°C");
    });
    error_ui(ui, view, FitField::Temperature);
    let width = (ui.available_width() - space(2.0)) / 2.0;
    for (part, material, expansion) in [
        (Feature::Hole, "fit-hole-material", "fit-hole-expansion"),
        (Feature::Shaft, "fit-shaft-material", "fit-shaft-expansion"),
    ] {
        Grid::new(("fit-material", part))
            .num_columns(2)
            .min_row_height(0.0)
            .min_col_width(width)
            .spacing(vec2(space(2.0), space(0.5)))
            .show(ui, |ui| {
                let material = quiet(ui, view.text(material));
                let expansion = quiet(ui, view.text(expansion));
                ui.end_row();
                material_ui(ui, view, part, material.id, width);
                field_ui(ui, view, FitField::expansion(part), expansion.id, Look::number(width - space(2.0)));
                ui.end_row();
            });
        error_ui(ui, view, FitField::expansion(part));
    }
}

/// Materials fill the field of expansion; a typed value belongs to no material any more.
fn material_ui(ui: &mut Ui, view: &mut View<'_>, part: Feature, name: Id, width: f32) {
    let language = view.session.language();
    let now = view.session.fit().expansion(part);
    let chosen = view.session.materials().iter().find(|material| Some(material.expansion) == now);
    let shown = chosen.map_or_else(|| view.text("fit-own-value"), |material| material.name_in(language).to_owned());
    let list = list_ui(ui, ("fit-material", part), shown, width, |ui| {
        for material in view.session.materials().iter() {
            let value = view.words.number(&material.expansion.to_string());
            let text = format!("{}  {value}", material.name_in(language));
            let is = Some(material.expansion) == now;
            let certainty = view.words.told(&material.certainty);
            let source = material.source.as_deref().unwrap_or_default();
            let hint = if source.is_empty() { certainty } else { format!("{certainty}: {source}") };
            if ui.selectable_label(is, text).on_hover_text(hint).clicked() {
                view.send(FitCommand::ChooseExpansion(part, material.expansion));
                ui.close();
            }
        }
    });
    list.labelled_by(name);
}
