//! Cycles that set a datum, and what is measured behind them. The programs in `tests/data/samples/datum` and the values that they are to give
//! were worked out apart from the program, from geometry alone.

use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::Contact;
use fitcheck::probing::simulated::{Part, Simulation};
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;
use proptest::prelude::*;

pub(crate) fn sample(name: &str) -> String {
    let path = format!("{}/tests/data/samples/datum/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn part(name: &str) -> Contacts {
    Contacts::Workpiece(Part::read(&sample(&format!("{name}.toml"))).unwrap())
}

pub(crate) fn machine(text: &str, contacts: Contacts) -> Machine {
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    Machine::new("main.h", Arc::new(Program::read(text.as_bytes()).unwrap().0), InMemory::new(), contacts, settings)
}

/// Runs to the end or to a fault.
pub(crate) fn over(mut machine: Machine) -> (Machine, Option<String>) {
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => return (machine, None),
            Ok(_) => {}
            Err(fault) => return (machine, Some(fault.to_string())),
        }
    }
}

#[track_caller]
pub(crate) fn ran(name: &str, text: &str) -> Machine {
    let (machine, fault) = over(machine(text, part(name)));
    assert_eq!(fault, None, "{name}");
    machine
}

#[track_caller]
pub(crate) fn check(machine: &Machine, values: &[(u16, f64)]) {
    for &(number, wanted) in values {
        let found = match machine.variables().get(Parameter::q(number)) {
            Some(Value::Number(number)) => *number,
            Some(Value::Length(length)) => length.to_mm_f64(),
            found => panic!("Q{number} is {found:?}"),
        };
        assert!((found - wanted).abs() < 0.000_1, "Q{number} = {found}, wanted {wanted}");
    }
}

pub(crate) fn verdicts(machine: &Machine) -> Vec<Option<Status>> {
    machine.cycles().iter().map(|run| run.result.verdict()).collect()
}

/// Where the zero of the datum is that the last cycle counted from.
pub(crate) fn zero(machine: &Machine) -> Option<String> {
    let datum = machine.cycles().last()?.datum.as_ref()?;
    Some(datum.zero.map(|axis| axis.to_string()).join(" "))
}

pub(crate) fn remarks(machine: &Machine) -> Vec<String> {
    machine.remarks().iter().map(|(place, remark)| format!("{}: {remark}", place.block)).collect()
}

const GOOD: Option<Status> = Some(Status::Good);

#[test]
fn a_face_becomes_the_zero_of_the_probe_axis() {
    let text = sample("s1_417_427.h");
    let machine = ran("s1_417_427", &text);
    check(&machine, &[(1, 0.037), (160, 0.0)]);
    assert_eq!(verdicts(&machine), [None, GOOD]);
    assert_eq!(zero(&machine).as_deref(), Some("0 0 0.037"));
    // Without it the face is too high.
    let (head, rest) = text.split_once("4  TCH PROBE 417").unwrap();
    let (lines, rest) = rest.split_once("5  Q1 = Q160").unwrap();
    let without = format!("{head}5  Q1 = 0{rest}");
    assert_eq!(ran("s1_417_427", &without).status(), Some(Status::Rework));
    // The second one finds the face at zero.
    let twice = format!("{head}4  TCH PROBE 417{lines}TCH PROBE 417{lines}5  Q1 = Q160{rest}");
    let machine = ran("s1_417_427", &twice);
    check(&machine, &[(1, 0.0), (160, 0.0)]);
    assert_eq!(zero(&machine).as_deref(), Some("0 0 0.037"));
}

#[test]
fn the_centre_of_a_hole_becomes_the_zero() {
    let machine = ran("s2_412_421", &sample("s2_412_421.h"));
    check(&machine, &[(1, 50.12), (2, 29.93), (3, 25.008), (151, 0.0), (152, 0.0), (153, 25.008), (163, 0.008)]);
    assert_eq!(verdicts(&machine), [None, GOOD]);
    assert_eq!(zero(&machine).as_deref(), Some("50.12 29.93 0"));
}

