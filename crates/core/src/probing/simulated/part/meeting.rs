//! What a probing meets first.
//!
//! Where a feature is met as if it were alone, its own exact answer counts, the same to the last bit as that of a file
//! with nothing else. Edges, floors, and everything that a space is cut out of are found step by step: a step as long
//! as the gap to the nearest material never leads through it.

use super::super::nearest::advance;
use super::super::{FARTHEST, Surface, Walls};
use super::{PartFeature, Space};
use crate::probing::vector::along;
use crate::tolerance::Feature;

/// This close counts as met at once, and as no overlap, mm: a nanometre.
const AT_ONCE: f64 = 1e-6;

/// What a probing met: which feature, and how far away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct Met {
    pub feature: usize,
    pub distance: f64,
}

/// Why a probing has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Obstacle {
    /// There is nothing on its way.
    Nothing,
    /// The ball begins in the material of a feature.
    InMaterial(usize),
    /// The ball comes to the wall of a hole, slot or pocket from behind.
    Behind(usize),
    /// Two features are met at once, or the wall that is met is missing in another space.
    Ambiguous(usize, usize),
}

/// What a body, a face or a point says as if it were alone.
#[derive(Debug, Clone, Copy)]
enum Alone {
    /// It is met there.
    Met(Met),
    /// It is not met.
    Missed,
    /// Its edges, or a space that is cut out of it, may count.
    Unknown,
}

/// A probing of the part.
#[derive(Debug, Clone, Copy)]
struct Probing<'a> {
    space: &'a Space,
    from: [f64; 3],
    direction: [f64; 3],
    ball_radius: f64,
}

impl Space {
    /// What a ball meets along a unit vector.
    pub(in super::super) fn meet(
        &self,
        from: [f64; 3],
        direction: [f64; 3],
        ball_radius: f64,
    ) -> Result<Met, Obstacle> {
        if let Some(PartFeature { surface, .. }) = self.only() {
            if !surface.is_free(from, ball_radius) {
                return Err(Obstacle::InMaterial(0));
            }
            let distance = surface.distance(from, direction, ball_radius).ok_or(Obstacle::Nothing)?;
            return Ok(Met { feature: 0, distance });
        }
        Probing { space: self, from, direction, ball_radius }.meet()
    }
}

