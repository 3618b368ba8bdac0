//! The reasons why a text is not a callout, each with what is allowed instead.

use super::{Callout, PartTolerance};
use crate::length::{Length, LengthError};
use crate::message::{Message, Say};
use crate::tolerance::{ClassError, GeneralClass};

/// A part of a callout, as errors name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "callout-part")]
pub enum Part {
    /// A deviation from the nominal size.
    Deviation,
    /// A limit of size.
    Limit,
    /// The actual size after the `@` of a cycle text.
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
    /// The text ends after the size.
    NoTolerance,
    /// The class cannot be read.
    #[say(transparent)]
    Class(Box<ClassError>),
    /// A class of ISO 2768-1 in capitals, or a class of ISO 286 without its grade.
    #[say(args(capital = class.letter().to_ascii_uppercase()))]
    GeneralCapital {
        /// The general class that may be meant.
        class: GeneralClass,
        /// The callout with that class.
        offer: Callout,
    },
    /// The shaft comes before the hole.
    FitOrder {
        /// The callout in the right order.
        offer: Callout,
    },
    /// Two holes or two shafts.
    FitSide {
        /// What stands before the slash.
        first: PartTolerance,
        /// What stands after it.
        second: PartTolerance,
    },
    /// A number after the size cannot be read.
    Number {
        /// What the number means.
        part: Part,
        /// What is wrong with it.
        error: LengthError,
    },
    /// There is something else instead of a number.
    #[say(args(how = part.how()))]
    NotA {
        /// What was expected.
        part: Part,
        /// What was found.
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
    /// One deviation has a unit and the other has none: the other may be in either unit.
    NoUnit {
        /// The number without a unit.
        number: String,
    },
    /// The lower deviation comes before the upper one.
    DeviationOrder {
        /// The callout in the right order.
        offer: Callout,
    },
    /// The smaller limit comes before the larger one.
    LimitsOrder {
        /// The callout in the right order.
        offer: Callout,
    },
    /// Limits that are too far apart to be meant as limits.
    LimitsApart {
        /// The larger.
        larger: Length,
        /// The smaller.
        smaller: Length,
    },
    /// Either a minus between two sizes or a very large lower deviation.
    LimitsOrDeviation {
        /// The callout as limits.
        limits: Box<Callout>,
        /// The callout as a deviation.
        deviation: Box<Callout>,
    },
    /// Two sizes with a minus between them.
    LimitsMeant {
        /// The callout as limits.
        limits: Callout,
    },
    /// The lower deviation makes the minimum limit zero or less.
    MinimumNotPositive {
        /// The minimum limit.
        minimum: Length,
    },
    /// The same, and as micrometres the deviations would leave something.
    MicrometresMeant {
        /// The minimum limit.
        minimum: Length,
        /// The callout with micrometres.
        offer: Callout,
    },
    /// A limit would be beyond what a length can hold.
    #[say(id = "limits-too-large")]
    TooLarge {
        /// The nominal size.
        nominal: Length,
    },
    /// A point in one number and a comma in another: `1,234 +0.5` may be 1.234 mm or 1234 mm.
    MixedDecimals {
        /// The number with the other decimal sign.
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
    /// Something follows a complete callout.
    TooMuch {
        /// What was found.
        found: String,
    },
    /// A text of QS400 that is too long for a string parameter.
    TooLong {
        /// The most characters.
        most: usize,
    },
    /// A text of QS400 with the lower deviation first.
    BandOrder,
    /// Deviations without a size, with the lower one first.
    LoneOrder {
        /// The deviations in the right order.
        offer: String,
    },
    /// A size in inches with a class of ISO 286, whose steps are in millimetres.
    Inch {
        /// The size as it was given.
        given: String,
        /// The same in millimetres.
        nominal: Length,
        /// The callout in millimetres.
        offer: Callout,
    },
    /// A size in inches with something else.
    InchSize {
        /// The size as it was given.
        given: String,
        /// The same in millimetres.
        nominal: Length,
    },
    /// Inches somewhere, or a size that is no whole number of nanometres.
    InchSomewhere {
        /// What was given.
        given: String,
    },
    /// A thread.
    Thread {
        /// What was given.
        given: String,
    },
    /// A theoretically exact size, which drawings have in a box.
    Exact,
    /// A size for reference, which drawings have in brackets.
    Reference,
    /// One limit alone: `min 8`.
    OneSided {
        /// What was given.
        given: String,
    },
    /// The roughness of a surface: `Ra 0.8`.
    Roughness {
        /// What was given.
        given: String,
    },
    /// Letters in brackets that are no modifier.
    Modifier {
        /// What was given.
        given: String,
        /// The modifiers there are.
        known: String,
    },
    /// A grade that is not defined at the size, or not at all.
    Grade {
        /// What was given.
        given: String,
        /// Nominal size.
        nominal: Length,
    },
    /// A class of ANSI B4.1.
    Ansi {
        /// What was given.
        class: String,
    },
    /// Deviations in brackets that are out of all proportion to the size, and would not be as micrometres.
    StatedMicrometres {
        /// Nominal size.
        nominal: Length,
        /// The deviations with micrometres.
        offer: String,
    },
    /// Deviations in brackets behind a fit.
    StatedOfFit,
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
    /// Whether the reason alone does not show the place. Without a wildcard, so that a new reason is decided here.
    pub(super) const fn needs_place(&self) -> bool {
        match self {
            Self::Empty
            | Self::NoNominal { .. }
            | Self::Nominal(_)
            | Self::NotPositive { .. }
            | Self::NoTolerance
            | Self::TooLong { .. }
            | Self::Inch { .. }
            | Self::InchSize { .. }
            | Self::InchSomewhere { .. }
            | Self::Thread { .. }
            | Self::Exact
            | Self::Reference
            | Self::OneSided { .. }
            | Self::Roughness { .. }
            | Self::Ansi { .. } => false,
            Self::Class(_)
            | Self::GeneralCapital { .. }
            | Self::FitOrder { .. }
            | Self::FitSide { .. }
            | Self::Number { .. }
            | Self::NotA { .. }
            | Self::Missing { .. }
            | Self::NoSign { .. }
            | Self::NoUnit { .. }
            | Self::DeviationOrder { .. }
            | Self::LimitsOrder { .. }
            | Self::LimitsApart { .. }
            | Self::LimitsOrDeviation { .. }
            | Self::LimitsMeant { .. }
            | Self::MinimumNotPositive { .. }
            | Self::MicrometresMeant { .. }
            | Self::TooLarge { .. }
            | Self::MixedDecimals { .. }
            | Self::CycleSign { .. }
            | Self::NotInCycleText { .. }
            | Self::TooMuch { .. }
            | Self::BandOrder
            | Self::LoneOrder { .. }
            | Self::Modifier { .. }
            | Self::Grade { .. }
            | Self::StatedMicrometres { .. }
            | Self::StatedOfFit => true,
        }
    }
}
