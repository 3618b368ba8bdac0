//! The search and the sections: as a list where there is room for it, else as a drop-down list.

use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Ui, WidgetInfo, vec2};

use crate::gui::field::{FieldStyle, field_ui};
use crate::gui::theme::{Icon, Weight, control, palette, space};
use crate::gui::view::{View, one_of_ui, quiet};
use crate::session::{Section, SettingsAction, SettingsCommand, SettingsField};

/// The field in which settings are looked for.
pub(super) fn find_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("settings-page-find"));
    let look = FieldStyle::text(ui.available_width());
    field_ui(ui, view, SettingsField::Find, name.id, look);
}

const fn icon_of(section: Section) -> Icon {
    match section {
        Section::General => Icon::User,
        Section::Appearance => Icon::Palette,
        Section::Rule => Icon::Scales,
        Section::OwnFiles => Icon::Folder,
        Section::Records => Icon::Database,
        Section::ShopServer => Icon::Buildings,
        Section::Gauges => Icon::LinkSimpleHorizontal,
        Section::Folders => Icon::FolderOpen,
        Section::Keys => Icon::Keyboard,
        Section::About => Icon::Info,
    }
}

/// The sections below each other.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    for section in Section::ALL {
        let action = SettingsAction::ShowSection(section);
        let is_on = action.is_on(view.session) == Some(true);
        let name = action.text(view.session, view.words);
        // The colour of the text on the ground of what is chosen.
        let colour = palette(ui.ctx()).text.0;
        let text = if is_on { RichText::new(&name).color(colour) } else { RichText::new(&name) };
        let icon = icon_of(section).text(if is_on { Weight::Fill } else { Weight::Regular }, space(5.0)).color(colour);
        let button = Button::selectable(is_on, (icon, text)).min_size(vec2(ui.available_width(), control(ui)));
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
