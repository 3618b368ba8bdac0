//! QIF 3.0 (ISO 23952), 2.1 and 2.0: results and plans of measuring software as XML.
//!
//! | QIF 3.0 | QIF 2.1 | QIF 2.0 |
//! |---|---|---|
//! | `Results` | `MeasurementsResults` | the same |
//! | `MeasurementResultsSet`, `ActualComponentSets` | the same | none: what is in these lists stands by itself |
//! | `MeasuredFeatures` | `FeatureActuals` in it | the same |
//! | `CharacteristicMeasurements` of `…CharacteristicMeasurement` | `CharacteristicActuals` of `…CharacteristicActual` | the same |
//! | `FeatureMeasurementIds` | `FeatureActualIds` | the same |
//! | `CharacteristicDesignator` | `KeyCharacteristic` | the same |
//! | `BASIC_OR_TED` | `BASIC` | the same |
//! | `n` | `n` | `N` |
//!
//! The other names that are read are the same.
//!
//! A file is read twice: first what is declared in it, which is kept (`definitions`, each thing in `declared`), then its values, which are not
//! (`results`). What stands behind the values, such as serial numbers, belongs to them all the same. `characteristics` puts
//! together what the definitions say of a value, `units` makes lengths of its numbers, `axis` says which features have a place to probe,
//! `kinds` which values are lengths.
//!
//! Names of elements count without their prefix, whatever namespace that stands for. The numbers of things are taken as they
//! are: whether they go beyond `idMax` changes nothing. The status of a whole part is not compared, because it is also that of
//! characteristics which are no sizes.

mod axis;
mod characteristics;
mod declared;
mod definitions;
mod kinds;
mod results;
mod units;

use std::collections::HashMap;
use std::ops::ControlFlow;
use std::sync::Arc;

use jiff::civil::DateTime;

use super::characteristic::{Characteristics, Value};
use super::claim::Claim;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::{Sink, StatedLimits, Unjudged, WhyUnjudged};
use super::source::{Beginning, Context, Source};
use super::xml::{self, Element, Fault, Xml};
use super::{Format, Labels};
use definitions::Definitions;
use fitcheck_core::length::Length;
use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::probing::Origin;
use fitcheck_core::text::Within as _;
use fitcheck_core::verdict::Status;
use kinds::{has_lengths, in_words, is_size};
use results::{End, Measured, QifResult};
use units::{NotALength, Number, UnitOwner};

pub(super) const FORMAT: Format = Format {
    name: "qif",
    endings: &["qif", "xml"],
    description: "exchange-format-qif",
    recognises,
    read,
    plan: Some(plan),
    line_ends: b"",
    has_marks: true,
    shows_end: true,
};

/// The attributes that anything is known by.
const ATTRIBUTES: &[&str] = &[
    "id",
    "n",
    "N",
    "versionQIF",
    "linearUnit",
    "zoneVariance",
    "combinedUncertainty",
    "meanError",
    "name",
    "validity",
];

/// By the name of its first element, whatever comes before it.
fn recognises(beginning: &Beginning<'_>) -> bool {
    let text = xml::text_of(beginning.bytes);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let is_named = |before: &str| before.ends_with(['<', ':']) || before.ends_with("<!DOCTYPE ");
    text.starts_with('<') && text.match_indices("QIFDocument").any(|(at, _)| is_named(text.within(..at)))
}

/// A file of which all pieces are read again.
fn open<'s>(source: &'s mut Source<'_>) -> Result<Xml<'s>, ImportErrorKind> {
    let head = source.beginning().bytes.to_vec();
    Xml::new(source.bytes()?, &head, ATTRIBUTES)
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let (definitions, mut fault) = Definitions::read(&mut open(source)?);
    // What is broken before the values may be what they refer to.
    if let Some(fault) = fault.take_if(|_| !definitions.has_results) {
        refuse(fault, sink);
        return Ok(());
    }
    if definitions.units.is_none() {
        return Err(ImportErrorKind::QifNoUnit);
    }
    for ((line, column), kind) in &definitions.warnings {
        sink.warn(FilePlace::in_line(*line, *column), None, kind.clone());
    }
    let context = source.context.clone();
    let mut reader = Reader { definitions: &definitions, context: &context, sink, has_time: true };
    let ended = results::read(&mut open(source)?, &definitions, &mut |found| reader.take(found));
    let Reader { has_time, .. } = reader;
    if !has_time {
        sink.warn(FilePlace::line(1), None, ImportWarningKind::NoTime);
    }
    match (ended, fault) {
        (Err(End::Fault(fault)), _) | (Ok(()), Some(fault)) => refuse(fault, sink),
        (Ok(()), None) if sink.rows() == 0 => return Err(ImportErrorKind::QifNoResults),
        (Err(End::Enough) | Ok(()), _) => {}
    }
    Ok(())
}

