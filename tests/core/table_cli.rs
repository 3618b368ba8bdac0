//! `fitcheck table`, through the built program.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::control::deviations::read_table;
use fitcheck::tolerance::Sources;

struct Answer {
    code: Option<i32>,
    out: String,
    err: String,
}

fn table(args: &[&str]) -> Answer {
    let answer = cargo_bin_cmd!("fitcheck").arg("table").args(args).assert();
    let output = answer.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    Answer { code: output.status.code(), out: text(&output.stdout), err: text(&output.stderr) }
}

fn shipped(name: &str) -> String {
    format!("{}/tables/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// A copy of the hole table with one text of a line replaced.
fn changed(folder: &Path, line: usize, from: &str, to: &str) -> String {
    let text = std::fs::read_to_string(shipped("82553_hole.tab")).unwrap();
    let lines: Vec<String> = text.split("\r\n").map(str::to_owned).collect();
    let at = lines[line - 1].find(from).unwrap_or_else(|| panic!("{}", lines[line - 1]));
    let mut lines = lines;
    lines[line - 1].replace_range(at..at + from.len(), to);
    let path = folder.join("own_hole.tab");
    std::fs::write(&path, lines.join("\r\n")).unwrap();
    path.to_str().unwrap().to_owned()
}

/// The line of the lower or upper row of a size range, by its end.
fn line_of(end: &str) -> usize {
    let text = std::fs::read_to_string(shipped("82553_hole.tab")).unwrap();
    let is_row = |line: &str| line.split_whitespace().nth(1) == Some(end);
    text.split("\r\n").position(is_row).unwrap() + 1
}

#[test]
fn both_shipped_tables_agree_with_the_standard() {
    for args in [&["verify"][..], &["verify", &shipped("82553_hole.tab"), &shipped("82553_shaft.tab")]] {
        let answer = table(args);
        assert_eq!(
            answer.out,
            "82553_hole.tab: 24 classes, 21 size ranges, 504 cells compared: all agree with ISO 286\n\
             82553_shaft.tab: 23 classes, 21 size ranges, 483 cells compared: all agree with ISO 286\n"
        );
        assert_eq!((answer.code, answer.err.as_str()), (Some(0), ""));
    }
}

#[test]
fn one_changed_cell_is_found_and_named_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    // 25 mm is in the range up to 30 mm; D10 is the first class: +149 and +65 µm.
    let line = line_of("30");
    let path = changed(folder.path(), line, "+149", "+150");
    let answer = table(&["verify", &path]);
    assert_eq!(answer.code, Some(1));
    let lines: Vec<&str> = answer.out.lines().collect();
    let place = format!("own_hole.tab:{line}:17");
    assert_eq!(
        lines,
        [
            &format!("{place}: D10 over 18 up to 30 mm: +150 / +65 µm, ISO 286 has +149 / +65 µm: upper 1 µm more"),
            "own_hole.tab: 24 classes, 21 size ranges, 504 cells compared: 1 differs from ISO 286"
        ]
    );
    let csv = table(&["verify", &path, "--format", "csv"]).out;
    let row = csv.lines().nth(1).unwrap();
    assert_eq!(row, format!("own_hole.tab,D10,18,30,150,65,149,65,1,0,{line},17,"));
    let json: serde_json::Value = serde_json::from_str(&table(&["verify", &path, "--format", "json"]).out).unwrap();
    let difference = &json[0]["differences"][0];
    assert_eq!((&difference["class"], &difference["upper_by_um"]), (&"D10".into(), &1.into()));
    assert_eq!((&json[0]["cells"], &difference["line"]), (&504.into(), &line.into()));
}

#[test]
fn lower_values_empty_cells_and_values_that_should_not_be_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let line = line_of("30");
    let lower = table(&["verify", &changed(folder.path(), line + 1, "+65", "+64")]);
    assert!(lower.out.contains("+149 / +64 µm, ISO 286 has +149 / +65 µm: lower 1 µm less"), "{}", lower.out);
    // The place is that of the lower value.
    assert!(lower.out.starts_with(&format!("own_hole.tab:{}:17: D10", line + 1)), "{}", lower.out);
    // Both rows of a cell emptied.
    let text = std::fs::read_to_string(shipped("82553_hole.tab")).unwrap();
    let emptied = text.replacen("+149", "    ", 1).replacen("+65", "   ", 1);
    let path = folder.path().join("empty.tab");
    std::fs::write(&path, emptied).unwrap();
    let empty = table(&["verify", path.to_str().unwrap()]);
    let told = format!("empty.tab:{line}:17: D10 over 18 up to 30 mm: no value, ISO 286 has +149 / +65 µm\n");
    assert!(empty.out.starts_with(&told), "{}", empty.out);
    // A value for N9 up to 1 mm, which the standard refuses, in a table whose first range ends at 3 mm.
    let path = folder.path().join("n9.tab");
    std::fs::write(&path, "BEGIN n9.tab\nNR BEREICH N9 U1Z1\n0  3       -4 +1\n1          -29 0\n[END]\n").unwrap();
    let refused = table(&["verify", path.to_str().unwrap()]);
    assert!(
        refused.out.contains("N9 over 0 up to 1 mm: -4 / -29 µm, but N9 is not defined at 1 mm in ISO 286"),
        "{}{}",
        refused.out,
        refused.err
    );
}

