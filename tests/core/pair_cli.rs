//! `fitcheck pair`, through the built program.

use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::Path;

use assert_cmd::Command;
use serde_json::{Value, json};

struct Answer {
    out: String,
    err: String,
    code: i32,
}

fn put(folder: &Path, name: &str, text: &str) {
    std::fs::File::create(folder.join(name)).and_then(|mut file| file.write_all(text.as_bytes())).unwrap();
}

fn run(folder: &Path, args: &[&str]) -> Answer {
    let mut command = Command::cargo_bin("fitcheck").unwrap();
    let output = command.current_dir(folder).arg("pair").args(args).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Answer { out: text(output.stdout), err: text(output.stderr), code: output.status.code().unwrap() }
}

/// The answer for two files.
fn pair(holes: &str, shafts: &str, args: &[&str]) -> Answer {
    let folder = tempfile::tempdir().unwrap();
    put(folder.path(), "holes.csv", holes);
    put(folder.path(), "shafts.csv", shafts);
    run(folder.path(), &[&["holes.csv", "shafts.csv"], args].concat())
}

fn told(holes: &str, shafts: &str, args: &[&str]) -> (Value, i32) {
    let answer = pair(holes, shafts, &[args, &["--format", "json"]].concat());
    (
        serde_json::from_str(&answer.out).unwrap_or_else(|error| panic!("{error}: {}{}", answer.out, answer.err)),
        answer.code,
    )
}

const HOLES: &str = "id;measured\nH1;25,012\nH2;25,004\nH3;25,021\nH4;25,008\nH5;25,002\n";
const SHAFTS: &str = "id;measured\nS1;24,990\nS2;24,985\nS3;25,004\nS4;24,994\nS5;24,998\n";
const WANTED: [&str; 2] = ["--clearance", "0.010..0.030"];

fn ids(pairs: &Value) -> Vec<String> {
    let id = |part: &Value| part["id"].as_str().unwrap().to_owned();
    pairs.as_array().unwrap().iter().map(|pair| id(&pair["hole"]) + "-" + &id(&pair["shaft"])).collect()
}

#[test]
fn names_and_measured_sizes_are_enough() {
    let (answer, code) = told(HOLES, SHAFTS, &WANTED);
    assert_eq!(code, 0);
    assert_eq!(ids(&answer["pairs"]), ["H5-S2", "H2-S1", "H4-S4", "H1-S5", "H3-S3"]);
    let clearances: Vec<_> = answer["pairs"].as_array().unwrap().iter().map(|pair| &pair["clearance_um"]).collect();
    assert_eq!(clearances, [17, 14, 14, 14, 17]);
    // Twice the 6 µm from the middle, 20 µm.
    let actual = json!({"pairs": 5, "minimum_clearance_um": 14, "maximum_clearance_um": 17, "band_um": 12});
    assert_eq!(answer["actual"], actual);
    let part = json!({"id": "H5", "line": 6, "mm": 25.002, "group": null, "simulated": false});
    assert_eq!(answer["pairs"][0]["hole"], part);
    assert_eq!((&answer["grinding"], &answer["groups"]), (&Value::Null, &Value::Null));
}

#[test]
fn a_bound_is_wanted_and_a_nanometre_more_is_left_over() {
    for (shaft, pairs) in [("24.990001", 0), ("24.99", 1), ("24.97", 1), ("24.969999", 0)] {
        let (answer, code) = told("id;measured\nH;25\n", &format!("id;measured\nS;{shaft}\n"), &WANTED);
        let left = [&answer["leftover_holes"], &answer["leftover_shafts"]].map(|left| left.as_array().unwrap().len());
        assert_eq!((answer["pairs"].as_array().unwrap().len(), left, code), (pairs, [1 - pairs; 2], 0), "{shaft}");
    }
}

