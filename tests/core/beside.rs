//! What stands beside a value in a file and contradicts its answer: it is told, the exit code says so, and `import` and `batch` agree.

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

use crate::at_home::AtHome as _;

fn within(folder: &Path, args: &[&str]) -> (i32, String) {
    let home = folder.join("home");
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder).args(args).env("FITCHECK_JOURNAL", folder.join("j.sqlite"));
    let output = command.at_home(&home).output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

fn of(files: &[(&str, &str)], args: &[&str]) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    }
    within(folder.path(), args)
}

/// Both ways end with this code.
#[track_caller]
fn both(text: &str, code: i32) {
    for args in [&["import", "a.csv"][..], &["batch", "--prefix", "fc_", "a.csv"]] {
        let (found, err) = of(&[("a.csv", text)], args);
        assert_eq!(found, code, "{args:?}\n{text}\n{err}");
    }
}

/// A file with a column beside a good value: 25 H7 is 25.000 … 25.021.
#[track_caller]
fn beside(name: &str, cell: &str, code: i32) {
    both(&format!("Feature;Callout;Measured;{name}\nB1;25 H7;25.013;{cell}\n"), code);
}

#[test]
fn a_rejection_counts_whatever_its_column_is_called() {
    for (name, cell) in [
        ("Tol. status", "OUT"),
        ("Program status", "ABORTED"),
        ("OK?", "NOK"),
        ("QC", "NG"),
        ("Test result", "FAIL"),
        ("Overall status", "NOK"),
        ("Judge", "NG"),
        ("Conformity", "nonconforming"),
        ("State", "REJECTED"),
        ("Disposition", "Scrap"),
        ("Accepted", "no"),
        ("Pass", "FALSE"),
        ("NOK", "X"),
        ("Rejected", "x"),
        ("i.O./n.i.O.", "n.i.O."),
        ("Prüfergebnis", "n.i.O."),
        ("Gut/Schlecht", "schlecht"),
        ("Goedkeuring", "afgekeurd"),
        ("Conforme", "no"),
        ("OutTol", "0.005"),
        ("OOT", "0.02"),
        ("Deleted", "yes"),
        ("Valid", "no"),
        ("Whatever", "NOK"),
    ] {
        beside(name, cell, 14);
    }
    for (name, cell) in [
        ("OK?", "OK"),
        ("Pass", "TRUE"),
        ("NOK", ""),
        ("Rejected", "no"),
        ("OutTol", "0.000"),
        ("Deleted", "no"),
        ("Valid", "yes"),
        ("Order state", "released to packing"),
        ("Remark", "see the drawing"),
        ("P/F", "pass"),
    ] {
        beside(name, cell, 0);
    }
    both("B1;25 H7;25.010;NOK\nB2;25 H7;25.011;OK\n", 14);
    both("B1;25 H7;25.010;OK\nB2;25 H7;25.011;OK\n", 0);
}

#[test]
fn limits_that_contradict_the_callout_leave_the_row_open() {
    let row = |names: &str, cells: &str| format!("Nr;Name;{names};Callout;Measured\n1;Bore;{cells};25 H7;25.015\n");
    for (names, cells, code) in [
        ("Größtmaß;Kleinstmaß", "25,013;25,000", 1),
        ("Größtmaß;Kleinstmaß", "25,021;25,000", 0),
        ("USL;LSL", "25.021;25", 0),
        ("USL;LSL", "25.02;25.00", 0),
        ("USL;LSL", "25.013;25", 1),
        ("Upper tol;Lower tol", "0.021;0", 0),
        ("Upper tol;Lower tol", "21;0", 0),
        ("Upper tol;Lower tol", "0.013;0", 1),
        ("+TOL;-TOL", "0.021;0.000", 0),
        ("oberes Abmaß;unteres Abmaß", "0,033;0", 1),
        ("Boven;Onder", "25,033;25", 1),
        ("Max;Min", "25.021;25.000", 0),
        ("Max;Min", "-;", 0),
        // Of several readings, within the limits and not.
        ("Max;Min", "25.018;25.011", 0),
        ("Max;Min", "25.024;25.011", 14),
        ("Max;Min", "25.013;25.000", 14),
    ] {
        both(&row(names, cells), code);
    }
    // A shaft's lower deviation, with its sign and without.
    for lower in ["-0.020", "0.020", "-20", "\u{2212}0.020"] {
        both(&format!("Name;Callout;Measured;Upper tol;Lower tol\nP;25 g6;24.985;-0.007;{lower}\n"), 0);
    }
    both("Name;Callout;Measured;Upper tol;Lower tol\nP;25 g6;24.985;-0.007;-0.033\n", 1);
    // In inches, as they are printed.
    both("Name;Nominal [in];Class;Measured [in];USL;LSL\nB;1;H7;1.0004;1.0008;1.0000\n", 0);
    both("Name;Nominal [in];Class;Measured [in];USL;LSL\nB;1;H7;1.0004;1.0005;1.0000\n", 1);
    let plan = "fitcheck_plan = 1\npart = \"One\"\n[[feature]]\nname = \"B\"\ncallout = \"25 H7\"\n";
    for (upper, code) in [("25.021", 0), ("25.013", 14)] {
        let rows = format!("Feature;Measured;USL;LSL\nB;25.015;{upper};25\n");
        let (found, err) = of(&[("a.csv", &rows), ("p.toml", plan)], &["import", "--plan", "p.toml", "a.csv"]);
        assert_eq!(found, code, "{err}");
    }
}

