//! Why a plan or a set cannot be, and what is worth knowing about one that can.

use std::fmt;

use crate::control::table::WriteError;
use crate::length::{Length, LengthError, signed_mm};
use crate::message::{Message, Say};
use crate::probing::cycle::CycleError;
use crate::tolerance::table::TableShapeError;
use crate::tolerance::{Callout, CalloutError, LimitsError, ToleranceClass};

/// Where in a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum At {
    /// Nowhere in particular.
    Whole,
    /// A line of its file, from 1.
    Line(usize),
    /// A feature, from 1.
    Feature(usize),
}

/// Why a plan cannot be, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanError {
    /// Where.
    pub at: At,
    /// Why.
    pub what: PlanFault,
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.at {
            At::Whole => write!(f, "{}", self.what),
            At::Line(line) => write!(f, "line {line}: {}", self.what),
            At::Feature(number) => write!(f, "feature {number}: {}", self.what),
        }
    }
}

impl std::error::Error for PlanError {}

impl Say for PlanError {
    fn message(&self) -> Message {
        let what = self.what.message();
        match self.at {
            At::Whole => what,
            At::Line(line) => Message::new("nc-at-line").text("line", line).message("what", what),
            At::Feature(number) => Message::new("nc-at-feature").text("number", number).message("what", what),
        }
    }
}

/// Why a plan cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanFault {
    /// Nothing to measure.
    #[error("the plan has no feature")]
    NoFeatures,
    /// More than a control shows.
    #[error("the plan has more than {most} features")]
    TooMany {
        /// What is allowed.
        most: usize,
    },
    /// The file is no CSV.
    #[error("the CSV cannot be read: {reason}")]
    Csv {
        /// What its reader says.
        reason: String,
    },
    /// A column is missing.
    #[error("column {column} is missing")]
    NoColumn {
        /// Which.
        column: &'static str,
    },
    /// A column that nobody knows.
    #[error("column {column} is not known; known are {known}")]
    UnknownColumn {
        /// Which.
        column: String,
        /// Those that are known.
        known: String,
    },
    /// A column occurs twice.
    #[error("column {column} occurs twice")]
    ColumnTwice {
        /// Which.
        column: &'static str,
    },
    /// A row has more cells than the header.
    #[error(
        "the row has {found} cells and the header {expected}: with a decimal comma, separate the columns by semicolons"
    )]
    Cells {
        /// How many it has.
        found: usize,
        /// How many there are columns.
        expected: usize,
    },
    /// A cell that must be filled is not.
    #[error("{column} is missing")]
    NoCell {
        /// Its column.
        column: &'static str,
    },
    /// A cell holds no number.
    #[error("{column}: {error}")]
    Number {
        /// Its column.
        column: &'static str,
        /// What is wrong.
        error: LengthError,
    },
    /// A text is no callout.
    #[error("{text}: {error}")]
    Callout {
        /// What was given.
        text: String,
        /// What is wrong.
        error: Box<CalloutError>,
    },
    /// No class: the called program finds limits by class alone.
    #[error("{callout} has no tolerance class: the programs look a class up in a table, such as H7")]
    NoClass {
        /// What was given.
        callout: Callout,
    },
    /// Two features in one callout.
    #[error("{callout} is a fit: write the hole and the shaft as two features")]
    Fit {
        /// What was given.
        callout: Callout,
    },
    /// No limits.
    #[error("{callout}: {error}")]
    Limits {
        /// What was given.
        callout: Callout,
        /// Why.
        error: Box<LimitsError>,
    },
    /// A value that the cycle refuses.
    #[error("{0}")]
    Range(Box<CycleError>),
    /// The probe would move at or below the height where it measures.
    #[error("clearance height {height} mm is not above the measuring height, {z} mm")]
    ClearanceHeight {
        /// The clearance height.
        height: Length,
        /// The measuring height.
        z: Length,
    },
    /// A name that no file can have.
    #[error("name {name}: letters A to Z, digits and _ are allowed, at most {most}")]
    Name {
        /// What was given.
        name: String,
        /// The most characters.
        most: usize,
    },
    /// Two features of one name.
    #[error("name {name} occurs twice; a control does not tell a from A in file names")]
    SameName {
        /// The name.
        name: String,
    },
}

