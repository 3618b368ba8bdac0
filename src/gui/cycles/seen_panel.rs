//! Middle: the parameter in focus, the path step by step, contacts with their deviations, criteria side by side.

use eframe::egui::{Label, Slider, Ui, vec2};

use super::form_panel::last_focused;
use super::parameter_row::standing_text;
use super::picture::{self, Surroundings};
use crate::gui::columns::{column_ui, of_height};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::length::without_zeros;
use crate::message::Message;
use crate::probing::cycle::{Move, Parameter, Phase};
use crate::session::{CycleRun, CyclesAction, CyclesCommand, Step};
use crate::words::Words;

/// From this width things stand beside each other.
const WIDE: f32 = 90.0;

/// Up to this width they stand below each other, even the words of a parameter.
const NARROW: f32 = 84.0;

/// The height of what stands above the picture of the path.
const PATH: f32 = 20.0;

/// The height of the line that says a move.
const LINE: f32 = 6.0;

/// The height of the criteria of four contacts.
const CRITERIA: f32 = 62.0;

/// The panel.
pub(super) fn seen_ui(ui: &mut Ui, view: &mut View<'_>) {
    let cycle = view.session.cycles().cycle;
    let shown = last_focused(ui).and_then(|key| cycle.parameter(key)).or_else(|| cycle.parameters.first());
    if let Some(parameter) = shown {
        focused_ui(ui, view, parameter);
        ui.separator();
    }
    let session = view.session;
    let height = ui.available_height();
    column_ui(ui, "cycles-seen", |ui| match session.cycles().run.as_ref() {
        None => _ = quiet(ui, view.text("cycles-nothing-seen")),
        Some(run) => run_ui(ui, view, run, height),
    });
}

/// What a run has to show, criteria in sight: path and contacts share the height that they leave, beside each other
/// where there is room.
fn run_ui(ui: &mut Ui, view: &mut View<'_>, run: &CycleRun, height: f32) {
    let beside = is_beside(ui, view, run);
    let above = space(PATH) + if beside { 0.0 } else { space(LINE) };
    let left = height - above - if run.evaluation.is_some() { space(CRITERIA) } else { 0.0 };
    let Some(result) = run.found() else {
        path_ui(ui, view, run, beside);
        return path_picture(ui, view, run, left.max(space(40.0)));
    };
    path_ui(ui, view, run, beside);
    let contacts = |ui: &mut Ui, view: &View<'_>, height| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().interact_size.y = 0.0;
            heading(ui, view.text("contacts"));
            if let Some(factor) = picture::contacts_factor(view, result, run.evaluation.as_ref()) {
                quiet(ui, factor);
            }
        });
        of_height(ui, height, |ui| picture::contacts_picture(ui, view, result, run.evaluation.as_ref()));
    };
    if space(WIDE) < ui.available_width() {
        let height = left.max(space(40.0));
        let width = (ui.available_width() - space(3.0)) * 0.575;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = space(3.0);
            ui.allocate_ui(vec2(width, height), |ui| path_picture(ui, view, run, height));
            ui.allocate_ui(vec2(ui.available_width(), height), |ui| {
                ui.vertical(|ui| contacts(ui, view, height - space(6.0)));
            });
        });
    } else {
        let height = ((left - space(8.0)) / 2.0).max(space(40.0));
        path_picture(ui, view, run, height);
        ui.separator();
        contacts(ui, view, height);
    }
    if let Some(evaluation) = &run.evaluation {
        ui.separator();
        heading(ui, view.text("cycles-criteria"));
        picture::criteria_table(ui, view, evaluation);
    }
}

/// What the parameter is, drawn and in words: question, range, default.
fn focused_ui(ui: &mut Ui, view: &View<'_>, parameter: &'static Parameter) {
    let cycle = view.session.cycles().cycle;
    let is_wide = space(WIDE) < ui.available_width();
    let words_ui = |ui: &mut Ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        heading(ui, parameter.key.to_string());
        ui.label(parameter.question(view.words.language().dialogue()));
        quiet(ui, picture::parameter_range(view, parameter));
        quiet(ui, standing_text(view, &view.session.cycles().unset(parameter)));
        if parameter.may_be_predef {
            quiet(ui, view.text("cycles-may-be-predef"));
        }
        if is_wide {
            ui.add_space(space(1.0));
            picture::parameter_sentence(ui, view, parameter);
        }
    };
    // The words stand below the drawing where there is no room beside it.
    if space(NARROW) < ui.available_width() {
        ui.horizontal_top(|ui| {
            picture::parameter_picture(ui, view, cycle, parameter.key, is_wide);
            ui.vertical(words_ui);
        });
    } else {
        picture::parameter_picture(ui, view, cycle, parameter.key, is_wide);
        ui.vertical(words_ui);
    }
}

/// Whether the words of every move have room beside the heading, so that they stay there on the way.
fn is_beside(ui: &Ui, view: &View<'_>, run: &CycleRun) -> bool {
    let width = |text: String, font| ui.painter().layout_no_wrap(text, font, palette(ui.ctx()).text.0).size().x;
    let count = run.path.len();
    let moves = run.path.iter().enumerate().map(|(step, now)| said(view.words, now, step, count));
    let widest = moves.map(|text| width(text, theme::font(sizes().body))).fold(0.0, f32::max);
    let heading = width(view.text("cycles-path"), theme::bold(sizes().heading));
    heading + widest + space(3.0) < ui.available_width()
}

