//! Reports as files get them, with what the journal is told of them once they are written.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::Shown;
use fitcheck_exchange::report::{RENDERINGS, Rendering, Report, ReportJournal};
use jiff::civil::DateTime;

use super::{Content, names};
use crate::Session;
use crate::reports::ReportOf;

/// A report with what the journal knows of it.
pub(crate) struct Composed {
    pub report: Report,
    /// What the journal is told of the file; `None` where it has none of the checks.
    pub shown: Option<Shown>,
}

impl Session {
    /// The listed rows of a large file, or the chosen records, or all of them when none is chosen, as a report.
    pub(super) fn export(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        self.content(self.composed(ReportOf::List, now)?, format)
    }

    /// The chosen records of the records page as a report.
    pub(super) fn report_records(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        self.content(self.composed(ReportOf::Records, now)?, format)
    }

    /// The part that is being measured as a report.
    pub(super) fn report_part(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        self.content(self.composed(ReportOf::Part, now)?, format)
    }

    /// A report of something, by the usual template.
    ///
    /// # Errors
    /// There is nothing of it.
    pub(crate) fn composed(&self, of: ReportOf, now: DateTime) -> Result<Composed, Message> {
        let recording = &self.shared.recording;
        let nothing = || message!("dialog-no-path");
        let (report, shown, newest) = match of {
            ReportOf::Part => {
                let report = self.parts.report(now).ok_or_else(nothing)?;
                let numbers = self.parts.numbers_for_report(&report, recording);
                let newest = self.parts.newest_for_report(recording);
                (report, recording.shown(numbers, None), newest)
            }
            ReportOf::Check => {
                let shown = self.check.shown.as_ref().ok_or_else(nothing)?;
                let report = Report::new(now, vec![Arc::clone(&shown.record)]);
                let number = shown.id.and_then(|id| recording.number_of(id));
                (report, recording.shown([number], None), shown.id.and_then(|id| recording.head_of(id)))
            }
            ReportOf::List => self.composed_list(now)?,
            ReportOf::Records => {
                let journal = recording.journal.as_ref().map(|journal| (journal.chain, journal.head));
                let heads = self.records.heads_for_report();
                let newest = heads.last().copied();
                let shown = recording.shown(heads.iter().map(|head| Some(head.number)), newest);
                (self.records.report(now, journal), shown, newest)
            }
            ReportOf::Statistics => {
                let series = self.statistics.series().clone();
                let values = series.features.iter().flat_map(|feature| &feature.values);
                let counted = values.filter(|value| value.left_out.is_none());
                let shown = recording.shown(counted.map(|value| value.origin.number), None);
                let is_partial = self.statistics.found().is_some_and(|found| 0 < found.unread);
                let notes = self.statistics.told_of_question();
                let part = series.features.first().map(|feature| feature.key.part.0.clone());
                let part = part.filter(|part| !part.is_empty() && !series.has_parts());
                (Report { series, part, notes, is_partial, ..Report::new(now, Vec::<Record>::new()) }, shown, None)
            }
        };
        let mut report = report;
        report.template = self.settings_page.company.in_template(&report.template);
        for (id, count) in self.told_of_corrections(of) {
            if 0 < count {
                report.notes.push(Message::new(id).count("count", count));
            }
        }
        Ok(Composed { report: Report { journal: self.journal_of(shown.as_ref(), newest), ..report }, shown })
    }

