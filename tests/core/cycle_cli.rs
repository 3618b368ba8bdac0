//! `fitcheck cycle`: the manuals' blocks through the program, every way in and every way out.

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

/// A file in a folder that is removed with the test.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path: PathBuf = folder.path().join(name);
    fitcheck::files::write(&path, text.as_bytes()).unwrap();
    path.display().to_string()
}

#[test]
fn the_block_of_cycle_427_runs_typed_or_as_json() {
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
    let (_, given) = json(&["427", "--inputs", "-"], &Value::from(block).to_string());
    assert_eq!(given, typed);
    // And as a block of an NC program.
    let lines = BLOCK_427.join(" ;COMMENT ~\n    ");
    let (_, given) = json(&["427", "--block", "-"], &format!("11 TCH PROBE 427 MISURAZ. COORDINATA ~\n    {lines}"));
    assert_eq!(given, typed);
}

#[test]
fn the_block_of_g785_and_an_example_of_each_other_cycle_run() {
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
    assert_eq!(said.err, "fitcheck: cycle 427: contact 1: the probe met nothing within the probing path of 50 mm\n");
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
    assert_eq!(said.code, Some(14), "one contact is left");
    assert!(said.out.contains("Q153,measured diameter,25.002,mm,false\n"), "{}", said.out);
    assert!(said.out.ends_with("status,status,GOOD,,false\n"), "{}", said.out);
    assert_eq!(said.err, "warning: standard input: the cycle used 4 of 5 contacts\n");
    let few = fitcheck(&args, "x,y\n12.5,0\n");
    assert_eq!(
        (few.code, few.err.as_str()),
        (Some(1), "fitcheck: cycle 421: contact 2: the file has only 1 contact\n")
    );
}

#[test]
fn recorded_contacts_out_of_the_reach_of_the_probe_are_refused_and_not_judged() {
    let flange = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/examples/flange_fit.csv")).unwrap();
    let at = |x: &str, y: &str| {
        let place = [format!("Q273={x}"), format!("Q274={y}")];
        let args = ["421", "--contacts", "-", "--set", &place[0], &place[1], "Q262=40", "Q247=120", "Q423=3"];
        fitcheck(&[&args[..], &["Q275=40.025", "Q276=40"]].concat(), &flange)
    };
    // The flange lies about 0/0: where it is probed it is judged.
    assert_eq!(at("0", "0").code, Some(14), "judged, and three contacts are left");
    let refused = at("50", "30");
    assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""));
    assert_eq!(
        refused.err,
        "fitcheck: cycle 421: contact 1 lies 57.17 mm from where its probing begins, and the ball travels at most 52 mm \
         (DIST or K, plus SET_UP of the touch-probe table and Q320): check that these contacts are of this feature, in this order, \
         and counted from this zero\n"
    );
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
    let text = fitcheck(&["421", "--list"], "").out;
    assert!(text.contains("90°              ±5 … ±120 °, 120° with Q423 = 3\n"), "{text}");
    for code in ["421", "422", "427", "444", "G785"] {
        let json: Value = serde_json::from_str(&fitcheck(&[code, "--list", "--format", "json"], "").out).unwrap();
        let json = json["parameters"].as_array().unwrap();
        assert!(json.iter().all(|row| row["question"].is_string()), "{json:?}");
        let csv = fitcheck(&[code, "--list", "--format", "csv"], "").out;
        assert!(csv.starts_with("key,name,question,unit,range,default,required,predef,effect\n"), "{csv}");
        assert_eq!(csv.lines().count(), json.len() + 1);
    }
}

/// What the manuals say of a cycle and no simulation shows.
#[test]
fn the_notes_of_a_cycle_are_listed_with_it() {
    let recommended = |cycle: &str| format!("where the control has cycle {cycle}, HEIDENHAIN recommends it instead");
    let ends = || "ends a basic rotation that is active".to_owned();
    let notes = |code: &str| match code {
        "421" => vec![ends(), recommended("1401")],
        "423" | "424" => vec![ends(), recommended("1403")],
        "425" => vec![ends(), recommended("1404")],
        "422" | "426" => vec![ends()],
        "427" => vec![ends(), "the control needs software option #17 / #1-05-1".to_owned(), recommended("1400")],
        "444" => vec![
            "an iTNC 530 does not have this cycle; TNC 320, TNC 620, TNC 640 and TNC7 have it".to_owned(),
            "the machine builder must enable and adapt this cycle: see the machine manual".to_owned(),
            "take the normal from a CAD or CAM system".to_owned(),
        ],
        _ => Vec::new(),
    };
    for code in ["421", "422", "423", "424", "425", "426", "427", "444", "G785"] {
        let json: Value = serde_json::from_str(&fitcheck(&[code, "--list", "--format", "json"], "").out).unwrap();
        assert_eq!((&json["cycle"], &json["notes"]), (&Value::from(code), &Value::from(notes(code))));
        let text = fitcheck(&[code, "--list"], "").out;
        let said: Vec<_> = text.lines().filter_map(|line| line.strip_prefix("note: ")).collect();
        assert_eq!(said, notes(code), "{text}");
    }
    let dutch = fitcheck(&["444", "--list", "--language", "nl"], "").out;
    assert!(dutch.ends_with("note: neem de normaal uit een CAD- of CAM-systeem\n"), "{dutch}");
}

