//! What blocks that are not run leave behind: nothing of an earlier measurement, and no datum that is not known.

use std::sync::Arc;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::Contact;
use fitcheck::probing::simulated::Simulation;
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;

const HOLE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-5 ~\nQ320=+2 ~\nQ260=+15 ~\n\
                    Q301=+0 ~\nQ275=+25.021 ~\nQ276=+25";
const DATUM: &str = "TCH PROBE 416 DATUM CIRCLE CENTER ~\nQ321=+60 ~\nQ322=+0 ~\nQ262=+30 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-3 ~\nQ320=+2 ~\n\
                     Q260=+15 ~\nQ301=+0 ~\nQ305=+0 ~\nQ331=+0 ~\nQ332=+0 ~\nQ303=+1";

/// A run with unknown blocks skipped, and why it stopped early.
fn run_with(blocks: &str, block_skip: bool, contacts: Contacts) -> (Machine, Option<String>) {
    run_text(&format!("BEGIN PGM main MM\nTOOL CALL 1 Z\n{blocks}\nEND PGM main MM\n"), block_skip, contacts)
}

fn run_text(text: &str, block_skip: bool, contacts: Contacts) -> (Machine, Option<String>) {
    let mut settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    (settings.skip_unknown, settings.block_skip) = (true, block_skip);
    let program = Arc::new(Program::read(text.as_bytes()).unwrap().0);
    let store = InMemory::new()
        .with("m.a", "\"%9.4F\", Q153;\n")
        .with("sub.h", "BEGIN PGM sub MM\nQL1 = FOO BAR\nEND PGM sub MM\n")
        .with("own.h", "BEGIN PGM own MM\nQL1 = 7\nEND PGM own MM\n")
        .with("own.tab", "BEGIN OWN.TAB MM\nNR  A     B\n0   1     2\n[END]\n")
        .with("other.tab", "BEGIN OTHER.TAB MM\nNR  A     B\n0   1     2\n[END]\n");
    let mut machine = Machine::new("main.h", program, store, contacts, settings);
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => return (machine, None),
            Ok(_) => {}
            Err(fault) => return (machine, Some(fault.kind.to_string())),
        }
    }
}

fn run(blocks: &str) -> (Machine, Option<String>) {
    run_with(blocks, false, Contacts::Perfect)
}

#[track_caller]
fn ends(blocks: &str) -> Machine {
    let (machine, fault) = run(blocks);
    assert_eq!(fault, None, "{blocks}");
    machine
}

#[track_caller]
fn stops(blocks: &str, why: &str) {
    let (_, fault) = run(blocks);
    assert_eq!(fault.as_deref(), Some(why), "{blocks}");
}

fn said(machine: &Machine) -> Vec<String> {
    machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect()
}

#[test]
fn cycles_that_only_mill_lose_no_datum() {
    for cycle in ["1271 OCM RECTANGLE", "1272 OCM CIRCLE", "1281 OCM RECTANGLE BOUNDARY", "233 FACE MILLING"] {
        ends(&format!("CYCL DEF {cycle}\n{HOLE}"));
    }
}

#[test]
fn whatever_a_block_names_that_is_not_understood_is_lost() {
    let jump = "FN 9: IF +Q881 EQU +7 GOTO LBL 1\nLBL 1";
    for block in ["SQL BIND Q881 \"TAB.POS\"", "SQL FETCH Q881 HANDLE Q5 INDEX+0", "FOO BAR Q881"] {
        stops(
            &format!("Q881 = 7\n{block}\n{jump}"),
            &format!("Q881 is undefined: line 4, {block}, may set it and was not run"),
        );
    }
}

#[test]
fn local_parameters_are_those_of_the_caller_again() {
    let ask = "FN 9: IF +QL1 EQU +5 GOTO LBL 1\nLBL 1";
    ends(&format!("QL1 = 5\nCALL PGM sub.h\n{ask}"));
    stops(
        &format!("QL1 = FOO BAR\nCALL PGM own.h\n{ask}"),
        "QL1 is undefined: line 3, QL1 = FOO BAR, may set it and was not run",
    );
}

const LOST: &str = "is undefined: line 15, TCH PROBE 416 DATUM CIRCLE CENTER ~, may set it and was not run";

