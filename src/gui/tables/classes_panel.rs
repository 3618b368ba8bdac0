//! Right, below: classes of ISO 286 as columns of this table, or as a table of their own.

use eframe::egui::{Button, Key, Ui};

use crate::gui::field::{Look, error_ui, field_ui};
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::Message;
use crate::session::tables::Document;
use crate::session::{Command, Field, TablesCommand};

/// The panel's content.
pub(super) fn classes_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.5);
    heading(ui, view.text("tables-from-standard"));
    let name = quiet(ui, view.text("tables-classes"));
    let look = Look { font: theme::font(sizes().body), ..Look::large(ui.available_width()) };
    field_ui(ui, view, Field::TableClasses, name.id, look);
    error_ui(ui, view, Field::TableClasses);
    ui.horizontal_wrapped(|ui| {
        if ui.add(Button::new(view.text("tables-add-columns"))).clicked() {
            view.send(Command::Tables(TablesCommand::AddColumns));
        }
        let selected = view.session.tables().shown().and_then(Document::selected);
        if let Some((class, _)) = selected {
            let remove = Message::new("tables-remove-column").text("class", class);
            if ui.add(Button::new(view.words.say(&remove))).clicked() {
                view.send(Command::Tables(TablesCommand::RemoveColumn));
            }
        }
    });
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        let name = ui.label(view.text("tables-up-to"));
        let to = field_ui(ui, view, Field::TableTo, name.id, Look::number(space(18.0)));
        quiet(ui, "mm");
        let entered = to.has_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if ui.add(Button::new(view.text("tables-make"))).clicked() || entered {
            view.send(Command::Tables(TablesCommand::Make));
        }
    });
    error_ui(ui, view, Field::TableTo);
}
