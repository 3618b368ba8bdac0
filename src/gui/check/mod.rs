//! The check page: is it good, and if not, what do I do?
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: callout, limits, measured value, probe position, simulated workpiece |
//! | `band_plot`, `contacts_plot` | middle: what was seen |
//! | `answer_panel`, `status_panel` | right: the verdict, and the control's window |
//! | `history_panel`, `history_list` | bottom: earlier checks |

mod answer_panel;
mod asked_panel;
mod band_plot;
mod contacts_plot;
mod history_list;
mod history_panel;
mod status_panel;

use eframe::egui::{CentralPanel, Panel, ScrollArea, Ui};
pub(super) use history_list::id as history_id;
pub(super) use status_panel::mask_chooser_ui;

use super::theme::space;
use super::view::View;

/// The check page: left what is asked, middle what was seen, right the answer, bottom the earlier checks.
pub(super) fn check_ui(ui: &mut Ui, view: &mut View<'_>) {
    let size = ui.available_size();
    let (narrow, low) = (size.x < 1200.0, size.y < 700.0);
    let folded = narrow || low;
    if folded && !history_panel::is_unfolded(ui) {
        Panel::bottom("strip").exact_size(space(12.0)).show(ui, |ui| history_panel::strip_ui(ui, view));
    } else {
        let height = (size.y * if folded { 0.4 } else { 0.21 }).max(space(40.0));
        Panel::bottom("history").exact_size(height).show(ui, |ui| history_panel::history_ui(ui, view, folded));
    }
    let side = if narrow { space(66.0) } else { space(74.0) };
    Panel::left("asked").exact_size(side).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            // The scroll bar floats: it must not cover the fields.
            ui.set_max_width(ui.available_width() - space(2.5));
            asked_panel::asked_panel_ui(ui, view);
        });
    });
    let side = if narrow { space(82.0) } else { space(88.0).max(size.x * 0.26) };
    Panel::right("answer").exact_size(side).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.set_max_width(ui.available_width() - space(2.5));
            answer_panel::answer_ui(ui, view);
            ui.add_space(space(2.0));
            status_panel::status_ui(ui, view);
        });
    });
    CentralPanel::default().show(ui, |ui| {
        let height = ui.available_height();
        band_plot::band_ui(ui, view, (height * 0.36).clamp(space(34.0), space(70.0)));
        ui.separator();
        contacts_plot::contacts_ui(ui, view);
    });
}
