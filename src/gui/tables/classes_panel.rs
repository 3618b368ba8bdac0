//! Right, below: classes of ISO 286 as columns of this table, or as a table of their own.

use eframe::egui::{Button, Key, Ui};

use crate::gui::field::{Look, error_ui, field_ui};
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::session::{Command, Field, TablesCommand};

/// The panel's content.
pub(super) fn classes_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("tables-from-standard"));
    let name = quiet(ui, view.text("tables-classes"));
    let look = Look { font: theme::font(sizes().body), ..Look::large(ui.available_width()) };
    field_ui(ui, view, Field::TableClasses, name.id, look);
    error_ui(ui, view, Field::TableClasses);
    if ui.add(Button::new(view.text("tables-add-columns"))).clicked() {
        view.send(Command::Tables(TablesCommand::AddColumns));
    }
    ui.horizontal(|ui| {
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
