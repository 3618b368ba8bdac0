//! Several columns that could be the measured value, and several quantities of one name: a wrong one is never taken in silence.

use std::io::Cursor;
use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::exchange::{ByPlan, FirstRows, ImportInputs, Item, Mapping, Role, import_from};
use fitcheck::part::Document;
use fitcheck::tolerance::Sources;

use crate::at_home::AtHome as _;

/// The answer of the program.
struct Answer {
    code: i32,
    out: String,
    err: String,
}

impl Answer {
    fn said(&self) -> String {
        format!("{}{}", self.out, self.err)
    }
}

struct Place(tempfile::TempDir);

impl Place {
    fn of(files: &[(&str, &str)]) -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        for (name, text) in files {
            fitcheck::files::write(&place.0.path().join(name), text.as_bytes()).unwrap();
        }
        place
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn say(&self, args: &[&str]) -> Answer {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.env_remove("FITCHECK_JOURNAL");
        let output = command.at_home(self.path()).current_dir(self.path()).args(args).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        Answer { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
    }
}

/// Every command refuses a file whose columns may be meant otherwise, and names them.
#[track_caller]
fn asked_about(text: &str, columns: &str) {
    let place = Place::of(&[("m.csv", text)]);
    let words = format!("columns {columns} may each be the measured value");
    for args in [
        &["import", "m.csv"][..],
        &["batch", "m.csv"],
        &["batch", "m.csv", "-o", "m.tsv"],
        &["batch", "m.csv", "-o", "m.jsonl"],
        &["report", "m.csv", "-o", "r.html"],
        &["pair", "--clearance", "0..0.1", "m.csv", "m.csv"],
    ] {
        let answer = place.say(args);
        assert!(
            answer.code == 1 && answer.said().contains(&words),
            "{args:?}\n{text}{}\n{}",
            answer.code,
            answer.said()
        );
    }
    // The window asks: nothing is chosen for any of them.
    let first = FirstRows::of("m.csv", text.as_bytes()).unwrap();
    assert!(first.detect(&Mapping::default()).is_err(), "{text}");
    assert!(!first.guess(&Mapping::default()).roles.contains(&Some(Role::Measured)), "{text}");
}

/// Import and batch take the column of this value, and tell that another one is skipped.
#[track_caller]
fn taken(text: &str, value: &str, skipped: &str) {
    let place = Place::of(&[("m.csv", text)]);
    let answer = place.say(&["import", "m.csv", "--format", "csv"]);
    // What stands against all values is a row without one.
    let cells = answer.out.lines().skip(1).filter_map(|line| line.split(',').nth(7));
    let measured: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
    assert_eq!(measured, [value], "{text}{}", answer.said());
    assert!(answer.err.contains(skipped), "{text}{}", answer.said());
    let answer = place.say(&["batch", "m.csv"]);
    assert!(answer.code != 1 && answer.err.contains(skipped), "{text}{}", answer.said());
}

#[test]
fn an_exact_name_does_not_win_over_another_column_that_may_be_the_value() {
    for (one, other) in [
        ("measured", "measured after honing"),
        ("actual", "final measured value"),
        ("Istwert", "Istwert nach Honen"),
        ("gemeten", "gemeten na honen"),
        ("misurato", "misurato dopo levigatura"),
        ("measured", "measured 2"),
        ("measured left", "measured right"),
        ("Messwert 1", "Messwert 2"),
        ("Messwert L", "Messwert R"),
        ("Meting voor", "Meting achter"),
        ("prima misurazione", "seconda misurazione"),
        ("measured", "gemeten voor"),
        ("MEAS", "ACT"),
    ] {
        let text = format!("id;callout;{one};{other}\nA;25 H7;25.012;25.030\n");
        asked_about(&text, &format!("3 ({one}), 4 ({other})"));
    }
    // A size that is not the nominal one may be the value, too.
    asked_about("id;callout;measured;diameter\nA;25 H7;25.012;25.030\n", "3 (measured), 4 (diameter)");
    asked_about("id;nominal;measured;Ø\nA;25;25.012;25.030\n", "3 (measured), 4 (Ø)");
}

#[test]
fn the_user_says_which_column_is_the_value() {
    let place = Place::of(&[("m.csv", "id;callout;measured;measured after honing\nA;25 H7;25.012;25.030\n")]);
    for (column, code, value) in [("measured=3", 0, "25.012"), ("measured=4", 11, "25.030")] {
        let answer = place.say(&["import", "m.csv", "--columns", column, "--format", "csv"]);
        assert_eq!((answer.code, answer.out.contains(&format!(",{value},"))), (code, true), "{}", answer.said());
    }
    assert!(place.say(&["import", "m.csv"]).said().contains("choose one with import --columns, such as measured=3"));
}

#[test]
fn what_was_measured_before_or_at_a_master_is_no_value_and_is_told() {
    for name in [
        "measured before honing",
        "actual before",
        "master measured",
        "measured setting ring",
        "calibration actual",
        "measured reference",
        "measured zero",
        "Istwert vor dem Honen",
        "Istwert vor",
        "Istwert vorher",
        "Istwert Einstellring",
        "Messwert Meister",
        "Messwert Kalibrierung",
        "gemeten voor honen",
        "gemeten vóór honen",
        "gemeten instelring",
        "meetwaarde kalibratie",
        "misurato prima di levigatura",
        "valore misurato azzeramento",
        "misurato master",
    ] {
        let skipped = format!("columns skipped: 3 ({name})");
        taken(&format!("id;callout;{name};measured\nA;25 H7;25.030;25.012\n"), "25.012", &skipped);
        // By itself it is not the value either.
        let place = Place::of(&[("m.csv", &format!("id;callout;{name}\nA;25 H7;25.012\n"))]);
        let answer = place.say(&["import", "m.csv"]);
        assert!(answer.code == 1 && answer.err.contains("no column of measured values"), "{name}: {}", answer.said());
    }
    // Beside what was measured after, "voor" and "prima" are before.
    taken("id;callout;gemeten voor;gemeten na\nA;25 H7;25.030;25.012\n", "25.012", "columns skipped: 3 (gemeten voor)");
    taken("id;callout;misura prima misurata;misurata dopo\nA;25 H7;25.030;25.012\n", "25.012", "columns skipped: 3");
    // On the spot is not before.
    taken("id;callout;Messwert vor Ort;shift\nA;25 H7;25.012;1\n", "25.012", "columns skipped: 4 (shift)");
}

#[test]
fn a_nominal_size_or_callout_that_stands_twice_says_the_same_or_is_asked_about() {
    for (text, words) in [
        (
            "id;callout;callout after coating;measured\nA;25 H7;25 F8;25.03\n",
            "columns 2 (callout), 3 (callout after coating)",
        ),
        ("id;nominal;nominal new;class;measured\nA;25;30;H7;25.01\n", "columns 2 (nominal), 3 (nominal new)"),
    ] {
        let place = Place::of(&[("m.csv", text)]);
        for command in ["import", "batch"] {
            let answer = place.say(&[command, "m.csv"]);
            assert!(answer.code == 1 && answer.said().contains(words), "{text}{}", answer.said());
        }
    }
    for text in [
        "id;callout;class;measured\nA;25 H7;H7;25.012\n",
        "id;callout;diameter;measured\nA;25 H7;25.000;25.012\n",
        "id;nominal;nominal size;class;measured\nA;25;25.0;H7;25.012\n",
    ] {
        let place = Place::of(&[("m.csv", text)]);
        for command in ["import", "batch"] {
            let answer = place.say(&[command, "m.csv"]);
            let is_asked = text.contains("nominal size");
            assert_eq!(answer.code, i32::from(is_asked), "{text}{}", answer.said());
        }
    }
}

/// The words of a column that is no size of a bore, as software of measuring machines and people write them.
const OTHERS: &[&str] = &[
    "X",
    "y",
    "Z",
    "R",
    "radius",
    "Radius",
    "TP",
    "PR",
    "PA",
    "A",
    "True position",
    "Position",
    "roundness",
    "Flatness",
    "depth",
    "angle",
    "M",
    "L",
    "Distance",
    "Rundheit",
    "Halbmesser",
    "Ebenheit",
    "Rechtwinkligkeit",
    "Tiefe",
    "Lage",
    "Rundlauf",
    "Zylinderform",
    "Abstand",
    "straal",
    "rondheid",
    "vlakheid",
    "diepte",
    "positie",
    "haaksheid",
    "slingering",
    "raggio",
    "rotondità",
    "planarità",
    "profondità",
    "posizione",
    "perpendicolarità",
    "⌖",
    "○",
    "Circularity (LSC)",
    "X coordinate",
    "Point",
    "Koaxialität",
    "Ruwheid",
    "Symmetrie",
];

const SIZES: &[&str] = &[
    "D",
    "DIA",
    "Diameter",
    "diameter",
    "Durchmesser",
    "Innendurchmesser",
    "diametro",
    "⌀",
    "Ø",
    "ID",
    "size",
    "Maß",
    "maat",
    "Inner diameter",
    "Bohrung",
    "hole",
    "",
];

const PLAN: &str = "name;callout\nBORE_A;25 H7\n";

/// What a plan makes of a file: a status, or why there is none.
fn judged(plan: &str, name: &str, bytes: &[u8]) -> Vec<String> {
    let sources = Sources::default();
    let plan = Document::read(plan.as_bytes()).unwrap().plan(&sources).unwrap();
    let by_plan = ByPlan::new(&plan);
    let given =
        ImportInputs { has_plan: true, ..ImportInputs::new(&sources, jiff::civil::date(2026, 11, 25).at(0, 0, 0, 0)) };
    let mut said = Vec::new();
    import_from(name, &mut Cursor::new(bytes), given, &mut |item| {
        by_plan.item(item, &mut |item| match item {
            Item::Record { record, .. } => said.push(record.verdict.status().word().to_owned()),
            Item::Unjudged(unjudged) => said.push(unjudged.why.to_string()),
            Item::Error(error) => said.push(error.to_string()),
            Item::Warning(_) | Item::Contacts(_) => {}
        });
    });
    said
}

/// The names of columns that say what was measured.
const COLUMNS: &[&str] = &[
    "AXIS",
    "Achse",
    "as",
    "asse",
    "Type",
    "Typ",
    "tipo",
    "Merkmalsart",
    "characteristic type",
    "quantity",
    "Dimension",
    "kenmerktype",
];

#[test]
fn a_row_of_another_quantity_is_not_the_bore_of_the_same_name() {
    for column in COLUMNS {
        for other in OTHERS {
            let text = format!("name;{column};nominal;measured\nBORE_A;Diameter;25;25.012\nBORE_A;{other};25;25.040\n");
            let said = judged(PLAN, "m.csv", text.as_bytes());
            let is_told = said
                .get(1)
                .is_some_and(|why| why.contains("not a size") || why.contains("something else was measured"));
            assert!(said.len() == 2 && said[0] == "GOOD" && is_told, "{column}: {other}: {said:?}");
            let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(';').collect()).collect();
            let rows: Vec<&[&str]> = rows.iter().map(Vec::as_slice).collect();
            assert_eq!(judged(PLAN, "m.xlsx", &crate::xlsx::workbook(&rows)), said, "{column}: {other}");
        }
    }
}

