//! Measured values brought to 20 °C: `fitcheck check --temperature`, against worked figures (`tests/data/rules/vectors.json`).

use assert_cmd::Command;
use fitcheck::length::Length;
use fitcheck::tolerance::fit::thermal::{Correction, Expansion, Temperature, Warm};
use proptest::prelude::*;
use serde_json::Value;

fn vectors(kind: &str) -> Vec<Value> {
    let path = format!("{}/tests/data/rules/vectors.json", env!("CARGO_MANIFEST_DIR"));
    let file: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let all = file["vectors"].as_array().unwrap();
    let found: Vec<Value> = all.iter().filter(|vector| vector["type"] == kind).cloned().collect();
    assert!(!found.is_empty(), "{kind}");
    found
}

/// The answer as JSON, what is said beside it, and the exit code.
fn check(arguments: &[&str]) -> (Value, String, Option<i32>) {
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck")).arg("check").args(arguments).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    (serde_json::from_slice(&output.stdout).unwrap_or_default(), said, output.status.code())
}

/// A coefficient as millionths per kelvin.
fn millionths(value: &Value) -> String {
    format!("{:.3}", value.as_f64().unwrap() * 1e6)
}

#[test]
fn lengths_are_brought_to_20_degrees_as_in_the_worked_figures() {
    let mm = |value: &Value| format!("{}", value.as_f64().unwrap());
    for vector in vectors("temperature") {
        let size = if vector["L"].is_null() { &vector["D"] } else { &vector["L"] };
        let degrees = if vector["T"].is_null() { panic!("{vector}") } else { mm(&vector["T"]) };
        let (found, ..) = check(&[
            &format!("{} ±1", mm(size)),
            "--feature",
            "hole",
            "--measured",
            &mm(size),
            "--temperature",
            &degrees,
            "--material",
            &millionths(&vector["alpha"]),
            "--format",
            "json",
        ]);
        let near = |name: &str, wanted: f64, allowed: f64| {
            let found = found[name].as_f64().unwrap_or_else(|| panic!("{name}: {found}"));
            assert!((found - wanted).abs() <= allowed, "{name}: {found} instead of {wanted}");
        };
        if let Some(linear) = vector["L20_linear"].as_f64() {
            // To the nearest nanometre; the exact form differs by 0.9 nm here.
            near("measured_mm", linear, 0.5e-6);
            near("measured_mm", vector["L20_exact"].as_f64().unwrap(), 1.5e-6);
        } else {
            near("correction_um", -vector["dD_um"].as_f64().unwrap(), 0.0005);
        }
        near("as_measured_mm", size.as_f64().unwrap(), 0.0);
    }
    for vector in vectors("temperature_differential") {
        let warm = |alpha: &Value, degrees: &Value| Warm {
            expansion: millionths(alpha).parse().unwrap(),
            temperature: mm(degrees).parse().unwrap(),
        };
        let part = warm(&vector["alpha_work"], &vector["T_work"]);
        let scale = warm(&vector["alpha_scale"], &vector["T_scale"]);
        let found = Correction::new(mm(&vector["D_indicated"]).parse().unwrap(), part, Some(scale));
        assert_eq!(found.at_reference.to_string(), mm(&vector["D20_linear"]));
        let exact = Length::from_mm_f64(vector["D20_exact"].as_f64().unwrap()).unwrap();
        assert_eq!(found.against_exact(), found.at_reference.checked_sub(exact).unwrap());
    }
}

#[test]
fn the_correction_decides_and_is_never_silent() {
    // 25.0215 mm at 26 °C is a bore of 25.019773 mm at 20 °C.
    let (_, said, code) = check(&["25 H7", "--measured", "25.0215"]);
    assert_eq!((code, said.contains("20 °C")), (Some(11), false));
    let warm = ["25 H7", "--measured", "25.0215", "--temperature", "26", "--material", "steel"];
    let (_, said, code) = check(&warm);
    assert_eq!(code, Some(0), "{said}");
    let line = "note: measured 25.0215 mm at 26 °C: -1.726 µm, so 25.019774 mm at 20 °C (steel, 11.5 · 10⁻⁶/K)";
    assert!(said.contains(line), "{said}");
    let (found, said, _) = check(&[&warm[..], &["--format", "json"]].concat());
    assert!(said.contains("at 20 °C"), "{said}");
    let names = ["as_measured_mm", "measured_mm", "correction_um", "temperature_c", "expansion_um_per_m_k"];
    let figures = names.map(|name| found[name].to_string());
    assert_eq!(figures, ["25.0215", "25.019774", "-1.726", "26.0", "11.5"]);
    let scale = ["--scale-temperature", "26", "--scale-material", "11.5", "--format", "json"];
    let (found, said, code) = check(&[&warm[..], &scale].concat());
    assert_eq!((code, found["correction_um"].to_string().as_str()), (Some(11), "0.0"), "{said}");
    assert!(said.contains("note: scales at 26 °C, 11.5 · 10⁻⁶/K"), "{said}");
}