#[test]
fn a_deviation_that_contradicts_the_value_is_told() {
    for (deviation, code) in
        [("0.013", 0), ("13", 0), ("+0.013", 0), ("0.01", 0), ("0.113", 14), ("25.05", 14), ("", 0)]
    {
        beside("Deviation", deviation, code);
    }
    beside("Abweichung [µm]", "13", 0);
    beside("Abweichung [µm]", "31", 14);
}

#[test]
fn a_shaft_with_the_callout_of_a_hole_is_told() {
    beside("Feature type", "Shaft", 14);
    beside("Type", "Welle", 14);
    beside("Feature type", "Bore", 0);
    both("Feature;Callout;Measured;Feature type\nP;25 h7;24.99;Shaft\n", 0);
    both("Feature;Callout;Measured;Feature type\nP;25 h7;24.99;Hole\n", 14);
}

#[test]
fn a_list_of_nominal_sizes_is_no_measurement() {
    both("Pos;Feature;Callout;Size\n1;Bore A;25 H7;25\n2;Bore B;30 H7;30\n3;Pin;20 h6;20\n", 14);
    both("Pos;Feature;Callout;Size\n1;Bore A;25 H7;25.000\n2;Bore B;30 H7;30.001\n3;Pin;20 h6;20\n", 0);
}

#[test]
fn columns_under_one_name_are_asked_about() {
    both("Name;Callout;Measured;;\nBore 1;25 H7;25.013;25.050;24.900\nBore 2;30 H7;30.010;30.011;30.012\n", 1);
    both("Name;Callout;Measured;;\nBore 1;25 H7;25.013;;\n", 0);
    both("Name;Callout;Measured;\nBore 1;25 H7;25.013;checked\n", 0);
    both("Name;Callout;Measured;Remeasured\nBore 1;25 H7;25.013;25.05\n", 1);
}

#[test]
fn a_word_of_simulation_counts_wherever_it_stands() {
    for name in ["Source", "Mode", "Comment"] {
        beside(name, "simulated", 14);
        beside(name, "Simulation", 14);
    }
    both("B1;25 H7;25.010;simulated\n", 14);
    both("# Offline simulation run\nFeature;Callout;Measured\nB1;25 H7;25.013\n", 14);
    both("Run mode;Simulation\nFeature;Callout;Measured\nB1;25 H7;25.013\n", 14);
    both("# Machine 7\nFeature;Callout;Measured\nB1;25 H7;25.013\n", 0);
}

#[test]
fn a_value_that_was_compensated_is_not_corrected_again() {
    for name in ["Temp comp", "TempKomp", "Normalized", "Temperature compensation"] {
        let rows = format!("Feature;Callout;Measured;{name}\nB;25 H7;25.023;Yes\n");
        let args = ["import", "a.csv", "--temperature", "30", "--material", "steel"];
        assert_eq!(of(&[("a.csv", &rows)], &args).0, 1, "{name}");
        assert_eq!(of(&[("a.csv", &rows.replace("Yes", "OFF"))], &args).0, 0, "{name}");
    }
}

/// Behind the rows by which the columns were found.
#[test]
fn another_quantity_far_down_is_not_judged_as_a_size() {
    let mut rows = "Feature;Callout;Measured;Type\n".to_owned();
    rows.extend((0..220).map(|n| format!("B{n};25 H7;25.010;\n")));
    both(&rows, 0);
    both(&(rows + "B9;25 H7;25.01;Roundness\n"), 1);
}

#[test]
fn pairs_are_made_of_parts_that_nobody_rejected() {
    let shafts = "Feature;Measured\nP1;24.980\nP2;24.985\nP3;24.990\n";
    for (holes, says) in [
        ("Feature;Measured\nB1;25.010\nMean;25.010\nMax;25.010\n", "Mean names a figure of several parts"),
        ("Feature;Measured;Status\nB1;25.010;OK\nB2;25.012;NOK\n", "the file itself rejects this value (NOK)"),
    ] {
        let files = [("h.csv", holes), ("s.csv", shafts)];
        let (code, err) = of(&files, &["pair", "h.csv", "s.csv", "--clearance", "0.01..0.05"]);
        assert!(code == 1 && err.contains(says), "{code}: {err}");
    }
}