/// By itself, without a row that says a diameter; in the last column, it is a row of its own all the same.
#[test]
fn a_radius_is_never_a_diameter() {
    for column in ["AXIS", "Type", "Typ", "Merkmalsart", "quantity"] {
        for radius in ["R", "radius", "Radius", "Halbmesser", "straal", "raggio"] {
            let text = format!("name;measured;{column}\nBORE_A;25.012;{radius}\n");
            let said = judged(PLAN, "m.csv", text.as_bytes());
            assert_eq!(said, [format!("{radius}: not a size of a hole or shaft")], "{column}");
        }
    }
    for name in ["measured radius", "Radius", "Istwert Radius", "gemeten straal", "raggio misurato", "measured R"] {
        let said = judged(PLAN, "m.csv", format!("name;{name}\nBORE_A;25.012\n").as_bytes());
        assert!(said[0].contains("no column of measured values"), "{name}: {said:?}");
    }
}

#[test]
fn a_word_of_a_size_is_one() {
    for column in COLUMNS.iter().filter(|column| **column != "as") {
        for size in SIZES {
            let text = format!("name;{column};measured\nBORE_A;{size};25.030\n");
            assert_eq!(judged(PLAN, "m.csv", text.as_bytes()), ["SCRAP"], "{column}: {size}");
        }
    }
}

