//! Words and numbers of the rows of a large file.

use crate::exchange::batch::RowFate;
use crate::words::Words;

/// A whole number in groups of three digits, with spaces that do not break.
pub(in crate::gui) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if 0 < at && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{a0}');
        }
        text.push(digit);
    }
    text
}

/// The name of what became of a row.
pub(super) fn fate_text(words: &Words, fate: RowFate) -> String {
    fate.status().map_or_else(|| words.get("rows-not-judged"), |status| words.told(&status))
}
