//! Left: the measured parts; the temperature, and what the parts are made of; the joint of a press fit.

use eframe::egui::{Grid, Ui, vec2};

use crate::gui::field::{FieldStyle, error_ui, field_ui, half_width, pairs_ui};
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

/// The joint of a press fit.
pub(super) fn press_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("fit-press"));
    let fields = [
        (FitField::PressLength, "fit-press-length"),
        (FitField::HubOuter, "fit-hub-outer"),
        (FitField::ShaftBore, "fit-shaft-bore"),
    ];
    pairs_ui(ui, view, &fields.map(|(field, name)| (field.into(), view.text(name), "mm")));
}

/// Two fields beside each other, each with its name above it and its error below.
pub(super) fn pair_ui(ui: &mut Ui, view: &mut View<'_>, fields: [(FitField, &str, &str); 2]) {
    pairs_ui(ui, view, &fields.map(|(field, name, unit)| (field.into(), view.text(name), unit)));
}

/// The temperature of both parts and their materials.
pub(super) fn temperature_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let name = heading(ui, view.text("fit-temperature"));
        ui.spacing_mut().item_spacing.x = space(1.0);
        field_ui(ui, view, FitField::Temperature, name.id, FieldStyle::number(space(20.0)).unit("°C"));
    });
    error_ui(ui, view, FitField::Temperature);
    let width = half_width(ui);
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
                field_ui(ui, view, FitField::expansion(part), expansion.id, FieldStyle::number(width));
                ui.end_row();
            });
        error_ui(ui, view, FitField::expansion(part));
    }
}
