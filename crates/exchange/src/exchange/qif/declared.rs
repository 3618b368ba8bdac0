//! What a QIF file declares: characteristics with their limits, features, and who measured.

use super::axis::Placed;
use super::units::Number;
use crate::exchange::given::shorten;
use crate::exchange::xml::{Element, Start};
use fitcheck_core::message::shortened;
use fitcheck_core::tolerance::Feature;

/// The limits of a characteristic.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Tolerance {
    /// Largest and smallest value, as limits or else as deviations.
    Limits { maximum: Option<Number>, minimum: Option<Number>, are_limits: bool },
    /// The numbers are those of a tolerance with this number.
    Shared { id: String, are_limits: bool },
    /// Limits or deviations: the file does not say which.
    Unclear,
    /// A class, and `HOLE` or `SHAFT`.
    Class { class: String, zone: String },
    /// None.
    Nothing,
}

/// What a characteristic is, and its limits.
#[derive(Debug, Clone)]
pub(super) struct Definition {
    /// Its kind, such as `Diameter`.
    pub(super) kind: String,
    name: String,
    pub(super) tolerance: Tolerance,
}

/// A characteristic with its nominal value.
#[derive(Debug, Clone)]
pub(super) struct Nominal {
    pub(super) name: String,
    pub(super) definition: String,
    pub(super) target: Option<Number>,
    pub(super) feature: String,
}

/// A characteristic of a feature of the part.
#[derive(Debug, Clone)]
pub(super) struct Item {
    pub(super) name: String,
    pub(super) designator: String,
    pub(super) nominal: String,
    pub(super) feature: String,
}

#[derive(Debug, Clone)]
pub(super) struct FeatureDefinition {
    pub(super) feature: Option<Feature>,
    pub(super) diameter: Option<Number>,
}

/// A feature where it should be.
#[derive(Debug, Clone)]
pub(super) struct FeatureNominal {
    pub(super) definition: String,
    /// X, Y and Z as one text, or why no cycle can be sent there.
    pub(super) place: Option<Placed>,
}

/// A feature of the part.
#[derive(Debug, Clone)]
pub(super) struct FeatureItem {
    pub(super) nominal: String,
    pub(super) name: String,
    /// The number of the coordinate system that it is checked in; empty for that of the file.
    pub(super) system: String,
}

/// Who measured, and when.
#[derive(Debug, Clone, Default)]
pub(super) struct Trace {
    pub(super) who: String,
    pub(super) time: String,
}

impl Trace {
    /// What an element `InspectionTraceability` says.
    pub(super) fn of(element: &Element) -> Self {
        let time = |name| element.text_at(&[name]).to_owned();
        let start = time("InspectionStart");
        let end = time("InspectionEnd");
        let who = name(element.text_at(&["InspectionOperator", "Name"]));
        Self { who, time: shorten(if end.is_empty() { &start } else { &end }) }
    }
}

impl Definition {
    pub(super) fn of(element: &Element) -> Self {
        let kind = element.start.name.trim_end_matches("CharacteristicDefinition").to_owned();
        let name = self::name(element.text_at(&["Name"]));
        let tolerance = if let Some(tolerance) = element.child("Tolerance") {
            let limit = |name| tolerance.child(name).and_then(Number::of);
            let are_limits = match tolerance.text_at(&["DefinedAsLimit"]) {
                "true" | "1" => Some(true),
                "false" | "0" => Some(false),
                _ => None,
            };
            match (tolerance.child("DefinitionId"), are_limits) {
                (_, None) => Tolerance::Unclear,
                (Some(id), Some(are_limits)) => Tolerance::Shared { id: key(&id.text), are_limits },
                (None, Some(are_limits)) => {
                    Tolerance::Limits { maximum: limit("MaxValue"), minimum: limit("MinValue"), are_limits }
                }
            }
        } else if let Some(fit) = element.child("LimitsAndFitsSpecification") {
            let class = format!("{}{}", fit.text_at(&["FormVariance"]), fit.text_at(&["Grade"]));
            Tolerance::Class { class: shorten(&class), zone: fit.start.attribute("zoneVariance").to_owned() }
        } else {
            Tolerance::Nothing
        };
        Self { kind, name, tolerance }
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }
}

/// Whether an element has the results; QIF 2 calls it otherwise.
pub(super) fn is_results(start: &Start) -> bool {
    matches!(start.name.as_str(), "Results" | "MeasurementsResults")
}

/// The longest name that is kept, in characters.
const LONGEST_NAME: usize = 500;

pub(super) fn name(text: &str) -> String {
    shortened(text, LONGEST_NAME)
}

/// The number of a thing, or one that it refers to.
pub(super) fn key(text: &str) -> String {
    shorten(text.trim())
}

pub(super) fn id(element: &Element) -> String {
    key(element.start.attribute("id"))
}

/// The only one of a list of numbers; empty where there are several.
pub(super) fn only_id(list: Option<&Element>) -> String {
    let mut ids = list.into_iter().flat_map(Element::children).filter(|id| id.start.name == "Id");
    match (ids.next(), ids.next()) {
        (Some(id), None) => key(&id.text),
        _ => String::new(),
    }
}
