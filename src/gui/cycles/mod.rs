//! The cycles page: a measuring cycle on a simulated workpiece, or on recorded contacts.
//!
//! | file | what |
//! |---|---|
//! | `form_panel` | left: the cycle, where contacts come from, its parameters |
//! | `parameter_row` | one parameter: question, field or choice, unit, error |
//! | `workpiece_window` | the dialog of the simulated workpiece |
//! | `block_window` | an NC block typed or pasted |
//! | `seen_panel` | middle: the parameter in focus, the path step by step, contacts, criteria |
//! | `answer_panel` | right: verdict, status window, result parameters |
//! | `picture` | the drawings |

mod answer_panel;
mod block_window;
mod form_panel;
mod parameter_row;
pub(super) mod picture;
mod seen_panel;
pub(super) mod workpiece_window;

use eframe::egui::{CentralPanel, Id, Key, Memory, Panel, Response, ScrollArea, Ui};

use super::dialogs::just_opened;
use super::field;
use super::theme::space;
use super::view::View;
use crate::session::{Action, Command, CycleField, CyclesCommand};

/// The page: left what is asked, middle what is seen, right the answer.
pub(super) fn cycles_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("cycles-page"))
        && let Some(first) = view.session.cycles().cycle().parameters.first()
    {
        ui.memory_mut(|memory| memory.request_focus(field::id(CycleField::Parameter(first.key))));
    }
    let size = ui.available_size();
    let narrow = size.x < 1200.0;
    let side = if narrow { space(80.0) } else { space(94.0) };
    Panel::left("cycles-form").exact_size(side).show(ui, |ui| form_panel::form_ui(ui, view));
    let side = if narrow { space(74.0) } else { space(82.0).max(size.x * 0.25) };
    Panel::right("cycles-answer").exact_size(side).show(ui, |ui| {
        column_ui(ui, |ui| answer_panel::answer_ui(ui, view));
    });
    CentralPanel::default().show(ui, |ui| seen_panel::seen_ui(ui, view));
    workpiece_window::workpiece_ui(ui, view);
    block_window::block_ui(ui, view);
    // After an attempt, a run that cannot begin leads to the field that is wrong.
    let is_run = |command: &Command| matches!(command, Command::Cycles(CyclesCommand::Run));
    let has_run = view.commands.iter().any(is_run);
    ui.data_mut(|data| data.insert_temp(asked_id(), has_run));
}

fn asked_id() -> Id {
    Id::unique("cycle-run-asked")
}

/// The field that gets the focus because the requested run cannot begin with it: the last focused one if it is wrong,
/// else the first wrong one.
fn wrong_field(ui: &Ui, view: &View<'_>) -> Option<CycleField> {
    let has_run = ui.data(|data| data.get_temp(asked_id()).unwrap_or(false));
    if !has_run {
        return None;
    }
    let page = view.session.cycles();
    let last = form_panel::last_focused(ui).map(CycleField::Parameter);
    last.filter(|field| page.error(*field).is_some()).or_else(|| page.first_wrong())
}

/// A column that scrolls where the window is low; the floating bar never covers its content.
fn column_ui(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.set_max_width(ui.available_width() - space(2.5));
        ui.spacing_mut().item_spacing.y = space(1.0);
        content(ui);
        follow_focus(ui);
    });
}

/// Scrolls to the widget that has just got the focus, if it was just drawn here.
fn follow_focus(ui: &Ui) {
    let focused = ui.memory(Memory::focused);
    let last =
        ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(ui.unique_id().with("focused")), focused));
    let Some(rect) = focused.filter(|_| focused != last).and_then(|id| ui.ctx().read_response(id)) else { return };
    if rect.layer_id == ui.layer_id() && ui.min_rect().contains(rect.rect.center()) {
        ui.scroll_to_rect(rect.rect, None);
    }
}

/// Keeps the focus on a list after a choice by key; after a choice by pointer, Enter runs the cycle as before.
fn keep_focus(ui: &Ui, list: &Response) {
    if ui.input(|input| input.key_pressed(Key::Space) || input.key_pressed(Key::Enter)) {
        list.request_focus();
    }
}

/// A button that opens a dialog; it gets the focus back when the dialog is closed.
fn opener_ui(ui: &mut Ui, view: &mut View<'_>, action: Action, is_open: bool) {
    let button = view.button(ui, action);
    let was_open = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(button.id.with("open")), is_open));
    if was_open && !is_open {
        button.request_focus();
    }
}
