//! Tables that have their limits in columns, their values side by side, and lines above their names: as people have them.

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

use crate::at_home::AtHome as _;

const TABLES: &str = "tests/data/tables";

struct Said {
    code: i32,
    out: String,
    err: String,
}

fn run(folder: &Path, args: &[&str]) -> Said {
    let home = folder.join("home");
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder).args(args).env("FITCHECK_JOURNAL", folder.join("j.sqlite"));
    let output = command.at_home(&home).output().unwrap();
    Said {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The answer to a table.
fn of(text: &str, args: &[&str]) -> Said {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("a.csv"), text.as_bytes()).unwrap();
    run(folder.path(), args)
}

/// `import` and `batch` give these answers to the rows of a table, the limits and the word of each; what is refused has a part of its reason.
#[track_caller]
fn both(text: &str, expected: &[&str]) {
    let imported = of(text, &["import", "a.csv", "--format", "csv"]);
    let rows: Vec<&str> = imported.out.lines().skip(1).collect();
    assert_eq!(rows.len(), expected.len(), "{text}{}{}", imported.out, imported.err);
    for (row, words) in rows.iter().zip(expected) {
        assert!(words.split(' ').all(|word| row.contains(word)), "{words}\n{row}\n{text}{}", imported.err);
    }
    let batch = of(text, &["batch", "--prefix", "fc_", "a.csv"]);
    for words in expected {
        let has = |row: &str| words.split(' ').all(|word| row.contains(word));
        assert!(batch.out.lines().any(has), "{words}\n{}{}", batch.out, batch.err);
    }
}

/// Both refuse a table as a whole, with these words.
#[track_caller]
fn refused(text: &str, words: &str) {
    for args in [&["import", "a.csv"][..], &["batch", "a.csv"]] {
        let said = of(text, args);
        assert!(said.code == 1 && said.err.contains(words), "{args:?}\n{text}{}{}", said.out, said.err);
    }
}

#[test]
fn a_mark_in_a_column_of_what_is_out_contradicts_good() {
    let row = |mark: &str| format!("Feature;Nominal;Tol+;Tol-;Actual;OutOfTol\nD1;25;0.021;0;25.0123;{mark}\n");
    for (mark, code) in [("*", 14), (">", 14), ("0.009", 14), ("", 0), ("-", 0), ("0", 0)] {
        let said = of(&row(mark), &["import", "a.csv"]);
        assert_eq!(said.code, code, "{mark}: {}{}", said.out, said.err);
        assert_eq!(said.err.contains("OutOfTol"), code == 14, "{mark}: {}", said.err);
    }
}

#[test]
fn two_limits_alone_may_be_as_far_apart_as_those_of_a_chamfer() {
    let chamfer = "name;lower limit;upper limit;measured\nC1;0.5;2.5;1\nC2;0.5;2.5;2.6\n";
    both(chamfer, &["C1 0.500 2.500 GOOD", "C2 0.500 2.500 OUT OF LIMITS"]);
    // A hole is not that wide, and deviations may have been written in micrometres.
    for row in [
        "name;kind;lower limit;upper limit;measured\nA;hole;0.5;2.5;1\n",
        "name;nominal;upper deviation;lower deviation;measured\nA;25;21;0;30\n",
    ] {
        let said = of(row, &["import", "a.csv"]);
        assert!(said.code == 1 && said.err.contains("out of all proportion"), "{row}{}{}", said.out, said.err);
    }
}

#[test]
fn deviations_beside_a_nominal_size_are_limits() {
    both(
        "Merkmal;Art;Nennmaß;oberes Abmaß;unteres Abmaß;Istwert\nA1;Bohrung;25;0,021;0;25,012\nA2;Bohrung;25;0,021;0;25,030\n\
         A3;Welle;20;-0,007;-0,020;19,99\nA4;Welle;20;-0,007;-0,020;19,995\n",
        &["A1 25.000 25.021 GOOD", "A2 25.000 25.021 SCRAP", "A3 19.980 19.993 GOOD", "A4 19.980 19.993 REWORK"],
    );
    both(
        "Repère;Type;Cote nominale;Écart supérieur;Écart inférieur;Valeur mesurée\nA;alésage;25;0,021;0;25,012\n",
        &["A 25.021 GOOD"],
    );
    both(
        "Característica;Tipo;Cota nominal;Desviación superior;Desviación inferior;Valor medido\nA;eje;20;-0,007;-0,020;19,98\n",
        &["A 19.993 GOOD"],
    );
    both("Feature;Kind;Nominal [mm];Tol+ [µm];Tol- [µm];Actual [mm]\nA;hole;25;21;0;25.030\n", &["A 25.021 SCRAP"]);
}

