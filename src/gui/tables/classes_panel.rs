//! Right, below: classes of ISO 286 as columns of this table, or as a table of their own.

use eframe::egui::Ui;

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::space;
use crate::gui::view::{View, heading, quiet};
use crate::session::{TablesAction, TablesField};

/// The panel's content.
pub(super) fn classes_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.5);
    heading(ui, view.text("tables-from-standard"));
    let name = quiet(ui, view.text("tables-classes"));
    let look = FieldStyle::text(ui.available_width());
    field_ui(ui, view, TablesField::Classes, name.id, look);
    error_ui(ui, view, TablesField::Classes);
    ui.horizontal_wrapped(|ui| {
        view.button(ui, TablesAction::AddColumns);
        if view.session.can(TablesAction::RemoveColumn) {
            view.button(ui, TablesAction::RemoveColumn);
        }
    });
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        let name = ui.label(view.text("tables-up-to"));
        field_ui(ui, view, TablesField::To, name.id, FieldStyle::number(space(22.0)).unit("mm"));
        view.button(ui, TablesAction::MakeTable);
    });
    error_ui(ui, view, TablesField::To);
}
