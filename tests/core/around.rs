//! Whole programs around a measurement: what is set up before a cycle acts in it, and what is passed over is counted.
//! The programs in `tests/data/samples/around` and what they are to leave behind are described in docs/SOURCES.md.

use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, FaultKind, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::Contact;
use fitcheck::probing::simulated::Simulation;
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;
use proptest::prelude::*;

fn sample(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/data/samples/around/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn settings() -> Settings {
    Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0))
}

fn machine_with(text: &[u8], contacts: Contacts, with: Settings) -> Machine {
    let store = InMemory::new().with("mm_note.h", sample("mm_note.h"));
    Machine::new(r"TNC:\main.h", Arc::new(Program::read(text).unwrap().0), store, contacts, with)
}

fn machine(text: &[u8], contacts: Contacts) -> Machine {
    machine_with(text, contacts, settings())
}

/// Runs to the end or to a fault; pauses are skipped.
fn over(mut machine: Machine) -> (Machine, Option<String>) {
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => return (machine, None),
            Ok(_) => {}
            Err(fault) => return (machine, Some(fault.to_string())),
        }
    }
}

fn number(machine: &Machine, q: u16) -> Option<f64> {
    match machine.variables().get(Parameter::q(q)) {
        Some(Value::Number(number)) => Some(*number),
        Some(Value::Length(length)) => Some(length.to_mm_f64()),
        Some(Value::Text(_)) | None => None,
    }
}

#[track_caller]
fn check(machine: &Machine, values: &[(u16, f64)]) {
    for &(q, wanted) in values {
        let found = number(machine, q).unwrap_or_else(|| panic!("Q{q} is undefined"));
        assert!((found - wanted).abs() < 1e-9, "Q{q} = {found}, wanted {wanted}");
    }
}

/// Four contacts of a circle, mm, from an angle.
fn circle([x, y]: [f64; 2], diameter: f64, from: f64, z: f64) -> Vec<Contact> {
    let at = |step: u32| (from + 90.0 * f64::from(step)).to_radians();
    let place = |angle: f64| [x + diameter / 2.0 * angle.cos(), y + diameter / 2.0 * angle.sin(), z];
    (0..4).map(|step| Contact::at(place(at(step)))).collect()
}

fn pocket(diameters: &[f64], x: f64) -> Contacts {
    Contacts::Recorded(diameters.iter().flat_map(|diameter| circle([x, -5.0], *diameter, 0.0, -8.0)).collect())
}

#[test]
fn a_bore_is_milled_measured_and_reworked_by_a_jump() {
    let program = sample("pocket_fit_rework.h");
    let fault = r"TNC:\main.h, block 29, FN 14: ERROR= 1072: the program stopped itself with error 1072";
    for (diameters, x, runs, q10, q12, q153, q163, status, ends) in [
        (vec![24.975, 25.010], 10.0, 2, 25.015, 1.0, 25.01, 0.0, Status::Good, None),
        (vec![25.0], 10.0, 1, 24.98, 0.0, 25.0, -0.01, Status::Good, None),
        (vec![25.03], 10.0, 1, 24.98, 0.0, 25.03, 0.02, Status::Scrap, Some(fault)),
        (vec![24.975; 3], 10.0, 3, 25.05, 2.0, 24.975, -0.035, Status::Rework, Some(fault)),
        (vec![25.01], 10.03, 1, 24.98, 0.0, 25.01, 0.0, Status::Scrap, Some(fault)),
    ] {
        let (machine, fault) = over(machine(&program, pocket(&diameters, x)));
        assert_eq!(fault.as_deref(), ends, "{diameters:?}");
        assert_eq!((machine.cycles().len(), machine.cycles().last().unwrap().result.verdict()), (runs, Some(status)));
        // What was reworked and measured again counts as it is now.
        assert_eq!(machine.status(), Some(status), "{diameters:?}");
        let again = machine.remarks().iter().any(|(_, remark)| remark.to_string().starts_with("measured again"));
        assert_eq!(again, 1 < runs);
        check(&machine, &[(10, q10), (12, q12), (153, q153), (163, q163)]);
        let markers = [Status::Good, Status::Rework, Status::Scrap].map(|one| f64::from(u8::from(one == status)));
        check(&machine, &[(180, markers[0]), (181, markers[1]), (182, markers[2])]);
        // PREDEF stands for the values of GLOBAL DEF 120, and what was stated can be read afterwards.
        check(&machine, &[(320, 1.0), (260, 50.0), (301, 0.0), (262, 25.01), (335, number(&machine, 10).unwrap())]);
        assert_eq!(machine.outputs().len(), runs, "a log for each");
        let spindle = machine.remarks().iter().any(|(_, remark)| remark.to_string().contains("spindle"));
        assert!(!spindle, "M5 stands before each cycle");
        let milled = u32::try_from(runs).unwrap();
        assert_eq!(machine.passed_over()["CYCL DEF 208"], usize::try_from(milled).unwrap());
        assert_eq!(machine.passed_over()["BLK FORM"], 2);
    }
}

