//! D functions: those of Klartext's FN, by the same numbers, with their operands behind `P01`, `P02` and `P03`.

use super::super::block::{Body, Condition, Target, still};
use super::super::cursor::{Cursor, Parsed, Stop};
use super::super::expression::Expression;
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::formula::binary;
use super::super::klartext::{label_number, print, system_datum};
use super::super::operand::Operand;
use super::super::words::{Computed, RELATIONS, computed};

/// `D01 Q1 P01 -Q2 P02 -5`, after the `D`.
pub(super) fn function(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.blanks();
    let at = cursor.at();
    let number = cursor.expect_whole(99)?;
    if number == 0 || computed(number).is_some() {
        return assign(cursor, computed(number));
    }
    match number {
        9..=12 => jump(cursor, number),
        14 => Ok(Body::Error(operand(cursor, 1)?)),
        18 => {
            let to = cursor.number_parameter()?;
            let datum = system_datum(&mut cursor.clone());
            cursor.take_rest();
            Ok(Body::SystemRead { to, datum })
        }
        // `D16 F-PRINT mask/output`; with P01 as other functions have it. No page that we found has either.
        16 => {
            cursor.take_word("P01");
            print(cursor)
        }
        // What is handed to the machine and to other computers.
        19 | 20 | 29 => {
            cursor.take_rest();
            Ok(still(format!("D{number:02}")))
        }
        // Tables: how their columns are written in ISO is on no page that we found.
        _ => Err(Stop { at, reason: BlockFault::NoForm { found: format!("D{number:02}") } }),
    }
}

/// Without anything to compute, the parameter gets the operand.
fn assign(cursor: &mut Cursor<'_>, computed: Option<Computed>) -> Parsed<Body> {
    let to = cursor.number_parameter()?;
    let first = value(cursor, 1)?;
    let value = match computed {
        None => first,
        Some(Computed::Of(function)) => Expression::Function(function, Box::new(first)),
        Some(Computed::Between(operation)) => binary(operation, first, value(cursor, 2)?),
    };
    Ok(Body::Assign { to, value })
}

fn value(cursor: &mut Cursor<'_>, place: u32) -> Parsed<Expression> {
    Ok(Expression::Value(operand(cursor, place)?))
}

/// `P01 +Q1`
fn operand(cursor: &mut Cursor<'_>, place: u32) -> Parsed<Operand> {
    expect_place(cursor, place)?;
    cursor.operand()
}

fn expect_place(cursor: &mut Cursor<'_>, place: u32) -> Parsed<()> {
    let mut ahead = cursor.clone();
    if ahead.take_prefix("P") && ahead.whole(99).ok().flatten() == Some(place) {
        *cursor = ahead;
        return Ok(());
    }
    Err(cursor.stop(ExpectedWord::Word(match place {
        1 => "P01",
        2 => "P02",
        _ => "P03",
    })))
}

/// `D09 P01 +Q1 P02 +Q3 P03 5`
fn jump(cursor: &mut Cursor<'_>, number: u32) -> Parsed<Body> {
    let left = operand(cursor, 1)?;
    let right = operand(cursor, 2)?;
    expect_place(cursor, 3)?;
    let label = label_number(cursor)?;
    let Some(&(_, _, relation)) = RELATIONS.iter().find(|(of, ..)| *of == number) else {
        return Err(cursor.stop(ExpectedWord::Relation));
    };
    Ok(Body::Jump { condition: Condition::Compare(left, relation, right), label: Target::Number(label) })
}
