//! A study of a gauge: readings of a file, how they were understood, and, once that is confirmed, whether the gauge is good enough.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `command` | what can be done, and what comes back from outside |
//! | `file` | the readings of a file, with what is to be said of them |
//! | `asked` | what is asked: how it is understood, and what it comes to |
//! | `asking` | from the fields to what is asked; nothing stays beside what it was not made with |
//! | `texts` | layout, figures and advice in words |
//!
//! Nothing is computed before the layout is confirmed.

mod asked;
mod asking;
mod command;
mod file;
mod texts;

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_exchange::series::StudyKind;
use jiff::civil::Date;

pub use asked::{StudyAsked, StudyFound, StudyRead};
pub use command::StudyCommand;
pub use file::StudyFile;
pub use texts::StudyFigure;
pub(super) use texts::kind_id;

use super::StatisticsField;
use crate::effect::Effect;

/// The state of a study.
#[derive(Debug, Default)]
pub struct Study {
    pub kind: StudyKind,
    file: Option<Arc<StudyFile>>,
    /// The feature that is chosen of several.
    pub feature: Option<String>,
    /// How the readings were understood, or why they make no study; `None` without a file.
    pub read: Option<Result<StudyRead, Message>>,
    errors: BTreeMap<StatisticsField, Message>,
    runs: u64,
    /// The number of the question that is being computed.
    evaluating: Option<u64>,
    found: Option<Result<Arc<StudyFound>, Message>>,
    errands: Vec<Effect>,
}

impl Study {
    /// The file whose readings are evaluated.
    pub fn file(&self) -> Option<&StudyFile> {
        self.file.as_deref()
    }

    /// What it comes to, or why it comes to nothing; `None` until it is evaluated.
    pub fn found(&self) -> Option<Result<&StudyFound, &Message>> {
        self.found.as_ref().map(|found| found.as_ref().map(Arc::as_ref))
    }

    /// What it comes to, where figures could be computed.
    pub fn evaluated(&self) -> Option<&StudyFound> {
        self.found.as_ref()?.as_ref().ok().map(Arc::as_ref).filter(|found| found.answer.doubt.is_none())
    }

    /// A number that changes with what was found.
    pub const fn version(&self) -> u64 {
        self.runs
    }

    pub const fn is_working(&self) -> bool {
        self.evaluating.is_some()
    }

    /// Whether the layout can be evaluated, apart from what looks wrong with it.
    pub fn is_whole(&self) -> bool {
        let is_read = self.read.as_ref().is_some_and(|read| read.as_ref().is_ok_and(StudyRead::is_whole));
        is_read && self.errors.is_empty() && !self.is_working()
    }

    /// Whether something looks wrong that has to be confirmed: with the layout, or by the figures.
    pub fn is_doubted(&self) -> bool {
        let by_layout = self.read.as_ref().is_some_and(|read| read.as_ref().is_ok_and(StudyRead::is_doubted));
        let by_figures =
            self.found.as_ref().is_some_and(|found| found.as_ref().is_ok_and(|of| of.answer.doubt.is_some()));
        by_layout || by_figures
    }

    /// Whether it gives an uncertainty budget something.
    pub fn has_budget(&self) -> bool {
        self.evaluated().is_some_and(|found| !found.answer.contributions.is_empty())
    }

    /// What it gives an uncertainty budget, as a file.
    pub(crate) fn budget(&self, today: Date) -> Option<String> {
        self.evaluated()?.answer.budget(&self.file()?.name, today)
    }

    /// What is wrong with one of its fields.
    pub(super) fn error(&self, field: StatisticsField) -> Option<&Message> {
        self.errors.get(&field)
    }

    /// What has to be done outside.
    pub(super) fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }
}
