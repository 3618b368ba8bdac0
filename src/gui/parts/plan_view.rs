//! The plan as a table, with its picture beside it and what is wrong with it below.

use eframe::egui::Ui;

use super::picture;
use super::plan::{faults, form, grid, tools};
use crate::gui::columns::{Side, bar_ui, column_ui, of_height, panel_ui, rest_ui};
use crate::gui::empty::empty_ui;
use crate::gui::keypad::keypad_ui;
use crate::gui::theme::space;
use crate::gui::view::View;
use crate::session::help::Sample;
use crate::session::{PartsAction, WindowAction};

/// The least size of a window in which table, picture and faults stand beside each other.
const ROOM: [f32; 2] = [225.0, 160.0];

pub(super) fn plan_ui(ui: &mut Ui, view: &mut View<'_>) {
    if view.session.parts().document.is_empty() {
        let actions = [WindowAction::OpenSample(Sample::Part).into(), PartsAction::NewPlan.into()];
        return rest_ui(ui, view, |ui, view| empty_ui(ui, view, "parts-page-no-plan", &actions));
    }
    keypad_ui(ui, view);
    let size = ui.ctx().content_rect().size();
    let [width, height] = ROOM.map(space);
    if size.x < width || size.y < height {
        rest_ui(ui, view, small_ui);
    } else {
        large_ui(ui, view);
    }
}

/// Everything below each other; the page scrolls.
fn small_ui(ui: &mut Ui, view: &mut View<'_>) {
    column_ui(ui, "plan-all", |ui| {
        tools::folded_ui(ui, view);
        of_height(ui, space(50.0), |ui| grid::grid_ui(ui, view));
        faults::here_ui(ui, view);
        faults::count_ui(ui, view);
        if faults::has_any(view) {
            of_height(ui, space(40.0), |ui| faults::list_ui(ui, view));
        }
        ui.collapsing(view.text("parts-page-head"), |ui| form::form_ui(ui, view));
        if view.session.parts().sight().is_some() {
            of_height(ui, space(75.0), |ui| picture::plan_picture_ui(ui, view));
        }
    });
}

fn large_ui(ui: &mut Ui, view: &mut View<'_>) {
    bar_ui(ui, view, Side::Top, "plan-tools", |ui, view| {
        form::form_ui(ui, view);
        tools::tools_ui(ui, view);
    });
    if view.session.parts().sight().is_some() {
        let all = ui.available_width();
        let sizes = (all * 0.38, all * 0.2..=all * 0.6);
        panel_ui(ui, view, Side::Right, "plan-picture", sizes, picture::plan_picture_ui);
    }
    if faults::has_any(view) {
        let all = ui.available_height();
        let sizes = ((all * 0.4).min(space(50.0)), space(22.0)..=(all * 0.6).max(space(23.0)));
        panel_ui(ui, view, Side::Bottom, "plan-faults", sizes, faults::list_ui);
    }
    rest_ui(ui, view, |ui, view| {
        // In its place whether there are faults or not: the table does not move.
        faults::count_ui(ui, view);
        let room = ui.available_height() - space(8.0);
        of_height(ui, room, |ui| grid::grid_ui(ui, view));
        faults::here_ui(ui, view);
    });
}
