//! Programs in Klartext: from text to blocks.
//!
//! | file | what |
//! |---|---|
//! | `blocks` | from lines to blocks, as only Klartext does it |
//! | `cut_off` | lines that a surplus `~` has put into the wrong block |
//! | `understand` | from the lines of one block to what it says |
//! | `body`, `functions`, `label`, `moves`, `around` | the kinds of blocks, read |
//! | `frames` | changes of the system that coordinates count in |
//! | `path_words` | axes with their values, and M functions |
//!
//! Grammar: manuals and public programs, see `docs/SOURCES.md`.

mod around;
mod blocks;
mod body;
mod cut_off;
mod frames;
mod functions;
mod label;
mod moves;
mod path_words;
mod understand;

use super::block::Block;
use super::milling::Reader;
use super::source::Source;

// What other notations have in common with Klartext.
pub(super) use around::defined;
pub(super) use functions::{assignment, print, system_datum};
pub(super) use label::{MOST_REPEATS, number as label_number};
pub(super) use moves::tool;
pub(super) use path_words::{MOST_M, axis};
pub(super) use understand::heading;

/// Reads the blocks of a program.
pub(super) fn read(source: Source<'_>) -> Vec<Block> {
    Reader::new(source, blocks::Klartext::default()).read()
}
