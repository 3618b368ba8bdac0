//! Right: the answer. The kind of fit as a word and a shape, then the figures, and what follows from them.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Color32, Layout, RichText, Sense, Ui, WidgetInfo, vec2};

use super::press_panel::press_ui;
use super::{example_text, part_text};
use crate::gui::card::{plain_ui, word_ui};
use crate::gui::class_chooser::feature_picture;
use crate::gui::limits::{self, feature_id};
use crate::gui::room::{is_low, is_tiny};
use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::{chip_ui, status_id};
use crate::gui::view::{View, doubt_text, heading, named_figures_ui, problem, quiet};
use crate::length::Length;
use crate::message::{Message, Say as _, message};
use crate::session::{Equivalent, FitAction, FitCommand, MeasuredParts, WarmFit, extremes};
use crate::tolerance::Feature;
use crate::tolerance::fit::preferred::{function, preference};
use crate::tolerance::fit::{Fit, FitKind, basis};
use crate::verdict::Status;
use crate::verdict::fit::{Actual, Possible};

/// Below the kind of fit: what it is for, the parts, limits, the equivalent fit.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let Some(fit) = session.fit().fit.as_ref() else { return };
    if is_tiny(ui) {
        figures_ui(ui, view, fit);
    }
    said_of_ui(ui, view);
    if let Some(parts) = session.fit().parts() {
        ui.separator();
        parts_ui(ui, view, &parts);
    }
    if let Some(warm) = session.fit().warm() {
        ui.separator();
        warm_ui(ui, view, &warm);
    }
    press_ui(ui, view);
    ui.separator();
    limits_ui(ui, view, fit);
    if let Some(equivalent) = session.fit().equivalent.as_ref() {
        ui.separator();
        equivalent_ui(ui, view, equivalent);
    }
}

const fn kind_id(kind: FitKind) -> &'static str {
    match kind {
        FitKind::Clearance => "fit-word-clearance",
        FitKind::Transition => "fit-word-transition",
        FitKind::Interference => "fit-word-interference",
    }
}

/// A range of clearance with its signs: `+7 … +41 µm`.
fn range(view: &View<'_>, minimum: Length, maximum: Length) -> String {
    format!("{} … {} µm", view.words.signed_um(minimum), view.words.signed_um(maximum))
}

/// The kind of fit. It is not a verdict, so it does not have the colour of one. That of an example is quiet and says so first.
pub(super) fn kind_ui(ui: &mut Ui, view: &View<'_>) {
    let fit = view.session.fit().seen().fit.as_ref();
    let word = view.text(fit.map_or("fit-word-none", |fit| kind_id(fit.kind())));
    plain_ui(ui, "kind", false, |ui| {
        let Some(fit) = fit else {
            quiet(ui, &word);
            return vec![word];
        };
        let palette = palette(ui.ctx());
        let example = example_text(view);
        let ink = if example.is_some() { palette.quiet.0 } else { palette.text.0 };
        if let Some(example) = &example {
            quiet(ui, example);
        }
        if !is_low(ui) {
            let (rect, _) = ui.allocate_exact_size(vec2(space(16.0), space(16.0)), Sense::hover());
            shapes::fit_kind(ui.painter(), rect, fit.kind(), ink, palette.sunken.0);
        }
        if example.is_some() {
            ui.label(RichText::new(&word).font(theme::bold(sizes().figure)).color(ink));
        } else {
            word_ui(ui, &word, (0.12, 0.1));
        }
        let line = range(view, fit.minimum_clearance(), fit.maximum_clearance());
        ui.label(RichText::new(&line).font(theme::bold(sizes().figure)).color(ink));
        let mut said: Vec<String> = example.into_iter().chain([word, line]).collect();
        if !is_tiny(ui) {
            ui.with_layout(Layout::top_down(Align::Min), |ui| said.extend(figures_ui(ui, view, fit)));
        }
        said
    });
}

/// The ends of the range and its middle, by name; returns what a screen reader says.
fn figures_ui(ui: &mut Ui, view: &View<'_>, fit: &Fit) -> Vec<String> {
    let [upper, lower] = extremes(fit.minimum_clearance(), fit.maximum_clearance());
    let mean = fit.mean_clearance();
    let mean_id = if mean < Length::ZERO { "fit-mean-interference" } else { "fit-mean-clearance" };
    // The maximum comes first, even where it is the largest interference.
    let (first, second) = if fit.kind() == FitKind::Interference { (lower, upper) } else { (upper, lower) };
    let rows = [first, second, (mean_id, mean.abs())];
    let rows = rows.map(|(id, amount)| (view.text(id), format!("{} µm", view.words.um(amount))));
    let said = rows.iter().map(|(name, value)| format!("{name} {value}")).collect();
    named_figures_ui(ui, "fit-figures", rows);
    said
}

/// Basis, preference and function, as far as they are known for the pair.
fn said_of_ui(ui: &mut Ui, view: &View<'_>) {
    let page = view.session.fit();
    let (Some(hole), Some(shaft)) = (page.class(Feature::Hole), page.class(Feature::Shaft)) else { return };
    let preferred = preference(hole, shaft).map(|preference| preference.message());
    let first = preferred.or_else(|| basis(hole, shaft).map(|basis| basis.message()));
    let name = function(hole, shaft).map(|function| message!("fit-ansi").message("name", function.message()));
    let lines: Vec<String> = first.iter().chain(&name).map(|message| view.words.say(message)).collect();
    if !lines.is_empty() {
        quiet(ui, format!("{hole}/{shaft}: {}", lines.join("; ")));
    }
}

