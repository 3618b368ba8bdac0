//! An NC block, typed or pasted, that fills the form. Its size stays whatever is typed: long blocks and long faults scroll.

use eframe::egui::{Button, Id, Modal, ScrollArea, TextEdit, Ui, vec2};

use crate::gui::over_page::just_opened;
use crate::gui::spoken::dialog_headed;
use crate::gui::theme::{self, control, sizes, space};
use crate::gui::view::{View, heading, problem, quiet};
use crate::session::{CyclesAction, CyclesCommand};

/// How many lines of a block and of what is wrong with it are in sight.
const LINES: f32 = 12.0;
const FAULT_LINES: f32 = 3.0;

/// The dialog, where it is open.
pub(super) fn block_ui(ui: &Ui, view: &mut View<'_>) {
    let Some(text) = view.session.cycles().block.as_deref().map(str::to_owned) else { return };
    Modal::new(Id::unique("cycle-block")).show(ui, |ui| {
        let screen = ui.ctx().content_rect().size();
        ui.set_width(space(140.0).min(screen.x - space(12.0)));
        let head = heading(ui, view.text("cycles-block"));
        dialog_headed(ui, Id::unique("cycle-block"), &head);
        let name = quiet(ui, view.text("cycles-block-hint")).id;
        let fault = FAULT_LINES * (sizes().body + space(1.0));
        let room = screen.y - fault - control(ui) - space(40.0);
        let height = (LINES * (sizes().mono + space(1.0))).min(room).max(space(12.0));
        ScrollArea::vertical()
            .id_salt("cycle-block")
            .max_height(height)
            .min_scrolled_height(height)
            .auto_shrink(false)
            .show(ui, |ui| text_ui(ui, view, (text, height), name));
        let faults = ScrollArea::vertical().id_salt("cycle-block-fault").max_height(fault).min_scrolled_height(fault);
        faults.auto_shrink(false).show(ui, |ui| {
            if let Some(error) = view.session.cycles().block_problem.as_ref() {
                problem(ui, view.words.say(error));
            }
        });
        ui.horizontal(|ui| {
            let size = vec2(space(24.0), control(ui));
            view.sized_button(ui, CyclesAction::TakeBlock, size);
            if ui.add(Button::new(view.text("dialog-cancel")).min_size(size)).clicked() {
                view.send(CyclesCommand::ShowBlock(false));
            }
        });
    });
}

/// The field, at least as high as its room.
fn text_ui(ui: &mut Ui, view: &mut View<'_>, (mut text, height): (String, f32), name: Id) {
    let id = Id::unique("cycle-block-text");
    let edit = TextEdit::multiline(&mut text)
        .id(id)
        .font(theme::mono(sizes().mono))
        .desired_rows(1)
        .desired_width(f32::INFINITY)
        .min_size(vec2(0.0, height));
    let response = ui.add(edit).labelled_by(name);
    if just_opened(ui, id) {
        response.request_focus();
    }
    if response.changed() {
        view.send(CyclesCommand::TypeBlock(text));
    }
}
