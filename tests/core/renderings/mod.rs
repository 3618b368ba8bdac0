//! The renderings of a report: figures, names and words, on records with limits made by hand.
//!
//! | file | what |
//! |---|---|
//! | `lots` | parts, and checks that are out of the ordinary, for the files below |
//! | `markdown`, `xlsx` | what people read: every text stays a text, nothing simulated is good |
//! | `dfq`, `qif` | what our own readers read back, and the structure |
//! | `band` | the axis on which zone and value are drawn |
//! | `csv`, `json` | the same columns for machines |
//! | `picture` | the drawing in the page |
//! | `texts` | sentences about a check |

mod band;
mod csv;
mod dfq;
mod json;
mod lots;
mod markdown;
mod picture;
mod qif;
mod texts;
mod xlsx;

use std::path::Path;

use fitcheck::journal::Record;
use fitcheck::length::Length;
use fitcheck::message::Message;
use fitcheck::probing::{Circle, Contact, Measurement, Origin};
use fitcheck::report::{RENDERINGS, Report, rendering_for};
use fitcheck::tolerance::{Callout, Deviations, Feature, Limits, Source};
use fitcheck::verdict::{AxisPosition, PositionVerdict};
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

fn um(um: i32) -> Length {
    Length::from_micrometres(um)
}

/// Limits as ISO 286 gives them between 18 and 30 mm.
fn limits(callout: &str, upper: i32, lower: i32) -> Limits {
    let callout: Callout = callout.parse().unwrap();
    let (over, to) = (um(18_000), um(30_000));
    let said = Message::new("source-iso286").with("over", &over).with("to", &to).into();
    let source = Source::Standard { over, to, said, doubt: None };
    let deviations = Deviations::new(um(upper), um(lower)).unwrap();
    Limits::new(callout.feature().unwrap(), callout.nominal(), deviations, source).unwrap()
}

/// A check of the given limits.
fn record(callout: &str, limits: Limits, measurement: Measurement, position: Option<PositionVerdict>) -> Record {
    let time = date(2026, 11, 21).at(10, 42, 7, 0);
    Record::judged(time, String::new(), callout.parse().ok(), limits, measurement, position)
}

fn typed(measured: &str) -> Record {
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), Origin::Typed);
    record("25 H7", limits("25 H7", 21, 0), measurement, None)
}

fn good() -> Record {
    Record { id: "Bore A".to_owned(), ..typed("25.012") }
}

fn rework() -> Record {
    Record { time: date(2026, 11, 21).at(10, 43, 0, 0), ..typed("24.998") }
}

fn scrap() -> Record {
    Record { time: date(2026, 11, 21).at(10, 43, 30, 0), id: "Bore C".to_owned(), ..typed("25.030") }
}

/// A shaft with a good diameter and a centre that is out in the minor axis.
fn out_of_position() -> Record {
    let contact = |x, y| Contact { x, y, z: -5.0 };
    let (x, y, r) = (0.003, -0.012, 12.4925);
    let measurement = Measurement {
        diameter: um(24_985),
        centre: Some([um(3), um(-12)]),
        contacts: vec![contact(12.4955, y), contact(x, 12.4805), contact(-12.4895, y), contact(x, -12.5045)],
        circle: Some(Circle { x, y, diameter: 2.0 * r }),
        origin: Origin::Simulated { cycle: 422, seed: 1 },
    };
    let position = PositionVerdict {
        axes: [
            AxisPosition { deviation: um(3), tolerance: None },
            AxisPosition { deviation: um(-12), tolerance: Some(um(10)) },
        ],
    };
    Record {
        time: date(2026, 11, 21).at(10, 44, 0, 0),
        id: "Stud".to_owned(),
        ..record("25 g6", limits("25 g6", -7, -20), measurement, Some(position))
    }
}

fn created() -> DateTime {
    date(2026, 11, 21).at(11, 0, 0, 0)
}

fn report(checks: Vec<Record>) -> Report {
    Report { program: "Fitcheck 0.0.0".to_owned(), ..Report::new(created(), checks) }
}

#[test]
fn the_ending_chooses_the_rendering() {
    let name = |path: &str| rendering_for(Path::new(path)).map(|rendering| rendering.name);
    assert_eq!(name("a/b.html"), Ok("html"));
    assert_eq!(name("B.HTM"), Ok("html"));
    assert_eq!(name("b.v2.csv"), Ok("csv"));
    assert_eq!(name("b.json"), Ok("json"));
    assert_eq!(name("b.Pdf"), Ok("pdf"));
    let said = |path| name(path).unwrap_err().to_string();
    let endings: Vec<_> = RENDERINGS.iter().flat_map(|to| to.endings).map(|ending| format!(".{ending}")).collect();
    let endings = endings.join(" ");
    assert_eq!(said("b.xps"), format!(".xps is not a format of the report: use one of {endings}"));
    assert_eq!(said("b"), format!("b has no ending that gives the report's format: use one of {endings}"));
}
