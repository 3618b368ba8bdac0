//! What a run admits by its exit code: 14 where everything has an answer, and a colleague would stop all the same.

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

use crate::at_home::AtHome as _;

/// Exit code, standard output and standard error of a call in a folder with these files.
fn of(files: &[(&str, &str)], args: &[&str]) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::create_dir_all(folder.path().join(name).parent().unwrap()).unwrap();
        fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    }
    within(folder.path(), args)
}

fn within(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let home = folder.join("home");
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder).args(args).env("FITCHECK_JOURNAL", folder.join("j.sqlite"));
    let output = command.at_home(&home).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// The exit code of an import of one file.
#[track_caller]
fn import(text: &str, code: i32) {
    let (found, out, err) = of(&[("a.csv", text)], &["import", "a.csv"]);
    assert_eq!(found, code, "{text}\n{out}\n{err}");
}

#[test]
fn a_good_value_that_its_file_calls_nok_is_looked_at_first() {
    // 25 H7 is 25.000 … 25.021.
    import("id;callout;measured;status\nA;25 H7;25.012;OK\n", 0);
    import("id;callout;measured;status\nA;25 H7;25.012;NOK\n", 14);
    // 24.998 of a hole is rework, 25.030 is scrap whatever the file says.
    import("id;callout;measured;status\nA;25 H7;24.998;OK\n", 14);
    import("id;callout;measured;status\nA;25 H7;24.998;NOK\n", 10);
    import("id;callout;measured;status\nA;25 H7;25.030;OK\n", 11);
    // A row without a verdict is bad data, whatever else there is.
    import("id;callout;measured;status\nA;25 H7;25.012;NOK\nB;25 H7;x;OK\n", 1);
}

/// A word that nobody here knows may be the worst there is: it is not passed over.
#[test]
fn a_status_that_is_not_known_is_said_and_looked_at_first() {
    for (word, code) in [
        ("OK", 0),
        ("in tolerance", 0),
        ("✓", 0),
        ("gemessen", 0),
        ("n/a", 0),
        ("-", 0),
        ("", 0),
        ("✗", 14),
        ("out of tolerance", 14),
        ("Sperrlager", 14),
        ("2", 14),
        ("?", 14),
    ] {
        let rows = format!("id;callout;measured;verdict\nA;25 H7;25.012;{word}\n");
        for command in ["import", "batch"] {
            let (found, out, err) = of(&[("a.csv", &rows)], &[command, "a.csv"]);
            assert_eq!(found, code, "{command} {word}\n{out}\n{err}");
        }
    }
    let rows = "id;callout;measured;verdict\nA;25 H7;25.012;Sperrlager\n";
    let (_, _, err) = of(&[("a.csv", rows)], &["import", "a.csv"]);
    assert!(err.contains("a.csv:2") && err.contains("Sperrlager, which is not a known status"), "{err}");
    let (_, _, err) = of(&[("a.csv", rows)], &["batch", "a.csv"]);
    assert!(err.contains("1 row has an unknown status in its file"), "{err}");
    let plan = "fitcheck_plan = 1\npart = \"One\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
    let (code, _, err) = of(&[("a.csv", rows), ("p.toml", plan)], &["import", "--plan", "p.toml", "a.csv"]);
    assert_eq!((code, err.matches("Sperrlager").count()), (14, 1), "{err}");
}

/// One column says OK for the station, the next one NOK for the customer: both are compared.
#[test]
fn every_column_of_a_status_is_compared() {
    for command in ["import", "batch"] {
        for (row, code) in [("OK;OK", 0), ("OK;NOK", 14), ("NOK;OK", 14)] {
            let rows = format!("id;callout;measured;verdict;decision\nA;25 H7;25.012;{row}\n");
            let (found, out, err) = of(&[("a.csv", &rows)], &[command, "a.csv"]);
            assert_eq!(found, code, "{command} {row}\n{out}\n{err}");
        }
    }
}

#[test]
fn what_nobody_measured_is_looked_at_first() {
    import("id;callout;measured;simulated\nA;25 H7;25.012;true\n", 14);
    import("id;callout;measured;simulated\nA;25 H7;25.012;false\n", 0);
    import("id;callout;measured;simulated\nA;25 H7;25.030;true\n", 11);
    let rows = "id;callout;measured;simulated\nA;25 H7;25.012;true\n";
    assert_eq!(of(&[("a.csv", rows)], &["batch", "a.csv"]).0, 14);
    assert_eq!(of(&[("a.csv", rows)], &["report", "a.csv", "-o", "r.html"]).0, 14);
    let plan = "fitcheck_plan = 1\npart = \"One\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
    let files = [("a.csv", rows), ("p.toml", plan), ("in/a.csv", rows)];
    assert_eq!(of(&files, &["import", "--plan", "p.toml", "a.csv"]).0, 14);
    assert_eq!(of(&files, &["report", "--plan", "p.toml", "a.csv", "-o", "r.html"]).0, 14);
    assert_eq!(of(&files, &["watch", "in", "--plan", "p.toml", "--until-idle", "0.5"]).0, 14);
}