#[test]
fn a_shifted_size_range_is_found_in_all_classes_that_change_there() {
    let folder = tempfile::tempdir().unwrap();
    let line = line_of("30");
    let answer = table(&["verify", &changed(folder.path(), line, "30 ", "31 ")]);
    assert_eq!(answer.code, Some(1));
    // The cells of the range up to 30 mm now also apply to sizes up to 31 mm.
    let first = format!(
        "own_hole.tab:{line}:17: D10 over 30 up to 31 mm: +149 / +65 µm, ISO 286 has +180 / +80 µm: upper 31 µm less, \
         lower 15 µm less"
    );
    assert_eq!(answer.out.lines().next(), Some(&*first));
    assert!(answer.out.ends_with("504 cells compared: 24 differ from ISO 286\n"), "{}", answer.out);
}

/// Nothing that reads a table drops a column without a word.
#[test]
fn a_column_that_is_no_class_is_told_wherever_a_table_is_read() {
    let by_name = "was skipped, because its name cannot be that of a tolerance class";
    for (column, cells, reason) in [
        ("P_F ", ["+1", "0"], by_name),
        ("NOTE", ["ab", "cd"], "was skipped, because it holds texts and no deviations"),
        ("Pf  ", ["+1", "0"], "was skipped, because a tolerance class does not mix upper and lower case"),
    ] {
        let [upper, lower] = cells;
        let own = format!(
            "BEGIN own.tab\nNR BEREICH H7   {column} \n0  3       +10  {upper}   \n1          +0   {lower}    \n[END]\n"
        );
        let told = format!("column {} {reason}", column.trim());
        for_all_readers(&own, |args, said| assert!(said.contains(&told), "{args:?}: {said}"));
    }
}

#[test]
fn an_own_column_is_used_wherever_a_table_is_read_and_nothing_is_told() {
    let own = "BEGIN own.tab\nNR BEREICH H7   PF   \n0  3       +10  +1   \n1          +0   0    \n[END]\n";
    for_all_readers(own, |args, said| assert_eq!(said, "", "{args:?}"));
}

/// What is said on standard error by each that reads a table.
#[track_caller]
fn for_all_readers(own: &str, check: impl Fn(&[&str], &str)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.tab");
    std::fs::write(&path, own).unwrap();
    let (name, tables) = (path.to_str().unwrap(), folder.path().to_str().unwrap());
    for args in [
        &["table", "verify", name][..],
        &["table", "export", name, "--format", "csv"],
        &["limits", "2 H7", "--tables", tables],
        &["check", "2 H7", "--tables", tables, "--measured", "2"],
        &["sql", "--dialect", "sqlite", "--classes", "H7", "--tables", tables],
    ] {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(args).output().unwrap();
        check(args, &String::from_utf8(output.stderr).unwrap());
    }
}

