//! `fitcheck run`: the sample programs through the program, every way in and every way out.

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use serde_json::Value;

struct Said {
    code: Option<i32>,
    out: String,
    err: String,
}

fn fitcheck(args: &[&str]) -> Said {
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    let output = command.arg("run").args(args).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Said { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

fn samples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples")
}

/// The sample programs with their tables and mask, and bores of three sizes, in a folder that is removed with the test.
struct Shop {
    folder: tempfile::TempDir,
}

impl Shop {
    fn new() -> Self {
        let shop = Self { folder: tempfile::tempdir().unwrap() };
        for (from, to) in [
            ("programs/fit_main.h", "fit_main.h"),
            ("programs/fit_check.h", "fit_check.h"),
            ("programs/syntax_zoo.h", "syntax_zoo.h"),
            ("tables/generation1_plain.tab", "fit_hole.tab"),
            ("tables/generation2_struct.tab", "FIT_SHAFT.TAB"),
            ("masks/status_en.a", "status_en.a"),
        ] {
            std::fs::copy(samples().join(from), shop.folder.path().join(to)).unwrap();
        }
        for (name, diameter) in [("good", "25.0134"), ("rework", "24.99"), ("scrap", "25.03")] {
            let bore = format!("[bore]\ncentre = [40.0, 30.0]\ndiameter = {diameter}\n");
            shop.file(&format!("{name}.toml"), &bore);
        }
        shop
    }

    fn file(&self, name: &str, text: &str) -> String {
        fitcheck::files::write(&self.folder.path().join(name), text.as_bytes()).unwrap();
        self.path(name)
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    /// A program with these blocks.
    fn program(&self, blocks: &str) -> String {
        self.file("own.h", &format!("BEGIN PGM own MM\n{blocks}\nEND PGM own MM\n"))
    }
}

fn json(args: &[&str]) -> (Option<i32>, Value) {
    let said = fitcheck(&[args, &["--format", "json"]].concat());
    (said.code, serde_json::from_str(&said.out).unwrap_or_else(|error| panic!("{error}: {}{}", said.out, said.err)))
}

#[test]
fn the_window_is_printed_and_the_exit_code_follows_the_verdict() {
    let shop = Shop::new();
    let run = |bore: &str| fitcheck(&[&shop.path("fit_main.h"), "--workpiece", &shop.path(bore)]);
    let good = run("good.toml");
    assert_eq!(good.out, std::fs::read_to_string(samples().join("masks/status_en.expected.txt")).unwrap());
    assert_eq!((good.code, good.err.as_str()), (Some(0), "note: simulated: nothing was measured\n"));
    let rework = run("rework.toml");
    assert!(rework.out.starts_with("FIT STATUS: REWORK\n"), "{}", rework.out);
    assert_eq!((rework.code, run("scrap.toml").code), (Some(10), Some(11)));
}

#[test]
fn a_given_value_stands_in_place_of_the_programs() {
    let shop = Shop::new();
    let program = shop.path("fit_main.h");
    let said = fitcheck(&[&program, "--set", "Q1=18", "QS1=g6", "Q11=0", "Q21=0", "--set", "Q41=45,5"]);
    assert_eq!(said.code, Some(10), "{}", said.err);
    assert_eq!(
        said.out,
        "FIT STATUS: REWORK\nCHECKED FIT: 18 g6\nMINIMUM SIZE:  17.9830\nMAXIMUM SIZE:  17.9940\nMEASURED DIAMETER:  18.0000\n"
    );
}

#[test]
fn a_trace_lists_every_block_with_the_values_it_changed() {
    let shop = Shop::new();
    let program = shop.program("Q1 = 5\nQ2 = Q1 * 2\nFN 0: Q1 SET UNDEFINED\nDECLARE STRING QS1 = \"H7\"");
    let said = fitcheck(&[&program, "--trace"]);
    assert_eq!(
        said.out,
        "own.h:1  BEGIN PGM own MM\nown.h:2  Q1 = 5\n    Q1 = 5\nown.h:3  Q2 = Q1 * 2\n    Q2 = 10\n\
         own.h:4  FN 0: Q1 SET UNDEFINED\n    Q1 undefined\nown.h:5  DECLARE STRING QS1 = \"H7\"\n    QS1 = \"H7\"\n\
         own.h:6  END PGM own MM\n"
    );
    let (code, answer) = json(&[&program, "--trace"]);
    assert_eq!((code, answer["trace"].as_array().unwrap().len()), (Some(0), 6));
    assert_eq!(answer["trace"][2]["changed"], serde_json::json!({"Q2": 10.0}));
}

#[test]
fn json_has_everything() {
    let shop = Shop::new();
    let (code, answer) = json(&[&shop.path("fit_main.h"), "--workpiece", &shop.path("rework.toml")]);
    assert_eq!((code, &answer["status"]), (Some(10), &Value::from("REWORK")));
    assert_eq!(answer["parameters"]["QS2"], "25 H7");
    assert_eq!(answer["windows"][0]["mask"], r"TNC:\fitcheck\status_en.a");
    assert_eq!(answer["cycles"][0]["results"]["Q153"], 24.99);
    assert_eq!(answer["pauses"], serde_json::json!(["the program has stopped: STOP or M0"]));
    assert_eq!(answer["faults"], serde_json::json!([]));
    // A fault does not remove what was found before it.
    let program = shop.program("Q1 = 5\nQ2 = Q9");
    let (code, answer) = json(&[&program]);
    assert_eq!((code, &answer["parameters"]["Q1"]), (Some(1), &Value::from(5.0)));
    assert_eq!(
        answer["faults"],
        serde_json::json!([{
            "program": r"TNC:\own.h", "line": 3, "number": null, "text": "Q2 = Q9", "message": "Q9 is undefined",
        }])
    );
}

#[test]
fn contacts_come_from_a_file_too() {
    let shop = Shop::new();
    let contacts = shop.file("c.csv", "x,y,z\n52.51,30,-8\n40,42.51,-8\n27.49,30,-8\n40,17.49,-8\n");
    let (code, answer) = json(&[&shop.path("fit_main.h"), "--contacts", &contacts]);
    assert_eq!((code, &answer["parameters"]["Q153"]), (Some(0), &Value::from(25.02)));
}

#[track_caller]
fn check_stopped(args: &[&str], expected: &str) {
    let said = fitcheck(args);
    assert_eq!((said.code, said.err.as_str()), (Some(1), format!("fitcheck: {expected}\n").as_str()));
}

#[test]
fn what_could_do_harm_is_stopped_with_its_own_message() {
    let shop = Shop::new();
    let run = |blocks: &str, expected: &str| check_stopped(&[&shop.program(blocks)], expected);
    let endless = shop.program("LBL 1\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    check_stopped(
        &[&endless, "--max-blocks", "1000"],
        r"TNC:\own.h, line 3, FN 9: IF +0 EQU +0 GOTO LBL 1: limit of 1000 blocks reached: possible endless loop",
    );
    run(
        "CALL PGM own.h",
        r"TNC:\own.h, line 2, CALL PGM own.h: nesting limit of 10 program calls reached: does the program call itself?",
    );
    run(
        "LBL 1\nCALL LBL 1",
        r"TNC:\own.h, line 3, CALL LBL 1: nesting limit of 20 label calls reached: does the program call itself?",
    );
    run(r"CALL PGM ..\secret.h", r"TNC:\own.h, line 2, CALL PGM ..\secret.h: ..\secret.h leads out of the folder");
    run(
        r"FN 16: F-PRINT status_en.a / C:\..\out.txt",
        r"TNC:\own.h, line 2, FN 16: F-PRINT status_en.a / C:\..\out.txt: C:\..\out.txt is neither a path on TNC: nor a path from the program's folder",
    );
    run(
        "QS1 = \"0123456789\"\nLBL 1\nQS1 = QS1 || QS1\nFN 9: IF +0 EQU +0 GOTO LBL 1",
        r"TNC:\own.h, line 4, QS1 = QS1 || QS1: the text has 320 characters, a parameter holds at most 255",
    );
    shop.file("broken.h", "\u{1}\u{2}\u{3}\u{4}");
    run(
        "CALL PGM broken.h",
        r"TNC:\own.h, line 2, CALL PGM broken.h: TNC:\broken.h: the file is not text: 4 of its 4 bytes are not characters",
    );
    let cut_off = shop.file("cut.h", "BEGIN PGM cut MM\nQ1 = 1\n");
    let said = fitcheck(&[&cut_off, "--trace"]);
    assert_eq!(said.out, "cut.h:1  BEGIN PGM cut MM\ncut.h:2  Q1 = 1\n    Q1 = 1\n");
    assert!(said.err.ends_with("fitcheck: TNC:\\cut.h, line 2, Q1 = 1: the program is broken: END PGM is missing\n"));
    let broken = shop.path("broken.h");
    check_stopped(&[&broken], "broken.h: the file is not text: 4 of its 4 bytes are not characters");
}

#[test]
fn unknown_blocks_stop_or_are_passed_over() {
    let shop = Shop::new();
    let zoo = shop.path("syntax_zoo.h");
    let said = fitcheck(&[&zoo]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let own = shop.program("ERROR = 23 TOOL CALL \"MILL D6\"");
    check_stopped(
        &[&own],
        "TNC:\\own.h, line 2, ERROR = 23 TOOL CALL \"MILL D6\": unknown block: Fitcheck runs only what it understands",
    );
    let said = fitcheck(&[&own, "--skip-unknown"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), "note: own.h:2: unknown block skipped\n"));
    let said = fitcheck(&[&own, "--skip-unknown", "--language", "nl"]);
    assert_eq!(said.err, "note: own.h:2: onbekende NC-regel overgeslagen\n");
}

#[test]
fn outputs_go_below_the_output_folder_only() {
    let shop = Shop::new();
    shop.file("m.a", "\"one\";\nM_CLOSE;\n");
    let program = shop.program(r"FN 16: F-PRINT m.a / TNC:\logs\out.txt");
    let said = fitcheck(&[&program]);
    assert_eq!(
        (said.code, said.err.as_str()),
        (Some(0), "note: own.h:2: TNC:\\logs\\out.txt was not written: no output folder was chosen\n")
    );
    let out = shop.folder.path().join("out");
    let said = fitcheck(&[&program, "--output-folder", &out.display().to_string()]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), "wrote TNC:\\logs\\out.txt\n"));
    assert_eq!(std::fs::read(out.join("logs/out.txt")).unwrap(), b"one\r\n");
}

