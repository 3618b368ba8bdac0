//! The results: those of each part, then those of the checks of no part.

use std::io;

use fitcheck_core::verdict::Status;

use super::ids::{Ids, centre};
use super::texts::{kind, mm, time};
use super::xml::Elements;
use crate::journal::Record;
use crate::report::Report;
use crate::report::given::{self, Found, Given, remarks};
use crate::row::Millimetres;

pub(super) fn write(report: &Report, ids: &Ids, xml: &mut Elements<'_>) -> io::Result<()> {
    let groups: Vec<usize> = (0..).zip(&ids.groups).filter(|(_, group)| 0 < group.values).map(|(at, _)| at).collect();
    xml.raw("<Results>\n")?;
    xml.list("MeasurementResultsSet", groups.len())?;
    let mut statuses = Vec::new();
    for &at in &groups {
        let status = group(report, ids, at, xml)?;
        statuses.push((at, status));
    }
    xml.close("MeasurementResultsSet")?;
    xml.list("ActualComponentSets", 1)?;
    xml.list("ActualComponentSet", statuses.len())?;
    for (at, status) in statuses {
        let [_, component, _] = ids.of_group(at);
        xml.open("ActualComponent", component)?;
        xml.some("SerialNumber", report.parts.get(at).map_or("", |part| part.serial()))?;
        xml.raw(&format!("<Status><InspectionStatusEnum>{status}</InspectionStatusEnum></Status>\n"))?;
        xml.close("ActualComponent")?;
    }
    xml.close("ActualComponentSet")?;
    xml.close("ActualComponentSets")?;
    xml.close("Results")
}

/// What the values of a group so far make of it.
#[derive(Default)]
struct Standing {
    has_failed: bool,
    has_rework: bool,
    is_open: bool,
}

impl Standing {
    fn see(&mut self, status: &str) {
        match status {
            "PASS" => {}
            "FAIL" => self.has_failed = true,
            "REWORK" => self.has_rework = true,
            _ => self.is_open = true,
        }
    }

    /// The status of the whole: a pass only where every value is one.
    const fn status(&self) -> &'static str {
        match self {
            Self { has_failed: true, .. } => "FAIL",
            Self { is_open: true, .. } => "UNKNOWN",
            Self { has_rework: true, .. } => "REWORK",
            _ => "PASS",
        }
    }
}

