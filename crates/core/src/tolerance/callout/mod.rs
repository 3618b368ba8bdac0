//! Callouts: a nominal size and its tolerance, as drawings have them and operators type them.
//!
//! | file | what |
//! |---|---|
//! | `scanner` | a text, character by character |
//! | `reading` | the one grammar: size, then class, fit or limits |
//! | `band` | the grammar's deviations, with sign and unit; also without a size |
//! | `notes` | what stands beside size and tolerance: count, deviations in brackets, modifiers |
//! | `drawn` | texts as drawings and other programs have them, read where the grammar refuses them |
//! | `error` | why a text is not a callout, and at which character |
//! | `kind` | the reasons |
//! | `micrometres` | deviations that were written in micrometres where millimetres are read |
//! | `cycle_text` | the texts of cycles 14xx: a callout, or less, or more |
//! | `qs400` | the tolerance texts of cycle 444 |
//!
//! ```text
//! callout    = [ "Ø" ] size ( class | fit | general | deviations ) | [ "Ø" ] size "/" size ;      Ø also as φ ∅ ⌀
//! size       = number [ "mm" ] ;
//! class      = letter { letter | digit } ;                  H7, js13, PF: letters of one case, at most eight characters
//! fit        = class ( "/" | "-" ) class                    hole first: H7/g6
//!            | ( class | deviations ) "/" ( class | deviations ) ;     H7/0 -0.013, ±0.1/+0.008 +0.002
//! general    = "f" | "m" | "c" | "v" ;                      ISO 2768-1, with no digit behind it
//! deviations = ( "±" | "+/-" | "+-" ) value | signed [ [ "/" ] signed ] ;
//! signed     = ( "+" | "-" ) value | "0" ;                  upper before lower; one alone: the other is 0
//! value      = number [ "mm" | "µm" | "um" ] ;
//! number     = digits [ ( "." | "," ) digits ] ;            one kind of decimal sign in a text
//! ```
//! Blanks may separate the parts; U+2212 and U+2013 count as a minus. Names of units are no class ([`ToleranceClass`] has the
//! rule), and in the texts of cycles 14xx a class has one or two digits behind its letters. A callout says what is wanted;
//! the sources of limits say whether a class is defined at its size.
//!
//! What this refuses is tried as a drawing writes it, with notes: `[ count "x" ] callout [ "(" deviations ")" ] { "(" modifier ")" }`.

mod band;
mod cycle_text;
mod drawn;
mod error;
mod kind;
mod micrometres;
mod notes;
mod qs400;
mod reading;
mod scanner;

use std::fmt;
use std::str::FromStr;

pub use band::band;
pub use cycle_text::{CycleSize, CycleText};
pub use error::CalloutError;
pub use kind::{CalloutErrorKind, Part};
pub(super) use micrometres::{as_micrometres, thousandths};
pub use notes::{FormClass, Modifier, ModifierGroup, Modifiers, Notes};
pub use qs400::qs400;
pub use reading::halves;

use super::class::{Feature, ToleranceClass};
use super::deviations::Deviations;
use super::iso2768::GeneralClass;
use crate::length::{Length, Unit};
use crate::message::{Arg, IntoArg, as_text};

/// A nominal size above zero and its tolerance; the minimum limit that it states is also above zero.
///
/// ```
/// use fitcheck_core::tolerance::{Callout, Feature};
///
/// let callout: Callout = "Ø25,0H7".parse()?;
/// assert_eq!(callout.to_string(), "25 H7");
/// assert_eq!(callout.feature(), Some(Feature::Hole));
/// let callout: Callout = "12+0,2/0".parse()?;
/// assert_eq!((callout.to_string().as_str(), callout.feature()), ("12 +0.2 0", None));
/// # Ok::<(), fitcheck_core::tolerance::CalloutError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Callout {
    nominal: Length,
    tolerance: Tolerance,
    notes: Notes,
}

/// What a callout asks for around its nominal size.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Tolerance {
    /// One tolerance class: `25 H7`.
    Class(ToleranceClass),
    /// A hole and the shaft in it: `25 H7/g6`.
    Fit {
        /// What the hole has: a class in capitals, or deviations.
        hole: PartTolerance,
        /// What the shaft has: a class in small letters, or deviations.
        shaft: PartTolerance,
    },
    /// A general tolerance of ISO 2768-1: `10m`.
    General(GeneralClass),
    /// Deviations from the nominal size: `12 +0.01 -0.015`, `12 ±0.02`.
    Deviations(Deviations),
    /// Limits of size: `12.01/11.985`. The smaller one is at least half of the larger.
    Limits {
        /// The larger.
        maximum: Length,
        /// The smaller, or the same.
        minimum: Length,
    },
}

/// What one part of a fit has: `H7` or `0 -0.013`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PartTolerance {
    /// A class.
    Class(ToleranceClass),
    /// Deviations, which do not say hole or shaft.
    Deviations(Deviations),
}

impl PartTolerance {
    /// The class, if there is one.
    pub const fn class(self) -> Option<ToleranceClass> {
        match self {
            Self::Class(class) => Some(class),
            Self::Deviations(_) => None,
        }
    }

