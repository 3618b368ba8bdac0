//! A file from its head to its end.

use std::io::{self, Write};

use fitcheck_core::part::WidthAxis;
use fitcheck_core::tolerance::Feature;

use super::ids::{CharacteristicIds, Ids, PART, STANDARD};
use super::results;
use super::texts::{kind, mm, time};
use super::xml::Elements;
use crate::report::Report;
use crate::report::given::{self, Asked, Given, Quantity, standing};

/// What the root of every file says.
const ROOT: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<QIFDocument xmlns=\"http://qifstandards.org/xsd/qif3\" \
    xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
    xsi:schemaLocation=\"http://qifstandards.org/xsd/qif3 QIFDocument.xsd\" versionQIF=\"3.0.0\"";

/// Millimetres, for features and for characteristics.
const UNITS: &str = "<FileUnits><PrimaryUnits><LinearUnit><SIUnitName>meter</SIUnitName><UnitName>mm</UnitName>\
    <UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>\n";

pub(super) fn write(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    let ids = Ids::of(report)?;
    let mut xml = Elements::new(out);
    xml.raw(&format!("{ROOT} idMax=\"{}\">\n", ids.largest()))?;
    head(report, &ids, &mut xml)?;
    if 0 < ids.known.count() {
        features(report, &ids, &mut xml)?;
        characteristics(report, &ids, &mut xml)?;
        results::write(report, &ids, &mut xml)?;
    }
    xml.close("QIFDocument")
}

fn head(report: &Report, ids: &Ids, xml: &mut Elements<'_>) -> io::Result<()> {
    xml.text("QPId", &ids.uuid)?;
    let mut said = vec![("title", report.title.clone())];
    said.extend(report.notes.iter().map(|note| ("note", note.to_string())));
    said.extend(report.parts.iter().map(|part| ("part", format!("{} {}", part.serial(), standing(part)))));
    xml.attributes(&said)?;
    xml.raw(&format!("<Version><TimeCreated>{}</TimeCreated></Version>\n", time(report.created)))?;
    xml.raw("<Header><Application>\n")?;
    xml.text("Name", &report.program)?;
    xml.text("Organization", "Fitcheck")?;
    xml.raw("</Application></Header>\n")?;
    xml.list("StandardsDefinitions", 1)?;
    xml.raw(&format!(
        "<Standard id=\"{STANDARD}\"><Organization><StandardsOrganizationEnum>ISO</StandardsOrganizationEnum>\
         </Organization><Designator>286-1</Designator><Year>2010</Year></Standard>\n"
    ))?;
    xml.close("StandardsDefinitions")?;
    xml.raw(UNITS)?;
    let plan = report.parts.first().map(|part| part.plan.head.part.clone());
    let part = report.part.clone().or(plan).filter(|part| !part.is_empty());
    if let Some(part) = part {
        xml.raw("<Product><PartSet n=\"1\">\n")?;
        xml.open("Part", PART)?;
        xml.text("ModelNumber", &part)?;
        xml.close("Part")?;
        xml.raw("</PartSet></Product>\n")?;
    }
    Ok(())
}

/// Shows each characteristic once.
fn each(
    report: &Report,
    ids: &Ids,
    see: &mut dyn FnMut(&Asked<'_>, CharacteristicIds) -> io::Result<()>,
) -> io::Result<()> {
    let mut declared = 0;
    given::each(report, &mut |given: &Given<'_>| match ids.known.of(given) {
        Some(known) if declared < known.number => {
            declared = known.number;
            see(&given.asked, Ids::of_characteristic(known))
        }
        _ => Ok(()),
    })
}

/// Holes and shafts as circles, slots and ridges as two lines: where they lie, or that this is not known. Where a face or a point lies is
/// a length of no feature.
fn features(report: &Report, ids: &Ids, xml: &mut Elements<'_>) -> io::Result<()> {
    let count = ids.known.sizes();
    if count == 0 {
        return Ok(());
    }
    xml.raw("<Features>\n")?;
    xml.list("FeatureDefinitions", count)?;
    each(report, ids, &mut |asked, id| match shape(asked.quantity) {
        Some(shape) => definition(asked, (shape, id), xml),
        None => Ok(()),
    })?;
    xml.close("FeatureDefinitions")?;
    xml.list("FeatureNominals", count)?;
    each(report, ids, &mut |asked, id| match shape(asked.quantity) {
        Some(shape) => nominal(asked, (shape, id), xml),
        None => Ok(()),
    })?;
    xml.close("FeatureNominals")?;
    xml.list("FeatureItems", count)?;
    each(report, ids, &mut |asked, id| {
        let Some(Shape { name, .. }) = shape(asked.quantity) else { return Ok(()) };
        let name = format!("{name}FeatureItem");
        xml.open(&name, id.feature_item())?;
        xml.id("FeatureNominalId", id.feature_nominal())?;
        xml.text("FeatureName", &asked.title())?;
        xml.raw(
            "<DeterminationMode><Checked><CheckDetails><Measured/></CheckDetails></Checked></DeterminationMode>\n",
        )?;
        xml.close(&name)
    })?;
    xml.close("FeatureItems")?;
    xml.close("Features")
}

