//! Above: which program; run, pause, single block, breakpoints, speed; what the run does, in words.

use eframe::egui::accesskit::Live;
use eframe::egui::{Align, Button, Layout, RichText, ScrollArea, Sense, Ui, vec2};

use super::paint;
use crate::gui::spoken::live;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, list_height, list_ui, one_of_ui};
use crate::nc::machine::Shipped;
use crate::session::program::{EntryKind, Origin, Speed, State, Switch};
use crate::session::{FilesCommand, ProgramAction, ProgramCommand, Purpose};
use crate::text::Within as _;

/// The width of the list of programs.
const CHOICE: f32 = 44.0;

/// The width of the list of places to go to.
const OUTLINE: f32 = 78.0;

/// The width of the list of speeds.
const LIST: f32 = 40.0;

/// From this width what the run does stands beside the choices.
const WIDE: f32 = 260.0;

/// Two rows, three in a narrow window: what can be done with the program, and where the run is.
pub(super) fn tool_bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = space(1.5);
        choice_ui(ui, view);
        ui.separator();
        run_ui(ui, view);
    });
    // What changes in length comes last, and in a row of its own where it would soon be cut.
    let is_wide = space(WIDE) < ui.available_width();
    let choices_ui = |ui: &mut Ui, view: &mut View<'_>| {
        outline_ui(ui, view);
        of_width(ui, LIST, |ui| speed_ui(ui, view));
        options_ui(ui, view);
    };
    if is_wide {
        ui.horizontal(|ui| {
            choices_ui(ui, view);
            ui.separator();
            progress_ui(ui, view);
        });
    } else {
        ui.horizontal_wrapped(|ui| choices_ui(ui, view));
    }
    if !is_wide {
        progress_ui(ui, view);
    }
    ui.add_space(space(1.0));
}

/// A list that keeps its width whatever it shows.
fn of_width<R>(ui: &mut Ui, steps: f32, content: impl FnOnce(&mut Ui) -> R) -> R {
    let size = vec2(space(steps), control(ui));
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_width(size.x);
        content(ui)
    })
    .inner
}

/// What the run does and which programs called one another, in one line that scrolls: nothing below it moves.
fn progress_ui(ui: &mut Ui, view: &mut View<'_>) {
    ScrollArea::horizontal().id_salt("program-progress").auto_shrink([false, true]).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.set_min_height(control(ui));
            state_ui(ui, view);
            calls_ui(ui, view);
        });
    });
}

fn choice_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = view.text("program-page-choice");
    // Where no program is open, none is chosen.
    let shown = view.session.program().main().map_or("", |document| document.title());
    let list = |ui: &mut Ui| {
        let entries = |ui: &mut Ui| programs_ui(ui, view);
        list_ui(ui, "program-choice", shown, space(CHOICE), entries)
    };
    let list = of_width(ui, CHOICE, list).accessible_name(name);
    // A long name is cut.
    if !shown.is_empty() {
        list.on_hover_text(shown);
    }
}

/// The programs that can be opened: built-in ones, and those that were opened before.
fn programs_ui(ui: &mut Ui, view: &mut View<'_>) {
    for (language, file) in Shipped::main_programs() {
        let chosen = view.session.program().origin.as_ref() == Some(&Origin::Shipped(file));
        let text = format!("{file}, {}", language.name());
        if ui.selectable_label(chosen, text).clicked() {
            view.send(ProgramCommand::OpenShipped(file));
        }
    }
    for (number, path) in view.session.recent_of(Purpose::OpenProgram) {
        let is_open = matches!(view.session.program().origin.as_ref(), Some(Origin::File(open)) if open == path);
        if ui.selectable_label(is_open, path.display().to_string()).clicked() {
            // It may have changed.
            view.send(FilesCommand::OpenRecent(number));
        }
    }
}

