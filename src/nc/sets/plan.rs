//! Which features a set measures, and where.

use super::called::Called;
use super::cells::is_band_of_cycle;
use super::error::{PlanError, PlanFault};
use super::kind::{NcKind, Towards};
use super::names::Control;
use crate::length::Length;
use crate::message::Place;
use crate::probing::cycle::{Angle, Axis, Meaning};
use crate::probing::cycles::measuring;
use crate::tolerance::{Callout, Feature, Limits, Source, Sources, Tolerance};

/// The most features of a plan: a control opens a window for each.
pub const MOST_FEATURES: usize = 1_000;

/// The lateral clearance if none is given, 2 mm: it is added to the probe's own.
pub const DEFAULT_CLEARANCE: Length = Length::from_micrometres(2_000);

/// The clearance height if none is given, 50 mm above the preset.
pub const DEFAULT_CLEARANCE_HEIGHT: Length = Length::from_micrometres(50_000);

/// The most characters of a feature's name: with its prefix and suffix, a file name has at most 29.
const LONGEST_NAME: usize = 20;

/// A feature of a plan: the seven inputs of NC-Solution 8255 (NC-Solutions, description of NC program 8255), the
/// clearance height, which that program leaves open, and a name.
#[derive(Debug, Clone, PartialEq)]
pub struct NcFeature {
    /// What is measured of it, with nominal sizes and classes (Q1, QS1).
    pub kind: NcKind,
    /// Its name: ASCII letters, digits and `_`, at most 20; if empty, it becomes `F` and its number.
    pub name: String,
    /// Centre in X, or the point's place (Q11), ±99999.9999 mm.
    pub x: Length,
    /// Centre in Y, or the point's place (Q21), ±99999.9999 mm.
    pub y: Length,
    /// Measuring height in Z, or the point's place (Q31), ±99999.9999 mm.
    pub z: Length,
    /// Angle of the first contact from +X (Q41), ±360 degrees.
    pub angle: Angle,
    /// Lateral set-up clearance (Q51), 0 to 99999.9999 mm, added to the probe's own.
    pub clearance: Length,
    /// Where the probe moves without a collision (Q61), above the measuring height.
    pub clearance_height: Length,
}

impl NcFeature {
    /// A diameter at X, Y, Z without a name; angle 0, and the usual clearances.
    pub fn new(callout: Callout, place: [Length; 3]) -> Self {
        Self::of_kind(NcKind::Diameter(callout), place)
    }

    /// The same with anything that can be measured.
    pub fn of_kind(kind: NcKind, [x, y, z]: [Length; 3]) -> Self {
        Self {
            kind,
            name: String::new(),
            x,
            y,
            z,
            angle: Angle::default(),
            clearance: DEFAULT_CLEARANCE,
            clearance_height: DEFAULT_CLEARANCE_HEIGHT,
        }
    }

    /// Checks that a program can use it.
    fn check(&self) -> Result<(), PlanFault> {
        for callout in self.kind.callouts() {
            match callout.tolerance() {
                Tolerance::Class(_) => {}
                Tolerance::Fit { .. } => return Err(PlanFault::Fit { callout }),
                _ => return Err(PlanFault::NoClass { callout }),
            }
        }
        self.check_kind()?;
        let is_sound = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
        if LONGEST_NAME < self.name.chars().count() || !self.name.bytes().all(is_sound) {
            let name = self.name.chars().take(2 * LONGEST_NAME).collect();
            return Err(PlanFault::Name { name, most: LONGEST_NAME });
        }
        in_range(Meaning::Centre(Axis::First), &self.x)?;
        in_range(Meaning::Centre(Axis::Second), &self.y)?;
        in_range(Meaning::MeasuringHeight, &self.z)?;
        in_range(Meaning::FirstAngle, &self.angle)?;
        in_range(Meaning::SetUpClearance, &self.clearance)?;
        in_range(Meaning::ClearanceHeight, &self.clearance_height)?;
        if self.clearance_height <= self.z {
            return Err(PlanFault::ClearanceHeight { height: self.clearance_height, z: self.z });
        }
        Ok(())
    }

    fn check_kind(&self) -> Result<(), PlanFault> {
        if !matches!(self.kind, NcKind::Diameter(_)) && self.angle != Angle::default() {
            return Err(PlanFault::NotOf { column: "angle", kind: self.kind.word() });
        }
        match &self.kind {
            NcKind::Diameter(_) | NcKind::Width(..) => Ok(()),
            NcKind::Face(callout, towards) => self.check_face(*callout, *towards),
            NcKind::Pocket(sides) => self.check_sides(sides, Feature::Hole, "H7"),
            NcKind::Boss(sides) => self.check_sides(sides, Feature::Shaft, "h7"),
            NcKind::Point(band, _) if is_band_of_cycle(band) => Ok(()),
            NcKind::Point(band, _) => Err(PlanFault::BandSide { upper: band.upper(), lower: band.lower() }),
        }
    }

