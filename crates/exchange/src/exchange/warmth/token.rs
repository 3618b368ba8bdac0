//! A text as numbers, words and signs.

use fitcheck_core::text::Within as _;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TokenKind<'a> {
    Number(f64),
    /// In small letters.
    Word(&'a str),
    Sign(char),
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) kind: TokenKind<'a>,
    /// Whether no blank stands before it.
    pub(super) is_glued: bool,
}

impl Token<'_> {
    pub(super) fn is(&self, sign: char) -> bool {
        self.kind == TokenKind::Sign(sign)
    }
}

/// A text in small letters, with one sign for each that looks alike.
pub(super) fn plain(text: &str) -> String {
    let text = text.replace('\u{2103}', "°c").replace('\u{2109}', "°f").replace('\u{ba}', "°").replace('\u{2212}', "-");
    text.to_lowercase().replace("+/-", "±").replace("+-", "±")
}

/// The tokens of such a text. A number has digits on both sides of its decimal sign, and a sign where one stands before it alone.
pub(super) fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut found: Vec<Token<'_>> = Vec::new();
    let mut rest = text;
    let mut is_glued = false;
    while let Some(first) = rest.chars().next() {
        if first.is_whitespace() {
            rest = rest.trim_start();
            is_glued = false;
            continue;
        }
        let (kind, length) = if first.is_ascii_digit() {
            let length = number_length(rest);
            let digits = rest.within(..length).replace(',', ".");
            (digits.parse().map_or(TokenKind::Sign('#'), TokenKind::Number), length)
        } else if first.is_alphabetic() {
            let length = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
            (TokenKind::Word(rest.within(..length)), length)
        } else {
            (TokenKind::Sign(first), first.len_utf8())
        };
        let token = signed(&mut found, Token { kind, is_glued });
        found.push(token);
        rest = rest.within(length..);
        is_glued = true;
    }
    found
}

/// A number with the sign before it, which is one unless something else stands directly before it: "35-36" is a range.
fn signed<'a>(found: &mut Vec<Token<'a>>, token: Token<'a>) -> Token<'a> {
    let TokenKind::Number(number) = token.kind else { return token };
    let (sign, before) = match found.as_slice() {
        [.., before, sign] if token.is_glued => (*sign, Some(*before)),
        [sign] if token.is_glued => (*sign, None),
        _ => return token,
    };
    let is_range = sign.is_glued && before.is_some_and(|before| !before.is('=') && !before.is(':') && !before.is('('));
    match sign.kind {
        TokenKind::Sign('-') if !is_range => {
            found.pop();
            Token { kind: TokenKind::Number(-number), is_glued: sign.is_glued }
        }
        TokenKind::Sign('+') if !is_range => {
            found.pop();
            Token { kind: TokenKind::Number(number), is_glued: sign.is_glued }
        }
        _ => token,
    }
}

fn number_length(text: &str) -> usize {
    let whole = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let behind = text.get(whole..).and_then(|rest| rest.strip_prefix(['.', ',']));
    let decimals = behind.map_or(0, |rest| rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len()));
    if decimals == 0 { whole } else { whole + 1 + decimals }
}
