//! What is wrong with a plan.

use crate::length::{Length, LengthError};
use crate::message::{Located, Message, Say};
use crate::probing::cycle::CycleError;
use crate::tolerance::fit::materials::MaterialsError;
use crate::tolerance::fit::thermal::ThermalError;
use crate::tolerance::{Callout, CalloutError, CalloutErrorKind, Feature, LimitsError};
use crate::verdict::rules::{RuleError, UncertaintyError};

/// What is wrong with a plan, with the place in its file.
pub type PlanError = Located<PlanFault>;

/// What is wrong with a plan.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "plan", error)]
pub enum PlanFault {
    /// There is nothing to measure.
    NoFeatures,
    /// A callout that may be a hole's or a shaft's.
    NoFeature {
        /// As it was written.
        callout: Callout,
    },
    /// A form or location tolerance without its one limit.
    NoFormLimit {
        /// What stands in its place.
        text: String,
    },
    /// More features than a plan can have.
    TooMany {
        /// What is allowed.
        most: usize,
    },
    /// Larger than any plan.
    TooLarge {
        /// What is allowed, KiB.
        most: usize,
    },
    /// A file that is not a plan.
    NotAPlan,
    /// A plan of a later version of Fitcheck.
    OtherVersion {
        /// What it says.
        given: String,
        /// The newest that is read.
        newest: u32,
    },
    /// Something that TOML does not allow.
    Toml {
        /// The TOML reader's message, in English.
        said: String,
    },
    /// A file of another format that cannot be read as a plan.
    File {
        /// Why.
        reason: Message,
    },
    /// A key that a plan does not have.
    UnknownKey {
        /// The key.
        key: String,
        /// The keys that it could be.
        known: String,
    },
    /// A value of another kind than the key has.
    OtherValue {
        /// The key.
        key: &'static str,
        /// What was found.
        found: &'static str,
        /// What is expected.
        expected: &'static str,
    },
    /// A column is missing.
    NoColumn {
        /// The column.
        column: &'static str,
    },
    /// An unknown column.
    UnknownColumn {
        /// The column.
        column: String,
        /// The known columns.
        known: String,
    },
    /// A column occurs twice.
    ColumnTwice {
        /// The column.
        column: &'static str,
    },
    /// A row has more cells than the header.
    Cells {
        /// How many it has.
        found: usize,
        /// How many columns there are.
        expected: usize,
    },
    /// A cell that must be filled is empty.
    NoCell {
        /// Its column.
        column: &'static str,
    },
    /// A cell does not hold a number.
    #[say(id = "plan-value")]
    Number {
        /// Its column.
        #[say(name = "what")]
        column: &'static str,
        /// What is wrong.
        error: LengthError,
    },
    /// A text is not a callout.
    #[say(id = "plan-value")]
    Callout {
        /// What was given.
        #[say(name = "what")]
        text: String,
        /// What is wrong.
        error: Box<CalloutError>,
    },
    /// Two features in one callout.
    Fit {
        /// What was given.
        callout: Callout,
    },
    /// An unknown kind of feature, axis or cycle.
    Unknown {
        /// The column.
        column: &'static str,
        /// What was given.
        given: String,
        /// What is known.
        known: String,
    },
    /// A word for a hole or a shaft beside a column that says the other one.
    OtherSide {
        /// The word.
        given: String,
        /// The other column.
        column: &'static str,
        /// What it has.
        text: String,
        /// Of what that is.
        side: Feature,
    },
    /// A column that a kind of feature does not have.
    NotOf {
        /// The column.
        column: &'static str,
        /// The kind.
        kind: &'static str,
    },
    /// Not a direction in which a point can be probed.
    Direction {
        /// What was given.
        given: String,
        /// The directions along an axis.
        known: String,
    },
    /// A text is not a band about the nominal place of a point.
    NoBand {
        /// What was given.
        text: String,
        /// What is wrong.
        error: Box<CalloutError>,
    },
    /// A band that the cycle does not take.
    BandSide {
        /// The upper deviation.
        upper: Length,
        /// The lower deviation.
        lower: Length,
    },
    /// A pocket with a shaft class, or a boss with a hole class.
    SideClass {
        /// What was given.
        callout: Callout,
        /// The kind.
        kind: &'static str,
        /// A class that it could have.
        example: &'static str,
    },
    /// A face with a hole class: the cycle judges a coordinate as an outside dimension.
    FaceClass {
        /// What was given.
        callout: Callout,
    },
    /// The coordinate of a face is not its nominal size.
    FacePlace {
        /// What was given.
        callout: Callout,
        /// The coordinate along the measured axis.
        coordinate: Length,
    },
    /// No limits.
    #[say(id = "plan-value")]
    Limits {
        /// What was given.
        #[say(name = "what")]
        callout: Callout,
        /// Why.
        error: Box<LimitsError>,
    },
    /// A band about the nominal place of a point that is out of all proportion.
    #[say(transparent)]
    Band(Box<LimitsError>),
    /// A value that is out of the cycle's range.
    #[say(transparent)]
    Range(Box<CycleError>),
    /// A parameter that the cycle does not have, or that a column of the plan decides.
    Parameter {
        /// What was given.
        given: String,
        /// The cycle.
        cycle: &'static str,
        /// The parameters that may be given.
        known: String,
    },
    /// A parameter that no measuring cycle takes from a plan.
    NoParameter {
        /// What was given.
        given: String,
    },
    /// The probe would move at or below the measuring height.
    ClearanceHeight {
        /// The clearance height.
        height: Length,
        /// The measuring height.
        z: Length,
    },
    /// A position that the machine does not reach.
    Travel {
        /// The axis.
        axis: &'static str,
        /// The position.
        given: Length,
        /// Where its travel begins.
        minimum: Length,
        /// Where it ends.
        maximum: Length,
    },
    /// A clearance height that the machine does not reach, given or usual.
    ClearanceTravel {
        /// The clearance height.
        height: Length,
        /// Where the travel in Z begins.
        minimum: Length,
        /// Where it ends.
        maximum: Length,
    },
    /// A machine's travel that is not two numbers, the smaller one first.
    NoTravel {
        /// What was given.
        given: String,
    },
    /// What a value can be is not two lengths, the smaller one first.
    NoPlausible {
        /// The column.
        column: &'static str,
        /// What was given.
        given: String,
    },
    /// What a value can be does not contain the limits of its size.
    PlausibleLimits {
        /// The column.
        column: &'static str,
        /// The smallest value that can be.
        lower: Length,
        /// The largest one.
        upper: Length,
        /// The smallest permitted value.
        minimum: Length,
        /// The largest permitted value.
        maximum: Length,
    },
    /// A text with line ends or other signs that are none, or one that is too long.
    Text {
        /// The column.
        column: &'static str,
        /// The most characters.
        most: usize,
    },
    /// Two features with the same name.
    SameName {
        /// The name.
        name: String,
        /// The line of the other one; 0 where it is from no file.
        line: usize,
    },
    /// Two features with the same number.
    SameNumber {
        /// The number.
        number: String,
        /// The number of the other one, which may have zeros before it.
        other: String,
        /// Its line; 0 where it is from no file.
        line: usize,
    },
    /// A value called so could be of two features.
    SameSize {
        /// What the value would be called.
        called: String,
        /// The name of the other feature.
        other: String,
        /// Its line; 0 where it is from no file.
        line: usize,
    },
    /// A value with this number could be of two features: it is the name of another one.
    NumberIsName {
        /// The number.
        number: String,
        /// The name of the other feature.
        other: String,
        /// Its line; 0 where it is from no file.
        line: usize,
    },
    /// The same the other way round.
    NameIsNumber {
        /// What the value would be called.
        called: String,
        /// The name of the other feature.
        other: String,
        /// Its line; 0 where it is from no file.
        line: usize,
    },
    /// A material that is not known.
    #[say(transparent)]
    Material(MaterialsError),
    /// An expansion that is none.
    #[say(transparent)]
    Thermal(ThermalError),
    /// A rule that cannot judge.
    #[say(id = "plan-value")]
    Rule {
        /// What was given.
        #[say(name = "what")]
        rule: String,
        /// Why.
        error: RuleError,
    },
    /// An uncertainty that is none.
    #[say(id = "plan-value")]
    Uncertainty {
        /// The column.
        #[say(name = "what")]
        column: &'static str,
        /// Why.
        error: UncertaintyError,
    },
    /// A place on the picture that is not on it.
    Balloon {
        /// What was given.
        given: String,
    },
}