#[test]
fn predef_takes_what_global_def_gave() {
    let block = [&["427", "--set"][..], &BLOCK_427[..3], &["Q320=PREDEF", "Q272=3", "Q267=-1"]].concat();
    let refused = fitcheck(&block, "");
    assert_eq!(refused.err, "fitcheck: cycle 427: Q320 SET-UP CLEARANCE = PREDEF: no GLOBAL DEF gives a value\n");
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
    let codes: Vec<_> = fitcheck::probing::cycles::CYCLES.iter().map(|cycle| cycle.code).collect();
    refused(&["431"], "", 2, &format!("the cycles are {}", codes.join(", ")));
    refused(&["427"], "", 1, "cycle 427: Q263 1ST POINT 1ST AXIS is missing");
    refused(&["427", "--set", "Q999=1"], "", 1, "cycle 427 has no parameter Q999");
    refused(&["427", "--set", "Q263"], "", 1, "Q263: write a parameter as NAME=VALUE");
    refused(&["427", "--set", "Q263=1", "q263=2"], "", 1, "q263 is set twice");
    refused(&["427", "--set", "Q263=x"], "", 1, "Q263 1ST POINT 1ST AXIS: x is not a number");
    refused(&["427", "--inputs", "-"], "[1]", 1, "standard input: ");
    refused(&["427", "--inputs", "-"], "{\"Q263\": true}", 1, "Q263 = true: expected a number or a text");
    refused(&["427", "--inputs", "-"], "{\"Q263\": 1, \"q263\": 2}", 1, "q263 is given twice");
    refused(&["427", "--predef", "Q288=1"], "", 1, "PREDEF is not allowed for parameter Q288");
    refused(&["G785", "--position", "1,2", "--set", "K=2", "RC=60"], "", 1, "expected three numbers X,Y,Z in mm");
    refused(&["421", "--set", "Q273=0", "Q274=0", "Q262=0"], "", 1, "a circle needs a diameter above 0");
    let outside = [&["427", "--set"][..], &BLOCK_427[..5], &["Q267=0"]].concat();
    refused(&outside, "", 1, "Q267 TRAVERSE DIRECTION = 0: expected one of -1, 1");
    let both = [&["427", "--workpiece", "-", "--set"][..], &BLOCK_427].concat();
    refused(&both, "[bore]\ncentre = [0, 0]\ndiameter = -1\n", 1, "standard input: line 3: diameter = -1");
}

#[test]
fn inputs_that_are_no_object_of_values_are_refused() {
    let refused = |input: &str, reason: &str| {
        let said = fitcheck(&["427", "--inputs", "-"], input);
        assert_eq!((said.code, said.out.as_str()), (Some(1), ""), "{input}");
        assert!(said.err.contains(reason), "{input}: {}", said.err);
    };
    refused("[]", "inputs must be a JSON object such as {\"Q263\": 35}: invalid type: sequence, expected an object");
    refused("{\"Q263\": 1", "inputs must be a JSON object such as {\"Q263\": 35}: EOF while parsing");
    refused("{\"Q263\": 1e999}", "number out of range");
    // The same name twice, letter by letter.
    refused("{\"Q263\": 1, \"Q263\": 2}", "Q263 is given twice");
    refused("{\"Q272\": 3.5}", "Q272 MEASURING AXIS = 3.5: expected one of 1, 2, 3");
    refused("{\"Q263\": \"NaN\"}", "Q263 1ST POINT 1ST AXIS: NaN is not a number");
    refused(
        "{\"Q999\": 1}",
        "cycle 427 has no parameter Q999: its parameters are Q263, Q264, Q261, Q320, Q272, Q267, Q260, Q281",
    );
}

