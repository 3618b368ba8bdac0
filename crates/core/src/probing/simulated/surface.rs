//! The surfaces that a simulated probe can touch: round features, plane faces, points of free surfaces, parallel walls.

use serde::{Deserialize, Serialize};

use super::nearest::{least, trace};
use super::reading::exactly;
use super::{FARTHEST, Figure, Shape, Walls, Workpiece, WorkpieceError, in_range};
use crate::probing::cycle::Plane;
use crate::probing::orientation::Orientation;
use crate::probing::vector::{along, dot, norm, unit};
use crate::tolerance::Feature;

/// A surface of the workpiece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// A hole or a shaft in a plane of the machine; its axis has no end.
    Round(Workpiece, Plane),
    /// A plane face without borders.
    Face(Face),
    /// The neighbourhood of a point of a free surface.
    Point(FreePoint),
    /// A slot, ridge, pocket or boss in X/Y.
    Walls(Walls),
}

/// A plane face, millimetres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Face {
    /// A point of the face; a wave has its crest there.
    #[serde(deserialize_with = "exactly")]
    pub point: [f64; 3],
    /// Its normal out of the material, of any length except zero.
    #[serde(deserialize_with = "exactly")]
    pub normal: [f64; 3],
    /// Waviness.
    #[serde(default)]
    pub wave: Option<Wave>,
    /// Scatter of the surface along the probing direction, one sigma.
    #[serde(default)]
    pub surface_scatter: f64,
}

/// Waves of a face, millimetres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wave {
    /// Half the height from trough to crest.
    pub amplitude: f64,
    /// The distance from crest to crest.
    pub length: f64,
    /// The direction in which the waves follow each other; its share along the normal does not count.
    #[serde(deserialize_with = "exactly")]
    pub direction: [f64; 3],
}

/// A point of a free surface, millimetres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FreePoint {
    /// Where the point should be.
    #[serde(deserialize_with = "exactly")]
    pub point: [f64; 3],
    /// The normal there out of the material, of any length except zero.
    #[serde(deserialize_with = "exactly")]
    pub normal: [f64; 3],
    /// How far out along the normal the surface really lies; below zero, material is missing.
    #[serde(default)]
    pub deviation: f64,
    /// Radius of the surface there: above zero it is convex, below zero concave; if not given, the surface is flat.
    #[serde(default)]
    pub radius: Option<f64>,
    /// Scatter of the surface along the probing direction, one sigma.
    #[serde(default)]
    pub surface_scatter: f64,
}

impl Face {
    /// A perfect face.
    pub const fn plane(point: [f64; 3], normal: [f64; 3]) -> Self {
        Self { point, normal, wave: None, surface_scatter: 0.0 }
    }
}

impl FreePoint {
    /// A point at its nominal place, on a flat surface.
    pub const fn flat(point: [f64; 3], normal: [f64; 3]) -> Self {
        Self { point, normal, deviation: 0.0, radius: None, surface_scatter: 0.0 }
    }
}

/// What a drawing shows of a surface, in the coordinates of its plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outline {
    /// A circle.
    Circle {
        /// Its centre.
        centre: [f64; 2],
        /// Its mean radius.
        radius: f64,
    },
    /// Straight walls, corner by corner.
    Walls([[f64; 2]; 4]),
    /// A face.
    Face {
        /// A point of it.
        point: [f64; 3],
        /// Its normal out of the material.
        normal: [f64; 3],
    },
}

impl Surface {
    /// What a drawing shows of it; endless walls extend `reach` either way.
    pub fn outline(&self, reach: f64) -> Outline {
        match *self {
            Self::Round(Workpiece { centre, diameter, .. }, _) => Outline::Circle { centre, radius: diameter / 2.0 },
            Self::Walls(walls) => Outline::Walls(walls.corners(reach)),
            Self::Face(Face { point, normal, .. }) | Self::Point(FreePoint { point, normal, .. }) => {
                Outline::Face { point, normal }
            }
        }
    }

