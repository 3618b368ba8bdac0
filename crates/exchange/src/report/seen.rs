//! A first look at the checks of a report: how many there are, what is special about them, and which of them a page lists.

use std::io;

use fitcheck_core::message::{Message, message};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::Report;
use super::changes::Changes;
use super::said::decimals_of;
use super::shared::Shared;
use crate::journal::Record;

/// What a first look at all checks finds.
#[derive(Default)]
pub(super) struct ReportSurvey {
    /// The most checks that the page lists.
    most: usize,
    /// How many there are of each status.
    pub counts: [usize; Status::ALL.len()],
    pub total: usize,
    /// How many nobody measured, were brought to 20 °C, are in doubt, are accepted beyond a limit, or have a rule other than the plain one.
    pub simulated: usize,
    /// How many of each status nobody measured.
    pub simulated_of: [usize; Status::ALL.len()],
    pub corrected: usize,
    pub doubted: usize,
    pub beyond: usize,
    pub guarded: usize,
    /// The most contacts of a check.
    pub contacts: usize,
    /// The longest name of a check, bytes.
    longest: usize,
    /// The most decimals of a size in millimetres, 3 at least.
    pub decimals: usize,
    /// The first that are not good or in doubt, by their place in the report, and how many there are.
    wanted: Vec<usize>,
    all_wanted: usize,
    /// What all checks have in common.
    pub shared: Shared,
    /// What changed since an earlier report.
    pub changes: Option<Changes>,
}

impl ReportSurvey {
    /// Looks at all checks, for a page that lists at most so many.
    pub fn of(report: &Report, most: usize) -> io::Result<Self> {
        let mut seen = Self { most, decimals: 3, ..Self::default() };
        report.checks.each(&mut |record| {
            seen.see(record);
            Ok(())
        })?;
        seen.changes = report.earlier.as_ref().map(|earlier| Changes::since(earlier, report)).transpose()?;
        Ok(seen)
    }

    fn see(&mut self, record: &Record) {
        let status = record.verdict.status();
        if let Some(count) = self.counts.get_mut(status.at()) {
            *count += 1;
        }
        if status != Status::Good || record.doubt.is_some() {
            self.all_wanted += 1;
            if self.wanted.len() < self.most {
                self.wanted.push(self.total);
            }
        }
        let is_simulated = record.measurement.origin.is_simulated();
        self.simulated += usize::from(is_simulated);
        if let Some(count) = self.simulated_of.get_mut(status.at()) {
            *count += usize::from(is_simulated);
        }
        self.corrected += usize::from(record.correction.is_some());
        self.doubted += usize::from(record.doubt.is_some());
        self.beyond += usize::from(record.verdict.is_beyond_limits());
        self.guarded += usize::from(!record.verdict.rule.is_plain());
        self.longest = self.longest.max(record.id.len());
        self.contacts = self.contacts.max(record.measurement.contacts.len());
        let sizes = [record.limits.maximum(), record.limits.minimum(), record.measurement.diameter];
        self.decimals = sizes.into_iter().map(decimals_of).fold(self.decimals, usize::max);
        self.shared.see(record, self.total == 0);
        self.total += 1;
    }

    /// Whether the page lists all checks.
    pub const fn is_whole(&self) -> bool {
        self.total <= self.most
    }

    /// What the values say together: only measured and complete ones within their limits, of an input that was judged as a whole, are a statement
    /// of conformity.
    pub fn statement(&self, report: &Report) -> Message {
        let good = self.counts.get(Status::Good.at()).copied().unwrap_or(0);
        let open: usize = report.parts.iter().map(|part| part.missing().len() + part.left_out().len()).sum();
        let bad = self.total.saturating_sub(good) + self.beyond;
        if 0 < bad {
            message!("report-statement-not").count("bad", bad).count("count", self.total)
        } else if report.is_partial {
            message!("report-statement-partial")
        } else if 0 < self.simulated {
            message!("report-statement-simulated").count("count", self.simulated)
        } else if 0 < self.doubted {
            // A value that may be another quantity or another part's proves nothing.
            message!("report-pdf-doubted").count("count", self.doubted).count("total", self.total)
        } else if 0 < open || self.total == 0 {
            message!("report-statement-open").count("count", open)
        } else {
            message!("report-statement-conforms").count("count", self.total)
        }
    }

    /// Whether its data are surely few: no text of a check that somebody gave is long, and a check has some kilobytes at most.
    pub const fn is_short(&self) -> bool {
        self.total <= 500 && self.contacts <= 100 && self.longest <= 1_000
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
