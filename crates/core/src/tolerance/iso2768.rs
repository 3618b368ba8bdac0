//! General tolerances of ISO 2768-1 for linear sizes: `10m`.
//!
//! The deviations of the four classes by size (table 1). Radii, chamfers and angles have tables of their own and are not
//! here.

use std::fmt;

use super::deviations::Deviations;
use crate::length::Length;
use crate::message::{Message, Say, as_text};

/// A class of ISO 2768-1, named by its small letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum GeneralClass {
    /// `f`.
    Fine,
    /// `m`.
    Medium,
    /// `c`.
    Coarse,
    /// `v`.
    VeryCoarse,
}

as_text!(GeneralClass);

/// A cell of the table: deviations, and the size range they belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GeneralCell {
    /// The same amount above and below.
    pub deviations: Deviations,
    /// Above this size; the first range includes its lower end, 0.5 mm.
    pub over: Length,
    /// Up to and including this size.
    pub to: Length,
}

/// Why a size has no general tolerance.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "general", error)]
pub enum GeneralError {
    /// Below 0.5 mm the drawing must state the deviations.
    #[say(args(first = FIRST))]
    TooSmall {
        /// The size that was asked for.
        nominal: Length,
    },
    /// The size is beyond the last range.
    #[say(args(last = last()))]
    TooLarge {
        /// The size that was asked for.
        nominal: Length,
    },
    /// The class has no value in this range.
    #[say(args(range = range(*over, *to), defined = range(*defined_over, *defined_to)))]
    NotDefined {
        /// The class that was asked for.
        class: GeneralClass,
        /// The range of the size: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// Where the class is defined: above this,
        defined_over: Length,
        /// up to and including this.
        defined_to: Length,
    },
}

/// Where the first range begins; this size belongs to it.
const FIRST: Length = Length::from_micrometres(500);

/// Ends of the size ranges and half widths of `f`, `m`, `c` and `v`, in micrometres.
const ROWS: [(i32, [Option<i32>; 4]); 8] = [
    (3_000, [Some(50), Some(100), Some(200), None]),
    (6_000, [Some(50), Some(100), Some(300), Some(500)]),
    (30_000, [Some(100), Some(200), Some(500), Some(1_000)]),
    (120_000, [Some(150), Some(300), Some(800), Some(1_500)]),
    (400_000, [Some(200), Some(500), Some(1_200), Some(2_500)]),
    (1_000_000, [Some(300), Some(800), Some(2_000), Some(4_000)]),
    (2_000_000, [Some(500), Some(1_200), Some(3_000), Some(6_000)]),
    (4_000_000, [None, Some(2_000), Some(4_000), Some(8_000)]),
];

impl GeneralClass {
    /// Every class, from fine to very coarse.
    pub const ALL: [Self; 4] = [Self::Fine, Self::Medium, Self::Coarse, Self::VeryCoarse];

    /// The letter, as in `10m`.
    pub const fn letter(self) -> char {
        match self {
            Self::Fine => 'f',
            Self::Medium => 'm',
            Self::Coarse => 'c',
            Self::VeryCoarse => 'v',
        }
    }

    /// The class of a small letter.
    pub fn from_letter(letter: &str) -> Option<Self> {
        let mut letters = letter.chars();
        let only = letters.next().filter(|_| letters.next().is_none())?;
        Self::ALL.into_iter().find(|class| class.letter() == only)
    }

    fn half_width(self, micrometres: [Option<i32>; 4]) -> Option<Length> {
        let (_, own) = Self::ALL.into_iter().zip(micrometres).find(|(class, _)| *class == self)?;
        own.map(Length::from_micrometres)
    }
}

impl fmt::Display for GeneralClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.letter().encode_utf8(&mut [0; 4]))
    }
}

/// The general tolerance of a size: 0.5 mm up to 4000 mm, each range above its lower end and up to its upper one.
///
/// ```
/// use fitcheck_core::tolerance::iso2768::{GeneralClass, deviations};
///
/// let cell = deviations(GeneralClass::Medium, "10".parse().unwrap())?;
/// assert_eq!(cell.deviations.upper().to_string(), "0.2");
/// assert_eq!(cell.deviations.lower().to_string(), "-0.2");
/// # Ok::<(), fitcheck_core::tolerance::iso2768::GeneralError>(())
/// ```
///
/// # Errors
/// [`GeneralError`] below 0.5 mm, above 4000 mm, and where the class has no value; it says where the class has one.
pub fn deviations(class: GeneralClass, nominal: Length) -> Result<GeneralCell, GeneralError> {
    if nominal < FIRST {
        return Err(GeneralError::TooSmall { nominal });
    }
    let Some((over, to, half)) = ranges(class).find(|&(_, to, _)| nominal <= to) else {
        return Err(GeneralError::TooLarge { nominal });
    };
    let Some(half) = half else {
        let defined = || ranges(class).filter(|(.., half)| half.is_some());
        let defined_over = defined().map(|(over, ..)| over).min().unwrap_or(FIRST);
        let defined_to = defined().map(|(_, to, _)| to).max().unwrap_or(FIRST);
        return Err(GeneralError::NotDefined { class, over, to, defined_over, defined_to });
    };
    Ok(GeneralCell { deviations: Deviations::spanning(half, half.negated()), over, to })
}

/// The ranges, ascending: above, up to, and half the width where the class has one.
fn ranges(class: GeneralClass) -> impl Iterator<Item = (Length, Length, Option<Length>)> {
    ROWS.iter().scan(FIRST, move |before, &(end, half_widths)| {
        let over = *before;
        let to = Length::from_micrometres(end);
        *before = to;
        Some((over, to, class.half_width(half_widths)))
    })
}

fn last() -> Length {
    ROWS.iter().map(|&(end, _)| Length::from_micrometres(end)).fold(FIRST, Length::max)
}

/// The first range includes its lower end; every other one begins above it.
fn range(over: Length, to: Length) -> Message {
    let id = if over == FIRST { "general-range-from" } else { "limits-range" };
    Message::new(id).with("over", &over).with("to", &to)
}
