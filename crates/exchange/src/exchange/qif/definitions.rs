//! The first reading of a QIF file: all that is declared in it, before or behind the values.
//!
//! Each thing has a number, and refers to others by theirs. The parts that a file may have at most, and that are kept, are
//! bounded: definitions are for a drawing, not for a production.

use super::axis::{is_common, placed};
use super::declared::{
    Definition, FeatureDefinition, FeatureItem, FeatureNominal, Item, Nominal, Trace, id, is_results, key, name,
    only_id,
};
use super::units::{Number, Units};
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::xml::{Element, Fault, Start, Xml, fault};
use fitcheck_core::tolerance::Feature;
use std::collections::{BTreeMap, HashMap, HashSet};

/// The most things of a kind that are kept.
pub(super) const MOST: usize = 100_000;

/// The most parts whose serial numbers are kept.
const MOST_PARTS: usize = 500_000;

/// What is kept of a definition, and of what it has in it.
const OF_DEFINITION: &[&str] = &[
    "Name",
    "Tolerance",
    "MaxValue",
    "MinValue",
    "DefinedAsLimit",
    "DefinitionId",
    "LimitsAndFitsSpecification",
    "FormVariance",
    "Grade",
    "NonTolerance",
];
const OF_NOMINAL: &[&str] = &["Name", "CharacteristicDefinitionId", "FeatureNominalIds", "Id", "TargetValue"];
const OF_ITEM: &[&str] = &[
    "Name",
    "CharacteristicDesignator",
    "KeyCharacteristic",
    "Designator",
    "FeatureItemIds",
    "Id",
    "CharacteristicNominalId",
];
const OF_FEATURE: &[&str] = &[
    "InternalExternal",
    "Diameter",
    "FeatureDefinitionId",
    "Location",
    "Normal",
    "Axis",
    "AxisPoint",
    "Direction",
    "FeatureNominalId",
    "FeatureName",
    "CoordinateSystemId",
];
const OF_SYSTEM: &[&str] = &["NominalTransform", "Rotation", "XDirection", "YDirection", "ZDirection", "Origin"];
const OF_UNITS: &[&str] = &[
    "PrimaryUnits",
    "OtherUnits",
    "LinearUnit",
    "PMILinearUnit",
    "SIUnitName",
    "UnitName",
    "UnitConversion",
    "Factor",
    "Offset",
];
/// What is kept of the traceability of an inspection.
pub(super) const OF_TRACE: &[&str] = &["InspectionOperator", "Name", "InspectionStart", "InspectionEnd"];

/// All that a file declares.
#[derive(Debug, Default)]
pub(super) struct Definitions {
    version: String,
    /// Whether the results were reached.
    pub(super) has_results: bool,
    pub(super) units: Option<Units>,
    /// The model numbers or names of the parts of the product.
    parts: Vec<String>,
    pub(super) trace: Trace,
    pub(super) kinds: HashMap<String, Definition>,
    pub(super) nominals: BTreeMap<(usize, String), Nominal>,
    nominal_lines: HashMap<String, usize>,
    pub(super) items: BTreeMap<(usize, String), Item>,
    item_lines: HashMap<String, usize>,
    pub(super) feature_kinds: HashMap<String, FeatureDefinition>,
    pub(super) feature_nominals: HashMap<String, FeatureNominal>,
    pub(super) feature_items: HashMap<String, FeatureItem>,
    /// Coordinate systems that are known to be that of the file's coordinates.
    pub(super) common_systems: HashSet<String>,
    /// Largest and smallest value of tolerances that several characteristics share.
    pub(super) tolerances: HashMap<String, (Option<Number>, Option<Number>)>,
    /// The serial numbers of the parts that were measured.
    pub(super) serials: HashMap<String, String>,
    /// The part of each measurement results, in their order; empty where there is none, or several.
    pub(super) measured_parts: Vec<String>,
    pub(super) warnings: Vec<((usize, usize), ImportWarningKind)>,
}

impl Definitions {
    /// Reads as far as the file can be read: the reading of its values meets the same fault, and tells it.
    pub(super) fn read(xml: &mut Xml<'_>) -> (Self, Option<Fault>) {
        let mut read = Self::default();
        let fault = read.document(xml).err();
        (read, fault)
    }

    pub(super) fn item(&self, id: &str) -> Option<&Item> {
        let id = key(id);
        let line = *self.item_lines.get(&id)?;
        self.items.get(&(line, id))
    }

    pub(super) fn nominal(&self, id: &str) -> Option<&Nominal> {
        let id = key(id);
        let line = *self.nominal_lines.get(&id)?;
        self.nominals.get(&(line, id))
    }

    /// The part, where the product is a single one.
    pub(super) fn part(&self) -> &str {
        if let [part] = self.parts.as_slice() { part } else { "" }
    }

