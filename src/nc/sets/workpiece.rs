//! A plan as a simulated part, on which the programs of its set find every feature good.

use super::{NcFeature, NcKind, NcPlan, PlanError};
use crate::length::Length;
use crate::probing::cycle::Plane;
use crate::probing::simulated::{Extent, Face, Part, PartFeature, Surface, Walls, Workpiece};
use crate::tolerance::{Limits, Sources};

/// How far a face reaches about its point, mm.
const REACH: f64 = 5.0;

/// The shortest walls of a slot or ridge, mm; others are as long as they are apart.
const SHORTEST: f64 = 10.0;

impl NcPlan {
    /// All features of the plan on one perfect part, in the middle of their zones, with a point as the probe.
    ///
    /// Walls begin at Z0, or where they are measured higher up, halfway between the measuring height and the clearance
    /// height. Slots and ridges are as long as wide, at least 10 mm; faces reach 5 mm about their point.
    ///
    /// # Errors
    /// [`PlanError`] if a feature has no limits.
    pub fn workpiece(&self, sources: &Sources) -> Result<Part, PlanError> {
        let limits = self.limits(sources)?;
        Ok(Part::perfect(
            self.features().iter().zip(&limits).map(|(feature, limits)| part_of(feature, limits)).collect(),
        ))
    }
}

fn part_of(feature: &NcFeature, limits: &Limits) -> PartFeature {
    let [x, y, z] = [feature.x, feature.y, feature.z].map(Length::to_mm_f64);
    let middle = limits.middle().to_mm_f64();
    let direction = feature.kind.direction();
    let surface = match feature.kind {
        NcKind::Diameter => Surface::Round(Workpiece::round(limits.feature, [x, y], middle), Plane::Xy),
        NcKind::Width(_) => {
            let [_, second, _] = direction;
            let angle = if 0.0 < second { 90.0 } else { 0.0 };
            Surface::Walls(Walls { angle, ..Walls::new(limits.feature, [x, y], (middle, None)) })
        }
        NcKind::Face(_) => {
            let [first, second, third] = direction;
            let one = |part: f64, place: f64| if 0.0 < part.abs() { middle } else { place };
            Surface::Face(Face::plane([one(first, x), one(second, y), one(third, z)], direction.map(|part| 0.0 - part)))
        }
    };
    let usual = Extent::usual(&surface);
    let top = if z < 0.0 { usual.top } else { f64::midpoint(z, feature.clearance_height.to_mm_f64()) };
    let extent = match feature.kind {
        NcKind::Diameter => Extent { top, ..usual },
        NcKind::Width(_) => Extent { top, length: middle.max(SHORTEST), ..usual },
        NcKind::Face(_) => Extent { reach: REACH, ..usual },
    };
    PartFeature { name: feature.name.clone(), surface, extent }
}
