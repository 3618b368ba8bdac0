//! Reading and writing NC programs.

mod around;
mod properties;
mod reading;
mod refusing;
mod samples;
