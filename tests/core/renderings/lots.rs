//! Parts for the renderings: a plan of three sizes, and values that somebody measured or nobody did.

use std::sync::Arc;

use fitcheck::part::Plan;
use fitcheck::report::part::PartSheet;
use fitcheck::tolerance::Sources;
use fitcheck::tolerance::fit::thermal::{Correction, Warm};
use fitcheck::verdict::Rule;
use fitcheck::verdict::rules::{RuleInputs, RuleName, Uncertainty};

use super::*;

pub const PLAN: &str = "fitcheck_plan = 1
part = \"Flange 4711\"
drawing = \"4711-B\"

[[feature]]
number = 1
name = \"BORE_A\"
callout = \"25 H7\"
x = 40
y = 30.5
z = -8

[[feature]]
number = 2
name = \"SEAT\"
callout = \"20 g6\"

[[feature]]
number = \"3a\"
name = \"SLOT\"
kind = \"width\"
callout = \"12 H9\"
";

/// What is hostile in one format or another.
pub const EVIL: [&str; 12] = [
    "=HYPERLINK(\"http://x\",\"y\")",
    "+1|2\n# head",
    "[a](http://b.c) www.d.e f@g.h",
    "<script>alert('x')</script> &amp; ]]>",
    "![p](q) `r` **s** ~~t~~ $u$",
    "1. a\r\n\r\n- b\u{0}\u{1b}[31m",
    "K0001/1 99\u{f}\u{14}255",
    "\u{202e}abc\u{2066}",
    "_x0041_ {\\rtf1}",
    "a/b\\c:d*e?f[g]h",
    "'quoted' \"twice\"",
    "\u{1f600}\u{4e2d}\u{6587}",
];

pub fn plan() -> Arc<Plan> {
    Arc::new(crate::plans::plan(PLAN))
}

/// A value of a size of the plan.
pub fn value(name: &str, callout: &str, measured: &str, origin: Origin) -> Record {
    let asked: Callout = callout.parse().unwrap();
    let limits = Sources::default().limits(&asked, None).unwrap();
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), origin);
    let time = date(2026, 11, 21).at(10, 42, 7, 0);
    Record::judged(time, name.to_owned(), Some(asked), limits, measurement, None)
}

/// A part with these values, by the places of their sizes.
pub fn sheet(plan: &Arc<Plan>, serial: &str, values: &[(usize, Record)]) -> PartSheet {
    let mut sheet = PartSheet::new(plan, serial);
    for (at, record) in values {
        sheet.take(*at, Arc::new(record.clone()), Some(record.time));
    }
    sheet
}

pub fn simulated() -> Origin {
    Origin::Simulated { cycle: 421, seed: 1 }
}

/// A good value of the plan's bore, one of its seat, one of its slot.
pub fn good_values(origin: &Origin) -> Vec<(usize, Record)> {
    vec![
        (0, value("BORE_A", "25 H7", "25.012", origin.clone())),
        (1, value("SEAT", "20 g6", "19.9901", origin.clone())),
        (2, value("SLOT", "12 H9", "12.02", origin.clone())),
    ]
}

/// Four parts: good, without its seat, scrap, and simulated; and a check that belongs to none.
pub fn lot() -> Report {
    let plan = plan();
    let good = good_values(&Origin::Typed);
    let mut lacking = sheet(&plan, "18", &good[..1]);
    lacking.skip(2, "no gauge");
    let scrap = [vec![(0, value("BORE_A", "25 H7", "25.1", Origin::Typed))], good[1..].to_vec()].concat();
    let nobody = good_values(&simulated());
    let parts = vec![sheet(&plan, "17", &good), lacking, sheet(&plan, "19", &scrap), sheet(&plan, "20", &nobody)];
    let values = [&good[..], &good[..1], &scrap[..], &nobody[..]].concat();
    let mut checks: Vec<Record> = values.into_iter().map(|(_, record)| record).collect();
    checks.push(rework());
    Report { parts, part: Some("Flange 4711".to_owned()), order: Some("O-1".to_owned()), ..report(checks) }
}

/// A value in the guard band of a rule: within the limits, and not decided.
pub fn undecided() -> Record {
    let uncertainty = Some(Uncertainty::standard("1.5").unwrap());
    let rule = Rule::new(RuleName::IlacG8, RuleInputs { uncertainty, ..RuleInputs::default() }).unwrap();
    Record { id: "Guarded".to_owned(), ..typed("25.0205") }.by(rule)
}

/// A value at 26 °C, brought to 20 °C.
pub fn corrected() -> Record {
    let measured = "25.012".parse().unwrap();
    let warm = Warm { temperature: "26".parse().unwrap(), expansion: "11.5".parse().unwrap() };
    Record { id: "Warm".to_owned(), ..typed("25.012") }.corrected(Correction::new(measured, warm, None))
}

/// Every hostile name as name, title, part, order, inspector, note and serial number.
pub fn hostile() -> Report {
    let plan = plan();
    let checks: Vec<Record> = EVIL.iter().map(|name| Record { id: (*name).to_owned(), ..rework() }).collect();
    let parts = EVIL.iter().map(|serial| sheet(&plan, serial, &good_values(&Origin::Typed))).collect();
    let all = EVIL.join(" ");
    let some = || Some(all.clone());
    Report {
        title: all.clone(),
        part: some(),
        order: some(),
        inspector: some(),
        notes: EVIL.iter().map(|text| Message::new("report-note").text("place", *text).text("what", "x")).collect(),
        parts,
        ..report(checks)
    }
}

/// The bytes of a rendering; the same twice.
#[track_caller]
pub fn bytes(name: &str, report: &Report, language: Language) -> Vec<u8> {
    let rendering = RENDERINGS.iter().find(|rendering| rendering.name == name).unwrap();
    let once = || rendering.bytes(report, &Words::new(language)).unwrap();
    let bytes = once();
    assert!(bytes == once(), "{name} is not the same twice");
    bytes
}
