//! A plan without a fault: what is measured of a part, and by which limits it is judged.

use crate::length::Length;
use crate::probing::cycle::{Angle, Cycle, Inputs};
use crate::tolerance::fit::thermal::Expansion;
use crate::tolerance::{Callout, Feature, Limits};
use crate::verdict::Rule;

use super::kind::FeatureKind;
use super::plausible::Plausible;

/// The most features of a plan: a control opens a window for each.
pub const MOST_FEATURES: usize = 1_000;

/// The lateral clearance if none is given, 2 mm: it is added to the probe's own.
pub const DEFAULT_CLEARANCE: Length = Length::from_micrometres(2_000);

/// The clearance height if none is given, 50 mm above the preset.
pub const DEFAULT_CLEARANCE_HEIGHT: Length = Length::from_micrometres(50_000);

/// What a plan says of the part as a whole. Texts are empty where it says nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Head {
    /// The part's name or number.
    pub part: String,
    /// The drawing.
    pub drawing: String,
    /// The file name of its picture.
    pub picture: String,
    /// Anything else.
    pub remark: String,
}

/// What a feature is made of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Material {
    /// As the plan names it.
    pub name: String,
    /// How much it expands.
    pub expansion: Expansion,
}

/// A feature of a plan: the seven inputs of NC-Solution 8255 (NC-Solutions, description of NC program 8255), the clearance height, which
/// that program leaves open, and what the plan says of judging and showing it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanFeature {
    /// The line of its file, where it is from one.
    pub line: Option<usize>,
    /// The number of its balloon; empty where it has none.
    pub number: String,
    /// Its name; if none is given, `F` and its position in the plan.
    pub name: String,
    /// What is measured of it, with nominal sizes and tolerances (Q1, QS1).
    pub kind: FeatureKind,
    /// The limits of every size; those of a point count from its nominal place, as an outside dimension.
    pub limits: Vec<Limits>,
    /// Centre in X and Y and measuring height in Z, or the point's place (Q11, Q21, Q31), ±99999.9999 mm; `None` where one of
    /// them is not given: it can be typed or read from a file, and not be measured by a program.
    pub place: Option<[Length; 3]>,
    /// The same as far as the plan says it: a value may be found by two axes.
    pub axes: [Option<Length>; 3],
    /// Angle of the first contact from +X (Q41), ±360 degrees.
    pub angle: Angle,
    /// Lateral set-up clearance (Q51), 0 to 99999.9999 mm, added to the probe's own.
    pub clearance: Length,
    /// Where the probe moves without a collision (Q61), above the measuring height.
    pub clearance_height: Length,
    /// The cycle that measures it; `None` where no cycle does.
    pub cycle: Option<&'static Cycle>,
    /// Further parameters of that cycle.
    pub parameters: Inputs,
    /// Whether the plan names the cycle or gives further parameters.
    pub has_own_cycle: bool,
    /// What it is made of, where the plan says so.
    pub material: Option<Material>,
    /// The decision rule, where the plan says so; with an uncertainty alone it is the control's.
    pub rule: Option<Rule>,
    /// Whether the plan names the rule, and not an uncertainty alone.
    pub has_own_rule: bool,
    /// What a value of each of its sizes can be at all, where the plan says so.
    pub plausible: [Option<Plausible>; 2],
    /// Anything else.
    pub remark: String,
    /// Where its balloon is on the picture, from 0 to 1 from the left and from the top.
    pub balloon: Option<[f64; 2]>,
}

/// One size of a feature: what a value is judged by.
#[derive(Debug, Clone, PartialEq)]
pub struct Size<'a> {
    /// The feature.
    pub feature: &'a PlanFeature,
    /// Which of its sizes, from 0.
    pub side: usize,
    /// The callout; a point has none.
    pub callout: Option<Callout>,
    /// Its limits.
    pub limits: &'a Limits,
    /// What a value of it can be at all, where the plan says so.
    pub plausible: Option<Plausible>,
}

impl Size<'_> {
    /// The feature's name, with the side where it has two: `K1 X`.
    pub fn name(&self) -> String {
        match self.feature.kind.sides().get(self.side) {
            Some(side) if !side.is_empty() => format!("{} {side}", self.feature.name),
            _ => self.feature.name.clone(),
        }
    }

    /// What a value can be, where this one, as it was measured, cannot; `None` of a value that can.
    pub fn excludes(&self, measured: Length) -> Option<Plausible> {
        self.plausible.filter(|range| !range.admits(measured))
    }
}

impl PlanFeature {
    /// Its sizes, in the order of its callouts.
    pub fn sizes(&self) -> impl Iterator<Item = Size<'_>> {
        let callouts = self.kind.callouts();
        let sides = (0..).zip(&self.limits);
        sides.map(move |(side, limits)| {
            let plausible = self.plausible.get(side).copied().flatten();
            Size { feature: self, side, callout: callouts.get(side).copied(), limits, plausible }
        })
    }

    /// Whether it is a hole or a shaft; a face and a point count as outside dimensions. `None` of a length or form of which nobody says it.
    pub fn feature(&self) -> Option<Feature> {
        self.limits.first()?.feature
    }
}

/// A plan: at least one feature, every value in its range, no name twice.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What it says of the part.
    pub head: Head,
    pub(super) features: Vec<PlanFeature>,
}

impl Plan {
    /// The features, in the order in which they are measured.
    pub fn features(&self) -> &[PlanFeature] {
        &self.features
    }

    /// Every size of every feature.
    pub fn sizes(&self) -> impl Iterator<Item = Size<'_>> {
        self.features.iter().flat_map(PlanFeature::sizes)
    }
}
