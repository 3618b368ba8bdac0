//! Measurements as they come from other programs, and what goes out: reports, records, rows by the million.
//!
//! | module | what |
//! |---|---|
//! | [`exchange`] | one file per format of other tools: bytes in; records, warnings, errors out |
//! | [`journal`] | what was checked, when, by which rule: an entry, its bytes, the chain |
//! | [`row`] | a check in figures, under the names that files for programs share |
//! | `report` | inspection reports: one model, one file per rendering (feature `reports`) |
//! | `proof` | what a written report says, against the journal (feature `reports`) |
//! | [`series`] | values of a feature in a row: what counts, and the figures of it |
//! | [`batch`] | rows by the million, judged by several workers |
//!
//! No file is opened here, no path is followed and no database is asked: bytes come in and go out.

pub mod batch;
pub mod exchange;
pub mod journal;
#[cfg(feature = "reports")]
pub mod proof;
#[cfg(feature = "reports")]
pub mod report;
pub mod row;
pub mod series;
