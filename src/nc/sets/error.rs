//! Why a plan or a set cannot be, and what is worth knowing about one that can.

use crate::control::table::WriteError;
use crate::length::{Length, LengthError};
use crate::message::{Located, Say};
use crate::nc::machine::Fault;
use crate::nc::program::ProgramError;
use crate::probing::cycle::CycleError;
use crate::tolerance::table::TableShapeError;
use crate::tolerance::{Callout, CalloutError, LimitsError, ToleranceClass};

/// Why a plan cannot be, with the line of its file where it has one.
pub type PlanError = Located<PlanFault>;

/// Why a plan cannot be.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum PlanFault {
    /// Nothing to measure.
    NoFeatures,
    /// More than a control shows.
    TooMany {
        /// What is allowed.
        most: usize,
    },
    /// A column is missing.
    NoColumn {
        /// Which.
        column: &'static str,
    },
    /// A column that nobody knows.
    UnknownColumn {
        /// Which.
        column: String,
        /// Those that are known.
        known: String,
    },
    /// A column occurs twice.
    ColumnTwice {
        /// Which.
        column: &'static str,
    },
    /// A row has more cells than the header.
    Cells {
        /// How many it has.
        found: usize,
        /// How many there are columns.
        expected: usize,
    },
    /// A cell that must be filled is not.
    NoCell {
        /// Its column.
        column: &'static str,
    },
    /// A cell holds no number.
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
    /// No class: the called program finds limits by class alone.
    NoClass {
        /// What was given.
        callout: Callout,
    },
    /// Two features in one callout.
    Fit {
        /// What was given.
        callout: Callout,
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
    /// A value that the cycle refuses.
    #[say(transparent)]
    Range(Box<CycleError>),
    /// The probe would move at or below the height where it measures.
    ClearanceHeight {
        /// The clearance height.
        height: Length,
        /// The measuring height.
        z: Length,
    },
    /// A name that no file can have.
    Name {
        /// What was given.
        name: String,
        /// The most characters.
        most: usize,
    },
    /// Two features of one name.
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
    /// A folder that programs cannot name.
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
    /// The control could not take a table.
    #[say(id = "nc-value")]
    Table {
        /// The table.
        #[say(name = "what")]
        table: &'static str,
        /// Why.
        error: WriteError,
    },
    /// A program or a mask that does not read back.
    ReadsOtherwise {
        /// The file.
        file: String,
    },
    /// The set does not run as it should.
    Proof(#[say(name = "reason")] ProofFault),
    /// The zip file cannot be made.
    Archive {
        /// What its writer says.
        reason: String,
    },
}

/// What went wrong when a set was run.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc-proof", error)]
pub enum ProofFault {
    /// The main program is none.
    #[say(transparent)]
    Program(ProgramError),
    /// The run stopped.
    #[say(transparent)]
    Fault(Fault),
    /// The run goes on and on.
    NoEnd,
    /// Features were left out, or measured twice.
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
    /// A class beyond the 47 of NC-Solution 8255 has got a column.
    OwnColumn {
        /// The class.
        class: ToleranceClass,
        /// The table.
        table: &'static str,
    },
    /// The table is full with its own classes, so it has those of the plan alone.
    FewerColumns {
        /// The table.
        table: &'static str,
        /// The classes that it has.
        classes: String,
    },
    /// Q262 is the limit next to the nominal size, which lies outside the limits.
    MovedNominal {
        /// The feature's name.
        name: String,
        /// Its callout.
        callout: Callout,
        /// The value of Q262.
        value: Length,
    },
}
