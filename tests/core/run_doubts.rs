//! What a green answer must not keep to itself: each of these programs and files was once answered without a word.

use std::sync::Arc;

use assert_cmd::Command;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::Contact;
use fitcheck::words::Dialogue;

const BORE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-8 ~\nQ260=+50 ~\nQ301=+0";
const LIMITS: &str = " ~\nQ275=+25.021 ~\nQ276=+25";

fn main_program(unit: &str, blocks: &str) -> String {
    format!("BEGIN PGM main {unit}\n{blocks}\nEND PGM main {unit}\n")
}

struct Ran {
    machine: Machine,
    remarks: Vec<String>,
}

fn ran(unit: &str, blocks: &str, contacts: Contacts, table: &str, given: &[(Parameter, Value)]) -> Ran {
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let program = Arc::new(Program::read(main_program(unit, blocks).as_bytes()).unwrap().0);
    let store = InMemory::new().with("own.tab", table).with("mask.a", "\"%.1F\",Q7;\n");
    let mut machine = Machine::new("main.h", program, store, contacts, settings);
    for (parameter, value) in given {
        machine.set(*parameter, value.clone()).unwrap();
    }
    while machine.run(u64::MAX).unwrap() != Step::Ended {}
    let remarks = machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
    Ran { machine, remarks }
}

/// Why a run stops.
fn fault(unit: &str, blocks: &str) -> String {
    fault_on(unit, blocks, Contacts::Perfect)
}

/// The same on contacts.
fn fault_on(unit: &str, blocks: &str, contacts: Contacts) -> String {
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let program = Arc::new(Program::read(main_program(unit, blocks).as_bytes()).unwrap().0);
    let mut machine = Machine::new("main.h", program, InMemory::new(), contacts, settings);
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => panic!("it ended: {blocks}"),
            Ok(_) => {}
            Err(fault) => return fault.kind.to_string(),
        }
    }
}

fn remarks(blocks: &str) -> Vec<String> {
    ran("MM", blocks, Contacts::Perfect, "", &[]).remarks
}

fn on_a_circle(centre: f64, radius: f64, degrees: [f64; 4], z: f64) -> Contacts {
    let place = |angle: f64| [centre + radius * angle.to_radians().cos(), radius * angle.to_radians().sin(), z];
    Contacts::Recorded(degrees.map(|angle| Contact::at(place(angle))).to_vec())
}

#[test]
fn a_bore_that_is_compared_with_nothing_has_no_verdict_and_says_so() {
    let judged = format!("TOOL CALL 1 Z\n{BORE}{LIMITS}");
    assert!(remarks(&judged).is_empty());
    let both = format!("{judged}\n{BORE} ~\nQ275=+0 ~\nQ276=+0");
    assert_eq!(remarks(&both), ["no verdict here: nothing was compared with limits"]);
}

#[test]
fn a_short_arc_is_told_where_its_bore_is_judged() {
    let narrow = BORE.replace("Q247=+90", "Q247=+20");
    let blocks = format!("TOOL CALL 1 Z\n{narrow}{LIMITS}");
    let found = remarks(&blocks);
    let [said] = found.as_slice() else { panic!("{found:?}") };
    assert!(said.starts_with("the contacts cover only 60.0° of arc: scatter in the diameter is"), "{said}");
}

#[test]
fn contacts_of_another_bore_are_told() {
    let blocks = format!("TOOL CALL 1 Z\n{BORE}{LIMITS}");
    let quarters = [0.0, 90.0, 180.0, 270.0];
    let astray = |contacts| ran("MM", &blocks, contacts, "", &[]).remarks;
    assert!(astray(on_a_circle(0.0, 12.505, quarters, -8.0)).is_empty());
    // Half a millimetre off, and in a file without heights. Where the height 0 is known it is eight too many.
    let Contacts::Recorded(flat) = on_a_circle(0.5, 12.505, quarters, 0.0) else { panic!() };
    assert!(astray(Contacts::WithoutHeights(flat.clone())).is_empty());
    assert!(astray(Contacts::Recorded(flat))[0].starts_with("4 contacts lie apart"));
    let found = astray(on_a_circle(20.0, 12.505, quarters, -8.0));
    let said = "3 contacts lie apart from where the cycle probes, contact";
    assert!(found[0].starts_with(said) && found[0].ends_with("perhaps they belong to another feature"), "{found:?}");
    // Where the ball could not come to, nothing is judged.
    let refused = fault_on("MM", &blocks, on_a_circle(100.0, 12.505, quarters, -8.0));
    assert!(refused.contains("contact 1 lies 102.01 mm from where its probing begins"), "{refused}");
    // The first and the third in each other's place.
    let found = astray(on_a_circle(0.0, 12.505, [180.0, 90.0, 0.0, 270.0], -8.0));
    assert!(found[0].starts_with("2 contacts lie apart"), "{found:?}");
    // At another height.
    let found = astray(on_a_circle(0.0, 12.505, quarters, -3.0));
    assert!(found[0].contains("contact 1 by 5 mm"), "{found:?}");
}

