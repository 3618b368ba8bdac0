//! What stands beside the chart: histogram, spread, probability plot, signals.

use eframe::egui::{Sense, Ui};

use super::signals_panel;
use crate::gui::columns::column_ui;
use crate::gui::spoken;
use crate::gui::view::{View, heading, quiet};
use crate::session::statistics::Aside;

pub(super) fn aside_ui(ui: &mut Ui, view: &mut View<'_>, aside: Aside) {
    let id = match aside {
        Aside::Signals => return column_ui(ui, "statistics-signals", |ui| signals_panel::signals_ui(ui, view)),
        Aside::Histogram => "statistics-page-histogram",
        Aside::Spread => "statistics-page-spread",
        Aside::Probability => "statistics-page-probability",
    };
    heading(ui, view.text(id));
    quiet(ui, "");
    let (_, response) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
    spoken::picture_named(&response, view.text(id));
}
