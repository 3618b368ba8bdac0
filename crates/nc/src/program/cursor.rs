//! A place in the text of one block, which moves forward.
//!
//! Klartext is not read word by word: blanks may occur within a word (`X + 0`, `FN0 :`) and be missing between words
//! (`SIN-Q5`, `IX-QR4`). So every reader asks the cursor for what it expects, and the cursor skips blanks.

use fitcheck_core::text;

use super::fault::{BlockFault, ExpectedWord};
use super::notation::Notation;
use super::operand::{Operand, TextOperand};
use crate::control::variables::{Family, Parameter};

/// What was read, or why reading stopped.
pub(super) type Parsed<T> = Result<T, Stop>;

/// Where reading stopped, as bytes from the beginning of the block's text, and why.
#[derive(Debug)]
pub(super) struct Stop {
    pub at: usize,
    pub reason: BlockFault,
}

/// The place.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    text: &'a str,
    at: usize,
    notation: Notation,
}

/// How many characters of the text found an error repeats.
const SHOWN: usize = 24;

/// A text as an error repeats it.
pub(super) fn shown(text: &str) -> String {
    text.chars().take(SHOWN).collect()
}

/// The first word of a text, if it has one, as an error repeats it.
pub(super) fn first_word(text: &str) -> String {
    shown(text::first_word(text))
}

impl<'a> Cursor<'a> {
    /// At the beginning.
    pub(super) const fn new(text: &'a str) -> Self {
        Self::of(text, Notation::Klartext)
    }

    /// At the beginning of a text in this notation, which decides what is a parameter.
    pub(super) const fn of(text: &'a str, notation: Notation) -> Self {
        Self { text, at: 0, notation }
    }

    /// Whether the text is one of a lathe control.
    pub(super) fn is_of_lathes(&self) -> bool {
        self.notation == Notation::DinPlus
    }

    /// Where it is, in bytes.
    pub(super) const fn at(&self) -> usize {
        self.at
    }

