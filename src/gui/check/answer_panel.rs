//! Right, above: the answer. One word that is read from two metres, its shape, and what to do.

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{Align, CollapsingHeader, Frame, Layout, Margin, RichText, Sense, Ui, WidgetInfo, vec2};

use crate::gui::shapes;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{Digits, View, quiet};
use crate::journal::Record;
use crate::length::{Length, Unit};
use crate::verdict::{PositionVerdict, Status};
use crate::words::{Message, Say, Words};

/// The verdict card and the reasons below it.
pub(super) fn answer_ui(ui: &mut Ui, view: &View<'_>) {
    let record = view.session.shown().map(|shown| shown.record.as_ref());
    card_ui(ui, view, record);
    if let Some(record) = record {
        why_ui(ui, view, record);
    }
}

/// The name of a status in the locale files.
pub(in crate::gui) const fn status_id(status: Option<Status>) -> &'static str {
    match status {
        Some(Status::Good) => "word-good",
        Some(Status::Rework) => "word-rework",
        Some(Status::Scrap) => "word-scrap",
        Some(Status::ReMeasure) => "word-re-measure",
        None => "word-none",
    }
}

fn card_ui(ui: &mut Ui, view: &View<'_>, record: Option<&Record>) {
    let status = record.map(|record| record.verdict.status());
    let (fill, colour) = palette(ui.ctx()).of_status(status);
    let lines = record.map(|record| lines(view.words, record)).unwrap_or_default();
    let word = view.text(status_id(status));
    let card = Frame::new().fill(fill).corner_radius(6.0).inner_margin(Margin::same(12)).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        ui.set_min_height(space(54.0));
        ui.with_layout(Layout::top_down(Align::Center), |ui| {
            let (rect, _) = ui.allocate_exact_size(vec2(space(18.0), space(18.0)), Sense::hover());
            shapes::status(ui.painter(), rect, status, colour);
            // A long word (German, Italian) is set smaller rather than cut.
            // 64 points and up, following the panel; no result is no news.
            let wanted = sizes().status.max(ui.available_width() * 0.2);
            let wanted = if status.is_some() { wanted } else { sizes().value };
            let galley = ui.painter().layout_no_wrap(word.clone(), theme::bold(wanted), colour);
            let size = wanted.min(wanted * ui.available_width() / galley.size().x.max(1.0));
            ui.label(RichText::new(&word).font(theme::bold(size.floor())).color(colour));
            for (number, line) in lines.iter().enumerate() {
                let font = if number == 0 { theme::bold(sizes().value) } else { theme::font(sizes().limits) };
                ui.label(RichText::new(line).font(font).color(colour));
            }
        });
    });
    let said = std::iter::once(word.clone()).chain(lines.iter().cloned()).collect::<Vec<_>>().join(". ");
    let response = ui.interact(card.response.rect, ui.scope_id().with("verdict"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Status, true, &said));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_live(Live::Assertive));
}

/// What stands below the word: the value, the distances, what to remove, the position.
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

/// Half of a length in µm, exact.
fn half_um(length: Length) -> String {
    let nm = length.nanometres();
    let whole =
        Length::from_nanometres(nm / 2).unwrap_or_default().exact(Unit::Micrometre, if nm % 2 == 0 { 0 } else { 3 });
    if nm % 2 == 0 { whole } else { format!("{whole}5") }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_a_length_is_exact() {
        for (nm, half) in [(2_000, "1"), (25_000, "12.5"), (1, "0.0005"), (3, "0.0015"), (9_001, "4.5005")] {
            assert_eq!(half_um(Length::from_nanometres(nm).unwrap()), half);
        }
    }
}
