//! The budget page.

use eframe::egui::{CentralPanel, Ui};

use super::view::{View, heading};

/// The page.
pub(super) fn budget_ui(ui: &mut Ui, view: &mut View<'_>) {
    CentralPanel::default().show(ui, |ui| {
        heading(ui, view.text("page-budget"));
    });
}
