//! `fitcheck import` as a whole: files in, verdicts, errors and exit codes out.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use fitcheck::tolerance::Sources;

const HEADER: &str = "file,line,id,callout,nominal_mm,min_mm,max_mm,measured_mm,deviation_um,status,remove_um,position,source,warnings,error";

/// What says how a value came about: nothing of these rows was simulated or corrected.
const HOW: &str = ",simulated,as_measured_mm,correction_um,temperature_c,expansion_um_per_m_k,scale_temperature_c,scale_expansion_um_per_m_k";

/// The answer of the program: exit code, standard output, standard error.
struct Answer {
    code: i32,
    out: String,
    err: String,
}

fn run(folder: &Path, arguments: &[&str]) -> Answer {
    let mut command = Command::cargo_bin("fitcheck").unwrap();
    let output = command.current_dir(folder).arg("import").args(arguments).output().unwrap();
    Answer {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The answer to one file as CSV, without the header.
fn csv(name: &str, bytes: &[u8]) -> (i32, Vec<String>) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::File::create(folder.path().join(name))
        .and_then(|mut file| std::io::Write::write_all(&mut file, bytes))
        .unwrap();
    let answer = run(folder.path(), &["--format", "csv", name]);
    let mut lines = answer.out.lines().map(str::to_owned);
    assert_eq!(lines.next(), Some(format!("{HEADER}{HOW}")));
    let without = |line: String| {
        let how = [",false,,,,,,", ",,,,,,,"].into_iter().find_map(|how| line.strip_suffix(how));
        how.unwrap_or_else(|| panic!("{line}")).to_owned()
    };
    (answer.code, lines.map(without).collect())
}

#[track_caller]
fn check(text: &str, code: i32, expected: &[&str]) {
    assert_eq!(csv("m.csv", text.as_bytes()), (code, expected.iter().map(ToString::to_string).collect()), "{text}");
}

fn samples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs")
}

const H7: &str = "\"ISO 286, over 18 up to 30 mm\"";

#[test]
fn the_exit_code_is_that_of_the_worst_verdict() {
    check(
        "id,callout,measured\nb1,25 H7,25.012\n",
        0,
        &[&format!("m.csv,2,b1,25 H7,25,25.000,25.021,25.012,12,GOOD,,,{H7},,")],
    );
    check(
        "b1;25 H7;25,012\nb2;25 H7;24,998\n",
        10,
        &[
            &format!("m.csv,1,b1,25 H7,25,25.000,25.021,25.012,12,GOOD,,,{H7},,"),
            &format!("m.csv,2,b2,25 H7,25,25.000,25.021,24.998,-2,REWORK,2,,{H7},,"),
        ],
    );
    check(
        "b1;25 H7;25,030\nb2;25 H7;24,998\n",
        11,
        &[
            &format!("m.csv,1,b1,25 H7,25,25.000,25.021,25.030,30,SCRAP,,,{H7},,"),
            &format!("m.csv,2,b2,25 H7,25,25.000,25.021,24.998,-2,REWORK,2,,{H7},,"),
        ],
    );
    check(
        "b1;25 H7;25,030\nb2;25 H7;24,9g8\nb3;25 H7;25,000000\n",
        1,
        &[
            &format!("m.csv,1,b1,25 H7,25,25.000,25.021,25.030,30,SCRAP,,,{H7},,"),
            "m.csv,2,,,,,,,,,,,,,\"measured: 24,9g8 is not a number\"",
            &format!("m.csv,3,b3,25 H7,25,25.000,25.021,25.000,0,GOOD,,,{H7},,"),
        ],
    );
}

#[test]
fn what_is_not_judged_is_never_good() {
    check("id,measured\nb1,25.012\n", 1, &["m.csv,2,b1,,,,,25.012,,,,,,,not judged: no callout given"]);
    check(
        "id;callout;measured\nb1;25 H7;25.012\nb2;;25.012\n",
        1,
        &[
            &format!("m.csv,2,b1,25 H7,25,25.000,25.021,25.012,12,GOOD,,,{H7},,"),
            "m.csv,3,b2,,,,,25.012,,,,,,,not judged: no callout given",
        ],
    );
}