impl Probing<'_> {
    fn meet(&self) -> Result<Met, Obstacle> {
        let around: Vec<usize> = self
            .space
            .features()
            .filter(|(_, feature)| feature.is_around(self.from))
            .map(|(number, _)| number)
            .collect();
        self.check_start(&around)?;
        let mut known: Vec<Met> = Vec::new();
        let mut unknown: Vec<usize> = Vec::new();
        let widest = self.widest(&around);
        known.extend(widest);
        for (number, feature) in self.space.features() {
            if feature.is_space() {
                // The walls of other spaces are missing where this one is.
                let is_inner = around.contains(&number);
                let is_missing = around.iter().any(|own| self.space.do_cross(*own, number));
                let is_known = widest.is_some_and(|met| met.feature == number) && !self.goes_down(feature);
                if is_known || (is_inner && widest.is_some_and(|met| met.feature != number)) || is_missing {
                    continue;
                }
                unknown.push(number);
            } else {
                match self.alone(number, feature) {
                    Alone::Met(met) => known.push(met),
                    Alone::Missed => {}
                    Alone::Unknown => unknown.push(number),
                }
            }
        }
        let nearest =
            known.iter().copied().reduce(|one, other| if other.distance < one.distance { other } else { one });
        let met = self.first_of(nearest, &unknown).ok_or(Obstacle::Nothing)?;
        self.check_met(met, &around, &known, &unknown)?;
        Ok(met)
    }

    fn at(&self, distance: f64) -> [f64; 3] {
        along(self.from, self.direction, distance)
    }

    fn gap(&self, number: usize, distance: f64) -> f64 {
        self.space.gap(number, self.at(distance)) - self.ball_radius
    }

    /// Whether the way leads towards the floor of a space.
    fn goes_down(&self, feature: &PartFeature) -> bool {
        let (_, up) = feature.within(self.direction);
        up < 0.0 && feature.extent.bottom.is_finite()
    }

    /// The ball must begin in the open.
    fn check_start(&self, around: &[usize]) -> Result<(), Obstacle> {
        for (number, _) in self.space.features() {
            if around.contains(&number) {
                continue;
            }
            if around.iter().any(|own| self.space.do_cross(*own, number)) {
                continue;
            }
            if self.gap(number, 0.0) < -AT_ONCE {
                return Err(Obstacle::InMaterial(number));
            }
        }
        // Within several spaces it is enough to lie free in one of them.
        let is_free = |number: &usize| {
            self.space.feature(*number).is_some_and(|feature| feature.surface.is_free(self.from, self.ball_radius))
        };
        match around {
            [] => Ok(()),
            _ if around.iter().any(is_free) => Ok(()),
            [one] => Err(Obstacle::InMaterial(*one)),
            [one, other, ..] => Err(Obstacle::Ambiguous(*one, *other)),
        }
    }

    /// The wall of the space round the ball; of several, the last one: until there the ball has room in that space.
    fn widest(&self, around: &[usize]) -> Option<Met> {
        let mut widest: Option<Met> = None;
        for number in around {
            let Some(feature) = self.space.feature(*number) else { continue };
            if !feature.surface.is_free(self.from, self.ball_radius) {
                continue;
            }
            // Along the walls there is room without end.
            let distance = feature.surface.distance(self.from, self.direction, self.ball_radius)?;
            if widest.is_none_or(|met| met.distance < distance) {
                widest = Some(Met { feature: *number, distance });
            }
        }
        let met = widest?;
        let feature = self.space.feature(met.feature)?;
        let centre = self.at(met.distance);
        let (_, height) = feature.within(centre);
        // Beyond the top, the floor or the end of a slot there is no wall to meet.
        (feature.extent.has(height) && has_wall_beside(feature, centre)).then_some(met)
    }

    /// What a body, a face or a point says as if it were alone.
    fn alone(&self, number: usize, feature: &PartFeature) -> Alone {
        let met = || {
            let distance = feature.surface.distance(self.from, self.direction, self.ball_radius)?;
            (0.0 <= distance).then_some(Met { feature: number, distance })
        };
        if self.space.cutting(number).next().is_some() {
            return Alone::Unknown;
        }
        if feature.walls() == Some(Feature::Shaft) {
            let (_, height) = feature.within(self.from);
            let (_, up) = feature.within(self.direction);
            let is_level = up.abs() <= 0.0;
            if is_level && self.ball_radius < feature.extent.beyond(height) {
                return Alone::Missed;
            }
            if !feature.extent.has(height) || feature.extent.length.is_finite() {
                return Alone::Unknown;
            }
            return match met() {
                Some(met) if feature.extent.has(feature.within(self.at(met.distance)).1) => Alone::Met(met),
                None if is_level => Alone::Missed,
                _ => Alone::Unknown,
            };
        }
        match met() {
            Some(met) if feature.extent.reach.is_infinite() || feature.is_over(self.at(met.distance)) => {
                Alone::Met(met)
            }
            None if feature.extent.reach.is_infinite() => Alone::Missed,
            _ => Alone::Unknown,
        }
    }

    /// The first of what is known and what is found step by step.
    fn first_of(&self, nearest: Option<Met>, unknown: &[usize]) -> Option<Met> {
        let farthest = nearest.map_or(2.0 * FARTHEST, |met| met.distance);
        let gaps = |distance: f64| unknown.iter().map(move |number| (self.gap(*number, distance), *number));
        let least = |distance: f64| {
            gaps(distance).fold((f64::INFINITY, 0), |one, other| if other.0 < one.0 { other } else { one })
        };
        let Some(distance) = advance(|distance| least(distance).0, farthest) else { return nearest };
        let (_, feature) = least(distance);
        match nearest {
            Some(met) if met.distance <= distance + AT_ONCE => Some(met),
            _ => Some(Met { feature, distance }),
        }
    }

    /// Refuses what cannot be told: a wall from behind or where it is missing, and two features at once.
    fn check_met(&self, met: Met, around: &[usize], known: &[Met], unknown: &[usize]) -> Result<(), Obstacle> {
        let centre = self.at(met.distance);
        let of_known =
            known.iter().filter(|other| (other.distance - met.distance).abs() <= AT_ONCE).map(|met| met.feature);
        let of_unknown = unknown.iter().copied().filter(|number| self.gap(*number, met.distance) <= AT_ONCE);
        let all: Vec<usize> = of_known.chain(of_unknown).filter(|number| *number != met.feature).collect();
        for other in all {
            // What is implied gives way to what is declared.
            if self.is_implied(met.feature, centre) == self.is_implied(other, centre) {
                return Err(Obstacle::Ambiguous(met.feature, other));
            }
        }
        let Some(feature) = self.space.feature(met.feature) else { return Ok(()) };
        if !feature.is_space() {
            return Ok(());
        }
        let (flat, height) = feature.within(centre);
        let is_behind = feature.extent.has(height) && -AT_ONCE <= feature.outside(flat);
        if is_behind && !around.contains(&met.feature) {
            return Err(Obstacle::Behind(met.feature));
        }
        // The place that the ball touches lies a radius farther on than its centre.
        let touched = self.touched(feature, centre);
        let missing = self
            .space
            .features()
            .find(|(number, other)| self.space.do_cross(met.feature, *number) && other.is_around(touched));
        missing.map_or(Ok(()), |(other, _)| Err(Obstacle::Ambiguous(met.feature, other)))
    }

    /// Whether a feature is met at the top of a body or at the floor of a space.
    fn is_implied(&self, number: usize, centre: [f64; 3]) -> bool {
        let Some(feature) = self.space.feature(number) else { return false };
        let (flat, height) = feature.within(centre);
        match feature.walls() {
            Some(Feature::Shaft) => feature.outside(flat) < 0.0 && feature.extent.top < height,
            Some(Feature::Hole) => feature.gap_to_floor(centre) <= self.ball_radius + AT_ONCE,
            None => false,
        }
    }

    /// The place of the contour that a ball within a space touches.
    fn touched(&self, feature: &PartFeature, centre: [f64; 3]) -> [f64; 3] {
        let plane = feature.surface.plane();
        let ([first, second], height) = feature.within(centre);
        let outwards = match &feature.surface {
            Surface::Round(workpiece, _) => workpiece.outwards([first, second]),
            Surface::Walls(walls) => walls.outwards([first, second]),
            Surface::Face(_) | Surface::Point(_) => [0.0, 0.0],
        };
        let [along_first, along_second] = outwards.map(|part| part * self.ball_radius);
        plane.place([first + along_first, second + along_second, height])
    }
}

/// Whether the walls of a slot reach as far as a place beside its centre.
fn has_wall_beside(feature: &PartFeature, centre: [f64; 3]) -> bool {
    let (flat, _) = feature.within(centre);
    match &feature.surface {
        Surface::Walls(walls @ Walls { lengths: (_, None), .. }) => {
            let [_, beside] = walls.outside(flat, feature.extent.length);
            beside <= 0.0
        }
        _ => true,
    }
}
