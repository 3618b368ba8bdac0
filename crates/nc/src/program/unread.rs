//! What a block that is not understood may do, by its words: a run that skips it must not go on as if nothing had happened.
//!
//! Only what is named here is told apart. Any other block may do anything: set a datum, change the tool, measure.

use fitcheck_core::text::{behind, until};

use super::cursor::Cursor;
use super::cycle_block::CycleBlock;
use super::lines::{self, Piece};
use super::milling::first_parameter;
use super::notation::Notation;
use super::{Program, iso};
use crate::control::variables::Parameter;

/// What a block that is not understood may do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unread {
    /// It decides which block is next, stops the run, or hands values to another program.
    Flow,
    /// It shows or prints something.
    Nothing,
    /// It sets these parameters.
    Sets(Vec<Parameter>),
    /// It opens a table of FN 26.
    TableOpen,
    /// It writes the table that is open.
    TableWrite,
    /// SQL: it sets these parameters, or binds them to be set by another one, and it may write any table.
    Sql(Vec<Parameter>),
    /// It copies, moves or deletes files.
    Files,
    /// Anything, and it may set these parameters.
    Anything(Vec<Parameter>),
}

/// Words of blocks that go elsewhere, or that something goes to.
const FLOW: [&str; 3] = ["LBL", "PGM", "GOTO"];

/// The same of lathe controls.
const LATHE_FLOW: [&str; 14] = [
    "IF",
    "THEN",
    "ELSE",
    "ENDIF",
    "WHILE",
    "ENDWHILE",
    "SWITCH",
    "CASE",
    "DEFAULT",
    "BREAK",
    "ENDSWITCH",
    "SUBPROGRAM",
    "RETURN",
    "ENDE",
];

impl Program {
    /// What a block may do that is kept as text ([`super::Body::Other`]).
    pub fn unread(&self, block: usize) -> Unread {
        let code: Vec<&str> = self.text_of(block).enumerate().map(|(line, text)| self.code_of(line, text)).collect();
        let code = code.join(" ");
        match self.notation() {
            Notation::Klartext => klartext(&code),
            Notation::Iso => iso(&code),
            Notation::DinPlus => din_plus(&code),
        }
    }

    /// A line of a block without its number and its comment; the first line is 0.
    fn code_of<'a>(&self, line: usize, text: &'a str) -> &'a str {
        let from = match (self.notation(), line) {
            (Notation::Klartext, 0) => lines::front(text).end,
            (Notation::Iso | Notation::DinPlus, 0) => iso::front_end(text),
            _ => 0,
        };
        match self.notation() {
            Notation::Klartext | Notation::Iso => {
                let Piece { code, .. } = lines::next(text, line, from);
                code
            }
            Notation::DinPlus => until(behind(text, from), '[').trim(),
        }
    }
}

/// The words of a text, without signs and figures between them.
fn has_word(code: &str, words: &[&str]) -> bool {
    let mut found = code.split(|c: char| !c.is_alphabetic() && c != '_');
    found.any(|found| words.iter().any(|word| word.eq_ignore_ascii_case(found)))
}

fn klartext(code: &str) -> Unread {
    let mut cursor = Cursor::new(code);
    if cursor.take_word("FN") {
        return match cursor.whole(99) {
            Ok(Some(number)) => function(number, code),
            _ => Unread::Flow,
        };
    }
    if cursor.take_words(&["OPEN", "FILE"]) {
        return Unread::Nothing;
    }
    if is_file_function(code) {
        return Unread::Files;
    }
    if cursor.take_word("SQL") {
        return Unread::Sql(parameters(code).into_iter().map(|(_, parameter)| parameter).collect());
    }
    if cursor.take_words(&["DECLARE", "STRING"]) || begins_with_parameter(code, Notation::Klartext) {
        return sets_first(code);
    }
    if has_word(code, &FLOW) || cursor.take_word("CALL") {
        return Unread::Flow;
    }
    Unread::Anything(named(code))
}

/// `FUNCTION FILECOPY` and its kin, where they are not understood.
fn is_file_function(code: &str) -> bool {
    let mut cursor = Cursor::new(code);
    cursor.take_word("FUNCTION")
        && ["FILE", "FILECHECK", "FILECOPY", "FILEDELETE", "FILEMOVE"].iter().any(|word| cursor.take_word(word))
}

