//! The settings, a row each: the name, one line about it, and at the right how it is set; below it where there is no room.

use eframe::egui::{Align, Id, Label, Layout, RichText, ScrollArea, Ui, vec2};

use super::controls::control_ui;
use super::gauge_controls::lines_ui;
use super::keys_panel::keys_ui;
use super::slot::Slot;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::chip_ui;
use crate::gui::view::{View, heading, quiet, steady};
use crate::session::{Section, Setting, SettingsAction};
use crate::verdict::Status;

/// From this width on the control stands at the right of the name.
const BESIDE: f32 = 150.0;

/// The share of the width that the control has there.
const SHARE: f32 = 0.5;

/// The settings of the chosen section, or all that are found, under their sections.
pub(super) fn rows_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.settings_page();
    // What is found stands under several sections.
    let mut section = page.found.is_none().then_some(page.section);
    if let Some(section) = section {
        head_ui(ui, view, section);
    }
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        let shown = page.shown();
        for setting in &shown {
            if section != Some(setting.section) {
                section = Some(setting.section);
                ui.add_space(space(1.0));
                heading(ui, view.text(setting.section.name()));
            }
            ui.separator();
            // A field keeps the focus while a search changes what stands before it.
            steady(ui, setting.name, |ui| row_ui(ui, view, setting));
        }
        if page.found.is_none() && page.section == Section::Appearance {
            preview_ui(ui, view);
        }
        if page.found.is_none() && page.section == Section::Gauges {
            lines_ui(ui, view);
        }
        if page.found.is_none() && page.section == Section::Keys {
            keys_ui(ui, view);
        } else if shown.is_empty() {
            quiet(ui, view.text("settings-page-nothing"));
        }
    });
}

/// How verdicts and numbers look now.
fn preview_ui(ui: &mut Ui, view: &View<'_>) {
    ui.separator();
    ui.label(RichText::new(view.text("settings-page-preview")).font(theme::font(sizes().body)));
    ui.horizontal_wrapped(|ui| {
        for status in Status::ALL {
            chip_ui(ui, status, &view.words.told(&status));
        }
        let value = view.words.number("25.012");
        ui.label(RichText::new(value).font(theme::bold(sizes().figure)));
        quiet(ui, "mm");
    });
}

/// The name of the section, and at the right what sets it back.
fn head_ui(ui: &mut Ui, view: &mut View<'_>, section: Section) {
    ui.horizontal(|ui| {
        ui.set_min_height(control(ui));
        heading(ui, view.text(section.name()));
        if section.has_defaults() {
            let at_right = Layout::right_to_left(Align::Center);
            ui.with_layout(at_right, |ui| view.field_button(ui, SettingsAction::BackToDefaults));
        }
    });
}

fn row_ui(ui: &mut Ui, view: &mut View<'_>, setting: &Setting) {
    let width = ui.available_width();
    let counts = (setting.counts)(view.session);
    if width < space(BESIDE) {
        let name = name_ui(ui, view, setting);
        ui.add_enabled_ui(counts, |ui| control_ui(ui, view, setting, &Slot { name, is_right: false }));
        return;
    }
    let of_control = (width * SHARE).floor();
    ui.horizontal_top(|ui| {
        let gap = ui.spacing().item_spacing.x;
        let of_name = width - of_control - gap;
        let name = ui.allocate_ui(vec2(of_name, 0.0), |ui| {
            ui.set_width(of_name);
            name_ui(ui, view, setting)
        });
        let slot = Slot { name: name.inner, is_right: true };
        ui.allocate_ui(vec2(of_control, 0.0), |ui| {
            ui.set_width(of_control);
            ui.add_enabled_ui(counts, |ui| ui.vertical(|ui| control_ui(ui, view, setting, &slot)));
        });
    });
}

/// The name of a setting and the line about it; returns what its control is labelled by.
fn name_ui(ui: &mut Ui, view: &View<'_>, setting: &Setting) -> Id {
    let colour = palette(ui.ctx()).text.0;
    let text = RichText::new(view.text(setting.name)).font(theme::font(sizes().body)).color(colour);
    let shown = ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let name = ui.add(Label::new(text).wrap());
        quiet(ui, view.text(setting.about));
        name.id
    });
    shown.inner
}
