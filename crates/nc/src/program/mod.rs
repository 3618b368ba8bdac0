//! NC programs: read, shown and written back. Each notation has a reader of its own; all give the same blocks.
//!
//! | file | what |
//! |---|---|
//! | `block`, `cycle_block`, `around` | what a block says, that of a cycle; blocks around a measurement |
//! | `movement` | a straight line: axes, feed, M functions |
//! | `operand`, `expression` | numbers and texts, or what holds them; formulas |
//! | `place` | a place in the text |
//! | `point_probe` | cycles 0 and 1 |
//! | `read`, `warnings` | bytes to blocks, with warnings |
//! | `notation`, `klartext`, `iso`, `din_plus` | which notation it is; the readers |
//! | `milling` | what Klartext and ISO have in common |
//! | `source`, `lines`, `cursor` | the text while it is read; parts of lines; the place in a block's text that moves forward |
//! | `formula`, `text_formula` | formulas, read |
//! | `course` | which blocks may run before a block, and whether it runs |
//! | `labels`, `numbering` | where the labels are; block numbers that do not rise |
//! | `unread` | what a block that is not understood may do |
//! | `weight` | how much text becomes trees in memory |
//! | `words` | words of the language, for reading and writing |
//! | `error`, `fault` | errors and warnings |
//! | `write`, `write_formula` | from bodies to blocks, for new programs |
//!
//! A program keeps its text and is written byte for byte as it was read; a block is a range of its lines and what they
//! say. Unknown blocks are kept as text ([`Body::Other`]) and are never an error: real programs hold far more than
//! Fitcheck runs. Running is in `nc::machine`. Grammar: manuals and public programs, see `docs/SOURCES.md`.
//!
//! To add a notation:
//!
//! 1. Write its reader in a folder here. It makes the blocks of `block` and `around`, and shares `cursor`, `formula`, `labels`,
//!    `numbering` and `warnings` with the others.
//! 2. Add a variant to [`Notation`], recognise its text in `Notation::of`, and call the reader in `read.rs`. The compiler names the
//!    other places: comments (here), `unread.rs`, and `document.rs` and `tokens.rs` in `session/program`.
//! 3. Look at each place that asks for `Notation::DinPlus` alone (`cursor.rs`; `around/mod.rs`, `moves.rs` and `run/mod.rs` in `nc/machine`):
//!    the compiler does not name it.
//! 4. Add its endings to `OpenProgram` in `crates/session/src/purpose.rs`, and to `of_file` in `files/kinds.rs` there.
//! 5. Add a fuzz target as `iso` and `lathe` are (`fuzz/src/targets/mod.rs`), with a dictionary.
//! 6. Test it in `tests/core/programs`; `iso_like_klartext` runs the same measurement in two notations.
//!
//! To add a block:
//!
//! 1. Read it in `around.rs` or `frames.rs` of `klartext/`, in `body.rs`, `codes.rs` or `functions.rs` of `iso/`, or in `din_plus/`.
//! 2. If no measurement depends on it, make it a [`PassedOver`]: a run counts it by its first words. If a run must remember it, make it a
//!    variant of [`Body`] or [`Frame`], keep it in `nc/machine/around`, and report it in `Around::odd`.
//! 3. Add a new variant of [`Body`] to the lists in `write.rs` and `klartext/cut_off.rs`. A remark of a run needs no more: text, JSON and
//!    window show it.
//! 4. Say in `docs/SOURCES.md` ("Around a measurement") where the block comes from.

mod around;
mod block;
mod course;
mod cursor;
mod cycle_block;
mod din_plus;
mod error;
mod expression;
mod fault;
mod formula;
mod iso;
mod klartext;
mod labels;
mod lines;
mod milling;
mod movement;
mod notation;
mod numbering;
mod operand;
mod place;
mod point_probe;
mod read;
mod source;
mod text_formula;
mod unread;
mod warnings;
mod weight;
mod words;
pub mod write;
mod write_formula;

pub use around::{Frame, Goes, Mode, PassedOver};
pub use block::{Block, Body, Columns, Condition, FileFunction, SystemDatum, Target, Tool, Unit};
pub use course::Course;
pub use cycle_block::{CycleBlock, CycleLine, CycleName, CycleValue};
pub use error::{LabelFault, ProgramError, ProgramWarning, ProgramWarningKind};
pub use expression::{Expression, NumberFunction, Operation, Relation, Test, TextExpression};
pub use fault::{BlockFault, ExpectedWord};
pub use movement::{Axis, AxisWord, Feed, MachineFunction, Movement};
pub use notation::Notation;
pub use operand::{Operand, TextOperand};
pub use place::TextPlace;
pub use point_probe::PointProbe;
pub use unread::Unread;

