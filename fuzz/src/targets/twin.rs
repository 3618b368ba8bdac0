//! The built-in program 8255 on a simulated workpiece: its status and its window are those of a native check, to the
//! nanometre; where there are no limits, neither gives a verdict.

use std::sync::{Arc, LazyLock};

use fitcheck::control::shipped_tables;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::journal::{Record, status_window};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Fault, Machine, Settings, Shipped, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::Origin;
use fitcheck::probing::cycle::Plane;
use fitcheck::probing::measure::{ProbePosition, cycle_number, measure};
use fitcheck::probing::simulated::{Simulation, Surface, Workpiece};
use fitcheck::tolerance::{Callout, Limits, Sources, ToleranceClass};
use fitcheck::words::Dialogue;

use super::shared::{Figures, NOW};

/// The tables that the program reads.
static SOURCES: LazyLock<Sources> = LazyLock::new(|| Sources::of_tables(shipped_tables()));

/// The smallest workpiece that can be simulated, in nanometres.
const SMALLEST: i64 = 1000;

pub fn run(bytes: &[u8]) {
    thread_local! {
        static MACHINES: [std::cell::RefCell<Machine>; 4] = Dialogue::ALL.map(|language| machine(language).into());
    }
    let mut figures = Figures(bytes);
    let language = usize::from(figures.byte()) % Dialogue::ALL.len();
    let classes: Vec<ToleranceClass> =
        SOURCES.tables().flat_map(|table| table.columns()).map(|column| column.class).collect();
    let class = figures.one_of(&classes);
    let nominal = match figures.byte() % 3 {
        // About the end of a range, any size, a size as on drawings.
        0 => {
            let ends: Vec<Length> = SOURCES.tables().flat_map(|table| table.ends().to_vec()).collect();
            figures.one_of(&ends).nanometres() + i64::from(figures.short())
        }
        1 => 1 + figures.up_to(401_000_000),
        _ => (1 + figures.up_to(40_100)) * 10_000,
    };
    let (Ok(nominal), place) = (Length::from_nanometres(nominal), figures.byte()) else { return };
    let Ok(callout) = Callout::new(nominal, class) else { return };
    let limits = SOURCES.limits(&callout, None).ok().filter(|limits| Length::ZERO <= limits.minimum());
    MACHINES.with(|machines| {
        let mut machine = machines[language].borrow_mut();
        let Some(limits) = limits else {
            assert!(result(&mut machine, callout, Contacts::Perfect).is_err(), "{callout} has no limits");
            assert!(machine.windows().is_empty() && machine.status().is_none());
            return;
        };
        let near = i64::from(figures.short()) % 3000;
        let measured = match place % 4 {
            0 => limits.minimum().nanometres() + near % 3,
            1 => limits.maximum().nanometres() + near % 3,
            _ => limits.middle().nanometres() + near,
        };
        if measured < SMALLEST {
            return;
        }
        let measured = Length::from_nanometres(measured).expect("near the limits");
        compare(&mut machine, callout, &limits, measured);
    });
}

fn machine(language: Dialogue) -> Machine {
    let bytes = Shipped::file(&format!("8255_{language}.h")).expect("a built-in program");
    let (program, _) = Program::read(bytes).expect("a program");
    let path = format!(r"TNC:\8255\8255_{language}.h");
    Machine::new(&path, Arc::new(program), Shipped, Contacts::Perfect, Settings::new(language, NOW))
}

/// Runs the program with Q1 and QS1 as an operator sets them.
fn result(machine: &mut Machine, callout: Callout, contacts: Contacts) -> Result<(), Fault> {
    machine.restart(contacts);
    let class = callout.class().expect("a class").to_string();
    machine.set(Parameter::q(1), Value::Number(callout.nominal().to_mm_f64())).expect("a number");
    machine.set(Parameter::qs(1), Value::Text(class)).expect("a text");
    while machine.run(u64::MAX)? != Step::Ended {}
    Ok(())
}

fn compare(machine: &mut Machine, callout: Callout, limits: &Limits, diameter: Length) {
    let Some(feature) = limits.feature else { return };
    let workpiece = Workpiece::round(feature, [40.0, 30.0], diameter.to_mm_f64());
    let simulation = Simulation::perfect(Surface::Round(workpiece, Plane::Xy));
    let position = ProbePosition {
        centre: [40_000, 30_000].map(Length::from_micrometres),
        height: Length::from_micrometres(-8_000),
        clearance: Length::from_micrometres(2_000),
        ..ProbePosition::default()
    };
    let origin = Origin::Simulated { cycle: cycle_number(feature), seed: 1 };
    let mut prober = simulation.machine().expect("a workpiece");
    let native = measure(feature, limits, &position, &mut prober, origin);
    let ran = result(machine, callout, Contacts::Workpiece(simulation.into()));
    match (native, ran) {
        (Ok((measurement, _)), Ok(())) => {
            assert_eq!(measurement.diameter, diameter, "{callout}");
            let record = Record::judged(NOW, String::new(), Some(callout), limits.clone(), measurement, None);
            let language = machine.settings().language;
            assert_eq!(machine.status(), Some(record.verdict.status()), "{callout}, {diameter} mm");
            let window = status_window(&record, language, None).expect("a built-in mask");
            let shown: Vec<&str> = machine.windows().iter().map(|window| window.text.as_str()).collect();
            assert_eq!(shown, [window.as_str()], "{callout}, {diameter} mm");
        }
        (Err(_), Err(_)) => {}
        (Ok(_), Err(fault)) => panic!("{callout}, {diameter} mm: {fault}"),
        (Err(error), Ok(())) => panic!("{callout}, {diameter} mm: only the program gives a verdict, {error}"),
    }
}
