//! What targets have in common.

use fitcheck::message::Say;
use fitcheck::nc::machine::{Machine, Step};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

/// A time for everything that is given one.
pub const NOW: DateTime = DateTime::constant(2026, 3, 7, 8, 5, 9, 0);

/// Figures from the beginning of an input; zeros where it has ended.
pub struct Figures<'a>(pub &'a [u8]);

impl Figures<'_> {
    /// The next bytes.
    pub fn bytes<const N: usize>(&mut self) -> [u8; N] {
        std::array::from_fn(|_| match self.0.split_first() {
            Some((first, rest)) => {
                self.0 = rest;
                *first
            }
            None => 0,
        })
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let [byte] = self.bytes();
        byte
    }

    /// One of several.
    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[usize::from(self.byte()) % all.len()]
    }

    /// A whole number from zero to this one.
    pub fn up_to(&mut self, most: i64) -> i64 {
        i64::from_le_bytes(self.bytes()).rem_euclid(most + 1)
    }

    /// A whole number of two bytes.
    pub fn short(&mut self) -> i16 {
        i16::from_le_bytes(self.bytes())
    }
}

/// Runs a program to its end or to a fault; what is said of it has a sentence.
pub fn to_its_end(bytes: &[u8], machine: &mut Machine) {
    loop {
        match machine.run(100) {
            Ok(Step::Ended) => break,
            Ok(_) => {}
            Err(fault) => {
                told(bytes, &fault);
                break;
            }
        }
    }
    machine.remarks().iter().take(3).for_each(|(_, remark)| told(bytes, remark));
}

/// What went wrong has a sentence in every language. Sentences take far longer than reading, so one input in a hundred
/// or so has to make them.
pub fn told(bytes: &[u8], what: &impl Say) {
    thread_local! {
        static WORDS: Vec<Words> = Language::all().map(Words::new).collect();
    }
    if bytes.iter().fold(0_u8, |sum, byte| sum.wrapping_mul(31).wrapping_add(*byte)).is_multiple_of(128) {
        let message = what.message();
        WORDS.with(|words| {
            for language in words {
                let said = language.say(&message);
                assert!(!said.is_empty() && said != message.id, "{} has no text", message.id);
            }
        });
    }
}