#[test]
fn scrap_stays_scrap_and_another_feature_is_not_the_same() {
    let worst = |first: f64, second: f64, between: &str| {
        let hole = HOLE.replace("Q273=+40", "Q273=+Q1");
        let blocks = format!("TOOL CALL 1 Z\nQ1 = 40\nLBL 1\n{hole}\n{between}\nCALL LBL 1 REP 1");
        let contacts = [circle([40.0, 30.0], first, 0.0, -8.0), circle([40.0, 30.0], second, 0.0, -8.0)].concat();
        ran(&blocks, Contacts::Recorded(contacts)).status()
    };
    let tool = "TOOL CALL 5 Z\nM3\nM5\nTOOL CALL 1 Z";
    assert_eq!(worst(24.99, 25.01, tool), Some(Status::Good));
    assert_eq!(worst(25.01, 24.99, tool), Some(Status::Rework));
    assert_eq!(worst(25.03, 25.01, tool), Some(Status::Scrap));
    for nothing in ["", "TOOL CALL 1 Z", "TOOL CALL 5 Z\nTOOL CALL 1 Z"] {
        assert_eq!(worst(24.99, 25.01, nothing), Some(Status::Rework), "nothing was machined between: {nothing}");
    }
    for other in [
        "STOP",
        "M0",
        "M66",
        "Q1 = 40.001",
        "CYCL DEF 7.1 X+1",
        "CYCL DEF 7.1 C+90",
        "CYCL DEF 247 X ~\nQ339=+2",
        "PRESET SELECT #2",
        "L C+90",
        "L X+0 M8 C+90",
        "L U+100",
        "FN 29: PLC = +1",
        "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\nPLANE RESET STAY",
    ] {
        assert_eq!(worst(24.99, 25.01, &format!("{tool}\n{other}")), Some(Status::Rework), "{other}");
    }
}

#[test]
fn in_iso_a_word_to_the_machine_between_keeps_rework_too() {
    let worst = |between: &str| {
        let hole = "N30 G421 Q273=+40 Q274=+30 Q262=+25 Q261=-8 Q320=+1 Q260=+50 Q275=+25.021 Q276=+25 *";
        let text = format!(
            "%A G71 *\nN10 T1 G17 *\nN20 G98 L1 *\n{hole}\nN40 M3 *\nN50 M5 *\n{between}\nN70 L1,1 *\nN99999999 %A G71 *\n"
        );
        let contacts = [24.99, 25.01].map(|diameter| circle([40.0, 30.0], diameter, 0.0, -8.0)).concat();
        let (machine, fault) = over(machine(text.as_bytes(), Contacts::Recorded(contacts)));
        assert_eq!(fault, None);
        machine.status()
    };
    assert_eq!(worst("N60 ;nothing *"), Some(Status::Good));
    assert_eq!(worst("N60 D19 P01 +1 *"), Some(Status::Rework));
    assert_eq!(worst("N60 D29 P01 +1 *"), Some(Status::Rework));
}

