//! Left: the measured parts; the temperature, and what the parts are made of.

use eframe::egui::{Grid, Ui, vec2};

use crate::gui::field::{FieldStyle, Pairs, error_ui, field_ui, pairs_ui};
use crate::gui::material::material_ui;
use crate::gui::theme::space;
use crate::gui::view::{View, heading, quiet};
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
        field_ui(ui, view, FitField::Temperature, name.id, FieldStyle::number(space(16.0)));
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
                let now = view.session.fit().expansion(part);
                if let Some(expansion) = material_ui(ui, view, ("fit-material", part), now, (material.id, width)) {
                    view.send(FitCommand::ChooseExpansion(part, expansion));
                }
                field_ui(ui, view, FitField::expansion(part), expansion.id, FieldStyle::number(width - space(2.0)));
                ui.end_row();
            });
        error_ui(ui, view, FitField::expansion(part));
    }
}
