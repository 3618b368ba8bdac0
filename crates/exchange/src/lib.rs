//! Measurements as they come from other programs, and what goes out: reports, records, rows by the million.
//!
//! | module | what |
//! |---|---|
//! | [`exchange`] | one file per format of other tools: bytes in; records, warnings, errors out |
//! | [`journal`] | what was checked, when, by which rule: an entry, its bytes, the chain |
//! | [`report`] | inspection reports: one model, one file per rendering |
//! | [`proof`] | what a written report says, against the journal |
//! | [`series`] | values of a feature in a row: what counts, and the figures of it |
//! | [`batch`] | rows by the million, judged by several workers |
//!
//! No file is opened here, no path is followed and no database is asked: bytes come in and go out.

pub mod batch;
pub mod exchange;
pub mod journal;
pub mod proof;
pub mod report;
pub mod series;
