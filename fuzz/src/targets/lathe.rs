//! Any bytes as a program of a lathe control and a subprogram in a file of its own (byte 0x1C between them): what is read is
//! written as it was, every line belongs to one block, warnings point into the text, and a run ends within a small budget, twice
//! alike.

use std::sync::Arc;

use fitcheck::nc::machine::{Budget, Contacts, InMemory, Machine, Settings};
use fitcheck::nc::program::{Body, Notation, Program};
use fitcheck::words::Dialogue;

use super::shared::{NOW, to_its_end, told};

/// What a run may use.
const MOST_BLOCKS: u64 = 2_000;

pub fn run(bytes: &[u8]) {
    let (main, subprogram) = bytes.split_at(bytes.iter().position(|byte| *byte == 0x1c).unwrap_or(bytes.len()));
    let text = [b"%A.nc\n", main].concat();
    let Ok((program, warnings)) = Program::read(&text) else { return };
    assert_eq!(program.write(), text);
    // A unit behind the name makes it ISO.
    if program.notation() != Notation::DinPlus {
        return;
    }
    for warning in warnings {
        assert!(warning.place.line.is_some_and(|line| line <= program.line_count()));
        told(bytes, &warning);
    }
    let mut behind = 0;
    for block in program.blocks() {
        assert!(behind <= block.lines.start && block.lines.len() == 1);
        behind = block.lines.end;
        // A branch whose end is missing is refused, so every one leads to a block or behind the last.
        if let Body::Branch { to, .. } | Body::Subprogram { behind: to, .. } = &block.body {
            assert!(*to <= program.blocks().len());
        }
    }
    let budget = Budget {
        blocks: MOST_BLOCKS,
        windows: 20,
        output_bytes: 10_000,
        cycles: 20,
        path: 500,
        remarks: 50,
        ..Budget::default()
    };
    let mut settings = Settings::new(Dialogue::En, NOW);
    settings.budget = budget;
    settings.skip_unknown = bytes.len() % 2 == 1;
    let store = InMemory::new().with("B.ncs", subprogram);
    let mut machine = Machine::new("A.nc", Arc::new(program), store, Contacts::Perfect, settings);
    let first = to_the_end(bytes, &mut machine);
    machine.restart(Contacts::Perfect);
    assert_eq!(to_the_end(bytes, &mut machine), first, "a second run does something else");
}

fn to_the_end(bytes: &[u8], machine: &mut Machine) -> String {
    to_its_end(bytes, machine);
    assert!(machine.is_over() && machine.blocks_run() <= MOST_BLOCKS);
    format!("{:?} {:?} {}", machine.variables(), machine.windows(), machine.blocks_run())
}
