//! The log of points on surfaces, probing in 3-D, as one HTML page: self-contained, without script, for screen and paper.
//!
//! | file | what |
//! |---|---|
//! | `point` | one measurement, and whether its figures agree |
//! | `page` | measurements as a page |
//! | `read` | measurements out of such a page |
//! | `stored` | the part of the page that programs read |
//! | `error` | what is wrong with a measurement or a page |
//!
//! The maker's own page is not documented; its content and layout are our rule (`docs/SOURCES.md`). Beside the table
//! each measurement stands in the page as JSON with its exact figures: that is what is read back, never the table.

mod error;
mod page;
mod point;
mod read;
mod stored;

pub use error::{PointFault, PointLogError};
pub use page::{append, write};
pub use point::{Band, PointLog};
pub use read::{is_log, read};