fn example(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/docs/examples/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// An example of the manual on the contacts beside it.
fn example_run(program: &str, contacts: &str) -> Machine {
    let rows = String::from_utf8(example(contacts)).unwrap();
    let contact = |row: &str| {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [x, y, z] = cells[..] else { panic!("{row}") };
        Contact::at([x, y, z])
    };
    let contacts = rows.lines().skip(1).map(contact).collect();
    let (machine, fault) = over(machine(&example(program), Contacts::Recorded(contacts)));
    assert_eq!(fault, None);
    // From first to last block: nothing was skipped as unknown.
    assert!(remarks(&machine).iter().all(|remark| !remark.contains("unknown")));
    machine
}

#[test]
fn the_plate_is_good_after_one_rework() {
    let machine = example_run("plate_fit.h", "plate_fit.csv");
    assert_eq!((machine.status(), machine.cycles().len()), (Some(Status::Good), 2));
    check(&machine, &[(1, 25.015), (2, 1.0), (153, 25.0102)]);
    assert_eq!((machine.passed_over()["CYCL DEF 208"], machine.passed_over()["CYCL CALL"]), (2, 3));
}

#[test]
fn the_flange_is_good_after_one_rework() {
    let machine = example_run("flange_fit.nc", "flange_fit.csv");
    let shown: Vec<&str> = machine.windows().iter().map(|window| window.text.trim()).collect();
    // The contacts have nine decimals, and the diameter is a whole number of nanometres.
    assert_eq!((shown, machine.cycles().len()), (vec!["rework 39.99", "measured 40.0124"], 2));
    // A program of a lathe control judges by itself: its cycle has no limits.
    assert_eq!(machine.status(), None);
}

#[test]
fn an_inch_program_measures_in_inches_and_hands_its_values_on_as_they_are() {
    let fed = |diameter: f64| {
        let contacts = circle([50.8, 38.1], diameter * 25.4, 45.0, -6.35);
        over(machine(&sample("inch_main.h"), Contacts::Recorded(contacts)))
    };
    let (good, fault) = fed(0.9996);
    assert_eq!((fault, good.status()), (None, Some(Status::Good)));
    check(&good, &[(153, 0.9996), (163, -0.0004), (161, 0.0), (162, 0.0), (50, 25.38984), (60, 1.0), (61, 0.9996)]);
    check(&good, &[(262, 1.0), (273, 2.0), (278, 0.9992)]);
    let [log] = good.outputs() else { panic!("{:?}", good.outputs()) };
    assert!(log.text.contains("1.0000") && !log.text.contains("25.4"), "{}", log.text);
    assert_eq!(fed(1.0001).0.status(), Some(Status::Rework));
    assert_eq!(fed(0.9990).0.status(), Some(Status::Scrap));
    // A limit belongs to the zone, in inches too; a nanometre beyond it does not.
    assert_eq!(fed(0.9992).0.status(), Some(Status::Good));
    assert_eq!(fed(0.9992 - 2e-6 / 25.4).0.status(), Some(Status::Scrap));
}

#[test]
fn a_cam_program_runs_over_its_oddities() {
    for (block_skip, last) in [(false, "/25 M30"), (true, "42 END PGM cam_traps MM")] {
        let text = sample("cam_traps.h");
        let with = |skip_unknown| Settings { block_skip, skip_unknown, ..settings() };
        let (_, fault) = over(machine_with(&text, Contacts::Perfect, with(false)));
        let inner = "ERROR = 23 TOOL CALL \"MILL D6\" Z S50: unknown block";
        assert!(fault.as_ref().is_some_and(|fault| fault.contains(inner)), "{fault:?}");
        let mut machine = machine_with(&text, Contacts::Perfect, with(true));
        let mut at = String::new();
        while !machine.is_over() {
            at = machine.current().text_of(machine.place().block).next().unwrap().to_owned();
            machine.step().unwrap();
        }
        assert_eq!((at.as_str(), machine.calls().len(), machine.cycles().len()), (last, 0, 0));
        check(&machine, &[(2, 900.0), (7, 3.0), (8, 4.0), (1900, 2.0), (1901, 3.0)]);
        // Only the block that the control itself could not read was skipped as unknown.
        let skipped = machine.remarks().iter().filter(|(_, remark)| remark.to_string() == "unknown block skipped");
        assert_eq!(skipped.count(), 1);
    }
}

const HOLE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+40 ~\nQ274=+30 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-8 ~\nQ320=+1 ~\n\
                    Q260=+50 ~\nQ301=+0 ~\nQ275=+25.021 ~\nQ276=+25 ~\nQ279=+0.02 ~\nQ280=+0.02 ~\nQ281=+0 ~\nQ309=+0 ~\nQ330=+0";

fn text(blocks: &str) -> String {
    format!("BEGIN PGM main MM\n{blocks}\nEND PGM main MM\n")
}

fn bore(toml: &str) -> Contacts {
    Contacts::Workpiece(Simulation::read(&format!("[bore]\ndiameter = 25.01\n{toml}")).unwrap().into())
}

fn ran(blocks: &str, contacts: Contacts) -> Machine {
    let (machine, fault) = over(machine(text(blocks).as_bytes(), contacts));
    assert_eq!(fault, None);
    machine
}

#[track_caller]
fn fault(blocks: &str) -> String {
    let mut machine = machine(text(blocks).as_bytes(), Contacts::Perfect);
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => panic!("it ran to its end"),
            Ok(_) => {}
            Err(fault) => return fault.kind.to_string(),
        }
    }
}

