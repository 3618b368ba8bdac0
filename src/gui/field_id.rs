//! The ids of fields.

use crate::session::Field;
use eframe::egui::Id;

/// The id of a field, the same wherever it is drawn.
pub(super) fn id(field: impl Into<Field>) -> Id {
    Id::unique(("field", field.into()))
}