#[test]
fn a_stud_and_its_top_become_the_datum_of_all_axes() {
    let machine = ran("s3_413_ts", &sample("s3_413_ts.h"));
    check(&machine, &[(1, 25.06), (2, 24.97), (3, 30.04), (160, 0.0)]);
    assert_eq!(verdicts(&machine), [None, GOOD, GOOD]);
    assert_eq!(zero(&machine).as_deref(), Some("25.06 14.97 25.013"));
}

#[test]
fn slot_and_ridge_set_one_axis_each() {
    let machine = ran("s4_408_409", &sample("s4_408_409.h"));
    check(&machine, &[(1, 24.03), (2, 0.21), (3, 39.97), (4, 80.06), (5, 0.0), (6, 80.0)]);
    assert_eq!(verdicts(&machine), [None, None, GOOD, GOOD]);
    assert_eq!(zero(&machine).as_deref(), Some("0.21 0.06 0"));
    let inch = sample("s4_408_409.h").replace("S4_408_409 MM", "S4_408_409 INCH");
    let (machine, _) = over(self::machine(&in_inches(&inch), part("s4_408_409")));
    check(&machine, &[(1, 24.03 / 25.4), (2, 0.21 / 25.4)]);
}

/// The lengths of a program's cycles and moves in inches.
fn in_inches(text: &str) -> String {
    let line = |line: &str| {
        let is_length = ["Q321", "Q322", "Q311", "Q261", "Q320", "Q260", "Q405"].iter().any(|q| line.contains(q));
        match line.split_once('=').filter(|_| is_length) {
            Some((name, rest)) => {
                let (value, comment) = rest.split_once(';').unwrap();
                let mm: f64 = value.trim().parse().unwrap();
                format!("{name}={:+.9} ;{comment}", mm / 25.4)
            }
            None => line.replace("Z+60", "Z+2.5"),
        }
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_row_of_the_preset_table_acts_with_cycle_247() {
    let machine = ran("s5_411_row1", &sample("s5_411_row1.h"));
    check(&machine, &[(1, 0.15), (2, -0.08), (3, 130.02), (4, 129.96), (5, 0.15), (6, -0.08), (7, 0.0)]);
    check(&machine, &[(151, 0.0), (152, 0.0)]);
    assert_eq!(verdicts(&machine), [None, Some(Status::Scrap), GOOD]);
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("row 1 of the preset table set to X 0.15, Y -0.08 mm")), "{said:?}");
}

#[test]
fn a_cam_system_s_chain_sets_one_axis_after_the_other() {
    let machine = ran("s6_417_419_419", &sample("s6_417_419_419.h"));
    check(&machine, &[(1, -40.0), (2, 30.0), (160, 0.0)]);
    assert_eq!(verdicts(&machine), [None, None, None, GOOD, GOOD, GOOD]);
    assert_eq!(zero(&machine).as_deref(), Some("0.04 0.04 0.05"));
}

#[test]
fn the_shift_ends_where_the_display_is_set() {
    let machine = ran("s8_412_shift", &sample("s8_412_shift.h"));
    check(&machine, &[(1, 0.02), (2, 0.05), (3, -0.02), (4, 10.02)]);
    assert_eq!(zero(&machine).as_deref(), Some("100.05 49.98 0"));
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("the datum shift ended in Z without")), "{said:?}");
    assert!(machine.remarks_stand_against());
}

/// A hole off its place, and a program that sets its datum there and measures the same hole.
const HOLE: &str = "[bore]\ncentre = [0.4, -0.3]\ndiameter = 25.01\n[probe]\nball_radius = 3\n";
const SET: &str = "TCH PROBE 412 DATUM INSIDE CIRCLE ~\nQ321=+0 ~\nQ322=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-3 ~\nQ320=+2 ~\n\
                   Q260=+15 ~\nQ301=+0 ~\nQ305=+0 ~\nQ331=+0 ~\nQ332=+0 ~\nQ303=+1 ~\nQ381=+0 ~\nQ382=+0 ~\nQ383=+0 ~\nQ384=+0 ~\nQ333=+0 ~\n\
                   Q423=+4 ~\nQ365=+1";