    fn feature(self) -> Option<Feature> {
        self.class().map(ToleranceClass::feature)
    }

    const fn alone(self) -> Tolerance {
        match self {
            Self::Class(class) => Tolerance::Class(class),
            Self::Deviations(deviations) => Tolerance::Deviations(deviations),
        }
    }
}

as_text!(PartTolerance);

/// As a callout has it: `H7`, `±0.1`, `0 -0.013`.
impl fmt::Display for PartTolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&match self {
            Self::Class(class) => class.to_string(),
            Self::Deviations(deviations) if deviations.upper() == deviations.lower().negated() => {
                format!("±{}", deviations.upper())
            }
            Self::Deviations(deviations) => format!("{} {}", signed(deviations.upper()), signed(deviations.lower())),
        })
    }
}

impl Callout {
    /// A callout of a single class: `25 H7`.
    ///
    /// # Errors
    /// [`CalloutErrorKind::NotPositive`] for a size of zero or less.
    pub fn new(nominal: Length, class: ToleranceClass) -> Result<Self, CalloutError> {
        Self::above_zero(nominal, Tolerance::Class(class))
    }

    /// A callout of a fit: `25 H7/g6`.
    ///
    /// # Errors
    /// [`CalloutErrorKind::FitOrder`] with the right order, [`CalloutErrorKind::FitSide`] for two holes or two shafts,
    /// [`CalloutErrorKind::NotPositive`].
    pub fn fit(nominal: Length, hole: ToleranceClass, shaft: ToleranceClass) -> Result<Self, CalloutError> {
        Self::of_parts(nominal, PartTolerance::Class(hole), PartTolerance::Class(shaft))
    }

    /// A callout of a fit whose parts have classes or deviations: `52 H7/0 -0.013`.
    ///
    /// # Errors
    /// Those of [`Self::fit`] and, for deviations, of [`Self::with_deviations`].
    pub fn of_parts(nominal: Length, hole: PartTolerance, shaft: PartTolerance) -> Result<Self, CalloutError> {
        match (hole.feature(), shaft.feature()) {
            (Some(Feature::Hole) | None, Some(Feature::Shaft) | None) => {
                for part in [hole, shaft] {
                    if let PartTolerance::Deviations(deviations) = part {
                        Self::with_deviations(nominal, deviations)?;
                    }
                }
                Self::above_zero(nominal, Tolerance::Fit { hole, shaft })
            }
            (Some(Feature::Shaft), Some(Feature::Hole) | None) | (None, Some(Feature::Hole)) => {
                let offer = Self::of_parts(nominal, shaft, hole)?;
                Err(CalloutErrorKind::FitOrder { offer }.into())
            }
            (Some(_), Some(_)) => Err(CalloutErrorKind::FitSide { first: hole, second: shaft }.into()),
        }
    }

    /// A callout of a general tolerance of ISO 2768-1: `10m`. [`super::iso2768::deviations`] says whether the class is
    /// defined at the size.
    ///
    /// # Errors
    /// [`CalloutErrorKind::NotPositive`] for a size of zero or less.
    pub fn general(nominal: Length, class: GeneralClass) -> Result<Self, CalloutError> {
        Self::above_zero(nominal, Tolerance::General(class))
    }

    /// A callout of a size and its deviations: `12 +0.01 -0.015`.
    ///
    /// # Errors
    /// [`CalloutErrorKind::NotPositive`], [`CalloutErrorKind::MinimumNotPositive`] or [`CalloutErrorKind::MicrometresMeant`], and
    /// [`CalloutErrorKind::TooLarge`] where a limit would be beyond [`Length::MAX`].
    pub fn with_deviations(nominal: Length, deviations: Deviations) -> Result<Self, CalloutError> {
        let callout = Self::above_zero(nominal, Tolerance::Deviations(deviations))?;
        let limits = (nominal.checked_add(deviations.lower()), nominal.checked_add(deviations.upper()));
        let (Some(minimum), Some(_)) = limits else { return Err(CalloutErrorKind::TooLarge { nominal }.into()) };
        if minimum <= Length::ZERO {
            return Err(match as_micrometres(nominal, deviations) {
                Some(offer) => CalloutErrorKind::MicrometresMeant { minimum, offer },
                None => CalloutErrorKind::MinimumNotPositive { minimum },
            }
            .into());
        }
        Ok(callout)
    }

    /// A callout of two limits of size: `12.01/11.985`. Its nominal size is their middle.
    ///
    /// # Errors
    /// [`CalloutErrorKind::LimitsOrder`] with the right order, [`CalloutErrorKind::MinimumNotPositive`],
    /// and [`CalloutErrorKind::LimitsApart`] where the smaller one is less than half of the larger: such a text may mean
    /// anything.
    pub fn with_limits(maximum: Length, minimum: Length) -> Result<Self, CalloutError> {
        let larger = maximum.max(minimum);
        let smaller = maximum.min(minimum);
        if smaller <= Length::ZERO {
            return Err(CalloutErrorKind::MinimumNotPositive { minimum: smaller }.into());
        }
        if smaller < larger.saturating_sub(smaller) {
            return Err(CalloutErrorKind::LimitsApart { larger, smaller }.into());
        }
        let nominal = larger.midpoint(smaller);
        let tolerance = Tolerance::Limits { maximum: larger, minimum: smaller };
        let callout = Self { nominal, tolerance, notes: Notes::default() };
        if maximum < minimum {
            return Err(CalloutErrorKind::LimitsOrder { offer: callout }.into());
        }
        Ok(callout)
    }

