//! Files from the field, each with its right answer: verdict, exit code, or refusal with its reason. They were rebuilt small after public
//! bug reports, exports and manuals; each stands for a whole kind.

use fitcheck::exchange::{ImportInputs, import, read_plan};
use fitcheck::session::{CheckCommand, Command, Session};
use fitcheck::tolerance::Sources;
use fitcheck::words::Language;
use jiff::civil::DateTime;

use crate::field_ways::place::{Place, by_batch, by_plan, converted, data, judged, walked};
use crate::session_walk::{now, send};

#[test]
fn an_inch_in_a_column_or_in_a_comment_is_25_4_mm() {
    for file in ["inch_column.csv", "inch_comment.csv"] {
        judged(file, 11, &["A 25.42286 SCRAP"]);
        by_batch(file, 11, &["A 25.421 SCRAP"]);
        converted(file, 0, &["A 25.4 H7"], &[]);
    }
}

#[test]
fn micrometres_in_a_row_below_the_names_are_micrometres() {
    judged("units_row_um.csv", 11, &["A1 25.012 GOOD", "A2 25.030 SCRAP"]);
    by_batch("units_row_um.csv", 11, &["A1 GOOD", "A2 SCRAP"]);
    converted("units_row_um.csv", 0, &["A1 25 H7", "A2 25 H7"], &[]);
}

#[test]
fn of_two_measured_columns_none_is_taken() {
    let place = Place::of(&["two_measured.csv"]);
    let words = "columns 3 (measured), 4 (measured after honing) may each be the measured value";
    for args in [
        &["import", "two_measured.csv"][..],
        &["batch", "two_measured.csv"],
        &["report", "two_measured.csv", "-o", "r.html"],
    ] {
        let said = place.say(args);
        assert!(said.code == 1 && format!("{}{}", said.out, said.err).contains(words), "{}", said.all());
    }
    // What should be measured is not in doubt.
    converted("two_measured.csv", 0, &["A 25 H7"], &[]);
}

#[test]
fn two_parts_without_serial_numbers_are_not_one_good_part() {
    let told = by_plan(
        "two_parts.csv",
        "two_parts.plan.toml",
        11,
        &["BORE_A 25.030 SCRAP", "SEAT 19.990 GOOD", "BORE_A 25.012 GOOD", "SEAT 19.990 GOOD"],
    );
    let words =
        "BORE_A has values that contradict each other: 25.030 SCRAP (two_parts.csv:2), 25.012 GOOD (two_parts.csv:4)";
    assert!(told.contains(words), "{told}");
    converted("two_parts.csv", 1, &["BORE_A ", "SEAT ", "BORE_A ", "SEAT "], &["column callout is missing"]);
}

#[test]
fn part_feature_operator_and_serial_number_of_a_row_are_those_of_the_journal() {
    judged("one_part.csv", 0, &["B2 12.0028 GOOD"]);
    converted("one_part.csv", 0, &["B2 12 H6"], &[]);
    let place = Place::of(&["one_part.csv"]);
    assert_eq!(place.say(&["import", "one_part.csv", "--record"]).code, 0);
    let listed = place.say(&["journal", "list", "--format", "csv"]);
    for words in ["P001", "B2", "JJ", "S-7", "12.0028"] {
        assert!(listed.out.contains(words), "{words}\n{}", listed.all());
    }
    // And by the window.
    let mut session = Session::new(Language::En);
    crate::session_walk::begin_records(&mut session);
    crate::session_walk::open_journal(&mut session, 7);
    let bytes = std::fs::read(data("one_part.csv")).unwrap();
    let read = import("one_part.csv", &bytes, &Sources::default(), now());
    let effects = send(
        &mut session,
        Command::Check(CheckCommand::Imported { name: "one_part.csv".to_owned(), result: Ok(Box::new(read)) }),
    );
    let (_, entries) = crate::session_walk::kept(&effects);
    let about = &entries[0].about;
    let said = [&about.part, &about.feature, &about.who, &about.serial].map(String::as_str);
    assert_eq!((entries.len(), said), (1, ["P001", "B2", "JJ", "S-7"]));
}

