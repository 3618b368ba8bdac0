//! The words of a block: letters with a number, in any order, with or without blanks between them.

use super::super::block::Tool;
use super::super::cursor::{Cursor, Parsed, Stop};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::klartext::{MOST_M, tool};
use super::super::movement::{Axis, MachineFunction};
use super::super::operand::Operand;
use super::super::words::{AXES, meaning};

/// The words of a block that begins with neither of the signs that have readers of their own.
#[derive(Debug, Default)]
pub(super) struct Words<'a> {
    /// G functions, in order.
    pub functions: Vec<Function>,
    /// Axes, in order.
    pub axes: Vec<AxisAt>,
    /// The tool behind `T`.
    pub tool: Option<Tool>,
    pub values: Vec<Word<'a>>,
    /// M functions.
    pub machine: Vec<MachineFunction>,
    /// The first letter of every word and its place.
    letters: Vec<(char, usize)>,
}

/// A G function.
#[derive(Debug, Clone, Copy)]
pub(super) struct Function {
    pub number: u32,
    pub at: usize,
}

/// An axis, with a value except where axes are only named.
#[derive(Debug, Clone, Copy)]
pub(super) struct AxisAt {
    pub axis: Axis,
    pub value: Option<Operand>,
    pub at: usize,
}

/// `F500`, `DL+0.2`, `I-5`, `P01 3`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Word<'a> {
    pub name: &'static str,
    pub value: Operand,
    /// As written.
    pub text: &'a str,
}

/// Words of one number; the longer ones first.
const VALUES: [&str; 12] = ["DR2", "DL", "DR", "F", "S", "H", "R", "L", "I", "J", "K", "P"];

impl<'a> Words<'a> {
    /// Reads them all.
    pub(super) fn read(cursor: &mut Cursor<'a>) -> Parsed<Self> {
        let mut words = Self::default();
        while let Some(letter) = cursor.next() {
            let at = cursor.at();
            words.word(cursor, letter.to_ascii_uppercase(), at)?;
            words.letters.push((letter.to_ascii_uppercase(), at));
        }
        Ok(words)
    }

    fn word(&mut self, cursor: &mut Cursor<'a>, letter: char, at: usize) -> Parsed<()> {
        if let Some(axis) = meaning(&AXES, letter.encode_utf8(&mut [0; 4])) {
            cursor.take_prefix(letter.encode_utf8(&mut [0; 4]));
            if self.axes.iter().any(|known| known.axis == axis) {
                return Err(Stop { at, reason: BlockFault::AxisTwice });
            }
            let has_value = cursor.next().is_some_and(|c| c.is_ascii_digit() || "+-.,Qq".contains(c));
            let value = if has_value { Some(cursor.operand()?) } else { None };
            self.axes.push(AxisAt { axis, value, at });
            return Ok(());
        }
        match letter {
            'G' => {
                cursor.take_prefix("G");
                self.functions.push(Function { number: cursor.expect_whole(999)?, at });
            }
            'M' => {
                cursor.take_prefix("M");
                self.machine.push(machine_function(cursor)?);
            }
            'T' if self.tool.is_none() => {
                cursor.take_prefix("T");
                let Some(tool) = tool(cursor)? else { return Err(cursor.stop(ExpectedWord::Value)) };
                self.tool = Some(tool);
            }
            _ => {
                let Some(name) = VALUES.into_iter().find(|name| takes_value(cursor, name)) else {
                    return Err(cursor.unknown_word());
                };
                if name == "P" {
                    cursor.expect_whole(99)?;
                }
                let value = cursor.operand()?;
                if name != "P" && self.value(name).is_some() {
                    return Err(Stop { at, reason: BlockFault::NotTogether { one: name.into(), other: name.into() } });
                }
                self.values.push(Word { name, value, text: cursor.since(at) });
            }
        }
        Ok(())
    }

    /// The value of a word.
    pub(super) fn value(&self, name: &str) -> Option<Operand> {
        self.values.iter().find(|word| word.name == name).map(|word| word.value)
    }

    /// The G functions of a group; two of them exclude each other.
    pub(super) fn one_of(&self, group: impl Fn(u32) -> bool) -> Parsed<Option<Function>> {
        let mut found = self.functions.iter().filter(|function| group(function.number));
        match (found.next(), found.next()) {
            (Some(first), Some(second)) => {
                let reason = BlockFault::NotTogether { one: name(first.number), other: name(second.number) };
                Err(Stop { at: second.at, reason })
            }
            (first, _) => Ok(first.copied()),
        }
    }

    /// An error for the first word whose letter is not among these; G functions are checked by their groups.
    pub(super) fn only(&self, letters: &str) -> Parsed<()> {
        match self.letters.iter().find(|(letter, _)| *letter != 'G' && !letters.contains(*letter)) {
            Some(&(letter, at)) => Err(Stop { at, reason: BlockFault::LeftOver { found: letter.to_string() } }),
            None => Ok(()),
        }
    }

    /// Whether there are no words but those of these letters.
    pub(super) fn has_only(&self, letters: &str) -> bool {
        self.letters.iter().all(|(letter, _)| letters.contains(*letter))
    }

    /// The letters of the words, as a block without a G function is counted: `X Y`, `I J`.
    pub(super) fn shown(&self) -> String {
        let letters = self.letters.iter().filter(|(letter, _)| *letter != 'M');
        letters.map(|(letter, _)| letter.to_string()).collect::<Vec<_>>().join(" ")
    }
}

/// As a G function is counted: `G02`.
pub(super) fn name(number: u32) -> String {
    format!("G{number:02}")
}

/// Takes the letters of a word that a value follows: `DR2` is one with a sign or a parameter behind it.
fn takes_value(cursor: &mut Cursor<'_>, name: &str) -> bool {
    let mut ahead = cursor.clone();
    let is_next = ahead.take_prefix(name) && (name != "DR2" || ahead.next().is_some_and(|c| "+-Qq".contains(c)));
    if is_next {
        *cursor = ahead;
    }
    is_next
}

/// An M function, after the `M`. Words that follow it belong to it only where they are known to: a coordinate must not
/// pass for one.
fn machine_function(cursor: &mut Cursor<'_>) -> Parsed<MachineFunction> {
    let number = cursor.expect_whole(MOST_M)?;
    let at = cursor.at();
    match number {
        120 if cursor.take_prefix("LA") => drop(cursor.operand()?),
        128 if cursor.take_prefix("F") => drop(cursor.operand()?),
        138 => while AXES.iter().any(|(name, _)| cursor.take_word(name)) {},
        140 if cursor.take_prefix("MB") && !cursor.take_word("MAX") => drop(cursor.operand()?),
        _ => {}
    }
    Ok(MachineFunction { number, rest: cursor.since(at).to_owned() })
}
