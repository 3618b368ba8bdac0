//! The program page: an NC program is read, run, stepped and watched, next to Fitcheck's own answer.
//!
//! | file | what |
//! |---|---|
//! | `tool_bar` | above: which program; run, pause, single block, breakpoints, speed; what the run does |
//! | `listing` | middle: the lines in sight, and the keys that walk through them |
//! | `paint` | how a line looks |
//! | `form_panel` | left: the inputs of 8255, the workpiece, program and native answer side by side |
//! | `part_panel` | left: the features of a simulated part |
//! | `tools_panel` | left: the tool table and the tools of Q330; right: what a run has changed in it |
//! | `answer_panel` | right: windows, files, what was measured |
//! | `create_panel` | right: the files with which a control measures for itself |
//! | `watch_panel` | right, below: parameters |
//! | `path_panel` | below the listing: the path of the probe |
//! | `notes_panel` | below the listing, beside the path: errors, warnings and remarks, each a link to its block |

mod answer_panel;
mod create_panel;
mod form_panel;
mod listing;
mod notes_panel;
mod paint;
mod part_panel;
mod path_panel;
mod tool_bar;
mod tools_panel;
mod watch_panel;

use std::path::Path;
use std::time::Duration;

use eframe::egui::{CentralPanel, Frame, Id, Panel, Ui};

use super::card::close_card_ui;
use super::columns::{Side, area_ui, bar_ui, column_ui, of_height, panel_ui, rest_ui};
use super::cycles::workpiece_window;
use super::field;
use super::keypad::{self, keypad_ui};
use super::over_page::just_opened;
use super::theme::{Icon, space};
use super::view::{View, focus_soon, take_focus};
use crate::gui::page::{Group, PageView, ending, open};
use crate::session::program::Speed;
use crate::session::{Command, CycleFile, ProgramAction, ProgramCommand, ProgramField, Purpose};

pub(super) const PAGE: PageView = PageView {
    action: |_| ProgramAction::OpenProgram.into(),
    opened,
    dropped,
    ..PageView::of(Group::Control, Icon::FileCode, program_ui)
};

/// The program that runs.
fn opened(view: &View<'_>) -> Vec<String> {
    view.session.program().main().iter().map(|main| main.title().to_owned()).collect()
}

/// The page: left what goes in, middle the program, right what comes out.
fn program_ui(ui: &mut Ui, view: &mut View<'_>) {
    focus_first(ui, view);
    tick(ui, view);
    let size = ui.available_size();
    // Where the window is low, the path of the probe is below the inputs.
    let narrow = size.x < 1200.0;
    let low = size.y < 640.0;
    let is_one = size.x < space(225.0);
    bar_ui(ui, view, Side::Top, "program-tools", tool_bar::tool_bar_ui);
    let inputs = |ui: &mut Ui, view: &mut View<'_>| {
        form_panel::form_ui(ui, view, low || is_one);
        if low && path_panel::has_room(view) {
            ui.separator();
            path_panel::path_ui(ui, view);
        }
    };
    if is_one {
        // Beside the program everything else in one column, the verdict above it.
        let sizes = (size.x * 0.42, size.x * 0.3..=size.x * 0.7);
        area_ui(ui, view, Side::Left, "program-side", sizes, |ui, view| {
            answer_panel::verdict_ui(ui, view);
            rest_ui(ui, view, |ui, view| {
                keypad_ui(ui, view);
                column_ui(ui, "program-side", |ui| {
                    inputs(ui, view);
                    ui.separator();
                    answer_panel::answer_ui(ui, view);
                    ui.separator();
                    of_height(ui, space(80.0), |ui| watch_panel::watch_ui(ui, view));
                });
            });
        });
    } else {
        let least = space(56.0).max(keypad::width(view));
        let sizes = (space(86.0).max(least), least..=least.max(size.x * 0.4));
        panel_ui(ui, view, Side::Left, "program-inputs", sizes, |ui, view| {
            keypad_ui(ui, view);
            column_ui(ui, "program-inputs", |ui| inputs(ui, view));
        });
        let side = if narrow { space(78.0) } else { space(90.0) };
        let sizes = (side, space(66.0)..=(size.x * 0.4).max(space(66.0)));
        area_ui(ui, view, Side::Right, "program-answer", sizes, |ui, view| {
            answer_panel::verdict_ui(ui, view);
            let has_card = create_panel::CARD <= size.y;
            if has_card {
                bar_ui(ui, view, Side::Bottom, "program-create", create_panel::card_ui);
            }
            // The parameters keep a share of the height whatever is above them, before and after a result.
            let height = ui.available_height();
            let rows = if low { 0.0 } else { watch_panel::usual_height(ui).min(height * 0.6) };
            let usual = (size.y * 0.26).max(space(44.0)).max(rows);
            let sizes = (usual, space(32.0)..=(height * 0.8).max(space(44.0)));
            panel_ui(ui, view, Side::Bottom, "program-watch", sizes, watch_panel::watch_ui);
            // On the parameters, so that it stays where it is whatever a run finds.
            if !has_card && !low {
                let below = Panel::bottom("program-create").resizable(false).show_separator_line(false);
                let below = below.frame(Frame::new().inner_margin(Side::Bottom.gap()));
                below.show(ui, |ui| create_panel::button_ui(ui, view));
            }
            rest_ui(ui, view, |ui, view| {
                column_ui(ui, "program-answers", |ui| answer_panel::answer_ui(ui, view));
            });
        });
    }
    CentralPanel::default().frame(Frame::NONE).show(ui, |ui| listed_ui(ui, view, low));
    workpiece_window::workpiece_ui(ui, view);
}

