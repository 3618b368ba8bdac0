//! Serial numbers that are counted up.

use fitcheck_core::text::behind;

/// The next serial number: the last figures in it are one more, and as many as before. One without figures gets a 1.
pub(super) fn next(serial: &str) -> String {
    let serial = serial.trim();
    let until = serial.trim_end_matches(|c: char| !c.is_ascii_digit());
    if until.is_empty() {
        return format!("{serial}1");
    }
    let before = until.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut counted: Vec<u8> = behind(until, before.len()).bytes().collect();
    let mut carries = true;
    for figure in counted.iter_mut().rev() {
        if !carries {
            break;
        }
        carries = *figure == b'9';
        *figure = if carries { b'0' } else { *figure + 1 };
    }
    let more = if carries { "1" } else { "" };
    let counted = String::from_utf8_lossy(&counted);
    format!("{before}{more}{counted}{}", behind(serial, until.len()))
}

/// Whether a text is a serial number and no value: it is `own`, the one after it, or of the same shape, which has a letter in it.
pub(super) fn is_like(text: &str, own: &str) -> bool {
    let text = text.trim();
    let own = own.trim();
    if text.is_empty() || own.is_empty() {
        return false;
    }
    let has_letter = own.chars().any(char::is_alphabetic);
    [own, &next(own)].into_iter().any(|serial| serial.eq_ignore_ascii_case(text))
        || has_letter && shape(text) == shape(own)
}

/// Whether a text that is still being typed is such a serial number already: no value has a letter in it.
pub(super) fn is_named(text: &str, own: &str) -> bool {
    own.chars().any(char::is_alphabetic) && is_like(text, own)
}

/// Whether what begins with this text may be a serial number of the same shape: it begins with a letter as the other one does.
pub(super) fn may_begin(text: &str, own: &str) -> bool {
    let begins = |text: &str| text.trim_start().chars().next().is_some_and(char::is_alphabetic);
    begins(text) && begins(own)
}

/// Letters and figures as such, every other sign as itself.
fn shape(text: &str) -> String {
    let of = |c: char| {
        if c.is_alphabetic() {
            'A'
        } else if c.is_numeric() {
            '9'
        } else {
            c
        }
    };
    text.chars().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::{is_like, next};

    #[test]
    fn a_serial_number_is_told_from_a_value_by_its_shape() {
        for (text, own, is_serial) in [
            ("A-0002", "A-0001", true),
            ("a-0001", "A-0001", true),
            ("B-7788", "A-0001", true),
            ("25.012", "A-0001", false),
            ("01A+0008.005", "A-0001", false),
            ("0002", "0001", true),
            ("0017", "0001", false),
            ("25.012", "", false),
            ("25.0l2", "A-0001", false),
        ] {
            assert_eq!(is_like(text, own), is_serial, "{text} {own}");
        }
    }

    #[test]
    fn the_last_figures_count_and_keep_their_width() {
        for (serial, counted) in [
            ("A-0099", "A-0100"),
            ("1", "2"),
            ("", "1"),
            ("999", "1000"),
            ("17-B", "18-B"),
            ("A", "A1"),
            ("2026-α009", "2026-α010"),
            ("00000000000000000000000000099", "00000000000000000000000000100"),
        ] {
            assert_eq!(next(serial), counted, "{serial}");
        }
    }
}
