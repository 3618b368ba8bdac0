//! Top: pages, import and export, and the menu of settings.

use std::path::Path;

use eframe::egui::{Button, Id, Panel, RichText, Ui};

use super::theme::{self, control, sizes, space};
use super::view::{View, quiet, remembered};
use super::who::{names_ui, who_ui};
use crate::message::message;
use crate::report::RENDERINGS;
use crate::session::{Action, Command, Density, FilesCommand, Page, Theme};
use crate::session::{CheckAction, WindowAction};
use crate::tolerance::Base;
use crate::words::Language;

/// The bar: pages, import and export, settings; where the window is narrow, all of them in menus.
pub(super) fn top_bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    Panel::top("top").resizable(false).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.set_min_height(control(ui));
            let id = Id::unique("top-bar");
            // The widths of the last frame: what has no room goes into the menus.
            let [pages, buttons]: [f32; 2] = remembered(ui, id);
            let all = ui.available_width();
            let has_room = pages + buttons + space(4.0) <= all;
            let before = ui.cursor().left();
            if has_room {
                pages_ui(ui, view);
            } else {
                let open = WindowAction::Open(view.session.page()).text(view.session, view.words);
                let text = RichText::new(format!("{open} ▾")).font(theme::bold(sizes().heading));
                ui.menu_button(text, |ui| {
                    for page in Page::ALL.map(WindowAction::Open) {
                        view.menu_item(ui, page);
                    }
                });
            }
            let pages = if has_room { ui.cursor().left() - before } else { pages };
            // As wide as the buttons, so that they end at the right edge in reading order.
            let width = if has_room { buttons } else { remembered(ui, id.with("few")) };
            ui.add_space((ui.available_width() - width).max(0.0));
            let shown = ui.horizontal(|ui| {
                if has_room {
                    who_ui(ui, view);
                    view.button(ui, WindowAction::Import);
                    ui.menu_button(view.text("export"), |ui| export_ui(ui, view));
                }
                ui.menu_button(view.text("menu"), |ui| {
                    if !has_room {
                        if view.session.recording().is_on() {
                            ui.menu_button(view.text("records-page-who"), |ui| names_ui(ui, view));
                        }
                        view.menu_item(ui, WindowAction::Import);
                        ui.menu_button(view.text("export"), |ui| export_ui(ui, view));
                        ui.separator();
                    }
                    menu_ui(ui, view);
                });
            });
            let width = shown.response.rect.width();
            ui.data_mut(|data| {
                data.insert_temp(id, [pages, if has_room { width } else { buttons }]);
                data.insert_temp(id.with("few"), width);
            });
        });
    });
}

/// The pages by name.
fn pages_ui(ui: &mut Ui, view: &mut View<'_>) {
    for page in Page::ALL.map(WindowAction::Open) {
        let text = RichText::new(page.text(view.session, view.words)).font(theme::bold(sizes().heading));
        view.button_as(ui, page, Button::selectable(page.is_on(view.session) == Some(true), text));
    }
}

fn export_ui(ui: &mut Ui, view: &mut View<'_>) {
    for number in 0..RENDERINGS.len() {
        view.menu_item(ui, WindowAction::Export(number));
    }
    view.menu_item(ui, WindowAction::ExportStatus);
    ui.separator();
    // What will be exported is said before it is.
    let history = view.session.history();
    let rows = view.session.check().rows.as_ref().filter(|_| view.session.lists_rows());
    let said = match (history.chosen_count(), history.exported_count()) {
        (0, listed) if listed < history.len() => {
            message!("history-exported-listed").count("count", listed).count("all", history.len())
        }
        (0, count) => message!("history-exported").count("count", count),
        (chosen, _) => message!("history-chosen").count("count", chosen),
    };
    let said = rows.map_or(said, |rows| message!("rows-not-exported").text("name", &rows.name));
    quiet(ui, view.words.say(&said));
    let choosing = [WindowAction::ChooseBad.into(), CheckAction::ChooseAll.into(), WindowAction::ChooseNone.into()];
    for action in choosing.into_iter().chain([Action::from(CheckAction::CopyChecks)]) {
        view.menu_item(ui, action);
    }
}

fn menu_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.menu_item(ui, WindowAction::Palette);
    recent_ui(ui, view);
    ui.separator();
    ui.menu_button(view.text("language"), |ui| {
        for language in Language::all() {
            if ui.radio(view.session.language() == language, language.name()).clicked() {
                view.send(Command::SetLanguage(language));
                ui.close();
            }
        }
    });
    ui.menu_button(view.text("theme"), |ui| {
        choices_ui(ui, view, [Theme::System, Theme::Light, Theme::Dark].map(WindowAction::UseTheme));
    });
    ui.menu_button(view.text("density"), |ui| choices_ui(ui, view, Density::ALL.map(WindowAction::UseDensity)));
    ui.menu_button(view.text("limits-from"), |ui| {
        choices_ui(ui, view, Base::ALL.map(WindowAction::UseSource));
        ui.separator();
        view.checkbox(ui, WindowAction::RoundJs);
        view.checkbox(ui, WindowAction::Edition1988);
    });
    ui.separator();
    for action in
        [WindowAction::ImportColumns, WindowAction::LoadTables, WindowAction::NoOwnTables, WindowAction::LoadMask]
    {
        view.menu_item(ui, action);
    }
    ui.separator();
    for action in [WindowAction::Undo, WindowAction::ClearHistory] {
        view.menu_item(ui, action);
    }
}

/// The files that were read last, each with its folder.
fn recent_ui(ui: &mut Ui, view: &mut View<'_>) {
    let recent = view.session.recent_files();
    ui.add_enabled_ui(!recent.is_empty(), |ui| {
        ui.menu_button(view.text("recent-files"), |ui| {
            for (number, file) in recent.iter().enumerate() {
                let name = file.path.file_name().unwrap_or(file.path.as_os_str()).to_string_lossy();
                let folder = file.path.parent().unwrap_or(Path::new("")).display();
                let told = message!("recent-file")
                    .text("name", name)
                    .text("what", view.text(file.purpose.title()))
                    .text("folder", folder);
                if ui.button(view.words.say(&told)).clicked() {
                    view.send(FilesCommand::OpenRecent(number));
                    ui.close();
                }
            }
            ui.separator();
            view.menu_item(ui, WindowAction::ForgetRecent);
        });
    });
}

/// Choices that close their menu.
fn choices_ui(ui: &mut Ui, view: &mut View<'_>, choices: impl IntoIterator<Item = impl Into<Action>>) {
    for choice in choices {
        if view.radio(ui, choice) {
            ui.close();
        }
    }
}
