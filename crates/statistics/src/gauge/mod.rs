//! Studies of gauges: is this probe good enough for this tolerance, and what is the smallest one that it is good enough for?
//!
//! | file | what |
//! |---|---|
//! | `master` | type 1: many readings of one master |
//! | `study` | repeatability and reproducibility: parts, operators and readings, crossed or nested |
//! | `linearity` | bias over the range of sizes |
//! | `stability` | a master over time |
//! | `finding` | what they say in sentences |

mod finding;
mod linearity;
mod master;
mod stability;
mod study;

pub use finding::{ACCEPTED_SHARE, Finding, GOOD_SHARE};
pub use linearity::{BiasAt, Linearity, linearity};
pub use master::{MasterPlan, MasterStudy, master_study};
pub use stability::{Stability, stability};
pub use study::{Component, Components, Design, Layout, Study, StudyPlan, crossed, nested};