fn remarks(machine: &Machine) -> Vec<String> {
    machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect()
}

#[test]
fn a_cycle_needs_a_tool_call_with_an_axis_unless_the_user_lets_it_go() {
    assert_eq!(fault(HOLE), "no TOOL CALL with a tool axis comes before this measuring cycle");
    assert_eq!(fault(&format!("TOOL CALL 1 S50\n{HOLE}")), fault(HOLE));
    ran(&format!("TOOL CALL 1 Z\n{HOLE}"), Contacts::Perfect);
    let with = Settings { assumes_tool: true, ..settings() };
    let (machine, fault) = over(machine_with(text(HOLE).as_bytes(), Contacts::Perfect, with));
    assert_eq!(fault, None);
    assert_eq!(remarks(&machine), ["no TOOL CALL comes before this cycle: measured along Z with the first probe"]);
}

#[test]
fn predef_needs_a_global_definition_that_was_run() {
    let hole = HOLE.replace("Q320=+1", "Q320= PREDEF");
    let none = "cycle 421: Q320 SET-UP CLEARANCE = PREDEF: no GLOBAL DEF gives a value";
    assert_eq!(fault(&format!("TOOL CALL 1 Z\n{hole}\nGLOBAL DEF 120 PROBING ~\nQ320=+3")), none);
    assert_eq!(fault(&format!("GLOBAL DEF 120 PROBING ~\nQ260=+3\nTOOL CALL 1 Z\n{hole}")), none);
    let machine = ran(
        &format!(
            "Q1 = 4\nGLOBAL DEF 120 PROBING ~\nQ320=+2\nGLOBAL DEF 120 PROBING ~\nQ320=+Q1\nQ1 = 9\nTOOL CALL 1 Z\n{hole}"
        ),
        Contacts::Perfect,
    );
    check(&machine, &[(320, 4.0)]);
    // Which of two values a control takes is not documented.
    for again in ["Q320=+3", "Q320=+2"] {
        let twice = format!("GLOBAL DEF 120 PROBING ~\nQ320=+2 ~\n{again}\nTOOL CALL 1 Z\n{hole}");
        assert_eq!(fault(&twice), "GLOBAL DEF 120: Q320 is given twice");
    }
    // A value of an inch program is handed on as a length, not as a number.
    let text = "BEGIN PGM a INCH\nGLOBAL DEF 120 PROBING ~\nQ320=+0.1\nTOOL CALL 1 Z\nCALL PGM b.h\nEND PGM a INCH\n";
    let store = InMemory::new().with("b.h", format!("BEGIN PGM b MM\n{hole}\nEND PGM b MM\n"));
    let program = Arc::new(Program::read(text.as_bytes()).unwrap().0);
    let mut machine = Machine::new("a.h", program, store, Contacts::Perfect, settings());
    assert_eq!(machine.run(u64::MAX), Ok(Step::Ended));
    let clearance = machine.cycles()[0].result.inputs.value(320_u16).map(ToString::to_string);
    assert_eq!(clearance.as_deref(), Some("2.54"));
}

#[test]
fn nothing_is_measured_outside_milling_mode() {
    for mode in ["TURN", "GRIND"] {
        let told =
            format!("the control is in {mode} mode: measuring cycles run in milling mode only (FUNCTION MODE MILL)");
        assert_eq!(fault(&format!("TOOL CALL 1 Z\nFUNCTION MODE {mode}\n{HOLE}")), told);
    }
    ran(&format!("TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION MODE MILL \"A\"\n{HOLE}"), Contacts::Perfect);
}