/// A characteristic of AQDEF, with its quantity, nominal size and limits.
fn aqdef(entries: &str) -> String {
    format!("K0100 1\nK1001/1 P\nK2001/1 1\nK2002/1 BORE_A\n{entries}K2142/1 mm\nK0001/1 25.012\nK0002/1 0\n")
}

#[test]
fn files_of_other_tools_with_another_quantity_or_nominal_size_are_not_that_feature() {
    let other = "its nominal size is 40 and the plan's is 25";
    let limits = "its limits 39.9 … 40.1 have nothing in common with the plan's 25 … 25.021";
    for (entries, words) in [
        ("K2009/1 202\nK2101/1 25\nK2110/1 25\nK2111/1 25.021\n", "GOOD"),
        // The smaller limit stands for a nominal size that is not there.
        ("K2009/1 202\nK2110/1 24.9\nK2111/1 25.1\nK2115/1 25.1\n", "GOOD"),
        ("K2009/1 202\nK2101/1 40\nK2110/1 39.9\nK2111/1 40.1\n", other),
        ("K2009/1 202\nK2101/1 40\nK2103/1 H\nK2104/1 7\n", other),
        ("K2101/1 40\n", other),
        ("K2009/1 202\nK2110/1 39.9\nK2111/1 40.1\n", limits),
        ("K2009/1 202\nK2110/1 39.9\nK2111/1 40.1\nK2115/1 40.1\n", limits),
        ("K2009/1 202\nK2111/1 0.02\n", "its limits … 0.02 have nothing in common"),
        ("K2009/1 102\nK2101/1 25\n", "roundness (K2009 is 102)"),
    ] {
        let said = judged(PLAN, "a.dfq", aqdef(entries).as_bytes());
        assert!(said.len() == 1 && said[0].contains(words), "{entries}{said:?}");
    }
    let header = "id\ttype\tidsymbol\tactual\tnominal\tuppertol\tlowertol\tdeviation\texceed\tunit\t\n";
    for (row, words) in [
        ("BORE_A\tD1\tdiameter\t25.012\t25\t0.021\t0\t0.012\t\tmm\t\n", "GOOD"),
        (
            "BORE_A\tD1\tdiameter\t40.012\t40\t0.021\t0\t0.012\t\tmm\t\n",
            "its limits 40 … 40.021 have nothing in common",
        ),
        ("BORE_A\tR1\tradius\t25.012\t25\t0.021\t0\t0.012\t\tmm\t\n", "not judged"),
        ("BORE_A\tX1\txValue\t25.012\t25\t0.021\t0\t0.012\t\tmm\t\n", "not judged"),
    ] {
        let said = judged(PLAN, "a_chr.txt", format!("{header}{row}END\n").as_bytes());
        assert!(said[0].contains(words), "{row}{said:?}");
    }
}

