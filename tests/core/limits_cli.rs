//! `fitcheck limits`, through the built program.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::io::{BufRead as _, BufReader, Write as _};
use std::process::{Command, Stdio};

use assert_cmd::assert::Assert;
use assert_cmd::cargo::cargo_bin_cmd;

const HEADER: &str = "callout,nominal_mm,lower_um,upper_um,min_mm,max_mm,source,error\n";
const HOLE_18_30: &str = "\"ISO 286, over 18 up to 30 mm\"";

fn limits(args: &[&str], input: &[u8]) -> Assert {
    cargo_bin_cmd!("fitcheck").arg("limits").args(args).write_stdin(input.to_vec()).assert()
}

/// Exit code, standard output and standard error.
#[track_caller]
fn check(args: &[&str], input: &str, code: i32, out: &str, err: &str) {
    check_bytes(args, input.as_bytes(), code, out, err);
}

#[track_caller]
fn check_bytes(args: &[&str], input: &[u8], code: i32, out: &str, err: &str) {
    let answer = limits(args, input);
    let output = answer.get_output();
    let said = (
        String::from_utf8(output.stdout.clone()).unwrap(),
        String::from_utf8(output.stderr.clone()).unwrap(),
        output.status.code(),
    );
    assert_eq!(said, (out.to_owned(), err.to_owned(), Some(code)), "for {args:?}");
}

#[test]
fn csv_has_the_columns_of_the_contract() {
    let row = format!("25 H7,25,0,21,25.000,25.021,{HOLE_18_30},\n");
    check(&["25 H7", "--format", "csv"], "", 0, &format!("{HEADER}{row}"), "");
}

#[test]
fn csv_figures_are_exact_and_the_callout_stays_as_given() {
    let over_6 = "\"ISO 286, over 6 up to 10 mm\"";
    let over_3 = "\"ISO 286, over 3 up to 6 mm\"";
    let rows = format!(
        "8 JS7,8,-7.5,7.5,7.9925,8.0075,{over_6},\n\
         \"Ø25,0H7\",25,0,21,25.000,25.021,{HOLE_18_30},\n\
         3.000001 h7,3.000001,-12,0,2.988001,3.000001,{over_3},\n"
    );
    check(&["8 JS7", "  Ø25,0H7 ", "3.000001 h7", "--format", "csv"], "", 0, &format!("{HEADER}{rows}"), "");
}

#[test]
fn a_stream_gets_one_line_for_each_line_refusals_included_and_goes_on() {
    let input = "25 H7\n\n1 N9\r\n24 T7\n  25 H7  \n3200 H7\n25 H7";
    let good = format!("25 H7,25,0,21,25.000,25.021,{HOLE_18_30},\n");
    let out = format!(
        "{HEADER}{good}\
         ,,,,,,,\"a callout is missing: write a nominal size and a tolerance class, such as 25 H7\"\n\
         1 N9,,,,,,,N9 is not defined at 1 mm in ISO 286; it is defined over 1 up to 3150 mm\n\
         24 T7,,,,,,,T7 is not defined at 24 mm in ISO 286; it is defined over 24 up to 3150 mm\n\
         {good}\
         3200 H7,,,,,,,\"nominal size 3200 mm is beyond ISO 286, which ends at 3150 mm\"\n\
         {good}"
    );
    check(&["-", "--format", "csv"], input, 1, &out, "4 of 7 callouts refused\n");
}

#[test]
fn json_is_an_array_of_objects_with_the_same_names() {
    let answer = limits(&["25 H7", "-", "1 N9", "--format", "json"], b"8 JS7\n");
    let output = answer.get_output();
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(String::from_utf8(output.stderr.clone()).unwrap(), "1 of 3 callouts refused\n");
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        told,
        serde_json::json!([
            {
                "callout": "25 H7", "nominal_mm": 25, "lower_um": 0, "upper_um": 21, "min_mm": 25.0, "max_mm": 25.021,
                "source": "ISO 286, over 18 up to 30 mm", "error": null
            },
            {
                "callout": "8 JS7", "nominal_mm": 8, "lower_um": -7.5, "upper_um": 7.5, "min_mm": 7.9925,
                "max_mm": 8.0075, "source": "ISO 286, over 6 up to 10 mm", "error": null
            },
            {
                "callout": "1 N9", "nominal_mm": null, "lower_um": null, "upper_um": null, "min_mm": null,
                "max_mm": null, "source": null,
                "error": "N9 is not defined at 1 mm in ISO 286; it is defined over 1 up to 3150 mm"
            }
        ])
    );
    check(&["-", "--format", "json"], "", 0, "[]\n", "");
    check(&["-", "--format", "csv"], "", 0, HEADER, "");
    check(&["-"], "", 0, "", "");
}