#[test]
fn nothing_is_measured_under_a_rotation_and_its_like_until_it_ends() {
    for (on, off, told) in [
        ("CYCL DEF 10.1 ROT+30", "CYCL DEF 10.1 ROT+0", "a rotation"),
        ("CYCL DEF 10.1 ROT+30", "TRANS ROTATION RESET", "a rotation"),
        ("CYCL DEF 8.1 X", "CYCL DEF 8.1", "mirroring"),
        ("CYCL DEF 11.1 SCL 0.99", "CYCL DEF 11.1 SCL1", "scaling"),
        ("CYCL DEF 26.1 X1 Y1.1", "CYCL DEF 26.1 X1 Y1", "scaling of single axes"),
        ("CYCL DEF 7.1 #5", "CYCL DEF 7.1 X+0 Y+0 Z+0", "a shift from a datum table"),
        ("PLANE AXIAL B+30 STAY", "PLANE RESET STAY", "a tilted plane"),
        ("CYCL DEF 19.1 ABST50", "CYCL DEF 19.1 A+0 B+0 C+0", "a tilted plane"),
    ] {
        let told = format!("{told} has been active since line 3, {on}: Fitcheck does not measure while it is active");
        assert_eq!(fault(&format!("TOOL CALL 1 Z\n{on}\n{HOLE}")), told);
        ran(&format!("TOOL CALL 1 Z\n{on}\n{off}\n{HOLE}"), Contacts::Perfect);
    }
    // A row of a table stays in the axes that a shift does not name.
    let table = fault(&format!("TOOL CALL 1 Z\nCYCL DEF 7.1 #5\nCYCL DEF 7.1 X+0\n{HOLE}"));
    assert!(table.starts_with("a shift from a datum table"), "{table}");
    // A rotation on top of another one is not known to end at zero; a preset ends all but a tilt.
    assert!(
        fault(&format!("TOOL CALL 1 Z\nCYCL DEF 10.1 ROT+30\nCYCL DEF 10.1 IROT-30\n{HOLE}")).starts_with("a rotation")
    );
    ran(&format!("TOOL CALL 1 Z\nCYCL DEF 10.1 ROT+30\nCYCL DEF 247 X ~\nQ339=+1\n{HOLE}"), Contacts::Perfect);
}

/// What stands where a control's own programs have nothing is not dropped.
#[test]
fn no_value_of_a_change_is_lost() {
    for block in [
        "CYCL DEF 10.0 ROTATION ROT+30",
        "CYCL DEF 7.0 DATUM SHIFT X+50",
        "CYCL DEF 8.0 MIRROR IMAGE X",
        "CYCL DEF 11.0 SCALING SCL 0.9",
        "CYCL DEF 19.0 WORKING PLANE A+30",
        "CYCL DEF 26.1 X1 Y1 Z=0.9",
        "TRANS DATUM AXIS X+0 TO Y+5",
        "CYCL DEF 7.1 X+5 X+0",
        "CYCL DEF 247 DATUM SETTING ~\nQ339=+1 ~\nQ339=+2",
        "FUNCTION COUNT REPEAT LBL 1",
        "FN 37: EXPORT QL1",
    ] {
        let said = fault(&format!("TOOL CALL 1 Z\n{block}\n{HOLE}"));
        assert!(said.contains("not understood") || said.contains("unknown"), "{block}: {said}");
    }
    for (blocks, change) in [
        ("CYCL DEF 11.1 SCL 0.99\nCYCL DEF 26.1 X1 Y1", "scaling"),
        ("CYCL DEF 26.1 X0.99 Y0.99\nCYCL DEF 11.1 SCL 1", "scaling of single axes"),
        ("CYCL DEF 26.1 X0.99 Y1\nTRANS SCALE RESET", "scaling of single axes"),
        ("CYCL DEF 26.1 X1 CCX+0 Y0.99 CCY+0", "scaling of single axes"),
        ("CYCL DEF 19.1 A+0 ABST50 B+30", "a tilted plane"),
        ("CYCL DEF 19.2 B+30", "a tilted plane"),
    ] {
        let said = fault(&format!("TOOL CALL 1 Z\n{blocks}\n{HOLE}"));
        assert!(said.starts_with(&format!("{change} has been active")), "{blocks}: {said}");
    }
    // As controls write them.
    for blocks in [
        "CYCL DEF 7.0 NULLPUNKT\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0",
        "CYCL DEF 26.0 AXIS-SPEC. SCALING\nCYCL DEF 26.1 X1 Y1 CCX+0 CCY+0",
        "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+0 C+0 F1000 ABST50",
    ] {
        ran(&format!("TOOL CALL 1 Z\n{blocks}\n{HOLE}"), Contacts::Perfect);
    }
}

