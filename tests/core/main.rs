mod report;
//! Tests of the core and the command line, in one binary.

mod limits_cli;
mod tables;
