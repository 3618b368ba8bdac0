//! `fitcheck stats`: published figures through the program, what is left out, and what cannot be computed.

use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

/// The exit code, standard output and standard error of a call in a folder.
pub(crate) fn stats(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    let output = command.current_dir(folder).arg("stats").args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// A folder with one file.
pub(crate) fn with(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fitcheck::files::write(&folder.path().join("values.csv"), text.as_bytes()).unwrap();
    folder
}

/// The answer to a call about one file.
pub(crate) fn answer(text: &str, arguments: &[&str]) -> (Option<i32>, Value) {
    let folder = with(text);
    let call = [&["values.csv", "--format", "json"], arguments].concat();
    let (code, out, _) = stats(folder.path(), &call);
    (code, serde_json::from_str(&out).unwrap())
}

#[track_caller]
pub(crate) fn near(found: &Value, expected: f64, share: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - expected).abs() <= share * expected.abs(), "{found} is not {expected}");
}

fn rings() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/statistics/rings.csv");
    std::fs::read_to_string(path).unwrap()
}

/// Montgomery's piston rings, with exact constants (`crates/statistics/tests/data/pistonrings.json`).
#[test]
fn the_piston_rings_have_their_published_figures() {
    for by in [&["--group", "5"][..], &["--group", "part"]] {
        let (code, found) = answer(&rings(), by);
        assert_eq!(code, Some(0));
        for (name, expected) in [
            ("mean_mm", 74.001_176),
            ("sigma_mm", 0.009_785_337_607_413_175),
            ("sd_mm", 0.010_069_968_126_291_413),
            ("cp", 1.703_228_578_852_444_2),
            ("cpk", 1.663_168_642_677_315_8),
            ("pp", 1.655_086_337_676_795_7),
            ("ppk", 1.616_158_707_014_133_2),
            ("lower_control_mm", 73.988_047_591_956_23),
            ("upper_control_mm", 74.014_304_408_043_8),
            ("spread_centre_mm", 0.022_76),
            ("spread_upper_mm", 0.048_126_000_542_373_766),
        ] {
            near(&found[name]["value"], expected, 1e-9);
        }
        assert_eq!((found["count"].as_u64(), found["groups"].as_u64()), (Some(125), Some(25)));
        assert_eq!(found["cp"]["method"], "mean range / d2");
        assert!(found["cp"]["lower"].as_f64() < found["cp"]["value"].as_f64());
        assert_eq!(found["rules"], Value::Array(Vec::new()));
    }
    let folder = with(&rings());
    let (_, out, _) = stats(folder.path(), &["values.csv", "--group", "5"]);
    assert!(out.contains("125 values, 25 groups of 5\n"), "{out}");
}

/// The limits of the first points do not know the later ones.
#[test]
fn a_baseline_freezes_the_limits() {
    let text = rings();
    let first = text.lines().take(1 + 50).collect::<Vec<_>>().join("\n");
    let (_, frozen) = answer(&text, &["--group", "5", "--baseline", "10"]);
    let (_, alone) = answer(&first, &["--group", "5"]);
    for name in ["centre_mm", "lower_control_mm", "upper_control_mm", "spread_upper_mm"] {
        near(&frozen[name]["value"], alone[name]["value"].as_f64().unwrap(), 1e-12);
    }
    let (code, small) = answer(&text, &["--group", "5", "--baseline", "1"]);
    assert_eq!(code, Some(0));
    assert!(small["centre_mm"]["reason"].as_str().unwrap().contains("at least 2 needed"), "{small}");
}

#[test]
fn simulated_and_doubtful_values_are_left_out_and_counted() {
    let text = "callout;measured;simulated\n25 H7;25.01;false\n25 H7;25.013;false\n25 H7;25.011;true\n25 H7;12.506;false\n25 H7;25.012;false\n";
    let (code, found) = answer(text, &[]);
    assert_eq!(code, Some(14));
    assert_eq!(found["count"], 3);
    assert_eq!(found["left_out"], serde_json::json!({ "simulated": 1, "doubtful": 1 }));
    near(&found["mean_mm"]["value"], 75.035 / 3.0, 1e-12);
    let folder = with(text);
    let (_, out, said) = stats(folder.path(), &["values.csv"]);
    assert!(out.contains("3 values, 2 left out: 1 simulated, 1 doubtful"), "{out}");
    assert!(said.contains("values.csv:5: warning: "), "{said}");
}