/// The mean circle is good, and two points across it are 80 µm out at both ends.
#[test]
fn a_bore_that_is_oval_beyond_its_zone_is_looked_at_first() {
    let oval = "x;y\n12.55;0\n0;12.46\n-12.55;0\n0;-12.46\n";
    let (code, err) = of(&[("c.csv", oval)], &["check", "25 H7", "--contacts", "c.csv"]);
    assert!(code == 14 && err.contains("contacts 2 and 4 is 24.92 mm"), "{code}: {err}");
    let round = "x;y\n12.505;0\n0;12.506\n-12.505;0\n0;-12.506\n";
    assert_eq!(of(&[("c.csv", round)], &["check", "25 H7", "--contacts", "c.csv"]).0, 0);
}

/// Across two contacts the size is beyond a limit that the mean circle keeps: 25 H7 is 25.000 … 25.021.
#[test]
fn a_size_across_two_contacts_that_is_out_is_looked_at_first() {
    let four = |one: &str, other: &str| format!("x;y\n{one};0\n0;{other}\n-{one};0\n0;-{other}\n");
    let at = |radius: f64, angles: &[f64]| {
        let line = |angle: &f64| {
            let (sin, cos) = angle.to_radians().sin_cos();
            format!("{:.7};{:.7}\n", radius * cos, radius * sin)
        };
        format!("x;y\n{}", angles.iter().map(line).collect::<String>())
    };
    for (contacts, code, says) in [
        (four("12.498", "12.507"), 14, "contacts 1 and 3 is 24.996 mm, beyond the limit of 25 mm"),
        (four("12.503", "12.511"), 14, "contacts 2 and 4 is 25.022 mm, beyond the limit of 25.021 mm"),
        // On the limits, and one nanometre beyond.
        (four("12.5", "12.5105"), 0, ""),
        (four("12.5", "12.5105005"), 14, "25.021001 mm"),
        (four("12.4999995", "12.5105"), 14, "24.999999 mm"),
        (four("12.5105", "12.5105"), 0, ""),
        // The mean is too small, too, and the verdict says so: rework.
        (four("12.49", "12.495"), 10, ""),
        // It is rework by the mean, and too large across two contacts.
        (four("12.48", "12.515"), 14, "25.03 mm"),
        // Nearly opposite: the chords are 24.9996 mm because they miss the centre, and the bore is round.
        (at(12.5002, &[0.0, 90.0, 180.9, 270.9]), 0, ""),
        // The size through the centre is 24.9996 mm.
        (at(12.4998, &[0.0, 180.9]) + at(12.505, &[90.0, 270.9]).trim_start_matches("x;y\n"), 14, "24.99"),
    ] {
        let (found, err) = of(&[("c.csv", &contacts)], &["check", "25 H7", "--contacts", "c.csv"]);
        assert!(found == code && err.contains(says), "{found}: {err}\n{contacts}");
    }
    // A part that was measured warm is compared as it is at 20 °C.
    let warm = |by: &str| {
        of(
            &[("c.csv", &four("12.509", by))],
            &["check", "25 H7", "--contacts", "c.csv", "--temperature", "26", "--material", "steel"],
        )
    };
    assert_eq!(warm("12.511").0, 0);
    assert_eq!(warm("12.512").0, 14);
}

#[test]
fn a_part_that_its_qif_file_rejects_is_looked_at_first() {
    let qif = include_str!("../data/qif/minimal_bore_25H7.qif");
    assert_eq!(of(&[("a.qif", qif)], &["import", "a.qif"]).0, 0);
    let parts: Vec<&str> = qif.split("<InspectionStatusEnum>PASS").collect();
    for at in 1..parts.len() {
        let (before, behind) = parts.split_at(at);
        let pass = "<InspectionStatusEnum>PASS";
        let text = format!("{}<InspectionStatusEnum>FAIL{}", before.join(pass), behind.join(pass));
        let (code, err) = of(&[("a.qif", &text)], &["import", "a.qif"]);
        assert!(code == 14 && err.contains("FAIL about the whole part"), "{code}: {err}");
    }
}

#[test]
fn a_name_of_a_mean_a_master_or_a_form_is_looked_at_first() {
    for name in
        ["Mean", "Max", "USL", "Cpk", "Setting master", "Mittelwert", "Roundness bore 1", "Rundheit B2", "Radius 3"]
    {
        both(&format!("Feature;Callout;Measured\nB1;25 H7;25.010\n{name};25 H7;25.011\n"), 14);
    }
    for name in ["Position 1", "Round bore", "Maxi 3", "Mean street bore"] {
        both(&format!("Feature;Callout;Measured\nB1;25 H7;25.010\n{name};25 H7;25.011\n"), 0);
    }
}