impl PlanFault {
    /// What the cell should probably hold, where its deviations are micrometres.
    pub fn meant(&self) -> Option<String> {
        match self {
            Self::Callout { error, .. } => match &error.kind {
                CalloutErrorKind::MicrometresMeant { offer, .. } => Some(offer.to_string()),
                _ => None,
            },
            Self::Limits { error, .. } => match error.as_ref() {
                LimitsError::Zone(doubt) => doubt.meant().map(ToString::to_string),
                _ => None,
            },
            Self::Band(error) => match error.as_ref() {
                LimitsError::Zone(doubt) => doubt.meant_band().map(str::to_owned),
                _ => None,
            },
            _ => None,
        }
    }
}

/// What a plan from another tool does not take over.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "plan-remark")]
pub enum PlanRemark {
    /// A characteristic that is no size of a hole or shaft.
    Left {
        /// Its name.
        name: String,
        /// What it is.
        why: Message,
    },
    /// A tolerance class whose limits are not those of the file, which count.
    ClassLeft {
        /// The characteristic.
        name: String,
        /// The class with its nominal size.
        class: String,
    },
    /// What is said of the file whenever it is read, such as a unit that it leaves open.
    File {
        /// What is said.
        said: Message,
    },
    /// The file has places, and nothing says along which axes its holes and shafts lie. Told once for a file.
    AxesAssumed,
    /// A place that no cycle here can be sent to: the feature has no position.
    PlaceLeft {
        /// The characteristic.
        name: String,
        /// Why.
        why: Message,
    },
    /// A place above the usual clearance height: a higher one is written into the plan.
    ClearanceRaised {
        /// The characteristic.
        name: String,
        /// The clearance height that is written.
        height: Length,
    },
    /// An expanded uncertainty with an odd number of nanometres: half of it is no whole number.
    UncertaintyLeft {
        /// The characteristic.
        name: String,
        /// The uncertainty.
        expanded: Length,
    },
}