#[test]
fn batch_and_import_set_the_same_rows_aside() {
    let text = "id;callout;type;measured\nA;25 H7;Diameter;25.012\nA;25 H7;Radius;12.506\nA;25 H7;Depth;30.1\nA;25 H7;;25.013\nA;25 H7;D;25.030\n";
    let place = Place::of(&[("m.csv", text)]);
    let answer = place.say(&["import", "m.csv", "--format", "csv"]);
    assert_eq!(answer.code, 1, "{}", answer.said());
    for (line, words) in [(2, "GOOD"), (3, "Radius: not a size"), (4, "Depth: not a size"), (5, "GOOD"), (6, "SCRAP")] {
        let row = answer.out.lines().find(|row| row.starts_with(&format!("m.csv,{line},"))).unwrap();
        assert!(row.contains(words), "{row}");
    }
    for name in ["o.csv", "o.tsv", "o.jsonl"] {
        let answer = place.say(&["batch", "m.csv", "-o", name]);
        assert_eq!(answer.code, 1, "{}", answer.said());
        let made = fitcheck::text::decode(&fitcheck::files::read_file(&place.path().join(name)).unwrap()).into_owned();
        let counts = ["GOOD", "SCRAP", "REWORK", "not a size"].map(|word| made.matches(word).count());
        assert_eq!(counts, [2, 1, 0, 2], "{name}: {made}");
    }
    let answer = place.say(&["pair", "--clearance", "0..0.1", "m.csv", "m.csv"]);
    assert!(answer.said().contains("Radius: not a size"), "{}", answer.said());
}

