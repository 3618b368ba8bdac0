//! Standard tolerance grades, IT01 to IT18, and the letters of tolerance classes.

use std::fmt;

use super::figures::{self, Row};

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

    /// The grade of `01`, `0`, `1` to `18`; other spellings such as `07` are none.
    pub(super) fn from_digits(digits: &[u8]) -> Option<Self> {
        match *digits {
            [b'0', b'1'] => Some(Self(0)),
            [b'0'] => Some(Self(1)),
            [one @ b'1'..=b'9'] => Self::numbered(one - b'0'),
            [b'1', one @ b'0'..=b'8'] => Self::numbered(10 + one - b'0'),
            _ => None,
        }
    }

    /// The two digits in ASCII; the second is 0 where there is one.
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
    ($($name:ident $text:literal)*) => {
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
        }
    };
}

letters! {
    A "a" B "b" C "c" Cd "cd" D "d" E "e" Ef "ef" F "f" Fg "fg" G "g" H "h" J "j" Js "js" K "k" M "m" N "n" P "p" R "r"
    S "s" T "t" U "u" V "v" X "x" Y "y" Z "z" Za "za" Zb "zb" Zc "zc"
}

impl Letter {
    /// From letters of either case; i, l, o, q, w do not exist.
    pub(super) fn from_letters(letters: &[u8]) -> Option<Self> {
        let (first, second) = match *letters {
            [one] => (one, 0),
            [one, two] => (one, two),
            _ => return None,
        };
        Some(match (first.to_ascii_lowercase(), second.to_ascii_lowercase()) {
            (b'a', 0) => Self::A,
            (b'b', 0) => Self::B,
            (b'c', 0) => Self::C,
            (b'c', b'd') => Self::Cd,
            (b'd', 0) => Self::D,
            (b'e', 0) => Self::E,
            (b'e', b'f') => Self::Ef,
            (b'f', 0) => Self::F,
            (b'f', b'g') => Self::Fg,
            (b'g', 0) => Self::G,
            (b'h', 0) => Self::H,
            (b'j', 0) => Self::J,
            (b'j', b's') => Self::Js,
            (b'k', 0) => Self::K,
            (b'm', 0) => Self::M,
            (b'n', 0) => Self::N,
            (b'p', 0) => Self::P,
            (b'r', 0) => Self::R,
            (b's', 0) => Self::S,
            (b't', 0) => Self::T,
            (b'u', 0) => Self::U,
            (b'v', 0) => Self::V,
            (b'x', 0) => Self::X,
            (b'y', 0) => Self::Y,
            (b'z', 0) => Self::Z,
            (b'z', b'a') => Self::Za,
            (b'z', b'b') => Self::Zb,
            (b'z', b'c') => Self::Zc,
            _ => return None,
        })
    }

    /// The printed row of fundamental deviations; h, j, js and the zeros of k have none.
    pub(super) const fn row(self) -> Option<&'static Row> {
        Some(match self {
            Self::A => &figures::A,
            Self::B => &figures::B,
            Self::C => &figures::C,
            Self::Cd => &figures::CD,
            Self::D => &figures::D,
            Self::E => &figures::E,
            Self::Ef => &figures::EF,
            Self::F => &figures::F,
            Self::Fg => &figures::FG,
            Self::G => &figures::G,
            Self::K => &figures::K,
            Self::M => &figures::M,
            Self::N => &figures::N,
            Self::P => &figures::P,
            Self::R => &figures::R,
            Self::S => &figures::S,
            Self::T => &figures::T,
            Self::U => &figures::U,
            Self::V => &figures::V,
            Self::X => &figures::X,
            Self::Y => &figures::Y,
            Self::Z => &figures::Z,
            Self::Za => &figures::ZA,
            Self::Zb => &figures::ZB,
            Self::Zc => &figures::ZC,
            Self::H | Self::J | Self::Js => return None,
        })
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
        for letters in ["i", "l", "o", "q", "w", "ab", "hj", "zd", ""] {
            assert_eq!(Letter::from_letters(letters.as_bytes()), None, "{letters}");
        }
    }
}
