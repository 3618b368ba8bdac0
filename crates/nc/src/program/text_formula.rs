//! Formulas for texts: items with `||` between them.

use super::cursor::{Cursor, Parsed, shown};
use super::expression::TextExpression;
use super::fault::{BlockFault, ExpectedWord};
use super::formula::{MOST_OPERANDS, text_word, value_word};
use super::operand::TextOperand;
use crate::control::variables::Family;

/// Reads a text formula as far as it goes.
pub(super) fn text_expression(cursor: &mut Cursor<'_>) -> Parsed<TextExpression> {
    let first = item(cursor)?;
    let mut items = Vec::new();
    while cursor.take_prefix("||") {
        if MOST_OPERANDS <= items.len() + 1 {
            return Err(cursor.fail(BlockFault::TooManyOperands { most: MOST_OPERANDS }));
        }
        items.push(item(cursor)?);
    }
    if items.is_empty() {
        return Ok(first);
    }
    items.insert(0, first);
    Ok(TextExpression::Join(items))
}

fn item(cursor: &mut Cursor<'_>) -> Parsed<TextExpression> {
    if let Some(text) = cursor.quoted() {
        return Ok(TextExpression::Value(TextOperand::Text(text.to_owned())));
    }
    let from = cursor.clone();
    if let Some(parameter) = cursor.parameter()? {
        if parameter.family != Family::Qs {
            return Err(from.clone().stop(ExpectedWord::Text));
        }
        return Ok(TextExpression::Value(TextOperand::Parameter(parameter)));
    }
    let word = cursor.letters();
    if word.is_empty() {
        return Err(cursor.stop(ExpectedWord::Text));
    }
    let is = |name: &str| word.eq_ignore_ascii_case(name);
    if !["TOCHAR", "SUBSTR", "SYSSTR"].into_iter().any(is) {
        return Err(cursor.fail(BlockFault::UnknownFunction { found: shown(word) }));
    }
    cursor.take_prefix(word);
    cursor.expect('(', "(")?;
    let found = if is("TOCHAR") {
        let number = value_word(cursor, "DAT")?;
        let decimals = if cursor.take_prefix("DECIMALS") { Some(cursor.operand()?) } else { None };
        TextExpression::FromNumber { number, decimals }
    } else if is("SUBSTR") {
        let source = text_word(cursor, "SRC_")?;
        let from = value_word(cursor, "BEG")?;
        let length = if cursor.take_prefix("LEN") { Some(cursor.operand()?) } else { None };
        TextExpression::Part { source, from, length }
    } else {
        TextExpression::System { id: value_word(cursor, "ID")?, number: value_word(cursor, "NR")? }
    };
    cursor.expect(')', ")")?;
    Ok(found)
}
