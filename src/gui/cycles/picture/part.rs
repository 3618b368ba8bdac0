//! The features of a simulated part in a view of the path: bodies as material, spaces with a rim of it, faces and points
//! as lines or discs, each with its name.
//!
//! Seen along their axis they have their outline; from the side they are boxes from top to bottom, and those of spaces are
//! dashed, as edges are that lie hidden.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Color32, Pos2, Rect, Stroke, Vec2, vec2};

use super::canvas::Canvas;
use super::scale::Scale;
use super::way::{Eye, part_ends};
use crate::gui::shapes::screen;
use crate::probing::cycle::Plane;
use crate::probing::simulated::{Outline, PartFeature, Shape};

/// The width of the rim of material about a space, points.
const RIM: f32 = 6.0;

/// The most names that can be told apart.
const MOST_NAMES: usize = 40;

/// How far a point without an end is drawn to either side, points.
const USUAL_REACH: f32 = 14.0;

/// A feature as it is seen.
enum FeatureOutline {
    /// Along its axis.
    Circle(Pos2, f32),
    /// Along its axis.
    Corners([Pos2; 4]),
    /// From the side.
    Box(Rect),
    /// A face or a point from in front: its disc; without an end, all that is seen.
    Disc(Pos2, Option<f32>),
    /// A face or a point from the side: the direction out of its material, and half its length.
    Line(Pos2, Vec2, f32),
}

/// The plane that a view looks onto.
const fn plane_of(eye: Eye) -> Plane {
    match eye {
        Eye::Above => Plane::Xy,
        Eye::Side => Plane::Zx,
        Eye::Front => Plane::Yz,
    }
}

fn seen(scale: &Scale, feature: &PartFeature) -> FeatureOutline {
    let PartFeature { surface, extent, .. } = feature;
    let plane = surface.plane();
    let eye = scale.eye();
    let is_along = plane == plane_of(eye);
    let place = |[first, second]: [f64; 2]| scale.at(eye.see(plane.place([first, second, 0.0])));
    match surface.outline((extent.length / 2.0).min(scale.reach())) {
        Outline::Circle { centre, radius } if is_along => FeatureOutline::Circle(place(centre), scale.length(radius)),
        Outline::Walls(corners) if is_along => FeatureOutline::Corners(corners.map(place)),
        Outline::Circle { .. } | Outline::Walls(_) => {
            let [low, high] = part_ends(feature).map(|end| scale.at(eye.see(end)));
            FeatureOutline::Box(Rect::from_two_pos(low, high).intersect(scale.rect().expand(RIM)))
        }
        Outline::Face { point, normal } => {
            let reach = extent.reach.is_finite().then(|| scale.length(extent.reach));
            let (point, [across, up]) = (scale.at(eye.see(point)), eye.see(normal));
            let largest = across.abs().max(up.abs());
            if largest < 1e-9 || largest.is_nan() {
                return FeatureOutline::Disc(
                    point,
                    reach.or_else(|| (surface.shape() != Shape::Face).then_some(USUAL_REACH)),
                );
            }
            let out = vec2(screen(across / largest), -screen(up / largest)).normalized();
            let endless = if surface.shape() == Shape::Face { scale.rect().size().length() } else { USUAL_REACH };
            FeatureOutline::Line(point, out, reach.unwrap_or(endless))
        }
    }
}

/// Draws the features: material first, then what is cut out of it, then faces and points, then names.
pub(super) fn draw(canvas: &Canvas<'_>, scale: &Scale, features: &[PartFeature]) {
    let seen: Vec<(&PartFeature, FeatureOutline)> =
        features.iter().map(|feature| (feature, seen(scale, feature))).collect();
    let is_body = |feature: &PartFeature| feature.surface.shape().is_outside();
    for (_, seen) in &seen {
        if let FeatureOutline::Disc(at, reach) = seen {
            disc(canvas, scale, *at, *reach);
        }
    }
    for (_, seen) in seen.iter().filter(|(feature, _)| is_body(feature)) {
        body(canvas, seen);
    }
    // A rim never covers the space beside it.
    for step in [rim, space_of] {
        seen.iter().filter(|(feature, _)| !is_body(feature)).for_each(|(_, seen)| step(canvas, seen));
    }
    for (_, seen) in &seen {
        if let FeatureOutline::Line(at, out, half) = seen {
            line(canvas, *at, *out, *half);
        }
    }
    if scale.eye() == Eye::Above && features.len() <= MOST_NAMES {
        for (feature, seen) in &seen {
            name(canvas, &feature.name, seen);
        }
    }
}

