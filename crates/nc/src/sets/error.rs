//! Why a set is impossible, and remarks on a possible one.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Located, Message, Say};
use fitcheck_core::probing::cycle::Key;
use fitcheck_core::tolerance::table::TableShapeError;
use fitcheck_core::tolerance::{Callout, ToleranceClass};

use crate::control::table::WriteError;
use crate::machine::Fault;
use crate::program::ProgramError;

/// Why a control cannot measure a feature, with the line of the plan's file if there is one.
pub type FeatureError = Located<FeatureFault>;

/// Why a control cannot measure a feature.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum FeatureFault {
    /// A coordinate is missing.
    NoPlace { name: String },
    /// A cycle or parameters of its own: the called programs have no place for them.
    OwnCycle { name: String },
    /// The control does not have the cycle that measures a kind.
    NotOnControl { kind: &'static str, cycle: &'static str, control: &'static str },
    /// A name that is not possible for a file.
    Name {
        /// What was given.
        name: String,
        /// The most characters.
        most: usize,
    },
}

/// Why a set cannot be made.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum SetError {
    /// The control cannot measure a feature.
    #[say(transparent)]
    Feature(#[from] FeatureError),
    /// It cannot measure several, or one for several reasons.
    Features {
        first: Box<FeatureError>,
        /// All others, in the order of the plan.
        #[say(name = "more", with = Vec::len)]
        others: Vec<FeatureError>,
    },
    /// The control has no cycle that takes a tolerance as a text.
    NoTexts { control: &'static str },
    /// A folder that programs cannot use.
    Folder {
        /// What was given.
        folder: String,
    },
    /// The parts of a table do not fit together.
    #[say(id = "nc-value")]
    Shape {
        #[say(name = "what")]
        table: &'static str,
        /// Why.
        error: TableShapeError,
    },
    /// The control could not read a table.
    #[say(id = "nc-value")]
    Table {
        #[say(name = "what")]
        table: &'static str,
        /// Why.
        error: WriteError,
    },
    /// A feature whose name is none for a column of the table of a series.
    SeriesName { name: String },
    /// More sizes of a part than a series keeps.
    SeriesSizes {
        /// How many there are.
        sizes: usize,
        /// How many there may be.
        most: usize,
    },
    /// A program or a mask that does not read back correctly.
    ReadsOtherwise { file: String },
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
    OtherVerdict { name: String },
}

/// What is worth knowing about a set before it is used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "nc")]
pub enum SetRemark {
    /// A class that is not one of the 47 of NC-Solution 8255 has a column.
    OwnColumn { class: ToleranceClass, table: &'static str },
    /// The table is full with its own classes, so it has only those of the plan.
    FewerColumns { table: &'static str, classes: String },
    /// A figure behind the limits is contested, for trial use, or not that of ISO 286.
    Figure {
        /// What it says.
        what: Message,
    },
    /// No cycle measures it, so it is not in the set.
    ByHand {
        /// The feature's name.
        name: String,
        /// Its kind.
        kind: &'static str,
    },
    /// What the plan says of judging a feature, and the set does not know: the limits alone decide on the control.
    NotInSet {
        /// The feature's name.
        name: String,
        /// What the plan says, by its keys.
        said: String,
    },
    /// The cycle's nominal size is the limit next to the nominal size, which lies outside the limits.
    MovedNominal {
        /// The feature's name.
        name: String,
        callout: Callout,
        /// The value that the cycle gets.
        value: Length,
        /// The cycle's parameter for it.
        parameter: Key,
        /// The result that counts from there.
        deviation: Key,
    },
}

impl SetError {
    /// Of features that the control cannot measure.
    pub(super) fn of_features(first: FeatureError, others: Vec<FeatureError>) -> Self {
        if others.is_empty() { Self::Feature(first) } else { Self::Features { first: Box::new(first), others } }
    }
}