#[test]
fn limits_of_size_in_columns_judge() {
    both(
        "Feature;Hole/Shaft;USL;LSL;Measured\nA;hole;25.021;25.000;25.021\nB;hole;25.021;25.000;25.0211\nC;shaft;20;19.987;20.005\n\
         D;hole;25.000;25.021;25.01\nE;hole;25.021;;25.01\n",
        &[
            "A GOOD",
            "B SCRAP",
            "C REWORK",
            "D not judged lower limit above",
            "E not judged one of the two limits is missing",
        ],
    );
    both("Feature;Kind;Nominal;Max;Min;Actual\nA;hole;25;25.021;25.000;25.012\n", &["A 25.021 GOOD"]);
}

#[test]
fn a_minus_that_is_left_out_is_supplied_where_all_rows_agree_and_told() {
    let table = "Feature;Type;Nominal;+TOL;-TOL;Measured\nA;hole;25;0.021;0.01;24.995\nB;hole;25;0.021;0.02;25.030\n";
    both(table, &["A 24.990 25.021 GOOD", "B 24.980 25.021 SCRAP"]);
    assert!(of(table, &["import", "a.csv"]).err.contains("column 5 (-TOL) has no minus signs"));
    // One row with a minus: the others have their signs, too.
    both(
        "Feature;Type;Nominal;+TOL;-TOL;Measured\nA;hole;25;0.021;-0.01;24.995\nB;hole;25;0.041;0.020;25.030\n",
        &["A 24.990 25.021 GOOD", "B 25.020 25.041 GOOD"],
    );
    // A zone above the nominal size, or around it.
    refused("Feature;Type;Nominal;Upper deviation;Lower deviation;Measured\nA;hole;25;0.041;0.020;25.030\n", "minus=5");
    let said = |columns: &str| {
        of(
            "Feature;Type;Nominal;Upper deviation;Lower deviation;Measured\nA;hole;25;0.041;0.020;25.010\n",
            &["import", "a.csv", "--format", "csv", "--columns", columns],
        )
        .out
    };
    assert!(said("upper=4,minus=5").contains("24.980,25.041,25.010,10,GOOD"), "{}", said("upper=4,minus=5"));
    assert!(said("upper=4,lower=5").contains("25.020,25.041,25.010,10,REWORK"), "{}", said("upper=4,lower=5"));
}

#[test]
fn names_that_may_mean_two_things_are_asked_about() {
    refused("Feature;Kind;Actual;Max;Min\nA;hole;25.012;25.021;25.000\n", "maximum=4,minimum=5");
    refused("Feature;Kind;Nominal;Upper limit;Lower limit;Actual\nA;hole;25;0.021;0;25.012\n", "upper=4,lower=5");
    refused("Feature;Kind;Nominal;Upper tol;Lower tol;Actual\nA;hole;25;25.021;25.000;25.012\n", "maximum=4,minimum=5");
    // The numbers tell what the names leave open.
    both("Feature;Kind;Nominal;Upper;Lower;Actual\nA;hole;25;25.021;25.000;25.012\n", &["A 25.021 GOOD"]);
    both("Feature;Kind;Nominal;Upper;Lower;Actual\nA;hole;25;0.021;-0.010;25.012\n", &["A 24.990 25.021 GOOD"]);
}

#[test]
fn limits_that_contradict_the_callout_beside_them_leave_the_row_open_until_somebody_says_which() {
    let table = "Name;Callout;USL;LSL;Measured\nA;25 H7;25.030;25.000;25.025\nB;25 H7;25.021;25.000;25.012\n";
    both(table, &["25.021 25.030 maximum=-,minimum=-", "B GOOD"]);
    let by_callout = of(table, &["import", "a.csv", "--columns", "maximum=-,minimum=-"]);
    assert!(
        by_callout.out.contains("SCRAP") && by_callout.err.contains("limit differs") || by_callout.code == 11,
        "{}",
        by_callout.err
    );
    let batch = of(table, &["batch", "a.csv", "--columns", "maximum=-,minimum=-"]);
    assert_eq!(batch.code, by_callout.code, "{}", batch.err);
}

#[test]
fn a_tolerance_beside_a_nominal_size_may_be_a_class_or_deviations() {
    both(
        "Merkmal;Art;Nennmaß;Toleranz;Istwert\nA;Bohrung;25;H7;25,012\nB;Bohrung;12;±0,02;12,01\nC;Bohrung;12;+0,01/-0,02;12,01\n\
         D;Bohrung;12;+0,021 0;12,01\nE;Bohrung;12;0,021/-0,000;12,03\nF;Bohrung;12;0,05;12,01\n",
        &[
            "A 25.021 GOOD",
            "B 11.980 12.020 GOOD",
            "C 11.980 12.010 GOOD",
            "D 12.021 GOOD",
            "E 12.021 SCRAP",
            "write ±0,05",
        ],
    );
    both("Feature;Kind;Nominal;Tol ±;Actual\nA;hole;12;0.05;12.01\n", &["A 11.950 12.050 GOOD"]);
}

