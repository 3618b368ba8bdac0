//! Fitcheck tells whether a probed hole or shaft is good, rework or scrap, and why.
//!
//! The rooms of the house are crates below `crates/`, in the order in which data goes through them; here they have one
//! roof, with the command line and the window.
//!
//! | module | what |
//! |---|---|
//! | [`shipped`], [`message`] | the built-in files; sentences without a language |
//! | [`length`] | whole nanometres |
//! | [`tolerance`] | callouts, classes, limits |
//! | [`probing`] | contacts, circles, measuring cycles, the simulated workpiece |
//! | [`verdict`] | good, rework, scrap |
//! | [`pairing`] | which measured holes go with which measured shafts |
//! | [`budget`] | how sure a measured value is |
//! | [`part`] | whole parts: plans of features |
//! | [`statistics`] | charts, capability, gauge studies and advice |
//! | [`control`] | the control's tables, masks and logs |
//! | [`nc`] | NC programs: read, written, run |
//! | [`exchange`] | files of other tools |
//! | [`series`] | values of a feature in a row, with their figures |
//! | [`batch`] | rows by the million, judged by several workers |
//! | [`journal`] | what was checked, when, by which rule |
//! | [`report`] | inspection reports |
//! | [`proof`] | what a written report says, against the journal |
//! | [`files`] | reading and writing files safely |
//! | [`store`] | where records are kept: a file of one station, the server of a shop |
//! | [`gauges`] | gauges on serial and USB ports |
//! | [`watch`] | a folder that files are dropped into |
//! | `gui` | the window, with the feature `gui` |
//! | [`session`] | the state of the application |
//! | [`cli`] | the command line |
//! | [`words`], [`text`] | texts in the user's language; bytes of a text file to lines |

pub mod cli;
#[cfg(feature = "gui")]
pub mod gui;

pub use fitcheck_core::{budget, length, message, pairing, part, probing, text, tolerance, verdict, words};
pub use fitcheck_exchange::{batch, exchange, journal, proof, report, row, series};
pub use fitcheck_files as files;
pub use fitcheck_gauges as gauges;
pub use fitcheck_nc::{self as nc, control};
pub use fitcheck_session as session;
pub use fitcheck_shipped as shipped;
pub use fitcheck_statistics as statistics;
pub use fitcheck_store::{self as store, watch};
