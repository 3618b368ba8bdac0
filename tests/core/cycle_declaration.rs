//! The declarations of cycles 421 and 422 against the control's manuals, and the range errors made from them.

use fitcheck::length::Length;
use fitcheck::probing::cycle::{Angle, Cycle, CycleError, Inputs, Parameter, Range, Value};
use fitcheck::probing::cycles::{CYCLES, cycle};
use fitcheck::probing::simulated::{Machine, Probe, Workpiece};
use fitcheck::probing::{Contact, Recorded};
use fitcheck::tolerance::Feature;

/// Inputs with the three parameters that have no default.
fn asked() -> Inputs {
    [273, 274, 262].into_iter().fold(Inputs::new(), |inputs, q| inputs.with(q, length("25")))
}

fn length(text: &str) -> Value {
    Value::Length(text.parse().unwrap())
}

/// Runs a cycle without a contact to be had: what comes before probing is all that matters.
fn error(cycle: &Cycle, inputs: &Inputs) -> CycleError {
    cycle.measure(inputs, &mut Recorded::new(Vec::new())).unwrap_err()
}

#[track_caller]
fn accepted(cycle: &Cycle, parameter: &Parameter, value: Value) {
    match error(cycle, &asked().with(parameter.q, value)) {
        CycleError::NoContact(_) | CycleError::LimitsSwapped { .. } => {}
        // The control's range begins at 0, a circle does not.
        error if parameter.q == 262 && value == Value::Length(Length::ZERO) => {
            assert_eq!(error.to_string(), "Q262 NOMINAL DIAMETER = 0 mm: a circle needs a diameter above 0");
        }
        error => panic!("Q{} = {value}: {error}", parameter.q),
    }
}

#[track_caller]
fn refused(cycle: &Cycle, parameter: &Parameter, value: Value) {
    let said = error(cycle, &asked().with(parameter.q, value)).to_string();
    let unit = if matches!(value, Value::Length(_)) { " mm" } else { "" };
    assert_eq!(said, format!("Q{} {} = {value}{unit}: {}", parameter.q, parameter.name, parameter.range));
}

/// The values on the bounds of a range, and those one step outside.
fn bounds(range: Range) -> (Vec<Value>, Vec<Value>) {
    let beside = |length: Length, nm: i64| Value::Length(Length::from_nanometres(length.nanometres() + nm).unwrap());
    let turned = |angle: Angle, sign: &str, ten_thousandths: i64| {
        let size = angle.ten_thousandths() + ten_thousandths;
        Value::Angle(format!("{sign}{}.{:04}", size / 10_000, size % 10_000).parse().unwrap())
    };
    match range {
        Range::Length { least, most } => {
            (vec![Value::Length(least), Value::Length(most)], vec![beside(least, -1), beside(most, 1)])
        }
        Range::Angle { most, smallest } => {
            let mut outside = vec![turned(most, "", 1), turned(most, "-", 1)];
            if Angle::default() < smallest {
                outside.extend([turned(smallest, "", -1), turned(smallest, "-", -1), Value::Angle(Angle::default())]);
            }
            (["", "-"].map(|sign| [turned(most, sign, 0), turned(smallest, sign, 0)]).concat(), outside)
        }
        Range::OneOf(allowed) => {
            let outside = [allowed.iter().min().unwrap() - 1, allowed.iter().max().unwrap() + 1];
            (allowed.iter().copied().map(Value::Whole).collect(), outside.map(Value::Whole).to_vec())
        }
        Range::Tool => (vec![Value::Whole(0), Value::Whole(99_999)], vec![Value::Whole(-1), Value::Whole(100_000)]),
    }
}

#[test]
fn every_parameter_is_accepted_on_its_bounds_and_refused_one_step_outside() {
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let (inside, outside) = bounds(parameter.range);
            for value in inside {
                accepted(cycle, parameter, value);
            }
            for value in outside {
                refused(cycle, parameter, value);
            }
        }
    }
}

#[test]
fn a_value_of_another_kind_is_refused_for_every_parameter() {
    let values = [length("10"), Value::Angle(Angle::from_degrees(90)), Value::Whole(3)];
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let wanted = match parameter.range {
                Range::Length { .. } => 0,
                Range::Angle { .. } => 1,
                Range::OneOf(_) | Range::Tool => 2,
            };
            let others = (0..).zip(values).filter(|(kind, _)| *kind != wanted);
            others.for_each(|(_, value)| refused(cycle, parameter, value));
        }
    }
}

#[test]
fn every_parameter_without_a_default_must_be_given() {
    for cycle in CYCLES {
        for parameter in cycle.parameters.iter().filter(|parameter| parameter.default.is_none()) {
            let others = [273, 274, 262].into_iter().filter(|q| *q != parameter.q);
            let inputs = others.fold(Inputs::new(), |inputs, q| inputs.with(q, length("25")));
            let expected = format!("Q{} {} is missing", parameter.q, parameter.name);
            assert_eq!(error(cycle, &inputs).to_string(), expected);
        }
    }
}

#[test]
fn order_numbers_and_defaults_are_those_of_the_control() {
    // The order of the lines in NC programs: a public post-processor's, then the two of newer controls.
    for (number, maximum, minimum) in [(421, 275, 276), (422, 277, 278)] {
        let declared: Vec<_> = cycle(number).unwrap().parameters.iter().map(|p| (p.q, p.name, p.default)).collect();
        let expected = [
            (273, "CENTER IN 1ST AXIS", None),
            (274, "CENTER IN 2ND AXIS", None),
            (262, "NOMINAL DIAMETER", None),
            (325, "STARTING ANGLE", Some(0)),
            (247, "STEPPING ANGLE", Some(900_000)),
            (261, "MEASURING HEIGHT", Some(0)),
            (320, "SET-UP CLEARANCE", Some(0)),
            (260, "CLEARANCE HEIGHT", Some(50_000_000)),
            (301, "MOVE TO CLEARANCE", Some(0)),
            (maximum, "MAXIMUM DIMENSION", Some(0)),
            (minimum, "MINIMUM DIMENSION", Some(0)),
            (279, "TOLERANCE 1ST CENTER", Some(0)),
            (280, "TOLERANCE 2ND CENTER", Some(0)),
            (281, "MEASURING LOG", Some(0)),
            (309, "PGM-STOP IF ERROR", Some(0)),
            (330, "TOOL NUMBER", Some(0)),
            (423, "NO. OF MEAS. POINTS", Some(4)),
            (365, "TYPE OF TRAVERSE", Some(1)),
        ];
        assert_eq!(declared, expected);
    }
}

#[test]
fn a_scatter_of_zero_leaves_the_numbers_of_the_other_alone() {
    let contacts = |surface_scatter, trigger_scatter| -> Vec<Contact> {
        let part = Workpiece { surface_scatter, ..Workpiece::round(Feature::Hole, [25.0, 25.0], 25.0) };
        let mut machine = Machine::new(part, Probe { trigger_scatter }, 3).unwrap();
        cycle(421).unwrap().measure(&asked(), &mut machine).unwrap().contacts
    };
    let (both, surface, probe, none) =
        (contacts(0.0003, 0.0005), contacts(0.0003, 0.0), contacts(0.0, 0.0005), contacts(0.0, 0.0));
    for (at, exact) in none.iter().enumerate() {
        let sum = (surface[at].x - exact.x) + (probe[at].x - exact.x);
        assert!((both[at].x - exact.x - sum).abs() < 1e-13, "touch {}", at + 1);
        assert!(surface[at] != *exact && probe[at] != *exact);
    }
}
