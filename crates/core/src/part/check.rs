//! A draft becomes a plan, or all its faults are told at once.

use std::str::FromStr;

use super::cells::{KindCells, check_kind, side_of};
use super::column::{Column, HeadField};
use super::draft::{Draft, DraftFeature};
use super::fault::PlanFault;
use super::kind::FeatureKind;
use super::measured_by;
use super::names::Names;
use super::plan::{DEFAULT_CLEARANCE, DEFAULT_CLEARANCE_HEIGHT, Head, MOST_FEATURES, Material, Plan, PlanFeature};
use super::plausible::Plausible;
use super::spot::{Finding, Spot};
use super::values::{beginning, in_range, material, plain_text, plausible, rule, travel};
use crate::length::{Length, LengthError};
use crate::probing::cycle::{Angle, Axis, Cycle, Inputs, Meaning, number};
use crate::tolerance::{Deviations, Feature, Limits, LimitsError, Source, Sources, Tolerance};
use crate::verdict::Rule;

/// The most characters of a name or a number.
const LONGEST_NAME: usize = 80;

/// The most characters of another text.
const LONGEST_TEXT: usize = 1_000;

/// A draft that was read: its features as far as nothing is wrong with them, and everything that is.
#[derive(Debug, Clone, Default)]
pub struct Review {
    /// What it says of the part.
    pub head: Head,
    /// A place for every row; `None` where something is wrong with it.
    pub features: Vec<Option<PlanFeature>>,
    /// What is wrong, in the order of the plan.
    pub findings: Vec<Finding>,
}

impl Review {
    /// Reads a draft. Limits are looked up in the sources, materials among those that are built in.
    pub fn of(draft: &Draft, sources: &Sources) -> Self {
        let mut faults = Faults::default();
        if draft.rows.is_empty() {
            faults.add(Spot::Plan, PlanFault::NoFeatures);
        }
        if MOST_FEATURES < draft.rows.len() {
            faults.add(Spot::Plan, PlanFault::TooMany { most: MOST_FEATURES });
        }
        let (head, shared) = head(draft, &mut faults);
        let mut names = Names::default();
        let rows = (0..).zip(draft.rows.iter().take(MOST_FEATURES));
        let features = rows
            .map(|(at, row)| {
                let mut reader = Reader { at, row, faults: &mut faults, sources, shared: &shared };
                reader.feature(&mut names)
            })
            .collect();
        faults.all.sort_by_key(|finding| finding.spot);
        Self { head, features, findings: faults.all }
    }

    /// The plan, where nothing is wrong with it.
    pub fn plan(&self) -> Option<Plan> {
        let features = || self.features.iter().flatten().cloned().collect();
        self.findings.is_empty().then(|| Plan { head: self.head.clone(), features: features() })
    }
}

impl Plan {
    /// What a draft says. Limits are looked up in the sources, materials among those that are built in.
    ///
    /// # Errors
    /// Every fault of every feature, in the order of the plan.
    pub fn of(draft: &Draft, sources: &Sources) -> Result<Self, Vec<Finding>> {
        let review = Review::of(draft, sources);
        review.plan().ok_or(review.findings)
    }
}

/// What was found so far.
#[derive(Default)]
struct Faults {
    all: Vec<Finding>,
}

impl Faults {
    fn add(&mut self, spot: Spot, what: PlanFault) {
        self.all.push(Finding { spot, what });
    }

    fn take<T>(&mut self, spot: Spot, read: Result<T, PlanFault>) -> Option<T> {
        read.map_err(|what| self.add(spot, what)).ok()
    }
}

/// What holds for every feature that says nothing itself.
#[derive(Default)]
struct Shared {
    material: Option<Material>,
    rule: Option<String>,
    uncertainty: Option<String>,
    /// The machine's travel in X, Y and Z.
    travel: [Option<[Length; 2]>; 3],
}

fn head(draft: &Draft, faults: &mut Faults) -> (Head, Shared) {
    let mut text = |field: HeadField| {
        let checked = plain_text(draft.cell(field).text.trim(), field.key(), LONGEST_TEXT);
        // What is wrong is told, and no text.
        faults.take(Spot::Head(field), checked).into_iter().collect()
    };
    let head = Head {
        part: text(HeadField::Part),
        drawing: text(HeadField::Drawing),
        picture: text(HeadField::Picture),
        remark: text(HeadField::Remark),
    };
    let of = |field| draft.text(field).map(str::to_owned);
    let mut shared = Shared { rule: of(HeadField::Rule), uncertainty: of(HeadField::Uncertainty), ..Shared::default() };
    if let Some(text) = draft.text(HeadField::Material) {
        shared.material = faults.take(Spot::Head(HeadField::Material), material(text));
    }
    let mut is_told = false;
    // A rule that cannot judge is told once, here, and not with every feature.
    for (column, what) in rule(shared.rule.as_deref(), shared.uncertainty.as_deref()).err().into_iter().flatten() {
        let field = if column == Column::Rule { HeadField::Rule } else { HeadField::Uncertainty };
        // An uncertainty of its own may complete the rule of a feature.
        if !(column == Column::Rule && shared.uncertainty.is_none() && matches!(what, PlanFault::Rule { .. })) {
            faults.add(Spot::Head(field), what);
            is_told = true;
        }
    }
    if is_told {
        shared.rule = None;
        shared.uncertainty = None;
    }
    for (axis, field) in [HeadField::TravelX, HeadField::TravelY, HeadField::TravelZ].into_iter().enumerate() {
        if let (Some(text), Some(place)) = (draft.text(field), shared.travel.get_mut(axis)) {
            *place = faults.take(Spot::Head(field), travel(text));
        }
    }
    (head, shared)
}

