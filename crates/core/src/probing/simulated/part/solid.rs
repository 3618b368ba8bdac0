//! How far a ball, or the stylus above it, is from the material of one feature: closed forms, one for each shape.
//!
//! Waves and lobes count: the nearest point of a wavy contour is searched for, as for a probing. Only the floor below
//! a lobed hole and a wavy face with a reach are taken at their mean form.

use super::super::{Face, FreePoint, Surface, Walls};
use super::PartFeature;
use crate::probing::cycle::Plane;
use crate::probing::vector::{along, dot, norm, unit};
use crate::tolerance::Feature;

/// The distance of a place beside two edges: from the corner if it is beyond both, else from the farther edge.
fn beyond_both(one: f64, other: f64) -> f64 {
    if 0.0 < one && 0.0 < other { libm::hypot(one, other) } else { one.max(other) }
}

impl PartFeature {
    /// The feature that its walls make; `None` for faces and points.
    pub(super) const fn walls(&self) -> Option<Feature> {
        match &self.surface {
            Surface::Round(workpiece, _) => Some(workpiece.feature),
            Surface::Walls(walls) => Some(walls.feature),
            Surface::Face(_) | Surface::Point(_) => None,
        }
    }

    /// Whether it is a hole, slot or pocket.
    pub(super) fn is_space(&self) -> bool {
        self.walls() == Some(Feature::Hole)
    }

    /// A place in the plane of the feature, and its height above it.
    pub(super) const fn within(&self, place: [f64; 3]) -> ([f64; 2], f64) {
        let [first, second, height] = self.surface.plane().within(place);
        ([first, second], height)
    }

    /// How far a place of the plane lies outside the contour; below zero inside.
    pub(super) fn outside(&self, place: [f64; 2]) -> f64 {
        match &self.surface {
            Surface::Round(workpiece, _) => workpiece.outside(place),
            Surface::Walls(walls) => {
                let [one, other] = walls.outside(place, self.extent.length);
                beyond_both(one, other)
            }
            Surface::Face(_) | Surface::Point(_) => f64::INFINITY,
        }
    }

    /// How far a place of the plane is from the walls, on whichever side.
    fn gap_to_walls(&self, place: [f64; 2]) -> f64 {
        match &self.surface {
            // The ends of a slot are open.
            Surface::Walls(walls @ Walls { lengths: (_, None), .. }) => {
                let [across, beside] = walls.outside(place, self.extent.length);
                libm::hypot(across.abs(), beside.max(0.0))
            }
            _ => self.outside(place).abs(),
        }
    }

    /// Whether a place lies in the space of a hole, slot or pocket, or above it.
    pub(super) fn is_in_column(&self, place: [f64; 3]) -> bool {
        let (flat, height) = self.within(place);
        self.is_space() && self.extent.bottom <= height && self.outside(flat) < 0.0
    }

    /// Whether a place lies in the space of a hole, slot or pocket.
    pub(super) fn is_around(&self, place: [f64; 3]) -> bool {
        let (_, height) = self.within(place);
        height <= self.extent.top && self.is_in_column(place)
    }

    /// How far a place is from the floor of a space; infinite where it has none.
    pub(super) fn gap_to_floor(&self, place: [f64; 3]) -> f64 {
        let (flat, height) = self.within(place);
        if !self.is_space() || self.extent.bottom.is_infinite() {
            return f64::INFINITY;
        }
        libm::hypot(self.outside(flat).max(0.0), height - self.extent.bottom)
    }

    /// How far a place is from the material, the floor of a space left out; below zero in the material.
    pub(super) fn gap_to_material(&self, place: [f64; 3]) -> f64 {
        let (flat, height) = self.within(place);
        let beyond = self.extent.beyond(height);
        match (&self.surface, self.walls()) {
            (_, Some(Feature::Hole)) => libm::hypot(self.gap_to_walls(flat), beyond.max(0.0)),
            (_, Some(Feature::Shaft)) => beyond_both(self.outside(flat), beyond),
            (Surface::Face(face), _) if self.extent.reach.is_infinite() => face.gap(place, 0.0),
            (Surface::Point(point), _) if self.extent.reach.is_infinite() => point.gap(place, 0.0),
            (Surface::Face(Face { point, normal, .. }), _) => self.gap_to_disc(*point, *normal, place),
            (Surface::Point(point), _) => self.gap_to_cap(point, place),
            (Surface::Round(..) | Surface::Walls(_), None) => f64::INFINITY,
        }
    }

    fn gap_to_disc(&self, point: [f64; 3], normal: [f64; 3], place: [f64; 3]) -> f64 {
        let [height, beside] = over(point, unit(normal), place);
        libm::hypot(height.abs(), (beside - self.extent.reach).max(0.0))
    }