impl Say for PlanFault {
    fn message(&self) -> Message {
        match self {
            Self::NoFeatures => Message::new("nc-no-features"),
            Self::TooMany { most } => Message::new("nc-too-many").text("most", most),
            Self::Csv { reason } => Message::new("nc-csv").text("reason", reason),
            Self::NoColumn { column } => Message::new("nc-no-column").text("column", column),
            Self::UnknownColumn { column, known } => {
                Message::new("nc-unknown-column").text("column", column).text("known", known)
            }
            Self::ColumnTwice { column } => Message::new("nc-column-twice").text("column", column),
            Self::Cells { found, expected } => Message::new("nc-cells").text("found", found).text("expected", expected),
            Self::NoCell { column } => Message::new("nc-no-cell").text("column", column),
            Self::Number { column, error } => {
                Message::new("nc-value").text("what", column).message("error", error.message())
            }
            Self::Callout { text, error } => {
                Message::new("nc-value").text("what", text).message("error", error.message())
            }
            Self::NoClass { callout } => Message::new("nc-no-class").text("callout", callout),
            Self::Fit { callout } => Message::new("nc-fit").text("callout", callout),
            Self::Limits { callout, error } => {
                Message::new("nc-value").text("what", callout).message("error", error.message())
            }
            Self::Range(error) => error.message(),
            Self::ClearanceHeight { height, z } => {
                let message = signed_mm(Message::new("nc-clearance-height"), "height-sign", "height", *height);
                signed_mm(message, "z-sign", "z", *z)
            }
            Self::Name { name, most } => Message::new("nc-name").text("name", name).text("most", most),
            Self::SameName { name } => Message::new("nc-same-name").text("name", name),
        }
    }
}

/// Why a set cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SetError {
    /// Something is wrong with the plan.
    #[error("{0}")]
    Plan(#[from] PlanError),
    /// A folder that programs cannot name.
    #[error("{folder} is no folder for programs: write TNC:\\, then names of letters, digits, _ and -, apart by \\")]
    Folder {
        /// What was given.
        folder: String,
    },
    /// The parts of a table do not fit together.
    #[error("{table}: {error}")]
    Shape {
        /// The table.
        table: &'static str,
        /// Why.
        error: TableShapeError,
    },
    /// The control could not take a table.
    #[error("{table}: {error}")]
    Table {
        /// The table.
        table: &'static str,
        /// Why.
        error: WriteError,
    },
    /// A table would give other limits than Fitcheck does.
    #[error("{table} would not give the limits of {callout}")]
    OtherLimits {
        /// The table.
        table: &'static str,
        /// The callout.
        callout: Callout,
    },
    /// A program or a mask that does not read back.
    #[error("{file} cannot be written so that it reads back the same")]
    ReadsOtherwise {
        /// The file.
        file: String,
    },
    /// The set does not run as it should.
    #[error("the set was run and is not given out: {reason}")]
    Proof {
        /// What happened.
        reason: String,
    },
    /// The zip file cannot be made.
    #[error("the zip file cannot be made: {reason}")]
    Archive {
        /// What its writer says.
        reason: String,
    },
}

impl Say for SetError {
    fn message(&self) -> Message {
        match self {
            Self::Plan(error) => error.message(),
            Self::Folder { folder } => Message::new("nc-folder").text("folder", folder),
            Self::Shape { table, error } => {
                Message::new("nc-value").text("what", table).message("error", error.message())
            }
            Self::Table { table, error } => {
                Message::new("nc-value").text("what", table).message("error", error.message())
            }
            Self::OtherLimits { table, callout } => {
                Message::new("nc-other-limits").text("table", table).text("callout", callout)
            }
            Self::ReadsOtherwise { file } => Message::new("nc-reads-otherwise").text("file", file),
            Self::Proof { reason } => Message::new("nc-proof").text("reason", reason),
            Self::Archive { reason } => Message::new("nc-archive").text("reason", reason),
        }
    }
}

/// What is worth knowing about a set before it is used.
#[derive(Debug, Clone, PartialEq, Eq)]
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

