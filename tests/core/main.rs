//! The core and the command line.

mod masks;
