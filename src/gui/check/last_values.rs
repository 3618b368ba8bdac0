//! The last values that were judged by the same limits, newest right, between the limits.

use eframe::egui::{Align2, Rect, RichText, Sense, Stroke, Ui, pos2, vec2};

use crate::gui::shapes::{self, screen};
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{Digits, View, heading, quiet};
use crate::journal::Record;
use crate::message::message;

/// The most values that are drawn.
const MOST: usize = 30;

/// How many earlier checks are looked through for them: a frame costs the same however long the history is.
const LOOKED_THROUGH: usize = 500;

/// Heading and strip.
pub(super) fn last_values_ui(ui: &mut Ui, view: &View<'_>) {
    ui.horizontal(|ui| {
        heading(ui, view.text("last-values"));
        let shown = view.session.check().shown.as_ref();
        if shown.is_some_and(|shown| shown.record.measurement.origin.is_simulated()) {
            ui.label(RichText::new(view.text("simulated")).font(theme::bold(sizes().body)));
        }
    });
    let Some(limits) = view.session.check().asked.limits.as_ref() else {
        quiet(ui, view.text("last-values-empty"));
        return;
    };
    // Simulated values are never among measured ones.
    let is_simulated = |record: &Record| record.measurement.origin.is_simulated();
    let shown = view.session.check().shown.as_ref().is_some_and(|shown| is_simulated(&shown.record));
    let checks = view.session.history().iter().rev().take(LOOKED_THROUGH).map(std::convert::AsRef::as_ref);
    let of_these = |record: &&Record| record.limits == *limits && is_simulated(record) == shown;
    let mut records: Vec<&Record> = checks.filter(of_these).take(MOST).collect();
    records.reverse();
    if records.is_empty() {
        quiet(ui, view.text("last-values-empty"));
        return;
    }
    let remark = ui.text_style_height(&eframe::egui::TextStyle::Body) * 2.0;
    let size = vec2(ui.available_width(), (ui.available_height() - remark).clamp(space(24.0), space(70.0)));
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    draw(ui, view, rect, &records);
    let message = message!("last-values-describe").count("count", records.len());
    let said = records.iter().map(|record| {
        let value = Digits::of(record).mm(view.words, record.measurement.diameter, 3);
        format!("{value} {}", view.words.told(&record.verdict))
    });
    let said = format!("{} {}", view.words.say(&message), said.collect::<Vec<_>>().join(", "));
    spoken::picture(ui, &response, view.text("last-values"), said);
}

/// The zone, its limits in micrometres, and a mark for every value: the shape says the verdict.
fn draw(ui: &Ui, view: &View<'_>, rect: Rect, records: &[&Record]) {
    let palette = palette(ui.ctx());
    let painter = ui.painter().with_clip_rect(rect);
    let Some(first) = records.first() else { return };
    let lower = &first.limits.deviations.lower();
    let upper = &first.limits.deviations.upper();
    let low = lower.to_um_f64();
    let high = upper.to_um_f64();
    let margin = ((high - low) * 0.5).max(1.0);
    let bottom = low - margin;
    let top = high + margin;
    let plot = Rect::from_min_max(rect.min + vec2(space(14.0), 0.0), rect.max);
    let y = |um: f64| {
        // The marks of values beyond the edges are whole.
        let y = plot.bottom() - plot.height() * screen((um - bottom) / (top - bottom));
        y.clamp(plot.top() + space(3.5), plot.bottom() - space(3.5))
    };
    let zone = Rect::from_min_max(pos2(plot.left(), y(high)), pos2(plot.right(), y(low)));
    painter.rect_filled(plot, 0.0, palette.sunken.0);
    painter.rect_filled(zone, 0.0, palette.zone.0);
    for (um, length) in [(low, lower), (high, upper)] {
        painter.hline(plot.x_range(), y(um), Stroke::new(2.0, palette.zone_edge.0));
        let text = view.words.signed_um(*length);
        let at = pos2(plot.left() - 4.0, y(um));
        painter.text(at, Align2::RIGHT_CENTER, text, theme::font(sizes().small), palette.text.0);
    }
    let step = ((plot.width() - space(8.0)) / shapes::times(1.0, MOST)).min(space(10.0));
    let x = |place: usize| plot.right() - space(4.0) - shapes::times(step, records.len() - 1 - place);
    let at = |place: usize, record: &Record| pos2(x(place), y(record.verdict.size.deviation.to_um_f64()));
    let line = records.iter().enumerate().map(|(place, record)| at(place, record)).collect();
    painter.line(line, Stroke::new(1.0, palette.quiet.0));
    let shown = view.session.check().shown.as_ref();
    for (place, record) in records.iter().enumerate() {
        let centre = at(place, record);
        let mark = Rect::from_center_size(centre, vec2(space(3.5), space(3.5)));
        painter.circle_filled(centre, space(2.2), palette.surface.0);
        shapes::status(&painter, mark, Some(record.verdict.status()), palette.text.0);
        if shown.is_some_and(|shown| std::ptr::eq(shown.record.as_ref(), *record)) {
            painter.circle_stroke(centre, space(3.0), Stroke::new(2.0, palette.data.0));
        }
    }
}
