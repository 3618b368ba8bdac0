//! Standard tolerance grades, IT01 to IT18, and the letters of tolerance classes.

use std::fmt;

use super::figures::{self, LetterDeviations};

/// A standard tolerance grade: 01, 0, 1 to 18.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Grade(u8);

impl Grade {
    /// The finest grade, IT01.
    pub const FINEST: Self = Self(0);
    /// The coarsest grade, IT18.
    pub const COARSEST: Self = Self(19);

    pub(super) const IT5: Self = Self(6);
    pub(super) const IT6: Self = Self(7);
    pub(super) const IT7: Self = Self(8);
    pub(super) const IT8: Self = Self(9);

    /// Every grade from the finest to the coarsest.
    pub fn all() -> impl Iterator<Item = Self> {
        (Self::FINEST.0..=Self::COARSEST.0).map(Self)
    }

    /// A letter with every grade.
    pub(super) fn of_letter(letter: Letter) -> impl Iterator<Item = (Letter, Self)> {
        Self::all().map(move |grade| (letter, grade))
    }

    /// IT1 to IT18 by its number; `None` beyond.
    pub const fn numbered(number: u8) -> Option<Self> {
        if 1 <= number && number <= 18 { Some(Self(number + 1)) } else { None }
    }

    /// The grade of `01`, `0`, `1` to `18`; other spellings such as `07` are not grades.
    pub(super) fn from_digits(digits: &[u8]) -> Option<Self> {
        match *digits {
            [b'0', b'1'] => Some(Self(0)),
            [b'0'] => Some(Self(1)),
            [one @ b'1'..=b'9'] => Self::numbered(one - b'0'),
            [b'1', one @ b'0'..=b'8'] => Self::numbered(10 + one - b'0'),
            _ => None,
        }
    }

    /// The two digits in ASCII; the second is 0 where there is only one.
    pub(in super::super) const fn digits(self) -> [u8; 2] {
        match self.0 {
            0 => [b'0', b'1'],
            number @ 1..=10 => [b'0' + number - 1, 0],
            number => [b'1', b'0' + number - 11],
        }
    }

    /// The grade one finer, `None` for IT01.
    pub(super) const fn finer(self) -> Option<Self> {
        if self.0 == 0 { None } else { Some(Self(self.0 - 1)) }
    }

    /// The row of [`figures::STANDARD_TOLERANCES`].
    pub(super) fn row(self) -> usize {
        usize::from(self.0)
    }

    /// Whether the grade is at most IT`number`.
    pub(super) const fn at_most(self, number: u8) -> bool {
        self.0 <= number + 1
    }

    /// Whether the grade is IT`number` or coarser.
    pub(super) const fn at_least(self, number: u8) -> bool {
        number < self.0
    }
}

/// The figures alone: `01`, `7`.
impl fmt::Display for Grade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 => f.pad("01"),
            number => f.pad(&(number - 1).to_string()),
        }
    }
}

macro_rules! letters {
    ($($name:ident $text:literal $(=> $row:ident)?),* $(,)?) => {
        /// The letters of ISO 286 without their case: where a zone lies.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Letter { $(#[doc = concat!("`", $text, "`")] $name),* }

        impl Letter {
            /// Every letter in the standard's order: from the loosest shaft to the tightest.
            pub const ALL: [Self; 28] = [$(Self::$name),*];

            /// In small letters, as for a shaft.
            pub const fn text(self) -> &'static str {
                match self { $(Self::$name => $text),* }
            }

            /// The printed row of fundamental deviations; h, j, js and the zeros of k have none.
            pub(super) fn row(self) -> Option<&'static LetterDeviations> {
                let row: &[&'static LetterDeviations] = match self { $(Self::$name => &[$(&figures::$row)?]),* };
                row.first().copied()
            }
        }
    };
}

letters! {
    A "a" => A, B "b" => B, C "c" => C, Cd "cd" => CD, D "d" => D, E "e" => E, Ef "ef" => EF, F "f" => F,
    Fg "fg" => FG, G "g" => G, H "h", J "j", Js "js", K "k" => K, M "m" => M, N "n" => N, P "p" => P, R "r" => R,
    S "s" => S, T "t" => T, U "u" => U, V "v" => V, X "x" => X, Y "y" => Y, Z "z" => Z, Za "za" => ZA,
    Zb "zb" => ZB, Zc "zc" => ZC,
}

impl Letter {
    /// From letters of either case; i, l, o, q, w do not exist.
    pub(super) fn from_letters(letters: &[u8]) -> Option<Self> {
        // The search for a fit asks this some hundred thousand times: two bytes compare as one number.
        let key = |letters: &[u8]| match *letters {
            [one] => Some([one.to_ascii_lowercase(), 0]),
            [one, two] if two != 0 => Some([one.to_ascii_lowercase(), two.to_ascii_lowercase()]),
            _ => None,
        };
        let wanted = key(letters)?;
        // They stand in the order of the alphabet.
        let place = Self::ALL.binary_search_by_key(&Some(wanted), |letter| key(letter.text().as_bytes())).ok()?;
        Self::ALL.get(place).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grades_and_letters_read_as_they_print() {
        let grades: Vec<String> = Grade::all().map(|grade| grade.to_string()).collect();
        assert_eq!(grades.join(" "), "01 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18");
        for grade in Grade::all() {
            assert_eq!(Grade::from_digits(grade.to_string().as_bytes()), Some(grade));
        }
        for digits in ["", "00", "07", "19", "20", "001", "x"] {
            assert_eq!(Grade::from_digits(digits.as_bytes()), None, "{digits}");
        }
        for letter in Letter::ALL {
            assert_eq!(Letter::from_letters(letter.text().as_bytes()), Some(letter));
            assert_eq!(Letter::from_letters(letter.text().to_uppercase().as_bytes()), Some(letter));
        }
        for letters in ["i", "l", "o", "q", "w", "ab", "hj", "zd", "a\0", "aaa", ""] {
            assert_eq!(Letter::from_letters(letters.as_bytes()), None, "{letters}");
        }
    }
}
