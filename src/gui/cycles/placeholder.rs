//! Stands in for the drawings.

use eframe::egui::Ui;

use crate::gui::view::{View, quiet};
use crate::probing::circle::Evaluation;
use crate::probing::cycle::{Cycle, CycleResult, Key, Move, Nominal};

pub(super) fn parameter_picture(ui: &mut Ui, _view: &View<'_>, cycle: &Cycle, key: Key) {
    quiet(ui, format!("{} {key}", cycle.code));
}

pub(super) fn path_picture(
    ui: &mut Ui,
    _view: &View<'_>,
    path: &[Move],
    step: usize,
    _nominal: Option<Nominal>,
    _ball_radius: f64,
) {
    quiet(ui, format!("{step} / {}", path.len()));
}

pub(super) fn contacts_picture(ui: &mut Ui, _view: &View<'_>, result: &CycleResult, _evaluation: Option<&Evaluation>) {
    quiet(ui, result.contacts.len().to_string());
}

pub(super) fn criteria_table(ui: &mut Ui, _view: &View<'_>, evaluation: &Evaluation) {
    quiet(ui, evaluation.least_squares.diameter.to_string());
}
