//! Parallel plane walls: a slot or ridge has two, a pocket or boss four. Their height has no end.

use super::{FARTHEST, Figure, WorkpieceError, in_range};
use crate::tolerance::Feature;

/// One or two pairs of parallel walls, millimetres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walls {
    /// A hole has its material outside (slot, pocket), a shaft inside (ridge, boss).
    pub feature: Feature,
    /// The middle between the walls.
    pub centre: [f64; 2],
    /// From wall to wall, across the first pair and, if there is one, across the second.
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
        let [x, y] = self.centre;
        let (first, second) = self.lengths;
        in_range(Figure::CentreX, x, -FARTHEST, FARTHEST)?;
        in_range(Figure::CentreY, y, -FARTHEST, FARTHEST)?;
        let size = |what, length| in_range(what, length, 0.001, FARTHEST);
        match second {
            Some(second) => size(Figure::FirstLength, first).and_then(|()| size(Figure::SecondLength, second))?,
            None => size(Figure::Width, first)?,
        }
        in_range(Figure::Angle, self.angle, -360.0, 360.0)?;
        in_range(Figure::SurfaceScatter, self.surface_scatter, 0.0, 1.0)
    }

    /// The same walls, grown by a factor about the workpiece's zero.
    pub(super) fn grown(self, factor: f64) -> Self {
        let (first, second) = self.lengths;
        let lengths = (first * factor, second.map(|second| second * factor));
        Self { centre: self.centre.map(|part| part * factor), lengths, ..self }
    }

    /// Half the lengths; a pair that does not exist is endlessly far away.
    fn halves(&self) -> [f64; 2] {
        let (first, second) = self.lengths;
        [first / 2.0, second.map_or(f64::INFINITY, |second| second / 2.0)]
    }

    /// The direction across the first pair, exact at every quarter turn.
    pub(super) fn across(&self) -> [f64; 2] {
        let (sin, cos) = libm::sincos(self.angle.to_radians());
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

    /// The corners in their order round the walls; those of a single pair lie `reach` beside the centre.
    pub fn corners(&self, reach: f64) -> [[f64; 2]; 4] {
        let [cos, sin] = self.across();
        let [centre_x, centre_y] = self.centre;
        let [first, second] = self.halves().map(|half| if half.is_finite() { half } else { reach });
        [[first, second], [-first, second], [-first, -second], [first, -second]]
            .map(|[x, y]| [centre_x + x * cos - y * sin, centre_y + x * sin + y * cos])
    }

    /// How far a place lies outside the first and the second pair of walls, below zero between them; a single pair ends
    /// after half a length on either side.
    pub(super) fn outside(&self, place: [f64; 2], length: f64) -> [f64; 2] {
        let [one, other] = self.place(place).map(f64::abs);
        let [half_1, half_2] = self.halves();
        [one - half_1, other - half_2.min(length / 2.0)]
    }

    /// The direction out of the space, to the nearest wall, with length 1.
    pub(super) fn outwards(&self, place: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.across();
        let [one, other] = self.place(place);
        let [outside_1, outside_2] = self.outside(place, f64::INFINITY);
        let sign_1 = one.signum();
        let sign_2 = other.signum();
        if outside_2 <= outside_1 { [sign_1 * cos, sign_1 * sin] } else { [-sign_2 * sin, sign_2 * cos] }
    }

    /// Whether a ball at this place is outside the material.
    pub(super) fn is_free(&self, from: [f64; 2], ball_radius: f64) -> bool {
        let [place_1, place_2] = self.place(from).map(f64::abs);
        let [half_1, half_2] = self.halves();
        match self.feature {
            Feature::Hole => place_1 + ball_radius <= half_1 && place_2 + ball_radius <= half_2,
            Feature::Shaft => {
                let off_1 = place_1 - half_1;
                let off_2 = place_2 - half_2;
                // Beside an edge the corner is nearest.
                let gap = if 0.0 < off_1 && 0.0 < off_2 { libm::hypot(off_1, off_2) } else { off_1.max(off_2) };
                ball_radius <= gap
            }
        }
    }

    /// How far along a vector of the plane a ball meets a wall, in lengths of the vector.
    pub(super) fn distance(&self, from: [f64; 2], direction: [f64; 2], ball_radius: f64) -> Option<f64> {
        let place = self.place(from);
        let along = self.within(direction);
        let met = match self.feature {
            Feature::Hole => self.leaving(place, along, ball_radius),
            Feature::Shaft => self.entering(place, along, ball_radius),
        };
        met.into_iter().filter(|distance| 0.0 <= *distance).reduce(f64::min)
    }

    /// From the space between walls: the wall ahead, of each pair.
    fn leaving(&self, place: [f64; 2], along: [f64; 2], ball_radius: f64) -> Vec<f64> {
        let ahead = place.into_iter().zip(along).zip(self.halves());
        let ahead = ahead.filter(|((_, along), half)| 0.0 < along.abs() && half.is_finite());
        ahead.map(|((place, along), half)| ((half - ball_radius).copysign(along) - place) / along).collect()
    }

    /// Towards a body: a wall between its edges, or an edge, which a ball meets with its side.
    fn entering(&self, [place_1, place_2]: [f64; 2], [along_1, along_2]: [f64; 2], ball_radius: f64) -> Vec<f64> {
        let [half_1, half_2] = self.halves();
        let wall = |[place, along, half]: [f64; 3], [beside, beside_along, beside_half]: [f64; 3]| {
            if along.abs() <= 0.0 || half.is_infinite() {
                return None;
            }
            let distance = ((half + ball_radius).copysign(-along) - place) / along;
            ((beside + distance * beside_along).abs() <= beside_half).then_some(distance)
        };
        let first = [place_1, along_1, half_1];
        let second = [place_2, along_2, half_2];
        let edge = |[sign_1, sign_2]: [f64; 2]| {
            let to_1 = sign_1 * half_1 - place_1;
            let to_2 = sign_2 * half_2 - place_2;
            let square = along_1 * along_1 + along_2 * along_2;
            let along = to_1 * along_1 + to_2 * along_2;
            let across = to_1 * along_2 - to_2 * along_1;
            let half_chord = ball_radius * ball_radius * square - across * across;
            (0.0 < half_chord).then(|| (along - half_chord.sqrt()) / square)
        };
        let has_edges = half_1.is_finite() && half_2.is_finite();
        let edges = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].into_iter().filter(|_| has_edges);
        [wall(first, second), wall(second, first)].into_iter().chain(edges.map(edge)).flatten().collect()
    }
}
