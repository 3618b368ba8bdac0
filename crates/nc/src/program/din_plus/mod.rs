//! Programs in DIN PLUS of HEIDENHAIN lathe controls (`MANUALplus` 620, CNC PILOT 640): from text to blocks.
//!
//! | file | what |
//! |---|---|
//! | `language` | sections, G functions and letters: what each is, in one place |
//! | `line` | a line's number, code and comment |
//! | `blocks` | from lines to blocks, section by section |
//! | `branches` | IF, WHILE, SWITCH and subprograms: which block comes next |
//! | `statement`, `condition` | blocks that begin with a word of the language or a variable |
//! | `letters`, `words`, `motion` | blocks of address letters, `G1 X40 Z-30 F0.2`; their words; their G functions and tools |
//!
//! Only a part of the language is documented in public; what is ours in it is in `docs/SOURCES.md`, "DIN PLUS". Anything beyond
//! is kept as text with a warning, so that no run goes past it in silence.

mod blocks;
mod branches;
mod condition;
mod language;
mod letters;
mod line;
mod motion;
mod statement;
mod words;

use super::block::Block;
use super::lines::{Lines, trimmed};
use super::source::Source;

/// Reads the blocks of a program.
pub(super) fn read(source: Source<'_>) -> (Vec<Block>, bool) {
    blocks::Reader::new(source).read()
}

/// The comment of a line, without its brackets.
pub(super) fn comment(text: &str) -> Option<&str> {
    line::Line::of(text).ok()?.comment
}

/// Whether a text is written so: it begins with `%NAME.nc`, or with `%NAME` that does not go on with `G71` and has a section
/// behind it, or with a section that only these programs begin with.
pub(super) fn is_written_so(text: &str, lines: &Lines) -> bool {
    let mut said = (0..lines.count()).map(|line| trimmed(lines.line(text, line)));
    let Some(first) = said.find(|line| !line.is_empty() && !line.starts_with('[')) else { return false };
    let Some(named) = first.strip_prefix('%') else { return language::begins_programs(first) };
    let (name, rest) = named.trim_start().split_once(char::is_whitespace).unwrap_or((named, ""));
    let is_iso = rest.split_whitespace().any(|word| ["G70", "G71"].iter().any(|unit| word.eq_ignore_ascii_case(unit)));
    if is_iso {
        return false;
    }
    let name = name.to_ascii_lowercase();
    name.ends_with(language::MAIN) || name.ends_with(language::SUBPROGRAM) || said.any(language::begins_programs)
}