/// The buttons that step along the path, and the move in words.
fn path_ui(ui: &mut Ui, view: &mut View<'_>, run: &CycleRun, beside: bool) {
    let step = view.session.cycles().step;
    let Some(now) = run.path.get(step) else { return };
    let said = said(view.words, now, step, run.path.len());
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        heading(ui, view.text("cycles-path"));
        if beside {
            ui.add(Label::new(&said).truncate());
        }
    });
    steps_ui(ui, view, run.path.len(), step);
    if !beside {
        ui.label(said);
    }
}

/// The path up to a move.
fn path_picture(ui: &mut Ui, view: &View<'_>, run: &CycleRun, height: f32) {
    let step = view.session.cycles().step;
    let around = Surroundings::of(run.nominal, run.ball_radius);
    of_height(ui, height, |ui| picture::path_picture(ui, view, &run.path, step + 1, around));
}

/// The buttons, and the slider beside them; below them where the column is narrow.
fn steps_ui(ui: &mut Ui, view: &mut View<'_>, count: usize, step: usize) {
    let buttons_ui = |ui: &mut Ui, view: &mut View<'_>| {
        ui.spacing_mut().item_spacing.x = space(1.0);
        for step in Step::PATH.map(CyclesAction::StepPath) {
            view.sized_button(ui, step, vec2(space(14.0), control(ui)));
        }
    };
    if ui.available_width() < space(NARROW) {
        ui.horizontal_wrapped(|ui| buttons_ui(ui, view));
        slider_ui(ui, view, count, step);
    } else {
        ui.horizontal(|ui| {
            buttons_ui(ui, view);
            slider_ui(ui, view, count, step);
        });
    }
}

fn slider_ui(ui: &mut Ui, view: &mut View<'_>, count: usize, step: usize) {
    let mut number = step + 1;
    ui.spacing_mut().slider_width = (ui.available_width() - space(4.0)).max(space(20.0));
    let edge = palette(ui.ctx()).edge.0;
    let slider = Slider::new(&mut number, 1..=count).show_value(false).trailing_fill(true);
    let slider = ui
        .scope(|ui| {
            // The rail has the colour of an edge: it has none of its own.
            ui.visuals_mut().widgets.inactive.bg_fill = edge;
            ui.add_enabled(1 < count, slider)
        })
        .inner
        .accessible_name(view.text("cycles-move"));
    if slider.changed() {
        view.send(CyclesCommand::StepTo(number.saturating_sub(1)));
    }
}

const fn phase_id(phase: Phase) -> &'static str {
    match phase {
        Phase::PrePosition => "cycles-phase-pre-position",
        Phase::Approach => "cycles-phase-approach",
        Phase::Contact => "cycles-phase-contact",
        Phase::Retract => "cycles-phase-retract",
        Phase::Leave => "cycles-phase-leave",
    }
}

/// `3 of 17: approach, contact 1, to X 35 Y 45 Z 5`.
fn said(words: &Words, now: &Move, step: usize, count: usize) -> String {
    let place = |place: [f64; 3]| {
        let parts = ["X", "Y", "Z"].into_iter().zip(place);
        let parts = parts.map(|(axis, mm)| format!("{axis} {}", words.number(&figure(mm))));
        parts.collect::<Vec<_>>().join("  ")
    };
    let id = match (now.phase, now.touch) {
        (Phase::Contact, _) => "cycles-move-contact",
        (_, Some(_)) => "cycles-move-of-touch",
        (_, None) => "cycles-move-of-none",
    };
    let message = Message::new(id)
        .count("number", step + 1)
        .count("count", count)
        .message("phase", Message::new(phase_id(now.phase)))
        .text("from", place(now.from))
        .text("to", place(now.to));
    words.say(&match now.touch {
        Some(touch) => message.count("touch", touch),
        None => message,
    })
}

/// Millimetres to four decimals, as a control shows them, without a sign on zero.
fn figure(mm: f64) -> String {
    let text = format!("{mm:.4}");
    let text = without_zeros(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::Language;

    #[test]
    fn a_move_is_said_in_words() {
        let step = Move {
            phase: Phase::Approach,
            touch: Some(1),
            from: [35.0, 45.0, 20.0],
            to: [35.0, 45.0, -0.00001],
            about: None,
        };
        let words = Words::new(Language::En);
        assert_eq!(said(&words, &step, 1, 5), "2 of 5: approach, contact 1, from X 35  Y 45  Z 20 to X 35  Y 45  Z 0");
        let contact = Move { phase: Phase::Contact, from: [0.5, -1.25, 3.0], to: [0.5, -1.25, 3.0], ..step };
        let words = Words::new(Language::Nl);
        assert_eq!(said(&words, &contact, 2, 5), "3 van 5: meetpunt 1, op X 0,5  Y −1,25  Z 3");
    }
}
