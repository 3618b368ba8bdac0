//! `fitcheck cycle`: the seeds' blocks through the program, every way in and every way out.

use std::path::PathBuf;

use assert_cmd::Command;
use serde_json::Value;

const BLOCK_427: [&str; 14] = [
    "Q263=+35",
    "Q264=+45",
    "Q261=+5",
    "Q320=+0",
    "Q272=+3",
    "Q267=-1",
    "Q260=+20",
    "Q281=+1",
    "Q288=+5.1",
    "Q289=+4.95",
    "Q309=+0",
    "Q330=+0",
    "Q498=+0",
    "Q531=+0",
];

struct Said {
    code: Option<i32>,
    out: String,
    err: String,
}

fn fitcheck(args: &[&str], input: &str) -> Said {
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    let output = command.arg("cycle").args(args).write_stdin(input).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Said { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

fn json(args: &[&str], input: &str) -> (Option<i32>, Value) {
    let said = fitcheck(&[args, &["--format", "json"]].concat(), input);
    (said.code, serde_json::from_str(&said.out).unwrap_or_else(|error| panic!("{error}: {}{}", said.out, said.err)))
}

/// A result by its key.
fn result<'a>(answer: &'a Value, key: &str) -> &'a Value {
    let results = answer["results"].as_array().unwrap();
    &results.iter().find(|found| found["key"] == key).unwrap()["value"]
}

/// A file in a folder that goes with the test.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path: PathBuf = folder.path().join(name);
    fitcheck::files::write(&path, text.as_bytes()).unwrap();
    path.display().to_string()
}

#[test]
fn the_block_of_seed_004_runs_typed_or_as_json() {
    let (code, typed) = json(&[&["427", "--set"][..], &BLOCK_427].concat(), "");
    assert_eq!(code, Some(0));
    assert_eq!((result(&typed, "Q160"), result(&typed, "Q180")), (&Value::from(5.0), &Value::from(1)));
    assert_eq!((&typed["status"], &typed["log"]), (&Value::from("GOOD"), &Value::from("TCHPR427.TXT")));
    assert_eq!(typed["source"]["kind"], "perfect");
    let block: serde_json::Map<String, Value> = BLOCK_427
        .iter()
        .map(|setting| setting.split_once('=').unwrap())
        .map(|(name, number)| (name.to_owned(), number.parse::<f64>().unwrap().into()))
        .collect();
    // 3.0 is no choice, 3 is.
    let block = Value::from(block).to_string().replace(".0,", ",").replace(".0}", "}");
    let (_, given) = json(&["427", "--inputs", "-"], &block);
    assert_eq!(given, typed);
}

#[test]
fn the_block_of_seed_003_and_an_example_of_each_other_cycle_run() {
    let block = ["G785", "--set", "R=0", "BR=0", "K=2", "C=0", "RC=60", "I=0", "J=0", "Q=0", "P=0", "H=0"];
    let (code, lathe) = json(&block, "");
    assert_eq!((code, result(&lathe, "#i99")), (Some(0), &Value::from(2.0)));
    assert!(lathe["warnings"].to_string().contains("3.0 times that of 3 contacts at 120°"), "{lathe}");
    assert_eq!(lathe["status"], Value::Null);
    let (code, hole) = json(&["g421", "--set", "Q273=50", "Q274=50", "Q262=75", "Q275=75.12", "Q276=74.95"], "");
    assert_eq!((code, result(&hole, "Q153")), (Some(0), &Value::from(75.0)));
    assert_eq!(hole["contacts"].as_array().unwrap().len(), 4);
    let (code, stud) = json(&["422", "--set", "Q273=50", "Q274=50", "Q262=75", "Q277=74.9", "Q278=74.8"], "");
    assert_eq!((code, &stud["status"]), (Some(10), &Value::from("REWORK")));
    let point = ["444", "--set", "Q263=1", "Q264=2", "Q294=3", "Q581=0", "Q582=1", "Q583=1", "QS400=0.4-0.1"];
    let (code, point) = json(&point, "");
    assert_eq!((code, result(&point, "Q183")), (Some(0), &Value::from(0)));
    assert_eq!((result(&point, "Q153"), &point["inputs"]["QS400"]), (&Value::from(3.0), &Value::from("0.4-0.1")));
}

