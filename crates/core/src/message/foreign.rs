//! Texts that somebody else has written, where they could do harm: on a terminal, and in a spreadsheet.

use std::borrow::Cow;

/// What could write a title, hide or forge a line of a terminal, or show `SCRAP` where something else is written: control characters
/// and the marks that turn the direction of a text (Unicode's `Bidi_Control`). A tab does none of that.
pub fn is_wild(c: char) -> bool {
    c.is_control() && c != '\t'
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// A text from a file, a name or an argument as it stands within a line: whatever is wild becomes a blank.
pub fn tame(text: &str) -> Cow<'_, str> {
    if text.contains(is_wild) { Cow::Owned(text.replace(is_wild, " ")) } else { Cow::Borrowed(text) }
}

/// Characters that end a cell where a spreadsheet, or its settings, split at something else than a comma.
const ENDS: [char; 5] = [';', '\t', '|', '\n', '\r'];

/// A text in which nothing behind such an end is computed: `x;=1+1` becomes `x;'=1+1`.
pub fn guarded(text: &str) -> Cow<'_, str> {
    // Most cells have none of them.
    let has_end = text.bytes().any(|byte| matches!(byte, b';' | b'\t' | b'|' | b'\n' | b'\r'));
    if !has_end || text.split(ENDS).skip(1).all(|rest| !is_formula(rest)) {
        return Cow::Borrowed(text);
    }
    let mut guarded = String::with_capacity(text.len() + 8);
    for (number, piece) in text.split_inclusive(ENDS).enumerate() {
        if 0 < number && is_formula(piece) {
            guarded.push('\'');
        }
        guarded.push_str(piece);
    }
    Cow::Owned(guarded)
}

/// Whether a spreadsheet may compute a text.
pub fn is_formula(text: &str) -> bool {
    let first = text.trim_start_matches(|c: char| c.is_whitespace() || c.is_control()).chars().next();
    first.is_some_and(|c| "=+-@\u{ff1d}\u{ff0b}\u{ff0d}\u{ff20}".contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_behind_another_separator_is_computed() {
        for (text, expected) in [
            ("x;=1+1", "x;'=1+1"),
            ("x;\u{a0}=1+1;-2", "x;'\u{a0}=1+1;'-2"),
            ("x\t@sum", "x\t'@sum"),
            ("x\n+1", "x\n'+1"),
            ("a-b;c=d", "a-b;c=d"),
            ("-0.007", "-0.007"),
        ] {
            assert_eq!(guarded(text), expected);
            assert_eq!(guarded(expected), expected);
        }
    }
}