    /// The direction that it faces in its plane; `None` where it faces every direction.
    pub fn facing(&self) -> Option<[f64; 2]> {
        match self {
            Self::Face(Face { normal: [x, y, _], .. }) | Self::Point(FreePoint { normal: [x, y, _], .. }) => {
                Some([*x, *y])
            }
            Self::Walls(walls) if walls.lengths.1.is_none() => Some(walls.across()),
            Self::Walls(_) | Self::Round(..) => None,
        }
    }

    /// Its shape.
    pub const fn shape(&self) -> Shape {
        match self {
            Self::Round(Workpiece { feature: Feature::Hole, .. }, _) => Shape::Hole,
            Self::Round(Workpiece { feature: Feature::Shaft, .. }, _) => Shape::Stud,
            Self::Face(_) => Shape::Face,
            Self::Point(_) => Shape::Point,
            Self::Walls(Walls { feature: Feature::Hole, lengths: (_, None), .. }) => Shape::Slot,
            Self::Walls(Walls { feature: Feature::Shaft, lengths: (_, None), .. }) => Shape::Ridge,
            Self::Walls(Walls { feature: Feature::Hole, .. }) => Shape::Pocket,
            Self::Walls(Walls { feature: Feature::Shaft, .. }) => Shape::Boss,
        }
    }

    /// The plane that it lies in; X/Y for a face.
    pub const fn plane(&self) -> Plane {
        if let Self::Round(_, plane) = self { *plane } else { Plane::Xy }
    }

    pub(super) fn check(&self, trigger_scatter: f64) -> Result<(), WorkpieceError> {
        match self {
            Self::Round(workpiece, _) => workpiece.check(trigger_scatter),
            Self::Face(face) => face.check(),
            Self::Point(point) => point.check(),
            Self::Walls(walls) => walls.check(),
        }
    }

    pub(super) const fn scatter(&self) -> f64 {
        match self {
            Self::Round(workpiece, _) => workpiece.surface_scatter,
            Self::Face(face) => face.surface_scatter,
            Self::Point(point) => point.surface_scatter,
            Self::Walls(walls) => walls.surface_scatter,
        }
    }

    /// The same surface grown by a factor about the workpiece's zero; waves and deviations stay.
    #[must_use]
    pub(super) fn grown(self, factor: f64) -> Self {
        match self {
            Self::Round(workpiece, plane) => {
                let centre = workpiece.centre.map(|part| part * factor);
                Self::Round(Workpiece { centre, diameter: workpiece.diameter * factor, ..workpiece }, plane)
            }
            Self::Face(face) => Self::Face(Face { point: face.point.map(|part| part * factor), ..face }),
            Self::Point(point) => Self::Point(FreePoint {
                point: point.point.map(|part| part * factor),
                radius: point.radius.map(|radius| radius * factor),
                ..point
            }),
            Self::Walls(walls) => Self::Walls(walls.grown(factor)),
        }
    }

    /// The same surface elsewhere.
    #[must_use]
    pub fn moved(self, by: [f64; 3]) -> Self {
        let [by_x, by_y, _] = self.plane().within(by);
        let in_plane = |[x, y]: [f64; 2]| [x + by_x, y + by_y];
        match self {
            Self::Round(round, plane) => Self::Round(Workpiece { centre: in_plane(round.centre), ..round }, plane),
            Self::Face(face) => Self::Face(Face { point: along(face.point, by, 1.0), ..face }),
            Self::Point(point) => Self::Point(FreePoint { point: along(point.point, by, 1.0), ..point }),
            Self::Walls(walls) => Self::Walls(Walls { centre: in_plane(walls.centre), ..walls }),
        }
    }

