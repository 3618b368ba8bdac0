//! The signs of drawings, of CAD programs and of full-width keyboards as those of the grammar. Each character stays one character, so
//! that places in the text stay the same.

use super::super::reading::is_diameter_sign;

/// Codes of CAD programs, with the sign that each stands for.
const CODES: [(&str, char); 7] =
    [("%%c", 'Ø'), ("%%C", 'Ø'), ("%%p", '±'), ("%%P", '±'), ("\\U+2205", 'Ø'), ("<MOD-DIAM>", 'Ø'), ("<MOD-PM>", '±')];

/// How far a full-width character lies behind the same one of ASCII.
const FULL_WIDTH: u32 = 0xFEE0;

/// The characters of a text, with the grammar's signs. A code becomes its sign and blanks.
pub(super) fn plain(text: &str) -> Vec<char> {
    let mut chars = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        if let Some((code, sign)) = CODES.into_iter().find(|(code, _)| rest.starts_with(code)) {
            chars.push(sign);
            chars.extend(std::iter::repeat_n(' ', code.chars().count() - 1));
            rest = rest.strip_prefix(code).unwrap_or("");
            continue;
        }
        chars.push(sign(c));
        rest = rest.strip_prefix(c).unwrap_or("");
    }
    chars
}

fn sign(c: char) -> char {
    match c {
        _ if is_diameter_sign(c) => 'Ø',
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(c) - FULL_WIDTH).unwrap_or(c),
        '\u{3000}' | '\t' => ' ',
        '\u{2010}' | '\u{2011}' | '\u{2212}' | '\u{2013}' | '\u{2014}' => '-',
        '\u{2044}' | '\u{2215}' => '/',
        '\u{d7}' | '\u{2715}' | '\u{2a2f}' | '*' => 'x',
        '\u{2033}' | '\u{201c}' | '\u{201d}' => '"',
        _ => c,
    }
}
