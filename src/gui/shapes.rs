//! Shapes that are painted, so that they need no font: verdicts, hole and shaft, hatching.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Color32, Painter, Pos2, Rect, Response, Shape, Stroke, StrokeKind, Ui, Vec2, pos2, vec2};

use super::theme::{Icon, Weight, palette};
use crate::journal::Record;
use crate::statistics::round::round_down;
use crate::text::long;
use crate::tolerance::Feature;
use crate::tolerance::fit::FitKind;
use crate::verdict::Status;

/// Screen coordinates have fewer digits than geometry.
#[expect(clippy::as_conversions, clippy::cast_possible_truncation, reason = "a place on the screen")]
pub(super) const fn screen(value: f64) -> f32 {
    value as f32
}

/// A size multiplied by any number of lines.
pub(super) fn times(size: f32, count: usize) -> f32 {
    let part = |number: usize| u16::try_from(number).map_or(f32::from(u16::MAX), f32::from);
    size * (part(count >> 16) * 65_536.0 + part(count & 0xffff))
}

/// How many whole lines a number of them is; none below zero.
#[expect(
    clippy::as_conversions,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "lines on a screen"
)]
pub(super) const fn lines_of(lines: f32) -> usize {
    lines.max(0.0) as usize
}

/// A place among so many, by its share of the way; exact to the place up to 2^52.
#[expect(clippy::as_conversions, clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below the number")]
#[expect(clippy::cast_precision_loss, reason = "nobody has so many rows")]
pub(super) fn part_of(share: f32, count: usize) -> usize {
    (f64::from(share.clamp(0.0, 1.0)) * count as f64) as usize
}

/// How much of all something is, from 0 to 1; 0 of nothing.
#[expect(clippy::as_conversions, clippy::cast_precision_loss, reason = "a length on the screen")]
pub(super) fn share(part: u64, all: u64) -> f32 {
    if all == 0 { 0.0 } else { screen(part as f64 / all as f64).clamp(0.0, 1.0) }
}

/// The same of places.
pub(super) fn ratio(part: usize, all: usize) -> f32 {
    share(long(part), long(all))
}

/// The ring around a part of a page that has the focus as a whole.
pub(super) fn focus_ring(ui: &Ui, rect: Rect) {
    let stroke = Stroke::new(2.0, palette(ui.ctx()).focus.0);
    ui.painter().rect_stroke(rect.shrink(1.0), 0.0, stroke, StrokeKind::Inside);
}

/// The ring of a button without a frame, which the library gives none. On a coloured card it has the colour of the words.
pub(super) fn ringed(ui: &Ui, button: Response, colour: Color32) -> Response {
    if button.has_focus() {
        ui.painter().rect_stroke(button.rect, 4.0, Stroke::new(2.0, colour), StrokeKind::Inside);
    }
    button
}

/// What is drawn around a verdict that is not what it looks like at first sight; its ground is pale then.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Edge {
    #[default]
    None,
    /// Nobody measured.
    Dashes,
    /// The rule accepts what lies beyond a limit.
    Line,
}

impl Edge {
    pub fn of(record: &Record) -> Self {
        if record.verdict.is_beyond_limits() {
            Self::Line
        } else {
            Self::of_simulated(record.measurement.origin.is_simulated())
        }
    }

    pub const fn of_simulated(is_simulated: bool) -> Self {
        if is_simulated { Self::Dashes } else { Self::None }
    }
}

/// Draws it around a verdict with such corners.
pub(super) fn edge(painter: &Painter, (rect, corner): (Rect, f32), edge: Edge, colour: Color32) {
    match edge {
        Edge::None => {}
        Edge::Dashes => dashed_frame(painter, rect, colour),
        Edge::Line => {
            let width = if rect.height() < 60.0 { 2.0 } else { 4.0 };
            painter.rect_stroke(rect, corner, Stroke::new(width, colour), StrokeKind::Inside);
        }
    }
}

/// The frame of a simulated verdict: nobody measured it.
pub(super) fn dashed_frame(painter: &Painter, rect: Rect, colour: Color32) {
    let rect = rect.shrink(2.0);
    let corners = [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom(), rect.left_top()];
    painter.extend(Shape::dashed_line(&corners, Stroke::new(2.0, colour), 8.0, 5.0));
}

/// The shape of a verdict: check, turning arrow, cross, loop, arrows up and down; a dash for no result.
pub(super) fn status(painter: &Painter, rect: Rect, status: Option<Status>, colour: Color32) {
    let icon = match status {
        Some(Status::Good) => Icon::Check,
        Some(Status::Rework) => Icon::ArrowCounterClockwise,
        Some(Status::Scrap) => Icon::X,
        Some(Status::ReMeasure) => Icon::Repeat,
        Some(Status::OutOfLimits) => Icon::ArrowsVertical,
        None => Icon::Minus,
    };
    icon.paint(painter, rect.center(), Weight::Bold, rect.size().min_elem(), colour);
}

