//! A line: its number, its code and its comment.

use fitcheck_core::text::{before, behind};

use super::super::cursor::first_word;
use super::super::error::ProgramWarningKind;
use super::super::fault::BlockFault;
use super::super::lines::trimmed;
use super::language::MOST_NUMBER;

/// The parts of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Line<'a> {
    /// The block number behind the `N`.
    pub number: Option<u32>,
    /// Where the code begins, in bytes.
    pub start: usize,
    /// The code without number, comment and blanks around it.
    pub code: &'a str,
    /// The comment without brackets and blanks around it.
    pub comment: Option<&'a str>,
}

/// What is wrong with a line, and where in it, in bytes.
pub(super) type Fault = (usize, ProgramWarningKind);

impl<'a> Line<'a> {
    /// Takes a line apart: `N5 G0 X10 [text]`. Only blanks may follow a comment.
    pub(super) fn of(text: &'a str) -> Result<Self, Fault> {
        let (end, comment) = split(text)?;
        let before = before(text, end);
        let begun = trimmed_start(before);
        let (number, front) = number(begun);
        let code = trimmed_start(behind(begun, front));
        Ok(Self { number, start: before.len() - code.len(), code: trimmed(code), comment })
    }
}

/// A text without what is skipped at the beginning of a line.
fn trimmed_start(text: &str) -> &str {
    text.trim_start_matches(|c: char| c.is_whitespace() || c == '\u{feff}' || c == '\u{1a}')
}

/// Where the code ends, and the comment. Brackets within quotation marks are text.
fn split(text: &str) -> Result<(usize, Option<&str>), Fault> {
    let mut at = 0;
    while let Some(found) = text.get(at..).and_then(|rest| rest.find(['[', '"'])) {
        let place = at + found;
        let inner = place + 1;
        let rest = behind(text, inner);
        if text.get(place..).is_some_and(|rest| rest.starts_with('"')) {
            at = inner + rest.find('"').ok_or((place, ProgramWarningKind::UnclosedQuote))? + 1;
            continue;
        }
        let (comment, behind) = rest.split_once(']').ok_or((place, ProgramWarningKind::UnclosedComment))?;
        let left = trimmed(behind);
        if left.is_empty() {
            return Ok((place, Some(trimmed(comment))));
        }
        let begins = text.len() - trimmed_start(behind).len();
        let found = first_word(left);
        return Err((begins, ProgramWarningKind::NotUnderstood(BlockFault::LeftOver { found })));
    }
    Ok((text.len(), None))
}

/// The number behind an `N`, and where it ends.
fn number(text: &str) -> (Option<u32>, usize) {
    let none = (None, 0);
    let Some(behind) = text.strip_prefix(['N', 'n']) else { return none };
    let digits = behind.trim_start_matches([' ', '\t']);
    let length = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    let number = digits.get(..length).and_then(|digits| digits.parse().ok());
    if number.is_none() || MOST_NUMBER < length {
        return none;
    }
    (number, text.len() - digits.len() + length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, number: Option<u32>, code: &str, comment: Option<&str>) {
        let line = Line::of(text).unwrap();
        assert_eq!((line.number, line.code, line.comment), (number, code, comment), "{text}");
        assert!(text.get(line.start..).unwrap().starts_with(code), "{text}");
    }

    #[test]
    fn a_line_is_taken_apart() {
        check("N10 G0 X10", Some(10), "G0 X10", None);
        check("  N 3 #l1=40 [ nominal ] ", Some(3), "#l1=40", Some("nominal"));
        check("[alone]", None, "", Some("alone"));
        check("N5", Some(5), "", None);
        check("N123456 G0", None, "N123456 G0", None);
        check("PRINT(\"a [b] c\",#l1) [d]", None, "PRINT(\"a [b] c\",#l1)", Some("d"));
        check("NAME", None, "NAME", None);
        check("\u{1a}", None, "", None);
    }

    #[test]
    fn what_is_not_closed_is_found() {
        assert_eq!(Line::of("N1 G0 [a").unwrap_err(), (6, ProgramWarningKind::UnclosedComment));
        assert_eq!(Line::of("PRINT(\"a [b]").unwrap_err(), (6, ProgramWarningKind::UnclosedQuote));
        let found = "G1".to_owned();
        let left = ProgramWarningKind::NotUnderstood(BlockFault::LeftOver { found });
        assert_eq!(Line::of("N1 [a]  G1 X2").unwrap_err(), (8, left));
    }
}
