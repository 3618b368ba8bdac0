//! `fitcheck fit`, through the built program.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::{Value, json};

fn fit(args: &[&str], input: &str) -> (String, String, i32) {
    let answer = cargo_bin_cmd!("fitcheck").arg("fit").args(args).write_stdin(input.as_bytes().to_vec()).assert();
    let output = answer.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (text(&output.stdout), text(&output.stderr), output.status.code().unwrap())
}

/// Standard output, standard error and exit code.
#[track_caller]
fn check(args: &[&str], out: &str, err: &str, code: i32) {
    assert_eq!(fit(args, ""), (out.to_owned(), err.to_owned(), code), "for {args:?}");
}

#[track_caller]
fn told(args: &[&str]) -> Value {
    let args = [args, &["--format", "json"]].concat();
    let (out, err, _) = fit(&args, "");
    serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {out}{err}"))
}

/// Records of CSV by column.
fn records(csv: &str) -> Vec<std::collections::BTreeMap<String, String>> {
    csv::Reader::from_reader(csv.as_bytes()).deserialize().collect::<Result<_, _>>().unwrap()
}

#[test]
fn text_is_a_few_aligned_lines() {
    check(
        &["50 H7/p6"],
        "\
50 H7/p6  interference fit, preferred fit of the hole basis, locational interference
  clearance    -42 … -1 µm, mean -21.5 µm (negative is interference)
  hole H7      50.000 … 50.025 mm      (0 / +25 µm)        from ISO 286, over 30 up to 50 mm
  shaft p6     50.026 … 50.042 mm      (+26 / +42 µm)      from ISO 286, over 30 up to 50 mm
  other basis  50 P7/h6, exactly the same clearances
",
        "",
        0,
    );
    check(
        &["2H7-p6", "25 H7/h6"],
        "\
2 H7/p6  transition fit, preferred fit of the hole basis, locational interference
  clearance    -12 … +4 µm, mean -4 µm (negative is interference)
  hole H7      2.000 … 2.010 mm        (0 / +10 µm)        from ISO 286, over 0 up to 3 mm
  shaft p6     2.006 … 2.012 mm        (+6 / +12 µm)       from ISO 286, over 0 up to 3 mm
  other basis  2 P7/h6, not the same: -16 … 0 µm, interference fit

25 H7/h6  clearance fit, hole and shaft basis, preferred fit of the hole basis, locational clearance
  clearance    0 … +34 µm, mean +17 µm
  hole H7      25.000 … 25.021 mm      (0 / +21 µm)        from ISO 286, over 18 up to 30 mm
  shaft h6     24.987 … 25.000 mm      (-13 / 0 µm)        from ISO 286, over 18 up to 30 mm
",
        "",
        0,
    );
}

#[test]
fn two_measured_parts_and_two_temperatures_in_text() {
    let args = ["50 H7/p6", "--hole", "50,010", "--shaft", "50.05", "--hole-material", "staal"];
    let (out, err, code) =
        fit(&[args.as_slice(), &["--shaft-material", "16", "--hole-temperature", "220"]].concat(), "");
    let expected = "  this hole    50.010 mm  GOOD
  this shaft   50.050 mm  REWORK, remove 0.008 mm to the nearest limit
  actual       -40 µm, within what the fit allows
  when warm    +73 … +114 µm, clearance fit, +115 µm against 20 °C
               actual +75 µm
               hole at 220 °C: steel, 11.5 millionths per kelvin from -100 to 250 °C (published value)
               shaft at 20 °C: 16 millionths per kelvin from -50 to 200 °C (own value)
";
    assert_eq!((out.get(out.find("  this hole").unwrap()..), err.as_str(), code), (Some(expected), "", 10));
}