#[test]
fn a_fit_gives_the_bounds_and_its_zones_the_groups() {
    let args = ["--fit", "25 H7/g6", "--classes", "3"];
    let holes = "id;callout;measured\na;25 H7;25.006999\nb;25 H7;25.007\nc;25 H7;25.021\nd;25 H7;25.0211\n";
    let (answer, code) = told(holes, "id;measured\ns;24.98\nt;24.993\n", &args);
    assert_eq!(code, 0);
    let bounds = ["fit", "minimum_clearance_um", "maximum_clearance_um"].map(|name| answer[name].clone());
    assert_eq!(bounds, [json!("25 H7/g6"), json!(7), json!(41)]);
    let group = |hole: &Value| (hole["id"].clone(), hole["group"].clone());
    let pairs = answer["pairs"].as_array().unwrap().iter().map(|pair| group(&pair["hole"]));
    let holes: BTreeMap<String, Value> = pairs
        .chain(answer["leftover_holes"].as_array().unwrap().iter().map(group))
        .map(|(id, group)| (id.as_str().unwrap().to_owned(), group))
        .collect();
    assert_eq!(json!(holes), json!({"a": 1, "b": 2, "c": 3, "d": null}));
    assert_eq!((&answer["holes_outside_groups"], &answer["shafts_outside_groups"]), (&json!(1), &json!(0)));
    let first = json!({
        "number": 1, "hole_from_mm": 25.0, "hole_to_mm": 25.007, "shaft_from_mm": 24.98, "shaft_to_mm": 24.984_334,
        "holes": 1, "shafts": 1, "pairs": 1, "minimum_clearance_um": 26.999, "maximum_clearance_um": 26.999,
        "all_within": true,
    });
    assert_eq!(answer["groups"][0], first);
    assert_eq!(answer["groups"][1]["minimum_clearance_um"], Value::Null);
}

#[test]
fn leftovers_are_named_and_one_amount_saves_most() {
    let holes = "id;measured\na;25.000\nb;25.001\nc;25.002\n";
    let shafts = "id;measured\ns;24.990\nt;24.995\nu;24.996\nv;25.6\n";
    let (answer, _) = told(holes, shafts, &WANTED);
    // 12 µm is closer to the middle than 10 or 11 µm.
    assert_eq!(ids(&answer["pairs"]), ["c-s"]);
    let grinding = json!({"amount_um": 5, "pairs": 2, "tried_um": 610, "reach_um": 610, "bounded": false});
    assert_eq!((&answer["grinding"], ids(&answer["saved"])), (&grinding, vec!["a-t".to_owned(), "b-u".to_owned()]));
    assert_eq!(answer["saved"][0]["clearance_um"], 10);
    let (answer, _) = told("id;measured\na;25\n", "id;measured\ns;26.5\n", &WANTED);
    let grinding = json!({"amount_um": null, "pairs": 0, "tried_um": 1000, "reach_um": 1510, "bounded": true});
    assert_eq!(answer["grinding"], grinding);
}

#[test]
fn what_cannot_be_used_is_refused_with_its_place_and_the_rest_is_paired() {
    let holes =
        "id;callout;measured\nH1;25 H7;25.012\nH2;25 H7;\nH3;25 g6;25.010\nH4;no callout;25.011\n# H5;25 H7;25.013\n";
    let answer = pair(holes, "id;measured\nS1;24.99\nS2;24.991\nS3;0\nS4\n", &WANTED);
    assert_eq!(answer.code, 1);
    assert_eq!(
        answer.err,
        "\
holes.csv:3:3: measured: a length is missing
holes.csv:4:2: 25 g6 is a shaft, and these are the holes: are the files swapped?
holes.csv:6: a line that begins with # is a comment, but this one holds a measurement
shafts.csv:4:2: measured: a diameter of 0 is not above 0
shafts.csv:5: expected 2 cells, found 1
"
    );
    assert!(answer.out.contains("2 holes, 2 shafts") && answer.out.contains("5 rows refused"), "{}", answer.out);
    let (answer, code) = told(holes, "id;measured\nS1;24.99\nS2;24.991\nS3;0\nS4\n", &WANTED);
    let places: Vec<_> = answer["refused"].as_array().unwrap().iter().map(|row| (&row["file"], &row["line"])).collect();
    assert_eq!(
        json!(places),
        json!([["holes.csv", 3], ["holes.csv", 4], ["holes.csv", 6], ["shafts.csv", 4], ["shafts.csv", 5]])
    );
    assert_eq!((ids(&answer["pairs"]).len(), code), (2, 1));
}

#[test]
fn a_comment_that_hides_a_size_is_refused_also_without_callouts() {
    let answer = pair("id;measured\nH1;25.012\n# H2;25.013\n# by hand\n", "id;measured\nS1;24.99\n", &WANTED);
    let said = "holes.csv:3: a line that begins with # is a comment, but this one holds a measurement\n";
    assert_eq!((answer.err.as_str(), answer.code), (said, 1));
}

