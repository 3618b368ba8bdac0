//! How high the window is, where that decides what gives way.

use eframe::egui::Ui;

use super::theme::space;

/// Whether the window is so low that pictures give way to words.
pub(super) fn is_low(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < space(160.0)
}

/// Whether there is only room for the word, the value and what to do.
pub(super) fn is_tiny(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < space(120.0)
}