#[test]
fn a_machine_file_names_what_is_needed_in_a_user_s_words() {
    let refused = |text: &str, reason: &str| {
        let said = fitcheck(&["421", "--workpiece", "-", "--set", "Q273=0", "Q274=0", "Q262=25"], text);
        assert_eq!((said.code, said.out.as_str()), (Some(1), ""), "{text}");
        assert_eq!(said.err, format!("fitcheck: standard input: {reason}\n"));
    };
    let bore = "[bore]\ncentre = [0, 0]\n";
    refused(&format!("{bore}diameter = \"25\"\n"), "line 3: invalid type: string \"25\", expected a number");
    refused(&format!("{bore}diameter = 25\ndiameter = 26\n"), "line 4: duplicate key diameter");
    refused(
        &format!("seed = -1\n{bore}diameter = 25\n"),
        "line 1: invalid value: integer `-1`, expected a whole number from 0 to 9223372036854775807",
    );
    refused(&format!("{bore}diameter = inf\n"), "line 3: diameter = inf: at least 0.001, at most 100000");
    refused("[bore]\ncentre = [0]\ndiameter = 25\n", "line 2: centre: expected 2 numbers, found 1");
}

#[test]
fn a_normal_of_any_length_but_zero_is_a_direction() {
    let args = ["444", "--set", "Q263=0", "Q264=0", "Q294=0", "Q581=0", "Q582=0", "Q583=1e-320"];
    let (code, answer) = json(&args, "");
    assert_eq!((code, result(&answer, "Q164")), (Some(0), &Value::from(0.0)));
}

/// A log of cycle 427 in this folder, with these further arguments.
fn logged(folder: &tempfile::TempDir, more: &[&str]) -> Said {
    let path = folder.path().display().to_string();
    let log = ["--log-folder", &path, "--time", "2026-03-14T06:55:04", "--program", "TNC:\\PART1.H"];
    fitcheck(&[&["427"], &log[..], more, &["--set"], &BLOCK_427].concat(), "")
}

#[test]
fn a_log_is_written_beside_others_and_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("TCHPR427.TXT");
    let said = logged(&folder, &[]);
    assert_eq!((said.code, said.err), (Some(0), format!("wrote {}\n", path.display())));
    let one = fitcheck::files::read(&path).unwrap();
    let text = String::from_utf8(one.clone()).unwrap();
    assert!(text.starts_with("Measuring log for touch probe cycle 427 Coordinate measuring\r\n"), "{text}");
    assert!(text.contains("Date: 14-03-2026\r\nTime: 6:55:04\r\nMeasuring program: TNC:\\PART1.H\r\n"), "{text}");
    assert!(text.contains("Measured coordinate:                                5.0000\r\n"), "{text}");
    // The second one follows the first, in another language.
    assert_eq!(logged(&folder, &["--language", "de"]).code, Some(0));
    let two = fitcheck::files::read(&path).unwrap();
    assert!(two.starts_with(&one) && one.len() < two.len());
    let import = Command::new(env!("CARGO_BIN_EXE_fitcheck")).arg("import").arg(&path).output().unwrap();
    let import = String::from_utf8(import.stdout).unwrap();
    assert!(import.contains("\n2 rows: 2 GOOD\n"), "{import}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    // Nothing is added to a file that is cut off, and nothing in it is lost.
    fitcheck::files::write(&path, &one[..100]).unwrap();
    let said = logged(&folder, &[]);
    let refused = "fitcheck: log: the file ends within a line: it may be cut off, so nothing is added to it: ";
    assert_eq!((said.code, said.err), (Some(1), format!("{refused}{}\n", path.display())));
    assert_eq!(fitcheck::files::read(&path).unwrap(), one[..100]);
}

/// As `run --output-folder` does.
#[test]
fn the_folder_of_the_log_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let new = folder.path().join("logs");
    let said = fitcheck(
        &[
            "444",
            "--log-folder",
            &new.display().to_string(),
            "--set",
            "Q263=1",
            "Q264=2",
            "Q294=3",
            "Q581=0",
            "Q582=0",
            "Q583=1",
        ],
        "",
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert!(new.join("TCHPR444.html").is_file());
}

