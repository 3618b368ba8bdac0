//! Any bytes as a program, a called program, a table and a mask (byte 0x1C between them) are run within a small budget:
//! the run ends, nothing is larger afterwards than the budget says, and a second run does the same.

use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings};
use fitcheck::nc::program::Program;
use fitcheck::probing::Contact;
use fitcheck::words::Dialogue;

use super::shared::{Figures, NOW, SMALL, to_its_end};

pub fn run(bytes: &[u8]) {
    let mut figures = Figures(bytes);
    let flags = figures.byte();
    let mut parts = figures.0.split(|byte| *byte == 0x1c);
    let mut part = || parts.next().unwrap_or_default();
    let main = part();
    let Ok((program, _)) = Program::read(main) else { return };
    let store = InMemory::new().with("main.h", main).with("sub.h", part()).with("own.tab", part()).with("m.a", part());
    let mut settings = Settings::new(Dialogue::En, NOW);
    settings.budget = SMALL;
    settings.skip_unknown = flags & 1 != 0;
    settings.block_skip = flags & 2 != 0;
    settings.optional_stop = flags & 4 != 0;
    settings.assumes_tool = flags & 0x20 != 0;
    let contacts = match (flags >> 3) & 3 {
        0 => Contacts::Recorded(Vec::new()),
        1 => Contacts::Recorded(
            [[12.5, 0.0], [0.0, 12.5], [-12.5, 0.0], [0.0, -12.5]].map(|[x, y]| Contact::at([x, y, 0.0])).to_vec(),
        ),
        _ => Contacts::Perfect,
    };
    let mut machine = Machine::new(r"TNC:\main.h", Arc::new(program), store, contacts.clone(), settings);
    run_to_the_end(bytes, &mut machine);
    let keeps_files = machine.outputs().is_empty();
    let first = said(&machine);
    machine.restart(contacts);
    run_to_the_end(bytes, &mut machine);
    // Files that the first run has written stay.
    assert!(!keeps_files || said(&machine) == first || changes_a_table(main), "a second run does something else");
}

fn run_to_the_end(bytes: &[u8], machine: &mut Machine) {
    for number in 1..=2 {
        machine.set(Parameter::q(number), Value::Number(1.0)).expect("a number");
        machine.set(Parameter::qs(number), Value::Text("ab".to_owned())).expect("a text");
    }
    to_its_end(bytes, machine);
    is_within_budget(machine);
}

fn is_within_budget(machine: &Machine) {
    assert!(machine.is_over() && machine.blocks_run() <= SMALL.blocks);
    assert!(machine.windows().len() <= SMALL.windows && machine.outputs().len() <= SMALL.outputs);
    assert!(machine.cycles().len() <= SMALL.cycles && machine.path().len() <= SMALL.path);
    assert!(machine.remarks().len() <= SMALL.remarks);
    assert!(machine.calls().len() <= SMALL.label_calls + SMALL.program_calls);
    for (parameter, value) in machine.variables().iter() {
        match value {
            Value::Text(text) => assert!(text.chars().count() <= SMALL.text, "{parameter}"),
            Value::Number(number) => assert!(number.abs() <= 1e10, "{parameter} = {number}"),
            Value::Length(_) => {}
        }
    }
}

/// Everything that a run leaves.
fn said(machine: &Machine) -> String {
    let windows: Vec<&str> = machine.windows().iter().map(|window| window.text.as_str()).collect();
    let results: Vec<_> = machine.cycles().iter().map(|run| &run.result.results).collect();
    format!("{:?} {windows:?} {results:?} {} {:?}", machine.variables(), machine.blocks_run(), machine.path())
}

/// FN 27 writes into a table, which stays changed.
fn changes_a_table(main: &[u8]) -> bool {
    String::from_utf8_lossy(main).to_uppercase().contains("TABWRITE") || main.contains(&0x1c)
}
