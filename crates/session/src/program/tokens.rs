//! The parts of a program line, to be distinguished on screen. Nothing is decided by them.

use std::ops::Range;

use fitcheck_core::text::Within as _;
use fitcheck_nc::program::Notation;

/// A part of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Token {
    /// Anything else.
    Plain,
    /// The block number, and the `/` before it.
    Number,
    /// A word of the language.
    Keyword,
    /// A Q, QL, QR or QS parameter.
    Parameter,
    /// A text in quotation marks.
    Text,
    Comment,
    /// A structure block.
    Heading,
}

/// The words of the language, in order.
const KEYWORDS: [&str; 79] = [
    "ABS", "ACOS", "ANG", "APPR", "ASIN", "ATAN", "BEGIN", "BLK", "CALL", "CC", "CHF", "COS", "CR", "CT", "CYCL",
    "DECLARE", "DEF", "DEFINED", "DEP", "DIV", "END", "EQU", "ERROR", "EXP", "F", "FAUTO", "FMAX", "FN", "FORM",
    "FRAC", "FUNCTION", "GLOBAL", "GOTO", "GT", "IF", "INCH", "INSTR", "INT", "IS", "L", "LBL", "LEN", "LN", "LOG",
    "LT", "M", "MM", "NE", "NEG", "PATTERN", "PGM", "PI", "PLANE", "PRINT", "PROBE", "REP", "RESET", "RND", "SCREEN",
    "SEL", "SET", "SGN", "SIN", "SPATIAL", "SQ", "SQRT", "STAY", "STOP", "STRCOMP", "STRING", "STRLEN", "SUBSTR",
    "TAN", "TCH", "THEN", "TOCHAR", "TONUMB", "TOOL", "TRANS",
];

/// Words after FN, in order.
const FUNCTIONS: [&str; 4] = ["TABOPEN", "TABREAD", "TABWRITE", "UNDEFINED"];

/// Words of DIN PLUS, in order.
const LATHE_KEYWORDS: [&str; 22] = [
    "AND",
    "BEARBEITUNG",
    "BREAK",
    "CASE",
    "DEFAULT",
    "ELSE",
    "ENDE",
    "ENDIF",
    "ENDSWITCH",
    "ENDWHILE",
    "FERTIGTEIL",
    "IF",
    "INPUT",
    "OR",
    "PRINT",
    "PROGRAMMKOPF",
    "RETURN",
    "REVOLVER",
    "ROHTEIL",
    "SUBPROGRAM",
    "THEN",
    "WHILE",
];

/// Splits a line into parts; every byte belongs to exactly one. `begins` is whether a block begins in the line: only
/// there can a block number be.
pub fn tokens(line: &str, begins: bool) -> Vec<(Range<usize>, Token)> {
    let mut found = TokenRanges::default();
    let front = if begins { front(line) } else { 0 };
    found.add(front, Token::Number);
    let rest = line.within(front..);
    if rest.trim_start().starts_with('*') {
        found.add(line.len(), Token::Heading);
        return found.parts;
    }
    while let Some(rest) = line.get(found.end..).filter(|rest| !rest.is_empty()) {
        let (length, token) = first(rest);
        found.add(found.end + length, token);
    }
    found.parts
}

/// The same for a line of a program in any notation.
pub fn tokens_of(notation: Notation, line: &str, begins: bool) -> Vec<(Range<usize>, Token)> {
    match notation {
        Notation::Klartext | Notation::Iso => tokens(line, begins),
        Notation::DinPlus => lathe_tokens(line),
    }
}

/// The parts of a line of DIN PLUS: `N5 #l1=40 [nominal size]`.
fn lathe_tokens(line: &str) -> Vec<(Range<usize>, Token)> {
    let mut found = TokenRanges::default();
    let blanks = line.len() - line.trim_start().len();
    let number = line.trim_start().strip_prefix(['N', 'n']).map_or(0, |rest| rest.len() - digits_behind(rest));
    found.add(if 0 < number { blanks + 1 + number } else { 0 }, Token::Number);
    while let Some(rest) = line.get(found.end..).filter(|rest| !rest.is_empty()) {
        let (length, token) = first_of_lathe(rest);
        found.add(found.end + length, token);
    }
    found.parts
}

/// How many bytes are left behind the figures that a text begins with.
fn digits_behind(text: &str) -> usize {
    text.trim_start_matches(|c: char| c.is_ascii_digit()).len()
}