/// A machine's export, as it is: the row D is the size.
#[test]
fn the_rows_of_a_measuring_machine_are_told_apart_by_their_axis() {
    let text = "PART NAME : PLATE-7\nSER NUMBER : 3\n\nFEATURE,AXIS,NOMINAL,MEAS,+TOL,-TOL,DEV,OUTTOL\n\
        BORE_A,D,25.000,25.012,0.021,0.000,0.012,0.000\nRING_B,D,203.200,203.212,0.100,-0.100,0.012,0.000\n\
        FLAT_C,,0.000,0.021,0.050,0.000,0.021,0.000\nBORE_A,X,40.000,40.004,0.050,-0.050,0.004,0.000\n\
        BORE_A,TP,0.000,0.032,0.100,0.000,0.032,0.000\n";
    let plan = "fitcheck_plan = 1\n[[feature]]\nname = \"BORE_A\"\ncallout = \"25 H7\"\n[[feature]]\nname = \"RING_B\"\n\
        callout = \"203.2 ±0.1\"\nfeature = \"shaft\"\n";
    let place = Place::of(&[("p.toml", plan), ("axes.csv", text)]);
    let answer = place.say(&["import", "--plan", "p.toml", "axes.csv", "--format", "csv"]);
    let said = answer.said();
    for words in [
        "axes.csv,5,BORE_A,25 H7,25,25.000,25.021,25.012,12,GOOD",
        "axes.csv,6,RING_B,203.2 ±0.1,203.2,203.100,203.300,203.212,12,GOOD",
        "X: not a size",
        "TP: not a size",
        "read for all values: PART NAME PLATE-7, SER NUMBER 3",
    ] {
        assert!(said.contains(words), "{words}\n{said}");
    }
    assert!(!said.contains("skipped, not a measurement"), "{said}");
    assert!(answer.code == 1 && !said.contains("SCRAP") && !said.contains("REWORK"), "{said}");
    let answer = place.say(&["report", "axes.csv", "--plan", "p.toml", "-o", "r.csv"]);
    let made = std::fs::read_to_string(place.path().join("r.csv")).unwrap_or_default();
    assert!(made.contains("BORE_A") && !made.contains("SCRAP") && !made.contains("REWORK"), "{made}{}", answer.said());
    // Watched, recorded.
    std::fs::create_dir(place.path().join("in")).unwrap();
    fitcheck::files::write(&place.path().join("in/axes.csv"), text.as_bytes()).unwrap();
    let watch = ["watch", "in", "--plan", "p.toml", "--until-idle", "0.5", "--record", "--journal", "j.sqlite"];
    let answer = place.say(&watch);
    let listed = place.say(&["journal", "list", "--journal", "j.sqlite", "--format", "csv"]).out;
    assert!(listed.matches("GOOD").count() == 2 && !listed.contains("SCRAP"), "{listed}{}", answer.said());
}

