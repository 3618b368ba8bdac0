//! The log of points on surfaces, probing in 3-D, as one HTML page: self-contained, no script, for screen and paper.
//!
//! | file | what |
//! |---|---|
//! | `point` | one measurement, and whether its figures agree |
//! | `page` | measurements as a page |
//! | `read` | a page back to measurements |
//! | `stored` | the part of the page that programs read |
//! | `error` | what is wrong with a measurement or a page |
//!
//! The maker's own page is not documented; its content and layout are our rule (`docs/SOURCES.md`). Besides the table
//! the page holds each measurement as JSON with its exact figures: the reader reads that, never the table.

mod error;
mod page;
mod point;
mod read;
mod stored;

pub use error::{PointFault, PointLogError};
pub use page::{append, write};
pub use point::{Band, PointLog};
pub use read::{each, is_log, read};
