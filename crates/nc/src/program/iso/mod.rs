//! ISO programs of HEIDENHAIN milling controls (`.i`): from text to the blocks that Klartext gives.
//!
//! | file | what |
//! |---|---|
//! | `blocks` | from lines to blocks, as only ISO does it |
//! | `pieces` | block number, `*` and comment of a line |
//! | `understand` | from the lines of one block to what it says |
//! | `body` | the kinds of blocks by their first sign: programs, labels, formulas |
//! | `functions` | D functions |
//! | `words`, `codes`, `frames` | words of a block; G functions; changes of the system of coordinates |
//! | `g_block` | a block with its G functions by what they are about |
//! | `modes` | what stays in force from block to block: G90, G91 and the kind of path |
//!
//! Forms and how sure each of them is: `docs/SOURCES.md`, "ISO programs".

mod blocks;
mod body;
mod codes;
mod frames;
mod functions;
mod g_block;
mod modes;
mod pieces;
mod understand;
mod words;

use super::block::Block;
use super::lines::{Lines, trimmed};
use super::milling::Reader;
use super::source::Source;

/// Whether a text begins as an ISO program does: `%NAME G71 *` in its first line that is not a comment.
pub(super) fn begins(text: &str, lines: &Lines) -> bool {
    let codes = (0..lines.count()).map(|line| lines.line(text, line)).filter(|line| !trimmed(line).is_empty());
    let mut codes = codes.map(|line| pieces::piece(line, 0, pieces::front(line).end).0.code);
    codes.find(|code| !code.is_empty()).is_some_and(|code| body::frame(code).is_some())
}

/// Reads the blocks of a program.
pub(super) fn read(source: Source<'_>) -> Vec<Block> {
    let form = blocks::Iso::new(source.text());
    Reader::new(source, form).read()
}

/// The comment of a line, without the `;` before it and the `*` behind it.
pub(super) fn comment(line: &str) -> Option<&str> {
    pieces::piece(line, 0, pieces::front(line).end).0.comment
}

/// Where the code of a line begins: behind its number and skip mark, in bytes.
pub(super) fn front_end(line: &str) -> usize {
    pieces::front(line).end
}