#[test]
fn json_of_one_fit_is_an_object_with_all_of_it() {
    let told = told(&["50 H7/p6", "--hole", "50.010", "--shaft", "50.030"]);
    assert_eq!(
        told,
        json!({
            "callout": "50 H7/p6", "nominal_mm": 50, "kind": "interference",
            "minimum_clearance_um": -42, "maximum_clearance_um": -1, "mean_clearance_um": -21.5,
            "basis": "hole", "preferred": "hole basis", "function": "locational-interference",
            "hole": {
                "class": "H7", "min_mm": 50.0, "max_mm": 50.025, "lower_um": 0, "upper_um": 25,
                "source": "ISO 286, over 30 up to 50 mm"
            },
            "shaft": {
                "class": "p6", "min_mm": 50.026, "max_mm": 50.042, "lower_um": 26, "upper_um": 42,
                "source": "ISO 286, over 30 up to 50 mm"
            },
            "equivalent": {
                "callout": "50 P7/h6", "exact": true, "minimum_clearance_um": -42, "maximum_clearance_um": -1,
                "error": null
            },
            "actual": {
                "hole_mm": 50.01, "shaft_mm": 50.03, "clearance_um": -20, "conforms": true,
                "hole_status": "GOOD", "shaft_status": "GOOD", "hole_remove_um": null, "shaft_remove_um": null
            },
            "possible": null, "temperature": null, "press": null, "error": null
        })
    );
}

#[test]
fn kinds_of_the_worked_examples() {
    for (callout, kind, minimum, maximum) in [
        ("25 H7/g6", "clearance", 7, 41),
        ("25 H7/k6", "transition", -15, 19),
        ("50 H7/p6", "interference", -42, -1),
        ("2 H7/p6", "transition", -12, 4),
        ("25 H7/h6", "clearance", 0, 34),
        ("2 P7/h6", "interference", -16, 0),
    ] {
        let told = told(&[callout]);
        let said = [&told["kind"], &told["minimum_clearance_um"], &told["maximum_clearance_um"]];
        assert_eq!(said, [&json!(kind), &json!(minimum), &json!(maximum)], "{callout}");
    }
}

#[test]
fn the_exit_code_is_that_of_the_worse_part() {
    for (hole, shaft, code, conforms) in [
        ("50.000", "50.042", 0, true),
        ("50.025", "50.026", 0, true),
        ("49.999999", "50.030", 10, true),
        ("50.010", "50.042001", 10, true),
        ("50.025001", "50.042001", 11, true),
        ("50.010", "50.025999", 11, true),
        ("50.025001", "50.026", 11, false),
        ("49.999999", "50.042", 10, false),
    ] {
        let (out, _, got) = fit(&["50 H7/p6", "--hole", hole, "--shaft", shaft, "--format", "json"], "");
        let told: Value = serde_json::from_str(&out).unwrap();
        assert_eq!((got, &told["actual"]["conforms"]), (code, &json!(conforms)), "{hole} {shaft}");
    }
}

#[test]
fn one_part_alone_is_judged_and_leaves_a_range() {
    let (out, _, code) = fit(&["50 H7/p6", "--hole", "49.99", "--format", "json"], "");
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(code, 10);
    assert_eq!(told["actual"], Value::Null);
    assert_eq!(
        told["possible"],
        json!({
            "feature": "hole", "measured_mm": 49.99, "status": "REWORK", "remove_um": 10,
            "minimum_clearance_um": -52, "maximum_clearance_um": -36
        })
    );
    let (_, err, code) = fit(&["25 H7/g6", "--shaft", "0.984"], "");
    let doubt = "warning: shaft: measured value is the nominal size divided by 25.4: is it in inch?\n";
    assert_eq!((err.as_str(), code), (doubt, 11));
}

