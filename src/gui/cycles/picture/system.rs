//! The zero and the axes that a program counts in, in a view of the path.

use eframe::egui::{Align2, Stroke, vec2};

use super::canvas::Canvas;
use super::scale::Scale;
use super::way::Way;
use crate::gui::shapes::screen;

/// How long an axis is, points.
const AXIS: f32 = 26.0;

/// The zero and the axes that a program counts in, as far as they are in the view; an axis that points at the viewer is left out.
pub(super) fn draw(canvas: &Canvas<'_>, scale: &Scale, way: &Way<'_>) {
    let Some((zero, axes)) = way.system else { return };
    let canvas = Canvas::new(&canvas.painter, canvas.palette, scale.rect());
    let plane = way.plane();
    let at = scale.at(scale.eye().see(plane.within(zero)));
    if !scale.room().contains(at) {
        return;
    }
    let stroke = Stroke::new(1.5, canvas.palette.text.0);
    for (name, axis) in ["X", "Y", "Z"].into_iter().zip(axes) {
        let [right, up] = scale.eye().see(plane.within(axis));
        let along = vec2(screen(right), -screen(up));
        if along.length() < 0.2 {
            continue;
        }
        canvas.arrow(at, at + along * AXIS, stroke);
        // Beside its tip: the name of what stands on the zero is beyond it.
        let aside = vec2(-along.y, along.x) * 9.0;
        canvas.note_on_ground(at + along * (AXIS - 4.0) + aside, Align2::CENTER_CENTER, name);
    }
    canvas.circle(at, 3.5, canvas.palette.surface.0, stroke);
}
