//! How a setting is set, by its kind. Each takes effect at once.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Align2, Button, Color32, Id, Label, Layout, RichText, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2,
};

use super::gauge_controls::{gauge_ui, port_ui};
use super::told::told;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::segments::segments_ui;
use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, one_of_ui, remembered};
use crate::gui::who::who_ui;
use crate::message::message;
use crate::session::{Action, Control, Field, Ruler, RulerStep, Setting, SettingsAction, SettingsField, Told};

/// As many choices stand in sight at most; more of them are a drop-down list.
const MOST_SEGMENTS: usize = 5;

/// Where a control stands.
pub(super) struct Slot {
    /// What labels it.
    pub name: Id,
    /// Whether it ends at the right edge.
    pub is_right: bool,
}

pub(super) fn control_ui(ui: &mut Ui, view: &mut View<'_>, setting: &Setting, slot: &Slot) {
    match setting.control {
        Control::OneOf(choices, _) => choices_ui(ui, view, setting, &choices(), slot),
        Control::Switch(action) => line_ui(ui, slot, "switch", |ui| switch_ui(ui, view, action, slot)),
        Control::Buttons(of, actions) => {
            told_ui(ui, view, of, slot);
            buttons_ui(ui, view, actions, slot);
        }
        Control::Field(field, unit, actions) => {
            value_ui(ui, view, (field, unit), slot);
            error_ui(ui, view, field);
            buttons_ui(ui, view, actions, slot);
        }
        Control::Zoom => line_ui(ui, slot, "zoom", |ui| zoom_ui(ui, view)),
        Control::Ruler => ruler_ui(ui, view, slot),
        Control::Who if view.session.recording().is_on() => line_ui(ui, slot, "who", |ui| who_ui(ui, view)),
        Control::Who => told_ui(ui, view, Told::Journal, slot),
        Control::Gauge(actions) => gauge_ui(ui, view, actions, slot),
        Control::Port(actions) => port_ui(ui, view, actions, slot),
        Control::Told(of) => told_ui(ui, view, of, slot),
    }
}

/// A line that ends at the right edge and yet is in reading order: as wide as it was the last time.
fn line_ui(ui: &mut Ui, slot: &Slot, what: &str, content: impl FnOnce(&mut Ui)) {
    if !slot.is_right {
        ui.horizontal(content);
        return;
    }
    let id = slot.name.with(what);
    let last: f32 = remembered(ui, id);
    ui.horizontal(|ui| {
        if 0.0 < last {
            ui.add_space((ui.available_width() - last).max(0.0));
        }
        let width = ui.horizontal(content).response.rect.width();
        if 0.5 < (width - last).abs() {
            ui.data_mut(|data| data.insert_temp(id, width));
            ui.ctx().request_discard("the width of a line is known");
        }
    });
}

/// The width of buttons with these texts beside each other.
fn width_of(ui: &Ui, texts: &[String]) -> f32 {
    let font = theme::font(sizes().body);
    let text = |text: &String| ui.painter().layout_no_wrap(text.clone(), font.clone(), Color32::PLACEHOLDER).size().x;
    let padding = 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x + 2.0;
    texts.iter().map(|of| text(of) + padding).sum()
}

/// A few choices stand beside each other where they have room, else below each other; more are a list.
fn choices_ui(ui: &mut Ui, view: &mut View<'_>, setting: &Setting, choices: &[Action], slot: &Slot) {
    let names: Vec<String> = choices.iter().map(|choice| choice.text(view.session, view.words)).collect();
    if MOST_SEGMENTS < choices.len() {
        let now = choices.iter().copied().find(|choice| choice.is_on(view.session) == Some(true));
        let width = ui.available_width().min(space(80.0));
        let entries = choices.iter().copied().map(Some).zip(names);
        line_ui(ui, slot, "list", |ui| {
            let (chosen, list) = one_of_ui(ui, setting.name, width - space(2.0), &now, entries);
            list.labelled_by(slot.name);
            if let Some(choice) = chosen.flatten() {
                view.act(choice);
            }
        });
        return;
    }
    // All are as wide as the widest.
    let widest = names.iter().map(|name| width_of(ui, std::slice::from_ref(name))).fold(0.0, f32::max);
    let width = shapes::times(widest, choices.len());
    if width <= ui.available_width() {
        line_ui(ui, slot, "choices", |ui| segments_ui(ui, view, choices, width));
    } else {
        for choice in choices {
            view.radio(ui, *choice);
        }
    }
}

