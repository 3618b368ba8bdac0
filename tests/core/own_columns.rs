//! Own columns of names without a grade, such as PF of NC-Solution 8255: whatever knows a class knows them, where an own
//! table has them.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::control::deviations::{read_table, to_control_table};
use fitcheck::control::table::Generation;
use fitcheck::message::Say as _;
use fitcheck::session::tables::{Filter, TableChoice};
use fitcheck::session::{
    Action, CheckCommand, CheckField, Command, Effect, FitField, Page, Purpose, Saved, Session, TablesCommand,
    TablesField, WindowAction,
};
use fitcheck::tolerance::{Base, Callout, ClassError, DeviationTable, Feature, Sources, ToleranceClass};
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

/// H7 as in ISO 286, and three columns of the shop: PF, one with digits in its name, and one without any value.
const HOLES: &str = "\
BEGIN own_hole.tab
NR  BEREICH H7     PF     U1Z1   LEER
0   18      +18    +35    +3     -
1           +0     +5     -3     -
2   30      +21    +40    +2.5   -
3           +0     +10    -2.5   -
[END]
";

const SHAFTS: &str = "\
BEGIN own_shaft.tab
NR  BEREICH h6     pf
0   30      +0     -10
1           -13    -40
[END]
";

/// A folder with both tables in a folder `own`.
fn shop() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("own")).unwrap();
    std::fs::write(folder.path().join("own/own_hole.tab"), HOLES).unwrap();
    std::fs::write(folder.path().join("own/own_shaft.tab"), SHAFTS).unwrap();
    folder
}

fn table(text: &str, name: &str) -> DeviationTable {
    let (table, warnings) = read_table(text.as_bytes(), name, name, false).unwrap();
    assert_eq!(warnings, []);
    table.unwrap()
}

fn sources() -> Sources {
    Sources::default().with_own([table(HOLES, "own_hole.tab"), table(SHAFTS, "own_shaft.tab")])
}

struct Answer {
    code: Option<i32>,
    out: String,
    err: String,
}

