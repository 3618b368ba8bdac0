//! What can be done with rows and columns, as buttons.

use eframe::egui::Ui;

use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, quiet};
use crate::message::message;
use crate::session::{PartsAction, Step};

/// What is done with the plan as a whole: a new one, writing it as TOML and as CSV.
const WHOLE: [PartsAction; 3] = [PartsAction::NewPlan, PartsAction::SavePlan(0), PartsAction::SavePlan(1)];

/// What is done with cells.
const CELLS: [PartsAction; 3] = [PartsAction::EditPlanCell, PartsAction::CopyPlanCells, PartsAction::PastePlanCells];

/// What is done with features.
const ROWS: [PartsAction; 6] = [
    PartsAction::InsertPlanRow,
    PartsAction::DeletePlanRows,
    PartsAction::MovePlanRows(Step::Up),
    PartsAction::MovePlanRows(Step::Down),
    PartsAction::SortPlan,
    PartsAction::RenumberPlan,
];

/// The same in one row: what is used less often is in a menu.
pub(in crate::gui::parts) fn folded_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        for action in
            [PartsAction::SavePlan(0), PartsAction::UndoPlan, PartsAction::RedoPlan, PartsAction::EditPlanCell]
        {
            view.field_button(ui, action);
        }
        ui.menu_button(view.text("parts-page-more"), |ui| {
            for action in [PartsAction::NewPlan, PartsAction::SavePlan(1)] {
                view.menu_item(ui, action);
            }
            ui.separator();
            for action in CELLS.into_iter().skip(1).chain(ROWS) {
                view.menu_item(ui, action);
            }
            view.checkbox(ui, PartsAction::ShowAllColumns);
        });
        unsaved_ui(ui, view);
    });
}

/// That the plan has changes that are in no file.
fn unsaved_ui(ui: &mut Ui, view: &View<'_>) {
    let document = &view.session.parts().document;
    if document.is_unsaved() {
        quiet(ui, view.words.say(&message!("parts-page-not-saved").text("name", document.name())));
    }
}

/// The buttons, and how many features there are.
pub(in crate::gui::parts) fn tools_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        for action in WHOLE {
            view.field_button(ui, action);
        }
        ui.separator();
        for action in [PartsAction::UndoPlan, PartsAction::RedoPlan].into_iter().chain(CELLS).chain(ROWS) {
            let response = view.field_button(ui, action);
            if response.clicked() && action == PartsAction::PastePlanCells {
                // What is on the clipboard comes to what has the focus.
                ui.memory_mut(|memory| memory.request_focus(super::grid_id()));
            }
        }
        // In one line, in the next row where there is no room.
        let name = PartsAction::ShowAllColumns.text(view.session, view.words);
        let name = ui.painter().layout_no_wrap(name, theme::font(sizes().body), palette(ui.ctx()).text.0).size().x;
        if ui.available_size_before_wrap().x < name + ui.spacing().icon_width + space(6.0) {
            ui.end_row();
        }
        view.checkbox(ui, PartsAction::ShowAllColumns);
        let count = view.session.parts().document.draft().rows.len();
        quiet(ui, view.words.say(&message!("parts-page-features").count("count", count)));
        unsaved_ui(ui, view);
    });
}