#[test]
fn values_of_another_quantity_are_warned_of() {
    for (measured, doubt) in [
        ("635", "measured value is 25.4 times the nominal size: was it converted from inch twice?"),
        ("0.984", "measured value is the nominal size divided by 25.4: is it in inch?"),
        ("50", "measured value is twice the nominal size: was a diameter taken for a radius?"),
        ("12.5", "measured value is half the nominal size: is it a radius?"),
    ] {
        let (_, rows) = csv("m.csv", format!("callout;measured\n25 H7;{measured}\n").as_bytes());
        assert!(rows[0].ends_with(&format!(",{doubt},")), "{rows:?}");
    }
}

#[test]
fn unknown_classes_and_sizes_tell_the_way_out() {
    let (code, rows) = csv("m.csv", b"callout;measured\n25 H99;25\n3200 H7;3200\n24 T7;24\n");
    assert_eq!(code, 1);
    assert!(rows[0].contains("H99 is not an ISO 286 tolerance class: the grades are 01 0 1"), "{}", rows[0]);
    assert!(rows[1].contains("3200 mm is beyond ISO 286, which ends at 3150 mm"), "{}", rows[1]);
    assert!(rows[2].contains("it is defined over 24 up to 3150 mm"), "{}", rows[2]);
}

#[test]
fn broken_files_are_named_and_the_others_go_on() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| {
        std::fs::File::create(folder.path().join(name))
            .and_then(|mut file| std::io::Write::write_all(&mut file, bytes))
            .unwrap();
    };
    write("empty.csv", b"");
    write("garbage.csv", &[0xff, 0x00, 0x81, 0x1b, 0x07, 0x90].repeat(50));
    write("good.csv", b"callout;measured\n25 H7;25.012\n");
    write("TCHPR421.TXT", b"Measuring log");
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    std::fs::File::create(folder.path().join("huge.csv")).unwrap().set_len(200 << 20).unwrap();
    let files = ["empty.csv", "garbage.csv", "missing.csv", "folder", "huge.csv", "TCHPR421.TXT", "good.csv"];
    let answer = run(folder.path(), &files);
    assert_eq!(answer.code, 1);
    assert_eq!(
        answer.err.lines().collect::<Vec<_>>(),
        [
            "empty.csv:1: the file is empty",
            "garbage.csv:1: not a file of a known format",
            "fitcheck: no such file or folder: missing.csv",
            "fitcheck: this is a folder, not a file: folder",
            "huge.csv:1: not a file of a known format",
            "TCHPR421.TXT:1: not a measuring log: no title line with the number of a measuring cycle",
        ]
    );
    assert!(answer.out.contains("good.csv:2"), "{}", answer.out);
    assert!(answer.out.ends_with("7 rows: 1 GOOD, 6 not usable\n"), "{}", answer.out);
    let mut arguments = vec!["--format", "csv"];
    arguments.extend(files);
    assert_eq!(run(folder.path(), &arguments).out.lines().count(), 8);
}

#[test]
fn problems_have_file_line_and_column_on_standard_error() {
    let folder = tempfile::tempdir().unwrap();
    let text = "id;callout;measured;remark\nb1;25 H7;25.0l2\nb2;25 H7\nb3;25 H7;0.984\nb4;25 H7;25.012;fine\n";
    std::fs::File::create(folder.path().join("m.csv"))
        .and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes()))
        .unwrap();
    let answer = run(folder.path(), &["m.csv"]);
    assert_eq!(answer.code, 1);
    assert_eq!(
        answer.err,
        "m.csv:1: warning: columns skipped: 4 (remark)\n\
         m.csv:2:3: measured: 25.0l2 is not a number\n\
         m.csv:3: expected 4 cells, found 2\n\
         m.csv:4: warning: measured value is the nominal size divided by 25.4: is it in inch?\n"
    );
    assert_eq!(
        answer.out,
        "file:line  id  callout  measured mm  limits mm         deviation µm  verdict                  position  source\n\
         m.csv:4    b3  25 H7          0.984  25.000 to 25.021        -24016  REWORK, remove 24016 µm            ISO 286, over 18 up to 30 mm\n\
         m.csv:5    b4  25 H7         25.012  25.000 to 25.021           +12  GOOD                               ISO 286, over 18 up to 30 mm\n\
         4 rows: 1 GOOD, 1 REWORK, 2 not usable\n"
    );
}

