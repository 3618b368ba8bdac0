//! Building blocks of the drawings: lines, arrows, dimensions, labels, the probe. The theme gives colours and fonts.
//!
//! Places are points from the upper left corner of the drawing, y downwards; angles are degrees counterclockwise from
//! the right, as an operator counts them.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2, pos2, vec2};

use crate::gui::shapes;
use crate::gui::theme::{self, Palette, sizes};

/// The width of the outlines of a workpiece.
pub(super) const EDGE: f32 = 1.5;

/// The width of highlighted lines.
const STRONG: f32 = 2.0;

/// The size of an arrowhead.
const HEAD: f32 = 9.0;

/// Between a place and the label beside it.
pub(super) const BESIDE: f32 = 7.0;

/// Where a drawing is painted.
pub(super) struct Canvas<'a> {
    pub(super) painter: Painter,
    pub(super) palette: &'a Palette,
    pub(super) rect: Rect,
}

impl<'a> Canvas<'a> {
    pub(super) fn new(painter: &Painter, palette: &'a Palette, rect: Rect) -> Self {
        Self { painter: painter.with_clip_rect(rect.intersect(painter.clip_rect())), palette, rect }
    }

    /// A place at an offset from the upper left corner.
    pub(super) fn at(&self, x: f32, y: f32) -> Pos2 {
        self.rect.min + vec2(x, y)
    }

    pub(super) fn edge(&self) -> Stroke {
        Stroke::new(EDGE, self.palette.text.0)
    }

    pub(super) fn thin(&self) -> Stroke {
        Stroke::new(1.0, self.palette.quiet.0)
    }

    pub(super) fn strong(&self) -> Stroke {
        Stroke::new(STRONG, self.palette.data.0)
    }

    pub(super) fn line(&self, from: Pos2, to: Pos2, stroke: Stroke) {
        self.painter.line_segment([from, to], stroke);
    }

    pub(super) fn polyline(&self, points: Vec<Pos2>, stroke: Stroke) {
        self.painter.add(PathShape::line(points, stroke));
    }

    pub(super) fn dashed(&self, points: &[Pos2], stroke: Stroke, dash: f32, gap: f32) {
        self.painter.extend(Shape::dashed_line(points, stroke, dash, gap));
    }

    pub(super) fn circle(&self, centre: Pos2, radius: f32, fill: Color32, stroke: Stroke) {
        self.painter.circle(centre, radius, fill, stroke);
    }

    /// A dashed circle.
    pub(super) fn ring(&self, centre: Pos2, radius: f32, stroke: Stroke) {
        self.dashed(&arc(centre, radius, 0.0, 360.0), stroke, 5.0, 4.0);
    }

    /// A centre: two short lines.
    pub(super) fn cross(&self, at: Pos2, size: f32, stroke: Stroke) {
        self.line(at - vec2(size, 0.0), at + vec2(size, 0.0), stroke);
        self.line(at - vec2(0.0, size), at + vec2(0.0, size), stroke);
    }

    /// An arrowhead with its tip at a place.
    pub(super) fn head(&self, tip: Pos2, direction: Vec2, colour: Color32) {
        shapes::arrow_head(&self.painter, tip - direction.normalized() * HEAD * 0.6, direction, HEAD, colour);
    }

    pub(super) fn arrow(&self, from: Pos2, to: Pos2, stroke: Stroke) {
        let direction = to - from;
        if direction.length() < 1.0 {
            return;
        }
        self.line(from, to - direction.normalized() * HEAD * 0.6, stroke);
        self.head(to, direction, stroke.color);
    }

    pub(super) fn arc_arrow(&self, centre: Pos2, radius: f32, [from, to]: [f32; 2], stroke: Stroke) {
        self.polyline(arc(centre, radius, from, to), stroke);
        let turn = if from < to { 90.0 } else { -90.0 };
        self.head(polar(centre, radius, to), polar(Pos2::ZERO, 1.0, to + turn).to_vec2(), stroke.color);
    }

    /// A dimension between two places; arrowheads inside, or outside where there is no room.
    pub(super) fn dimension(&self, from: Pos2, to: Pos2) {
        let stroke = self.strong();
        let along = to - from;
        if along.length() < 2.6 * HEAD {
            let outwards = along.normalized() * 2.0 * HEAD;
            self.arrow(from - outwards, from, stroke);
            self.arrow(to + outwards, to, stroke);
            self.line(from, to, Stroke::new(1.0, stroke.color));
        } else {
            let middle = from + along / 2.0;
            self.arrow(middle, from, stroke);
            self.arrow(middle, to, stroke);
        }
    }

