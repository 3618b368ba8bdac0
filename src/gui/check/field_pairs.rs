//! Fields of the check page, two beside each other.

use eframe::egui::Ui;

use crate::gui::field;
use crate::gui::view::View;
use crate::session::CheckField;

pub(super) fn pairs_ui(ui: &mut Ui, view: &mut View<'_>, fields: &[(CheckField, &str, &str)]) {
    let fields: Vec<_> = fields.iter().map(|(field, name, unit)| ((*field).into(), view.text(name), *unit)).collect();
    field::pairs_ui(ui, view, &fields);
}
