//! The table page: tables of deviations against ISO 286.

use eframe::egui::{CentralPanel, Ui};

use super::view::{View, heading};

/// The page.
pub(super) fn tables_ui(ui: &mut Ui, view: &mut View<'_>) {
    CentralPanel::default().show(ui, |ui| {
        heading(ui, view.text("page-tables"));
    });
}
