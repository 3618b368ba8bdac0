//! Plane walls that stand parallel: a slot or ridge has two, a pocket or boss four. Their height has no end.

use super::{FARTHEST, WorkpieceError, in_range};
use crate::tolerance::Feature;

/// One or two pairs of parallel walls, millimetres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walls {
    /// A hole has its material outside (slot, pocket), a shaft inside (ridge, boss).
    pub feature: Feature,
    /// The middle between the walls.
    pub centre: [f64; 2],
    /// From wall to wall, across the first pair and across the second, where there is one.
    pub lengths: (f64, Option<f64>),
    /// The direction across the first pair, degrees from the first axis.
    pub angle: f64,
    /// Scatter of the surface along the probing direction, one sigma.
    pub surface_scatter: f64,
}

impl Walls {
    /// Perfect walls, the first pair across the first axis.
    pub const fn new(feature: Feature, centre: [f64; 2], lengths: (f64, Option<f64>)) -> Self {
        Self { feature, centre, lengths, angle: 0.0, surface_scatter: 0.0 }
    }

    pub(super) fn check(&self) -> Result<(), WorkpieceError> {
        let ([x, y], (first, second)) = (self.centre, self.lengths);
        in_range("centre x", x, -FARTHEST, FARTHEST)?;
        in_range("centre y", y, -FARTHEST, FARTHEST)?;
        let size = |what, length| in_range(what, length, 0.001, FARTHEST);
        match second {
            Some(second) => size("1st length", first).and_then(|()| size("2nd length", second))?,
            None => size("width", first)?,
        }
        in_range("angle", self.angle, -360.0, 360.0)?;
        in_range("surface scatter", self.surface_scatter, 0.0, 1.0)
    }

    /// The same, grown by a factor about the workpiece's zero.
    pub(super) fn grown(self, factor: f64) -> Self {
        let (first, second) = self.lengths;
        let lengths = (first * factor, second.map(|second| second * factor));
        Self { centre: self.centre.map(|part| part * factor), lengths, ..self }
    }

    /// Half the lengths; a pair that is not there is endlessly far away.
    fn halves(&self) -> [f64; 2] {
        let (first, second) = self.lengths;
        [first / 2.0, second.map_or(f64::INFINITY, |second| second / 2.0)]
    }

    /// Across the first pair, exact at every quarter turn.
    pub(super) fn across(&self) -> [f64; 2] {
        let (sin, cos) = self.angle.to_radians().sin_cos();
        let is_quarter = (self.angle % 90.0).abs() <= 0.0;
        if is_quarter { [cos.round(), sin.round()] } else { [cos, sin] }
    }

    /// A vector of the plane as its shares across the first and the second pair.
    fn within(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.across();
        [x * cos + y * sin, y * cos - x * sin]
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [centre_x, centre_y] = self.centre;
        self.within([x - centre_x, y - centre_y])
    }

    /// The corners in their order round the walls, those of a single pair so far beside the centre.
    pub fn corners(&self, reach: f64) -> [[f64; 2]; 4] {
        let ([cos, sin], [centre_x, centre_y]) = (self.across(), self.centre);
        let [first, second] = self.halves().map(|half| if half.is_finite() { half } else { reach });
        [[first, second], [-first, second], [-first, -second], [first, -second]]
            .map(|[x, y]| [centre_x + x * cos - y * sin, centre_y + x * sin + y * cos])
    }

    /// Whether a ball there is not in the material.
    pub(super) fn is_free(&self, from: [f64; 2], ball_radius: f64) -> bool {
        let [place_1, place_2] = self.place(from).map(f64::abs);
        let [half_1, half_2] = self.halves();
        match self.feature {
            Feature::Hole => place_1 + ball_radius <= half_1 && place_2 + ball_radius <= half_2,
            Feature::Shaft => {
                let (off_1, off_2) = (place_1 - half_1, place_2 - half_2);
                // Beside an edge the corner is nearest.
                let gap = if 0.0 < off_1 && 0.0 < off_2 { off_1.hypot(off_2) } else { off_1.max(off_2) };
                ball_radius <= gap
            }
        }
    }

    /// How far along a vector of the plane a ball meets a wall, in lengths of the vector.
    pub(super) fn distance(&self, from: [f64; 2], direction: [f64; 2], ball_radius: f64) -> Option<f64> {
        let (place, along) = (self.place(from), self.within(direction));
        let met = match self.feature {
            Feature::Hole => self.leaving(place, along, ball_radius),
            Feature::Shaft => self.entering(place, along, ball_radius),
        };
        met.into_iter().filter(|distance| 0.0 <= *distance).reduce(f64::min)
    }

    /// Out of the room between walls: the wall ahead, of each pair.
    fn leaving(&self, place: [f64; 2], along: [f64; 2], ball_radius: f64) -> Vec<f64> {
        let ahead = place.into_iter().zip(along).zip(self.halves());
        let ahead = ahead.filter(|((_, along), half)| 0.0 < along.abs() && half.is_finite());
        ahead.map(|((place, along), half)| ((half - ball_radius).copysign(along) - place) / along).collect()
    }

