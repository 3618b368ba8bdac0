//! What the user is told: what happened, until it is closed or has been seen; and what was told before.

use std::collections::VecDeque;
use std::path::PathBuf;

use fitcheck_core::message::Message;

use super::columns::NoticeColumns;
use super::history::ChangeId;
use super::page::Page;
use super::purpose::Purpose;
use super::saved::Saved;

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
    /// What the window itself opens that file as; without one, its own program opens it.
    pub opens: Option<Purpose>,
    /// The change of the history that it tells of.
    pub change: Option<ChangeId>,
    /// What was kept before the change of a setting that it tells of.
    pub before: Option<Box<Saved>>,
    /// Whether it tells of checks that could not be recorded.
    pub records: bool,
    /// The file whose columns it tells of.
    pub columns: Option<NoticeColumns>,
    /// The name of a file that is of no part of the plan: Check can judge it.
    pub unplanned: Option<String>,
    /// The number of the gauge that it tells of.
    pub gauge: Option<u64>,
    /// The page that shows what it tells of.
    pub page: Option<Page>,
    /// The part of that page, by its name, where it is folded away there.
    pub part: Option<&'static str>,
}

impl Notice {
    /// A headline alone.
    pub(super) const fn of(message: Message, is_problem: bool) -> Self {
        Self {
            message,
            details: Vec::new(),
            is_problem,
            file: None,
            opens: None,
            change: None,
            before: None,
            records: false,
            columns: None,
            unplanned: None,
            gauge: None,
            page: None,
            part: None,
        }
    }

    /// Whether somebody has to look at it: a problem, what was skipped or assumed, or a choice that it offers.
    pub const fn asks(&self) -> bool {
        self.is_problem || self.records || self.columns.is_some() || !self.details.is_empty()
    }
}

/// What the user is told now, oldest first, and what was told before.
#[derive(Debug, Default)]
pub(crate) struct Notices {
    open: Vec<Notice>,
    /// How many were told so far.
    told: u64,
    /// What was closed and asked for a look, newest first.
    earlier: VecDeque<Notice>,
    pub shows_earlier: bool,
}

impl Notices {
    /// How many of the earlier ones are kept.
    const EARLIER: usize = 50;

    pub fn open(&self) -> &[Notice] {
        &self.open
    }

    pub const fn earlier(&self) -> &VecDeque<Notice> {
        &self.earlier
    }

    /// The change of a setting is told until something else is: it is in sight. So is that something was copied.
    pub fn push(&mut self, notice: Notice) {
        self.open.retain(|earlier| earlier.before.is_none() && earlier.message.id != "copied");
        self.open.push(notice);
        self.told += 1;
    }

    /// How many were told so far: one that says what another said is another one.
    pub const fn told(&self) -> u64 {
        self.told
    }

    /// Before the notice that asked for it.
    pub fn push_first(&mut self, notice: Notice) {
        self.open.insert(0, notice);
        self.told += 1;
    }

    pub fn retain(&mut self, stays: impl FnMut(&Notice) -> bool) {
        self.open.retain(stays);
    }

    fn shown_place(&self) -> usize {
        self.open.iter().position(Notice::asks).unwrap_or(0)
    }

    /// The notice that is shown: the oldest one that asks for a look, or else the oldest one.
    pub fn shown(&self) -> Option<&Notice> {
        self.open.get(self.shown_place())
    }

    pub fn shown_mut(&mut self) -> Option<&mut Notice> {
        let place = self.shown_place();
        self.open.get_mut(place)
    }

    /// The newest notice with a headline.
    pub fn of_mut(&mut self, message: &Message) -> Option<&mut Notice> {
        self.open.iter_mut().rev().find(|notice| notice.message == *message)
    }

    pub fn newest_mut(&mut self) -> Option<&mut Notice> {
        self.open.last_mut()
    }

    /// Closes the notice that is shown. One that asked for a look stays among the earlier ones.
    pub fn close(&mut self) {
        if self.open.is_empty() {
            return;
        }
        let notice = self.open.remove(self.shown_place());
        if notice.asks() {
            self.earlier.push_front(notice);
            self.earlier.truncate(Self::EARLIER);
        }
    }

    /// Empties the list of the earlier ones.
    pub fn forget_earlier(&mut self) {
        self.earlier.clear();
        self.shows_earlier = false;
    }
}
