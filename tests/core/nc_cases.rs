//! Programs and logs from the field that once failed, each with its right answer.

use std::path::Path;

use assert_cmd::Command;

/// What the program says to a command, in a folder with the files of the cases.
struct Said {
    code: i32,
    out: String,
    err: String,
}

struct Shop {
    folder: tempfile::TempDir,
}

impl Shop {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        for entry in std::fs::read_dir(Path::new("tests/data/nc_cases")).unwrap() {
            let path = entry.unwrap().path();
            std::fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
        }
        Self { folder }
    }

    fn put(&self, name: &str, text: &str) {
        fitcheck::files::write(&self.folder.path().join(name), text.as_bytes()).unwrap();
    }

    fn read(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(self.folder.path().join(name)).ok()
    }

    fn say(&self, args: &[&str]) -> Said {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
        let output = command.args(args).current_dir(self.folder.path()).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Said { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
    }
}

#[test]
fn behind_a_skipped_measuring_cycle_no_result_is_left_of_an_earlier_one() {
    let shop = Shop::new();
    let text = shop.read("stale_after_skipped_cycle.h").unwrap();
    // A cycle that nothing here runs, in place of one that once was such.
    shop.put("stale.h", &text.replace("TCH PROBE 412 DATUM INSIDE CIRCLE", "TCH PROBE 416 DATUM CIRCLE CENTER"));
    let said = shop.say(&["run", "stale.h", "--skip-unknown"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(said.err.contains("Q180 is undefined: line 19, TCH PROBE 416"), "{}", said.err);
    assert!(!said.out.contains("SECOND HOLE GOOD"), "{}", said.out);
}

#[test]
fn a_hole_is_measured_from_the_datum_that_the_cycle_before_has_set() {
    let shop = Shop::new();
    let said = shop.say(&["run", "datum_then_hole.h", "--workpiece", "datum_then_hole.toml", "--format", "json"]);
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    assert!(said.out.contains("GOOD"), "{}", said.out);
    let text = shop.read("datum_then_hole.h").unwrap();
    shop.put("unknown.h", &text.replace("TCH PROBE 412 DATUM INSIDE CIRCLE", "TCH PROBE 416 DATUM CIRCLE CENTER"));
    let said = shop.say(&["run", "unknown.h", "--workpiece", "datum_then_hole.toml", "--skip-unknown"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(!said.out.contains("GOOD"), "{}", said.out);
    // The block alone has another datum than in its program.
    let alone = shop.say(&["cycle", "421", "--block", "datum_then_hole.h", "--at", "25"]);
    assert!(alone.err.contains("line 4: TCH PROBE 412"), "{}", alone.err);
}

#[test]
fn the_face_of_a_perfect_part_is_in_the_middle_of_its_limits() {
    let shop = Shop::new();
    for args in [&[][..], &["--workpiece", "coordinate_from_a_cam_system.toml"]] {
        let said = shop.say(&[&["run", "coordinate_from_a_cam_system.h", "--format", "json"], args].concat());
        assert_eq!(said.code, 0, "{}{}", said.out, said.err);
        assert!(said.out.contains("GOOD"), "{}", said.out);
    }
}

#[test]
fn a_limit_that_is_given_twice_is_offered_as_the_other_one() {
    let shop = Shop::new();
    let said = shop.say(&["run", "slot_q288_twice.h"]);
    assert_eq!(said.code, 1);
    assert!(said.err.contains("Q288 is given twice") && said.err.contains("Q289"), "{}", said.err);
}

#[test]
fn files_are_copied_and_deleted_within_the_output_folder() {
    let shop = Shop::new();
    shop.put("TCHPR421.TXT", "LOG\r\n");
    shop.put("a", "A\r\n");
    std::fs::create_dir(shop.folder.path().join("out")).unwrap();
    shop.put("out/x", "X\r\n");
    let said = shop.say(&["run", "filecopy.h", "--output-folder", "out"]);
    assert_eq!((said.code, said.err.contains(r"TNC:\x was deleted")), (0, true), "{}", said.err);
    assert_eq!(shop.read("out/B1.TXT").as_deref(), Some("LOG\r\n"));
    assert_eq!((shop.read("out/b").as_deref(), shop.read("out/x")), (Some("A\r\n"), None));
}

#[test]
fn the_tool_table_answers_what_a_program_asks_of_its_tools() {
    let shop = Shop::new();
    shop.put(
        "tool.t",
        "BEGIN TOOL.T MM\nT   L    R   DL    DR\n5   +90  +6  +0.1  -0.05\n100 +50  +3  +0    +0\n[END]\n",
    );
    let said = shop.say(&["run", "fn18.h", "--tools", "tool.t", "--trace"]);
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    for words in ["Q3 = 6\n", "QS2 = \"TNC:\\fn18.h\"\n"] {
        assert!(said.out.contains(words), "{words}{}", said.out);
    }
    let said = shop.say(&["run", "preassigned.h", "--tools", "tool.t", "--trace"]);
    for words in ["Q1 = 11.9\n", "Q2 = 90.1\n", "Q3 = 2\n"] {
        assert!(said.out.contains(words), "{words}{}{}", said.out, said.err);
    }
}

#[test]
fn a_path_with_a_text_parameter_is_a_file_below_the_output_folder() {
    let shop = Shop::new();
    let said = shop.say(&["run", "fn16_path.h", "--output-folder", "out"]);
    assert_eq!(said.code, 0, "{}", said.err);
    for file in ["out/LOG/B1.TXT", "out/LOG/B2.TXT"] {
        assert!(shop.read(file).is_some_and(|text| text.contains("DIAMETER   25.0100")), "{file}");
    }
}

#[test]
fn a_block_of_iso_is_read_alone_as_a_run_reads_it() {
    let shop = Shop::new();
    let block = shop.read("block_with_asterisks.i").unwrap();
    shop.put("whole.i", &format!("%A G71 *\nN10 T100 G17 S50*\n{block}N99999999 %A G71 *\n"));
    let alone = shop.say(&["cycle", "421", "--block", "block_with_asterisks.i"]);
    let whole = shop.say(&["run", "whole.i", "--format", "json"]);
    assert_eq!((alone.code, whole.code), (0, 0), "{}{}", alone.err, whole.err);
    assert!(alone.out.contains("GOOD") && whole.out.contains("GOOD"), "{}{}", alone.out, whole.out);
}

#[test]
fn a_log_with_its_last_line_in_one_has_all_deviations_and_a_wrong_one_is_refused() {
    let shop = Shop::new();
    let said = shop.say(&["import", "log_one_line.TXT"]);
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(!said.err.contains("deviations are missing"), "{}", said.err);
    let said = shop.say(&["import", "log_deviation_wrong.TXT"]);
    assert_eq!(said.code, 1);
    assert!(said.err.contains("deviation 0.0223 is not actual minus nominal value"), "{}", said.err);
}
