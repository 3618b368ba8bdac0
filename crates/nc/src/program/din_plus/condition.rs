//! Conditions of IF and WHILE.

use super::super::cursor::{Cursor, Parsed};
use super::super::expression::{Relation, Test};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::formula::{MOST_DEPTH, MOST_OPERANDS, expression};

/// Comparisons, the longer ones first; whether the comparison holds or its opposite.
const COMPARISONS: [(&str, Relation, bool); 6] = [
    ("==", Relation::Equal, true),
    ("<>", Relation::NotEqual, true),
    ("<=", Relation::Greater, false),
    (">=", Relation::Less, false),
    ("<", Relation::Less, true),
    (">", Relation::Greater, true),
];

/// Reads a condition as far as it goes: comparisons, joined by AND or by OR. Which of the two comes first is not documented, so
/// both in one condition need brackets.
pub(super) fn condition(cursor: &mut Cursor<'_>) -> Parsed<Test> {
    joined(cursor, 0)
}

fn joined(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Test> {
    let first = item(cursor, depth)?;
    let (word, other) = match () {
        () if is_next(cursor, "AND") => ("AND", "OR"),
        () if is_next(cursor, "OR") => ("OR", "AND"),
        () => return Ok(first),
    };
    let mut all = vec![first];
    while cursor.take_word(word) {
        if MOST_OPERANDS <= all.len() {
            return Err(cursor.fail(BlockFault::TooManyOperands { most: MOST_OPERANDS }));
        }
        all.push(item(cursor, depth)?);
    }
    if is_next(cursor, other) {
        return Err(cursor.fail(BlockFault::AndWithOr));
    }
    Ok(if word == "AND" { Test::All(all) } else { Test::Any(all) })
}

fn is_next(cursor: &mut Cursor<'_>, word: &str) -> bool {
    cursor.blanks();
    cursor.clone().take_word(word)
}

/// A comparison, or a condition in brackets.
fn item(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Test> {
    if opens_condition(cursor) {
        if depth == MOST_DEPTH {
            return Err(cursor.fail(BlockFault::TooDeep { most: MOST_DEPTH }));
        }
        cursor.expect('(', "(")?;
        let inner = joined(cursor, depth + 1)?;
        cursor.expect(')', ")")?;
        return Ok(inner);
    }
    let left = expression(cursor)?;
    let Some(&(_, relation, holds)) = COMPARISONS.iter().find(|(sign, ..)| cursor.take_prefix(sign)) else {
        return Err(cursor.stop(ExpectedWord::Word("==, <>, <, <=, > / >=")));
    };
    let compared = Test::Compare(left, relation, expression(cursor)?);
    Ok(if holds { compared } else { Test::Not(Box::new(compared)) })
}

/// Whether a bracket comes next that has a comparison in it, and not only a formula.
fn opens_condition(cursor: &mut Cursor<'_>) -> bool {
    if cursor.next() != Some('(') {
        return false;
    }
    let mut depth = 0_usize;
    for character in cursor.rest().chars() {
        match character {
            '(' => depth += 1,
            ')' if depth <= 1 => return false,
            ')' => depth -= 1,
            '<' | '>' | '=' => return true,
            _ => {}
        }
    }
    false
}
