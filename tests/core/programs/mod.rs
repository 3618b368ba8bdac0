//! Reading and writing NC programs.

mod around;
mod din_plus;
mod iso;
mod iso_like_klartext;
mod properties;
mod reading;
mod refusing;
mod samples;
