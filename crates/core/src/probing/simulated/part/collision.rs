//! What a move would touch: the ball, or the stylus above it, on a straight line or an arc.
//!
//! The stylus is a cylinder in Z from the centre of the ball upwards, without an end, as thick as the file says, or
//! else as thick as the ball. A program with another tool axis has the ball alone looked at. A touch that goes no deeper than a nanometre is none. Not looked at:
//!
//! - the workpiece of a file without `[[feature]]`: nothing says how high it is;
//! - the walls of spaces that run into one another: each is missing within the other;
//! - with the stylus, features that [`Space::unchecked`] names: walls in other planes than X/Y, faces and points that
//!   look down, slanted ones with a reach, hollows.
//!
//! A move that slides beside a wall for more than a hundred thousand times its distance from it is told as touching
//! there: nothing else can be said within a bounded time.

use super::super::nearest::{Way, follow};
use super::Space;
use crate::message::Say;
use crate::probing::vector::{along, dot, norm};

/// How deep a touch is before it is one, mm: a nanometre.
const DEPTH: f64 = 1e-6;

/// What of the probe would touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Say)]
#[say(prefix = "mover")]
pub enum Mover {
    /// The ball.
    Ball,
    /// The stylus above it.
    Stylus,
}

/// A place where a move would touch a feature.
#[derive(Debug, Clone, PartialEq)]
pub struct Collision {
    /// What touches.
    pub mover: Mover,
    /// The feature's name.
    pub feature: String,
    /// Where the centre of the ball is then, millimetres.
    pub place: [f64; 3],
}

/// A move: a straight line, or the shorter arc about a centre.
#[derive(Debug, Clone, Copy)]
struct Line {
    from: [f64; 3],
    to: [f64; 3],
    about: Option<[f64; 3]>,
}

/// An arc: the arm to its beginning, one across it in the direction of the way, and the angle of all of it.
#[derive(Debug, Clone, Copy)]
struct Arc {
    centre: [f64; 3],
    arm: [f64; 3],
    across: [f64; 3],
    angle: f64,
}

impl Line {
    /// Its length, mm.
    fn length(&self) -> f64 {
        self.arc().map_or_else(|| norm(along(self.to, self.from, -1.0)), |arc| norm(arc.arm) * arc.angle)
    }

    /// The arc; `None` for a straight line. Half a turn goes counter-clockwise: neither way is the shorter.
    fn arc(&self) -> Option<Arc> {
        let centre = self.about?;
        let arm = along(self.from, centre, -1.0);
        let other = along(self.to, centre, -1.0);
        let radius = norm(arm);
        let cos = dot(arm, other) / (norm(arm) * norm(other));
        let aside = along(other, arm, -dot(arm, other) / (radius * radius));
        let [x, y, _] = arm;
        let across = if 1e-9 < norm(aside) { aside.map(|part| part * radius / norm(aside)) } else { [-y, x, 0.0] };
        let angle = libm::acos(cos.clamp(-1.0, 1.0));
        // NaN, where an arm has no length, is no angle either.
        (1e-9 < angle).then_some(Arc { centre, arm, across, angle })
    }

    /// The place after a share of the way, 0 to 1.
    fn at(&self, share: f64) -> [f64; 3] {
        let Some(Arc { centre, arm, across, angle }) = self.arc() else {
            return along(self.from, along(self.to, self.from, -1.0), share);
        };
        let (sin, cos) = libm::sincos(share * angle);
        along(along(centre, arm, cos), across, sin)
    }
}

impl Space {
    /// What a move of the ball's centre would touch first; `about` is the centre of an arc.
    pub(in super::super) fn collision(
        &self,
        [from, to]: [[f64; 3]; 2],
        about: Option<[f64; 3]>,
        movers: &[(Mover, f64)],
    ) -> Option<Collision> {
        if self.only().is_some() {
            return None;
        }
        let line = Line { from, to, about };
        let length = line.length();
        let nearest = |gone: f64| {
            let place = if 0.0 < length { line.at(gone / length) } else { from };
            let mut nearest = (f64::INFINITY, 0, Mover::Ball);
            for (number, feature) in self.features() {
                if feature.is_space() && self.crossing(number).next().is_some() {
                    continue;
                }
                // The ball comes first: where both are as near, it is told.
                for &(mover, radius) in movers {
                    let nearest_place = match mover {
                        Mover::Ball => Some(place),
                        Mover::Stylus => feature.nearest_on_stylus(place),
                    };
                    let gap = nearest_place.map_or(f64::INFINITY, |place| self.gap(number, place) - radius);
                    if gap < nearest.0 {
                        nearest = (gap, number, mover);
                    }
                }
            }
            nearest
        };
        let gone = match follow(|gone| nearest(gone).0 + DEPTH, length) {
            Way::Free => return None,
            Way::Closed(gone) => gone,
        };
        let (_, number, mover) = nearest(gone);
        let place = if 0.0 < length { line.at(gone / length) } else { from };
        Some(Collision { mover, feature: self.name(number).to_owned(), place })
    }

    /// The features that no move, or no stylus, is looked at with.
    pub(in super::super) fn unchecked(&self) -> Vec<&str> {
        if self.only().is_some() {
            return Vec::new();
        }
        let is_unchecked = |number: usize| {
            let feature = self.feature(number);
            let has_no_form = feature.is_some_and(|feature| feature.nearest_on_stylus([0.0; 3]).is_none());
            has_no_form || self.crossing(number).next().is_some()
        };
        self.features().filter(|(number, _)| is_unchecked(*number)).map(|(number, _)| self.name(number)).collect()
    }
}