#[test]
fn half_a_temperature_is_wrong_usage_and_what_is_unknown_is_refused() {
    let code = |options: &[&str]| check(&[&["25 H7", "--measured", "25.01"], options].concat()).2;
    assert_eq!(code(&["--temperature", "26"]), Some(2));
    assert_eq!(code(&["--material", "steel"]), Some(2));
    assert_eq!(code(&["--temperature", "26", "--material", "steel", "--scale-temperature", "20"]), Some(2));
    assert_eq!(code(&["--temperature", "26", "--material", "unobtainium"]), Some(1));
    assert_eq!(code(&["--temperature", "2600", "--material", "steel"]), Some(1));
    assert_eq!(code(&["--temperature", "26", "--material", "11.5"]), Some(0));
}

proptest! {
    /// At 20 °C nothing changes, and scales that are as warm as a part of their own material show its size at 20 °C.
    #[test]
    fn what_warms_alike_needs_no_correction(nm in 1_i64..5_000_000_000, alpha in -20_000_i32..500_000, degrees in -273_000_i32..1_000_000) {
        let measured = Length::from_nanometres(nm).unwrap();
        let expansion = Expansion::from_thousandths(alpha).unwrap();
        let warm = Warm { expansion, temperature: Temperature::from_thousandths(degrees).unwrap() };
        prop_assert_eq!(Correction::new(measured, warm, Some(warm)).at_reference, measured);
        let cold = Warm { temperature: "20".parse().unwrap(), ..warm };
        prop_assert_eq!(Correction::new(measured, cold, None).change(), Length::ZERO);
    }
}

/// A CSV of Fitcheck is read back with its correction, and no value is corrected twice.
#[test]
fn a_corrected_value_is_read_back_and_never_corrected_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("warm.csv");
    let run = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).output().unwrap();
        (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap(), output.status.code())
    };
    let warm = ["--temperature", "28", "--material", "23.1", "--scale-temperature", "24", "--scale-material", "10"];
    let check = ["check", "80 H7", "--measured", "80.02", "--format", "csv"];
    let (csv, _, _) = run(&[&check[..], &warm[..]].concat());
    fitcheck::files::write(&path, csv.as_bytes()).unwrap();
    let name = path.to_str().unwrap();
    let read = fitcheck::exchange::import(
        name,
        csv.as_bytes(),
        &fitcheck::tolerance::Sources::default(),
        jiff::civil::date(2026, 11, 21).at(0, 0, 0, 0),
    );
    let correction = read.records[0].correction.unwrap();
    let warm = |expansion: &str, temperature: &str| Warm {
        expansion: expansion.parse().unwrap(),
        temperature: temperature.parse().unwrap(),
    };
    assert_eq!(correction, Correction::new("80.02".parse().unwrap(), warm("23.1", "28"), Some(warm("10", "24"))));
    assert_eq!(read.records[0].measurement.diameter, correction.at_reference);
    let (_, told, code) = run(&["import", name]);
    assert_eq!(code, Some(0), "{told}");
    assert!(told.contains("values with an entry in the column as_measured_mm are already at 20 °C"), "{told}");
    let (out, told, code) = run(&["import", name, "--temperature", "28", "--material", "23.1"]);
    assert!(out.contains("1 row: 1 not judged"), "{out}");
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("the file says that its values are at 20 °C already"), "{told}");
    // A value that does not follow from its own columns is refused.
    fitcheck::files::write(&path, csv.replace("80.020", "80.021").as_bytes()).unwrap();
    let (_, told, code) = run(&["import", name]);
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("does not follow from the measured value and its temperatures"), "{told}");
}
