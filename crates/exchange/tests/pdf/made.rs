//! Reports to write.

use std::sync::Arc;

use fitcheck_core::part::{Document, Plan};
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::tolerance::{Callout, Feature, Sources};
use fitcheck_core::verdict::Rule;
use fitcheck_core::verdict::rules::{RuleInputs, RuleName, Uncertainty};
use fitcheck_core::words::{Language, Words};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::report::part::PartSheet;
use fitcheck_exchange::report::{RENDERINGS, Report};
use jiff::civil::{DateTime, date};

use super::reader::Pdf;

pub fn time() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

/// A value of a callout.
pub fn record(id: &str, callout: &str, measured: &str) -> Record {
    of_origin(id, callout, measured, Origin::Typed)
}

pub fn simulated(id: &str, callout: &str, measured: &str) -> Record {
    of_origin(id, callout, measured, Origin::Simulated { cycle: 421, seed: 1 })
}

fn of_origin(id: &str, callout: &str, measured: &str, origin: Origin) -> Record {
    let callout: Callout = callout.parse().unwrap();
    let limits = Sources::default().limits(&callout, callout.feature().or(Some(Feature::Hole))).unwrap();
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), origin);
    Record::judged(time(), id.to_owned(), Some(callout), limits, measurement, None)
}

/// A rule with guard bands of twice this uncertainty in µm.
pub fn guarded(um: &str) -> Rule {
    let given = RuleInputs { uncertainty: Some(Uncertainty::standard(um).unwrap()), ..RuleInputs::default() };
    Rule::new(RuleName::IlacG8, given).unwrap()
}

pub fn report(checks: Vec<Record>) -> Report {
    Report { program: "Fitcheck 0.0.0".to_owned(), ..Report::new(time(), checks) }
}

/// Three values: good, to rework, scrap.
pub fn three() -> Vec<Record> {
    vec![record("Bore A", "25 H7", "25.012"), record("Bore B", "25 H7", "24.998"), record("Stud", "10 g6", "9.9855")]
}

pub fn bytes(report: &Report, language: &str) -> Vec<u8> {
    rendered(report, language, "pdf")
}

pub fn rendered(report: &Report, language: &str, name: &str) -> Vec<u8> {
    let language = Language::all().find(|known| known.code() == language).unwrap();
    let rendering = RENDERINGS.iter().find(|rendering| rendering.name == name).unwrap();
    rendering.bytes(report, &Words::new(language)).unwrap()
}

pub fn pdf(report: &Report, language: &str) -> Pdf {
    Pdf::read(&bytes(report, language))
}

const PLAN: &str = r#"fitcheck_plan = 1
part = "Flange 4711"
drawing = "4711-B"
picture = "flange.png"
remark = "Deburr the seat."

[[feature]]
number = 1
name = "BORE_A"
callout = "25 H7"
balloon_x = 0.42
balloon_y = 0.3

[[feature]]
number = 2
name = "SEAT"
callout = "20 g6"
balloon_x = 1
balloon_y = 0

[[feature]]
number = 3
name = "HUB"
callout = "40 H7"
"#;

pub fn plan() -> Arc<Plan> {
    Arc::new(Document::read(PLAN.as_bytes()).unwrap().plan(&Sources::default()).unwrap())
}

/// A part with the values of some of its sizes, by their places.
pub fn part(values: &[(usize, Record)]) -> PartSheet {
    let mut sheet = PartSheet::new(&plan(), "17");
    for (at, record) in values {
        sheet.take(*at, Arc::new(record.clone()), None);
    }
    sheet
}

/// A report of one part.
pub fn of_part(sheet: PartSheet, values: &[(usize, Record)]) -> Report {
    let checks: Vec<Record> = values.iter().map(|(_, record)| record.clone()).collect();
    Report { parts: vec![sheet], part: Some("Flange 4711".to_owned()), ..report(checks) }
}

pub fn whole() -> Vec<(usize, Record)> {
    vec![
        (0, record("BORE_A", "25 H7", "25.012")),
        (1, record("SEAT", "20 g6", "19.990")),
        (2, record("HUB", "40 H7", "39.998")),
    ]
}