/// Nothing that cannot be computed crashes or is a bare figure.
#[test]
fn what_cannot_be_computed_has_a_reason() {
    let of = |rows: &[&str]| -> (Option<i32>, Value) {
        let rows: Vec<String> = rows.iter().map(|row| format!("25 H7;{row}")).collect();
        answer(&format!("callout;measured\n{}\n", rows.join("\n")), &[])
    };
    let (code, none) = of(&[]);
    assert_eq!((code, &none["mean_mm"]["reason"]), (Some(1), &"there are no values".into()));
    let (code, one) = of(&["25.01"]);
    assert_eq!(code, Some(1));
    assert_eq!(one["mean_mm"]["reason"], "too few values or groups: 1, at least 2 needed");
    assert!(one["mean_mm"]["value"].is_null());
    let (code, equal) = of(&["25.01"; 4]);
    assert_eq!(code, Some(1));
    assert_eq!(equal["cpk"]["reason"], "all values are equal: there is no spread to compute with");
    let (code, two) = of(&["25.01", "25.012"]);
    assert_eq!(code, Some(0));
    assert!(two["cpk"]["upper"].as_f64().unwrap() > 2.0 * two["cpk"]["value"].as_f64().unwrap());
    let (code, nan) = of(&["25.01", "nan", "25.012"]);
    assert_eq!((code, &nan["count"]), (Some(1), &2.into()));
    let (code, bare) = answer("measured [mm]\n25.01\n25.013\n25.012\n", &[]);
    assert_eq!((code, &bare["cpk"]["reason"]), (Some(0), &"there are no limits".into()));
    let folder = with("measured [mm]\n25.01\n25.013\n");
    let (code, out, said) = stats(folder.path(), &["values.csv", "--lower", "26", "--upper", "25"]);
    assert_eq!((code, out.as_str()), (Some(1), ""));
    assert!(said.contains("with the lower limit below the upper one"), "{said}");
}

#[test]
fn one_limit_has_no_potential() {
    let text = "measured [mm]\n0.004\n0.006\n0.003\n0.009\n0.005\n0.007\n0.002\n0.006\n";
    let (code, found) = answer(text, &["--upper", "0.02", "--law", "folded-normal"]);
    assert_eq!(code, Some(0));
    assert!(found["cpk"]["value"].is_f64() && found["ppk_percentile"]["lower"].is_f64());
    assert!(found.get("cp").is_none() && found.get("pp_percentile").is_none());
    assert!(found["lower_limit_mm"].is_null());
}

#[test]
fn several_features_are_asked_about() {
    let text = "name;callout;measured\nbore;25 H7;25.01\nhub;40 H7;40.01\nbore;25 H7;25.012\n";
    let folder = with(text);
    let (code, out, said) = stats(folder.path(), &["values.csv"]);
    assert_eq!((code, out.as_str()), (Some(1), ""));
    assert!(said.contains("several features: choose one with --feature: bore, hub"), "{said}");
    let (_, _, said) = stats(folder.path(), &["values.csv", "--feature", "stud"]);
    assert!(said.contains("no feature stud: the files have bore, hub"), "{said}");
    let (code, found) = answer(text, &["--feature", "bore"]);
    assert_eq!((code, &found["count"], &found["feature"]), (Some(0), &2.into(), &"bore".into()));
    let differ = with("name;callout;measured\nbore;25 H7;25.01\nbore;25 H8;25.012\n");
    let (code, _, said) = stats(differ.path(), &["values.csv"]);
    assert!(code == Some(1) && said.contains("limits differ from value to value"), "{said}");
    let (code, _, said) = stats(differ.path(), &["values.csv", "--lower", "25", "--upper", "25.02", "--group", "part"]);
    assert!(code == Some(1) && said.contains("values that do not say to which group they belong: 2"), "{said}");
}

