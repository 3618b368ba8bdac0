//! Right: the verdict, the status window, the result parameters as the control lists them, and what is worth knowing.

use eframe::egui::{Align, Button, Color32, Label, Layout, RichText, Ui, vec2};

use crate::gui::check::{mask_chooser_ui, recorded_ui};
use crate::gui::popup::popup_ui;
use crate::gui::room::is_tiny;
use crate::gui::shapes::Edge;
use crate::gui::theme::{self, control, sizes, space};
use crate::gui::verdict_card::{Card, card_height, card_ui, half, lines_below_ui, remove, status_id};
use crate::gui::view::{Digits, View, by_limits_ui, heading, quiet, quiet_height, quiet_within};
use crate::length::{Length, Unit};
use crate::message::{Message, message};
use crate::probing::cycle::{Check, CycleResult, LogTarget, ResultName, ResultParameter, Value};
use crate::session::{CycleRun, CyclesAction, RunLog, WorkpieceAction};
use crate::verdict::{Removal, Status};
use crate::words::Words;

/// Below the verdict: status window, results, remarks.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let run = session.cycles().run.as_ref();
    lines_below_ui(ui, &run_card(view, run));
    ui.add_space(space(1.0));
    let window = session.cycles().window(session.drawn_with());
    let is_measured = run.is_some_and(|run| run.found().is_some());
    let empty = if is_measured { "cycles-no-window" } else { "popup-empty" };
    let title = if run.is_some_and(|run| run.is_simulated) { "popup-title-simulated" } else { "popup-title" };
    popup_ui(ui, view, window.as_ref(), empty, title);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = control(ui);
        view.button(ui, CyclesAction::CopyCycleStatus);
        mask_chooser_ui(ui, view);
    });
    monitoring_ui(ui, view, run);
    // Below the window, so that nothing above moves when a program stop comes.
    if let Some(stop) = run.and_then(|run| run.found()?.stop.as_ref()) {
        ui.label(RichText::new(view.words.told(stop)).font(theme::bold(sizes().body)));
    }
    if let Some((run, result)) = run.and_then(|run| Some((run, run.found()?))) {
        by_limits_ui(ui, view);
        others_ui(ui, view.words, result);
        results_ui(ui, view, result);
        notes_ui(ui, view, run, result);
    }
}

/// The verdict. What stands below it does not move when a result comes: the card keeps the room of a rework with its
/// instruction.
pub(super) fn verdict_ui(ui: &mut Ui, view: &mut View<'_>) {
    let run = view.session.cycles().run.as_ref();
    let height = if is_tiny(ui) { 0.0 } else { card_height(ui, view, &largest_card(view.words)) };
    card_ui(ui, view, &Card { height, ..run_card(view, run) });
    let slip = run.and_then(|run| run.record).map(|record| (record, 0));
    recorded_ui(ui, view, slip.and_then(|slip| view.session.recording().of_slip(slip)));
}

/// A card with every line that one value can give it.
fn largest_card(words: &Words) -> Card {
    let um = |id: &'static str| words.say(&Message::new(id).text("um", words.number("888.8")));
    Card {
        status: Some(Status::Rework),
        edge: Edge::Dashes,
        word: words.told(&Status::Rework),
        value: Some(format!("{} mm", words.number("888.8888"))),
        instruction: Some(remove(words, &words.number("888.8"), Some(words.number("888.8")))),
        lines: vec![
            with_more(words, words.told(&ResultName::DIAMETER), 2),
            um("below-minimum"),
            um("remove-to-middle"),
        ],
        ..Card::default()
    }
}

fn run_card(view: &View<'_>, run: Option<&CycleRun>) -> Card {
    let words = view.words;
    let is_simulated = run.is_some_and(|run| run.is_simulated);
    match run.map(|run| &run.result) {
        None => Card { word: view.text("word-none"), ..Card::default() },
        Some(Err(problem)) => {
            Card { word: view.text("cycles-word-stopped"), lines: vec![words.say(problem)], ..Card::default() }
        }
        Some(Ok(result)) => Card { edge: Edge::of_simulated(is_simulated), ..card(words, result) },
    }
}

/// The value that the card is about, the worst that is out or else the first, and every other that is out.
fn first_and_others(result: &CycleResult) -> Option<(&Check, Vec<&Check>)> {
    let mut out: Vec<&Check> = result.checks.iter().filter(|check| check.is_out()).collect();
    // What no rework mends decides, and comes first.
    out.sort_by_key(|check| check.removal().is_some());
    let mut out = out.into_iter();
    let first = out.next().or_else(|| result.checks.first())?;
    Some((first, out.collect()))
}