#[test]
fn a_value_that_may_be_another_quantity_is_looked_at_first() {
    // Half of 25: a radius. As a hole it could be machined to size.
    import("id;callout;measured\nA;25 H7;12.506\n", 14);
    assert_eq!(of(&[], &["check", "25 H7", "--measured", "12.506"]).0, 14);
    assert_eq!(of(&[], &["check", "25 h7", "--measured", "12.506"]).0, 11);
    let rows = [("a.csv", "id;callout;measured\nA;25 H7;12.506\n")];
    assert_eq!(of(&rows, &["batch", "a.csv"]).0, 14);
    assert_eq!(of(&rows, &["report", "a.csv", "-o", "r.html"]).0, 14);
}

#[test]
fn a_file_that_is_named_twice_is_looked_at_first() {
    let rows = [("a.csv", "id;callout;measured\nA;25 H7;25.012\n")];
    assert_eq!(of(&rows, &["import", "a.csv", "a.csv"]).0, 14);
    assert_eq!(of(&rows, &["batch", "a.csv", "a.csv"]).0, 14);
    assert_eq!(of(&rows, &["report", "a.csv", "a.csv", "-o", "r.html"]).0, 14);
}

#[test]
fn the_help_says_the_rule() {
    let (code, out, _) = of(&[], &["--help"]);
    assert_eq!(code, 0);
    assert!(out.contains("14 judged, but look first"), "{out}");
}

/// The hole 25 H7 is 25.000 … 25.021, the shaft 20 g6 is 19.980 … 19.993.
const TWO: &str = "fitcheck_plan = 1\npart = \"Two\"\n[[feature]]\nname = \"BORE_A\"\ncallout = \"25 H7\"\n\
                   [[feature]]\nname = \"SEAT\"\ncallout = \"20 g6\"\n";

/// The exit code of every command that judges whole parts by [`TWO`], and what `import` says on standard error.
#[track_caller]
fn parts(rows: &str, more: &[&str], code: i32) -> String {
    let files = [("two.csv", rows), ("p.toml", TWO)];
    let import = of(&files, &[&["import", "--plan", "p.toml", "two.csv"], more].concat());
    let report =
        of(&files, &[&["report", "--plan", "p.toml", "two.csv", "-o", "-", "--format", "json"], more].concat());
    assert_eq!((import.0, report.0), (code, code), "{rows}\n{}\n{}", import.2, report.2);
    import.2
}

#[test]
fn a_later_row_does_not_replace_scrap() {
    let said = parts("name;measured\nBORE_A;25.030\nSEAT;19.99\nBORE_A;25.012\nSEAT;19.99\n", &[], 11);
    let facts = "BORE_A has values that contradict each other: 25.030 SCRAP (two.csv:2), 25.012 GOOD (two.csv:4)";
    assert!(said.contains(facts), "{said}");
    assert_eq!(said.matches("--repeats last or --repeats worst").count(), 1, "{said}");
    assert!(!said.contains("SEAT"), "values that agree are no contradiction: {said}");
    // The other way round it is scrap as well.
    parts("name;measured\nBORE_A;25.012\nSEAT;19.99\nBORE_A;25.030\nSEAT;19.99\n", &[], 11);
}

#[test]
fn of_two_files_neither_is_the_later_one() {
    let (scrap, good) = ("name;measured\nBORE_A;25.030\nSEAT;19.99\n", "name;measured\nBORE_A;25.012\nSEAT;19.99\n");
    let files = [("a.csv", scrap), ("b.csv", good), ("p.toml", TWO)];
    for order in [["a.csv", "b.csv"], ["b.csv", "a.csv"]] {
        let (code, _, err) = of(&files, &[&["import", "--plan", "p.toml"][..], &order].concat());
        assert_eq!(code, 11, "{err}");
        assert!(err.contains("25.030 SCRAP (a.csv:2), 25.012 GOOD (b.csv:2)"), "{err}");
    }
}

