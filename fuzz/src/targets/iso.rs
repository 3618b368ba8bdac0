//! Any bytes as an ISO program and one that it calls (byte 0x1C between them): what is read is written as it was, blocks follow each
//! other, warnings point into the text, and a run ends within a small budget, twice alike.

use fitcheck::nc::program::Notation;

use super::shared::{Source, halves};

pub fn run(bytes: &[u8]) {
    let (main, called) = halves(bytes);
    let source = Source { name: "A.i", text: &[b"%A G71 *\n", main].concat(), beside: ("B.i", called) };
    if let Some(program) = source.reads(Notation::Iso) {
        source.runs_twice_alike(program);
    }
}