#[test]
fn the_exit_code_is_the_status_and_a_stop_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let face = |height: &str| {
        file(
            &folder,
            "face.toml",
            &format!("[face]\npoint = [0, 0, {height}]\nnormal = [0, 0, 1]\n[probe]\nball_radius = 3\n"),
        )
    };
    for (height, code, word) in [("5", 0, "GOOD"), ("5.2", 10, "REWORK"), ("4.9", 11, "SCRAP")] {
        let path = face(height);
        let args = [&["427", "--workpiece", &path, "--set"][..], &BLOCK_427[..10], &["Q309=1"]].concat();
        let said = fitcheck(&args, "");
        assert_eq!(said.code, Some(code), "{}{}", said.out, said.err);
        assert!(said.out.lines().any(|line| line == word), "{}", said.out);
        assert_eq!(said.out.contains("program stop by Q309 = 1"), code != 0, "{}", said.out);
    }
    // Millimetres below the perfect face, and out of reach.
    let path = face("-50");
    let args = [&["427", "--workpiece", &path, "--path", "--set"][..], &BLOCK_427].concat();
    let said = fitcheck(&args, "");
    assert_eq!(said.code, Some(1));
    assert_eq!(said.err, "fitcheck: cycle 427: touch 1: no contact within the probing path of 50 mm\n");
    assert!(said.out.contains("approach"), "{}", said.out);
}

#[test]
fn the_path_is_shown_in_every_format() {
    let args = [&["427", "--path", "--set"][..], &BLOCK_427].concat();
    let text = fitcheck(&args, "").out;
    assert!(text.contains("    1  pre-position touch 1  to      35.000000      45.000000       7.000000\n"), "{text}");
    let csv = fitcheck(&[&args[..], &["--format", "csv"]].concat(), "").out;
    assert!(
        csv.starts_with("step,phase,touch,from_x,from_y,from_z,to_x,to_y,to_z\n1,pre-position,1,35,45,20,35,45,7\n"),
        "{csv}"
    );
    let (_, answer) = json(&args, "");
    let phases: Vec<_> =
        answer["path"].as_array().unwrap().iter().map(|step| step["phase"].as_str().unwrap()).collect();
    assert_eq!(phases, ["pre-position", "approach", "contact", "retract", "leave"]);
}

#[test]
fn recorded_contacts_are_measured_in_their_order() {
    let csv = "x,y,z\n12.5,0,0\n0,12.502,0\n-12.5,0,0\n0,-12.502,0\n1,1,1\n";
    let args = ["421", "--contacts", "-", "--set", "Q273=0", "Q274=0", "Q262=25", "Q275=25.021", "Q276=25"];
    let said = fitcheck(&[&args[..], &["--format", "csv"]].concat(), csv);
    assert_eq!(said.code, Some(0));
    assert!(said.out.contains("Q153,measured diameter,25.002,mm\n"), "{}", said.out);
    assert!(said.out.ends_with("status,status,GOOD,\n"), "{}", said.out);
    assert_eq!(said.err, "warning: standard input: the cycle took 4 of 5 contacts\n");
    let few = fitcheck(&args, "x,y\n12.5,0\n");
    assert_eq!((few.code, few.err.as_str()), (Some(1), "fitcheck: cycle 421: touch 2: the file has only 1 contacts\n"));
}

#[test]
fn the_probe_table_is_read_and_used() {
    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/samples/tables/tchprobe.tp");
    let args = [&["427", "--probe-table", table, "--probe", "2", "--set"][..], &BLOCK_427].concat();
    let (_, answer) = json(&args, "");
    assert_eq!((&answer["probe"]["set_up_mm"], &answer["probe"]["dist_mm"]), (&Value::from(1.5), &Value::from(6.0)));
    // SET_UP of 1.5 above the point.
    assert_eq!(answer["path"][1]["from"][2], 6.5);
    let missing = fitcheck(&["427", "--probe-table", table, "--probe", "9"], "");
    assert_eq!((missing.code, missing.err.as_str()), (Some(1), "fitcheck: the touch-probe table has no probe 9\n"));
}

#[test]
fn the_same_seed_gives_the_same_result() {
    let folder = tempfile::tempdir().unwrap();
    let bore = "[bore]\ncentre = [0, 0]\ndiameter = 25.01\nsurface_scatter = 0.001\n";
    let path = file(&folder, "bore.toml", bore);
    let diameter = |seed: &str| {
        let args = ["421", "--workpiece", &path, "--seed", seed, "--set", "Q273=0", "Q274=0", "Q262=25"];
        result(&json(&args, "").1, "Q153").clone()
    };
    assert_eq!(diameter("3"), diameter("3"));
    assert_ne!(diameter("3"), diameter("4"));
}