fn refuse(fault: Fault, sink: &mut Sink<'_>) {
    let Located { what, place } = *fault.0;
    sink.refuse(place, what, String::new());
}

/// The characteristics of the items, and of nominals that no item refers to: a plan need not have items.
fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let (definitions, fault) = Definitions::read(&mut open(source)?);
    if let Some(fault) = fault {
        return Err(fault.into());
    }
    // Where items do not name their features, the values do.
    let mut features: HashMap<String, String> = HashMap::new();
    let ended = results::read(&mut open(source)?, &definitions, &mut |found| {
        if let QifResult::Value(Measured { element, feature_item: Some(feature), .. }) = found {
            let item = element.text_at(&["CharacteristicItemId"]);
            if features.len() < definitions::MOST && !features.contains_key(item) {
                features.insert(item.to_owned(), feature.to_owned());
            }
        }
        ControlFlow::Continue(())
    });
    if let Err(End::Fault(fault)) = ended {
        return Err(fault.into());
    }
    let items = definitions
        .items
        .iter()
        .map(|((line, id), item)| (*line, definitions.resolve(item, features.get(id).map(String::as_str))));
    let without_item =
        definitions.nominals.iter().filter(|((_, id), _)| !definitions.items.values().any(|item| item.nominal == *id));
    let nominals = without_item.map(|((line, _), nominal)| (*line, definitions.resolve_nominal(nominal)));
    for (line, read) in items.chain(nominals) {
        match read {
            Ok(read) => found.found.push((line, read.characteristic)),
            Err(kind) => found.refuse(line, xml::fault((line, 1), kind).into()),
        }
    }
    let is_empty = found.found.is_empty() && found.refused.is_empty();
    if is_empty { Err(ImportErrorKind::QifNoCharacteristics) } else { Ok(()) }
}

/// Judges values.
struct Reader<'r, 's> {
    definitions: &'r Definitions,
    context: &'r Context<'r>,
    sink: &'r mut Sink<'s>,
    /// Whether each value had a time so far.
    has_time: bool,
}

impl Reader<'_, '_> {
    fn take(&mut self, found: QifResult<'_>) -> ControlFlow<()> {
        match found {
            QifResult::Warning((line, column), kind) => self.sink.warn(FilePlace::in_line(line, column), None, kind),
            QifResult::Value(measured) => {
                let (line, column) = measured.element.start.at;
                if self.sink.is_full(line) {
                    return ControlFlow::Break(());
                }
                if let Err((kind, given)) = self.value(line, &measured) {
                    self.sink.refuse(FilePlace::in_line(line, column), kind, given);
                }
            }
        }
        ControlFlow::Continue(())
    }

    fn warn(&mut self, line: usize, kind: ImportWarningKind) {
        self.sink.warn(FilePlace::line(line), Some(line), kind);
    }

