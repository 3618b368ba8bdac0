//! The fit page: what its fields mean, and what can be done on it.
//!
//! | file | what |
//! |---|---|
//! | here | callout, measured parts, temperature, search; made anew when a field changes |
//! | `class_map` | every class at the size, where it lies, and its neighbours |
//! | `picture` | the classical picture's geometry |
//!
//! What costs more than a frame may (every class, every pair) is kept until the size or the sources change.

mod class_map;
mod picture;

use std::collections::BTreeMap;
use std::ops;
use std::sync::Arc;

use super::inputs::{Field, Inputs};
use super::{Page, Session, asked};
use crate::length::Length;
use crate::message::{Message, Say as _};
use crate::tolerance::fit::equivalent::{self, Difference};
use crate::tolerance::fit::search::{Found, Scope, Wanted, search_in};
use crate::tolerance::fit::thermal::{Expansion, Temperature, clearance_change};
use crate::tolerance::fit::{Actual, Fit, Kind, Possible};
use crate::tolerance::{Callout, Feature, Limits, Sources, ToleranceClass};

pub use class_map::{ClassMap, Direction, MapCell};
pub use picture::{Mark, Picture, PictureZone};

/// The most pairs that a search lists; the total is counted in any case.
pub const MOST_FOUND: usize = 500;

/// What can be done on the fit page, besides typing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FitCommand {
    /// Takes a hole's and a shaft's class; the nominal size stays.
    TakePair(ToleranceClass, ToleranceClass),
    /// Takes a class for its side; the nominal size and the other side stay.
    ChooseClass(ToleranceClass),
    /// Shows the map of hole classes or of shaft classes.
    ShowClasses(Feature),
    /// Puts a material's expansion into the field of a part.
    ChooseExpansion(Feature, Expansion),
    /// Searches among these pairs.
    SearchAmong(Scope),
    /// Takes one side of the fit to the check page.
    Check(Feature),
}

/// The same fit in the other basis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equivalent {
    /// The hole's class.
    pub hole: ToleranceClass,
    /// The shaft's class.
    pub shaft: ToleranceClass,
    /// How far its clearances are from this fit's, or why it has none at this size.
    pub difference: Result<Difference, Message>,
}

/// What the measured parts do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parts {
    /// Both were measured.
    Both(Actual),
    /// One was measured.
    One(Possible),
}

/// The fit at a temperature of both parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WarmFit {
    /// How warm.
    pub temperature: Temperature,
    /// How much more clearance there is than at 20 °C.
    pub change: Length,
    /// The smallest clearance there.
    pub minimum: Length,
    /// The largest clearance there.
    pub maximum: Length,
    /// The measured parts' clearance there.
    pub actual: Option<Length>,
}

/// What a search was made with: while that is the same, so is the answer.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Asking {
    nominal: Length,
    wanted: Wanted,
    scope: Scope,
    sources: Arc<Sources>,
}

/// Every class at a size, holes and shafts.
#[derive(Debug, Clone)]
struct Maps {
    nominal: Length,
    sources: Arc<Sources>,
    hole: ClassMap,
    shaft: ClassMap,
}

/// The meaning of the fit page's fields.
#[derive(Debug, Clone)]
pub struct FitPage {
    side: Feature,
    scope: Scope,
    nominal: Option<Length>,
    hole: Option<ToleranceClass>,
    shaft: Option<ToleranceClass>,
    culprit: Option<ops::Range<usize>>,
    hint: Option<Message>,
    errors: BTreeMap<Field, Message>,
    lengths: BTreeMap<Field, Length>,
    fit: Option<Fit>,
    equivalent: Option<Equivalent>,
    temperature: Option<Temperature>,
    expansions: BTreeMap<Feature, Expansion>,
    maps: Option<Maps>,
    asking: Option<Asking>,
    found: Option<Result<Found, Message>>,
}

impl Default for FitPage {
    fn default() -> Self {
        Self {
            side: Feature::Hole,
            scope: Scope::default(),
            nominal: None,
            hole: None,
            shaft: None,
            culprit: None,
            hint: None,
            errors: BTreeMap::new(),
            lengths: BTreeMap::new(),
            fit: None,
            equivalent: None,
            temperature: None,
            expansions: BTreeMap::new(),
            maps: None,
            asking: None,
            found: None,
        }
    }
}

