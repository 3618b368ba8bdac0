//! The report that the page shows and writes: from what is reported, by the chosen template.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::report::pdf::{self, Pages};
use fitcheck_exchange::report::template::{HeadField, Section, Template};
use fitcheck_exchange::report::{Holds, RENDERINGS, RenderError, Rendering};
use jiff::civil::DateTime;

use super::drawing::{Drawing, WatchedChecks};
use super::{ReportOf, ReportsField, ReportsPage, Wanted};
use crate::Session;
use crate::effect::Effect;
use crate::files::Content;
use crate::page::Page;
use crate::state::PageState as _;

impl ReportsPage {
    /// The template with what was chosen beside it.
    fn made_template(&self) -> Template {
        self.template().without(&self.hidden, self.paper())
    }

    /// Asks for the pages of a report; while others are being drawn, it waits for them.
    fn draw(&mut self, made: Result<Content, Message>) {
        self.is_stale = false;
        self.run += 1;
        match made {
            Ok(mut content) => {
                let drawing = Arc::<Drawing>::default();
                if let Content::Report { report, .. } = &mut content {
                    let checks = Arc::clone(&report.checks);
                    report.checks = Arc::new(WatchedChecks { checks, drawing: Arc::clone(&drawing) });
                }
                self.at_work = Some((self.run, drawing));
                self.errands.push(Effect::DrawReport { run: self.run, content: Box::new(content) });
            }
            Err(why) => self.pages = Some(Err(why)),
        }
    }

    pub(super) fn take_pages(&mut self, run: u64, result: Result<Arc<Pages>, Message>) {
        let Some((_, drawing)) = self.at_work.take_if(|(asked, _)| *asked == run) else { return };
        // What was stopped because something else is to be shown now says nothing.
        if drawing.is_stopped() && self.is_stale {
            return;
        }
        self.pages = Some(if drawing.is_stopped() { Err(message!("reports-page-stopped")) } else { result });
    }

    /// Ends the drawing of pages, if there is any.
    pub(super) fn stop(&self) {
        if let Some((_, drawing)) = &self.at_work {
            drawing.stop();
        }
    }
}

impl Session {
    /// Whether there is something of it to report.
    pub fn can_report(&self, of: ReportOf) -> bool {
        match of {
            ReportOf::Part => self.parts.walking.is_begun(),
            ReportOf::Check => self.check.shown.is_some(),
            ReportOf::List => self.check.rows.is_some() || !self.shared.history.is_empty(),
            ReportOf::Records => 0 < self.records.reported(),
            ReportOf::Statistics => self.statistics.is_settled(),
        }
    }

    /// What the reports page is about: what was chosen, as long as there is something of it.
    pub fn report_of(&self) -> Option<ReportOf> {
        let chosen = self.reports.of.filter(|of| self.can_report(*of));
        // Behind the worst row of a file stands the whole file.
        let list = self.check.lot.is_some().then_some(ReportOf::List).filter(|of| self.can_report(*of));
        let whole = list.filter(|_| !self.can_report(ReportOf::Part));
        chosen.or(whole).or_else(|| ReportOf::ALL.into_iter().find(|of| self.can_report(*of)))
    }

    /// Asks for the pages that the open reports page does not have yet.
    pub(crate) fn draw_report(&mut self, now: DateTime) -> Vec<Effect> {
        let is_open = self.shared.page == Page::Reports;
        if is_open && self.reports.is_stale && self.reports.at_work.is_none() {
            let made = self.made_report(&pdf::RENDERING, now);
            self.reports.draw(made);
        }
        if std::mem::take(&mut self.reports.reads_templates)
            && let Some(file) = &self.settings_page.state_file
        {
            self.reports.errands.push(Effect::ReadTemplates(file.with_file_name("templates")));
        }
        match self.reports.wanted.take() {
            None => {}
            Some(Wanted::Print) => match self.made_report(&pdf::RENDERING, now) {
                Ok(content) => self.reports.errands.push(Effect::Print(Box::new(content))),
                Err(why) => self.shared.tell(why),
            },
            Some(Wanted::NewTemplate) => {
                let text = Template::sample(&self.shared.words());
                match self.settings_page.state_file.as_ref().map(|file| file.with_file_name("templates")) {
                    Some(folder) => self.reports.errands.push(Effect::NewTemplate { folder, text }),
                    None => self.shared.tell(message!("reports-page-no-folder")),
                }
            }
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
        if of == ReportOf::Statistics && !self.reports.shows(Section::Statistics) {
            return Err(message!("reports-page-no-statistics"));
        }
        if of == ReportOf::Statistics && rendering.holds != Holds::ReportAndStatistics {
            return Err(RenderError::NoStatistics { format: rendering.title }.message());
        }
        let mut composed = self.composed(of, now)?;
        let words = self.shared.report_words_in(self.reports.language());
        let template = self.settings_page.company.in_template(&Arc::new(self.reports.made_template()));
        let report = &mut composed.report;
        report.paper = template.paper;
        report.template = template;
        if of == ReportOf::Records && report.template.has(Section::Statistics) {
            report.series = self.records.series();
        }
        report.earlier = self.reports.earlier.as_ref().map(|(_, earlier)| Arc::clone(earlier));
        report.tell(HeadField::Inspector, self.shared.recording.who());
        for field in ReportsField::all() {
            let text = self.reports.text(*field);
            match field.head() {
                None if text.trim().is_empty() => {}
                None => text.trim().clone_into(&mut report.title),
                Some(head) => report.tell(head, text),
            }
        }
        Ok(composed.content(rendering, words))
    }
}
