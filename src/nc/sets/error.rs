//! Why a plan or a set is impossible, and remarks on a possible one.

use crate::control::table::WriteError;
use crate::length::{Length, LengthError};
use crate::message::{Located, Message, Say};
use crate::nc::machine::Fault;
use crate::nc::program::ProgramError;
use crate::probing::cycle::{CycleError, Key};
use crate::tolerance::table::TableShapeError;
use crate::tolerance::{Callout, CalloutError, LimitsError, ToleranceClass};

/// Why a plan is impossible, with the line of its file if there is one.
pub type PlanError = Located<PlanFault>;

/// Why a plan is impossible.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum PlanFault {
    /// There is nothing to measure.
    NoFeatures,
    /// More features than a control can show.
    TooMany {
        /// What is allowed.
        most: usize,
    },
    /// Larger than any plan.
    TooLarge {
        /// What is allowed, KiB.
        most: usize,
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
    #[say(id = "nc-value")]
    Number {
        /// Its column.
        #[say(name = "what")]
        column: &'static str,
        /// What is wrong.
        error: LengthError,
    },
    /// A text is not a callout.
    #[say(id = "nc-value")]
    Callout {
        /// What was given.
        #[say(name = "what")]
        text: String,
        /// What is wrong.
        error: Box<CalloutError>,
    },
    /// No class: the called program finds limits only by class.
    NoClass {
        /// What was given.
        callout: Callout,
    },
    /// Two features in one callout.
    Fit {
        /// What was given.
        callout: Callout,
    },
    /// An unknown kind of feature, or an unknown axis.
    Unknown {
        /// The column.
        column: &'static str,
        /// What was given.
        given: String,
        /// What is known.
        known: String,
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
    /// The control does not have the cycle that measures a kind.
    NotOnControl {
        /// The kind.
        kind: &'static str,
        /// The cycle.
        cycle: &'static str,
        /// The control.
        control: &'static str,
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
    #[say(id = "nc-value")]
    Limits {
        /// What was given.
        #[say(name = "what")]
        callout: Callout,
        /// Why.
        error: Box<LimitsError>,
    },
    /// A value that is out of the cycle's range.
    #[say(transparent)]
    Range(Box<CycleError>),
    /// The probe would move at or below the measuring height.
    ClearanceHeight {
        /// The clearance height.
        height: Length,
        /// The measuring height.
        z: Length,
    },
    /// A name that is not possible for a file.
    Name {
        /// What was given.
        name: String,
        /// The most characters.
        most: usize,
    },
    /// Two features with the same name.
    SameName {
        /// The name.
        name: String,
    },
}

/// Why a set cannot be made.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum SetError {
    /// Something is wrong with the plan.
    #[say(transparent)]
    Plan(#[from] PlanError),
    /// A folder that programs cannot use.
    Folder {
        /// What was given.
        folder: String,
    },
    /// The parts of a table do not fit together.
    #[say(id = "nc-value")]
    Shape {
        /// The table.
        #[say(name = "what")]
        table: &'static str,
        /// Why.
        error: TableShapeError,
    },
    /// The control could not read a table.
    #[say(id = "nc-value")]
    Table {
        /// The table.
        #[say(name = "what")]
        table: &'static str,
        /// Why.
        error: WriteError,
    },
    /// A program or a mask that does not read back correctly.
    ReadsOtherwise {
        /// The file.
        file: String,
    },
    /// The set does not run as it should.
    Proof(#[say(name = "reason")] ProofFault),
    /// The simulated workpiece cannot be written.
    Workpiece {
        /// The message of the TOML writer.
        reason: String,
    },
    /// The zip file cannot be made.
    Archive {
        /// The message of the zip writer.
        reason: String,
    },
}

/// What went wrong when a set was run.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc-proof", error)]
pub enum ProofFault {
    /// The main program cannot be read.
    #[say(transparent)]
    Program(ProgramError),
    /// The run stopped.
    #[say(transparent)]
    Fault(Fault),
    /// The run does not end.
    NoEnd,
    /// Features were left out or measured twice.
    Count {
        /// How many cycles were run.
        found: usize,
        /// How many features there are.
        expected: usize,
    },
    /// A feature in the middle of its zone is not good, or has other limits.
    OtherVerdict {
        /// Its name.
        name: String,
    },
}

/// What is worth knowing about a set before it is used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "nc")]
pub enum SetRemark {
    /// A class that is not one of the 47 of NC-Solution 8255 has a column.
    OwnColumn {
        /// The class.
        class: ToleranceClass,
        /// The table.
        table: &'static str,
    },
    /// The table is full with its own classes, so it has only those of the plan.
    FewerColumns {
        /// The table.
        table: &'static str,
        /// The classes in it.
        classes: String,
    },
    /// A figure behind the limits is contested, for trial use, or not that of ISO 286.
    Figure {
        /// What it says.
        what: Message,
    },
    /// The cycle's nominal size is the limit next to the nominal size, which lies outside the limits.
    MovedNominal {
        /// The feature's name.
        name: String,
        /// Its callout.
        callout: Callout,
        /// The value that the cycle gets.
        value: Length,
        /// The cycle's parameter for it.
        parameter: Key,
        /// The result that counts from there.
        deviation: Key,
    },
}
