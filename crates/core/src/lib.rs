//! Whether a probed hole or shaft is good, rework or scrap, and why: limits of size, measuring cycles and verdicts.
//!
//! Data goes one way, from a callout to a verdict. Nothing here reads a file, starts a thread or asks for the time.
//!
//! | module | what |
//! |---|---|
//! | [`message`], [`words`] | sentences without a language; texts in the user's language |
//! | [`length`] | whole nanometres |
//! | [`tolerance`] | callouts, classes, limits, fits as geometry |
//! | [`verdict`] | good, rework, scrap; decision rules |
//! | [`pairing`] | which measured holes go with which measured shafts |
//! | [`probing`] | contacts, circles, measuring cycles, the simulated workpiece |
//! | [`budget`] | how sure a measured value is |
//! | [`part`] | whole parts: plans of features |
//! | [`text`] | from the bytes of a text file to text and lines |

#![warn(missing_docs)]

// What is derived names the types of this crate by its name, here as elsewhere.
extern crate self as fitcheck_core;

pub mod budget;
pub mod length;
pub mod message;
pub mod pairing;
pub mod part;
pub mod probing;
pub mod text;
pub mod tolerance;
pub mod verdict;
pub mod words;