#[test]
fn the_clearance_at_a_temperature() {
    let materials = ["25 H7/g6", "--hole-material", "aluminium", "--shaft-material", "Stainless Steel"];
    let told = told(&[materials.as_slice(), &["--temperature", "-40 °C", "--hole", "25", "--shaft", "24.99"]].concat());
    // (23.1 − 16) · (−60) · 25 mm = −10.65 µm
    assert_eq!(
        told["temperature"],
        json!({
            "hole_c": -40, "shaft_c": -40, "change_um": -10.65,
            "minimum_clearance_um": -3.65, "maximum_clearance_um": 30.35, "kind": "transition",
            "actual_clearance_um": -0.65,
            "hole_material": {
                "name": "aluminium", "expansion_um_per_m_k": 23.1, "certainty": "published",
                "source": "one published table of length measurement"
            },
            "shaft_material": {
                "name": "stainless steel", "expansion_um_per_m_k": 16, "certainty": "verify",
                "source": "usual handbook value"
            }
        })
    );
}

#[test]
fn own_materials_come_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("own.toml");
    std::fs::write(&file, "version = 1\n[[material]]\nname = \"delrin\"\nexpansion = 122\n").unwrap();
    let path = file.to_str().unwrap();
    let args = |hole| {
        ["25 H7/g6", "--hole-material", hole, "--shaft-material", "steel", "--temperature", "30", "--materials", path]
    };
    let told = told(&args("Delrin"));
    assert_eq!(told["temperature"]["change_um"], json!(27.625));
    assert_eq!(told["temperature"]["hole_material"]["certainty"], json!("own"));
    std::fs::write(&file, "version = 1\n[[material]]\nname = \"1.4301\"\nexpansion = 16\n").unwrap();
    let numbered = self::told(&args("1.4301"));
    assert_eq!(numbered["temperature"]["hole_material"]["name"], json!("1.4301"));
    assert!(fit(&args("42CrMo4"), "").1.contains("unknown material 42CrMo4: choose one of steel, "));
    assert!(fit(&args("6061"), "").1.contains("an expansion of 6061 is out of range"));
    std::fs::write(&file, "version = 1\n[[material]]\nname = \"delrin\"\nexpansion = 1220\n").unwrap();
    let (_, err, code) = fit(&args("delrin"), "");
    assert_eq!(code, 1);
    assert!(err.contains("own.toml: line 4, column 13: an expansion of 1220 is out of range"), "{err}");
}

#[test]
fn a_stream_gets_one_line_for_each_line_refusals_included() {
    let input = "50 H7/p6\n25 H7\n\n25 h6/G7\r\n25 G7/h6\n600 H7/c8\n";
    let (out, err, code) = fit(&["-", "--format", "csv"], input);
    let records = records(&out);
    assert_eq!((err.as_str(), code, records.len()), ("4 of 6 callouts refused\n", 1, 6));
    let errors: Vec<&str> = records.iter().map(|record| record["error"].as_str()).collect();
    assert_eq!(
        errors,
        [
            "",
            "25 H7 is not a fit: write a size, a hole class and a shaft class, such as 25 H7/g6",
            "a callout is missing: write a nominal size and a tolerance class, such as 25 H7",
            "the shaft comes before the hole: write 25 G7/h6 (character 4)",
            "",
            "c8 is not defined at 600 mm in ISO 286; it is defined over 0 up to 500 mm",
        ]
    );
    assert_eq!(records[0]["hole_max_mm"], "50.025");
    assert_eq!(records[0]["minimum_clearance_um"], "-42");
    assert_eq!(
        (records[4]["preferred"].as_str(), records[4]["equivalent_callout"].as_str()),
        ("shaft basis", "25 H7/g6")
    );
    let (out, _, _) = fit(&["-", "--format", "json"], input);
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(told.as_array().unwrap().len(), 6);
    assert_eq!(fit(&["-", "--format", "json"], ""), ("[]\n".to_owned(), String::new(), 0));
}

/// Every value of an object by its joined names.
fn flat(value: &Value, name: &str, into: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                let joined = if name.is_empty() { key.clone() } else { format!("{name}_{key}") };
                flat(value, &joined, into);
            }
        }
        value => into.push((name.to_owned(), value.clone())),
    }
}

