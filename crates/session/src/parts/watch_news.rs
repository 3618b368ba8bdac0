//! What is told of a watched folder from outside.

use fitcheck_core::message::Message;
use fitcheck_exchange::exchange::Item;
use fitcheck_exchange::journal::chain::Hash;

/// What came from a watched folder.
#[derive(Debug, Clone, PartialEq)]
pub enum WatchNews {
    /// The watch has begun, and knows so many files that were taken before.
    Begun(usize),
    /// Files are ready.
    Look {
        /// The number of the look.
        number: u64,
        files: Vec<WatchedFile>,
    },
    /// These files are not ready, with the reasons; none where nothing is waited for.
    Waiting(Vec<(String, Message)>),
    /// The folder cannot be read, or the watch cannot begin; `None` where it can again.
    Trouble(Option<Message>),
}

/// A file that is ready.
#[derive(Debug, Clone, PartialEq)]
pub struct WatchedFile {
    /// Its name without the folder.
    pub name: String,
    /// SHA-256 of what was read of it.
    pub sha256: Hash,
    /// What it holds, judged by the plan.
    pub items: Vec<Item>,
    /// What else is to be said of it.
    pub remarks: Vec<Message>,
}
