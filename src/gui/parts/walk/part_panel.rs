//! Right, below the verdict: the values of the size that the page is about, what the values make of the part, and what is to do.

use eframe::egui::{Button, Ui, vec2};

use crate::gui::check::check_card;
use crate::gui::shapes::Edge;
use crate::gui::theme::{self, control, space};
use crate::gui::verdict_card::{chip_ui, edged_chip_ui};
use crate::gui::view::{Digits, View, heading, problem, quiet};
use crate::message::{Say as _, message};
use crate::session::parts::{WalkCommand, Walking};

/// How many missing sizes are named.
const NAMED: usize = 12;

/// How many values of a size are shown.
const VALUES: usize = 4;

/// How many sizes stand among what is to do.
const TO_DO: usize = 6;

/// The values of a size, the newest first; one alone is in the card.
pub(super) fn values_ui(ui: &mut Ui, view: &View<'_>, at: usize, is_contradicted: bool) {
    let words = view.words;
    let walking = &view.session.parts().walking;
    let values = walking.values(at);
    if values.len() < 2 {
        return;
    }
    ui.add_space(space(1.0));
    heading(ui, words.say(&message!("walk-page-values").text("name", walking.name(at))));
    for value in values.iter().rev().take(VALUES) {
        let record = &value.record;
        ui.horizontal_wrapped(|ui| {
            if let Some(when) = value.when {
                quiet(ui, when.strftime("%H:%M:%S").to_string());
            }
            ui.label(format!("{} mm", Digits::of(record).mm(words, record.measurement.diameter, 3)));
            let status = record.verdict.status();
            edged_chip_ui(ui, (status, Edge::of(record)), &words.told(&record.verdict));
            if record.measurement.origin.is_simulated() {
                quiet(ui, view.text("walk-page-row-simulated"));
            }
        });
    }
    if !is_contradicted {
        quiet(ui, words.say(&message!("walk-page-last-counts").count("count", values.len())));
    }
}

/// How many sizes have which verdict, what is to do, and what is missing.
pub(super) fn part_ui(ui: &mut Ui, view: &mut View<'_>) {
    let words = view.words;
    let walking = &view.session.parts().walking;
    let standing = walking.standing();
    ui.add_space(space(1.0));
    heading(ui, view.text("walk-page-part-status"));
    counts_ui(ui, view, walking);
    if !walking.is_done() {
        ui.label(words.say(&standing.message()));
        if 0 < standing.simulated {
            problem(ui, words.say(&message!("walk-page-simulated").count("count", standing.simulated)));
        }
    }
    to_do_ui(ui, view, walking);
    if 0 < standing.missing {
        let named: Vec<&str> = walking.open().take(NAMED).collect();
        let more = if named.len() < standing.missing { " …" } else { "" };
        let message = message!("walk-page-missing").text("names", format!("{}{more}", named.join(", ")));
        quiet(ui, words.say(&message));
    }
}

/// A chip for every verdict that sizes have.
fn counts_ui(ui: &mut Ui, view: &View<'_>, walking: &Walking) {
    let counts = walking.counts();
    if counts.is_empty() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        for (status, count) in counts {
            chip_ui(ui, status, &format!("{count} {}", view.words.told(&status)));
        }
    });
}

/// The sizes that are not good, each with what can be done about it, and a way there.
fn to_do_ui(ui: &mut Ui, view: &mut View<'_>, walking: &Walking) {
    let bad: Vec<usize> = walking.not_good().take(TO_DO).collect();
    for at in bad {
        let Some(value) = walking.counting(at) else { continue };
        let card = check_card(view.words, &value.record, walking.is_round(at));
        let what = card.instruction.map_or(card.word, |(what, _)| what);
        let text = view.words.say(&message!("walk-page-to-do").text("name", walking.name(at)).text("what", what));
        let button = Button::new(text).wrap().min_size(vec2(ui.available_width(), control(ui)));
        if theme::looking(ui, theme::tonal, |ui| ui.add(button)).clicked() {
            view.send(WalkCommand::Go(at));
        }
    }
}
