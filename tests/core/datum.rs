//! Cycles that set a datum, and what is measured behind them. The programs in `tests/data/samples/datum` and the values that they are to give
//! were worked out apart from the program, from geometry alone.

use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::simulated::Part;
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;

fn sample(name: &str) -> String {
    let path = format!("{}/tests/data/samples/datum/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn part(name: &str) -> Contacts {
    Contacts::Workpiece(Part::read(&sample(&format!("{name}.toml"))).unwrap())
}

fn machine(text: &str, contacts: Contacts) -> Machine {
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    Machine::new("main.h", Arc::new(Program::read(text.as_bytes()).unwrap().0), InMemory::new(), contacts, settings)
}

/// Runs to the end or to a fault.
fn over(mut machine: Machine) -> (Machine, Option<String>) {
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => return (machine, None),
            Ok(_) => {}
            Err(fault) => return (machine, Some(fault.to_string())),
        }
    }
}

#[track_caller]
fn ran(name: &str, text: &str) -> Machine {
    let (machine, fault) = over(machine(text, part(name)));
    assert_eq!(fault, None, "{name}");
    machine
}

#[track_caller]
fn check(machine: &Machine, values: &[(u16, f64)]) {
    for &(number, wanted) in values {
        let found = match machine.variables().get(Parameter::q(number)) {
            Some(Value::Number(number)) => *number,
            Some(Value::Length(length)) => length.to_mm_f64(),
            found => panic!("Q{number} is {found:?}"),
        };
        assert!((found - wanted).abs() < 0.000_1, "Q{number} = {found}, wanted {wanted}");
    }
}

fn verdicts(machine: &Machine) -> Vec<Option<Status>> {
    machine.cycles().iter().map(|run| run.result.verdict()).collect()
}

/// Where the zero of the datum is that the last cycle counted from.
fn zero(machine: &Machine) -> Option<String> {
    let datum = machine.cycles().last()?.datum.as_ref()?;
    Some(datum.zero.map(|axis| axis.to_string()).join(" "))
}

fn remarks(machine: &Machine) -> Vec<String> {
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
    let (from, to) = (text.find("4  TCH PROBE 417").unwrap(), text.find("5  Q1").unwrap());
    let without = format!("{}{}", &text[..from], text[to..].replace("Q1 = Q160", "Q1 = 0"));
    assert_eq!(ran("s1_417_427", &without).status(), Some(Status::Rework));
    // The second one finds the face at zero.
    let cycle = &text[from..to];
    let machine = ran("s1_417_427", &text.replace(cycle, &format!("{cycle}{}", cycle.replace("4  TCH", "TCH"))));
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
                let end = rest.find([' ', ';']).unwrap_or(rest.len());
                let mm: f64 = rest[..end].parse().unwrap();
                format!("{name}={:+.9} {}", mm / 25.4, &rest[end..])
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