#[test]
fn a_coordinate_and_a_position_of_the_same_name_are_not_that_size() {
    let (file, plan) = ("axes.csv", "axes.plan.toml");
    let told = by_plan(
        file,
        plan,
        1,
        &["BORE_A 25.012 GOOD", "RING_B 203.212 GOOD", "FLAT_C 0.021 -", "BORE_A 40.004 -", "BORE_A 0.032 -"],
    );
    for words in ["X: not a size of a hole or shaft", "TP: not a size of a hole or shaft"] {
        assert!(told.contains(words), "{words}\n{told}");
    }
    assert!(told.contains("read for all values: PART NAME PLATE-7, SER NUMBER 3"), "{told}");
    // Without a plan each is judged by its own limits.
    let own =
        ["BORE_A 25.012 GOOD", "RING_B 203.212 GOOD", "FLAT_C 0.021 GOOD", "BORE_A 40.004 GOOD", "BORE_A 0.032 GOOD"];
    judged(file, 0, &own);
    by_batch(file, 0, &own);
    converted(
        file,
        1,
        &["BORE_A 25 +0.021 0", "RING_B 203.2 ±0.1", "FLAT_C 0.05"],
        &["BORE_A is skipped: X", "BORE_A is skipped: TP"],
    );
}

#[test]
fn a_bore_along_x_has_no_position_for_a_cycle() {
    let file = std::fs::read_to_string("tests/data/qif/minimal_bore_25H7_limitsandfits.qif").unwrap();
    let text = file.replace("<Normal>0 0 1<", "<Normal>1 0 0<").replace("BORE1 25 H7", "BORE1");
    let sources = Sources::default();
    let document = read_plan("a.qif", text.as_bytes(), ImportInputs::new(&sources, DateTime::default())).unwrap();
    let toml = document.draft.to_toml();
    assert!(!toml.contains("x = ") && toml.contains("callout = \"25 H7\""), "{toml}");
    let why = "BORE1: no position was taken over: it lies along 1 0 0";
    assert!(document.remarks.iter().any(|remark| remark.to_string().contains(why)));
}

#[test]
fn upper_and_lower_deviations_in_columns_are_limits() {
    let rows = ["A1 25.012 GOOD", "A2 25.030 OUT OF LIMITS", "A3 19.990 GOOD"];
    judged("updown.csv", 13, &rows);
    by_batch("updown.csv", 13, &["A1 25.021 GOOD", "A2 OUT OF LIMITS", "A3 19.993 GOOD"]);
    converted(
        "updown.csv",
        1,
        &["A1 25 +0.021 0", "A2 25 +0.021 0", "A3 20 -0.007 -0.02"],
        &["may be a hole or a shaft"],
    );
}

#[test]
fn a_tolerance_beside_a_nominal_size_is_a_class_or_deviations() {
    let rows = ["A1 25.012 GOOD", "A2 19.990 GOOD", "A3 12.010 GOOD", "A4 12.010 GOOD", "A5 12.010 GOOD"];
    judged("nominal_class.csv", 0, &rows);
    by_batch(
        "nominal_class.csv",
        0,
        &["A1 25.021 GOOD", "A2 19.993 GOOD", "A3 11.980 12.020 GOOD", "A4 11.980 12.010 GOOD"],
    );
    let callouts = ["A1 25 H7", "A2 20 g6", "A3 12 ±0.02", "A4 12 +0.01 -0.02", "A5 12 +0.01 -0.02"];
    converted("nominal_class.csv", 1, &callouts, &["line 4: 12 ±0.02 may be a hole or a shaft"]);
}

#[test]
fn limits_without_hole_or_shaft_are_met_or_not_and_rework_or_scrap_stays_open() {
    judged("pm.csv", 13, &["A1 12.010 GOOD", "A2 12.050 OUT OF LIMITS"]);
    by_batch("pm.csv", 13, &["A1 GOOD", "A2 OUT OF LIMITS"]);
    judged("within.dfq", 0, &["Hole 12.010 GOOD"]);
    converted("within.dfq", 1, &["Hole 12 +0.02/-0.02"], &["may be a hole or a shaft"]);
    let outside = std::fs::read_to_string(data("within.dfq")).unwrap().replace("\n12.01", "\n12.05");
    let read = import("within.dfq", outside.as_bytes(), &Sources::default(), now());
    assert_eq!(read.records[0].verdict.status().word(), "OUT OF LIMITS");
}