fn body(canvas: &Canvas<'_>, seen: &FeatureOutline) {
    let fill = canvas.palette.none.0;
    match seen {
        FeatureOutline::Circle(at, radius) => canvas.circle(*at, *radius, fill, canvas.edge()),
        FeatureOutline::Corners(corners) => polygon(canvas, corners, fill, canvas.edge()),
        FeatureOutline::Box(rect) if rect.is_positive() => canvas.cut(*rect),
        FeatureOutline::Box(_) | FeatureOutline::Disc(..) | FeatureOutline::Line(..) => {}
    }
}

/// The material about a space.
fn rim(canvas: &Canvas<'_>, seen: &FeatureOutline) {
    let material = canvas.palette.none.0;
    match seen {
        FeatureOutline::Circle(at, radius) => canvas.circle(*at, *radius + RIM, material, Stroke::NONE),
        // Half of the line lies within the space, which covers it.
        FeatureOutline::Corners(corners) => polygon(canvas, corners, material, Stroke::new(2.0 * RIM, material)),
        FeatureOutline::Box(_) | FeatureOutline::Disc(..) | FeatureOutline::Line(..) => {}
    }
}

fn space_of(canvas: &Canvas<'_>, seen: &FeatureOutline) {
    let fill = canvas.palette.surface.0;
    match seen {
        FeatureOutline::Circle(at, radius) => canvas.circle(*at, *radius, fill, canvas.edge()),
        FeatureOutline::Corners(corners) => polygon(canvas, corners, fill, canvas.edge()),
        FeatureOutline::Box(rect) if rect.is_positive() => {
            let corners = [rect.left_top(), rect.left_bottom(), rect.right_bottom(), rect.right_top()];
            canvas.dashed(&corners, canvas.thin(), 4.0, 3.0);
        }
        FeatureOutline::Box(_) | FeatureOutline::Disc(..) | FeatureOutline::Line(..) => {}
    }
}

fn polygon(canvas: &Canvas<'_>, corners: &[Pos2; 4], fill: Color32, stroke: Stroke) {
    canvas.painter.add(PathShape::convex_polygon(corners.to_vec(), fill, stroke));
}

fn disc(canvas: &Canvas<'_>, scale: &Scale, at: Pos2, reach: Option<f32>) {
    match reach {
        Some(reach) => {
            canvas.circle(at, reach, canvas.palette.none.0, Stroke::NONE);
            canvas.ring(at, reach, canvas.thin());
        }
        None => _ = canvas.painter.rect_filled(scale.rect(), 4.0, canvas.palette.none.0),
    }
    canvas.cross(at, 4.0, canvas.thin());
}

/// A face from the side, with short strokes into its material.
fn line(canvas: &Canvas<'_>, at: Pos2, out: Vec2, half: f32) {
    let along = vec2(-out.y, out.x);
    canvas.line(at - along * half, at + along * half, canvas.edge());
    let mut off = -half;
    while off <= half {
        let from = at + along * off;
        canvas.line(from, from - out * 5.0 + along * 5.0, canvas.thin());
        off += 7.0;
    }
}

/// The name above the outline.
fn name(canvas: &Canvas<'_>, name: &str, seen: &FeatureOutline) {
    let at = match seen {
        FeatureOutline::Circle(at, radius) => *at - vec2(0.0, radius + RIM),
        FeatureOutline::Corners(corners) => {
            let middle = corners.iter().fold(Vec2::ZERO, |sum, corner| sum + corner.to_vec2()) / 4.0;
            let top = corners.iter().map(|corner| corner.y).fold(f32::INFINITY, f32::min);
            Pos2::new(middle.x, top - RIM)
        }
        FeatureOutline::Box(rect) => rect.center_top(),
        FeatureOutline::Disc(at, reach) => *at - vec2(0.0, reach.unwrap_or(4.0)),
        FeatureOutline::Line(at, out, _) => *at + *out * 6.0 - vec2(0.0, 4.0),
    };
    canvas.note_on_ground(at, Align2::CENTER_BOTTOM, name);
}
