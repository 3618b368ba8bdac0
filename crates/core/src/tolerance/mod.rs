//! From a callout to limits of size.
//!
//! | file | what |
//! |---|---|
//! | `class` | tolerance classes such as `H7`, hole or shaft by the letter's case |
//! | `callout` | what people type: `25 H7`, `25 H7/g6`, `10m`, `12 +0.01 -0.015`, `12.01/11.985` |
//! | `iso2768` | general tolerances: `10m` |
//! | `deviations` | the two deviations from a size |
//! | `limits` | limits of size, and where the deviations come from |
//! | `figure` | figures to check: contested ones, and those of own tables that differ from the standard |
//! | `coarsest` | the widest zone that a size has |
//! | `proportion` | zones that are out of all proportion to their size |
//! | `table` | size ranges and deviations as a control's table holds them |
//! | `table_edit` | a table that is being edited, and tables made from the standard |
//! | `compare` | a table against the standard, cell by cell |
//! | `iso286` | the standard: every class, 0 to 3150 mm |
//! | `nominal` | the nominal value of cycles 14xx, with its limits |
//! | `sources` | from a callout to limits: the user's own tables first, then a source of the list in `sources/bases` |
//! | `fit` | a hole against a shaft: clearances, search, temperature |
//!
//! Nothing here reads a file or depends on a window: tables come in as values.

pub mod callout;
pub mod class;
mod coarsest;
pub mod compare;
mod deviations;
mod figure;
pub mod fit;
pub mod iso2768;
pub mod iso286;
pub mod limits;
mod nominal;
pub mod proportion;
mod ranges;
pub mod sources;
pub mod table;
pub mod table_edit;

pub use callout::{Callout, CalloutError, CalloutErrorKind, CycleText, PartTolerance, Tolerance};
pub use class::{ClassError, Feature, ToleranceClass};
pub use deviations::{Deviations, DeviationsError};
pub use figure::FigureWarning;
pub use iso2768::GeneralClass;
pub use limits::{Bounds, Limits, Source};
pub use nominal::{Nominal, NominalError};
pub use proportion::ZoneDoubt;
pub use sources::{Absent, Base, LimitsError, Sources};
pub use table::DeviationTable;