#[test]
fn a_skipped_measurement_leaves_nothing_of_the_one_before_it() {
    let skipped = format!("{HOLE}\n{DATUM}");
    let machine = ends(&skipped);
    for number in (115..=119).chain(150..=166).chain(180..=183).chain([198, 950]) {
        assert_eq!(machine.variables().get(Parameter::q(number)), None, "Q{number}");
    }
    assert!(said(&machine).iter().any(|said| said.contains("this measurement was skipped")), "{:?}", said(&machine));
    for (reads, parameter) in [
        ("Q1 = Q153", "Q153"),
        ("FN 0: Q1 = +Q161", "Q161"),
        ("FN 9: IF +Q180 EQU +1 GOTO LBL 20\nLBL 20", "Q180"),
        ("FN 9: IF Q182 IS UNDEFINED GOTO LBL 20\nLBL 20", "Q182"),
        ("QS2 = TOCHAR ( DAT+Q153 DECIMALS4 )", "Q153"),
        ("FN 16: F-PRINT m.a / SCREEN:", "Q153"),
        ("FN 26: TABOPEN own.tab\nFN 27: TABWRITE 0/\"A\" = Q153", "Q153"),
        ("L X+Q115 R0 FMAX", "Q115"),
    ] {
        stops(&format!("{skipped}\n{reads}"), &format!("{parameter} {LOST}"));
    }
    // Another measurement, or an assignment, sets them again.
    ends(&format!("{skipped}\nQ153 = 3\nQ1 = Q153"));
    // What the block itself says can be read.
    assert_eq!(
        ends(&format!("{skipped}\nQ1 = Q262")).variables().get(Parameter::q(1)).map(|v| format!("{v:?}")),
        Some("Number(30.0)".into())
    );
}

#[test]
fn a_measurement_that_is_skipped_by_its_stroke_leaves_nothing_either() {
    let blocks = format!("{HOLE}\n/{HOLE}\nQ1 = Q153");
    let (machine, fault) = run_with(&blocks, true, Contacts::Perfect);
    assert_eq!(
        fault.as_deref(),
        Some("Q153 is undefined: line 15, /TCH PROBE 421 MEASURE HOLE ~, may set it and was not run")
    );
    assert_eq!(machine.cycles().len(), 1);
    assert_eq!(run_with(&blocks, false, Contacts::Perfect).1, None);
}

#[test]
fn nothing_is_measured_behind_a_skipped_block_that_may_have_set_a_datum() {
    let bore = Simulation::read("[bore]\ncentre = [0.4, -0.3]\ndiameter = 25.01\n").unwrap();
    let (machine, fault) = run_with(&format!("{DATUM}\n{HOLE}"), false, Contacts::Workpiece(bore.into()));
    assert_eq!(
        fault.as_deref(),
        Some(
            "an unknown datum has been active since line 3, TCH PROBE 416 DATUM CIRCLE CENTER ~: Fitcheck does not measure while it is active"
        )
    );
    assert!(machine.cycles().is_empty() && machine.status().is_none());
    for block in [
        "TCH PROBE 401 ROT OF 2 HOLES",
        "TCH PROBE 1420 PROBING IN PLANE",
        "TCH PROBE 550 OF THE BUILDER",
        "CYCL DEF 550 OF THE BUILDER ~\nQ1=+1",
        "CYCL DEF 392 OF THE BUILDER ~\nQ1=+1",
        "CYCL DEF 412 DATUM INSIDE CIRCLE ~\nQ1=+1",
        "CYCL DEF 1275 OF THE BUILDER ~\nQ1=+1",
        "CYCL DEF 800 ADJUST XZ SYSTEM ~\nQ497=+90",
        "CYCL DEF 68.0 OF THE BUILDER",
        "CYCL DEF 247 DATUM SETTING ~\nQ339=+1 ~\nQ340=+1",
        "PRESET SELECT #3 KEEP TRANS WP",
        "PRESET CORR X+10",
        "TRANS SHEAR X+10",
        "FN 17: SYSWRITE ID503 NR1 IDX1 = +Q5",
        "FN 17: SYSWRITE ID Q5 NR1 IDX1 = +Q5",
        "POLARKIN AXES X Z MODE:KEEP POLE:ALLOWED",
        "FUNCTION PARAXMODE X Y W",
        "FUNCTION MODE SET \"KINEMATICS\"",
        "CAMERA ON",
        "L X+0 R0 FMAX foo",
        "M104",
        "L Z+50 R0 FMAX M142",
        "ERROR = 23 TOOL CALL \"MILL D6\"",
    ] {
        let (machine, fault) = run(&format!("{block}\n{HOLE}"));
        assert!(
            fault.as_ref().is_some_and(|fault| fault.contains("has been active since line 3, ")),
            "{block}: {fault:?}"
        );
        assert!(machine.cycles().is_empty());
        // Another preset does not help: the block may have written it.
        let preset = "CYCL DEF 247 DATUM SETTING ~\nQ339=+1";
        assert!(run(&format!("{block}\n{preset}\n{HOLE}")).1.is_some(), "{block}");
    }
}