    /// Onto a body: a wall between its edges, or an edge, which a ball meets on its side.
    fn entering(&self, [place_1, place_2]: [f64; 2], [along_1, along_2]: [f64; 2], ball_radius: f64) -> Vec<f64> {
        let [half_1, half_2] = self.halves();
        let wall = |[place, along, half]: [f64; 3], [beside, beside_along, beside_half]: [f64; 3]| {
            if along.abs() <= 0.0 || half.is_infinite() {
                return None;
            }
            let distance = ((half + ball_radius).copysign(-along) - place) / along;
            ((beside + distance * beside_along).abs() <= beside_half).then_some(distance)
        };
        let (first, second) = ([place_1, along_1, half_1], [place_2, along_2, half_2]);
        let edge = |[sign_1, sign_2]: [f64; 2]| {
            let (to_1, to_2) = (sign_1 * half_1 - place_1, sign_2 * half_2 - place_2);
            let square = along_1 * along_1 + along_2 * along_2;
            let (along, across) = (to_1 * along_1 + to_2 * along_2, to_1 * along_2 - to_2 * along_1);
            let half_chord = ball_radius * ball_radius * square - across * across;
            (0.0 < half_chord).then(|| (along - half_chord.sqrt()) / square)
        };
        let has_edges = half_1.is_finite() && half_2.is_finite();
        let edges = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].into_iter().filter(|_| has_edges);
        [wall(first, second), wall(second, first)].into_iter().chain(edges.map(edge)).flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(walls: &Walls, from: [f64; 2], direction: [f64; 2], ball_radius: f64, expected: Option<f64>) {
        let found = walls.distance(from, direction, ball_radius);
        let is_near =
            found.zip(expected).map_or(found == expected, |(found, expected)| (found - expected).abs() < 1e-12);
        assert!(is_near, "{found:?} for {expected:?}");
    }

    #[test]
    fn a_ball_meets_the_wall_ahead() {
        let slot = Walls::new(Feature::Hole, [50.0, 20.0], (10.0, None));
        check(&slot, [48.0, 90.0], [1.0, 0.0], 2.0, Some(5.0));
        check(&slot, [48.0, 90.0], [-1.0, 0.0], 2.0, Some(1.0));
        check(&slot, [48.0, 90.0], [0.0, 1.0], 2.0, None);
        assert!(slot.is_free([47.0, 0.0], 2.0) && !slot.is_free([46.9, 0.0], 2.0));
        let ridge = Walls { feature: Feature::Shaft, angle: 90.0, ..slot };
        check(&ridge, [0.0, 30.0], [0.0, -1.0], 2.0, Some(3.0));
        check(&ridge, [0.0, 30.0], [0.0, 1.0], 2.0, None);
        check(&ridge, [0.0, 30.0], [1.0, 0.0], 2.0, None);
        assert!(ridge.is_free([0.0, 27.0], 2.0) && !ridge.is_free([0.0, 26.9], 2.0));
        let pocket = Walls::new(Feature::Hole, [0.0, 0.0], (60.0, Some(40.0)));
        check(&pocket, [1.0, 2.0], [0.0, -1.0], 3.0, Some(19.0));
        check(&pocket, [1.0, 2.0], [1.0, 0.0], 3.0, Some(26.0));
        assert!(!pocket.is_free([0.0, 18.0], 3.0) && !pocket.is_free([28.0, 0.0], 3.0));
    }

    #[test]
    fn a_ball_meets_the_edge_of_a_boss_on_its_side_or_passes_it() {
        let boss = Walls::new(Feature::Shaft, [0.0, 0.0], (60.0, Some(40.0)));
        check(&boss, [50.0, 10.0], [-1.0, 0.0], 5.0, Some(15.0));
        // 3 above the edge the ball stands 4 beside it.
        check(&boss, [50.0, 23.0], [-1.0, 0.0], 5.0, Some(16.0));
        check(&boss, [50.0, 25.1], [-1.0, 0.0], 5.0, None);
        assert!(boss.is_free([34.0, 23.0], 5.0) && !boss.is_free([33.9, 22.9], 5.0));
        // Turned by 45 degrees the edge points along the axis.
        let turned = Walls { angle: 45.0, lengths: (20.0, Some(20.0)), ..boss };
        check(&turned, [30.0, 14.2], [-1.0, 0.0], 0.0, None);
        check(&turned, [30.0, 0.001], [-1.0, 0.0], 0.0, Some(30.0 - 200.0_f64.sqrt() + 0.001));
        let corners = turned.corners(1e3);
        assert!(corners.iter().any(|[x, y]| (x - 200.0_f64.sqrt()).abs() < 1e-12 && y.abs() < 1e-12), "{corners:?}");
    }
}
