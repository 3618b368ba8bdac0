//! Checks and reports as JSON, the same in every language.
//!
//! An object with the file's `version`, 1 now, and `checks`: one object a check with the names of the CSV's columns.
//! Figures are numbers, contacts arrays of x, y, z in millimetres, warnings an array of sentences; what there is not
//! is null. A report has its head beside them: `title`, `created`, `program`, `part`, `order`, `inspector`, `notes`.

use serde::Serialize;

use super::row::Row;
use super::{RenderError, Rendering, Report};
use crate::journal::Record;
use crate::words::Words;

/// This rendering.
pub const RENDERING: Rendering = Rendering { name: "json", endings: &["json"], render: render_report };

/// The version of the file's shape. A reader can rely on: what it knows of an older version stays where it is.
pub const VERSION: u32 = 1;

#[derive(Serialize)]
struct File<'a> {
    version: u32,
    #[serde(flatten)]
    head: Option<Head<'a>>,
    checks: Vec<Row>,
}

#[derive(Serialize)]
struct Head<'a> {
    title: &'a str,
    created: String,
    program: &'a str,
    part: Option<&'a str>,
    order: Option<&'a str>,
    inspector: Option<&'a str>,
    notes: Vec<String>,
}

fn render_report(report: &Report, _words: &Words) -> Result<Vec<u8>, RenderError> {
    let head = Head {
        title: &report.title,
        created: report.created.to_string(),
        program: &report.program,
        part: report.part.as_deref(),
        order: report.order.as_deref(),
        inspector: report.inspector.as_deref(),
        notes: report.notes.iter().map(ToString::to_string).collect(),
    };
    written(Some(head), &report.checks)
}

/// The records as JSON, in their order.
pub fn render(records: &[Record]) -> Result<Vec<u8>, RenderError> {
    written(None, records)
}

/// One record as an object with the CSV's names; what there is not is left out.
pub fn object(record: &Record) -> Result<serde_json::Map<String, serde_json::Value>, RenderError> {
    let value = serde_json::to_value(Row::of(record)).map_err(|error| RenderError::writer("json", &error))?;
    let serde_json::Value::Object(mut object) = value else { return Ok(serde_json::Map::new()) };
    // Without what there is not: nulls, and the empty contacts and name of a typed value.
    object.retain(|_, value| {
        !value.is_null()
            && value.as_str() != Some("")
            && !matches!(value, serde_json::Value::Array(array) if array.is_empty())
    });
    Ok(object)
}

fn written(head: Option<Head<'_>>, records: &[Record]) -> Result<Vec<u8>, RenderError> {
    let file = File { version: VERSION, head, checks: records.iter().map(Row::of).collect() };
    let mut bytes = serde_json::to_vec_pretty(&file).map_err(|error| RenderError::writer("json", &error))?;
    bytes.push(b'\n');
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use crate::length::Length;
    use crate::report::columns;
    use crate::report::csv::COLUMNS;
    use crate::words::Language;

    #[test]
    fn a_check_has_the_columns_of_the_csv() {
        let text = String::from_utf8(render(&[sample::rework()]).unwrap()).unwrap();
        assert_eq!(
            text,
            r#"{
  "version": 1,
  "checks": [
    {
      "time": "2026-11-21T10:43:00",
      "id": "",
      "callout": "25 H7",
      "feature": "hole",
      "nominal_mm": 25.0,
      "min_mm": 25.0,
      "max_mm": 25.021,
      "measured_mm": 24.998,
      "deviation_um": -2.0,
      "status": "REWORK",
      "remove_um": 2.0,
      "remove_to_middle_um": 12.5,
      "position": null,
      "centre_x_mm": null,
      "centre_y_mm": null,
      "contacts": [],
      "source": "ISO 286, over 18 up to 30 mm",
      "origin": "typed",
      "rule": "no guard band, limits belong to the zone",
      "warnings": [
        "one diameter only: form and position are unknown"
      ]
    }
  ]
}
"#
        );
        let names: Vec<&str> = text.lines().filter_map(|l| l.strip_prefix("      \"")?.split('"').next()).collect();
        assert_eq!(names, columns::names(&COLUMNS));
    }

    #[test]
    fn a_report_has_its_head() {
        let report = Report { part: Some("4711".to_owned()), ..sample::report(vec![]) };
        let text = String::from_utf8(render_report(&report, &Words::new(Language::Nl)).unwrap()).unwrap();
        assert_eq!(
            text,
            r#"{
  "version": 1,
  "title": "",
  "created": "2026-11-21T11:00:00",
  "program": "Fitcheck 0.0.0",
  "part": "4711",
  "order": null,
  "inspector": null,
  "notes": [],
  "checks": []
}
"#
        );
    }

    #[test]
    fn a_contact_that_is_no_number_is_null() {
        let mut record = sample::out_of_position();
        record.measurement.contacts[0].x = f64::NAN;
        record.measurement.contacts[0].y = -0.0;
        let read: serde_json::Value = serde_json::from_slice(&render(&[record]).unwrap()).unwrap();
        assert_eq!(read["checks"][0]["contacts"][0].to_string(), "[null,0.0,-5.0]");
    }

    proptest::proptest! {
        #[test]
        fn a_number_reads_as_the_exact_decimal(nm in 1_i64..1_000_000_000_000) {
            let mut record = sample::good();
            record.measurement.diameter = Length::from_nanometres(nm).unwrap();
            record.verdict.size.deviation = Length::from_nanometres(-nm).unwrap();
            let read: serde_json::Value = serde_json::from_slice(&render(&[record]).unwrap()).unwrap();
            let length = |name: &str, unit| Length::parse_in(&read["checks"][0][name].to_string(), unit).unwrap();
            assert_eq!(length("measured_mm", crate::length::Unit::Millimetre).nanometres(), nm);
            assert_eq!(length("deviation_um", crate::length::Unit::Micrometre).nanometres(), -nm);
        }
    }
}