#[test]
fn a_file_that_is_none_is_named() {
    for (holes, said) in [
        ("", "holes.csv:1: the file is empty\n"),
        ("id;measured\n", "holes.csv:1: no row holds a measurement\n"),
        (
            "1;25.01\n2;25.02\n",
            "holes.csv:1: rows of two or three numbers are contacts: name the columns in the first line, such as id;measured\n",
        ),
        (
            "id;name\na;b\n",
            "holes.csv:1: no column of measured values: name it in the first line, such as id;callout;measured\n",
        ),
    ] {
        let answer = pair(holes, "id;measured\nS1;24.99\n", &WANTED);
        assert_eq!((answer.err.as_str(), answer.code), (said, 1), "{holes:?}");
        assert!(answer.out.starts_with("0 holes, 1 shaft"), "{}", answer.out);
    }
    let folder = tempfile::tempdir().unwrap();
    let answer = run(folder.path(), &[&["a.csv", "b.csv"], WANTED.as_slice()].concat());
    assert_eq!((answer.out.as_str(), answer.code), ("", 1));
    assert!(answer.err.contains("a.csv"), "{}", answer.err);
}

#[test]
fn logs_are_sizes_and_know_hole_and_shaft() {
    let folder = tempfile::tempdir().unwrap();
    let log = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs/en/TCHPR421.TXT");
    put(folder.path(), "TCHPR421.TXT", &std::fs::read_to_string(log).unwrap());
    put(folder.path(), "shafts.csv", "id;measured\nS1;24.9\n");
    let answer = run(folder.path(), &["TCHPR421.TXT", "shafts.csv", "--clearance", "0..1", "--format", "json"]);
    let read: Value = serde_json::from_str(&answer.out).unwrap();
    assert_eq!((&read["holes"], answer.code), (&json!(1), 0), "{}", answer.err);
    let answer = run(folder.path(), &["shafts.csv", "TCHPR421.TXT", "--clearance", "0..1"]);
    let said = "TCHPR421.TXT:1: this is the log of a hole, and these are the shafts: are the files swapped?\n";
    assert_eq!((answer.err.as_str(), answer.code), (said, 1));
}

#[test]
fn simulated_rows_and_repeated_names_are_said() {
    let holes = "id;measured;simulated\nH1;25.012;true\nH1;25.013;false\nH1;25.014;\n";
    let shafts = "id;measured\nS1;24.99\nS2;24.991\n";
    let answer = pair(holes, shafts, &WANTED);
    assert_eq!(
        answer.err,
        "\
holes.csv: warning: 2 rows have the name of an earlier row, such as H1 on lines 2 and 3: each row counts as a part
holes.csv: warning: 1 row is simulated: nothing was measured
"
    );
    assert_eq!(answer.code, 0);
    assert_eq!(answer.out.matches("hole simulated").count(), 1, "{}", answer.out);
    let (read, _) = told(holes, shafts, &WANTED);
    assert_eq!(read["warnings"].as_array().unwrap().len(), 2);
    assert_eq!(read["pairs"][0]["hole"]["simulated"], true);
}

#[test]
fn csv_has_a_row_for_each_result_and_no_formula() {
    let holes = "id;measured\n=1+1;25.000\nb;25.001\nc;x\n";
    let answer = pair(
        holes,
        "id;measured\ns;24.990\nt;24.995\n",
        &[&WANTED[..], &["--classes", "1", "--format", "csv"]].concat(),
    );
    let rows: Vec<BTreeMap<String, String>> =
        csv::Reader::from_reader(answer.out.as_bytes()).deserialize().collect::<Result<_, _>>().unwrap();
    let results: Vec<_> = rows.iter().map(|row| row["result"].as_str()).collect();
    assert_eq!(results, ["pair", "leftover", "leftover", "grinding", "saved", "group", "refused"]);
    assert_eq!((rows[0]["hole_id"].as_str(), rows[0]["clearance_um"].as_str()), ("b", "11"));
    assert_eq!((rows[1]["hole_id"].as_str(), rows[2]["shaft_id"].as_str()), ("'=1+1", "t"));
    assert_eq!((rows[3]["grinding_amount_um"].as_str(), rows[3]["grinding_pairs"].as_str()), ("5", "1"));
    assert_eq!((rows[5]["group_number"].as_str(), rows[5]["group_all_within"].as_str()), ("1", "false"));
    assert_eq!((rows[6]["refused_file"].as_str(), rows[6]["refused_line"].as_str()), ("holes.csv", "4"));
}

