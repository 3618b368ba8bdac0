//! What can be done with a study of a gauge, and what comes back from outside.

use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_exchange::series::StudyKind;

use super::{StudyFile, StudyFound};

/// What can be done with a study of a gauge, and what comes back from outside.
#[derive(Debug, Clone)]
pub enum StudyCommand {
    /// A file with readings was read, or not.
    Read {
        /// Its name without the folder.
        name: String,
        result: Result<Arc<StudyFile>, Message>,
    },
    /// Chooses the kind of study.
    SetKind(StudyKind),
    /// Chooses the feature, where the file has several.
    ChooseFeature(String),
    /// Confirms the layout and evaluates it; with `all_the_same` also one that looks wrong.
    Evaluate { all_the_same: bool },
    /// It was evaluated.
    Evaluated {
        /// The number of the question.
        run: u64,
        result: Result<Arc<StudyFound>, Message>,
    },
}