#[test]
fn text_is_aligned_and_refusals_go_to_standard_error() {
    check(
        &["25H7", "25 g6", "25 V19", "100 JS9", "-"],
        "\n",
        1,
        "\
25 H7       hole     25.000 … 25.021 mm    (0 / +21 µm)        from ISO 286, over 18 up to 30 mm
25 g6       shaft    24.980 … 24.993 mm    (-20 / -7 µm)       from ISO 286, over 18 up to 30 mm
100 JS9     hole    99.9565 … 100.0435 mm  (-43.5 / +43.5 µm)  from ISO 286, over 80 up to 120 mm
",
        "\
25 V19: V19 is not an ISO 286 tolerance class: the grades are 01 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18
line 1: a callout is missing: write a nominal size and a tolerance class, such as 25 H7
",
    );
}

#[test]
fn bytes_that_are_no_utf8_and_control_characters_are_answered_like_any_line() {
    // Ø in Windows-1252, a byte order mark, an escape sequence, UTF-16.
    let input = b"\xd825 H7\n\xef\xbb\xbf25 H7\n\x1b[2J25 H7\n2\x005\x00\n";
    let good = |callout: &str| format!("{callout},25,0,21,25.000,25.021,{HOLE_18_30},\n");
    let out = format!(
        "{HEADER}{}{}\
         \u{fffd}[2J25 H7,,,,,,,\"\u{fffd}[2J25 H7 does not begin with a nominal size: write one, such as 25 H7\"\n\
         2\u{fffd}5\u{fffd},,,,,,,\"\u{fffd}5\u{fffd} is not a tolerance class: write letters and a grade, such as H7 or js13 (character 2)\"\n",
        good("Ø25 H7"),
        good("25 H7"),
    );
    check_bytes(&["-", "--format", "csv"], input, 1, &out, "2 of 4 callouts refused\n");
}

#[test]
fn a_line_without_end_is_refused_in_bounded_memory_and_the_next_one_is_answered() {
    let padded = |length: usize| format!("25 H7{}", " ".repeat(length - 5));
    let good = format!("25 H7,25,0,21,25.000,25.021,{HOLE_18_30},\n");
    let input = format!("{}\r\n{}\n{}\n25 H7\n", padded(65_536), padded(65_537), "9".repeat(10_000_000));
    let out = format!(
        "{HEADER}{good}\
         25 H7{}…,,,,,,,the line is longer than 65536 bytes\n\
         {}…,,,,,,,the line is longer than 65536 bytes\n\
         {good}",
        " ".repeat(35),
        "9".repeat(40),
    );
    check(&["-", "--format", "csv"], &input, 1, &out, "2 of 4 callouts refused\n");
}

