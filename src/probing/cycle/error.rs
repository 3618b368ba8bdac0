//! Why a cycle did not run, or not to its end.

use std::fmt;

use super::key::Key;
use super::parameter::Range;
use crate::length::{Length, LengthError};
use crate::message::{Message, Say};
use crate::probing::circle::CircleError;
use crate::probing::contact::NoContact;

/// Why a cycle did not run, or not to its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CycleError {
    /// A parameter is outside its range.
    #[error("{key} {name} = {given}: {range}")]
    OutOfRange {
        /// The parameter.
        key: Key,
        /// Its name.
        name: &'static str,
        /// What was given.
        given: String,
        /// What is allowed.
        range: Range,
    },
    /// A text is no value for a parameter.
    #[error("{key} {name}: {error}")]
    NotAValue {
        /// The parameter.
        key: Key,
        /// Its name.
        name: &'static str,
        /// What is wrong with the text.
        error: Reason,
    },
    /// A parameter without a default was not given.
    #[error("{key} {name} is missing")]
    Missing {
        /// The parameter.
        key: Key,
        /// Its name.
        name: &'static str,
    },
    /// PREDEF, and no GLOBAL DEF before.
    #[error("{key} {name} = PREDEF: no GLOBAL DEF has given a value")]
    NoGlobal {
        /// The parameter.
        key: Key,
        /// Its name.
        name: &'static str,
    },
    /// A parameter that the cycle does not have.
    #[error("cycle {cycle} has no parameter {parameter}: it has {known}")]
    NoSuchParameter {
        /// The cycle.
        cycle: &'static str,
        /// The parameter as it was given.
        parameter: String,
        /// The parameters that the cycle has.
        known: String,
    },
    /// The minimum is above the maximum.
    #[error(
        "{minimum_key} = {minimum} mm is above {maximum_key} = {maximum} mm: the minimum dimension is above the maximum"
    )]
    LimitsSwapped {
        /// The parameter of the minimum.
        minimum_key: Key,
        /// The minimum.
        minimum: Length,
        /// The parameter of the maximum.
        maximum_key: Key,
        /// The maximum.
        maximum: Length,
    },
    /// A nominal diameter of zero.
    #[error("{key} {name} = 0 mm: a circle needs a diameter above 0")]
    NoDiameter {
        /// The parameter.
        key: Key,
        /// Its name.
        name: &'static str,
    },
    /// A probing path of zero.
    #[error("{key} {name} = 0 mm: a probing path needs a length, its sign is the direction")]
    NoPath {
        /// The parameter.
        key: Key,
        /// Its name.
        name: &'static str,
    },
    /// A normal without a direction.
    #[error("{first}, {second} and {third} are all 0: a normal needs a direction")]
    NoNormal {
        /// Its component in the first axis.
        first: Key,
        /// In the second.
        second: Key,
        /// In the third.
        third: Key,
    },
    /// Two touches of the same point lie too far apart.
    #[error("contact {contact}: its two touches lie {difference} mm apart, {key} permits {most} mm")]
    Apart {
        /// Which contact, from 1.
        contact: usize,
        /// How far apart.
        difference: Length,
        /// The parameter that permits less.
        key: Key,
        /// How much it permits.
        most: Length,
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
    /// A measured coordinate is beyond what a length can hold.
    #[error("the measured coordinate is too large: {0}")]
    TooFar(LengthError),
}

impl Say for CycleError {
    fn message(&self) -> Message {
        let of = |id, key: &Key, name: &str| Message::new(id).text("key", key).text("name", name);
        match self {
            Self::OutOfRange { key, name, given, range } => {
                of("cycle-out-of-range", key, name).text("given", given).message("allowed", range.message())
            }
            Self::NotAValue { key, name, error } => {
                of("cycle-not-a-value", key, name).message("error", error.message.clone())
            }
            Self::NoDiameter { key, name } => of("cycle-no-diameter", key, name),
            Self::NoPath { key, name } => of("cycle-no-path", key, name),
            Self::Missing { key, name } => of("cycle-missing", key, name),
            Self::NoGlobal { key, name } => of("cycle-no-global", key, name),
            Self::NoSuchParameter { cycle, parameter, known } => Message::new("cycle-no-such-parameter")
                .text("cycle", cycle)
                .text("parameter", parameter)
                .text("known", known),
            Self::LimitsSwapped { minimum_key, minimum, maximum_key, maximum } => Message::new("cycle-limits-swapped")
                .text("minimum-key", minimum_key)
                .mm("minimum", *minimum)
                .text("maximum-key", maximum_key)
                .mm("maximum", *maximum),
            Self::NoNormal { first, second, third } => {
                Message::new("cycle-no-normal").text("first", first).text("second", second).text("third", third)
            }
            Self::Apart { contact, difference, key, most } => Message::new("cycle-apart")
                .text("contact", contact)
                .text("difference", difference)
                .text("key", key)
                .text("most", most),
            Self::NoContact(error) => error.message(),
            Self::Circle(error) => error.message(),
            Self::TooLarge(error) => Message::new("cycle-too-large").message("error", error.message()),
            Self::TooFar(error) => Message::new("cycle-too-far").message("error", error.message()),
        }
    }
}

/// What is wrong with a text, said by the room that reads such texts: in English, and for other languages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reason {
    english: String,
    message: Message,
}

impl Reason {
    pub(super) fn of(error: &(impl fmt::Display + Say)) -> Self {
        Self { english: error.to_string(), message: error.message() }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.english)
    }
}