use fitcheck_core::text;

/// A program: its text, and what its blocks say.
#[derive(Debug, Clone)]
pub struct Program {
    text: String,
    encoding: Encoding,
    lines: lines::Lines,
    notation: Notation,
    blocks: Vec<Block>,
    labels: labels::Labels,
    has_unit: bool,
}

impl Program {
    /// The blocks in the order of the text; every line that is not blank belongs to exactly one.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// How it is written.
    pub const fn notation(&self) -> Notation {
        self.notation
    }

    /// The name after `BEGIN PGM` or `%`, if there is one.
    pub fn name(&self) -> Option<&str> {
        self.begin().map(|(name, _)| name)
    }

    /// Whether the program says its unit. A subprogram of a lathe control in a file of its own does not: it counts in the unit
    /// of the program that calls it.
    pub const fn has_unit(&self) -> bool {
        self.has_unit
    }

    /// The unit after `BEGIN PGM`, in the head, or that of G70 and G71, if there is one.
    pub fn unit(&self) -> Option<Unit> {
        self.begin().map(|(_, unit)| unit)
    }

    fn begin(&self) -> Option<(&str, Unit)> {
        self.blocks.iter().find_map(|block| match &block.body {
            Body::Begin { name, unit } => Some((name.as_str(), *unit)),
            _ => None,
        })
    }

    /// The whole text, without a byte order mark.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// About how many bytes it takes in memory.
    pub const fn memory(&self) -> usize {
        self.text.len() + self.lines.count() * size_of::<(u32, u32)>() + self.blocks.len() * size_of::<Block>()
    }

    /// How many lines the text has.
    pub const fn line_count(&self) -> usize {
        self.lines.count()
    }

    /// A line as written, counted from 0; empty beyond the last.
    pub fn line(&self, line: usize) -> &str {
        self.lines.line(&self.text, line)
    }

    /// The lines of a block as written; none beyond the last block.
    pub fn text_of(&self, block: usize) -> impl Iterator<Item = &str> {
        let lines = self.blocks.get(block).map_or(0..0, |block| block.lines.clone());
        lines.map(|line| self.line(line))
    }

    /// The first line of a block as written; empty beyond the last block.
    pub fn first_line_of(&self, block: usize) -> &str {
        self.blocks.get(block).map_or("", |block| self.line(block.lines.start))
    }

    /// The comment of a block, if there is one: that of its first line, without the signs around it.
    pub fn comment_of(&self, block: usize) -> Option<&str> {
        let line = self.blocks.get(block)?.lines.start;
        let text = self.line(line);
        match self.notation {
            Notation::Klartext => lines::first(text, line, lines::front(text).end).comment,
            Notation::Iso => iso::comment(text),
            Notation::DinPlus => din_plus::comment(text),
        }
    }

    /// The block that a line belongs to, counted from 0; `None` for blank lines between blocks.
    pub fn block_at(&self, line: usize) -> Option<usize> {
        let behind = self.blocks.partition_point(|block| block.lines.start <= line);
        let index = behind.checked_sub(1)?;
        self.blocks.get(index).filter(|block| block.lines.contains(&line)).map(|_| index)
    }

    /// The block of a label.
    ///
    /// # Errors
    /// [`LabelFault`] if there is none or more than one, or if the label is 0 or a parameter.
    pub fn label(&self, label: &Target) -> Result<usize, LabelFault> {
        self.labels.block(label)
    }

    /// The program as a file, byte for byte as it was read.
    pub fn write(&self) -> Vec<u8> {
        self.encoding.encode(&self.text)
    }
}

/// How the text of a file is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Encoding {
    Utf8,
    Utf8WithMark,
    Windows1252,
}

/// The mark at the beginning of some files in UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

impl Encoding {
    fn decode(bytes: &[u8]) -> (String, Self) {
        let (rest, utf8) = match bytes.strip_prefix(MARK) {
            Some(rest) => (rest, Self::Utf8WithMark),
            None => (bytes, Self::Utf8),
        };
        match std::str::from_utf8(rest) {
            Ok(text) => (text.to_owned(), utf8),
            // In this case the mark is three ordinary characters.
            Err(_not_utf8) => (text::windows_1252(bytes), Self::Windows1252),
        }
    }

    fn encode(self, text: &str) -> Vec<u8> {
        match self {
            Self::Utf8 => text.as_bytes().to_vec(),
            Self::Utf8WithMark => [MARK, text.as_bytes()].concat(),
            // Every byte has its character, so none is lost on the way back.
            Self::Windows1252 => encoding_rs::WINDOWS_1252.encode(text).0.into_owned(),
        }
    }
}
