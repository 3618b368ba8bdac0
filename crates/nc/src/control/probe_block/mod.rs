//! One block of a probing cycle in an NC program: `TCH PROBE 427 …` of a milling control, `G785 …` of a lathe.
//!
//! | file | what |
//! |---|---|
//! | `read` | a block as pairs of name and text |
//! | `write` | the block of a cycle's inputs, from its declaration |
//! | `fault` | what is wrong with a block |
//!
//! A reader goes by the numbers and order of characters, never by names and comments, which follow the dialogue
//! language. Grammar and layout: the examples in the manuals of G785 and cycle 427. Nothing here runs a program: a
//! value that is a Q parameter stays a text.

mod fault;
mod read;
mod write;

pub use fault::{ProbeBlockError, ProbeBlockFault};
pub use read::{beginnings, read, read_at, read_or_lines};
pub use write::write;

use fitcheck_core::message::{Message, Say, display};
use fitcheck_core::probing::cycle::{Cycle, Inputs};
use fitcheck_core::text::cut;

/// A block as read: the cycle and its parameters as texts.
#[derive(Debug, Clone)]
pub struct ProbeBlock {
    /// The line that it begins on, from 1.
    pub line: usize,
    pub cycle: &'static Cycle,
    /// Its parameters in the order of the block.
    pub settings: Vec<Setting>,
    /// The first skipped line that is not part of any block, if there is one.
    pub unused: Option<Unused>,
}

/// A parameter of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// Its line, from 1.
    pub line: usize,
    /// Its name as written: `Q263`, `QS400`, `BR`.
    pub key: String,
    /// Its value as written, without quotation marks: `+35`, `PREDEF`, `+Q1`.
    pub text: String,
}

/// Lines of a program outside the block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unused {
    /// The first of them, from 1.
    pub line: usize,
    pub text: String,
    /// How many more there are.
    pub more: usize,
}

display!(Unused);

impl Say for Unused {
    fn message(&self) -> Message {
        let id = if self.more == 0 { "block-unused" } else { "block-unused-more" };
        let message = Message::new(id).text("line", self.line).text("text", &self.text);
        if self.more == 0 { message } else { message.text("more", self.more) }
    }
}

impl ProbeBlock {
    /// Puts the block's values into inputs; ranges are checked when the cycle runs.
    ///
    /// # Errors
    /// [`ProbeBlockError`] with the line of a parameter that the cycle does not have, or of a text that is not a value.
    pub fn put_into(&self, inputs: Inputs) -> Result<Inputs, ProbeBlockError> {
        self.settings.iter().try_fold(inputs, |inputs, Setting { line, key, text }| {
            let fault = match self.cycle.set(inputs, key, text) {
                Ok(inputs) => return Ok(inputs),
                Err(_) if is_reference(text) => ProbeBlockFault::Reference {
                    key: key.clone(),
                    given: text.trim_start_matches(['+', '-']).to_owned(),
                },
                Err(error) => ProbeBlockFault::Cycle(Box::new(error)),
            };
            Err(fault.at(*line))
        })
    }
}

/// Whether a text is a parameter of a program, `+Q1`, `QS12`, `-QL3`.
fn is_reference(text: &str) -> bool {
    let bare = text.trim().trim_start_matches(['+', '-']).trim_start().to_ascii_uppercase();
    bare.strip_prefix('Q').is_some_and(|rest| {
        let number = rest.trim_start_matches(['L', 'R', 'S']);
        rest.len() <= number.len() + 1 && !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    })
}

/// A piece of the text as errors show it: no longer than a line of a program.
fn shown(text: &str) -> String {
    cut(text, 80).replace(char::is_control, "\u{fffd}")
}
