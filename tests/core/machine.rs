//! Running NC programs: documented values, every fault by its name, and no way for a program to do harm.

use std::sync::Arc;

use fitcheck::control::log::{self, Log};
use fitcheck::control::shipped_tables;
use fitcheck::control::variables::{Family, Parameter, Value};
use fitcheck::journal::{Record, status_window};
use fitcheck::length::Length;
use fitcheck::nc::machine::{
    BlockPlace, Budget, Contacts, FaultKind, InMemory, Machine, NcPath, Pause, Settings, Shipped, Step, TravelKind,
    UsedUp,
};
use fitcheck::nc::program::Program;
use fitcheck::probing::cycle::{Control, Move, Phase};
use fitcheck::probing::cycles::cycles_of;
use fitcheck::probing::simulated::Simulation;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::store::programs::Folders;
use fitcheck::tolerance::{Callout, Sources};
use fitcheck::verdict::{Status, judge};
use fitcheck::words::Dialogue;
use proptest::prelude::*;

fn sample(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/data/samples/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

pub(crate) fn settings() -> Settings {
    let mut settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    // Most programs here are only a cycle; `around` has the tests with TOOL CALL and without.
    settings.assumes_tool = true;
    settings
}

pub(crate) fn program(text: &[u8]) -> Arc<Program> {
    Arc::new(Program::read(text).unwrap().0)
}

/// A program with these blocks.
pub(crate) fn text(blocks: &str) -> String {
    format!("BEGIN PGM main MM\n{blocks}\nEND PGM main MM\n")
}

fn machine_in(store: InMemory, blocks: &str) -> Machine {
    Machine::new(r"TNC:\fit\main.h", program(text(blocks).as_bytes()), store, Contacts::Perfect, settings())
}

fn machine(blocks: &str) -> Machine {
    machine_in(InMemory::new(), blocks)
}

/// Runs to the end; pauses are skipped.
#[track_caller]
pub(crate) fn to_end(machine: &mut Machine) {
    loop {
        match machine.run(u64::MAX).unwrap_or_else(|fault| panic!("{fault}")) {
            Step::Ended => return,
            Step::Paused(_) => {}
            Step::Went => panic!("the machine went on"),
        }
    }
}

#[track_caller]
fn ran(blocks: &str) -> Machine {
    let mut machine = machine(blocks);
    to_end(&mut machine);
    machine
}

/// The fault without its place.
#[track_caller]
pub(crate) fn fault_of(machine: &mut Machine) -> String {
    let fault = loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => panic!("it ran to its end: {:?}", machine.variables()),
            Ok(_) => {}
            Err(fault) => break fault,
        }
    };
    assert_eq!(machine.step(), Err(fault.clone()), "a run that failed stays so");
    fault.kind.to_string()
}

#[track_caller]
fn fault(blocks: &str) -> String {
    fault_of(&mut machine(blocks))
}

#[track_caller]
fn number(machine: &Machine, name: &str) -> f64 {
    match value(machine, name) {
        Some(Value::Number(number)) => number,
        Some(Value::Length(length)) => length.to_mm_f64(),
        other => panic!("{name} is {other:?}"),
    }
}

fn value(machine: &Machine, name: &str) -> Option<Value> {
    let (family, number) = match name.split_at(name.find(|c: char| c.is_ascii_digit()).unwrap()) {
        ("Q", number) => (Family::Q, number),
        ("QL", number) => (Family::Ql, number),
        ("QR", number) => (Family::Qr, number),
        (_, number) => (Family::Qs, number),
    };
    machine.variables().get(Parameter { family, number: number.parse().unwrap() }).cloned()
}

fn text_value(machine: &Machine, name: &str) -> String {
    match value(machine, name) {
        Some(Value::Text(text)) => text,
        other => panic!("{name} is {other:?}"),
    }
}

#[track_caller]
fn check_values(machine: &Machine, expected: &[(&str, f64)]) {
    for (name, expected) in expected {
        let found = number(machine, name);
        assert!((found - expected).abs() <= 1e-9, "{name} is {found}, not {expected}");
    }
}

#[test]
fn an_angle_is_less_than_a_full_turn() {
    let text = b"BEGIN PGM A MM\nFN 13: Q1 = -0.00000000000000000001 ANG +1\nFN 13: Q2 = -1 ANG +1\nEND PGM A MM\n";
    let mut machine = Machine::new("a.h", program(text), InMemory::new(), Contacts::Perfect, settings());
    to_end(&mut machine);
    assert_eq!((number(&machine, "Q1"), number(&machine, "Q2")), (0.0, 315.0));
}

#[test]
fn the_syntax_zoo_leaves_the_documented_values() {
    let zoo = program(&sample("programs/syntax_zoo.h"));
    let mut machine = Machine::new("syntax_zoo.h", zoo, InMemory::new(), Contacts::Perfect, settings());
    to_end(&mut machine);
    check_values(
        &machine,
        &[
            ("Q1", 60.0),
            ("Q2", 55.0),
            ("Q3", 5.0),
            ("Q4", 9.0),
            ("Q5", 1.125),
            ("Q6", 2.0),
            ("Q7", 35.0),
            ("Q8", 73.0),
            ("Q9", -15.0),
            ("Q10", 9.0),
            ("Q12", 29.0),
            ("Q13", 40.0),
            ("Q14", -40.0),
            ("Q15", -1.0),
            ("Q16", 0.75),
            ("QL1", 15.0),
            ("QR3", 15.0),
            ("Q20", 1.125),
            ("Q21", 4.0),
            ("Q24", 14.0),
            ("Q25", 1.0),
            ("Q30", 4.0),
            ("Q31", 4.0),
            ("Q32", 7.0),
            ("Q41", -200.66),
        ],
    );
    // Binary arithmetic as on the control.
    assert_eq!(value(&machine, "Q12"), Some(Value::Number(28.999_999_999_999_996)));
    for (name, expected) in [("QS12", "WORKPIECEPIECE"), ("QS13", "1.125"), ("QS14", "PIE")] {
        assert_eq!(text_value(&machine, name), expected);
    }
    let remarks: Vec<String> = machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
    assert_eq!(remarks, ["Q40 is undefined from here on: only a control knows the system data of FN 18"]);
    assert_eq!(machine.position(), [Some(12.5), Some(60.0), Some(100.0)]);
}

/// The sample programs with the small tables of the samples.
fn fit(contacts: Contacts) -> Machine {
    let store = InMemory::new()
        .with("fit_check.h", sample("programs/fit_check.h"))
        .with("FIT_HOLE.TAB", sample("tables/generation1_plain.tab"))
        .with("FIT_SHAFT.TAB", sample("tables/generation2_struct.tab"))
        .with("status_en.a", sample("masks/status_en.a"));
    Machine::new(r"TNC:\fitcheck\fit_main.h", program(&sample("programs/fit_main.h")), store, contacts, settings())
}

fn bore(diameter: &str) -> Contacts {
    let text = format!("[bore]\ncentre = [40.0, 30.0]\ndiameter = {diameter}\n");
    Contacts::Workpiece(Simulation::read(&text).unwrap().into())
}