#[test]
fn names_over_two_rows_and_a_row_of_units_are_one_header() {
    both(
        "Merkmal;Art;Nennmaß;Toleranz;;Messung\n;;;oben;unten;\n;;mm;µm;µm;mm\nA1;Bohrung;25;21;0;25,012\nA2;Bohrung;25;21;0;25,030\n",
        &["A1 25.021 GOOD", "A2 25.021 SCRAP"],
    );
}

#[test]
fn numbers_may_have_signs_between_their_thousands_and_units() {
    both(
        "id;callout;measured\nA;1025 H7;1.025,012\nB;1025 H7;1 025,012\nC;25 H7;25012 µm\nD;25 H7;0,98472 in\nE;1025 H7;1\u{202f}025,012\n",
        &["A 1025.105 GOOD", "B 1025.105 GOOD", "C 25.021 GOOD", "D 25.021 GOOD", "E 1025.105 GOOD"],
    );
}

#[test]
fn a_form_of_first_articles_has_requirements_and_results() {
    both(
        "Char No.;Characteristic Designator;Requirement;Results;Status\n1;Bore;25 H7;25.012;OK\n2;Bore;25 H7;25.030;NOK\n",
        &["1 GOOD", "2 SCRAP"],
    );
}

fn imported(file: &str, more: &[&str]) -> Said {
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(TABLES).unwrap() {
        let path = entry.unwrap().path();
        std::fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
    }
    run(folder.path(), &[&["import", file, "--format", "csv"], more].concat())
}

#[test]
fn tables_from_the_field_give_the_right_answers() {
    let fir = imported("fir.xlsx", &[]);
    for (value, word) in
        [("25.012", "GOOD"), ("25.004", "GOOD"), ("25.030", "SCRAP"), ("24.998", "REWORK"), ("25.000", "GOOD")]
    {
        let is_it = |row: &str| row.contains("Bore,25 H7") && row.contains(&format!("{value},")) && row.contains(word);
        assert!(fir.out.lines().any(is_it), "{value}\n{}", fir.out);
    }
    let numbers = imported("textnum.xlsx", &[]).out;
    assert!(numbers.lines().any(|row| row.contains("25.0299") && row.contains("SCRAP")), "{numbers}");
    for (file, word) in
        [("inch_column.csv", "SCRAP"), ("inch_comment.csv", "SCRAP"), ("two_measured.csv", "measured after honing")]
    {
        let said = imported(file, &[]);
        assert!(
            said.code != 0 && (said.out.contains(word) || said.err.contains(word)),
            "{file}\n{}{}",
            said.out,
            said.err
        );
    }
    let units = imported("units_row_um.csv", &[]).out;
    assert!(units.contains("25.012,12,GOOD") && units.contains("25.030,30,SCRAP"), "{units}");
    let part = imported("two_parts.csv", &["--plan", "two_parts.plan.toml"]);
    assert!(part.code == 11 && part.err.contains("contradict"), "{}{}", part.out, part.err);
    let axes = imported("axes.csv", &["--plan", "axes.plan.toml"]);
    assert!(
        axes.out.contains("BORE_A,25 H7,25,25.000,25.021,25.012,12,GOOD") && !axes.out.contains("SCRAP"),
        "{}{}",
        axes.out,
        axes.err
    );
}

#[test]
fn lines_above_the_names_say_the_part_and_the_day_of_all_values() {
    let said = imported("preamble.csv", &["--columns", "kind=Type"]);
    assert!(said.err.contains("Part Name Plate 4711") && said.err.contains("Date 2026-07-10"), "{}", said.err);
    assert!(said.err.contains("skipped, not a measurement: Summary"), "{}", said.err);
}

#[test]
fn show_columns_answers_also_where_nothing_can_be_read_yet() {
    for file in ["fir.xlsx", "two_measured.csv", "axes.csv", "preamble.csv", "updown.csv"] {
        let folder = tempfile::tempdir().unwrap();
        std::fs::copy(Path::new(TABLES).join(file), folder.path().join(file)).unwrap();
        let said = run(folder.path(), &["import", "--show-columns", file]);
        assert!(said.out.contains("[columns]"), "{file}\n{}{}", said.out, said.err);
    }
    let said = of("Feature;Kind;Actual;Max;Min\nA;hole;25.012;25.021;25.000\n", &["import", "--show-columns", "a.csv"]);
    assert!(said.code == 1 && said.out.contains("Max") && said.err.contains("maximum=4"), "{}{}", said.out, said.err);
}