#[test]
fn rework_without_a_time_is_not_replaced_either() {
    // 24.998 of a hole is rework.
    let rows = "name;measured\nBORE_A;24.998\nSEAT;19.99\nBORE_A;25.012\n";
    let said = parts(rows, &[], 14);
    assert!(said.contains("24.998 REWORK (two.csv:2), 25.012 GOOD (two.csv:4)"), "{said}");
    assert!(!parts(rows, &["--repeats", "last"], 0).contains("contradict"));
    assert!(!parts(rows, &["--repeats", "worst"], 10).contains("contradict"));
}

#[test]
fn times_say_which_value_is_the_last_one() {
    let rows = |first: &str, second: &str, values: [&str; 2]| {
        let [one, two] = values;
        format!(
            "name;measured;time\nBORE_A;{one};2026-11-24T{first}\nSEAT;19.99;2026-11-24T08:00\nBORE_A;{two};2026-11-24T{second}\n"
        )
    };
    // Reworked, and measured again.
    parts(&rows("08:00", "09:00", ["24.998", "25.012"]), &[], 0);
    // The order of the rows is another one.
    parts(&rows("09:00", "08:00", ["24.998", "25.012"]), &[], 10);
    parts(&rows("09:00", "08:00", ["25.012", "24.998"]), &[], 0);
    // At the same time neither is the later one.
    parts(&rows("08:00", "08:00", ["24.998", "25.012"]), &[], 14);
    // A hole that is too large does not become smaller: somebody has to say what that was.
    let scrap = rows("08:00", "09:00", ["25.030", "25.012"]);
    assert!(parts(&scrap, &[], 11).contains("contradict"));
    parts(&scrap, &["--repeats", "last"], 0);
    // It became scrap when it was reworked: nothing contradicts that.
    assert!(!parts(&rows("08:00", "09:00", ["24.998", "25.030"]), &[], 11).contains("contradict"));
    // The last one by its time is chosen, not the last row.
    parts(&rows("09:00", "08:00", ["25.030", "25.012"]), &["--repeats", "last"], 11);
}

#[test]
fn serial_numbers_keep_parts_apart() {
    let rows = "name;measured;serial\nBORE_A;25.030;1\nSEAT;19.99;1\nBORE_A;25.012;2\nSEAT;19.99;2\n";
    assert!(!parts(rows, &[], 11).contains("contradict"));
}

#[test]
fn a_watched_file_says_that_its_values_contradict_each_other() {
    let rows = "name;measured\nBORE_A;24.998\nSEAT;19.99\nBORE_A;25.012\nSEAT;19.99\n";
    let files = [("in/two.csv", rows), ("p.toml", TWO)];
    let (code, out, err) = of(&files, &["watch", "in", "--plan", "p.toml", "--until-idle", "0.5"]);
    assert_eq!(code, 14, "{out}\n{err}");
    assert!(err.contains("BORE_A has values that contradict each other: 24.998 REWORK"), "{err}");
}

/// What was recorded before the watch was started again is known: a value that contradicts it is not simply good.
#[test]
fn a_watch_that_is_started_again_knows_the_values_before() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        fitcheck::files::write(&path, text.as_bytes()).unwrap();
    };
    let watch = |name: &str, rows: &str| {
        write(&format!("in/{name}"), &format!("name;measured;serial\n{rows}"));
        within(folder.path(), &["watch", "in", "--plan", "p.toml", "--until-idle", "0.5"])
    };
    write("p.toml", TWO);
    assert_eq!(watch("a.csv", "BORE_A;25.030;7\nSEAT;19.99;7\n").0, 11);
    assert_eq!(watch("b.csv", "BORE_A;25.012;8\nSEAT;19.985;7\n").0, 0, "another part, and a size that agrees");
    let (code, out, err) = watch("c.csv", "BORE_A;25.012;7\n");
    assert_eq!(code, 14, "{out}\n{err}");
    assert!(err.contains("7: BORE_A has values that contradict each other: 25.030 SCRAP (a.csv)"), "{err}");
    // Somebody looked, and took the value back.
    let taken_back = ["journal", "correct", "2", "--withdraw", "--reason", "the wrong part was in the fixture"];
    let (code, out, err) = within(folder.path(), &taken_back);
    assert_eq!(code, 0, "{out}\n{err}");
    let (code, out, err) = watch("d.csv", "BORE_A;25.011;7\n");
    assert_eq!(code, 0, "{out}\n{err}");
}

