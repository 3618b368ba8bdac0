//! The second reading of a QIF file: its values one after the other, each with what was measured with it.

use std::collections::HashMap;
use std::ops::ControlFlow;

use super::axis::{Placed, placed};
use super::declared::{Trace, is_results};
use super::definitions::{Definitions, MOST, OF_TRACE, miscounted};
use super::units::Number;
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::given::shorten;
use crate::exchange::xml::{Element, Fault, Start, Xml, fault};

const OF_MEASUREMENT: &[&str] = &[
    "Status",
    "CharacteristicStatusEnum",
    "OtherCharacteristicStatus",
    "CharacteristicItemId",
    "TimeStamp",
    "FeatureMeasurementIds",
    "FeatureActualIds",
    "Id",
    "ActualComponentId",
    "Attributes",
    "AttributeStr",
    "Value",
];

const OF_FEATURE: &[&str] = &["FeatureItemId", "Location", "Normal", "Axis", "AxisPoint", "Direction"];

/// The most measured features of one part.
const MOST_FEATURES: usize = 5 * MOST;

pub(super) struct Measured<'r> {
    /// Its kind, such as `Diameter`.
    pub(super) kind: &'r str,
    pub(super) element: &'r Element,
    /// The number of the feature that it was measured at.
    pub(super) feature_item: Option<&'r str>,
    /// Where that was found, if a cycle could be sent there.
    pub(super) place: Option<&'r Number>,
    pub(super) serial: &'r str,
    pub(super) trace: &'r Trace,
}

/// What comes out of a second reading.
pub(super) enum QifResult<'r> {
    Value(Measured<'r>),
    Warning((usize, usize), ImportWarningKind),
}

/// Where it goes; a break ends the reading.
pub(super) type Take<'t> = &'t mut dyn FnMut(QifResult<'_>) -> ControlFlow<()>;

/// Why a reading ends early.
pub(super) enum End {
    Fault(Fault),
    Enough,
}

impl From<Fault> for End {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

struct MeasuredFeature {
    item: String,
    place: Option<Placed>,
}

/// Reads all values of a file.
///
/// # Errors
/// Where the file is broken, or whoever takes the values has enough.
pub(super) fn read(xml: &mut Xml<'_>, definitions: &Definitions, take: Take<'_>) -> Result<(), End> {
    let root = xml.root()?;
    if root.name != "QIFDocument" {
        return Err(fault(root.at, ImportErrorKind::NotRecognised).into());
    }
    let mut parts = definitions.measured_parts.iter();
    while let Some(start) = xml.child()? {
        if !is_results(&start) {
            xml.skip()?;
            continue;
        }
        let mut next = || parts.next().map_or("", String::as_str);
        while let Some(start) = xml.child()? {
            match start.name.as_str() {
                "MeasurementResultsSet" => {
                    while xml.child()?.is_some() {
                        of_one_part(xml, definitions, next(), take)?;
                    }
                }
                // QIF 2.0 has no list of them.
                "MeasurementResults" => of_one_part(xml, definitions, next(), take)?,
                _ => xml.skip()?,
            }
        }
    }
    Ok(())
}

fn of_one_part(xml: &mut Xml<'_>, definitions: &Definitions, part: &str, take: Take<'_>) -> Result<(), End> {
    let mut part = Part { definitions, id: part, trace: definitions.trace.clone(), features: HashMap::new() };
    while let Some(start) = xml.child()? {
        match start.name.as_str() {
            "InspectionTraceability" => part.trace = Trace::of(&xml.element(start, OF_TRACE)?),
            "MeasuredFeatures" => {
                while let Some(start) = xml.child()? {
                    // A list of its own in QIF 2.
                    if start.name == "FeatureActuals" {
                        while let Some(start) = xml.child()? {
                            part.keep(&xml.element(start, OF_FEATURE)?)?;
                        }
                    } else {
                        part.keep(&xml.element(start, OF_FEATURE)?)?;
                    }
                }
            }
            "MeasuredCharacteristics" => {
                while let Some(list) = xml.child()? {
                    if matches!(list.name.as_str(), "CharacteristicMeasurements" | "CharacteristicActuals") {
                        part.values(xml, &list, take)?;
                    } else {
                        xml.skip()?;
                    }
                }
            }
            _ => xml.skip()?,
        }
    }
    Ok(())
}

/// The results of one part.
struct Part<'d> {
    definitions: &'d Definitions,
    id: &'d str,
    trace: Trace,
    features: HashMap<String, MeasuredFeature>,
}

impl Part<'_> {
    fn keep(&mut self, feature: &Element) -> Result<(), Fault> {
        if MOST_FEATURES <= self.features.len() {
            let kind = ImportErrorKind::QifTooMany { what: feature.start.name.clone(), most: MOST_FEATURES };
            return Err(fault(feature.start.at, kind));
        }
        let item = shorten(feature.text_at(&["FeatureItemId"]));
        let new = MeasuredFeature { item, place: placed(feature) };
        self.features.insert(shorten(feature.start.attribute("id")), new);
        Ok(())
    }

    fn values(&self, xml: &mut Xml<'_>, list: &Start, take: Take<'_>) -> Result<(), End> {
        let mut found = 0;
        while let Some(start) = xml.child()? {
            found += 1;
            let element = xml.element(start, OF_MEASUREMENT)?;
            if take(QifResult::Value(self.value(&element))).is_break() {
                return Err(End::Enough);
            }
        }
        if let Some(kind) = miscounted(list, found)
            && take(QifResult::Warning(list.at, kind)).is_break()
        {
            return Err(End::Enough);
        }
        Ok(())
    }

    fn value<'r>(&'r self, element: &'r Element) -> Measured<'r> {
        let features = element.child("FeatureMeasurementIds").or_else(|| element.child("FeatureActualIds"));
        let mut ids = features.into_iter().flat_map(Element::children);
        let feature = match (ids.next(), ids.next()) {
            (Some(id), None) => self.features.get(&id.text),
            _ => None,
        };
        let own = element.text_at(&["ActualComponentId"]);
        let part = if own.is_empty() { self.id } else { own };
        let name = element.start.name.as_str();
        let kind = name.strip_suffix("CharacteristicMeasurement").or_else(|| name.strip_suffix("CharacteristicActual"));
        Measured {
            kind: kind.unwrap_or(name),
            element,
            feature_item: feature.map(|feature| feature.item.as_str()),
            place: feature.and_then(|feature| feature.place.as_ref()?.as_ref().ok()),
            serial: self.definitions.serials.get(part).map_or("", String::as_str),
            trace: &self.trace,
        }
    }
}