#[test]
fn own_columns_are_named_and_a_table_of_them_alone_is_not_said_to_agree() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.tab");
    let own = "BEGIN own.tab\nNR BEREICH H7   OWN1 \n0  3       +10  +1   \n1          +0   0    \n[END]\n";
    std::fs::write(&path, own).unwrap();
    let name = path.to_str().unwrap();
    let answer = table(&["verify", name]);
    let said = "own.tab: 1 class, 1 size range, 1 cell compared: all agree with ISO 286; not compared, not ISO 286 \
                classes: OWN1\n";
    assert_eq!((answer.code, &*answer.out), (Some(0), said));
    let json: serde_json::Value = serde_json::from_str(&table(&["verify", name, "--format", "json"]).out).unwrap();
    assert_eq!((&json[0]["classes"], &json[0]["own_columns"]), (&1.into(), &serde_json::json!(["OWN1"])));
    std::fs::write(&path, own.replace("H7  ", "OWN2")).unwrap();
    let answer = table(&["verify", name]);
    assert!(answer.out.contains("0 cells compared: nothing to compare with ISO 286"), "{}", answer.out);
}

#[test]
fn the_options_of_the_standard_change_what_is_compared() {
    let answer = table(&["verify", "--js-rounded"]);
    assert_eq!(answer.code, Some(1));
    let told = "82553_hole.tab: JS7 over 6 up to 10 mm: +7.5 / -7.5 µm, ISO 286 has +7 / -7 µm: upper 0.5 µm more, \
                lower 0.5 µm less";
    assert_eq!(answer.out.lines().next(), Some(told));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rounded.tab");
    let name = path.to_str().unwrap();
    assert_eq!(table(&["new", "--classes", "JS7 JS9 EF7", "--js-rounded", "-o", name]).code, Some(0));
    assert_eq!(table(&["verify", name, "--js-rounded"]).code, Some(0));
    assert_eq!(table(&["verify", name]).code, Some(1));
}

#[test]
fn a_file_that_is_no_table_is_named_and_the_others_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.tab");
    std::fs::write(&path, "not a table\n").unwrap();
    let answer = table(&["verify", path.to_str().unwrap(), &shipped("82553_hole.tab")]);
    assert_eq!(answer.code, Some(1));
    assert!(answer.err.contains("broken.tab, line 1, column 1"), "{}", answer.err);
    assert!(answer.out.starts_with("82553_hole.tab: 24 classes"), "{}", answer.out);
}

#[test]
fn a_new_table_for_every_generation_reads_back_and_gives_the_standards_limits() {
    let folder = tempfile::tempdir().unwrap();
    for generation in ["itnc530", "tnc640", "tnc7"] {
        let path = folder.path().join(format!("{generation}.tab"));
        let name = path.to_str().unwrap();
        let args = ["new", "--classes", "H7 R7 JS9 U6", "--to", "3150", "--generation", generation, "-o", name];
        let answer = table(&args);
        assert_eq!((answer.code, answer.err), (Some(0), format!("wrote {name}\n")));
        let verified = table(&["verify", name]);
        assert_eq!((verified.code, verified.err.as_str()), (Some(0), ""), "{}", verified.out);
        let (read, warnings) = read_table(&std::fs::read(&path).unwrap(), "own.tab", name, false).unwrap();
        assert_eq!(warnings, []);
        let own = Sources::of_tables([read.unwrap()]);
        for callout in ["3 H7", "64.999999 R7", "65.000001 R7", "100 JS9", "3150 U6", "0.5 H7"] {
            let callout = callout.parse().unwrap();
            let (own, standard) = (own.limits(&callout, None), Sources::default().limits(&callout, None));
            assert_eq!(own.unwrap().deviations, standard.unwrap().deviations, "{callout}");
        }
    }
}

