//! How a setting is set, by its kind. Each takes effect at once.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Align2, Button, Label, Layout, RichText, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2};

use super::gauge_controls::{gauge_ui, port_ui};
use super::slot::{Slot, buttons_ui, line_ui, value_ui, width_of};
use super::told::told;
use crate::gui::field::error_ui;
use crate::gui::segments::segments_ui;
use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, one_of_ui};
use crate::gui::who::who_ui;
use crate::message::message;
use crate::session::{Action, Control, Ruler, RulerStep, Setting, SettingsAction, Told};

/// As many choices stand in sight at most; more of them are a drop-down list.
const MOST_SEGMENTS: usize = 5;

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
