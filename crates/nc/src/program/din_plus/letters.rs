//! Blocks of address letters: `G1 X40 Z-30 F0.2 M8`. Several functions may stand in one block.

use fitcheck_core::probing::cycle::{Control, Cycle};
use fitcheck_core::probing::cycles::cycles_of;

use super::super::block::Body;
use super::super::cursor::{Cursor, Parsed, Stop};
use super::super::cycle_block::{CycleBlock, CycleLine, CycleName};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::place::TextPlace;
use super::motion::{self, tool};
use super::words::Words;

/// Reads a block.
pub(super) fn body(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let words = Words::read(cursor)?;
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
fn without_function(mut words: Words<'_>) -> Parsed<Body> {
    if let Some(word) = words.others.iter().find(|word| !["T", "S", "F"].contains(&word.letters)) {
        let is_axis = word.axis().is_ok_and(|axis| axis.is_some());
        // Whether G1 of an earlier block still holds is not documented.
        let missing = BlockFault::Missing(ExpectedWord::Word("G0 / G1"));
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

/// A measuring cycle with its letters; nothing else stands beside it.
fn probe(at: usize, cycle: &Cycle, words: Words<'_>) -> Parsed<CycleBlock> {
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
        let place = TextPlace { line: 0, column: word.at };
        let parameter = CycleName::Word(word.letters.to_owned());
        lines.push(CycleLine { parameter, value: word.value, place, comment: String::new() });
    }
    Ok(CycleBlock { number: cycle.code.to_owned(), name: String::new(), lines })
}