#[test]
fn holes_and_shafts_get_a_table_each() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shop.tab");
    let answer = table(&["new", "--classes", "preferred", "--ends", "3 6 10 18", "-o", path.to_str().unwrap()]);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    let [hole, shaft] = ["hole", "shaft"].map(|part| folder.path().join(format!("shop_{part}.tab")));
    let verified = table(&["verify", hole.to_str().unwrap(), shaft.to_str().unwrap()]);
    // One range over 0 up to 3 mm: A11 and B11 begin above 1 mm only, so their cell stays empty.
    let told = "A11 over 1 up to 3 mm: no value, ISO 286 has +330 / +270 µm";
    assert!(verified.out.contains(told), "{}", verified.out);
    assert!(verified.out.contains("shop_shaft.tab: 17 classes, 4 size ranges"), "{}", verified.out);
}

#[test]
fn what_cannot_be_made_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for (args, reason) in [
        (vec!["--classes", "Q7"], "Q7 is not an ISO 286 tolerance class"),
        (vec!["--classes", "T7", "--to", "24"], "T7 is not defined at 24 mm in ISO 286"),
        (vec!["--classes", "H7", "--to", "3151"], "the last size is 3151 mm: it must be above 0 and at most 3150 mm"),
        (vec!["--classes", "H7", "--ends", "6 3"], "size range up to 3 mm does not end above the one before it, 6 mm"),
        (vec!["--classes", "H7", "--ends", "3 4000"], "the last size is 4000 mm"),
        (vec!["--classes", "H7 H7"], "column H7 occurs twice"),
        (vec!["--classes", " "], "no tolerance class is given"),
        (vec!["--classes", "H7", "--to", "x"], "x is not a number"),
    ] {
        let answer = table(&[&["new", "-o", &path("own.tab")][..], &args].concat());
        assert_eq!(answer.code, Some(1), "{args:?}");
        assert!(answer.err.contains(reason), "{args:?}: {}", answer.err);
    }
    let digit = table(&["new", "--classes", "H7", "--generation", "tnc7", "-o", &path("82553_hole.tab")]);
    assert!(digit.err.contains("does not begin with a letter"), "{}", digit.err);
    let operator = table(&["new", "--classes", "H7", "--generation", "tnc7", "-o", &path("my-hole.tab")]);
    assert!(operator.err.contains("my-hole.tab contains -"), "{}", operator.err);
    let ending = table(&["new", "--classes", "H7", "-o", &path("own.csv")]);
    assert!(ending.err.contains("the name of a control table ends in .tab"), "{}", ending.err);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The layout of `tests/data/iso286/limits_47_classes.csv`, whose figures are the oracle.
#[test]
fn the_built_in_tables_export_as_csv_has_the_published_figures() {
    let out = table(&["export", "--format", "csv"]).out;
    assert!(out.starts_with("class,over_mm,to_mm,upper_um,lower_um\nD10,0,1,60,20\nD10,1,3,60,20\nD10,3,6,78,30\n"));
    assert_eq!(out.matches("class,").count(), 1, "one header for both tables");
    assert_eq!(out.lines().count(), 1 + 47 * 21 - 2);
    let path = format!("{}/tests/data/iso286/limits_47_classes.csv", env!("CARGO_MANIFEST_DIR"));
    let mut published = csv::Reader::from_path(path).unwrap();
    let mut found = 0;
    for row in published.records().map(Result::unwrap) {
        let row: Vec<&str> = row.iter().take(5).collect();
        found += usize::from(out.contains(&format!("\n{}\n", row.join(","))));
    }
    assert!(700 < found, "{found} rows with the same ranges");
}

