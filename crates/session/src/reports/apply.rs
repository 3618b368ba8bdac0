//! How commands and news change the reports page.

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::report::template::Section;
use jiff::civil::DateTime;

use super::{ReportOf, ReportsCommand, ReportsField, ReportsPage, Wanted};
use crate::effect::Effect;
use crate::files::Launch;
use crate::page::Page;
use crate::saved::{Saved, SavedReports};
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::step::Step;
use crate::texts::Texts;

impl PageState for ReportsPage {
    type Command = ReportsCommand;
    type Field = ReportsField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        let SavedReports { template, language, paper, hidden } = saved.reports.clone();
        Self { texts: Texts::restored(&saved.inputs.texts), template, language, paper, hidden, ..Self::default() }
    }

    fn save(&self, saved: &mut Saved) {
        saved.inputs.texts.extend(self.texts.saved());
        saved.reports = SavedReports {
            template: self.template.clone(),
            language: self.language,
            paper: self.paper,
            hidden: self.hidden.clone(),
        };
    }

    fn apply(&mut self, command: ReportsCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            ReportsCommand::Type(field, text) => self.texts.set(field, text),
            ReportsCommand::Of(of) => self.of = Some(of),
            ReportsCommand::OfStatistics => {
                self.of = Some(ReportOf::Statistics);
                // A template that shows statistics is kept.
                if !self.shows(Section::Statistics) {
                    self.hidden.remove(&Section::Statistics);
                    let usual = self.templates().find(|template| template.has(Section::Statistics));
                    self.template = usual.map_or_else(String::new, |template| template.name.clone());
                }
                self.at = 0;
                shared.open(Page::Reports);
            }
            ReportsCommand::Template(name) => {
                self.template = name;
                self.at = 0;
            }
            ReportsCommand::Language(language) => self.language = language,
            ReportsCommand::Paper(paper) => self.paper = paper,
            ReportsCommand::Earlier { name, result } => {
                let refused = |why| message!("reports-page-no-earlier").text("file", &name).message("reason", why);
                let Some(earlier) = shared.file_answered(result.map_err(refused)) else { return Vec::new() };
                self.earlier = Some((name, earlier));
            }
            ReportsCommand::CompareNot => self.earlier = None,
            ReportsCommand::Show(section, true) => _ = self.hidden.remove(&section),
            ReportsCommand::Show(section, false) => _ = self.hidden.insert(section),
            ReportsCommand::Move(step) => {
                // A page of keys is a page of paper.
                let step = match step {
                    Step::PageUp => Step::Left,
                    Step::PageDown => Step::Right,
                    step => step,
                };
                self.at = step.place(Some(self.at()), self.last());
                return Vec::new();
            }
            ReportsCommand::Magnify(magnification) => {
                self.magnification = magnification;
                return Vec::new();
            }
            ReportsCommand::Drawn { run, result } => {
                self.take_pages(run, result);
                return Vec::new();
            }
            ReportsCommand::Stop => {
                self.stop();
                return Vec::new();
            }
            ReportsCommand::Templates(own) => self.own = own,
            ReportsCommand::NewTemplate => {
                self.wanted = Some(Wanted::NewTemplate);
                return Vec::new();
            }
            ReportsCommand::TemplateMade(Ok(file)) => {
                let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned();
                shared.note(message!("reports-page-template-made").text("name", name), Vec::new());
                self.reads_templates = true;
                return vec![Effect::Launch(file, Launch::ShowInFolder)];
            }
            ReportsCommand::Print => {
                self.wanted = Some(Wanted::Print);
                return Vec::new();
            }
            ReportsCommand::Printed(Ok(())) => {
                shared.note(message!("reports-page-printed"), Vec::new());
                return Vec::new();
            }
            ReportsCommand::TemplateMade(Err(why)) | ReportsCommand::Printed(Err(why)) => {
                shared.tell(why);
                return Vec::new();
            }
        }
        // Nobody waits for pages that are others now.
        self.stop();
        self.is_stale = true;
        Vec::new()
    }

    fn follow(&mut self, news: &News, _shared: &mut Shared) {
        if *news == News::Opened(Page::Reports) {
            // Whatever was measured meanwhile is in it.
            self.is_stale = true;
            self.reads_templates = true;
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    fn text(&self, field: ReportsField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, _field: ReportsField) -> Option<&Message> {
        None
    }

    fn is_free_text(&self, _field: ReportsField) -> bool {
        true
    }
}
