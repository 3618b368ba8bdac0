//! The reasons why a text is not a callout, each with what is allowed instead.

use crate::length::{Length, LengthError};
use crate::message::{Message, Say};
use crate::tolerance::{ClassError, GeneralClass, ToleranceClass};

/// A part of a callout, as errors name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "callout-part")]
pub enum Part {
    /// A deviation from the nominal size.
    Deviation,
    /// A limit of size.
    Limit,
    /// The actual size behind the `@` of a cycle text.
    Actual,
}

/// The reason why a text is not a callout, a cycle text or a text of QS400.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "callout", error)]
pub enum CalloutErrorKind {
    /// There is no text.
    Empty,
    /// The text does not begin with a size.
    NoNominal {
        /// What was given.
        text: String,
    },
    /// The nominal size cannot be read.
    Nominal(#[say(name = "error")] LengthError),
    /// ISO 286 and the control's tables begin above 0 mm. Program 8255 has no such check: a size of 0 or less would
    /// read its table's first row.
    NotPositive {
        /// What was given.
        nominal: Length,
    },
    /// The text ends behind the size.
    NoTolerance,
    /// The class cannot be read.
    #[say(transparent)]
    Class(Box<ClassError>),
    /// A class of ISO 2768-1 in capitals, or a class of ISO 286 without its grade.
    #[say(args(capital = class.letter().to_ascii_uppercase()))]
    GeneralCapital {
        /// The general class that it may be.
        class: GeneralClass,
        /// The callout with it.
        offer: String,
    },
    /// The shaft stands before the hole.
    FitOrder {
        /// The callout in the right order.
        offer: String,
    },
    /// Two holes or two shafts.
    FitSide {
        /// The class before the stroke.
        first: ToleranceClass,
        /// The class behind it.
        second: ToleranceClass,
    },
    /// A number behind the size cannot be read.
    Number {
        /// What it stands for.
        part: Part,
        /// What is wrong with it.
        error: LengthError,
    },
    /// There is something else instead of a number.
    #[say(args(how = part.how()))]
    NotA {
        /// What was expected.
        part: Part,
        /// What stands there.
        found: String,
    },
    /// The text ends where a number was expected.
    #[say(args(how = part.how()))]
    Missing {
        /// What was expected.
        part: Part,
    },
    /// A deviation other than zero without a sign, or a blank within a number.
    NoSign {
        /// The number.
        number: String,
    },
    /// One deviation has a unit and the other has none: it may be meant in either.
    NoUnit {
        /// The number without a unit.
        number: String,
    },
    /// The lower deviation stands before the upper one.
    DeviationOrder {
        /// The callout in the right order.
        offer: String,
    },
    /// The smaller limit stands before the larger one.
    LimitsOrder {
        /// The callout in the right order.
        offer: String,
    },
    /// Limits so far apart that they are hardly limits.
    LimitsApart {
        /// The larger.
        larger: Length,
        /// The smaller.
        smaller: Length,
    },
    /// A minus between two sizes, or a very large lower deviation.
    LimitsOrDeviation {
        /// The callout as limits.
        limits: String,
        /// The callout as a deviation.
        deviation: String,
    },
    /// Two sizes with a minus between them.
    LimitsMeant {
        /// The callout as limits.
        limits: String,
    },
    /// The lower deviation takes all of the size away.
    MinimumNotPositive {
        /// The minimum limit.
        minimum: Length,
    },
    /// A limit would be beyond what a length can hold.
    #[say(id = "limits-too-large")]
    TooLarge {
        /// The nominal size.
        nominal: Length,
    },
    /// A point in one number and a comma in another: `1,234 +0.5` may be 1.234 mm or 1234 mm.
    MixedDecimals {
        /// The number with the other sign.
        number: String,
    },
    /// `?` and `@` in a callout.
    CycleSign {
        /// The sign.
        sign: char,
    },
    /// A fit or limits of size in a text of the cycles 14xx.
    NotInCycleText {
        /// The sign that begins it.
        found: char,
    },
    /// Something behind a whole callout.
    TooMuch {
        /// What stands there.
        found: String,
    },
    /// A text of QS400 that no string parameter can hold.
    TooLong {
        /// The most characters.
        most: usize,
    },
    /// A text of QS400 with the lower deviation first.
    BandOrder,
}

impl Part {
    const fn how(self) -> Message {
        Message::new(match self {
            Self::Deviation => "callout-how-deviation",
            Self::Limit => "callout-how-limit",
            Self::Actual => "callout-how-actual",
        })
    }
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