/// What a feature is.
#[derive(Clone, Copy)]
struct Shape {
    /// As names of elements begin.
    name: &'static str,
    /// The direction of the line in the middle between two walls; `None` of a circle.
    line: Option<&'static str>,
}

const fn shape(quantity: Quantity) -> Option<Shape> {
    match quantity {
        Quantity::Diameter => Some(Shape { name: "Circle", line: None }),
        Quantity::Width(WidthAxis::X) => Some(Shape { name: "OppositeParallelLines", line: Some("0 1 0") }),
        Quantity::Width(WidthAxis::Y) => Some(Shape { name: "OppositeParallelLines", line: Some("1 0 0") }),
        Quantity::Coordinate | Quantity::Length => None,
    }
}

fn definition(asked: &Asked<'_>, (shape, id): (Shape, CharacteristicIds), xml: &mut Elements<'_>) -> io::Result<()> {
    let name = format!("{}FeatureDefinition", shape.name);
    xml.open(&name, id.feature_definition())?;
    xml.text(
        "InternalExternal",
        match asked.limits.feature {
            Some(Feature::Hole) => "INTERNAL",
            Some(Feature::Shaft) => "EXTERNAL",
            None => "NOT_APPLICABLE",
        },
    )?;
    let size = mm(asked.limits.nominal);
    if shape.line.is_some() {
        xml.text("Width", &size)?;
        xml.raw("<EndType><SlotEndEnum>UNDEFINED</SlotEndEnum></EndType>\n")?;
    } else {
        xml.text("Diameter", &size)?;
    }
    xml.close(&name)
}

fn nominal(asked: &Asked<'_>, (shape, id): (Shape, CharacteristicIds), xml: &mut Elements<'_>) -> io::Result<()> {
    let name = format!("{}FeatureNominal", shape.name);
    xml.open(&name, id.feature_nominal())?;
    xml.id("FeatureDefinitionId", id.feature_definition())?;
    // A place of which nothing is known has to be there, and says that it is none.
    let place = asked.place.map(|place| place.map(mm).join(" "));
    let validity = if place.is_some() { "" } else { " validity=\"DUMMY\"" };
    let place = place.unwrap_or_else(|| "0 0 0".to_owned());
    xml.raw(&match shape.line {
        Some(line) => {
            format!("<CenterLine><StartPoint{validity}>{place}</StartPoint><Vector>{line}</Vector></CenterLine>\n")
        }
        None => format!("<Location{validity}>{place}</Location>\n"),
    })?;
    xml.raw("<Normal>0 0 1</Normal>\n")?;
    xml.close(&name)
}

/// The limits themselves, whatever class they come from: these are what the values were judged by.
fn characteristics(report: &Report, ids: &Ids, xml: &mut Elements<'_>) -> io::Result<()> {
    let count = ids.known.count();
    xml.raw("<Characteristics>\n")?;
    xml.id("FormalStandardId", STANDARD)?;
    xml.list("CharacteristicDefinitions", count)?;
    each(report, ids, &mut |asked, id| {
        let name = format!("{}CharacteristicDefinition", kind(asked.quantity));
        xml.open(&name, id.definition())?;
        let callout = asked.callout.map_or_else(String::new, |callout| callout.to_string());
        xml.attributes(&[("callout", callout), ("limits from", asked.limits.source.to_string())])?;
        let limits = asked.limits;
        xml.raw(&format!(
            "<Tolerance><MaxValue>{}</MaxValue><MinValue>{}</MinValue><DefinedAsLimit>true</DefinedAsLimit></Tolerance>\n",
            mm(limits.maximum()),
            mm(limits.minimum())
        ))?;
        xml.close(&name)
    })?;
    xml.close("CharacteristicDefinitions")?;
    xml.list("CharacteristicNominals", count)?;
    each(report, ids, &mut |asked, id| {
        let name = format!("{}CharacteristicNominal", kind(asked.quantity));
        xml.open(&name, id.nominal())?;
        xml.id("CharacteristicDefinitionId", id.definition())?;
        if asked.quantity.has_shape() {
            xml.only_id("FeatureNominalIds", id.feature_nominal())?;
        }
        xml.text("TargetValue", &mm(asked.limits.nominal))?;
        xml.close(&name)
    })?;
    xml.close("CharacteristicNominals")?;
    xml.list("CharacteristicItems", count)?;
    each(report, ids, &mut |asked, id| {
        let name = format!("{}CharacteristicItem", kind(asked.quantity));
        xml.open(&name, id.item())?;
        xml.text("Name", &asked.title())?;
        if !asked.number.is_empty() {
            xml.raw("<CharacteristicDesignator>")?;
            xml.text("Designator", asked.number)?;
            xml.close("CharacteristicDesignator")?;
        }
        if asked.quantity.has_shape() {
            xml.only_id("FeatureItemIds", id.feature_item())?;
        }
        xml.id("CharacteristicNominalId", id.nominal())?;
        xml.close(&name)
    })?;
    xml.close("CharacteristicItems")?;
    xml.close("Characteristics")
}
