//! Right, above: the answer. One word that can be read from two metres, its shape, and what to do.

use eframe::egui::{CollapsingHeader, Ui};

use crate::gui::verdict_card::{card_ui, half_um, status_id};
use crate::gui::view::{Digits, View, quiet};
use crate::journal::Record;
use crate::length::Length;
use crate::message::{Message, Say};
use crate::verdict::PositionVerdict;
use crate::words::Words;

/// The verdict card and the reasons below it.
pub(super) fn answer_ui(ui: &mut Ui, view: &View<'_>) {
    let record = view.session.check().shown().map(|shown| shown.record.as_ref());
    let lines = record.map(|record| lines(view.words, record)).unwrap_or_default();
    let status = record.map(|record| record.verdict.status());
    card_ui(ui, status, &view.text(status_id(status)), &lines);
    if let Some(record) = record {
        why_ui(ui, view, record);
    }
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
