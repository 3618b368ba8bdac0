//! A line of a file, taken apart: an entry with its key, or the values of a part.

use std::fmt;

/// Between the characteristics of a line of values.
pub(super) const BETWEEN_CHARACTERISTICS: char = '\u{f}';

pub(super) const BETWEEN_FIELDS: char = '\u{14}';

/// The number of a field, as in `K2110`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Key(pub(super) u16);

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "K{:04}", self.0)
    }
}

/// What a field belongs to, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Level {
    /// How many characteristics the file has: `K0100`.
    Count,
    Value,
    Part,
    Characteristic,
    /// Groups, catalogues, charts and whatever else there is.
    Other,
}

impl Key {
    pub(super) const fn level(self) -> Level {
        match self.0 {
            100 => Level::Count,
            1..=99 => Level::Value,
            1000..=1999 => Level::Part,
            2000..=2999 => Level::Characteristic,
            _ => Level::Other,
        }
    }

    /// Whether values are judged by an entry of a characteristic.
    pub(super) const fn is_judged_by(self) -> bool {
        matches!(self.0, 2004 | 2009 | 2101 | 2103 | 2104 | 2110..=2115 | 2120 | 2121 | 2142 | 2151)
    }

    /// Whether an entry of parts or characteristics is used; the others are told.
    pub(super) const fn is_used(self) -> bool {
        // K1000 and K2000 are the numbers that the file itself counts with.
        matches!(self.0, 1000..=1002 | 1222 | 2000..=2002 | 2004 | 2009 | 2022 | 2101 | 2103 | 2104 | 2106)
            || matches!(self.0, 2110..=2115 | 2120 | 2121 | 2142 | 2151 | 2152)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Line<'a> {
    Blank,
    Entry(Entry<'a>),
    /// Values without keys.
    Values(&'a str),
    /// Nothing that is known.
    Unknown,
}

/// `K0001/2/3 25.0123`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Entry<'a> {
    pub(super) key: Key,
    /// The number of the part or characteristic; 0 means each of them, and a key alone means the first.
    pub(super) index: u32,
    /// Whether the line says that number.
    pub(super) has_index: bool,
    pub(super) value: Option<u32>,
    pub(super) text: &'a str,
}

/// Takes a line apart.
pub(super) fn line(text: &str) -> Line<'_> {
    // Files of old systems end with this sign.
    let text = text.trim().trim_end_matches('\u{1a}');
    if text.is_empty() {
        Line::Blank
    } else if let Some(entry) = entry(text) {
        Line::Entry(entry)
    } else if text.contains([BETWEEN_CHARACTERISTICS, BETWEEN_FIELDS]) || is_number(text) {
        Line::Values(text)
    } else {
        Line::Unknown
    }
}

fn entry(text: &str) -> Option<Entry<'_>> {
    let rest = text.strip_prefix('K')?;
    let (key, rest) = rest.split_at_checked(4)?;
    let key = Key(number(key)?.try_into().ok()?);
    let (indices, text) = rest.split_once([' ', '\t']).unwrap_or((rest, ""));
    let text = text.trim();
    if indices.is_empty() {
        return Some(Entry { key, index: 1, has_index: false, value: None, text });
    }
    let indices = indices.strip_prefix('/')?;
    let (index, value) = match indices.split_once('/') {
        Some((index, value)) if key.level() == Level::Value => (index, Some(number(value)?)),
        Some(_) => return None,
        None => (indices, None),
    };
    Some(Entry { key, index: number(index)?, has_index: true, value, text })
}

/// A whole number of figures alone.
pub(super) fn number(text: &str) -> Option<u32> {
    if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    text.parse().ok()
}

/// Whether a line is a number alone: one value.
fn is_number(text: &str) -> bool {
    let begins = text.starts_with(|sign: char| sign.is_ascii_digit() || "+-.,\u{2212}".contains(sign));
    begins && text.chars().all(|sign| sign.is_ascii_digit() || "+-.,eE\u{2212}".contains(sign))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, key: u16, index: u32, value: Option<u32>, rest: &str) {
        let has_index = text.contains('/');
        assert_eq!(line(text), Line::Entry(Entry { key: Key(key), index, has_index, value, text: rest }), "{text}");
    }

    #[test]
    fn a_key_has_one_number_two_or_none() {
        check("K0100 2", 100, 1, None, "2");
        check("K2002/2 SHAFT1 25 g6", 2002, 2, None, "SHAFT1 25 g6");
        check("K2142/0 mm", 2142, 0, None, "mm");
        check("K0001/1/3 25.0123", 1, 1, Some(3), "25.0123");
        check("K0001/1", 1, 1, None, "");
        check("  K0001/12   25 ", 1, 12, None, "25");
        check("K1001 PN-4711", 1001, 1, None, "PN-4711");
    }

    #[test]
    fn a_line_of_values_has_its_signs_or_is_a_number() {
        for text in ["25.0123\u{14}0\u{f}24.9\u{14}0", "25.0123", "-1.5E+0001", "\u{14}255", "K0\u{f}"] {
            assert_eq!(line(text), Line::Values(text), "{text}");
        }
        for text in ["K001 5", "K0001/x 5", "K0001/1/ 5", "K2002/1/1 5", "K0001;5", "25 mm", "x", "K"] {
            assert_eq!(line(text), Line::Unknown, "{text}");
        }
        assert_eq!(line(" \u{1a}"), Line::Blank);
    }
}