#[test]
fn a_column_that_may_have_the_callouts_is_named_where_nothing_gives_limits() {
    let folder = tempfile::tempdir().unwrap();
    let told = "1: warning: column 2 (Quota) looks as if it held the callouts, but its name is not known: \
                name it callout, or give its number with --columns, such as callout=2\n";
    let err = |text: &str| {
        std::fs::write(folder.path().join("m.csv"), text).unwrap();
        run(folder.path(), &["m.csv"]).err
    };
    let unknown = "Pezzo;Quota;Valore misurato\nP1;25 H7;25,01\nP2;30 g6;29,99\n";
    assert!(err(unknown).contains(told), "{}", err(unknown));
    let mut batch = Command::cargo_bin("fitcheck").unwrap();
    let batch = batch.args(["batch", "-"]).write_stdin(unknown).output().unwrap();
    let batch = String::from_utf8(batch.stderr).unwrap();
    assert!(batch.contains(told), "{batch}");
    for known in [
        // The callouts are known: the other column may be of the mating part.
        "Pezzo;Quota;Tolleranza;Valore misurato\nP1;25 g6;25 H7;25,01\n",
        "Pezzo;Quota;Min;Max;Valore misurato\nP1;25 H7;25;25,021;25,01\n",
        // Nothing in it is a callout.
        "Pezzo;Quota;Valore misurato\nP1;17-3;25,01\n",
    ] {
        assert!(!err(known).contains("looks as if"), "{known}: {}", err(known));
    }
}

#[test]
fn json_has_the_same_names_and_exact_figures() {
    let folder = tempfile::tempdir().unwrap();
    let text = "id;callout;measured\nb\"1;25 H7;24.9979995\nb2;25 H7;x\nb3;25 H7;24.997999\n";
    std::fs::File::create(folder.path().join("m.csv"))
        .and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes()))
        .unwrap();
    let answer = run(folder.path(), &["--format", "json", "m.csv"]);
    assert_eq!(answer.code, 1);
    let rows: Vec<serde_json::Value> = serde_json::from_str(&answer.out).unwrap();
    for row in &rows {
        let names: BTreeSet<&str> = row.as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(names, HEADER.split(',').chain(HOW.split(',').skip(1)).collect());
    }
    assert_eq!(rows[0]["error"], "measured: 24.9979995 is finer than a nanometre");
    assert_eq!(rows[1]["line"], 3);
    assert_eq!(rows[1]["status"], serde_json::Value::Null);
    assert_eq!((&rows[2]["measured_mm"], &rows[2]["deviation_um"]), (&24.997_999.into(), &(-2.001).into()));
    assert_eq!((&rows[2]["status"], &rows[2]["remove_um"]), (&"REWORK".into(), &2.001.into()));
}

#[test]
fn every_sample_log_is_judged_on_the_command_line() {
    let mut expected = csv::Reader::from_path(samples().join("expected.csv")).unwrap();
    let expected: Vec<csv::StringRecord> = expected.records().collect::<Result<_, _>>().unwrap();
    let mut files: Vec<&str> = expected.iter().map(|row| &row[0]).collect();
    files.dedup();
    let mut arguments = vec!["--format", "csv"];
    arguments.extend(&files);
    let answer = run(&samples(), &arguments);
    assert_eq!(answer.code, 11);
    assert_eq!(answer.err, "");
    let mut rows = csv::Reader::from_reader(answer.out.as_bytes());
    let rows: Vec<csv::StringRecord> = rows.records().collect::<Result<_, _>>().unwrap();
    assert_eq!(rows.len(), expected.len());
    for (row, expected) in rows.iter().zip(&expected) {
        assert_eq!(&row[0], &expected[0]);
        assert_eq!((&row[9], &row[10], &row[11]), (&expected[9], &expected[10], &expected[15]), "{}", &row[0]);
        assert_eq!(&row[14], "", "{}", &row[0]);
    }
}

/// The class in the expected values gives the limits that the log gives.
#[test]
fn limits_of_the_sample_logs_are_those_of_their_classes() {
    let mut compared = 0;
    for row in csv::Reader::from_path(samples().join("expected.csv")).unwrap().records() {
        let row = row.unwrap();
        if row[3].is_empty() {
            continue;
        }
        let limits = Sources::default().limits(&row[3].parse().unwrap(), None).unwrap();
        assert_eq!((limits.minimum(), limits.maximum()), (row[5].parse().unwrap(), row[6].parse().unwrap()), "{row:?}");
        compared += 1;
    }
    assert_eq!(compared, 14);
}

