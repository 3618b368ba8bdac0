//! Left: what is asked. Callout, limits, measured value, probe position, simulated workpiece.

use eframe::egui::{Button, CollapsingHeader, Grid, RichText, Ui, vec2};

use crate::gui::class_chooser::{class_chooser_ui, feature_picture};
use crate::gui::field::{Look, error_ui, field_ui};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::length::Length;
use crate::message::{Message, Say as _};
use crate::session::{Command, Field, MeasureBy};
use crate::tolerance::{Feature, Limits, Source};

/// The panel's content.
pub(super) fn asked_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    callout_ui(ui, view);
    ui.add_space(space(1.0));
    match view.session.asked().limits() {
        Some(limits) => limits_ui(ui, view, limits),
        None => no_limits_ui(ui, view),
    }
    ui.separator();
    measured_ui(ui, view);
    ui.separator();
    size_and_class_ui(ui, view);
    ui.separator();
    position_ui(ui, view);
    ui.add_space(space(1.0));
    simulation_ui(ui, view);
}

fn callout_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("callout"));
    let width = ui.available_width();
    field_ui(ui, view, Field::Callout, name.id, Look::large(width));
    error_ui(ui, view, Field::Callout);
    if view.session.asked().needs_feature() {
        feature_ui(ui, view);
    }
}

/// Hole or shaft, where the callout does not say it.
fn feature_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        for (feature, id) in [(Feature::Hole, "feature-hole"), (Feature::Shaft, "feature-shaft")] {
            feature_picture(ui, feature, space(6.0));
            if ui.radio(view.session.inputs().feature == Some(feature), view.text(id)).clicked() {
                view.send(Command::ChooseFeature(feature));
            }
        }
    });
}

fn limits_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits) {
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        feature_picture(ui, limits.feature, space(6.0));
        let word = match limits.feature {
            Feature::Hole => "feature-hole",
            Feature::Shaft => "feature-shaft",
        };
        ui.label(view.text(word));
        quiet(ui, view.words.say(&Message::new("nominal-is").mm("nominal", limits.nominal)));
    });
    Grid::new("limits").num_columns(3).min_row_height(0.0).spacing(vec2(space(4.0), 0.0)).show(ui, |ui| {
        let mut row = |id: &str, size: Length, deviation: Length| {
            ui.label(view.text(id));
            let font = theme::bold(sizes().limits);
            ui.label(RichText::new(view.words.mm(size, 3)).font(font));
            quiet(ui, format!("{} µm", view.words.signed_um(deviation)));
            ui.end_row();
        };
        row("maximum", limits.maximum(), limits.deviations.upper());
        row("minimum", limits.minimum(), limits.deviations.lower());
    });
    quiet(ui, view.words.say(&Message::new("from-source").message("source", limits.source.message())));
    if let Source::Table { instead_of: Some(standard), .. } = &limits.source {
        let by = limits.deviations.minus(standard);
        let instead = Message::new("source-overrides")
            .text("upper", view.words.signed_um(standard.upper()))
            .text("lower", view.words.signed_um(standard.lower()))
            .text("by-upper", view.words.signed_um(by.0))
            .text("by-lower", view.words.signed_um(by.1));
        ui.label(view.words.say(&instead));
    }
}

fn no_limits_ui(ui: &mut Ui, view: &View<'_>) {
    if view.session.inputs().text(Field::Callout).trim().is_empty() {
        quiet(ui, view.text("callout-hint"));
    }
}

