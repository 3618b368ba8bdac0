//! Figures against published ones, against 30 digits, and against what must hold of any series.
//!
//! | file | what |
//! |---|---|
//! | `laws` | the laws and their quantiles, against 30 digits |
//! | `moments` | means and deviations with the certified values of NIST StRD |
//! | `charts` | constants, charts, rules, EWMA and CUSUM |
//! | `capability` | capability by the normal law and by percentiles; Anderson and Darling |
//! | `gauges` | studies of gauges |
//! | `trends` | lines, trends, offsets, groups |
//! | `properties` | what holds of any series; average run lengths |
//! | `pictures` | charts as drawings |
//! | `advice` | the sentences |
//! | `simulated` | values by chance, for the levels of intervals |

#![cfg(test)]
#![expect(
    clippy::disallowed_methods,
    reason = "expected values come from the mathematics of the system, not from that of the program"
)]

mod advice;
mod capability;
mod charts;
mod gauges;
mod laws;
mod moments;
mod pictures;
mod properties;
mod simulated;
mod trends;

use serde_json::Value;

/// A file of published figures.
fn data(name: &str) -> Value {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// One of the published studies.
fn study(id: &str) -> Value {
    let all = data("published_studies.json");
    all.as_array().unwrap().iter().find(|study| study["id"] == id).unwrap().clone()
}

/// A list of numbers.
fn numbers(of: &Value) -> Vec<f64> {
    of.as_array().unwrap().iter().map(number).collect()
}

/// A number, or the text of one.
#[track_caller]
fn number(of: &Value) -> f64 {
    of.as_f64().or_else(|| of.as_str()?.parse().ok()).unwrap()
}

/// Within so much of what is expected, as a share of it.
#[track_caller]
fn near(found: f64, expected: f64, share: f64) {
    assert!((found - expected).abs() <= share * expected.abs(), "{found} is not {expected}");
}

/// Within so much of what is expected.
#[track_caller]
fn within(found: f64, expected: f64, most: f64) {
    assert!((found - expected).abs() <= most, "{found} is not {expected}");
}

/// Equal to a figure that was printed with so many decimals.
#[track_caller]
fn printed(found: f64, expected: f64, decimals: i32) {
    within(found, expected, 0.500_001 * 10_f64.powi(-decimals));
}