#[test]
fn a_table_of_types_before_limits_gives_no_wrong_verdict() {
    let text = "\u{feff}Program;PLATE_OP20;Software;9.1\nPart Name;Plate 4711;Drawing;D-200\n\n\
        Characteristic;Type;Nominal;Actual;Deviation;Tol-;Tol+;OutOfTol\n\
        Width_1;Distance;18.5000;18.5042;0.0042;-0.0200;0.0200;\nFlat_1;Flatness;0.0000;0.0310;0.0310;0.0000;0.0200;*\n\
        Dia_01;Diameter;25.0000;25.0123;0.0123;0.0000;0.0210;\nDia_02;Diameter;25.0000;25.0250;0.0250;0.0000;0.0210;*\n\n\
        Summary;4 characteristics;2 out of tolerance\n";
    let plan = "name;callout;feature\nDia_01;25 H7;\nDia_02;25 H7;\nWidth_1;18.5 ±0.02;hole\nFlat_1;25 H7;\n";
    let place = Place::of(&[("p.csv", plan), ("m.csv", text)]);
    let answer = place.say(&["import", "--plan", "p.csv", "m.csv", "--format", "csv"]);
    let said = answer.said();
    for (line, words) in [(7, "GOOD"), (8, "SCRAP"), (5, "something else was measured"), (6, "Flatness: not a size")] {
        let row = answer.out.lines().find(|row| row.starts_with(&format!("m.csv,{line},")));
        assert!(row.is_some_and(|row| row.contains(words)), "{line}: {said}");
    }
    assert!(said.contains("m.csv:10: warning: skipped, not a measurement: Summary"), "{said}");
    assert_eq!((said.matches("GOOD").count() < 3, said.contains("REWORK")), (true, false), "{said}");
}

#[test]
fn a_nominal_size_callout_or_limits_of_something_else_refuse_the_row_with_both_figures() {
    for (text, words) in [
        ("name;nominal;measured\nBORE_A;40;40.004\n", "its nominal size is 40 and the plan's is 25"),
        ("name;nominal;measured\nBORE_A;12.5;12.506\n", "its nominal size is 12.5 and the plan's is 25"),
        ("name;callout;measured\nBORE_A;40 ±0.05;40.004\n", ""),
        ("name;callout;measured\nBORE_A;24 H7;24.004\n", "its nominal size is 24 and the plan's is 25"),
        ("name;diameter;measured\nBORE_A;40;40.004\n", "its nominal size is 40 and the plan's is 25"),
        ("name;nominal;measured\nBORE_A;0;0.032\n", "its nominal size is 0 and the plan's is 25"),
    ] {
        let place = Place::of(&[("p.csv", PLAN), ("m.csv", text)]);
        let answer = place.say(&["import", "--plan", "p.csv", "m.csv"]);
        let said = answer.said();
        assert!(answer.code == 1 && said.contains(words), "{text}{said}");
        assert!(!said.contains("SCRAP") && !said.contains("REWORK") && !said.contains("GOOD"), "{text}{said}");
    }
}

/// 25 H7 is 25.000 … 25.021: its middle is 25.0105, and 0.9843 in is 25.00122 mm.
#[test]
fn a_nominal_size_that_is_rounded_or_in_the_middle_of_the_limits_is_that_of_the_plan() {
    for (nominal, measured, is_told) in
        [("25", "25.012", false), ("25.0105", "25.012", true), ("25.011", "25.012", true), ("25.00", "25.012", false)]
    {
        let place =
            Place::of(&[("p.csv", PLAN), ("m.csv", &format!("name;nominal;measured\nBORE_A;{nominal};{measured}\n"))]);
        let answer = place.say(&["import", "--plan", "p.csv", "m.csv", "--format", "csv"]);
        assert_eq!(answer.code, 0, "{nominal}: {}", answer.said());
        assert_eq!(answer.said().contains("the file has the nominal size"), is_told, "{}", answer.said());
    }
    let place = Place::of(&[("p.csv", PLAN), ("m.csv", "name;nominal [inch];measured\nBORE_A;0.9843;25.012\n")]);
    // Beside a measured value of which nothing says the unit.
    let answer = place.say(&["import", "--plan", "p.csv", "m.csv"]);
    assert_eq!(answer.code, 1, "{}", answer.said());
}