const MEASURE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-5 ~\nQ320=+2 ~\n\
                       Q260=+15 ~\nQ301=+0 ~\nQ275=+25.021 ~\nQ276=+25 ~\nQ279=+0.02 ~\nQ280=+0.02 ~\nQ281=+0 ~\nQ309=+0 ~\nQ330=+0";

fn hole() -> Contacts {
    Contacts::Workpiece(Simulation::read(HOLE).unwrap().into())
}

fn program(blocks: &str) -> String {
    format!("BEGIN PGM main MM\nTOOL CALL 100 Z S50\nL X+0 Y+0 R0 FMAX\n{blocks}\nEND PGM main MM\n")
}

fn run(blocks: &str, contacts: Contacts) -> (Machine, Option<String>) {
    over(machine(&program(blocks), contacts))
}

/// What a run ends with, without the place.
#[track_caller]
fn refused(blocks: &str, contacts: Contacts, why: &str) {
    let (machine, fault) = run(blocks, contacts);
    let fault = fault.unwrap_or_else(|| panic!("it ran to its end: {blocks}"));
    assert!(fault.starts_with(r"TNC:\main.h, line ") && fault.contains(why), "{fault}");
    assert_eq!(machine.status(), None, "{blocks}");
}

#[test]
fn the_same_hole_is_good_behind_its_datum_and_scrap_without() {
    let (machine, fault) = run(&format!("{SET}\n{MEASURE}"), hole());
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    assert_eq!(run(MEASURE, hole()).0.status(), Some(Status::Scrap));
    // What it measured counts in the system before; nothing of an earlier measurement is left.
    let (machine, fault) = run(&format!("{MEASURE}\n{SET}"), hole());
    assert_eq!(fault, None);
    check(&machine, &[(151, 0.4), (152, -0.3), (153, 25.01), (198, 412.0), (305, 0.0)]);
    for gone in (161..=166).chain(180..=182) {
        assert_eq!(machine.variables().get(Parameter::q(gone)), None, "Q{gone}");
    }
    // A subprogram and a called program leave it behind.
    let sub = format!("CALL LBL 1\n{MEASURE}\nM30\nLBL 1\n{SET}\nLBL 0");
    assert_eq!(run(&sub, hole()).0.status(), Some(Status::Good));
}

#[test]
fn moves_go_to_the_new_zero_at_once() {
    let (machine, _) = run(&format!("{SET}\nL X+0 Y+0 R0 FMAX"), hole());
    let [x, y, _] = machine.position();
    assert_eq!([x, y], [Some(0.4), Some(-0.3)]);
}

#[test]
fn another_preset_takes_the_place_of_the_datum_and_row_0_brings_it_back() {
    let preset = |number: u32| format!("CYCL DEF 247 DATUM SETTING ~\nQ339=+{number}");
    let (machine, fault) = run(&format!("{}\n{SET}\n{}\n{MEASURE}", preset(1), preset(1)), hole());
    assert_eq!((fault, machine.status()), (None, Some(Status::Scrap)));
    check(&machine, &[(161, 0.4), (162, -0.3)]);
    let (machine, _) = run(&format!("{SET}\n{}\n{}\n{MEASURE}", preset(1), preset(0)), hole());
    assert_eq!(machine.status(), Some(Status::Good));
    // The row of the active preset acts at once, with a remark that an iTNC 530 waits for cycle 247.
    let row = SET.replace("Q305=+0", "Q305=+1");
    let (machine, _) = run(&format!("{}\n{row}\n{MEASURE}", preset(1)), hole());
    assert_eq!((machine.status(), machine.remarks_stand_against()), (Some(Status::Good), true));
    // Another row changes nothing before it is active.
    assert_eq!(run(&format!("{row}\n{MEASURE}"), hole()).0.status(), Some(Status::Scrap));
    assert_eq!(run(&format!("{row}\n{}\n{MEASURE}", preset(1)), hole()).0.status(), Some(Status::Good));
}

