//! One measured value between its limits, along the measuring direction.

use eframe::egui::{Align2, Rect, Sense, Stroke, Ui, Vec2, pos2, vec2};

use super::canvas::Canvas;
use crate::gui::shapes::screen;
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, quiet};
use crate::length::{Length, Unit};
use crate::message::message;
use crate::probing::cycle::{CycleResult, ResultName, Value};
use crate::words::Words;

/// How high the drawing is, in steps.
const STEPS: f32 = 26.0;

/// The share of the width on either side of the zone.
const BESIDE_ZONE: f64 = 0.25;

/// Every value that was compared, or the deviation along the normal; else a sentence that nothing was compared.
pub(super) fn ui(ui: &mut Ui, view: &View<'_>, result: &CycleResult) {
    for check in &result.checks {
        let limits = [check.minimum, check.maximum];
        draw(ui, view.words, check.measured, Some(limits), &view.words.told(check));
    }
    if !result.checks.is_empty() {
        return;
    }
    let deviation = result.results.iter().find(|found| found.name == ResultName::DEVIATION_ALONG);
    match deviation.map(|found| &found.value) {
        Some(Value::Length(deviation)) => {
            let said = message!("cycle-picture-deviation").number("deviation", *deviation);
            draw(ui, view.words, *deviation, None, &view.words.say(&said));
        }
        _ => _ = quiet(ui, view.text("cycle-picture-no-limits")),
    }
}

/// The part of an axis that is shown, in nanometres: a zone with room on either side, or zero with the value.
fn span(measured: Length, limits: Option<[Length; 2]>) -> [f64; 2] {
    let nm = |length: Length| length.to_mm_f64() * 1e6;
    let [lower, upper] = limits.map_or([0.0; 2], |limits| limits.map(nm));
    // A zone of no width still gets room: for the value, and at least a micrometre.
    let width = match upper - lower {
        width if 0.0 < width => width,
        _ => (2.0 * (nm(measured) - lower).abs()).max(1000.0),
    };
    let room = width * BESIDE_ZONE / (1.0 - 2.0 * BESIDE_ZONE);
    let spare = if lower < upper { room } else { width };
    [lower - spare, upper + spare]
}

fn draw(ui: &mut Ui, words: &Words, measured: Length, limits: Option<[Length; 2]>, said: &str) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), space(STEPS)), Sense::hover());
    if ui.is_rect_visible(rect) {
        let canvas = Canvas::new(ui.painter(), palette(ui.ctx()), rect);
        Bar { canvas: &canvas, words, span: span(measured, limits) }.draw(measured, limits);
    }
    spoken::picture_named(&response, said);
    ui.label(said);
}

struct Bar<'a> {
    canvas: &'a Canvas<'a>,
    words: &'a Words,
    span: [f64; 2],
}

impl Bar<'_> {
    /// Where a value lies, from 0 to 1; outside that for one that is not in sight.
    fn share(&self, value: Length) -> f64 {
        let [from, to] = self.span;
        (value.to_mm_f64() * 1e6 - from) / (to - from)
    }

    fn band(&self) -> Rect {
        let rect = self.canvas.rect;
        Rect::from_min_max(rect.min + vec2(space(2.0), space(9.0)), rect.max - vec2(space(2.0), space(8.0)))
    }

    fn x(&self, value: Length) -> f32 {
        let band = self.band();
        band.left() + band.width() * screen(self.share(value).clamp(0.0, 1.0))
    }

    fn draw(&self, measured: Length, limits: Option<[Length; 2]>) {
        let band = self.band();
        let palette = self.canvas.palette;
        self.canvas.line(band.left_center(), band.right_center(), self.canvas.thin());
        if let Some(limits) = limits {
            let [lower, upper] = limits.map(|limit| self.x(limit));
            let zone = Rect::from_x_y_ranges(lower..=upper.max(lower + 1.0), band.y_range());
            self.canvas.painter.rect_filled(zone, 0.0, palette.zone.0);
            for (limit, anchor) in limits.into_iter().zip([Align2::RIGHT_BOTTOM, Align2::LEFT_BOTTOM]) {
                let x = self.x(limit);
                self.canvas.painter.vline(x, band.y_range(), Stroke::new(2.0, palette.zone_edge.0));
                let text = format!("{} mm", self.words.mm(limit, 3));
                let font = theme::font(sizes().body);
                self.canvas.label(pos2(x, band.top() - 3.0), anchor, &text, font, palette.text.0);
            }
        }
        // The nominal point, where deviations are shown.
        if (0.0..=1.0).contains(&self.share(Length::ZERO)) {
            let x = self.x(Length::ZERO);
            let line = [pos2(x, band.top() - 4.0), pos2(x, band.bottom() + 4.0)];
            self.canvas.dashed(&line, Stroke::new(1.5, palette.quiet.0), 5.0, 4.0);
            if limits.is_none() {
                self.canvas.note(line_top(line), Align2::CENTER_BOTTOM, "0");
            }
        }
        self.marker(measured, limits, band);
    }

    /// The value, or an arrow at the edge that it is beyond; always with its figure.
    fn marker(&self, measured: Length, limits: Option<[Length; 2]>, band: Rect) {
        let colour = self.canvas.palette.text.0;
        let share = self.share(measured);
        let x = self.x(measured);
        let y = band.center().y;
        let text = format!("{} mm", figure(self.words, measured, limits));
        let along = match share {
            share if share < 0.0 => -Vec2::X,
            share if 1.0 < share => Vec2::X,
            _ => {
                self.canvas.painter.vline(x, band.y_range(), Stroke::new(3.0, colour));
                self.canvas.head(pos2(x, band.bottom()), Vec2::Y, colour);
                let place = pos2(x, band.bottom() + space(1.0));
                self.canvas.label(place, Align2::CENTER_TOP, &text, theme::bold(sizes().body), colour);
                return;
            }
        };
        self.canvas.head(pos2(x, y), along, colour);
        let anchor = if along.x < 0.0 { Align2::LEFT_TOP } else { Align2::RIGHT_TOP };
        self.canvas.label(pos2(x, band.bottom() + space(1.0)), anchor, &text, theme::bold(sizes().body), colour);
    }
}

/// To 0.1 µm, but exactly where that could hide on which side of a limit it lies.
fn figure(words: &Words, measured: Length, limits: Option<[Length; 2]>) -> String {
    let is_near = |limit: Length| measured.saturating_sub(limit).abs() < Length::from_micrometres(1);
    if limits.is_some_and(|limits| limits.into_iter().any(is_near)) {
        words.mm(measured, 4)
    } else {
        words.number(&measured.rounded(Unit::Millimetre, 4))
    }
}

const fn line_top([top, _]: [eframe::egui::Pos2; 2]) -> eframe::egui::Pos2 {
    top
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_zone_takes_the_middle_half_and_no_zone_is_never_nothing() {
        fn check(measured: i32, limits: Option<[i32; 2]>, expected: [f64; 2]) {
            let span =
                span(Length::from_micrometres(measured), limits.map(|limits| limits.map(Length::from_micrometres)));
            assert!(span.iter().zip(expected).all(|(nm, expected)| (nm - expected).abs() < 1e-6), "{span:?}");
        }
        check(5, Some([-100, 100]), [-200_000.0, 200_000.0]);
        // A zone of no width, and a value on it.
        check(7, Some([7, 7]), [6_000.0, 8_000.0]);
        check(0, None, [-1_000.0, 1_000.0]);
        check(-40, None, [-80_000.0, 80_000.0]);
    }
}
