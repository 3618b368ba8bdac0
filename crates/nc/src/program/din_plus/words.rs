//! The words of a block of address letters: `X40`, `Zi-30`, `M8`.

use super::super::cursor::{Cursor, Parsed, Stop, shown};
use super::super::cycle_block::CycleValue;
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::movement::{Axis, AxisWord, MachineFunction};
use super::super::operand::{Operand, TextOperand};
use super::language::{MOST, STARTS_AGAIN};

/// A letter with its value, and where it stands.
#[derive(Debug)]
pub(super) struct Word<'a> {
    pub at: usize,
    pub letters: &'a str,
    /// Whether an `i` follows the letters: the value counts from where the axis is.
    pub is_incremental: bool,
    pub value: CycleValue,
}

impl Word<'_> {
    /// What is wrong with it.
    pub(super) const fn fail(&self, reason: BlockFault) -> Stop {
        Stop { at: self.at, reason }
    }

    /// As an error names it.
    pub(super) fn shown(&self) -> String {
        let value = match &self.value {
            CycleValue::Number { text, .. } => text.as_str(),
            CycleValue::Text(_) | CycleValue::Word(_) => "",
        };
        let sign = if self.is_incremental { "i" } else { "" };
        shown(&format!("{}{sign}{value}", self.letters))
    }

    /// The number behind it.
    pub(super) fn operand(&self) -> Parsed<Operand> {
        match self.value {
            CycleValue::Number { value, .. } => Ok(value),
            CycleValue::Text(_) | CycleValue::Word(_) => {
                Err(self.fail(BlockFault::Missing(ExpectedWord::ValueOrVariable)))
            }
        }
    }

    /// The axis that it moves, if it is one.
    pub(super) fn axis(&self) -> Parsed<Option<AxisWord>> {
        let axis = match self.letters {
            "X" => Axis::X,
            "Y" => Axis::Y,
            "Z" => Axis::Z,
            _ => return Ok(None),
        };
        Ok(Some(AxisWord { axis, is_incremental: self.is_incremental, value: self.operand()? }))
    }
}

/// The words of a block.
#[derive(Debug, Default)]
pub(super) struct Words<'a> {
    /// G functions with their places.
    pub functions: Vec<(usize, u32)>,
    pub machine: Vec<MachineFunction>,
    /// The others, each letter once.
    pub others: Vec<Word<'a>>,
}

impl<'a> Words<'a> {
    /// Takes all words.
    pub(super) fn read(cursor: &mut Cursor<'a>) -> Parsed<Self> {
        let mut found = Self::default();
        while !cursor.is_at_end() {
            let from = cursor.clone();
            let letters = cursor.take_while(|c| c.is_ascii_uppercase());
            match letters {
                "" => return Err(from.unknown_word()),
                "G" => {
                    let number = cursor.expect_whole(MOST)?;
                    found.functions.push((from.at(), number));
                }
                "M" => {
                    let number = cursor.expect_whole(MOST)?;
                    if number == STARTS_AGAIN {
                        return Err(from.unknown_word());
                    }
                    found.machine.push(MachineFunction { number, rest: String::new() });
                }
                letters => {
                    if found.named(letters).is_some() {
                        return Err(from.fail(BlockFault::LetterTwice { letters: shown(letters) }));
                    }
                    let is_incremental = cursor.take_while(|c| c == 'i').len();
                    if 1 < is_incremental {
                        return Err(from.unknown_word());
                    }
                    let value = value(cursor)?;
                    found.others.push(Word { at: from.at(), letters, is_incremental: is_incremental == 1, value });
                }
            }
        }
        Ok(found)
    }

    /// The word with these letters.
    pub(super) fn named(&self, letters: &str) -> Option<&Word<'a>> {
        self.others.iter().find(|word| word.letters == letters)
    }
}

/// A number, a variable or a quoted text.
fn value(cursor: &mut Cursor<'_>) -> Parsed<CycleValue> {
    if let Some(text) = cursor.quoted() {
        return Ok(CycleValue::Text(TextOperand::Text(text.to_owned())));
    }
    let from = cursor.at();
    let value = cursor.operand()?;
    let text = cursor.since(from).chars().filter(|c| !c.is_whitespace()).collect();
    Ok(CycleValue::Number { value, text })
}