/// The name of the row is that of the switch.
fn switch_ui(ui: &mut Ui, view: &mut View<'_>, action: Action, slot: &Slot) {
    let mut is_on = action.is_on(view.session) == Some(true);
    if ui.checkbox(&mut is_on, "").labelled_by(slot.name).clicked() {
        view.act(action);
    }
}

/// What is in force; nothing where there is nothing to say.
fn told_ui(ui: &mut Ui, view: &View<'_>, of: Told, slot: &Slot) {
    let Some(said) = told(view, of) else { return };
    let text = RichText::new(said).font(theme::font(sizes().body));
    let align = if slot.is_right { Align::RIGHT } else { Align::LEFT };
    ui.with_layout(Layout::top_down(align), |ui| ui.add(Label::new(text).wrap().selectable(true)));
}

/// What can be done: beside each other where there is room.
pub(super) fn buttons_ui(ui: &mut Ui, view: &mut View<'_>, actions: &[Action], slot: &Slot) {
    if actions.is_empty() {
        return;
    }
    let names: Vec<String> = actions.iter().map(|action| action.text(view.session, view.words)).collect();
    if width_of(ui, &names) <= ui.available_width() {
        line_ui(ui, slot, "buttons", |ui| {
            for action in actions {
                view.field_button(ui, *action);
            }
        });
    } else {
        for action in actions {
            view.field_button(ui, *action);
        }
    }
}

/// A field with its unit; one without a unit and with buttons holds a longer text.
pub(super) fn value_ui(ui: &mut Ui, view: &mut View<'_>, (field, unit): (Field, &str), slot: &Slot) {
    if view.session.is_free_text(field) {
        let width = ui.available_width();
        let is_hidden = field == SettingsField::NewPin.into();
        field_ui(ui, view, field, slot.name, FieldStyle { is_hidden, ..FieldStyle::text(width) });
        return;
    }
    line_ui(ui, slot, "field", |ui| {
        field_ui(ui, view, field, slot.name, FieldStyle::number(space(30.0)).unit(unit));
    });
}

/// Smaller, what it is, larger.
fn zoom_ui(ui: &mut Ui, view: &mut View<'_>) {
    let percent = view.words.say(&message!("settings-page-percent").text("percent", view.session.zoom().percent()));
    for (action, shown, width) in [
        (SettingsAction::ZoomOut, "−", control(ui)),
        (SettingsAction::ZoomNormal, percent.as_str(), space(18.0)),
        (SettingsAction::ZoomIn, "+", control(ui)),
    ] {
        let name = action.text(view.session, view.words);
        let said = if action == SettingsAction::ZoomNormal { format!("{percent}, {name}") } else { name.clone() };
        let button = Button::new(shown).min_size(vec2(width, control(ui)));
        let response = view.button_as(ui, action, button).on_hover_text(name);
        let is_enabled = view.session.can(action);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, is_enabled, &said));
    }
}

/// A bank card as wide as the screen is said to show it, and below it what makes it longer or shorter.
fn ruler_ui(ui: &mut Ui, view: &mut View<'_>, slot: &Slot) {
    let palette = palette(ui.ctx());
    let scale = f32::from(view.session.zoom().percent()) / 100.0;
    let known = view.session.ruler();
    let width = known.unwrap_or(Ruler::USUAL).dots() / scale;
    let (rect, response) = ui.allocate_exact_size(vec2(width, space(13.0)), Sense::hover());
    let edge = Stroke::new(2.0, if known.is_some() { palette.accent.0 } else { palette.edge.0 });
    ui.painter().rect(rect, 8.0, palette.sunken.0, edge, StrokeKind::Inside);
    let said = view.text(if known.is_some() { "ruler-known" } else { "ruler-card" });
    ui.painter().text(rect.center(), Align2::CENTER_CENTER, &said, theme::font(sizes().small), palette.text.0);
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &said));
    line_ui(ui, slot, "ruler", |ui| {
        let signs = ["−−", "−", "+", "++"];
        for (step, sign) in RulerStep::ALL.into_iter().zip(signs) {
            let action = SettingsAction::MoveRuler(step);
            let name = action.text(view.session, view.words);
            let button = Button::new(sign).min_size(vec2(control(ui), control(ui)));
            view.button_as(ui, action, button).accessible_name(&name).on_hover_text(name);
        }
        view.field_button(ui, SettingsAction::ForgetRuler);
    });
}
