//! A round feature with its form, and the place where a probing meets it.

use serde::{Deserialize, Serialize};

use super::nearest::{least, trace};
use super::{FARTHEST, Figure, WorkpieceError, in_range};
use crate::tolerance::Feature;

/// The most lobes: the steps along a contour are so small that no lobe is missed.
const MOST_LOBES: f64 = 100.0;

/// The number of steps along a smooth contour.
const STEPS: u32 = 512;

/// A circular feature with its form, millimetres and degrees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Workpiece {
    /// Hole or shaft.
    pub feature: Feature,
    /// Where the centre really is.
    pub centre: [f64; 2],
    /// Mean diameter, above zero.
    pub diameter: f64,
    /// Ovality: two lobes.
    #[serde(default)]
    pub ovality: Lobes,
    /// Any other lobes.
    #[serde(default)]
    pub lobes: Lobes,
    /// Scatter of the surface along the probing direction, one sigma.
    #[serde(default)]
    pub surface_scatter: f64,
}

/// A regular wave of the radius.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lobes {
    /// How many there are round the circle; two for ovality.
    pub count: u32,
    /// Amplitude in the radius, zero or more.
    pub amplitude: f64,
    /// Direction of the first crest, degrees.
    #[serde(default)]
    pub angle: f64,
}

impl Workpiece {
    /// A perfectly round feature.
    pub const fn round(feature: Feature, centre: [f64; 2], diameter: f64) -> Self {
        Self { feature, centre, diameter, ovality: Lobes::NONE, lobes: Lobes::NONE, surface_scatter: 0.0 }
    }

    /// A usual feature from a workshop: a micrometre oval, three tenths of a micrometre rough.
    pub const fn usual(feature: Feature, diameter: f64) -> Self {
        Self {
            ovality: Lobes { count: 2, amplitude: 0.001, angle: 0.0 },
            surface_scatter: 0.0003,
            ..Self::round(feature, [0.0, 0.0], diameter)
        }
    }

    /// The radius in a direction seen from the centre, radians.
    fn radius(&self, angle: f64) -> f64 {
        self.diameter / 2.0 + self.ovality.height(angle) + self.lobes.height(angle)
    }

    pub(super) fn check(&self, trigger_scatter: f64) -> Result<(), WorkpieceError> {
        let [x, y] = self.centre;
        in_range(Figure::Diameter, self.diameter, 0.001, FARTHEST)?;
        in_range(Figure::CentreX, x, -FARTHEST, FARTHEST)?;
        in_range(Figure::CentreY, y, -FARTHEST, FARTHEST)?;
        // Contour and scatter must stay small enough for the contour to be a curve about its centre.
        let highest = self.diameter / 20.0;
        in_range(Figure::SurfaceScatter, self.surface_scatter, 0.0, highest)?;
        in_range(Figure::ProbeScatter, trigger_scatter, 0.0, highest)?;
        in_range(Figure::Ovality, self.ovality.amplitude, 0.0, highest)?;
        in_range(Figure::LobeHeight, self.lobes.amplitude, 0.0, highest)?;
        in_range(Figure::OvalityAngle, self.ovality.angle, -360.0, 360.0)?;
        in_range(Figure::LobeAngle, self.lobes.angle, -360.0, 360.0)?;
        // A wave with fewer crests would only move or widen the circle.
        let fewest = |wave: &Lobes| if 0.0 < wave.amplitude { 2.0 } else { 0.0 };
        in_range(Figure::OvalityCount, f64::from(self.ovality.count), fewest(&self.ovality), 2.0)?;
        in_range(Figure::Lobes, f64::from(self.lobes.count), fewest(&self.lobes), MOST_LOBES)
    }

    fn is_round(&self) -> bool {
        self.ovality.amplitude.max(self.lobes.amplitude) <= 0.0
    }

    /// The radius of its highest crest.
    pub(super) const fn widest(&self) -> f64 {
        self.diameter / 2.0 + self.ovality.amplitude + self.lobes.amplitude
    }

    /// The direction from the centre to a place, with length 1.
    pub(super) fn outwards(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [centre_x, centre_y] = self.centre;
        let (sin, cos) = libm::sincos(libm::atan2(y - centre_y, x - centre_x));
        [cos, sin]
    }

    /// How far a place lies outside the contour; below zero inside.
    pub(super) fn outside(&self, [x, y]: [f64; 2]) -> f64 {
        let [centre_x, centre_y] = self.centre;
        let off @ [off_x, off_y] = [x - centre_x, y - centre_y];
        let beyond = libm::hypot(off_x, off_y) - self.radius(libm::atan2(off_y, off_x));
        if self.is_round() { beyond } else { self.gap(off, 0.0).copysign(beyond) }
    }

