//! Parameters whose declaration gives no more than their range: a length, an angle, a number.

use eframe::egui::{Align2, pos2, vec2};

use super::canvas::{BESIDE, Canvas, polar};
use crate::probing::cycle::Meaning;

pub(super) fn draw(canvas: &Canvas<'_>, meaning: Meaning, key: &str) {
    match meaning {
        Meaning::Angle => angle(canvas, key),
        Meaning::Number | Meaning::TableRow => number(canvas, key),
        _ => length(canvas, key),
    }
}

fn length(canvas: &Canvas<'_>, key: &str) {
    let left = canvas.at(40.0, 0.0).x;
    let right = canvas.at(220.0, 0.0).x;
    let y = canvas.at(0.0, 80.0).y;
    for x in [left, right] {
        canvas.line(pos2(x, y - 34.0), pos2(x, y + 34.0), canvas.edge());
    }
    canvas.dimension(pos2(left, y), pos2(right, y));
    canvas.key(pos2(f32::midpoint(left, right), y), Align2::CENTER_CENTER, key);
}

fn angle(canvas: &Canvas<'_>, key: &str) {
    let centre = canvas.at(84.0, 126.0);
    canvas.line(centre, polar(centre, 130.0, 0.0), canvas.edge());
    canvas.line(centre, polar(centre, 130.0, 50.0), canvas.edge());
    canvas.arc_arrow(centre, 84.0, [0.0, 50.0], canvas.strong());
    canvas.key(polar(centre, 84.0 + BESIDE, 25.0), Align2::LEFT_CENTER, key);
}

fn number(canvas: &Canvas<'_>, key: &str) {
    let left = canvas.at(30.0, 0.0).x;
    let right = canvas.at(230.0, 0.0).x;
    let y = canvas.at(0.0, 92.0).y;
    canvas.arrow(pos2(left, y), pos2(right, y), canvas.edge());
    let zero = f32::midpoint(left, right);
    canvas.line(pos2(zero, y - 6.0), pos2(zero, y + 6.0), canvas.edge());
    canvas.note(pos2(zero, y + 8.0), Align2::CENTER_TOP, "0");
    let mark = pos2(zero + 50.0, y);
    canvas.arrow(mark - vec2(0.0, 30.0), mark - vec2(0.0, 3.0), canvas.strong());
    canvas.key(mark - vec2(0.0, 34.0), Align2::CENTER_BOTTOM, key);
}
