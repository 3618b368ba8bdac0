//! Left: what is asked. Callout, limits, measured value, probe position, simulated workpiece.

use eframe::egui::{Align, Color32, Grid, Key, Layout, Rect, Sense, Ui, UiBuilder, vec2};

use super::field_pairs::pairs_ui;
use crate::gui::check::record_panel::record_ui;
use crate::gui::check::rule_panel::worth_ui;
use crate::gui::class_chooser::{class_chooser_ui, feature_picture};
use crate::gui::field::{FieldStyle, error_ui, field_ui, half_width, keypad_button_ui, value_field_ui};
use crate::gui::limits::{self, feature_id};
use crate::gui::room::is_low;
use crate::gui::section::Section;
use crate::gui::segments::segments_ui;
use crate::gui::theme::{self, Icon, control, sizes, space};
use crate::gui::view::{View, quiet};
use crate::message::message;
use crate::session::{CheckAction, CheckCommand, CheckField, Command, MeasureBy};
use crate::tolerance::{Feature, Limits, Source};

/// Callout and measured value beside each other, where the keypad leaves little room.
pub(super) fn typed_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let gap = space(2.0);
    let width = ui.available_width() - gap;
    let callout = (width * 0.45).floor();
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing = vec2(gap, space(1.0));
        for (field, width) in [(CheckField::Callout, callout), (CheckField::Measured, width - callout)] {
            ui.allocate_ui_with_layout(vec2(width, 0.0), Layout::top_down(Align::Min), |ui| {
                ui.set_width(width);
                if field == CheckField::Callout {
                    callout_field_ui(ui, view);
                } else {
                    let rect = measured_ui(ui, view);
                    keypad_button_ui(ui, view, CheckField::Measured, rect);
                }
                error_ui(ui, view, field);
            });
        }
    });
    ui.add_space(space(0.5));
}

/// The panel's content: what is asked, and below it what an engineer sets, folded. What `is_typed_above` is not asked once more.
pub(super) fn asked_panel_ui(ui: &mut Ui, view: &mut View<'_>, is_typed_above: bool) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let top = ui.cursor().top();
    if !is_typed_above {
        callout_field_ui(ui, view);
        error_ui(ui, view, CheckField::Callout);
    }
    let features = room_of_feature(ui, view);
    ui.add_space(space(1.0));
    match view.session.check().asked.limits.as_ref() {
        Some(limits) => limits_ui(ui, view, limits, features.is_none()),
        None => no_limits_ui(ui, view),
    }
    // The field of the value stands still, whatever the callout says.
    if !is_typed_above {
        ui.add_space((room_of_callout(ui) - (ui.cursor().top() - top)).max(0.0));
    }
    ui.add_space(space(1.0));
    // By touch a low window has no room for all of it: what the callout says, too, stands behind the buttons there.
    let is_behind = is_low(ui) && sizes().mouse < control(ui);
    let size_and_class = (!is_behind).then(|| {
        let size = vec2(ui.available_width(), sizes().small * 1.4 + control(ui) + space(1.0));
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        ui.add_space(space(1.0));
        rect
    });
    let field = (!is_typed_above).then(|| measured_ui(ui, view));
    if let Some(rect) = features {
        feature_ui(ui, view, rect);
    }
    if let Some(rect) = field {
        keypad_button_ui(ui, view, CheckField::Measured, rect);
        error_ui(ui, view, CheckField::Measured);
    }
    measure_ui(ui, view);
    // Tab goes from the callout to the value, as the work does.
    match size_and_class {
        Some(rect) => size_and_class_ui(&mut ui.new_child(UiBuilder::new().max_rect(rect)), view),
        None => size_and_class_ui(ui, view),
    }
    ui.add_space(space(3.0));
    ui.separator();
    position_ui(ui, view);
    simulation_ui(ui, view);
    worth_ui(ui, view);
    part_ui(ui, view);
    record_ui(ui, view);
}

/// The height of the callout and the limits that it usually has. Where the window is low nothing is kept free.
fn room_of_callout(ui: &Ui) -> f32 {
    if is_low(ui) {
        return 0.0;
    }
    let line =
        |size: f32| ui.painter().layout_no_wrap("0".to_owned(), theme::font(size), Color32::PLACEHOLDER).size().y;
    // A name, or the choice between hole and shaft.
    let feature = ui.spacing().interact_size.y;
    let callout = line(sizes().small) + FieldStyle::callout(ui).height.max(control(ui));
    let gaps = ui.spacing().item_spacing.y * 6.0 + space(1.0);
    callout + feature + 2.0 * line(sizes().limits) + line(sizes().small) + gaps
}

fn callout_field_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("callout"));
    let style = FieldStyle::callout(ui);
    field_ui(ui, view, CheckField::Callout, name.id, style);
}

/// The room for hole and shaft, where the callout does not say which.
fn room_of_feature(ui: &mut Ui, view: &View<'_>) -> Option<Rect> {
    let row = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let check = view.session.check();
    let is_asked = check.asked.needs_feature() || check.can_be_said(view.session.history());
    is_asked.then(|| ui.allocate_exact_size(row, Sense::hover()).0)
}