    fn document(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        let root = xml.root()?;
        root.attribute("versionQIF").clone_into(&mut self.version);
        if !["2.0", "2.1", "3."].iter().any(|known| self.version.starts_with(known)) {
            let version = self.version.clone();
            self.warnings.push((root.at, ImportWarningKind::QifVersion { version }));
        }
        while let Some(start) = xml.child()? {
            match start.name.as_str() {
                "FileUnits" => {
                    let at = start.at;
                    let element = xml.element(start, OF_UNITS)?;
                    self.units = Some(Units::of(&element).map_err(|kind| fault(at, kind))?);
                }
                "Product" => self.product(xml)?,
                "CoordinateSystems" => self.systems(xml)?,
                "Features" => self.features(xml)?,
                "Characteristics" => self.characteristics(xml)?,
                _ if is_results(&start) => {
                    self.has_results = true;
                    self.results(xml)?;
                }
                _ => xml.skip()?,
            }
        }
        Ok(())
    }

    fn product(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        while let Some(start) = xml.child()? {
            if start.name != "PartSet" {
                xml.skip()?;
                continue;
            }
            while let Some(start) = xml.child()? {
                let part = xml.element(start, &["Header", "Name", "ModelNumber"])?;
                let number = part.text_at(&["ModelNumber"]);
                let name = if number.is_empty() { part.text_at(&["Header", "Name"]) } else { number };
                // One part gives its name to all values; of two neither does.
                if self.parts.len() < 2 {
                    self.parts.push(self::name(name));
                }
            }
        }
        Ok(())
    }

    fn systems(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        while let Some(list) = xml.child()? {
            if list.name != "CoordinateSystemDefinitions" {
                xml.skip()?;
                continue;
            }
            while let Some(start) = xml.child()? {
                let element = xml.element(start, OF_SYSTEM)?;
                if is_common(&element) && self.common_systems.len() < MOST {
                    self.common_systems.insert(id(&element));
                }
            }
        }
        Ok(())
    }

    fn features(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        while let Some(list) = xml.child()? {
            while let Some(start) = xml.child()? {
                match list.name.as_str() {
                    "FeatureDefinitions" => {
                        let element = xml.element(start, OF_FEATURE)?;
                        let feature = match element.text_at(&["InternalExternal"]) {
                            "INTERNAL" => Some(Feature::Hole),
                            "EXTERNAL" => Some(Feature::Shaft),
                            _ => None,
                        };
                        let diameter = element.child("Diameter").and_then(Number::of);
                        let new = FeatureDefinition { feature, diameter };
                        keep(&mut self.feature_kinds, &mut self.warnings, &element, new)?;
                    }
                    "FeatureNominals" => {
                        let element = xml.element(start, OF_FEATURE)?;
                        let definition = key(element.text_at(&["FeatureDefinitionId"]));
                        let new = FeatureNominal { definition, place: placed(&element) };
                        keep(&mut self.feature_nominals, &mut self.warnings, &element, new)?;
                    }
                    "FeatureItems" => {
                        let element = xml.element(start, OF_FEATURE)?;
                        let nominal = key(element.text_at(&["FeatureNominalId"]));
                        let system = key(element.text_at(&["CoordinateSystemId"]));
                        let new = FeatureItem { nominal, name: name(element.text_at(&["FeatureName"])), system };
                        keep(&mut self.feature_items, &mut self.warnings, &element, new)?;
                    }
                    _ => xml.skip()?,
                }
            }
        }
        Ok(())
    }

    fn characteristics(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        while let Some(list) = xml.child()? {
            let mut found = 0;
            while let Some(start) = xml.child()? {
                found += 1;
                match list.name.as_str() {
                    "ToleranceDefinitions" => {
                        let element = xml.element(start, OF_DEFINITION)?;
                        let limit = |name| element.child(name).and_then(Number::of);
                        let new = (limit("MaxValue"), limit("MinValue"));
                        keep(&mut self.tolerances, &mut self.warnings, &element, new)?;
                    }
                    "CharacteristicDefinitions" => {
                        let element = xml.element(start, OF_DEFINITION)?;
                        let new = Definition::of(&element);
                        keep(&mut self.kinds, &mut self.warnings, &element, new)?;
                    }
                    "CharacteristicNominals" => self.keep_nominal(&xml.element(start, OF_NOMINAL)?)?,
                    "CharacteristicItems" => self.keep_item(&xml.element(start, OF_ITEM)?)?,
                    _ => xml.skip()?,
                }
            }
            self.count(&list, found);
        }
        Ok(())
    }

