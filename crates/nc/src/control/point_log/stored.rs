//! The part of the page that programs read: each measurement as JSON in a block that browsers do not run.
//!
//! Figures are texts, so that none passes through a float on its way; lengths are in millimetres, whatever the page
//! shows. Only ASCII is used, and no character with a meaning in HTML.

use std::fmt::Write as _;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::verdict::Status;
use jiff::civil::DateTime;
use serde::{Deserialize, Serialize};

use super::error::PointFault;
use super::point::{Band, PointLog};

/// The text before a measurement.
pub(super) const OPEN: &str = r#"<script type="application/json" data-fitcheck="444">"#;
/// The text after it.
pub(super) const CLOSE: &str = "</script>";
/// The name under which the page announces how many measurements it holds.
pub(super) const COUNT: &str = "fitcheck-444";
/// Version of the JSON.
const VERSION: u32 = 1;

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Stored {
    version: u32,
    time: Option<DateTime>,
    program: Option<String>,
    unit: StoredUnit,
    nominal_mm: [String; 3],
    normal: [String; 3],
    measured_mm: [String; 3],
    deviations_mm: [String; 3],
    deviation_mm: String,
    tolerance: String,
    upper_mm: Option<String>,
    lower_mm: Option<String>,
    status: Option<Status>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    simulated: bool,
}

/// Only to find out whether a later version has written the rest.
#[derive(Debug, Deserialize)]
struct Version {
    version: u32,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum StoredUnit {
    Mm,
    Inch,
}

/// A measurement as its block. The caller has checked it.
pub(super) fn block(log: &PointLog) -> String {
    let mm = |length: Length| length.to_string();
    let stored = Stored {
        version: VERSION,
        time: log.date_time,
        program: log.program.clone(),
        unit: if log.unit == Unit::Inch { StoredUnit::Inch } else { StoredUnit::Mm },
        nominal_mm: log.nominal.map(mm),
        normal: log.normal.map(|part| part.to_string()),
        measured_mm: log.measured.map(mm),
        deviations_mm: log.deviations.map(mm),
        deviation_mm: mm(log.deviation),
        tolerance: log.tolerance.clone(),
        upper_mm: log.band.map(|band| mm(band.upper)),
        lower_mm: log.band.map(|band| mm(band.lower)),
        status: log.status,
        simulated: log.is_simulated,
    };
    #[expect(clippy::expect_used, reason = "texts under names are always JSON")]
    let json = serde_json::to_string(&stored).expect("texts can be written as JSON");
    format!("{OPEN}{}{CLOSE}", ascii(&json))
}

/// JSON in which all characters outside plain ASCII, and those with a meaning in HTML, are escaped in JSON's own way.
/// They occur only in texts, never in JSON's own syntax.
fn ascii(json: &str) -> String {
    let mut escaped = String::with_capacity(json.len());
    for character in json.chars() {
        if matches!(character, ' '..='~') && !"<>&".contains(character) {
            escaped.push(character);
            continue;
        }
        for unit in character.encode_utf16(&mut [0; 2]) {
            // Writing to a text cannot fail.
            let _always = write!(escaped, "\\u{unit:04x}");
        }
    }
    escaped
}

/// A measurement from the text between [`OPEN`] and [`CLOSE`].
pub(super) fn parse(json: &str) -> Result<PointLog, PointFault> {
    let wrong = |error: serde_json::Error| PointFault::Json { what: error.to_string() };
    let Version { version } = serde_json::from_str(json).map_err(wrong)?;
    if version != VERSION {
        return Err(PointFault::Version { version, known: VERSION });
    }
    let stored: Stored = serde_json::from_str(json).map_err(wrong)?;
    let band = match (stored.upper_mm, stored.lower_mm) {
        (Some(upper), Some(lower)) => Some(Band { upper: length(&upper)?, lower: length(&lower)? }),
        (None, None) => None,
        _ => return Err(PointFault::Json { what: "only one of upper_mm and lower_mm is there".to_owned() }),
    };
    let log = PointLog {
        date_time: stored.time,
        program: stored.program,
        is_simulated: stored.simulated,
        unit: match stored.unit {
            StoredUnit::Mm => Unit::Millimetre,
            StoredUnit::Inch => Unit::Inch,
        },
        nominal: lengths(&stored.nominal_mm)?,
        normal: numbers(&stored.normal)?,
        measured: lengths(&stored.measured_mm)?,
        deviations: lengths(&stored.deviations_mm)?,
        deviation: length(&stored.deviation_mm)?,
        tolerance: stored.tolerance,
        band,
        status: stored.status,
    };
    log.check()?;
    Ok(log)
}

fn length(text: &str) -> Result<Length, PointFault> {
    Ok(Length::parse_in(text, Unit::Millimetre)?)
}

fn lengths([x, y, z]: &[String; 3]) -> Result<[Length; 3], PointFault> {
    Ok([length(x)?, length(y)?, length(z)?])
}

fn numbers(texts: &[String; 3]) -> Result<[f64; 3], PointFault> {
    let number =
        |text: &String| text.parse::<f64>().map_err(|_not_a_number| PointFault::Normal { given: texts.join(", ") });
    let [x, y, z] = texts;
    Ok([number(x)?, number(y)?, number(z)?])
}
