//! The fit page: what its fields mean, and what can be done on it.
//!
//! | file | what |
//! |---|---|
//! | here | the state, and what follows from it |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `press` | the joint of a press fit |
//! | `reading` | callout, measured parts, temperature, search: read anew when a field changes |
//! | `class_map` | every class at the size, where it lies, and its neighbours |
//! | `picture` | the classical picture's geometry |
//!
//! What takes longer than a frame may (every class, every pair) is kept until the size or the sources change.

mod actions;
mod apply;
mod class_map;
mod command;
mod field;
mod picture;
mod press;
mod reading;

use std::collections::BTreeMap;
use std::ops;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::Message;
use fitcheck_core::tolerance::fit::equivalent::Difference;
use fitcheck_core::tolerance::fit::press::Press;
use fitcheck_core::tolerance::fit::search::{ClearanceRange, FitSearchResult, Scope};
use fitcheck_core::tolerance::fit::thermal::{Expansion, Temperature, clearance_change};
use fitcheck_core::tolerance::fit::{Fit, FitKind};
use fitcheck_core::tolerance::{Feature, Sources, ToleranceClass};
use fitcheck_core::verdict::fit::{Actual, Possible};
use fitcheck_core::verdict::{Doubt, doubt};

use super::texts::Texts;

pub use actions::{CLASSES, FitAction};
pub use class_map::{ClassMap, MapCell};
pub use command::FitCommand;
pub use field::FitField;
pub use picture::{Mark, Picture, PictureZone};
pub use press::FRICTION;

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

/// What follows from the measured parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeasuredParts {
    /// Both were measured.
    Both(Actual),
    /// One was measured.
    One(Possible),
}

/// The fit at a temperature of both parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WarmFit {
    pub temperature: Temperature,
    /// How much more clearance there is than at 20 °C.
    pub change: Length,
    /// The smallest clearance at the temperature.
    pub minimum: Length,
    /// The largest clearance at the temperature.
    pub maximum: Length,
    /// The clearance of the measured parts at the temperature.
    pub actual: Option<Length>,
}

/// The inputs of a search: while they are the same, so is the answer.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Asking {
    nominal: Length,
    wanted: ClearanceRange,
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

/// The state of the fit page, and what its fields mean.
#[derive(Debug, Clone, Default)]
pub struct FitPage {
    texts: Texts<FitField>,
    /// Whose classes the map shows; those of holes until one is chosen.
    side: Option<Feature>,
    /// Which pairs are searched.
    pub scope: Scope,
    /// The nominal size, even of an unfinished callout.
    pub nominal: Option<Length>,
    hole: Option<ToleranceClass>,
    shaft: Option<ToleranceClass>,
    culprit: Option<ops::Range<usize>>,
    /// What is still to be typed.
    pub hint: Option<Message>,
    errors: BTreeMap<FitField, Message>,
    lengths: BTreeMap<FitField, Length>,
    /// The fit, when hole and shaft have limits.
    pub fit: Option<Fit>,
    /// The same fit in the other basis, where there is one.
    pub equivalent: Option<Equivalent>,
    temperature: Option<Temperature>,
    expansions: BTreeMap<Feature, Expansion>,
    press: Option<Result<Press, Message>>,
    maps: Option<Maps>,
    asking: Option<Asking>,
    found: Option<Result<FitSearchResult, Message>>,
    /// What is drawn while nothing is typed.
    example: Option<Box<Self>>,
}

