//! What a mapping says of a file as a whole: what separates its cells, its decimal sign, and the units of its columns.

use std::fmt;
use std::str::FromStr;

use fitcheck_core::length::Unit;

use super::MappingError;

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Separator {
    Semicolon,
    Comma,
    Tab,
    Pipe,
}

/// What stands before the decimals of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DecimalSign {
    Point,
    Comma,
}

/// The unit of numbers in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnUnit(Unit);

impl Separator {
    pub const ALL: [Self; 4] = [Self::Semicolon, Self::Comma, Self::Tab, Self::Pipe];

    pub const fn word(self) -> &'static str {
        match self {
            Self::Semicolon => "semicolon",
            Self::Comma => "comma",
            Self::Tab => "tab",
            Self::Pipe => "pipe",
        }
    }

    pub(in crate::exchange) const fn byte(self) -> u8 {
        match self {
            Self::Semicolon => b';',
            Self::Comma => b',',
            Self::Tab => b'\t',
            Self::Pipe => b'|',
        }
    }

    /// `None` where cells need none.
    pub(super) fn of_byte(byte: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|separator| separator.byte() == byte)
    }
}

impl DecimalSign {
    pub const ALL: [Self; 2] = [Self::Point, Self::Comma];

    pub const fn word(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Comma => "comma",
        }
    }

    pub(super) const fn sign(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }

    pub(super) fn of_sign(sign: char) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.sign() == sign)
    }
}

impl ColumnUnit {
    pub const ALL: [Self; 3] = [Self(Unit::Millimetre), Self(Unit::Micrometre), Self(Unit::Inch)];

    pub const fn of(unit: Unit) -> Self {
        Self(unit)
    }

    pub const fn unit(self) -> Unit {
        self.0
    }

    pub const fn word(self) -> &'static str {
        match self.0 {
            Unit::Millimetre => "mm",
            Unit::Micrometre => "um",
            Unit::Inch => "inch",
        }
    }

    /// The unit of a text that stands behind this word of a mapping.
    pub(super) fn of_word(word: &str, given: &str) -> Result<Self, MappingError> {
        known(word, given, &Self::ALL, Self::word)
    }
}

impl FromStr for Separator {
    type Err = MappingError;

    fn from_str(text: &str) -> Result<Self, MappingError> {
        known("separator", text, &Self::ALL, Self::word)
    }
}

impl FromStr for DecimalSign {
    type Err = MappingError;

    fn from_str(text: &str) -> Result<Self, MappingError> {
        known("decimal", text, &Self::ALL, Self::word)
    }
}

impl FromStr for ColumnUnit {
    type Err = MappingError;

    fn from_str(text: &str) -> Result<Self, MappingError> {
        Self::of_word("unit", text)
    }
}

impl fmt::Display for Separator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

impl fmt::Display for DecimalSign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

impl fmt::Display for ColumnUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// The one that a text names.
fn known<T: Copy>(word: &str, given: &str, all: &[T], name: fn(T) -> &'static str) -> Result<T, MappingError> {
    all.iter().copied().find(|one| name(*one) == given).ok_or_else(|| MappingError::Value {
        word: word.to_owned(),
        given: given.to_owned(),
        allowed: all.iter().map(|one| name(*one)).collect::<Vec<_>>().join(" "),
    })
}
