//! One plan for everything: its values come from wherever they are, each finds its feature, and all of them are in the records.

use std::collections::BTreeMap;
use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value as Json;

use crate::at_home::AtHome as _;

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
        command.env_remove("FITCHECK_JOURNAL");
        let output = command.at_home(self.0.path()).current_dir(self.0.path()).args(args).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
    }

    /// What a plan makes of a file of values: the exit code and the rows.
    fn judged(&self, plan: &str, values: &str, more: &[&str]) -> (i32, Vec<Json>) {
        self.write("own.csv", plan);
        self.write("v.csv", values);
        self.rows(&[&["import", "--plan", "own.csv", "v.csv"], more].concat())
    }

    fn rows(&self, args: &[&str]) -> (i32, Vec<Json>) {
        let (code, out, err) = self.say(&[args, &["--format", "json"]].concat());
        (code, serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {out}{err}")))
    }
}

/// The status of a row, and whether it is beside what must be said.
#[track_caller]
fn says(row: &Json, status: Option<&str>, what: &str) {
    assert_eq!(row["status"].as_str(), status, "{row}");
    let said = format!("{} {}", row["warnings"], row["error"]);
    assert!(said.contains(what), "{what}: {row}");
}

/// That nothing is said of a row besides its verdict.
#[track_caller]
fn silent(row: &Json) {
    assert_eq!((row["warnings"].as_array().map(Vec::len), row["error"].as_str()), (Some(0), None), "{row}");
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
    assert!(out.contains("matched by location to BORE_A of the plan"), "{out}");
    assert!(err.contains("not measured: FACE, POCKET X, POCKET Y, B5"), "{err}");
    // What an own mask printed: good, and without the other features the part is not complete.
    place.write("list.a", MASK);
    place.write("list.txt", PRINTED);
    let (code, out, err) = import(&["list.txt", "--mask", "list.a"]);
    assert_eq!((code, out.contains("2 rows: 2 GOOD, 11 missing")), (1, true), "{out}{err}");
    // QIF, a typed value, and a table.
    place.copy("results.qif", "qif/minimal_bore_25H7.qif");
    let (code, out, err) = import(&["results.qif"]);
    assert_eq!((code, out.contains("1 row: 1 GOOD, 12 missing")), (1, true), "{out}{err}");
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
    assert_eq!(code, 14, "{err}");
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
    assert!(err.contains("it matches A of the plan, but its nominal size is 25"), "{err}");
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

/// A row of Fitcheck without a callout, its limits from a log, keeps how it was brought to 20 °C: by hand, 25.0215 mm at 26 °C is
/// 25.019774 mm at 20 °C with 11.5 millionths per kelvin.
#[test]
fn a_corrected_value_without_a_callout_is_not_corrected_again_by_a_plan() {
    let place = Place::new();
    let values = "id,callout,measured_mm,deviation_um,status,as_measured_mm,temperature_c,expansion_um_per_m_k\n\
                  A,,25.019774,19.774,GOOD,25.0215,26,11.5\n";
    let plan = "name;callout\nA;25 H7\n";
    let (code, rows) = place.judged(plan, values, &[]);
    assert_eq!((code, rows[0]["measured_mm"].as_f64()), (0, Some(25.019_774)), "{rows:?}");
    let (code, rows) = place.judged(plan, values, &["--temperature", "26", "--material", "steel"]);
    assert_eq!(code, 1);
    says(&rows[0], None, "--temperature: the file says that its values are at 20 °C already");
    // The correction is recorded with the value.
    let record = ["--record", "--journal", "j.sqlite"];
    place.say(&[&["import", "--plan", "own.csv", "v.csv"], &record[..]].concat());
    let (_, shown, _) = place.say(&["journal", "show", "2", "--journal", "j.sqlite", "--format", "json"]);
    assert!(shown.contains("\"measured_nm\":25021500,\"at_20c_nm\":25019774"), "{shown}");
}

#[test]
fn a_name_that_no_feature_has_beside_a_number_that_one_has_is_told() {
    let place = Place::new();
    let plan = "number;name;callout;x;y\n3;PIN;25 H7;40;30\n";
    let of = |values: &str| place.judged(plan, values, &[]).1.remove(0);
    // The size speaks for the number.
    for values in
        ["name;number;callout;measured\nBORE_X;3;25 H7;25.01\n", "name;number;nominal;measured\nBORE_X;3;25;25.01\n"]
    {
        let row = of(values);
        assert_eq!(row["id"], "PIN");
        says(&row, Some("GOOD"), "no feature of the plan is called BORE_X; matched by number to PIN of the plan");
    }
    says(&of("number;measured\n3;25.01\n"), Some("GOOD"), "matched by number to PIN of the plan");
    says(&of("name;measured\n3;25.01\n"), Some("GOOD"), "\"matched by number to PIN of the plan\"");
    says(&of("number;measured\n03;25.01\n"), Some("GOOD"), "matched by number to PIN of the plan");
    let place_of = of("name;x;y;measured\nBORE_X;40;30;25.01\n");
    says(&place_of, Some("GOOD"), "no feature of the plan is called BORE_X; matched by location to PIN of the plan");
    silent(&of("name;number;measured\nPIN;3;25.01\n"));
}

/// The rows of a file are numbered, and so are the balloons: that is no reason to take one for the other.
#[test]
fn a_running_number_beside_a_name_that_the_plan_does_not_know_finds_nothing() {
    let place = Place::new();
    let plan = "number;name;callout\n1;BORE;25 H7\n2;PIN;25 H7\n";
    let (code, rows) = place.judged(plan, "number;name;measured\n1;circle 7;25.01\n2;circle 9;25.01\n", &[]);
    assert_eq!(code, 1);
    for (row, name) in [(&rows[0], "BORE"), (&rows[1], "PIN")] {
        says(row, None, &format!("{name} has the same number, but that may be a running number"));
    }
    // Without a name the number is all that there is.
    let (code, rows) = place.judged(plan, "number;measured\n1;25.01\n2;25.01\n", &[]);
    assert_eq!((code, rows[1]["id"].as_str()), (0, Some("PIN")));
    // Other limits do not speak for it.
    let (_, rows) = place.judged(plan, "number;name;measured;min;max\n1;circle 7;25.01;25.000;25.033\n", &[]);
    assert_eq!(rows[0]["status"], Json::Null, "{rows:?}");
}

#[test]
fn two_axes_are_a_place_where_they_are_that_of_one_feature() {
    let place = Place::new();
    let of = |plan: &str, values: &str| place.judged(plan, values, &[]).1.remove(0);
    // The plan says no height.
    let flat = "name;callout;x;y\nA;25 H7;40;30\nB;25 H7;80;30\n";
    assert_eq!(of(flat, "name;x;y;z;measured\n;40;30;-8;25.01\n")["id"], "A");
    assert_eq!(of(flat, "name;x;y;measured\n;80;30.4;25.01\n")["id"], "B");
    says(&of(flat, "name;x;z;measured\n;80;-8;25.01\n"), None, "a location needs X and Y");
    // One above the other: the value does not say which, and with a height it does.
    let tall = "name;callout;x;y;z\nA;25 H7;40;30;-8\nB;25 H7;40;30;-28\n";
    says(&of(tall, "name;x;y;measured\n;40;30;25.01\n"), None, "several features of the plan have this location: A, B");
    assert_eq!(of(tall, "name;x;y;z;measured\n;40;30;-28;25.01\n")["id"], "B");
}

#[test]
fn a_nominal_size_in_the_file_is_compared_whatever_else_is_missing() {
    let place = Place::new();
    let plan = "number;name;callout\n3;PIN;25 H7\n";
    // A nominal size and no callout.
    let (code, rows) = place.judged(plan, "number;nominal;callout;measured\n3;30;;25.01\n", &[]);
    assert_eq!(code, 1);
    says(&rows[0], None, "it matches PIN of the plan, but its nominal size is 30");
    let (_, rows) = place.judged(plan, "name;nominal;callout;measured\nPIN;30;;25.01\n", &[]);
    says(&rows[0], None, "it matches PIN of the plan, but its nominal size is 30 and the plan's is 25");
    // AQDEF that does not say hole or shaft: K2101 is the nominal size, K2110 and K2111 are the limits.
    let aqdef = |limits: &str| {
        format!("K0100 1\nK2001/1 3\nK2009/1 102\nK2101/1 30\n{limits}K2142/1 mm\nK0001/1 25.01\nK0002/1 0\n")
    };
    place.write("own.csv", plan);
    for limits in ["K2110/1 29.9\nK2111/1 30.1\n", "K2110/1 29.9\n", "K2110/1 30.1\nK2111/1 29.9\n"] {
        place.write("a.dfq", &aqdef(limits).replace("K2009/1 102\n", "K2009/1 200\n"));
        let (_, rows) = place.rows(&["import", "--plan", "own.csv", "a.dfq"]);
        says(&rows[0], None, "");
    }
}

#[test]
fn a_place_with_other_limits_than_the_plan_is_told_as_a_diameter_is() {
    let place = Place::new();
    place.write("own.csv", "name;kind;axis;callout;feature\nW (425);width;X;8 ±0.05;hole\n");
    place.write("list.a", &shipped("width_en.a"));
    place.write(
        "list.txt",
        "WIDTH STATUS: GOOD\nCHECKED: W (425)\nMINIMUM WIDTH:   7.9000\nMAXIMUM WIDTH:   8.1000\n\
         MEASURED WIDTH:   8.0120\nCENTRE LINE:   0.0010\n",
    );
    let (_, rows) = place.rows(&["import", "--plan", "own.csv", "list.txt", "--mask", "list.a"]);
    says(&rows[0], Some("GOOD"), "the file has the limits 7.9 to 8.1: the plan's limits apply");
    // A coordinate: the log of cycle 427 has limits of its own.
    place.write("own.csv", "name;kind;axis;callout;x;y;z\nX (427);face;-X;10 ±0.4;10;0;0\n");
    place.write("list.a", &shipped("427_en.a"));
    place.write(
        "list.txt",
        "COORDINATE STATUS: GOOD\nCHECKED: X (427)\nMINIMUM LIMIT:   9.0000\nMAXIMUM LIMIT:  11.0000\n\
         MEASURED COORDINATE:   9.5000\n",
    );
    let (_, rows) = place.rows(&["import", "--plan", "own.csv", "list.txt", "--mask", "list.a"]);
    says(&rows[0], Some("SCRAP"), "the file has the limits 9 to 11: the plan's limits apply");
    says(&rows[0], Some("SCRAP"), "the file says GOOD, but the limits say SCRAP");
}

/// A mask of Fitcheck.
fn shipped(name: &str) -> String {
    let mask = fitcheck::shipped::file(fitcheck::shipped::MASKS, name).unwrap();
    String::from_utf8(mask.to_vec()).unwrap()
}

#[test]
fn another_part_than_that_of_the_plan_is_told() {
    let place = Place::new();
    place.write(
        "flange.toml",
        "fitcheck_plan = 1\npart = \"Flange 4711\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n",
    );
    for (part, is_told) in [("Flange 4711", false), ("flange 4711", false), ("Cover 12", true)] {
        place.write("v.csv", &format!("part;name;measured\n{part};A;25.01\n"));
        let (_, rows) = place.rows(&["import", "--plan", "flange.toml", "v.csv"]);
        if is_told {
            says(&rows[0], Some("GOOD"), "the file names part Cover 12: it is judged as Flange 4711, the plan's part");
        } else {
            silent(&rows[0]);
        }
    }
}

#[test]
fn an_incomplete_part_is_not_green_and_names_what_is_missing() {
    let place = Place::new();
    let plan = "number;name;callout\n1;A;25 H7\n2;B;20 g6\n";
    let (code, rows) = place.judged(plan, "name;measured\nA;25.01\nB;19.99\n", &[]);
    assert_eq!((code, rows.len()), (0, 2));
    let (code, rows) = place.judged(plan, "name;measured\nA;25.01\n", &[]);
    assert_eq!((code, rows.len()), (1, 2), "{rows:?}");
    assert_eq!(
        [&rows[1]["file"], &rows[1]["line"], &rows[1]["id"], &rows[1]["callout"]],
        [&Json::from("own.csv"), &3.into(), &"B".into(), &"20 g6".into()]
    );
    says(&rows[1], None, "missing: no value found");
    // Scrap stays scrap.
    assert_eq!(place.judged(plan, "name;measured\nA;25.03\n", &[]).0, 11);
    // Each of two parts.
    let (code, rows) = place.judged(plan, "name;serial;measured\nA;7;25.01\nB;7;19.99\nA;8;25.01\n", &[]);
    assert_eq!((code, rows.len()), (1, 4));
    says(&rows[3], None, "missing on 8");
    let (_, out, err) = place.say(&["import", "--plan", "own.csv", "v.csv"]);
    assert!(out.contains("3 rows: 3 GOOD, 1 missing"), "{out}");
    assert!(err.contains("8: not measured: B"), "{err}");
}

#[test]
fn the_columns_of_a_rule_are_there_when_the_plan_has_one() {
    let place = Place::new();
    place.write("own.csv", "name;callout;rule;u_um\nA;25 H7;iso14253-2017;1\nB;25 H7;;\n");
    place.write("v.csv", "name;measured\nA;25.0205\nB;25.0205\n");
    let csv = |args: &[&str]| {
        let (_, out, _) = place.say(&[args, &["--format", "csv"]].concat());
        let mut reader = csv::Reader::from_reader(out.as_bytes());
        let names: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        (names, reader.into_records().map(Result::unwrap).collect::<Vec<_>>())
    };
    let (of_check, _) = csv(&["check", "25 H7", "--measured", "25.0205", "--rule", "iso14253-2017", "--u", "1"]);
    let (names, rows) = csv(&["import", "--plan", "own.csv", "v.csv"]);
    let at = |name: &str| names.iter().position(|found| found == name).unwrap_or_else(|| panic!("{name}: {names:?}"));
    for name in of_check.iter().filter(|name| name.starts_with("rule_") || name.contains("accepted")) {
        at(name);
    }
    assert_eq!([&rows[0][at("rule_name")], &rows[1][at("rule_name")]], ["iso14253-2017", ""]);
}

/// The columns of the journal that say of which part a check is: who, part, serial number, feature.
fn parts_of(place: &Place) -> Vec<[String; 4]> {
    let (_, listed, err) = place.say(&["journal", "list", "--journal", "j.sqlite", "--format", "csv"]);
    let rows = csv::Reader::from_reader(listed.as_bytes()).into_records().map(Result::unwrap).collect::<Vec<_>>();
    assert!(!rows.is_empty(), "{err}");
    let mut parts: Vec<_> = rows.iter().map(|row| [3, 4, 5, 6].map(|at| row[at].to_owned())).collect();
    parts.sort();
    parts
}

#[test]
fn parts_of_a_file_without_serial_numbers_can_be_told_apart_in_the_journal() {
    let place = Place::new();
    place.write("own.toml", "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n[[feature]]\nname = \"B\"\ncallout = \"25 H7\"\n");
    place.write("v.csv", "part;name;measured\nP1;A;25.1\nP2;A;25.01\nflange;B;25.01\n");
    let record = ["--record", "--journal", "j.sqlite"];
    let (code, _, err) = place.say(&[&["import", "--plan", "own.toml", "v.csv"], &record[..]].concat());
    assert_eq!(code, 11, "{err}");
    let part = |part: &str, feature: &str| ["", part, "", feature].map(str::to_owned);
    assert_eq!(parts_of(&place), [part("Flange", "B"), part("P1", "A"), part("P2", "A")]);
    for missing in ["P1: not measured: B", "P2: not measured: B", "flange: not measured: A"] {
        assert!(err.contains(missing), "{missing}: {err}");
    }
    // A serial number tells parts apart, and the plan says what they are.
    place.write("v.csv", "part;serial;name;measured\nP1;7;A;25.01\n");
    std::fs::remove_file(place.0.path().join("j.sqlite")).unwrap();
    place.say(&[&["import", "--plan", "own.toml", "v.csv"], &record[..]].concat());
    assert_eq!(parts_of(&place), [["", "Flange", "7", "A"].map(str::to_owned)]);
}

#[test]
fn what_a_watched_file_says_counts_before_the_options() {
    let place = Place::new();
    place.write("own.csv", "name;callout\nA;25 H7\n");
    std::fs::create_dir(place.0.path().join("in")).unwrap();
    place.write("in/a.csv", "name;part;serial;who;measured\nA;P18;18;Bert;25.01\n");
    place.write("in/b.csv", "name;measured\nA;25.01\n");
    let own = ["--serial", "17", "--who", "Anna", "--part", "P17", "--journal", "j.sqlite"];
    for plan in [&["--plan", "own.csv"][..], &[]] {
        _ = std::fs::remove_file(place.0.path().join("j.sqlite"));
        if plan.is_empty() {
            place.write("in/a.csv", "name;part;serial;who;callout;measured\nA;P18;18;Bert;25 H7;25.011\n");
            place.write("in/b.csv", "name;callout;measured\nA;25 H7;25.012\n");
        }
        let (code, out, err) = place.say(&[&["watch", "in", "--until-idle", "0.5"], plan, &own].concat());
        assert_eq!(code, 0, "{out}{err}");
        // With a plan the serial number tells parts apart, and the part is that of all files.
        let part = if plan.is_empty() { "P18" } else { "P17" };
        let expected = [["Anna", "P17", "17", "A"], ["Bert", part, "18", "A"]];
        assert_eq!(parts_of(&place), expected.map(|row| row.map(str::to_owned)));
    }
}

/// The exit code is that of the part as its page says it, whoever reports it.
#[test]
fn import_and_report_end_with_the_status_of_the_worst_part() {
    let place = Place::new();
    let plan = "name;callout\nA;25 H7\nB;25 H7\n";
    for (values, code, why) in [
        ("A;25.01;;\nB;25.01;;\n", 0, "all is measured and good"),
        ("A;25.01;;true\nB;25.01;;true\n", 14, "nobody measured it"),
        ("A;25.01;;\n", 1, "B is missing"),
        ("A;25.1;;\n", 11, "scrap stays scrap, whatever is missing"),
        ("A;24.99;;\n", 10, "and rework rework"),
        ("A;25.1;;\nA;25.01;;\nB;25.01;;\n", 11, "two values of A, and nothing says which one was later"),
        ("A;25.01;;\nA;25.1;;\nB;25.01;;\n", 11, "the worst value counts"),
        ("A;25.01;7;\nB;25.01;7;\nA;24.99;8;\n", 10, "the worst of two parts"),
        ("A;25.01;7;\nB;25.01;7;\nA;25.01;8;\n", 1, "one of two parts is open"),
        ("A;25.1;;\nC;25.01;;\n", 1, "C is of no feature"),
    ] {
        place.write("own.csv", plan);
        place.write("v.csv", &format!("name;measured;serial;simulated\n{values}"));
        for command in [&["import", "--format", "csv"][..], &["report", "-o", "r.html"]] {
            let (found, out, err) = place.say(&[command, &["--plan", "own.csv", "v.csv"]].concat());
            assert_eq!(found, code, "{command:?}: {why}: {out}{err}");
        }
    }
}

#[test]
fn a_set_for_a_control_names_what_it_does_not_know_of_judging() {
    let place = Place::new();
    place.write("own.csv", "name;callout;x;y;z;rule;u_um;material\nBORE;25 H7;40;30;-8;iso14253-2017;2;steel\nPLAIN;25 H7;80;30;-8;simple;;\nSURE;25 H7;120;30;-8;;2;\n");
    let (code, _, err) = place.say(&["nc", "own.csv", "--control", "tnc7", "-o", "set"]);
    assert_eq!(code, 0, "{err}");
    let readme = std::fs::read_to_string(place.0.path().join("set/README.TXT")).unwrap();
    for (name, said) in [("BORE", "rule iso14253-2017, u_um 2, material steel"), ("SURE", "u_um 2")] {
        assert!(err.contains(&format!("{name}: the plan says {said}, but the set does not use it")), "{err}");
        assert!(readme.contains(&format!("  {name:<20} {said}\r\n")), "{readme}");
    }
    assert!(!err.contains("PLAIN:"), "{err}");
    assert!(readme.contains("Judged here by the limits alone: the plan says more"), "{readme}");
    // A plan that says no more has no such lines.
    let (_, _, err) =
        place.say(&["nc", "25 H7", "--x", "1", "--y", "2", "--z", "-8", "--control", "tnc7", "-o", "plain"]);
    let readme = std::fs::read_to_string(place.0.path().join("plain/README.TXT")).unwrap();
    assert!(
        !err.contains("does not use") && !readme.contains("the plan says more") && !readme.contains('{'),
        "{readme}"
    );
}

#[test]
fn everything_that_a_control_cannot_measure_is_told_at_once() {
    let place = Place::new();
    place.write(
        "own.csv",
        "name;callout;feature;x;y;z\nA B;12 ±0.02;hole;;;\nGOOD;25 H7;;0;0;-8\nPIN;25 ±0.1;shaft;0;0;-8\n",
    );
    let (code, _, err) = place.say(&["nc", "own.csv", "--control", "tnc7", "-o", "set"]);
    assert_eq!(code, 1);
    // A size without a class is measured by its own limits.
    assert_eq!(err.lines().filter(|line| line.contains("own.csv")).count(), 2, "{err}");
    assert!(err.contains("line 2") && !err.contains("line 4"), "{err}");
}

#[test]
fn a_plan_is_read_from_a_workbook() {
    let place = Place::new();
    let rows = [&["number", "name", "callout", "x", "y", "z"][..], &["1", "A", "25 H7", "40", "30,5", "-8"]];
    fitcheck::files::write(&place.0.path().join("own.xlsx"), &crate::xlsx::workbook(&rows)).unwrap();
    place.write("v.csv", "name;measured\nA;25.01\n");
    let (code, rows) = place.rows(&["import", "--plan", "own.xlsx", "v.csv"]);
    assert_eq!((code, rows[0]["status"].as_str()), (0, Some("GOOD")), "{rows:?}");
    let (code, out, err) = place.say(&["plan", "check", "own.xlsx"]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("25 H7"), "{out}");
}

#[test]
fn a_class_is_not_taken_for_a_limit_that_the_file_contradicts_or_leaves_out() {
    let head = "K0100 1\nK2001/1 1\nK2002/1 BORE\nK2009/1 202\nK2101/1 25\nK2103/1 H\nK2104/1 7\nK2142/1 mm\n";
    let remark = "BORE: 25 H7 has other limits than the file";
    let converted = |file: &str| {
        let place = Place::new();
        place.write("p.dfq", file);
        let (_, _, err) = place.say(&["plan", "convert", "p.dfq", "-o", "p.toml"]);
        // A plan with a fault is not written.
        (std::fs::read_to_string(place.0.path().join("p.toml")).unwrap_or_default(), err)
    };
    for limits in ["K2111/1 25.010\n", "K2110/1 25\nK2111/1 25.021\nK2121/1 0\n"] {
        let (plan, err) = converted(&format!("{head}{limits}"));
        assert!(err.contains(remark), "{limits}: {err}");
        assert!(!plan.contains("callout = \"25 H7\""), "{limits}: {plan}");
    }
    let (plan, err) = converted(head);
    assert!(plan.contains("callout = \"25 H7\""), "{plan}{err}");
}