/// The names of the larger and of the smaller end of a range of clearance, with their amounts: a clearance below zero
/// is called an interference.
pub fn extremes(minimum: Length, maximum: Length) -> [(&'static str, Length); 2] {
    match FitKind::of(minimum, maximum) {
        FitKind::Clearance => [("fit-maximum-clearance", maximum), ("fit-minimum-clearance", minimum)],
        FitKind::Transition => [("fit-maximum-clearance", maximum), ("fit-maximum-interference", minimum.negated())],
        FitKind::Interference => {
            [("fit-minimum-interference", maximum.negated()), ("fit-maximum-interference", minimum.negated())]
        }
    }
}

/// The fit of a page on which nothing was typed yet.
const EXAMPLE: &str = "25 H7/g6";

impl FitPage {
    /// What the picture and the card show: the fit that was typed, or the example of an empty page.
    pub fn seen(&self) -> &Self {
        self.example.as_deref().unwrap_or(self)
    }

    /// The callout of the example, while it is drawn.
    pub fn example(&self) -> Option<&'static str> {
        self.example.is_some().then_some(EXAMPLE)
    }

    /// The class of a side, as far as it has been typed.
    pub const fn class(&self, part: Feature) -> Option<ToleranceClass> {
        match part {
            Feature::Hole => self.hole,
            Feature::Shaft => self.shaft,
        }
    }

    /// The length in a field, when it can be read.
    pub fn length(&self, field: FitField) -> Option<Length> {
        self.lengths.get(&field).copied()
    }

    /// The expansion of a part, when it can be read.
    pub fn expansion(&self, part: Feature) -> Option<Expansion> {
        self.expansions.get(&part).copied()
    }

    /// What follows from the measured parts, when there is a fit and at least one of them was measured.
    pub fn parts(&self) -> Option<MeasuredParts> {
        let fit = self.fit.as_ref()?;
        match (self.length(FitField::HoleMeasured), self.length(FitField::ShaftMeasured)) {
            (Some(hole), Some(shaft)) => Some(MeasuredParts::Both(Actual::of(fit, hole, shaft))),
            (Some(hole), None) => Some(MeasuredParts::One(Possible::of(fit, Feature::Hole, hole))),
            (None, Some(shaft)) => Some(MeasuredParts::One(Possible::of(fit, Feature::Shaft, shaft))),
            (None, None) => None,
        }
    }

    /// What is strange about a measured part: it may be another quantity, or another part's.
    pub fn doubt(&self, part: Feature) -> Option<Doubt> {
        let fit = self.fit.as_ref()?;
        let (limits, field) = match part {
            Feature::Hole => (fit.hole(), FitField::HoleMeasured),
            Feature::Shaft => (fit.shaft(), FitField::ShaftMeasured),
        };
        doubt(limits, self.length(field)?)
    }

    /// The clearance of both measured parts.
    fn actual_clearance(&self) -> Option<Length> {
        match self.parts()? {
            MeasuredParts::Both(actual) => Some(actual.clearance),
            MeasuredParts::One(_) => None,
        }
    }

    /// The fit at a temperature other than 20 °C.
    pub fn warm(&self) -> Option<WarmFit> {
        let fit = self.fit.as_ref()?;
        let temperature = self.temperature.filter(|temperature| *temperature != Temperature::REFERENCE)?;
        let hole = self.expansion(Feature::Hole)?;
        let shaft = self.expansion(Feature::Shaft)?;
        let change = clearance_change(fit.nominal(), hole, shaft, temperature);
        Some(WarmFit {
            temperature,
            change,
            minimum: fit.minimum_clearance().checked_add(change)?,
            maximum: fit.maximum_clearance().checked_add(change)?,
            actual: self.actual_clearance().and_then(|actual| actual.checked_add(change)),
        })
    }

    /// The press fit, when its joint is given; or why there is none.
    pub fn press(&self) -> Option<Result<&Press, &Message>> {
        self.press.as_ref().map(Result::as_ref)
    }

    /// The classical picture of the fit.
    pub fn picture(&self) -> Option<Picture> {
        let fit = self.fit.as_ref()?;
        Some(Picture::new(fit, self.length(FitField::HoleMeasured), self.length(FitField::ShaftMeasured)))
    }

    /// Whose classes the map shows.
    pub fn side(&self) -> Feature {
        self.side.unwrap_or(Feature::Hole)
    }

    /// Every class of one side at the size, when there is a size.
    pub fn map(&self, part: Feature) -> Option<&ClassMap> {
        let maps = self.maps.as_ref()?;
        Some(match part {
            Feature::Hole => &maps.hole,
            Feature::Shaft => &maps.shaft,
        })
    }

    /// Whether both classes are defined at the size; true while there is no size.
    pub fn is_defined(&self, hole: ToleranceClass, shaft: ToleranceClass) -> bool {
        let has = |class: ToleranceClass| self.map(class.feature()).is_none_or(|map| map.has(class));
        has(hole) && has(shaft)
    }

    /// What the search found; `None` while no search is asked for.
    pub fn found(&self) -> Option<Result<&FitSearchResult, &Message>> {
        self.found.as_ref().map(Result::as_ref)
    }
}
