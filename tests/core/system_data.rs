//! What FN 18 and the parameters from Q108 on say of the tool in the spindle, of axes and of places.

use fitcheck::control::tool_table::ToolTable;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine};

use crate::machine::{fault_of, program, settings, text, to_end};

const TABLE: &str = "BEGIN TOOL.T MM\nT   NAME   L      R      DL     DR     RT\n\
                     5   MILL   +90    +6     +0.1   -0.05  7\n6   DRILL  +120   +4     +0     +0     0\n[END]\n";

fn machine(blocks: &str, table: Option<&str>) -> Machine {
    let mut settings = settings();
    settings.tool_table = table.map(|table| ToolTable::read(table.as_bytes(), "tool.t").unwrap());
    let program = program(text(blocks).as_bytes());
    Machine::new(r"TNC:\fit\main.h", program, InMemory::new(), Contacts::Perfect, settings)
}

/// The values of parameters after the run; NaN where one has none.
#[track_caller]
fn values(blocks: &str, table: Option<&str>, parameters: &[u16]) -> Vec<f64> {
    let mut machine = machine(blocks, table);
    to_end(&mut machine);
    let of = |number: &u16| match machine.variables().get(Parameter::q(*number)) {
        Some(Value::Number(value)) => *value,
        Some(Value::Length(length)) => length.to_mm_f64(),
        _ => f64::NAN,
    };
    parameters.iter().map(of).collect()
}

#[track_caller]
fn check(found: &[f64], wanted: &[f64]) {
    let is_same = |(found, wanted): (&f64, &f64)| (found - wanted).abs() < 1e-9 || found.is_nan() && wanted.is_nan();
    assert!(found.len() == wanted.len() && found.iter().zip(wanted).all(is_same), "{found:?}, right: {wanted:?}");
}

#[test]
fn the_tool_in_the_spindle_is_that_of_the_table_with_what_the_call_adds() {
    let blocks = "TOOL CALL 5 Z S1000 DL+0.2 DR-0.01\nFN 18: SYSREAD Q1 = ID20 NR1\nFN 18: SYSREAD Q2 = ID20 NR4\n\
                  FN 18: SYSREAD Q3 = ID60 NR4\nFN 18: SYSREAD Q4 = ID60 NR5\nFN 18: SYSREAD Q5 = ID200 NR1\n\
                  FN 18: SYSREAD Q6 = ID200 NR2\nFN 18: SYSREAD Q7 = ID50 NR8";
    // R 6 - 0.05 - 0.01 and L 90 + 0.1 + 0.2.
    let numbers = [108, 109, 114, 1, 2, 3, 4, 5, 6, 7];
    check(&values(blocks, Some(TABLE), &numbers), &[5.94, 2.0, 90.3, 5.0, 1000.0, 0.2, -0.01, 5.94, 90.3, 7.0]);
    // By its name, in another plane, and none.
    check(&values("TOOL CALL \"DRILL\" Y S50", Some(TABLE), &[108, 109, 114]), &[4.0, 1.0, 120.0]);
    check(&values("TOOL CALL 5 Z\nTOOL CALL 0 Z", Some(TABLE), &[108, 114]), &[0.0, 0.0]);
}

#[test]
fn any_tool_of_the_table_can_be_asked_for() {
    let blocks = "Q9 = 6\nTOOL CALL 5 Z\nFN 18: SYSREAD Q1 = ID50 NR2 IDX6\nFN 18: SYSREAD Q2 = ID50 NR1 IDXQ9\n\
                  FN 18: SYSREAD Q3 = ID50 NR5\nFN 18: SYSREAD Q4 = ID50 NR2 IDX99\nFN 18: SYSREAD Q5 = ID50 NR40 IDX5";
    check(&values(blocks, Some(TABLE), &[1, 2, 3, 4, 5]), &[4.0, 120.0, -0.05, f64::NAN, f64::NAN]);
}