    fn keep_nominal(&mut self, element: &Element) -> Result<(), Fault> {
        let line = element.start.at.0;
        if keep(&mut self.nominal_lines, &mut self.warnings, element, line)? {
            let new = Nominal {
                name: name(element.text_at(&["Name"])),
                definition: key(element.text_at(&["CharacteristicDefinitionId"])),
                target: element.child("TargetValue").and_then(Number::of),
                feature: only_id(element.child("FeatureNominalIds")),
            };
            self.nominals.insert((line, id(element)), new);
        }
        Ok(())
    }

    fn keep_item(&mut self, element: &Element) -> Result<(), Fault> {
        let line = element.start.at.0;
        if keep(&mut self.item_lines, &mut self.warnings, element, line)? {
            let designator = element.child("CharacteristicDesignator").or_else(|| element.child("KeyCharacteristic"));
            let new = Item {
                name: name(element.text_at(&["Name"])),
                designator: designator.map_or_else(String::new, |of| name(of.text_at(&["Designator"]))),
                nominal: key(element.text_at(&["CharacteristicNominalId"])),
                feature: only_id(element.child("FeatureItemIds")),
            };
            self.items.insert((line, id(element)), new);
        }
        Ok(())
    }

    /// What stands behind the values, or says of which part they are.
    fn results(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        while let Some(start) = xml.child()? {
            match start.name.as_str() {
                "InspectionTraceability" => self.trace = Trace::of(&xml.element(start, OF_TRACE)?),
                "MeasurementResultsSet" => {
                    while xml.child()?.is_some() {
                        self.results_of_part(xml)?;
                    }
                }
                "ActualComponentSets" => {
                    while xml.child()?.is_some() {
                        self.measured_components(xml)?;
                    }
                }
                // QIF 2.0 has no lists of these.
                "MeasurementResults" => self.results_of_part(xml)?,
                "ActualComponentSet" => self.measured_components(xml)?,
                _ => xml.skip()?,
            }
        }
        Ok(())
    }

    fn measured_components(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        while let Some(start) = xml.child()? {
            let part = xml.element(start, &["SerialNumber", "Status", "InspectionStatusEnum"])?;
            self.part_status(&part);
            if self.serials.len() < MOST_PARTS {
                self.serials.insert(id(&part), name(part.text_at(&["SerialNumber"])));
            }
        }
        Ok(())
    }

    fn results_of_part(&mut self, xml: &mut Xml<'_>) -> Result<(), Fault> {
        let mut part = String::new();
        while let Some(start) = xml.child()? {
            match start.name.as_str() {
                "ActualComponentIds" => part = only_id(Some(&xml.element(start, &["Id"])?)),
                "InspectionStatus" => self.part_status(&xml.element(start, &["InspectionStatusEnum"])?),
                _ => xml.skip()?,
            }
        }
        if self.measured_parts.len() < MOST_PARTS {
            self.measured_parts.push(part);
        }
        Ok(())
    }

    /// What the file says of a whole part: it is told where that part is not accepted.
    fn part_status(&mut self, element: &Element) {
        let at_root = element.text_at(&["InspectionStatusEnum"]);
        let status = if at_root.is_empty() { element.text_at(&["Status", "InspectionStatusEnum"]) } else { at_root };
        if matches!(status, "FAIL" | "REWORK") && self.warnings.len() < MOST_PARTS {
            let given = status.to_owned();
            self.warnings.push((element.start.at, ImportWarningKind::PartRejected { given }));
        }
    }

    /// Each list says how many it has: fewer or more, and somebody has changed the file.
    fn count(&mut self, list: &Start, found: usize) {
        self.warnings.extend(miscounted(list, found).map(|kind| (list.at, kind)));
    }
}

/// That a list says another number of things than it has.
pub(super) fn miscounted(list: &Start, found: usize) -> Option<ImportWarningKind> {
    // QIF 2.0 writes it in capitals.
    let said = ["n", "N"].into_iter().find_map(|name| list.attribute(name).parse::<usize>().ok())?;
    if said == found {
        return None;
    }
    Some(ImportWarningKind::QifCount { list: list.name.clone(), said, found })
}

/// Keeps the first thing of a number, and tells of a second one; `false` for that.
fn keep<T>(
    all: &mut HashMap<String, T>,
    warnings: &mut Vec<((usize, usize), ImportWarningKind)>,
    element: &Element,
    new: T,
) -> Result<bool, Fault> {
    let at = element.start.at;
    if MOST <= all.len() {
        return Err(fault(at, ImportErrorKind::QifTooMany { what: element.start.name.clone(), most: MOST }));
    }
    let id = id(element);
    if all.contains_key(&id) {
        warnings.push((at, ImportWarningKind::QifTwice { id }));
        return Ok(false);
    }
    all.insert(id, new);
    Ok(true)
}