#[test]
fn what_is_not_known_is_refused_with_its_line() {
    let row = SET.replace("Q305=+0", "Q305=+5");
    let table = "row 5 of the active datum table (Q303 = 0)";
    refused(&format!("{}\n{MEASURE}", row.replace("Q303=+1", "Q303=+0")), hole(), table);
    let unstated = "cycle 412: Q305 = 5 with Q303 = -1: it is not stated which table has that row";
    refused(&format!("{}\n{MEASURE}", row.replace("Q303=+1", "Q303=-1")), hole(), unstated);
    refused(&format!("{}\n{MEASURE}", row.replace("Q303=+1 ~\n", "")), hole(), unstated);
    // For the display Q303 has no function.
    for other in ["Q303=+0", "Q303=-1"] {
        let (machine, fault) = run(&format!("{}\n{MEASURE}", SET.replace("Q303=+1", other)), hole());
        assert_eq!((fault, machine.status()), (None, Some(Status::Good)), "{other}");
    }
    let active = format!("CYCL DEF 247 DATUM SETTING ~\nQ339=+5\nCYCL DEF 7.1 X+0.1\n{row}\n{MEASURE}");
    refused(&active, hole(), "row 5 is the active preset, and a datum shift is active");
    let turned = format!("CYCL DEF 10.1 ROT+30\n{SET}\n{MEASURE}");
    refused(&turned, hole(), "a rotation has been active since line 4");
    refused(&format!("{}\n{MEASURE}", SET.replace("Q321=+0", "Q321=+100")), hole(), "contact 1");
    refused(&format!("{}\n{MEASURE}", SET.replace("Q260=+15 ~\n", "")), hole(), "Q260 CLEARANCE HEIGHT is missing");
    // A cycle that is not followed and may set a datum ends all measuring.
    let other = SET.replace("TCH PROBE 412 DATUM INSIDE CIRCLE", "TCH PROBE 416 DATUM CIRCLE CENTER");
    refused(&format!("{other}\n{MEASURE}"), hole(), "does not follow cycle 416");
}

#[test]
fn a_perfect_workpiece_has_the_top_that_is_probed() {
    let top = SET.replace("Q381=+0", "Q381=+1").replace("Q382=+0", "Q382=+40").replace("Q384=+0", "Q384=+2");
    let (machine, fault) = run(&format!("{}\n{MEASURE}", top.replace("Q333=+0", "Q333=+5")), Contacts::Perfect);
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    assert_eq!(zero(&machine).as_deref(), Some("0 0 -3"));
}

#[test]
fn recorded_contacts_count_from_the_new_datum() {
    let circle = |x: f64, y: f64| {
        [[12.505, 0.0], [0.0, 12.505], [-12.505, 0.0], [0.0, -12.505]]
            .map(|[off_x, off_y]| Contact::at([x + off_x, y + off_y, -5.0]))
    };
    let contacts = Contacts::Recorded([circle(0.4, -0.3), circle(0.01, 0.0)].concat());
    let (machine, fault) = run(&format!("{SET}\n{MEASURE}"), contacts);
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    check(&machine, &[(161, 0.01), (162, 0.0)]);
}