/// What a value is, and how many more are told below.
fn with_more(words: &Words, what: String, count: usize) -> String {
    if count == 0 { what } else { words.say(&message!("cycles-more-out").text("what", what).text("count", count)) }
}

/// The other values that are out, below the status window: the card keeps its height however many there are.
fn others_ui(ui: &mut Ui, words: &Words, result: &CycleResult) {
    let Some((_, others)) = first_and_others(result) else { return };
    for other in others {
        let Card { value, instruction, lines, .. } = check_card(words, other);
        // Nothing is removed from scrap: then only the distance from the limit counts.
        let is_rework = result.status == Some(Status::Rework);
        let instruction = instruction.filter(|_| is_rework);
        let (name, rest) = lines.split_first().map_or(("", [].as_slice()), |(name, rest)| (name.as_str(), rest));
        let rest = rest.get(..1).filter(|_| !is_rework).unwrap_or(rest);
        ui.separator();
        let title = value.map_or_else(|| name.to_owned(), |value| format!("{name} {value}"));
        ui.label(RichText::new(title).font(theme::bold(sizes().body)));
        for line in instruction.iter().map(|(what, rest)| format!("{what} {rest}")).chain(rest.iter().cloned()) {
            ui.label(RichText::new(line).font(theme::font(sizes().body)));
        }
    }
}

/// The card of a result: the value, its distance from its limits, what to remove, how many others are out.
fn card(words: &Words, result: &CycleResult) -> Card {
    let Some((first, others)) = first_and_others(result) else {
        let word = words.get("cycles-word-no-verdict");
        let value = main_value(words, result);
        // The markers (Q180 to Q182) stand among the results.
        let why = if result.status.is_some() { "cycles-no-limits-marked" } else { "cycles-no-limits" };
        return Card { word, value, lines: vec![words.get(why)], ..Card::default() };
    };
    let mut card = check_card(words, first);
    card.status = result.status;
    card.word = words.get(if result.status.is_some() { status_id(result.status) } else { "cycles-word-no-verdict" });
    if let Some(name) = card.lines.first_mut() {
        *name = with_more(words, std::mem::take(name), others.len());
    }
    card
}

fn digits(check: &Check) -> Digits {
    Digits::of_distances(&[check.above_minimum(), check.below_maximum()])
}

/// What a card says of one value against its limits.
fn check_card(words: &Words, check: &Check) -> Card {
    let digits = digits(check);
    let um = |length: Length| digits.um(words, length);
    let distance = |distance: Length, inside: &'static str, outside: &'static str| {
        let id = if distance < Length::ZERO { outside } else { inside };
        words.say(&Message::new(id).text("um", um(distance.abs())))
    };
    let mut lines = vec![words.told(&check.what)];
    let below = distance(check.below_maximum(), "below-maximum", "above-maximum");
    let above = distance(check.above_minimum(), "above-minimum", "below-minimum");
    let removal = check.removal();
    match removal {
        Some(removal) => {
            lines.push(if check.below_maximum() < Length::ZERO { below } else { above });
            lines.push(words.say(&message!("remove-to-middle").text("um", um(removal.to_middle))));
        }
        None if check.above_minimum() < Length::ZERO => lines.push(above),
        None if check.below_maximum() < Length::ZERO => lines.push(below),
        None => lines.extend([above, below]),
    }
    let value = Some(format!("{} mm", digits.mm(words, check.measured, 3)));
    let per_side =
        |removal: &Removal| (check.what == ResultName::DIAMETER).then(|| half(words, digits, removal.to_limit));
    let instruction = removal.map(|removal| remove(words, &um(removal.to_limit), per_side(&removal)));
    Card { value, instruction, lines, ..Card::default() }
}

/// The main value of the cycle: a diameter, a deviation along the normal, or else the first one.
fn main_value(words: &Words, result: &CycleResult) -> Option<String> {
    let about = [ResultName::DIAMETER, ResultName::DEVIATION_ALONG];
    let found = result.results.iter().find(|found| about.contains(&found.name)).or_else(|| result.results.first())?;
    Some(match found.value {
        // Like a value beside limits: a measured value has more digits than are meaningful.
        Value::Length(length) => format!("{} mm", Digits::Rounded.mm(words, length, 3)),
        ref other => value(words, other, 3),
    })
}

