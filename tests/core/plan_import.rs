//! One plan for everything: its values come from wherever they are, each finds its feature, and all of them are in the records.

use std::collections::BTreeMap;
use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

/// Twelve features; the first four are measured by a control, the others by hand, gauge and machine.
const PLAN: &str = "\
number;name;kind;axis;callout;callout2;feature;x;y;z
1;BORE_A;;;25 H7;;;40;30;-8
2;PIN;;;20 g6;;;0;0;-8
3;FACE;face;-Z;12 js13;;;300;30;12
4;POCKET;pocket;;40 H7;25 H8;;0;100;-8
5;B5;;;18 K7;;;;;
6;B6;;;10 JS7;;;;;
7;BORE1 25 H7;;;25 H7;;;50;50;-5
8;W8;width;;16 H8;;;200;30;-8
9;S9;;;30 ±0.01;;shaft;;;
10;B10;;;12 F9;;;;;
11;B11;;;12 F9;;;;;
12;B12;;;50 H6;;;;;
";

/// What an own mask of the shop prints, and what it printed.
const MASK: &str = "\"FEATURE %S: %9.4F mm, %S\", QS12, Q153, QS3;\nM_APPEND;\n";
const PRINTED: &str = "FEATURE B5:   17.9990 mm, GOOD\r\nFEATURE B6:   10.0075 mm, GOOD\r\n";

struct Place(tempfile::TempDir);

impl Place {
    fn new() -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        place.write("plan.csv", PLAN);
        place
    }

    fn write(&self, name: &str, text: &str) {
        fitcheck::files::write(&self.0.path().join(name), text.as_bytes()).unwrap();
    }

    fn copy(&self, name: &str, from: &str) {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(from);
        std::fs::copy(from, self.0.path().join(name)).unwrap();
    }

    fn say(&self, args: &[&str]) -> (i32, String, String) {
        let mut command = cargo_bin_cmd!("fitcheck");
        for name in ["XDG_DATA_HOME", "XDG_CONFIG_HOME", "FITCHECK_JOURNAL"] {
            command.env_remove(name);
        }
        let output = command.env("HOME", self.0.path()).current_dir(self.0.path()).args(args).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
    }
}

#[test]
fn twelve_features_from_every_source_are_in_the_records_with_their_origin() {
    let place = Place::new();
    let record = ["--record", "--journal", "j.sqlite", "--serial", "7"];
    let import = |args: &[&str]| place.say(&[&["import", "--plan", "plan.csv"], args, &record].concat());
    // The same plan makes the set for a control, which measures the first four and the width on a simulated part.
    let rows: Vec<&str> = PLAN.lines().collect();
    place.write("control.csv", &[rows[0], rows[1], rows[2], rows[3], rows[4], rows[8], ""].join("\n"));
    let (code, _, err) =
        place.say(&["nc", "control.csv", "--control", "tnc7", "-o", "set", "--workpiece-out", "part.toml"]);
    assert_eq!(code, 0, "{err}");
    let run = ["run", "set/FIT_MAIN.H", "--folder", "set", "--workpiece", "part.toml"];
    let (code, out, err) = place.say(&[&run[..], &record].concat());
    assert_eq!(code, 0, "{out}{err}");
    // Logs of the control find their features by place, and say so.
    place.copy("TCHPR421.TXT", "samples/logs/en/TCHPR421.TXT");
    place.copy("TCHPR422.TXT", "samples/logs/en/TCHPR422.TXT");
    let (code, out, err) = import(&["TCHPR421.TXT", "TCHPR422.TXT", "--format", "csv"]);
    assert_eq!(code, 10, "{err}");
    assert!(out.contains("TCHPR421.TXT,1,BORE_A,25 H7,25,25.000,25.021,25.0134,13.4,GOOD"), "{out}");
    assert!(out.contains("found by its place: BORE_A of the plan"), "{out}");
    assert!(err.contains("not measured: FACE, POCKET X, POCKET Y, B5"), "{err}");
    // What an own mask printed.
    place.write("list.a", MASK);
    place.write("list.txt", PRINTED);
    let (code, out, err) = import(&["list.txt", "--mask", "list.a"]);
    assert_eq!(code, 0, "{out}{err}");
    // QIF, a typed value, and a table.
    place.copy("results.qif", "qif/minimal_bore_25H7.qif");
    let (code, out, err) = import(&["results.qif"]);
    assert_eq!(code, 0, "{out}{err}");
    let typed =
        ["check", "30 ±0.01", "--feature", "shaft", "--measured", "30.005", "--feature-name", "S9", "--part", "P"];
    let (code, out, err) = place.say(&[&typed[..], &record].concat());
    assert_eq!(code, 0, "{out}{err}");
    place.write("hand.csv", "name;measured\nFACE;11.9\npocket.x;40.01\nK1;1\n4;25.02\n");
    let (code, out, err) = import(&["hand.csv", "--format", "csv"]);
    assert_eq!(code, 1, "two of them are of no size of the plan: {err}");
    assert!(out.contains("hand.csv,4,K1,,,,,1.000,,,,,,,\"not judged: no feature of the plan"), "{out}");
    assert!(out.contains("hand.csv,5,4,"), "{out}");
    // The watched folder.
    std::fs::create_dir(place.0.path().join("in")).unwrap();
    place.write("in/a.csv", "number;measured\n10;12.03\n11;12.07\n12;50.01\n");
    let watch = ["watch", "in", "--plan", "plan.csv", "--until-idle", "0.5"];
    let (code, out, err) = place.say(&[&watch[..], &record].concat());
    assert_eq!(code, 11, "{out}{err}");
    let (_, listed, _) = place.say(&["journal", "list", "--journal", "j.sqlite", "--format", "csv"]);
    let mut features: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for row in csv::Reader::from_reader(listed.as_bytes()).into_records().map(Result::unwrap) {
        features.entry(row[6].to_owned()).or_default().push(format!("{} {}", &row[13], &row[14]));
    }
    for (feature, expected) in [
        ("BORE_A", "GOOD imported from TCHPR421.TXT"),
        ("PIN", "REWORK imported from TCHPR422.TXT"),
        ("B5", "GOOD imported from list.txt"),
        ("B6", "GOOD imported from list.txt"),
        ("BORE1 25 H7", "GOOD imported from results.qif"),
        ("S9", "GOOD typed"),
        ("FACE", "GOOD imported from hand.csv"),
        ("POCKET X", "GOOD imported from hand.csv"),
        ("B10", "GOOD imported from a.csv"),
        ("B11", "SCRAP imported from a.csv"),
        ("B12", "GOOD imported from a.csv"),
    ] {
        let found = features.get(feature).unwrap_or_else(|| panic!("{feature}: {features:?}"));
        assert!(found.iter().any(|found| found == expected), "{feature}: {found:?}");
    }
    assert!(listed.contains("simulated"), "{listed}");
}