#[test]
fn what_sets_no_datum_lets_the_next_measurement_count() {
    for block in [
        "TCH PROBE 480 CALIBRATE TT",
        "TCH PROBE 483 MEASURE TOOL",
        "TCH PROBE 441 FAST PROBING",
        "TCH PROBE 461 TS CALIBRATION OF TOOL LENGTH",
        "TCH PROBE 430 MEAS. BOLT HOLE CIRC",
        "TCH PROBE 0.0 REF. PLANE Q5 X-\nTCH PROBE 0.1 X+5 Y+0 Z-5",
        "CYCL DEF 200 DRILLING ~\nQ200=+2",
        "CYCL DEF 1271 OCM RECTANGLE ~\nQ650=+1",
        "CYCL DEF 1274 OCM CIRCULAR SLOT ~\nQ650=+1",
        "CYCL DEF 1278 OCM POLYGON ~\nQ650=+1",
        "CYCL DEF 1281 OCM RECTANGLE BOUNDARY ~\nQ651=+1",
        "CYCL DEF 1282 OCM CIRCLE BOUNDARY ~\nQ653=+1",
        "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.01",
        "CYCL DEF 800 ADJUST XZ SYSTEM ~\nQ497=+90\nCYCL DEF 801 RESET ROTARY COORDINATE SYSTEM",
        "FN 17: SYSWRITE ID50 NR1 IDX5 = +Q9",
        "POLARKIN OFF",
        "FUNCTION PARAXMODE OFF",
        "FUNCTION FILECOPY \"a\", \"b\"",
        "Q5 = CFGREAD ( X )",
        "FN 16: F-PRINT m.a",
    ] {
        let (machine, fault) = run(&format!("Q9 = 1\n{block}\n{HOLE}"));
        assert_eq!((fault, machine.status()), (None, Some(Status::Good)), "{block}");
    }
}

#[test]
fn recorded_contacts_behind_a_skipped_measurement_are_of_nobody_knows_which() {
    let contacts = || {
        let places = [[12.505, 0.0, -5.0], [0.0, 12.505, -5.0], [-12.505, 0.0, -5.0], [0.0, -12.505, -5.0]];
        Contacts::Recorded(places.map(Contact::at).to_vec())
    };
    let (machine, fault) = run_with(HOLE, false, contacts());
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    let (machine, fault) = run_with(&format!("TCH PROBE 430 MEAS. BOLT HOLE CIRC\n{HOLE}"), false, contacts());
    assert_eq!(
        fault.as_deref(),
        Some(
            "it is not known which recorded contacts belong to this cycle: some may belong to line 3, TCH PROBE 430 MEAS. BOLT HOLE CIRC, \
             which was not run"
        )
    );
    assert!(machine.cycles().is_empty());
    // Measuring a tool touches no workpiece.
    let (machine, fault) = run_with(&format!("TCH PROBE 483 MEASURE TOOL\n{HOLE}"), false, contacts());
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
}