/// A part without a name is its file, also for the next watch: others without one are other parts.
#[test]
fn files_without_a_serial_number_are_parts_of_their_own_after_a_restart() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::create_dir(path("in")).unwrap();
    fitcheck::files::write(&path("p.toml"), TWO.as_bytes()).unwrap();
    let watch = || within(folder.path(), &["watch", "in", "--plan", "p.toml", "--until-idle", "0.5"]);
    fitcheck::files::write(&path("in/a.csv"), b"name;measured\nBORE_A;25.030\n").unwrap();
    assert_eq!(watch().0, 11);
    fitcheck::files::write(&path("in/b.csv"), b"name;measured\nBORE_A;25.012\n").unwrap();
    let (code, out, err) = watch();
    assert_eq!(code, 0, "{out}\n{err}");
    // The first file grows.
    fitcheck::files::write(&path("in/a.csv"), b"name;measured\nBORE_A;25.030\nBORE_A;25.011\n").unwrap();
    let (code, out, err) = watch();
    assert_eq!(code, 14, "{out}\n{err}");
    assert!(err.contains("a.csv: BORE_A has values that contradict each other: 25.030 SCRAP (a.csv)"), "{err}");
}

mod walks {
    //! Any values of a size in any order.

    use fitcheck::part::{Document, Plan, Repeats, SizeValue, Walk};
    use fitcheck::tolerance::Sources;
    use fitcheck::verdict::Status;
    use jiff::civil::date;
    use proptest::prelude::*;

    fn plan() -> Plan {
        let one = "fitcheck_plan = 1\npart = \"One\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
        Document::read(one.as_bytes()).unwrap().plan(&Sources::default()).unwrap()
    }

    fn walk(values: &[SizeValue]) -> Walk {
        let mut walk = Walk::new(&plan(), String::new());
        for value in values {
            walk.take(0, *value);
        }
        walk
    }

    fn taken() -> impl Strategy<Value = SizeValue> {
        let status = prop::sample::select(Status::ALL.to_vec());
        let when = prop::option::of((0..4_i8).prop_map(|hour| date(2026, 11, 24).at(hour, 0, 0, 0)));
        let fields = (status, when, any::<bool>());
        fields.prop_map(|(status, when, is_simulated)| SizeValue { status, is_simulated, when, is_settled: false })
    }

    proptest! {
        #[test]
        fn a_part_that_ever_had_a_scrap_value_is_never_good_without_a_choice(
            values in prop::collection::vec(taken(), 1..8),
        ) {
            let walk = walk(&values);
            let is_scrap = |taken: &SizeValue| taken.status == Status::Scrap && !taken.is_simulated;
            if values.iter().any(is_scrap) {
                prop_assert_eq!(walk.standing().said(), Some(Status::Scrap));
            }
        }

        #[test]
        fn without_times_the_order_does_not_matter(mut values in prop::collection::vec(taken(), 1..8)) {
            for value in &mut values {
                (value.when, value.is_simulated) = (None, false);
            }
            let there = walk(&values).standing();
            values.reverse();
            let back = walk(&values).standing();
            prop_assert_eq!(there, back);
            let worst = values.iter().map(|value| value.status).max();
            prop_assert_eq!(there.worst, worst);
            let agree = values.iter().all(|value| Some(value.status) == worst);
            prop_assert_eq!(there.contradicted, usize::from(!agree));
        }

        #[test]
        fn what_somebody_chooses_counts_and_contradicts_nothing(values in prop::collection::vec(taken(), 1..8)) {
            let mut walk = walk(&values);
            let newest = walk.steps()[0].newest().unwrap();
            for place in (0..values.len()).filter(|place| *place != newest) {
                walk.settle(0, place);
            }
            prop_assert_eq!(walk.steps()[0].counting(), Some(newest));
            prop_assert_eq!(walk.standing().contradicted, 0);
            // The same chosen beforehand.
            let mut last = Walk::new(&plan(), String::new()).by(Repeats::Last);
            for value in &values {
                last.take(0, *value);
            }
            prop_assert_eq!(last.steps()[0].counting(), Some(newest));
        }
    }
}

#[test]
fn batch_compares_the_status_of_the_file_too() {
    let rows = "id;callout;measured;result\nA;25 H7;25.012;OK\nB;25 H7;25.011;NOK\nC;25 H7;25.010;\"nok\"\n";
    let (code, _, err) = of(&[("a.csv", rows)], &["batch", "a.csv"]);
    assert_eq!(code, 14, "{err}");
    assert!(err.contains("a.csv:3: warning: the file says NOK, but the limits say GOOD"), "{err}");
    assert!(err.contains("2 rows have a different status in their file"), "{err}");
    assert_eq!(of(&[("a.csv", &rows.to_uppercase().replace("NOK", "OK"))], &["batch", "a.csv"]).0, 0);
}