#[test]
fn a_simulated_value_stays_simulated_and_a_rule_of_the_plan_counts() {
    let place = Place::new();
    place.write("plan.csv", "name;callout;rule;u_um\nA;25 H7;iso14253-2017;1\nB;25 H7;;\n");
    place.write("v.csv", "name;measured;simulated\nA;25.0205;true\nB;25.0205;false\n");
    let (code, out, err) = place.say(&["import", "--plan", "plan.csv", "v.csv", "--format", "json"]);
    assert_eq!(code, 12, "{err}");
    let rows: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((rows[0]["status"].as_str(), rows[1]["status"].as_str()), (Some("RE-MEASURE"), Some("GOOD")), "{out}");
    assert!(rows[0]["warnings"].to_string().contains("simulated"), "{out}");
}

#[test]
fn what_a_file_and_the_plan_say_otherwise_is_told() {
    let place = Place::new();
    place.write("v.csv", "name;callout;measured\nBORE_A;25 H8;25.02\n7;25 H7;25.01\n");
    let (_, out, _) = place.say(&["import", "--plan", "plan.csv", "v.csv", "--format", "json"]);
    let rows: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(rows[0]["callout"], "25 H7");
    assert!(rows[0]["warnings"].to_string().contains("the file has the limits 25 to 25.033"), "{out}");
}

/// A running number of another tool and a place of another operation are no proof.
#[test]
fn a_number_or_place_with_another_nominal_size_finds_nothing() {
    let place = Place::new();
    place.write("plan.csv", "number;name;callout;x;y;z\n1;A;30 H7;40;30;-8\n");
    place.copy("TCHPR421.TXT", "samples/logs/en/TCHPR421.TXT");
    let (code, _, err) = place.say(&["import", "--plan", "plan.csv", "TCHPR421.TXT"]);
    assert_eq!(code, 1);
    assert!(err.contains("it would be A of the plan, but its nominal size is 25"), "{err}");
}

#[test]
fn deviations_and_coordinates_below_zero_are_read_where_the_plan_has_no_diameter() {
    let place = Place::new();
    place.write(
        "plan.csv",
        "number;name;kind;axis;callout;x;y;z\n1;BORE;;;25 H7;40;30;-8\n2;POINT;point;-Z;±0,05;260;30;12\n",
    );
    let text = "name;measured\nPOINT;-0,012\nPOINT;0\nPOINT;-0,051\nBORE;-0,012\nNOBODY;-1\n";
    place.write("m.csv", text);
    let (_, out, err) = place.say(&["import", "--plan", "plan.csv", "m.csv", "--format", "csv"]);
    let rows: Vec<&str> = out.lines().filter(|line| line.starts_with("m.csv,")).collect();
    let has = |line: &str, words: &[&str]| {
        let row = rows.iter().find(|row| row.starts_with(&format!("m.csv,{line},")));
        let row = row.unwrap_or_else(|| panic!("{line}: {out}{err}"));
        assert!(words.iter().all(|word| row.contains(word)), "{row}");
    };
    has("2", &["POINT", "GOOD", "-12"]);
    has("3", &["POINT", "GOOD"]);
    has("4", &["POINT", "-51"]);
    assert!(!out.contains("m.csv,4,POINT,GOOD"), "{out}");
    has("5", &["a diameter of -0,012 is not above 0"]);
    has("6", &["no feature of the plan"]);
    // Without a plan nothing says that it is no diameter.
    let (code, out, err) = place.say(&["import", "m.csv"]);
    assert_eq!(code, 1);
    assert_eq!((out + &err).matches("is not above 0").count(), 5);
}