#[test]
fn a_header_below_eleven_lines_is_found_and_each_line_is_told_once() {
    let rows =
        ["Width_1 18.5042 GOOD", "Flat_1 0.031 OUT OF LIMITS", "Dia_01 25.0123 GOOD", "Dia_02 25.025 OUT OF LIMITS"];
    judged("preamble.csv", 13, &rows);
    by_batch("preamble.csv", 13, &["Width_1 GOOD", "Flat_1 OUT OF LIMITS", "Dia_01 GOOD", "Dia_02 OUT OF LIMITS"]);
    converted(
        "preamble.csv",
        1,
        &["Width_1 18.5 ±0.02", "Flat_1 0.02", "Dia_01 25 +0.021 0", "Dia_02 25 +0.021 0"],
        &["Summary is skipped"],
    );
    let told = Place::of(&["preamble.csv"]).say(&["import", "preamble.csv"]).err;
    for words in
        ["4711", "D-200", "B-7", "2026-07-10", "14:32:05", "0042", "PLATE_OP20", "20.1 C", "2 out of tolerance"]
    {
        assert_eq!(told.matches(words).count(), 1, "{words}\n{told}");
    }
}

#[test]
fn samples_side_by_side_are_parts_and_each_has_its_verdict() {
    judged(
        "fir.xlsx",
        1,
        &[
            "Bore 25.012 GOOD",
            "Bore 25.004 GOOD",
            "Bore 25.030 SCRAP",
            "Bore 24.998 REWORK",
            "Bore 25.000 GOOD",
            "Distance 140.050 GOOD",
            "Distance 140.010 GOOD",
            "Distance 139.950 GOOD",
            "Distance 140.000 GOOD",
            "Distance 139.900 GOOD",
            "Flatness 0.100 GOOD",
            "Flatness 0.080 GOOD",
            "Flatness 0.110 GOOD",
            "Flatness 0.200 GOOD",
            "Flatness 0.300 OUT OF LIMITS",
            "- - -",
            "- - -",
            "- - -",
            "- - -",
            "- - -",
            "Bore dia 12.009 GOOD",
            "Bore dia 12.004 GOOD",
            "Bore dia 12.020 OUT OF LIMITS",
            "Bore dia 12.000 GOOD",
            "Bore dia 12.018 GOOD",
        ],
    );
    let said = Place::of(&["fir.xlsx"]).say(&["import", "fir.xlsx", "--format", "csv"]);
    assert!(!said.all().contains("is not the name of a size"), "{}", said.all());
    for words in ["FLANGE", "4711/B", "ACME", "FINAL INSPECTION REPORT"] {
        assert_eq!(said.err.matches(words).count(), 1, "{words}\n{}", said.err);
    }
    assert!(said.out.contains("4711-B!L10: measured: NG is not a number"), "{}", said.out);
    let callouts = ["Bore 25 H7", "Distance 140 ±0.13", "Flatness 0.25", "Thread 10-32 UNF", "Bore dia 12 +0.018 0"];
    converted("fir.xlsx", 1, &callouts, &["10-32 UNF is a thread"]);
    // By a plan five samples are five parts: no value of one contradicts that of another, and each part lacks what it lacks.
    let place = Place::of(&["fir.xlsx"]);
    let plan = "fitcheck_plan = 1\n[[feature]]\nname = \"Bore\"\ncallout = \"25 H7\"\n";
    fitcheck::files::write(&place.0.path().join("p.toml"), plan.as_bytes()).unwrap();
    let said = place.say(&["import", "fir.xlsx", "--plan", "p.toml"]);
    assert!(!said.err.contains("contradict"), "{}", said.all());
}

#[test]
fn a_number_in_a_cell_of_a_workbook_has_no_decimal_sign() {
    judged("textnum.xlsx", 11, &["A1 25.012 GOOD", "A2 25.0299 SCRAP", "A3 24.998 REWORK"]);
    converted("textnum.xlsx", 0, &["A1 25 H7", "A2 25 H7", "A3 25 H7"], &[]);
}

