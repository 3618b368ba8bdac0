//! The small picture of a cycle: what it measures, seen from above, and the ball beside it.

use eframe::egui::{Painter, Pos2, Rect, Vec2, pos2, vec2};

use super::canvas::Canvas;
use crate::gui::theme::Palette;
use crate::probing::cycle::Cycle;
use crate::probing::simulated::Shape;

/// Parts of the height: the half of what is measured, and the radius of the ball.
const HALF: f32 = 0.3;
const BALL: f32 = 0.11;

/// Paints it; who draws the tile says in words what it is.
pub(in crate::gui) fn tile_picture(painter: &Painter, palette: &Palette, rect: Rect, cycle: &Cycle) {
    let canvas = Canvas::new(painter, palette, rect);
    let rect = rect.shrink(2.0);
    let (centre, half, ball) = (rect.center(), rect.height() * HALF, rect.height() * BALL);
    let block = |half: Vec2| Rect::from_center_size(centre, half * 2.0);
    let void = |rect: Rect| {
        canvas.block(rect.shrink2(vec2(rect.width() * 0.1, 0.0)));
    };
    let hollow = |half: Vec2| {
        painter.rect(block(half), 1.0, palette.surface.0, canvas.edge(), eframe::egui::StrokeKind::Middle);
    };
    let inside = |half: f32| canvas.ball(centre + vec2(half - ball, 0.0), ball);
    let outside = |half: f32| canvas.ball(centre + vec2(half + ball, 0.0), ball);
    match cycle.shape() {
        Shape::Hole => {
            void(rect);
            canvas.circle(centre, half, palette.surface.0, canvas.edge());
            inside(half);
        }
        Shape::Stud => {
            canvas.circle(centre, half, palette.none.0, canvas.edge());
            outside(half);
        }
        Shape::Pocket => {
            void(rect);
            hollow(vec2(half * 1.05, half));
            inside(half * 1.05);
        }
        Shape::Boss => {
            canvas.block(block(vec2(half * 1.05, half)));
            outside(half * 1.05);
        }
        Shape::Slot => {
            void(rect);
            let gap = Rect::from_center_size(centre, vec2(half * 1.4, rect.height()));
            painter.rect_filled(gap.expand2(vec2(0.0, 1.0)), 0.0, palette.surface.0);
            canvas.line(gap.left_top(), gap.left_bottom(), canvas.edge());
            canvas.line(gap.right_top(), gap.right_bottom(), canvas.edge());
            inside(half * 0.7);
        }
        Shape::Ridge => {
            canvas.block(Rect::from_center_size(centre, vec2(half * 1.2, rect.height())));
            outside(half * 0.6);
        }
        Shape::Face => {
            let face =
                Rect::from_min_max(rect.left_top() + vec2(rect.width() * 0.1, 0.0), pos2(centre.x, rect.bottom()));
            canvas.block(face);
            outside(0.0);
        }
        Shape::Point => point(&canvas, rect, ball),
    }
}

/// A curved surface, and the ball along its normal.
fn point(canvas: &Canvas<'_>, rect: Rect, ball: f32) {
    let radius = rect.height();
    let middle: Pos2 = pos2(rect.center().x, rect.bottom() + radius * 0.45);
    canvas.circle(middle, radius, canvas.palette.none.0, canvas.edge());
    let along = vec2(0.5, -0.866);
    let touch = middle + along * (radius + ball);
    canvas.ball(touch, ball);
}