#[track_caller]
fn check_fit(diameter: &str, word: &str, status: Status, printed: &str) {
    let mut machine = fit(bore(diameter));
    assert_eq!(machine.run(u64::MAX), Ok(Step::Paused(Pause::Stop)));
    assert_eq!(machine.run(u64::MAX), Ok(Step::Ended));
    let expected = String::from_utf8(sample("masks/status_en.expected.txt")).unwrap();
    let expected = expected.replace("GOOD", word).replace("25.0134", printed);
    let window = &machine.windows()[0];
    assert_eq!(window.text, expected);
    assert_eq!(window.mask.to_string(), r"TNC:\fitcheck\status_en.a");
    assert_eq!(machine.status(), Some(status));
    check_values(&machine, &[("Q23", 25.021), ("Q33", 25.0), ("Q22", 9.0), ("Q2", -1.0)]);
}

#[test]
fn the_sample_fit_check_is_good_rework_or_scrap_with_limits_inside() {
    check_fit("25.0134", "GOOD", Status::Good, "25.0134");
    check_fit("25.0", "GOOD", Status::Good, "25.0000");
    check_fit("25.021", "GOOD", Status::Good, "25.0210");
    check_fit("24.999999", "REWORK", Status::Rework, "25.0000");
    check_fit("25.021001", "SCRAP", Status::Scrap, "25.0210");
    check_fit("24.9", "REWORK", Status::Rework, "24.9000");
}

#[test]
fn jumps_calls_and_repeats_go_where_the_control_goes() {
    let blocks = "Q1 = 0\nCALL LBL \"ADD\"\nCALL LBL \"ADD\"\nLBL 1\nQ1 = Q1 + 1\nCALL LBL 1 REP 3\nQ2 = Q1\nM30\n\
                  LBL \"ADD\"\nQ1 = Q1 + 100\nLBL 0";
    check_values(&ran(blocks), &[("Q2", 204.0)]);
    // A count that is used up starts again: three times two rounds.
    let blocks = "Q1 = 0\nQ2 = 0\nLBL 1\nLBL 2\nQ1 = Q1 + 1\nCALL LBL 2 REP 1\nQ2 = Q2 + 1\nCALL LBL 1 REP 2";
    check_values(&ran(blocks), &[("Q1", 6.0), ("Q2", 3.0)]);
    // A subprogram in the normal flow runs once; LBL 0 is skipped.
    check_values(&ran("Q1 = 0\nLBL 5\nQ1 = Q1 + 1\nLBL 0\nQ1 = Q1 + 10"), &[("Q1", 11.0)]);
    // Labels from parameters; numbers and names are separate.
    let blocks = "QS5 = \"7\"\nQ5 = 7\nFN 9: IF +0 EQU +0 GOTO LBL QS5\nM30\nLBL 7\nQ1 = 2\nM30\nLBL \"7\"\nQ1 = 1";
    check_values(&ran(blocks), &[("Q1", 1.0)]);
    let blocks = "Q1 = 0\nFN 9: IF +Q9 IS UNDEFINED GOTO LBL 1\nM30\nLBL 1\nQ9 = 1\nFN 0: Q9 SET UNDEFINED\n\
                  FN 9: IF +Q9 IS DEFINED GOTO LBL 2\nQ1 = 5\nLBL 2";
    check_values(&ran(blocks), &[("Q1", 5.0)]);
    // As they are in binary.
    let blocks = "Q1 = 0.1 + 0.2\nQ2 = 1\nFN 9: IF +Q1 EQU +0.3 GOTO LBL 1\nQ2 = 0\nLBL 1";
    check_values(&ran(blocks), &[("Q2", 0.0)]);
}

#[test]
fn called_programs_share_q_and_keep_ql_for_themselves() {
    let store = InMemory::new().with(
        r"TNC:\fit\sub\called.h",
        "BEGIN PGM called MM\nQ1 = Q1 + 1\nFN 9: IF +QL1 IS DEFINED GOTO LBL 1\nQ2 = 1\nLBL 1\nQL1 = 99\n\
         CALL PGM ..\\other.h\nEND PGM called MM\n",
    );
    let store = store.with(r"TNC:\fit\other.h", "BEGIN PGM other MM\nQS1 = \"here\"\nEND PGM other MM\n");
    let mut machine = machine_in(store, "Q1 = 1\nQL1 = 5\nCALL PGM sub\\called.h\nCALL PGM TNC:\\fit\\sub\\called");
    to_end(&mut machine);
    check_values(&machine, &[("Q1", 3.0), ("Q2", 1.0), ("QL1", 5.0)]);
    assert_eq!(text_value(&machine, "QS1"), "here");
}

#[test]
fn m30_in_a_called_program_ends_the_run_with_a_remark() {
    let store = InMemory::new().with("sub.h", "BEGIN PGM sub MM\nM30\nEND PGM sub MM\n");
    let mut machine = machine_in(store, "Q1 = 1\nCALL PGM sub.h\nQ1 = 2");
    to_end(&mut machine);
    check_values(&machine, &[("Q1", 1.0)]);
    let (place, remark) = &machine.remarks()[0];
    assert_eq!(place.program.to_string(), r"TNC:\fit\sub.h");
    assert_eq!(remark.to_string(), "M30 in a called program ended the run: a control does not allow it there");
}

#[test]
fn stop_and_m0_pause_and_m1_where_it_is_wanted() {
    let mut machine = machine("STOP\nM1\nL X+1 R0 M0\nSTOP M30\nQ1 = 1");
    assert_eq!(machine.run(9), Ok(Step::Paused(Pause::Stop)));
    assert_eq!(machine.run(9), Ok(Step::Paused(Pause::Stop)));
    assert_eq!(machine.run(9), Ok(Step::Ended));
    assert_eq!(machine.run(9), Ok(Step::Ended));
    assert_eq!(value(&machine, "Q1"), None);
    let mut with = settings();
    with.optional_stop = true;
    let mut machine = Machine::new("a.h", program(text("M1").as_bytes()), InMemory::new(), Contacts::Perfect, with);
    assert_eq!(machine.run(9), Ok(Step::Paused(Pause::OptionalStop)));
}

#[test]
fn breakpoints_stop_before_their_block_and_let_go_on() {
    let mut machine = machine("Q1 = 1\nLBL 1\nQ1 = Q1 + 1\nCALL LBL 1 REP 2");
    let third = BlockPlace { program: NcPath::new(r"TNC:\fit\main.h").unwrap(), block: 3 };
    machine.toggle_breakpoint(third.clone());
    for expected in [1.0, 2.0, 3.0] {
        assert_eq!(machine.run(99), Ok(Step::Paused(Pause::Breakpoint)));
        assert_eq!(machine.place().block, 3);
        check_values(&machine, &[("Q1", expected)]);
    }
    machine.toggle_breakpoint(third);
    assert_eq!(machine.run(99), Ok(Step::Ended));
}

#[test]
fn blocks_with_a_skip_sign_run_unless_they_are_skipped() {
    let blocks = "Q1 = 1\n/Q1 = 2";
    check_values(&ran(blocks), &[("Q1", 2.0)]);
    let mut with = settings();
    with.block_skip = true;
    let mut machine = Machine::new("a.h", program(text(blocks).as_bytes()), InMemory::new(), Contacts::Perfect, with);
    to_end(&mut machine);
    check_values(&machine, &[("Q1", 1.0)]);
}

