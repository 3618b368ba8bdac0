//! Blocks that begin with `FN`, and assignments.

use super::super::around::Frame;
use super::super::block::{Body, Columns, Condition, SystemDatum, still};
use super::super::cursor::{Cursor, Parsed};
use super::super::expression::{Expression, NumberFunction, Operation};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::formula::{binary, expression};
use super::super::operand::Operand;
use super::super::text_formula::text_expression;
use super::super::words::{Computed, FUNCTIONS, OPERATIONS, RELATIONS, computed, word};
use super::label::target;
use crate::control::variables::Family;

/// `FN n: …`, after the word `FN`. Functions that Fitcheck does not run are [`Body::Other`].
pub(super) fn function(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let number = cursor.expect_whole(99)?;
    cursor.expect(':', ":")?;
    if let Some(computed) = computed(number) {
        return assign(cursor, computed);
    }
    match number {
        0 => assign_value(cursor),
        9..=12 => jump(cursor, number),
        14 => error(cursor),
        16 => print(cursor),
        26 => {
            cursor.expect_word("TABOPEN")?;
            Ok(Body::TableOpen(cursor.path(None)?))
        }
        // Not 37: what EXPORT hands to the calling program may be a limit, and how it does is on no page that we found.
        15 | 19 | 20 | 29 | 38 => {
            cursor.take_rest();
            Ok(still(format!("FN {number}")))
        }
        17 => system_write(cursor),
        18 => system_read(cursor),
        27 => table_write(cursor),
        28 => table_read(cursor),
        _ => {
            cursor.take_rest();
            Ok(Body::Other)
        }
    }
}

/// `Q5 = …`, `QS5 = …`, `Q5 SET UNDEFINED`.
pub(in super::super) fn assignment(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let to = cursor.any_parameter()?;
    if cursor.take_words(&["SET", "UNDEFINED"]) {
        return Ok(Body::Undefine(to));
    }
    cursor.expect('=', "=")?;
    if to.family == Family::Qs {
        return Ok(Body::AssignText { to, value: text_expression(cursor)? });
    }
    Ok(Body::Assign { to, value: expression(cursor)? })
}

/// `DECLARE STRING QS1 = …`, after the first two words.
pub(super) fn declaration(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let to = cursor.text_parameter(ExpectedWord::TextParameter)?;
    cursor.expect('=', "=")?;
    Ok(Body::AssignText { to, value: text_expression(cursor)? })
}

fn assign_value(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let from = cursor.clone();
    let to = cursor.any_parameter()?;
    if cursor.take_words(&["SET", "UNDEFINED"]) {
        return Ok(Body::Undefine(to));
    }
    if to.family == Family::Qs {
        return Err(from.clone().stop(ExpectedWord::NumberParameter));
    }
    cursor.expect('=', "=")?;
    Ok(Body::Assign { to, value: value(cursor)? })
}

fn assign(cursor: &mut Cursor<'_>, computed: Computed) -> Parsed<Body> {
    let to = cursor.number_parameter()?;
    cursor.expect('=', "=")?;
    let value = match computed {
        Computed::Of(function) => of(cursor, function)?,
        Computed::Between(operation) => between(cursor, operation)?,
    };
    Ok(Body::Assign { to, value })
}

fn value(cursor: &mut Cursor<'_>) -> Parsed<Expression> {
    Ok(Expression::Value(cursor.operand()?))
}

fn of(cursor: &mut Cursor<'_>, function: NumberFunction) -> Parsed<Expression> {
    cursor.expect_word(word(&FUNCTIONS, function))?;
    Ok(Expression::Function(function, Box::new(value(cursor)?)))
}

/// Two operands with the sign or word of an operation between them.
fn between(cursor: &mut Cursor<'_>, operation: Operation) -> Parsed<Expression> {
    let left = value(cursor)?;
    let word = word(&OPERATIONS, operation);
    match word.chars().next().filter(|sign| !sign.is_alphabetic()) {
        // `DIV`; a `/` stands in programs that were written by hand.
        Some('/') if !cursor.take('/') => cursor.expect_word("DIV")?,
        Some('/') => {}
        Some(sign) => cursor.expect(sign, word)?,
        None => cursor.expect_word(word)?,
    }
    Ok(binary(operation, left, value(cursor)?))
}

/// FN 9 to FN 12.
fn jump(cursor: &mut Cursor<'_>, number: u32) -> Parsed<Body> {
    cursor.expect_word("IF")?;
    let condition = match defined(cursor)? {
        Some(condition) => condition,
        None => compare(cursor, number)?,
    };
    cursor.expect_word("GOTO")?;
    cursor.expect_word("LBL")?;
    Ok(Body::Jump { condition, label: target(cursor)? })
}