    /// From the cap of a ball, or a hollow, about its point.
    fn gap_to_cap(&self, point: &FreePoint, place: [f64; 3]) -> f64 {
        let Some(radius) = point.radius else { return self.gap_to_disc(point.real(), point.normal, place) };
        let normal = unit(point.normal);
        let centre = along(point.real(), normal, -radius);
        let [height, beside] = over(centre, normal, place);
        let height = height * radius.signum();
        let radius = radius.abs();
        let rim = self.extent.reach.min(radius);
        let rim_height = ((radius - rim) * (radius + rim)).sqrt();
        // Within the cone to the rim the ball itself is nearest.
        if 0.0 <= height && beside * rim_height <= rim * height {
            return (libm::hypot(height, beside) - radius).abs();
        }
        libm::hypot(height - rim_height, beside - rim)
    }

    /// The place on the stylus above a ball that is nearest to the material: the stylus is a line upwards in Z.
    ///
    /// `None` where it has no closed form: walls of another plane, faces and points that look down, slanted ones with a
    /// reach, hollows.
    pub(super) fn nearest_on_stylus(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        let [x, y, z] = place;
        let no_lower_than = |height: f64| [x, y, z.max(height)];
        match &self.surface {
            Surface::Round(_, Plane::Xy) | Surface::Walls(_) => Some(no_lower_than(self.extent.bottom)),
            Surface::Round(..) => None,
            Surface::Face(Face { point, normal, .. }) => self.on_stylus_over(*point, *normal, place),
            Surface::Point(point @ FreePoint { radius: None, .. }) => {
                self.on_stylus_over(point.real(), point.normal, place)
            }
            Surface::Point(point @ FreePoint { radius: Some(radius), .. }) => {
                let [_, _, height] = along(point.real(), unit(point.normal), -radius);
                (0.0 < *radius && self.extent.reach.is_infinite()).then(|| no_lower_than(height))
            }
        }
    }

    fn on_stylus_over(&self, [_, _, height]: [f64; 3], normal: [f64; 3], place: [f64; 3]) -> Option<[f64; 3]> {
        let [x, y, z] = place;
        let [_, _, up] = unit(normal);
        match (self.extent.reach.is_infinite(), up) {
            (true, up) => (0.0 <= up).then_some(place),
            (false, up) => (up.abs() <= 0.0 || 1.0 <= up.abs()).then(|| [x, y, z.max(height)]),
        }
    }

    /// The place in X/Y of a face or point with a reach, and that reach.
    pub(super) fn disc(&self) -> Option<([f64; 2], f64)> {
        let [x, y, _] = match &self.surface {
            Surface::Face(face) => face.point,
            Surface::Point(point) => point.real(),
            Surface::Round(..) | Surface::Walls(_) => return None,
        };
        self.extent.reach.is_finite().then_some(([x, y], self.extent.reach))
    }

    /// The height of the face above a place of X/Y; `None` for what does not look up.
    pub(super) fn height_above(&self, [x, y]: [f64; 2]) -> Option<f64> {
        let (point, normal) = match &self.surface {
            Surface::Face(Face { point, normal, .. }) => (*point, *normal),
            Surface::Point(point) => (point.real(), point.normal),
            Surface::Round(..) | Surface::Walls(_) => return None,
        };
        let [point_x, point_y, point_z] = point;
        let [normal_x, normal_y, up] = unit(normal);
        (0.0 < up).then(|| point_z - ((x - point_x) * normal_x + (y - point_y) * normal_y) / up)
    }

    /// Whether the foot of a ball's centre lies on a face or point, and not beyond its reach.
    pub(super) fn is_over(&self, centre: [f64; 3]) -> bool {
        let (point, normal) = match &self.surface {
            Surface::Face(face) => (face.point, face.normal),
            Surface::Point(point) => (point.real(), point.normal),
            Surface::Round(..) | Surface::Walls(_) => return false,
        };
        let radius = if let Surface::Point(point) = &self.surface { point.radius } else { None };
        let normal = unit(normal);
        let [height, beside] = over(point, normal, centre);
        // On a ball the foot lies on the line to its centre.
        let foot = radius.map_or(beside, |radius| radius.abs() * beside / libm::hypot(beside, radius + height));
        foot <= self.extent.reach
    }
}

/// A place seen from a point with a normal: how high above it, and how far beside it.
fn over(point: [f64; 3], normal: [f64; 3], place: [f64; 3]) -> [f64; 2] {
    let off = along(place, point, -1.0);
    let height = dot(off, normal);
    [height, norm(along(off, normal, -height))]
}