#[test]
fn what_a_tool_call_does_not_say_or_cannot_have_is_told() {
    let measured = |call: &str| remarks(&format!("{call}\n{BORE}{LIMITS}"));
    for fine in
        ["TOOL CALL 1 Z S50 F200 DL+0 DR2=0", "TOOL CALL \"P\" Z S2500F350", "TOOL CALL 1 Z S Q5", "TOOL CALL 9 S50 Z"]
    {
        assert!(measured(&format!("Q5 = 5\n{fine}")).is_empty(), "{fine}: {:?}", measured(fine));
    }
    assert_eq!(measured("TOOL CALL 0 Z"), ["tool 0 was called: a TNC7 then has no probe in the spindle"]);
    assert_eq!(
        measured("TOOL CALL Z S50"),
        ["no TOOL CALL before this cycle names a tool: measured with the first probe"]
    );
    assert!(measured("TOOL CALL Z S50\nTOOL CALL 1 Z\nTOOL CALL S60").is_empty());
    assert_eq!(measured("TOOL CALL 1 Z M3 X+100"), ["TOOL CALL does not take M3 X+100: skipped"]);
}

#[test]
fn a_value_that_was_given_and_that_no_block_reads_is_told() {
    let told = |blocks: &str, number: u16| {
        let given = [(Parameter::q(number), Value::Number(5.0))];
        ran("MM", blocks, Contacts::Perfect, "", &given).remarks
    };
    let lost = |number: u16| format!("Q{number} was given before the run and had no effect: no block read it");
    assert_eq!(told("Q2 = 3", 1), [lost(1)]);
    // It replaces the program's own value, is read, or printed.
    assert_eq!(told("Q1 = 3", 1), ["Q1 = 5 was given before the run and replaces this block's value"]);
    assert!(told("Q2 = Q1 + 1", 1).is_empty());
    assert!(told("FN 16: F-PRINT mask.a / SCREEN:", 7).is_empty());
    // A cycle overwrites it before anybody looks.
    let blocks = format!("TOOL CALL 1 Z\n{BORE}{LIMITS}\nQ2 = Q153");
    assert_eq!(told(&blocks, 153), [lost(153)]);
}

#[test]
fn what_a_block_leaves_out_is_told_and_half_a_pair_of_limits_stops() {
    let without = BORE.replace("Q261=-8 ~\n", "");
    let found = remarks(&format!("TOOL CALL 1 Z\n{without}{LIMITS}"));
    let said = "the block leaves out Q261 = 0 mm: these values were used, but a control may refuse the block";
    assert_eq!(found, [said]);
    let half = format!("TOOL CALL 1 Z\n{BORE} ~\nQ275=+25.021");
    assert_eq!(fault("MM", &half), "cycle 421: Q275 is given without Q276: 0 would be the other limit");
}

#[test]
fn a_tolerance_finer_than_a_nanometre_does_not_become_none() {
    let blocks = format!("TOOL CALL 1 Z\n{BORE}{LIMITS} ~\nQ279=+0.0000004 ~\nQ280=+0");
    assert!(fault("MM", &blocks).contains("finer than a nanometre"), "{}", fault("MM", &blocks));
}

#[test]
fn a_cycle_that_is_skipped_at_request_is_told() {
    let blocks = format!("TOOL CALL 1 Z\n{BORE}{LIMITS}\n/{BORE}{LIMITS}");
    let mut settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    settings.block_skip = true;
    let program = Arc::new(Program::read(main_program("MM", &blocks).as_bytes()).unwrap().0);
    let mut machine = Machine::new("main.h", program, InMemory::new(), Contacts::Perfect, settings);
    while machine.run(u64::MAX).unwrap() != Step::Ended {}
    let said = "this measuring cycle was skipped as requested, because of the / before it";
    assert_eq!(machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect::<Vec<_>>(), [said]);
}

#[test]
fn a_global_value_that_is_no_number_stops_and_so_does_more_than_a_preset() {
    let global =
        |value: &str| format!("GLOBAL DEF 120 X ~\nQ320=+2 ~\nQ260=+50 ~\nQ301=+0\nGLOBAL DEF 120 X ~\nQ320={value}");
    assert!(remarks(&global("+3")).is_empty());
    assert_eq!(fault("MM", &global("MAX")), "GLOBAL DEF 120: Q320 has no number");
    for block in ["TRANS DATUM RESET X+5 Y+3", "CYCL DEF 247 PRESET ~\nQ339=+1 ~\nQ340=+4"] {
        assert_eq!(fault("MM", block), "unknown block: Fitcheck runs only what it understands", "{block}");
    }
}

