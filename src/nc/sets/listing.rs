//! Blocks with their numbers, as a control writes them: from 0, padded to two characters, CRLF (`docs/SOURCES.md`).

use crate::length::Length;

/// A program that is being written.
#[derive(Debug)]
pub(super) struct Listing {
    name: String,
    blocks: Vec<String>,
}

impl Listing {
    /// A program of a name; `BEGIN PGM` stands there already.
    pub(super) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), blocks: vec![format!("BEGIN PGM {name} MM ")] }
    }

    /// One more block; lines behind the first belong to it.
    pub(super) fn push(&mut self, block: impl Into<String>) {
        self.blocks.push(block.into());
    }

    /// More blocks.
    pub(super) fn extend(&mut self, blocks: impl IntoIterator<Item = String>) {
        self.blocks.extend(blocks);
    }

    /// The program as a file, `END PGM` last. All of it is ASCII, since names and texts are.
    pub(super) fn bytes(mut self) -> Vec<u8> {
        self.blocks.push(format!("END PGM {} MM ", self.name));
        let blocks = self.blocks.iter().enumerate();
        let lines = blocks.map(|(number, block)| format!("{number:<2} {}\r\n", block.replace('\n', "\r\n")));
        lines.collect::<Vec<_>>().concat().into_bytes()
    }
}

/// A length as a formula has it: a negative one with a blank behind its sign, as the control writes it.
pub(super) fn formula_number(length: Length) -> String {
    let size = length.abs();
    if length < Length::ZERO { format!("- {size}") } else { size.to_string() }
}