#[test]
fn nothing_behind_an_open_subprogram_or_a_missing_part_is_skipped() {
    let open = format!("TOOL CALL 1 Z\nCALL LBL 1\n{HOLE}\nM30\nLBL 1\nQ1 = 1");
    assert_eq!(fault(&open), "the program ends within the subprogram that is called in line 3: LBL 0 is missing");
    ran(&format!("{open}\nLBL 0"), Contacts::Perfect);
    let ahead = format!("TOOL CALL 1 Z\nCALL LBL 1 REP 1\n{HOLE}\nLBL 1\nQ5 = 1");
    let said = fault(&ahead);
    assert!(said.starts_with("REP repeats the part between a label and this block"), "{said}");
}

#[test]
fn predef_takes_no_value_of_another_definition_or_unit() {
    let hole = HOLE.replace("Q320=+1", "Q320= PREDEF");
    let none = "cycle 421: Q320 SET-UP CLEARANCE = PREDEF: no GLOBAL DEF gives a value";
    assert_eq!(fault(&format!("TOOL CALL 1 Z\nGLOBAL DEF 110 POCKET MILLING ~\nQ320=+2\n{hole}")), none);
    // 0.1 inch is no number of a program in millimetres.
    let inch = "BEGIN PGM g INCH\nGLOBAL DEF 120 PROBING ~\nQ320=+0.1\nEND PGM g INCH\n";
    let main = text(&format!("CALL PGM g.h\nTOOL CALL 1 Z\n{hole}\nQ1 = Q320"));
    let program = Arc::new(Program::read(main.as_bytes()).unwrap().0);
    let store = InMemory::new().with("g.h", inch);
    let mut machine = Machine::new("main.h", program, store, Contacts::Perfect, settings());
    let said = machine.run(u64::MAX).unwrap_err().kind.to_string();
    assert!(said.contains("Q320") && said.contains("undefined"), "{said}");
}

/// A counter of workpieces, and a message to another computer, may bring another workpiece.
#[test]
fn a_counted_workpiece_is_not_the_next_one_reworked() {
    let between = |block: &str| {
        let blocks = format!(
            "TOOL CALL 1 Z\nLBL 1\n{HOLE}\nTOOL CALL 5 Z S3000\nL Z+50 FMAX M3\nL Z+90 FMAX M5\nTOOL CALL 1 Z\n{block}\n\
             CALL LBL 1 REP 1"
        );
        let mut contacts = circle([40.0, 30.0], 24.98, 0.0, -8.0);
        contacts.extend(circle([40.0, 30.0], 25.01, 0.0, -8.0));
        let machine = ran(&blocks, Contacts::Recorded(contacts));
        machine.cycles().iter().filter(|run| run.is_reworked).count()
    };
    assert_eq!(between("Q5 = 1"), 1);
    assert_eq!(between("FUNCTION COUNT ADD"), 0);
    assert_eq!(between("FN 38: SEND /\"NEXT PART\" / +1"), 0);
}

#[test]
fn a_shift_moves_the_zero_that_the_workpiece_is_measured_from() {
    // The hole lies at X100 Y70 of the workpiece: 40, 30 from a zero that is shifted by 60, 40.
    let shift = "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+50\nCYCL DEF 7.2 Y+40\nCYCL DEF 7.1 IX+10";
    let machine =
        ran(&format!("TOOL CALL 1 Z\n{shift}\nL X+40 Y+30 Z+50 FMAX\n{HOLE}"), bore("centre = [100.005, 70.0]"));
    check(&machine, &[(151, 40.005), (152, 30.0), (153, 25.01), (161, 0.005), (180, 1.0)]);
    // The path is drawn on the workpiece, and Q115 counts from the preset.
    assert!(machine.path().iter().any(|travel| (travel.from[0] - 100.0).abs() < 1e-9));
    check(&machine, &[(117, -8.0)]);
    assert!(number(&machine, 115).is_some_and(|x| (80.0..120.0).contains(&x)));
    // Back at zero the ball is beside the hole.
    let blocks = format!("TOOL CALL 1 Z\n{shift}\nTRANS DATUM RESET\n{HOLE}");
    let (_, fault) = over(self::machine(text(&blocks).as_bytes(), bore("centre = [100.005, 70.0]")));
    assert!(fault.is_some_and(|fault| fault.contains("contact 1")));
    let other = ran(
        &format!("TOOL CALL 1 Z\nCYCL DEF 247 X ~\nQ339=+1\nCYCL DEF 247 X ~\nQ339=+2\n{HOLE}"),
        bore("centre = [40.0, 30.0]"),
    );
    assert_eq!(remarks(&other), ["preset 2: the workpiece is assumed to lie there, too"]);
}