/// A value; a length with at least this many decimals.
fn value(words: &Words, value: &Value, decimals: usize) -> String {
    match value {
        Value::Length(length) => format!("{} mm", words.mm(*length, decimals)),
        other => words.say(&other.with_unit()),
    }
}

/// How many decimals show all lengths exactly, with their decimal signs aligned.
fn decimals(result: &CycleResult) -> usize {
    let of_value = |found: &ResultParameter| match found.value {
        Value::Length(length) => {
            length.exact(Unit::Millimetre, 3).split_once('.').map_or(0, |(_, decimals)| decimals.len())
        }
        _ => 0,
    };
    result.results.iter().map(of_value).fold(0, usize::max)
}

/// The result parameters, their values aligned.
fn results_ui(ui: &mut Ui, view: &mut View<'_>, result: &CycleResult) {
    ui.separator();
    ui.horizontal(|ui| {
        heading(ui, view.text("cycles-results"));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            // The heading beside it says what is copied; a screen reader has the whole name.
            let name = view.text("cycles-copy-results");
            let button = Button::new(view.text("copy"));
            view.button_as(ui, CyclesAction::CopyResults, button).accessible_name(name);
        });
    });
    let decimals = decimals(result);
    let shown: Vec<_> = result.results.iter().map(|found| value(view.words, &found.value, decimals)).collect();
    let width = |text: &String| {
        let font = theme::font(sizes().body);
        ui.painter().layout_no_wrap(text.clone(), font, Color32::PLACEHOLDER).size().x
    };
    // Names take what the widest value leaves them, in as many lines as they need.
    let widest = shown.iter().map(width).fold(0.0, f32::max);
    let width = (ui.available_width() - space(11.0) - widest - ui.spacing().item_spacing.x * 2.0).max(space(10.0));
    for (found, text) in result.results.iter().zip(shown) {
        let text = RichText::new(text).font(theme::font(sizes().body));
        let name = view.words.told(&found.name);
        let height = quiet_height(ui, &name, width).max(sizes().body + space(1.0));
        let row = vec2(ui.available_width(), height);
        ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_height(height);
            let text_of_key = RichText::new(found.called()).font(theme::bold(sizes().body));
            ui.allocate_ui_with_layout(vec2(space(11.0), row.y), Layout::left_to_right(Align::Center), |ui| {
                ui.set_min_width(space(11.0));
                ui.label(text_of_key);
            });
            quiet_within(ui, name, width);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.add(Label::new(text).selectable(true));
            });
        });
    }
}

/// The measuring log: its text where the control shows it, and a button that saves it as a file.
fn log_ui(ui: &mut Ui, view: &mut View<'_>, log: &RunLog) {
    if let Some(text) = &log.shown {
        let text = RichText::new(text).font(theme::mono(sizes().small));
        ui.add(Label::new(text).selectable(true).wrap());
    }
    view.button(ui, CyclesAction::SaveLog);
}

/// What the monitoring of the tool gave: a changed cell of the tool table, or why the control stops.
fn monitoring_ui(ui: &mut Ui, view: &mut View<'_>, run: Option<&CycleRun>) {
    let Some(monitoring) = run.and_then(|run| run.monitoring.as_ref()) else { return };
    if let Some(stop) = monitoring.problem() {
        ui.label(RichText::new(view.words.say(&stop)).font(theme::bold(sizes().body)));
    }
    if let Some(change) = monitoring.change() {
        quiet(ui, view.words.told(change));
        view.button(ui, WorkpieceAction::SaveTools);
        quiet(ui, view.text("tools-save-hint"));
    }
}

/// The log, where contacts came from, remarks and warnings.
fn notes_ui(ui: &mut Ui, view: &mut View<'_>, run: &CycleRun, result: &CycleResult) {
    ui.separator();
    let words = view.words;
    let log = match result.log {
        LogTarget::None => None,
        LogTarget::File(name) => Some(words.say(&message!("cycles-log-file").text("name", name))),
        LogTarget::Screen => Some(view.text("cycles-log-screen")),
        LogTarget::Shown => Some(view.text("cycles-log-shown")),
    };
    if let Some(line) = log {
        quiet(ui, line);
    }
    if let Some(log) = view.session.cycles().log() {
        log_ui(ui, view, log);
    }
    quiet(ui, words.say(&run.from));
    for remark in run.remarks() {
        quiet(ui, words.say(&remark));
    }
}
