//! G functions: motion, feed and speed; and tools.

use super::super::around::{Goes, PassedOver};
use super::super::block::{Body, Tool};
use super::super::cursor::{Parsed, Stop};
use super::super::fault::BlockFault;
use super::super::movement::{AxisWord, Feed, MachineFunction, Movement};
use super::language::{Function, STOPS, function};
use super::words::{Word, Words};

/// A block that moves nothing and changes nothing that a measurement depends on.
pub(super) fn passed_over(words: String, machine: Vec<MachineFunction>) -> Body {
    Body::PassedOver(PassedOver { words, goes: Goes::default(), machine })
}

/// `T8 M5`: the tool. A tool call has no M functions here, so those that stop or end are refused beside it.
pub(super) fn tool(words: &Words<'_>) -> Parsed<Body> {
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

/// A block with G functions; `None` without any.
pub(super) fn body(words: &Words<'_>) -> Parsed<Option<Body>> {
    let Some((number, function)) = leading(words)? else { return Ok(None) };
    let mut axes = Vec::new();
    for word in &words.others {
        if !function.letters().contains(&word.letters) && !["S", "F"].contains(&word.letters) {
            return Err(word.fail(BlockFault::UnknownWord { found: word.shown() }));
        }
        axes.extend(word.axis()?);
    }
    let machine = words.machine.clone();
    let name = format!("G{number}");
    Ok(Some(match function {
        Function::Rapid | Function::Line => line(function, axes, words)?,
        Function::Arc => Body::PassedOver(PassedOver { words: name, goes: Goes { is_unknown: false, axes }, machine }),
        Function::ChangePoint => {
            Body::PassedOver(PassedOver { words: name, goes: Goes { is_unknown: true, axes }, machine })
        }
        Function::Setting if words.named("T").is_some() => tool(words)?,
        Function::Setting => passed_over(name, machine),
        Function::ReadNoFurther => match machine.first() {
            Some(other) => {
                let other = format!("M{}", other.number);
                return Err(Stop { at: 0, reason: BlockFault::NotTogether { one: name, other } });
            }
            None => Body::ReadNoFurther,
        },
    }))
}

/// The function that decides what the block is: feed and speed may stand beside any other, and only they.
fn leading(words: &Words<'_>) -> Parsed<Option<(u32, Function)>> {
    let mut leading: Option<(u32, Function)> = None;
    for &(at, number) in &words.functions {
        let fail = |reason| Stop { at, reason };
        let name = || format!("G{number}");
        let known = function(number).ok_or_else(|| fail(BlockFault::UnknownWord { found: name() }))?;
        leading = match leading {
            None | Some((_, Function::Setting)) => Some((number, known)),
            Some(first) if known == Function::Setting => Some(first),
            Some((first, _)) => {
                return Err(fail(BlockFault::NotTogether { one: format!("G{first}"), other: name() }));
            }
        };
    }
    Ok(leading)
}

fn line(function: Function, axes: Vec<AxisWord>, words: &Words<'_>) -> Parsed<Body> {
    let feed = match (function, words.named("F")) {
        (Function::Rapid, _) => Some(Feed::Rapid),
        (_, Some(feed)) => Some(Feed::Value(feed.operand()?)),
        (_, None) => None,
    };
    Ok(Body::Move(Movement { axes, compensation: None, feed, machine: words.machine.clone() }))
}