/// The results of a group; the status of the whole.
fn group(report: &Report, ids: &Ids, at: usize, xml: &mut Elements<'_>) -> io::Result<&'static str> {
    let [results, component, first] = ids.of_group(at);
    let count = ids.groups.get(at).copied().map_or((0, 0), |group| (group.values, group.features));
    xml.open("MeasurementResults", results)?;
    xml.raw("<InspectionTraceability>\n")?;
    xml.some("OrderNumber", report.order.as_deref().unwrap_or(""))?;
    if let Some(inspector) = report.inspector.as_deref().filter(|name| !name.trim().is_empty()) {
        xml.raw("<InspectionOperator>")?;
        xml.text("Name", inspector)?;
        xml.close("InspectionOperator")?;
    }
    xml.text("ReportPreparationDate", &time(report.created))?;
    xml.close("InspectionTraceability")?;
    if 0 < count.1 {
        xml.list("MeasuredFeatures", count.1)?;
        let mut id = first + count.0;
        each_of(report, at, &mut |given| {
            let (Found::Value(record), Some(known)) = (given.found, ids.known.of(given)) else { return Ok(()) };
            let Some(place) = centre(&record.measurement) else { return Ok(()) };
            xml.open("CircleFeatureMeasurement", id)?;
            xml.id("FeatureItemId", Ids::of_characteristic(known).feature_item())?;
            xml.raw(&format!("<Location>{}</Location><Normal>0 0 1</Normal>\n", place.join(" ")))?;
            xml.text("Diameter", &mm(record.measurement.diameter))?;
            id += 1;
            xml.close("CircleFeatureMeasurement")
        })?;
        xml.close("MeasuredFeatures")?;
    }
    let mut standing = Standing::default();
    xml.raw("<MeasuredCharacteristics>\n")?;
    xml.list("CharacteristicMeasurements", count.0)?;
    let mut next = [first, first + count.0];
    each_of(report, at, &mut |given| {
        standing.see(status(given.found));
        value(given, ids, &mut next, xml)
    })?;
    xml.close("CharacteristicMeasurements")?;
    xml.close("MeasuredCharacteristics")?;
    let status = report.parts.get(at).map_or_else(|| standing.status(), |part| of_part(part.status()));
    xml.raw(&format!("<InspectionStatus><InspectionStatusEnum>{status}</InspectionStatusEnum></InspectionStatus>\n"))?;
    xml.only_id("ActualComponentIds", component)?;
    xml.close("MeasurementResults")?;
    Ok(status)
}

/// Shows the values of a group.
fn each_of(report: &Report, at: usize, see: &mut dyn FnMut(&Given<'_>) -> io::Result<()>) -> io::Result<()> {
    if at < report.parts.len() { given::of_part(report, at, see) } else { given::of_none(report, see) }
}

/// A whole part: what has no verdict is not known.
const fn of_part(status: Option<Status>) -> &'static str {
    match status {
        Some(Status::Good) => "PASS",
        Some(Status::Rework) => "REWORK",
        Some(Status::Scrap | Status::OutOfLimits) => "FAIL",
        Some(Status::ReMeasure) | None => "UNKNOWN",
    }
}

/// The status of a value.
fn status(found: Found<'_>) -> &'static str {
    let Found::Value(record) = found else { return "NOT_ANALYZED" };
    match record.verdict.status() {
        _ if record.measurement.origin.is_simulated() => "NOT_ANALYZED",
        Status::Good => "PASS",
        Status::Rework => "REWORK",
        Status::ReMeasure => "INDETERMINATE",
        Status::Scrap | Status::OutOfLimits => "FAIL",
    }
}

fn value(given: &Given<'_>, ids: &Ids, next: &mut [usize; 2], xml: &mut Elements<'_>) -> io::Result<()> {
    let Some(known) = ids.known.of(given) else { return Ok(()) };
    let [id, feature] = next;
    let name = format!("{}CharacteristicMeasurement", kind(given.asked.quantity));
    xml.open(&name, *id)?;
    *id += 1;
    xml.attributes(&said(given.found))?;
    xml.raw(&format!(
        "<Status><CharacteristicStatusEnum>{}</CharacteristicStatusEnum></Status>\n",
        status(given.found)
    ))?;
    xml.id("CharacteristicItemId", Ids::of_characteristic(known).item())?;
    if let Found::Value(record) = given.found {
        xml.text("TimeStamp", &time(record.time))?;
        if centre(&record.measurement).is_some() {
            xml.only_id("FeatureMeasurementIds", *feature)?;
            *feature += 1;
        }
        let measured = mm(record.measurement.diameter);
        let uncertainty = record.verdict.rule.uncertainty().and_then(|uncertainty| standard(&uncertainty.um()));
        xml.raw(&match uncertainty {
            Some(standard) => {
                format!("<Value combinedUncertainty=\"{standard}\" meanError=\"0\">{measured}</Value>\n")
            }
            None => format!("<Value>{measured}</Value>\n"),
        })?;
    }
    xml.close(&name)
}

/// What there is no element for.
fn said(found: Found<'_>) -> Vec<(&'static str, String)> {
    match found {
        Found::Missing => vec![("reason", "missing".to_owned())],
        Found::LeftOut(reason) => vec![("reason", format!("left out: {reason}"))],
        Found::Value(record) => of_record(record),
    }
}

fn of_record(record: &Record) -> Vec<(&'static str, String)> {
    let is_simulated = record.measurement.origin.is_simulated();
    let correction = record.correction.map(|correction| Millimetres(correction.measured).text(3));
    vec![
        ("verdict", remarks(record)),
        ("rule", record.verdict.rule.to_string()),
        ("origin", record.measurement.origin.to_string()),
        ("simulated", is_simulated.to_string()),
        ("measured before the correction to 20 °C, mm", correction.into_iter().collect()),
    ]
}

/// Micrometres as a decimal of millimetres: the point moves three places.
fn standard(um: &str) -> Option<String> {
    let (whole, part) = um.split_once('.').unwrap_or((um, ""));
    let figures = format!("{whole:0>4}");
    let (mm, behind) = figures.split_at_checked(figures.len().checked_sub(3)?)?;
    Some(format!("{mm}.{behind}{part}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_point_moves_three_places() {
        for (um, mm) in [("1.2", "0.0012"), ("0.0001", "0.0000001"), ("1234", "1.234"), ("12", "0.012")] {
            assert_eq!(standard(um).as_deref(), Some(mm), "{um}");
        }
    }

    #[test]
    fn a_whole_passes_only_where_every_value_does() {
        for (all, expected) in [
            (&["PASS", "PASS"][..], "PASS"),
            (&["PASS", "NOT_ANALYZED"], "UNKNOWN"),
            (&["REWORK", "INDETERMINATE"], "UNKNOWN"),
            (&["REWORK", "PASS"], "REWORK"),
            (&["NOT_ANALYZED", "FAIL", "REWORK"], "FAIL"),
        ] {
            let mut standing = Standing::default();
            for status in all {
                standing.see(status);
            }
            assert_eq!(standing.status(), expected, "{all:?}");
        }
    }
}
