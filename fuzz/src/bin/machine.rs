//! Any bytes as a program, a called program, a table and a mask (byte 0x1C between them) are run within a small budget:
//! the run ends, and nothing is larger afterwards than the budget says.

#![no_main]

use std::sync::Arc;

use fitcheck::nc::machine::{Budget, Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::words::Dialogue;
use libfuzzer_sys::fuzz_target;

/// What a run may use.
const SMALL: Budget = Budget {
    blocks: 2_000,
    label_calls: 20,
    program_calls: 10,
    text: 255,
    windows: 20,
    outputs: 20,
    output_bytes: 10_000,
    cycles: 20,
    path: 500,
    files: 5,
    file_bytes: 100_000,
    traffic: 1_000_000,
    remarks: 50,
};

fuzz_target!(|bytes: &[u8]| {
    let Some((&flags, bytes)) = bytes.split_first() else { return };
    let mut parts = bytes.split(|byte| *byte == 0x1c);
    let mut part = || parts.next().unwrap_or_default();
    let main = part();
    let Ok((program, _)) = Program::read(main) else { return };
    let store = InMemory::new().with("main.h", main).with("sub.h", part()).with("own.tab", part()).with("m.a", part());
    let mut settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    settings.budget = SMALL;
    settings.skip_unknown = flags & 1 != 0;
    settings.block_skip = flags & 2 != 0;
    settings.optional_stop = flags & 4 != 0;
    let contacts = if flags & 8 == 0 { Contacts::Perfect } else { Contacts::Recorded(Vec::new()) };
    let mut machine = Machine::new(r"TNC:\main.h", Arc::new(program), store, contacts.clone(), settings);
    for _round in 0..2 {
        run(&mut machine);
        machine.restart(contacts.clone());
    }
});

fn run(machine: &mut Machine) {
    for number in 1..=2 {
        machine.set(Parameter::q(number), Value::Number(1.0)).expect("a number");
        machine.set(Parameter::qs(number), Value::Text("ab".to_owned())).expect("a text");
    }
    loop {
        match machine.run(100) {
            Ok(Step::Ended) => break,
            Ok(_) => {}
            Err(fault) => {
                assert!(!fault.to_string().is_empty());
                break;
            }
        }
    }
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