    /// Whether a ball at this place is outside the material and does not touch it from behind.
    pub(super) fn is_free(&self, [x, y]: [f64; 2], ball_radius: f64) -> bool {
        let [centre_x, centre_y] = self.centre;
        let off_x = x - centre_x;
        let off_y = y - centre_y;
        let radius = self.radius(libm::atan2(off_y, off_x));
        let off = libm::hypot(off_x, off_y);
        let is_outside_material = match self.feature {
            Feature::Hole => off + ball_radius <= radius || (!self.is_round() && off <= radius),
            Feature::Shaft => radius + ball_radius <= off || (!self.is_round() && radius <= off),
        };
        // A point needs no space; a neighbouring crest of a wavy contour may be nearer.
        is_outside_material && (self.is_round() || ball_radius <= 0.0 || 0.0 <= self.gap([off_x, off_y], ball_radius))
    }

    /// How far along a unit vector a ball meets the contour.
    pub(super) fn distance(&self, from: [f64; 2], direction: [f64; 2], ball_radius: f64) -> Option<f64> {
        let [x, y] = from;
        let [along_x, along_y] = direction;
        let [centre_x, centre_y] = self.centre;
        let to_x = centre_x - x;
        let to_y = centre_y - y;
        let along = to_x * along_x + to_y * along_y;
        let across = to_x * along_y - to_y * along_x;
        let half_chord = |radius: f64| {
            let square = (radius - across) * (radius + across);
            (0.0 <= square).then(|| square.sqrt())
        };
        let feature = self.feature;
        if self.is_round() {
            let radius = match feature {
                Feature::Hole => self.diameter / 2.0 - ball_radius,
                Feature::Shaft => self.diameter / 2.0 + ball_radius,
            };
            let half = half_chord(radius)?;
            // From inside a hole the far side is met, from outside a shaft the near one.
            let distance = if feature == Feature::Hole { along + half } else { along - half };
            return (0.0 <= distance).then_some(distance);
        }
        // Any other contour lies within a circle a little wider than its highest crest.
        let ovality = self.ovality.amplitude;
        let lobes = self.lobes.amplitude;
        let widest = (self.diameter / 2.0 + ovality + lobes) * (1.0 + 1e-9);
        if 0.0 < ball_radius {
            let half = half_chord(widest + ball_radius)?;
            let gap = |gone: f64| self.gap([gone * along_x - to_x, gone * along_y - to_y], ball_radius);
            return trace(gap, along + half);
        }
        // For a point, the first crossing on the way through that circle is searched for in small steps and then halved
        // to the last bit.
        let half = half_chord(widest)?;
        let first = (along - half).max(0.0);
        let last = along + half;
        let crossed = |distance: f64| {
            let off_x = distance * along_x - to_x;
            let off_y = distance * along_y - to_y;
            let outside = libm::hypot(off_x, off_y) - self.radius(libm::atan2(off_y, off_x));
            if feature == Feature::Hole { 0.0 <= outside } else { outside <= 0.0 }
        };
        if last < first {
            return None;
        }
        let steps = STEPS + 64 * self.lobes.count;
        let place = |step: u32| first + (last - first) * (f64::from(step) / f64::from(steps));
        let beyond = (0..=steps).find(|&step| crossed(place(step)))?;
        let mut before = place(beyond.saturating_sub(1));
        let mut after = place(beyond);
        for _ in 0..60 {
            let middle = f64::midpoint(before, after);
            if crossed(middle) { after = middle } else { before = middle }
        }
        Some(after)
    }

    /// The gap between a ball, seen from the centre, and the nearest point of the contour.
    fn gap(&self, [x, y]: [f64; 2], ball_radius: f64) -> f64 {
        let distance = |angle: f64| {
            let radius = self.radius(angle);
            let (sin, cos) = libm::sincos(angle);
            libm::hypot(x - radius * cos, y - radius * sin)
        };
        let turn = std::f64::consts::TAU;
        least(distance, 0.0, turn, (STEPS / 2).max(32 * self.lobes.count)) - ball_radius
    }
}

impl Lobes {
    /// No wave.
    pub const NONE: Self = Self { count: 0, amplitude: 0.0, angle: 0.0 };

    pub(super) fn height(&self, angle: f64) -> f64 {
        self.amplitude * libm::cos(f64::from(self.count) * (angle - self.angle.to_radians()))
    }
}