#[test]
fn a_given_value_wins_over_the_first_assignment_in_the_main_program() {
    let mut machine = machine("Q1 = 25\nQ2 = Q2 + 1\nQ3 = Q1\nQ1 = 30\nDECLARE STRING QS1 = \"H7\"");
    machine.set(Parameter::q(1), Value::Number(50.0)).unwrap();
    machine.set(Parameter::q(2), Value::Number(7.0)).unwrap();
    machine.set(Parameter::qs(1), Value::Text("g6".to_owned())).unwrap();
    to_end(&mut machine);
    check_values(&machine, &[("Q1", 30.0), ("Q2", 8.0), ("Q3", 50.0)]);
    assert_eq!(text_value(&machine, "QS1"), "g6");
    let remarks: Vec<String> = machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
    assert_eq!(
        remarks,
        [
            "Q1 = 50 was given before the run and replaces this block's value",
            "QS1 = \"g6\" was given before the run and replaces this block's value"
        ]
    );
}

#[test]
fn the_machine_may_go_to_another_thread() {
    fn is_send<T: Send>(_: &T) {}
    is_send(&machine(""));
}

#[test]
fn budgets_have_a_fault_each() {
    let kind = |blocks: &str, change: fn(&mut Budget)| {
        let mut with = settings();
        change(&mut with.budget);
        let mask = "\"%S\", QS1;\n";
        let store = InMemory::new().with("m.a", mask).with("one.tab", TABLE).with("two.tab", TABLE);
        let store = store.with("full.a", "M_APPEND_MAX0;\n\"%S\", QS1;\n");
        let mut machine =
            Machine::new(r"TNC:\main.h", program(text(blocks).as_bytes()), store, Contacts::Perfect, with);
        machine.set(Parameter::qs(1), Value::Text("x".repeat(100))).unwrap();
        machine.set(Parameter::q(1), Value::Number(0.0)).unwrap();
        let fault = loop {
            match machine.run(u64::MAX) {
                Ok(Step::Ended) => panic!("{blocks}"),
                Ok(_) => {}
                Err(fault) => break fault,
            }
        };
        *fault.kind
    };
    let forever = |block: &str| format!("LBL 1\n{block}\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    // To its end it runs in `session_program`.
    assert_eq!(settings().budget.blocks, 10_000_000);
    assert_eq!(kind(&forever("Q1 = Q1 + 1"), |budget| budget.blocks = 100), UsedUp::Blocks(100).into());
    assert_eq!(kind("LBL 1\nCALL LBL 1", |_| {}), UsedUp::LabelCalls(20).into());
    assert_eq!(kind("CALL PGM main.h", |_| {}), UsedUp::ProgramCalls(10).into());
    let print = forever("FN 16: F-PRINT m.a / SCREEN:");
    assert_eq!(kind(&print, |budget| budget.windows = 3), UsedUp::Windows(3).into());
    assert_eq!(kind(&print, |budget| budget.output_bytes = 1_000), UsedUp::Output(1_000).into());
    let print = forever("FN 16: F-PRINT m.a / out.txt");
    assert_eq!(kind(&print, |budget| budget.outputs = 3), UsedUp::Outputs(3).into());
    assert_eq!(kind(&print, |budget| budget.traffic = 1_000), UsedUp::Traffic(1_000).into());
    // Only a file that takes no text any more is printed to in vain, and that is counted, too.
    let print = forever("FN 16: F-PRINT full.a / out.txt");
    assert_eq!(kind(&print, |budget| budget.outputs = 3), UsedUp::Outputs(3).into());
    let elsewhere = |path: &str| {
        forever(&format!("QS2 = TOCHAR ( DAT+Q1 )\nQS2 = {path}\nFN 16: F-PRINT m.a / :'QS2'\nQ1 = Q1 + 1"))
    };
    let files = elsewhere("QS2 || \".txt\"");
    assert_eq!(kind(&files, |budget| budget.output_files = 3), UsedUp::OutputFiles(3).into());
    let folders = elsewhere("QS2 || \"\\out.txt\"");
    assert_eq!(kind(&folders, |budget| budget.folders = 3), UsedUp::Folders(3).into());
    // Folders on the way count, too.
    assert_eq!(kind(r"FN 16: F-PRINT m.a / a\b\c\out.txt", |budget| budget.folders = 2), UsedUp::Folders(2).into());
    let change = |table: &str| format!("FN 26: TABOPEN {table}.tab\nFN 27: TABWRITE 0/\"H7\" = Q1");
    let change = forever(&format!("{}\n{}", change("one"), change("two")));
    assert_eq!(kind(&change, |budget| budget.table_writes = 3), UsedUp::TableWrites(3).into());
    let step = forever("L IX+1 Y+0 Z+0 R0 FMAX");
    let step = format!("L X+0 Y+0 Z+0\n{step}");
    assert_eq!(kind(&step, |budget| budget.path = 10), UsedUp::Path(10).into());
    let touch = forever("TCH PROBE 421 X ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+10");
    assert_eq!(kind(&touch, |budget| budget.cycles = 2), UsedUp::Cycles(2).into());
    assert_eq!(kind("CALL PGM none.h", |budget| budget.files = 0).to_string(), r"file not found: TNC:\none.h");
    let grow = forever("QS1 = QS1 || QS1");
    assert_eq!(kind(&grow, |_| {}), FaultKind::TextTooLong { length: 400, most: 255 });
    assert_eq!(UsedUp::Blocks(100).to_string(), "limit of 100 blocks reached: possible endless loop");
}

#[test]
fn what_numbers_cannot_do_is_said() {
    assert_eq!(fault("Q1 = Q2 + 1"), "Q2 is undefined");
    assert_eq!(fault("FN 11: IF +Q7 GT +1 GOTO LBL 1"), "Q7 is undefined");
    assert_eq!(fault("QS2 = QS1"), "QS1 is undefined");
    assert_eq!(fault("L X+Q5"), "Q5 is undefined");
    assert_eq!(fault("Q1 = 1 / 0"), "division by zero");
    assert_eq!(fault("FN 4: Q1 = +1 DIV +0"), "division by zero");
    assert_eq!(fault("Q1 = 5 % 0"), "division by zero");
    assert_eq!(fault("FN 5: Q1 = SQRT -4"), "the square root of -4 is not defined");
    assert_eq!(fault("Q1 = ( 0 - 8 ) ^ 0.5"), "the square root of -8 is not defined");
    assert_eq!(fault("Q1 = ASIN 2"), "ASIN 2 is not defined");
    assert_eq!(fault("Q1 = LN 0"), "LN 0 is not defined");
    assert_eq!(fault("Q1 = 100000 * 1000000"), "100000000000 is beyond the range of values, -10^10 to 10^10");
    assert_eq!(fault("Q1 = EXP 9999 - EXP 9999"), "inf is beyond the range of values, -10^10 to 10^10");
    check_values(&ran("Q1 = 100000 * 100000"), &[("Q1", 1e10)]);
    assert_eq!(fault("QS1 = \"x\"\nQ1 = TONUMB ( SRC_QS1 )"), "QS1 = \"x\" is not a number");
    assert_eq!(
        fault("QS1 = \"abc\"\nQS2 = SUBSTR ( SRC_QS1 BEG4 LEN1 )"),
        "the text has 3 characters: position 4 is past its end"
    );
    assert_eq!(
        fault("Q2 = - 1\nQS1 = \"abc\"\nQS2 = SUBSTR ( SRC_QS1 BEG+Q2 )"),
        "BEG = -1: expected a whole number from 0"
    );
    assert_eq!(
        fault("QS1 = SYSSTR ( ID5 NR0 )"),
        "unknown system text ID5 NR0: only date and time (ID10321) are supported"
    );
    assert_eq!(fault("FN 14: ERROR= 1072"), "the program stopped itself with error 1072");
}

#[test]
fn what_texts_can_do() {
    let blocks = "QS1 = \"abc\"\nQS2 = SUBSTR ( SRC_QS1 BEG1 LEN9 )\nQ1 = STRLEN ( SRC_QS9 )\nQS3 = \"x\"\n\
                  Q2 = INSTR ( SRC_QS1 SEA_QS3 BEG0 )\nQ3 = STRCOMP ( SRC_QS3 SEA_QS1 )\nQ4 = STRCOMP ( SRC_QS1 SEA_QS1 )\n\
                  QS4 = \"ab\"\nQ5 = STRCOMP ( SRC_QS4 SEA_QS1 )\nQS5 = TOCHAR ( DAT+25 )\nQS6 = TOCHAR ( DAT-2.5 DECIMALS0 )\n\
                  Q6 = 25 + 21 / 1000 - 42 / 1000\nQS7 = TOCHAR ( DAT+Q6 )\nQS8 = SYSSTR ( ID10321 NR0 )\nQS11 = \"12,5\"\n\
                  Q7 = TONUMB ( SRC_QS11 )\nQS12 = \"A\"\nQS13 = \"a\"\nQ8 = STRCOMP ( SRC_QS12 SEA_QS13 )";
    let machine = ran(blocks);
    for (name, expected) in
        [("QS2", "bc"), ("QS5", "25"), ("QS6", "-3"), ("QS7", "24.979"), ("QS8", "07.03.2026 08:05:09")]
    {
        assert_eq!(text_value(&machine, name), expected, "{name}");
    }
    // Capitals come before small letters, the beginning of a text before the text.
    check_values(
        &machine,
        &[("Q1", -1.0), ("Q2", 3.0), ("Q3", 1.0), ("Q4", 0.0), ("Q5", -1.0), ("Q7", 12.5), ("Q8", -1.0)],
    );
}

#[test]
fn labels_that_cannot_be_gone_to_are_named() {
    assert_eq!(fault("FN 9: IF +0 EQU +0 GOTO LBL \"NOWHERE\""), "LBL \"NOWHERE\" does not occur in the program");
    assert_eq!(fault("CALL LBL 7"), "LBL 7 does not occur in the program");
    assert_eq!(fault("LBL 7\nLBL 7\nCALL LBL 7"), "LBL 7 is defined twice, in line 2 and line 3");
    assert_eq!(fault("CALL LBL 0"), "LBL 0 ends a subprogram: nothing can jump to it");
    assert_eq!(fault("QS5 = \"X\"\nCALL LBL QS5"), "LBL \"X\" does not occur in the program");
    assert_eq!(fault("Q5 = 1.5\nCALL LBL Q5"), "Q5 = 1.5 is not a label");
}

const TABLE: &str = "BEGIN own.tab\nNR  BEREICH  H7    NOTE\n0   3        +10   a b\n1            0     -\n2   6        x     -\n[END]\n";

#[track_caller]
fn table_fault(blocks: &str) -> String {
    fault_of(&mut machine_in(InMemory::new().with("own.tab", TABLE), blocks))
}

#[test]
fn tables_are_read_by_row_and_column() {
    let mut machine = machine_in(
        InMemory::new().with("own.tab", TABLE),
        "FN 26: TABOPEN own.tab\nFN 28: TABREAD Q5 = 0/\"BEREICH,H7\"\nQ1 = 1\nQS1 = \"H7\"\n\
         FN 28: TABREAD Q2 = +Q1/QS1\nFN 28: TABREAD QS2 = 0/\"NOTE\"",
    );
    to_end(&mut machine);
    check_values(&machine, &[("Q5", 3.0), ("Q6", 10.0), ("Q2", 0.0)]);
    assert_eq!(text_value(&machine, "QS2"), "a b");
}

/// NC-Solution 8255 reads BEREICH first and BEREIK after that, from the same table.
#[test]
fn the_range_column_is_found_in_both_spellings() {
    let other = TABLE.replace("BEREICH", "BEREIK ");
    for (table, has, lacks) in [(TABLE, "BEREICH", "BEREIK"), (other.as_str(), "BEREIK", "BEREICH")] {
        let blocks = "FN 26: TABOPEN own.tab\nFN 28: TABREAD Q5 = 0/\"BEREICH\"\nFN 28: TABREAD Q6 = 0/\"BEREIK,H7\"\n\
                      Q8 = 4\nFN 27: TABWRITE 0/\"BEREIK\" = Q8\nFN 28: TABREAD Q9 = 0/\"BEREICH\"";
        let mut machine = machine_in(InMemory::new().with("own.tab", table), blocks);
        to_end(&mut machine);
        check_values(&machine, &[("Q5", 3.0), ("Q6", 3.0), ("Q7", 10.0), ("Q9", 4.0)]);
        let said: Vec<String> = machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
        let said: Vec<&String> = said.iter().filter(|said| said.contains("spelling")).collect();
        let expected =
            format!("table own.tab has no column {lacks}: {has} was used, the other spelling in NC-Solution 8255");
        assert!(!said.is_empty() && said.iter().all(|said| **said == expected), "{said:?}");
    }
}

#[test]
fn what_tables_cannot_do_is_said() {
    let open = "FN 26: TABOPEN own.tab\n";
    assert_eq!(table_fault("FN 28: TABREAD Q1 = 0/\"H7\""), "no table is open");
    assert_eq!(table_fault("FN 26: TABOPEN none.tab"), r"file not found: TNC:\fit\none.tab");
    assert_eq!(
        table_fault(&format!("{open}FN 28: TABREAD Q1 = 0/\"h7\"")),
        "table own.tab has no column h7; its columns are NR, BEREICH, H7, NOTE"
    );
    assert_eq!(
        table_fault(&format!("{open}FN 28: TABREAD Q1 = 3/\"H7\"")),
        "table own.tab has no row 3: its rows are 0 to 2"
    );
    assert_eq!(
        table_fault(&format!("{open}FN 28: TABREAD Q1 = 1/\"BEREICH\"")),
        "table own.tab, row 1, column BEREICH: the cell is empty"
    );
    assert_eq!(
        table_fault(&format!("{open}FN 28: TABREAD Q1 = 2/\"H7\"")),
        "table own.tab, row 2, column H7: x is not a number"
    );
    assert_eq!(
        table_fault(&format!("{open}FN 28: TABREAD Q1 = 0.5/\"H7\"")),
        "row = 0.5: expected a whole number from 0"
    );
    assert_eq!(
        table_fault(&format!("{open}FN 28: TABREAD Q1999 = 0/\"NR,H7\"")),
        "parameter Q2000 does not exist: Q and QS go up to 1999, QL and QR up to 499"
    );
}

#[test]
fn fn_27_changes_the_open_table_and_writes_it_when_it_is_closed() {
    let blocks = "FN 26: TABOPEN own.tab\nQ1 = 12.5\nFN 27: TABWRITE 2/\"H7\" = Q1\nFN 28: TABREAD Q2 = 2/\"H7\"\n\
                  FN 26: TABOPEN 82553_hole.tab\nFN 26: TABOPEN own.tab\nFN 28: TABREAD Q3 = 2/\"H7\"";
    let mut machine = machine_in(InMemory::new().with("own.tab", TABLE), blocks);
    to_end(&mut machine);
    check_values(&machine, &[("Q2", 12.5), ("Q3", 12.5)]);
    // Nothing is written into folders that were given for reading only; the change stays in memory.
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("own.tab"), TABLE.as_bytes()).unwrap();
    let store = Folders::new().reading(folder.path());
    let mut machine = Machine::new("main.h", program(text(blocks).as_bytes()), store, Contacts::Perfect, settings());
    to_end(&mut machine);
    check_values(&machine, &[("Q3", 12.5)]);
    assert_eq!(std::fs::read(folder.path().join("own.tab")).unwrap(), TABLE.as_bytes());
    assert_eq!(machine.remarks()[0].1.to_string(), r"TNC:\own.tab was not written: no output folder was chosen");
    let too_wide = "FN 26: TABOPEN own.tab\nFN 27: TABWRITE 2/\"H7\" = Q1";
    let mut machine = machine_in(InMemory::new().with("own.tab", TABLE), too_wide);
    machine.set(Parameter::q(1), Value::Number(1234.567)).unwrap();
    assert_eq!(fault_of(&mut machine), "table own.tab: row 2, column H7: 1234.567 does not fit into 6 characters");
}