#[test]
fn what_a_skipped_block_would_have_set_is_undefined() {
    let before = "Q5 = 1\nQ6 = 2\nQL7 = 3\nQS5 = \"H7\"\n";
    for (block, reads, parameter) in [
        ("Q5 = CFGREAD ( X )", "Q1 = Q5", "Q5"),
        ("FN 1: Q5 = 5", "Q1 = Q5", "Q5"),
        ("QS5 = CFGREAD ( X )", "QS1 = QS5", "QS5"),
        ("QS5 = CFGREAD ( X )", "Q1 = STRLEN ( SRC_QS5 )", "QS5"),
        ("QL7 = ( 5 + 3", "Q1 = QL7", "QL7"),
        ("FN 28: TABREAD Q5 = 5", "Q1 = Q5", "Q5"),
        ("FN 28: TABREAD Q5 = X/\"A,B\"", "Q1 = Q6", "Q6"),
        ("FN 18: SYSREAD Q5 = ID990 NR8", "FN 9: IF Q5 IS UNDEFINED GOTO LBL 1\nLBL 1", "Q5"),
        ("TCH PROBE 0.0 REF. PLANE Q5 X-", "Q1 = Q5", "Q5"),
        ("TCH PROBE 3.1 Q5", "Q1 = Q6", "Q6"),
        ("CYCL DEF 200 DRILLING ~\nQ5=( 2", "Q1 = Q5", "Q5"),
        ("FOO BAR Q5", "Q1 = Q5", "Q5"),
        ("FOO BAR Q6 Q5 = 7", "Q1 = Q6", "Q6"),
        ("FOO BAR ~\nQS5", "QS1 = QS5", "QS5"),
        ("SQL BIND Q5 \"TAB.COLUMN\"", "Q1 = Q5", "Q5"),
        ("SQL FETCH Q6 HANDLE Q5", "Q1 = Q6", "Q6"),
        ("SQL FETCH Q6 HANDLE Q5", "Q1 = Q5", "Q5"),
    ] {
        let (_, fault) = run(&format!("{before}{block}\n{reads}"));
        let expected = format!("{parameter} is undefined: line 7, ");
        assert!(fault.as_ref().is_some_and(|fault| fault.starts_with(&expected)), "{block}: {fault:?}");
    }
    // What stands behind a sign is only read.
    ends(&format!("{before}FOO X+Q5 Y=Q6\nQ1 = Q5 + Q6"));
    // Each row that is fetched fills what was bound.
    let (_, fault) = run("SQL BIND Q5 \"TAB.COLUMN\"\nQ5 = 1\nQ1 = Q5\nSQL FETCH Q6 HANDLE Q7\nQ1 = Q5");
    assert!(fault.as_ref().is_some_and(|fault| fault.starts_with("Q5 is undefined: line 6, SQL FETCH")), "{fault:?}");
    // The table that is open is another one after a block that is not understood.
    stops("FN 26: TABOPEN own.tab\nFN 26: TABOPEN \"own\nFN 28: TABREAD Q1 = 0/\"A\"", "no table is open");
}

#[test]
fn a_file_that_a_skipped_block_may_have_written_is_not_read() {
    let (_, fault) = run("FUNCTION FILECOPY \"other.tab\", \"OWN.TAB\"\nFN 26: TABOPEN own.tab");
    assert!(fault.as_ref().is_some_and(|fault| fault.contains("line 3, FUNCTION FILECOPY")), "{fault:?}");
    ends("FUNCTION FILECOPY \"TCHPR421.TXT\", \"B1.TXT\"\nFN 26: TABOPEN own.tab");
    // Its name may stand in any line of the block, and the table may be open.
    let copy = "FUNCTION FILECOPY \"a.tab\", ~\n\"own.tab\"";
    for (blocks, line) in [
        (format!("{copy}\nFN 26: TABOPEN own.tab"), 3),
        (format!("FN 26: TABOPEN own.tab\n{copy}\nFN 28: TABREAD Q1 = 0/\"A\""), 4),
        ("FUNCTION FILEDELETE \"*.tab\", all\nFN 26: TABOPEN own.tab".to_owned(), 3),
    ] {
        let (_, fault) = run(&blocks);
        assert!(
            fault.as_ref().is_some_and(|fault| fault.contains(&format!("line {line}, FUNCTION FILE"))),
            "{blocks}: {fault:?}"
        );
    }
    ends(&format!("{copy}\nFN 26: TABOPEN other.tab\nFN 28: TABREAD Q1 = 0/\"A\""));
}