/// One feature of a draft.
struct Reader<'a> {
    at: usize,
    row: &'a DraftFeature,
    faults: &'a mut Faults,
    sources: &'a Sources,
    shared: &'a Shared,
}

impl Reader<'_> {
    fn fault(&mut self, column: Column, what: PlanFault) {
        self.faults.add(Spot::Feature(self.at, Some(column)), what);
    }

    fn take<T>(&mut self, column: Column, read: Result<T, PlanFault>) -> Option<T> {
        self.faults.take(Spot::Feature(self.at, Some(column)), read)
    }

    /// The feature; `None` where anything of it is wrong, which is told.
    fn feature(&mut self, names: &mut Names) -> Option<PlanFeature> {
        let before = self.faults.all.len();
        let number = self.text(Column::Number, LONGEST_NAME);
        let name = self.text(Column::Name, LONGEST_NAME);
        let name = if name.is_empty() { format!("F{}", self.at + 1) } else { name };
        let place = self.place();
        let angle = self.value(Column::Angle, Meaning::FirstAngle).unwrap_or(Angle::from_degrees(0));
        let clearance = self.value(Column::Clearance, Meaning::SetUpClearance).unwrap_or(DEFAULT_CLEARANCE);
        let clearance_height =
            self.value(Column::ClearanceHeight, Meaning::ClearanceHeight).unwrap_or(DEFAULT_CLEARANCE_HEIGHT);
        if let [_, _, Some(z)] = place
            && clearance_height <= z
        {
            self.fault(Column::ClearanceHeight, PlanFault::ClearanceHeight { height: clearance_height, z });
        }
        self.within_travel(place, clearance_height);
        let side = self.side();
        let kind = self.kind(place, angle);
        let side = self.side_of_kind(kind.as_ref(), side);
        let sides = kind.as_ref().map_or(&[""][..], FeatureKind::sides);
        for (column, what) in names.take(self.row.place.line, &number, &name, sides) {
            self.fault(column, what);
        }
        // Letters that do not go with the kind have no limits that would say more.
        let limits = kind.as_ref().filter(|kind| check_kind(kind, place).is_empty());
        let limits = limits.and_then(|kind| self.limits(kind, side));
        // Whether a hole or a shaft is measured may be known without limits; where it is not, no cycle is the wrong one.
        let first = limits.as_ref().and_then(|limits| limits.first()?.feature);
        let letters = kind.as_ref().and_then(|kind| kind.callouts().first()?.feature());
        let feature = first.or(letters).or(side);
        let cycle = self.cycle(
            kind.as_ref().filter(|kind| feature.is_some() || kind.is_by_hand()),
            feature.unwrap_or(Feature::Shaft),
        );
        let parameters = self.parameters(cycle);
        let material = self.material();
        let rule = self.rule();
        let plausible = self.plausible(kind.as_ref(), limits.as_deref());
        let remark = self.text(Column::Remark, LONGEST_TEXT);
        let balloon = self.balloon();
        let (kind, limits) = kind.zip(limits)?;
        let [x, y, z] = place;
        (self.faults.all.len() == before).then_some(PlanFeature {
            line: self.row.place.line,
            number,
            name,
            kind,
            limits,
            place: x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]),
            axes: place,
            angle,
            clearance,
            clearance_height,
            cycle,
            parameters,
            has_own_cycle: self.row.text(Column::Cycle).is_some() || self.row.text(Column::Parameters).is_some(),
            material,
            rule,
            has_own_rule: self.row.text(Column::Rule).is_some() || self.shared.rule.is_some(),
            plausible,
            remark,
            balloon,
        })
    }

    fn text(&mut self, column: Column, most: usize) -> String {
        let checked = plain_text(self.row.said(column), column.key(), most);
        // What is wrong is told, and no text.
        self.take(column, checked).into_iter().collect()
    }

    /// A value within the range of a parameter of the cycles.
    fn value<T: FromStr<Err = LengthError> + ToString>(&mut self, column: Column, meaning: Meaning) -> Option<T> {
        let text = self.row.text(column)?;
        let read = text.parse::<T>().map_err(|error| PlanFault::Number { column: column.key(), error });
        let value = self.take(column, read)?;
        let range = in_range(meaning, &value);
        self.take(column, range)?;
        Some(value)
    }

    fn place(&mut self) -> [Option<Length>; 3] {
        let columns = [
            (Column::X, Meaning::Centre(Axis::First), "X"),
            (Column::Y, Meaning::Centre(Axis::Second), "Y"),
            (Column::Z, Meaning::MeasuringHeight, "Z"),
        ];
        let mut at = 0;
        columns.map(|(column, meaning, axis)| {
            let value: Option<Length> = self.value(column, meaning);
            let travel = self.shared.travel.get(at).copied().flatten();
            at += 1;
            if let (Some(given), Some([minimum, maximum])) = (value, travel)
                && !(minimum <= given && given <= maximum)
            {
                self.fault(column, PlanFault::Travel { axis, given, minimum, maximum });
            }
            value
        })
    }

    /// The probe moves at the clearance height above what a program measures.
    fn within_travel(&mut self, place: [Option<Length>; 3], height: Length) {
        let [.., travel] = self.shared.travel;
        if let Some([minimum, maximum]) = travel
            && place.iter().all(Option::is_some)
            && !(minimum <= height && height <= maximum)
        {
            let what = PlanFault::ClearanceTravel { height, minimum, maximum };
            self.fault(Column::ClearanceHeight, what);
        }
    }

    /// Hole or shaft, where the plan says it.
    fn side(&mut self) -> Option<Feature> {
        let text = self.row.text(Column::Feature)?;
        let words = [Feature::Hole, Feature::Shaft].map(Feature::word);
        let found = [Feature::Hole, Feature::Shaft].into_iter().find(|side| side.word().eq_ignore_ascii_case(text));
        let unknown = || PlanFault::Unknown { column: "feature", given: beginning(text), known: words.join(", ") };
        self.take(Column::Feature, found.ok_or_else(unknown))
    }

    /// The same where the word for the kind says it.
    fn side_of_kind(&mut self, kind: Option<&FeatureKind>, side: Option<Feature>) -> Option<Feature> {
        let Some(word) = self.row.text(Column::Kind) else { return side };
        let Some(of_kind) = side_of(word).filter(|_| kind.is_some()) else { return side };
        if let Some(other) = side.filter(|side| *side != of_kind) {
            let (given, text) = (beginning(word), other.word().to_owned());
            let what = PlanFault::OtherSide { given, column: "feature", text, side: other };
            self.fault(Column::Kind, what);
        }
        // The letters of a callout that says the other one have their fault already.
        let letters = kind.and_then(|kind| kind.callouts().first()?.feature());
        side.or(letters.is_none().then_some(of_kind))
    }

    fn kind(&mut self, place: [Option<Length>; 3], angle: Angle) -> Option<FeatureKind> {
        let callout = self.row.text(Column::Callout);
        if callout.is_none() {
            self.fault(Column::Callout, PlanFault::NoCell { column: "callout" });
        }
        let kind = self.row.text(Column::Kind);
        let axis = self.row.text(Column::Axis);
        let second = self.row.text(Column::SecondCallout);
        let (kind, faults) = KindCells { kind, axis, callout: self.row.said(Column::Callout), second }.read_all();
        for (column, what) in faults.into_iter().filter(|(column, _)| callout.is_some() || *column != Column::Callout) {
            self.fault(column, what);
        }
        let kind = kind?;
        if !matches!(kind, FeatureKind::Diameter(_)) && angle != Angle::default() {
            self.fault(Column::Angle, PlanFault::NotOf { column: "angle", kind: kind.word() });
        }
        for (column, what) in check_kind(&kind, place) {
            self.fault(column, what);
        }
        Some(kind)
    }

    fn limits(&mut self, kind: &FeatureKind, side: Option<Feature>) -> Option<Vec<Limits>> {
        if let FeatureKind::Point(band, _) = kind {
            let in_proportion = self.sources.proportionate_coordinate(Length::ZERO, *band);
            let in_proportion = in_proportion.map_err(|error| PlanFault::Band(Box::new(error)));
            self.take(Column::Callout, in_proportion)?;
            return Some(Limits::new(Feature::Shaft, Length::ZERO, *band, Source::Callout).into_iter().collect());
        }
        if let FeatureKind::Form(most) = kind {
            let band = Deviations::new(*most, Length::ZERO).ok();
            return Some(
                band.and_then(|band| Limits::new(None, Length::ZERO, band, Source::Callout)).into_iter().collect(),
            );
        }
        // A face is judged as an outside dimension; a pocket has sides inside, a boss outside.
        let side = match kind {
            FeatureKind::Face(..) | FeatureKind::Boss(_) => side.or(Some(Feature::Shaft)),
            FeatureKind::Pocket(_) => side.or(Some(Feature::Hole)),
            _ => side,
        };
        let mut all = Vec::new();
        for (callout, column) in kind.callouts().into_iter().zip([Column::Callout, Column::SecondCallout]) {
            let limits = if matches!(callout.tolerance(), Tolerance::Fit { .. }) {
                Err(PlanFault::Fit { callout })
            } else {
                let limits = match kind {
                    FeatureKind::Face(..) => self.sources.coordinate_limits(&callout, side),
                    FeatureKind::Length(_) => self.sources.limits(&callout, side),
                    _ => self.sources.feature_limits(&callout, side),
                };
                limits.map_err(|error| match error {
                    LimitsError::NoFeature { callout } => PlanFault::NoFeature { callout },
                    error => PlanFault::Limits { callout, error: Box::new(error) },
                })
            };
            let Some(limits) = self.take(column, limits) else { continue };
            // Far below a millimetre a class can reach below 0, which no cycle accepts.
            let range = in_range(Meaning::MinimumDiameter, &limits.minimum());
            if !matches!(kind, FeatureKind::Face(..) | FeatureKind::Length(_)) {
                self.take(column, range);
            }
            all.push(limits);
        }
        Some(all).filter(|all| !all.is_empty())
    }

    fn cycle(&mut self, kind: Option<&FeatureKind>, feature: Feature) -> Option<&'static Cycle> {
        let read = measured_by::cycle(self.row.text(Column::Cycle), kind, feature);
        self.take(Column::Cycle, read).flatten()
    }

    fn parameters(&mut self, cycle: Option<&'static Cycle>) -> Inputs {
        measured_by::parameters(self.row.said(Column::Parameters), cycle).unwrap_or_else(|faults| {
            for what in faults {
                self.fault(Column::Parameters, what);
            }
            Inputs::new()
        })
    }

    fn material(&mut self) -> Option<Material> {
        match self.row.text(Column::Material) {
            Some(text) => self.take(Column::Material, material(text)),
            None => self.shared.material.clone(),
        }
    }

    fn rule(&mut self) -> Option<Rule> {
        let own = self.row.text(Column::Rule);
        let own_u = self.row.text(Column::Uncertainty);
        let name = own.or(self.shared.rule.as_deref());
        let uncertainty = own_u.or(self.shared.uncertainty.as_deref());
        match rule(name, uncertainty) {
            Ok(rule) => rule,
            Err(faults) => {
                for (column, what) in faults {
                    self.fault(column, what);
                }
                None
            }
        }
    }

    /// What a value of each size can be. The side along Y has a range of its own, or else that along X.
    fn plausible(&mut self, kind: Option<&FeatureKind>, limits: Option<&[Limits]>) -> [Option<Plausible>; 2] {
        let mut range = |column: Column| {
            let text = self.row.text(column)?;
            self.take(column, plausible(text, column.key()))
        };
        let columns = [Column::Plausible, Column::SecondPlausible];
        let [first, own] = columns.map(&mut range);
        let Some(kind) = kind else { return [first, own] };
        let is_one = kind.sides().len() == 1;
        if is_one && self.row.text(Column::SecondPlausible).is_some() {
            let what = PlanFault::NotOf { column: Column::SecondPlausible.key(), kind: kind.word() };
            self.fault(Column::SecondPlausible, what);
        }
        let second = own.or(first).filter(|_range| !is_one);
        // Where the side along Y says nothing, the fault is told of the range that it takes.
        let told = [Column::Plausible, if own.is_some() { Column::SecondPlausible } else { Column::Plausible }];
        for ((range, column), limits) in [first, second].into_iter().zip(told).zip(limits.into_iter().flatten()) {
            if let Some(range) = range {
                self.take(column, range.about(limits, column.key()));
            }
        }
        [first, second]
    }

    fn balloon(&mut self) -> Option<[f64; 2]> {
        let [x, y] = [Column::BalloonX, Column::BalloonY].map(|column| {
            let text = self.row.text(column)?;
            let on = number(text).filter(|part| (0.0..=1.0).contains(part));
            self.take(column, on.ok_or_else(|| PlanFault::Balloon { given: beginning(text) }))
        });
        match (x, y) {
            (Some(x), Some(y)) => Some([x, y]),
            (Some(_), None) if self.row.text(Column::BalloonY).is_none() => {
                self.fault(Column::BalloonY, PlanFault::NoCell { column: "balloon_y" });
                None
            }
            (None, Some(_)) if self.row.text(Column::BalloonX).is_none() => {
                self.fault(Column::BalloonX, PlanFault::NoCell { column: "balloon_x" });
                None
            }
            _ => None,
        }
    }
}