#[test]
fn the_tool_axis_says_which_axes_are_set() {
    let part = "[[feature]]\nname = \"A\"\nkind = \"face\"\npoint = [0, 0, 1.5]\nnormal = [0, 0, 1]\n[probe]\nball_radius = 3\n";
    let set = "TCH PROBE 419 DATUM IN ONE AXIS ~\nQ263=+0 ~\nQ264=+0 ~\nQ261=+30 ~\nQ320=+2 ~\nQ260=+50 ~\nQ272=+1 ~\nQ267=-1 ~\nQ305=+0 ~\n\
               Q333=+1 ~\nQ303=+1";
    let text = program(&format!("{set}\n{MEASURE}")).replace("TOOL CALL 100 Z", "TOOL CALL 100 Y");
    let (machine, _) = over(machine(&text, Contacts::Workpiece(Part::read(part).unwrap())));
    check(&machine, &[(160, 1.5)]);
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("its zero is now at X 0, Y 0, Z 0.5 mm")), "{said:?}");
}

const TABLE: &str = "BEGIN PRESET.PR MM\r\n\
    NO   DOC      X            Y            Z            SPC     LOCKED\r\n\
    0             +0           +0           +0           +0      -\r\n\
    1    VICE     +100.5       +200         -50          +0      -\r\n\
    2    PLATE    +100.5       +250         -50.25       +0      -\r\n\
    3    OLD      +0           +0           +0           +0      1\r\n\
    4    TURNED   +0           +0           +0           +1.5    -\r\n\
    5    EMPTY    -            -            -            -       -\r\n\
    [END]\r\n";

fn with_table(blocks: &str) -> (Machine, Option<String>) {
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let store = InMemory::new().with("preset.pr", TABLE);
    let program = Arc::new(Program::read(program(blocks).as_bytes()).unwrap().0);
    over(Machine::new("main.h", program, store, hole(), settings))
}

#[test]
fn the_preset_table_says_where_the_rows_are_and_is_written() {
    let preset = |number: u32| format!("CYCL DEF 247 DATUM SETTING ~\nQ339=+{number}");
    let row = |number: u32| SET.replace("Q305=+0", &format!("Q305=+{number}"));
    // The workpiece lies at the row that is active first; another one is 50 mm away in Y.
    let (machine, fault) = with_table(&format!("{}\n{}\n{}", preset(1), preset(2), SET.replace("Q322=+0", "Q322=-50")));
    assert_eq!(fault, None);
    check(&machine, &[(151, 0.4), (152, -50.3)]);
    assert!(!remarks(&machine).iter().any(|said| said.contains("assumed to lie")), "{:?}", remarks(&machine));
    let (machine, fault) = with_table(&format!("{}\n{}\n{}\n{MEASURE}", preset(1), row(2), preset(2)));
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    // X and Y are where the hole is, Z stays what the table has.
    let datum = machine.cycles().last().unwrap().datum.clone().unwrap();
    assert_eq!(datum.zero.map(|axis| axis.to_string()), ["0.4", "-0.3", "-0.25"]);
    assert_eq!((datum.set_by.line, datum.set_by.text.as_str()), (6, "TCH PROBE 412 DATUM INSIDE CIRCLE ~"));
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains(r"TNC:\table\preset.pr was written")), "{said:?}");
    for (blocks, why) in [
        (format!("{}\n{}", preset(1), row(3)), "preset.pr: row 3 is locked, so the cycle cannot write it"),
        (format!("{}\n{}", preset(1), row(7)), "preset.pr has no row 7"),
        (preset(7), "preset.pr has no row 7"),
        (format!("{}\n{MEASURE}", preset(4)), "a rotation has been active since line 4"),
    ] {
        let fault = with_table(&blocks).1.unwrap_or_else(|| panic!("it ran to its end: {blocks}"));
        assert!(fault.contains(why), "{fault}");
    }
}