#[test]
fn a_file_that_is_printed_to_twice_is_told_once() {
    let shop = Shop::new();
    shop.file("m.a", "\"one\";\nM_APPEND;\nM_CLOSE;\n");
    let program = shop.program("LBL 1\nFN 16: F-PRINT m.a / b.txt\nFN 16: F-PRINT m.a / a.txt\nCALL LBL 1 REP 2");
    let said = fitcheck(&[&program, "--output-folder", &shop.path("")]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), "wrote TNC:\\a.txt\nwrote TNC:\\b.txt\n"));
}

#[test]
fn a_program_cannot_talk_to_the_terminal() {
    let shop = Shop::new();
    shop.file("m.a", "\"\u{1b}]0;title\u{7}%S\", QS1;\n");
    let program = shop.program(
        "QS1 = \"\u{1b}[2Jx\"\nFN 16: F-PRINT m.a / SCREEN:\nFN 26: TABOPEN 82553_hole.tab\n\
         FN 28: TABREAD Q1 = 0/QS1",
    );
    let said = fitcheck(&[&program, "--trace"]);
    assert_eq!(said.code, Some(1), "{}", said.err);
    assert!(said.out.contains(" ]0;title  [2Jx\n") && said.err.contains("no column  [2Jx"), "{}{}", said.out, said.err);
    assert!(!(said.out + &said.err).contains(['\u{1b}', '\u{7}']));
}

