//! The dialog of the simulated workpiece: surface, probe, scatter, temperature, all from one seed and one file.

use eframe::egui::{Align2, Button, Id, ScrollArea, Ui, Vec2, vec2};

use super::parameter_row::figure_ui;
use crate::gui::columns::follow_focus;
use crate::gui::over_page::{fixed_window, just_opened};
use crate::gui::theme::{control, space};
use crate::gui::view::{View, heading, quiet};
use crate::probing::cycle::Plane;
use crate::probing::simulated::Shape;
use crate::session::{WorkpieceAction, WorkpieceCommand, WorkpieceField, shape_id};

/// The window, where it is open. What is typed counts at once.
pub(in crate::gui) fn workpiece_ui(ui: &Ui, view: &mut View<'_>) {
    if !view.session.workpiece_is_open() {
        return;
    }
    let size = ui.ctx().content_rect().size();
    let window =
        fixed_window("workpiece", view.text("simulated-workpiece"), Align2::CENTER_CENTER, Vec2::ZERO).show(ui, |ui| {
            ui.set_width((size.x * 0.9).min(space(200.0)));
            ScrollArea::vertical().max_height(size.y - space(50.0)).show(ui, |ui| {
                content_ui(ui, view);
                follow_focus(ui);
            });
            ui.separator();
            buttons_ui(ui, view);
        });
    // A window takes the size of its content one frame later.
    let rect = window.map(|window| window.response.rect);
    let last = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(Id::unique("workpiece-size")), rect));
    if last != rect {
        ui.ctx().request_repaint();
    }
}

fn content_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let shape = view.session.workpiece().shape;
    let is_new = just_opened(ui, Id::unique("workpiece-shape"));
    ui.horizontal_wrapped(|ui| {
        for choice in Shape::ALL {
            let radio = ui.radio(shape == choice, view.text(shape_id(choice)));
            if is_new && shape == choice {
                radio.request_focus();
            }
            if radio.clicked() {
                view.send(WorkpieceCommand::ChooseShape(choice));
            }
        }
    });
    if shape.is_round() {
        plane_ui(ui, view);
    }
    ui.columns(2, |columns| {
        if let [left, right] = columns {
            left.spacing_mut().item_spacing.y = space(1.0);
            right.spacing_mut().item_spacing.y = space(1.0);
            heading(left, view.text(shape_id(shape)));
            fields_ui(left, view, &WorkpieceField::of(shape));
            heading(right, view.text("workpiece-probe"));
            fields_ui(right, view, WorkpieceField::of_probe());
            heading(right, view.text("workpiece-machine"));
            fields_ui(right, view, WorkpieceField::of_machine());
        }
    });
}

fn plane_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        quiet(ui, view.text("cycles-plane"));
        let chosen = view.session.workpiece().plane;
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            if ui.radio(chosen == plane, plane.axes().join("/")).clicked() {
                view.send(WorkpieceCommand::ChoosePlane(plane));
            }
        }
    });
}

fn fields_ui(ui: &mut Ui, view: &mut View<'_>, fields: &[WorkpieceField]) {
    for field in fields {
        figure_ui(ui, view, *field, view.text(field.name_id()), field.unit());
    }
}

fn buttons_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let size = vec2(space(20.0), control(ui));
        for action in [WorkpieceAction::SuitWorkpiece, WorkpieceAction::OpenWorkpiece, WorkpieceAction::SaveWorkpiece] {
            view.sized_button(ui, action, size);
        }
        if ui.add(Button::new(view.text("close")).min_size(size)).clicked() {
            view.send(WorkpieceCommand::Show(false));
        }
    });
}