#[test]
fn other_sizes_beside_the_measured_ones_are_said() {
    for (names, cells) in [
        ("M1;M2", "25.05;24.9"),
        ("#2;#3", "25.05;24.9"),
        ("CMM;Local max", "25.05;25.10"),
        ("Reading 2b;n", "25.03;3"),
    ] {
        let code = of(
            &[("a.csv", &format!("Feature;Callout;{names};Measured\nB1;25 H7;{cells};25.013\n"))],
            &["import", "a.csv"],
        );
        assert_ne!(code.0, 0, "{names}");
    }
    both("Feature;Callout;Length;Measured;Tip\nB1;25 H7;25;25.013;3.000\n", 0);
    both("Feature;Callout;Measured;Temp\nB1;25 H7;25.013;21.3\nB2;30 H7;30.01;21.4\n", 0);
}

/// A good word with something against it is not good.
#[test]
fn a_word_that_is_put_in_doubt_is_looked_at() {
    for word in [
        "!OK",
        "≠OK",
        "OK?",
        "OK ✗",
        "❌ OK",
        "OK (Ausschuss)",
        "OK - NOK",
        "OK: rejected",
        "GOOD (blocked)",
        "NA",
        "NV",
    ] {
        beside("Verdict", word, 14);
    }
    for word in ["OK (checked twice)", "n/a", "n.v.t.", "i.O."] {
        beside("Verdict", word, 0);
    }
    for name in ["stato", "Prüfstatus", "Pru\u{308}fergebnis", "Inspection result", "OK/NOK", "OK-NOK"] {
        beside(name, "NOK", 14);
    }
}

/// Umlauts of two characters, and values of before the last operation or of another thing.
#[test]
fn a_value_of_before_or_of_something_else_is_none() {
    for name in [
        "fru\u{308}her gemessen",
        "Istmaß Rohteil",
        "Istmaß vorgedreht",
        "measured uncoated",
        "Istmaß Gegenstück",
        "Ist Prüfring",
    ] {
        both(&format!("Feature;Callout;{name}\nB1;25 H7;25.013\n"), 1);
    }
}

#[test]
fn what_is_compared_is_not_called_skipped() {
    let rows = "Feature;Callout;Measured;Status;USL;Remark\nB1;25 H7;25.013;OK;25.021;x\n";
    let (code, err) = of(&[("a.csv", rows)], &["import", "a.csv"]);
    assert!(code == 0 && err.contains("columns skipped: 6 (Remark)\n"), "{code}: {err}");
}

mod runs {
    //! Programs whose contacts are another feature's, or whose remarks are more than are listed.

    use super::of;

    fn bore(x: i32, maximum: &str) -> String {
        let inputs = [
            ("Q274", "+20"),
            ("Q262", "+25"),
            ("Q325", "+0"),
            ("Q247", "+90"),
            ("Q261", "-5"),
            ("Q320", "+0"),
            ("Q260", "+20"),
            ("Q301", "+0"),
            ("Q275", maximum),
            ("Q276", "+25"),
            ("Q279", "+0"),
            ("Q280", "+0"),
            ("Q281", "+0"),
            ("Q309", "+0"),
            ("Q330", "+0"),
            ("Q423", "+4"),
            ("Q365", "+1"),
        ];
        let inputs: Vec<String> = inputs.iter().map(|(name, value)| format!("{name}={value}")).collect();
        format!("TCH PROBE 421 MEASURE HOLE ~\nQ273=+{x} ~\n{}\n", inputs.join(" ~\n"))
    }

    fn program(blocks: &str) -> String {
        format!("0 BEGIN PGM A MM\nTOOL CALL 1 Z S100\n{blocks}M30\nEND PGM A MM\n")
    }

    #[test]
    fn contacts_of_another_bore_are_looked_at_first() {
        let two = program(&(bore(10, "+25.021") + &bore(40, "+25.13")));
        let (a, b) = (
            "22.55,20,-5\n10,32.55,-5\n-2.55,20,-5\n10,7.45,-5\n",
            "52.505,20,-5\n40,32.505,-5\n27.495,20,-5\n40,7.495,-5\n",
        );
        for (order, code) in [(format!("x,y,z\n{a}{b}"), 11), (format!("x,y,z\n{b}{a}"), 14)] {
            let files = [("a.h", two.as_str()), ("c.csv", order.as_str())];
            let (found, err) = of(&files, &["run", "a.h", "--contacts", "c.csv"]);
            assert_eq!(found, code, "{err}");
        }
        let far = format!("x,y,z\n{b}");
        let one = program(&bore(10, "+25.021"));
        let files = [("a.h", one.as_str()), ("c.csv", far.as_str())];
        let (found, err) = of(&files, &["cycle", "421", "--block", "a.h", "--contacts", "c.csv"]);
        assert_eq!(found, 14, "{err}");
    }

