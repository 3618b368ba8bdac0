//! A plan as a simulated part, on which the programs of its set find every feature good.

use super::{NcFeature, NcKind, NcPlan, PlanError, WidthAxis};
use crate::length::Length;
use crate::probing::cycle::Plane;
use crate::probing::simulated::{Extent, Face, FreePoint, Part, PartFeature, Surface, Walls, Workpiece};
use crate::tolerance::{Feature, Limits, Sources};

/// How far a face, or the surface about a point, reaches, mm.
const REACH: f64 = 5.0;

/// The shortest walls of a slot or ridge, mm; others are as long as they are apart.
const SHORTEST: f64 = 10.0;

impl NcPlan {
    /// All features of the plan on one perfect part, in the middle of their zones, with a point as the probe.
    ///
    /// Walls begin at Z0, or where they are measured higher up, halfway between the measuring height and the clearance
    /// height. Slots and ridges are as long as wide, at least 10 mm; faces and the
    /// surfaces about points reach 5 mm.
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

fn part_of(feature: &NcFeature, limits: &[Limits]) -> PartFeature {
    let [x, y, z] = [feature.x, feature.y, feature.z].map(Length::to_mm_f64);
    let mut middles = limits.iter().map(|limits| limits.middle().to_mm_f64());
    let (middle, second) = (middles.next().unwrap_or_default(), middles.next());
    let round = limits.first().map_or(Feature::Shaft, |limits| limits.feature);
    let walls = |angle| Surface::Walls(Walls { angle, ..Walls::new(round, [x, y], (middle, second)) });
    let surface = match &feature.kind {
        NcKind::Diameter(_) => Surface::Round(Workpiece::round(round, [x, y], middle), Plane::Xy),
        NcKind::Width(_, WidthAxis::X) | NcKind::Pocket(_) | NcKind::Boss(_) => walls(0.0),
        NcKind::Width(_, WidthAxis::Y) => walls(90.0),
        NcKind::Face(_, towards) => {
            let [first, second, third] = towards.vector();
            let one = |part: f64, place: f64| if 0.0 < part.abs() { middle } else { place };
            let point = [one(first, x), one(second, y), one(third, z)];
            Surface::Face(Face::plane(point, towards.vector().map(|part| 0.0 - part)))
        }
        NcKind::Point(_, direction) => {
            Surface::Point(FreePoint { deviation: middle, ..FreePoint::flat([x, y, z], direction.normal()) })
        }
    };
    let usual = Extent::usual(&surface);
    let top = if z < 0.0 { usual.top } else { f64::midpoint(z, feature.clearance_height.to_mm_f64()) };
    let extent = match feature.kind {
        NcKind::Diameter(_) | NcKind::Pocket(_) | NcKind::Boss(_) => Extent { top, ..usual },
        NcKind::Width(..) => Extent { top, length: middle.max(SHORTEST), ..usual },
        NcKind::Face(..) | NcKind::Point(..) => Extent { reach: REACH, ..usual },
    };
    PartFeature { name: feature.name.clone(), surface, extent }
}
