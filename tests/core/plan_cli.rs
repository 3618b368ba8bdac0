//! A plan through the built program, from its rows to the verdicts: `fitcheck nc` writes the set and the part, `fitcheck
//! run` measures the part, and `fitcheck check` says what each size is.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::collections::BTreeMap;
use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::length::Length;
use fitcheck::part::FeatureKind;
use serde_json::Value;

use super::part_plans::{limits, sizes};

/// Twelve features of every kind.
const PLAN: &str = "\
name;kind;axis;callout;callout2;x;y;z
H1;;;25 H7;;40;30;-8
H2;;;12 P9;;80;30;-8
S1;;;20 g6;;40;90;-8
N1;width;Y;16 H8;;100;90;-8
R1;width;X;30 h9;;160;30,5;-8
P1;face;-Z;10 h9;;220;30;10
P2;face;+X;300 js7;;300;60;-10
K1;pocket;;40 H7;25 D10;40;200;-8
B1;boss;;18 s7;;140;200;-8
T1;point;-Z;±0,05;;260;30;12
T2;point;-0,5 0,25 -1;+0,1/-0,05;;260;90;4,5
T3;point;+Y;0/-0,02;;260;150;-3
";

/// The exit code and what is printed.
fn fitcheck(folder: &Path, args: &[&str]) -> (Option<i32>, String, String) {
    let answer = cargo_bin_cmd!("fitcheck").current_dir(folder).args(args).assert();
    let output = answer.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

fn json(folder: &Path, args: &[&str]) -> (Option<i32>, Value) {
    let (code, out, err) = fitcheck(folder, &[args, &["--format", "json"]].concat());
    (code, serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {args:?}: {err}")))
}

/// Gives the features of a part's file other sizes.
fn resize(text: &str, sizes: &[Vec<Length>]) -> String {
    let mut file: toml::Table = text.parse().unwrap();
    let features = file["feature"].as_array_mut().unwrap();
    assert_eq!(features.len(), sizes.len());
    for (feature, sizes) in features.iter_mut().zip(sizes) {
        let feature = feature.as_table_mut().unwrap();
        let size = |number: usize| toml::Value::Float(sizes[number].to_mm_f64());
        match feature["kind"].as_str().unwrap() {
            "bore" | "stud" => feature["diameter"] = size(0),
            "slot" | "ridge" => feature["width"] = size(0),
            "pocket" | "boss" => feature["lengths"] = toml::Value::Array(vec![size(0), size(1)]),
            "face" => {
                let normal = feature["normal"].as_array().unwrap();
                let axis = normal.iter().position(|part| 0.5 < part.as_float().unwrap().abs()).unwrap();
                feature["point"].as_array_mut().unwrap()[axis] = size(0);
            }
            "point" => drop(feature.insert("deviation".to_owned(), size(0))),
            kind => panic!("{kind}"),
        }
    }
    file.to_string()
}

/// What `fitcheck check` says of every size: minimum, maximum, status. A point is checked as a shaft of 10 mm.
fn checked(folder: &Path, kind: &FeatureKind, sizes: &[Length]) -> Vec<[String; 3]> {
    let ten: Length = "10".parse().unwrap();
    let off = if matches!(kind, FeatureKind::Point(..)) { ten } else { Length::ZERO };
    let callouts: Vec<String> = match kind {
        FeatureKind::Point(band, _) => vec![format!("10 {}/{}", signed(band.upper()), signed(band.lower()))],
        kind => kind.callouts().iter().map(ToString::to_string).collect(),
    };
    let all = callouts.iter().zip(sizes).map(|(callout, size)| {
        let measured = size.checked_add(off).unwrap().to_string();
        let mut args = vec!["check", callout, "--measured", &measured];
        if off == ten {
            args.extend(["--feature", "shaft"]);
        }
        let (_code, answer) = json(folder, &args);
        let limit = |key: &str| -> String {
            let limit: Length = answer[key].to_string().parse().unwrap();
            limit.checked_add(off.negated()).unwrap().to_string()
        };
        [limit("min_mm"), limit("max_mm"), answer["status"].as_str().unwrap().to_owned()]
    });
    all.collect()
}

fn signed(deviation: Length) -> String {
    format!("{}{deviation}", if Length::ZERO < deviation { "+" } else { "" })
}

#[test]
fn twelve_features_through_the_program_have_the_verdicts_of_check() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("plan.csv"), PLAN).unwrap();
    let (code, _, err) =
        fitcheck(folder, &["nc", "plan.csv", "--control", "tnc7", "-o", "set", "--workpiece-out", "perfect.toml"]);
    assert_eq!(code, Some(0), "{err}");
    let run = |part: &str| {
        std::fs::copy(folder.join("set").join("FIT_MAIN.H"), folder.join("MAIN.H")).unwrap();
        json(folder, &["run", "MAIN.H", "--folder", "set", "--no-builtin", "--workpiece", part])
    };
    let (code, answer) = run("perfect.toml");
    assert_eq!((code, answer["faults"].as_array().unwrap().len()), (Some(0), 0), "{answer}");
    let text = std::fs::read_to_string(folder.join("perfect.toml")).unwrap();
    let plan = crate::plans::plan(PLAN);
    let limits = limits(&plan);
    let mut counted = BTreeMap::new();
    for turn in 0..5 {
        let sizes = sizes(&limits, turn);
        std::fs::write(folder.join("part.toml"), resize(&text, &sizes)).unwrap();
        let (code, answer) = run("part.toml");
        let cycles = answer["cycles"].as_array().unwrap();
        assert_eq!((code, cycles.len()), (Some(11), 12), "{answer}");
        for ((cycle, feature), sizes) in cycles.iter().zip(plan.features()).zip(&sizes) {
            let found = cycle["checks"].as_array().unwrap().iter().map(|check| {
                let status = check["status"].as_str().unwrap().to_owned();
                [check["minimum_mm"].to_string(), check["maximum_mm"].to_string(), status]
            });
            let found: Vec<[String; 3]> = found.collect();
            let expected = checked(folder, &feature.kind, sizes);
            let as_lengths = |all: &[[String; 3]]| -> Vec<(Length, Length, String)> {
                let one = |[minimum, maximum, status]: &[String; 3]| {
                    (minimum.parse().unwrap(), maximum.parse().unwrap(), status.clone())
                };
                all.iter().map(one).collect()
            };
            assert_eq!(as_lengths(&found), as_lengths(&expected), "{}, turn {turn}", feature.name);
            // The worst side is the feature's.
            let worst = ["SCRAP", "REWORK", "GOOD"].into_iter().find(|word| expected.iter().any(|[.., it]| it == word));
            assert_eq!(cycle["status"].as_str(), worst, "{}, turn {turn}", feature.name);
            *counted.entry(worst.unwrap()).or_insert(0) += 1;
        }
    }
    assert_eq!(counted.into_iter().collect::<Vec<_>>(), [("GOOD", 34), ("REWORK", 12), ("SCRAP", 14)]);
}