    #[test]
    fn a_measurement_that_was_skipped_behind_a_thousand_remarks_is_looked_at_first() {
        let mills = "L X+100 Y+20 Z-5 R0 FMAX\nL X+101 Y+20 Z-5 R0 FMAX\n".repeat(550);
        let skipped = "TCH PROBE 430 BOLT HOLE CIRC ~\nQ273=+0 ~\nQ274=+0\n";
        let blocks = format!("{mills}L Z+50 R0 FMAX\n{skipped}{}", bore(10, "+25.021"));
        let workpiece = "[[feature]]\nname = \"A\"\nkind = \"bore\"\ncentre = [10, 20]\ndiameter = 25.01\nbottom = -20\n\
            [[feature]]\nname = \"BOSS\"\nkind = \"boss\"\ncentre = [100, 20]\nlengths = [40, 40]\ntop = 0\nbottom = -20\n";
        let files = [("a.h", program(&blocks)), ("p.toml", workpiece.to_owned())];
        let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
        let (code, err) = of(&files, &["run", "a.h", "--skip-unknown", "--workpiece", "p.toml"]);
        assert!(code == 14 && err.contains("more remarks are not listed"), "{code}: {err}");
    }

    /// The mean circle is good; across the contacts it is 25.040 and 24.980.
    #[test]
    fn an_oval_bore_with_a_good_mean_circle_is_looked_at_first() {
        let contacts = |a: &str, b: &str| format!("x,y,z\n{a},20,-5\n10,{b},-5\n-2.52,20,-5\n10,7.51,-5\n");
        for oval in [contacts("22.52", "32.49"), contacts("22.512", "32.499")] {
            let files = [("a.h", program(&bore(10, "+25.021"))), ("c.csv", oval)];
            let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
            for args in
                [&["run", "a.h", "--contacts", "c.csv"][..], &["cycle", "421", "--block", "a.h", "--contacts", "c.csv"]]
            {
                let (found, err) = of(&files, args);
                assert_eq!(found, 14, "{args:?}: {err}");
            }
        }
        let round = "x,y,z\n22.505,20,-5\n10,32.505,-5\n-2.505,20,-5\n10,7.495,-5\n";
        let files = [("a.h", program(&bore(10, "+25.021"))), ("c.csv", round.to_owned())];
        let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
        assert_eq!(of(&files, &["run", "a.h", "--contacts", "c.csv"]).0, 0);
    }

    #[test]
    fn a_block_whose_coordinates_were_moved_is_looked_at_first() {
        for (lines, code) in [
            ("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+15\n", 14),
            ("CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.99\n", 14),
            ("PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n", 14),
            ("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+0\n", 0),
            ("", 0),
        ] {
            let files = [("a.h", program(&format!("{lines}{}", bore(10, "+25.021"))))];
            let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
            let (found, err) = of(&files, &["cycle", "421", "--block", "a.h"]);
            assert_eq!(found, code, "{lines}: {err}");
        }
    }

    #[test]
    fn a_block_without_its_limits_beside_a_good_one_is_looked_at_first() {
        let unlimited = bore(60, "+25.021").replace("Q275=+25.021 ~\nQ276=+25 ~\n", "");
        let files = [("a.h", program(&(bore(10, "+25.021") + &unlimited)))];
        let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
        let (code, err) = of(&files, &["run", "a.h"]);
        assert_eq!(code, 14, "{err}");
        // Alone, too; limits of zero are a measurement that nobody judges.
        let zero = unlimited.replacen("Q262", "Q275=+0 ~\nQ276=+0 ~\nQ262", 1);
        for (block, code) in [(unlimited, 14), (zero, 0)] {
            let files = [("a.h", program(&block))];
            let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
            for args in [&["run", "a.h"][..], &["cycle", "421", "--block", "a.h"]] {
                let (found, err) = of(&files, args);
                assert_eq!(found, code, "{args:?}: {err}");
            }
        }
        // Typed, nothing was left out.
        let typed = ["cycle", "421", "--set", "Q273=50", "Q274=50", "Q262=25"];
        assert_eq!(of(&[], &typed).0, 0);
        // Old controls have no Q423 and no Q365.
        let old = bore(10, "+25.021").replace(" ~\nQ423=+4 ~\nQ365=+1", "");
        let files = [("a.h", program(&old))];
        let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
        assert_eq!(of(&files, &["run", "a.h"]).0, 0);
    }

    #[test]
    fn a_measuring_cycle_behind_the_end_is_looked_at_first() {
        let text = format!(
            "0 BEGIN PGM A MM\nTOOL CALL 1 Z S100\n{}END PGM A MM\n{}",
            bore(10, "+25.021"),
            bore(60, "+25.021")
        );
        let (code, err) = of(&[("a.h", text.as_str())], &["run", "a.h"]);
        assert_eq!(code, 14, "{err}");
    }

    #[test]
    fn a_part_that_was_turned_is_looked_at_first() {
        let files = [("a.h", program(&format!("L C+90 R0 FMAX\n{}", bore(10, "+25.021"))))];
        let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
        let contacts = [files[0], ("c.csv", "x,y,z\n22.505,20,-5\n10,32.505,-5\n-2.505,20,-5\n10,7.495,-5\n")];
        let (code, err) = of(&contacts, &["run", "a.h", "--contacts", "c.csv"]);
        assert!(code == 14 && err.contains("as if it had not been turned"), "{code}: {err}");
    }
}

