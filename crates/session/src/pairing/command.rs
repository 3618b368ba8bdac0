//! What can be done on the pairing page, and what comes back from outside.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::Feature;
use fitcheck_exchange::report::pairing::PairingParts;

use super::{Paired, PairingField};
use crate::Step;

/// What can be done on the pairing page.
#[derive(Debug, Clone)]
pub enum PairingCommand {
    /// Replaces the text of a field.
    Type(PairingField, String),
    /// A file of holes or shafts was read, or not.
    Read {
        /// What it was read as.
        feature: Feature,
        /// The file.
        path: PathBuf,
        /// Its parts, or why there are none.
        result: Result<Arc<PairingParts>, Message>,
    },
    /// Takes the holes or the shafts among the checks of the history: the chosen checks, or all where none is chosen.
    TakeHistory(Feature),
    /// A file was dropped, and both sides have their parts.
    NoSideFree {
        /// Its name without the folder.
        name: String,
    },
    /// The parts are paired.
    Paired {
        /// The number of the question.
        run: u64,
        /// The answer.
        paired: Arc<Paired>,
    },
    /// Goes to another pair.
    Move(Step),
    /// Goes to the pair at a place of the list.
    Select(usize),
    /// Puts all pairs on the clipboard.
    Copy,
}
