//! Where the entries come from that are sent to a server.

use fitcheck_core::message::{Message, Say as _};
use fitcheck_exchange::journal::chain::{ChainId, Head};
use fitcheck_exchange::journal::entry::Kept;

use crate::local::Reader;

/// A journal whose entries are sent.
pub trait Source {
    /// The name of its chain.
    fn chain(&self) -> ChainId;

    /// Its last entry.
    ///
    /// # Errors
    /// What is wrong with it.
    fn head(&self) -> Result<Head, Message>;

    /// At most so many entries from a number on, ascending.
    ///
    /// # Errors
    /// What is wrong with it.
    fn entries(&self, from: u64, most: usize) -> Result<Vec<Kept>, Message>;
}

/// The journal of this station.
impl Source for Reader {
    fn chain(&self) -> ChainId {
        Self::chain(self)
    }

    fn head(&self) -> Result<Head, Message> {
        Self::head(self).map_err(|error| error.message())
    }

    fn entries(&self, from: u64, most: usize) -> Result<Vec<Kept>, Message> {
        Self::entries(self, from, most).map_err(|error| error.message())
    }
}
