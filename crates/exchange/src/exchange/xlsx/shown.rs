//! The unit that a number format shows behind a number: a cell with 12 in it and the format `0.0" µm"` reads "12.0 µm" to whoever
//! looks at the sheet. Codes of formats: ECMA-376-1, 18.8.31.

use crate::exchange::units;

/// Stands for the figures in the text of a section.
const FIGURES: &str = " 0 ";

/// What people put around a unit.
const BRACKETS: [char; 4] = ['[', ']', '(', ')'];

/// What the sections of a format show beside the number and that may be a unit, each once.
///
/// A percent sign counts as one: 0.25 shows as 25 %.
pub(super) fn unit(code: &str) -> Option<String> {
    let mut units: Vec<String> = Vec::new();
    for section in sections(code) {
        let words: Vec<&str> = section.split_whitespace().map(|word| word.trim_matches(BRACKETS)).collect();
        for (at, &word) in words.iter().enumerate() {
            // A unit before the figures, and nothing else: [$in] 0.000.
            let is_before = at == 0 && words.get(1..) == Some(&[FIGURES.trim()]);
            let is_behind = words.get(..at).and_then(<[_]>::last) == Some(&FIGURES.trim()) && at + 1 == words.len();
            if (units::may_be_unit(word, is_behind || is_before) || word == "%")
                && !units.iter().any(|known| known == word)
            {
                units.push(word.to_owned());
            }
        }
    }
    (!units.is_empty()).then(|| units.join(", "))
}

/// The texts of the sections, with [`FIGURES`] where their number stands.
fn sections(code: &str) -> Vec<String> {
    let mut sections = vec![String::new()];
    let code = code.replace("General", "0").replace("GENERAL", "0").replace("general", "0");
    let mut signs = code.chars().peekable();
    while let Some(sign) = signs.next() {
        let Some(text) = sections.last_mut() else { break };
        match sign {
            '"' => text.extend(signs.by_ref().take_while(|&sign| sign != '"')),
            // Some programs write letters that stand for themselves without quotation marks.
            'a'..='z' | 'A'..='Z' => {
                let mut letters = String::from(sign);
                while let Some(letter) = signs.next_if(char::is_ascii_alphabetic) {
                    letters.push(letter);
                }
                let is_date = letters.chars().all(|letter| "ymdhsYMDHS".contains(letter));
                text.push_str(if is_date { " " } else { &letters });
            }
            '\\' => text.extend(signs.next()),
            // A blank as wide as a sign, and a sign that fills the cell.
            '_' | '*' => {
                signs.next();
                text.push(' ');
            }
            // A condition, a colour, or a text with its language: [$mm-409].
            '[' => {
                let inside: String = signs.by_ref().take_while(|&sign| sign != ']').collect();
                let literal = inside
                    .strip_prefix('$')
                    .map_or("", |inside| inside.split_once('-').map_or(inside, |(sign, _)| sign));
                text.push_str(literal);
            }
            ';' => sections.push(String::new()),
            '%' => text.push_str(" % "),
            '\u{b5}' | '\u{3bc}' | '\u{2033}' => text.push(sign),
            '0' | '#' | '?' if text.ends_with(FIGURES) => {}
            '0' | '#' | '?' | '@' => text.push_str(FIGURES),
            '.' | ',' => {}
            _ => text.push(' '),
        }
    }
    sections
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_formats_are_found() {
        for (code, expected) in [
            ("General", None),
            ("0.000", None),
            ("#,##0.000;[Red]-#,##0.000", None),
            ("0.000\" mm\"", Some("mm")),
            ("0.0\" \u{b5}m\"", Some("\u{b5}m")),
            ("0.0\\ \\\u{b5}\\m", Some("\u{b5}m")),
            ("0.0000\\\"", Some("\"")),
            ("0.0000\" in\"", Some("in")),
            ("0.0[$ \u{b5}m-407]", Some("\u{b5}m")),
            ("0.00%", Some("%")),
            ("0.000\" thou\"", Some("thou")),
            ("\"\u{d8} \"0.000", None),
            ("0\" pcs\"", None),
            ("0.000\" in stock\"", None),
            ("\"measured in \"0.000", None),
            ("\"\u{d8} in mm \"0.000", Some("mm")),
            ("#,##0.000 [$in]", Some("in")),
            ("General\" in\"", Some("in")),
            ("General\" mm\"", Some("mm")),
            ("@\" in\"", Some("in")),
            ("#,##0.0000\\\"", Some("\"")),
            ("[$in]\u{a0}0.0000", Some("in")),
            ("0.0000 in", Some("in")),
            ("0.0000 inch", Some("inch")),
            ("0.00E+00", None),
            ("yyyy-mm-dd", None),
            ("mm:ss.0", None),
            ("General", None),
            ("@", None),
            ("0.000\" mm\";-0.000\" mm\"", Some("mm")),
            ("[<1]0.0\" \u{b5}m\";0.000\" mm\"", Some("\u{b5}m, mm")),
            ("\"", None),
            ("[", None),
        ] {
            assert_eq!(unit(code).as_deref(), expected, "{code}");
        }
    }
}
