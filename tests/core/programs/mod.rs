//! Reading and writing NC programs.

mod din_plus;
mod properties;
mod reading;
mod refusing;
mod samples;