/// The program, and below it the path and the notes; where the window is low, the notes alone.
fn listed_ui(ui: &mut Ui, view: &mut View<'_>, low: bool) {
    if !low && path_panel::has_room(view) {
        // Of one height whatever a run finds: notes stand beside the path, and the listing does not move.
        let height = (ui.available_height() * 0.36).max(notes_panel::least(ui));
        let below = Panel::bottom("program-path").exact_size(height).show_separator_line(false);
        below.frame(Frame::new().inner_margin(Side::Bottom.gap())).show(ui, |ui| {
            if 0 < view.session.program().note_count() {
                let half = ui.available_width() * 0.5;
                let notes = Panel::left("program-notes").exact_size(half).show_separator_line(false);
                let notes = notes.frame(Frame::new().inner_margin(Side::Left.gap()));
                notes.show(ui, |ui| close_card_ui(ui, |ui| notes_panel::notes_ui(ui, view)));
            }
            let rest = CentralPanel::default().frame(Frame::NONE);
            rest.show(ui, |ui| close_card_ui(ui, |ui| path_panel::path_ui(ui, view)));
        });
    } else if let Some(height) = notes_panel::height(ui, view) {
        let notes = Panel::bottom("program-notes-below").exact_size(height).show_separator_line(false);
        let notes = notes.frame(Frame::new().inner_margin(Side::Bottom.gap()));
        notes.show(ui, |ui| close_card_ui(ui, |ui| notes_panel::notes_ui(ui, view)));
    }
    let rest = CentralPanel::default().frame(Frame::NONE);
    rest.show(ui, |ui| close_card_ui(ui, |ui| listing::listing_ui(ui, view)));
}

/// The page opens ready for typing, or for walking through the program where it has no inputs.
fn focus_first(ui: &Ui, view: &View<'_>) {
    if just_opened(ui, Id::unique("program-page")) {
        let input = view.session.program().inputs().next();
        let first = input.map_or_else(listing::id, |input| field::id(ProgramField::Input(input)));
        ui.memory_mut(|memory| memory.request_focus(first));
    }
    // Who opens a program reads it: arrows, breakpoints and single blocks are at hand. The dialog is still there in this frame.
    take_focus(ui, listing::id());
    let opened = view.session.program().opened_count();
    let key = Id::unique("program-opened");
    if ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(key), opened)) != opened {
        focus_soon(ui, listing::id());
    }
}

/// Asks for the next slice when it is due; without a run that goes on, nothing is repainted.
fn tick(ui: &Ui, view: &mut View<'_>) {
    let program = view.session.program();
    if !program.is_running() {
        return;
    }
    let id = Id::unique("program-tick");
    let now = ui.input(|input| input.time);
    let interval = program.speed.interval();
    let last = ui.data(|data| data.get_temp::<f64>(id)).unwrap_or(f64::NEG_INFINITY);
    // A clock that was set back does not stop the run.
    let waited = (now - last).abs();
    if program.speed == Speed::Fast || interval <= waited {
        ui.data_mut(|data| data.insert_temp(id, now));
        view.send(ProgramCommand::Tick);
        ui.request_repaint_after(Duration::from_secs_f64(interval));
    } else {
        ui.request_repaint_after(Duration::from_secs_f64((interval - waited).clamp(0.0, 1.0)));
    }
}

/// A tool table, a workpiece, contacts or a program, by its ending.
fn dropped(_view: &View<'_>, path: &Path, _number: usize) -> Command {
    let purpose = match ending(path).as_str() {
        "t" => Purpose::OpenTools,
        "toml" => Purpose::OpenCycleFile(CycleFile::Workpiece),
        "csv" => Purpose::OpenCycleFile(CycleFile::Contacts),
        _ => Purpose::OpenProgram,
    };
    open(purpose, path)
}