#[test]
fn the_declaration_is_listed() {
    let text = fitcheck(&["427", "--list", "--language", "it"], "").out;
    assert!(text.starts_with("427 MISURAZ. COORDINATA\n"), "{text}");
    assert!(
        text.contains("  Q288   Limite max dimensione?            0                -99999.9999 … 99999.9999 mm\n"),
        "{text}"
    );
    assert!(
        text.contains("Distanza di sicurezza?            0                0 … 99999.9999 mm, or PREDEF\n"),
        "{text}"
    );
    for code in ["421", "422", "427", "444", "G785"] {
        let json: Value = serde_json::from_str(&fitcheck(&[code, "--list", "--format", "json"], "").out).unwrap();
        assert!(json.as_array().unwrap().iter().all(|row| row["question"].is_string()), "{json}");
        let csv = fitcheck(&[code, "--list", "--format", "csv"], "").out;
        assert!(csv.starts_with("key,name,question,unit,range,default,required,predef,effect\n"), "{csv}");
        assert_eq!(csv.lines().count(), json.as_array().unwrap().len() + 1);
    }
}

#[test]
fn predef_takes_what_global_def_gave() {
    let block = [&["427", "--set"][..], &BLOCK_427[..3], &["Q320=PREDEF", "Q272=3", "Q267=-1"]].concat();
    let refused = fitcheck(&block, "");
    assert_eq!(refused.err, "fitcheck: cycle 427: Q320 SET-UP CLEARANCE = PREDEF: no GLOBAL DEF has given a value\n");
    let (_, answer) = json(&[&block[..], &["--predef", "Q320=4"]].concat(), "");
    assert_eq!(answer["inputs"]["Q320"], 4.0);
    assert_eq!(answer["path"][1]["from"][2], 11.0);
}

#[test]
fn what_cannot_be_used_is_refused_with_its_reason() {
    let refused = |args: &[&str], input: &str, code: i32, reason: &str| {
        let said = fitcheck(args, input);
        assert_eq!(said.code, Some(code), "{args:?}: {}", said.err);
        assert!(said.err.contains(reason), "{args:?}: {}", said.err);
        assert!(said.out.is_empty(), "{args:?}: {}", said.out);
    };
    refused(&["431"], "", 2, "the cycles are 421, 422, 427, 444, G785");
    refused(&["427"], "", 1, "cycle 427: Q263 1ST POINT 1ST AXIS is missing");
    refused(&["427", "--set", "Q999=1"], "", 1, "cycle 427 has no parameter Q999");
    refused(&["427", "--set", "Q263"], "", 1, "Q263: a parameter is given as NAME=VALUE");
    refused(&["427", "--set", "Q263=1", "q263=2"], "", 1, "q263 is set twice");
    refused(&["427", "--set", "Q263=x"], "", 1, "Q263 1ST POINT 1ST AXIS: x is not a number");
    refused(&["427", "--inputs", "-"], "[1]", 1, "standard input: ");
    refused(&["427", "--inputs", "-"], "{\"Q263\": true}", 1, "Q263 = true: a number or a text is needed");
    refused(&["427", "--inputs", "-"], "{\"Q263\": 1, \"q263\": 2}", 1, "q263 is given twice");
    refused(&["427", "--predef", "Q288=1"], "", 1, "Q288 is no parameter that may be PREDEF");
    refused(&["G785", "--position", "1,2", "--set", "K=2", "RC=60"], "", 1, "three numbers X,Y,Z in mm are needed");
    refused(&["421", "--set", "Q273=0", "Q274=0", "Q262=0"], "", 1, "a circle needs a diameter above 0");
    let outside = [&["427", "--set"][..], &BLOCK_427[..5], &["Q267=0"]].concat();
    refused(&outside, "", 1, "Q267 TRAVERSE DIRECTION = 0: not one of -1, 1");
    let both = [&["427", "--workpiece", "-", "--set"][..], &BLOCK_427].concat();
    refused(&both, "[bore]\ncentre = [0, 0]\ndiameter = -1\n", 1, "standard input: line 3: diameter = -1");
}

#[test]
fn help_tells_the_keys_of_all_files() {
    let help = fitcheck(&["--help"], "").out;
    for word in ["surface_scatter", "calibration_error", "--probe-table", "Q263=35", "10 rework"] {
        assert!(help.contains(word), "{word}: {help}");
    }
}