#[test]
fn recorded_contacts_that_no_cycle_took_are_told() {
    let contact = |[x, y]: [f64; 2]| fitcheck::probing::Contact { x, y, z: -8.0 };
    let four = [[12.5, 0.0], [0.0, 12.5], [-12.5, 0.0], [0.0, -12.5]].map(contact);
    let left = |contacts: Vec<_>| {
        let blocks = "TOOL CALL 1 Z\nTCH PROBE 421 X ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ261=-8 ~\nQ260=+50";
        let contacts = Contacts::Recorded(contacts);
        let mut machine = Machine::new("main.h", program(text(blocks).as_bytes()), Shipped, contacts, settings());
        to_end(&mut machine);
        machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect::<Vec<_>>()
    };
    let is_left = |remark: &&String| remark.starts_with("the cycles used");
    assert_eq!(left(four.to_vec()).iter().find(is_left), None);
    let left = left([four, four].concat());
    assert_eq!(left.iter().find(is_left), Some(&"the cycles used 4 of 8 recorded contacts".to_owned()));
}

#[test]
fn a_table_that_is_written_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("own.tab"), TABLE.as_bytes()).unwrap();
    let blocks = "Q1 = 5\nFN 26: TABOPEN own.tab\nFN 27: TABWRITE 0/\"H7\" = Q1";
    let store = Folders::new().writing(folder.path());
    let mut machine = Machine::new("main.h", program(text(blocks).as_bytes()), store, Contacts::Perfect, settings());
    to_end(&mut machine);
    assert_eq!(machine.remarks()[0].1.to_string(), r"TNC:\own.tab was written");
    let written = String::from_utf8(std::fs::read(folder.path().join("own.tab")).unwrap()).unwrap();
    assert!(written.contains("\n0   3        5     a b"), "{written}");
}

