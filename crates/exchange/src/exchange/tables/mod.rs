//! Tables of deviations as files of other tools and of controls.
//!
//! | file | what |
//! |---|---|
//! | `control` | a control's table, for a chosen generation of controls |
//! | `csv` | plain CSV, one line per cell |
//! | `parquet` | Parquet, one row per cell, with the feature of that name |
//! | `pcdmis` | the CSV that PC-DMIS reads for ISO tolerances |
//!
//! To add a format:
//!
//! 1. Write a file with its [`TableFormat`]. Add its `mod` line, its line in [`TABLE_FORMATS`] and its row above.
//! 2. Add the text of its `description` to `exchange.ftl` in every folder of `assets/locales`.
//! 3. Test it in `tests/core/table_formats.rs`. Add a call of `fitcheck table export` to the corpus and record the answers
//!    (`tests/core/corpus.rs`).
//!
//! Command line and dialogs follow.

mod control;
mod csv;
mod parquet;
mod pcdmis;

use std::path::Path;

use fitcheck_core::message::Say;
use fitcheck_core::tolerance::{DeviationTable, ToleranceClass};
use fitcheck_nc::control::table::WriteError;

pub use parquet::{FORMAT as PARQUET, together as parquet_of};

/// A format that a table of deviations is written in.
#[derive(Debug, Clone, Copy)]
pub struct TableFormat {
    /// The name on the command line.
    pub name: &'static str,
    /// File endings in lower case, without the point; the first is proposed.
    pub endings: &'static [&'static str],
    /// The id of its one-line description.
    pub description: &'static str,
    /// What to check before relying on the file.
    pub warning: fn(&DeviationTable) -> Option<FormatWarning>,
    /// Makes the file's bytes.
    pub write: fn(&DeviationTable) -> Result<Vec<u8>, TableFormatError>,
}

/// Every format that every program has, the window's too; the command line has [`PARQUET`] besides.
pub const TABLE_FORMATS: &[TableFormat] =
    &[control::ITNC530, control::TNC640, control::TNC7, csv::FORMAT, pcdmis::FORMAT];

impl TableFormat {
    /// Whether a file of this name can be of this format.
    pub fn fits(&self, file: &Path) -> bool {
        file.extension().is_some_and(|ending| self.endings.iter().any(|own| ending.eq_ignore_ascii_case(own)))
    }
}

/// What the other tool's documents leave open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "table-format-warning")]
pub enum FormatWarning {
    /// How PC-DMIS takes the sign of a lower deviation.
    LowerSign {
        /// The first class with a lower deviation other than zero.
        class: ToleranceClass,
    },
}

/// Why a table cannot be written in a format.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "table-format", error)]
pub enum TableFormatError {
    /// A control's table cannot be written.
    #[say(transparent)]
    Control(#[from] WriteError),
    /// A name on a TNC7 must begin with a letter.
    Name {
        /// The table's name.
        name: String,
    },
    /// A TNC7 would take the name for a formula.
    Operator {
        /// The table's name.
        name: String,
        /// The operator.
        sign: char,
    },
    /// A program built without the feature `parquet`.
    ParquetUnknown,
    /// The Parquet writer failed.
    Parquet {
        /// What it says.
        reason: String,
    },
    /// The CSV writer failed.
    Csv {
        /// What it says.
        reason: String,
    },
}