    /// An error in values has no place. A text's reader gives it that of the class or deviation (`Reader::placed`);
    /// `CalloutErrorKind::needs_place` says whether the message names it.
    fn above_zero(nominal: Length, tolerance: Tolerance) -> Result<Self, CalloutError> {
        if nominal <= Length::ZERO {
            return Err(CalloutErrorKind::NotPositive { nominal }.into());
        }
        Ok(Self { nominal, tolerance, notes: Notes::default() })
    }

    /// The same with what stands beside it.
    #[must_use]
    pub const fn with_notes(self, notes: Notes) -> Self {
        Self { notes, ..self }
    }

    /// What stands beside size and tolerance.
    pub const fn notes(&self) -> &Notes {
        &self.notes
    }

    /// The nominal size in millimetres, above zero; for limits of size their middle, with a half nanometre rounded up.
    pub const fn nominal(&self) -> Length {
        self.nominal
    }

    /// What is asked for around the nominal size.
    pub const fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    /// The tolerance class, if there is exactly one; a fit has two.
    pub const fn class(&self) -> Option<ToleranceClass> {
        match self.tolerance {
            Tolerance::Class(class) => Some(class),
            _ => None,
        }
    }

    /// The tolerance class of one feature: a single class of that feature, or that side of a fit.
    pub fn class_for(&self, feature: impl Into<Option<Feature>>) -> Option<ToleranceClass> {
        match (self.tolerance, feature.into()?) {
            (Tolerance::Class(class), feature) => (class.feature() == feature).then_some(class),
            (Tolerance::Fit { hole, .. }, Feature::Hole) => hole.class(),
            (Tolerance::Fit { shaft, .. }, Feature::Shaft) => shaft.class(),
            _ => None,
        }
    }

    /// The callout of one part: one side of a fit, or any other callout unchanged.
    #[must_use]
    pub fn of_part(self, feature: impl Into<Option<Feature>>) -> Self {
        match (self.tolerance, feature.into()) {
            (Tolerance::Fit { hole, .. }, Some(Feature::Hole)) => Self { tolerance: hole.alone(), ..self },
            (Tolerance::Fit { shaft, .. }, Some(Feature::Shaft)) => Self { tolerance: shaft.alone(), ..self },
            _ => self,
        }
    }

    /// Hole or shaft, by the case of a single class; other callouts do not say.
    pub fn feature(&self) -> Option<Feature> {
        self.class().map(ToleranceClass::feature)
    }
}

/// With the decimal sign and the minus of the language.
impl IntoArg for Callout {
    fn arg(&self) -> Arg {
        Arg::Number(self.to_string())
    }
}

impl IntoArg for Box<Callout> {
    fn arg(&self) -> Arg {
        self.as_ref().arg()
    }
}

impl FromStr for Callout {
    type Err = CalloutError;

    /// Reads the grammar at the top of this file, and else what drawings write.
    fn from_str(text: &str) -> Result<Self, CalloutError> {
        reading::callout(text).or_else(|error| drawn::callout(text, error))
    }
}

/// The single notation of each kind, which reads back as the same callout: `25 H7` as the control prints it in QS2, `25
/// H7/g6`, `10m`, `12 ±0.02`, `12 +0.2 0`, `12.01/11.985`; with notes `4x 8 H7 (+0.015 0) (E)`. Numbers have a point and only the decimals they need; zero
/// has no sign.
impl fmt::Display for Callout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let nominal = self.nominal;
        let is_plain = self.notes.is_empty();
        let text = match self.tolerance {
            // The usual one, as it is usually asked for.
            Tolerance::Class(class) if is_plain && f.width().is_none() && f.precision().is_none() => {
                f.write_str(&nominal.exact(Unit::Millimetre, 0))?;
                return write!(f, " {class}");
            }
            Tolerance::Class(class) => format!("{nominal} {class}"),
            Tolerance::Fit { hole, shaft } => format!("{nominal} {hole}/{shaft}"),
            Tolerance::General(class) => format!("{nominal}{class}"),
            Tolerance::Deviations(deviations) => format!("{nominal} {}", PartTolerance::Deviations(deviations)),
            Tolerance::Limits { maximum, minimum } => format!("{maximum}/{minimum}"),
        };
        f.pad(&if is_plain { text } else { self.notes.around(&text) })
    }
}

/// A deviation with its sign; zero has none.
pub(super) fn signed(deviation: Length) -> String {
    format!("{}{deviation}", if Length::ZERO < deviation { "+" } else { "" })
}