#[test]
fn a_loop_around_changed_tables_ends_even_where_nothing_is_written() {
    let change = |table: &str| format!("FN 26: TABOPEN {table}\nFN 27: TABWRITE 2/\"H7\" = Q1\n");
    let blocks = ["Q1 = 5\nLBL 1\n", &change("a.tab"), &change("b.tab"), "FN 9: IF +0 EQU +0 GOTO LBL 1"].concat();
    let folder = tempfile::tempdir().unwrap();
    for table in ["a.tab", "b.tab"] {
        fitcheck::files::write(&folder.path().join(table), TABLE.as_bytes()).unwrap();
    }
    let mut with = settings();
    with.budget.traffic = 10_000;
    with.budget.blocks = 10_000;
    let store = Folders::new().reading(folder.path());
    let mut machine = Machine::new("main.h", program(text(&blocks).as_bytes()), store, Contacts::Perfect, with);
    assert_eq!(*machine.run(u64::MAX).unwrap_err().kind, UsedUp::Traffic(10_000).into());
}

#[test]
fn a_loop_full_of_remarks_goes_on_as_fast() {
    let unknown = "APPR 1\n".repeat(2_000);
    let mut with = settings();
    with.skip_unknown = true;
    with.budget.blocks = 1_000_000;
    let blocks = format!("LBL 1\n{unknown}FN 9: IF +0 EQU +0 GOTO LBL 1");
    let mut machine = Machine::new("main.h", program(text(&blocks).as_bytes()), Shipped, Contacts::Perfect, with);
    assert_eq!(*machine.run(u64::MAX).unwrap_err().kind, UsedUp::Blocks(1_000_000).into());
    assert_eq!(machine.remarks().len(), 1_000);
}

#[test]
fn fn_16_opens_windows_and_closes_them() {
    let store = InMemory::new().with("m.a", "\"%9.4F|%S\", Q1, QS1;\n");
    let mut machine = machine_in(
        store,
        "Q1 = 25 + 21 / 1000\nQS1 = \"GOOD\"\nFN 16: F-PRINT m.a / SCREEN:\nFN 16: F-PRINT m.a / SCLR:",
    );
    to_end(&mut machine);
    assert_eq!(machine.windows()[0].text, "  25.0210|GOOD\n");
    assert!(!machine.windows()[0].is_open);
    let undefined = InMemory::new().with("m.a", "\"%9.4F\", Q1;\n");
    assert_eq!(
        fault_of(&mut machine_in(undefined, "FN 16: F-PRINT m.a / SCREEN:")),
        r"mask TNC:\fit\m.a: line 1, column 2: Q1 is not defined"
    );
    let broken = InMemory::new().with("m.a", "\"%9.4Z\", Q1;\n");
    assert!(
        fault_of(&mut machine_in(broken, "FN 16: F-PRINT m.a / SCREEN:")).starts_with(r"mask TNC:\fit\m.a: line 1")
    );
}

#[test]
fn fn_16_writes_below_the_chosen_folder_and_nowhere_else() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    std::fs::create_dir(&out).unwrap();
    let masks = folder.path().join("masks");
    std::fs::create_dir(&masks).unwrap();
    fitcheck::files::write(&masks.join("open.a"), b"\"one %F\", Q1;\n").unwrap();
    fitcheck::files::write(&masks.join("close.a"), b"\"two\";\nM_CLOSE;\n").unwrap();
    fitcheck::files::write(&masks.join("append.a"), b"M_APPEND;\n\"three\";\nM_CLOSE;\n").unwrap();
    let store = || Folders::new().reading(&masks).writing(&out);
    let run = |blocks: &str| {
        let program = program(text(blocks).as_bytes());
        let mut machine = Machine::new(r"TNC:\fit\main.h", program, store(), Contacts::Perfect, settings());
        machine.set(Parameter::q(1), Value::Number(1.0)).unwrap();
        machine
    };
    let print = |mask: &str, to: &str| format!("FN 16: F-PRINT {mask}.a / {to}\n");
    // Outputs are collected until a mask closes the file; then it starts again, or is added to.
    let blocks = [print("open", "res.txt"), print("close", "res.txt"), print("append", "res.txt")].concat();
    to_end(&mut run(&blocks));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    // What has a figure was not measured here.
    assert_eq!(read("fit/res.txt"), "# Simulated by Fitcheck - not measured\r\none 1.000000\r\ntwo\r\nthree\r\n");
    to_end(&mut run(&print("close", r"TNC:\res.txt")));
    assert_eq!(read("res.txt"), "two\r\n");
    for (to, expected) in [
        (r"..\..\x.txt", r"..\..\x.txt leads out of the folder"),
        (r"C:\..\x.txt", r"C:\..\x.txt is neither a path on TNC: nor a path from the program's folder"),
        ("NUL", "NUL in NUL is not a name for a file or folder"),
    ] {
        assert_eq!(fault_of(&mut run(&print("close", to))), expected);
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(folder.path(), out.join("link")).unwrap();
        let to = r"TNC:\link\x.txt";
        assert_eq!(fault_of(&mut run(&print("close", to))), r"TNC:\link\x.txt leads out of the given folders");
        std::os::unix::fs::symlink("/etc/hostname", masks.join("etc.a")).unwrap();
        let blocks = print("etc", "SCREEN:");
        assert_eq!(fault_of(&mut run(&blocks)), r"TNC:\fit\etc.a leads out of the given folders");
    }
    assert!(!folder.path().join("x.txt").exists());
    // Without a folder the run continues, and the text is kept.
    let program = program(text(&print("close", "res.txt")).as_bytes());
    let reading = Folders::new().reading(&masks);
    let mut machine = Machine::new("main.h", program, reading, Contacts::Perfect, settings());
    to_end(&mut machine);
    assert_eq!((machine.outputs()[0].text.as_str(), machine.outputs()[0].is_saved), ("two\n", false));
    assert_eq!(machine.remarks().len(), 1);
}

