//! Any bytes as a program of a lathe control and a subprogram in a file of its own (byte 0x1C between them): what is read is
//! written as it was, every line belongs to one block, warnings point into the text, and a run ends within a small budget, twice
//! alike.

use fitcheck::nc::program::{Body, Notation};

use super::shared::{Source, halves};

pub fn run(bytes: &[u8]) {
    let (main, subprogram) = halves(bytes);
    let source = Source { name: "A.nc", text: &[b"%A.nc\n", main].concat(), beside: ("B.ncs", subprogram) };
    let Some(program) = source.reads(Notation::DinPlus) else { return };
    for block in program.blocks() {
        assert_eq!(block.lines.len(), 1);
        // A branch whose end is missing is refused, so every one leads to a block or behind the last.
        if let Body::Branch { to, .. } | Body::Subprogram { behind: to, .. } = &block.body {
            assert!(*to <= program.blocks().len());
        }
    }
    source.runs_twice_alike(program);
}
