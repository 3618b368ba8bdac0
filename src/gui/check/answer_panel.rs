//! Right, above: the answer. One word that can be read from two metres, its shape, and what to do.

use eframe::egui::{CollapsingHeader, Ui, vec2};

use crate::gui::theme::{sizes, space};
use crate::gui::verdict_card::{Card, card_ui, chip_ui, half_um, status_id};
use crate::gui::view::{Digits, View, heading, quiet};
use crate::journal::Record;
use crate::length::Length;
use crate::message::{Message, Say};
use crate::session::{Action, Lot, Question, Step};
use crate::verdict::{PositionVerdict, Status};
use crate::words::Words;

/// The imported lot, if there is one, the verdict card, and the reasons below it; or a question instead.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    if let Some(lot) = view.session.check().lot() {
        lot_ui(ui, view, lot);
    }
    if let Some(question) = view.session.check().question() {
        return question_ui(ui, view, question);
    }
    let record = view.session.check().shown().map(|shown| shown.record.as_ref());
    let lines = record.map(|record| lines(view.words, record)).unwrap_or_default();
    let status = record.map(|record| record.verdict.status());
    let is_simulated = record.is_some_and(|record| record.measurement.origin.is_simulated());
    card_ui(ui, view, &Card { status, is_simulated, word: view.text(status_id(status)), lines: &lines });
    if let Some(record) = record {
        why_ui(ui, view, record);
    }
}

/// What is asked about a typed value before it is judged.
fn question_ui(ui: &mut Ui, view: &mut View<'_>, question: &Question) {
    let measured = format!("{} mm", view.words.mm(question.measured, 3));
    let lines = [measured, view.words.told(&question.doubt), view.text("question-enter")];
    card_ui(ui, view, &Card { status: None, is_simulated: false, word: view.text("word-question"), lines: &lines });
    ui.add_space(space(1.0));
    let size = vec2(ui.available_width(), sizes().touch);
    if question.doubt.meant().is_some() {
        view.main_button(ui, Action::TakeMeant, size);
    }
    let anyway = view.named(Action::JudgeAnyway).min_size(size);
    view.button_as(ui, Action::JudgeAnyway, anyway);
}

/// How many rows of an imported file are what, and which of them is shown.
fn lot_ui(ui: &mut Ui, view: &mut View<'_>, lot: &Lot) {
    let words = view.words;
    let said = |id: &'static str, count: usize| words.say(&Message::new(id).count("count", count));
    heading(ui, words.say(&Message::new("lot-title").text("name", lot.name()).count("rows", lot.rows())));
    ui.horizontal_wrapped(|ui| {
        for (status, count) in lot.counts() {
            // Nothing is re-measured without a guard band, so a zero would only raise questions.
            if status != Status::ReMeasure || 0 < count {
                let word = words.told(&status);
                let text = Message::new("lot-count").text("status", word).count("count", count);
                chip_ui(ui, status, &words.say(&text));
            }
        }
    });
    for (id, count) in
        [("lot-unjudged", lot.unjudged()), ("lot-refused", lot.refused()), ("lot-doubted", lot.doubted())]
    {
        if 0 < count {
            ui.label(said(id, count));
        }
    }
    let Some((place, line)) = lot.shown() else { return };
    let part = view.session.check().shown().map(|shown| shown.record.id.clone()).unwrap_or_default();
    let shown = Message::new(if part.is_empty() { "lot-shown" } else { "lot-shown-part" });
    let shown = shown.count("place", place).count("judged", lot.judged()).count("line", line).text("part", part);
    ui.label(words.say(&shown));
    ui.horizontal(|ui| {
        for step in Step::PATH {
            view.field_button(ui, Action::ShowInLot(step));
        }
    });
    ui.add_space(space(1.0));
}

/// The lines below the word: the value, the distances, what to remove, the position.
fn lines(words: &Words, record: &Record) -> Vec<String> {
    let size = &record.verdict.size;
    let digits = Digits::of(record);
    let mut lines = vec![format!("{} mm", digits.mm(words, record.measurement.diameter, 3))];
    let distance = |id: (&'static str, &'static str), distance: Length| {
        let id = if distance < Length::ZERO { id.1 } else { id.0 };
        words.say(&Message::new(id).text("um", digits.um(words, distance.abs())))
    };
    if let Some(removal) = size.removal {
        let um = |length: Length| digits.um(words, length);
        lines.push(words.say(&Message::new("remove-to-limit").text("um", um(removal.to_limit))));
        lines.push(words.say(&Message::new("remove-to-middle").text("um", um(removal.to_middle))));
        let half = match digits {
            Digits::Exact => words.number(&half_um(removal.to_limit)),
            Digits::Rounded => um(removal.to_limit.midpoint(Length::ZERO)),
        };
        lines.push(words.say(&Message::new("remove-per-side").text("um", half)));
    } else {
        lines.push(distance(("above-minimum", "below-minimum"), size.above_minimum));
        lines.push(distance(("below-maximum", "above-maximum"), size.below_maximum));
    }
    if let Some(position) = record.verdict.position.filter(PositionVerdict::is_monitored) {
        lines.push(words.get(if position.is_out() { "position-out" } else { "position-in" }));
    }
    if record.verdict.status() != size.status {
        let id = status_id(Some(size.status));
        lines.push(words.say(&Message::new("diameter-alone").text("status", words.get(id))));
    }
    lines.extend(record.doubt.map(|doubt| words.told(&doubt)));
    lines
}

fn why_ui(ui: &mut Ui, view: &View<'_>, record: &Record) {
    CollapsingHeader::new(view.text("why")).id_salt("why").show_unindented(ui, |ui| {
        let words = view.words;
        let said = |id: &'static str, what: &dyn Say| words.say(&Message::new(id).message("what", what.message()));
        quiet(ui, said("why-limits", &record.limits.source));
        quiet(ui, said("why-measured", &record.measurement.origin));
        quiet(ui, said("why-rule", &record.verdict.rule));
        for caveat in record.measurement.caveats() {
            quiet(ui, said("why-caveat", &caveat));
        }
    });
}