#[test]
fn a_plan_is_made_of_a_table_and_says_what_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["preamble.csv", "one_part.csv", "fir.xlsx", "updown.csv"] {
        std::fs::copy(Path::new(TABLES).join(file), folder.path().join(file)).unwrap();
    }
    let convert = |file: &str| {
        let said = run(folder.path(), &["plan", "convert", file, "-o", "p.toml", "--force"]);
        (std::fs::read_to_string(folder.path().join("p.toml")).unwrap_or_default(), said)
    };
    let (plan, said) = convert("preamble.csv");
    for words in ["part = \"Plate 4711\"", "drawing = \"D-200\"", "25 +0.021 0", "18.5 ±0.02", "kind = \"form\""] {
        assert!(plan.contains(words), "{words}\n{plan}{}", said.err);
    }
    let (plan, said) = convert("one_part.csv");
    assert!(said.code == 0 && plan.contains("12 H6") && plan.contains("P001"), "{plan}{}", said.err);
    let (plan, said) = convert("fir.xlsx");
    assert!(said.code == 1 && plan.contains("25 H7") && plan.contains("140 ±0.13"), "{plan}{}", said.err);
    let (plan, said) = convert("updown.csv");
    assert!(plan.contains("20 -0.007 -0.02") && said.code == 1, "{plan}{}", said.err);
}

#[test]
fn two_hundred_samples_beside_each_other_are_two_hundred_values() {
    let names: Vec<String> = (1..=200).map(|number| number.to_string()).collect();
    let values = vec!["25.012"; 200].join(";");
    let table = format!("Feature;Callout;{}\nA;25 H7;{values}\n", names.join(";"));
    let said = of(&table, &["import", "a.csv", "--format", "csv"]);
    assert_eq!((said.code, said.out.matches("GOOD").count()), (0, 200), "{}", said.err);
    refused_by_batch(&table);
}

#[track_caller]
fn refused_by_batch(table: &str) {
    let said = of(table, &["batch", "a.csv"]);
    assert!(said.code == 1 && said.err.contains("side by side"), "{}", said.err);
    let one = of(table, &["batch", "a.csv", "--columns", "measured=3,sample=-"]);
    assert_eq!(one.code, 0, "{}", one.err);
}

#[test]
fn names_of_the_users_own_are_known_in_any_file() {
    let folder = tempfile::tempdir().unwrap();
    let words = "[names]\nmeasured = [\"Prüfmaß\", \"gauge says\"]\nmaximum = [\"GOK\"]\nminimum = [\"GUK\"]\n";
    fitcheck::files::write(&folder.path().join("own.toml"), words.as_bytes()).unwrap();
    for (name, text) in [
        ("a.csv", "Merkmal;Art;GOK;GUK;Prüfmaß\nA;Bohrung;25,021;25,000;25,012\n"),
        ("b.csv", "Art;gauge says;Merkmal;GUK;GOK\nBohrung;25,030;A;25,000;25,021\n"),
    ] {
        fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
        for command in ["import", "batch"] {
            let said = run(folder.path(), &[command, name, "--columns", "own.toml"]);
            assert!([0, 11].contains(&said.code), "{command} {name}\n{}{}", said.out, said.err);
        }
    }
}

/// The names of the manual are known, and each word of `--columns` has its line there.
#[test]
fn the_manual_has_every_role_with_names_that_are_known() {
    use fitcheck::exchange::{FirstRows, Mapping, Role};
    let manual = include_str!("../../docs/manual/columns.md");
    let rows: Vec<Vec<&str>> = manual
        .lines()
        .filter(|line| line.starts_with("| `"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    for role in Role::all() {
        let word = format!("`{}`", role.word());
        let row = rows.iter().find(|row| row[0].split(", ").any(|known| known == word));
        let row = row.unwrap_or_else(|| panic!("no line for {word}"));
        if matches!(
            role,
            Role::Minus | Role::Sample | Role::Kind | Role::Units | Role::Status | Role::X | Role::Y | Role::Z
        ) {
            continue;
        }
        for name in row[2].split('`').filter(|name| !name.trim_matches([',', ' ']).is_empty()) {
            let guess = |text: String| {
                let first = FirstRows::of_columns("a.csv", text.as_bytes()).unwrap();
                first.guess(&Mapping::default()).roles[0]
            };
            let guessed = guess(format!("{name};q;r\na;b;1\n"));
            let beside = guess(format!("{name};feature;callout;measured\na;A;25 H7;25.01\n"));
            let guessed = if beside == Some(role) { beside } else { guessed };
            // A name of a part, a number or a serial number names a feature where nothing else does.
            let is_label = matches!(role, Role::Number | Role::Part | Role::Serial) && guessed == Some(Role::Id);
            assert!(guessed == Some(role) || is_label || role == Role::Quantity, "{name}: {guessed:?}");
        }
    }
}