/// The outline of a verdict around a number: circle, square, diamond, hexagon, triangle; a circle where there is none.
pub(super) fn outline(
    painter: &Painter,
    at: Pos2,
    radius: f32,
    status: Option<Status>,
    (fill, edge): (Color32, Stroke),
) {
    let corners: &[Vec2] = match status {
        Some(Status::Good) | None => &[],
        Some(Status::Rework) => &[vec2(-0.9, -0.9), vec2(0.9, -0.9), vec2(0.9, 0.9), vec2(-0.9, 0.9)],
        Some(Status::Scrap) => &[vec2(0.0, -1.3), vec2(1.3, 0.0), vec2(0.0, 1.3), vec2(-1.3, 0.0)],
        Some(Status::OutOfLimits) => &[vec2(0.0, -1.45), vec2(1.4, 0.85), vec2(-1.4, 0.85)],
        Some(Status::ReMeasure) => {
            &[vec2(1.15, 0.0), vec2(0.58, 1.0), vec2(-0.58, 1.0), vec2(-1.15, 0.0), vec2(-0.58, -1.0), vec2(0.58, -1.0)]
        }
    };
    if corners.is_empty() {
        painter.circle(at, radius, fill, edge);
        return;
    }
    let points = corners.iter().map(|corner| at + *corner * radius).collect();
    painter.add(PathShape::convex_polygon(points, fill, edge));
}

pub(super) fn arrow_head(painter: &Painter, tip: Pos2, direction: Vec2, size: f32, colour: Color32) {
    let along = direction.normalized() * size;
    let across = vec2(-along.y, along.x) * 0.62;
    let points = vec![tip + along * 0.6, tip - along * 0.5 + across, tip - along * 0.5 - across];
    painter.add(PathShape::convex_polygon(points, colour, Stroke::NONE));
}

/// A small picture of what is measured: material around a hole, or a shaft with nothing around it.
pub(super) fn feature(
    painter: &Painter,
    rect: Rect,
    feature: Feature,
    material: Color32,
    ground: Color32,
    line: Color32,
) {
    let edge = Stroke::new(1.5, line);
    let radius = rect.size().min_elem() * 0.3;
    match feature {
        Feature::Hole => {
            painter.rect(rect, 2.0, material, edge, eframe::egui::StrokeKind::Inside);
            painter.circle(rect.center(), radius, ground, edge);
        }
        Feature::Shaft => _ = painter.circle(rect.center(), radius * 1.35, material, edge),
    }
}

/// The shape of a kind of fit: a shaft smaller than its hole, as large, or larger.
pub(super) fn fit_kind(painter: &Painter, rect: Rect, kind: FitKind, colour: Color32, ground: Color32) {
    let size = rect.size().min_elem();
    let ring = size * 0.3;
    let shaft = Stroke::new(size * 0.09, colour);
    match kind {
        FitKind::Clearance => {
            painter.circle(rect.center(), size * 0.44, ground, shaft);
            painter.circle_filled(rect.center(), size * 0.22, colour);
        }
        FitKind::Transition => {
            painter.circle(rect.center(), size * 0.44, ground, shaft);
            painter.circle_filled(rect.center(), size * 0.4, colour);
            painter.circle_filled(rect.center(), size * 0.22, ground);
        }
        FitKind::Interference => {
            painter.circle_filled(rect.center(), size * 0.48, colour);
            painter.circle_stroke(rect.center(), ring, Stroke::new(size * 0.05, ground));
        }
    }
}

/// How an area is hatched: the sides of the limit band differ without colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hatch {
    /// Lines one way: rework, and the hole of a fit.
    Single,
    /// Lines the other way: the shaft of a fit.
    Falling,
    /// Lines both ways: scrap.
    Cross,
    /// Upright lines: nothing is decided.
    Upright,
}

/// Hatches an area with lines at 45 degrees.
pub(super) fn hatch(painter: &Painter, rect: Rect, hatch: Hatch, stroke: Stroke) {
    const STEP: f32 = 9.0;
    if !rect.is_positive() {
        return;
    }
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    let height = rect.height();
    if hatch == Hatch::Upright {
        let mut x = rect.left() + STEP / 3.0;
        while x < rect.right() {
            painter.vline(x, rect.y_range(), stroke);
            x += STEP / 2.0;
        }
        return;
    }
    let mut x = rect.left() - height;
    while x < rect.right() {
        if hatch != Hatch::Falling {
            painter.line_segment([pos2(x, rect.bottom()), pos2(x + height, rect.top())], stroke);
        }
        if hatch != Hatch::Single {
            painter.line_segment([pos2(x, rect.top()), pos2(x + height, rect.bottom())], stroke);
        }
        x += STEP;
    }
}

/// The largest factor of 1, 2 or 5 times a power of ten by which the largest deviation stays within reach; at least 1.
/// Both in the same unit.
pub(super) fn magnification(reach: f64, largest: f64) -> f64 {
    // An exact part has nothing to magnify; a factor of a few million is already more than any scatter needs.
    let wanted = (reach / largest.max(reach * 1e-7 / 0.3)).max(1.0);
    round_down(wanted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factor_is_round_and_keeps_deviations_in_sight() {
        for (radius, largest, expected) in
            [(12.5, 0.01, 200.0), (12.5, 0.0075, 500.0), (12.5, 3.0, 1.0), (12.5, 0.0, 2e6), (12.5, 20.0, 1.0)]
        {
            let factor = magnification(0.3 * radius, largest);
            assert!((factor - expected).abs() < expected * 1e-9, "{radius} {largest}");
        }
    }
}