fn fitcheck_of(folder: &Path, args: &[&str], input: &str) -> Answer {
    let output = cargo_bin_cmd!("fitcheck").current_dir(folder).args(args).write_stdin(input).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Answer { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

/// What a call with the own tables prints; nothing warns about them.
#[track_caller]
fn with_own(args: &[&str], code: i32) -> String {
    let folder = shop();
    let answer = fitcheck_of(folder.path(), &[args, &["--tables", "own"]].concat(), "");
    assert_eq!(answer.code, Some(code), "{args:?}: {} {}", answer.out, answer.err);
    assert!(!answer.err.contains("warning"), "{args:?}: {}", answer.err);
    answer.out
}

#[test]
fn limits_come_from_the_own_table_for_holes_and_for_shafts() {
    let out = with_own(&["limits", "25 PF", "25 pf", "18 PF", "Ø25,0U1Z1", "25 PF/h6", "--format", "csv"], 0);
    let rows: Vec<&str> = out.lines().skip(1).collect();
    assert_eq!(
        rows,
        [
            "25 PF,25,10,40,25.010,25.040,\"table own_hole.tab, over 18 up to 30 mm\",",
            "25 pf,25,-40,-10,24.960,24.990,\"table own_shaft.tab, over 0 up to 30 mm\",",
            "18 PF,18,5,35,18.005,18.035,\"table own_hole.tab, over 0 up to 18 mm\",",
            "\"Ø25,0U1Z1\",25,-2.5,2.5,24.9975,25.0025,\"table own_hole.tab, over 18 up to 30 mm\",",
            "25 PF,25,10,40,25.010,25.040,\"table own_hole.tab, over 18 up to 30 mm\",",
            "25 h6,25,-13,0,24.987,25.000,\"table own_shaft.tab, over 0 up to 30 mm\",",
        ]
    );
}

#[test]
fn a_check_has_its_verdict_and_the_text_of_the_mask() {
    for (callout, measured, code) in [
        ("25 PF", "25.009999", 10),
        ("25 PF", "25.01", 0),
        ("25 PF", "25.04", 0),
        ("25 PF", "25.040001", 11),
        ("25 pf", "24.990001", 10),
        ("25 pf", "24.959999", 11),
    ] {
        let out = with_own(&["check", callout, "--measured", measured, "--mask", "nl"], code);
        assert!(out.contains(&format!("GEPRUEFTE PASSUNG: {callout}\n")), "{out}");
    }
}

#[test]
fn a_fit_of_own_columns_has_its_clearances() {
    let out = with_own(&["fit", "25 PF/pf", "--format", "json"], 0);
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    let text = json.to_string();
    assert!(text.contains("\"PF\"") && text.contains("\"pf\""), "{text}");
    assert!(text.contains("20") && text.contains("80"), "{text}");
}

#[track_caller]
fn refused(args: &[&str], reason: &str) {
    let folder = shop();
    let answer = fitcheck_of(folder.path(), args, "");
    assert_eq!((answer.code, answer.err.trim_end()), (Some(1), reason), "{args:?}: {}", answer.out);
}

#[test]
fn without_the_column_the_error_says_which_there_are() {
    let none = "is not an ISO 286 tolerance class: write letters and a grade, such as H7 or js13";
    refused(&["limits", "25 PF"], &format!("25 PF: PF {none}, or choose own tables with a column PF"));
    refused(&["limits", "25 U1Z1"], &format!("25 U1Z1: U1Z1 {none}, or choose own tables with a column U1Z1"));
    // A letter of ISO 286 lacks its grade, with own tables and without.
    for tables in [&[][..], &["--tables", "own"]] {
        for name in ["H", "js", "H777"] {
            let callout = format!("25 {name}");
            refused(&[&["limits", &callout], tables].concat(), &format!("{callout}: {name} {none}"));
        }
    }
    let tables = "table own_hole.tab, own_shaft.tab";
    refused(
        &["limits", "25 PX", "--tables", "own"],
        &format!("25 PX: PX is not an ISO 286 tolerance class, and {tables} has no column PX: it has H7 PF U1Z1 LEER"),
    );
    refused(
        &["limits", "25 px", "--tables", "own"],
        &format!("25 px: px is not an ISO 286 tolerance class, and {tables} has no column px: it has h6 pf"),
    );
    refused(
        &["limits", "25 u1z1", "--tables", "own"],
        &format!("25 u1z1: u1z1 is a shaft class and {tables} does not have it; the hole class is U1Z1"),
    );
    refused(
        &["limits", "31 PF", "--tables", "own"],
        "31 PF: nominal size 31 mm is beyond table own_hole.tab, whose last range is over 18 up to and including 30 mm",
    );
    refused(
        &["limits", "25 LEER", "--tables", "own"],
        "25 LEER: LEER is not defined over 18 up to 30 mm in table own_hole.tab; it is not defined at any size",
    );
    // The built-in tables have no such column, either.
    let answer = fitcheck_of(Path::new("."), &["limits", "25 PF", "--source", "control"], "");
    assert!(answer.err.starts_with("25 PF: PF is not in table 82553_hole.tab; it has D10"), "{}", answer.err);
}

#[test]
fn a_name_that_means_something_else_is_no_class() {
    let is_class = |text: &str| text.parse::<ToleranceClass>().is_ok();
    for name in [
        "mm", "MM", "um", "in", "IN", "inch", "Inch", "nr", "NR", "BEREICH", "BEREIK", "MAX", "ref", "f", "M", "c", "V",
    ] {
        assert!(!is_class(name), "{name}");
    }
    for name in ["7", "7H", "P_F", "P-F", "PFÄ", "ABCDEFGHI", "", "H7x", "P F", "P/F"] {
        assert!(!is_class(name), "{name}");
    }
    for name in ["P", "PF", "pf", "PRODUKT1", "A1B2C3D4", "H777", "MMX", "INX", "OK"] {
        assert!(is_class(name), "{name}");
        assert_eq!(name.parse::<ToleranceClass>().unwrap().as_str(), name);
    }
    assert!(matches!("Pf".parse::<ToleranceClass>(), Err(ClassError::MixedCase { .. })));
    let said = |text: &str| text.parse::<Callout>().map_or_else(|error| error.to_string(), |read| read.to_string());
    assert_eq!(said("25 in"), "25 in is 635 mm: write size and tolerance in millimetres");
    assert_eq!(said("10m"), "10m");
    assert_eq!(
        said("25mmPF"),
        "mmPF mixes upper and lower case: write MMPF for a hole or mmpf for a shaft (character 3)"
    );
    assert_eq!(said("25mm PF"), "25 PF");
    assert_eq!(said("25 Pf"), "Pf mixes upper and lower case: write PF for a hole or pf for a shaft (character 4)");
    assert_eq!(said("25 PF-pf"), "25 PF/pf");
    // A deviation behind a class is compared with it.
    assert_eq!(said("25 PF -0.1"), "25 PF (0 -0.1)");
}

#[test]
fn texts_of_cycles_14xx_take_classes_with_a_grade_only() {
    use fitcheck::tolerance::CycleText;
    assert!("?10H7".parse::<CycleText>().is_ok());
    let error = "10PF".parse::<CycleText>().unwrap_err().to_string();
    assert!(error.starts_with("PF is not a tolerance class"), "{error}");
}

const ROWS: &str = "id;callout;measured\nA1;25 PF;25,012\nA2;25 pf;24,9\nA3;25 U1Z1;25,1\nA4;25 PX;25\nA5;25 H7;25,01\n\
                    A6;25 mm;25\nA7;25PF;25,005\nA8;31 PF;31\n";

/// The answers of `batch` without the warnings.
fn batch(folder: &Path, file: &str) -> Vec<String> {
    let answer = fitcheck_of(folder, &["batch", file, "--tables", "own"], "");
    answer.out.lines().map(str::to_owned).collect()
}

#[test]
fn an_import_and_a_batch_judge_by_own_columns_and_agree() {
    let folder = shop();
    std::fs::write(folder.path().join("m.csv"), ROWS).unwrap();
    let rows = batch(folder.path(), "m.csv");
    let px = "PX is not an ISO 286 tolerance class, and table own_hole.tab, own_shaft.tab has no column PX: it has H7 \
              PF U1Z1 LEER";
    assert_eq!(rows[1], "A1;25 PF;25,012;25.010;25.040;12;GOOD;;");
    assert_eq!(rows[2], "A2;25 pf;24,9;24.960;24.990;-100;SCRAP;;");
    assert_eq!(rows[3], "A3;25 U1Z1;25,1;24.9975;25.0025;100;SCRAP;;");
    assert_eq!(rows[4], format!("A4;25 PX;25;;;;;;{px}"));
    assert_eq!(rows[5], "A5;25 H7;25,01;25.000;25.021;10;GOOD;;");
    assert!(rows[6].contains("a tolerance is missing"), "{}", rows[6]);
    assert_eq!(rows[7], "A7;25PF;25,005;25.010;25.040;5;REWORK;5;");
    assert!(rows[8].contains("is beyond table own_hole.tab"), "{}", rows[8]);
    let import = fitcheck_of(folder.path(), &["import", "m.csv", "--tables", "own", "--format", "json"], "");
    let json: serde_json::Value =
        serde_json::from_str(&import.out).unwrap_or_else(|error| panic!("{error} {}", import.err));
    let json = json.as_array().unwrap();
    for (row, imported) in rows[1..].iter().zip(json) {
        let cells: Vec<&str> = row.split(';').collect();
        assert_eq!(imported["status"].as_str().unwrap_or_default(), cells[6], "{row} {imported}");
        assert_eq!(imported["error"].as_str().unwrap_or_default(), cells[8], "{row}");
    }
    let report = fitcheck_of(folder.path(), &["report", "m.csv", "--tables", "own", "-o", "r.html"], "");
    let page = std::fs::read_to_string(folder.path().join("r.html")).unwrap_or_else(|_| panic!("{}", report.err));
    assert!(page.contains("25 PF") && page.contains("table own_hole.tab"));
}

#[test]
fn a_nominal_size_and_an_own_column_may_have_a_column_each() {
    let folder = shop();
    let rows = "part,nominal,class,measured\nA1,25,PF,25.012\nA2,25,pf,25.012\nA3,25,mm,25\nA4,25,m,25\n";
    std::fs::write(folder.path().join("m.csv"), rows).unwrap();
    let rows = batch(folder.path(), "m.csv");
    assert_eq!(rows[1], "A1,25,PF,25.012,25.010,25.040,12,GOOD,,");
    assert_eq!(rows[2], "A2,25,pf,25.012,24.960,24.990,12,REWORK,22,");
    for row in &rows[3..5] {
        assert!(row.contains("is not a tolerance class"), "{row}");
    }
}

#[test]
fn without_a_header_own_callouts_are_told_from_words_by_the_measured_value() {
    let folder = shop();
    std::fs::write(folder.path().join("m.csv"), "A1;25 PF;25.012\nA2;25 PF;25.2\n").unwrap();
    assert_eq!(batch(folder.path(), "m.csv")[0], "A1;25 PF;25.012;25.010;25.040;12;GOOD;;");
    // Three pieces of 25 mm have no callout, as before.
    std::fs::write(folder.path().join("p.csv"), "A1;3 pcs;25.012\nA2;3 pcs;25.2\n").unwrap();
    let pieces = batch(folder.path(), "p.csv");
    assert!(pieces[0].ends_with("not judged: no callout given"), "{}", pieces[0]);
    // A word behind a size is no class: two columns of numbers stay two, and the reason is theirs.
    std::fs::write(folder.path().join("w.csv"), "25.0;GOOD;25.012\n25.0;GOOD;25.2\n").unwrap();
    let words = fitcheck_of(folder.path(), &["batch", "w.csv", "--tables", "own"], "");
    assert!(words.code == Some(1) && !words.err.contains("ISO 286"), "{}", words.err);
}

#[test]
fn sql_holds_the_own_columns() {
    let folder = shop();
    let answer =
        fitcheck_of(folder.path(), &["sql", "--dialect", "sqlite", "--tables", "own", "--classes", "PF pf U1Z1"], "");
    assert_eq!((answer.code, answer.err.as_str()), (Some(0), ""));
    for cell in ["('PF',true)", "('pf',false)", "('U1Z1',true)"] {
        assert!(answer.out.contains(cell), "{cell}");
    }
    assert!(answer.out.contains(",10000,40000,"), "PF in nanometres");
}

#[test]
fn every_format_has_the_column_and_a_control_table_reads_back_the_same() {
    let folder = shop();
    let export = |format: &str, name: &str| {
        let args = ["table", "export", "own/own_hole.tab", "--format", format, "-o", name];
        let answer = fitcheck_of(folder.path(), &args, "");
        assert_eq!(answer.code, Some(0), "{format}: {}", answer.err);
        std::fs::read_to_string(folder.path().join(name)).unwrap()
    };
    let csv = export("csv", "a.csv");
    assert!(csv.contains("PF,18,30,40,10\n") && csv.contains("U1Z1,18,30,2.5,-2.5\n"), "{csv}");
    let pcdmis = export("pcdmis", "b.csv");
    assert!(pcdmis.contains("PF, 0, 18, 30\n0.035, 0.005, 0.040, 0.010\n"), "{pcdmis}");
    for format in ["itnc530", "tnc640", "tnc7"] {
        let written = export(format, "own_hole.tab");
        let again = table(&written, "own_hole.tab");
        assert_eq!(again, table(HOLES, "own_hole.tab"), "{format}");
        let verified = fitcheck_of(folder.path(), &["table", "verify", "own_hole.tab"], "");
        let said = "own_hole.tab: 1 class, 2 size ranges, 2 cells compared: ";
        assert!(verified.out.contains(said), "{}", verified.out);
        assert!(verified.out.contains("not compared, not ISO 286 classes: PF U1Z1 LEER\n"), "{}", verified.out);
    }
}

#[test]
fn a_table_is_not_made_of_names_that_iso_286_lacks() {
    let folder = shop();
    for (name, reason) in [
        ("PF", "PF is not an ISO 286 tolerance class: letter PF does not exist, only A B C"),
        ("h", "h is not an ISO 286 tolerance class: write letters and a grade, such as H7 or js13"),
    ] {
        let answer = fitcheck_of(folder.path(), &["table", "new", "--classes", name, "-o", "new.tab"], "");
        assert!(answer.code == Some(1) && answer.err.contains(reason), "{}", answer.err);
    }
}

#[test]
fn a_set_carries_the_column_and_its_program_measures_by_it() {
    let folder = shop();
    let bore = ["nc", "25 PF", "--x", "40", "--y", "30", "--z", "-8", "--tables", "own"];
    for control in ["itnc530", "tnc640", "tnc7"] {
        let answer = fitcheck_of(folder.path(), &[&bore[..], &["--control", control, "-o", control]].concat(), "");
        assert_eq!(answer.code, Some(0), "{control}: {}", answer.err);
        assert!(answer.err.contains("PF"), "the set says that the class is not one of the 47: {}", answer.err);
        let main = if control == "itnc530" { "8255_en.h" } else { "FIT_MAIN.H" };
        for (diameter, code, status) in [("25.009", 10, "REWORK"), ("25.01", 0, "GOOD"), ("25.0401", 11, "SCRAP")] {
            std::fs::write(
                folder.path().join("bore.toml"),
                format!("[bore]\ncentre = [40, 30]\ndiameter = {diameter}\n"),
            )
            .unwrap();
            let run = ["run", &format!("{control}/{main}"), "--workpiece", "bore.toml"];
            let answer = fitcheck_of(folder.path(), &run, "");
            assert_eq!(answer.code, Some(code), "{control}: {}", answer.err);
            let window =
                format!("FIT STATUS: {status}\nCHECKED FIT: 25 PF\nMINIMUM SIZE:  25.0100\nMAXIMUM SIZE:  25.0400\n");
            assert!(answer.out.starts_with(&window), "{}", answer.out);
        }
    }
}

fn now() -> DateTime {
    date(2026, 11, 23).at(10, 0, 0, 0)
}

/// A session with the own tables.
fn session() -> Session {
    let mut session = Session::new(Language::En);
    let result = Ok((vec![table(HOLES, "own_hole.tab"), table(SHAFTS, "own_shaft.tab")], Vec::new()));
    session.apply(Command::TablesRead { folder: "/shop".into(), result }, now());
    session
}

#[test]
fn the_chosen_source_of_limits_names_own_tables_as_long_as_they_come_first() {
    let words = Words::new(Language::En);
    let mut session = session();
    let chosen = |session: &Session| {
        let sources = Base::ALL.map(|base| Action::from(WindowAction::UseSource(base)));
        let on: Vec<String> = sources
            .into_iter()
            .filter(|source| source.is_on(session) == Some(true))
            .map(|source| source.text(session, &words))
            .collect();
        on.join("; ")
    };
    assert_eq!(chosen(&session), "Own tables, then ISO 286, every class to 3150 mm");
    let stop = Action::from(WindowAction::NoOwnTables);
    assert_eq!(stop.text(&session, &words), "Stop using own tables");
    session.apply(Command::NoOwnTables, now());
    assert_eq!(chosen(&session), "ISO 286, every class to 3150 mm");
    assert!(!session.can(WindowAction::NoOwnTables));
}

#[test]
fn page_check_measures_by_an_own_column_and_keeps_it_over_a_restart() {
    let mut session = session();
    for (field, text) in [(CheckField::Callout, "25 PF"), (CheckField::Measured, "25.045")] {
        session.apply(CheckCommand::Type(field, text.into()).into(), now());
    }
    session.apply(CheckCommand::Measure.into(), now());
    let judged: Vec<String> = session
        .history()
        .iter()
        .map(|check| format!("{} by {}", check.verdict.status(), check.limits.source))
        .collect();
    assert_eq!(judged, ["SCRAP by table own_hole.tab, over 18 up to 30 mm"]);
    let classes = session.sources().classes(Feature::Hole);
    assert!(classes.iter().any(|class| class.as_str() == "PF"), "the chooser offers it");
    let (mut again, effects) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    assert_eq!(again.text(CheckField::Callout), "25 PF");
    assert_eq!(effects, [Effect::Read(Purpose::LoadTables, "/shop".into())]);
    let error = |session: &Session| session.error(CheckField::Callout).map(|error| Words::new(Language::En).say(error));
    assert_eq!(error(&again).as_deref(), Some("The own tables in /shop are still being read"));
    let result = Ok((vec![table(HOLES, "own_hole.tab")], Vec::new()));
    again.apply(Command::TablesRead { folder: "/shop".into(), result }, now());
    assert_eq!(error(&again), None);
    again.apply(Command::NoOwnTables, now());
    assert!(error(&again).unwrap_or_default().contains("choose own tables with a column PF"), "{:?}", error(&again));
}

#[test]
fn page_fit_takes_own_columns() {
    let mut session = session();
    session.apply(Command::OpenPage(Page::Fit), now());
    session.apply(fitcheck::session::Field::from(FitField::Callout).typed("25 PF/pf".to_owned()), now());
    assert_eq!(session.error(FitField::Callout).map(|error| Words::new(Language::En).say(error)), None);
    let map = session.fit().map(Feature::Hole).unwrap();
    let others: Vec<&str> = map.others.iter().map(ToleranceClass::as_str).collect();
    assert_eq!(others, ["PF", "U1Z1"]);
}

#[test]
fn page_tables_keeps_edits_and_finds_own_columns() {
    let mut session = session();
    let send = |session: &mut Session, command: TablesCommand| _ = session.apply(Command::Tables(command), now());
    session.apply(Command::OpenPage(Page::Tables), now());
    send(&mut session, TablesCommand::Open(TableChoice::Own(0)));
    let pf: ToleranceClass = "PF".parse().unwrap();
    send(&mut session, TablesCommand::Select(pf, 1));
    session.apply(fitcheck::session::Field::from(TablesField::CellUpper).typed("41".to_owned()), now());
    send(&mut session, TablesCommand::SetCell);
    let document = session.tables().shown().unwrap();
    let filter = Filter::of("U1Z1 PF", document.table());
    let columns: Vec<&str> = filter.columns.iter().map(|&at| document.table().columns()[at].class.as_str()).collect();
    assert_eq!((columns, filter.unmatched), (vec!["PF", "U1Z1"], Vec::new()));
    let written = to_control_table(document.table(), Generation::Description).write().unwrap();
    let again = table(&String::from_utf8(written).unwrap(), "own_hole.tab");
    let sources = Sources::of_tables([again]);
    let limits = sources.limits(&"25 PF".parse().unwrap(), None).unwrap();
    assert_eq!(limits.maximum().to_string(), "25.041");
    assert!(document.is_own_class(pf));
}

#[test]
fn the_reasons_are_told_in_dutch() {
    let error = sources().limits(&"25 PX".parse().unwrap(), None).unwrap_err();
    let told = Words::new(Language::Nl).say(&error.message());
    assert!(told.starts_with("PX is geen tolerantieklasse van ISO 286 en tabel own_hole.tab"), "{told}");
}
