//! Reports as files get them, with what the journal is told of them once they are written.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::entry::Shown;
use fitcheck_exchange::report::{RENDERINGS, Rendering, Report};
use jiff::civil::DateTime;

use super::Content;
use crate::Session;

impl Session {
    /// The listed rows of a large file, or the chosen records, or all of them when none is chosen, as a report.
    pub(super) fn export(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        let Some(rendering) = RENDERINGS.get(format) else { return Err(message!("dialog-no-path")) };
        let (report, shown) = if let Some(rows) = self.check.rows.as_ref().filter(|_| self.lists_rows()) {
            (rows.report(&self.shared.sources, now).ok_or_else(|| message!("rows-export-not-yet"))?, None)
        } else {
            let records: Vec<Arc<Record>> = self.shared.history.for_report().map(Arc::clone).collect();
            let checks = self.shared.history.ids_for_report().map(|id| self.shared.recording.number_of(id));
            (Report::new(now, records), self.shared.recording.shown(checks, None))
        };
        Ok(self.content(report, rendering, shown))
    }

    /// The chosen records of the records page as a report.
    pub(super) fn report_records(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        let Some(rendering) = RENDERINGS.get(format) else { return Err(message!("dialog-no-path")) };
        let journal = self.shared.recording.journal.as_ref().map(|journal| (journal.chain, journal.head));
        let heads = self.records.heads_for_report();
        let newest = heads.last().copied();
        let shown = self.shared.recording.shown(heads.iter().map(|head| Some(head.number)), newest);
        Ok(self.content(self.records.report(now, journal), rendering, shown))
    }

    /// The part that is being measured as a report.
    pub(super) fn report_part(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        let report = RENDERINGS.get(format).zip(self.parts.report(now));
        let (rendering, report) = report.ok_or_else(|| message!("dialog-no-path"))?;
        let numbers = self.parts.numbers_for_report(&report, &self.shared.recording);
        let shown = self.shared.recording.shown(numbers, None);
        Ok(self.content(report, rendering, shown))
    }

    /// A report as a file gets it, with what the journal is told of it.
    fn content(&self, report: Report, rendering: &'static Rendering, shown: Option<Shown>) -> Content {
        let words = Arc::new(self.shared.report_words());
        Content::Report { report: Box::new(report), rendering, words, shown: shown.map(Box::new) }
    }
}
