//! A path as it is drawn: its moves, and the direction that it is seen from.

use std::f64::consts::{PI, TAU};

use crate::probing::cycle::{Move, Phase, Plane};
use crate::probing::simulated::{Outline, PartFeature, Surface};

/// Points on an arc of the path.
const STEPS: u8 = 48;

/// The name of a phase's word.
pub(super) const fn phase_id(phase: Phase) -> &'static str {
    match phase {
        Phase::PrePosition => "cycle-picture-phase-pre-position",
        Phase::Approach => "cycle-picture-phase-approach",
        Phase::Contact => "cycle-picture-phase-contact",
        Phase::Retract => "cycle-picture-phase-retract",
        Phase::Leave => "cycle-picture-phase-leave",
    }
}

/// Where the ball is after this many moves.
pub(super) fn place(moves: &[Move], step: usize) -> Option<[f64; 3]> {
    match step.checked_sub(1).and_then(|last| moves.get(last)) {
        Some(last) => Some(last.to),
        None => moves.first().map(|first| first.from),
    }
}

/// A zero, mm, and the unit vectors of its axes.
pub(in crate::gui) type System = ([f64; 3], [[f64; 3]; 3]);

/// The path and what is shown with it.
pub(super) struct Way<'a> {
    pub(super) moves: &'a [Move],
    pub(super) step: usize,
    pub(super) nominal: Option<Surface>,
    pub(super) features: &'a [PartFeature],
    pub(super) ball_radius: f64,
    pub(super) system: Option<System>,
}

impl Way<'_> {
    pub(super) fn plane(&self) -> Plane {
        // A part has features in every plane.
        if !self.features.is_empty() {
            return Plane::Xy;
        }
        self.nominal.map_or(Plane::Xy, |surface| surface.plane())
    }

    /// Places of the path, in the coordinates of a view.
    pub(super) fn places(&self, eye: Eye) -> Vec<[f64; 2]> {
        self.moves.iter().flat_map(|one| trace(one, self.plane())).map(|place| eye.see(place)).collect()
    }

    /// The zero of the system, where it is no farther from these places than they reach.
    pub(super) fn zero_beside(&self, eye: Eye, places: &[[f64; 2]]) -> Option<[f64; 2]> {
        let (zero, _) = self.system?;
        let zero = eye.see(self.plane().within(zero));
        is_beside(places, zero).then_some(zero)
    }
}

/// Whether a place is no farther from others than these reach.
fn is_beside(places: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let ((left, right), (low, high)) = (ends(places, |[x, _]| *x), ends(places, |[_, y]| *y));
    let reach = (right - left).max(high - low);
    let is_in = |at: f64, least: f64, most: f64| least - reach <= at && at <= most + reach;
    reach.is_finite() && is_in(x, left, right) && is_in(y, low, high)
}

/// Between which values places lie along an axis.
pub(super) fn ends(places: &[[f64; 2]], axis: fn(&[f64; 2]) -> f64) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    places.iter().map(axis).fold(none, |(least, most), value| (least.min(value), most.max(value)))
}

/// The places of a move in plane coordinates: two ends, or the points of an arc the shorter way round.
pub(super) fn trace(one: &Move, plane: Plane) -> Vec<[f64; 3]> {
    let from = plane.within(one.from);
    let to = plane.within(one.to);
    let Some(about) = one.about.map(|about| plane.within(about)) else { return vec![from, to] };
    let about_centre = |[x, y, _]: [f64; 3]| {
        let [centre_x, centre_y, _] = about;
        (x - centre_x, y - centre_y)
    };
    let ((from_x, from_y), (to_x, to_y)) = (about_centre(from), about_centre(to));
    let begin = libm::atan2(from_y, from_x);
    let end = libm::atan2(to_y, to_x);
    let turn = (end - begin + PI).rem_euclid(TAU) - PI;
    let first = libm::hypot(from_x, from_y);
    let last = libm::hypot(to_x, to_y);
    let ([_, _, low], [_, _, high]) = (from, to);
    (0..=STEPS)
        .map(|step| {
            let share = f64::from(step) / f64::from(STEPS);
            let (sin, cos) = libm::sincos(begin + turn * share);
            let radius = first + (last - first) * share;
            let [centre_x, centre_y, _] = about;
            [centre_x + radius * cos, centre_y + radius * sin, low + (high - low) * share]
        })
        .collect()
}

/// The direction of view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Eye {
    /// Onto the plane.
    Above,
    /// Along the second axis.
    Side,
    /// Along the first axis.
    Front,
}

impl Eye {
    pub(super) const fn see(self, [first, second, height]: [f64; 3]) -> [f64; 2] {
        match self {
            Self::Above => [first, second],
            Self::Side => [first, height],
            Self::Front => [second, height],
        }
    }

    /// The side from which a face or wall is seen as a line, where there is one.
    pub(super) fn beside(nominal: Option<Surface>) -> Self {
        match nominal.and_then(|surface| surface.facing()) {
            Some([x, y]) if x.abs() < y.abs() => Self::Front,
            _ => Self::Side,
        }
    }

    pub(super) const fn names(self, plane: Plane) -> [&'static str; 2] {
        let [first, second] = plane.axes();
        let third = match plane {
            Plane::Xy => "Z",
            Plane::Zx => "Y",
            Plane::Yz => "X",
        };
        match self {
            Self::Above => [first, second],
            Self::Side => [first, third],
            Self::Front => [second, third],
        }
    }
}

/// The corners of a feature in a view, as far as it has ends there.
pub(super) fn part_places(feature: &PartFeature, eye: Eye) -> Vec<[f64; 2]> {
    let [[low_across, low_up], [high_across, high_up]] = part_ends(feature).map(|end| eye.see(end));
    let across = [low_across, high_across].into_iter().filter(|end| end.is_finite());
    let up = || [low_up, high_up].into_iter().filter(|end| end.is_finite());
    across.flat_map(|across| up().map(move |up| [across, up])).collect()
}

/// The lowest and the highest X, Y and Z of a feature, mm; infinite where it has no end.
pub(super) fn part_ends(feature: &PartFeature) -> [[f64; 3]; 2] {
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