const CYCLE_427: &str = "TCH PROBE 427 MEASURE COORDINATE ~\nQ263=+35 ~\nQ264=+45 ~\nQ261=+5 ~\nQ272=+3 ~\nQ267=-1 ~\n\
                         Q288=+5,1 ~\nQ289=+4.95";

#[test]
fn a_cycle_hands_its_results_over_and_its_way_is_kept() {
    let blocks = format!("TOOL CALL 1 Z\nL X+0 Y+0 R0 FMAX\nL Z+50 R0 FMAX\n{CYCLE_427}\nL IZ+5 R0 F100");
    let machine = ran(&blocks);
    check_values(&machine, &[("Q160", 5.0), ("Q180", 1.0), ("Q181", 0.0), ("Q182", 0.0), ("Q198", 427.0)]);
    assert_eq!(value(&machine, "Q160"), Some(Value::Length("5".parse().unwrap())));
    assert_eq!(machine.status(), Some(Status::Good));
    let path = machine.path();
    let is_at = |one: [f64; 3], other: [f64; 3]| one.iter().zip(&other).all(|(one, other)| (one - other).abs() <= 0.0);
    assert!(is_at(path[0].from, [0.0, 0.0, 50.0]));
    assert!(path.windows(2).all(|pair| is_at(pair[0].to, pair[1].from)), "{path:?}");
    assert_eq!(path.last().unwrap().kind, TravelKind::Feed);
    assert_eq!(machine.cycles()[0].cycle.number, 427);
}

#[test]
fn q281_writes_the_measuring_log_beside_the_program_or_shows_it() {
    let folder = tempfile::tempdir().unwrap();
    let block = |x: &str, log: &str| {
        format!(
            "TCH PROBE 427 X ~\nQ263=+{x} ~\nQ264=+0 ~\nQ261=+5 ~\nQ272=+1 ~\nQ267=-1 ~\nQ281=+{log} ~\nQ288=+40 ~\nQ289=+30\n"
        )
    };
    let store = Folders::new().writing(folder.path());
    let blocks = text(&[block("35", "1"), block("36.5", "1"), block("20", "2"), block("1", "0")].concat());
    let mut machine =
        Machine::new(r"TNC:\fit\main.h", program(blocks.as_bytes()), store, Contacts::Perfect, settings());
    to_end(&mut machine);
    let [one, two] = machine.outputs() else { panic!("{:?}", machine.outputs()) };
    assert_eq!((one.path.to_string().as_str(), one.is_saved, two.is_saved), (r"TNC:\fit\TCHPR427.TXT", true, true));
    let logs: Vec<_> = log::read(&std::fs::read(folder.path().join("fit/TCHPR427.TXT")).unwrap())
        .into_iter()
        .map(|log| match log.unwrap() {
            Log { figures, program, .. } if figures.len() == 1 => (figures[0].actual.to_string(), program),
            other => panic!("{other:?}"),
        })
        .collect();
    let of = |actual: &str| (actual.to_owned(), Some(r"TNC:\fit\main.h".to_owned()));
    assert_eq!(logs, [of("35"), of("36.5")]);
    let [window] = machine.windows() else { panic!("{:?}", machine.windows()) };
    assert!(window.text.contains("20.0000"), "{}", window.text);
    // Without a folder the text still exists.
    let program = program(text(&block("35", "1")).as_bytes());
    let mut machine = Machine::new(r"TNC:\fit\main.h", program, Shipped, Contacts::Perfect, settings());
    to_end(&mut machine);
    assert_eq!((machine.outputs().len(), machine.outputs()[0].is_saved), (1, false));
    let mut remarks = machine.remarks().iter().map(|(_, remark)| remark.to_string());
    assert!(remarks.any(|remark| remark.ends_with("no output folder was chosen")));
}

/// What `fitcheck cycle 444 --as-block` writes.
#[test]
fn a_cycle_takes_the_word_mb() {
    let block = |mb: &str| {
        format!(
            "Q5 = 7\nTOOL CALL 1 Z\nTCH PROBE 444 TASTEN 3D ~\n Q263=+1 ~\n Q264=+2 ~\n Q294=+3 ~\n Q581=+0 ~\n Q582=+0 ~\n Q583=+1 ~\n \
             Q260=+50 ~\n {mb}"
        )
    };
    for mb in ["MB=+7 ;TERUGTREKAFSTAND", "mb = Q5"] {
        let machine = ran(&block(mb));
        let last = machine.cycles()[0].result.path.last().unwrap().to;
        assert!((last[2] - 10.0).abs() < 1e-9, "{last:?}");
    }
    // The end of the machine's traverse: a simulated workpiece has none.
    assert_eq!(fault(&block("MB=MAX")), "cycle 444: MB RETRACTION: MAX is not a number");
    assert_eq!(fault(&block("MB=+7 ~\n MB=+7")), "cycle 444: MB is given twice");
    assert_eq!(fault(&block("QB=+7")), "unknown block: Fitcheck runs only what it understands");
    assert!(fault(&block("BM=+7")).starts_with("cycle 444 has no parameter BM"));
}

#[test]
fn a_stop_of_q309_pauses_with_its_reason() {
    let blocks =
        "TCH PROBE 421 MEASURE HOLE ~\nQ273=+40 ~\nQ274=+30 ~\nQ262=+25 ~\nQ275=+25.021 ~\nQ276=+25 ~\nQ309=+1\nQ1 = 1";
    let mut machine = Machine::new("a.h", program(text(blocks).as_bytes()), InMemory::new(), bore("25.1"), settings());
    let Ok(Step::Paused(Pause::Tolerance(stop))) = machine.run(99) else { panic!("no stop") };
    assert_eq!(
        stop.to_string(),
        "program stop by Q309 = 1: measured diameter 25.1 mm is above its maximum 25.021 mm: SCRAP"
    );
    assert_eq!(machine.run(99), Ok(Step::Ended));
    check_values(&machine, &[("Q1", 1.0), ("Q182", 1.0)]);
}

