//! Reading and writing NC programs.

mod around;
mod din_plus;
mod properties;
mod reading;
mod refusing;
mod samples;
