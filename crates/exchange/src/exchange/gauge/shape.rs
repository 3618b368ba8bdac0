//! A line as numbers and what stands between them. What is between them has to be the same in every line of a gauge; digits are not.

/// A piece of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece<'a> {
    Number(Number<'a>),
    /// A sign that is no part of a number. Blanks are left out.
    Sign(char),
}

/// A number in a line: all of its digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Number<'a> {
    pub is_negative: bool,
    pub whole: &'a str,
    pub decimals: &'a str,
}

/// The pieces of a line, in which only `decimal` stands before decimals; without one every number is whole.
pub(super) fn pieces(line: &str, decimal: Option<char>) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let mut rest = line.trim_start();
    let mut is_behind_number = false;
    while let Some(first) = rest.chars().next() {
        let number = number(rest, decimal, is_behind_number);
        let (piece, behind) = number.map_or_else(
            || (Piece::Sign(first), rest.get(first.len_utf8()..)),
            |(number, behind)| (Piece::Number(number), Some(behind)),
        );
        pieces.push(piece);
        let behind = behind.unwrap_or("");
        rest = behind.trim_start();
        is_behind_number = matches!(piece, Piece::Number(_)) && behind.len() == rest.len();
    }
    pieces
}

/// The number at the start of a text, and what is behind it. Directly behind another number a decimal sign begins none.
fn number(text: &str, decimal: Option<char>, is_behind_number: bool) -> Option<(Number<'_>, &str)> {
    let unsigned = text.strip_prefix(['+', '-', '\u{2212}']).map(str::trim_start);
    let is_negative = unsigned.is_some() && !text.starts_with('+');
    let (whole, behind) = digits(unsigned.unwrap_or(text));
    if whole.is_empty() && is_behind_number {
        return None;
    }
    let (decimals, behind) = match decimal.and_then(|sign| behind.strip_prefix(sign)).map(digits) {
        Some((decimals, behind)) if !decimals.is_empty() => (decimals, behind),
        _ => ("", behind),
    };
    let has_digits = !(whole.is_empty() && decimals.is_empty());
    has_digits.then_some((Number { is_negative, whole, decimals }, behind))
}

fn digits(text: &str) -> (&str, &str) {
    let end = text.find(|sign: char| !sign.is_ascii_digit()).unwrap_or(text.len());
    text.split_at_checked(end).unwrap_or((text, ""))
}

/// Whether two lines are the same but for their digits and blanks.
pub(super) fn are_alike(one: &[Piece<'_>], other: &[Piece<'_>]) -> bool {
    let is_alike = |pair: (&Piece<'_>, &Piece<'_>)| match pair {
        (Piece::Number(_), Piece::Number(_)) => true,
        (Piece::Sign(one), Piece::Sign(other)) => one == other,
        _ => false,
    };
    one.len() == other.len() && one.iter().zip(other).all(is_alike)
}

impl Number<'_> {
    /// Its text with the decimal sign moved to the right by so many places, or to the left.
    pub fn moved(&self, places: i8) -> String {
        let digits = format!("{}{}", self.whole, self.decimals);
        let point = i64::try_from(self.whole.len()).unwrap_or(i64::MAX).saturating_add(i64::from(places));
        let sign = if self.is_negative { "-" } else { "" };
        let zeros = |count: i64| "0".repeat(usize::try_from(count).unwrap_or(0));
        match usize::try_from(point).ok().and_then(|point| digits.split_at_checked(point)) {
            Some((whole, decimals)) => format!("{sign}0{whole}.{decimals}0"),
            None if point < 0 => format!("{sign}0.{}{digits}", zeros(-point)),
            None => format!("{sign}{digits}{}", zeros(point.saturating_sub(i64::try_from(digits.len()).unwrap_or(0)))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape_of(line: &str, decimal: char) -> String {
        let sign = |piece: &Piece<'_>| if let Piece::Sign(sign) = piece { *sign } else { '#' };
        pieces(line, Some(decimal)).iter().map(sign).collect()
    }

    #[test]
    fn digits_and_blanks_are_free_and_everything_else_is_fixed() {
        for (line, decimal, wanted) in [
            ("M1   25.0123 mm OK", '.', "M##mmOK"),
            ("01,25.0123,mm", '.', "#,#,mm"),
            ("01,25.0123,mm", ',', "#.#,mm"),
            ("- 0.013", '.', "#"),
            ("2026-11-27 10:42 .984", '.', "####:##"),
            ("25.0123.4", '.', "#.#"),
            ("\u{f8}25,0", ',', "\u{f8}#"),
            ("", '.', ""),
        ] {
            assert_eq!(shape_of(line, decimal), wanted, "{line}");
        }
    }

    #[test]
    fn a_sign_of_the_line_is_no_place_of_a_number() {
        let are_alike = |one, other| are_alike(&pieces(one, Some('.')), &pieces(other, Some('.')));
        assert!(are_alike("#1 25.0", "#12 9.75"));
        assert!(!are_alike("#1 25.0", "3 1 25.0"));
        assert!(!are_alike("25.0 mm", "25.0 in"));
        assert!(!are_alike("25.0", "25.0 mm"));
    }

    #[test]
    fn the_decimal_sign_of_a_number_moves_to_both_sides() {
        let number = Number { is_negative: false, whole: "250", decimals: "12" };
        for (places, wanted) in [(0, "250.12"), (-2, "2.5012"), (-3, "0.25012"), (2, "25012"), (4, "2501200")] {
            let moved: fitcheck_core::length::Length = number.moved(places).parse().unwrap();
            assert_eq!(moved, wanted.parse().unwrap(), "{places}");
        }
    }
}
