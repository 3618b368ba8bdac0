//! Outlines: rectangles with round corners, and those of verdicts.

use krilla::geom::{Path, PathBuilder};

use super::sheet::{Area, Place};
use super::signs::Outline;

/// A rectangle with round corners.
pub(super) fn block(area: Area, radius: f32) -> Option<Path> {
    let rect = area.rect()?;
    let mut builder = PathBuilder::new();
    if radius <= 0.0 {
        builder.push_rect(rect);
        return builder.finish();
    }
    let [left, top, right, bottom] = [rect.left(), rect.top(), rect.right(), rect.bottom()];
    let r = radius.min(area.width / 2.0).min(area.height / 2.0);
    // Where the handles of a quarter of a circle are.
    let k = r * 0.447_715;
    builder.move_to(left + r, top);
    builder.line_to(right - r, top);
    builder.cubic_to(right - k, top, right, top + k, right, top + r);
    builder.line_to(right, bottom - r);
    builder.cubic_to(right, bottom - k, right - k, bottom, right - r, bottom);
    builder.line_to(left + r, bottom);
    builder.cubic_to(left + k, bottom, left, bottom - k, left, bottom - r);
    builder.line_to(left, top + r);
    builder.cubic_to(left, top + k, left + k, top, left + r, top);
    builder.close();
    builder.finish()
}

/// The outline of a verdict.
pub(super) fn outline_path(outline: Outline, [x, y]: Place, radius: f32) -> Option<Path> {
    match outline {
        Outline::Circle => return block(Area::new(x - radius, y - radius, 2.0 * radius, 2.0 * radius), radius),
        Outline::Square => {
            let side = radius * 0.94;
            return block(Area::new(x - side, y - side, 2.0 * side, 2.0 * side), radius * 0.25);
        }
        Outline::Diamond | Outline::Hexagon | Outline::Triangle => {}
    }
    let mut builder = PathBuilder::new();
    for (number, [dx, dy]) in outline.corners().iter().enumerate() {
        let [to_x, to_y] = [x + dx * radius, y + dy * radius];
        if number == 0 {
            builder.move_to(to_x, to_y);
        } else {
            builder.line_to(to_x, to_y);
        }
    }
    builder.close();
    builder.finish()
}