#[test]
fn the_log_of_cycle_444_is_a_page() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().display().to_string();
    let args = ["444", "--log-folder", &path, "--language", "nl", "--time", "2026-03-14T06:55", "--set", "Q263=1"];
    let args = [&args[..], &["Q264=2", "Q294=3", "Q581=0", "Q582=1", "Q583=1", "QS400=0.4-0.1"]].concat();
    for count in 1..=2 {
        assert_eq!(fitcheck(&args, "").code, Some(0));
        let page = fitcheck::files::read(&folder.path().join("TCHPR444.html")).unwrap();
        let logs = fitcheck::control::point_log::read(&page);
        assert!(logs.len() == count && logs.iter().all(Result::is_ok), "{logs:?}");
        assert!(String::from_utf8(page).unwrap().contains("GOED"));
    }
}

#[test]
fn q281_says_whether_there_is_a_log_and_where() {
    let set = |value: &'static str| {
        let block = BLOCK_427.map(|setting| if setting.starts_with("Q281") { value } else { setting });
        [&["427", "--time", "2026-03-14T06:55", "--set"][..], &block].concat()
    };
    let shown = fitcheck(&set("Q281=2"), "");
    let log = "\nMeasuring log for touch probe cycle 427 Coordinate measuring\n\n# Simulated by Fitcheck - not measured\nDate: 14-03-2026\nTime: 6:55:00\n";
    assert!(shown.out.contains(log) && shown.out.ends_with("\nMeasuring log end\n"), "{}", shown.out);
    let (_, answer) = json(&set("Q281=2"), "");
    assert!(answer["log_text"].as_str().unwrap().ends_with("Measuring log end\n"));
    assert_eq!(answer["log"], "screen");
    let (_, answer) = json(&set("Q281=1"), "");
    assert_eq!((&answer["log"], &answer["log_text"]), (&Value::from("TCHPR427.TXT"), &Value::Null));
    assert!(fitcheck(&set("Q281=1"), "").out.contains("\nthe control writes TCHPR427.TXT\n"));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().display().to_string();
    for (value, why) in [("Q281=0", "Q281 = 0"), ("Q281=2", "Q281 = 2 shows it on screen")] {
        let said = fitcheck(&[&set(value)[..], &["--log-folder", &path]].concat(), "");
        assert_eq!((said.code, said.err), (Some(0), format!("warning: no log is written: {why}\n")));
    }
    let lathe = fitcheck(&["G785", "--log-folder", &path, "--set", "K=2", "RC=120"], "");
    assert_eq!(lathe.err, "warning: no log is written: the cycle has none\n");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_log_that_says_something_else_than_the_cycle_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    let face = file(&folder, "face.toml", "[face]\npoint = [0, 0, 5.100001]\nnormal = [0, 0, 1]\n");
    let said = logged(&folder, &["--workpiece", &face]);
    let note = "note: the log's values, rounded to 0.0001 mm, give GOOD where the cycle gave REWORK\n";
    assert_eq!(said.code, Some(10));
    assert!(said.out.contains(note), "{}", said.out);
}

#[test]
fn a_block_is_printed_and_read_again() {
    let inputs = [&["427", "--as-block", "--language", "it", "--set"][..], &BLOCK_427].concat();
    let block = fitcheck(&inputs, "").out;
    assert!(
        block.starts_with("TCH PROBE 427 MISURAZ. COORDINATA ~\r\n    Q263=+35   ;1. PUNTO 1. ASSE ~\r\n"),
        "{block}"
    );
    assert_eq!(fitcheck(&["427", "--block", "-", "--as-block", "--language", "it"], &block).out, block);
    // What the control would refuse is not printed.
    let said = fitcheck(&["427", "--as-block", "--set", "Q263=1"], "");
    assert_eq!((said.code, said.out.as_str()), (Some(1), ""));
    assert_eq!(said.err, "fitcheck: cycle 427: Q264 1ST POINT 2ND AXIS is missing\n");
    let other = fitcheck(&["421", "--block", "-"], &block);
    assert_eq!(other.err, "fitcheck: standard input: line 1: this is cycle 427, not 421\n");
    let program = format!("L Z+50\n{block}L Z+100\n");
    let said = fitcheck(&["427", "--block", "-", "--set", "Q263=99"], &program);
    assert_eq!(said.code, Some(0));
    assert!(said.out.contains("99 mm"), "{}", said.out);
    let warning =
        "warning: standard input: line 1: L Z+50 is not part of the probing cycle and was skipped, and 1 more\n";
    assert_eq!(said.err, warning);
}