/// Both parts' limits, where they come from, and the way to the check page.
fn limits_ui(ui: &mut Ui, view: &mut View<'_>, fit: &Fit) {
    for (feature, limits) in fit.parts() {
        let name = part_text(view, feature);
        let action = FitAction::CheckPart(feature);
        // Where both have no room in one line the button goes below the name.
        let width =
            |text: String| ui.painter().layout_no_wrap(text, theme::bold(sizes().body), Color32::PLACEHOLDER).size().x;
        let both = width(name.clone()) + width(action.text(view.session, view.words));
        let is_narrow = ui.available_width() < both + ui.spacing().button_padding.x * 2.0 + space(12.0);
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = 0.0;
            feature_picture(ui, feature, space(6.0));
            heading(ui, name);
            if !is_narrow {
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| view.field_button(ui, action));
            }
        });
        if is_narrow {
            view.field_button(ui, action);
        }
        limits::limits_ui(ui, view, limits);
        ui.add_space(space(1.0));
    }
}

/// The same fit in the other basis, with a button to take it.
fn equivalent_ui(ui: &mut Ui, view: &mut View<'_>, equivalent: &Equivalent) {
    ui.horizontal(|ui| {
        let name = heading(ui, view.text("fit-equivalent"));
        let Equivalent { hole, shaft, difference } = equivalent;
        let button = Button::new(format!("{hole}/{shaft}")).min_size(vec2(space(20.0), control(ui)));
        if ui.add_enabled(difference.is_ok(), button).labelled_by(name.id).clicked() {
            view.send(FitCommand::TakePair(*hole, *shaft));
        }
    });
    match &equivalent.difference {
        Ok(difference) if difference.is_none() => _ = ui.label(view.text("fit-equivalent-same")),
        Ok(difference) => {
            let message = message!("fit-equivalent-differs")
                .text("minimum", view.words.signed_um(difference.minimum))
                .text("maximum", view.words.signed_um(difference.maximum));
            ui.label(view.words.say(&message));
        }
        Err(error) => _ = problem(ui, view.words.say(error)),
    }
}

/// A clearance by its name and without a sign: `Interference 20 µm`.
fn clearance(view: &View<'_>, clearance: Length) -> String {
    let id = if clearance < Length::ZERO { "fit-actual-interference" } else { "fit-actual-clearance" };
    view.words.say(&Message::new(id).text("um", view.words.um(clearance.abs())))
}

fn parts_ui(ui: &mut Ui, view: &View<'_>, parts: &MeasuredParts) {
    match parts {
        MeasuredParts::Both(actual) => both_ui(ui, view, actual),
        MeasuredParts::One(possible) => one_ui(ui, view, possible),
    }
}

fn both_ui(ui: &mut Ui, view: &View<'_>, actual: &Actual) {
    ui.label(RichText::new(clearance(view, actual.clearance)).font(theme::bold(sizes().figure)));
    let id = if actual.conforms { "fit-conforms" } else { "fit-conforms-not" };
    ui.label(view.text(id));
    part_ui(ui, view, Feature::Hole, actual.hole, actual.hole_verdict.status());
    part_ui(ui, view, Feature::Shaft, actual.shaft, actual.shaft_verdict.status());
}

fn one_ui(ui: &mut Ui, view: &View<'_>, possible: &Possible) {
    let id = match possible.feature {
        Feature::Hole => "fit-with-good-shaft",
        Feature::Shaft => "fit-with-good-hole",
    };
    ui.label(view.text(id));
    let line = range(view, possible.minimum, possible.maximum);
    ui.label(RichText::new(line).font(theme::bold(sizes().figure)));
    part_ui(ui, view, possible.feature, possible.measured, possible.verdict.status());
}

/// A measured part and its own verdict: word, shape and colour.
fn part_ui(ui: &mut Ui, view: &View<'_>, feature: Feature, measured: Length, status: Status) {
    let part = view.text(feature_id(Some(feature)));
    let word = view.text(status_id(Some(status)));
    let said = format!("{part} {word}");
    ui.horizontal(|ui| {
        let chip = chip_ui(ui, status, &word);
        let response = ui.interact(chip.rect, ui.scope_id().with(&said), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
        ui.label(format!("{part} {} mm", view.words.mm(measured, 3)));
    });
    if let Some(doubt) = view.session.fit().doubt(feature) {
        problem(ui, doubt_text(view.words, doubt));
    }
}

fn warm_ui(ui: &mut Ui, view: &View<'_>, warm: &WarmFit) {
    let degrees = view.words.number(&warm.temperature.to_string());
    heading(ui, view.words.say(&message!("fit-at-temperature").text("degrees", degrees)));
    ui.label(RichText::new(range(view, warm.minimum, warm.maximum)).font(theme::bold(sizes().figure)));
    let kind = view.text(kind_id(FitKind::of(warm.minimum, warm.maximum)));
    let change = message!("fit-temperature-change").text("um", view.words.signed_um(warm.change));
    ui.label(format!("{kind}; {}", view.words.say(&change)));
    if let Some(actual) = warm.actual {
        let line = message!("fit-these-parts").text("clearance", clearance(view, actual));
        ui.label(view.words.say(&line));
    }
}