fn measured_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("measured-value"));
    let width = ui.available_width();
    ui.horizontal(|ui| {
        let unit = space(8.0);
        field_ui(ui, view, Field::Measured, name.id, Look::large(width - unit - space(4.0)));
        quiet(ui, "mm");
    });
    error_ui(ui, view, Field::Measured);
    ui.horizontal(|ui| {
        for (by, id) in [(MeasureBy::Typing, "by-typing"), (MeasureBy::Simulating, "by-simulating")] {
            let text = view.text(id);
            if ui.radio(view.session.inputs().by == by, text).clicked() {
                view.send(Command::MeasureBy(by));
            }
        }
        let keypad = view.session.has_keypad();
        if ui.add(Button::new(view.text("keypad")).selected(keypad)).clicked() {
            view.send(Command::ShowKeypad(!keypad));
        }
    });
    ui.horizontal(|ui| {
        let palette = palette(ui.ctx());
        let text = RichText::new(view.text("measure")).color(palette.on_accent.0).font(theme::bold(sizes().body));
        let button = Button::new(text).fill(palette.accent.0).min_size(vec2(width * 0.6, sizes().touch));
        if ui.add(button).clicked() {
            view.send(Command::Measure);
        }
        let clear = Button::new(view.text("clear")).min_size(vec2(0.0, sizes().touch));
        if ui.add(clear).clicked() {
            view.send(Command::ClearResult);
        }
    });
}

fn size_and_class_ui(ui: &mut Ui, view: &mut View<'_>) {
    Grid::new("size-and-class").num_columns(2).min_row_height(0.0).spacing(vec2(space(2.0), space(0.5))).show(
        ui,
        |ui| {
            let name = ui.label(view.text("nominal-size"));
            let class = ui.label(view.text("tolerance-class"));
            ui.end_row();
            number_ui(ui, view, Field::Nominal, name.id, "mm");
            class_chooser_ui(ui, view, class.id);
            ui.end_row();
        },
    );
    let name = ui.label(view.text("part-name"));
    let width = ui.available_width();
    let look = Look { font: theme::font(sizes().body), ..Look::large(width) };
    field_ui(ui, view, Field::Part, name.id, look);
}

fn position_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("probe-position"));
    pairs_ui(
        ui,
        view,
        "position",
        &[
            (Field::CentreX, "centre-x", "mm"),
            (Field::CentreY, "centre-y", "mm"),
            (Field::Height, "height-z", "mm"),
            (Field::FirstAngle, "first-contact", "°"),
            (Field::Clearance, "clearance", "mm"),
            (Field::CentreTolerance, "centre-tolerance", "mm"),
        ],
    );
}

fn simulation_ui(ui: &mut Ui, view: &mut View<'_>) {
    CollapsingHeader::new(view.text("simulated-workpiece")).id_salt("simulated").show_unindented(ui, |ui| {
        quiet(ui, view.text("simulated-hint"));
        pairs_ui(
            ui,
            view,
            "simulation",
            &[
                (Field::TrueDiameter, "true-diameter", "mm"),
                (Field::Seed, "seed", ""),
                (Field::OffsetX, "offset-x", "mm"),
                (Field::OffsetY, "offset-y", "mm"),
                (Field::Ovality, "ovality", "mm"),
                (Field::Lobes, "lobes", ""),
                (Field::LobeHeight, "lobe-height", "mm"),
                (Field::SurfaceScatter, "surface-scatter", "mm"),
                (Field::ProbeScatter, "probe-scatter", "mm"),
            ],
        );
    });
}

/// Two fields a row, each with its name above it and its error below the row.
fn pairs_ui(ui: &mut Ui, view: &mut View<'_>, id: &str, fields: &[(Field, &str, &str)]) {
    for pair in fields.chunks(2) {
        Grid::new((id, pair.first().map(|(field, ..)| *field)))
            .num_columns(2)
            .min_row_height(0.0)
            .min_col_width(space(31.0))
            .spacing(vec2(space(2.0), space(0.5)))
            .show(ui, |ui| {
                let names: Vec<_> = pair.iter().map(|(_, name, _)| quiet(ui, view.text(name)).id).collect();
                ui.end_row();
                for ((field, _, unit), name) in pair.iter().zip(names) {
                    number_ui(ui, view, *field, name, unit);
                }
                ui.end_row();
            });
        for (field, ..) in pair {
            error_ui(ui, view, *field);
        }
    }
}

fn number_ui(ui: &mut Ui, view: &mut View<'_>, field: Field, name: eframe::egui::Id, unit: &str) {
    ui.horizontal(|ui| {
        field_ui(ui, view, field, name, Look::number(space(22.0)));
        quiet(ui, unit);
    });
}