#[test]
fn what_the_preset_table_does_not_say_is_told() {
    let preset = |number: u32| format!("CYCL DEF 247 DATUM SETTING ~\nQ339=+{number}");
    let row = SET.replace("Q305=+0", "Q305=+5");
    // An empty row can be written; in Z the workpiece is taken to lie there.
    let (machine, fault) = with_table(&format!("{}\n{row}\n{}\n{MEASURE}", preset(1), preset(5)));
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    assert!(remarks(&machine).iter().any(|said| said.contains("preset 5: the workpiece is assumed to lie there")));
    // A program that writes the table itself is not followed.
    let own = format!(
        "{}\nFN 26: TABOPEN TNC:\\table\\preset.pr\nQ50 = 1\nFN 27: TABWRITE 1/\"X\" = Q50\n{MEASURE}",
        preset(1)
    );
    let fault = with_table(&own).1.unwrap();
    assert!(fault.contains("an unknown datum has been active since line 8"), "{fault}");
    // Without cycle 247 before it is not known where the workpiece lies on the machine.
    let (machine, fault) = with_table(&format!("{row}\n{}\n{MEASURE}", preset(5)));
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    assert!(remarks(&machine).iter().any(|said| said.contains("preset.pr stays as it is: no cycle 247 before")));
}

#[test]
fn an_iso_program_sets_its_datum_as_well() {
    let text = "%A G71 *\nN10 T100 G17 *\nN20 G412 Q321=+0 Q322=+0 Q262=+25 Q325=+0 Q247=+90 Q261=-3 Q320=+2 Q260=+15 Q301=+0 Q305=+0 \
                Q331=+0 Q332=+0 Q303=+1 *\nN30 G421 Q273=+0 Q274=+0 Q262=+25 Q325=+0 Q247=+90 Q261=-5 Q320=+2 Q260=+15 Q301=+0 \
                Q275=+25.021 Q276=+25 Q279=+0.02 Q280=+0.02 *\nN99999999 %A G71 *\n";
    let (machine, fault) = over(machine(text, hole()));
    assert_eq!((fault, machine.status()), (None, Some(Status::Good)));
    assert_eq!(zero(&machine).as_deref(), Some("0.4 -0.3 0"));
}

proptest! {
    /// Wherever the hole is and whatever coordinates it gets: behind its datum it is where the program says.
    #[test]
    fn what_was_measured_has_the_wanted_coordinates(
        centre in prop::array::uniform2(-0.9..0.9_f64),
        wanted in prop::array::uniform2(-500_000..500_000_i64),
        shift in prop::array::uniform2(-90_000..90_000_i64),
    ) {
        let mm = |thousandths: i64| format!("{:+}.{:03}", thousandths / 1_000, (thousandths % 1_000).abs());
        let [x, y] = wanted.map(|at| if (-999..0).contains(&at) { -at } else { at }).map(mm);
        let [by_x, by_y] = shift.map(|at| if (-999..0).contains(&at) { -at } else { at }).map(mm);
        let set = SET.replace("Q331=+0", &format!("Q331={x}")).replace("Q332=+0", &format!("Q332={y}"));
        let measure = MEASURE.replace("Q273=+0", &format!("Q273={x}")).replace("Q274=+0", &format!("Q274={y}"));
        let [off_x, off_y] = centre;
        let [at_x, at_y] = [(off_x, &by_x), (off_y, &by_y)].map(|(off, by)| off + by.parse::<f64>().unwrap());
        let bore = format!("[bore]\ncentre = [{at_x}, {at_y}]\ndiameter = 25.01\n[probe]\nball_radius = 3\n");
        let part = Contacts::Workpiece(Simulation::read(&bore).unwrap().into());
        let (machine, fault) = run(&format!("CYCL DEF 7.1 X{by_x} Y{by_y}\n{set}\n{measure}"), part);
        prop_assert_eq!(fault, None);
        let found = machine.cycles().last().unwrap().result.circle.as_ref().unwrap().position.axes;
        // Nanometres: the datum is one, and so is the centre.
        prop_assert!(found.iter().all(|axis| axis.deviation.nanometres().abs() <= 1), "{found:?}");
        prop_assert_eq!(machine.status(), Some(Status::Good));
    }
}
