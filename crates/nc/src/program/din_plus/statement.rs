//! Blocks that begin with a word of the language or a variable.

use super::super::block::{Body, Target, still};
use super::super::cursor::{Cursor, Parsed};
use super::super::expression::{Expression, Test, TextExpression};
use super::super::fault::ExpectedWord;
use super::super::formula::expression;
use super::super::operand::{Operand, TextOperand};
use super::condition::condition;
use super::language::SUBPROGRAM;
use super::letters;

/// What a block says; where the next block lies is found for branches when all blocks are read.
#[derive(Debug)]
pub(super) enum Said {
    /// A body that stands for itself.
    Body(Body),
    /// `IF …`, with `THEN` on the same line or not.
    If(Test),
    Then,
    Else,
    EndIf,
    While(Test),
    EndWhile,
    Switch(Expression),
    Case(Expression),
    Default,
    Break,
    EndSwitch,
    /// `SUBPROGRAM "NAME"`
    Subprogram(Target),
    Return,
    Unit,
    EndOfUnit,
}

/// A word and what it says.
type Alone = (&'static str, fn() -> Said);

/// Words that are a block each.
const ALONE: [Alone; 8] = [
    ("THEN", || Said::Then),
    ("ELSE", || Said::Else),
    ("ENDIF", || Said::EndIf),
    ("ENDWHILE", || Said::EndWhile),
    ("DEFAULT", || Said::Default),
    ("BREAK", || Said::Break),
    ("ENDSWITCH", || Said::EndSwitch),
    ("RETURN", || Said::Return),
];

/// Reads a block of a section that runs.
pub(super) fn said(cursor: &mut Cursor<'_>) -> Parsed<Said> {
    let said = match cursor.next() {
        None => Said::Body(Body::Nothing),
        Some('#') => Said::Body(assignment(cursor)?),
        Some(_) => match word(cursor)? {
            Some(said) => said,
            None => Said::Body(letters::body(cursor)?),
        },
    };
    cursor.end()?;
    Ok(said)
}

/// A block that begins with a word of the language; takes nothing otherwise.
fn word(cursor: &mut Cursor<'_>) -> Parsed<Option<Said>> {
    if let Some((_, said)) = ALONE.iter().find(|(word, _)| cursor.take_word(word)) {
        return Ok(Some(said()));
    }
    let said = if cursor.take_word("IF") {
        let test = condition(cursor)?;
        cursor.take_word("THEN");
        Said::If(test)
    } else if cursor.take_word("WHILE") {
        Said::While(condition(cursor)?)
    } else if cursor.take_word("SWITCH") {
        Said::Switch(Expression::Value(cursor.operand()?))
    } else if cursor.take_word("CASE") {
        Said::Case(case(cursor)?)
    } else if cursor.take_word("SUBPROGRAM") {
        Said::Subprogram(Target::Name(name(cursor)?))
    } else if cursor.take_word("UNIT") {
        cursor.take_rest();
        Said::Unit
    } else if cursor.take_word("END_OF_UNIT") {
        cursor.take_rest();
        Said::EndOfUnit
    } else if cursor.take_word("PRINT") {
        Said::Body(print(cursor)?)
    } else if cursor.take_word("INPUT") {
        Said::Body(input(cursor)?)
    } else if cursor.take_word("WINDOW") {
        Said::Body(window(cursor)?)
    } else if cursor.letters() == "L" {
        Said::Body(call(cursor)?)
    } else {
        return Ok(None);
    };
    Ok(Some(said))
}

/// `#l1=…`, `#x1="text"`.
fn assignment(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    let to = cursor.any_parameter()?;
    cursor.expect('=', "=")?;
    if to.family.is_text() {
        return Ok(Body::AssignText { to, value: text(cursor)? });
    }
    Ok(Body::Assign { to, value: expression(cursor)? })
}

/// `1`, `1:`, `-2`
fn case(cursor: &mut Cursor<'_>) -> Parsed<Expression> {
    let is_negative = cursor.minus();
    let Some(number) = cursor.number()? else { return Err(cursor.stop(ExpectedWord::Number)) };
    cursor.take(':');
    Ok(Expression::Value(Operand::Number(if is_negative { -number } else { number })))
}

fn name(cursor: &mut Cursor<'_>) -> Parsed<String> {
    match cursor.quoted().map(str::trim) {
        Some(name) if !name.is_empty() => Ok(name.to_owned()),
        _ => Err(cursor.stop(ExpectedWord::Word("\"NAME\""))),
    }
}

/// A quoted text or a variable that holds one.
fn text(cursor: &mut Cursor<'_>) -> Parsed<TextExpression> {
    if let Some(text) = cursor.quoted() {
        return Ok(TextExpression::Value(TextOperand::Text(text.to_owned())));
    }
    Ok(TextExpression::Value(TextOperand::Parameter(cursor.text_parameter(ExpectedWord::Text)?)))
}

/// `("text",#l1)`: texts and values, shown with a blank between them.
fn print(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect('(', "(")?;
    let mut items = Vec::new();
    loop {
        if !items.is_empty() {
            items.push(TextExpression::Value(TextOperand::Text(" ".to_owned())));
        }
        let holds_text = cursor.next() == Some('"')
            || cursor.clone().parameter().is_ok_and(|parameter| parameter.is_some_and(|found| found.family.is_text()));
        items.push(if holds_text {
            text(cursor)?
        } else {
            TextExpression::FromNumber { number: cursor.operand()?, decimals: None }
        });
        if !cursor.take(',') {
            break;
        }
    }
    cursor.expect(')', ")")?;
    Ok(Body::Show(TextExpression::Join(items)))
}

/// `("text",#l1)`
fn input(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect('(', "(")?;
    let mut question = String::new();
    if let Some(text) = cursor.quoted() {
        text.clone_into(&mut question);
        cursor.expect(',', ",")?;
    }
    let to = cursor.any_parameter()?;
    cursor.expect(')', ")")?;
    Ok(Body::Input { question, to })
}

/// `(10)`: how many lines the control's window has.
fn window(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.expect('(', "(")?;
    cursor.operand()?;
    cursor.expect(')', ")")?;
    Ok(still("WINDOW"))
}

/// `L"NAME" V1`: V1 is a file beside the program, otherwise the subprogram is in it. Letters handed over and repeats are not
/// run: what they mean is not documented.
fn call(cursor: &mut Cursor<'_>) -> Parsed<Body> {
    cursor.take('L');
    let name = name(cursor)?;
    let mut is_file = false;
    if cursor.letters() == "V" {
        cursor.take('V');
        is_file = cursor.expect_whole(1)? == 1;
    }
    if !cursor.is_at_end() {
        return Err(cursor.unknown_word());
    }
    if !is_file {
        return Ok(Body::CallLabel { label: Target::Name(name), repeat: None });
    }
    let file = if name.contains('.') { name } else { format!("{name}{SUBPROGRAM}") };
    Ok(Body::CallProgram(TextOperand::Text(file)))
}
