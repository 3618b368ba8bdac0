//! What a drawing writes beside a size and its tolerance: how many features the callout is for, deviations in brackets behind a
//! class, modifiers, a class for form. It is kept with the callout; what a measured value says of it is in `probing`.

use std::fmt;

use super::signed;
use crate::message::as_text;
use crate::tolerance::deviations::Deviations;

/// The most features that one callout can be for.
pub const MOST_FEATURES: u16 = 9_999;

/// What stands beside a size and its tolerance.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Notes {
    /// How many features the callout is for: `4x 8 H7`. Never 0.
    pub count: Option<u16>,
    /// Deviations that stand behind the tolerance, in brackets: `25 H7 (+0.021 0)`. The tolerance counts; they are compared with it.
    pub stated: Option<Deviations>,
    /// The modifiers of ISO 14405-1: `25 H7 (E)`.
    pub modifiers: Modifiers,
    /// The class of ISO 2768-2 behind that of ISO 2768-1: `10 mK`.
    pub form: Option<FormClass>,
}

/// A class of ISO 2768-2 for form and position.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FormClass {
    /// `H`.
    H,
    /// `K`.
    K,
    /// `L`.
    L,
}

as_text!(FormClass, Modifier);

crate::named! {
    /// Which size of a feature is meant, or under which conditions it holds: a specification modifier of ISO 14405-1:2016, tables 1 and 2.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Modifier {
        /// Every modifier, in the order in which they are written.
        ALL;
        /// The letters on the drawing, in a circle or an oval there: `E`, `GG`.
        fn letters;
        /// Each two-point size: what a size without a modifier means, too.
        TwoPoint = "LP",
        /// Each local size defined by a sphere.
        Sphere = "LS",
        /// The least-squares size.
        LeastSquares = "GG",
        /// The maximum inscribed size.
        Inscribed = "GX",
        /// The minimum circumscribed size.
        Circumscribed = "GN",
        /// The minimax size.
        Minimax = "GC",
        /// The diameter by the circumference.
        Circumference = "CC",
        /// The diameter by the area.
        Area = "CA",
        /// The diameter by the volume.
        Volume = "CV",
        /// The largest of the local sizes.
        Largest = "SX",
        /// The smallest of the local sizes.
        Smallest = "SN",
        /// The average of the local sizes.
        Average = "SA",
        /// The median of the local sizes.
        Median = "SM",
        /// The middle of the local sizes.
        Middle = "SD",
        /// The range of the local sizes.
        Range = "SR",
        /// The standard deviation of the local sizes.
        StandardDeviation = "SQ",
        /// The envelope requirement.
        Envelope = "E",
        /// Any cross section.
        AnyCrossSection = "ACS",
        /// A specific cross section.
        SpecificCrossSection = "SCS",
        /// Any longitudinal section.
        AnyLongitudinalSection = "ALS",
        /// One tolerance for several features as if they were one.
        Common = "CT",
        /// Several features as one.
        United = "UF",
        /// Not clamped.
        FreeState = "F",
    }
}

/// What a modifier asks for, as far as one measured diameter is concerned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModifierGroup {
    /// Each two-point size.
    TwoPoint,
    /// The least-squares size.
    LeastSquares,
    /// An envelope of perfect form.
    Envelope,
    /// Another size, which a diameter alone does not show.
    OtherSize,
    /// Where or how the size is measured.
    Condition,
}

/// Modifiers, each at most once.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Modifiers(u32);

impl Modifier {
    /// The modifier of its letters.
    pub fn from_letters(letters: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|modifier| modifier.letters() == letters)
    }

    /// What it asks for, as far as one measured diameter is concerned.
    pub const fn group(self) -> ModifierGroup {
        match self {
            Self::TwoPoint => ModifierGroup::TwoPoint,
            Self::LeastSquares => ModifierGroup::LeastSquares,
            Self::Envelope => ModifierGroup::Envelope,
            Self::Sphere
            | Self::Inscribed
            | Self::Circumscribed
            | Self::Minimax
            | Self::Circumference
            | Self::Area
            | Self::Volume
            | Self::Largest
            | Self::Smallest
            | Self::Average
            | Self::Median
            | Self::Middle
            | Self::Range
            | Self::StandardDeviation => ModifierGroup::OtherSize,
            Self::AnyCrossSection
            | Self::SpecificCrossSection
            | Self::AnyLongitudinalSection
            | Self::Common
            | Self::United
            | Self::FreeState => ModifierGroup::Condition,
        }
    }

    fn bit(self) -> u32 {
        Self::ALL.iter().position(|modifier| *modifier == self).map_or(0, |place| 1 << place)
    }
}

/// In brackets: `(E)`.
impl fmt::Display for Modifier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({})", self.letters())
    }
}

impl Modifiers {
    /// Whether there is none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Adds one.
    pub fn add(&mut self, modifier: Modifier) {
        self.0 |= modifier.bit();
    }

    /// Those there are, in the order in which they are written.
    pub fn iter(self) -> impl Iterator<Item = Modifier> {
        Modifier::ALL.into_iter().filter(move |modifier| self.0 & modifier.bit() != 0)
    }
}

impl FormClass {
    /// Every class.
    pub const ALL: [Self; 3] = [Self::H, Self::K, Self::L];

    /// The letter.
    pub const fn letter(self) -> char {
        match self {
            Self::H => 'H',
            Self::K => 'K',
            Self::L => 'L',
        }
    }

    /// The class of a letter.
    pub fn from_letter(letter: char) -> Option<Self> {
        Self::ALL.into_iter().find(|class| class.letter() == letter)
    }
}

impl fmt::Display for FormClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.letter().encode_utf8(&mut [0; 4]))
    }
}

impl Notes {
    /// Whether there is nothing beside size and tolerance.
    pub const fn is_empty(&self) -> bool {
        self.count.is_none() && self.stated.is_none() && self.modifiers.is_empty() && self.form.is_none()
    }

    /// A callout's text with its notes around it, which reads back as the same: `4x 8 H7 (+0.015 0) (E)`.
    pub(super) fn around(&self, text: &str) -> String {
        let count = self.count.map_or_else(String::new, |count| format!("{count}x "));
        let form = self.form.map_or_else(String::new, |class| class.to_string());
        let stated = self
            .stated
            .map_or_else(String::new, |stated| format!(" ({} {})", signed(stated.upper()), signed(stated.lower())));
        let mut whole = format!("{count}{text}{form}{stated}");
        for modifier in self.modifiers.iter() {
            whole.push(' ');
            whole.push_str(&modifier.to_string());
        }
        whole
    }
}