#[test]
fn programs_and_tables_may_lie_in_other_folders() {
    let shop = Shop::new();
    let other = tempfile::tempdir().unwrap();
    let main = other.path().join("fit_main.h");
    std::fs::copy(samples().join("programs/fit_main.h"), &main).unwrap();
    let main = main.display().to_string();
    check_stopped(
        &[&main],
        r"TNC:\fit_main.h, block 11, CALL PGM TNC:\fitcheck\fit_check.h: file not found: TNC:\fitcheck\fit_check.h",
    );
    assert_eq!(fitcheck(&[&main, "--folder", &shop.path("")]).code, Some(0));
}

#[test]
fn the_probe_comes_from_a_table() {
    let shop = Shop::new();
    let table = samples().join("tables/tchprobe.tp").display().to_string();
    let said = fitcheck(&[&shop.path("fit_main.h"), "--probe-table", &table]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let probe = "note: fit_check.h:34: tool TOUCH_PROBE is not in the touch-probe table: probe 1 was used\n";
    assert!(said.err.starts_with(probe), "{}", said.err);
}

#[test]
fn wrong_usage_is_told_apart_from_bad_data() {
    let shop = Shop::new();
    let main = shop.path("fit_main.h");
    assert_eq!(fitcheck(&[]).code, Some(2));
    assert_eq!(fitcheck(&[&main, "--workpiece", "a", "--contacts", "b"]).code, Some(2));
    check_stopped(
        &["none.h"],
        "no such file or folder: none.h; built-in programs are 8255_nl.h, 8255_en.h, 8255_de.h, 8255_it.h",
    );
    check_stopped(&["folder/none.h"], "no such file or folder: folder/none.h");
    check_stopped(&[&main, "--set", "Q1=x"], "--set Q1=x: this is not a number");
    check_stopped(
        &[&main, "--set", "R1=1"],
        "--set R1=1: R1 is not a parameter: allowed are Q, QL, QR and QS with a number",
    );
    check_stopped(
        &[&main, "--set", "Q2000=1"],
        "--set Q2000=1: parameter Q2000 does not exist: Q and QS go up to 1999, QL and QR up to 499",
    );
    check_stopped(&[&main, "--folder", "none"], "no such folder: none");
}

/// Slots and rectangles in a program: figures of the workpiece computed by hand, each in the parameter of its cycle.
#[test]
fn a_slot_and_a_pocket_are_measured_in_a_program() {
    let shop = Shop::new();
    let slot = shop.file("slot.toml", "[slot]\ncentre = [50.02, 0.0]\nwidth = 20.05\n[probe]\nball_radius = 3.0\n");
    let blocks = "TOOL CALL 1 Z\nTCH PROBE 425 MEASURE INSIDE WIDTH ~\n  Q328=+50 ;STARTNG PNT 1ST AXIS ~\n  Q329=+10 ~\n  \
                  Q310=+0 ~\n  Q272=+1 ~\n  Q261=-5 ~\n  Q260=+20 ~\n  Q311=+20 ~\n  Q288=+20.1 ~\n  Q289=+20 ~\n  \
                  Q281=+0 ~\n  Q309=+0 ~\n  Q330=+0\nFN 9: IF +Q180 EQU +1 GOTO LBL 1\nFN 14: ERROR= 1072\nLBL 1\n";
    let values = |program: &str, workpiece: &str, names: &[&str]| {
        let said = fitcheck(&[program, "--workpiece", workpiece, "--format", "json"]);
        let answer: Value = serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{}{}", said.out, said.err));
        let [cycle] = answer["cycles"].as_array().unwrap().as_slice() else { panic!("{answer}") };
        let found = names.iter().map(|name| cycle["results"][name].clone());
        (said.code, found.collect::<Vec<_>>())
    };
    let program = shop.program(blocks);
    // 20.05 wide, its middle at 50.02, 0.05 more than nominal, within 20 to 20.1.
    let expected = [20.05, 50.02, 0.05].map(Value::from).to_vec();
    assert_eq!(values(&program, &slot, &["Q156", "Q157", "Q166"]), (Some(0), expected));
    let pocket = "[pocket]\ncentre = [50.03, 19.98]\nlengths = [59.9, 40.04]\n[probe]\nball_radius = 2.0\n";
    let pocket = shop.file("pocket.toml", pocket);
    let blocks = "TOOL CALL 1 Z\nTCH PROBE 423 MEAS. RECTAN. INSIDE ~\n  Q273=+50 ~\n  Q274=+20 ~\n  Q282=+60 ~\n  Q283=+40 ~\n  \
                  Q261=-5 ~\n  Q320=+0 ~\n  Q260=+20 ~\n  Q301=+0 ~\n  Q284=+60.1 ~\n  Q285=+60 ~\n  Q286=+40.1 ~\n  \
                  Q287=+40 ~\n  Q279=+0 ~\n  Q280=+0 ~\n  Q281=+0 ~\n  Q309=+0 ~\n  Q330=+0\n";
    let program = shop.program(blocks);
    // The first side is 0.1 too small: rework. The second is within its limits.
    let names = ["Q151", "Q152", "Q154", "Q155", "Q161", "Q162", "Q164", "Q165", "Q180", "Q181", "Q182"];
    let expected = [50.03, 19.98, 59.9, 40.04, 0.03, -0.02, -0.1, 0.04].map(Value::from).into_iter();
    let expected = expected.chain([0, 1, 0].map(Value::from)).collect::<Vec<_>>();
    assert_eq!(values(&program, &pocket, &names), (Some(10), expected));
}

/// The hole of the workpiece is far too large for 25 H7.
#[test]
fn a_scrap_hole_is_not_passed_by_a_cycle_that_lost_its_limits() {
    let shop = Shop::new();
    let cycle = |q301: &str| {
        format!(
            "TOOL CALL 1 Z\nTCH PROBE 421 HOLE ~\n    Q273=+40 ;X ~\n    Q274=+30 ;X ~\n    Q262=+25 ;X ~\n    Q325=+0 ;X ~\n    \
             Q247=+90 ;X ~\n    Q261=-5 ;X ~\n    Q320=+0 ;X ~\n    Q260=+20 ;X ~\n    {q301}\n    Q275=+25.021 ;X ~\n    \
             Q276=+25 ;X ~\n    Q279=+0 ;X ~\n    Q280=+0 ;X ~\n    Q281=+0 ;X ~\n    Q309=+0 ;X ~\n    Q330=+0 ;X"
        )
    };
    let scrap = shop.path("scrap.toml");
    let whole = fitcheck(&[&shop.program(&cycle("Q301=+0 ;X ~")), "--workpiece", &scrap]);
    assert_eq!(whole.code, Some(11), "{}{}", whole.out, whole.err);
    let cut = "column 5: cycle 421 ended in line 12, which has no ~ at its end: Q275 is not part of it and would be assigned instead";
    let own = fitcheck(&[&shop.program(&cycle("Q301=+0 ;X")), "--workpiece", &scrap]);
    assert_eq!(own.code, Some(1), "{}", own.err);
    assert!(own.err.contains(&format!("own.h: line 13, {cut}")), "{}", own.err);
    // What the reader of a called program says is said, too.
    let called = shop.program(&cycle("Q301=+0 ;X"));
    std::fs::rename(&called, shop.path("sub.h")).unwrap();
    let said = fitcheck(&[&shop.program("CALL PGM sub.h"), "--workpiece", &scrap]);
    assert_eq!(said.code, Some(1), "{}", said.err);
    assert!(said.err.contains(r"TNC:\sub.h: line 13, ") && said.err.contains(cut), "{}", said.err);
}

/// The log has the unit of the main program, here inches, also of a cycle in a program in millimetres.
#[test]
fn an_inch_main_program_has_its_log_in_inches() {
    let shop = Shop::new();
    let measuring = "TOOL CALL 1 Z\nTCH PROBE 421 HOLE ~\n Q273=+40 ;X ~\n Q274=+30 ;X ~\n Q262=+25 ;X ~\n Q325=+0 ;X ~\n Q247=+90 ;X ~\n \
                     Q261=-5 ;X ~\n Q320=+0 ;X ~\n Q260=+20 ;X ~\n Q301=+0 ;X ~\n Q275=+25.03 ;X ~\n Q276=+25 ;X ~\n Q279=+0 ;X ~\n \
                     Q280=+0 ;X ~\n Q281=+1 ;X ~\n Q309=+0 ;X ~\n Q330=+0 ;X";
    std::fs::rename(shop.program(measuring), shop.path("sub.h")).unwrap();
    let main = shop.file("inch.h", "BEGIN PGM inch INCH\nCALL PGM sub.h\nEND PGM inch INCH\n");
    let out = shop.path("out");
    let said = fitcheck(&[&main, "--workpiece", &shop.path("good.toml"), "--output-folder", &out]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let log = std::fs::read_to_string(shop.folder.path().join("out/TCHPR421.TXT")).unwrap();
    assert!(log.contains("(0 = MM / 1 = INCH): 1"), "{log}");
    // 25.0134 mm
    assert!(log.contains("0.9848"), "{log}");
}

/// H7 and H8 are two classes: the program would read both, and measure against the first.
#[test]
fn two_classes_in_one_text_are_refused() {
    let said = fitcheck(&["8255_nl.h", "--set", "Q1=25", "QS1=H7,H8"]);
    assert_eq!(said.code, Some(1), "{}", said.out);
    assert!(said.err.contains("QS1 = H7,H8 names several columns"), "{}", said.err);
}

/// A path that leads nowhere: the built-in program of that name is read, and that is said, or refused.
#[test]
fn a_built_in_file_in_place_of_a_given_path_is_told_or_refused() {
    let shop = Shop::new();
    let blocks = "Q1 = 25\nQS1 = \"H7\"\nFN 26: TABOPEN TNC:\\firma\\82553_hole.tab\nFN 28: TABREAD QL1 = 3 / \"H7\"";
    let own = shop.program(blocks);
    let table = "TNC:\\firma\\82553_hole.tab";
    let said = fitcheck(&[&own]);
    assert_eq!(
        (said.code, said.err),
        (Some(0), format!("note: own.h:4: {table} is not among the given files: the built-in one was read\n"))
    );
    let (_, answer) = json(&[&own]);
    assert_eq!(answer["files"], serde_json::json!([{"file": table, "from": "built in"}]));
    check_stopped(
        &[&own, "--no-builtin"],
        &format!(r"TNC:\own.h, line 4, FN 26: TABOPEN {table}: file not found: {table}"),
    );
    // The user's own one beside the program.
    let given = shop.file("82553_hole.tab", &std::fs::read_to_string(shop.path("fit_hole.tab")).unwrap());
    let (code, answer) = json(&[&own]);
    assert_eq!((code, &answer["remarks"]), (Some(0), &serde_json::json!([])));
    assert_eq!(answer["files"], serde_json::json!([{"file": table, "from": given}]));
    // With a trace the text says it, too.
    let read = |from: &str| format!("note: {table} {from}\n");
    assert_eq!(fitcheck(&[&own]).err, "");
    assert_eq!(fitcheck(&[&own, "--trace"]).err, read(&format!("was read from {given}")));
    assert_eq!(fitcheck(&[&own, "--trace", "--language", "nl"]).err, read(&format!("is gelezen uit {given}")));
    let said = fitcheck(&["8255_nl.h", "--set", "Q1=25", "QS1=H7", "--trace"]).err;
    assert!(said.contains("note: TNC:\\82551_nl.h is built in\nnote: TNC:\\8255\\82552_nl.a is built in\n"), "{said}");
    // The whole set is built in: nothing else could be meant.
    let (_, answer) = json(&["8255_nl.h", "--set", "Q1=25", "QS1=H7"]);
    assert!(!answer["remarks"].to_string().contains("built-in"), "{answer}");
    assert!(answer["files"].as_array().unwrap().iter().all(|file| file["from"] == "built in"), "{answer}");
    assert_eq!(fitcheck(&["8255_nl.h", "--no-builtin"]).code, Some(1));
}

/// The end of the table is missing, and perhaps its last rows.
#[test]
fn a_table_that_was_cut_off_is_told_in_a_run() {
    let shop = Shop::new();
    let whole = std::fs::read_to_string(shop.path("fit_hole.tab")).unwrap();
    let (rows, _end) = whole.rsplit_once("[END]").unwrap();
    shop.file("cut.tab", rows);
    let said = fitcheck(&[&shop.program("FN 26: TABOPEN cut.tab\nFN 28: TABREAD QL1 = 3 / \"H7\"")]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert!(said.err.starts_with("note: own.h:2: TNC:\\cut.tab: ") && said.err.contains("END"), "{}", said.err);
}

#[test]
fn an_iso_program_runs_and_calls_another() {
    let shop = Shop::new();
    let cycle = "G421 Q273=+40 Q274=+30 Q262=25 Q261=-8 Q275=+25.021 Q276=+25";
    shop.file("SUB.i", &format!("%SUB G71 *\nN10 {cycle} *\nN99999999 %SUB G71 *\n"));
    let main = shop.file(
        "part.i",
        "%PART G71 *\nN5 T9 G17 *\nN10 G00 G90 X+0 Y+0 Z+50 *\nN20 %SUB *\nN30 Q1 = Q153 * 2 *\nN99999999 %PART G71 *\n",
    );
    let (code, answer) = json(&[&main, "--workpiece", &shop.path("rework.toml")]);
    assert_eq!((code, &answer["faults"]), (Some(10), &serde_json::json!([])));
    assert_eq!((&answer["parameters"]["Q1"], &answer["cycles"][0]["line"]), (&Value::from(49.98), &Value::from(2)));
    assert_eq!(answer["cycles"][0]["program"], "TNC:\\SUB");

    let twice = shop.file("twice.i", &format!("%A G71 *\nN5 T9 G17 *\nN10 {cycle} Q276=+24.9 *\nN99 %A G71 *\n"));
    let said = fitcheck(&[&twice]);
    assert!(said.code == Some(1) && said.err.contains("Q276"), "{}", said.err);
    let open = shop.file("open.i", &format!("%A G71 *\nN10 {cycle}\nN99 %A G71 *\n"));
    let said = fitcheck(&[&open]);
    assert!(
        said.code == Some(1) && said.err.contains("line 2, column 65: the block does not end in *"),
        "{}",
        said.err
    );
}

#[test]
fn the_iso_sample_has_its_documented_values() {
    let shop = Shop::new();
    let program = samples().join("programs/fit_iso.i").display().to_string();
    for (diameter, code, counted, is_scrap) in
        [("18.000", 0, 0.0, false), ("17.980", 10, 1.0, false), ("18.010", 1, 0.0, true)]
    {
        let bore = shop.file("bore.toml", &format!("[bore]\ncentre = [0.0, 0.0]\ndiameter = {diameter}\n"));
        let (found, answer) = json(&[&program, "--workpiece", &bore]);
        let parameter = |name: &str| answer["parameters"][name].clone();
        assert_eq!((found, parameter("Q40")), (Some(code), Value::from(counted)), "{diameter}: {answer:#}");
        assert_eq!((parameter("Q23"), parameter("Q33")), (Value::from(18.006), Value::from(17.988)));
        assert_eq!(parameter("Q182"), Value::from(if is_scrap { 1.0 } else { 0.0 }));
        match answer["faults"].as_array().unwrap().first() {
            None => assert!(!is_scrap),
            Some(fault) => assert!(is_scrap && fault["number"] == 180 && fault.to_string().contains("1072"), "{fault}"),
        }
        if diameter == "17.980" {
            assert_eq!(parameter("Q163"), Value::from(-0.02));
        }
    }
}
