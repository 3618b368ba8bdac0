//! Where records are kept, at the edge: an embedded file for each station, and the server of a shop.
//!
//! What an entry is, its bytes and its chain are in [`journal`](crate::journal); here is only where they lie.
//!
//! | file | what |
//! |---|---|
//! | `local` | the journal of a station: one SQLite file |
//! | `error` | why a journal could not be used |
//! | `shop` | the PostgreSQL server of a shop, with the feature of that name |

mod error;
pub mod local;

pub use error::{StoreError, StoreRemark};
