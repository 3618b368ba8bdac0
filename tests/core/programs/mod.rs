//! Reading and writing NC programs.

mod around;
mod iso;
mod iso_like_klartext;
mod properties;
mod reading;
mod refusing;
mod samples;
