//! The features of a simulated part in a view of the path: bodies as material, spaces with a rim of it, faces and points
//! as lines or discs, each with its name.
//!
//! Seen along their axis they have their outline; from the side they are boxes from top to bottom, and those of spaces are
//! dashed, as edges are that lie hidden.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Color32, Pos2, Rect, Stroke, Vec2, vec2};

use super::canvas::Canvas;
use super::path::Eye;
use super::scale::Scale;
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

/// The lowest and the highest X, Y and Z of a feature, mm; infinite where it has no end.
fn ends(feature: &PartFeature) -> [[f64; 3]; 2] {
    let PartFeature { surface, extent, .. } = feature;
    let walls = |[[low_1, high_1], [low_2, high_2]]: [[f64; 2]; 2]| {
        [[low_1, low_2, extent.bottom], [high_1, high_2, extent.top]].map(|end| surface.plane().place(end))
    };
    match surface.outline(extent.length / 2.0) {
        Outline::Circle { centre, radius } => walls(centre.map(|middle| [middle - radius, middle + radius])),
        Outline::Walls(corners) => {
            let range = |places: [f64; 4]| {
                [places.into_iter().fold(f64::INFINITY, f64::min), places.into_iter().fold(f64::NEG_INFINITY, f64::max)]
            };
            walls([range(corners.map(|[first, _]| first)), range(corners.map(|[_, second]| second))])
        }
        Outline::Face { point: [x, y, z], normal } => {
            let reach = if extent.reach.is_finite() { extent.reach } else { 0.0 };
            let length = normal.iter().map(|part| part * part).sum::<f64>().sqrt();
            let half = normal.map(|part| reach * (1.0 - (part / length).powi(2)).max(0.0).sqrt());
            let [half_x, half_y, half_z] = half;
            [[x - half_x, y - half_y, z - half_z], [x + half_x, y + half_y, z + half_z]]
        }
    }
}

/// The corners of a feature in a view, as far as it has ends there.
pub(super) fn places(feature: &PartFeature, eye: Eye) -> Vec<[f64; 2]> {
    let [[low_across, low_up], [high_across, high_up]] = ends(feature).map(|end| eye.see(end));
    let across = [low_across, high_across].into_iter().filter(|end| end.is_finite());
    let up = || [low_up, high_up].into_iter().filter(|end| end.is_finite());
    across.flat_map(|across| up().map(move |up| [across, up])).collect()
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
    let (plane, eye) = (surface.plane(), scale.eye());
    let is_along = plane == plane_of(eye);
    let place = |[first, second]: [f64; 2]| scale.at(eye.see(plane.place([first, second, 0.0])));
    match surface.outline((extent.length / 2.0).min(scale.reach())) {
        Outline::Circle { centre, radius } if is_along => FeatureOutline::Circle(place(centre), scale.length(radius)),
        Outline::Walls(corners) if is_along => FeatureOutline::Corners(corners.map(place)),
        Outline::Circle { .. } | Outline::Walls(_) => {
            let [low, high] = ends(feature).map(|end| scale.at(eye.see(end)));
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
    let fill = canvas.palette.panel.0;
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
