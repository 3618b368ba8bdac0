//! D functions: those of Klartext's FN, by the same numbers, with their operands behind `P01`, `P02` and `P03`.

use super::super::around::{Goes, PassedOver};
use super::super::block::{Body, Condition, Target};
use super::super::cursor::{Cursor, Read, Stop};
use super::super::expression::{Expression, NumberFunction, Operation};
use super::super::fault::{BlockFault, Wanted};
use super::super::formula::binary;
use super::super::klartext::MOST_LABEL;
use super::super::operand::Operand;
use super::super::words::RELATIONS;

/// `D01 Q1 P01 -Q2 P02 -5`, after the `D`.
pub(super) fn function(cursor: &mut Cursor<'_>) -> Read<Body> {
    cursor.blanks();
    let at = cursor.at();
    let number = cursor.expect_whole(99)?;
    match number {
        0 => assign(cursor, |cursor| value(cursor, 1)),
        1 => assign(cursor, |cursor| between(cursor, Operation::Add)),
        2 => assign(cursor, |cursor| between(cursor, Operation::Subtract)),
        3 => assign(cursor, |cursor| between(cursor, Operation::Multiply)),
        4 => assign(cursor, |cursor| between(cursor, Operation::Divide)),
        5 => assign(cursor, |cursor| of(cursor, NumberFunction::SquareRoot)),
        6 => assign(cursor, |cursor| of(cursor, NumberFunction::Sine)),
        7 => assign(cursor, |cursor| of(cursor, NumberFunction::Cosine)),
        8 => assign(cursor, |cursor| between(cursor, Operation::Hypotenuse)),
        13 => assign(cursor, |cursor| between(cursor, Operation::Angle)),
        9..=12 => jump(cursor, number),
        14 => Ok(Body::Error(operand(cursor, 1)?)),
        18 => {
            let to = cursor.number_parameter()?;
            // Which value it is makes no difference: a simulator has none of them.
            cursor.take_rest();
            Ok(Body::SystemRead { to })
        }
        // What is handed to the machine and to other computers.
        19 | 20 | 29 => {
            cursor.take_rest();
            let words = format!("D{number:02}");
            Ok(Body::PassedOver(PassedOver { words, goes: Goes::default(), machine: Vec::new() }))
        }
        // Prints and tables: how their paths and columns are written in ISO is on no page that we found.
        _ => Err(Stop { at, reason: BlockFault::NoForm { found: format!("D{number:02}") } }),
    }
}

fn assign(cursor: &mut Cursor<'_>, formula: impl Fn(&mut Cursor<'_>) -> Read<Expression>) -> Read<Body> {
    let to = cursor.number_parameter()?;
    Ok(Body::Assign { to, value: formula(cursor)? })
}

fn of(cursor: &mut Cursor<'_>, function: NumberFunction) -> Read<Expression> {
    Ok(Expression::Function(function, Box::new(value(cursor, 1)?)))
}

fn between(cursor: &mut Cursor<'_>, operation: Operation) -> Read<Expression> {
    let left = value(cursor, 1)?;
    Ok(binary(operation, left, value(cursor, 2)?))
}

fn value(cursor: &mut Cursor<'_>, place: u32) -> Read<Expression> {
    Ok(Expression::Value(operand(cursor, place)?))
}

/// `P01 +Q1`
fn operand(cursor: &mut Cursor<'_>, place: u32) -> Read<Operand> {
    expect_place(cursor, place)?;
    cursor.operand()
}

fn expect_place(cursor: &mut Cursor<'_>, place: u32) -> Read<()> {
    let mut ahead = cursor.clone();
    if ahead.take_prefix("P") && ahead.whole(99).ok().flatten() == Some(place) {
        *cursor = ahead;
        return Ok(());
    }
    Err(cursor.stop(Wanted::Word(match place {
        1 => "P01",
        2 => "P02",
        _ => "P03",
    })))
}

/// `D09 P01 +Q1 P02 +Q3 P03 5`
fn jump(cursor: &mut Cursor<'_>, number: u32) -> Read<Body> {
    let left = operand(cursor, 1)?;
    let right = operand(cursor, 2)?;
    expect_place(cursor, 3)?;
    let Some(label) = cursor.whole(MOST_LABEL)? else { return Err(cursor.stop(Wanted::Label)) };
    let Some(&(_, _, relation)) = RELATIONS.iter().find(|(of, ..)| *of == number) else {
        return Err(cursor.stop(Wanted::Relation));
    };
    Ok(Body::Jump { condition: Condition::Compare(left, relation, right), label: Target::Number(label) })
}