#[test]
fn measures_without_a_table_are_undefined_and_say_what_is_missing() {
    let blocks = "TOOL CALL 5 Z S1000\n";
    check(&values(blocks, None, &[108, 114, 109]), &[f64::NAN, f64::NAN, 2.0]);
    let fault = fault_of(&mut machine(&format!("{blocks}Q1 = Q108 * 2"), None));
    assert_eq!(fault, "Q108 is undefined: it holds a measure of the tool in the spindle, which a tool table says");
    // A table that lacks the tool, and an oversize in a parameter.
    for call in ["TOOL CALL 9 Z", "Q5 = 0.1\nTOOL CALL 5 Z DR+Q5"] {
        let fault = fault_of(&mut machine(&format!("TOOL CALL 6 Z\n{call}\nQ1 = Q108"), Some(TABLE)));
        assert!(fault.starts_with("Q108 is undefined"), "{fault}");
    }
}

#[test]
fn behind_a_tool_measurement_that_was_passed_over_no_measure_of_a_tool_is_known() {
    let measured = "TOOL CALL 5 Z\nTCH PROBE 483 MEASURE TOOL\n";
    for asked in ["ID50 NR1 IDX5", "ID50 NR1", "ID200 NR2"] {
        let blocks = format!("{measured}FN 18: SYSREAD Q1 = {asked}\nFN 18: SYSREAD Q2 = ID20 NR1");
        check(&values(&blocks, Some(TABLE), &[1, 2]), &[f64::NAN, 5.0]);
    }
    for blocks in ["Q1 = Q114", "TOOL CALL 6 Z\nQ1 = Q108"] {
        let fault = fault_of(&mut machine(&format!("{measured}{blocks}"), Some(TABLE)));
        assert!(fault.contains(" is undefined"), "{fault}");
    }
}

#[test]
fn spindle_and_coolant_are_those_of_the_m_functions() {
    check(&values("Q1 = Q110\nQ2 = Q111\nQ3 = Q109", None, &[1, 2, 3]), &[-1.0, 0.0, -1.0]);
    for (blocks, spindle, coolant) in
        [("M3", 0.0, 0.0), ("M14", 1.0, 1.0), ("M13\nM5", 2.0, 1.0), ("M4\nM5", 3.0, 0.0), ("M8\nM9", -1.0, 0.0)]
    {
        let blocks = format!("TOOL CALL 5 Z\n{blocks}\nFN 18: SYSREAD Q1 = ID20 NR5\nFN 18: SYSREAD Q2 = ID20 NR8");
        check(&values(&blocks, None, &[110, 111, 1, 2]), &[spindle, coolant, spindle, coolant]);
    }
}

#[test]
fn places_count_from_the_datum_in_force() {
    let blocks = "TOOL CALL 5 Z\nL X+10 Y+20 R0 FMAX\nL Z+50 R0 FMAX\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+4\n\
                  FN 18: SYSREAD Q1 = ID270 NR1 IDX1\nFN 18: SYSREAD Q2 = ID270 NR1 IDX3\nFN 18: SYSREAD Q3 = ID220 NR2 IDX1";
    check(&values(blocks, None, &[1, 2, 3]), &[6.0, 50.0, 4.0]);
    // Nobody knows where the probe is before it moves, nor in turned coordinates.
    let unknown = "TOOL CALL 5 Z\nFN 18: SYSREAD Q1 = ID270 NR1 IDX1";
    check(&values(unknown, None, &[1]), &[f64::NAN]);
    let turned = "L X+10 Y+20 R0 FMAX\nL Z+50 R0 FMAX\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\nFN 18: SYSREAD Q1 = ID270 NR1 IDX1";
    check(&values(turned, None, &[1]), &[f64::NAN]);
}

#[test]
fn what_only_a_control_knows_stays_undefined_with_a_remark() {
    let mut machine = machine("FN 18: SYSREAD Q1 = ID990 NR8\nQS1 = SYSSTR ( ID10010 NR1 )", None);
    to_end(&mut machine);
    assert_eq!(machine.remarks().len(), 1);
    let name = machine.variables().get(Parameter::qs(1)).cloned();
    assert_eq!(name, Some(Value::Text(r"TNC:\fit\main.h".to_owned())));
}

#[test]
fn a_table_without_the_columns_of_breakage_is_used_and_says_what_it_cannot_do() {
    let table = ToolTable::read(TABLE.as_bytes(), "tool.t").unwrap();
    let said: Vec<String> = table.warnings().iter().map(ToString::to_string).collect();
    assert!(said.iter().any(|said| said.contains("no column TL")), "{said:?}");
    assert_eq!(table.tools().len(), 2);
}
