//! Straight lines and tool calls.

use super::super::block::{Body, Tool};
use super::super::cursor::{Cursor, Parsed, Stop, first_word};
use super::super::fault::BlockFault;
use super::super::movement::{Feed, Movement};
use super::super::operand::{Operand, TextOperand};
use super::super::words::{AXES, COMPENSATIONS};
use super::path_words::{axis_letter, axis_word, machine_functions};
use crate::control::variables::Family;

/// `L …`, after the word.
pub(super) fn line(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let mut movement = Movement { axes: Vec::new(), compensation: None, feed: None, machine: Vec::new() };
    loop {
        cursor.blanks();
        let at = cursor.at();
        if let Some(word) = axis_word(cursor)? {
            if movement.axes.iter().any(|known| known.axis == word.axis) {
                return Err(Stop { at, reason: BlockFault::AxisTwice });
            }
            movement.axes.push(word);
        } else if let Some(word) = COMPENSATIONS.into_iter().find(|word| cursor.take_word(word)) {
            movement.compensation = Some(word.to_owned());
        } else if let Some(found) = speed(cursor) {
            return Err(Stop { at, reason: BlockFault::SpeedInMove { found } });
        } else if movement.feed.is_none() && cursor.take_prefix("F") {
            movement.feed = Some(feed(cursor)?);
        } else {
            movement.machine.append(&mut machine_functions(cursor)?);
            if cursor.is_at_end() {
                return Ok(Body::Move(movement));
            }
        }
    }
}

/// `S6000`, as other controls have it here.
fn speed(cursor: &Cursor<'_>) -> Option<String> {
    let mut ahead = cursor.clone();
    let is_speed = ahead.take_prefix("S") && ahead.next().is_some_and(|c| c.is_ascii_digit() || "+Qq".contains(c));
    is_speed.then(|| first_word(cursor.rest()))
}

/// The value after the F.
fn feed(cursor: &mut Cursor<'_>) -> Parsed<Feed> {
    if cursor.take_word("MAX") {
        return Ok(Feed::Rapid);
    }
    if cursor.take_word("AUTO") {
        return Ok(Feed::Auto);
    }
    Ok(Feed::Value(cursor.operand()?))
}

/// `TOOL CALL …`, after the two words.
pub(super) fn tool_call(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let tool = tool(cursor)?;
    let mut ahead = cursor.clone();
    let axis = axis_letter(&mut ahead).filter(|_| ahead.rest().chars().next().is_none_or(char::is_whitespace));
    if axis.is_some() {
        *cursor = ahead;
    }
    let rest = cursor.take_rest().to_owned();
    // `TOOL CALL 9 S50 Z`: the axis may stand behind the speed.
    let alone =
        || AXES.into_iter().find(|(letter, _)| rest.split_whitespace().any(|word| word.eq_ignore_ascii_case(letter)));
    let axis = axis.or_else(|| alone().map(|(_, axis)| axis));
    Ok(Body::ToolCall { tool, axis, rest })
}

pub(in super::super) fn tool(cursor: &mut Cursor<'_>) -> Parsed<Option<Tool>> {
    if let Some(name) = cursor.quoted() {
        return Ok(Some(Tool::Name(TextOperand::Text(name.to_owned()))));
    }
    let mut ahead = cursor.clone();
    if let Some(parameter) = ahead.parameter()?.filter(|parameter| parameter.family == Family::Qs) {
        *cursor = ahead;
        return Ok(Some(Tool::Name(TextOperand::Parameter(parameter))));
    }
    let mut ahead = cursor.clone();
    ahead.minus();
    if ahead.next().is_some_and(|c| c.is_ascii_digit()) || ahead.parameter()?.is_some() {
        let number: Operand = cursor.operand()?;
        return Ok(Some(Tool::Number(number)));
    }
    Ok(None)
}