    /// Judges a value, or says why it cannot be used, and what was given.
    fn value(&mut self, line: usize, measured: &Measured<'_>) -> Result<(), (ImportErrorKind, String)> {
        let nothing_given = |kind| (kind, String::new());
        let element = measured.element;
        let id = element.text_at(&["CharacteristicItemId"]);
        let missing = || ImportErrorKind::QifReference { what: "CharacteristicItem".to_owned(), id: shorten(id) };
        let item = self.definitions.item(id).ok_or_else(missing).map_err(nothing_given)?;
        let resolved = self.definitions.resolve(item, measured.feature_item).map_err(nothing_given)?;
        let own = element.text_at(&["Status", "CharacteristicStatusEnum"]);
        let status = if own.is_empty() { element.text_at(&["Status", "OtherCharacteristicStatus"]) } else { own };
        // A radius is half a diameter.
        if has_lengths(&resolved.kind) && resolved.kind != measured.kind {
            let measured = in_words(measured.kind);
            let defined = in_words(&resolved.kind);
            return Err(nothing_given(ImportErrorKind::QifOtherKind { measured, defined }));
        }
        if 1 < element.children().filter(|child| child.start.name == "Value").count() {
            return Err(nothing_given(ImportErrorKind::QifSeveralValues));
        }
        let no_value = || nothing_given(ImportErrorKind::QifNoValue { status: shorten(status) });
        let value = element.child("Value").filter(|value| !value.text.is_empty()).ok_or_else(no_value)?;
        let mut labels = resolved.characteristic.labels.clone();
        labels.claims.extend(claim(status));
        measured.serial.clone_into(&mut labels.serial);
        labels.who.clone_from(&measured.trace.who);
        // What our own files say of a value that was brought to 20 °C.
        let said = element.child("Attributes").into_iter().flat_map(Element::children);
        labels.is_corrected = said.into_iter().any(|one| one.start.attribute("name").ends_with(CORRECTED));
        if labels.place == [None; 3]
            && labels.no_place.is_none()
            && let Some((place, units)) = measured.place.zip(self.definitions.units.as_ref())
        {
            labels.place = characteristics::coordinates(units, place);
        }
        let time = self.time(line, measured);
        if !has_lengths(measured.kind) {
            let why = WhyUnjudged::NotASize { what: in_words(measured.kind) };
            self.set_aside(line, why, resolved.characteristic.id(), labels, time);
            return Ok(());
        }
        if NOT_VALID.contains(&status) {
            let why = WhyUnjudged::NotValid { said: status.to_owned() };
            self.set_aside(line, why, resolved.characteristic.id(), labels, time);
            return Ok(());
        }
        let Some((number, units)) = Number::of(value).zip(self.definitions.units.as_ref()) else { return Ok(()) };
        let read = units.length(&number, UnitOwner::Characteristic).map_err(|error| match error {
            NotALength::Number(error) => ImportErrorKind::Measured(error),
            NotALength::Unit(kind) => kind,
        });
        let (length, is_exact) = read.map_err(|kind| (kind, shorten(&number.text)))?;
        if is_size(measured.kind) && length <= Length::ZERO {
            let given = shorten(&number.text);
            return Err((ImportErrorKind::NotPositive { given: given.clone() }, given));
        }
        let inexact = (!is_exact).then_some(number.text);
        for given in resolved.rounded.into_iter().chain(inexact) {
            self.warn(line, ImportWarningKind::Rounded { given: shorten(&given) });
        }
        let standard = value.start.attribute("combinedUncertainty").to_owned();
        if !standard.is_empty() {
            let mean_error = value.start.attribute("meanError").to_owned();
            self.warn(line, ImportWarningKind::StandardUncertaintyNotUsed { standard, mean_error });
        }
        let value = Value { line, measured: length, time, labels, is_simulated: false };
        resolved.characteristic.judge(value, self.context, self.sink);
        Ok(())
    }

    /// A value that is no length, such as an angle, or of which the file says that it is none.
    fn set_aside(&mut self, line: usize, why: WhyUnjudged, id: String, labels: Labels, time: Option<DateTime>) {
        let time = time.unwrap_or(self.context.now);
        let origin = Origin::Imported { file: Arc::clone(&self.context.file) };
        let measured = None;
        let position = None;
        let asked = StatedLimits::default();
        let correction = None;
        self.sink.set_aside(Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why });
    }

    /// When a value was measured: it says so itself, or the inspection that it belongs to.
    fn time(&mut self, line: usize, measured: &Measured<'_>) -> Option<DateTime> {
        let own = measured.element.text_at(&["TimeStamp"]);
        let given = if own.is_empty() { &measured.trace.time } else { own };
        if given.is_empty() {
            self.has_time = false;
            return None;
        }
        let (local, offset) = without_offset(given);
        let time = local.parse().ok();
        let given = shorten(given);
        match time {
            None => self.warn(line, ImportWarningKind::Time { given }),
            Some(_) if !offset.is_empty() => self.warn(line, ImportWarningKind::Offset { given }),
            Some(_) => {}
        }
        time
    }
}