/// The same rings, whose parts are batches or are measured half an hour after each other: every way has the same groups.
#[test]
fn subgroups_are_made_of_batches_and_of_pauses() {
    let rows: Vec<String> = rings()
        .lines()
        .skip(1)
        .enumerate()
        .map(|(at, row)| {
            let (_, row) = row.split_once(',').unwrap();
            let minutes = at / 5 * 34 + at % 5;
            let time = format!("2026-11-17T{:02}:{:02}:00", 6 + minutes / 60, minutes % 60);
            format!("LOT-{},{time},{row}", at / 5)
        })
        .collect();
    let text = format!("batch,time,feature,min,max,measured [mm]\n{}\n", rows.join("\n"));
    let (_, expected) = answer(&rings(), &["--group", "5"]);
    for group in ["batch", "20min", "29 min"] {
        let (code, found) = answer(&text, &["--group", group]);
        assert_eq!((code, &found["groups"]), (Some(0), &25.into()), "{group}");
        for figure in ["cpk", "sigma_mm", "upper_control_mm"] {
            assert_eq!(found[figure], expected[figure], "{figure} by {group}");
        }
    }
    let (_, found) = answer(&text, &["--group", "1h"]);
    assert_eq!(found["groups"], 1, "no pause is as long");
    let folder = with(&text.replacen("LOT-3", "", 1));
    let (code, _, said) = stats(folder.path(), &["values.csv", "--group", "batch"]);
    assert!(code == Some(1) && said.contains("values that do not say to which group they belong: 1"), "{said}");
    for wrong in ["0", "2.5", "month", "min", "-3", "99999999d"] {
        let (code, _, said) = stats(folder.path(), &["values.csv", &format!("--group={wrong}")]);
        assert!(code == Some(2) && said.contains("expected a number of values, part, batch"), "{wrong}: {said}");
    }
}

/// Exactly as long as the pause is no longer than it, and what is measured earlier than the value before begins a group, too.
#[test]
fn a_pause_is_what_is_longer_backwards_as_well() {
    let of = |times: [&str; 3]| {
        let rows = times.map(|time| format!("{time};25 H7;25.010\n"));
        format!("time;callout;measured\n{}", rows.concat())
    };
    let half_past = of(["2026-11-18T07:00:00", "2026-11-18T07:30:00", "2026-11-18T08:00:01"]);
    let (_, found) = answer(&half_past, &["--group", "30min"]);
    assert_eq!(found["groups"], 2);
    let tuesday_first = of(["2026-11-18T07:00:00", "2026-11-17T07:00:00", "2026-11-17T07:10:00"]);
    let (_, found) = answer(&tuesday_first, &["--group", "8h"]);
    assert_eq!(found["groups"], 2);
}

/// Two standard deviations above the mean from point 11 on: the sum grows by 1.5 s a point. A point that is left out is none of them.
#[test]
fn a_cusum_names_the_point_at_which_the_shift_began() {
    let rows: Vec<&str> = std::iter::repeat_n("25.010", 10).chain(std::iter::repeat_n("25.012", 8)).collect();
    let folder = with(&format!("measured [mm]\n{}\n", rows.join("\n")));
    let call = ["values.csv", "--chart", "cusum", "--known", "25.010,0.001", "--rules", "none"];
    let (_, out, _) = stats(folder.path(), &call);
    assert!(out.contains("first at point 14: the mean has moved, since about point 11"), "{out}");
    let (_, out, _) = stats(folder.path(), &[&call[..], &["--leave-out", "12=chip"]].concat());
    assert!(out.contains("first at point 15: the mean has moved, since about point 11"), "{out}");
}

/// 24 parts measured once and one measured twice: the limits come from one range.
#[test]
fn limits_from_few_groups_of_several_values_are_told() {
    let rows: Vec<String> = (0..25).map(|at| format!("S-{};ring;25.0{}", at.min(23), 10 + at % 3)).collect();
    let text = format!("serial;feature;measured [mm]\n{}\n", rows.join("\n"));
    let folder = with(&text);
    let (_, out, _) = stats(folder.path(), &["values.csv", "--group", "part"]);
    assert!(out.contains("control limits come from 1 points: 20 or more are usual"), "{out}");
}

/// A series that alarms everywhere is not a page of numbers; machines get all of them.
#[test]
fn people_see_the_first_points_of_a_rule() {
    let rows: Vec<String> = (0..80).map(|at| format!("{}", 25.0 + f64::from(at) / 1_000.0)).collect();
    let text = format!("measured [mm]\n{}\n", rows.join("\n"));
    let folder = with(&text);
    let (_, out, _) = stats(folder.path(), &["values.csv", "--rules", "nelson-3"]);
    assert!(out.contains("(nelson-3): at 6, 7, 8,") && out.contains(", 25, … (75 points)"), "{out}");
    let (_, found) = answer(&text, &["--rules", "nelson-3"]);
    assert_eq!(found["rules"][0]["points"].as_array().unwrap().len(), 75);
}
