//! What the definitions of a QIF file say of one characteristic: from its item to its nominal, its definition and its feature.

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{Feature, ToleranceClass};

use super::declared::{Definition, Item, Nominal, Tolerance};
use super::definitions::Definitions;
use super::kinds::{has_lengths, in_words, is_size};
use super::units::{NotALength, Number, UnitOwner, Units};
use crate::exchange::Labels;
use crate::exchange::characteristic::{Characteristic, CharacteristicKind};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::imported::WhyUnjudged;
use crate::exchange::no_place::NoPlace;
use crate::exchange::quantity::Quantity;

/// A characteristic, and what else there is to say of it.
pub(super) struct Resolved {
    pub(super) characteristic: Characteristic,
    /// Limits and nominal sizes with figures beyond the nanometre, as they stand in the file.
    pub(super) rounded: Vec<String>,
    /// Its kind, such as `Diameter`.
    pub(super) kind: String,
}

/// Numbers as lengths.
struct Lengths<'d> {
    units: &'d Units,
    rounded: Vec<String>,
}

impl Lengths<'_> {
    fn read(&mut self, number: Option<&Number>, of: UnitOwner) -> Result<Option<Length>, ImportErrorKind> {
        let Some(number) = number else { return Ok(None) };
        let (length, is_exact) = self.units.length(number, of).map_err(|error| match error {
            NotALength::Number(error) => ImportErrorKind::QifLimit(error),
            NotALength::Unit(kind) => kind,
        })?;
        if !is_exact {
            self.rounded.push(number.text.clone());
        }
        Ok(Some(length))
    }
}

impl Definitions {
    /// The characteristic of an item, whose feature is perhaps known by what was measured.
    ///
    /// # Errors
    /// What of its definition is not in the file, or cannot be read.
    pub(super) fn resolve(&self, item: &Item, measured: Option<&str>) -> Result<Resolved, ImportErrorKind> {
        let nominal = self.nominal(&item.nominal).ok_or_else(|| missing("CharacteristicNominal", &item.nominal))?;
        let names = [&item.name, &item.designator];
        let feature_item = [Some(item.feature.as_str()), measured].into_iter().flatten().find(|id| !id.is_empty());
        let feature_item = feature_item.and_then(|id| self.feature_items.get(id));
        let name = names.into_iter().map(String::as_str).chain(feature_item.map(|item| item.name.as_str()));
        let name = name.chain([nominal.name.as_str()]).find(|name| !name.is_empty()).unwrap_or("");
        let feature = feature_item.map(|item| item.nominal.as_str()).filter(|id| !id.is_empty());
        let mut resolved = self.of_nominal(nominal, feature.unwrap_or(&nominal.feature), (name, &item.designator))?;
        let system = feature_item.map_or("", |item| item.system.as_str());
        if !system.is_empty() && !self.common_systems.contains(system) {
            let labels = &mut resolved.characteristic.labels;
            labels.place = [None; 3];
            labels.no_place.get_or_insert_with(|| NoPlace::System { system: system.to_owned() });
        }
        Ok(resolved)
    }

    /// The characteristic of a nominal that no item refers to.
    pub(super) fn resolve_nominal(&self, nominal: &Nominal) -> Result<Resolved, ImportErrorKind> {
        self.of_nominal(nominal, &nominal.feature, (&nominal.name, ""))
    }

