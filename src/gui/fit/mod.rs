//! The fit page: a hole against a shaft.
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: the callout, fits to pick from |
//! | `parts_panel` | left: measured parts, temperature and materials |
//! | `search_panel` | left: from a wanted clearance to classes |
//! | `picture` | middle: the classical picture |
//! | `class_map`, `staircase` | middle: every class at this size, and where the zones of a grade lie |
//! | `answer_panel` | right: kind of fit, figures, limits, equivalent fit, what the parts do |

mod answer_panel;
mod asked_panel;
mod class_map;
mod parts_panel;
mod picture;
mod search_panel;
mod staircase;

use eframe::egui::{CentralPanel, Id, Panel, ScrollArea, Ui};

pub(super) use class_map::map_id;

use super::dialogs::just_opened;
use super::field;
use super::theme::space;
use super::view::View;
use crate::session::FitField;

/// The page: left what is asked, middle what is seen, right the answer.
pub(super) fn fit_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("fit-page")) {
        ui.memory_mut(|memory| memory.request_focus(field::id(FitField::Callout)));
    }
    let size = ui.available_size();
    let narrow = size.x < 1200.0;
    let side = if narrow { space(66.0) } else { space(74.0) };
    Panel::left("fit-asked").exact_size(side).show(ui, |ui| {
        column_ui(ui, |ui| {
            asked_panel::callout_ui(ui, view);
            ui.separator();
            parts_panel::parts_ui(ui, view);
            ui.separator();
            parts_panel::temperature_ui(ui, view);
            ui.separator();
            search_panel::search_ui(ui, view);
        });
    });
    let side = if narrow { space(72.0) } else { space(80.0).max(size.x * 0.25) };
    Panel::right("fit-answer").exact_size(side).show(ui, |ui| column_ui(ui, |ui| answer_panel::answer_ui(ui, view)));
    CentralPanel::default().show(ui, |ui| {
        let height = ui.available_height();
        column_ui(ui, |ui| {
            picture::picture_ui(ui, view, (height * 0.31).max(space(50.0)));
            ui.separator();
            class_map::class_map_ui(ui, view, height);
        });
    });
}

/// A column that scrolls where the window is low; the floating bar never covers its content.
fn column_ui(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.set_max_width(ui.available_width() - space(2.5));
        ui.spacing_mut().item_spacing.y = space(1.0);
        content(ui);
    });
}
