//! Left: what is asked. Callout, limits, measured value, probe position, simulated workpiece.

use eframe::egui::{CollapsingHeader, Grid, Ui, vec2};

use crate::gui::check::record_panel::record_ui;
use crate::gui::check::rule_panel::worth_ui;
use crate::gui::class_chooser::{class_chooser_ui, feature_picture};
use crate::gui::field::{self, Look, Pairs, error_ui, field_ui};
use crate::gui::limits::{self, feature_id};
use crate::gui::theme::{self, control, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::Message;
use crate::session::{Action, CheckCommand, CheckField, MeasureBy};
use crate::tolerance::{Feature, Limits, Source};

/// The panel's content.
pub(super) fn asked_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    callout_ui(ui, view);
    ui.add_space(space(1.0));
    match view.session.check().asked().limits() {
        Some(limits) => limits_ui(ui, view, limits),
        None => no_limits_ui(ui, view),
    }
    ui.separator();
    measured_ui(ui, view);
    ui.separator();
    worth_ui(ui, view);
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
    field_ui(ui, view, CheckField::Callout, name.id, Look::large(width));
    error_ui(ui, view, CheckField::Callout);
    if view.session.check().asked().needs_feature() {
        feature_ui(ui, view);
    }
}

/// Hole or shaft, where the callout does not say it.
fn feature_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        for feature in [Feature::Hole, Feature::Shaft] {
            feature_picture(ui, feature, space(6.0));
            if ui.radio(view.session.check().feature() == Some(feature), view.text(feature_id(feature))).clicked() {
                view.send(CheckCommand::ChooseFeature(feature));
            }
        }
    });
}

fn limits_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits) {
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        feature_picture(ui, limits.feature, space(6.0));
        ui.label(view.text(feature_id(limits.feature)));
        quiet(ui, view.words.say(&Message::new("nominal-is").mm("nominal", limits.nominal)));
    });
    limits::limits_ui(ui, view, limits);
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
    if view.session.text(CheckField::Callout).trim().is_empty() {
        quiet(ui, view.text("callout-hint"));
    }
}

fn measured_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("measured-value"));
    let width = ui.available_width();
    ui.horizontal(|ui| {
        let unit = space(8.0);
        field_ui(ui, view, CheckField::Measured, name.id, Look::large(width - unit - space(4.0)));
        quiet(ui, "mm");
    });
    error_ui(ui, view, CheckField::Measured);
    ui.horizontal(|ui| {
        for by in [MeasureBy::Typing, MeasureBy::Simulating] {
            view.radio(ui, Action::MeasureBy(by));
        }
        let keypad = view.named(Action::Keypad).selected(view.session.has_keypad());
        view.button_as(ui, Action::Keypad, keypad);
    });
    ui.horizontal(|ui| {
        view.main_button(ui, Action::Measure, vec2(width * 0.6, control(ui)));
        let clear = view.named(Action::ClearResult).min_size(vec2(0.0, control(ui)));
        view.button_as(ui, Action::ClearResult, clear);
    });
}

fn size_and_class_ui(ui: &mut Ui, view: &mut View<'_>) {
    Grid::new("size-and-class").num_columns(2).min_row_height(0.0).spacing(vec2(space(2.0), space(0.5))).show(
        ui,
        |ui| {
            let name = ui.label(view.text("nominal-size"));
            let class = ui.label(view.text("tolerance-class"));
            ui.end_row();
            ui.horizontal(|ui| {
                field_ui(ui, view, CheckField::Nominal, name.id, Look::number(space(22.0)));
                quiet(ui, "mm");
            });
            class_chooser_ui(ui, view, class.id);
            ui.end_row();
        },
    );
    let name = ui.label(view.text("part-name"));
    let width = ui.available_width();
    let look = Look { font: theme::font(sizes().body), ..Look::large(width) };
    field_ui(ui, view, CheckField::Part, name.id, look);
    record_ui(ui, view);
}

fn position_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("probe-position"));
    pairs_ui(
        ui,
        view,
        space(22.0),
        &[
            (CheckField::CentreX, "centre-x", "mm"),
            (CheckField::CentreY, "centre-y", "mm"),
            (CheckField::Height, "height-z", "mm"),
            (CheckField::FirstAngle, "first-contact", "°"),
            (CheckField::Clearance, "clearance", "mm"),
            (CheckField::CentreTolerance, "centre-tolerance", "mm"),
        ],
    );
}

fn simulation_ui(ui: &mut Ui, view: &mut View<'_>) {
    let fields = [
        (CheckField::TrueDiameter, "true-diameter", "mm"),
        (CheckField::Seed, "seed", ""),
        (CheckField::OffsetX, "offset-x", "mm"),
        (CheckField::OffsetY, "offset-y", "mm"),
        (CheckField::Ovality, "ovality", "mm"),
        (CheckField::Lobes, "lobes", ""),
        (CheckField::LobeHeight, "lobe-height", "mm"),
        (CheckField::SurfaceScatter, "surface-scatter", "mm"),
        (CheckField::ProbeScatter, "probe-scatter", "mm"),
    ];
    // An error is never folded away.
    let is_wrong = fields.iter().any(|(field, ..)| view.session.check().error(*field).is_some());
    let header = CollapsingHeader::new(view.text("simulated-workpiece")).id_salt("simulated");
    header.open(is_wrong.then_some(true)).show_unindented(ui, |ui| {
        quiet(ui, view.text("simulated-hint"));
        pairs_ui(ui, view, space(22.0), &fields);
    });
}

/// Two fields beside each other, of this width.
pub(super) fn pairs_ui(ui: &mut Ui, view: &mut View<'_>, width: f32, fields: &[(CheckField, &str, &str)]) {
    let fields: Vec<_> = fields.iter().map(|(field, name, unit)| ((*field).into(), view.text(name), *unit)).collect();
    let pairs = Pairs { column: space(31.0), field: |_: &str| width, gap: space(2.0) };
    field::pairs_ui(ui, view, &pairs, &fields);
}