#[test]
fn a_table_that_a_skipped_block_may_have_written_is_not_read() {
    let (open, write, read) = ("FN 26: TABOPEN own.tab", "FN 27: TABWRITE 0/\"A = Q1", "FN 28: TABREAD Q1 = 0/\"A\"");
    let other = "FN 26: TABOPEN other.tab";
    for (blocks, by) in [
        (format!("{open}\n{write}\n{read}"), "line 4, FN 27"),
        (format!("{open}\n{write}\n{other}\n{read}\n{open}"), "line 4, FN 27"),
        // Which table is open is not known.
        (format!("FN 26: TABOPEN \"own\n{write}\n{other}"), "line 4, FN 27"),
        (format!("SQL UPDATE \"OWN\"\n{open}"), "line 3, SQL"),
    ] {
        let (_, fault) = run(&blocks);
        assert!(fault.as_ref().is_some_and(|fault| fault.contains(by)), "{blocks}: {fault:?}");
    }
    ends(&format!("{open}\n{write}\n{other}\n{read}"));
}

/// The exit code of `fitcheck run` with unknown blocks skipped.
#[track_caller]
fn exits(blocks: &str, code: i32) {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("BEGIN PGM own MM\nTOOL CALL 1 Z\n{blocks}\nEND PGM own MM\n");
    fitcheck::files::write(&folder.path().join("own.h"), text.as_bytes()).unwrap();
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder.path()).args(["run", "own.h", "--skip-unknown"]).assert().code(code);
}

#[test]
fn a_good_run_that_leaves_a_measurement_out_is_looked_at_first() {
    exits(HOLE, 0);
    for skipped in [
        "TCH PROBE 430 MEAS. BOLT HOLE CIRC",
        "TCH PROBE 1420 PROBING IN PLANE",
        "TCH PROBE 0.0 REF. PLANE Q5 X-\nTCH PROBE 0.1 X+5 Y+0 Z-5",
        "CYCL DEF 421 MEASURE HOLE ~\nQ1=+1",
        DATUM,
        "FOO",
    ] {
        exits(&format!("{HOLE}\n{skipped}"), 14);
    }
    // No measurement of the workpiece is left out by these, and another datum behind all of them changes none.
    exits(&format!("{HOLE}\nTCH PROBE 461 TS CALIBRATION OF TOOL LENGTH"), 0);
    exits(&format!("{HOLE}\nM104"), 0);
}

#[test]
fn calibrations_and_tool_measurements_are_passed_over_and_return_what_was_given() {
    let blocks = "Q150 = 1\nTCH PROBE 481 CALIBRATE TT LENGTH\nTCH PROBE 441 FAST PROBING ~\nQ396=+2000\nQ1 = Q115";
    let machine = |blocks: &str| {
        let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
        let text = format!("BEGIN PGM main MM\nTOOL CALL 1 Z\n{blocks}\nEND PGM main MM\n");
        let program = Arc::new(Program::read(text.as_bytes()).unwrap().0);
        Machine::new("main.h", program, InMemory::new(), Contacts::Perfect, settings)
    };
    let mut without = machine(blocks);
    let fault = without.run(u64::MAX).unwrap_err().kind.to_string();
    assert!(fault.starts_with("Q115 is undefined: line 4, TCH PROBE 481"), "{fault}");
    let mut given = machine(blocks);
    given.set(Parameter::q(115), Value::Number(-0.02)).unwrap();
    assert_eq!(given.run(u64::MAX), Ok(Step::Ended));
    assert_eq!(given.variables().get(Parameter::q(1)), Some(&Value::Number(-0.02)));
    let said: Vec<String> = given.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(said[0].starts_with("this cycle calibrates the probe or measures a tool"), "{said:?}");
    // What an earlier measurement has found is not that of a passed cycle either.
    let mut stale = machine(&format!("{HOLE}\nTCH PROBE 483 MEASURE TOOL\nQ1 = Q153"));
    assert!(stale.run(u64::MAX).unwrap_err().kind.to_string().starts_with("Q153 is undefined"));
}

#[test]
fn a_zone_out_of_all_proportion_is_looked_at_first() {
    exits(&HOLE.replace("Q275=+25.021", "Q275=+46"), 14);
    let limits = |most: &str, code: i32| {
        let set = ["Q273=0", "Q274=0", "Q262=25", "Q276=25", most];
        cargo_bin_cmd!("fitcheck").args(["cycle", "421", "--set"]).args(set).assert().code(code);
    };
    limits("Q275=25.021", 0);
    limits("Q275=46", 14);
}

