//! The figures with their intervals, beside each other as far as there is room.

use eframe::egui::{Label, RichText, Sense, Ui, vec2};

use crate::gui::shapes::{lines_of, times};
use crate::gui::spoken;
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, quiet_text};
use crate::session::statistics::FigureText;
use eframe::egui::accesskit::Role;

/// The least width of a figure with its interval.
const LEAST: f32 = 116.0;

/// The height of the card in which all stand beside each other.
pub(super) fn height(ui: &Ui) -> f32 {
    let row = |size: f32| ui.fonts_mut(|fonts| fonts.row_height(&theme::font(size)));
    row(sizes().figure) + 3.0 * row(sizes().small) + 2.0 * space(6.0)
}

pub(super) fn figures_ui(ui: &mut Ui, view: &View<'_>) {
    let figures = view.session.statistics().figures(view.words);
    let fit = lines_of(ui.available_width() / LEAST).clamp(2, figures.len().max(2));
    let width = ui.available_width() / times(1.0, fit);
    let name = view.text("statistics-page-figures");
    spoken::around_ui(ui, Role::Group, &name, |ui| {
        for row in figures.chunks(fit) {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing = vec2(0.0, 0.0);
                for figure in row {
                    ui.allocate_ui(vec2(width, 0.0), |ui| figure_ui(ui, figure, width));
                }
            });
        }
    });
}

fn figure_ui(ui: &mut Ui, figure: &FigureText, width: f32) {
    ui.vertical(|ui| {
        ui.set_width(width);
        ui.spacing_mut().item_spacing.y = 0.0;
        let FigureText { name, value, unit, note } = figure;
        let text = quiet_text(ui, name);
        ui.add(Label::new(text).wrap());
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = space(1.0);
            ui.spacing_mut().interact_size.y = 0.0;
            ui.label(RichText::new(value).font(theme::bold(sizes().figure)));
            if !unit.is_empty() {
                ui.label(quiet_text(ui, unit));
            }
        });
        let note = RichText::new(note).size(sizes().small);
        ui.add(Label::new(note).wrap().sense(Sense::hover()));
    });
}
