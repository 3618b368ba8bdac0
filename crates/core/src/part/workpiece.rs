//! A plan as a simulated part, on which the programs of its set find every feature good.

use super::{FeatureKind, Plan, PlanFeature, WidthAxis};
use crate::length::Length;
use crate::probing::cycle::Plane;
use crate::probing::simulated::{Extent, Face, FreePoint, Part, PartFeature, Surface, Walls, Workpiece};

/// How far a face, or the surface about a point, reaches, mm.
const REACH: f64 = 5.0;

/// The shortest walls of a slot or ridge, mm; others are as long as they are apart.
const SHORTEST: f64 = 10.0;

impl Plan {
    /// All features of the plan that have a place, on one perfect part, in the middle of their zones, with a point as the probe.
    ///
    /// Walls begin at Z0, or where they are measured higher up, halfway between the measuring height and the clearance
    /// height. Slots and ridges are as long as wide, at least 10 mm; faces and the
    /// surfaces about points reach 5 mm.
    pub fn workpiece(&self) -> Part {
        Part::perfect(self.features().iter().filter_map(PlanFeature::on_part).collect())
    }
}

impl PlanFeature {
    /// This feature on a perfect part; `None` without a place.
    pub fn on_part(&self) -> Option<PartFeature> {
        part_of(self, self.place?)
    }
}

fn part_of(feature: &PlanFeature, place: [Length; 3]) -> Option<PartFeature> {
    let [x, y, z] = place.map(Length::to_mm_f64);
    let (limits, more) = feature.limits.split_first()?;
    let round = limits.feature?;
    let middle = limits.middle().to_mm_f64();
    let second = more.first().map(|limits| limits.middle().to_mm_f64());
    let walls = |angle| Surface::Walls(Walls { angle, ..Walls::new(round, [x, y], (middle, second)) });
    let surface = match &feature.kind {
        FeatureKind::Diameter(_) => Surface::Round(Workpiece::round(round, [x, y], middle), Plane::Xy),
        FeatureKind::Width(_, WidthAxis::X) | FeatureKind::Pocket(_) | FeatureKind::Boss(_) => walls(0.0),
        FeatureKind::Width(_, WidthAxis::Y) => walls(90.0),
        FeatureKind::Face(_, towards) => {
            let [first, second, third] = towards.vector();
            let one = |part: f64, place: f64| if 0.0 < part.abs() { middle } else { place };
            let point = [one(first, x), one(second, y), one(third, z)];
            Surface::Face(Face::plane(point, towards.vector().map(|part| 0.0 - part)))
        }
        FeatureKind::Point(_, direction) => {
            Surface::Point(FreePoint { deviation: middle, ..FreePoint::flat([x, y, z], direction.normal()) })
        }
        FeatureKind::Length(_) | FeatureKind::Form(_) => return None,
    };
    let usual = Extent::usual(&surface);
    let top = if z < 0.0 { usual.top } else { f64::midpoint(z, feature.clearance_height.to_mm_f64()) };
    let extent = match feature.kind {
        FeatureKind::Diameter(_) | FeatureKind::Pocket(_) | FeatureKind::Boss(_) => Extent { top, ..usual },
        FeatureKind::Width(..) => Extent { top, length: middle.max(SHORTEST), ..usual },
        FeatureKind::Face(..) | FeatureKind::Point(..) | FeatureKind::Length(_) | FeatureKind::Form(_) => {
            Extent { reach: REACH, ..usual }
        }
    };
    Some(PartFeature { name: feature.name.clone(), surface, extent })
}
