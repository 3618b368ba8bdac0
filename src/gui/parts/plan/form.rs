//! What the plan says of the part as a whole.

use eframe::egui::{Align, Color32, Layout, RichText, Ui, vec2};

use super::head_id;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, quiet};
use crate::part::HeadField;
use crate::session::parts::{PlanCommand, PlanField};
use crate::session::{PartsAction, PartsCommand};

/// The width of a field: its hint is whole.
fn width(ui: &Ui, view: &View<'_>, field: HeadField) -> f32 {
    let hint = hint(field).map_or(0.0, |id| {
        let font = theme::font(sizes().body);
        ui.painter().layout_no_wrap(view.text(id), font, Color32::PLACEHOLDER).size().x + space(6.5)
    });
    space(steps(field)).max(hint)
}

/// Its usual width, steps of space.
const fn steps(field: HeadField) -> f32 {
    match field {
        HeadField::Part | HeadField::Drawing | HeadField::Picture => 27.0,
        HeadField::Material | HeadField::Rule => 21.0,
        HeadField::Uncertainty => 12.0,
        HeadField::TravelX | HeadField::TravelY | HeadField::TravelZ => 20.0,
        HeadField::Remark => 30.0,
    }
}

/// What an empty field says.
const fn hint(field: HeadField) -> Option<&'static str> {
    match field {
        HeadField::Picture => Some("parts-page-head-file"),
        HeadField::TravelX | HeadField::TravelY | HeadField::TravelZ => Some("parts-page-head-two"),
        _ => None,
    }
}

/// Every field with its name above it, as many as there is room for beside each other; what is wrong with them below.
pub(in crate::gui::parts) fn form_ui(ui: &mut Ui, view: &mut View<'_>) {
    // The names stand in one line, as high as each of them is.
    let line = Layout::left_to_right(Align::Min).with_main_wrap(true);
    let row = vec2(ui.available_width(), control(ui) + space(5.0));
    ui.allocate_ui_with_layout(row, line, |ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        for field in HeadField::ALL {
            let size = width(ui, view, field);
            ui.allocate_ui(vec2(size, row.y), |ui| {
                ui.vertical(|ui| {
                    ui.spacing_mut().item_spacing.y = 0.0;
                    one_ui(ui, view, field, size);
                });
            });
        }
    });
    for field in HeadField::ALL {
        error_ui(ui, view, PlanField::Head(field));
    }
}

fn one_ui(ui: &mut Ui, view: &mut View<'_>, field: HeadField, size: f32) {
    let name = quiet(ui, view.text(&head_id(field)));
    let hint = hint(field).map_or_else(RichText::default, |id| RichText::new(view.text(id)));
    let hint = hint.color(palette(ui.ctx()).quiet.0);
    ui.horizontal(|ui| {
        let chooses = field == HeadField::Picture;
        let look = FieldStyle { font: theme::font(sizes().body), hint, ..FieldStyle::large(size) };
        let response = field_ui(ui, view, PlanField::Head(field), name.id, look);
        if response.lost_focus() {
            view.send(PartsCommand::Plan(PlanCommand::SettleHead));
        }
        if chooses {
            view.field_button(ui, PartsAction::ChoosePicture);
        }
    });
}
