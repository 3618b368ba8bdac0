//! What lies in what: which holes, slots and pockets are cut out of which bodies and faces.

use super::super::{FARTHEST, Surface, Walls};
use super::PartFeature;
use crate::probing::cycle::Plane;
use crate::tolerance::Feature;

/// Heights this close are the same, mm.
const SAME: f64 = 1e-6;

/// The features of a part, and how they lie in one another.
#[derive(Debug, Clone)]
pub(in super::super) struct Space {
    features: Vec<PartFeature>,
    /// For each feature, the spaces that may cut it.
    cutting: Vec<Vec<usize>>,
    /// For each space, the spaces that run into it.
    crossing: Vec<Vec<usize>>,
}

impl Space {
    pub(in super::super) fn of(features: Vec<PartFeature>) -> Self {
        let numbers = |wanted: &dyn Fn(&PartFeature) -> bool| -> Vec<usize> {
            (0..).zip(&features).filter(|(_, feature)| wanted(feature)).map(|(number, _)| number).collect()
        };
        let is_cut = |feature: &PartFeature, by: &PartFeature| match feature.walls() {
            Some(Feature::Hole) => floor_is_cut(feature, by),
            Some(Feature::Shaft) | None => by.is_space() && !stands_in(feature, by) && overlap(feature, by),
        };
        let cutting = features.iter().map(|feature| numbers(&|by| is_cut(feature, by))).collect();
        let crossing = (0..).zip(&features).map(|(own, feature): (usize, _)| {
            let mut crossing = numbers(&|other| cross(feature, other));
            crossing.retain(|number| *number != own);
            crossing
        });
        let crossing = crossing.collect();
        Self { features, cutting, crossing }
    }

    /// The features by their numbers.
    pub(super) fn features(&self) -> impl Iterator<Item = (usize, &PartFeature)> {
        (0..).zip(&self.features)
    }

    pub(super) fn feature(&self, number: usize) -> Option<&PartFeature> {
        self.features.get(number)
    }

    /// The name of a feature.
    pub(in super::super) fn name(&self, number: usize) -> &str {
        self.feature(number).map_or("", |feature| &feature.name)
    }

    /// The scatter of a feature's surface.
    pub(in super::super) fn scatter(&self, number: usize) -> f64 {
        self.feature(number).map_or(0.0, |feature| feature.surface.scatter())
    }

    /// The only feature, if it has no end: the whole workpiece of a file without `[[feature]]`.
    pub(in super::super) fn only(&self) -> Option<&PartFeature> {
        let [only] = self.features.as_slice() else { return None };
        (only.name.is_empty() && only.extent.is_endless()).then_some(only)
    }

    fn among<'a>(&'a self, lists: &'a [Vec<usize>], number: usize) -> impl Iterator<Item = &'a PartFeature> {
        lists.get(number).into_iter().flatten().filter_map(|other| self.feature(*other))
    }

    /// The spaces that may cut a feature.
    pub(super) fn cutting(&self, number: usize) -> impl Iterator<Item = &PartFeature> {
        self.among(&self.cutting, number)
    }

    /// The spaces that run into a space.
    pub(super) fn crossing(&self, number: usize) -> impl Iterator<Item = &PartFeature> {
        self.among(&self.crossing, number)
    }

    /// Whether two spaces run into one another.
    pub(super) fn do_cross(&self, one: usize, other: usize) -> bool {
        self.crossing.get(one).is_some_and(|crossing| crossing.contains(&other))
    }

    /// How far the centre of a ball, or a place on its stylus, is from what is left of a feature's material.
    ///
    /// Over a space that is cut out, the nearest material of the feature is the rim of that space, which is the space's
    /// own: the feature itself is infinitely far away there.
    pub(super) fn gap(&self, number: usize, place: [f64; 3]) -> f64 {
        let Some(feature) = self.feature(number) else { return f64::INFINITY };
        let is_cut = || self.cutting(number).any(|by| cuts(by, feature, place));
        if feature.is_space() {
            let floor = feature.gap_to_floor(place);
            let walls = feature.gap_to_material(place);
            return if floor < walls && is_cut() { walls } else { walls.min(floor) };
        }
        if is_cut() { f64::INFINITY } else { feature.gap_to_material(place) }
    }
}