    fn of_nominal(
        &self,
        nominal: &Nominal,
        feature: &str,
        (name, number): (&str, &str),
    ) -> Result<Resolved, ImportErrorKind> {
        let definition = self.kinds.get(&nominal.definition);
        let definition = definition.ok_or_else(|| missing("CharacteristicDefinition", &nominal.definition))?;
        let units = self.units.as_ref().ok_or(ImportErrorKind::QifNoUnit)?;
        let mut lengths = Lengths { units, rounded: Vec::new() };
        let feature_nominal = self.feature_nominals.get(feature);
        let declared = feature_nominal.and_then(|nominal| self.feature_kinds.get(&nominal.definition));
        let (place, no_place) = match feature_nominal.and_then(|nominal| nominal.place.as_ref()) {
            Some(Ok(place)) => (coordinates(units, place), None),
            Some(Err(why)) => ([None; 3], Some(why.clone())),
            None => ([None; 3], None),
        };
        let name = if name.is_empty() { definition.name() } else { name };
        let labels =
            Labels { number: number.to_owned(), part: self.part().to_owned(), place, no_place, ..Labels::default() };
        let mut characteristic = Characteristic {
            name: name.to_owned(),
            what: CharacteristicKind::Other(in_words(&definition.kind)),
            class: String::new(),
            feature: declared.and_then(|declared| declared.feature),
            nominal: None,
            minimum: None,
            maximum: None,
            expanded: None,
            labels,
        };
        if has_lengths(&definition.kind) {
            (characteristic.what, characteristic.labels.quantity) = match definition.kind.as_str() {
                "Diameter" => (CharacteristicKind::Size, Some(Quantity::Diameter)),
                "Width" => (CharacteristicKind::Size, Some(Quantity::Width)),
                kind => {
                    let why = WhyUnjudged::NotASize { what: in_words(kind) };
                    (CharacteristicKind::Length(why), Some(Quantity::Length))
                }
            };
            let target = lengths.read(nominal.target.as_ref(), UnitOwner::Characteristic)?;
            let diameter = declared.and_then(|declared| declared.diameter.as_ref());
            characteristic.nominal = match target {
                Some(target) => Some(target),
                None if definition.kind == "Diameter" => lengths.read(diameter, UnitOwner::Feature)?,
                None => None,
            };
            let limits = self.limits(definition, &mut characteristic, &mut lengths);
            // What is no size is listed without limits where those of the file cannot be read.
            if is_size(&definition.kind) {
                limits?;
            }
        }
        Ok(Resolved { characteristic, rounded: lengths.rounded, kind: definition.kind.clone() })
    }

    /// The limits or the class of a definition.
    fn limits(
        &self,
        definition: &Definition,
        characteristic: &mut Characteristic,
        lengths: &mut Lengths<'_>,
    ) -> Result<(), ImportErrorKind> {
        let (maximum, minimum, are_limits) = match &definition.tolerance {
            Tolerance::Limits { maximum, minimum, are_limits } => (maximum, minimum, *are_limits),
            Tolerance::Shared { id, are_limits } => {
                let shared = self.tolerances.get(id).ok_or_else(|| missing("LinearTolerance", id))?;
                (&shared.0, &shared.1, *are_limits)
            }
            Tolerance::Class { class, zone } => return class_of(class, zone, characteristic),
            Tolerance::Unclear => return Err(ImportErrorKind::QifDefinedAsLimit),
            Tolerance::Nothing => return Ok(()),
        };
        let maximum = lengths.read(maximum.as_ref(), UnitOwner::Characteristic)?;
        let minimum = lengths.read(minimum.as_ref(), UnitOwner::Characteristic)?;
        (characteristic.maximum, characteristic.minimum) = if are_limits {
            (maximum, minimum)
        } else {
            // Deviations alone are no limits.
            let nominal = characteristic.nominal.ok_or(ImportErrorKind::QifNoNominal)?;
            let size = |deviation: Option<Length>| deviation.and_then(|deviation| nominal.checked_add(deviation));
            (size(maximum), size(minimum))
        };
        Ok(())
    }
}

/// A tolerance class and the zone, hole or shaft: the class says so, too, by its letter.
fn class_of(class: &str, zone: &str, characteristic: &mut Characteristic) -> Result<(), ImportErrorKind> {
    let of_zone = match zone {
        "HOLE" => Some(Feature::Hole),
        "SHAFT" => Some(Feature::Shaft),
        _ => None,
    };
    let of_class = class.parse::<ToleranceClass>().ok().map(ToleranceClass::feature);
    if of_zone.is_some() && of_class.is_some() && of_zone != of_class {
        return Err(ImportErrorKind::QifZone { class: class.to_owned(), zone: zone.to_owned() });
    }
    class.clone_into(&mut characteristic.class);
    characteristic.feature = of_zone.or(characteristic.feature);
    Ok(())
}

/// Three coordinates in one text.
pub(super) fn coordinates(units: &Units, place: &Number) -> [Option<Length>; 3] {
    let mut read = place.text.split_whitespace().map(|text| units.length(&place.with(text), UnitOwner::Feature).ok());
    std::array::from_fn(|_axis| Some(read.next()??.0))
}

fn missing(what: &'static str, id: &str) -> ImportErrorKind {
    ImportErrorKind::QifReference { what: what.to_owned(), id: id.to_owned() }
}
