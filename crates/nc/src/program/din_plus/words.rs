//! Blocks of address letters: `G1 X40 Z-30 F0.2 M8`. Several functions may stand in one block.

use fitcheck_core::probing::cycle::{Control, Cycle};
use fitcheck_core::probing::cycles::cycles_of;

use super::super::block::{Body, Tool};
use super::super::cursor::{Cursor, Read, Stop};
use super::super::cycle_block::{CycleBlock, CycleLine, CycleName, CycleValue};
use super::super::fault::{BlockFault, Wanted};
use super::super::movement::{Axis, AxisWord, MachineFunction};
use super::super::operand::{Operand, TextOperand};
use super::super::place::Place;
use super::language::{MOST, STARTS_AGAIN, STOPS};
use super::motion;

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
        format!("{}{sign}{value}", self.letters).chars().take(24).collect()
    }

    /// The number behind it.
    pub(super) fn operand(&self) -> Read<Operand> {
        match self.value {
            CycleValue::Number { value, .. } => Ok(value),
            CycleValue::Text(_) | CycleValue::Word(_) => Err(self.fail(BlockFault::Missing(Wanted::ValueOrVariable))),
        }
    }

    /// The axis that it moves, if it is one.
    pub(super) fn axis(&self) -> Read<Option<AxisWord>> {
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
    /// The word with these letters.
    pub(super) fn named(&self, letters: &str) -> Option<&Word<'a>> {
        self.others.iter().find(|word| word.letters == letters)
    }
}

/// Reads a block.
pub(super) fn body(cursor: &mut Cursor<'_>) -> Read<Body> {
    let words = words(cursor)?;
    let cycle = words.functions.iter().find_map(|&(at, number)| {
        let code = format!("G{number}");
        cycles_of(Control::Lathe).find(|cycle| cycle.code == code).map(|cycle| (at, cycle))
    });
    match cycle {
        Some((at, cycle)) => probe(at, cycle, words).map(Body::Probe),
        None => match motion::body(&words)? {
            Some(body) => Ok(body),
            None => without_function(words),
        },
    }
}

/// A block without a G function: a tool, M functions, feed and speed.
fn without_function(mut words: Words<'_>) -> Read<Body> {
    if let Some(word) = words.others.iter().find(|word| !["T", "S", "F"].contains(&word.letters)) {
        let is_axis = word.axis().is_ok_and(|axis| axis.is_some());
        // Whether G1 of an earlier block still holds is not documented.
        let missing = BlockFault::Missing(Wanted::Word("G0 / G1"));
        return Err(word.fail(if is_axis { missing } else { BlockFault::UnknownWord { found: word.shown() } }));
    }
    if words.named("T").is_some() {
        return tool(&words);
    }
    if words.others.is_empty() {
        return Ok(Body::MachineFunctions(std::mem::take(&mut words.machine)));
    }
    let first = words.others.first().map_or("", |word| word.letters);
    Ok(motion::passed_over(first.to_owned(), std::mem::take(&mut words.machine)))
}

/// `T8 M5`: the tool. A tool call has no M functions here, so those that stop or end are refused beside it.
pub(super) fn tool(words: &Words<'_>) -> Read<Body> {
    let Some(word) = words.named("T") else { return Ok(Body::Nothing) };
    if let Some(stop) = words.machine.iter().find(|function| STOPS.contains(&function.number)) {
        return Err(word.fail(BlockFault::NotTogether { one: word.shown(), other: format!("M{}", stop.number) }));
    }
    let others = words.others.iter().filter(|word| word.letters != "T").map(Word::shown);
    let functions = words.functions.iter().map(|(_, number)| format!("G{number}"));
    let machine = words.machine.iter().map(|function| format!("M{}", function.number));
    let rest: Vec<String> = functions.chain(others).chain(machine).collect();
    Ok(Body::ToolCall { tool: Some(Tool::Number(word.operand()?)), axis: None, rest: rest.join(" ") })
}

/// A measuring cycle with its letters; nothing else stands beside it.
fn probe(at: usize, cycle: &Cycle, words: Words<'_>) -> Read<CycleBlock> {
    let together = |other: String| BlockFault::NotTogether { one: cycle.code.to_owned(), other };
    if let Some((_, other)) = words.functions.iter().find(|(place, _)| *place != at) {
        return Err(Stop { at, reason: together(format!("G{other}")) });
    }
    if let Some(function) = words.machine.first() {
        return Err(Stop { at, reason: together(format!("M{}", function.number)) });
    }
    let mut lines = Vec::new();
    for word in words.others {
        if word.is_incremental || cycle.parameter_named(word.letters).is_none() {
            return Err(word.fail(BlockFault::UnknownWord { found: word.shown() }));
        }
        // The reader of lines turns this into the place in the file.
        let place = Place { line: 0, column: word.at };
        let parameter = CycleName::Word(word.letters.to_owned());
        lines.push(CycleLine { parameter, value: word.value, place, comment: String::new() });
    }
    Ok(CycleBlock { number: cycle.code.to_owned(), name: String::new(), lines })
}

/// Takes all words.
fn words<'a>(cursor: &mut Cursor<'a>) -> Read<Words<'a>> {
    let mut found = Words::default();
    while !cursor.is_at_end() {
        let from = cursor.clone();
        let letters = cursor.take_while(|c| c.is_ascii_uppercase());
        match letters {
            "" => return Err(unknown(&from)),
            "G" => {
                let number = cursor.expect_whole(MOST)?;
                found.functions.push((from.at(), number));
            }
            "M" => {
                let number = cursor.expect_whole(MOST)?;
                if number == STARTS_AGAIN {
                    return Err(unknown(&from));
                }
                found.machine.push(MachineFunction { number, rest: String::new() });
            }
            letters => {
                if found.named(letters).is_some() {
                    return Err(from.fail(BlockFault::LetterTwice { letters: letters.chars().take(24).collect() }));
                }
                let is_incremental = cursor.take_while(|c| c == 'i').len();
                if 1 < is_incremental {
                    return Err(unknown(&from));
                }
                let value = value(cursor)?;
                found.others.push(Word { at: from.at(), letters, is_incremental: is_incremental == 1, value });
            }
        }
    }
    Ok(found)
}

fn unknown(from: &Cursor<'_>) -> Stop {
    let found = from.rest().split_whitespace().next().unwrap_or_default().chars().take(24).collect();
    from.fail(BlockFault::UnknownWord { found })
}

/// A number, a variable or a quoted text.
fn value(cursor: &mut Cursor<'_>) -> Read<CycleValue> {
    if let Some(text) = cursor.quoted() {
        return Ok(CycleValue::Text(TextOperand::Text(text.to_owned())));
    }
    let from = cursor.at();
    let value = cursor.operand()?;
    let text = cursor.since(from).chars().filter(|c| !c.is_whitespace()).collect();
    Ok(CycleValue::Number { value, text })
}
