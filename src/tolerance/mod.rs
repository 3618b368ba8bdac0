//! From a callout to limits of size.
//!
//! | file | what |
//! |---|---|
//! | `class` | tolerance classes such as `H7`, hole or shaft by the letter's case |
//! | `callout` | what people type: `25 H7` |
//! | `limits` | deviations and limits of size, and where they come from |
//! | `table` | size ranges and deviations as a control's table holds them |
//! | `fit` | a hole against a shaft: clearances, search, temperature |
//! | `lookup` | from a callout to limits: the user's tables first, then the shipped ones |
//!
//! Nothing here reads a file or knows a window: tables arrive as values.

pub mod callout;
pub mod class;
pub mod fit;
pub mod iso286;
pub mod limits;
pub mod lookup;
mod ranges;
pub mod table;

pub use callout::{Callout, CalloutError};
pub use class::{ClassError, Feature, ToleranceClass};
pub use limits::{Deviations, DeviationsError, Limits, Source};
pub use lookup::{LimitsError, Tables};
pub use table::DeviationTable;