/// FN and D of a number.
fn function(number: u32, code: &str) -> Unread {
    match number {
        0..=8 | 13 | 18 => sets_first(code),
        28 => {
            let Unread::Sets(first) = sets_first(code) else { return Unread::Flow };
            // Several columns fill the parameters that follow.
            let more = u16::try_from(code.matches(',').count()).unwrap_or(u16::MAX);
            let all = first.iter().flat_map(|first| {
                (first.number..=first.number.saturating_add(more)).map(|number| Parameter { number, ..*first })
            });
            Unread::Sets(all.collect())
        }
        15 | 16 | 20 | 38 => Unread::Nothing,
        26 => Unread::TableOpen,
        27 => Unread::TableWrite,
        9..=12 | 14 | 37 => Unread::Flow,
        _ => Unread::Anything(named(code)),
    }
}

fn iso(code: &str) -> Unread {
    let mut cursor = Cursor::new(code);
    if begins_with_parameter(code, Notation::Iso) {
        return sets_first(code);
    }
    if code.starts_with('%') || has_word(code, &FLOW) || is_call(code) {
        return Unread::Flow;
    }
    let number = |cursor: &mut Cursor<'_>| cursor.whole(999).ok().flatten();
    if cursor.take_prefix("D") {
        return number(&mut cursor).map_or(Unread::Anything(named(code)), |number| function(number, code));
    }
    match cursor.take_prefix("G").then(|| number(&mut cursor)).flatten() {
        // A label, and a program as a cycle.
        Some(98 | 39) => Unread::Flow,
        _ => Unread::Anything(named(code)),
    }
}

/// `L1,0` of ISO, `L"NAME"` of lathe controls.
fn is_call(code: &str) -> bool {
    let behind = code.strip_prefix(['L', 'l']).map(str::trim_start);
    behind.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit() || c == '"') && !rest.contains('='))
}

fn din_plus(code: &str) -> Unread {
    if has_word(code, &LATHE_FLOW) || is_call(code) {
        return Unread::Flow;
    }
    let mut cursor = Cursor::of(code, Notation::DinPlus);
    if cursor.take_word("PRINT") || cursor.take_word("WINDOW") {
        return Unread::Nothing;
    }
    if begins_with_parameter(code, Notation::DinPlus) || cursor.take_word("INPUT") {
        return Unread::Sets(variables(code));
    }
    Unread::Anything(variables(code))
}

fn begins_with_parameter(code: &str, notation: Notation) -> bool {
    let mut cursor = Cursor::of(code, notation);
    // One that does not exist is one, too.
    !matches!(cursor.parameter(), Ok(None))
}

/// The first parameter of a text; none where a control does not have it.
fn sets_first(code: &str) -> Unread {
    let found = first_parameter(code, |_cursor| true);
    let parameter = found.and_then(|(_, rest)| Cursor::new(rest).parameter().ok().flatten());
    Unread::Sets(parameter.into_iter().collect())
}

/// The parameters that a text may set: all but those that stand as a value, behind a sign or `=`.
fn named(code: &str) -> Vec<Parameter> {
    let is_value = |at: usize| code.get(..at).is_some_and(|before| before.trim_end().ends_with(['+', '-', '=']));
    parameters(code).into_iter().filter(|(at, _)| !is_value(*at)).map(|(_, parameter)| parameter).collect()
}

/// All Q parameters of a text, and where each begins.
fn parameters(code: &str) -> Vec<(usize, Parameter)> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(rest) = code.get(from..)
        && let Some((before, rest)) = first_parameter(rest, |_cursor| true)
    {
        let mut cursor = Cursor::new(rest);
        from += before.len();
        found.extend(cursor.parameter().ok().flatten().map(|parameter| (from, parameter)));
        // Its first letter at least is behind.
        from += cursor.at().max(1);
    }
    found
}

/// All variables of a lathe control's text.
fn variables(code: &str) -> Vec<Parameter> {
    let at = |(at, _): (usize, &str)| Cursor::of(behind(code, at), Notation::DinPlus).parameter().ok().flatten();
    code.match_indices('#').filter_map(at).collect()
}

impl CycleBlock {
    /// The parameters that its first line names besides its own lines: `TCH PROBE 0.0 REF. PLANE Q5 X-`, `TCH PROBE 3.1 Q1`. Cycles
    /// 3 and 4 fill the three that follow, too.
    pub fn named(&self) -> Vec<Parameter> {
        let more = if self.number.starts_with(['3', '4']) && self.number.contains('.') { 3 } else { 0 };
        let all =
            |first: Parameter| (0..=more).map(move |on| Parameter { number: first.number.saturating_add(on), ..first });
        parameters(&self.name).into_iter().flat_map(|(_, first)| all(first)).collect()
    }
}