    /// The same surface turned about the workpiece's zero; `None` where a round one or walls would no longer stand along Z.
    #[must_use]
    pub fn turned(self, orientation: Orientation) -> Option<Self> {
        let in_plane = |[x, y]: [f64; 2]| {
            let [x, y, _] = orientation.out([x, y, 0.0]);
            [x, y]
        };
        Some(match self {
            Self::Face(face) => {
                let wave = face.wave.map(|wave| Wave { direction: orientation.out(wave.direction), ..wave });
                Self::Face(Face {
                    point: orientation.out(face.point),
                    normal: orientation.out(face.normal),
                    wave,
                    ..face
                })
            }
            Self::Point(point) => Self::Point(FreePoint {
                point: orientation.out(point.point),
                normal: orientation.out(point.normal),
                ..point
            }),
            _ if orientation.is_level() => self,
            Self::Round(round, Plane::Xy) if orientation.is_upright() => {
                Self::Round(Workpiece { centre: in_plane(round.centre), ..round }, Plane::Xy)
            }
            Self::Walls(walls) if orientation.is_upright() => Self::Walls(Walls {
                centre: in_plane(walls.centre),
                angle: walls.angle + orientation.about_z(),
                ..walls
            }),
            Self::Round(..) | Self::Walls(_) => return None,
        })
    }

    /// Whether a ball at this place is outside the material.
    pub(super) fn is_free(&self, from: [f64; 3], ball_radius: f64) -> bool {
        let [first, second, _] = self.plane().within(from);
        match self {
            Self::Round(workpiece, _) => workpiece.is_free([first, second], ball_radius),
            Self::Face(face) => 0.0 <= face.gap(from, ball_radius),
            Self::Point(point) => 0.0 <= point.gap(from, ball_radius),
            Self::Walls(walls) => walls.is_free([first, second], ball_radius),
        }
    }

    /// How far along a unit vector a ball meets the surface.
    pub(super) fn distance(&self, from: [f64; 3], direction: [f64; 3], ball_radius: f64) -> Option<f64> {
        let [first, second, _] = self.plane().within(from);
        let [along_1, along_2, up] = self.plane().within(direction);
        match self {
            Self::Round(workpiece, _) => {
                if up.abs() <= 0.0 {
                    return workpiece.distance([first, second], [along_1, along_2], ball_radius);
                }
                // Only the share across the axis moves towards the wall.
                let share = libm::hypot(along_1, along_2);
                if share <= 0.0 {
                    return None;
                }
                let across = [along_1 / share, along_2 / share];
                workpiece.distance([first, second], across, ball_radius).map(|distance| distance / share)
            }
            Self::Face(face) => face.distance(from, direction, ball_radius),
            Self::Point(point) => point.distance(from, direction, ball_radius),
            Self::Walls(walls) => walls.distance([first, second], [along_1, along_2], ball_radius),
        }
    }
}

impl Face {
    fn check(&self) -> Result<(), WorkpieceError> {
        check_place(self.point, self.normal, self.surface_scatter)?;
        let Some(wave) = &self.wave else { return Ok(()) };
        in_range(Figure::WaveLength, wave.length, 0.001, FARTHEST)?;
        in_range(Figure::WaveAmplitude, wave.amplitude, 0.0, wave.length)?;
        in_range(Figure::WaveDirection, norm(self.across(wave)), 1e-6, FARTHEST)
    }

    /// The share of the wave's direction that lies in the face.
    fn across(&self, wave: &Wave) -> [f64; 3] {
        let normal = unit(self.normal);
        let share = dot(wave.direction, normal);
        along(wave.direction, normal, -share)
    }