#[test]
fn another_program_can_ask_line_by_line() {
    let program = assert_cmd::cargo::cargo_bin!("fitcheck");
    let mut child = Command::new(program)
        .args(["limits", "-", "--format", "csv"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let mut answers = BufReader::new(child.stdout.take().unwrap()).lines();
    for (callout, expected) in [("25 H7", "25 H7,25,0,21,"), ("30 H7", "30 H7,30,0,21,")] {
        writeln!(input, "{callout}").unwrap();
        let mut answer = answers.next().unwrap().unwrap();
        if answer == HEADER.trim_end() {
            answer = answers.next().unwrap().unwrap();
        }
        assert!(answer.starts_with(expected), "{answer}");
    }
    drop(input);
    assert!(answers.next().is_none());
    assert!(child.wait().unwrap().success());
}

#[test]
fn own_tables_come_first_and_the_answer_says_what_they_replace() {
    let folder = tempfile::tempdir().unwrap();
    let own = "BEGIN own.tab\nNR BEREICH H7   U1\n0  30      +30  +8\n1          +5   +3\n";
    std::fs::write(folder.path().join("own.tab"), own).unwrap();
    let path = folder.path().to_str().unwrap();
    let out = format!(
        "{HEADER}25 U1,25,3,8,25.003,25.008,\"table own.tab, over 0 up to 30 mm\",\n\
         25 H7,25,5,30,25.005,25.030,\"table own.tab, over 0 up to 30 mm, instead of 0 / +21 µm in ISO 286\",\n\
         25 H8,25,0,33,25.000,25.033,{HOLE_18_30},\n\
         50 H7,50,0,25,50.000,50.025,\"ISO 286, over 30 up to 50 mm\",\n"
    );
    let named = folder.path().join("own.tab");
    let warning = format!("warning: [END] is missing: {}, line 4, column 1\n", named.display());
    check(&["25 U1", "25 H7", "25 H8", "50 H7", "--format", "csv", "--tables", path], "", 0, &out, &warning);
}

#[test]
fn a_broken_table_ends_the_program_before_anything_is_answered() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_str().unwrap();
    let none = format!("fitcheck: no table of deviations (*.tab with a column BEREICH) in this folder: {path}\n");
    check(&["25 H7", "--tables", path], "", 1, "", &none);
    std::fs::write(folder.path().join("own.tab"), "BEGIN own.tab\nNR BEREICH H7\n0  3       +1O\n").unwrap();
    let broken = format!(
        "fitcheck: the number of rows is odd (1): each size range takes two, first the upper deviation, then the lower deviation: \
         {}, line 3, column 1\n",
        folder.path().join("own.tab").display()
    );
    check(&["25 H7", "--tables", path], "", 1, "", &broken);
}

#[test]
fn a_closed_pipe_is_not_an_error() {
    let program = assert_cmd::cargo::cargo_bin!("fitcheck");
    for format in ["text", "csv", "json"] {
        let mut child = Command::new(program)
            .args(["limits", "-", "--format", format])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut input = child.stdin.take().unwrap();
        // The program may have ended before everything is written.
        let _closed = input.write_all("25 H7\n".repeat(100_000).as_bytes());
        drop(input);
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]), "{format}");
    }
}

#[test]
fn wrong_usage_exits_with_2_and_help_shows_examples() {
    limits(&[], b"").code(2);
    limits(&["25 H7", "--fromat", "csv"], b"").code(2);
    limits(&["-5 H7"], b"").code(2);
    check(&["--", "-5 H7"], "", 1, "", "-5 H7: nominal size -5 mm is not above 0\n");
    let help = limits(&["--help"], b"").success();
    let text = String::from_utf8(help.get_output().stdout.clone()).unwrap();
    assert!(text.contains("fitcheck limits - --format csv < callouts.txt"), "{text}");
}

#[test]
fn the_controls_tables_are_the_other_source() {
    let source = ["--source", "control", "--format", "csv"];
    let answer = limits(&[&["25 H7", "400.5 H7", "25 G6", "25 T7"][..], &source].concat(), b"");
    assert_eq!(
        String::from_utf8(answer.get_output().stdout.clone()).unwrap(),
        format!(
            "{HEADER}25 H7,25,0,21,25.000,25.021,\"built-in table 82553_hole.tab, over 18 up to 30 mm\",\n\
             400.5 H7,,,,,,,\"nominal size 400.5 mm is beyond table 82553_hole.tab, whose last range is over 355 up to and \
             including 400 mm\"\n\
             25 G6,,,,,,,G6 is a hole class and table 82553_hole.tab does not have it; the shaft class is g6\n\
             25 T7,,,,,,,T7 is not in table 82553_hole.tab; it has D10 E9 F7 F8 G7 G9 H6 H7 H8 H9 H11 H12 H13 JS7 JS9 \
             K6 K7 M6 M7 N7 N9 P7 P9 R7\n"
        )
    );
}

#[test]
fn editions_of_the_standard_can_be_chosen() {
    let figures = |args: &[&str]| {
        let answer = limits(&[args, &["--format", "csv"]].concat(), b"");
        String::from_utf8(answer.get_output().stdout.clone()).unwrap().lines().nth(1).unwrap().to_owned()
    };
    assert!(figures(&["100 JS9"]).starts_with("100 JS9,100,-43.5,43.5,"));
    assert_eq!(
        figures(&["100 JS9", "--js-rounded"]),
        "100 JS9,100,-43,43,99.957,100.043,\"ISO 286, over 80 up to 120 mm; JS rounded as in 1988\","
    );
    assert!(figures(&["20 cd8"]).starts_with("20 cd8,20,-118,-85,"));
    assert!(figures(&["20 cd8", "--edition", "1988"]).contains("it is defined over 0 up to 10 mm"));
}