/// TOML itself refuses the same spelling alone.
#[test]
fn a_key_of_a_plan_in_two_spellings_is_refused() {
    let head = "fitcheck_plan = 1\npart = \"One\"\n";
    let feature = "[[feature]]\nname = \"A\"\ncallout = \"25 H11\"\n";
    for text in [
        format!("{head}{feature}Callout = \"25 H7\"\n"),
        format!("{head}rule = \"simple\"\nRULE = \"iso14253-2017\"\n{feature}"),
    ] {
        let (code, err) = of(&[("p.toml", &text)], &["plan", "check", "p.toml"]);
        assert!(code == 1 && err.contains("occurs twice"), "{code}: {err}");
    }
}

/// One size of each part: the serial number names the row, and is a serial number all the same.
#[test]
fn a_serial_number_that_names_the_rows_is_found_as_one() {
    let folder = tempfile::tempdir().unwrap();
    for (name, head, row) in [
        ("a.csv", "callout;Istmaß;Seriennummer", "25 H7;25,05;S1"),
        ("b.csv", "callout;measured;serial;part", "25 H7;25.05;S2;Flange"),
    ] {
        fitcheck::files::write(&folder.path().join(name), format!("{head}\n{row}\n").as_bytes()).unwrap();
        assert_eq!(within(folder.path(), &["import", name, "--record"]).0, 11);
    }
    for serial in ["serial:S1", "serial:S2"] {
        let mut command = cargo_bin_cmd!("fitcheck");
        let command = command.current_dir(folder.path()).env("FITCHECK_JOURNAL", folder.path().join("j.sqlite"));
        let output = command.at_home(folder.path().join("home")).args(["journal", "list", serial]).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.contains("SCRAP"), "{serial}: {text}");
    }
}

/// A feature may be called like a quantity: in a file of Fitcheck that is its name.
#[test]
fn a_name_in_a_file_of_fitcheck_is_no_quantity() {
    let folder = tempfile::tempdir().unwrap();
    let rows = "name;callout;measured\nDiameter:;25 H7;25.0134\n";
    fitcheck::files::write(&folder.path().join("a.csv"), rows.as_bytes()).unwrap();
    let mut command = cargo_bin_cmd!("fitcheck");
    let written =
        command.current_dir(folder.path()).args(["import", "a.csv", "--format", "csv"]).output().unwrap().stdout;
    fitcheck::files::write(&folder.path().join("b.csv"), &written).unwrap();
    let mut command = cargo_bin_cmd!("fitcheck");
    let again = command.current_dir(folder.path()).args(["import", "b.csv", "--format", "csv"]).output().unwrap();
    let text = String::from_utf8(again.stdout).unwrap();
    assert!(again.status.code() == Some(0) && text.contains("Diameter:,"), "{text}");
}

/// A part measured warm is larger than at 20 °C: by 8 µm at 35 °C, of a zone of 21.
#[test]
fn a_temperature_beside_the_value_that_nobody_counted_is_told() {
    for (name, cell) in [
        ("Temperature", "35"),
        ("Temp [°C]", "35,0"),
        ("Part temperature", "35 °C"),
        ("Werkstücktemperatur", "35"),
        ("T (°C)", "35"),
        ("Temperature [°F]", "95"),
        ("temperatuur", "35"),
        ("Temperatura [K]", "308"),
        ("Remark", "part at 35 °C"),
        ("Remark", "after hardening still 45 °C"),
        ("Remark", "not compensated, 35 °C"),
        ("Temp. Teil nach Kühlung", "35"),
        ("Temperature", "ca. 35 °C"),
        ("Temperature", "35-36"),
        ("Temperature", "> 30"),
        ("Werkstück [°C]", "35"),
        ("t_part", "35"),
        ("Bauteil-T", "35"),
        ("ΔT [K]", "15"),
        ("Temp 1", "35"),
        ("Temp [°C] uncorrected", "35"),
    ] {
        beside(name, cell, 14);
    }
    for (name, cell) in [
        ("Temperature", "20"),
        ("Temperature", "20.6"),
        ("Temperature [°F]", "68"),
        ("Temperature [K]", "293,15"),
        ("Temperature", ""),
        ("Spindle temperature", "45"),
        ("Kühlmitteltemperatur", "35"),
        ("Remark", "cleaned at 80 °C"),
        ("Remark", "20 °C ± 1 °C"),
        ("Remark", "30° C-axis"),
        ("Remark", "lavato a 45 °C"),
        ("Temperature uncertainty", "0.5"),
        ("Temp drift [K]", "0.2"),
        ("Temperature limit", "30"),
        ("Werkzeugtemperatur", "40"),
        ("Temp. difference [K]", "0.2"),
    ] {
        beside(name, cell, 0);
    }
    let rows = "Feature;Callout;Measured\nB1;25 H7;25.013\n";
    for line in [
        "# Werkstücktemperatur: 35 °C",
        "Part temperature 35 °C",
        "Messbericht;35 °C",
        "# temperatuur 35,5 graden Celsius",
        "Part temperature: 35.0C",
        "Temperature;35.0",
        "Temp. 35",
        "Temperatur [°C];35,0",
        "# Reference temperature 20 °C, part measured at 35 °C",
        "# Temp. comp. off, 35 °C",
        "# Spindle 40 °C / workpiece 35 °C",
        "# part -3 °C",
        "# Part temperature;35",
    ] {
        both(&format!("{line}\n{rows}"), 14);
        both(&format!("{rows}# {line}\n"), 14);
    }
    for line in [
        // Of a zone of 21 µm, 1.5 K are less than a tenth.
        "# Raumtemperatur 21,5 °C",
        "# corrected from 35 °C to 20 °C",
        "# Werte auf 20 °C umgerechnet",
        "# ambient 27 °C, part 20 °C",
        "# Ambient 27 °C\n# Part 20 °C",
        "# 20 °C",
    ] {
        both(&format!("{line}\n{rows}"), 0);
    }
}