impl fmt::Display for SetRemark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OwnColumn { class, table } => {
                write!(f, "{class} is none of the 47 classes of NC-Solution 8255: {table} has a column more")
            }
            Self::FewerColumns { table, classes } => {
                write!(f, "an iTNC 530 takes no more columns: {table} has the plan's classes only, {classes}")
            }
            Self::MovedNominal { name, callout, value } => write!(
                f,
                "{name}: the nominal size of {callout} is outside the limits, which a TNC7 refuses: Q262 is {value} mm, and \
                 Q163 counts from there"
            ),
        }
    }
}

impl Say for SetRemark {
    fn message(&self) -> Message {
        match self {
            Self::OwnColumn { class, table } => Message::new("nc-own-column").text("class", class).text("table", table),
            Self::FewerColumns { table, classes } => {
                Message::new("nc-fewer-columns").text("table", table).text("classes", classes)
            }
            Self::MovedNominal { name, callout, value } => {
                Message::new("nc-moved-nominal").text("name", name).text("callout", callout).mm("value", *value)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::Sources;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check(what: &(impl Say + fmt::Display)) {
        assert_eq!(Words::new(Language::En).told(what), what.to_string());
        let dutch = Words::new(Language::Nl).told(what);
        assert!(!dutch.contains("nc-") && dutch != what.to_string(), "{dutch}");
    }

    fn length(text: &str) -> Length {
        text.parse().unwrap()
    }

    fn callout(text: &str) -> Callout {
        text.parse().unwrap()
    }

    #[test]
    fn every_error_and_remark_is_said_in_both_languages() {
        let range = crate::probing::cycles::cycle(421).unwrap().parameter_named("Q325").unwrap().accept("361");
        let error = Sources::default().limits(&callout("4000 H7"), None).unwrap_err();
        for what in [
            PlanFault::NoFeatures,
            PlanFault::TooMany { most: 1_000 },
            PlanFault::Csv { reason: "no UTF-8".to_owned() },
            PlanFault::NoColumn { column: "x" },
            PlanFault::UnknownColumn { column: "depth".to_owned(), known: "x, y".to_owned() },
            PlanFault::ColumnTwice { column: "x" },
            PlanFault::Cells { found: 12_345, expected: 8 },
            PlanFault::NoCell { column: "x" },
            PlanFault::Number { column: "x", error: LengthError::Empty },
            PlanFault::Callout { text: "25 H".to_owned(), error: Box::new("25 H".parse::<Callout>().unwrap_err()) },
            PlanFault::NoClass { callout: callout("10m") },
            PlanFault::Fit { callout: callout("25 H7/g6") },
            PlanFault::Limits { callout: callout("4000 H7"), error: Box::new(error) },
            PlanFault::Range(Box::new(range.unwrap_err())),
            PlanFault::ClearanceHeight { height: length("-8"), z: length("2") },
            PlanFault::Name { name: "a b".to_owned(), most: 20 },
            PlanFault::SameName { name: "a".to_owned() },
        ] {
            for at in [At::Whole, At::Line(12_345), At::Feature(2)] {
                check(&SetError::Plan(PlanError { at, what: what.clone() }));
            }
        }
        let table = "FIT_HOLE.TAB";
        check(&SetError::Folder { folder: "C:".to_owned() });
        check(&SetError::Shape { table, error: TableShapeError::NoRanges });
        check(&SetError::Table { table, error: WriteError::ReadsOtherwise });
        check(&SetError::OtherLimits { table, callout: callout("25 H7") });
        check(&SetError::ReadsOtherwise { file: "FIT_MAIN.H".to_owned() });
        check(&SetError::Proof { reason: "LBL 7 does not occur".to_owned() });
        check(&SetError::Archive { reason: "full".to_owned() });
        check(&SetRemark::OwnColumn { class: "U7".parse().unwrap(), table });
        check(&SetRemark::FewerColumns { table, classes: "U7 H7".to_owned() });
        let name = "F1".to_owned();
        check(&SetRemark::MovedNominal { name, callout: callout("25 D10"), value: length("1025") });
    }
}