#[test]
fn csv_has_the_names_and_values_of_json() {
    let heat = ["--hole-material", "brass", "--shaft-material", "steel", "--temperature", "85.5"];
    for parts in [["--hole", "24.99", "--shaft", "24.9"].as_slice(), &["--shaft", "25.1"]] {
        let args = [["25 H7/g6"].as_slice(), &heat, parts].concat();
        let (csv, _, _) = fit(&[args.as_slice(), &["--format", "csv"]].concat(), "");
        let record = records(&csv).remove(0);
        let mut values = Vec::new();
        flat(&told(&args), "", &mut values);
        assert!(30 < values.len());
        for (name, value) in values {
            let Some(cell) = record.get(&name) else {
                assert_eq!(value, Value::Null, "{name} is no column");
                continue;
            };
            match value {
                Value::Null => assert_eq!(cell, "", "{name}"),
                Value::Number(number) => assert_eq!(cell.parse::<f64>().ok(), number.as_f64(), "{name}"),
                Value::String(text) => assert_eq!(cell, &text, "{name}"),
                other => assert_eq!(cell, &other.to_string(), "{name}"),
            }
        }
    }
}

#[test]
fn a_search_lists_the_best_pairs() {
    let args = ["25", "--min-clearance", "0.007", "--max-clearance", "41 µm"];
    let (out, err, code) = fit(&[args.as_slice(), &["--limit", "3", "--scope", "preferred"]].concat(), "");
    let expected = "\
25 mm, clearance +7 … +41 µm: 4 pairs, the best 3
  H7/g6      +7 … +41 µm           clearance fit, preferred fit of the hole basis, sliding
  H6/g5      +7 … +29 µm           clearance fit, preferred fit of the hole basis
  G7/h6      +7 … +41 µm           clearance fit, preferred fit of the shaft basis, sliding
";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    let told = told(&[args.as_slice(), &["--limit", "1"]].concat());
    assert_eq!(
        told["candidates"],
        json!([{
            "callout": "25 H7/g6", "hole": "H7", "shaft": "g6", "kind": "clearance",
            "minimum_clearance_um": 7, "maximum_clearance_um": 41,
            "basis": "hole", "preferred": "hole basis", "function": "sliding"
        }])
    );
    assert!(100 < told["total"].as_u64().unwrap());
    let (csv, _, _) = fit(&[args.as_slice(), &["--format", "csv"]].concat(), "");
    assert_eq!(records(&csv).len(), 20);
    assert_eq!(records(&csv)[0]["callout"], "25 H7/g6");
}

#[test]
fn a_search_for_interference_takes_negative_clearances() {
    let told = told(&["Ø50", "--min-clearance", "-0.042", "--max-clearance", "-0.001", "--limit", "2"]);
    // 50 H6/n5 is -28 to -1 and as wide as H6/p5, -37 to -10: by letters.
    let found: Vec<&Value> = told["candidates"].as_array().unwrap().iter().map(|one| &one["callout"]).collect();
    assert_eq!(found, ["50 H7/p6", "50 H6/n5"]);
    let narrower = fit(&["50", "--min-clearance=-0.041999", "--max-clearance=-0.001", "--format", "csv"], "").0;
    assert!(!narrower.contains("H7,p6,"), "{narrower}");
}

#[test]
fn a_search_without_a_find_names_the_nearest() {
    check(
        &["25", "--min-clearance", "0.008", "--max-clearance", "0.041", "--scope", "preferred"],
        "25 mm, clearance +8 … +41 µm: 0 pairs\n  nearest is H7/g6 with +7 … +41 µm, 1 µm below\n",
        "",
        0,
    );
}

#[test]
fn a_function_gives_its_pairs() {
    let told = told(&["2", "--function", "locational-interference"]);
    let kinds: Vec<[&Value; 2]> =
        told["candidates"].as_array().unwrap().iter().map(|one| [&one["callout"], &one["kind"]]).collect();
    assert_eq!(kinds, [[&json!("2 H7/p6"), &json!("transition")], [&json!("2 P7/h6"), &json!("interference")]]);
    check(
        &["600", "--function", "loose-running"],
        "600 mm, loose running\n",
        "600 H11/c11: c11 is not defined at 600 mm in ISO 286; it is defined over 0 up to 500 mm\n\
         600 C11/h11: C11 is not defined at 600 mm in ISO 286; it is defined over 0 up to 500 mm\n",
        1,
    );
}