#[test]
fn a_value_that_is_rounded_into_a_table_is_told() {
    let block = "#STRUCTBEGIN\n NAME = X\n TYPE = N\n WIDTH = 9\n DEC = 3\n";
    let table = format!("BEGIN own.tab MM\n{block}#STRUCTEND\nX        \n+0       \n[END]\n");
    let write = |value: &str| {
        let blocks = format!("Q1 = {value}\nFN 26: TABOPEN own.tab\nFN 27: TABWRITE 0/\"X\" = Q1");
        let found = ran("MM", &blocks, Contacts::Perfect, &table, &[]).remarks;
        found.into_iter().filter(|remark| remark.contains("rounded")).collect::<Vec<_>>()
    };
    assert!(write("25.021").is_empty());
    assert_eq!(write("25.0214"), ["table own.tab, column X: 25.0214 was rounded to +25.021"]);
}

#[test]
fn a_log_that_will_say_something_else_is_told() {
    let blocks = format!("TOOL CALL 1 Z\n{BORE}{LIMITS} ~\nQ281=+1");
    let found = ran("MM", &blocks, on_a_circle(0.0, 12.510_52, [0.0, 90.0, 180.0, 270.0], -8.0), "", &[]).remarks;
    assert!(found.iter().any(|remark| remark.contains("GOOD") && remark.contains("SCRAP")), "{found:?}");
}

#[test]
fn the_block_of_a_program_in_inches_is_not_read_as_mm() {
    let shop = Shop::new();
    let program = shop.file("main.h", &main_program("INCH", &format!("{BORE}{LIMITS}")));
    let (code, _, said) = fitcheck(&["cycle", "421", "--block", &program]);
    assert_eq!(code, Some(1));
    assert!(said.contains("line 1: the block belongs to a program in inches"), "{said}");
    let program = shop.file("main.h", &main_program("MM", &format!("{BORE}{LIMITS}")));
    assert_eq!(fitcheck(&["cycle", "421", "--block", &program]).0, Some(0));
}

#[test]
fn rows_that_are_numbered_otherwise_are_told() {
    let read = "FN 26: TABOPEN own.tab\nFN 28: TABREAD Q1 = 0/\"U1\"";
    let of = |first: usize| {
        let table = format!("BEGIN own.tab MM\nNR U1\n{first}  +8\n{}  +9\n[END]\n", first + 1);
        ran("MM", read, Contacts::Perfect, &table, &[]).remarks
    };
    assert!(of(0).is_empty());
    assert_eq!(of(1), ["table own.tab: NR is 1 in row 0: FN 27 and FN 28 count rows from 0"]);
}

/// A table with a column of type LENGTH and one of type FLOAT.
fn with_lengths(unit: &str) -> String {
    let column =
        |key: &str, kind: &str| format!("CfgColumnDescription (\nkey:=\"{key}\",\nwidth:=10,\nunit:={kind}\n)");
    let columns = [column("D", "LENGTH"), column("G", "FLOAT")].join(",\n");
    let rows = "D         G         \n25.4      25.4      \n[END]\n";
    format!("BEGIN own.tab {unit}\nTableDescription (\ncolumns:= [\n{columns}\n]\n)\n{rows}")
}

#[test]
fn a_column_of_lengths_is_converted_for_a_program_in_inches() {
    let blocks = "FN 26: TABOPEN own.tab\nFN 28: TABREAD Q1 = 0/\"D,G\"";
    let read = |unit: &str, table: &str| {
        let Ran { machine, remarks } = ran(unit, blocks, Contacts::Perfect, &with_lengths(table), &[]);
        let of = |number| machine.variables().get(Parameter::q(number)).cloned().unwrap();
        (of(1), of(2), remarks)
    };
    let told = vec!["table own.tab: column D is a LENGTH and was converted between mm and inches".to_owned()];
    let number = Value::Number;
    assert_eq!(read("MM", "MM"), (number(25.4), number(25.4), Vec::new()));
    assert_eq!(read("INCH", "MM"), (number(1.0), number(25.4), told.clone()));
    assert_eq!(read("INCH", "INCH"), (number(25.4), number(25.4), Vec::new()));
    assert_eq!(read("MM", "INCH"), (number(25.4 * 25.4), number(25.4), told));
}

#[test]
fn a_length_is_written_in_the_unit_of_its_table() {
    let blocks = "Q1 = 2\nFN 26: TABOPEN own.tab\nFN 27: TABWRITE 0/\"D\" = Q1\nFN 28: TABREAD Q2 = 0/\"D\"\nFN 28: TABREAD QS2 = 0/\"D\"";
    let machine = ran("INCH", blocks, Contacts::Perfect, &with_lengths("MM"), &[]).machine;
    assert_eq!(machine.variables().get("QS2".parse().unwrap()), Some(&Value::Text("50.8".to_owned())));
    assert_eq!(machine.variables().get(Parameter::q(2)), Some(&Value::Number(2.0)));
}