/// The list of the issue: exceptions and borders, line by line.
#[test]
fn exceptions_and_borders_are_right_or_refused_line_by_line() {
    let input = b"1250 H8\n3 K7\n3.001 K7\n280 M6\n250 M6\n24 T7\n8 N9\n";
    let answer = limits(&["-", "--format", "csv"], input);
    let out = String::from_utf8(answer.get_output().stdout.clone()).unwrap();
    let figures: Vec<String> =
        out.lines().skip(1).map(|l| l.split(',').take(4).collect::<Vec<_>>().join(",")).collect();
    assert_eq!(
        figures,
        [
            "1250 H8,1250,0,165",
            "3 K7,3,-10,0",
            "3.001 K7,3.001,-9,3",
            "280 M6,280,-41,-9",
            "250 M6,250,-37,-8",
            "24 T7,,,",
            "8 N9,8,-36,0"
        ]
    );
}

#[test]
fn every_notation_of_drawings_is_answered() {
    let input = "Ø25 h6\n25 H7-g6\n10m\n12+0.01-0.015\n12 ±0.02\n12 +0.2/0\n12,01/11,985\n3v\n8-2-1\n".as_bytes();
    let answer = limits(&["-", "--format", "csv"], input);
    assert_eq!(
        String::from_utf8(answer.get_output().stdout.clone()).unwrap(),
        format!(
            "{HEADER}Ø25 h6,25,-13,0,24.987,25.000,{HOLE_18_30},\n\
             25 H7,25,0,21,25.000,25.021,{HOLE_18_30},\n\
             25 g6,25,-20,-7,24.980,24.993,{HOLE_18_30},\n\
             10m,10,-200,200,9.800,10.200,\"ISO 2768-1 class m, over 6 up to 30 mm\",\n\
             12+0.01-0.015,12,-15,10,11.985,12.010,the callout itself,\n\
             12 ±0.02,12,-20,20,11.980,12.020,the callout itself,\n\
             12 +0.2/0,12,0,200,12.000,12.200,the callout itself,\n\
             \"12,01/11,985\",11.9975,-12.5,12.5,11.985,12.010,the callout itself,\n\
             3v,,,,,,,ISO 2768-1 does not define class v from 0.5 up to 3 mm; it is defined over 3 up to 4000 mm\n\
             8-2-1,,,,,,,the lower deviation comes before the upper one: write 8 -1 -2 (character 2)\n"
        )
    );
    check(
        &["25 H7/g6", "12 +0.2 0"],
        "",
        0,
        "\
25 H7       hole     25.000 … 25.021 mm    (0 / +21 µm)        from ISO 286, over 18 up to 30 mm
25 g6       shaft    24.980 … 24.993 mm    (-20 / -7 µm)       from ISO 286, over 18 up to 30 mm
12 +0.2 0   –        12.000 … 12.200 mm    (0 / +200 µm)       from the callout itself
",
        "",
    );
}

#[test]
#[cfg(unix)]
fn nobody_listening_to_refusals_leaves_the_answers_and_the_exit_code() {
    for (format, lines) in [("text", 2), ("csv", 4)] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = Command::new(assert_cmd::cargo::cargo_bin!("fitcheck"))
            .args(["limits", "25 H7", "bad", "25 g6", "--format", format])
            .stderr(Stdio::from(writer))
            .output()
            .unwrap();
        let said = String::from_utf8(output.stdout).unwrap();
        assert_eq!((said.lines().count(), output.status.code()), (lines, Some(1)), "{format}");
    }
}

#[test]
fn utf_16_is_read_from_a_redirected_file() {
    let units =
        |order: fn(u16) -> [u8; 2]| "\u{feff}25 H7\r\n12 ±0.05\r\n".encode_utf16().flat_map(order).collect::<Vec<u8>>();
    let expected = limits(&["-", "--format", "csv"], "25 H7\n12 ±0.05\n".as_bytes()).success();
    for bytes in [units(u16::to_le_bytes), units(u16::to_be_bytes)] {
        let answer = limits(&["-", "--format", "csv"], &bytes).success();
        assert_eq!(answer.get_output().stdout, expected.get_output().stdout);
    }
}