#[test]
fn what_cycles_cannot_do_is_said() {
    let with = |line: &str| format!("{CYCLE_427} ~\n{line}");
    assert_eq!(fault(&with("Q275=+1")), "cycle 427 has no parameter Q275");
    assert_eq!(fault(&with("Q263=+1")), "cycle 427: Q263 is given twice");
    assert_eq!(
        fault(&with("Q320=-1")),
        "cycle 427: Q320 SET-UP CLEARANCE = -1 mm: at least 0 mm, at most 99999.9999 mm"
    );
    assert_eq!(fault(&with("Q320=+Q77")), "Q77 is undefined");
    assert_eq!(fault("TCH PROBE 427 X ~\nQ263=+35"), "cycle 427: Q264 1ST POINT 2ND AXIS is missing");
    assert_eq!(fault(&with("Q320= PREDEF")), "cycle 427: Q320 SET-UP CLEARANCE = PREDEF: no GLOBAL DEF gives a value");
    let known: Vec<_> = cycles_of(Control::Milling).map(|cycle| cycle.code).collect();
    let unknown =
        format!("Fitcheck does not follow cycle 431, even where the control has it: it follows {}", known.join(", "));
    assert_eq!(fault("TCH PROBE 431 MEASURE PLANE ~\nQ263=+35"), unknown);
    let mut machine = Machine::new(
        "a.h",
        program(text(CYCLE_427).as_bytes()),
        InMemory::new(),
        Contacts::Recorded(Vec::new()),
        settings(),
    );
    assert_eq!(fault_of(&mut machine), "cycle 427: contact 1: the file has only 0 contacts");
}

#[test]
fn a_file_that_is_there_but_cannot_be_read_is_not_passed_over_for_another() {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("sub.i"), b"%SUB G71 *\nN1 D00 Q1 P01 +1 *\nN2 %SUB G71 *\n").unwrap();
    let run = || {
        let store = Folders::new().reading(folder.path());
        Machine::new("main.h", program(text("CALL PGM sub").as_bytes()), store, Contacts::Perfect, settings())
    };
    to_end(&mut run());
    std::fs::create_dir(folder.path().join("sub.h")).unwrap();
    assert_eq!(fault_of(&mut run()), r"TNC:\sub.h is not a file");
}