#[test]
fn the_answer_is_written_whole_and_never_over_its_own_files() {
    let folder = tempfile::tempdir().unwrap();
    put(folder.path(), "holes.csv", HOLES);
    put(folder.path(), "shafts.csv", SHAFTS);
    let printed = run(folder.path(), &[&["holes.csv", "shafts.csv", "--format", "json"], WANTED.as_slice()].concat());
    let args = [&["holes.csv", "shafts.csv", "--format", "json", "-o", "a.json"], WANTED.as_slice()].concat();
    let written = run(folder.path(), &args);
    assert_eq!((written.out.as_str(), written.err.as_str(), written.code), ("", "wrote a.json\n", 0));
    assert_eq!(std::fs::read_to_string(folder.path().join("a.json")).unwrap(), printed.out);
    let refused = run(folder.path(), &[&["holes.csv", "shafts.csv", "-o", "holes.csv"], WANTED.as_slice()].concat());
    let said = "fitcheck: holes.csv is one of the inputs: write the answers to another file\n";
    assert_eq!((refused.err.as_str(), refused.code), (said, 1));
    assert_eq!(std::fs::read_to_string(folder.path().join("holes.csv")).unwrap(), HOLES);
}

#[test]
fn exactly_one_of_clearance_and_fit_is_needed() {
    assert_eq!(pair(HOLES, SHAFTS, &[]).code, 2);
    assert_eq!(pair(HOLES, SHAFTS, &["--clearance", "0..1", "--fit", "25 H7/g6"]).code, 2);
    assert_eq!(pair(HOLES, SHAFTS, &["--clearance", "0..1", "--classes", "1001"]).code, 2);
    for (args, said) in [
        (["--clearance", "0.03..0.01"], "the smallest clearance 0.03 mm is larger than the largest, 0.01 mm"),
        (["--fit", "25 H7"], "25 H7"),
    ] {
        let answer = pair(HOLES, SHAFTS, &args);
        assert_eq!((answer.out.as_str(), answer.code), ("", 1));
        assert!(answer.err.contains(said), "{}", answer.err);
    }
    let unused = pair(HOLES, SHAFTS, &[&WANTED[..], &["--edition", "1988"]].concat());
    assert!(unused.err.starts_with("warning: --tables"), "{}", unused.err);
}

#[test]
fn the_order_of_rows_changes_no_clearance() {
    let reversed = |text: &str| {
        let mut rows: Vec<&str> = text.lines().skip(1).collect();
        rows.reverse();
        format!("id;measured\n{}\n", rows.join("\n"))
    };
    let (one, _) = told(HOLES, SHAFTS, &WANTED);
    let (other, _) = told(&reversed(HOLES), &reversed(SHAFTS), &WANTED);
    assert_eq!(ids(&one["pairs"]), ids(&other["pairs"]));
}

#[test]
fn a_part_outside_its_own_limits_is_told_where_a_fit_is_given() {
    let said = |holes: &str, args: &[&str]| pair(holes, "id;measured\nS1;24,990\n", args).err;
    let fit = ["--fit", "25 H7/g6"];
    assert_eq!(said("id;measured\nH1;25,021\n", &fit), "");
    let warning = "holes.csv: warning: 1 part is outside its own limits: pairs are chosen by clearance alone\n";
    assert_eq!(said("id;measured\nH1;25,021001\n", &fit), warning);
    assert_eq!(said("id;measured\nH1;25,021001\n", &["--clearance", "0.010..0.040"]), "");
    let (answer, code) = told("id;measured\nH1;25,03\nH2;25,04\n", "id;measured\nS1;24,990\n", &fit);
    assert_eq!(code, 0);
    let warnings = answer["holes"]["warnings"].as_array().or(answer["warnings"].as_array()).unwrap();
    assert!(warnings.iter().any(|said| said.as_str().unwrap().contains("2 parts are outside")), "{answer}");
}
