//! Where records are kept, at the edge: an embedded file for each station, and the server of a shop.
//!
//! What an entry is, its bytes and its chain are in [`journal`](fitcheck_exchange::journal); here is only where they lie.
//!
//! | file | what |
//! |---|---|
//! | `local` | the journal of a station: one SQLite file |
//! | `here` | this computer: its name and its time |
//! | `error` | why a journal could not be used |
//! | `shop` | the PostgreSQL server of a shop, with the feature of that name |

mod error;
pub mod here;
pub mod local;
pub mod programs;
#[cfg(feature = "shop")]
pub mod shop;
pub mod tables;
pub mod watch;

pub use error::{StoreError, StoreRemark};

/// Whether a text names the server of a shop and not a file. It may hold a password: it is not to be shown.
pub fn is_server(text: &str) -> bool {
    let text = text.trim_start();
    ["postgres:", "postgresql:"]
        .iter()
        .any(|scheme| text.get(..scheme.len()).is_some_and(|start| start.eq_ignore_ascii_case(scheme)))
}