    /// The coordinate of a face is the nominal size, and it is judged as an outside dimension: too large is rework.
    fn check_face(&self, callout: Callout, towards: Towards) -> Result<(), PlanFault> {
        if callout.feature() == Some(Feature::Hole) {
            return Err(PlanFault::FaceClass { callout });
        }
        let coordinate = match towards.axis {
            Axis::First => self.x,
            Axis::Second => self.y,
            Axis::Third => self.z,
        };
        if coordinate == callout.nominal() { Ok(()) } else { Err(PlanFault::FacePlace { callout, coordinate }) }
    }

    /// The word and the letters say the same.
    fn check_sides(&self, sides: &[Callout; 2], feature: Feature, example: &'static str) -> Result<(), PlanFault> {
        match sides.iter().find(|callout| callout.feature() != Some(feature)) {
            Some(callout) => Err(PlanFault::SideClass { callout: *callout, kind: self.kind.word(), example }),
            None => Ok(()),
        }
    }

    /// The limits of every size; those of a point count from its nominal place, as an outside dimension.
    fn limits(&self, sources: &Sources) -> Result<Vec<Limits>, PlanFault> {
        if let NcKind::Point(band, _) = self.kind {
            return Ok(Limits::new(Feature::Shaft, Length::ZERO, band, Source::Callout).into_iter().collect());
        }
        let limits = self.kind.callouts().into_iter().map(|callout| {
            let limits = sources.limits(&callout, None);
            let limits = limits.map_err(|error| PlanFault::Limits { callout, error: Box::new(error) })?;
            // Far below a millimetre a class can reach below 0, which no cycle accepts.
            in_range(Meaning::MinimumDiameter, &limits.minimum())?;
            Ok(limits)
        });
        limits.collect()
    }
}

/// A plan that can become a program: at least one feature, every value in its range, no name twice.
#[derive(Debug, Clone, PartialEq)]
pub struct NcPlan {
    features: Vec<NcFeature>,
    /// The line of each feature in its file.
    lines: Vec<usize>,
}

impl NcPlan {
    /// A plan of features; those without a name get one.
    ///
    /// # Errors
    /// [`PlanError`] for the first feature that is impossible.
    pub fn new(features: Vec<NcFeature>) -> Result<Self, PlanError> {
        Self::of_lines(features, Vec::new())
    }

    /// The same for a file; `lines` are those of the features.
    pub(super) fn of_lines(mut features: Vec<NcFeature>, lines: Vec<usize>) -> Result<Self, PlanError> {
        if features.is_empty() {
            return Err(located(None, PlanFault::NoFeatures));
        }
        if MOST_FEATURES < features.len() {
            return Err(located(None, PlanFault::TooMany { most: MOST_FEATURES }));
        }
        let mut names = std::collections::BTreeSet::new();
        for (number, feature) in features.iter_mut().enumerate() {
            feature.check().map_err(|what| located(lines.get(number), what))?;
            if feature.name.is_empty() {
                feature.name = format!("F{}", number + 1);
            }
            // The names of the result files differ only by it, and for a control a and A are the same file.
            if !names.insert(feature.name.to_ascii_uppercase()) {
                let what = PlanFault::SameName { name: feature.name.clone() };
                return Err(located(lines.get(number), what));
            }
        }
        Ok(Self { features, lines })
    }

    /// The features, in the order in which they are measured.
    pub fn features(&self) -> &[NcFeature] {
        &self.features
    }

    /// Refuses features that are measured by a cycle that the control does not have.
    pub(super) fn check_control(&self, control: Control) -> Result<(), PlanError> {
        for (number, feature) in self.features.iter().enumerate() {
            let kind = &feature.kind;
            // Both cycles of a kind are on the same controls.
            if let Some(cycle) = Called::of(kind).cycle(Feature::Shaft).filter(|cycle| !control.has(cycle)) {
                let (kind, cycle, control) = (kind.word(), cycle.code, control.name());
                return Err(located(self.lines.get(number), PlanFault::NotOnControl { kind, cycle, control }));
            }
        }
        Ok(())
    }

    /// The limits of every feature: one of each size.
    pub(super) fn limits(&self, sources: &Sources) -> Result<Vec<Vec<Limits>>, PlanError> {
        let limits = self
            .features
            .iter()
            .enumerate()
            .map(|(number, feature)| feature.limits(sources).map_err(|what| located(self.lines.get(number), what)));
        limits.collect()
    }
}

/// Checks a value against the range of a parameter; both cycles have these parameters, with the same ranges.
fn in_range(meaning: Meaning, value: &impl ToString) -> Result<(), PlanFault> {
    let Some(parameter) = measuring(Feature::Hole).meant(meaning) else { return Ok(()) };
    let value = value.to_string();
    match parameter.accept(value.trim_end_matches('°')) {
        Ok(_value) => Ok(()),
        Err(error) => Err(PlanFault::Range(Box::new(error))),
    }
}

/// A fault with its line, if there is a file.
fn located(line: Option<&usize>, what: PlanFault) -> PlanError {
    PlanError { what, place: Place { line: line.copied(), ..Place::default() } }
}