    pub(super) fn gap(&self, from: [f64; 3], ball_radius: f64) -> f64 {
        let off = along(from, self.point, -1.0);
        let height = dot(off, unit(self.normal));
        let Some(wave) = self.wave.filter(|wave| 0.0 < wave.amplitude) else { return height - ball_radius };
        // Far above the crests the exact gap does not matter, as long as it is not too large.
        let above = height - wave.amplitude;
        if wave.length < above - ball_radius {
            return above - ball_radius;
        }
        let place = dot(off, unit(self.across(&wave)));
        let number = std::f64::consts::TAU / wave.length;
        let crest = |gone: f64| wave.amplitude * libm::cos(number * gone);
        if height < crest(place) {
            // Below the surface: the depth is enough.
            return height - crest(place) - ball_radius;
        }
        let distance = |gone: f64| libm::hypot(gone - place, height - crest(gone));
        // No point farther along than the one straight below can be nearer.
        let reach = height - crest(place);
        let samples = whole((64.0 * reach / wave.length).clamp(16.0, 20_000.0));
        least(distance, place - reach, place + reach, samples) - ball_radius
    }

    fn distance(&self, from: [f64; 3], direction: [f64; 3], ball_radius: f64) -> Option<f64> {
        let towards = -dot(direction, unit(self.normal));
        if self.wave.is_none_or(|wave| wave.amplitude <= 0.0) {
            return (0.0 < towards).then(|| self.gap(from, ball_radius) / towards);
        }
        trace(|gone| self.gap(along(from, direction, gone), ball_radius), FARTHEST)
    }
}

impl FreePoint {
    fn check(&self) -> Result<(), WorkpieceError> {
        check_place(self.point, self.normal, self.surface_scatter)?;
        in_range(Figure::Deviation, self.deviation, -1_000.0, 1_000.0)?;
        in_range(Figure::Radius, self.radius.map_or(1.0, f64::abs), 0.001, FARTHEST)
    }

    /// The real point of the surface, moved by the deviation.
    pub(super) fn real(&self) -> [f64; 3] {
        along(self.point, unit(self.normal), self.deviation)
    }

    pub(super) fn gap(&self, from: [f64; 3], ball_radius: f64) -> f64 {
        let Some(radius) = self.radius else {
            return dot(along(from, self.real(), -1.0), unit(self.normal)) - ball_radius;
        };
        let centre = along(self.real(), unit(self.normal), -radius);
        let distance = norm(along(from, centre, -1.0));
        if 0.0 < radius { distance - radius - ball_radius } else { -radius - ball_radius - distance }
    }

    fn distance(&self, from: [f64; 3], direction: [f64; 3], ball_radius: f64) -> Option<f64> {
        let Some(radius) = self.radius else {
            let towards = -dot(direction, unit(self.normal));
            return (0.0 < towards).then(|| self.gap(from, ball_radius) / towards);
        };
        let centre = along(self.real(), unit(self.normal), -radius);
        let to = along(centre, from, -1.0);
        let ahead = dot(to, direction);
        let across = norm(along(to, direction, -ahead));
        // The ball's centre meets a sphere that is a ball's radius larger, or smaller inside a hollow.
        let reach = if 0.0 < radius { radius + ball_radius } else { -radius - ball_radius };
        let square = (reach - across) * (reach + across);
        if square < 0.0 {
            return None;
        }
        let distance = if 0.0 < radius { ahead - square.sqrt() } else { ahead + square.sqrt() };
        (0.0 <= distance).then_some(distance)
    }
}

fn check_place(point: [f64; 3], normal: [f64; 3], surface_scatter: f64) -> Result<(), WorkpieceError> {
    for part in point {
        in_range(Figure::Point, part, -FARTHEST, FARTHEST)?;
    }
    for part in normal {
        in_range(Figure::Normal, part, -FARTHEST, FARTHEST)?;
    }
    in_range(Figure::NormalLength, norm(normal), 1e-6, 2.0 * FARTHEST)?;
    in_range(Figure::SurfaceScatter, surface_scatter, 0.0, 1.0)
}

#[expect(
    clippy::as_conversions,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cast from float saturates, and the caller gives 16 to 20000"
)]
const fn whole(number: f64) -> u32 {
    number as u32
}