#[test]
fn a_block_that_decides_what_runs_next_is_not_skipped() {
    for block in [
        "FN 9: IF +Q1 NE +0 GOTO LBL 1",
        "FN 12: IF +Q1 LT GOTO",
        "CALL LBL 5 REP",
        "CALL PGM ;x",
        "SEL PGM",
        "LBL LOOP",
        "FN 14: ERROR=",
        "FN 37: EXPORT QS10",
        "FUNCTION COUNT REPEAT LBL 5",
    ] {
        stops(block, "this block decides what runs next or what another program receives: it cannot be skipped");
    }
}

#[test]
fn the_perfect_face_lies_in_the_middle_of_the_limits() {
    let cycle = "TCH PROBE 427 MEASURE COORDINATE ~\nQ263=-55 ~\nQ264=+0 ~\nQ261=-4 ~\nQ320=+12 ~\nQ272=+1 ~\nQ267=+1 ~\nQ260=+5 ~\n\
                 Q281=+0 ~\nQ288=-39.98 ~\nQ289=-40.02 ~\nQ309=+0 ~\nQ330=+0";
    let machine = ends(cycle);
    assert_eq!(machine.status(), Some(Status::Good));
    assert_eq!(machine.cycles()[0].result.checks[0].measured.to_string(), "-40");
    let face = "[face]\npoint=[-40,0,0]\nnormal=[-1,0,0]\n[probe]\nball_radius=3\n";
    let (machine, fault) = run_with(cycle, false, Contacts::Workpiece(Simulation::read(face).unwrap().into()));
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
}

#[test]
fn a_limit_that_is_given_twice_is_offered_as_the_other_one() {
    let cycle = "TCH PROBE 425 MEASURE INSIDE WIDTH ~\nQ328=+0 ~\nQ329=+30 ~\nQ310=+0 ~\nQ272=+1 ~\nQ261=-5 ~\nQ260=+15 ~\nQ311=+20 ~\n\
                 Q288=+20.05 ~\nQ288=+19.95 ~\nQ281=+1 ~\nQ309=+0 ~\nQ330=+0";
    stops(cycle, "cycle 425: Q288 is given twice, and Q289 not at all: is the second one meant as Q289?");
}

#[test]
fn what_an_iso_or_lathe_program_skips_counts_as_well() {
    let hole =
        "N30 G421 Q273=+0 Q274=+0 Q262=+25 Q325=+0 Q247=+90 Q261=-5 Q320=+2 Q260=+15 Q301=+0 Q275=+25.021 Q276=+25 *\n";
    for block in ["G416 Q321=+0 *", "G147 X5 *", "D17 P01 5 *", "G80 Q1 *"] {
        let text = format!("%A G71 *\nN10 T1 G17 *\nN20 {block}\n{hole}N99999999 %A G71 *\n");
        let (machine, fault) = run_text(&text, false, Contacts::Perfect);
        assert!(fault.as_ref().is_some_and(|fault| fault.contains("since line 3")), "{block}: {fault:?}");
        assert!(machine.cycles().is_empty());
    }
    let circle = "N3 G785 R0 BR0 K5 C0 RC60 I0 J0\n";
    for block in ["N2 G59 Z20\n", "N2 G53 X5\n"] {
        let text = format!("%A.nc\nPROGRAMMKOPF\n#EINHEIT METRISCH\nBEARBEITUNG\n{block}{circle}ENDE\n");
        let (machine, fault) = run_text(&text, false, Contacts::Perfect);
        assert!(fault.as_ref().is_some_and(|fault| fault.contains("since line 5")), "{block}: {fault:?}");
        assert!(machine.cycles().is_empty());
    }
    let text = format!(
        "%A.nc\nPROGRAMMKOPF\n#EINHEIT METRISCH\nBEARBEITUNG\n{circle}N4 G909\nN5 G999 A5\nN6 #l1=#i99\nENDE\n"
    );
    let fault = run_text(&text, false, Contacts::Perfect).1;
    assert!(fault.as_ref().is_some_and(|fault| fault.contains("#i99 is undefined: line 7")), "{fault:?}");
    // Nor is a unit passed over that shifts the zero point.
    let text = format!(
        "%A.nc\nPROGRAMMKOPF\n#EINHEIT METRISCH\nBEARBEITUNG\nN4 UNIT ID\"G\"\nN5 G59 Z20\nN6 END_OF_UNIT\n{circle}ENDE\n"
    );
    let fault = run_text(&text, false, Contacts::Perfect).1;
    assert!(fault.as_ref().is_some_and(|fault| fault.contains("since line 6")), "{fault:?}");
}
