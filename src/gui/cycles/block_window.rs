//! An NC block, typed or pasted, that fills the form.

use eframe::egui::{Align2, Button, Id, TextEdit, Ui, Vec2, vec2};

use crate::gui::over_page::{fixed_window, just_opened};
use crate::gui::theme::{self, control, sizes, space};
use crate::gui::view::{View, problem, quiet};
use crate::session::CyclesAction;
use crate::session::CyclesCommand;

/// The window, where it is open.
pub(super) fn block_ui(ui: &Ui, view: &mut View<'_>) {
    let Some(mut text) = view.session.cycles().block.as_deref().map(str::to_owned) else { return };
    fixed_window("cycle-block", view.text("cycles-block"), Align2::CENTER_CENTER, Vec2::ZERO).show(ui, |ui| {
        ui.set_width(space(140.0));
        let name = quiet(ui, view.text("cycles-block-hint"));
        let id = Id::unique("cycle-block-text");
        let edit = TextEdit::multiline(&mut text)
            .id(id)
            .font(theme::mono(sizes().mono))
            .desired_rows(12)
            .desired_width(f32::INFINITY);
        let response = ui.add(edit).labelled_by(name.id);
        if just_opened(ui, id) {
            response.request_focus();
        }
        if response.changed() {
            view.send(CyclesCommand::TypeBlock(text.clone()));
        }
        if let Some(error) = view.session.cycles().block_problem.as_ref() {
            problem(ui, view.words.say(error));
        }
        ui.horizontal(|ui| {
            let size = vec2(space(24.0), control(ui));
            view.sized_button(ui, CyclesAction::TakeBlock, size);
            if ui.add(Button::new(view.text("dialog-cancel")).min_size(size)).clicked() {
                view.send(CyclesCommand::ShowBlock(false));
            }
        });
    });
}
