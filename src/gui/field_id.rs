//! The ids of fields.

use eframe::egui::Id;

use crate::session::Field;

/// The id of a field, the same wherever it is drawn.
pub(super) fn id(field: impl Into<Field>) -> Id {
    Id::unique(("field", field.into()))
}
