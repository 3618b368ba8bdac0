//! Middle: the figures with their intervals and methods; of a stability study also its chart.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Label, Layout, RichText, Sense, Ui, vec2};

use crate::gui::columns::{column_ui, of_height};
use crate::gui::empty::empty_ui;
use crate::gui::spoken;
use crate::gui::statistics::paint;
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, heading, quiet, quiet_text};
use crate::session::StatisticsAction;
use crate::session::statistics::StudyFigure;

/// From this width on all of a figure stands in one line.
const BESIDE: f32 = 440.0;

/// Between two columns.
const GAP: f32 = 12.0;

/// By how much small text is lower, so that it stands on the line of larger text.
const RAISED: f32 = 2.0;

pub(super) fn seen_ui(ui: &mut Ui, view: &mut View<'_>) {
    let study = &view.session.statistics().study;
    if study.file().is_none() {
        return empty_ui(ui, view, "statistics-study-none", &[StatisticsAction::OpenStudy.into()]);
    }
    if study.evaluated().is_none() {
        quiet(ui, view.text("statistics-study-confirm"));
        return;
    }
    if study.evaluated().is_some_and(|found| found.answer.chart.is_ok()) {
        let height = (ui.available_height() * 0.45).max(space(45.0));
        of_height(ui, height, |ui| chart_ui(ui, view));
    }
    column_ui(ui, "study-figures", |ui| figures_ui(ui, view));
}

fn chart_ui(ui: &mut Ui, view: &View<'_>) {
    let name = view.text("statistics-study-stability");
    heading(ui, &name);
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
    paint::study_ui(ui, view, rect);
    spoken::picture(ui, &response, name, view.session.statistics().study.chart_text(view.words));
}

/// One line for each figure: its name, the figure, its interval or why there is none, its method.
fn figures_ui(ui: &mut Ui, view: &View<'_>) {
    let name = view.text("statistics-page-figures");
    heading(ui, &name);
    let figures = view.session.statistics().study.figures(view.words);
    let width = ui.available_width();
    spoken::around_ui(ui, Role::Group, &name, |ui| {
        ui.spacing_mut().item_spacing = vec2(GAP, space(1.0));
        for figure in &figures {
            if BESIDE <= width {
                beside_ui(ui, figure, width);
            } else {
                below_ui(ui, figure, width);
            }
        }
    });
}

/// Name, figure and what is to be known of it beside each other; the figures end at one edge.
fn beside_ui(ui: &mut Ui, figure: &StudyFigure, width: f32) {
    ui.horizontal_top(|ui| {
        name_ui(ui, figure, width * 0.36);
        value_ui(ui, figure, width * 0.2);
        note_ui(ui, figure, ui.available_width());
    });
}

/// What is to be known of a figure below it.
fn below_ui(ui: &mut Ui, figure: &StudyFigure, width: f32) {
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.horizontal_top(|ui| {
            name_ui(ui, figure, width * 0.6);
            value_ui(ui, figure, ui.available_width());
        });
        note_ui(ui, figure, width);
    });
}

fn cell_ui(ui: &mut Ui, width: f32, align: Align, content: impl FnOnce(&mut Ui)) {
    ui.allocate_ui_with_layout(vec2(width, 0.0), Layout::top_down(align), |ui| {
        ui.set_min_width(width);
        ui.spacing_mut().item_spacing.y = 0.0;
        content(ui);
    });
}

fn name_ui(ui: &mut Ui, figure: &StudyFigure, width: f32) {
    cell_ui(ui, width, Align::Min, |ui| _ = ui.add(Label::new(&figure.name).wrap()));
}

fn value_ui(ui: &mut Ui, figure: &StudyFigure, width: f32) {
    let value = RichText::new(&figure.value).font(theme::bold(sizes().body));
    cell_ui(ui, width, Align::Max, |ui| _ = ui.label(value));
}

/// Its interval or why there is none, and its method.
fn note_ui(ui: &mut Ui, figure: &StudyFigure, width: f32) {
    let StudyFigure { interval, method, .. } = figure;
    let texts = [interval, method].into_iter().filter(|text| !text.is_empty());
    let note = quiet_text(ui, texts.cloned().collect::<Vec<_>>().join("; "));
    cell_ui(ui, width, Align::Min, |ui| {
        ui.add_space(RAISED);
        ui.add(Label::new(note).wrap());
    });
}