/// The names of the larger and of the smaller end of a range of clearance, with their amounts: a clearance below zero
/// is called an interference.
pub fn extremes(minimum: Length, maximum: Length) -> [(&'static str, Length); 2] {
    match Kind::of(minimum, maximum) {
        Kind::Clearance => [("fit-maximum-clearance", maximum), ("fit-minimum-clearance", minimum)],
        Kind::Transition => [("fit-maximum-clearance", maximum), ("fit-maximum-interference", minimum.negated())],
        Kind::Interference => {
            [("fit-minimum-interference", maximum.negated()), ("fit-maximum-interference", minimum.negated())]
        }
    }
}

/// The field of a part's measured size.
pub const fn measured_field(part: Feature) -> Field {
    match part {
        Feature::Hole => Field::HoleMeasured,
        Feature::Shaft => Field::ShaftMeasured,
    }
}

/// The field of a part's expansion.
pub const fn expansion_field(part: Feature) -> Field {
    match part {
        Feature::Hole => Field::HoleExpansion,
        Feature::Shaft => Field::ShaftExpansion,
    }
}

impl FitPage {
    /// Reads the fields anew.
    pub(super) fn read(&mut self, inputs: &Inputs, sources: &Arc<Sources>) {
        let (side, scope) = (self.side, self.scope);
        let (maps, asking, found) = (self.maps.take(), self.asking.take(), self.found.take());
        *self = Self { side, scope, maps, asking, found, ..Self::default() };
        self.read_callout(inputs.text(Field::FitCallout), sources);
        self.read_lengths(inputs);
        self.read_temperature(inputs);
        self.read_maps(sources);
        self.search(sources);
    }

    fn read_callout(&mut self, text: &str, sources: &Sources) {
        if text.trim().is_empty() {
            return;
        }
        let (nominal, classes) = (asked::nominal_text(text), asked::class_text(text));
        // The map and the search need the size alone, also while the classes are still being typed.
        self.nominal = nominal.trim_start_matches(['Ø', '⌀']).parse().ok().filter(|nominal| Length::ZERO < *nominal);
        match text.parse::<Callout>() {
            Ok(callout) => {
                self.nominal = Some(callout.nominal());
                (self.hole, self.shaft) = (callout.class_for(Feature::Hole), callout.class_for(Feature::Shaft));
                self.read_fit(&callout, sources);
            }
            Err(error) => {
                let mut known = classes.split(['/', '-']).filter_map(|text| text.trim().parse().ok());
                for class in known.by_ref().take(2) {
                    self.put_class(class);
                }
                self.culprit = error.span();
                self.errors.insert(Field::FitCallout, error.message());
            }
        }
    }

    fn put_class(&mut self, class: ToleranceClass) {
        match class.feature() {
            Feature::Hole => self.hole = Some(class),
            Feature::Shaft => self.shaft = Some(class),
        }
    }

    fn read_fit(&mut self, callout: &Callout, sources: &Sources) {
        let (Some(hole), Some(shaft)) = (self.hole, self.shaft) else {
            self.hint = Some(Message::new(match (self.hole, self.shaft) {
                (Some(_), None) => "fit-shaft-missing",
                (None, Some(_)) => "fit-hole-missing",
                _ => "fit-classes-missing",
            }));
            return;
        };
        match limits(callout, sources) {
            Ok(fit) => {
                self.equivalent = equivalent_of(&fit, hole, shaft, sources);
                self.fit = Some(fit);
            }
            Err(problem) => _ = self.errors.insert(Field::FitCallout, problem),
        }
    }

    fn read_lengths(&mut self, inputs: &Inputs) {
        let fields = [
            (Field::HoleMeasured, true),
            (Field::ShaftMeasured, true),
            (Field::WantedMinimum, false),
            (Field::WantedMaximum, false),
        ];
        for (field, above_zero) in fields {
            let text = inputs.text(field);
            if text.trim().is_empty() {
                continue;
            }
            match text.parse::<Length>() {
                Ok(value) if above_zero && value <= Length::ZERO => {
                    let problem = Message::new("field-above-zero").mm("given", value).mm("limit", Length::MAX);
                    self.errors.insert(field, problem);
                }
                Ok(value) => _ = self.lengths.insert(field, value),
                Err(error) => _ = self.errors.insert(field, error.message()),
            }
        }
    }

    fn read_temperature(&mut self, inputs: &Inputs) {
        match inputs.text(Field::Temperature).parse() {
            Ok(temperature) => self.temperature = Some(temperature),
            Err(error) => self.refuse_thermal(Field::Temperature, &error),
        }
        for part in [Feature::Hole, Feature::Shaft] {
            let field = expansion_field(part);
            match inputs.text(field).parse() {
                Ok(expansion) => _ = self.expansions.insert(part, expansion),
                Err(error) => self.refuse_thermal(field, &error),
            }
        }
    }

    fn refuse_thermal(&mut self, field: Field, error: &crate::tolerance::fit::thermal::ThermalError) {
        self.errors.insert(field, error.message());
    }

    fn read_maps(&mut self, sources: &Arc<Sources>) {
        let Some(nominal) = self.nominal else { return self.maps = None };
        let is_known = |maps: &Maps| maps.nominal == nominal && Arc::ptr_eq(&maps.sources, sources);
        if self.maps.as_ref().is_some_and(is_known) {
            return;
        }
        let map = |feature| ClassMap::new(feature, nominal, sources);
        let (hole, shaft) = (map(Feature::Hole), map(Feature::Shaft));
        self.maps = Some(Maps { nominal, sources: Arc::clone(sources), hole, shaft });
    }

    fn search(&mut self, sources: &Arc<Sources>) {
        let (minimum, maximum) = (self.length(Field::WantedMinimum), self.length(Field::WantedMaximum));
        let asking = self.nominal.zip(minimum.zip(maximum)).map(|(nominal, (minimum, maximum))| Asking {
            nominal,
            wanted: Wanted { minimum, maximum },
            scope: self.scope,
            sources: Arc::clone(sources),
        });
        if asking == self.asking {
            return;
        }
        self.found = asking.as_ref().map(|asking| {
            search_in(asking.nominal, asking.wanted, &asking.sources, asking.scope, MOST_FOUND)
                .map_err(|error| error.message())
        });
        self.asking = asking;
    }

    /// The nominal size, also of a callout that is not finished.
    pub const fn nominal(&self) -> Option<Length> {
        self.nominal
    }

    /// The class of a side, as far as it is typed.
    pub const fn class(&self, part: Feature) -> Option<ToleranceClass> {
        match part {
            Feature::Hole => self.hole,
            Feature::Shaft => self.shaft,
        }
    }

    /// The fit, when hole and shaft have limits.
    pub const fn fit(&self) -> Option<&Fit> {
        self.fit.as_ref()
    }

    /// What is still to be typed.
    pub const fn hint(&self) -> Option<&Message> {
        self.hint.as_ref()
    }

    /// The same fit in the other basis, where there is one.
    pub const fn equivalent(&self) -> Option<&Equivalent> {
        self.equivalent.as_ref()
    }

    /// What is wrong with a field.
    pub fn error(&self, field: Field) -> Option<&Message> {
        self.errors.get(&field)
    }

    /// Where in the callout's text an error shows: characters counted from 0.
    pub const fn culprit(&self) -> Option<&ops::Range<usize>> {
        self.culprit.as_ref()
    }

    /// The length in a field, when it can be read.
    pub fn length(&self, field: Field) -> Option<Length> {
        self.lengths.get(&field).copied()
    }

    /// The expansion of a part, when it can be read.
    pub fn expansion(&self, part: Feature) -> Option<Expansion> {
        self.expansions.get(&part).copied()
    }

    /// What the measured parts do, when there is a fit and one of them was measured.
    pub fn parts(&self) -> Option<Parts> {
        let fit = self.fit.as_ref()?;
        match (self.length(Field::HoleMeasured), self.length(Field::ShaftMeasured)) {
            (Some(hole), Some(shaft)) => Some(Parts::Both(fit.actual(hole, shaft))),
            (Some(hole), None) => Some(Parts::One(fit.possible(Feature::Hole, hole))),
            (None, Some(shaft)) => Some(Parts::One(fit.possible(Feature::Shaft, shaft))),
            (None, None) => None,
        }
    }

    /// The clearance of both measured parts.
    fn actual_clearance(&self) -> Option<Length> {
        match self.parts()? {
            Parts::Both(actual) => Some(actual.clearance),
            Parts::One(_) => None,
        }
    }

    /// The fit at another temperature than 20 °C.
    pub fn warm(&self) -> Option<WarmFit> {
        let fit = self.fit.as_ref()?;
        let temperature = self.temperature.filter(|temperature| *temperature != Temperature::REFERENCE)?;
        let (hole, shaft) = (self.expansion(Feature::Hole)?, self.expansion(Feature::Shaft)?);
        let change = clearance_change(fit.nominal(), hole, shaft, temperature);
        Some(WarmFit {
            temperature,
            change,
            minimum: fit.minimum_clearance().checked_add(change)?,
            maximum: fit.maximum_clearance().checked_add(change)?,
            actual: self.actual_clearance().and_then(|actual| actual.checked_add(change)),
        })
    }

    /// The classical picture of the fit.
    pub fn picture(&self) -> Option<Picture> {
        let fit = self.fit.as_ref()?;
        Some(Picture::new(fit, self.length(Field::HoleMeasured), self.length(Field::ShaftMeasured)))
    }

    /// Whose classes the map shows.
    pub const fn side(&self) -> Feature {
        self.side
    }

    /// Every class of one side at the size, when there is a size.
    pub fn map(&self, part: Feature) -> Option<&ClassMap> {
        let maps = self.maps.as_ref()?;
        Some(match part {
            Feature::Hole => &maps.hole,
            Feature::Shaft => &maps.shaft,
        })
    }

    /// Whether both classes are defined at the size; true as long as there is no size.
    pub fn is_defined(&self, hole: ToleranceClass, shaft: ToleranceClass) -> bool {
        let has = |class: ToleranceClass| self.map(class.feature()).is_none_or(|map| map.has(class));
        has(hole) && has(shaft)
    }

    /// Which pairs are searched.
    pub const fn scope(&self) -> Scope {
        self.scope
    }

    /// What the search found; `None` as long as it is not asked for.
    pub fn found(&self) -> Option<Result<&Found, &Message>> {
        self.found.as_ref().map(Result::as_ref)
    }
}

/// The fit of a callout that names both classes.
fn limits(callout: &Callout, sources: &Sources) -> Result<Fit, Message> {
    let of = |part| -> Result<Limits, Message> { sources.limits(callout, Some(part)).map_err(|error| error.message()) };
    Fit::new(of(Feature::Hole)?, of(Feature::Shaft)?).map_err(|error| error.message())
}

fn equivalent_of(fit: &Fit, hole: ToleranceClass, shaft: ToleranceClass, sources: &Sources) -> Option<Equivalent> {
    let (hole, shaft) = equivalent::equivalent(hole, shaft)?;
    let callout = Callout::fit(fit.nominal(), hole, shaft).map_err(|error| error.message());
    let other = callout.and_then(|callout| limits(&callout, sources));
    Some(Equivalent { hole, shaft, difference: other.map(|other| Difference::between(fit, &other)) })
}

impl Session {
    /// The fit page.
    pub const fn fit(&self) -> &FitPage {
        &self.fit
    }

    pub(super) fn apply_fit(&mut self, command: &FitCommand) {
        match command {
            FitCommand::TakePair(hole, shaft) => self.put_classes(&format!("{hole}/{shaft}")),
            FitCommand::ChooseClass(class) => {
                self.fit.put_class(*class);
                let classes = [self.fit.hole, self.fit.shaft];
                let classes: Vec<&str> = classes.iter().flatten().map(ToleranceClass::as_str).collect();
                self.put_classes(&classes.join("/"));
            }
            FitCommand::ShowClasses(side) => self.fit.side = *side,
            FitCommand::ChooseExpansion(part, expansion) => {
                let sign = self.language.decimal_sign().to_string();
                self.inputs.set(expansion_field(*part), expansion.to_string().replace('.', &sign));
            }
            FitCommand::SearchAmong(scope) => self.fit.scope = *scope,
            FitCommand::Check(part) => self.check_part(*part),
        }
        self.fit.read(&self.inputs, &self.sources);
    }

    fn put_classes(&mut self, classes: &str) {
        let nominal = asked::nominal_text(self.inputs.text(Field::FitCallout));
        self.inputs.set(Field::FitCallout, format!("{nominal} {classes}").trim().to_owned());
    }

    fn check_part(&mut self, part: Feature) {
        let Some(class) = self.fit.class(part) else { return };
        let nominal = asked::nominal_text(self.inputs.text(Field::FitCallout));
        self.inputs.set(Field::Callout, format!("{nominal} {class}").trim().to_owned());
        self.callout_changed(true);
        self.page = Page::Check;
    }
}