/// `Q1 IS DEFINED`; takes nothing if a comparison comes next.
fn defined(cursor: &mut Cursor<'_>) -> Parsed<Option<Condition>> {
    let mut ahead = cursor.clone();
    ahead.minus();
    let Some(parameter) = ahead.parameter()? else { return Ok(None) };
    if !ahead.take_word("IS") {
        return Ok(None);
    }
    let condition = if ahead.take_word("DEFINED") {
        Condition::IsDefined(parameter)
    } else {
        ahead.expect_word("UNDEFINED")?;
        Condition::IsUndefined(parameter)
    };
    *cursor = ahead;
    Ok(Some(condition))
}

fn compare(cursor: &mut Cursor<'_>, number: u32) -> Parsed<Condition> {
    let left = cursor.operand()?;
    cursor.blanks();
    let from = cursor.clone();
    let Some(&(own, found, relation)) = RELATIONS.iter().find(|(_, word, _)| cursor.take_word(word)) else {
        return Err(cursor.stop(ExpectedWord::Relation));
    };
    if own != number {
        let allowed = RELATIONS.iter().find(|(of, ..)| *of == number).map_or("", |&(_, word, _)| word);
        return Err(from.fail(BlockFault::Relation { number, allowed, found }));
    }
    Ok(Condition::Compare(left, relation, cursor.operand()?))
}

fn error(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect_word("ERROR")?;
    cursor.expect('=', "=")?;
    Ok(Body::Error(cursor.operand()?))
}

/// `F-PRINT mask / output`
pub(in super::super) fn print(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    if !cursor.take_prefix("F-PRINT") {
        return Err(cursor.stop(ExpectedWord::Word("F-PRINT")));
    }
    let mask = cursor.path(Some('/'))?;
    cursor.expect('/', "/")?;
    Ok(Body::Print { mask, output: cursor.path(None)? })
}

fn table_read(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect_word("TABREAD")?;
    let to = cursor.any_parameter()?;
    cursor.expect('=', "=")?;
    let (row, columns) = cell(cursor)?;
    Ok(Body::TableRead { to, row, columns })
}

/// `SYSREAD Q2 = ID50 NR19 IDXQ1`
fn system_read(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect_word("SYSREAD")?;
    let to = cursor.number_parameter()?;
    cursor.expect('=', "=")?;
    let datum = system_datum(&mut cursor.clone());
    cursor.take_rest();
    Ok(Body::SystemRead { to, datum })
}

/// `ID50 NR19 IDXQ1`; a value of another form is one that only a control knows.
pub(in super::super) fn system_datum(cursor: &mut Cursor<'_>) -> Option<SystemDatum> {
    let mut word = |letters: &str| {
        if cursor.take_prefix(letters) { cursor.operand().map(Some).ok() } else { Some(None) }
    };
    let group = match word("ID")?? {
        Operand::Number(group) => format!("{group}").parse().ok()?,
        Operand::Parameter { .. } => return None,
    };
    let (number, index) = (word("NR")?, word("IDX")?);
    cursor.is_at_end().then_some(SystemDatum { group, number, index })
}

/// `SYSWRITE ID50 NR1 IDXQ2 = Q1601`: presets, datum tables and rotations can be written, too. Only data of tools and pockets are known
/// to leave the system alone, and how the probe approaches.
fn system_write(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.take_word("SYSWRITE");
    cursor.take_prefix("ID");
    let group = cursor.whole(u32::MAX)?;
    cursor.take_rest();
    Ok(match group {
        Some(50..=52 | 990) => still("FN 17"),
        _ => Body::Frame(Frame::NotFollowed),
    })
}

fn table_write(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect_word("TABWRITE")?;
    let (row, columns) = cell(cursor)?;
    cursor.expect('=', "=")?;
    Ok(Body::TableWrite { row, columns, from: cursor.any_parameter()? })
}

/// `40/"NAME"`, `+Q22/QS1`.
fn cell(cursor: &mut Cursor<'_>) -> Parsed<(Operand, Columns)> {
    let row = cursor.operand()?;
    cursor.expect('/', "/")?;
    if let Some(names) = cursor.quoted() {
        let names: Vec<String> = names.split(',').map(|name| name.trim().to_owned()).collect();
        return Ok((row, Columns::Names(names)));
    }
    Ok((row, Columns::Parameter(cursor.text_parameter(ExpectedWord::Text)?)))
}
