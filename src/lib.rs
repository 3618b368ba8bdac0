//! Fitcheck tells whether a probed hole or shaft is good, rework or scrap, and why.
//!
//! The rooms of the house, in the order in which data goes through them:
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
//! | [`control`] | the control's tables, masks and logs |
//! | [`part`] | whole parts: plans of features |
//! | [`nc`] | NC programs: read, written, run |
//! | [`exchange`] | files of other tools |
//! | [`batch`] | rows by the million, judged by several workers |
//! | [`journal`] | what was checked, when, by which rule |
//! | [`report`] | inspection reports |
//! | [`store`] | where records are kept: a file of one station, the server of a shop |
//! | [`watch`] | a folder that files are dropped into |
//! | `gui` | the window, with the feature `gui` |
//! | [`session`] | the state of the application |
//! | [`cli`] | the command line |
//! | [`words`], [`files`] | texts in the user's language; reading and writing files safely |

pub mod batch;
pub mod budget;
pub mod cli;
pub mod control;
pub mod exchange;
pub mod files;
#[cfg(feature = "gui")]
pub mod gui;
pub mod journal;
pub mod length;
pub mod message;
pub mod nc;
pub mod pairing;
pub mod part;
pub mod probing;
pub mod report;
pub mod session;
pub mod shipped;
pub mod store;
pub mod tolerance;
pub mod verdict;
pub mod watch;
pub mod words;
