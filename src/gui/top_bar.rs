//! Top: pages, import and export, and the menu of everything that is set once.

use eframe::egui::{Button, Id, Key, KeyboardShortcut, Modifiers, Panel, RichText, Ui};

use super::theme::{self, sizes, space};
use super::view::View;
use crate::report::RENDERINGS;
use crate::session::{Command, Page, Purpose, SourceChoice, Theme};
use crate::tolerance::iso286::{Edition, JsHalves, Options};
use crate::words::Language;

/// The bar.
pub(super) fn top_bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    Panel::top("top").show(ui, |ui| {
        ui.add_space(space(1.0));
        ui.horizontal(|ui| {
            ui.set_min_height(sizes().touch);
            pages_ui(ui, view);
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

/// The pages by name; Ctrl+1 and so on open them from the keyboard.
fn pages_ui(ui: &mut Ui, view: &mut View<'_>) {
    for (page, key) in Page::ALL.into_iter().zip([Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5]) {
        let open = view.session.page() == page;
        let text = RichText::new(view.text(page_id(page))).font(theme::bold(sizes().heading));
        let shortcut = KeyboardShortcut::new(Modifiers::COMMAND, key);
        let pressed = ui.input_mut(|input| input.consume_shortcut(&shortcut));
        let button = ui.add(Button::selectable(open, text)).on_hover_text(ui.ctx().format_shortcut(&shortcut));
        if (button.clicked() || pressed) && !open {
            view.send(Command::OpenPage(page));
        }
    }
}

const fn page_id(page: Page) -> &'static str {
    match page {
        Page::Check => "page-check",
        Page::Fit => "page-fit",
        Page::Cycles => "page-cycles",
        Page::Tables => "page-tables",
        Page::Program => "page-program",
    }
}

fn export_ui(ui: &mut Ui, view: &mut View<'_>) {
    let has_history = !view.session.history().is_empty();
    for (number, rendering) in RENDERINGS.iter().enumerate() {
        let text = view.text(&format!("export-{}", rendering.name));
        if ui.add_enabled(has_history, Button::new(text)).clicked() {
            view.send(Command::OpenDialog(Purpose::Export(number)));
            ui.close();
        }
    }
    let has_status = view.session.shown().is_some_and(|shown| shown.window.is_ok());
    if ui.add_enabled(has_status, Button::new(view.text("export-status"))).clicked() {
        view.send(Command::OpenDialog(Purpose::ExportStatus));
        ui.close();
    }
}

fn menu_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.menu_button(view.text("language"), |ui| {
        for language in Language::all() {
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
    ui.menu_button(view.text("limits-from"), |ui| standard_ui(ui, view));
    ui.separator();
    let mut entry = |ui: &mut Ui, id: &str, enabled: bool, command: Command| {
        if ui.add_enabled(enabled, Button::new(view.words.get(id))).clicked() {
            view.commands.push(command);
            ui.close();
        }
    };
    entry(ui, "load-tables", true, Command::OpenDialog(Purpose::LoadTables));
    entry(ui, "no-own-tables", !view.session.sources().own().is_empty(), Command::NoOwnTables);
    entry(ui, "load-mask", true, Command::OpenDialog(Purpose::LoadMask));
    ui.separator();
    entry(ui, "undo", view.session.can_undo(), Command::Undo);
    entry(ui, "clear-history", !view.session.history().is_empty(), Command::ClearHistory);
}

/// The two sources of limits, and where editions of ISO 286 differ.
fn standard_ui(ui: &mut Ui, view: &mut View<'_>) {
    for (source, id) in
        [(SourceChoice::Iso286, "source-choice-iso286"), (SourceChoice::ControlTables, "source-choice-control")]
    {
        if ui.radio(view.session.source_choice() == source, view.text(id)).clicked() {
            view.send(Command::UseSource(source));
            ui.close();
        }
    }
    ui.separator();
    let options = view.session.sources().options();
    let mut rounded = options.js == JsHalves::Rounded;
    if ui.checkbox(&mut rounded, view.text("standard-js-rounded")).clicked() {
        let js = if rounded { JsHalves::Rounded } else { JsHalves::Exact };
        view.send(Command::SetStandard(Options { js, ..options }));
    }
    let mut old = options.edition == Edition::Of1988;
    if ui.checkbox(&mut old, view.text("standard-1988")).clicked() {
        let edition = if old { Edition::Of1988 } else { Edition::Of2010 };
        view.send(Command::SetStandard(Options { edition, ..options }));
    }
}