#[test]
fn a_temperature_in_the_names_of_columns_or_below_them_is_compared() {
    both("Feature;Callout;Measured [mm, 35 °C]\nB1;25 H7;25.013\n", 14);
    both("Feature;Callout;Measured (not compensated) [mm, 35 °C]\nB1;25 H7;25.013\n", 14);
    both("Feature;Callout;Measured;Temp\n;;;°C\nB1;25 H7;25.013;20\n", 0);
    both("Feature;Callout;Measured;Temp\n;;mm;K\nB1;25 H7;25.013;308\n", 14);
    both("Feature;Callout;Measured;Temp\n;;mm;°F\nB1;25 H7;25.013;68\n", 0);
    both("Feature;Callout;Measured;Temp\nB1;25 H7;25.013;308\n", 14);
    both("Feature;Callout;Measured;Ambient temperature;Part temperature\nB1;25 H7;25.013;27;20\n", 0);
    both("Feature;Callout;Measured;Ambient temperature\nB1;25 H7;25.013;29\n", 14);
    both("Feature;Callout;Measured (compensated to 20 °C)\nB1;25 H7;25.013\n", 0);
    both("Feature;Callout;Measured at 20 °C\nB1;25 H7;25.013\n", 0);
    both("Feature;Callout;Measured [mm, 20 °C]\nB1;25 H7;25.013\n", 0);
}

#[test]
fn a_temperature_that_counts_is_not_told_again() {
    let text = "Feature;Callout;Measured;Temperature\nB1;25 H7;25.013;35\n";
    let warm =
        |temperature: &str| ["import", "--temperature", temperature, "--material", "steel", "a.csv"].map(str::to_owned);
    for (temperature, code) in [("35", 0), ("28", 14)] {
        let args = warm(temperature);
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let (found, err) = of(&[("a.csv", text)], &args);
        assert_eq!(found, code, "{temperature}: {err}");
        if code == 14 {
            assert!(err.contains("Temperature 35"), "{err}");
        }
    }
    let plan = "fitcheck_plan = 1\npart = \"P\"\n[[feature]]\nname = \"B1\"\ncallout = \"25 H7\"\n";
    for (more, code) in [(&["--temperature", "35", "--material", "steel"][..], 0), (&[], 14)] {
        let args: Vec<&str> =
            ["import", "--plan", "p.toml"].into_iter().chain(more.iter().copied()).chain(["a.csv"]).collect();
        let (found, err) = of(&[("a.csv", text), ("p.toml", plan)], &args);
        assert_eq!(found, code, "{err}");
    }
}

/// Below the second header, 25.013 is the nominal size and 25 the value: by the first header it would be good.
#[test]
fn rows_below_another_header_are_judged_by_none() {
    let first = "Feature;Callout;Nominal;Measured\nB1;H7;25;25.013\n";
    for (second, judged) in [
        ("Feature;Callout;Measured;Nominal\nB2;H7;25;25.013\n", 1),
        ("Feature;Callout;Nominal;Measured [µm]\nB2;H7;25;25.013\n", 0),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fitcheck::files::write(&folder.path().join("a.csv"), format!("{first}{second}").as_bytes()).unwrap();
        let mut command = cargo_bin_cmd!("fitcheck");
        let output = command.current_dir(folder.path()).args(["import", "a.csv"]).output().unwrap();
        let out = String::from_utf8(output.stdout).unwrap();
        assert_eq!((output.status.code(), out.matches("ISO 286").count()), (Some(1), judged), "{second}: {out}");
        both(&format!("{first}{second}"), 1);
    }
}

