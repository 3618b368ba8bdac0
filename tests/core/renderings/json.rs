//! The history and a report as JSON.

use fitcheck::length::Unit;
use fitcheck::report::json::{RENDERING, render};

use super::*;

#[test]
fn a_check_has_the_columns_of_the_csv() {
    let text = String::from_utf8(render(&[rework()]).unwrap()).unwrap();
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
      ],
      "simulated": false
    }
  ]
}
"#
    );
    let names: Vec<&str> = text.lines().filter_map(|l| l.strip_prefix("      \"")?.split('"').next()).collect();
    let header = String::from_utf8(fitcheck::report::csv::render(&[]).unwrap()).unwrap();
    assert_eq!(names, header.trim_end().split(',').collect::<Vec<_>>());
}

#[test]
fn a_report_has_its_head() {
    let report = Report { part: Some("4711".to_owned()), ..report(vec![]) };
    let text = String::from_utf8(RENDERING.bytes(&report, &Words::new(Language::Nl)).unwrap()).unwrap();
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
    let mut record = out_of_position();
    record.measurement.contacts[0].x = f64::NAN;
    record.measurement.contacts[0].y = -0.0;
    let read: serde_json::Value = serde_json::from_slice(&render(&[record]).unwrap()).unwrap();
    assert_eq!(read["checks"][0]["contacts"][0].to_string(), "[null,0.0,-5.0]");
}

proptest::proptest! {
    #[test]
    fn a_number_reads_as_the_exact_decimal(nm in 1_i64..1_000_000_000_000) {
        let mut record = good();
        record.measurement.diameter = Length::from_nanometres(nm).unwrap();
        record.verdict.size.deviation = Length::from_nanometres(-nm).unwrap();
        let read: serde_json::Value = serde_json::from_slice(&render(&[record]).unwrap()).unwrap();
        let length = |name: &str, unit| Length::parse_in(&read["checks"][0][name].to_string(), unit).unwrap();
        assert_eq!(length("measured_mm", Unit::Millimetre).nanometres(), nm);
        assert_eq!(length("deviation_um", Unit::Micrometre).nanometres(), -nm);
    }
}