#[test]
fn a_block_of_several_is_chosen_by_its_line() {
    let block = fitcheck(&[&["427", "--as-block", "--set"][..], &BLOCK_427].concat(), "").out;
    let lines = block.lines().count();
    let program = format!("{block}L Z+50\n{block}");
    let second = lines + 2;
    let several = fitcheck(&["427", "--block", "-"], &program);
    assert_eq!(several.code, Some(1));
    let expected = format!(
        "fitcheck: standard input: several measuring cycles, on the lines 1 (427), {second} (427): choose one by --at LINE\n"
    );
    assert_eq!(several.err, expected);
    for line in [1, 2, lines, second, second + 3] {
        let said = fitcheck(&["427", "--block", "-", "--at", &line.to_string()], &program);
        assert_eq!(said.code, Some(0), "{line}: {}", said.err);
    }
    let between = fitcheck(&["427", "--block", "-", "--at", &(lines + 1).to_string()], &program);
    let expected = format!(
        "fitcheck: standard input: line {}: no measuring cycle has this line: they begin on the lines 1 (427), {second} (427)\n",
        lines + 1
    );
    assert_eq!(between.err, expected);
    // What is wrong with another block is not asked.
    let program = program.replacen("Q264", "Q999", 1);
    assert_eq!(fitcheck(&["427", "--block", "-", "--at", &second.to_string()], &program).code, Some(0));
}

#[test]
fn a_tool_without_a_name_says_what_to_write() {
    let block = fitcheck(&[&["427", "--as-block", "--set"][..], &BLOCK_427].concat(), "").out;
    let named = block.lines().find(|line| line.contains("Q330=")).unwrap();
    let block = block.replace(named, "    QS330=\"\" ~");
    let said = fitcheck(&["427", "--block", "-"], &block);
    assert!(said.err.ends_with("no tool is named: for none, write Q330=0\n"), "{}", said.err);
}

#[test]
fn help_tells_the_keys_of_all_files() {
    let help = fitcheck(&["--help"], "").out;
    for word in
        ["surface_scatter", "calibration_error", "--probe-table", "Q263=35", "10 rework", "--as-block", "TCHPR444.html"]
    {
        assert!(help.contains(word), "{word}: {help}");
    }
}

#[test]
fn widths_and_rectangles_through_the_program() {
    let folder = tempfile::tempdir().unwrap();
    let slot = file(&folder, "slot.toml", "[slot]\ncentre = [50, 0]\nwidth = 20.2\n");
    let settings = ["Q328=50", "Q329=0", "Q272=1", "Q261=-5", "Q311=20", "Q288=20.1", "Q289=20"];
    let (code, answer) = json(&[&["425", "--workpiece", &slot, "--set"][..], &settings].concat(), "");
    assert_eq!(
        (code, result(&answer, "Q156"), result(&answer, "Q157")),
        (Some(11), &Value::from(20.2), &Value::from(50.0))
    );
    // The block that it writes is read back as the same inputs.
    let block = fitcheck(&[&["425", "--as-block", "--set"][..], &settings].concat(), "").out;
    assert!(
        block.starts_with("TCH PROBE 425 MEASURE INSIDE WIDTH ~\r\n    Q328=+50   ;STARTNG PNT 1ST AXIS ~\r\n"),
        "{block}"
    );
    let (code, again) = json(&["425", "--workpiece", &slot, "--block", "-"], &block);
    assert_eq!((code, &again["results"], &again["contacts"]), (Some(11), &answer["results"], &answer["contacts"]));
    let logs = folder.path().display().to_string();
    let said = fitcheck(
        &[&["425", "--workpiece", &slot, "--log-folder", &logs, "--set", "Q281=1"][..], &settings].concat(),
        "",
    );
    assert_eq!(said.code, Some(11), "{}", said.err);
    assert!(std::fs::read_to_string(folder.path().join("TCHPR425.TXT")).unwrap().contains("cycle 425"));
    // Perfect workpieces at nominal size.
    let rectangle = ["Q273=50", "Q274=20", "Q282=60", "Q283=40", "Q261=-5"];
    for code in ["423", "424"] {
        let (exit, answer) = json(&[&[code, "--set"][..], &rectangle].concat(), "");
        let sides = (result(&answer, "Q154"), result(&answer, "Q155"));
        assert_eq!((exit, sides), (Some(0), (&Value::from(60.0), &Value::from(40.0))), "{code}");
    }
    let ridge = ["Q263=60", "Q264=0", "Q265=40", "Q266=0", "Q272=1", "Q261=-5", "Q311=20"];
    let (exit, answer) = json(&[&["426", "--set"][..], &ridge].concat(), "");
    assert_eq!((exit, result(&answer, "Q156")), (Some(0), &Value::from(20.0)));
}
