//! Records for the unit tests, with limits made by hand: no table is read.

use jiff::civil::{DateTime, date};

use super::Report;
use crate::journal::Record;
use crate::length::Length;
use crate::message::Message;
use crate::probing::{Circle, Contact, Measurement, Origin};
use crate::tolerance::{Callout, Deviations, Limits, Source};
use crate::verdict::{AxisPosition, PositionVerdict};

pub fn um(um: i32) -> Length {
    Length::from_micrometres(um)
}

/// Limits as ISO 286 gives them between 18 and 30 mm.
pub fn limits(callout: &str, upper: i32, lower: i32) -> Limits {
    let callout: Callout = callout.parse().unwrap();
    let (over, to) = (um(18_000), um(30_000));
    let said = Message::new("source-iso286").with("over", &over).with("to", &to);
    let source = Source::Standard { over, to, said };
    let deviations = Deviations::new(um(upper), um(lower)).unwrap();
    Limits::new(callout.feature().unwrap(), callout.nominal(), deviations, source).unwrap()
}

/// A check of some limits.
pub fn record(callout: &str, limits: Limits, measurement: Measurement, position: Option<PositionVerdict>) -> Record {
    let time = date(2026, 11, 21).at(10, 42, 7, 0);
    Record::judged(time, String::new(), callout.parse().ok(), limits, measurement, position)
}

pub fn typed(measured: &str) -> Record {
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), Origin::Typed);
    record("25 H7", limits("25 H7", 21, 0), measurement, None)
}

pub fn good() -> Record {
    Record { id: "Bore A".to_owned(), ..typed("25.012") }
}

pub fn rework() -> Record {
    Record { time: date(2026, 11, 21).at(10, 43, 0, 0), ..typed("24.998") }
}

pub fn scrap() -> Record {
    Record { time: date(2026, 11, 21).at(10, 43, 30, 0), id: "Bore C".to_owned(), ..typed("25.030") }
}

/// A shaft whose diameter is good and whose centre is out in the minor axis.
pub fn out_of_position() -> Record {
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

pub fn created() -> DateTime {
    date(2026, 11, 21).at(11, 0, 0, 0)
}

pub fn report(checks: Vec<Record>) -> Report {
    Report { program: "Fitcheck 0.0.0".to_owned(), ..Report::new(created(), checks) }
}
