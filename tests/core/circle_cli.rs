//! `fitcheck circle`: the certified sets through the program, and what it refuses.

use assert_cmd::Command;
use serde_json::Value;

fn fitcheck() -> Command {
    Command::new(env!("CARGO_BIN_EXE_fitcheck"))
}

fn sets() -> Vec<Value> {
    ["nist_circles", "textbook_circles"]
        .into_iter()
        .flat_map(|name| {
            let path = format!("{}/tests/data/circles/{name}.json", env!("CARGO_MANIFEST_DIR"));
            let file: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
            file["sets"].as_array().unwrap().clone()
        })
        .collect()
}

fn csv(set: &Value) -> String {
    let points = set["points"].as_array().unwrap().iter().map(|point| format!("{},{}\n", point[0], point[1]));
    std::iter::once("x,y\n".to_owned()).chain(points).collect()
}

#[track_caller]
fn near(answer: &Value, expected: &Value, tolerance: f64, what: &str) {
    let (answer, expected) = (answer.as_f64().unwrap(), expected.as_f64().unwrap());
    assert!((answer - expected).abs() <= tolerance * expected.abs().max(1.0), "{what}: {answer} not {expected}");
}

#[test]
fn every_reference_set_is_met_through_the_program() {
    for set in sets() {
        let id = set["id"].as_str().unwrap();
        let output = fitcheck().args(["circle", "-", "--format", "json"]).write_stdin(csv(&set)).output().unwrap();
        assert!(output.status.success(), "{id}: {}", String::from_utf8_lossy(&output.stderr));
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        for name in ["x", "y", "diameter"] {
            near(&answer["least_squares"][name], &set["least_squares"][name], 1e-9, id);
            near(&answer["minimum_circumscribed"][name], &set["minimum_circumscribed"][name], 1e-8, id);
        }
        near(&answer["minimum_zone"]["width"], &set["minimum_zone"]["width"], 1e-8, id);
        match &set["maximum_inscribed"] {
            Value::Null => assert_eq!(answer["maximum_inscribed"], Value::Null, "{id}"),
            inscribed => near(&answer["maximum_inscribed"]["diameter"], &inscribed["diameter"], 1e-8, id),
        }
        assert_eq!(answer["contacts"], set["n"], "{id}");
    }
}

#[test]
fn four_contacts_oppose_each_other_in_two_pairs() {
    let csv = "x,y\n12.5,0\n0,12.502\n-12.5,0\n0,-12.502\n";
    let output = fitcheck().args(["circle", "-", "--format", "json"]).write_stdin(csv).output().unwrap();
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let sizes: Vec<f64> =
        answer["two_point"].as_array().unwrap().iter().map(|pair| pair["size"].as_f64().unwrap()).collect();
    assert!((sizes[0] - 25.0).abs() < 1e-9 && (sizes[1] - 25.004).abs() < 1e-9, "{sizes:?}");
    assert!(answer["warnings"].to_string().contains("4 contacts"), "{}", answer["warnings"]);
}

#[test]
fn what_is_no_circle_is_refused_with_its_reason() {
    for (csv, reason) in [
        ("x,y\n0,0\n1,1\n2,2\n", "line"),
        ("x,y\n0,0\n0,0\n0,0\n", "coincide"),
        ("x,y\n0,0\n1,0\n", "at least 3 contacts"),
        ("", "holds no contacts"),
        ("x,y\n1,2\n3;4\n", "line 3"),
    ] {
        let output = fitcheck().args(["circle", "-"]).write_stdin(csv).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{csv}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(reason), "{csv}: {said}");
        assert!(output.stdout.is_empty(), "{csv}");
    }
}

#[test]
fn a_folder_as_path_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let output = fitcheck().arg("circle").arg(folder.path()).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stderr).unwrap().contains("this is a folder"));
}

#[test]
fn text_and_csv_print_every_criterion() {
    let csv = "x,y\n12.5,0\n0,12.5\n-12.5,0\n0,-12.5\n";
    let text = fitcheck().args(["circle", "-"]).write_stdin(csv).output().unwrap();
    let text = String::from_utf8(text.stdout).unwrap();
    for word in ["least squares", "minimum circumscribed", "maximum inscribed", "minimum zone", "two-point 1 - 3"] {
        assert!(text.contains(word), "{text}");
    }
    let rows = fitcheck().args(["circle", "-", "--format", "csv"]).write_stdin(csv).output().unwrap();
    let rows = String::from_utf8(rows.stdout).unwrap();
    assert!(rows.starts_with("criterion,x_mm,y_mm,diameter_mm,form_mm\nleast_squares,"), "{rows}");
}
