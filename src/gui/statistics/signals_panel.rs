//! The patterns that rules find, numbered as in the chart; the rules; what to do.

use eframe::egui::{Button, Label, RichText, Ui, vec2};

use crate::gui::columns::{column_ui, footed_column_ui};
use crate::gui::theme::{self, control, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::session::statistics::SignalText;
use crate::session::{StatisticsAction, StatisticsCommand};
use crate::statistics::Rule;

/// So many signals are listed.
const MOST: usize = 100;

/// From this height on, what to do is always in sight.
const FOOTED: f32 = 260.0;

/// Signals that scroll, and below them what to do; in a low card all of it scrolls.
pub(super) fn card_ui(ui: &mut Ui, view: &mut View<'_>) {
    if FOOTED <= ui.available_height() {
        return footed_column_ui(ui, view, "statistics-signals", signals_ui, advice_ui);
    }
    column_ui(ui, "statistics-signals", |ui| {
        signals_ui(ui, view);
        advice_ui(ui, view);
    });
}

pub(super) fn signals_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.text("statistics-page-signals"));
        view.toggle(ui, StatisticsAction::ShowRules);
    });
    if page.shows_rules {
        for rule in Rule::ALL {
            view.checkbox(ui, StatisticsAction::SwitchRule(rule));
        }
    }
    let signals = page.signals(view.words);
    if signals.is_empty() {
        quiet(ui, view.text("statistics-page-no-signals"));
    }
    for signal in signals.iter().take(MOST) {
        signal_ui(ui, view, signal);
    }
}

/// Whether what is asked for is proven, and what to do.
pub(super) fn advice_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    heading(ui, view.text("statistics-page-advice"));
    let told = page.told_of_look(view.words).into_iter().chain(page.proof_text(view.words));
    for said in told.chain(page.advice(view.words)) {
        ui.add(Label::new(RichText::new(said).size(sizes().small)).wrap());
    }
}

/// A press opens the record of its last point.
fn signal_ui(ui: &mut Ui, view: &mut View<'_>, signal: &SignalText) {
    let SignalText { number, rule, place, point } = signal;
    let title = format!("{number}  {rule}");
    let text = RichText::new(format!("{title}\n{place}")).size(sizes().small);
    let button = Button::new(text).wrap().min_size(vec2(ui.available_width(), control(ui) + space(2.0)));
    let pressed = theme::looking(ui, theme::tonal, |ui| ui.add(button));
    if pressed.accessible_name(format!("{title}. {place}")).clicked() {
        view.send(StatisticsCommand::OpenRecord(Some(*point)));
    }
}