/// A date and time as XML writes it, and how far it is from UTC.
fn without_offset(given: &str) -> (&str, &str) {
    let begin = given.find('T').and_then(|time| {
        let behind = given.get(time..)?;
        Some(time + behind.find(['Z', '+', '-'])?)
    });
    given.split_at(begin.unwrap_or(given.len()))
}

/// The end of the name of an attribute with what was measured before.
const CORRECTED: &str = "before the correction to 20 °C, mm";

/// Statuses of characteristics (`CharacteristicStatusEnumType`) and of inspections (`InspectionStatusEnumType`) of which there is no
/// value to judge: the measuring software could not determine it, or did not.
const NOT_VALID: [&str; 7] =
    ["SYSERROR", "INDETERMINATE", "NOT_ANALYZED", "UNDEFINED", "UNKNOWN", "NOT_CALCULATED", "NOT_MEASURED"];

/// What a status of the file claims; `None` where it says nothing of the size.
fn claim(status: &str) -> Option<Claim> {
    match status {
        "PASS" => Some(Claim::of(status, Status::Good)),
        "REWORK" => Some(Claim::of(status, Status::Rework)),
        "FAIL" => Some(Claim::out(status)),
        // A size without a tolerance.
        "" | "BASIC_OR_TED" | "BASIC" => None,
        other => Some(Claim::unknown(other)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::characteristic::Characteristic;
    use super::*;
    use fitcheck_core::tolerance::Feature;

    fn planned(text: &str) -> Result<Vec<(usize, Characteristic)>, String> {
        FORMAT.declared("a.qif", text.as_bytes(), None)
    }

    const LIMITS: &str = include_str!("../../../../../tests/data/qif/minimal_bore_25H7.qif");
    const CLASS: &str = include_str!("../../../../../tests/data/qif/minimal_bore_25H7_limitsandfits.qif");

    #[test]
    fn results_declare_their_characteristics() {
        for (text, class, limits) in [(LIMITS, "", Some(["25", "25.021"])), (CLASS, "H7", None)] {
            let declared = planned(text).unwrap();
            let [(line, bore)] = declared.as_slice() else { panic!("{declared:?}") };
            assert_eq!((*line, bore.name.as_str(), bore.class.as_str()), (45, "BORE1 25 H7", class));
            assert_eq!((bore.feature, bore.nominal.unwrap().to_string().as_str()), (Some(Feature::Hole), "25"));
            let found =
                bore.minimum.zip(bore.maximum).map(|(minimum, maximum)| [minimum.to_string(), maximum.to_string()]);
            assert_eq!(found, limits.map(|limits| limits.map(str::to_owned)));
            assert_eq!(bore.labels.part, "PN-4711");
            assert_eq!(bore.labels.place.map(|axis| axis.unwrap().to_string()), ["50", "50", "-5"]);
        }
    }

    #[test]
    fn a_plan_needs_neither_results_nor_items() {
        let (before, _) = LIMITS.split_once("  <Results>").unwrap();
        let plan = format!("{before}</QIFDocument>");
        let [(45, bore)] = &planned(&plan).unwrap()[..] else { panic!() };
        // Nothing says to which feature it belongs.
        assert_eq!((bore.name.as_str(), bore.feature), ("BORE1 25 H7", None));
        let named = "<FeatureNominalIds n=\"1\"><Id>4</Id></FeatureNominalIds><Name>B</Name><TargetValue>";
        let plan = plan.replace("<TargetValue>", named);
        let (before, behind) = plan.split_once("<CharacteristicItems").unwrap();
        let plan = format!("{before}{}", behind.split_once("</CharacteristicItems>").unwrap().1);
        let [(42, bore)] = &planned(&plan).unwrap()[..] else { panic!("{:?}", planned(&plan)) };
        assert_eq!((bore.name.as_str(), bore.feature), ("B", Some(Feature::Hole)));
        let broken = plan.replace("<CharacteristicDefinitionId>7", "<CharacteristicDefinitionId>70");
        assert_eq!(planned(&broken).unwrap_err(), "line 42, column 1: CharacteristicDefinition 70 is not in the file");
    }
}