#[test]
fn encodings_line_ends_and_byte_order_marks_do_not_matter() {
    let text = "Teil;Passung;Istmaß\r\nBüchse;25 H7;25,012\r\n";
    let expected = (0, vec![format!("m.csv,2,Büchse,25 H7,25,25.000,25.021,25.012,12,GOOD,,,{H7},,")]);
    assert_eq!(csv("m.csv", text.as_bytes()), expected);
    assert_eq!(csv("m.csv", format!("\u{feff}{text}").as_bytes()), expected);
    assert_eq!(csv("m.csv", text.replace("\r\n", "\n").as_bytes()), expected);
    assert_eq!(csv("m.csv", b"Teil;Passung;Istma\xdf\r\nB\xfcchse;25 H7;25,012\r\n"), expected);
}

#[test]
fn wrong_usage_is_told() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(run(folder.path(), &[]).code, 2);
    assert_eq!(run(folder.path(), &["--format", "xml", "m.csv"]).code, 2);
    assert_eq!(run(folder.path(), &["--time", "yesterday", "m.csv"]).code, 2);
}

#[test]
fn own_tables_come_first_and_say_where_they_differ() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        std::fs::File::create(folder.path().join(name))
            .and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes()))
            .unwrap();
    };
    write(
        "own.tab",
        "BEGIN OWN .TAB\nNR   BEREICH H7      U1\n0    30      +40     +5\n1            +10     -5\n[END]\n",
    );
    write("m.csv", "callout;measured\n25 H7;25.03\n25 U1;25.006\n25 g6;24.99\n");
    let answer = run(folder.path(), &["--tables", ".", "--format", "csv", "m.csv"]);
    let rows: Vec<&str> = answer.out.lines().skip(1).map(|row| row.strip_suffix(",false,,,,,,").unwrap()).collect();
    assert_eq!(
        rows,
        [
            "m.csv,2,,25 H7,25,25.010,25.040,25.030,30,GOOD,,,\"table own.tab, over 0 up to 30 mm\",ISO 286 has 0 / +21 µm here,",
            "m.csv,3,,25 U1,25,24.995,25.005,25.006,6,SCRAP,,,\"table own.tab, over 0 up to 30 mm\",,",
            "m.csv,4,,25 g6,25,24.980,24.993,24.990,-10,GOOD,,,\"ISO 286, over 18 up to 30 mm\",,",
        ],
        "{}",
        answer.err
    );
    assert_eq!(answer.code, 11);
}

/// The program reads what it writes.
#[test]
fn its_own_csv_is_read_to_the_same_verdicts() {
    let (_, first) = csv("m.csv", b"id;callout;measured\nb1;25 H7;25.012\nb2;20 g6;19.9975\nb3;25 H7;25.0215\n");
    let (code, second) = csv("m.csv", format!("{HEADER}\n{}\n", first.join("\n")).as_bytes());
    assert_eq!((code, first), (11, second));
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig { cases: 64, failure_persistence: None, ..Default::default() })]

    /// With the program's tables: as many answers as rows, whatever the rows hold.
    #[test]
    fn rows_are_records_unjudged_or_problems(rows in proptest::collection::vec(
        "(b[0-9]|);(25 ?[HKgZ][5-8]|Ø?[0-9]{1,3},5 h7|25|x|);(2[45][.,][0-9]{1,7}|[0-9]{1,3}|-3|abc|)", 1..30)
    ) {
        let text = format!("id;callout;measured\n{}\n", rows.join("\n"));
        let imported = fitcheck::exchange::import("m.csv", text.as_bytes(), &Sources::default(), jiff::civil::date(2025, 1, 1).at(0, 0, 0, 0));
        let filled = rows.iter().filter(|row| *row != ";;").count().max(1);
        proptest::prop_assert_eq!(imported.rows, filled);
        proptest::prop_assert_eq!(imported.records.len() + imported.unjudged.len() + imported.errors.len(), filled);
    }
}

#[test]
fn a_simulated_value_stays_simulated_through_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::cargo_bin("fitcheck").unwrap();
    let asked = ["check", "25 H7", "--simulate", "--format", "csv"];
    let output = command.current_dir(folder.path()).args(asked).output().unwrap();
    std::fs::File::create(folder.path().join("simulated.csv"))
        .and_then(|mut file| std::io::Write::write_all(&mut file, &output.stdout))
        .unwrap();
    let answer = run(folder.path(), &["--format", "csv", "simulated.csv"]);
    assert!(answer.out.contains("simulated: nothing was measured"), "{}", answer.out);
}
