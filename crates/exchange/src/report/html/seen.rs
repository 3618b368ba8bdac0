//! A first look at the checks of a report: how many there are, and which of them a page lists.

use std::io;

use fitcheck_core::message::Message;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::shared::Shared;
use super::{CONTACTS_IN_CHECK, MOST_CHECKS};
use crate::journal::Record;
use crate::report::Report;

/// What a first look at all checks finds.
#[derive(Default)]
pub(in crate::report) struct ReportSurvey {
    /// How many there are of each status.
    pub counts: [usize; Status::ALL.len()],
    /// The same of those that nobody measured.
    pub simulated: [usize; Status::ALL.len()],
    pub total: usize,
    /// The first that are not good or in doubt, by their place in the report, and how many there are.
    wanted: Vec<usize>,
    all_wanted: usize,
    /// The most checks that are listed.
    most: usize,
    /// Whether a check has contacts at the end.
    pub has_annex: bool,
    /// Whether a check was judged by a rule other than the plain one.
    pub has_guards: bool,
    /// What all checks have in common.
    pub(in crate::report::html) shared: Shared,
}

impl ReportSurvey {
    pub fn of(report: &Report) -> io::Result<Self> {
        Self::listing(report, MOST_CHECKS)
    }

    /// The same where so many checks are listed at most.
    pub fn listing(report: &Report, most: usize) -> io::Result<Self> {
        let mut seen = Self { most, ..Self::default() };
        report.checks.each(&mut |record| {
            let status = record.verdict.status();
            let is_simulated = record.measurement.origin.is_simulated();
            let counted = [(&mut seen.counts, true), (&mut seen.simulated, is_simulated)];
            for (counts, counts_it) in counted {
                if let Some(count) = counts.get_mut(status.at()) {
                    *count += usize::from(counts_it);
                }
            }
            if status != Status::Good || record.doubt.is_some() {
                seen.all_wanted += 1;
                if seen.wanted.len() < most {
                    seen.wanted.push(seen.total);
                }
            }
            seen.has_guards |= !record.verdict.rule.is_plain();
            seen.shared.see(record, seen.total == 0);
            seen.has_annex |= CONTACTS_IN_CHECK < record.measurement.contacts.len();
            seen.total += 1;
            Ok(())
        })?;
        Ok(seen)
    }

    /// Whether the page lists all checks.
    pub const fn is_whole(&self) -> bool {
        self.total <= self.most
    }

    /// What the page says of the checks that it does not list.
    pub fn note(&self, words: &Words) -> Option<String> {
        let id = match self.wanted.len() {
            _ if self.is_whole() => return None,
            0 => "report-page-all-good",
            listed if listed == self.all_wanted => "report-page-not-good",
            _ => "report-page-first",
        };
        let listed = Message::new(id).count("listed", self.wanted.len()).count("wanted", self.all_wanted);
        Some(words.say(&listed.count("total", self.total)))
    }

    /// Shows every check that the page lists, with its number in the report.
    pub fn each(&self, report: &Report, see: &mut dyn FnMut(usize, &Record) -> io::Result<()>) -> io::Result<()> {
        let mut at = 0;
        let mut wanted = self.wanted.iter().peekable();
        report.checks.each(&mut |record| {
            at += 1;
            if self.is_whole() || wanted.next_if_eq(&&(at - 1)).is_some() { see(at, record) } else { Ok(()) }
        })
    }
}