/// The first part of such a text that is not empty.
fn first_of_lathe(text: &str) -> (usize, Token) {
    let closed = |mark: char| text.find(mark).map_or(text.len(), |end| end + mark.len_utf8());
    match text.chars().next() {
        Some('[') => (closed(']'), Token::Comment),
        Some('"') => first(text),
        Some('#') => {
            let name = text.within(1..).trim_start_matches(|c: char| c.is_ascii_lowercase() || c == '_');
            // `#EINHEIT` is data of the head.
            let is_variable = name.starts_with(|c: char| c.is_ascii_digit());
            if is_variable { (text.len() - digits_behind(name), Token::Parameter) } else { (1, Token::Plain) }
        }
        Some(c) if c.is_alphabetic() => {
            let behind = text.trim_start_matches(char::is_alphabetic);
            let length = text.len() - behind.len();
            let word = text.within(..length).to_ascii_uppercase();
            match word.as_str() {
                "G" => (text.len() - digits_behind(behind), Token::Keyword),
                word if LATHE_KEYWORDS.contains(&word) => (length, Token::Keyword),
                _ => (length, Token::Plain),
            }
        }
        Some(c) => (c.len_utf8(), Token::Plain),
        None => (0, Token::Plain),
    }
}

/// The parts so far; equal neighbours are merged.
#[derive(Debug, Default)]
struct TokenRanges {
    parts: Vec<(Range<usize>, Token)>,
    end: usize,
}

impl TokenRanges {
    fn add(&mut self, end: usize, token: Token) {
        if end <= self.end {
            return;
        }
        match self.parts.last_mut() {
            Some((range, last)) if *last == token => range.end = end,
            _ => self.parts.push((self.end..end, token)),
        }
        self.end = end;
    }
}

/// The length of a block's number, with what is around it.
fn front(line: &str) -> usize {
    let rest = line.trim_start_matches(|c: char| c.is_whitespace() || c == '/');
    let behind = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    let number = rest.len() - behind.len();
    let has_mark = line.trim_start().starts_with('/');
    match (number, behind.chars().next()) {
        (0, _) if has_mark => line.len() - rest.len(),
        (0, _) => 0,
        // `5L` would be a word, `5` alone is a number.
        (_, Some(c)) if !c.is_whitespace() && c != '/' && c != ';' => 0,
        _ => line.len() - behind.len(),
    }
}

/// The first part of a text that is not empty.
fn first(text: &str) -> (usize, Token) {
    let length = |more: fn(char) -> bool| text.len() - text.trim_start_matches(more).len();
    match text.chars().next() {
        Some(';') => (text.len(), Token::Comment),
        Some('"') => {
            let closed = text.get(1..).and_then(|rest| rest.find('"'));
            // A quotation mark that is not closed quotes nothing.
            closed.map_or((1, Token::Plain), |inner| (inner + 2, Token::Text))
        }
        Some(c) if c.is_alphabetic() => word(text, length(char::is_alphabetic)),
        Some(c) if c.is_ascii_digit() => (length(|c| c.is_ascii_digit()), Token::Plain),
        Some(c) => (c.len_utf8(), Token::Plain),
        None => (0, Token::Plain),
    }
}

/// The first word of a text, `length` bytes long: a parameter, a word of the language, or another one.
fn word(text: &str, length: usize) -> (usize, Token) {
    let (word, behind) = text.split_at_checked(length).unwrap_or((text, ""));
    let digits = behind.len() - behind.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let upper = word.to_ascii_uppercase();
    if 0 < digits {
        let family = ["QS", "QL", "QR", "Q"].into_iter().find(|family| upper.ends_with(family));
        return match family {
            Some(family) if family.len() == length => (length + digits, Token::Parameter),
            // `FQ1822`: the feed from a parameter.
            Some(family) => (length - family.len(), Token::Keyword),
            None if is_keyword(&upper) => (length, Token::Keyword),
            None => (length + digits, Token::Plain),
        };
    }
    (length, if is_keyword(&upper) { Token::Keyword } else { Token::Plain })
}

fn is_keyword(word: &str) -> bool {
    KEYWORDS.binary_search(&word).is_ok() || FUNCTIONS.binary_search(&word).is_ok()
}

/// The comment at the end of a line, without its `;`.
pub(super) fn comment(line: &str) -> Option<&str> {
    let (range, _) = tokens(line, true).into_iter().find(|(_, token)| *token == Token::Comment)?;
    let text = line.get(range)?.trim_start_matches(';').trim_end_matches(|c: char| c == '~' || c.is_whitespace());
    Some(text.trim()).filter(|text| !text.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_in_order() {
        assert!(KEYWORDS.is_sorted() && FUNCTIONS.is_sorted());
    }

    #[test]
    fn the_comment_names_a_parameter() {
        for (line, expected) in [
            ("7 Q1 = 25 ; NOMINAL SIZE ~ ", Some("NOMINAL SIZE")),
            ("7 QS1 = \"a;b\"", None),
            ("7 Q1 = 25 ;", None),
            (";all", Some("all")),
        ] {
            assert_eq!(comment(line), expected, "{line}");
        }
    }
}