/// Whether a space has taken away the material of a feature at a place.
fn cuts(by: &PartFeature, feature: &PartFeature, place: [f64; 3]) -> bool {
    if !by.is_in_column(place) {
        return false;
    }
    let (flat, _) = by.within(place);
    let is_open = |top: f64| top <= by.extent.top + SAME;
    match (feature.walls(), feature.height_above(flat)) {
        (Some(Feature::Hole), _) => true,
        (Some(Feature::Shaft), _) => {
            let is_same_plane = feature.surface.plane() == by.surface.plane();
            (is_same_plane && is_open(feature.extent.top)) || by.is_around(place)
        }
        (None, Some(height)) if by.surface.plane() == Plane::Xy => is_open(height) || by.is_around(place),
        (None, _) => by.is_around(place),
    }
}

/// Whether a space takes away the floor of another: it begins there.
fn floor_is_cut(feature: &PartFeature, by: &PartFeature) -> bool {
    let floor = feature.extent.bottom;
    let passes = floor <= by.extent.top + SAME && by.extent.bottom < floor - SAME;
    by.is_space() && feature.surface.plane() == by.surface.plane() && passes
}

/// Whether two spaces have a place in common.
fn cross(one: &PartFeature, other: &PartFeature) -> bool {
    let heights = &one.extent;
    let others = &other.extent;
    let is_one_above = heights.top.min(others.top) <= heights.bottom.max(others.bottom) + SAME;
    // Where their axes differ, that is not looked into.
    let is_same_plane = one.surface.plane() == other.surface.plane();
    one.is_space() && other.is_space() && is_same_plane && !is_one_above && overlap(one, other)
}

/// Whether two contours have a place in common, seen along the axis of their planes; also where that is not known.
fn overlap(one: &PartFeature, other: &PartFeature) -> bool {
    if one.surface.plane() != other.surface.plane() {
        return true;
    }
    match (&one.surface, &other.surface) {
        (Surface::Face(_) | Surface::Point(_), _) => match one.disc() {
            Some((centre, reach)) => other.outside(centre) < reach,
            None => true,
        },
        (Surface::Round(round, _), Surface::Round(second, _)) => {
            let [[x, y], [other_x, other_y]] = [round.centre, second.centre];
            libm::hypot(x - other_x, y - other_y) < round.widest() + second.widest()
        }
        (Surface::Round(round, _), Surface::Walls(_)) => other.outside(round.centre) < round.widest(),
        (Surface::Walls(_), Surface::Round(round, _)) => one.outside(round.centre) < round.widest(),
        (Surface::Walls(walls), Surface::Walls(second)) => {
            let others = corners(second, other.extent.length);
            let corners = corners(walls, one.extent.length);
            ![*walls, *second].iter().any(|walls| parts(walls, corners, others))
        }
        (_, Surface::Face(_) | Surface::Point(_)) => true,
    }
}

fn corners(walls: &Walls, length: f64) -> [[f64; 2]; 4] {
    walls.corners((length / 2.0).min(FARTHEST))
}

/// Whether a line along one of the walls lies between two rectangles.
fn parts(walls: &Walls, one: [[f64; 2]; 4], other: [[f64; 2]; 4]) -> bool {
    let [cos, sin] = walls.across();
    [[cos, sin], [-sin, cos]].into_iter().any(|[along_x, along_y]| {
        let range = |corners: [[f64; 2]; 4]| {
            let places = corners.map(|[x, y]| x * along_x + y * along_y);
            let least = f64::INFINITY;
            let most = f64::NEG_INFINITY;
            places.into_iter().fold((least, most), |(least, most), place| (least.min(place), most.max(place)))
        };
        let (from, to) = range(one);
        let (other_from, other_to) = range(other);
        to <= other_from + SAME || other_to <= from + SAME
    })
}

/// Whether a body, a face or a point lies wholly within a space, seen along their common axis.
fn stands_in(body: &PartFeature, space: &PartFeature) -> bool {
    if body.surface.plane() != space.surface.plane() {
        return false;
    }
    match &body.surface {
        Surface::Round(workpiece, _) => space.outside(workpiece.centre) <= -workpiece.widest(),
        Surface::Walls(walls) => {
            corners(walls, body.extent.length).into_iter().all(|corner| space.outside(corner) <= 0.0)
        }
        Surface::Face(_) | Surface::Point(_) => {
            body.disc().is_some_and(|(centre, reach)| space.outside(centre) <= -reach)
        }
    }
}