#[test]
fn own_tables_and_the_controls_tables_count() {
    let folder = tempfile::tempdir().unwrap();
    let table = "BEGIN OWN .TAB MM\nNR  BEREICH H7   \n0   400     +5   \n1   400     0    \n[END]\n";
    std::fs::write(folder.path().join("own.tab"), table).unwrap();
    let told_here = told(&["25 H7/g6", "--tables", folder.path().to_str().unwrap()]);
    assert_eq!((&told_here["maximum_clearance_um"], &told_here["hole"]["upper_um"]), (&json!(25), &json!(5)));
    let source = told_here["hole"]["source"].as_str().unwrap();
    assert!(source.starts_with("table own.tab") && source.ends_with("instead of 0 / +21 µm in ISO 286"), "{source}");
    let control = told(&["25 H7/g6", "--source", "control"]);
    assert_eq!(control["maximum_clearance_um"], json!(41));
    let (_, err, code) = fit(&["400.5 H7/g6", "--source", "control"], "");
    assert_eq!(code, 1);
    assert!(err.contains("400.5 mm is beyond table"), "{err}");
    let all = told(&["25", "--min-clearance=-1", "--max-clearance", "1", "--source", "control"]);
    assert_eq!(all["total"], json!(24 * 23));
}

#[test]
fn wrong_data_ends_with_1_and_wrong_usage_with_2() {
    let code = |args: &[&str]| fit(args, "").2;
    for args in [
        ["25 H7/g6", "--hole", "0"].as_slice(),
        &["25 H7/g6", "--shaft", "-3"],
        &["25 H7/g6", "--shaft", "x"],
        &["25 H7/g6", "25 H7/h6", "--shaft", "25"],
        &["-", "--shaft", "25"],
        &["25", "--min-clearance", "1", "--max-clearance", "0"],
        &["25", "--min-clearance", "x", "--max-clearance", "0"],
        &["3150.1", "--min-clearance", "0", "--max-clearance", "1"],
        &["-5", "--min-clearance", "0", "--max-clearance", "1"],
        &["25 H7/g6", "--min-clearance", "0", "--max-clearance", "1"],
        &["25", "26", "--function", "sliding"],
        &["25", "--function", "sliding", "--hole", "25"],
        &["25 H7/g6", "--hole-material", "wood", "--shaft-material", "steel", "--temperature", "30"],
        &["25 H7/g6", "--hole-material", "steel", "--shaft-material", "steel", "--temperature", "-300"],
    ] {
        assert_eq!(code(args), 1, "{args:?}");
    }
    for args in [
        [].as_slice(),
        &["25", "--min-clearance", "1"],
        &["25", "--function", "gliding"],
        &["25", "--function", "sliding", "--scope", "all"],
        &["25 H7/g6", "--temperature", "30"],
        &["25 H7/g6", "--hole-material", "steel", "--temperature", "30"],
        &["25 H7/g6", "--hole-material", "steel", "--shaft-material", "steel"],
        &["25 H7/g6", "--edition", "1999"],
    ] {
        assert_eq!(code(args), 2, "{args:?}");
    }
}

#[test]
#[cfg(unix)]
fn a_closed_pipe_keeps_the_verdict() {
    use std::process::{Command, Stdio};
    for (format, shaft, expected) in [("text", "50.05", 10), ("json", "50.02", 11), ("csv", "50.03", 0)] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let status = Command::new(assert_cmd::cargo::cargo_bin!("fitcheck"))
            .args(["fit", "50 H7/p6", "--hole", "50.010", "--shaft", shaft, "--format", format])
            .stdout(Stdio::from(writer))
            .stderr(Stdio::null())
            .status()
            .unwrap();
        assert_eq!(status.code(), Some(expected), "{format}");
    }
}
