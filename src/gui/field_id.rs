//! The ids of fields, and what is selected in them.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{Context, Id};

use crate::session::Field;

/// The id of a field, the same wherever it is drawn.
pub(super) fn id(field: impl Into<Field>) -> Id {
    Id::unique(("field", field.into()))
}

/// Selects characters of a field.
pub(super) fn select(ctx: &Context, id: Id, range: CCursorRange) {
    // A field that was not drawn yet has no state of its own: it begins with an empty one.
    let mut state = TextEditState::load(ctx, id).unwrap_or_default();
    state.cursor.set_char_range(Some(range));
    state.store(ctx, id);
}

/// Selects the whole text of a field.
pub(super) fn select_all(ctx: &Context, id: Id, text: &str) {
    select(ctx, id, CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count())));
}