#[test]
fn a_tolerance_in_k2151_is_no_class_and_warns_of_no_value() {
    let rows = ["4A Gauss 3.220291 GOOD", "4A Gauss 3.260195 SCRAP"];
    let told = by_plan("k2151.dfq", "k2151.toml", 11, &rows);
    assert!(told.matches("k2151.dfq:21: warning").count() <= 1 && !told.contains("K2151"), "{told}");
    judged("k2151.dfq", 13, &["4A Gauss 3.220291 GOOD", "4A Gauss 3.260195 OUT OF LIMITS"]);
    converted("k2151.dfq", 1, &["4A Gauss 3.23 +0.025/-0.025"], &["may be a hole or a shaft"]);
    assert_eq!(walked("k2151.dfq", "k2151.toml"), ["4A Gauss 3.220291 GOOD", "4A Gauss 3.260195 SCRAP"]);
}

#[test]
fn printed_reports_have_their_answers() {
    let rows =
        ["CIR5 X 0.017 GOOD", "CIR5 Y 0.008 GOOD", "CIR5 25.012 GOOD", "CYL1 30.018 OUT OF LIMITS", "DIST1 4.271 GOOD"];
    judged("housing.txt", 13, &rows);
    converted(
        "housing.txt",
        1,
        &["CIR5 25 +0.021/0", "CYL1 30 +0.01/-0.01", "DIST1 4.25 +0.25/-0.1"],
        &["CIR5 X is skipped: LOCATION X: not a size of a hole or shaft"],
    );
    judged(
        "two_features.txt",
        1,
        &[
            "FEATURE NO 1 25.012 GOOD",
            "FEATURE NO 1 X 40.003 -",
            "FEATURE NO 1 Y 29.998 -",
            "FEATURE NO 2 71.9072 OUT OF LIMITS",
        ],
    );
    let features = ["FEATURE NO 1 25 +0.021/-0.021", "FEATURE NO 2 71 +0.1/-0.1"];
    converted("two_features.txt", 1, &features, &["FEATURE NO 1 X is skipped"]);
}

#[test]
fn a_remark_over_lines_that_look_like_rows_is_refused_everywhere() {
    let why = ["a quotation mark is not closed on this line", "this line may be a row or a remark"];
    judged("quoted_lines.csv", 1, &["- - -", "- - -", "- - -", "D 25.011 GOOD"]);
    by_batch("quoted_lines.csv", 1, &["D 25.021 GOOD"]);
    let place = Place::of(&["quoted_lines.csv"]);
    for command in ["import", "batch"] {
        let said = place.say(&[command, "quoted_lines.csv"]);
        assert!(why.iter().all(|words| said.all().contains(words)), "{}", said.all());
    }
    converted("quoted_lines.csv", 1, &["D 25 H7"], &why);
}

#[test]
fn what_is_not_of_the_plan_and_out_of_its_own_limits_is_told_beside_a_good_part() {
    let folder = tempfile::tempdir().unwrap();
    let report = include_str!("../data/pcdmis/housing.txt");
    assert!(report.contains("30.018      0.018      0.008 ---->"), "the cylinder is out");
    let plan = "fitcheck_plan = 1\n[[feature]]\nname = \"CIR5\"\ncallout = \"25 +0.021 0\"\nfeature = \"hole\"\n";
    for (name, text) in [("p.txt", report), ("p.toml", plan)] {
        let mut file = std::fs::File::create(folder.path().join(name)).unwrap();
        std::io::Write::write_all(&mut file, text.as_bytes()).unwrap();
    }
    let mut command = assert_cmd::cargo::cargo_bin_cmd!("fitcheck");
    let run = command
        .current_dir(folder.path())
        .args(["report", "--plan", "p.toml", "p.txt", "-o", "-", "--format", "markdown"]);
    let page = String::from_utf8(run.output().unwrap().stdout).unwrap().replace('\\', "");
    assert!(page.contains("p.txt, line 14: not of the plan, and above the upper limit of its file, 30.01"), "{page}");
    assert!(!page.contains("line 9: not of the plan, and") && page.contains("GOOD**: 1 measured"), "{page}");
}
