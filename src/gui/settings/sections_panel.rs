//! The search and the sections: as a list where there is room for it, else as a drop-down list.

use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Ui, WidgetInfo, vec2};

use crate::gui::field::{FieldStyle, field_ui};
use crate::gui::theme::{control, palette};
use crate::gui::view::{View, one_of_ui, quiet};
use crate::session::{Section, SettingsAction, SettingsCommand, SettingsField};

/// The field in which settings are looked for.
pub(super) fn find_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("settings-page-find"));
    let look = FieldStyle::text(ui.available_width());
    field_ui(ui, view, SettingsField::Find, name.id, look);
}

/// The sections below each other.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    for action in Section::ALL.map(SettingsAction::ShowSection) {
        let is_on = action.is_on(view.session) == Some(true);
        let name = action.text(view.session, view.words);
        // The colour of the text on the ground of what is chosen.
        let text = if is_on { RichText::new(&name).color(palette(ui.ctx()).text.0) } else { RichText::new(&name) };
        let button = Button::selectable(is_on, text).min_size(vec2(ui.available_width(), control(ui)));
        let response = view.button_as(ui, action, button);
        response.widget_info(|| WidgetInfo::selected(Role::Tab, true, is_on, &name));
    }
}

/// The sections in a drop-down list.
pub(super) fn chooser_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("settings-page-sections"));
    let page = view.session.settings_page();
    let now = Some(page.section).filter(|_| page.found.is_none());
    let entries = Section::ALL.map(|section| (Some(section), view.text(section.name())));
    let (chosen, list) = one_of_ui(ui, "settings-section", ui.available_width(), &now, entries);
    list.labelled_by(name.id);
    if let Some(section) = chosen.flatten() {
        view.send(SettingsCommand::Show(section));
    }
}