/// Hole or shaft, where the callout does not say it. Tab comes here behind the value, which is typed next, and Enter chooses neither: it may
/// be the end of a line that was typed in one go.
fn feature_ui(ui: &mut Ui, view: &mut View<'_>, rect: Rect) {
    let row = UiBuilder::new().max_rect(rect).layout(Layout::left_to_right(Align::Center));
    // A child leaves the cursor of the panel where it is: below the value.
    let ui = &mut ui.new_child(row);
    // A fit has one of the two; any other size may be neither.
    let is_fit = view.session.check().asked.is_fit();
    let choices = [Some(Feature::Hole), Some(Feature::Shaft), None];
    for feature in choices.into_iter().filter(|feature| feature.is_some() || !is_fit) {
        let asked = &view.session.check().asked;
        // Without a callout the limits on screen say it.
        let meant = asked.limits.as_ref().filter(|_| asked.callout.is_none()).map(|limits| limits.feature);
        let chosen =
            meant.unwrap_or_else(|| view.session.check().feature()) == feature && (feature.is_some() || !is_fit);
        let is_chosen = ui.radio(chosen, view.text(feature_id(feature))).clicked();
        if is_chosen && !ui.input(|input| input.key_pressed(Key::Enter)) {
            view.send(CheckCommand::ChooseFeature(feature));
            view.send(Command::GoTo(CheckField::Measured.into()));
        }
    }
}

/// The limits; the feature by its name where it is not chosen above.
fn limits_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits, names_feature: bool) {
    if names_feature {
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = 0.0;
            if let Some(feature) = limits.feature {
                feature_picture(ui, feature, space(6.0));
            }
            ui.label(view.text(feature_id(limits.feature)));
            quiet(ui, view.words.say(&message!("nominal-is").number("nominal", limits.nominal)));
        });
    }
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

fn measured_ui(ui: &mut Ui, view: &mut View<'_>) -> Rect {
    let name = quiet(ui, view.text("measured-value"));
    let style = FieldStyle::value(ui, ui.available_width());
    value_field_ui(ui, view, CheckField::Measured, name.id, style)
}

/// How a value comes, and the buttons.
fn measure_ui(ui: &mut Ui, view: &mut View<'_>) {
    let width = ui.available_width();
    segments_ui(ui, view, &[MeasureBy::Typing, MeasureBy::Simulating].map(CheckAction::MeasureBy), width);
    ui.add_space(space(0.5));
    ui.horizontal(|ui| {
        let clear = view.width_of(ui, &[CheckAction::ClearResult]) + ui.spacing().item_spacing.x;
        view.main_button(ui, CheckAction::Measure, vec2((width - clear).max(width * 0.5), control(ui) + space(2.0)));
        view.sized_button(ui, CheckAction::ClearResult, vec2(0.0, control(ui) + space(2.0)));
    });
    // Below the buttons, which stay where they are.
    if view.session.check().is_repeated {
        quiet(ui, view.text("measured-once"));
    }
    if let Some(gauge) = &view.session.check().gauge {
        let told = std::iter::once(view.words.say(&gauge.told()));
        let remarks = gauge.remarks.iter().map(|remark| view.words.told(remark));
        quiet(ui, told.chain(remarks).collect::<Vec<_>>().join("; "));
    }
}

fn size_and_class_ui(ui: &mut Ui, view: &mut View<'_>) {
    let width = half_width(ui);
    let grid = Grid::new("size-and-class").num_columns(2).min_row_height(0.0).min_col_width(width);
    grid.spacing(vec2(ui.available_width() - 2.0 * width, space(0.5))).show(ui, |ui| {
        let name = quiet(ui, view.text("nominal-size"));
        let class = quiet(ui, view.text("tolerance-class"));
        ui.end_row();
        field_ui(ui, view, CheckField::Nominal, name.id, FieldStyle::number(width).unit("mm"));
        class_chooser_ui(ui, view, class.id, width);
        ui.end_row();
    });
}

/// The name of what is measured.
fn part_ui(ui: &mut Ui, view: &mut View<'_>) {
    let value = view.session.text(CheckField::Part).trim().to_owned();
    let is_wrong = view.session.error(CheckField::Part).is_some();
    Section { icon: Icon::Cube, name: "part-section", value, is_wrong }.show(ui, view, |ui, view| {
        let name = quiet(ui, view.text("part-name"));
        let width = ui.available_width();
        field_ui(ui, view, CheckField::Part, name.id, FieldStyle::text(width));
        error_ui(ui, view, CheckField::Part);
    });
}

/// Where it is probed.
fn position_ui(ui: &mut Ui, view: &mut View<'_>) {
    let fields = [
        (CheckField::CentreX, "centre-x", "mm"),
        (CheckField::CentreY, "centre-y", "mm"),
        (CheckField::Height, "height-z", "mm"),
        (CheckField::FirstAngle, "first-contact", "°"),
        (CheckField::Clearance, "clearance", "mm"),
        (CheckField::CentreTolerance, "centre-tolerance", "mm"),
    ];
    let [x, y, z] = [CheckField::CentreX, CheckField::CentreY, CheckField::Height]
        .map(|field| view.words.number(view.session.text(field).trim()));
    let value = format!("X {x} Y {y} Z {z}");
    let is_wrong = fields.iter().any(|(field, ..)| view.session.error(*field).is_some());
    Section { icon: Icon::Crosshair, name: "probe-position", value, is_wrong }.show(ui, view, |ui, view| {
        pairs_ui(ui, view, &fields);
    });
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
    let is_wrong = fields.iter().any(|(field, ..)| view.session.error(*field).is_some());
    let value = view.words.number(view.session.text(CheckField::TrueDiameter).trim());
    let section = Section { icon: Icon::Play, name: "simulated-workpiece", value, is_wrong };
    section.show(ui, view, |ui, view| {
        quiet(ui, view.text("simulated-hint"));
        pairs_ui(ui, view, &fields);
    });
}
