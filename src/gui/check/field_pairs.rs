//! Fields of the check page, two beside each other.

use eframe::egui::Ui;

use crate::gui::field::{self, Pairs};
use crate::gui::theme::space;
use crate::gui::view::View;
use crate::session::CheckField;

/// Two fields beside each other, of this width.
pub(super) fn pairs_ui(ui: &mut Ui, view: &mut View<'_>, width: f32, fields: &[(CheckField, &str, &str)]) {
    let fields: Vec<_> = fields.iter().map(|(field, name, unit)| ((*field).into(), view.text(name), *unit)).collect();
    let pairs = Pairs { column: space(31.0), field: |_: &str| width, gap: space(2.0) };
    field::pairs_ui(ui, view, &pairs, &fields);
}
