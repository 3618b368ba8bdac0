//! Names of sheets: at most 31 characters, none that means something in a formula, and no name twice.

use std::collections::BTreeSet;

/// The most UTF-16 units of a name.
const LONGEST: usize = 31;

/// The names that a workbook has so far, in small letters: capitals are no difference.
#[derive(Default)]
pub(super) struct SheetNames(BTreeSet<String>);

impl SheetNames {
    /// The name, or the nearest one that a sheet may have.
    pub(super) fn of(&mut self, wanted: &str) -> String {
        let is_allowed = |c: char| !c.is_control() && !matches!(c, '[' | ']' | ':' | '*' | '?' | '/' | '\\');
        let plain: String = wanted.chars().map(|c| if is_allowed(c) { c } else { ' ' }).collect();
        let plain = super::super::told::on_one_line(&plain);
        let plain = plain.trim_matches(|c: char| c == '\'' || c.is_whitespace());
        // Spreadsheets keep this name for themselves.
        let plain = if plain.is_empty() || plain.eq_ignore_ascii_case("history") { "-" } else { plain };
        for number in 1_usize.. {
            let behind = if number == 1 { String::new() } else { format!(" ({number})") };
            let name = format!("{}{behind}", shortened(plain, LONGEST - behind.len()));
            if self.0.insert(name.to_lowercase()) {
                return name;
            }
        }
        String::new()
    }
}

/// The beginning of a text with at most so many UTF-16 units; nothing that a name must not end with.
fn shortened(text: &str, most: usize) -> &str {
    let mut units = 0;
    let end = text.char_indices().find(|(_, c)| {
        units += c.len_utf16();
        most < units
    });
    let kept = end.and_then(|(at, _)| text.get(..at)).unwrap_or(text);
    kept.trim_end_matches(|c: char| c == '\'' || c.is_whitespace())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_that_a_sheet_may_have() {
        let mut names = SheetNames::default();
        for (wanted, expected) in [
            ("Checks", "Checks"),
            ("checks", "checks (2)"),
            ("[a]:*?/\\b", "a      b"),
            ("''", "-"),
            ("History", "- (2)"),
            ("", "- (3)"),
            ("'quoted'", "quoted"),
            ("a\nb\u{202e}", "a b\u{fffd}"),
            ("0123456789012345678901234567 9'1x", "0123456789012345678901234567 9"),
        ] {
            assert_eq!(names.of(wanted), expected, "{wanted}");
        }
        let long = "\u{1f600}".repeat(40);
        let all: Vec<String> = (0..12).map(|_| names.of(&long)).collect();
        assert!(all.iter().all(|name| name.encode_utf16().count() <= LONGEST), "{all:?}");
        assert_eq!(all.iter().collect::<BTreeSet<_>>().len(), 12);
    }
}