    /// The key of what is highlighted.
    pub(super) fn key(&self, at: Pos2, anchor: Align2, text: &str) {
        self.label(at, anchor, text, theme::bold(sizes().body), self.palette.data.0);
    }

    /// A word or a number beside something, in light type and without a background.
    pub(super) fn note(&self, at: Pos2, anchor: Align2, text: &str) {
        self.painter.text(at, anchor, text, theme::font(sizes().small), self.palette.quiet.0);
    }

    /// A note in as many lines as it needs.
    pub(super) fn wrapped(&self, at: Pos2, text: &str, width: f32) {
        let font = theme::font(sizes().small);
        let colour = self.palette.text.0;
        let galley = self.painter.layout(text.to_owned(), font, colour, width);
        self.painter.galley(at, galley, colour);
    }

    /// A note with a background, where lines or material are behind it.
    pub(super) fn note_on_ground(&self, at: Pos2, anchor: Align2, text: &str) {
        self.label(at, anchor, text, theme::font(sizes().small), self.palette.quiet.0);
    }

    /// Text on a background, so that lines do not cross it, kept within the drawing.
    pub(super) fn label(&self, at: Pos2, anchor: Align2, text: &str, font: FontId, colour: Color32) -> Rect {
        let galley = self.painter.layout_no_wrap(text.to_owned(), font, colour);
        let rect = anchor.anchor_size(at, galley.size());
        let aside = (self.rect.left() - rect.left()).max(0.0) - (rect.right() - self.rect.right()).max(0.0);
        let shift = (self.rect.top() - rect.top()).max(0.0) - (rect.bottom() - self.rect.bottom()).max(0.0);
        let rect = rect.translate(vec2(aside, shift));
        self.painter.rect_filled(rect.expand2(vec2(2.0, -1.0)), 2.0, self.palette.surface.0);
        self.painter.galley(rect.min, galley, colour);
        rect
    }

    /// Material seen from above.
    pub(super) fn block(&self, rect: Rect) {
        self.painter.rect(rect, 2.0, self.palette.none.0, self.edge(), StrokeKind::Middle);
    }

    /// Material in section.
    pub(super) fn cut(&self, rect: Rect) {
        self.painter.rect_filled(rect, 0.0, self.palette.none.0);
        shapes::hatch(&self.painter, rect, shapes::Hatch::Single, Stroke::new(1.0, self.palette.line.0));
        self.painter.rect_stroke(rect, 0.0, self.edge(), StrokeKind::Middle);
    }

    /// The ball, and its stylus upwards out of the drawing.
    pub(super) fn probe(&self, ball: Pos2, radius: f32) {
        self.line(ball - vec2(0.0, radius), pos2(ball.x, self.rect.top()), Stroke::new(3.0, self.palette.quiet.0));
        self.ball(ball, radius);
    }

    pub(super) fn ball(&self, ball: Pos2, radius: f32) {
        self.circle(ball, radius, self.palette.surface.0, self.edge());
        self.circle(ball, 1.5, self.palette.text.0, Stroke::NONE);
    }

    /// Where a ball was or will be.
    pub(super) fn ghost(&self, ball: Pos2, radius: f32) {
        self.dashed(&arc(ball, radius, 0.0, 360.0), self.thin(), 3.0, 3.0);
    }

    pub(super) fn contact(&self, at: Pos2, colour: Color32) {
        self.circle(at, 4.0, colour, Stroke::new(1.0, self.palette.surface.0));
    }
}

/// A place at a distance from a centre in a direction.
pub(super) fn polar(centre: Pos2, radius: f32, degrees: f32) -> Pos2 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    centre + vec2(cos, -sin) * radius
}

/// Points of an arc.
pub(super) fn arc(centre: Pos2, radius: f32, from: f32, to: f32) -> Vec<Pos2> {
    const STEPS: u8 = 72;
    (0..=STEPS).map(|step| polar(centre, radius, from + (to - from) * f32::from(step) / f32::from(STEPS))).collect()
}
