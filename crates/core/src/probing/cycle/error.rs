//! Why a cycle did not run, or did not finish.

use super::key::Key;
use super::name::ParameterName;
use super::range::Range;
use crate::length::{Length, LengthError};
use crate::message::{Arg, Message, Say};
use crate::probing::circle::CircleError;
use crate::probing::contact::NoContact;

/// Why a text calls no tool.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "cycle-tool", error)]
pub(crate) enum ToolFault {
    /// Neither a number nor a name.
    NoName {
        /// The text.
        text: String,
    },
    /// A name without a character.
    Empty,
    /// A word in a block that is no number.
    Unquoted {
        /// The text.
        text: String,
    },
}

/// Why a cycle did not run, or did not finish.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "cycle", error)]
pub enum CycleError {
    /// A parameter is outside its range.
    OutOfRange {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
        /// What was given.
        given: Box<Arg>,
        /// What is allowed.
        #[say(name = "allowed")]
        range: Range,
    },
    /// A text is not a value for a parameter.
    NotAValue {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
        /// What is wrong with the text, as the room that reads such texts puts it.
        error: Message,
    },
    /// A parameter without a default was not given.
    Missing {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
    },
    /// A limit without the other limit of the same value, which would count as 0.
    OneLimit {
        /// The limit.
        given: Key,
        /// The other one.
        missing: Key,
    },
    /// PREDEF without a GLOBAL DEF before it.
    NoGlobal {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
    },
    /// A parameter that the cycle does not have.
    NoSuchParameter {
        /// The cycle.
        cycle: &'static str,
        /// The parameter as it was given.
        parameter: String,
        /// The parameters that the cycle has.
        known: String,
    },
    /// The minimum is above the maximum.
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
    NoDiameter {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
    },
    /// A class of a hole for a shaft, or the other way round.
    OtherFeature {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
        /// The nominal value with its class.
        given: String,
        /// The parameter that says hole or shaft.
        geometry: Key,
    },
    /// A tolerance for a value that the cycle does not measure.
    NotMeasured {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
        /// The nominal value with its tolerance.
        given: String,
    },
    /// A tolerance in a program in inches, whose unit is not known.
    InchTolerance {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
        /// The nominal value with its tolerance.
        given: String,
    },
    /// Two points of an edge that lie at one place along it.
    NoEdge {
        /// The parameter of the first point.
        first: Key,
        /// The parameter of the second one.
        second: Key,
    },
    /// Contacts that do not determine a sphere.
    NoSphere,
    /// A measured rotation is to turn something.
    NoRotation {
        /// The parameter that asks for that.
        key: Key,
        /// Its name.
        name: ParameterName,
    },
    /// A row of a table is named, and not which table: controls without that parameter had another kind of table.
    NoTransfer {
        /// The parameter that says which table.
        key: Key,
        /// The parameter of the row.
        row_key: Key,
        /// The row.
        row: i64,
    },
    /// A probing path of zero.
    NoPath {
        /// The parameter.
        key: Key,
        /// Its name.
        name: ParameterName,
    },
    /// A normal without a direction.
    NoNormal {
        /// Its component in the first axis.
        first: Key,
        /// In the second.
        second: Key,
        /// In the third.
        third: Key,
    },
    /// Two probings of the same point lie too far apart.
    Apart {
        /// Which contact, from 1.
        contact: usize,
        /// How far apart.
        difference: Length,
        /// The parameter that permits no more than its value.
        key: Key,
        /// How much is permitted.
        most: Length,
    },
    /// The probe met nothing.
    #[say(transparent)]
    NoContact(#[from] NoContact),
    /// The contacts do not make a circle.
    #[say(transparent)]
    Circle(#[from] CircleError),
    /// The result is beyond what a length can hold.
    TooLarge(#[say(name = "error")] LengthError),
    /// A measured coordinate is beyond what a length can hold.
    TooFar(#[say(name = "error")] LengthError),
}