    /// What was corrected or withdrawn among what is reported; the records page tells it of its own.
    fn told_of_corrections(&self, of: ReportOf) -> [(&'static str, usize); 2] {
        let history = &self.shared.history;
        let [mut left_out, mut corrected] = [0, 0];
        match of {
            ReportOf::Part => {
                let values = (0..self.parts.walking.count()).flat_map(|at| self.parts.walking.values(at));
                corrected = history.corrections(values.filter_map(|value| value.id));
            }
            ReportOf::Check => corrected = history.corrections(self.check.shown.iter().filter_map(|shown| shown.id)),
            ReportOf::List if self.lists_rows() => {}
            ReportOf::List => {
                left_out = history.replaced_for_report();
                corrected = history.corrections(history.ids_for_report());
            }
            ReportOf::Records | ReportOf::Statistics => {}
        }
        [("records-page-out-replaced", left_out), ("records-page-report-corrects", corrected)]
    }

    /// The listed rows of a large file, or the list of the check page.
    fn composed_list(&self, now: DateTime) -> Result<(Report, Option<Shown>, Option<Head>), Message> {
        if let Some(rows) = self.check.rows.as_ref().filter(|_| self.lists_rows()) {
            let report = rows.report(&self.shared.sources, now);
            return Ok((report.ok_or_else(|| message!("rows-export-not-yet"))?, None, None));
        }
        let (history, recording) = (&self.shared.history, &self.shared.recording);
        let records: Vec<Arc<Record>> = history.for_report().map(Arc::clone).collect();
        let numbers = history.ids_for_report().map(|id| recording.number_of(id));
        let heads = history.ids_for_report().filter_map(|id| recording.head_of(id));
        let newest = heads.max_by_key(|head| head.number);
        let notes: Vec<Message> = history.left_out().cloned().collect();
        let report = Report { is_partial: !notes.is_empty(), notes, ..Report::new(now, records) };
        Ok((report, recording.shown(numbers, None), newest))
    }

    /// Where the records of a report stand, as its pages say it.
    fn journal_of(&self, shown: Option<&Shown>, newest: Option<Head>) -> Option<ReportJournal> {
        let shown = shown?;
        let chain = self.shared.recording.journal.as_ref()?.chain;
        Some(ReportJournal { chain, head: shown.head?, newest, numbers: shown.checks.to_string() })
    }

    fn content(&self, composed: Composed, format: usize) -> Result<Content, Message> {
        let rendering = RENDERINGS.get(format).ok_or_else(|| message!("dialog-no-path"))?;
        Ok(composed.content(rendering, self.shared.report_words()))
    }

    /// The proposed name of the report of the reports page: that of the part, of the only check, or of several.
    pub(super) fn report_name(&self, now: DateTime, ending: &str) -> String {
        let several = self.shared.words().get("file-name-checks");
        match self.report_of() {
            Some(ReportOf::Part) => self.part_name(now, ending),
            Some(ReportOf::Check) => {
                let shown = self.check.shown.iter().map(|shown| shown.record.as_ref());
                names::of_records(shown, &several, now, ending)
            }
            Some(ReportOf::Records) => {
                let records = self.records.for_report();
                names::of_records(records.iter().map(Arc::as_ref), &several, now, ending)
            }
            Some(ReportOf::Statistics) => {
                let part = self.statistics.part().map(str::to_owned);
                let part = part.unwrap_or_else(|| self.shared.words().get("page-statistics"));
                names::dated(&names::allowed(&part), now, ending)
            }
            Some(ReportOf::List) | None => {
                let records = self.shared.history.for_report().map(Arc::as_ref);
                names::of_records(records, &several, now, ending)
            }
        }
    }

    /// That of the part that is being measured.
    pub(super) fn part_name(&self, now: DateTime, ending: &str) -> String {
        self.parts.report(now).map_or_else(String::new, |report| {
            let part = report.part.unwrap_or_else(|| self.shared.words().get("file-name-checks"));
            let name = [part.as_str(), self.parts.walking.serial()].into_iter().filter(|text| !text.is_empty());
            names::dated(&names::allowed(&name.collect::<Vec<_>>().join("-")), now, ending)
        })
    }
}

impl Composed {
    /// The report as a file gets it, with what the journal is told of it.
    pub fn content(self, rendering: &'static Rendering, words: Words) -> Content {
        let Self { report, shown } = self;
        Content::Report { report: Box::new(report), rendering, words: Arc::new(words), shown: shown.map(Box::new) }
    }
}