#[test]
fn words_that_are_not_known_are_never_a_size_in_silence() {
    // One word for all of them: believed with the plan's name, told once, and looked at first.
    let place = Place::of(&[("p.csv", PLAN), ("m.csv", "name;Type;nominal;measured\nBORE_A;Zwischenring;25;25.012\n")]);
    let answer = place.say(&["import", "--plan", "p.csv", "m.csv"]);
    assert_eq!(answer.code, 14, "{}", answer.said());
    assert_eq!(
        answer.said().matches("column 2 (Type) has no known word for what was measured (Zwischenring)").count(),
        1
    );
    // Words that tell rows of one name apart, a column that says what is measured, and a word beside known ones.
    for (column, words) in [("Type", ["Blub", "Blab"]), ("AXIS", ["Q1", "Q2"]), ("Type", ["Diameter", "Blab"])] {
        let text = format!("name;{column};measured\nBORE_A;{};25.012\nBORE_A;{};25.030\n", words[0], words[1]);
        let place = Place::of(&[("p.csv", PLAN), ("m.csv", &text)]);
        let answer = place.say(&["import", "--plan", "p.csv", "m.csv"]);
        let said = answer.said();
        assert!(answer.code == 1 && said.contains(&format!("{}: not a size", words[1])), "{text}{said}");
        assert!(!said.contains("SCRAP"), "{text}{said}");
    }
    // Variants of a part are none of it.
    let text = "name;callout;Type;measured\nA1;25 H7;A;25.012\nA2;25 H7;B;25.012\n";
    let place = Place::of(&[("m.csv", text)]);
    let answer = place.say(&["import", "m.csv"]);
    assert!(answer.code == 14 && answer.said().contains("column 3 (Type) has no known word"), "{}", answer.said());
    // The user knows.
    let text = "name;Type;measured\nBORE_A;Blub;25.012\nBORE_A;Blab;25.013\n";
    let place = Place::of(&[("p.csv", PLAN), ("m.csv", text)]);
    let answer = place.say(&["import", "--plan", "p.csv", "m.csv", "--columns", "quantity=-"]);
    assert!(!answer.said().contains("not a size"), "{}", answer.said());
}

#[test]
fn a_column_of_quantities_is_known_by_its_words_whatever_its_name() {
    for text in [
        "Element;Merkmal;Istwert\nBORE_A;Durchmesser;25.012\nBORE_A;Rundheit;25.030\n",
        "name;what is it;measured\nBORE_A;Diameter;25.012\nBORE_A;Radius;25.030\n",
        "name;c;measured\nBORE_A;D;25.012\nBORE_A;TP;25.030\n",
        "BORE_A;Diameter;25.012\nBORE_A;Radius;25.030\n",
        "BORE_A;D;25.012\nBORE_A;X;25.030\n",
    ] {
        let place = Place::of(&[("p.csv", PLAN), ("m.csv", text)]);
        let answer = place.say(&["import", "--plan", "p.csv", "m.csv"]);
        let said = answer.said();
        assert!(said.contains("not a size") && said.contains("GOOD") && !said.contains("SCRAP"), "{text}{said}");
    }
    // A tick is no axis, and left and right are none either.
    for text in [
        "id;callout;measured;checked\nA;25 H7;25.012;x\nB;25 H7;25.012;x\n",
        "id;callout;measured;side\nA;25 H7;25.012;L\nB;25 H7;25.012;R\n",
        "id;callout;measured;station\nA;25 H7;25.012;Line 2\nB;25 H7;25.012;Position 1\n",
    ] {
        let answer = Place::of(&[("m.csv", text)]).say(&["import", "m.csv"]);
        assert_eq!(answer.code, 0, "{text}{}", answer.said());
    }
}

/// A face is a coordinate: the row of its axis is its value, and the row of another axis is not.
#[test]
fn the_coordinate_of_a_face_is_the_row_of_its_axis() {
    let plan = "name;kind;axis;callout\nFACE;face;-Z;12 js13\n";
    for (axis, is_judged) in [("Z", true), ("X", false), ("R", false), ("D", false)] {
        let text = format!("name;axis;measured\nFACE;{axis};11.9\n");
        let place = Place::of(&[("p.csv", plan), ("m.csv", &text)]);
        let answer = place.say(&["import", "--plan", "p.csv", "m.csv"]);
        assert_eq!(answer.said().contains("GOOD"), is_judged, "{axis}: {}", answer.said());
    }
}

/// `Depth` that is cut off is `D`.
#[test]
fn a_quantity_that_may_be_cut_off_is_told() {
    let place = Place::of(&[("m.csv", "id;callout;measured;type\nA;25 H7;25.012;Diameter\nB;25 H7;25.012;D")]);
    for command in ["import", "batch"] {
        let said = place.say(&[command, "m.csv"]).said();
        assert!(said.contains("the file ends here without a line end"), "{command}: {said}");
    }
}