/// The classes and sizes of the built-in tables give the built-in tables.
#[test]
fn the_shipped_tables_can_be_made_anew() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("82553.tab");
    assert_eq!(table(&["new", "--classes", "control", "-o", path.to_str().unwrap()]).code, Some(0));
    for name in ["82553_hole.tab", "82553_shaft.tab"] {
        let made = std::fs::read(folder.path().join(name)).unwrap();
        assert!(made == std::fs::read(shipped(name)).unwrap(), "{name}");
    }
}

#[test]
fn an_exported_control_table_is_called_as_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("hole640.tab");
    let name = path.to_str().unwrap();
    let answer = table(&["export", &shipped("82553_hole.tab"), "--format", "tnc7", "-o", name]);
    assert_eq!((answer.code, answer.err), (Some(0), format!("wrote {name}\n")));
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("BEGIN hole640.tab\r\nTableDescription ("));
    assert_eq!(table(&["verify", name]).code, Some(0));
}

#[test]
fn an_export_never_lands_in_a_file_of_another_kind() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.tab");
    let answer = table(&["export", "--format", "csv", "-o", path.to_str().unwrap()]);
    assert_eq!(answer.code, Some(1));
    assert!(answer.err.contains("own.tab: a file of format csv ends in .csv"), "{}", answer.err);
    assert!(!path.exists());
}

#[test]
fn pc_dmis_gets_classes_of_holes_and_shafts_in_one_file() {
    let answer = table(&["export", "--classes", "H7 g6", "--to", "10", "--format", "pcdmis"]);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert_eq!(
        answer.out,
        "H7, 0, 3, 6, 10\n0.010, 0, 0.012, 0, 0.015, 0\n\
         g6, 0, 3, 6, 10\n-0.002, -0.008, -0.004, -0.012, -0.005, -0.014\n"
    );
    assert!(answer.err.starts_with("warning: the PC-DMIS manual shows no lower deviation other than 0: check g6"));
    assert_eq!(table(&["export", "--classes", "H7", "--to", "10", "--format", "pcdmis"]).err, "");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("iso.csv");
    let name = path.to_str().unwrap();
    assert_eq!(table(&["export", "--format", "pcdmis", "-o", name]).code, Some(0));
    assert_eq!(std::fs::read_to_string(&path).unwrap().lines().count(), 2 * 47);
    let two = table(&["export", "--format", "itnc530"]);
    assert!(two.code == Some(1) && two.err.contains("a control table is one file"), "{}", two.err);
}

#[test]
#[cfg(unix)]
fn nobody_listening_is_no_reason_to_leave_a_table_unwritten() {
    let folder = tempfile::tempdir().unwrap();
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let status = std::process::Command::new(assert_cmd::cargo::cargo_bin!("fitcheck"))
        .args(["table", "new", "--classes", "H7 h6", "-o"])
        .arg(folder.path().join("own.tab"))
        .stderr(std::process::Stdio::from(writer))
        .status()
        .unwrap();
    assert_eq!((status.code(), std::fs::read_dir(folder.path()).unwrap().count()), (Some(0), 2));
}

#[test]
fn a_cell_that_stays_empty_though_the_class_is_defined_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.tab");
    let path = path.to_str().unwrap();
    let new = |classes, ends| table(&["new", "--classes", classes, "--ends", ends, "-o", path]);
    let answer = new("C11 T7", "18 30 50");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    let empty =
        |cell: &str| format!("warning: own.tab: {cell} is left empty: ISO 286 has no single value for all of it\n");
    let warnings =
        ["C11 over 0 up to 18 mm", "C11 over 30 up to 50 mm", "T7 over 18 up to 30 mm", "T7 over 30 up to 50 mm"];
    assert_eq!(answer.err, format!("{}wrote {path}\n", warnings.map(empty).concat()));
    // Where the class is not defined at all, an empty cell is what ISO 286 says.
    assert_eq!(new("T7", "10 18 24 30").err, format!("wrote {path}\n"));
    let exported = table(&["export", "--classes", "r6", "--ends", "80", "--format", "csv"]);
    assert!(exported.err.contains("r6 over 0 up to 80 mm is left empty"), "{}", exported.err);
}
