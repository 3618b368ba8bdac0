//! The report that the page shows and writes: from what is reported, by the chosen template.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::report::template::Template;
use fitcheck_exchange::report::{RENDERINGS, Rendering, Report};
use jiff::civil::DateTime;

use super::{ReportOf, ReportsField, ReportsPage};
use crate::Session;
use crate::effect::Effect;
use crate::files::Content;
use crate::page::Page;

impl ReportsPage {
    /// The template with what was chosen beside it.
    fn made_template(&self) -> Template {
        let template = self.template();
        let sections = template.sections.iter().copied().filter(|section| !self.hidden.contains(section));
        Template { sections: sections.collect(), paper: self.paper(), ..template.as_ref().clone() }
    }

    /// Asks for the pages of a report; while others are being drawn, it waits for them.
    fn draw(&mut self, made: Result<Content, Message>) {
        self.is_stale = false;
        self.run += 1;
        match made {
            Ok(content) => {
                self.at_work = Some(self.run);
                self.errands.push(Effect::DrawReport { run: self.run, content: Box::new(content) });
            }
            Err(why) => self.pages = Some(Err(why)),
        }
    }

    pub(super) fn take_pages(
        &mut self,
        run: u64,
        result: Result<Arc<fitcheck_exchange::report::pdf::Pages>, Message>,
    ) {
        if self.at_work == Some(run) {
            self.at_work = None;
            self.pages = Some(result);
        }
    }
}

impl Session {
    /// What there is something of to report.
    pub fn reportable(&self) -> impl Iterator<Item = ReportOf> {
        ReportOf::ALL.into_iter().filter(|of| match of {
            ReportOf::Part => self.parts.walking.is_begun(),
            ReportOf::Check => self.check.shown.is_some(),
            ReportOf::List => self.check.rows.is_some() || !self.shared.history.is_empty(),
            ReportOf::Records => 0 < self.records.reported(),
        })
    }

    /// What the reports page is about: what was chosen, as long as there is something of it.
    pub fn report_of(&self) -> Option<ReportOf> {
        let chosen = self.reports.of.filter(|of| self.reportable().any(|other| other == *of));
        chosen.or_else(|| self.reportable().next())
    }

    /// Asks for the pages that the open reports page does not have yet.
    pub(crate) fn draw_report(&mut self, now: DateTime) -> Vec<Effect> {
        if self.shared.page == Page::Reports && self.reports.is_stale && self.reports.at_work.is_none() {
            let made = self.made_report(&fitcheck_exchange::report::pdf::RENDERING, now);
            self.reports.draw(made);
        }
        self.reports.errands.drain(..).collect()
    }

    /// The report in a format of its list, by its number there.
    ///
    /// # Errors
    /// There is nothing to report.
    pub(crate) fn report_to_write(&self, format: usize, now: DateTime) -> Result<Content, Message> {
        let rendering = RENDERINGS.get(format).ok_or_else(|| message!("dialog-no-path"))?;
        self.made_report(rendering, now)
    }

    fn made_report(&self, rendering: &'static Rendering, now: DateTime) -> Result<Content, Message> {
        let of = self.report_of().ok_or_else(|| message!("reports-page-nothing"))?;
        let report = match of {
            ReportOf::Part => self.parts.report(now),
            ReportOf::Check => self.check.shown.as_ref().map(|shown| Report::new(now, vec![Arc::clone(&shown.record)])),
            ReportOf::List => Some(self.listed_report(now)?),
            ReportOf::Records => Some(self.records_report(now)),
        };
        let mut report = report.ok_or_else(|| message!("reports-page-nothing"))?;
        report.template = Arc::new(self.reports.made_template());
        for field in ReportsField::all() {
            let text = self.reports.texts.text(*field).trim().to_owned();
            if text.is_empty() {
                continue;
            }
            match field.head() {
                None => report.title = text,
                Some(head) => report.tell(head, text),
            }
        }
        let words = self.reports.language().map_or_else(|| self.shared.report_words(), |language| self.shared.report_words_in(language));
        Ok(Content::Report { report: Box::new(report), rendering, words: Arc::new(words) })
    }
}
