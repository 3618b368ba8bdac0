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

use crate::gui::page::{Group, PageView, cycle_file, ending, open};
use crate::session::{Action, Command, CycleField, CyclesCommand, Purpose};
use eframe::egui::{Id, Ui};
use std::path::Path;

use super::columns::{Page, columns_ui};
use super::field;
use super::over_page::just_opened;
use super::theme::{Icon, space};
use super::verdict_card::least_width;
use super::view::{View, remembered};

pub(super) const PAGE: PageView = PageView { opened, dropped, ..PageView::of(Group::Control, Icon::Target, cycles_ui) };

/// The part that is probed.
fn opened(view: &View<'_>) -> Vec<String> {
    view.session.part().iter().map(|part| part.name.clone()).collect()
}

/// The page: left what is asked, middle what is seen, right the answer.
fn cycles_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("cycles-page"))
        && let Some(first) = view.session.cycles().first_needed()
    {
        ui.memory_mut(|memory| memory.request_focus(field::id(CycleField::Parameter(first.key))));
    }
    let page = Page {
        name: "cycles",
        left: space(94.0),
        right: space(75.5),
        three: space(240.0),
        head: Some(form_panel::head_ui),
        asked: form_panel::form_ui,
        seen: seen_panel::seen_ui,
        seen_height: space(180.0),
        verdict: |ui, view| answer_panel::verdict_ui(ui, view),
        least: least_width(ui, view),
        answer: answer_panel::answer_ui,
    };
    columns_ui(ui, view, &page);
    workpiece_window::workpiece_ui(ui, view);
    block_window::block_ui(ui, view);
    // After an attempt, a run that cannot begin leads to the field that is wrong.
    let is_run = |command: &Command| matches!(command, Command::Cycles(CyclesCommand::Run) | Command::Enter(_));
    let has_run = view.commands.iter().any(is_run);
    ui.data_mut(|data| data.insert_temp(asked_id(), has_run));
}

fn asked_id() -> Id {
    Id::unique("cycle-run-asked")
}

/// The field that gets the focus because the requested run cannot begin with it: the last focused one if it is wrong,
/// else the first wrong one.
fn wrong_field(ui: &Ui, view: &View<'_>) -> Option<CycleField> {
    if !remembered::<bool>(ui, asked_id()) {
        return None;
    }
    let page = view.session.cycles();
    let last = form_panel::last_focused(ui).map(CycleField::Parameter);
    last.filter(|field| view.session.error(*field).is_some()).or_else(|| page.first_wrong())
}

/// A button that opens a dialog; it gets the focus back when the dialog is closed.
fn opener_ui(ui: &mut Ui, view: &mut View<'_>, action: impl Into<Action>, is_open: bool) {
    let button = view.button(ui, action);
    let was_open = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(button.id.with("open")), is_open));
    if was_open && !is_open {
        button.request_focus();
    }
}

/// A tool table, a probe table, a workpiece or contacts, by its ending.
fn dropped(_view: &View<'_>, path: &Path, _number: usize) -> Command {
    let is_tools = ending(path) == "t";
    open(if is_tools { Purpose::OpenTools } else { Purpose::OpenCycleFile(cycle_file(path)) }, path)
}