#[test]
fn the_tool_axis_makes_the_plane() {
    // Along X the plane is Y and Z: the hole's centre is Y40 Z30.
    for (axis, plane, centre) in
        [("X", "YZ", "[40.005, 30.0]"), ("Y", "ZX", "[40.005, 30.0]"), ("Z", "XY", "[40.005, 30.0]")]
    {
        let toml = format!("centre = {centre}\nplane = \"{plane}\"");
        let machine = ran(&format!("TOOL CALL 1 {axis}\n{HOLE}"), bore(&toml));
        check(&machine, &[(151, 40.005), (152, 30.0), (153, 25.01)]);
        let along = match axis {
            "X" => 115,
            "Y" => 116,
            _ => 117,
        };
        check(&machine, &[(along, -8.0)]);
    }
}

#[test]
fn a_turning_spindle_and_turned_axes_are_told() {
    let told = |blocks: &str| remarks(&ran(&format!("TOOL CALL 1 Z\n{blocks}\n{HOLE}"), Contacts::Perfect));
    assert_eq!(told("L Z+50 FMAX M3"), ["the spindle turns since M3: a control would not probe"]);
    assert!(told("L Z+50 FMAX M3\nM5").is_empty());
    assert!(told("L Z+50 FMAX M13\nTOOL CALL 1 Z").is_empty());
    assert!(told("M4\nSTOP").is_empty());
    assert_eq!(
        told("L C+90 FMAX"),
        ["C moved before this cycle: the workpiece was measured as if it had not been turned"]
    );
    assert!(told("L C+90 FMAX\nL C+0 FMAX").is_empty());
}

#[test]
fn what_a_tool_call_adds_to_the_probe_is_told() {
    let told = |call: &str| remarks(&ran(&format!("{call}\n{HOLE}"), Contacts::Perfect));
    let said = |offsets: &str| [format!("{offsets} of the TOOL CALL does not change the simulated probe")];
    assert_eq!(told("TOOL CALL 1 Z S50 DL+0.1"), said("DL+0.1"));
    assert_eq!(told("TOOL CALL 1 Z S50 DL-0,1 DR+Q5"), said("DL-0,1 DR+Q5"));
    assert!(told("TOOL CALL 1 Z S50 DL+0 DR-0.0").is_empty());
    // Another tool is another length.
    assert!(told("TOOL CALL 1 Z DR2+0.1\nTOOL CALL 2 Z").is_empty());
    assert_eq!(told("TOOL CALL 1 Z DR2+0.1\nTOOL CALL S100"), said("DR2+0.1"));
    // In ISO it stands in the T block.
    let iso = text(HOLE).replace("BEGIN PGM main MM\n", "").replace("END PGM main MM\n", "").replace("TCH PROBE ", "G");
    let iso = format!("%A G71 *\nN1 T1 G17 DL+0.1 *\n{} *\nN9 %A G71 *\n", iso.trim());
    let (machine, fault) = over(machine(iso.as_bytes(), Contacts::Perfect));
    assert_eq!((fault, remarks(&machine)), (None, said("DL+0.1").to_vec()));
}

#[test]
fn the_tools_place_is_known_only_where_the_program_says_it() {
    let at = |blocks: &str| ran(&format!("TOOL CALL 1 Z\nL X+1 Y+2 Z+3 FMAX\n{blocks}"), Contacts::Perfect).position();
    let [x, y, z] = [Some(1.0), Some(2.0), Some(3.0)];
    for (blocks, place) in [
        ("CC X+9 Y+9", [x, y, z]),
        ("C X+5 Y+6 DR-", [Some(5.0), Some(6.0), z]),
        ("CP IPA-360 IZ-5 DR-", [None; 3]),
        ("DEP LT LEN10\nL Z+50", [None, None, Some(50.0)]),
        ("L M140 MB MAX", [x, y, None]),
        ("TOOL CALL 1 X\nL M140 MB MAX", [None, y, z]),
        ("L Z+0 FMAX M91", [x, y, None]),
        ("L X+5 FMAX M99", [None; 3]),
        ("CYCL CALL", [None; 3]),
        ("CYCL DEF 7.1 X+10\nL X+5", [Some(15.0), y, z]),
        ("CYCL DEF 10.1 ROT+10\nL X+5", [None, y, z]),
        ("L IX+5", [Some(6.0), y, z]),
    ] {
        assert_eq!(at(blocks), place, "{blocks}");
    }
}

