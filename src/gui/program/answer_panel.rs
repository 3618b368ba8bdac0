//! Right: the windows that the program opens, files that it would write, what was measured.

use eframe::egui::{Button, CollapsingHeader, Label, Margin, RichText, Sense, Ui, vec2};

use super::tools_panel::changes_ui;
use crate::gui::card::{self, MARGIN};
use crate::gui::check::recorded_ui;
use crate::gui::popup;
use crate::gui::section::folded_ui;
use crate::gui::shapes::{self, Edge};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::verdict_card::{colours, status_id};
use crate::gui::view::{View, by_limits_ui, heading, marked_ui, quiet};
use crate::message::{Message, message};
use crate::nc::machine::{CycleRun, Window};
use crate::probing::cycle::Value;
use crate::session::ProgramCommand;
use crate::session::program::{Agreement, Run};
use crate::verdict::Status;
use crate::words::Words;

/// The most windows and cycles that are drawn; the last ones count.
const MOST: usize = 20;

/// Below the verdict: windows, what was measured, files.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(run) = view.session.program().run.as_ref() else {
        quiet(ui, view.text("program-page-no-windows"));
        return;
    };
    let open: Vec<_> = run.windows().iter().filter(|window| window.is_open).collect();
    if open.is_empty() {
        quiet(ui, view.text("program-page-no-windows"));
    }
    for (number, window) in open.iter().enumerate().rev().take(MOST) {
        window_ui(ui, view, window, number);
    }
    cycles_ui(ui, view, run);
    by_limits_ui(ui, view);
    changes_ui(ui, view, run);
    outputs_ui(ui, view, run);
    if let Some(passed_over) = run.passed_over() {
        ui.add_space(space(1.0));
        quiet(ui, view.words.say(&passed_over));
    }
}

/// The verdict in one line, so that the program's own window stays in sight.
pub(super) fn verdict_ui(ui: &mut Ui, view: &mut View<'_>) {
    let run = view.session.program().run.as_ref();
    let status = run.and_then(Run::status);
    let measured = run.and_then(|run| run.cycles().last()).and_then(|cycle| main_value(view.words, cycle));
    // What was measured without limits is a result, and no verdict.
    let word = match status {
        None if measured.is_some() => view.text("program-page-no-verdict"),
        status => view.text(status_id(status)),
    };
    let is_simulated = run.is_some() && view.session.program().is_simulated();
    let contested = status.and_then(|status| contested(view, status));
    // A verdict that does not stand has no colour of one.
    let coloured = status.filter(|_| contested.is_none());
    let (fill, colour) = colours(palette(ui.ctx()), coloured, Edge::of_simulated(is_simulated));
    let simulated = (is_simulated && status.is_some()).then(|| view.text("simulated"));
    let size = if coloured.is_some() { sizes().status * 0.5 } else { sizes().figure };
    let word = contested.unwrap_or(word);
    let edge = Edge::of_simulated(simulated.is_some());
    card::verdict_ui(ui, (fill, colour), edge, Margin::symmetric(MARGIN, 8), |ui| {
        // As high before the run as after it: nothing below moves.
        let line = |size: f32| ui.fonts_mut(|fonts| fonts.row_height(&theme::bold(size)));
        let above = if view.session.program().is_simulated() { line(sizes().limits) + space(1.0) } else { 0.0 };
        ui.set_min_height(above + line(sizes().status * 0.5).max(space(9.0)));
        ui.spacing_mut().item_spacing.y = space(1.0);
        if let Some(simulated) = &simulated {
            ui.label(RichText::new(simulated).font(theme::bold(sizes().limits)).color(colour));
        }
        ui.horizontal_wrapped(|ui| {
            let (rect, _) = ui.allocate_exact_size(vec2(space(9.0), space(9.0)), Sense::hover());
            shapes::status(ui.painter(), rect, coloured, colour);
            ui.label(RichText::new(&word).font(theme::bold(size)).color(colour));
            if let Some(measured) = &measured {
                ui.label(RichText::new(measured).font(theme::bold(sizes().limits)).color(colour));
            }
        });
        simulated.into_iter().chain([word]).chain(measured).collect()
    });
    let slip = view.session.program().run.as_ref().and_then(|run| run.record);
    recorded_ui(ui, view, slip.and_then(|slip| view.session.recording().of_slip(slip)));
}