#[test]
fn a_broken_file_is_named() {
    let run = |text: &str| {
        let mut machine = Machine::new("a.h", program(text.as_bytes()), InMemory::new(), Contacts::Perfect, settings());
        fault_of(&mut machine)
    };
    assert_eq!(run("BEGIN PGM a MM\nQ1 = 1\n"), "the program is broken: END PGM is missing");
    assert_eq!(run("Q1 = 1\nEND PGM a MM\n"), "the program is broken: BEGIN PGM is missing");
    let store = InMemory::new().with("sub.h", [1_u8, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(
        fault_of(&mut machine_in(store, "CALL PGM sub.h")),
        r"TNC:\fit\sub.h: the file is not text: 8 of its 8 bytes are not characters"
    );
}

/// Runs the built-in Dutch programs with a nominal size and a class on a bore or a stud.
fn shipped(nominal: &str, class: &str, workpiece: &str) -> Machine {
    let main = program(Shipped::file("8255_nl.h").unwrap());
    let contacts = Contacts::Workpiece(Simulation::read(workpiece).unwrap().into());
    let mut machine = Machine::new(r"TNC:\8255_nl.h", main, Shipped, contacts, settings());
    machine.set(Parameter::q(1), Value::Number(nominal.parse().unwrap())).unwrap();
    machine.set(Parameter::qs(1), Value::Text(class.to_owned())).unwrap();
    machine
}

#[test]
fn the_shipped_programs_print_the_native_window() {
    for (callout, measured) in
        [("25 H7", "25.0134"), ("24.99995 H7", "25.02095"), ("8 JS7", "7.9925"), ("18 g6", "17.9945")]
    {
        let parsed: Callout = callout.parse().unwrap();
        let measured: Length = measured.parse().unwrap();
        let limits = Sources::of_tables(shipped_tables()).limits(&parsed, None).unwrap();
        let record = Record {
            time: settings().time,
            id: String::new(),
            callout: Some(parsed),
            verdict: judge(&limits, measured, None),
            doubt: None,
            correction: None,
            budget: None,
            limits,
            measurement: Measurement::of_diameter(measured, Origin::Typed),
        };
        let kind = if callout.contains('g') { "stud" } else { "bore" };
        let workpiece = format!("[{kind}]\ncentre = [40.0, 30.0]\ndiameter = {measured}\n");
        let (nominal, class) = callout.split_once(' ').unwrap();
        let mut machine = shipped(nominal, class, &workpiece);
        to_end(&mut machine);
        assert_eq!(machine.windows()[0].text, status_window(&record, Dialogue::Nl, None).unwrap(), "{callout}");
        assert_eq!(machine.status(), Some(record.verdict.status()), "{callout}");
    }
}

/// Q41 turns the contacts, Q51 moves the places where the probings begin: 25 mm about (12, -7), from 30 degrees on.
#[test]
fn the_shipped_program_measures_from_q41_on_with_the_clearance_of_q51() {
    let mut machine = shipped("25", "H7", "[bore]\ncentre = [12.0, -7.0]\ndiameter = 25.0\n");
    for (name, value) in [("Q11", 12.0), ("Q21", -7.0), ("Q31", -3.0), ("Q41", 30.0), ("Q51", 4.0)] {
        machine.set(name.parse().unwrap(), Value::Number(value)).unwrap();
    }
    to_end(&mut machine);
    let result = &machine.cycles()[0].result;
    let rounded = |place: [f64; 3]| place.map(|part| (part * 1e4).round() / 1e4);
    let contacts: Vec<_> = result.contacts.iter().map(|contact| rounded(contact.place())).collect();
    // 12.5 cos 30 = 10.8253, 12.5 sin 30 = 6.25, then in steps of 90 degrees.
    let expected = [[22.8253, -0.75, -3.0], [5.75, 3.8253, -3.0], [1.1747, -13.25, -3.0], [18.25, -17.8253, -3.0]];
    assert_eq!(contacts, expected);
    let begins = |wanted| {
        let of = |step: &&Move| step.touch == Some(1) && step.phase == wanted;
        rounded(result.path.iter().find(of).unwrap().from)
    };
    // 4 mm of Q51 and 2 mm of SET_UP before the contact: 6.5 cos 30 = 5.6292, 6.5 sin 30 = 3.25.
    assert_eq!(format!("{:?}", begins(Phase::Approach)), "[17.6292, -3.75, -3.0]");
}

#[test]
fn what_is_odd_in_a_called_program_is_told_in_every_run() {
    let sub = "BEGIN PGM sub MM\nTCH PROBE 421 A ~\n Q301=+0 ;X\n Q275=+25.01 ;X\nEND PGM sub MM\n";
    let mut machine = machine_in(InMemory::new().with("sub.h", sub), "TOOL CALL 1 Z\nCALL PGM sub.h");
    for _ in 0..2 {
        let _fault = machine.run(100).unwrap_err();
        let said: Vec<String> = machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
        let [said] = said.as_slice() else { panic!("{said:?}") };
        assert!(said.starts_with("TNC:\\fit\\sub.h: line 4, column 2: cycle 421 ended in line 3"), "{said}");
        machine.restart(Contacts::Perfect);
    }
}

#[test]
fn a_restart_forgets_the_run_and_sees_changed_files() {
    let mut machine = fit(bore("25.0134"));
    machine.toggle_breakpoint(BlockPlace { program: NcPath::new(r"TNC:\fitcheck\fit_main.h").unwrap(), block: 3 });
    for (diameter, status) in [("25.0134", Status::Good), ("25.1", Status::Scrap), ("24.9", Status::Rework)] {
        machine.restart(bore(diameter));
        assert_eq!((machine.status(), machine.blocks_run(), machine.place().block), (None, 0, 0));
        to_end(&mut machine);
        assert_eq!((machine.status(), machine.windows().len()), (Some(status), 1));
        assert_eq!(machine.breakpoints().len(), 1);
    }
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    let blocks = "CALL PGM sub.h\nFN 26: TABOPEN own.tab\nFN 28: TABREAD Q2 = 0/\"H7\"";
    let store = Folders::new().reading(folder.path());
    let main = program(text(blocks).as_bytes());
    let mut machine = Machine::new("main.h", main, store, Contacts::Perfect, settings());
    for (number, cell) in [("1", "+10"), ("2", "+20")] {
        write("sub.h", &format!("BEGIN PGM sub MM\nQ1 = {number}\nEND PGM sub MM\n"));
        write("own.tab", &TABLE.replace("+10", cell));
        machine.restart(Contacts::Perfect);
        to_end(&mut machine);
        check_values(&machine, &[("Q1", number.parse().unwrap()), ("Q2", cell.parse().unwrap())]);
    }
}

#[test]
fn where_the_original_is_weak_the_control_s_error_is_ours() {
    let bore = "[bore]\ncentre = [40.0, 30.0]\ndiameter = 25.0\n";
    assert!(fault_of(&mut shipped("400.0001", "H7", bore)).starts_with("table 82553_hole.tab has no row 42"));
    assert!(
        fault_of(&mut shipped("25", "H10", bore))
            .starts_with("table 82553_hole.tab has no column H10; its columns are")
    );
}

/// Blocks that do something, and pieces that make them do something else.
const PIECES: [&str; 44] = [
    "LBL 1\n",
    "LBL 2\n",
    "LBL 0\n",
    "CALL LBL 1\n",
    "CALL LBL 2 REP 3\n",
    "CALL PGM sub.h\n",
    "CALL PGM main.h\n",
    "Q1 = Q1 + 1\n",
    "Q1 = Q2 * Q1 ^ 2 - SIN Q3\n",
    "Q2 = SQRT Q1 / Q2\n",
    "QL1 = 1\n",
    "Q3 = - Q1 % 7\n",
    "FN 0: Q2 SET UNDEFINED\n",
    "FN 9: IF +Q1 EQU +0 GOTO LBL 1\n",
    "FN 12: IF +Q1 LT +9 GOTO LBL 2\n",
    "FN 10: IF +Q2 IS DEFINED GOTO LBL 1\n",
    "FN 16: F-PRINT m.a / SCREEN:\n",
    "FN 16: F-PRINT m.a / SCLR:\n",
    "FN 16: F-PRINT m.a / out.txt\n",
    "FN 26: TABOPEN own.tab\n",
    "FN 26: TABOPEN 82553_hole.tab\n",
    "FN 27: TABWRITE 1/\"H7\" = Q1\n",
    "FN 28: TABREAD Q1 = +Q3/\"H7,BEREICH\"\n",
    "FN 28: TABREAD QS1 = 0/\"NOTE\"\n",
    "QS1 = QS1 || QS2 || QS1\n",
    "DECLARE STRING QS2 = \"ab\"\n",
    "QS1 = SUBSTR ( SRC_QS2 BEG1 LEN+Q1 )\n",
    "QS2 = TOCHAR ( DAT+Q1 DECIMALS3 )\n",
    "Q2 = INSTR ( SRC_QS1 SEA_QS2 BEG+Q3 )\n",
    "Q1 = TONUMB ( SRC_QS2 )\n",
    "QS1 = SYSSTR ( ID10321 NR+Q1 )\n",
    "TOOL CALL Q1 Z\n",
    "L X+Q1 IY-2 Z+0 R0 FMAX M91\n",
    "L IX+1e300 Y+Q1 FQ2 M0\n",
    "TCH PROBE 421 X ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+Q1\n",
    "TCH PROBE 427 X ~\nQ263=+0 ~\nQ264=+Q1 ~\nQ261=+5 ~\nQ272=+3 ~\nQ267=-1 ~\nQ281=+2\n",
    "TCH PROBE 444 X ~\nQ263=+0 ~\nQ264=+0 ~\nQ294=+0 ~\nQ581=+Q1 ~\nQ582=+0 ~\nQ583=+1 ~\nQS400=\"0.4-0.1\"\n",
    "STOP\n",
    "/M30\n",
    "M1\n",
    "END PGM main MM\n",
    "FN 14: ERROR= Q1\n",
    "CYCL DEF 7.0 DATUM SHIFT\n",
    "\u{0}\u{ff}(((((",
];

/// What a run may use in these trials.
const SMALL: Budget = Budget {
    blocks: 3_000,
    label_calls: 20,
    program_calls: 10,
    text: 255,
    windows: 20,
    outputs: 20,
    output_files: 3,
    folders: 3,
    table_writes: 5,
    output_bytes: 10_000,
    cycles: 20,
    path: 500,
    files: 5,
    file_bytes: 100_000,
    traffic: 5_000_000,
    remarks: 50,
};

/// Runs anything within a small budget, and compares every bound with the result.
fn run_anything(text: &[u8], sub: &[u8], skip_unknown: bool) {
    let Ok((program, _)) = Program::read(text) else { return };
    let store = InMemory::new()
        .with("sub.h", sub)
        .with("main.h", text)
        .with("own.tab", TABLE)
        .with("m.a", "\"%9.4F%S\", Q1, QS1;\n");
    let mut with = settings();
    with.budget = SMALL;
    with.skip_unknown = skip_unknown;
    let mut machine = Machine::new(r"TNC:\main.h", Arc::new(program), store, Contacts::Perfect, with);
    for number in 1..=3 {
        machine.set(Parameter::q(number), Value::Number(0.0)).unwrap();
        machine.set(Parameter::qs(number), Value::Text("x".to_owned())).unwrap();
    }
    let ended = loop {
        match machine.run(1_000) {
            Ok(Step::Ended) => break Ok(()),
            Ok(_) => {}
            Err(fault) => break Err(fault),
        }
    };
    if let Err(fault) = ended {
        assert!(!fault.to_string().is_empty());
    }
    assert!(machine.is_over() && machine.blocks_run() <= SMALL.blocks);
    assert!(machine.windows().len() <= SMALL.windows && machine.outputs().len() <= SMALL.outputs);
    assert!(machine.cycles().len() <= SMALL.cycles && machine.path().len() <= SMALL.path);
    assert!(machine.remarks().len() <= SMALL.remarks && machine.calls().len() <= 30);
    for (parameter, value) in machine.variables().iter() {
        match value {
            Value::Text(text) => assert!(text.chars().count() <= SMALL.text, "{parameter}"),
            Value::Number(number) => assert!(number.abs() <= 1e10, "{parameter} = {number}"),
            Value::Length(_) => {}
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn any_program_ends_within_its_budget(
        pieces in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..40),
        sub in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..10),
        skip_unknown: bool,
    ) {
        run_anything(text(&pieces.concat()).as_bytes(), text(&sub.concat()).as_bytes(), skip_unknown);
    }

    #[test]
    fn any_bytes_end_within_their_budget(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        run_anything(&bytes, &bytes, true);
        run_anything(&[b"BEGIN PGM a MM\n", bytes.as_slice()].concat(), &bytes, true);
    }
}