    pub(super) fn rest(&self) -> &'a str {
        text::behind(self.text, self.at)
    }

    /// The text between a place and here, without blanks around it.
    pub(super) fn since(&self, at: usize) -> &'a str {
        text::part(self.text, at, self.at).trim()
    }

    /// Skips blanks.
    pub(super) fn blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    /// Whether only blanks are left.
    pub(super) fn is_at_end(&mut self) -> bool {
        self.blanks();
        self.text.len() <= self.at
    }

    /// The next character that is not a blank.
    pub(super) fn next(&mut self) -> Option<char> {
        self.blanks();
        self.rest().chars().next()
    }

    /// Takes characters as long as they pass a test, also blanks if the test allows them.
    pub(super) fn take_while(&mut self, test: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let end = rest.find(|c| !test(c)).unwrap_or(rest.len());
        self.at += end;
        text::before(rest, end)
    }

    /// Takes the rest, without blanks around it.
    pub(super) fn take_rest(&mut self) -> &'a str {
        let rest = self.rest();
        self.at = self.text.len();
        rest.trim()
    }

    /// Takes a sign such as `=`, if it is next.
    pub(super) fn take(&mut self, sign: char) -> bool {
        let is_next = self.next() == Some(sign);
        if is_next {
            self.at += sign.len_utf8();
        }
        is_next
    }

    /// Takes the beginning of a word, such as `DAT` of `DAT+Q5`, in any case.
    pub(super) fn take_prefix(&mut self, prefix: &str) -> bool {
        self.blanks();
        let is_next = self.rest().get(..prefix.len()).is_some_and(|next| next.eq_ignore_ascii_case(prefix));
        if is_next {
            self.at += prefix.len();
        }
        is_next
    }

    /// Takes a whole word, in any case: no letter follows it.
    pub(super) fn take_word(&mut self, word: &str) -> bool {
        let mut ahead = self.clone();
        let is_next = ahead.take_prefix(word) && !ahead.rest().starts_with(|c: char| c.is_alphabetic() || c == '_');
        if is_next {
            *self = ahead;
        }
        is_next
    }

    /// Takes several words, or none.
    pub(super) fn take_words(&mut self, words: &[&str]) -> bool {
        let mut ahead = self.clone();
        let are_next = words.iter().all(|word| ahead.take_word(word));
        if are_next {
            *self = ahead;
        }
        are_next
    }

    /// The letters that come next, without taking them.
    pub(super) fn letters(&mut self) -> &'a str {
        self.blanks();
        self.clone().take_while(|c| c.is_ascii_alphabetic())
    }

    /// Takes a sign or stops.
    pub(super) fn expect(&mut self, sign: char, wanted: &'static str) -> Parsed<()> {
        if self.take(sign) { Ok(()) } else { Err(self.stop(ExpectedWord::Word(wanted))) }
    }

    /// Takes a word or stops.
    pub(super) fn expect_word(&mut self, word: &'static str) -> Parsed<()> {
        if self.take_word(word) { Ok(()) } else { Err(self.stop(ExpectedWord::Word(word))) }
    }

    /// Stops if anything is left.
    pub(super) fn end(&mut self) -> Parsed<()> {
        if self.is_at_end() { Ok(()) } else { Err(self.fail(BlockFault::LeftOver { found: self.shown() })) }
    }

    /// The fault that something else is expected here.
    pub(super) fn stop(&mut self, wanted: ExpectedWord) -> Stop {
        let reason = if self.is_at_end() {
            BlockFault::Missing(wanted)
        } else {
            BlockFault::Unexpected { wanted, found: self.shown() }
        };
        self.fail(reason)
    }

    pub(super) const fn fail(&self, reason: BlockFault) -> Stop {
        Stop { at: self.at, reason }
    }

    /// The fault that a word is not known here.
    pub(super) fn unknown_word(&self) -> Stop {
        self.fail(BlockFault::UnknownWord { found: self.shown() })
    }

    /// The beginning of the rest, as an error repeats it.
    fn shown(&self) -> String {
        first_word(self.rest())
    }

    /// Takes the text of a number without sign: digits with at most one point or comma before, between or after them.
    pub(super) fn number_text(&mut self) -> Option<&'a str> {
        self.blanks();
        let mut ahead = self.clone();
        let from = ahead.at;
        let mut digits = ahead.take_while(|c| c.is_ascii_digit()).len();
        if ahead.rest().starts_with(['.', ',']) {
            ahead.at += 1;
            digits += ahead.take_while(|c| c.is_ascii_digit()).len();
        }
        if digits == 0 {
            return None;
        }
        *self = ahead;
        Some(self.since(from))
    }

    /// Takes a number without sign.
    pub(super) fn number(&mut self) -> Parsed<Option<f64>> {
        self.blanks();
        let from = self.clone();
        let Some(text) = self.number_text() else { return Ok(None) };
        let number = if text.contains(',') { text.replace(',', ".").parse() } else { text.parse::<f64>() };
        match number {
            Ok(number) if number.is_finite() => Ok(Some(number)),
            _ => Err(from.fail(BlockFault::NumberSize { found: from.shown() })),
        }
    }

    /// Takes a whole number without sign or stops.
    pub(super) fn expect_whole(&mut self, most: u32) -> Parsed<u32> {
        match self.whole(most)? {
            Some(number) => Ok(number),
            None => Err(self.stop(ExpectedWord::Number)),
        }
    }

    /// Takes a whole number without sign.
    pub(super) fn whole(&mut self, most: u32) -> Parsed<Option<u32>> {
        self.blanks();
        let from = self.clone();
        let digits = self.take_while(|c| c.is_ascii_digit());
        if digits.is_empty() {
            return Ok(None);
        }
        match digits.parse() {
            Ok(number) if number <= most => Ok(Some(number)),
            _ => Err(from.fail(BlockFault::Range { found: from.shown(), most })),
        }
    }

    /// Takes a parameter.
    pub(super) fn parameter(&mut self) -> Parsed<Option<Parameter>> {
        self.blanks();
        let mut ahead = self.clone();
        // The shortest last: `QS5` begins with the letter of `Q5`.
        let milling = [Family::Qs, Family::Ql, Family::Qr, Family::Q];
        let known = Family::ALL.into_iter().filter(|family| family.is_of_lathes() && self.is_of_lathes());
        let known = milling.into_iter().filter(|_| !self.is_of_lathes()).chain(known);
        let Some(family) = known.into_iter().find(|family| ahead.take_prefix(family.prefix())) else { return Ok(None) };
        let digits = ahead.take_while(|c| c.is_ascii_digit());
        if digits.is_empty() {
            return Ok(None);
        }
        let numbers = family.numbers();
        match digits.parse() {
            Ok(number) if numbers.contains(&number) => {
                *self = ahead;
                Ok(Some(Parameter { family, number }))
            }
            _ => {
                let (least, most) = numbers.into_inner();
                Err(self.fail(BlockFault::ParameterRange { found: self.shown(), family: family.prefix(), least, most }))
            }
        }
    }

    /// Takes a parameter of any family or stops.
    pub(super) fn any_parameter(&mut self) -> Parsed<Parameter> {
        self.parameter_of(ExpectedWord::Parameter, |_family| true)
    }

    /// Takes a number parameter or stops.
    pub(super) fn number_parameter(&mut self) -> Parsed<Parameter> {
        self.parameter_of(ExpectedWord::NumberParameter, |family| !family.is_text())
    }

    /// Takes a QS parameter or stops.
    pub(super) fn text_parameter(&mut self, wanted: ExpectedWord) -> Parsed<Parameter> {
        self.parameter_of(wanted, Family::is_text)
    }

    fn parameter_of(&mut self, wanted: ExpectedWord, test: impl Fn(Family) -> bool) -> Parsed<Parameter> {
        let mut from = self.clone();
        match self.parameter()? {
            Some(parameter) if test(parameter.family) => Ok(parameter),
            _ => Err(from.stop(wanted)),
        }
    }

    /// Takes `+` or `-`; returns whether it was a minus.
    pub(super) fn minus(&mut self) -> bool {
        let is_minus = self.take('-');
        if !is_minus {
            self.take('+');
        }
        is_minus
    }

    /// Takes a number or a Q, QL or QR parameter, with or without sign.
    pub(super) fn operand(&mut self) -> Parsed<Operand> {
        self.blanks();
        let from = self.clone();
        let is_negative = self.minus();
        if let Some(number) = self.number()? {
            return Ok(Operand::Number(if is_negative { -number } else { number }));
        }
        match self.parameter()? {
            Some(parameter) if !parameter.family.is_text() => Ok(Operand::Parameter { parameter, is_negative }),
            _ => Err(from.clone().stop(ExpectedWord::Value)),
        }
    }

    /// Takes a quoted text. The caller has checked that the quotes are closed.
    pub(super) fn quoted(&mut self) -> Option<&'a str> {
        self.blanks();
        let rest = self.rest().strip_prefix('"')?;
        let (text, _) = rest.split_once('"')?;
        self.at += text.len() + 2;
        Some(text)
    }

    /// Takes a path or the like up to a sign or the end: quoted, a QS parameter, or as written.
    pub(super) fn path(&mut self, until: Option<char>) -> Parsed<TextOperand> {
        if let Some(text) = self.quoted() {
            return Ok(TextOperand::Text(text.to_owned()));
        }
        self.blanks();
        let from = self.clone();
        let text = self.take_while(|c| Some(c) != until && c != '"').trim();
        if text.is_empty() {
            return Err(from.clone().stop(ExpectedWord::Path));
        }
        let name = text.strip_prefix(":'").and_then(|text| text.strip_suffix('\'')).unwrap_or(text);
        let mut name = Cursor::new(name);
        match name.parameter() {
            Ok(Some(parameter)) if parameter.family == Family::Qs && name.is_at_end() => {
                Ok(TextOperand::Parameter(parameter))
            }
            _ => Ok(TextOperand::Text(text.to_owned())),
        }
    }
}
