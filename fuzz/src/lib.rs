//! The targets, for the programs in `bin`. The tests of the core read the same files.

pub mod targets;
