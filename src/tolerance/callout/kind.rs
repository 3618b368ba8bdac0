//! The reasons why a text is no callout, each with what is allowed instead.

use crate::length::{Length, LengthError};
use crate::tolerance::{ClassError, GeneralClass, ToleranceClass};

/// A part of a callout, as errors name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// A deviation from the nominal size.
    Deviation,
    /// A limit of size.
    Limit,
    /// The actual size behind the `@` of a cycle text.
    Actual,
}

/// The reason why a text is no callout, no cycle text or no text of QS400.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CalloutErrorKind {
    /// There is no text.
    #[error("a callout is missing: write a nominal size and a tolerance class, such as 25 H7")]
    Empty,
    /// The text does not begin with a size.
    #[error("{text} does not begin with a nominal size: write one, such as 25 H7")]
    NoNominal {
        /// What was given.
        text: String,
    },
    /// The nominal size cannot be read.
    #[error("nominal size: {0}")]
    Nominal(LengthError),
    /// ISO 286 and the control's tables begin above 0 mm. Program 8255 has no such check: a size of 0 or less would
    /// read its table's first row.
    #[error("nominal size {nominal} mm is not above 0")]
    NotPositive {
        /// What was given.
        nominal: Length,
    },
    /// The text ends behind the size.
    #[error("a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1")]
    NoTolerance,
    /// The class cannot be read.
    #[error("{0}")]
    Class(Box<ClassError>),
    /// A class of ISO 2768-1 in capitals, or a class of ISO 286 without its grade.
    #[error("{} has no grade: write {offer} for the general tolerance of ISO 2768-1, or a grade, such as {}7",
        capital(*.class), capital(*.class))]
    GeneralCapital {
        /// The general class that it may be.
        class: GeneralClass,
        /// The callout with it.
        offer: String,
    },
    /// The shaft stands before the hole.
    #[error("the shaft stands before the hole: write {offer}")]
    FitOrder {
        /// The callout in the right order.
        offer: String,
    },
    /// Two holes or two shafts.
    #[error("{first} and {second} are no hole and shaft: a fit has capitals, then small letters, such as 25 H7/g6")]
    FitSide {
        /// The class before the stroke.
        first: ToleranceClass,
        /// The class behind it.
        second: ToleranceClass,
    },
    /// A number behind the size cannot be read.
    #[error("{}: {error}", part.name())]
    Number {
        /// What it stands for.
        part: Part,
        /// What is wrong with it.
        error: LengthError,
    },
    /// There is something else instead of a number.
    #[error("{found} is no {}: {}", part.name(), part.how())]
    NotA {
        /// What was expected.
        part: Part,
        /// What stands there.
        found: String,
    },
    /// The text ends where a number was expected.
    #[error("a {} is missing: {}", part.name(), part.how())]
    Missing {
        /// What was expected.
        part: Part,
    },
    /// A deviation other than zero without a sign, or a blank within a number.
    #[error("{number} has no sign: write +{number} or -{number} for a deviation, and no blank within a number")]
    NoSign {
        /// The number.
        number: String,
    },
    /// One deviation has a unit and the other has none: it may be meant in either.
    #[error("{number} has no unit and the other deviation is in µm: write the unit behind both")]
    NoUnit {
        /// The number without a unit.
        number: String,
    },
    /// The lower deviation stands before the upper one.
    #[error("the lower deviation stands before the upper one: write {offer}")]
    DeviationOrder {
        /// The callout in the right order.
        offer: String,
    },
    /// The smaller limit stands before the larger one.
    #[error("the smaller limit stands before the larger one: write {offer}")]
    LimitsOrder {
        /// The callout in the right order.
        offer: String,
    },
    /// Limits so far apart that they are hardly limits.
    #[error(
        "{larger} mm is more than twice {smaller} mm, so these are hardly limits: write deviations, such as 12 +0.2 0"
    )]
    LimitsApart {
        /// The larger.
        larger: Length,
        /// The smaller.
        smaller: Length,
    },
    /// A minus between two sizes, or a very large lower deviation.
    #[error("this is ambiguous: write {limits} for limits of size or {deviation} for a lower deviation")]
    LimitsOrDeviation {
        /// The callout as limits.
        limits: String,
        /// The callout as a deviation.
        deviation: String,
    },
    /// Two sizes with a minus between them.
    #[error("a deviation of that size leaves nothing: write {limits} for limits of size")]
    LimitsMeant {
        /// The callout as limits.
        limits: String,
    },
    /// The lower deviation takes all of the size away.
    #[error("minimum limit {minimum} mm is not above 0")]
    MinimumNotPositive {
        /// The minimum limit.
        minimum: Length,
    },
    /// A limit would be beyond what a length can hold.
    #[error("the limits of {nominal} mm are too large")]
    TooLarge {
        /// The nominal size.
        nominal: Length,
    },
    /// A point in one number and a comma in another: `1,234 +0.5` may be 1.234 mm or 1234 mm.
    #[error("{number} has another decimal sign than the number before: write one kind")]
    MixedDecimals {
        /// The number with the other sign.
        number: String,
    },
    /// `?` and `@` in a callout.
    #[error("{sign} belongs to the texts of cycles 14xx and not to a callout")]
    CycleSign {
        /// The sign.
        sign: char,
    },
    /// A fit or limits of size in a text of the cycles 14xx.
    #[error("{found} cannot stand in a text of cycles 14xx: write a class, a general class or deviations")]
    NotInCycleText {
        /// The sign that begins it.
        found: char,
    },
    /// Something behind a whole callout.
    #[error("{found} is too much: the text ends before it")]
    TooMuch {
        /// What stands there.
        found: String,
    },
    /// A text of QS400 that no string parameter can hold.
    #[error("the text is too long: at most {most} characters")]
    TooLong {
        /// The most characters.
        most: usize,
    },
    /// A text of QS400 with the lower deviation first.
    #[error("the lower deviation stands before the upper one: QS400 is written as 0.4-0.1")]
    BandOrder,
}

impl Part {
    const fn name(self) -> &'static str {
        match self {
            Self::Deviation => "deviation",
            Self::Limit => "limit of size",
            Self::Actual => "value behind @",
        }
    }

    const fn how(self) -> &'static str {
        match self {
            Self::Deviation => "write a sign and a number, such as +0.1 or -0.1",
            Self::Limit => "write two sizes, the larger first, such as 12.01/11.985",
            Self::Actual => "write a number, such as 10H7@10.004",
        }
    }
}

/// The letter of a general class as a capital.
pub(super) const fn capital(class: GeneralClass) -> char {
    class.letter().to_ascii_uppercase()
}

impl CalloutErrorKind {
    /// Whether the reason alone does not tell the place.
    pub(super) const fn needs_place(&self) -> bool {
        !matches!(
            self,
            Self::Empty
                | Self::NoNominal { .. }
                | Self::Nominal(_)
                | Self::NotPositive { .. }
                | Self::NoTolerance
                | Self::TooLong { .. }
        )
    }
}
