//! Files that are wrong or may be read in two ways: each of them once got a green answer without a word.

use std::path::Path;

use assert_cmd::Command;

/// The answer of the program: exit code, standard output, standard error.
struct Answer {
    code: i32,
    out: String,
    err: String,
}

impl Answer {
    /// Both streams.
    fn said(&self) -> String {
        format!("{}{}", self.out, self.err)
    }
}

/// A call in a folder that holds one file.
#[track_caller]
fn answer(name: &str, text: &str, arguments: &[&str]) -> Answer {
    let folder = tempfile::tempdir().unwrap();
    std::io::Write::write_all(&mut std::fs::File::create(folder.path().join(name)).unwrap(), text.as_bytes()).unwrap();
    answer_in(folder.path(), arguments)
}

fn answer_in(folder: &Path, arguments: &[&str]) -> Answer {
    let mut command = Command::cargo_bin("fitcheck").unwrap();
    let output = command.current_dir(folder).args(arguments).output().unwrap();
    Answer {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

fn import(text: &str) -> Answer {
    answer("m.csv", text, &["import", "m.csv", "--format", "csv"])
}

fn batch(text: &str) -> Answer {
    answer("m.csv", text, &["batch", "m.csv"])
}

/// Both `import` and `batch` refuse the file with these words.
#[track_caller]
fn refused(text: &str, words: &str) {
    let said = import(text);
    assert!(said.code == 1 && said.out.contains(words), "{text}\n{}{}", said.out, said.err);
    let said = batch(text);
    assert!(said.code == 1 && said.said().contains(words), "{text}\n{}{}", said.out, said.err);
}

/// Both judge every row: the measured values in millimetres.
#[track_caller]
fn measured(text: &str, expected: &[&str]) {
    let said = import(text);
    let column = |line: &str| line.split(',').nth(7).map(str::to_owned);
    let values: Vec<String> = said.out.lines().skip(1).filter_map(column).collect();
    assert_eq!(values, expected, "{text}\n{}{}", said.out, said.err);
    let said = batch(text);
    assert!(said.code != 1, "{text}\n{}{}", said.out, said.err);
}

#[test]
fn a_nominal_size_beside_a_class_and_a_measured_value_before_it_is_not_guessed() {
    refused("25;24.99;H7\n25;24.995;H7\n", "columns 1, 2 may each be the measured value");
    refused("A1;25;24.99;H7\nA2;25;24.995;H7\n", "columns 2, 3 may each be the measured value");
    refused("1;25.01;25 H7\n2;25.02;25 H7\n", "columns 1, 2 may each be the measured value");
    measured("A1;25;H7;25.004\nA2;25;H7;25.005\n", &["25.004", "25.005"]);
    measured("1;25;H7;25.004\n2;25;H7;25.005\n", &["25.004", "25.005"]);
}

#[test]
fn inch_is_understood_wherever_it_stands_in_a_name() {
    for name in [
        "measured_in",
        "measured (in.)",
        "measured (Duim)",
        "measured (pollice)",
        "measured (\u{2033})",
        "measured [\u{201d}]",
        "measured ('')",
        "[inch] measured",
        "measured [inch] avg",
        "measured (inch, 20 C)",
        "measured (20 \u{b0}C, inch)",
        "measured.inch",
        "measuredInch",
        "measured pollici",
        "measured_zoll",
        "measured duim",
        "gemeten in duim",
        "measured [Inches]",
        "measured (average) [in]",
        "inch measured",
        "measured [inch",
    ] {
        measured(&format!("id;callout;{name}\n1;25.4 H7;1.0004\n"), &["25.41016"]);
    }
}

#[test]
fn what_may_be_a_unit_and_is_none_that_is_known_is_refused() {
    for (name, unit) in [
        ("measured m", "m"),
        ("measured_m", "m"),
        ("measured [m]", "m"),
        ("measured cm", "cm"),
        ("measured [\u{b5}]", "\u{b5}"),
        ("measured [mm/1000]", "mm/1000"),
        ("measured [1/1000 mm]", "1/1000 mm"),
        ("measured [0.01 mm]", "0.01 mm"),
        ("measured [10 \u{b5}m]", "10 \u{b5}m"),
        ("measured [mm, inch]", "mm, inch"),
        ("measured_mm [inch]", "inch, mm"),
        ("measured [mm] [inch]", "mm, inch"),
        ("[cm] measured", "cm"),
        ("measured (M)", "M"),
        ("measured (10mm)", "10mm"),
        ("measured (mm2)", "mm2"),
        ("measured (pouces)", "pouces"),
        ("measured (1/10)", "1/10"),
        ("measured hm", "hm"),
        ("measured_thou", "thou"),
        ("measured mils", "mils"),
    ] {
        refused(&format!("id;callout;{name}\n1;25.4 H7;25.405\n"), &format!("unknown unit {unit}: use mm"));
    }
}

#[test]
fn a_name_with_a_known_word_that_is_no_unit_is_read_as_before() {
    for name in [
        "measured",
        "measured (average)",
        "measured (mean)",
        "Istma\u{df} (Mittelwert)",
        "gemeten (gemiddeld)",
        "misurato (media)",
        "measured (mm)",
        "measured [mm] avg",
        "[mm] measured",
        "measured (mm, 20 \u{b0}C)",
        "measured (20 \u{b0}C)",
        "measured (2)",
        "Bore \u{d8} measured in mm",
        "measured value A",
        "measured diameter 1",
        "measured, mm",
        "measured/mm",
        "measured (\u{d8})",
        "measured (P1)",
        "measured (bore A)",
        "measured (1st)",
        "measured (mean of 3, mm)",
        "measured (in the machine)",
        "measured (by CMM)",
        "measured (at 20 \u{b0}C)",
        "measured (max)",
        "measured [mm] (mean of 3)",
        "measured (diameter)",
        "Messwert (Durchmesser)",
        "\u{d8}",
        "mm",
        "diameter (measured)",
    ] {
        measured(&format!("id;callout;{name}\n1;25.4 H7;25.405\n"), &["25.405"]);
    }
    measured("id;callout;measured_um\n1;25.4 H7;25405\n", &["25.405"]);
    measured("id;callout;Istma\u{df} (\u{b5}m)\n1;25.4 H7;25405\n", &["25.405"]);
}

#[test]
fn unknown_names_above_the_rows_still_have_their_unit() {
    measured("p;q;r [inch]\n1;25.4 H7;1.0004\n", &["25.41016"]);
    refused("p;q;r [cm]\n1;25.4 H7;2.5405\n", "unknown unit cm: use mm");
}

#[test]
fn a_decimal_comma_among_numbers_with_a_point_is_not_taken_for_two_cells() {
    let rows = "id,callout,measured,pieces\n1,25 H7,25.012,3\n3,25 H7,25.013,4\n";
    for row in ["2,25 H7,25,030\n", "2,25 H7,25,012\n", "2,25 H7,25,03\n", "2,25 H7,25,12\n"] {
        refused(&format!("{rows}{row}"), "may be one number with a decimal comma");
    }
    measured(&format!("{rows}2,25 H7,25,5\n"), &["25.012", "25.013", "25.000"]);
}

#[test]
fn a_name_that_says_another_measurement_is_not_the_measured_value() {
    for name in [
        "simulated measured value",
        "previous measured",
        "measured (previous)",
        "expected measurement",
        "measured radius",
        "measured roughness",
        "measured depth",
        "vorheriger Messwert",
        "erwarteter Messwert",
        "gemessen Radius",
        "vorige meting",
        "gemeten ruwheid",
        "gemeten diepte",
        "misurato precedente",
        "rugosit\u{e0} misurata",
        "raggio misurato",
    ] {
        measured(&format!("id;callout;{name};diameter\n1;25 H7;12.5;25.012\n"), &["25.012"]);
        refused(&format!("id;callout;{name}\n1;25 H7;25.012\n"), "no column of measured values");
    }
    // Brackets before another word, or before a unit, are part of the name.
    for name in
        ["(max) measured", "measured (max) [mm]", "measured (deviation) value", "measured (max", "\u{d8} (nominal)"]
    {
        refused(&format!("id;callout;{name}\n1;25 H7;25.012\n"), "no column of measured values");
    }
    let nominal = "id;class;\u{d8} (nominal);\u{d8}\n1;H7;25;25.012\n";
    measured(nominal, &["25.012"]);
    // Nor do brackets make a column say nothing that says whether nobody measured.
    let said = import("id;callout;measured;simulated (true/false)\n1;25 H7;25.012;true\n2;25 H7;25.012;maybe\n");
    assert!(said.out.contains("maybe is neither true nor false"), "{}", said.out);
    // These words say nothing against a name of the part.
    let named = import("reference number;callout;measured\nA7;25 H7;25.012\n");
    assert!(named.out.contains(",A7,25 H7,"), "{}", named.out);
}

#[test]
fn batch_names_the_columns_that_it_passes_over() {
    let text = "id;callout;operator;measured;shift\n1;25 H7;JJ;25.012;2\n";
    // The operator is kept with a check.
    let warning = "m.csv:1: warning: columns skipped: 5 (shift)";
    assert_eq!(import(text).err.matches(warning).count(), 1);
    let said = batch(text);
    assert_eq!(said.err.matches(warning).count(), 1, "{}", said.err);
    assert_eq!(said.code, 0);
    assert!(!batch("id;callout;measured\n1;25 H7;25.012\n").err.contains("skipped"));
}

#[test]
fn a_last_line_that_may_be_cut_off_is_told() {
    let rows = "id;callout;measured\n1;25 H7;25.012\n";
    let words =
        "the file ends here without a line end, and 25.0 has fewer decimals than the other values: it may be cut off";
    for text in [format!("{rows}2;25 H7;25.0"), "1;25 H7;25.012\n2;25 H7;25.0".to_owned()] {
        for said in [import(&text), batch(&text)] {
            assert!(said.said().contains(words), "{}{}", said.out, said.err);
            assert_eq!(said.code, 14);
        }
    }
    let comma = "id;callout;measured;pieces\n1;25 H7;25,012;3\n2;25 H7;25";
    assert!(import(comma).out.contains("25 has fewer decimals"), "{}", import(comma).out);
    assert!(batch(comma).err.contains("25 has fewer decimals"), "{}", batch(comma).err);
    for complete in [
        format!("{rows}2;25 H7;25.011"),
        format!("{rows}2;25 H7;25.0\n"),
        format!("{rows}2;25 H7;25.0\r\n"),
        "id;callout;measured;pieces\n1;25 H7;25.012;3\n2;25 H7;25.0;4".to_owned(),
    ] {
        for said in [import(&complete), batch(&complete)] {
            assert!(!said.said().contains("cut off"), "{complete}\n{}{}", said.out, said.err);
        }
    }
}

#[test]
fn a_last_line_of_which_nothing_says_whether_it_is_whole_is_told() {
    let told = |last: &str| format!("the file ends here without a line end: its last value, {last}, may be cut off");
    for (text, last) in [
        ("callout;measured\n25 H7;25.0", "25.0"),
        ("callout;measured\n25 H7;25.012", "25.012"),
        ("callout;measured [inch]\n25 H7;0.984", "0.984"),
        ("measured;callout\n25.012;25 H11\n25.05;25 H1", "25 H1"),
        ("id;callout;measured\n1;25 H7;25.0\n2;25 H7;25.01\n3;25 H7;25.0", "25.0"),
        ("id;callout;measured\n1;25 H7;25\n2;25 H7;25", "25"),
    ] {
        for said in [import(text), batch(text)] {
            assert!(said.said().contains(&told(last)), "{text}\n{}{}", said.out, said.err);
        }
        let json = answer("m.csv", text, &["import", "m.csv", "--format", "json"]).out;
        assert!(json.contains(&told(last)), "{text}: {json}");
        let whole = format!("{text}\n");
        for said in [import(&whole), batch(&whole)] {
            assert!(!said.said().contains("cut off"), "{whole}\n{}{}", said.out, said.err);
        }
    }
    let said = import("callout;measured\n25 H7;25.012");
    assert!(said.code == 0 && said.out.contains("GOOD"), "{}", said.out);
}

#[test]
fn a_row_without_its_date_is_told_and_so_is_an_offset_that_is_not_kept() {
    let text = "id;callout;measured;time\n1;25 H7;25.012;2024-03-14T08:05:09\n2;25 H7;25.011;\n3;25 H7;25.011;2024-03-14T08:05:09+05:00\n";
    let said = import(text).out;
    let lines: Vec<&str> = said.lines().skip(1).collect();
    assert!(!lines[0].contains("time"), "{said}");
    assert!(lines[1].contains("no date and time here: the time of import is used"), "{said}");
    assert!(lines[2].contains("2024-03-14T08:05:09+05:00 is stored as local time without its offset"), "{said}");
    assert!(!import("id;callout;measured\n1;25 H7;25.012\n").out.contains("time of import"));
}

#[test]
fn a_report_as_csv_says_what_it_does_not_hold() {
    let head = ["--title", "T", "--part", "4711", "--order", "8", "--inspector", "JJ"];
    let report = |output: &[&str], more: &[&str]| {
        let call = [&["report", "m.csv", "--time", "2026-11-21T10:42"], output, more].concat();
        answer("m.csv", "id;callout;measured\n1;25 H7;25.012\n2;25 H7;25,0l2\n", &call)
    };
    for output in [["-o", "r.csv"].as_slice(), &["-o", "-", "--format", "csv"]] {
        let said = report(output, &head);
        assert_eq!(said.code, 1);
        let words = "warning: CSV has no place for --title, --part, --order, --inspector: HTML, JSON and PDF do";
        assert!(said.err.contains(words), "{}", said.err);
        assert!(said.err.contains("warning: 1 note is not in the CSV: HTML and JSON contain it"), "{}", said.err);
        let said = report(output, &["--part", "4711"]);
        assert!(said.err.contains("CSV has no place for --part:"), "{}", said.err);
    }
    for output in [["-o", "r.html"].as_slice(), &["-o", "r.json"]] {
        assert!(!report(output, &head).err.contains("CSV"), "{}", report(output, &head).err);
    }
    let complete = ["report", "--check", "25 H7=25.012", "-o", "-", "--format", "csv"];
    assert_eq!(answer("m.csv", "", &complete).err, "");
}

const COORDINATE: [&str; 8] = ["cycle", "427", "--set", "Q263=35", "Q264=45", "Q261=0", "Q267=-1", "Q260=50"];

#[test]
fn contacts_without_heights_are_refused_where_the_height_is_measured() {
    let words = "contact 1 has no height: add a column z to the file";
    let axis =
        |axis: &'static str| [COORDINATE.as_slice(), &[axis, "Q288=0.1", "Q289=-0.1", "--contacts", "c.csv"]].concat();
    let said = answer("c.csv", "x,y\n35,45\n", &axis("Q272=3"));
    assert!(said.code == 1 && said.err.contains(words), "{}{}", said.out, said.err);
    let known = answer("c.csv", "x,y,z\n35,45,0\n", &axis("Q272=3"));
    assert_eq!(known.code, 0, "{}", known.err);
    let aside = [COORDINATE.as_slice(), &["Q272=1", "--contacts", "c.csv"]].concat();
    assert_eq!(answer("c.csv", "x,y\n35,45\n", &aside).code, 0);
    let point = [
        "cycle",
        "444",
        "--set",
        "Q263=35",
        "Q264=45",
        "Q294=0",
        "Q581=0",
        "Q582=0",
        "Q583=1",
        "QS400=0.1-0.1",
        "Q260=50",
        "--contacts",
        "c.csv",
    ];
    let said = answer("c.csv", "x,y\n35,45\n", &point);
    assert!(said.code == 1 && said.err.contains(words), "{}{}", said.out, said.err);
    assert_eq!(answer("c.csv", "x,y,z\n35,45,0\n", &point).code, 0);
}

#[test]
fn a_circle_in_a_plane_with_the_axis_z_needs_heights() {
    let circle = "x,y\n12.505,0\n0,12.505\n-12.505,0\n0,-12.505\n";
    let measured = |plane: &str| {
        answer("c.csv", circle, &["cycle", "G785", "--set", "K=2", "RC=90", plane, "--contacts", "c.csv"])
    };
    assert!(!measured("R=0").err.contains("has no height"), "{}", measured("R=0").err);
    for plane in ["R=1", "R=2"] {
        let said = measured(plane);
        assert!(said.code == 1 && said.err.contains("contact 1 has no height"), "{}{}", said.out, said.err);
    }
}

const BORE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-8 ~\n\
    Q260=+50 ~\nQ275=+25.021 ~\nQ276=+25 ~\nQ281=+0";

/// A program of one cycle.
fn program(axis: &str, cycle: &str) -> String {
    format!("BEGIN PGM main MM\nTOOL CALL 1 {axis}\n{cycle}\nEND PGM main MM\n")
}

/// The program on these contacts.
fn call(program: &str, contacts: &str) -> Answer {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("main.h", program), ("c.csv", contacts)] {
        std::io::Write::write_all(&mut std::fs::File::create(folder.path().join(name)).unwrap(), text.as_bytes())
            .unwrap();
    }
    answer_in(folder.path(), &["run", "main.h", "--contacts", "c.csv"])
}

#[test]
fn a_program_refuses_contacts_without_heights_where_it_measures_them() {
    let words = "has no height: add a column z to the file";
    let point = "TCH PROBE 427 MEASURE COORDINATE ~\nQ263=+35 ~\nQ264=+45 ~\nQ261=+0 ~\nQ320=+0 ~\nQ272=+3 ~\nQ267=-1 ~\n\
                 Q260=+50 ~\nQ281=+0 ~\nQ288=+0.1 ~\nQ289=-0.1";
    let said = call(&program("Z", point), "x,y\n35,45\n");
    assert!(said.code == 1 && said.err.contains(words), "{}{}", said.out, said.err);
    let said = call(&program("Z", point), "x,y,z\n35,45,0\n");
    assert!(!said.err.contains(words), "{}{}", said.out, said.err);
    let circle = "x,y\n12.505,0\n0,12.505\n-12.505,0\n0,-12.505\n";
    let said = call(&program("Z", BORE), circle);
    assert!(said.code == 0 && !said.err.contains(words), "{}{}", said.out, said.err);
    // With the tool axis Y the plane is Z and X.
    let said = call(&program("Y", BORE), circle);
    assert!(said.code == 1 && said.err.contains(words), "{}{}", said.out, said.err);
}

#[test]
fn an_array_of_a_workpiece_has_as_many_numbers_as_it_should() {
    let run = |text: &str, cycle: &[&str]| {
        let call = [&["cycle"], cycle, &["--workpiece", "w.toml"]].concat();
        answer("w.toml", text, &call)
    };
    let bore = ["421", "--set", "Q273=50", "Q274=20", "Q262=25", "Q260=50"];
    for (text, key, found) in [
        ("[bore]\ncentre = [50,0,20]\ndiameter = 25.01\n", "centre", 3),
        ("[bore]\ncentre = [50]\ndiameter = 25.01\n", "centre", 1),
        ("[stud]\ncentre = [50,0,20]\ndiameter = 25.01\n", "centre", 3),
        ("[face]\npoint = [0,0,5,3]\nnormal = [0,0,1]\n", "point", 4),
        ("[face]\npoint = [0,0,5]\nnormal = [0,0,0,1]\n", "normal", 4),
        ("[point]\npoint = [0,0,5,3]\nnormal = [0,0,1]\n", "point", 4),
        ("[point]\npoint = [0,0,5]\nnormal = [0,0]\n", "normal", 2),
        ("[slot]\ncentre = [0,0,5]\nwidth = 8\n", "centre", 3),
        ("[pocket]\ncentre = [0,0,5]\nlengths = [8,8]\n", "centre", 3),
        ("[boss]\ncentre = [0,0]\nlengths = [8,5,8]\n", "lengths", 3),
        ("[bore]\ncentre = [50,20]\ndiameter = 25.01\n[probe]\noffset = [0,1,0,2]\n", "offset", 4),
        ("[[feature]]\nkind = \"bore\"\ncentre = [50,0,20]\ndiameter = 25.01\n", "centre", 3),
        ("[[feature]]\nkind = \"face\"\npoint = [0,0,5,3]\nnormal = [0,0,1]\n", "point", 4),
        ("[[feature]]\nkind = \"face\"\npoint = [0,0,5]\nnormal = [0,0,0,1]\n", "normal", 4),
        ("[[feature]]\nkind = \"boss\"\ncentre = [0,0]\nlengths = [8,5,8]\n", "lengths", 3),
        (
            "[[feature]]\nkind = \"bore\"\ncentre = [50,20]\ndiameter = 25.01\n[probe]\noffset = [0,1,0,2]\n",
            "offset",
            4,
        ),
    ] {
        let said = run(text, &bore);
        let counted = format!("found {found}");
        assert!(said.code == 1 && said.err.contains(key) && said.err.contains(&counted), "{text}{}", said.err);
    }
    assert_eq!(run("[bore]\ncentre = [50,20]\ndiameter = 25.01\n[probe]\noffset = [0,0]\n", &bore).code, 0);
}

#[test]
fn contacts_at_very_different_heights_are_told() {
    let at = |heights: [f64; 4]| {
        let places = [[12.505, 0.0], [0.0, 12.505], [-12.505, 0.0], [0.0, -12.505]];
        let rows = places.iter().zip(heights).map(|([x, y], z)| format!("{x},{y},{z}\n"));
        format!("x,y,z\n{}", rows.collect::<String>())
    };
    let bore = [
        "cycle",
        "421",
        "--set",
        "Q273=0",
        "Q274=0",
        "Q262=25",
        "Q261=-8",
        "Q260=50",
        "Q275=25.021",
        "Q276=25",
        "--contacts",
        "c.csv",
    ];
    let calls: [&[&str]; 3] = [&["check", "25 H7", "--contacts", "c.csv"], &["circle", "c.csv"], &bore];
    for call in calls {
        let words = "heights differ by 40.000 mm";
        let said = answer("c.csv", &at([0.0, -10.0, -20.0, -40.0]), call);
        assert!(said.said().contains(words), "{call:?}\n{}{}", said.out, said.err);
        // From a tenth of the diameter on.
        let said = answer("c.csv", &at([-8.0, -8.0, -8.0, -10.6]), call);
        assert!(said.said().contains("heights differ by 2.600 mm"), "{call:?}\n{}", said.err);
        let said = answer("c.csv", &at([-8.0, -8.0, -8.0, -10.4]), call);
        assert!(!said.said().contains("heights differ"), "{call:?}\n{}", said.err);
    }
    let told = |heights| call(&program("Z", BORE), &at(heights)).said();
    assert!(told([0.0, -10.0, -20.0, -40.0]).contains("heights differ by 40.000 mm"));
    assert!(!told([-8.0, -8.0, -8.0, -8.4]).contains("heights differ"));
    // Half a millimetre is nothing to tell, however small the circle.
    let small = |z: f64| format!("x,y,z\n1,0,0\n0,1,0\n-1,0,0\n0,-1,{z}\n");
    let circle = ["circle", "c.csv"];
    assert!(!answer("c.csv", &small(0.5), &circle).said().contains("heights differ"));
    assert!(answer("c.csv", &small(0.51), &circle).said().contains("heights differ by 0.510 mm"));
}

#[test]
fn a_contact_at_height_zero_is_far_from_a_probing_below() {
    let ridge = [
        "cycle",
        "426",
        "--set",
        "Q263=0",
        "Q264=0",
        "Q265=20",
        "Q266=0",
        "Q272=1",
        "Q261=-8",
        "Q260=50",
        "Q311=20",
        "Q288=20.1",
        "Q289=19.9",
        "--contacts",
        "c.csv",
    ];
    let words = "contact 1 lies 8";
    let said = answer("c.csv", "x,y,z\n0,0,0\n20,0,-8\n", &ridge);
    assert!(said.said().contains(words), "{}{}", said.out, said.err);
    let said = answer("c.csv", "x,y\n0,0\n20,0\n", &ridge);
    assert!(!said.said().contains(words), "{}{}", said.out, said.err);
}