/// 25.013 between four contacts, on a part that was warm.
#[test]
fn a_temperature_in_a_file_of_contacts_is_told() {
    let contacts = "x;y\n12.5065;0\n0;12.5065\n-12.5065;0\n0;-12.5065\n";
    let in_column = "x;y;Temp\n12.5065;0;20\n0;12.5065;35\n-12.5065;0;35\n0;-12.5065;35\n";
    let block = "TCH PROBE 421 MEASURE HOLE ~\n Q273=+0 ~\n Q274=+0 ~\n Q262=+25 ~\n Q275=+25.021 ~\n Q276=+25";
    for (text, code) in [(contacts, 0), (&format!("# part 35 °C\n{contacts}"), 14), (in_column, 14)] {
        let files = [("c.csv", text), ("b.h", block)];
        for args in [
            &["check", "25 H7", "--contacts", "c.csv"][..],
            &["cycle", "421", "--block", "b.h", "--contacts", "c.csv"],
            &["import", "c.csv"],
        ] {
            let (found, err) = of(&files, args);
            // A file of contacts alone says nothing of its limits.
            let code = if args.contains(&"import") { found } else { code };
            assert_eq!(found, code, "{args:?}: {err}");
            assert_eq!(err.contains("mentions a temperature other than"), text != contacts, "{args:?}: {err}");
        }
    }
    let args = ["check", "25 H7", "--contacts", "c.csv", "--temperature", "35", "--material", "steel"];
    assert_eq!(of(&[("c.csv", in_column)], &args).0, 0);
}

/// As where two exports were put together, or pages were printed.
#[test]
fn the_same_header_once_more_is_no_row() {
    let text = "Feature;Callout;Measured\nB1;25 H7;25.013\nfeature; Callout;Measured\nB2;25 H7;25.013\n";
    both(text, 0);
    let (_, err) = of(&[("a.csv", text)], &["import", "a.csv"]);
    assert!(err.contains("a.csv:3"), "{err}");
}

/// What makes the exit code 14 stands in what machines read, too.
#[test]
fn what_stands_against_all_values_of_a_file_is_a_row_for_machines() {
    let folder = tempfile::tempdir().unwrap();
    let text = "Feature;Callout;Measured\nB1;25 H7;25.013\n# part 35 °C\n# Meier\n";
    fitcheck::files::write(&folder.path().join("a.csv"), text.as_bytes()).unwrap();
    let out = |format: &str| {
        let mut command = cargo_bin_cmd!("fitcheck");
        let output = command.current_dir(folder.path()).args(["import", "a.csv", "--format", format]).output().unwrap();
        assert_eq!(output.status.code(), Some(14));
        String::from_utf8(output.stdout).unwrap()
    };
    let json: serde_json::Value = serde_json::from_str(&out("json")).unwrap();
    let [value, told] = json.as_array().unwrap().as_slice() else { panic!("{json}") };
    assert_eq!((&value["status"], &value["line"]), (&"GOOD".into(), &2.into()));
    assert_eq!((&told["status"], &told["measured_mm"], &told["line"]), (&().into(), &().into(), &3.into()));
    assert!(told["warnings"][0].as_str().unwrap().contains("# part 35 °C"), "{told}");
    assert_eq!(out("csv").lines().filter(|line| line.contains("# part 35 °C")).count(), 1);
}

/// Somebody wrote it where nothing stood in a thousand rows.
#[test]
fn a_remark_far_down_counts_as_one_in_the_first_row() {
    let rows = |last: &str| {
        let plain = |at: usize| {
            format!("B{at};25 H7;25.013;{};SN-{at:06}\n", if at.is_multiple_of(3) { "burr 3 mm" } else { "" })
        };
        let rows: String = (1..1000).map(plain).collect();
        format!("Feature;Callout;Measured;Bemerkung;Code\n{rows}B1000;25 H7;25.013;{last};SN-001000\n")
    };
    for (last, code) in [
        ("rejected", 14),
        ("n.i.O.", 14),
        ("NOK: Grat", 14),
        ("simulated", 14),
        ("all values in inch", 14),
        ("thread 1/4 inch", 0),
        ("depth 3 mm", 0),
        ("part at 35 °C", 14),
        ("Teil 35C", 14),
        ("part 308 K", 14),
        ("burr 4 mm", 0),
        ("part at 20 °C", 0),
        ("OK", 0),
        ("", 0),
    ] {
        both(&rows(last), code);
    }
    // In the first row as well, and over several lines; import refuses these lines.
    both("Feature;Callout;Measured;Remark\nB1;25 H7;25.013;all values in inch\n", 14);
    let lines = "Feature;Callout;Measured;Remark\nB1;25 H7;25.013;\"first line\nall values in inch\"\n";
    for (args, code) in [(["import", "a.csv"], 1), (["batch", "a.csv"], 14)] {
        assert_eq!(of(&[("a.csv", lines)], &args).0, code, "{args:?}");
    }
    for name in ["Mean", "Rundheit", "Master ring"] {
        both(&rows("").replace("\nB1000;", &format!("\n{name};")), 14);
    }
}