#[test]
fn results_of_an_earlier_cycle_do_not_pass_as_measured() {
    let face = "TCH PROBE 427 X ~\nQ263=+35 ~\nQ264=+45 ~\nQ261=+5 ~\nQ320=+0 ~\nQ272=+3 ~\nQ267=-1 ~\nQ260=+20 ~\nQ281=+0 ~\n\
                Q288=+5.1 ~\nQ289=+4.9 ~\nQ309=+0 ~\nQ330=+0";
    let machine = ran(&format!("TOOL CALL 1 Z\n{HOLE}\n{face}"), Contacts::Perfect);
    assert_eq!((number(&machine, 153), number(&machine, 163)), (None, None));
    check(&machine, &[(160, 5.0), (198, 427.0)]);
}

#[test]
fn a_selected_program_and_a_repeat_by_parameter_run() {
    let store = InMemory::new().with("sub.h", "BEGIN PGM sub MM\nQ9 = Q9 + 1\nEND PGM sub MM\n");
    let blocks = "Q9 = 0\nQ7 = 2\nSEL PGM \"sub.h\"\nLBL 1\nCALL SELECTED PGM\nCALL LBL 1 REP Q7";
    let program = Arc::new(Program::read(text(blocks).as_bytes()).unwrap().0);
    let mut machine = Machine::new("main.h", program, store, Contacts::Perfect, settings());
    assert_eq!(machine.run(u64::MAX), Ok(Step::Ended));
    check(&machine, &[(9, 3.0)]);
    assert_eq!(fault("CALL SELECTED PGM"), "no SEL PGM comes before CALL SELECTED PGM");
    assert_eq!(fault("Q7 = 1.5\nLBL 1\nCALL LBL 1 REP Q7"), "REP = 1.5: expected a whole number from 0");
}

#[test]
fn system_data_are_undefined_and_said_unless_they_are_given() {
    let blocks = "Q1 = 5\nFN 18: SYSREAD Q1 = ID20 NR1";
    assert_eq!(fault(&format!("{blocks}\nQ2 = Q1")), "Q1 is undefined");
    let mut machine = machine(text("FN 18: SYSREAD Q1 = ID20 NR1\nQ2 = Q1").as_bytes(), Contacts::Perfect);
    machine.set(Parameter::q(1), Value::Number(3.0)).unwrap();
    let (machine, fault) = over(machine);
    assert_eq!(fault, None);
    check(&machine, &[(2, 3.0)]);
}

proptest! {
    /// A hole has the same figures wherever the zero is and along whichever axis it is probed.
    #[test]
    fn a_shift_and_an_axis_change_no_figure(shift in prop::array::uniform3(-500.0..500.0_f64), along in 0..3_usize) {
        let shift = shift.map(|one| (one * 1e3).round() / 1e3);
        let (axis, plane) = [("X", "YZ"), ("Y", "ZX"), ("Z", "XY")][along];
        // The workpiece's centre in its own plane; X, Y and Z of the shift by the axis.
        let [first, second] = [[1, 2], [2, 0], [0, 1]][along];
        let toml = format!("centre = [{}, {}]\nplane = \"{plane}\"", 40.003 + shift[first], 29.996 + shift[second]);
        let blocks = format!("TOOL CALL 1 {axis}\nCYCL DEF 7.1 X{:+} Y{:+} Z{:+}\n{HOLE}", shift[0], shift[1], shift[2]);
        let machine = ran(&blocks, bore(&toml));
        check(&machine, &[(151, 40.003), (152, 29.996), (153, 25.01)]);
    }
}

#[test]
fn faults_are_of_their_kind() {
    let mut machine = machine(text(HOLE).as_bytes(), Contacts::Perfect);
    assert_eq!(*machine.run(u64::MAX).unwrap_err().kind, FaultKind::NoToolCall);
}
