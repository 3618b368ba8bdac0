//! Programs in Klartext: from text to blocks.
//!
//! | file | what |
//! |---|---|
//! | `blocks` | from lines to blocks |
//! | `cut_off` | lines that a missing or a surplus `~` has put into the wrong block |
//! | `understand` | from the lines of one block to what it says |
//! | `body`, `functions`, `moves`, `cycle`, `around` | the kinds of blocks, read |
//!
//! Grammar: manuals and public programs, see `docs/SOURCES.md`.

mod around;
mod blocks;
mod body;
mod cut_off;
mod cycle;
mod functions;
mod moves;
mod understand;

use super::block::Block;
use super::lines::Lines;
use super::warnings::Warnings;

/// Reads the blocks of a program.
pub(super) fn read(text: &str, lines: &Lines, warnings: &mut Warnings) -> Vec<Block> {
    blocks::Reader::new(text, lines, warnings).read()
}
