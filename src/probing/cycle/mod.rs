//! What a measuring cycle declares: its parameters, once, with name, unit, range and default.
//!
//! Range errors, and later forms and NC blocks, are made from the declaration. Where contacts come from is not a
//! cycle's business.
//!
//! | file | what |
//! |---|---|
//! | `parameter` | one parameter: Q number, name, range, default |
//! | `value` | what is put in: lengths, angles, whole numbers |

mod parameter;
mod value;

pub use parameter::{Parameter, Range};
pub(in crate::probing) use value::QUARTER_TURN;
pub use value::{Angle, Inputs, Value};

use super::circle::{Circle, CircleError};
use super::contact::{Contact, NoContact, Prober};
use crate::length::{Length, LengthError};
use crate::verdict::{PositionVerdict, Status};
use crate::words::{Language, Message, Say};

/// A measuring cycle of the control.
#[derive(Debug)]
pub struct Cycle {
    /// Its number, 421.
    pub number: u16,
    /// Its name in NC programs, by dialogue language.
    pub names: &'static [(Language, &'static str)],
    /// Its parameters in the order of NC programs.
    pub parameters: &'static [Parameter],
    /// Runs it.
    pub run: fn(&Inputs, &mut dyn Prober) -> Result<CycleResult, CycleError>,
}

/// What a cycle found.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleResult {
    /// The contacts in probing order.
    pub contacts: Vec<Contact>,
    /// The least-squares circle, unrounded, mm.
    pub circle: Circle,
    /// The centre, at the nearest nanometre.
    pub centre: [Length; 2],
    /// The diameter, at the nearest nanometre.
    pub diameter: Length,
    /// The centre against its nominal position.
    pub position: PositionVerdict,
    /// The status that the markers tell; `Good` also where no limits were given, as on the control.
    pub status: Status,
    /// The result parameters by Q number: lengths in mm, markers 0 or 1.
    pub results: Vec<(u16, Value)>,
}

/// Why a cycle did not run, or not to its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CycleError {
    /// A parameter is outside its range.
    #[error("Q{q} {name} = {given}: {range}")]
    OutOfRange {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
        /// What was given.
        given: String,
        /// What is allowed.
        range: Range,
    },
    /// A text is no value for a parameter.
    #[error("Q{q} {name}: {error}")]
    NotAValue {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
        /// What is wrong with the text.
        error: LengthError,
    },
    /// A parameter without a default was not given.
    #[error("Q{q} {name} is missing")]
    Missing {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
    },
    /// A parameter that the cycle does not have.
    #[error("cycle {cycle} has no parameter Q{q}")]
    NoSuchParameter {
        /// The cycle.
        cycle: u16,
        /// The parameter.
        q: u16,
    },
    /// The minimum is above the maximum.
    #[error("minimum dimension {minimum} mm is above maximum dimension {maximum} mm")]
    LimitsSwapped {
        /// The minimum.
        minimum: Length,
        /// The maximum.
        maximum: Length,
    },
    /// A nominal diameter of zero.
    #[error("Q{q} {name} = 0 mm: a circle needs a diameter above 0")]
    NoDiameter {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
    },
    /// The probe met nothing.
    #[error(transparent)]
    NoContact(#[from] NoContact),
    /// The contacts make no circle.
    #[error(transparent)]
    Circle(#[from] CircleError),
    /// The result is beyond what a length can hold.
    #[error("the measured circle is too large: {0}")]
    TooLarge(LengthError),
}

impl Say for CycleError {
    fn message(&self) -> Message {
        match self {
            Self::OutOfRange { q, name, given, range } => Message::new("cycle-out-of-range")
                .text("q", q)
                .text("name", name)
                .text("given", given)
                .message("allowed", range.message()),
            Self::NotAValue { q, name, error } => {
                Message::new("cycle-not-a-value").text("q", q).text("name", name).message("error", error.message())
            }
            Self::NoDiameter { q, name } => Message::new("cycle-no-diameter").text("q", q).text("name", name),
            Self::Missing { q, name } => Message::new("cycle-missing").text("q", q).text("name", name),
            Self::NoSuchParameter { cycle, q } => {
                Message::new("cycle-no-such-parameter").text("cycle", cycle).text("q", q)
            }
            Self::LimitsSwapped { minimum, maximum } => {
                Message::new("cycle-limits-swapped").mm("minimum", *minimum).mm("maximum", *maximum)
            }
            Self::NoContact(error) => error.message(),
            Self::Circle(error) => error.message(),
            Self::TooLarge(error) => Message::new("cycle-too-large").message("error", error.message()),
        }
    }
}

impl Cycle {
    /// The name in a language; English where the language has none.
    pub fn name(&self, language: Language) -> &'static str {
        let of = |wanted| self.names.iter().find(|(language, _)| *language == wanted).map(|(_, name)| *name);
        of(language).or_else(|| of(Language::En)).unwrap_or_default()
    }

    /// A parameter by its Q number.
    pub fn parameter(&self, q: u16) -> Option<&'static Parameter> {
        self.parameters.iter().find(|parameter| parameter.q == q)
    }

    /// Checks the values against the declaration, fills in defaults and runs the cycle.
    ///
    /// # Errors
    /// [`CycleError`] names the parameter, the value and what is allowed, or what went wrong on the way.
    pub fn measure(&self, inputs: &Inputs, prober: &mut dyn Prober) -> Result<CycleResult, CycleError> {
        (self.run)(&self.checked(inputs)?, prober)
    }

    fn checked(&self, inputs: &Inputs) -> Result<Inputs, CycleError> {
        if let Some(&q) = inputs.given.keys().find(|q| self.parameter(**q).is_none()) {
            return Err(CycleError::NoSuchParameter { cycle: self.number, q });
        }
        let mut checked = inputs.clone();
        for parameter in self.parameters {
            let (q, name) = (parameter.q, parameter.name);
            if let Some(default) = parameter.default_value() {
                checked.defaults.insert(q, default);
            }
            let value = checked.value(q).ok_or(CycleError::Missing { q, name })?;
            if !parameter.allows(value) {
                return Err(parameter.out_of_range(value));
            }
        }
        Ok(checked)
    }
}
