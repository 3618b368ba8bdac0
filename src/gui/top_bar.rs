//! Top: pages, import and export, and the menu of everything that is set once.

use eframe::egui::{Id, Panel, Ui};

use super::theme::{sizes, space};
use super::view::{View, heading};
use crate::report::RENDERINGS;
use crate::session::{Command, Purpose, Theme};
use crate::words::Language;

/// The bar.
pub(super) fn top_bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    Panel::top("top").show(ui, |ui| {
        ui.add_space(space(1.0));
        ui.horizontal(|ui| {
            ui.set_min_height(sizes().touch);
            heading(ui, view.text("page-check"));
            // As wide as the three buttons, so that they stand at the right edge in reading order.
            let width = ui.memory(|memory| memory.data.get_temp(Id::unique("top-buttons"))).unwrap_or(space(70.0));
            ui.add_space((ui.available_width() - width).max(0.0));
            let buttons = ui.horizontal(|ui| {
                ui.spacing_mut().interact_size.y = sizes().touch;
                if ui.button(view.text("import")).clicked() {
                    view.send(Command::OpenDialog(Purpose::Import));
                }
                ui.menu_button(view.text("export"), |ui| export_ui(ui, view));
                ui.menu_button(view.text("menu"), |ui| menu_ui(ui, view));
            });
            let width = buttons.response.rect.width();
            ui.memory_mut(|memory| memory.data.insert_temp(Id::unique("top-buttons"), width));
        });
        ui.add_space(space(1.0));
    });
}

fn export_ui(ui: &mut Ui, view: &mut View<'_>) {
    let has_history = !view.session.history().is_empty();
    for (number, rendering) in RENDERINGS.iter().enumerate() {
        let text = view.text(&format!("export-{}", rendering.name));
        if ui.add_enabled(has_history, eframe::egui::Button::new(text)).clicked() {
            view.send(Command::OpenDialog(Purpose::Export(number)));
            ui.close();
        }
    }
    let has_status = view.session.shown().is_some_and(|shown| shown.window.is_ok());
    if ui.add_enabled(has_status, eframe::egui::Button::new(view.text("export-status"))).clicked() {
        view.send(Command::OpenDialog(Purpose::ExportStatus));
        ui.close();
    }
}

fn menu_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.menu_button(view.text("language"), |ui| {
        for language in Language::COMPLETE {
            if ui.radio(view.session.language() == language, language.name()).clicked() {
                view.send(Command::SetLanguage(language));
                ui.close();
            }
        }
    });
    ui.menu_button(view.text("theme"), |ui| {
        for (theme, id) in [(Theme::System, "theme-system"), (Theme::Light, "theme-light"), (Theme::Dark, "theme-dark")]
        {
            if ui.radio(view.session.theme() == theme, view.text(id)).clicked() {
                view.send(Command::SetTheme(theme));
                ui.close();
            }
        }
    });
    ui.separator();
    let mut entry = |ui: &mut Ui, id: &str, enabled: bool, command: Command| {
        if ui.add_enabled(enabled, eframe::egui::Button::new(view.words.get(id))).clicked() {
            view.commands.push(command);
            ui.close();
        }
    };
    entry(ui, "load-tables", true, Command::OpenDialog(Purpose::LoadTables));
    entry(ui, "no-own-tables", view.session.tables_folder().is_some(), Command::NoOwnTables);
    entry(ui, "load-mask", true, Command::OpenDialog(Purpose::LoadMask));
    ui.separator();
    entry(ui, "undo", view.session.can_undo(), Command::Undo);
    entry(ui, "clear-history", !view.session.history().is_empty(), Command::ClearHistory);
}
