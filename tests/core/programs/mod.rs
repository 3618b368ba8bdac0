//! Reading and writing NC programs.

mod properties;
mod reading;
mod refusing;
mod samples;
