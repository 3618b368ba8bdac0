//! Who is measuring: in the top bar, with the last names and a field for another one.

use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{Button, Id, PopupCloseBehavior, RichText, Ui};

use super::field::{self, FieldStyle, field_ui};
use super::over_page::just_opened;
use super::theme::{self, Icon, Weight, control, sizes, space};
use super::view::{View, focus_soon, quiet, take_focus};
use crate::message::Message;
use crate::session::{Command, RecordsCommand, RecordsField, WindowAction};

/// The button with the name, and its menu; nothing where nothing is recorded.
pub(super) fn who_ui(ui: &mut Ui, view: &mut View<'_>) {
    let recording = view.session.recording();
    if !recording.is_on() {
        return;
    }
    let who = recording.who();
    let shown = if who.is_empty() { view.text("records-page-nobody") } else { shortened(who) };
    let said = Message::new(if who.is_empty() { "records-page-who-nobody" } else { "records-page-who-is" });
    let said = view.words.say(&said.text("name", who));
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let icon = Icon::User.text(Weight::Regular, space(4.5));
    let caret = Icon::CaretDown.text(Weight::Bold, space(3.0));
    let (button, _) = theme::looking(ui, theme::plain, |ui| {
        MenuButton::from_button(Button::new((icon, shown, caret))).config(config).ui(ui, |ui| names_ui(ui, view))
    });
    button.widget_info(|| eframe::egui::WidgetInfo::labeled(eframe::egui::accesskit::Role::Button, true, &said));
    button.on_hover_text(said);
}

/// A long name is cut; the whole one shows under the pointer.
fn shortened(name: &str) -> String {
    const MOST: usize = 14;
    if name.chars().count() <= MOST {
        return name.to_owned();
    }
    name.chars().take(MOST - 1).chain(['…']).collect()
}

/// The last names, and a field for another one.
pub(super) fn names_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.set_min_width(space(50.0));
    let recording = view.session.recording();
    let who = recording.who().to_owned();
    let names = recording.names().to_vec();
    for name in names {
        if ui.radio(name == who, RichText::new(&name).font(theme::font(sizes().body))).clicked() {
            view.send(RecordsCommand::UseName(name));
            ui.close();
        }
    }
    if ui.radio(who.is_empty(), view.text("records-page-nobody-named")).clicked() {
        view.send(RecordsCommand::UseName(String::new()));
        ui.close();
    }
    ui.separator();
    let name = quiet(ui, view.text("records-page-new-name"));
    let look = FieldStyle::text(space(46.0));
    let before = view.commands.len();
    take_focus(ui, field::id(RecordsField::Who));
    // While its size is found out, nothing in a menu can have the focus.
    if !ui.is_sizing_pass() && just_opened(ui, Id::unique("who-names")) {
        focus_soon(ui, field::id(RecordsField::Who));
    }
    // A menu draws what is in it without an edge.
    theme::looking(ui, theme::edged, |ui| field_ui(ui, view, RecordsField::Who, name.id, look));
    view.sized_button(ui, WindowAction::TakeName, eframe::egui::vec2(0.0, control(ui)));
    let is_taken = view
        .commands
        .iter()
        .skip(before)
        .any(|command| matches!(command, Command::Records(RecordsCommand::TakeName) | Command::Enter(_)));
    if is_taken {
        ui.close();
    }
}
