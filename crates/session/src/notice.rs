//! What the user is told: what happened, until it is closed or has been seen; and what was told before.

use std::path::PathBuf;

use fitcheck_core::message::Message;

use super::columns::NoticeColumns;
use super::history::ChangeId;
use super::saved::Saved;
use super::shared::Shared;

/// A notice, shown until it is closed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    /// The headline.
    pub message: Message,
    /// Details, one per line: rows of a file that could not be used, warnings.
    pub details: Vec<Message>,
    /// Whether something failed.
    pub is_problem: bool,
    /// The file that was written.
    pub file: Option<PathBuf>,
    /// The change of the history that it tells of.
    pub change: Option<ChangeId>,
    /// What was kept before the change of a setting that it tells of.
    pub before: Option<Box<Saved>>,
    /// Whether it tells of checks that could not be recorded.
    pub records: bool,
    /// The file whose columns it tells of.
    pub columns: Option<NoticeColumns>,
}

impl Notice {
    /// A headline alone.
    pub(super) const fn of(message: Message, is_problem: bool) -> Self {
        Self {
            message,
            details: Vec::new(),
            is_problem,
            file: None,
            change: None,
            before: None,
            records: false,
            columns: None,
        }
    }

    /// Whether somebody has to look at it: a problem, what was skipped or assumed, or a choice that it offers.
    pub const fn asks(&self) -> bool {
        self.is_problem || self.records || self.columns.is_some() || !self.details.is_empty()
    }
}

impl Shared {
    /// Tells the user something. The change of a setting is told until something else is: it is in sight.
    pub fn push_notice(&mut self, notice: Notice) {
        self.notices.retain(|earlier| earlier.before.is_none());
        self.notices.push(notice);
    }

    /// The place of the notice that is shown: the oldest one that asks for a look, or else the oldest one.
    pub fn shown_place(&self) -> usize {
        self.notices.iter().position(Notice::asks).unwrap_or(0)
    }

    /// The notice that is shown.
    pub fn notice(&self) -> Option<&Notice> {
        self.notices.get(self.shown_place())
    }

    /// Tells the user what failed.
    pub fn tell(&mut self, message: Message) {
        self.push_notice(Notice::of(message, true));
    }

    /// Tells the user what failed, before the notice that asked for it.
    pub fn tell_first(&mut self, message: Message) {
        self.notices.insert(0, Notice::of(message, true));
    }

    /// Tells the user that checks are not recorded, and offers to try again: one notice for all of them.
    pub fn tell_of_records(&mut self, message: Message) {
        self.notices.retain(|notice| !notice.records);
        self.push_notice(Notice { records: true, ..Notice::of(message, true) });
    }

    /// Closes the notice that is shown. One that asked for a look stays in the list of what was told before.
    pub fn close_notice(&mut self) {
        /// How many are kept.
        const EARLIER: usize = 50;
        if self.notices.is_empty() {
            return;
        }
        let notice = self.notices.remove(self.shown_place());
        if notice.asks() {
            self.earlier.push_front(notice);
            self.earlier.truncate(EARLIER);
        }
    }

    /// Empties the list of what was told before.
    pub fn forget_messages(&mut self) {
        self.earlier.clear();
        self.shows_messages = false;
    }

    /// Tells the user what was done.
    pub fn note(&mut self, message: Message, details: Vec<Message>) {
        self.push_notice(Notice { details, ..Notice::of(message, false) });
    }

    /// Tells the user what was done, where there are details.
    pub fn note_details(&mut self, message: Message, details: Vec<Message>) {
        if !details.is_empty() {
            self.note(message, details);
        }
    }

    /// The newest notice tells of the last change of the history, and offers to undo it.
    pub fn note_change(&mut self) {
        if let Some(notice) = self.notices.last_mut() {
            notice.change = self.history.last_change();
        }
    }
}