fn fitcheck(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

struct Shop(tempfile::TempDir);

impl Shop {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn file(&self, name: &str, text: &str) -> String {
        let path = self.0.path().join(name);
        fitcheck::files::write(&path, text.as_bytes()).unwrap();
        path.display().to_string()
    }
}

#[test]
fn a_run_says_what_was_measured() {
    let shop = Shop::new();
    let program = shop.file("main.h", &main_program("MM", &format!("TOOL CALL 1 Z\n{BORE}{LIMITS}")));
    let part = shop.file("bore.toml", "[bore]\ncentre = [0, 0]\ndiameter = 25.01\n");
    let source = |more: &[&str]| {
        let (code, out, _) = fitcheck(&[&["run", &program, "--format", "json"], more].concat());
        assert_eq!(code, Some(0));
        let answer: serde_json::Value = serde_json::from_str(&out).unwrap();
        (answer["source"]["kind"].as_str().unwrap().to_owned(), answer["cycles"][0]["warnings"][0].clone())
    };
    let four = "4 contacts give two diameters and a mean; four lobes would stay invisible";
    let (kind, warning) = source(&[]);
    assert_eq!(kind, "perfect");
    assert!(warning.as_str().unwrap().starts_with("4 contacts") || warning == four, "{warning}");
    assert_eq!(source(&["--workpiece", &part]).0, "simulated");
    assert!(
        fitcheck(&["run", &program]).2.contains("note: simulated: every cycle measured a perfect workpiece at nominal")
    );
    assert!(fitcheck(&["run", &program, "--workpiece", &part]).2.contains("note: simulated: nothing was measured"));
    let empty = shop.file("empty.h", &main_program("MM", "Q1 = 5"));
    assert_eq!(fitcheck(&["run", &empty]).2, "");
}

#[test]
fn a_check_of_a_short_arc_warns() {
    let shop = Shop::new();
    let place = |angle: f64| format!("{},{}\n", 12.505 * angle.to_radians().cos(), 12.505 * angle.to_radians().sin());
    let rows: String = [0.0, 20.0, 40.0, 60.0].map(place).concat();
    let contacts = shop.file("arc.csv", &format!("x,y\n{rows}"));
    let (code, _, said) = fitcheck(&["check", "25 H7", "--contacts", &contacts]);
    assert_eq!(code, Some(0));
    assert!(said.contains("warning: contacts cover only 60°"), "{said}");
}

#[test]
fn a_row_that_begins_with_a_number_sign_is_not_lost() {
    let shop = Shop::new();
    for row in ["#2,25 H7,25.5", "2#,25 H7,25.5", "# 2,25 H7,25.5"] {
        let rows = shop.file("rows.csv", &format!("part,callout,measured\n1,25 H7,25.012\n{row}\n"));
        for subcommand in ["import", "batch"] {
            let (code, ..) = fitcheck(&[subcommand, &rows]);
            assert_ne!(code, Some(0), "{subcommand}: {row}");
        }
    }
    let rows = shop.file("rows.csv", "callout,measured\n#25 H7,25.5\n25 H7,25.012\n");
    assert_eq!(fitcheck(&["import", &rows]).0, Some(1));
    let rows = shop.file("rows.csv", "callout,measured\n# probed on machine 3\n25 H7,25.012\n# end, 2 rows\n");
    assert_eq!(fitcheck(&["import", &rows]).0, Some(0));
    let contacts = shop.file("contacts.csv", "# 4 contacts\nx,y\n12.5,0\n#0,12.5\n-12.5,0\n0,-12.5\n");
    let (code, _, said) = fitcheck(&["circle", &contacts]);
    assert_eq!(code, Some(1));
    assert!(said.contains("contacts.csv: line 4, column 1"), "{said}");
    assert!(said.contains("a line that begins with # is a comment, but this one holds coordinates"), "{said}");
}

#[test]
fn a_file_that_is_named_twice_is_told() {
    let shop = Shop::new();
    let rows = shop.file("rows.csv", "callout,measured\n25 H7,25.012\n");
    let other = format!("{}/./rows.csv", shop.0.path().display());
    for subcommand in ["import", "batch"] {
        assert!(!fitcheck(&[subcommand, &rows]).2.contains("named twice"), "{subcommand}");
        let said = fitcheck(&[subcommand, &rows, &other]).2;
        assert!(said.contains("this file is named twice: its rows are counted twice"), "{subcommand}: {said}");
    }
    let said = fitcheck(&["report", &rows, &other, "-o", "-", "--format", "csv"]).2;
    assert!(said.contains("this file is named twice"), "{said}");
}