/// Why a program's verdict does not stand: Fitcheck's is another one, or the program did not come to its end.
fn contested(view: &View<'_>, status: Status) -> Option<String> {
    let program = view.session.program();
    let said = |id: &'static str| Message::new(id).text("program", view.words.told(&status));
    let own = program.verdict(view.session.sources()).map(|(_, verdict)| verdict.status);
    let message = match (own, program.agreement(view.session.sources())) {
        _ if program.run.as_ref().is_some_and(|run| run.fault.is_some()) => said("program-page-stopped-at"),
        (Some(own), _) if own != status => said("program-page-contested").text("own", view.words.told(&own)),
        (_, Some(Agreement::Differs(_))) => said("program-page-contested-limits"),
        _ => return None,
    };
    Some(view.words.say(&message))
}

/// The diameter that a cycle measured, or else what it compared first, or its first result.
fn main_value(words: &Words, run: &CycleRun) -> Option<String> {
    let result = &run.result;
    let compared = || result.checks.first().map(|check| check.measured);
    let length = result.circle.as_ref().map(|circle| circle.diameter).or_else(compared).or_else(|| {
        result.results.iter().find_map(|found| match found.value {
            Value::Length(length) => Some(length),
            _ => None,
        })
    })?;
    Some(format!("{} mm", words.number(&length.rounded(crate::length::Unit::Millimetre, 4))))
}

/// A window of FN 16, as the control shows it; a block in a loop opens several.
fn window_ui(ui: &mut Ui, view: &View<'_>, window: &Window, number: usize) {
    let id =
        if view.session.program().is_simulated() { "program-page-window-simulated" } else { "program-page-window" };
    // PRINT of a lathe control has no mask: its program shows the text.
    let from = if window.mask == window.place.program { "PRINT" } else { "FN 16" };
    let title = Message::new(id).text("from", from).text("mask", window.mask.file_name());
    let salt = (&window.place.program, window.place.block, number);
    popup::frame_ui(ui, view.words.say(&title), |ui| popup::text_ui(ui, &window.text, salt));
}

/// What was measured, one per line: shape, word, cycle, value; a click shows the block.
fn cycles_ui(ui: &mut Ui, view: &mut View<'_>, run: &Run) {
    let cycles = run.cycles();
    if cycles.is_empty() {
        return;
    }
    ui.add_space(space(1.0));
    heading(ui, view.text("program-page-cycles"));
    if MOST < cycles.len() {
        let message = message!("program-page-last-of").count("shown", MOST).count("all", cycles.len());
        quiet(ui, view.words.say(&message));
    }
    for cycle in cycles.iter().rev().take(MOST).rev() {
        let status = cycle.result.verdict();
        let word = if status.is_some() { status_id(status) } else { "program-page-no-verdict" };
        let mut text = format!("{}  {}  ", cycle.cycle.code, view.text(word));
        if let Some(value) = main_value(view.words, cycle) {
            text.push_str(&value);
        }
        let line = marked_ui(ui, (status, palette(ui.ctx()).text.0), Button::new(text));
        if line.on_hover_text(view.text("program-page-show-block")).clicked() {
            view.send(ProgramCommand::GoTo(cycle.place.clone()));
        }
    }
}

/// What would have been written, file by file; nothing is written.
fn outputs_ui(ui: &mut Ui, view: &View<'_>, run: &Run) {
    let outputs = run.outputs();
    if outputs.is_empty() {
        return;
    }
    ui.add_space(space(1.0));
    heading(ui, view.text("program-page-outputs"));
    quiet(ui, view.text("program-page-outputs-hint"));
    for (number, output) in outputs.iter().enumerate().rev().take(MOST) {
        let title = output.path.to_string();
        folded_ui(ui, CollapsingHeader::new(title).id_salt(("output", number)), |ui| {
            let text = RichText::new(output.text.trim_end()).font(theme::mono(sizes().small));
            // A log is wider than the column, and its figures stand at the right: they go to the next line, and are never out of sight.
            ui.add(Label::new(text).wrap().selectable(true));
        });
    }
}