#[test]
fn a_skipped_measurement_and_limits_out_of_proportion_are_looked_at_first() {
    let hole = |maximum: &str| {
        format!(
            "TCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-5 ~\nQ320=+2 ~\n\
             Q260=+15 ~\nQ301=+0 ~\nQ275=+{maximum} ~\nQ276=+25\n"
        )
    };
    let skipped = "TCH PROBE 430 MEAS. BOLT HOLE CIRC ~\nQ273=+0\n";
    for (blocks, expected) in [(hole("25.021"), 0), (format!("{}{skipped}", hole("25.021")), 14), (hole("46"), 14)] {
        let text = format!("BEGIN PGM m MM\nTOOL CALL 1 Z\n{blocks}END PGM m MM\n");
        let (code, out, err) = of(&[("m.h", &text)], &["run", "m.h", "--skip-unknown"]);
        assert_eq!(code, expected, "{blocks}{out}{err}");
    }
    for (maximum, expected) in [("Q275=25.021", 0), ("Q275=46", 14)] {
        let args = ["cycle", "421", "--set", "Q273=50", "Q274=50", "Q262=25", maximum, "Q276=25"];
        let (code, out, err) = of(&[], &args);
        assert_eq!(code, expected, "{out}{err}");
    }
}

#[test]
fn a_status_with_a_reason_behind_it_is_a_status() {
    for word in ["n.i.O. (Kratzer)", "rejected - burr", "NOK: scratch", "KO", "scrapped"] {
        import(&format!("id;callout;measured;status\nA;25 H7;25.010;{word}\n"), 14);
    }
}

#[test]
fn rows_within_quotation_marks_have_no_verdict_for_batch_as_for_import() {
    let rows =
        "id;callout;measured;remark\nA;25 H7;25.012;\"ok\nB;25 H7;25.030;bad\nC;25 H7;25.010;x\"\nD;25 H7;25.011;y\n";
    let import = of(&[("a.csv", rows)], &["import", "a.csv", "--format", "csv"]);
    let batch = of(&[("a.csv", rows)], &["batch", "a.csv"]);
    assert_eq!((import.0, batch.0), (1, 1), "{}{}", import.2, batch.2);
    let status = |out: &str, id: &str| {
        let row = out.lines().find(|line| line.split([';', ',']).any(|cell| cell == id)).unwrap_or_default().to_owned();
        ["GOOD", "SCRAP"].into_iter().find(|word| row.contains(word)).unwrap_or("none")
    };
    for (id, expected) in [("A", "none"), ("B", "none"), ("C", "none"), ("D", "GOOD")] {
        assert_eq!(status(&batch.1, id), expected, "{}", batch.1);
        assert_eq!(status(&import.1, id), expected, "{}", import.1);
    }
    for (reason, count) in
        [("a quotation mark is not closed on this line", 1), ("this line may be a row or a remark", 2)]
    {
        for said in [&import.1, &batch.1] {
            assert_eq!(said.matches(reason).count(), count, "{said}");
        }
    }
    // A row in the first cell, one that would be refused, and rows within the header.
    for rows in [
        "id,callout,measured\n\"A,25 H7,25.040\nB\",25 H7,25.010\n",
        "id,callout,measured,remark\nA,25 H7,25.010,\"note\nB,25 ZZ7,25.040,\n\"\n",
        "id,callout,measured,\"remark\nA,25 H7,25.040,\nB,25 H7,25.010,\"\nC,25 H7,25.010,ok\n",
    ] {
        for command in ["import", "batch"] {
            let (code, out, err) = of(&[("a.csv", rows)], &[command, "a.csv"]);
            assert!(code == 1 && !out.contains("GOOD"), "{command} {rows}: {out}{err}");
        }
    }
    // A remark of several lines that are no rows is a remark.
    let remark = "id;callout;measured;remark\nA;25 H7;25.012;\"ok\nsee the drawing\"\nD;25 H7;25.011;y\n";
    for command in ["import", "batch"] {
        assert_eq!(of(&[("a.csv", remark)], &[command, "a.csv"]).0, 0, "{command}");
    }
}

#[test]
fn a_file_with_the_bytes_of_another_is_not_recorded_and_said() {
    let rows = "id;callout;measured\nA;25 H7;25.012\n";
    let (code, out, err) = of(&[("in/a.csv", rows), ("in/b.csv", rows)], &["watch", "in", "--until-idle", "0.5"]);
    assert_eq!(code, 14, "{out}\n{err}");
    assert!(out.contains("1 row: 1 GOOD"), "{out}");
    assert!(err.contains("b.csv") && err.contains("a.csv"), "{err}");
    assert_eq!(of(&[("in/a.csv", rows)], &["watch", "in", "--until-idle", "0.5"]).0, 0);
}
