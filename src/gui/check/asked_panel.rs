//! Left: what is asked. Callout, limits, measured value, probe position, simulated workpiece.

use eframe::egui::{Align, CollapsingHeader, Grid, Key, Layout, Rect, Sense, Ui, UiBuilder, vec2};

use super::field_pairs::pairs_ui;
use crate::gui::check::record_panel::record_ui;
use crate::gui::check::rule_panel::worth_ui;
use crate::gui::class_chooser::{class_chooser_ui, feature_picture};
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::limits::{self, feature_id};
use crate::gui::theme::{control, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::message;
use crate::session::{CheckAction, WindowAction};
use crate::session::{CheckCommand, CheckField, Command, MeasureBy};
use crate::tolerance::{Feature, Limits, Source};

/// The panel's content.
pub(super) fn asked_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let features = callout_ui(ui, view);
    ui.add_space(space(1.0));
    match view.session.check().asked.limits.as_ref() {
        Some(limits) => limits_ui(ui, view, limits),
        None => no_limits_ui(ui, view),
    }
    ui.separator();
    measured_ui(ui, view, features);
    ui.separator();
    worth_ui(ui, view);
    ui.separator();
    size_and_class_ui(ui, view);
    ui.separator();
    position_ui(ui, view);
    ui.add_space(space(1.0));
    simulation_ui(ui, view);
}

/// The callout; returns the room for hole and shaft, where it does not say which.
fn callout_ui(ui: &mut Ui, view: &mut View<'_>) -> Option<Rect> {
    let name = heading(ui, view.text("callout"));
    let width = ui.available_width();
    field_ui(ui, view, CheckField::Callout, name.id, FieldStyle::large(width));
    error_ui(ui, view, CheckField::Callout);
    let row = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let is_asked = view.session.check().asked.needs_feature();
    is_asked.then(|| ui.allocate_exact_size(row, Sense::hover()).0)
}

/// Hole or shaft, where the callout does not say it. Tab comes here behind the value, which is typed next, and Enter chooses neither: it may
/// be the end of a line that was typed in one go.
fn feature_ui(ui: &mut Ui, view: &mut View<'_>, rect: Rect) {
    let row = UiBuilder::new().max_rect(rect).layout(Layout::left_to_right(Align::Center));
    // A child leaves the cursor of the panel where it is: below the value.
    let ui = &mut ui.new_child(row);
    for feature in [Feature::Hole, Feature::Shaft] {
        feature_picture(ui, feature, space(6.0));
        let chosen = view.session.check().feature() == Some(feature);
        let is_chosen = ui.radio(chosen, view.text(feature_id(feature))).clicked();
        if is_chosen && !ui.input(|input| input.key_pressed(Key::Enter)) {
            view.send(CheckCommand::ChooseFeature(feature));
            view.send(Command::GoTo(CheckField::Measured.into()));
        }
    }
}

fn limits_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits) {
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        feature_picture(ui, limits.feature, space(6.0));
        ui.label(view.text(feature_id(limits.feature)));
        quiet(ui, view.words.say(&message!("nominal-is").number("nominal", limits.nominal)));
    });
    limits::limits_ui(ui, view, limits);
    if let Source::Table { instead_of: Some(standard), .. } = &limits.source {
        let by = limits.deviations.minus(standard);
        let instead = message!("source-overrides")
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

fn measured_ui(ui: &mut Ui, view: &mut View<'_>, features: Option<Rect>) {
    let name = heading(ui, view.text("measured-value"));
    let width = ui.available_width();
    ui.horizontal(|ui| {
        let unit = space(8.0);
        field_ui(ui, view, CheckField::Measured, name.id, FieldStyle::large(width - unit - space(4.0)));
        quiet(ui, "mm");
    });
    if let Some(rect) = features {
        feature_ui(ui, view, rect);
    }
    error_ui(ui, view, CheckField::Measured);
    if view.session.check().is_repeated {
        quiet(ui, view.text("measured-once"));
    }
    ui.horizontal(|ui| {
        for by in [MeasureBy::Typing, MeasureBy::Simulating] {
            view.radio(ui, CheckAction::MeasureBy(by));
        }
        view.toggle(ui, WindowAction::Keypad);
    });
    ui.horizontal(|ui| {
        view.main_button(ui, CheckAction::Measure, vec2(width * 0.6, control(ui)));
        view.field_button(ui, CheckAction::ClearResult);
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
                field_ui(ui, view, CheckField::Nominal, name.id, FieldStyle::number(space(22.0)));
                quiet(ui, "mm");
            });
            class_chooser_ui(ui, view, class.id);
            ui.end_row();
        },
    );
    let name = ui.label(view.text("part-name"));
    let width = ui.available_width();
    let look = FieldStyle::text(width);
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
    let is_wrong = fields.iter().any(|(field, ..)| view.session.error(*field).is_some());
    let header = CollapsingHeader::new(view.text("simulated-workpiece")).id_salt("simulated");
    header.open(is_wrong.then_some(true)).show_unindented(ui, |ui| {
        quiet(ui, view.text("simulated-hint"));
        pairs_ui(ui, view, space(22.0), &fields);
    });
}