fn run_ui(ui: &mut Ui, view: &mut View<'_>) {
    let run = ProgramAction::RunProgram;
    let pause = ProgramAction::PauseProgram;
    let width = view.width_of(ui, &[run, pause]).max(space(20.0));
    let action = if view.session.program().is_running() { pause } else { run };
    view.main_button(ui, action, vec2(width, control(ui)));
    for action in [
        ProgramAction::StepProgram,
        ProgramAction::StepOver,
        ProgramAction::RunToSelected,
        ProgramAction::ToggleBreakpoint,
        ProgramAction::ResetProgram,
    ] {
        view.field_button(ui, action);
    }
}

const fn speed_id(speed: Speed) -> &'static str {
    match speed {
        Speed::Slow => "program-page-speed-slow",
        Speed::Medium => "program-page-speed-medium",
        Speed::Fast => "program-page-speed-fast",
    }
}

fn speed_ui(ui: &mut Ui, view: &mut View<'_>) {
    let speed = view.session.program().speed;
    let name = view.text("program-page-speed");
    let all = Speed::ALL.map(|speed| (speed, view.text(speed_id(speed))));
    let (chosen, list) = one_of_ui(ui, "program-speed", space(LIST), &speed, all);
    list.accessible_name(name);
    if let Some(speed) = chosen {
        view.send(ProgramCommand::SetSpeed(speed));
    }
}

fn options_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.menu_button(view.text("program-page-options"), |ui| {
        for switch in Switch::ALL {
            view.checkbox(ui, ProgramAction::Switch(switch));
        }
    });
}

/// What the run does and why it waits: a live region.
fn state_ui(ui: &mut Ui, view: &View<'_>) {
    let program = view.session.program();
    let (mark, _) = ui.allocate_exact_size(vec2(space(5.0), space(5.0)), Sense::hover());
    paint::state(ui.painter(), mark, program.run.as_ref().map(|run| run.state), palette(ui.ctx()));
    let said = view.words.say(&program.state_message());
    let label = ui.label(RichText::new(&said).font(theme::bold(sizes().body)));
    live(ui, &label, &said, Live::Polite);
}

/// The programs that called one another; each can be shown.
fn calls_ui(ui: &mut Ui, view: &mut View<'_>) {
    let program = view.session.program();
    let Some(run) = program.run.as_ref().filter(|run| run.state != State::Ended) else { return };
    let programs = run.programs();
    if programs.len() < 2 && program.shown().map(|document| &document.path) == programs.first() {
        return;
    }
    ui.separator();
    for (number, path) in programs.into_iter().enumerate() {
        if 0 < number {
            ui.label("→");
        }
        let shown = program.shown().is_some_and(|document| document.path == path);
        if ui.add(Button::selectable(shown, path.file_name())).clicked() {
            view.send(ProgramCommand::ShowProgram(path));
        }
    }
}

/// Structure blocks and labels: the list jumps to them.
fn outline_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(document) = view.session.program().shown() else { return };
    let outline = &document.outline;
    if outline.is_empty() {
        return;
    }
    let name = ui.label(view.text("program-page-outline"));
    let under = document.under(document.selected);
    let text = under.and_then(|number| outline.get(number)).map(|entry| entry.text.clone());
    let text = text.unwrap_or_else(|| view.text("program-page-outline-none"));
    let height = list_height(ui);
    let list = of_width(ui, OUTLINE, |ui| {
        list_ui(ui, "program-outline", text, space(OUTLINE), |ui| {
            ui.set_min_width(space(70.0));
            // Only the entries in sight: there may be thousands.
            let area = ScrollArea::vertical().max_height(height).id_salt("outline");
            area.show_rows(ui, control(ui), outline.len(), |ui, rows| {
                for (number, entry) in rows.clone().zip(outline.within(rows)) {
                    let depth = entry.depth.saturating_sub(1) + usize::from(entry.kind == EntryKind::Label);
                    let text = format!("{}{}", "    ".repeat(depth.min(8)), entry.text);
                    let button = Button::selectable(under == Some(number), text).truncate();
                    if ui.add(button.min_size(vec2(0.0, control(ui)))).clicked() {
                        let program = document.path.clone();
                        let place = crate::nc::machine::BlockPlace { program, block: entry.block };
                        view.send(ProgramCommand::GoTo(place));
                        ui.close();
                    }
                }
            });
        })
    });
    list.labelled_by(name.id);
}
